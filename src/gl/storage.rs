//! Shader storage buffers by name, and the uniform block that tells shaders which band of the image is rendered.

use glow::HasContext;

use super::context::Context;
use super::machine::GlMachine;
use super::making::{Making, allocate, no_room};
use crate::error::{Error, Result};
use crate::steps::Storage;

/// The format in which shaders read a buffer as texels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Texels {
    /// One 32-bit number each.
    R32Ui,
    /// Four 32-bit numbers each.
    Rgba32Ui,
    /// Four 32-bit floats each.
    Rgba32F,
}

/// A buffer and, for shaders that only read it, a buffer texture: on llvmpipe a texel is fetched several times as fast
/// as four words of a storage buffer.
#[derive(Clone, Copy, Debug)]
pub(super) struct StorageBuffer {
    pub(super) raw: glow::Buffer,
    texture: Option<(Texels, glow::Texture)>,
    bytes: u64,
}

impl StorageBuffer {
    pub(super) fn bytes(&self) -> u64 {
        self.bytes
    }

    pub(super) fn delete(&self, gl: &glow::Context) {
        // SAFETY: the caller owns both and takes them out of its tables.
        unsafe {
            if let Some((_, texture)) = self.texture {
                gl.delete_texture(texture);
            }
            gl.delete_buffer(self.raw);
        }
    }
}

/// The most bytes a buffer may have, for a shader that writes it and reads it as texels.
pub fn largest_storage(context: &Context, texels: Texels) -> u64 {
    let driver = context.driver();
    let limit = |name| u64::try_from(driver.limit(name)).unwrap_or(0);
    let texel = match texels {
        Texels::R32Ui => 4,
        Texels::Rgba32Ui | Texels::Rgba32F => 16,
    };
    // glow addresses the inside of a buffer with 31 bits.
    (i32::MAX as u64)
        .min(limit("GL_MAX_SHADER_STORAGE_BLOCK_SIZE"))
        .min(limit("GL_MAX_TEXTURE_BUFFER_SIZE") * texel)
}

