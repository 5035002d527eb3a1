//! The twins of `glsl/`: a function for each fragment shader of a listing, under the name of the shader's file.

use crate::error::{Error, Result};
use crate::fragment::Fragment;
use crate::steps::Shader;

/// The inputs of a shader: the fragment, and the bound maps at its pixel.
pub(super) struct Inputs<'a> {
    pub(super) fragment: Fragment,
    /// `texelFetch` at this pixel, by texture unit.
    pub(super) texel: &'a dyn Fn(u32) -> [f32; 4],
    /// The shadow lookup of texture unit 0 with this reference.
    pub(super) shadow: &'a dyn Fn(f32) -> bool,
}

/// The output of a shader, or `None` if it discards.
pub(super) type Outputs = Option<Kept>;

/// A colour, and a depth if the shader replaces it.
pub(super) struct Kept {
    pub(super) color: [f32; 4],
    pub(super) depth: Option<f32>,
}

type Twin = fn(&Inputs<'_>) -> Outputs;

/// Every twin by its file's name.
const TWINS: [(&str, Twin); 19] = [
    ("surface", surface),
    ("peel", peel),
    ("coplanar", coplanar),
    ("layer", layer),
    ("over", over),
    ("under", under),
    ("alive/first", alive_first),
    ("alive/later", alive_later),
    ("clip/open_open", |i| {
        clip(i, |low, z, high| low < z && z < high)
    }),
    ("clip/open_closed", |i| {
        clip(i, |low, z, high| low < z && z <= high)
    }),
    ("clip/closed_open", |i| {
        clip(i, |low, z, high| low <= z && z < high)
    }),
    ("clip/closed_closed", |i| {
        clip(i, |low, z, high| low <= z && z <= high)
    }),
    ("clip/at_bound", at_bound),
    ("clip/at_bound_as_printed", at_bound_as_printed),
    ("clip/between_peels_as_printed", |i| {
        clip(i, |low, z, high| low < z && z < high)
    }),
    ("clip/previous_depth", |i| {
        previous_depth(i, |low, z| low < z)
    }),
    ("clip/previous_depth_from_near", |i| {
        previous_depth(i, |low, z| low <= z)
    }),
    ("clip/next_bound", next_bound),
    ("verified/surface", verified_surface),
];

/// The twin of a shader.
pub(super) fn twin(Shader(name): Shader) -> Result<Twin> {
    TWINS
        .iter()
        .find(|(file, _)| *file == name)
        .map(|(_, twin)| *twin)
        .ok_or_else(|| Error::NoTwin {
            shader: name.into(),
            known: TWINS.map(|(file, _)| file).to_vec(),
        })
}

fn keep(color: [f32; 4]) -> Outputs {
    Some(Kept { color, depth: None })
}

fn premultiplied([r, g, b, a]: [f32; 4]) -> [f32; 4] {
    [r * a, g * a, b * a, a]
}

// surface.frag
fn surface(i: &Inputs<'_>) -> Outputs {
    keep(i.fragment.color.to_array())
}

// peel.frag
fn peel(i: &Inputs<'_>) -> Outputs {
    if !(i.shadow)(i.fragment.depth) {
        return None;
    }
    keep(i.fragment.color.to_array())
}

// coplanar.frag
fn coplanar(i: &Inputs<'_>) -> Outputs {
    if !(i.shadow)(i.fragment.depth) {
        return None;
    }
    keep(premultiplied(i.fragment.color.to_array()))
}

// layer.frag
fn layer(i: &Inputs<'_>) -> Outputs {
    keep((i.texel)(2))
}

// common/layer.glsl
fn layer_of(i: &Inputs<'_>) -> Option<[f32; 4]> {
    let [opaque_depth, layer_depth] = [(i.texel)(1)[0], (i.texel)(3)[0]];
    (layer_depth < opaque_depth).then(|| (i.texel)(2))
}

// over.frag
fn over(i: &Inputs<'_>) -> Outputs {
    keep(layer_of(i)?)
}

// under.frag
fn under(i: &Inputs<'_>) -> Outputs {
    keep(premultiplied(layer_of(i)?))
}

// alive/first.frag
fn alive_first(i: &Inputs<'_>) -> Outputs {
    let opaque_depth = (i.texel)(1)[0];
    Some(Kept {
        depth: Some(opaque_depth),
        ..under(i)?
    })
}

// alive/later.frag
fn alive_later(i: &Inputs<'_>) -> Outputs {
    if (i.texel)(3)[0] == 0.0 {
        return None;
    }
    alive_first(i)
}

// verified/surface.frag
fn verified_surface(i: &Inputs<'_>) -> Outputs {
    if i.fragment.depth >= (i.texel)(5)[0] {
        return None;
    }
    keep(i.fragment.color.to_array())
}

// common/clip.glsl
fn lower_bound(i: &Inputs<'_>) -> f32 {
    (i.texel)(1)[0]
}

fn upper_bound(i: &Inputs<'_>) -> f32 {
    let [upper, other_upper] = [2, 3].map(|unit| (i.texel)(unit)[0]);
    upper.min(other_upper).min(opaque_depth(i))
}

fn opaque_depth(i: &Inputs<'_>) -> f32 {
    (i.texel)(4)[0]
}

fn clip(i: &Inputs<'_>, inside: fn(f32, f32, f32) -> bool) -> Outputs {
    if !inside(lower_bound(i), i.fragment.depth, upper_bound(i)) {
        return None;
    }
    keep(premultiplied(i.fragment.color.to_array()))
}

// clip/at_bound.frag
fn at_bound(i: &Inputs<'_>) -> Outputs {
    if i.fragment.depth >= opaque_depth(i) {
        return None;
    }
    at_bound_as_printed(i)
}

// clip/at_bound_as_printed.frag
fn at_bound_as_printed(i: &Inputs<'_>) -> Outputs {
    if i.fragment.depth != upper_bound(i) {
        return None;
    }
    keep(premultiplied(i.fragment.color.to_array()))
}

// clip/previous_depth.frag, clip/previous_depth_from_near.frag
fn previous_depth(i: &Inputs<'_>, behind: fn(f32, f32) -> bool) -> Outputs {
    let z = i.fragment.depth;
    if !(behind(lower_bound(i), z) && z < upper_bound(i)) {
        return None;
    }
    keep([1.0, 1.0, 1.0, z])
}

// clip/next_bound.frag
fn next_bound(i: &Inputs<'_>) -> Outputs {
    Some(Kept {
        color: [0.0; 4],
        depth: Some(upper_bound(i)),
    })
}
