//! The driver: its name, its abilities and its known traps.

use std::collections::BTreeSet;

use glow::HasContext;

use super::quirks::Quirks;

/// A driver's description of itself.
#[derive(Clone, Debug)]
pub struct Driver {
    /// `GL_RENDERER`.
    pub renderer: String,
    /// `GL_VERSION`, whole.
    pub version_text: String,
    /// Major and minor.
    pub version: (u32, u32),
    /// Major and minor of the shading language, the minor in hundredths: (4, 30).
    pub shading_language: (u32, u32),
    /// Whether it is OpenGL ES and not OpenGL.
    pub embedded: bool,
    /// Whether it still has the functions that OpenGL 3.1 removed.
    pub has_fixed_functions: bool,
    /// All extensions.
    pub extensions: BTreeSet<String>,
    /// Limits by GL's names.
    pub limits: Vec<(&'static str, i64)>,
}

/// A known error of drivers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "cli", derive(serde::Serialize))]
pub struct Trap {
    /// The effect of the error.
    pub what: &'static str,
    /// How onionskin avoids it.
    pub avoided: &'static str,
}

/// Lost atomics of a fragment shader: see [`crate::gl::GlMachine::traps`].
pub(super) const LOST_ATOMICS: Trap = Trap {
    what: "a fragment shader's buffer writes and atomics are lost when a later opaque triangle covers a whole tile \
           and the framebuffer has no depth attachment (Mesa 22.3 llvmpipe)",
    avoided: "every framebuffer whose fragments write buffers has a depth attachment",
};

/// Extensions that some method or check uses, and their purposes. None of them is needed to render.
pub const WANTED_EXTENSIONS: [(&str, &str); 4] = [
    ("GL_KHR_debug", "steps named in debuggers"),
    (
        "GL_EXT_shader_framebuffer_fetch",
        "ordered fragments without atomics",
    ),
    (
        "GL_ARM_shader_framebuffer_fetch_depth_stencil",
        "the same for depth and stencil",
    ),
    ("GL_ARB_fragment_shader_interlock", "the same with images"),
];

const LIMITS: [(&str, u32); 11] = [
    ("GL_MAX_TEXTURE_BUFFER_SIZE", glow::MAX_TEXTURE_BUFFER_SIZE),
    ("GL_MAX_TEXTURE_SIZE", glow::MAX_TEXTURE_SIZE),
    ("GL_MAX_3D_TEXTURE_SIZE", glow::MAX_3D_TEXTURE_SIZE),
    ("GL_MAX_TEXTURE_IMAGE_UNITS", glow::MAX_TEXTURE_IMAGE_UNITS),
    ("GL_MAX_RENDERBUFFER_SIZE", glow::MAX_RENDERBUFFER_SIZE),
    (
        "GL_MAX_ARRAY_TEXTURE_LAYERS",
        glow::MAX_ARRAY_TEXTURE_LAYERS,
    ),
    ("GL_MAX_DRAW_BUFFERS", glow::MAX_DRAW_BUFFERS),
    (
        "GL_MAX_SHADER_STORAGE_BLOCK_SIZE",
        glow::MAX_SHADER_STORAGE_BLOCK_SIZE,
    ),
    (
        "GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS",
        glow::MAX_FRAGMENT_SHADER_STORAGE_BLOCKS,
    ),
    (
        "GL_MAX_FRAGMENT_IMAGE_UNIFORMS",
        glow::MAX_FRAGMENT_IMAGE_UNIFORMS,
    ),
    (
        "GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS",
        glow::MAX_COMPUTE_WORK_GROUP_INVOCATIONS,
    ),
];

impl Driver {
    /// Asks the current context.
    pub(super) fn read(gl: &glow::Context) -> Self {
        let version = gl.version();
        // SAFETY: the caller's context is current, and the names are strings in every version of GL from 2.0 on.
        let (renderer, version_text, shading_language) = unsafe {
            (
                gl.get_parameter_string(glow::RENDERER),
                gl.get_parameter_string(glow::VERSION),
                gl.get_parameter_string(glow::SHADING_LANGUAGE_VERSION),
            )
        };
        let number = (version.major, version.minor);
        // Before version 4.3 most of the limits do not exist, and the context will be refused anyway.
        let limits = if number < (4, 3) || version.is_embedded {
            Vec::new()
        } else {
            // SAFETY: each is an integer from OpenGL 4.3 on.
            LIMITS
                .iter()
                .map(|&(name, limit)| (name, unsafe { gl.get_parameter_i64(limit) }))
                .collect()
        };
        const COMPATIBILITY: i32 = 2; // GL_CONTEXT_COMPATIBILITY_PROFILE_BIT
        let has_fixed_functions = number >= (3, 2) && !version.is_embedded && {
            // SAFETY: an integer from OpenGL 3.2 on.
            let profile = unsafe { gl.get_parameter_i32(glow::CONTEXT_PROFILE_MASK) };
            profile & COMPATIBILITY != 0
        };
        Self {
            has_fixed_functions,
            renderer,
            version_text,
            version: number,
            shading_language: numbers(&shading_language),
            embedded: version.is_embedded,
            extensions: gl.supported_extensions().iter().cloned().collect(),
            limits,
        }
    }

    /// A limit by GL's name, or 0 if it is not one of the known limits.
    pub fn limit(&self, name: &str) -> i64 {
        self.limits
            .iter()
            .find(|(n, _)| *n == name)
            .map_or(0, |(_, value)| *value)
    }

    /// The largest width and height of an image.
    pub fn largest_image(&self) -> u32 {
        u32::try_from(self.limit("GL_MAX_TEXTURE_SIZE")).unwrap_or(0)
    }

    /// What it does otherwise than others, by its name.
    pub fn quirks(&self) -> Quirks {
        Quirks::of(&self.renderer, &self.version_text)
    }

    /// Whether the driver names an extension.
    pub fn has(&self, extension: &str) -> bool {
        self.extensions.contains(extension)
    }
}

/// The two numbers at the beginning of a version's text.
fn numbers(text: &str) -> (u32, u32) {
    let mut numbers = text
        .split(|c: char| !c.is_ascii_digit())
        .map(|number| number.parse().unwrap_or(0));
    let mut next = || numbers.next().unwrap_or(0);
    (next(), next())
}

#[cfg(test)]
mod tests {
    use super::numbers;

    #[test]
    fn a_version_s_text_begins_with_its_numbers() {
        assert_eq!(numbers("4.50"), (4, 50));
        assert_eq!(numbers("4.60 NVIDIA"), (4, 60));
        assert_eq!(numbers("OpenGL ES GLSL ES 3.20"), (0, 0));
        assert_eq!(numbers(""), (0, 0));
    }
}
