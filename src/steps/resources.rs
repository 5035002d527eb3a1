//! The resources that must exist before a listing runs: maps, framebuffers and buffers by name, and variables.

use super::format::Format;
use super::names::{Map, Shader, Storage, Target};

/// Everything that a listing takes for granted.
#[derive(Clone, Copy, Debug)]
pub struct Resources {
    /// The maps, each of the image's size, and their contents.
    pub maps: &'static [(Map, Holds)],
    /// Maps that it makes by copying into them: one alone, or a row of them under any variable.
    pub made: &'static [Map],
    /// The framebuffers.
    pub framebuffers: &'static [Framebuffer],
    /// Its shader storage buffers. How large they are depends on the scene.
    pub storages: &'static [Storage],
    /// Variables that have a value before it begins.
    pub variables: &'static [&'static str],
    /// The shaders that it draws with, or `None` for whatever the machine has.
    pub shaders: Option<&'static [Shader]>,
    /// The keys of the texts that take all this for granted, or none for every text of a paper.
    pub texts: &'static [&'static str],
}

/// The contents of a map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Holds {
    /// Colours, in the format that the image has.
    Colors,
    /// Depths, in the format that depth buffers have.
    Depths,
    /// Texels of just this format.
    Exactly(Format),
}

/// A framebuffer, and the maps that it draws into to begin with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Framebuffer {
    /// Its name.
    pub target: Target,
    /// Its colors, the first for the shaders' location 0.
    pub colors: &'static [Map],
    /// Its depth buffer.
    pub depth: Option<Map>,
}

impl Resources {
    /// Nothing at all.
    pub const NONE: Self = Self {
        maps: &[],
        made: &[],
        framebuffers: &[],
        storages: &[],
        variables: &[],
        shaders: None,
        texts: &[],
    };

    /// The same for these texts of a paper, which draw with these shaders.
    pub const fn of(self, texts: &'static [&'static str], shaders: &'static [Shader]) -> Self {
        Self {
            texts,
            shaders: Some(shaders),
            ..self
        }
    }
}

impl Framebuffer {
    /// A framebuffer that draws into these maps.
    pub const fn new(target: Target, colors: &'static [Map], depth: Option<Map>) -> Self {
        Self {
            target,
            colors,
            depth,
        }
    }
}

impl Holds {
    /// The format of a map that holds this, where the image has the format `color` and depth buffers the format `depth`.
    pub const fn format(self, color: Format, depth: Format) -> Format {
        match self {
            Self::Colors => color,
            Self::Depths => depth,
            Self::Exactly(format) => format,
        }
    }
}
