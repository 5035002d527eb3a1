//! The GL machine's tables: which GL object a listing's name stands for. What the calls do is in `interpreter`.

use std::collections::HashMap;

use glow::HasContext;

use super::classic::Classic;
use super::context::Context;
use super::geometry::Geometry;
use super::host::{UNITS, known_state};
use super::making::{Making, expect_no_error};
use super::program::{Linked, ProgramKey};
use super::scan::ScanPrograms;
use super::storage::StorageBuffer;
use super::texture::Texture;
use super::volumes::{self, VolumeTextures};
use crate::error::{Error, Result};
use crate::steps::{Format, Map, Query, Storage, Target, Workspace};

/// Runs listings on OpenGL.
///
/// It keeps the tables that give the listings' names their GL objects. Maps and framebuffers are made by
/// [`allocate`](Self::allocate) and [`target`](Self::target) before a listing runs; programs and queries are made when
/// they are first named.
pub struct GlMachine<'c> {
    pub(super) context: &'c Context,
    pub(super) size: [u32; 2],
    pub(super) textures: HashMap<Map, Texture>,
    pub(super) framebuffers: HashMap<Target, glow::Framebuffer>,
    pub(super) storages: HashMap<Storage, StorageBuffer>,
    pub(super) programs: HashMap<ProgramKey, Linked>,
    /// The defines of an A-buffer's programs.
    pub(super) constants: Vec<(&'static str, u32)>,
    /// The near plane's distance, as the bits of a float, if depths are 1/w.
    pub(super) inverse_w: Option<u32>,
    pub(super) queries: HashMap<Query, glow::Query>,
    /// The sampler with compare mode, of texture unit 0.
    pub(super) shadow_sampler: glow::Sampler,
    /// The sampler without compare mode, of the other units.
    pub(super) plain_sampler: glow::Sampler,
    /// Draws without attributes need a vertex array without attributes.
    pub(super) no_attributes: glow::VertexArray,
    pub(super) geometry: Option<Geometry<'c>>,
    pub(super) volumes: Option<VolumeTextures<'c>>,
    /// The defines of the programs of slices, if any are drawn.
    pub(super) slices: Option<volumes::Constants>,
    /// The programs of the scan, which are linked when a scan is first asked for.
    pub(super) scan: Option<ScanPrograms>,
    pub(super) current: Option<ProgramKey>,
    /// A query has begun and not ended.
    pub(super) counting: bool,
    /// The first row and the number of rows that are drawn to, or `None` for all rows.
    pub(super) band: Option<[u32; 2]>,
    pub(super) counts: Counts,
    /// The state and the objects of classic calls.
    pub(super) classic: Classic,
}

/// Counts of a machine's work since [`GlMachine::begin_frame`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// The draws of the scene, or of its transparent part.
    pub geometry_passes: u64,
    /// The bytes of all textures and buffers that the machine holds for the method.
    pub bytes: u64,
}

impl<'c> GlMachine<'c> {
    /// A machine for images of one size.
    ///
    /// # Errors
    /// If the size is 0 or over the driver's limit.
    pub fn new(context: &'c Context, [width, height]: [u32; 2]) -> Result<Self> {
        let largest = context.driver().largest_image();
        if width == 0 || height == 0 || width > largest || height > largest {
            return Err(Error::usage(
                format!("an image of {width} x {height} pixels cannot be rendered"),
                format!("this driver renders 1 x 1 to {largest} x {largest}"),
            ));
        }
        context.begin_making()?;
        let gl = context.glow();
        let mut making = Making::new(gl);
        // SAFETY: the context is current; the samplers are set up before they are used.
        let (shadow_sampler, plain_sampler, no_attributes) = unsafe {
            let shadow = making.sampler()?;
            let plain = making.sampler()?;
            for sampler in [shadow, plain] {
                for (name, value) in [
                    (glow::TEXTURE_MIN_FILTER, glow::NEAREST),
                    (glow::TEXTURE_MAG_FILTER, glow::NEAREST),
                    (glow::TEXTURE_WRAP_S, glow::CLAMP_TO_EDGE),
                    (glow::TEXTURE_WRAP_T, glow::CLAMP_TO_EDGE),
                ] {
                    gl.sampler_parameter_i32(sampler, name, value as i32);
                }
            }
            let compare = glow::COMPARE_REF_TO_TEXTURE as i32;
            gl.sampler_parameter_i32(shadow, glow::TEXTURE_COMPARE_MODE, compare);
            (shadow, plain, making.vertex_array()?)
        };
        making.finish();
        Ok(Self {
            context,
            size: [width, height],
            textures: HashMap::new(),
            framebuffers: HashMap::new(),
            storages: HashMap::new(),
            programs: HashMap::new(),
            constants: Vec::new(),
            inverse_w: None,
            queries: HashMap::new(),
            shadow_sampler,
            plain_sampler,
            no_attributes,
            geometry: None,
            volumes: None,
            slices: None,
            scan: None,
            current: None,
            counting: false,
            band: None,
            counts: Counts::default(),
            classic: Classic::default(),
        })
    }

