//! Maps by name: textures of the image's size, and some of fewer rows.

use std::collections::HashMap;

use glow::HasContext;

use super::context::Context;
use super::texture::Texture;
use crate::error::{Error, Result};
use crate::steps::{Format, Map};

#[derive(Debug)]
pub(super) struct Maps {
    /// Width and height of the image.
    pub(super) size: [u32; 2],
    textures: HashMap<Map, Texture>,
}

impl Maps {
    pub(super) fn new(size: [u32; 2]) -> Self {
        let textures = HashMap::new();
        Self { size, textures }
    }

    pub(super) fn get(&self, map: Map) -> Result<Texture> {
        self.textures.get(&map).copied().ok_or_else(|| {
            let allocated = self.textures.keys().map(Map::to_string);
            Error::unknown_map(map.to_string(), allocated)
        })
    }

    /// Makes a map, unless it is there in this format.
    pub(super) fn allocate(&mut self, context: &Context, map: Map, format: Format) -> Result<()> {
        self.allocate_rows(context, map, format, self.size[1])
    }

    /// Makes a map of so many rows, unless it is there in this format and has as many.
    pub(super) fn allocate_rows(
        &mut self,
        context: &Context,
        map: Map,
        format: Format,
        rows: u32,
    ) -> Result<()> {
        match self.textures.get(&map) {
            Some(texture) if texture.format == format && texture.size[1] >= rows => Ok(()),
            _ => {
                context.begin_making()?;
                self.free(context.glow(), map);
                let size = [self.size[0], rows];
                let texture = Texture::new(context.glow(), &map, format, size)?;
                self.textures.insert(map, texture);
                Ok(())
            }
        }
    }

    pub(super) fn free(&mut self, gl: &glow::Context, map: Map) {
        if let Some(texture) = self.textures.remove(&map) {
            // SAFETY: the texture is the machine's own and is no longer in its table.
            unsafe { gl.delete_texture(texture.raw) };
        }
    }

    /// Copies a whole image, every aspect, into a map that is made if it is not there.
    pub(super) fn copy(&mut self, context: &Context, from: Map, to: Map) -> Result<()> {
        let source = self.get(from)?;
        self.allocate(context, to, source.format)?;
        let destination = self.get(to)?;
        let [width, height] = self.size.map(|side| side as i32);
        let two_d = glow::TEXTURE_2D;
        // SAFETY: both textures are the machine's, of one size and one format.
        unsafe {
            context.glow().copy_image_sub_data(
                source.raw,
                two_d,
                0,
                0,
                0,
                0,
                destination.raw,
                two_d,
                0,
                0,
                0,
                0,
                width,
                height,
                1,
            );
        }
        Ok(())
    }

    /// Exchanges two maps' names.
    pub(super) fn swap(&mut self, a: Map, b: Map) -> Result<()> {
        let (of_a, of_b) = (self.get(a)?, self.get(b)?);
        self.textures.insert(a, of_b);
        self.textures.insert(b, of_a);
        Ok(())
    }

    pub(super) fn bytes(&self) -> u64 {
        self.textures.values().map(Texture::bytes).sum()
    }

    pub(super) fn names(&self) -> impl Iterator<Item = &Map> {
        self.textures.keys()
    }

    pub(super) fn delete(&mut self, gl: &glow::Context) {
        for (_, texture) in self.textures.drain() {
            // SAFETY: the texture is the machine's own and leaves its table here.
            unsafe { gl.delete_texture(texture.raw) };
        }
    }
}
