//! Shader storage buffers by name.

use std::collections::HashMap;

use glow::HasContext;

use super::context::Context;
use super::making::{Making, allocate, no_room};
use crate::error::{Error, Result};
use crate::steps::Storage;

/// The format in which shaders read a buffer as texels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Texels {
    /// One 32-bit number each.
    R32Ui,
    /// Two 32-bit numbers each.
    Rg32Ui,
    /// Four 32-bit numbers each.
    Rgba32Ui,
    /// Four 32-bit floats each.
    Rgba32F,
}

/// A buffer and, for shaders that only read it, a buffer texture: on llvmpipe a texel is fetched several times as fast
/// as four words of a storage buffer.
#[derive(Clone, Copy, Debug)]
struct StorageBuffer {
    raw: glow::Buffer,
    texture: Option<(Texels, glow::Texture)>,
    bytes: u64,
}

impl StorageBuffer {
    fn delete(&self, gl: &glow::Context) {
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
        Texels::Rg32Ui => 8,
        Texels::Rgba32Ui | Texels::Rgba32F => 16,
    };
    // glow addresses the inside of a buffer with 31 bits.
    (i32::MAX as u64)
        .min(limit("GL_MAX_SHADER_STORAGE_BLOCK_SIZE"))
        .min(limit("GL_MAX_TEXTURE_BUFFER_SIZE") * texel)
}

/// The buffers of a machine.
#[derive(Debug, Default)]
pub(super) struct Storages(HashMap<Storage, StorageBuffer>);

impl Storages {
    /// Makes a buffer of at least so many bytes, unless there is one. Its contents are undefined. Buffers do not shrink: the
    /// bands of an image take turns in one that is as large as the largest band needs.
    ///
    /// # Errors
    /// If the driver has no room.
    pub(super) fn allocate(
        &mut self,
        context: &Context,
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
        if self.0.get(&storage).is_some_and(is_enough) {
            return Ok(());
        }
        context.begin_making()?;
        self.free(context.glow(), storage);
        let what = format!("the {}", storage.0);
        let size = i32::try_from(bytes)
            .map_err(|_| no_room(&what, bytes, "glow addresses a buffer with 31 bits"))?;
        let gl = context.glow();
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
                    Texels::Rg32Ui => glow::RG32UI,
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
        self.0.insert(storage, made);
        Ok(())
    }

    fn free(&mut self, gl: &glow::Context, storage: Storage) {
        if let Some(storage) = self.0.remove(&storage) {
            storage.delete(gl);
        }
    }

    /// Binds a buffer's texels to a texture unit. The context is current, here and below.
    ///
    /// # Errors
    /// If there is no such buffer, or it has no texels.
    pub(super) fn bind_texels(
        &self,
        gl: &glow::Context,
        unit: u32,
        storage: Storage,
    ) -> Result<()> {
        let (_, texture) = self.get(storage)?.texture.ok_or_else(|| {
            Error::out_of_order(
                format!("the buffer '{}' has no texels", storage.0),
                "allocate it with texels",
            )
        })?;
        // SAFETY: the context is current, and the texture is the machine's own.
        unsafe {
            gl.active_texture(glow::TEXTURE0 + unit);
            gl.bind_texture(glow::TEXTURE_BUFFER, Some(texture));
            gl.active_texture(glow::TEXTURE0);
        }
        Ok(())
    }

    /// Binds a buffer as a storage block.
    ///
    /// # Errors
    /// If there is no such buffer.
    pub(super) fn bind(&self, gl: &glow::Context, index: u32, storage: Storage) -> Result<()> {
        self.bind_to(gl, glow::SHADER_STORAGE_BUFFER, index, storage)
    }

    /// Binds a buffer as a uniform block.
    ///
    /// # Errors
    /// If there is no such buffer.
    pub(super) fn bind_uniforms(
        &self,
        gl: &glow::Context,
        index: u32,
        storage: Storage,
    ) -> Result<()> {
        self.bind_to(gl, glow::UNIFORM_BUFFER, index, storage)
    }

    fn bind_to(&self, gl: &glow::Context, kind: u32, index: u32, storage: Storage) -> Result<()> {
        let raw = self.get(storage)?.raw;
        // SAFETY: the context is current, and the buffer is the machine's own.
        unsafe { gl.bind_buffer_base(kind, index, Some(raw)) };
        Ok(())
    }

    /// Sets every byte of a buffer to 0.
    ///
    /// # Errors
    /// If there is no such buffer.
    pub(super) fn clear(&self, gl: &glow::Context, storage: Storage) -> Result<()> {
        let bytes = self.get(storage)?.bytes as usize;
        self.write(gl, storage, &vec![0; bytes])
    }

    /// Fills a buffer's beginning.
    ///
    /// # Errors
    /// If there is no such buffer, or it is shorter.
    pub(super) fn write(&self, gl: &glow::Context, storage: Storage, bytes: &[u8]) -> Result<()> {
        let there = self.get(storage)?;
        if there.bytes < bytes.len() as u64 {
            return Err(Error::out_of_order(
                format!(
                    "{} bytes do not fit into the buffer '{}'",
                    bytes.len(),
                    storage.0
                ),
                "allocate it larger",
            ));
        }
        // SAFETY: the buffer is the machine's own and long enough.
        unsafe {
            gl.bind_buffer(glow::SHADER_STORAGE_BUFFER, Some(there.raw));
            gl.buffer_sub_data_u8_slice(glow::SHADER_STORAGE_BUFFER, 0, bytes);
        }
        Ok(())
    }

    /// A buffer's bytes.
    ///
    /// # Errors
    /// If there is no such buffer.
    pub(super) fn read(&self, gl: &glow::Context, storage: Storage) -> Result<Vec<u8>> {
        let there = self.get(storage)?;
        let mut bytes = vec![0; there.bytes as usize];
        // SAFETY: the buffer is the machine's own and as long as what is read.
        unsafe {
            gl.bind_buffer(glow::SHADER_STORAGE_BUFFER, Some(there.raw));
            gl.memory_barrier(glow::BUFFER_UPDATE_BARRIER_BIT);
            gl.get_buffer_sub_data(glow::SHADER_STORAGE_BUFFER, 0, &mut bytes);
        }
        Ok(bytes)
    }

    fn get(&self, storage: Storage) -> Result<StorageBuffer> {
        self.0.get(&storage).copied().ok_or_else(|| {
            let allocated = self.0.keys().map(|storage| storage.0.into());
            Error::unknown_buffer(storage.0.into(), allocated)
        })
    }

    pub(super) fn bytes(&self) -> u64 {
        self.0.values().map(|buffer| buffer.bytes).sum()
    }

    pub(super) fn delete(&mut self, gl: &glow::Context) {
        self.0.drain().for_each(|(_, buffer)| buffer.delete(gl));
    }
}
