//! A scene's volumes in the driver's memory, for the shaders of fused rendering and for slices.

use std::borrow::Cow;

use glam::{DMat3, DVec3};
use glow::HasContext;

use super::bindings::{EMPTY, FIRST_VOLUME, PLACES_BLOCK, TRANSFER};
use super::context::Context;
use super::making::{allocate, named, no_room};
use super::pixel_store::PixelStore;
use super::program::Define;
use super::storage::{Storages, Texels};
use crate::error::{Error, Result};
use crate::scene::{Axes, Scene, TransferPoint, Volume};
use crate::steps::Storage;

/// The most volumes: a fragment's id and the resolve's occupancy have bits for so many. Drivers with fewer texture
/// units allow fewer.
pub const MOST_VOLUMES: u32 = 32;

const PLACES: Storage = Storage("volumes' places");
const TRANSFER_FUNCTIONS: Storage = Storage("transfer functions");

/// The volumes of a machine, if its scene has any.
#[derive(Default)]
pub(super) struct Volumes<'c> {
    textures: Option<VolumeTextures<'c>>,
    /// The next scene that is uploaded has the same volumes.
    are_kept: bool,
}

/// A 3D texture for each volume.
struct VolumeTextures<'c> {
    context: &'c Context,
    textures: Vec<glow::Texture>,
    bytes: u64,
}

impl<'c> Volumes<'c> {
    /// Uploads the scene's volumes, and lets go of those that were there, if it has others. `spacing` is the distance from slice to slice, where
    /// they are drawn as slices. Returns what shaders are compiled with for them: VOLUMES and POINTS, both 0 without any.
    ///
    /// # Errors
    /// There are more than the ids have bits or the driver has texture units for, or it has no room.
    pub(super) fn upload(
        &mut self,
        context: &'c Context,
        storages: &mut Storages,
        scene: &Scene,
        size: [u32; 2],
        spacing: f64,
    ) -> Result<[Define; 2]> {
        let kept = match std::mem::take(&mut self.are_kept) {
            true => self.textures.take(),
            false => None,
        };
        self.textures = None;
        let count = scene.volumes.len() as u32;
        if count == 0 {
            return Ok([("VOLUMES", 0), ("POINTS", 0)]);
        }
        expect_room_for(context, count)?;
        let most = scene.volumes.iter().map(|v| v.transfer.points().len());
        // One more than any has, to end at.
        let points = (most.max().unwrap_or(0) + 1).next_power_of_two() as u32;
        self.textures = Some(match kept {
            Some(textures) => textures,
            None => VolumeTextures::upload(context, &scene.volumes)?,
        });
        let transfer: Vec<f32> = scene
            .volumes
            .iter()
            .flat_map(|volume| padded(volume.transfer.points(), points as usize))
            .collect();
        let mut give = |storage, numbers: &[f32], texels| {
            let bytes = bytemuck::cast_slice(numbers);
            storages.allocate(context, storage, bytes.len() as u64, texels)?;
            storages.write(context.glow(), storage, bytes)
        };
        give(TRANSFER_FUNCTIONS, &transfer, Some(Texels::Rgba32F))?;
        give(PLACES, &places(scene, size, spacing), None)?;
        Ok([("VOLUMES", count), ("POINTS", points)])
    }

    /// Binds what was uploaded, if anything. The context is current.
    ///
    /// # Errors
    /// None but what the driver has lost.
    pub(super) fn bind(&self, gl: &glow::Context, storages: &Storages) -> Result<()> {
        let Some(volumes) = &self.textures else {
            return Ok(());
        };
        for (unit, texture) in (FIRST_VOLUME..).zip(&volumes.textures) {
            // SAFETY: the context is current, the texture is alive, and there are so many units.
            unsafe {
                gl.active_texture(glow::TEXTURE0 + unit);
                gl.bind_texture(glow::TEXTURE_3D, Some(*texture));
                gl.active_texture(glow::TEXTURE0);
            }
        }
        storages.bind_texels(gl, TRANSFER, TRANSFER_FUNCTIONS)?;
        storages.bind_uniforms(gl, PLACES_BLOCK, PLACES)
    }

    pub(super) fn bytes(&self) -> u64 {
        self.textures.as_ref().map_or(0, |volumes| volumes.bytes)
    }

    /// Lets go of them.
    pub(super) fn free(&mut self) {
        self.textures = None;
        self.are_kept = false;
    }

    /// Keeps their samples for the next scene that is uploaded, which has the same volumes.
    pub(super) fn keep(&mut self) {
        self.are_kept = true;
    }
}

fn expect_room_for(context: &Context, count: u32) -> Result<()> {
    let remedy = "leave some volumes out, or render with the method exact, which takes any number";
    if count > MOST_VOLUMES {
        return Err(Error::scene(
            format!(
                "the scene has {count} volumes, and a fragment's id has bits for {MOST_VOLUMES}"
            ),
            remedy,
        ));
    }
    let units = context.driver().limit("GL_MAX_TEXTURE_IMAGE_UNITS");
    let room = u32::try_from(units)
        .unwrap_or(0)
        .saturating_sub(FIRST_VOLUME);
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

impl<'c> VolumeTextures<'c> {
    fn upload(context: &'c Context, volumes: &[Volume]) -> Result<Self> {
        let mut textures = Self {
            context,
            textures: Vec::new(),
            bytes: 0,
        };
        volumes.iter().try_for_each(|volume| textures.add(volume))?;
        Ok(textures)
    }

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
        self.context.count_upload();
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

/// The samples as the texture has them.
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
    let Axes { right, up, forward } = camera.axes();
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