    /// The context in which it works.
    pub fn context(&self) -> &'c Context {
        self.context
    }

    /// Width and height of its images.
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// Sets the geometry that draw calls draw.
    pub fn set_geometry(&mut self, geometry: Geometry<'c>) {
        self.geometry = Some(geometry);
    }

    /// Sets GL's initial state, as a fresh context has it, a viewport of the machine's size, and every count to 0.
    /// Listings start from there. The state before is lost, unless a [`Visit`](super::Visit) of the context is going
    /// on.
    pub fn begin_frame(&mut self) {
        self.end_counting();
        known_state(self.context, self.size);
        let gl = self.context.glow();
        // SAFETY: the context is current, and the samplers are the machine's own.
        unsafe {
            gl.active_texture(glow::TEXTURE0);
            for unit in 0..UNITS {
                let sampler = match unit {
                    0 => Some(self.shadow_sampler),
                    1..8 => Some(self.plain_sampler),
                    // Volumes are fetched texel by texel, and classic calls bind their own.
                    _ => None,
                };
                gl.bind_sampler(unit, sampler);
            }
        }
        // A listing chooses its program again.
        self.current = None;
        self.band = None;
        self.counts.geometry_passes = 0;
        self.classic.state = None;
    }

    /// Ends a query that a listing has begun and, because a step of it failed, not ended.
    fn end_counting(&mut self) {
        if std::mem::take(&mut self.counting) {
            // SAFETY: the context is current, and the machine's own query is active.
            unsafe { self.context.glow().end_query(glow::SAMPLES_PASSED) };
        }
    }

    /// Asks OpenGL for errors since it was last asked. Release builds do not ask after each step.
    ///
    /// # Errors
    /// OpenGL's error, after any call.
    pub fn expect_no_error(&self, when: &str) -> Result<()> {
        expect_no_error(self.context.glow(), when)
    }

    /// What the programs whose names begin with `a_buffer/` or `ideal/` are compiled with from now on: names and values that their
    /// source sees as `#define`s.
    pub fn set_constants(&mut self, constants: &[(&'static str, u32)]) {
        self.constants = constants.to_vec();
    }

    /// Has surfaces tested, stored and compared by 1/w instead of window-space depth from now on, with the near plane at
    /// this distance; by window-space depth if none is given. What is stored then is explained in
    /// `glsl/common/fragment_depth.glsl`. It takes depth maps in 32-bit float. Classic calls and the shaders of the
    /// invariance experiment know nothing of it.
    pub fn set_inverse_w(&mut self, near: Option<f32>) {
        self.inverse_w = near.map(f32::to_bits);
    }

    /// Whether depths are 1/w.
    pub fn has_inverse_w(&self) -> bool {
        self.inverse_w.is_some()
    }

    /// Draws and clears only so many rows from `first` on, counted from the bottom. With `None`, all rows.
    pub fn set_band(&mut self, band: Option<[u32; 2]>) {
        self.band = band;
        self.scissor_to_band();
    }

    /// The scissor of the band, or `None` for the whole image.
    pub(super) fn scissor_to_band(&self) {
        let gl = self.context.glow();
        // SAFETY: the context is current.
        unsafe {
            match self.band {
                Some([first, rows]) => {
                    gl.enable_draw_buffer(glow::SCISSOR_TEST, 0);
                    let [width, rows] = [self.size[0], rows].map(|side| side as i32);
                    gl.scissor_slice(0, 1, &[[0, first as i32, width, rows]]);
                }
                None => gl.disable_draw_buffer(glow::SCISSOR_TEST, 0),
            }
        }
    }

    /// The counts since the frame began.
    pub fn counts(&self) -> Counts {
        Counts {
            bytes: self.textures.values().map(Texture::bytes).sum::<u64>()
                + self
                    .storages
                    .values()
                    .map(StorageBuffer::bytes)
                    .sum::<u64>()
                + self.volumes.as_ref().map_or(0, VolumeTextures::bytes),
            ..self.counts
        }
    }

    /// Does work whose draws are not the method's. They are left out of [`counts`](Self::counts).
    ///
    /// # Errors
    /// The errors of `work`.
    pub fn aside<T>(&mut self, work: impl FnOnce(&mut Self) -> Result<T>) -> Result<T> {
        let counts = self.counts;
        let result = work(self);
        self.counts = counts;
        result
    }

    /// Waits until all commands have been executed.
    pub fn finish(&self) {
        // SAFETY: the context is current.
        unsafe { self.context.glow().finish() };
    }

    /// Makes a map of the image's size, unless it exists in this format.
    ///
    /// # Errors
    /// If the driver has too little memory.
    pub fn allocate(&mut self, map: Map, format: Format) -> Result<()> {
        match self.textures.get(&map) {
            Some(texture) if texture.format == format => Ok(()),
            _ => {
                self.context.begin_making()?;
                self.free(map);
                let texture = Texture::new(self.context.glow(), &map, format, self.size)?;
                self.textures.insert(map, texture);
                Ok(())
            }
        }
    }

    /// The format of a map.
    ///
    /// # Errors
    /// If there is no such map.
    pub fn format(&self, map: Map) -> Result<Format> {
        Ok(self.texture(map)?.format)
    }

    /// Deletes a map.
    pub fn free(&mut self, map: Map) {
        if let Some(texture) = self.textures.remove(&map) {
            // SAFETY: the texture is the machine's own and is no longer in its table.
            unsafe { self.context.glow().delete_texture(texture.raw) };
        }
    }

    /// Deletes every map, buffer, framebuffer and volume.
    pub fn free_every_map(&mut self) {
        (self.volumes, self.slices) = (None, None);
        let gl = self.context.glow();
        // SAFETY: the objects are the machine's own and leave its tables here.
        unsafe {
            self.framebuffers
                .drain()
                .for_each(|(_, framebuffer)| gl.delete_framebuffer(framebuffer));
            self.storages
                .drain()
                .for_each(|(_, storage)| storage.delete(gl));
            self.textures
                .drain()
                .for_each(|(_, texture)| gl.delete_texture(texture.raw));
        }
    }

    /// A colour map's texels, bottom row first.
    ///
    /// # Errors
    /// If there is no such map.
    pub fn read_colors(&self, map: Map) -> Result<Vec<[f32; 4]>> {
        Ok(self.texture(map)?.read_colors(self.context))
    }

    /// A depth map's depths, bottom row first.
    ///
    /// # Errors
    /// If there is no such map.
    pub fn read_depths(&self, map: Map) -> Result<Vec<f32>> {
        Ok(self.texture(map)?.read_depths(self.context))
    }

    /// A depth map's stencil values, bottom row first. They are 0 if its format has none.
    ///
    /// # Errors
    /// If there is no such map.
    pub fn read_stencils(&self, map: Map) -> Result<Vec<u8>> {
        Ok(self.texture(map)?.read_stencils(self.context))
    }

    /// An integer map's texels, four numbers each, bottom row first. Missing channels are 0, except the last, which is
    /// 1.
    ///
    /// # Errors
    /// If there is no such map.
    pub fn read_integers(&self, map: Map) -> Result<Vec<[u32; 4]>> {
        Ok(self.texture(map)?.read_integers(self.context))
    }

    /// A map's first channel, bottom row first, as whole numbers.
    ///
    /// # Errors
    /// If there is no such map.
    pub fn read_counts(&self, map: Map) -> Result<Vec<u32>> {
        Ok(self.texture(map)?.read_counts(self.context))
    }

    pub(super) fn texture(&self, map: Map) -> Result<Texture> {
        self.textures.get(&map).copied().ok_or_else(|| {
            Error::usage(
                format!("the listing names the map '{map}', which does not exist"),
                "allocate it first",
            )
        })
    }
}

impl Workspace for GlMachine<'_> {
    fn allocate(&mut self, map: Map, format: Format) -> Result<()> {
        self.allocate(map, format)
    }

    fn target_of(&mut self, target: Target, colors: &[Map], depth: Option<Map>) -> Result<()> {
        self.target_of(target, colors, depth)
    }
}

impl Drop for GlMachine<'_> {
    fn drop(&mut self) {
        // In another context the names would be someone else's objects.
        let Ok(_away) = self.context.enter() else {
            return;
        };
        self.end_counting();
        self.free_classic();
        let gl = self.context.glow();
        // SAFETY: every object is the machine's own, and the context outlives the borrow.
        unsafe {
            self.textures
                .values()
                .for_each(|texture| gl.delete_texture(texture.raw));
            self.storages
                .values()
                .for_each(|storage| storage.delete(gl));
            self.framebuffers
                .values()
                .for_each(|framebuffer| gl.delete_framebuffer(*framebuffer));
            self.programs
                .values()
                .flat_map(Linked::programs)
                .for_each(|program| gl.delete_program(program.raw));
            if let Some(scan) = &self.scan {
                scan.delete(gl);
            }
            self.queries
                .values()
                .for_each(|query| gl.delete_query(*query));
            gl.delete_sampler(self.shadow_sampler);
            gl.delete_sampler(self.plain_sampler);
            gl.delete_vertex_array(self.no_attributes);
        }
    }
}

impl std::fmt::Debug for GlMachine<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("GlMachine")
            .field("size", &self.size)
            .field("maps", &self.textures.keys())
            .finish()
    }
}
