//! Other steps, or another word in a shader, to see whether that is noticed.

use onionskin::Renderer;
use onionskin::low_level::gl::shader_file;
use onionskin::low_level::steps::{Amendment, Step};

/// A file of `glsl/`, a text in it, and the text that replaces it.
pub type Change = [&'static str; 3];

/// The renderer with a changed shader.
///
/// # Panics
/// If the text to be replaced is missing, or occurs more than once.
pub fn with_change<'c>(renderer: Renderer<'c>, [file, from, to]: Change) -> Renderer<'c> {
    let text = shader_file(file).expect("the file exists");
    assert_eq!(text.matches(from).count(), 1, "'{from}' in glsl/{file}");
    let changed = text.replace(from, to);
    renderer.with_shader_file(file, &changed).unwrap()
}

pub const fn changed(printed: &'static [Step], amended: &'static [Step]) -> Amendment {
    Amendment {
        key: "",
        kind: onionskin::low_level::steps::Kind::Correction,
        place: "",
        printed,
        amended,
        why: "to see whether it is noticed",
        test: "",
    }
}
