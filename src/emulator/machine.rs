//! The machine: pixels, their state and maps, and what it can be told and asked. `perform` has what each call does.

use std::collections::HashMap;
use std::sync::Arc;

use super::maps::Maps;
use super::record::Record;
use super::settings::{PixelRay, Settings};
use super::state::State;
use super::surface::{Group, Surface};
use crate::error::{Error, Result};
use crate::fragment::Fragment;
use crate::scene::Volume;
use crate::steps::{Map, Query, Shader};

/// Runs listings on pixels whose surfaces are given. Maps and framebuffers are made as on the GL machine.
#[derive(Debug)]
pub struct Emulator {
    /// Each pixel's surfaces in the order of submission.
    pub(super) pixels: Vec<Vec<Surface>>,
    /// Each pixel's surfaces as they are drawn, if that is another order.
    drawn: Option<Vec<Vec<Surface>>>,
    /// Each pixel's column and row in the image, if they have been said.
    places: Vec<[u32; 2]>,
    band: Option<[u32; 2]>,
    screen: Option<[u32; 4]>,
    pub(super) state: State,
    pub(super) maps: Maps,
    pub(super) settings: Settings,
    pub(super) program: Option<Shader>,
    pub(super) queries: HashMap<Query, u64>,
    pub(super) counting: Option<Query>,
    /// Each pixel's records in the order of filling. Where a fill has stored fewer than the one before, old ones follow.
    pub(super) records: Vec<Vec<Fragment>>,
    /// The plane that counts them.
    pub(super) counter: Option<usize>,
    pub(super) composited: Vec<Vec<u32>>,
    pub(super) watched: Vec<bool>,
    pub(super) histories: Vec<Record>,
}

impl Emulator {
    /// A machine in GL's initial state for pixels with these surfaces. Each pixel's surfaces are in the order of
    /// submission.
    pub fn new(pixels: Vec<Vec<Surface>>) -> Self {
        let count = pixels.len();
        Self {
            pixels,
            drawn: None,
            places: Vec::new(),
            band: None,
            screen: None,
            state: State::INITIAL,
            maps: Maps::new(count),
            settings: Settings::new(),
            program: None,
            queries: HashMap::new(),
            counting: None,
            records: vec![Vec::new(); count],
            counter: None,
            composited: vec![Vec::new(); count],
            watched: vec![false; count],
            histories: vec![Record::default(); count],
        }
    }

    /// The same, but it also records what happens to every surface of one pixel.
    ///
    /// # Panics
    /// If there is no such pixel.
    #[must_use]
    pub fn watching(mut self, pixel: usize) -> Self {
        assert!(pixel < self.pixels.len(), "there is no pixel {pixel}");
        self.watched[pixel] = true;
        self
    }

    /// The same, but it also records what happens to every surface of every pixel.
    #[must_use]
    pub fn watching_all(mut self) -> Self {
        self.watched.fill(true);
        self
    }

    /// The record of the watched pixel's surfaces so far. If several are watched, it is the first one's.
    pub fn record(&self) -> &Record {
        const NOTHING: &Record = &Record {
            draws: Vec::new(),
            resolves: Vec::new(),
        };
        let first = self.watched.iter().position(|watched| *watched);
        first.map_or(NOTHING, |pixel| &self.histories[pixel])
    }

    /// Each pixel's record so far. It is empty if the pixel is not watched.
    pub fn records(&self) -> &[Record] {
        &self.histories
    }

    /// GL's initial state, with nothing bound, every surface drawn in the order of submission, everywhere. Maps,
    /// framebuffers and records stay.
    pub fn begin_frame(&mut self) {
        self.state = State::INITIAL;
        self.settings.compare_func = Settings::new().compare_func;
        self.maps.unbind();
        (self.program, self.counting) = (None, None);
        (self.drawn, self.band, self.screen) = (None, None, None);
    }

    /// Has transparent surfaces drawn in this order from now on, each given by its place in the order of submission, and
    /// no others. One that is named several times is drawn as often. With `None` all of them are drawn in the order of
    /// submission. Opaque surfaces and the boxes around volumes are drawn in any case, and before the others.
    pub fn set_order(&mut self, order: Option<&[u32]>) {
        let Some(order) = order else {
            self.drawn = None;
            return;
        };
        let surfaces = self.pixels.iter().flatten();
        let mut turns: HashMap<u32, Vec<usize>> = surfaces
            .map(|surface| (surface.fragment.order, Vec::new()))
            .collect();
        for (turn, triangle) in order.iter().enumerate() {
            if let Some(turns) = turns.get_mut(triangle) {
                turns.push(turn);
            }
        }
        // One that is always drawn has its turn before all others.
        let turns_of = |surface: &Surface| match surface.group {
            Group::Opaque | Group::Proxy => vec![None],
            Group::Sorted | Group::Unsorted => {
                let turns = turns.get(&surface.fragment.order).into_iter().flatten();
                turns.copied().map(Some).collect()
            }
        };
        let in_order = |surfaces: &Vec<Surface>| {
            let with_turns = surfaces.iter().flat_map(|surface| {
                let turns = turns_of(surface).into_iter();
                turns.map(|turn| (turn, *surface))
            });
            let mut drawn: Vec<_> = with_turns.collect();
            drawn.sort_by_key(|(turn, _)| *turn);
            drawn.into_iter().map(|(_, surface)| surface).collect()
        };
        self.drawn = Some(self.pixels.iter().map(in_order).collect());
    }