impl GlMachine<'_> {
    /// Makes a buffer of at least so many bytes, unless it exists. Its contents are undefined. Buffers do not shrink:
    /// the bands of an image share one that is large enough for the largest band.
    ///
    /// # Errors
    /// If the driver has no room.
    pub fn allocate_storage(
        &mut self,
        storage: Storage,
        bytes: u64,
        texels: Option<Texels>,
    ) -> Result<()> {
        // A buffer without a byte cannot be bound.
        let bytes = bytes.max(16);
        let is_enough = |there: &StorageBuffer| {
            let read_as = there.texture.map(|(texels, _)| texels);
            there.bytes >= bytes && (texels.is_none() || texels == read_as)
        };
        if self.storages.get(&storage).is_some_and(is_enough) {
            return Ok(());
        }
        self.context.begin_making()?;
        self.free_storage(storage);
        let what = format!("the {}", storage.0);
        let size = i32::try_from(bytes)
            .map_err(|_| no_room(&what, bytes, "glow addresses a buffer with 31 bits"))?;
        let gl = self.context.glow();
        let mut making = Making::new(gl);
        let raw = making.buffer()?;
        // SAFETY: the context is current; the buffer gets its storage before anything uses it.
        unsafe {
            gl.bind_buffer(glow::SHADER_STORAGE_BUFFER, Some(raw));
            allocate(gl, &what, bytes, || {
                gl.buffer_data_size(glow::SHADER_STORAGE_BUFFER, size, glow::DYNAMIC_COPY);
            })?;
        }
        let texture = texels
            .map(|texels| -> Result<_> {
                let format = match texels {
                    Texels::R32Ui => glow::R32UI,
                    Texels::Rgba32Ui => glow::RGBA32UI,
                    Texels::Rgba32F => glow::RGBA32F,
                };
                let texture = making.texture()?;
                // SAFETY: the context is current, and the buffer has its storage.
                unsafe {
                    gl.active_texture(glow::TEXTURE15);
                    gl.bind_texture(glow::TEXTURE_BUFFER, Some(texture));
                    gl.tex_buffer(glow::TEXTURE_BUFFER, format, Some(raw));
                    gl.bind_texture(glow::TEXTURE_BUFFER, None);
                    gl.active_texture(glow::TEXTURE0);
                }
                Ok((texels, texture))
            })
            .transpose()?;
        making.finish();
        let made = StorageBuffer {
            raw,
            texture,
            bytes,
        };
        self.storages.insert(storage, made);
        Ok(())
    }

    /// Deletes a buffer.
    pub fn free_storage(&mut self, storage: Storage) {
        if let Some(storage) = self.storages.remove(&storage) {
            storage.delete(self.context.glow());
        }
    }

    /// Binds a buffer's texels to a texture unit.
    ///
    /// # Errors
    /// If there is no such buffer, or it has no texels.
    pub fn bind_texels(&self, unit: u32, storage: Storage) -> Result<()> {
        let (_, texture) = self.storage(storage)?.texture.ok_or_else(|| {
            Error::usage(
                format!("the buffer '{}' has no texels", storage.0),
                "allocate it with texels",
            )
        })?;
        let gl = self.context.glow();
        // SAFETY: the context is current, and the texture is the machine's own.
        unsafe {
            gl.active_texture(glow::TEXTURE0 + unit);
            gl.bind_texture(glow::TEXTURE_BUFFER, Some(texture));
            gl.active_texture(glow::TEXTURE0);
        }
        Ok(())
    }

    /// Sets every 32-bit word of a buffer to 0.
    ///
    /// # Errors
    /// If there is no such buffer.
    pub fn clear_storage(&self, storage: Storage) -> Result<()> {
        let storage = self.storage(storage)?;
        let gl = self.context.glow();
        // SAFETY: the buffer is the machine's own; R32UI and one word of zeros are a valid pair.
        unsafe {
            gl.bind_buffer(glow::SHADER_STORAGE_BUFFER, Some(storage.raw));
            gl.buffer_sub_data_u8_slice(
                glow::SHADER_STORAGE_BUFFER,
                0,
                &vec![0; storage.bytes as usize],
            );
        }
        Ok(())
    }

    /// A buffer's words.
    ///
    /// # Errors
    /// If there is no such buffer.
    pub fn read_storage(&self, storage: Storage) -> Result<Vec<u32>> {
        let storage = self.storage(storage)?;
        let mut words = vec![0_u32; storage.bytes as usize / 4];
        let gl = self.context.glow();
        // SAFETY: shaders' writes are waited for, and the slice is not longer than the buffer.
        unsafe {
            gl.memory_barrier(glow::BUFFER_UPDATE_BARRIER_BIT);
            gl.bind_buffer(glow::SHADER_STORAGE_BUFFER, Some(storage.raw));
            gl.get_buffer_sub_data(
                glow::SHADER_STORAGE_BUFFER,
                0,
                bytemuck::cast_slice_mut(&mut words),
            );
        }
        Ok(words)
    }

    /// Fills a buffer's beginning with `words`.
    ///
    /// # Errors
    /// If there is no such buffer, or it is shorter.
    pub fn write_storage(&self, storage: Storage, words: &[u32]) -> Result<()> {
        let there = self.storage(storage)?;
        if there.bytes < words.len() as u64 * 4 {
            return Err(Error::usage(
                format!(
                    "{} words do not fit into the buffer '{}'",
                    words.len(),
                    storage.0
                ),
                "allocate it larger",
            ));
        }
        let gl = self.context.glow();
        // SAFETY: the buffer is the machine's own and long enough.
        unsafe {
            gl.bind_buffer(glow::SHADER_STORAGE_BUFFER, Some(there.raw));
            gl.buffer_sub_data_u8_slice(
                glow::SHADER_STORAGE_BUFFER,
                0,
                bytemuck::cast_slice(words),
            );
        }
        Ok(())
    }

    /// Sets the five numbers of the shaders' uniform block 0.
    ///
    /// # Errors
    /// If the driver has no room.
    pub fn set_parameters(&mut self, parameters: [u32; 5]) -> Result<()> {
        const PARAMETERS: Storage = Storage("parameters");
        // A block is as long as whole groups of four.
        self.allocate_storage(PARAMETERS, 32, None)?;
        self.write_storage(PARAMETERS, &parameters)?;
        self.bind_uniforms(0, PARAMETERS)
    }

    /// Binds a buffer as a uniform block.
    ///
    /// # Errors
    /// If there is no such buffer.
    pub(super) fn bind_uniforms(&self, index: u32, storage: Storage) -> Result<()> {
        let raw = self.storage(storage)?.raw;
        // SAFETY: the context is current, and the buffer is the machine's own.
        unsafe {
            self.context
                .glow()
                .bind_buffer_base(glow::UNIFORM_BUFFER, index, Some(raw));
        }
        Ok(())
    }

    pub(super) fn storage(&self, storage: Storage) -> Result<StorageBuffer> {
        self.storages.get(&storage).copied().ok_or_else(|| {
            Error::usage(
                format!(
                    "the listing names the buffer '{}', which does not exist",
                    storage.0
                ),
                "allocate it first",
            )
        })
    }
}
