//! A scene's volumes in the driver's memory, for the shaders of fused rendering and for slices.

use std::borrow::Cow;

use glam::{DMat3, DVec3};
use glow::HasContext;

use super::context::Context;
use super::machine::GlMachine;
use super::making::{allocate, named, no_room};
use super::pixel_store::PixelStore;
use super::storage::Texels;
use crate::error::{Error, Result};
use crate::scene::{Scene, TransferPoint, Volume};
use crate::steps::Storage;

/// The most volumes: a fragment's id and the resolve's occupancy have bits for so many. Drivers with fewer texture
/// units allow fewer.
pub const MOST_VOLUMES: u32 = 32;

/// The texture unit of the first volume. The units before it are for the fragment lists, the opaque depth and the
/// transfer functions.
const FIRST_UNIT: u32 = 7;
const TRANSFER_UNIT: u32 = 6;
const PLACES: Storage = Storage("volumes' places");
const TRANSFER: Storage = Storage("transfer functions");

/// VOLUMES and POINTS, what shaders are compiled with.
pub(super) type Constants = [(&'static str, u32); 2];

/// A 3D texture for each volume.
pub struct VolumeTextures<'c> {
    context: &'c Context,
    textures: Vec<glow::Texture>,
    bytes: u64,
}

impl VolumeTextures<'_> {
    pub(super) fn bytes(&self) -> u64 {
        self.bytes
    }
}

impl<'c> GlMachine<'c> {
    /// Uploads the scene's volumes, and deletes the earlier ones. Returns the defines that shaders need, VOLUMES and
    /// POINTS. Both are 0 without volumes.
    ///
    /// # Errors
    /// If there are more volumes than the ids have bits or the driver has texture units, or if it has too little
    /// memory.
    pub fn upload_volumes(&mut self, scene: &Scene) -> Result<Constants> {
        self.upload(scene, 0.0)
    }

    /// Uploads the scene's volumes for meshes that are shaded as [`Shading::Slice`](crate::scene::Shading::Slice), which
    /// are drawn from now on until [`free_every_map`](Self::free_every_map). `spacing` is the distance from slice to slice.
    ///
    /// # Errors
    /// As [`upload_volumes`](Self::upload_volumes).
    pub fn upload_slices(&mut self, scene: &Scene, spacing: f64) -> Result<()> {
        self.slices = Some(self.upload(scene, spacing)?);
        Ok(())
    }

    fn upload(&mut self, scene: &Scene, spacing: f64) -> Result<Constants> {
        self.volumes = None;
        let count = scene.volumes.len() as u32;
        if count == 0 {
            return Ok([("VOLUMES", 0), ("POINTS", 0)]);
        }
        self.expect_room_for(count)?;
        let most = scene.volumes.iter().map(|v| v.transfer.points().len());
        // One more than any has, to end at.
        let points = (most.max().unwrap_or(0) + 1).next_power_of_two() as u32;
        let mut textures = VolumeTextures {
            context: self.context,
            textures: Vec::new(),
            bytes: 0,
        };
        for volume in &scene.volumes {
            textures.add(volume)?;
        }
        self.volumes = Some(textures);
        let transfer: Vec<u32> = scene
            .volumes
            .iter()
            .flat_map(|volume| padded(volume.transfer.points(), points as usize))
            .map(f32::to_bits)
            .collect();
        self.allocate_storage(TRANSFER, transfer.len() as u64 * 4, Some(Texels::Rgba32F))?;
        self.write_storage(TRANSFER, &transfer)?;
        let places = places(scene, self.size, spacing);
        let places: Vec<u32> = places.into_iter().map(f32::to_bits).collect();
        self.allocate_storage(PLACES, places.len() as u64 * 4, None)?;
        self.write_storage(PLACES, &places)?;
        Ok([("VOLUMES", count), ("POINTS", points)])
    }

    /// Binds the volumes that [`upload_volumes`](Self::upload_volumes) has uploaded, if there are any.
    ///
    /// # Errors
    /// If the driver has lost its objects.
    pub fn bind_volumes(&self) -> Result<()> {
        let Some(volumes) = &self.volumes else {
            return Ok(());
        };
        let gl = self.context.glow();
        for (unit, texture) in (FIRST_UNIT..).zip(&volumes.textures) {
            // SAFETY: the context is current, the texture is alive, and there are so many units.
            unsafe {
                gl.active_texture(glow::TEXTURE0 + unit);
                gl.bind_texture(glow::TEXTURE_3D, Some(*texture));
                gl.active_texture(glow::TEXTURE0);
            }
        }
        self.bind_texels(TRANSFER_UNIT, TRANSFER)?;
        self.bind_uniforms(1, PLACES)
    }