    /// The `#define`s of programs that are used from now on, names and values.
    pub fn set_defines(&mut self, defines: &[(&'static str, u32)]) {
        self.settings.defines = defines.iter().copied().collect();
    }

    /// The distances of the near and the far plane, for shaders that ask how far a fragment is away. Its distance along
    /// the view direction is then computed from its depth.
    pub fn set_planes(&mut self, planes: [f64; 2]) {
        self.settings.planes = planes;
    }

    /// Whether fragments' depths are 1/w (`glsl/common/fragment_depth.glsl`), and not window-space depths.
    pub fn set_inverse_w(&mut self, inverse_w: bool) {
        self.settings.inverse_w = inverse_w;
    }

    /// The scene's volumes, and each pixel's ray through them, for a Resolve Step that casts rays. Its planes are those of
    /// [`set_planes`](Self::set_planes), and it samples in f64.
    ///
    /// # Panics
    /// If there are not as many rays as pixels.
    pub fn set_volumes(&mut self, volumes: impl Into<Arc<[Volume]>>, rays: Vec<PixelRay>) {
        assert_eq!(rays.len(), self.pixels.len(), "one ray for each pixel");
        (self.settings.volumes, self.settings.rays) = (volumes.into(), rays);
    }

    /// The number of records that a fixed buffer has for each pixel. Without it there is room for all.
    pub fn set_layers(&mut self, layers: u32) {
        self.settings.layers = layers;
    }

    /// Each pixel's column and row in the image, from the lower left. They are needed where only a part of the image is
    /// drawn.
    ///
    /// # Panics
    /// If there are not as many as pixels.
    pub fn set_places(&mut self, places: Vec<[u32; 2]>) {
        assert_eq!(places.len(), self.pixels.len(), "one place for each pixel");
        self.places = places;
    }

    /// Draws and clears only so many rows from the first one on, counted from the bottom, at pixels whose places have been
    /// said. With `None`, all rows.
    ///
    /// This is for bands of the image. Bands of marked pixels' lists are no part of the emulated machine, which has those
    /// lists at the pixels themselves.
    pub fn set_band(&mut self, band: Option<[u32; 2]>) {
        self.band = band;
    }

    /// Has draws over the screen cover these pixels only: x, y, width and height. With `None`, all.
    pub fn set_screen(&mut self, screen: Option<[u32; 4]>) {
        self.screen = screen;
    }

    /// The surfaces of a pixel as they are drawn.
    pub(super) fn drawn(&self, pixel: usize) -> &[Surface] {
        &self.drawn.as_ref().unwrap_or(&self.pixels)[pixel]
    }

    /// Whether the band has this pixel.
    pub(super) fn is_in_band(&self, pixel: usize) -> bool {
        match (self.band, self.places.get(pixel)) {
            (Some([first, rows]), Some(&[_, y])) => y.wrapping_sub(first) < rows,
            _ => true,
        }
    }

    /// Whether draws over the screen cover this pixel.
    pub(super) fn is_on_screen(&self, pixel: usize) -> bool {
        match (self.screen, self.places.get(pixel)) {
            (Some([left, low, width, height]), Some(&[x, y])) => {
                x.wrapping_sub(left) < width && y.wrapping_sub(low) < height
            }
            _ => true,
        }
    }

    /// For each pixel, the surfaces that were composited front to back (blended under earlier ones) into the first color
    /// map, in their order of compositing. A surface is given by its place in the order of submission.
    pub fn composited(&self) -> &[Vec<u32>] {
        &self.composited
    }

    /// The fragment list of a pixel, as the last fill left it. Records are in the order of filling, which is also that of
    /// fixed and dynamic buffers in memory. Linked lists are walked from the end. A record's colour is rounded as it is
    /// stored, and its `order` is its id.
    ///
    /// # Panics
    /// If there is no such pixel.
    pub fn list(&self, pixel: usize) -> &[Fragment] {
        let records = &self.records[pixel];
        let counted = self.counter.map_or(0, |plane| {
            let plane = &self.maps.planes[plane];
            plane.texel(pixel).integers()[0] as usize
        });
        &records[..counted.min(records.len())]
    }

    /// A color map's texels.
    ///
    /// # Errors
    /// If there is no such map.
    pub fn colors(&self, map: Map) -> Result<&[[f32; 4]]> {
        Ok(&self.maps.get(map)?.colors)
    }

    /// The texels of a map of whole numbers.
    ///
    /// # Errors
    /// If there is no such map.
    pub fn integers(&self, map: Map) -> Result<&[[u32; 4]]> {
        Ok(&self.maps.get(map)?.integers)
    }

    /// A depth map's depths as its format stores them, which for fixed point are raw integers.
    ///
    /// # Errors
    /// If there is no such map.
    pub fn depths(&self, map: Map) -> Result<&[f32]> {
        Ok(&self.maps.get(map)?.depths)
    }

    /// A depth map's stencil values.
    ///
    /// # Errors
    /// If there is no such map.
    pub fn stencils(&self, map: Map) -> Result<&[u8]> {
        Ok(&self.maps.get(map)?.stencils)
    }

    pub(super) fn program(&self) -> Result<Shader> {
        self.program.ok_or_else(|| {
            Error::out_of_order(
                "the listing draws before it chooses a program",
                "glUseProgram comes first",
            )
        })
    }
}
