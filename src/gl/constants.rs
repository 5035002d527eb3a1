//! The names of OpenGL's errors. The constants that listings have know their numbers by themselves.

/// GL's name for an error.
pub(super) fn error_name(error: u32) -> &'static str {
    match error {
        glow::INVALID_ENUM => "GL_INVALID_ENUM",
        glow::INVALID_VALUE => "GL_INVALID_VALUE",
        glow::INVALID_OPERATION => "GL_INVALID_OPERATION",
        glow::INVALID_FRAMEBUFFER_OPERATION => "GL_INVALID_FRAMEBUFFER_OPERATION",
        glow::OUT_OF_MEMORY => "GL_OUT_OF_MEMORY",
        glow::CONTEXT_LOST => "GL_CONTEXT_LOST",
        _ => "an unknown error",
    }
}

#[cfg(test)]
mod tests {
    use crate::steps::{Buffers, NUMBERS};

    /// Glow's numbers come from Khronos's registry, those of the table from the specification.
    macro_rules! of_glow {
        ($($constant:ident)*) => {
            &[$((stringify!($constant), glow::$constant),)*]
        };
    }

    #[test]
    fn the_numbers_of_the_table_are_opengl_s() {
        let of_glow: &[(&str, u32)] = of_glow! {
            NEVER LESS EQUAL LEQUAL GREATER NOTEQUAL GEQUAL ALWAYS
            KEEP ZERO REPLACE INCR INCR_WRAP DECR DECR_WRAP INVERT
            ZERO ONE SRC_ALPHA ONE_MINUS_SRC_ALPHA DST_ALPHA ONE_MINUS_DST_ALPHA
            FUNC_ADD MIN MAX DEPTH_TEST STENCIL_TEST BLEND DEPTH_CLAMP
        };
        assert_eq!(NUMBERS, of_glow);
        let buffers = |color, depth, stencil| {
            Buffers {
                color,
                depth,
                stencil,
            }
            .number()
        };
        assert_eq!(buffers(true, false, false), glow::COLOR_BUFFER_BIT);
        assert_eq!(buffers(false, true, false), glow::DEPTH_BUFFER_BIT);
        assert_eq!(buffers(false, false, true), glow::STENCIL_BUFFER_BIT);
        assert_eq!(buffers(false, false, false), 0);
    }
}
