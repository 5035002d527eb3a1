//! `a_buffer/resolve_pixel.glsl`: the Resolve Step of a pixel, by the paper's pseudocode.

use super::list::{list, list_length};
use super::ray::Ray;
use super::volume_ray;
use crate::low_level::emulator::color::Texel;
use crate::low_level::emulator::invocation::{Inputs, Kept, Outputs};
use crate::low_level::emulator::lists::{RayRun, Resolved, run_on_lists};
use crate::low_level::fragment::Fragment;
use crate::low_level::papers::lindholm_2015::components::{
    KEEP_NEAREST, PP_DP, PP_DP_AMENDMENTS, STATIC_ARRAY, STOP,
};

pub(super) fn resolve_pixel(i: &Inputs<'_>) -> Outputs {
    let (list, n) = (list(i), i.settings.size);
    let fits = list_length(i).min(n);
    let peels = i.is("PEEL_ALWAYS")
        || i.is("PP_DP") && n == i.define("LAST_SEGMENT") && list.len() > n as usize;
    let (resolved, ray, color) = match i.is("VOLUMES") {
        true => through_volumes(i, list, peels),
        false => through_surfaces(i, &list, peels),
    };
    let cost = [
        resolved.records_read,
        resolved.composited.len() as u32,
        resolved.subpasses,
        n << 16 | fits,
    ];
    Some(Kept {
        colors: vec![Texel::Color(color), Texel::Integers(cost)],
        resolved: Some((resolved, ray)),
        ..Kept::default()
    })
}

/// The result, the ray if there are volumes, and the colour.
type Through = (Resolved, Option<RayRun>, [f32; 4]);

fn through_surfaces(i: &Inputs<'_>, list: &[Fragment], peels: bool) -> Through {
    let mut resolved = resolved(i, list, peels);
    let mut ray = Ray::new(i);
    for order in &resolved.composited {
        if ray.ended() {
            break;
        }
        let fragment = list.iter().find(|fragment| fragment.order == *order);
        fragment.into_iter().for_each(|it| ray.composite(it));
    }
    end_after(&mut resolved, ray.composited as usize);
    if peels && ray.ended() {
        // The subpass in which the ray ended was the last.
        resolved.subpasses = ray.composited.div_ceil(i.settings.size);
        resolved.records_read = resolved.subpasses * list.len() as u32;
        resolved.passes.truncate(resolved.subpasses as usize);
    }
    let [r, g, b] = ray.color;
    (resolved, None, [r, g, b, 1.0 - ray.transparency])
}

/// Ends after so many composited fragments.
fn end_after(resolved: &mut Resolved, mut composited: usize) {
    resolved.composited.truncate(composited);
    for pass in &mut resolved.passes {
        pass.composited.truncate(composited);
        composited -= pass.composited.len();
    }
}

fn resolved(i: &Inputs<'_>, list: &[Fragment], peels: bool) -> Resolved {
    let subpasses = most_subpasses(i, list);
    let (algorithm, amendments, limit) = match (peels, keeps_nearest(i)) {
        (true, _) if i.is("LITERAL") => (PP_DP, &[][..], subpasses),
        (true, _) if i.is("AS_PRINTED") => (PP_DP, &[STOP][..], subpasses),
        (true, _) => (PP_DP, &PP_DP_AMENDMENTS[..], subpasses),
        (false, true) => (STATIC_ARRAY, &[KEEP_NEAREST][..], 1),
        (false, false) => (STATIC_ARRAY, &[][..], 1),
    };
    let lists = [list.to_vec()];
    let run = run_on_lists(&algorithm, amendments, &lists, i.settings.size, limit);
    // It fails only without an element in the Local Array, and then resolves nothing.
    let pixels = run.map(|run| run.pixels).unwrap_or_default();
    pixels.into_iter().next().unwrap_or_default()
}

fn through_volumes(i: &Inputs<'_>, mut list: Vec<Fragment>, peels: bool) -> Through {
    let n = i.settings.size;
    let read = list.len() as u32;
    let peeled_by = peels.then(|| [n, most_subpasses(i, &list)]);
    if !peels {
        if keeps_nearest(i) {
            list.sort_by(|a, b| a.depth.total_cmp(&b.depth).then(a.order.cmp(&b.order)));
        }
        list.truncate(n as usize);
    }
    // It fails only without an element in the Local Array, and then resolves nothing.
    let Ok((mut resolved, run)) = volume_ray::cast(i, list, peeled_by) else {
        return (Resolved::default(), None, [0.0; 4]);
    };
    if keeps_nearest(i) && !peels {
        resolved.records_read = read;
    }
    let [r, g, b] = run.light.map(|channel| channel as f32);
    let color = [r, g, b, (1.0 - run.transparency) as f32];
    (resolved, Some(run), color)
}

fn most_subpasses(i: &Inputs<'_>, list: &[Fragment]) -> u32 {
    let most = i.settings.defines.get("MOST_SUBPASSES");
    let most = most.copied().unwrap_or(u32::MAX);
    let most = most.min(list.len() as u32);
    // Read literally, nothing says when to stop.
    most.saturating_add(u32::from(i.is("LITERAL")))
}

/// Whether a full Local Array keeps the nearest fragments.
fn keeps_nearest(i: &Inputs<'_>) -> bool {
    i.is("KEEP_NEAREST") && i.settings.size == i.define("LAST_SEGMENT")
}
