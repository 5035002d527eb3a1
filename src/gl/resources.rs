//! What a method makes on the GL machine before its listing runs, and reads from it afterwards: maps, framebuffers,
//! buffers, volumes, base offsets.

use super::bindings::{BAND_BLOCK, BandParameters, NUMBERS as NUMBERS_UNIT};
use super::machine::GlMachine;
use super::numbers::Numbers;
use super::program::Define;
use super::scan::scan_bytes;
use super::storage::Texels;
use super::witness::Setting;
use crate::error::Result;
use crate::scene::Scene;
use crate::steps::{Format, Map, Storage, Target, Workspace};

/// The block of a band is as long as whole groups of four numbers.
const BAND_BYTES: u64 = size_of::<BandParameters>().next_multiple_of(16) as u64;
const BAND: Storage = Storage("parameters");
const NUMBERS: Storage = Storage("numbers of marked pixels");

impl<'c> GlMachine<'c> {
    /// Makes a map of the image's size, unless it is there in this format.
    ///
    /// # Errors
    /// If the driver has no room.
    pub fn allocate(&mut self, map: Map, format: Format) -> Result<()> {
        self.maps.allocate(self.context, map, format)?;
        self.watch.tell(|witness| witness.allocated(map, format))
    }

    /// Makes a map as wide as the image and of so many rows from the bottom, unless it is there in this format and has as
    /// many.
    ///
    /// # Errors
    /// If the driver has no room.
    pub(crate) fn allocate_rows(&mut self, map: Map, format: Format, rows: u32) -> Result<()> {
        self.maps.allocate_rows(self.context, map, format, rows)?;
        self.watch.tell(|witness| witness.allocated(map, format))
    }

    /// How a map stores its texels.
    ///
    /// # Errors
    /// If there is no such map.
    pub fn format(&self, map: Map) -> Result<Format> {
        Ok(self.maps.get(map)?.format)
    }

    /// Lets go of a map.
    pub fn free(&mut self, map: Map) {
        self.maps.free(self.context.glow(), map);
    }

    /// Lets go of every map, buffer, framebuffer and volume.
    pub(crate) fn free_every_map(&mut self) {
        self.free_every_map_but_the_volumes();
        self.volumes.free();
    }

    /// Lets go of every map, buffer and framebuffer. The volumes' samples stay where they are; the scene that is uploaded
    /// next has the same volumes.
    pub(crate) fn free_every_map_but_the_volumes(&mut self) {
        let gl = self.context.glow();
        self.programs.slices = None;
        self.volumes.keep();
        self.framebuffers.delete(gl);
        self.storages.delete(gl);
        self.maps.delete(gl);
    }

    /// Makes a framebuffer that draws into these maps.
    ///
    /// # Errors
    /// If a map is missing, or the driver does not take the combination.
    pub fn framebuffer(
        &mut self,
        target: Target,
        color: Option<Map>,
        depth: Option<Map>,
    ) -> Result<()> {
        self.framebuffer_with(target, color.as_slice(), depth)
    }

    /// The same with as many color maps as there are, the first for the shaders' location 0.
    ///
    /// # Errors
    /// As [`framebuffer`](Self::framebuffer).
    ///
    /// # Panics
    /// With more than eight.
    pub fn framebuffer_with(
        &mut self,
        target: Target,
        colors: &[Map],
        depth: Option<Map>,
    ) -> Result<()> {
        let raw = colors.iter().map(|&map| self.maps.get(map));
        let raw = raw.collect::<Result<Vec<_>>>()?;
        let raw_depth = depth.map(|map| self.maps.get(map)).transpose()?;
        let gl = self.context.glow();
        self.framebuffers.attach(gl, target, &raw, raw_depth)?;
        self.watch
            .tell(|witness| witness.framed(target, colors, depth))
    }

    /// Copies a framebuffer's colours into the default framebuffer, lower left corner on lower left corner.
    ///
    /// # Errors
    /// If there is no such framebuffer.
    pub(crate) fn copy_to_window(&mut self, target: Target) -> Result<()> {
        let size = self.size();
        self.framebuffers.copy_to_window(self.context, target, size)
    }

    /// Makes a buffer of at least so many bytes, unless there is one. Its contents are undefined. Buffers do not shrink: the
    /// bands of an image take turns in one that is as large as the largest band needs.
    ///
    /// # Errors
    /// If the driver has no room.
    pub fn allocate_storage(
        &mut self,
        storage: Storage,
        bytes: u64,
        texels: Option<Texels>,
    ) -> Result<()> {
        self.storages.allocate(self.context, storage, bytes, texels)
    }

    /// Binds a buffer's texels to a texture unit.
    ///
    /// # Errors
    /// If there is no such buffer, or it has no texels.
    pub fn bind_texels(&self, unit: u32, storage: Storage) -> Result<()> {
        self.storages
            .bind_texels(self.context.glow(), unit, storage)
    }

    /// Sets every 32-bit word of a buffer to 0.
    ///
    /// # Errors
    /// If there is no such buffer.
    pub fn clear_storage(&self, storage: Storage) -> Result<()> {
        self.storages.clear(self.context.glow(), storage)
    }

    /// Fills a buffer's beginning.
    ///
    /// # Errors
    /// If there is no such buffer, or it is shorter.
    pub fn write_storage(&self, storage: Storage, bytes: &[u8]) -> Result<()> {
        self.storages.write(self.context.glow(), storage, bytes)
    }

