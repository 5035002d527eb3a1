//! An invocation of a shader: the values that it reads, and those that it leaves.

use super::color::Texel;
use super::lists::{RayRun, Resolved};
use super::maps::Maps;
use super::place::Place;
use super::settings::{self, Settings};
use crate::fragment::Fragment;

/// The inputs of a shader.
pub(super) struct Inputs<'a> {
    pub(super) fragment: Fragment,
    pub(super) pixel: usize,
    pub(super) maps: &'a Maps,
    pub(super) place: &'a Place,
    pub(super) settings: &'a Settings,
    /// The pixel's records in the order in which they were stored, those of earlier fills at the end.
    pub(super) records: &'a [Fragment],
}

impl Inputs<'_> {
    /// `surface_color()`, with straight alpha.
    pub(super) fn surface_color(&self) -> [f32; 4] {
        self.fragment.color.to_array()
    }

    /// `FRAGMENT_DEPTH`
    pub(super) fn depth(&self) -> f32 {
        self.fragment.depth
    }

    /// `1.0 / gl_FragCoord.w`, the distance along the view direction.
    pub(super) fn distance(&self) -> f64 {
        let (planes, inverse_w) = (self.settings.planes, self.settings.inverse_w);
        settings::distance(planes, inverse_w, self.fragment.depth)
    }

    /// `texelFetch` at this pixel, by texture unit.
    pub(super) fn texel(&self, unit: u32) -> [f32; 4] {
        self.maps.texel(unit, self.pixel).color()
    }

    /// The same of a map of whole numbers.
    pub(super) fn integers(&self, unit: u32) -> [u32; 4] {
        self.maps.texel(unit, self.pixel).integers()
    }

    /// The shadow lookup of texture unit 0 with this reference.
    pub(super) fn shadow(&self, reference: f32) -> bool {
        self.settings
            .compare_func
            .holds(reference, self.texel(0)[0])
    }

    /// `imageLoad` at this pixel, by image unit.
    pub(super) fn image(&self, unit: u32) -> Texel {
        self.maps.image(unit, self.pixel)
    }

    /// What an `inout` finds in the framebuffer, by location.
    pub(super) fn fetched(&self, location: usize) -> Texel {
        let found = self.place.colors.get(location);
        found.map_or(Texel::Color([0.0; 4]), |(_, texel)| *texel)
    }

    /// The value of a `#define`, or 0 without one.
    pub(super) fn define(&self, name: &str) -> u32 {
        self.settings.defines.get(name).copied().unwrap_or(0)
    }

    /// Whether a `#define` is not 0.
    pub(super) fn is(&self, name: &str) -> bool {
        self.define(name) != 0
    }
}

/// The output of a shader, or `None` if it discards.
pub(super) type Outputs = Option<Kept>;

/// What a shader leaves.
#[derive(Default)]
pub(super) struct Kept {
    /// The framebuffer's colours, by location.
    pub(super) colors: Vec<Texel>,
    /// A depth that replaces the fragment's.
    pub(super) depth: Option<f32>,
    /// What it stores into images, by image unit.
    pub(super) images: Vec<(u32, Texel)>,
    /// What it does to the pixel's list.
    pub(super) list: Option<Appended>,
    /// How it resolved the pixel's list, and the ray that it has cast.
    pub(super) resolved: Option<(Resolved, Option<RayRun>)>,
}

/// What a fragment does to its pixel's list.
pub(super) enum Appended {
    /// It is stored as this record, as so many records were before.
    Stored(u32, Fragment),
    /// There is no room for it.
    NoRoom,
}

/// A shader's twin.
pub(super) type Twin = fn(&Inputs<'_>) -> Outputs;

/// The output of a shader that only writes a colour.
pub(super) fn keep(color: [f32; 4]) -> Outputs {
    keep_all([color])
}

/// The output of a shader that only writes these colours, by location.
pub(super) fn keep_all<const N: usize>(colors: [[f32; 4]; N]) -> Outputs {
    Some(Kept {
        colors: colors.map(Texel::Color).to_vec(),
        ..Kept::default()
    })
}
