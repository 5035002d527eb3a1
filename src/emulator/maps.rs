//! Maps by name, framebuffers that draw into them, and the units that shaders look them up by.

use std::collections::HashMap;

use super::color::{self, Texel};
use super::depth;
use crate::error::{Error, Result};
use crate::steps::{Format, Map, Target};

/// A map's texels, one per pixel.
#[derive(Clone, Debug)]
pub(super) struct Plane {
    pub(super) format: Format,
    /// The texels of a color map.
    pub(super) colors: Vec<[f32; 4]>,
    /// The texels of a map of whole numbers.
    pub(super) integers: Vec<[u32; 4]>,
    /// The depths of a depth map, as its format stores them.
    pub(super) depths: Vec<f32>,
    pub(super) stencils: Vec<u8>,
}

/// The maps into which a framebuffer draws.
#[derive(Clone, Debug, Default)]
pub(super) struct Attached {
    /// By the shaders' locations.
    pub(super) colors: Vec<usize>,
    pub(super) depth: Option<usize>,
}

/// OpenGL promises so many texture units to a shader.
const TEXTURE_UNITS: usize = 16;
/// OpenGL promises so many image units.
const IMAGE_UNITS: usize = 8;

#[derive(Debug)]
pub(super) struct Maps {
    pixels: usize,
    pub(super) planes: Vec<Plane>,
    names: HashMap<Map, usize>,
    targets: HashMap<Target, Attached>,
    textures: [Option<usize>; TEXTURE_UNITS],
    images: [Option<usize>; IMAGE_UNITS],
    active_texture: usize,
    pub(super) target: Option<Target>,
}

impl Plane {
    fn new(format: Format, pixels: usize) -> Self {
        let [mut colors, mut integers, mut depths] = [0; 3];
        *match (format.has_depth(), color::has_integers(format)) {
            (true, _) => &mut depths,
            (false, true) => &mut integers,
            (false, false) => &mut colors,
        } = pixels;
        Self {
            format,
            colors: vec![color::stored(format, [0.0; 4]); colors],
            integers: vec![color::stored_integers(format, [0; 4]); integers],
            depths: vec![0.0; depths],
            stencils: vec![0; depths],
        }
    }

    /// The value that a lookup reads.
    pub(super) fn texel(&self, pixel: usize) -> Texel {
        if self.format.has_depth() {
            let depth = depth::sampled_by_llvmpipe(self.format, self.depths[pixel]);
            return Texel::Color([depth, 0.0, 0.0, 1.0]);
        }
        match color::has_integers(self.format) {
            true => Texel::Integers(self.integers[pixel]),
            false => Texel::Color(self.colors[pixel]),
        }
    }

    /// Stores a texel as it is. A texel of another kind, or of a depth, is left out, as OpenGL leaves open what happens.
    pub(super) fn set(&mut self, pixel: usize, texel: Texel) {
        match texel {
            Texel::Color(color) => replace(&mut self.colors, pixel, color),
            Texel::Integers(integers) => replace(&mut self.integers, pixel, integers),
        }
    }
}

fn replace<T>(all: &mut [T], pixel: usize, new: T) {
    if let Some(texel) = all.get_mut(pixel) {
        *texel = new;
    }
}

impl Maps {
    pub(super) fn new(pixels: usize) -> Self {
        Self {
            pixels,
            planes: Vec::new(),
            names: HashMap::new(),
            targets: HashMap::new(),
            textures: [None; TEXTURE_UNITS],
            images: [None; IMAGE_UNITS],
            active_texture: 0,
            target: None,
        }
    }

    /// Nothing is bound any more. The maps stay.
    pub(super) fn unbind(&mut self) {
        self.textures = [None; TEXTURE_UNITS];
        self.images = [None; IMAGE_UNITS];
        self.active_texture = 0;
        self.target = None;
    }

    pub(super) fn plane(&self, map: Map) -> Result<usize> {
        self.names.get(&map).copied().ok_or_else(|| {
            let allocated = self.names.keys().map(Map::to_string);
            Error::unknown_map(map.to_string(), allocated)
        })
    }

