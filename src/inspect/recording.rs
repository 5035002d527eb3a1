//! Everything that a method had done to a pixel, so that it can be done again on another emulated pixel.

use std::sync::Arc;

use super::drawn_order::{Triangle, drawn};
use glam::{DAffine3, DVec3};

use crate::emulator::{Emulator, PixelRay, Surface};
use crate::error::Result;
use crate::gl::Setting;
use crate::papers::stage;
use crate::scene::{Transfer, TransferPoint, Volume};
use crate::steps::gl::glClearColor;
use crate::steps::{Call, Format, Machine, Map, Resources, Target, Workspace};

/// The reason for which triangles in pieces are not followed.
const IN_PIECES: &str =
    "a triangle is drawn in pieces, and only OpenGL knows which of them has the pixel";
const NUMBERS: &str = "the emulated pixel has its list at its own place, and no number";

/// A step of a method.
#[derive(Clone, Debug)]
pub(super) enum Done {
    /// A map was made.
    Map(Map, Format),
    /// A framebuffer was given maps.
    Framebuffer(Target, Vec<Map>, Option<Map>),
    /// The background's colour was set, before the method began.
    Background([f32; 3]),
    /// A call was performed.
    Call(Call),
    /// Surfaces are drawn in this order, by their numbers; others are not.
    Order(Vec<u32>),
    /// Programs have these defines.
    Defines(Vec<(&'static str, u32)>),
    /// Only these rows are drawn.
    Band(Option<[u32; 2]>),
    /// Draws over the screen cover these pixels.
    Screen(Option<[u32; 4]>),
    /// A fixed buffer has room for so many records at each pixel.
    Layers(u32),
}

impl Done {
    /// What every method finds, in these formats, before this background.
    pub(super) fn stage(color: Format, depth: Format, background: [f32; 3]) -> Vec<Self> {
        let Resources {
            maps, framebuffers, ..
        } = stage::RESOURCES;
        let maps = maps.iter();
        let maps = maps.map(|(map, holds)| Self::Map(*map, holds.format(color, depth)));
        let framebuffers = framebuffers
            .iter()
            .map(|it| Self::Framebuffer(it.target, it.colors.to_vec(), it.depth));
        let background = Self::Background(background);
        maps.chain(framebuffers).chain([background]).collect()
    }

    /// A setting as it concerns the fragments of these triangles. `Err` says why it cannot be followed.
    pub(super) fn set(
        setting: Setting<'_>,
        triangles: &[Triangle],
    ) -> std::result::Result<Self, &'static str> {
        Ok(match setting {
            Setting::Order(order) => {
                let drawn = drawn(triangles, order).ok_or(IN_PIECES)?;
                Self::Order(drawn.into_iter().map(|number| number as u32).collect())
            }
            Setting::Defines(defines) => Self::Defines(defines.to_vec()),
            Setting::Band(band) => Self::Band(band),
            Setting::Screen(screen) => Self::Screen(screen),
            Setting::Window(window) => Self::Screen(Some(window)),
            Setting::Layers(layers) => Self::Layers(layers),
            Setting::Numbers(_) => return Err(NUMBERS),
        })
    }

    /// Does it on an emulated pixel.
    ///
    /// # Errors
    /// What the emulated pixel leaves out.
    pub(super) fn repeat(&self, emulator: &mut Emulator) -> Result<()> {
        match self {
            Self::Map(map, format) => return emulator.allocate(*map, *format),
            Self::Framebuffer(target, colors, depth) => {
                return emulator.framebuffer_with(*target, colors, *depth);
            }
            &Self::Background([red, green, blue]) => {
                return emulator.perform(&glClearColor(red, green, blue, 1.0));
            }
            Self::Call(call) => return emulator.perform(call),
            Self::Order(order) => emulator.set_order(Some(order)),
            Self::Defines(defines) => emulator.set_defines(defines),
            Self::Band(band) => emulator.set_band(*band),
            Self::Screen(screen) => emulator.set_screen(*screen),
            Self::Layers(layers) => emulator.set_layers(*layers),
        }
        Ok(())
    }
}

/// A pixel in an image.
#[derive(Clone, Debug)]
pub(super) struct Place {
    /// Column from the left, row from the bottom.
    pub(super) pixel: [u32; 2],
    /// The distances of the near and the far plane.
    pub(super) planes: [f64; 2],
    /// Whether depths are 1/w.
    pub(super) inverse_w: bool,
    /// The scene's volumes, and the ray through the pixel.
    pub(super) volumes: Arc<[Volume]>,
    pub(super) ray: PixelRay,
}

impl Place {
    /// An emulated pixel at this place, which records nothing.
    pub(super) fn emulator(&self, surfaces: Vec<Surface>) -> Emulator {
        let mut emulator = Emulator::new(vec![surfaces]);
        emulator.set_places(vec![self.pixel]);
        emulator.set_planes(self.planes);
        emulator.set_inverse_w(self.inverse_w);
        emulator.set_volumes(Arc::clone(&self.volumes), vec![self.ray]);
        emulator
    }

    /// The same, but with everything so many times as far away.
    pub(super) fn at_distance(&self, times: f64) -> Self {
        Self {
            planes: self.planes.map(|plane| plane * times),
            ..self.clone()
        }
    }

    /// The same, but with volumes that nothing is seen of.
    pub(super) fn with_clear_volumes(&self) -> Self {
        let nothing = [0.0, 1.0].map(|value| TransferPoint {
            value,
            color: [0.0; 3],
            density: 0.0,
        });
        let anywhere = DAffine3::from_scale(DVec3::splat(1e6));
        let clear = Volume::new("clear", [2; 3], vec![0.0; 8], anywhere);
        let clear = clear.expect("a volume of eight samples");
        let clear = clear.with_transfer(Transfer::new(nothing.into()).expect("two points"));
        Self {
            volumes: vec![clear; self.volumes.len()].into(),
            ..self.clone()
        }
    }
}
