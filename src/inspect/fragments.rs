//! The fragments that OpenGL has at a pixel, whatever hides them.

use super::drawn_order::Numbering;
use crate::error::Result;
use crate::fragment::{Rgba, Source};
use crate::gl::{Captured, CapturedFragment, GlMachine, capture_at};
use crate::methods::DrawOrder;
use crate::papers::stage::OPAQUE_DEPTH;
use crate::scene::Scene;
use crate::steps::{Compare, Objects};

/// The faces of the boxes around volumes at each pixel, whatever hides them, each with its id
/// ([`Source::id`]) as its `order`, in the order in which boxes are drawn. OpenGL's state is lost.
///
/// # Errors
/// If the driver fails.
pub(super) fn faces(
    machine: &mut GlMachine<'_>,
    scene: &Scene,
    pixels: &[[u32; 2]],
) -> Result<Vec<Vec<CapturedFragment>>> {
    if scene.volumes.is_empty() {
        return Ok(vec![Vec::new(); pixels.len()]);
    }
    let pixels = pixels.iter();
    pixels
        .map(|&pixel| {
            let mut faces = capture_at(machine, &captured(Objects::Proxies), pixel)?;
            faces.sort_by_key(|face| match Source::of(face.order) {
                Source::Proxy { volume, .. } => (volume, face.color.r as u32),
                Source::Surface(_) => (u32::MAX, 0),
            });
            let clear = |face| CapturedFragment {
                color: Rgba::default(),
                ..face
            };
            Ok(faces.into_iter().map(clear).collect())
        })
        .collect()
}

fn captured(objects: Objects) -> Captured {
    Captured {
        objects,
        depth: OPAQUE_DEPTH,
        passes: Compare::Always,
    }
}

/// The fragments of pixels, each with the number of its triangle as its `order`. Pixels are columns from the left and rows from
/// the bottom. The scene is uploaded to be drawn in `drawn`. OpenGL's state is lost.
///
/// # Errors
/// If the driver fails.
pub(super) fn fragments(
    machine: &mut GlMachine<'_>,
    scene: &Scene,
    numbering: &Numbering,
    drawn: &DrawOrder,
    pixels: &[[u32; 2]],
) -> Result<Vec<Vec<CapturedFragment>>> {
    let transparent = match drawn {
        DrawOrder::Own => numbering.transparent(scene),
        _ => Vec::new(),
    };
    if *drawn == DrawOrder::Own {
        let corners = |&number: &u32| numbering.triangle(scene, number).corners;
        let corners: Vec<_> = transparent.iter().filter_map(corners).collect();
        machine.submit_triangles(&corners)?;
    }
    // A fragment's place in the order of drawing is known, and from it follows its triangle's number.
    let number = |objects: Objects, place: u32| match drawn {
        DrawOrder::Sorted(order) => numbering.number(order[place as usize]),
        DrawOrder::InTurn(orders) => numbering.number(orders[0][place as usize]),
        DrawOrder::Own if objects == Objects::Transparent => transparent[place as usize],
        DrawOrder::Own | DrawOrder::Submission => place,
    };
    let mut all = Vec::new();
    for &pixel in pixels {
        let mut here = Vec::new();
        for objects in [Objects::Opaque, Objects::Transparent] {
            let captured = capture_at(machine, &captured(objects), pixel)?;
            here.extend(captured.into_iter().map(|fragment| CapturedFragment {
                order: number(objects, fragment.order),
                ..fragment
            }));
        }
        here.sort_by_key(|fragment| fragment.order);
        all.push(here);
    }
    Ok(all)
}
