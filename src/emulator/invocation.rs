//! An invocation of a shader: the values that it reads, and those that it leaves.

use crate::fragment::Fragment;

/// The inputs of a shader: the fragment, and the bound maps at its pixel.
pub(super) struct Inputs<'a> {
    pub(super) fragment: Fragment,
    pub(super) lookup: &'a dyn Fn(u32) -> [f32; 4],
    pub(super) comparison: &'a dyn Fn(f32) -> bool,
}

impl Inputs<'_> {
    /// `texelFetch` at this pixel, by texture unit.
    pub(super) fn texel(&self, unit: u32) -> [f32; 4] {
        (self.lookup)(unit)
    }

    /// The shadow lookup of texture unit 0 with this reference.
    pub(super) fn shadow(&self, reference: f32) -> bool {
        (self.comparison)(reference)
    }

    /// `surface_color()`, with straight alpha.
    pub(super) fn surface_color(&self) -> [f32; 4] {
        self.fragment.color.to_array()
    }

    /// `FRAGMENT_DEPTH`
    pub(super) fn depth(&self) -> f32 {
        self.fragment.depth
    }
}

/// The output of a shader, or `None` if it discards.
pub(super) type Outputs = Option<Kept>;

/// A colour, and a depth if the shader replaces it.
pub(super) struct Kept {
    pub(super) color: [f32; 4],
    pub(super) depth: Option<f32>,
}

/// A shader's twin.
pub(super) type Twin = fn(&Inputs<'_>) -> Outputs;

/// The output of a shader that only writes a colour.
pub(super) fn keep(color: [f32; 4]) -> Outputs {
    Some(Kept { color, depth: None })
}