    /// A buffer's bytes.
    ///
    /// # Errors
    /// If there is no such buffer.
    pub fn read_storage(&self, storage: Storage) -> Result<Vec<u8>> {
        self.storages.read(self.context.glow(), storage)
    }

    /// Tells shaders which band of the image is rendered.
    ///
    /// # Errors
    /// If the driver has no room.
    pub(crate) fn set_parameters(&mut self, parameters: BandParameters) -> Result<()> {
        let gl = self.context.glow();
        self.watch.set(Setting::Layers(parameters.layers));
        self.storages
            .allocate(self.context, BAND, BAND_BYTES, None)?;
        self.storages
            .write(gl, BAND, bytemuck::bytes_of(&parameters))?;
        self.storages.bind_uniforms(gl, BAND_BLOCK, BAND)
    }

    /// Tells shaders the numbers of marked pixels.
    ///
    /// # Errors
    /// If the driver has no room.
    pub(crate) fn set_numbers(&mut self, numbers: &Numbers) -> Result<()> {
        self.watch.set(Setting::Numbers(numbers));
        let bytes = bytemuck::cast_slice(numbers.words());
        self.allocate_storage(NUMBERS, size_of_val(bytes) as u64, Some(Texels::Rg32Ui))?;
        self.write_storage(NUMBERS, bytes)?;
        self.bind_texels(NUMBERS_UNIT, NUMBERS)
    }

    /// Uploads the scene's volumes, and lets go of those that were there. Returns the defines that shaders need about
    /// them, VOLUMES and POINTS, both 0 without any.
    ///
    /// # Errors
    /// There are more than the ids have bits or the driver has texture units for, or it has no room.
    pub(crate) fn upload_volumes(&mut self, scene: &Scene) -> Result<[Define; 2]> {
        self.upload(scene, 0.0)
    }

    /// Uploads the scene's volumes for meshes that are shaded as [`Shading::Slice`](crate::scene::Shading::Slice), which
    /// are drawn from now on until [`free_every_map`](Self::free_every_map). `spacing` is the distance from slice to slice.
    ///
    /// # Errors
    /// As [`upload_volumes`](Self::upload_volumes).
    pub(crate) fn upload_slices(&mut self, scene: &Scene, spacing: f64) -> Result<()> {
        self.programs.slices = Some(self.upload(scene, spacing)?);
        Ok(())
    }

    fn upload(&mut self, scene: &Scene, spacing: f64) -> Result<[Define; 2]> {
        let size = self.size();
        let storages = &mut self.storages;
        self.volumes
            .upload(self.context, storages, scene, size, spacing)
    }

    /// Binds what [`upload_volumes`](Self::upload_volumes) has uploaded, if anything.
    ///
    /// # Errors
    /// None but what the driver has lost.
    pub(crate) fn bind_volumes(&self) -> Result<()> {
        self.volumes.bind(self.context.glow(), &self.storages)
    }

    /// Bytes of the buffers that the prefix scan of an A-buffer needs for so many numbers, the result included.
    pub fn scan_bytes(numbers: u64) -> u64 {
        scan_bytes(numbers)
    }

    /// Makes `offsets` hold, for each pixel of the image, the sum of the counts of the pixels before it, row by row from the
    /// bottom, modulo 2^32. `counts` is a map of whole numbers in float texels.
    ///
    /// # Errors
    /// If the driver has no room.
    pub(crate) fn prefix_scan(&mut self, counts: Map, offsets: Storage) -> Result<()> {
        let counts = self.maps.get(counts)?;
        self.programs.forget_current();
        let files = &self.programs.files;
        self.scan
            .run(self.context, files, &mut self.storages, counts, offsets)
    }

    /// A colour map's texels, bottom row first.
    ///
    /// # Errors
    /// If there is no such map.
    pub fn read_colors(&self, map: Map) -> Result<Vec<[f32; 4]>> {
        Ok(self.maps.get(map)?.read_colors(self.context))
    }

    /// A depth map's depths, bottom row first.
    ///
    /// # Errors
    /// If there is no such map.
    pub fn read_depths(&self, map: Map) -> Result<Vec<f32>> {
        Ok(self.maps.get(map)?.read_depths(self.context))
    }

    /// A depth map's stencil values, bottom row first; 0 where its format has none.
    ///
    /// # Errors
    /// If there is no such map.
    pub fn read_stencils(&self, map: Map) -> Result<Vec<u8>> {
        Ok(self.maps.get(map)?.read_stencils(self.context))
    }

    /// An integer map's texels, four numbers each, bottom row first; channels that it does not have are 0, or 1 for the
    /// last.
    ///
    /// # Errors
    /// If there is no such map.
    pub fn read_integers(&self, map: Map) -> Result<Vec<[u32; 4]>> {
        Ok(self.maps.get(map)?.read_integers(self.context))
    }

    /// A map's first channel, bottom row first, as whole numbers.
    ///
    /// # Errors
    /// If there is no such map.
    pub fn read_counts(&self, map: Map) -> Result<Vec<u32>> {
        Ok(self.maps.get(map)?.read_counts(self.context))
    }
}

impl Workspace for GlMachine<'_> {
    fn allocate(&mut self, map: Map, format: Format) -> Result<()> {
        self.allocate(map, format)
    }

    fn framebuffer_with(
        &mut self,
        target: Target,
        colors: &[Map],
        depth: Option<Map>,
    ) -> Result<()> {
        self.framebuffer_with(target, colors, depth)
    }
}