    pub(super) fn get(&self, map: Map) -> Result<&Plane> {
        Ok(&self.planes[self.plane(map)?])
    }

    /// The map that has this plane now.
    pub(super) fn name(&self, plane: usize) -> Option<Map> {
        let mut names = self.names.iter();
        names.find(|(_, of)| **of == plane).map(|(map, _)| *map)
    }

    pub(super) fn allocate(&mut self, map: Map, format: Format) {
        let is_there = |&plane: &usize| self.planes[plane].format == format;
        if !self.names.get(&map).is_some_and(is_there) {
            self.planes.push(Plane::new(format, self.pixels));
            self.names.insert(map, self.planes.len() - 1);
        }
    }

    pub(super) fn copy(&mut self, from: Map, to: Map) -> Result<()> {
        let source = self.get(from)?.clone();
        self.allocate(to, source.format);
        let destination = self.plane(to)?;
        self.planes[destination] = source;
        Ok(())
    }

    pub(super) fn swap(&mut self, a: Map, b: Map) -> Result<()> {
        let (of_a, of_b) = (self.plane(a)?, self.plane(b)?);
        self.names.insert(a, of_b);
        self.names.insert(b, of_a);
        Ok(())
    }

    pub(super) fn attach(
        &mut self,
        target: Target,
        colors: &[Map],
        depth: Option<Map>,
    ) -> Result<()> {
        let colors = colors.iter().map(|&map| self.plane(map));
        let attached = Attached {
            colors: colors.collect::<Result<_>>()?,
            depth: depth.map(|map| self.plane(map)).transpose()?,
        };
        self.targets.insert(target, attached);
        Ok(())
    }

    /// The maps of the current framebuffer.
    pub(super) fn attached(&self) -> Result<Attached> {
        Ok(self
            .targets
            .get(&self.target()?)
            .cloned()
            .unwrap_or_default())
    }

    pub(super) fn attach_color(&mut self, map: Map) -> Result<()> {
        let (plane, target) = (self.plane(map)?, self.target()?);
        let colors = &mut self.targets.entry(target).or_default().colors;
        match colors.first_mut() {
            Some(first) => *first = plane,
            None => colors.push(plane),
        }
        Ok(())
    }

    pub(super) fn attach_depth(&mut self, map: Map) -> Result<()> {
        let (plane, target) = (self.plane(map)?, self.target()?);
        self.targets.entry(target).or_default().depth = Some(plane);
        Ok(())
    }

    fn target(&self) -> Result<Target> {
        self.target.ok_or_else(|| {
            Error::out_of_order(
                "the listing draws or clears before it chooses a framebuffer",
                "glBindFramebuffer comes first",
            )
        })
    }

    /// Makes a texture unit the active one, and says whether it exists.
    pub(super) fn activate(&mut self, unit: u32) -> bool {
        self.active_texture = unit as usize;
        self.active_texture < TEXTURE_UNITS
    }

    pub(super) fn bind_texture(&mut self, map: Map) -> Result<()> {
        self.textures[self.active_texture] = Some(self.plane(map)?);
        Ok(())
    }

    /// Binds an image, and says whether its unit exists.
    pub(super) fn bind_image(&mut self, unit: u32, map: Map) -> Result<bool> {
        let plane = self.plane(map)?;
        let image = self.images.get_mut(unit as usize);
        Ok(image.map(|image| *image = Some(plane)).is_some())
    }

    /// What is looked up at a pixel by a texture unit. An unbound unit reads zeros.
    pub(super) fn texel(&self, unit: u32, pixel: usize) -> Texel {
        self.at(self.textures[unit as usize], pixel)
    }

    /// What an image has at a pixel.
    pub(super) fn image(&self, unit: u32, pixel: usize) -> Texel {
        self.at(self.images[unit as usize], pixel)
    }

    fn at(&self, bound: Option<usize>, pixel: usize) -> Texel {
        bound.map_or(Texel::Color([0.0; 4]), |plane| {
            self.planes[plane].texel(pixel)
        })
    }

    /// The plane that is an image's.
    pub(super) fn image_plane(&self, unit: u32) -> Option<usize> {
        self.images[unit as usize]
    }
}