    fn expect_room_for(&self, count: u32) -> Result<()> {
        let remedy = "leave some volumes out, or render with -m exact, which takes any number";
        if count > MOST_VOLUMES {
            return Err(Error::usage(
                format!(
                    "the scene has {count} volumes, and a fragment's id has bits for {MOST_VOLUMES}"
                ),
                remedy,
            ));
        }
        let units = self.context.driver().limit("GL_MAX_TEXTURE_IMAGE_UNITS");
        let room = u32::try_from(units).unwrap_or(0).saturating_sub(FIRST_UNIT);
        if count > room {
            return Err(Error::Driver {
                what: format!(
                    "the scene has {count} volumes, and this driver has texture units for {room}"
                ),
                remedy: remedy.into(),
            });
        }
        Ok(())
    }
}

impl VolumeTextures<'_> {
    fn add(&mut self, volume: &Volume) -> Result<()> {
        let dims = volume.dims();
        let bytes = volume.samples().len() as u64 * 4;
        let what = format!(
            "the volume '{}' of {} x {} x {} samples",
            volume.name, dims[0], dims[1], dims[2]
        );
        let most = self.context.driver().limit("GL_MAX_3D_TEXTURE_SIZE");
        if dims.iter().any(|&side| side as i64 > most) {
            let why = format!("a side may have {most} samples at the most");
            return Err(no_room(&what, bytes, &why));
        }
        let [width, height, depth] = dims.map(|side| side as i32);
        let gl = self.context.glow();
        let _tight = PixelStore::own(self.context);
        // SAFETY: the context is current, and there are as many samples as the texture has texels.
        unsafe {
            let raw = named("texture", gl.create_texture())?;
            self.textures.push(raw);
            gl.active_texture(glow::TEXTURE15);
            gl.bind_texture(glow::TEXTURE_3D, Some(raw));
            let room = allocate(gl, &what, bytes, || {
                gl.tex_storage_3d(glow::TEXTURE_3D, 1, glow::R32F, width, height, depth);
            });
            if room.is_ok() {
                let samples = texels(volume);
                let samples = bytemuck::cast_slice(&samples);
                let samples = glow::PixelUnpackData::Slice(Some(samples));
                gl.tex_sub_image_3d(
                    glow::TEXTURE_3D,
                    0,
                    0,
                    0,
                    0,
                    width,
                    height,
                    depth,
                    glow::RED,
                    glow::FLOAT,
                    samples,
                );
            }
            gl.bind_texture(glow::TEXTURE_3D, None);
            gl.active_texture(glow::TEXTURE0);
            room?;
        }
        self.bytes += bytes;
        Ok(())
    }
}

/// The value of an empty sample in `volume.glsl`. It is less than every value that a sample may have, so that shaders
/// need no NaN.
const EMPTY: f32 = -3e38;

/// The samples in the form of the texture.
fn texels(volume: &Volume) -> Cow<'_, [f32]> {
    if !volume.has_empty() {
        return Cow::Borrowed(volume.samples());
    }
    let texel = |&sample: &f32| if sample.is_nan() { EMPTY } else { sample };
    Cow::Owned(volume.samples().iter().map(texel).collect())
}

/// `count` points of eight numbers, as `volume.glsl` reads them. The list is filled up with the last point, at
/// infinity.
fn padded(points: &[TransferPoint], count: usize) -> impl Iterator<Item = f32> + '_ {
    let last = points.last().map(|point| TransferPoint {
        value: f32::INFINITY,
        ..*point
    });
    let points = points
        .iter()
        .copied()
        .chain(std::iter::repeat(last).flatten());
    points.take(count).flat_map(|point| {
        let [r, g, b] = point.color;
        [point.value, point.density, 0.0, 0.0, r, g, b, 0.0]
    })
}

/// The block `Volumes` of `volume.glsl`, computed in f64.
fn places(scene: &Scene, [width, height]: [u32; 2], spacing: f64) -> Vec<f32> {
    let camera = &scene.camera;
    let [width, height] = [width, height].map(f64::from);
    let half = (camera.fov.to_radians() / 2.0).tan();
    let [half_width, half_height] = [half * width / height, half];
    let forward = (camera.target - camera.eye).normalize();
    let right = forward.cross(camera.up).normalize();
    let up = right.cross(forward);
    let to_borders = DMat3::from_cols(right * half_width, up * half_height, forward);
    let mut block = vec![
        camera.near,
        camera.far,
        half_width,
        half_height,
        width,
        height,
        spacing,
        0.0,
    ];
    for volume in &scene.volumes {
        let to_index = volume.world_to_index();
        let eye: DVec3 = to_index.transform_point3(camera.eye);
        block.extend(eye.extend(volume.sampling_distance()).to_array());
        let axes = to_index.matrix3 * to_borders;
        let axes = [axes.x_axis, axes.y_axis, axes.z_axis];
        for (axis, last) in axes.into_iter().zip(volume.last().to_array()) {
            block.extend(axis.extend(last).to_array());
        }
    }
    block.into_iter().map(|number| number as f32).collect()
}

impl Drop for VolumeTextures<'_> {
    fn drop(&mut self) {
        // In another context the names would be someone else's objects.
        let Ok(_away) = self.context.enter() else {
            return;
        };
        for &texture in &self.textures {
            // SAFETY: the texture is this one's own, and the context outlives the borrow.
            unsafe { self.context.glow().delete_texture(texture) };
        }
    }
}
