//! Algorithm 2 on a driver whose shaders read the framebuffer in order.

use crate::error::Result;
use crate::image::{Comparison, Image};
use crate::low_level::edition::figures::{Drawn, Figure, Studio, printed};
use crate::methods::{
    CoherentOptions, Frame, IdealOptions, Method, Reading, Renderer, TriangleSort, Variant,
};
use crate::scene::Scene;

pub(super) const FIGURE: Figure = Figure {
    key: "carr-ideal",
    source: "Carr et al. 2008, section 7",
    title: "Algorithm 2, as amended and as printed",
    make,
};

/// The worst order, in which Algorithm 2 and the six passes differ most.
const REVERSED: TriangleSort = TriangleSort::Reversed(1024);

fn ideal(reading: Reading, tight_bound: bool) -> Method {
    Method::IdealCoherentLayerPeeling(IdealOptions {
        sorting: REVERSED,
        reading,
        tight_bound,
        ..IdealOptions::default()
    })
}

fn coherent(variant: Variant) -> Method {
    Method::CoherentLayerPeeling(CoherentOptions {
        sorting: REVERSED,
        ..CoherentOptions::from(variant)
    })
}

/// Frames of a scene that is submitted back to front: by Algorithm 2 in three readings, by both variants, and by layer peeling.
/// `None` if this driver is no ideal GPU.
///
/// # Errors
/// If the driver fails.
pub fn rows(
    renderer: &mut Renderer<'_>,
    scene: &Scene,
    driver: &crate::gl::Driver,
) -> Result<Option<Vec<(&'static str, Frame)>>> {
    if !ideal(Reading::Amended, false).entry().runs_on(driver) {
        return Ok(None);
    }
    let methods = [
        ("Algorithm 2", ideal(Reading::Amended, false)),
        ("Algorithm 2, as printed", ideal(Reading::AsPrinted, false)),
        ("Algorithm 2, tight bound", ideal(Reading::Amended, true)),
        ("coherent, variant A", coherent(Variant::A)),
        ("coherent, variant B", coherent(Variant::B)),
        ("layer peeling", Method::LayerPeeling(Default::default())),
    ];
    let frames = methods.map(|(name, method)| Ok((name, renderer.render(scene, &method)?)));
    Ok(Some(frames.into_iter().collect::<Result<_>>()?))
}

fn make(studio: &Studio) -> Result<Drawn> {
    let scene = studio.scene("knots", [336, 252])?;
    let mut renderer = studio.renderer(&scene)?;
    let driver = studio.context.driver();
    let Some(frames) = rows(&mut renderer, &scene, driver)? else {
        return Ok(Drawn::new(format!(
            "This driver ({}) is no ideal GPU: it has neither framebuffer fetch nor fragment shader interlock. Mesa's llvmpipe \
             has the former.",
            driver.renderer
        )));
    };
    let exact = renderer.render(&scene, &Method::Exact)?.image;
    let drawn = Drawn::new(
        "The knots are submitted back to front, which is the worst order. As printed, pixels that are finished composite their \
         last layer again in each further iteration, and grow opaque (CX22). The table compares the passes. Algorithm 2 takes as \
         many iterations as layer peeling here, as the paper says it may, with two passes each. The tight bound is the unused z2 \
         of the print put to use (CX23).",
    );
    let [(_, amended), (_, printed), ..] = &frames[..] else {
        return Ok(drawn);
    };
    Ok(drawn
        .flipped(
            "amended",
            &amended.image,
            "as amended",
            "three translucent knots",
        )
        .flipped(
            "printed",
            &printed.image,
            "as printed",
            "the same knots, far too opaque",
        )
        .difference(
            "difference",
            [&amended.image, &printed.image],
            1.0,
            "the difference of the two",
        )?
        .table(
            "Three knots, submitted back to front",
            &["method", "iterations", "geometry passes", "largest error"],
            table(&frames, &exact)?,
        ))
}

fn table(frames: &[(&str, Frame)], exact: &Image) -> Result<Vec<Vec<String>>> {
    let row = |(name, frame): &(&str, Frame)| {
        let error = Comparison::new(&frame.image, exact, 0.0)?.max;
        Ok(vec![
            (*name).into(),
            frame.stats.iterations.to_string(),
            frame.stats.geometry_passes.to_string(),
            printed::error(error),
        ])
    };
    frames.iter().map(row).collect()
}
