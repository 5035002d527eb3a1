//! `a_buffer/resolve_pixel.glsl`: the Resolve Step of a pixel, by the paper's pseudocode.

use super::list::{list, list_length};
use super::ray::Ray;
use crate::low_level::emulator::color::Texel;
use crate::low_level::emulator::invocation::{Inputs, Kept, Outputs};
use crate::low_level::emulator::lists::{Resolved, run_on_lists};
use crate::low_level::fragment::Fragment;
use crate::low_level::papers::lindholm_2015::components::{
    KEEP_NEAREST, PP_DP, PP_DP_AMENDMENTS, STATIC_ARRAY, STOP,
};

pub(super) fn resolve_pixel(i: &Inputs<'_>) -> Outputs {
    let (list, n) = (list(i), i.settings.size);
    let fits = list_length(i).min(n);
    let peels = i.is("PEEL_ALWAYS")
        || i.is("PP_DP") && n == i.define("LAST_SEGMENT") && list.len() > n as usize;
    let mut resolved = resolved(i, &list, peels);
    let mut ray = Ray::new(i);
    for order in &resolved.composited {
        if ray.ended() {
            break;
        }
        let fragment = list.iter().find(|fragment| fragment.order == *order);
        fragment.into_iter().for_each(|it| ray.composite(it));
    }
    if peels && ray.ended() {
        // The subpass in which the ray ended was the last.
        resolved.subpasses = ray.composited.div_ceil(n);
        resolved.records_read = resolved.subpasses * list.len() as u32;
    }
    let [r, g, b] = ray.color;
    let cost = [
        resolved.records_read,
        ray.composited,
        resolved.subpasses,
        n << 16 | fits,
    ];
    Some(Kept {
        colors: vec![
            Texel::Color([r, g, b, 1.0 - ray.transparency]),
            Texel::Integers(cost),
        ],
        ..Kept::default()
    })
}

fn resolved(i: &Inputs<'_>, list: &[Fragment], peels: bool) -> Resolved {
    let n = i.settings.size;
    let most = i.settings.defines.get("MOST_SUBPASSES");
    let most = most.copied().unwrap_or(u32::MAX);
    let count = list.len() as u32;
    let keeps = i.is("KEEP_NEAREST") && n == i.define("LAST_SEGMENT");
    let (algorithm, amendments, limit) = match (peels, keeps) {
        (true, _) if i.is("LITERAL") => (PP_DP, &[][..], count.min(most).saturating_add(1)),
        (true, _) if i.is("AS_PRINTED") => (PP_DP, &[STOP][..], count.min(most)),
        (true, _) => (PP_DP, &PP_DP_AMENDMENTS[..], count.min(most)),
        (false, true) => (STATIC_ARRAY, &[KEEP_NEAREST][..], 1),
        (false, false) => (STATIC_ARRAY, &[][..], 1),
    };
    let run = run_on_lists(&algorithm, amendments, &[list.to_vec()], n, limit);
    // It fails only without an element in the Local Array, and then resolves nothing.
    let pixels = run.map(|run| run.pixels).unwrap_or_default();
    pixels.into_iter().next().unwrap_or_default()
}
