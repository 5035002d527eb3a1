//! The twins of `glsl/`: one file for each fragment shader of a listing, of the same name, whose `main` reads like the
//! shader's. What shaders include is in `common`, likewise.

mod a_buffer;
mod alive;
mod clip;
mod common;
mod complexity;
mod coplanar;
mod dual;
mod ideal;
mod layer;
mod multi_layer;
mod over;
mod peel;
mod surface;
mod under;
mod verified;
mod weighted;

use super::invocation::Twin;
use super::settings::Settings;
use crate::error::{Error, Result};
use crate::steps::Shader;

/// A table of twins by the names of their shaders' files.
macro_rules! twins {
    ($($($part:ident)/+,)*) => {
        [$((twins!(@ $($part)/+), $($part)::+::main as Twin),)*]
    };
    (@ $first:ident $(/ $rest:ident)*) => {
        concat!(stringify!($first) $(, "/", stringify!($rest))*)
    };
}

const TWINS: &[(&str, Twin)] = &twins! {
    surface,
    peel,
    coplanar,
    layer,
    over,
    under,
    alive / first,
    alive / later,
    clip / open_open,
    clip / open_closed,
    clip / closed_open,
    clip / closed_closed,
    clip / at_bound,
    clip / at_bound_as_printed,
    clip / between_peels_as_printed,
    clip / previous_depth,
    clip / previous_depth_from_near,
    clip / next_bound,
    complexity,
    dual / depths,
    dual / peel,
    dual / left,
    dual / rest,
    ideal / begin,
    ideal / begin_as_printed,
    ideal / begin_tight,
    ideal / pass_1,
    ideal / pass_1_as_printed,
    ideal / pass_2,
    ideal / pass_2_tight,
    ideal / changed,
    weighted / accumulate,
    weighted / composite,
    multi_layer / begin,
    multi_layer / insert,
    multi_layer / composite,
    multi_layer / taken,
    verified / surface,
    verified / mark,
    verified / count,
    verified / place,
    a_buffer / count,
    a_buffer / begin,
    a_buffer / fill,
    a_buffer / fill_ordered,
    a_buffer / resolve,
    a_buffer / resolve_segment,
    a_buffer / resolve_segment_or_rest,
};

/// The shaders whose tests come first (`early_fragment_tests`), because they write buffers or images.
const TESTED_EARLY: &[&str] = &[
    "a_buffer/count",
    "a_buffer/fill",
    "a_buffer/fill_ordered",
    "multi_layer/insert",
    "verified/count",
    "verified/mark",
];

/// The `#define`s without which a shader is not compiled.
const DEFINES: &[(&str, &[&str])] = &[
    ("weighted/accumulate", &["EQUATION"]),
    ("multi_layer/begin", &["NODES"]),
    ("multi_layer/insert", &["NODES", "IMAGES"]),
    ("multi_layer/composite", &["NODES"]),
    ("verified/mark", &["OPAQUE"]),
    ("a_buffer/fill", LISTS),
    ("a_buffer/fill_ordered", LISTS),
    ("a_buffer/resolve", LISTS),
    ("a_buffer/resolve_segment", LISTS),
    ("a_buffer/resolve_segment_or_rest", LISTS),
];

const LISTS: &[&str] = &["MANAGER", "FFB", "PPLL", "FLOAT_COLOR", "LAST_SEGMENT"];

/// A program.
pub(super) struct Program {
    shader: &'static str,
    pub(super) twin: Twin,
    pub(super) tests_early: bool,
}

/// The program of a shader.
///
/// # Errors
/// If the shader has no twin.
pub(super) fn program(Shader(shader): Shader) -> Result<Program> {
    let found = TWINS.iter().find(|(file, _)| *file == shader);
    let (_, twin) = found.ok_or_else(|| Error::NoTwin {
        shader: shader.into(),
        known: TWINS.iter().map(|(file, _)| *file).collect(),
    })?;
    Ok(Program {
        shader,
        twin: *twin,
        tests_early: TESTED_EARLY.contains(&shader),
    })
}

impl Program {
    /// # Errors
    /// If it has not been told a `#define` that it needs.
    pub(super) fn expect_defines(&self, settings: &Settings) -> Result<()> {
        let needed = DEFINES.iter().filter(|(shader, _)| *shader == self.shader);
        let mut needed = needed.flat_map(|(_, names)| *names);
        let missing = needed.find(|name| !settings.defines.contains_key(**name));
        missing.map_or(Ok(()), |name| {
            Err(Error::out_of_order(
                format!("the shader {} needs the define {name}", self.shader),
                "give the machine the method's defines first: set_defines",
            ))
        })
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    #[test]
    fn every_twin_and_every_file_beside_it_has_a_shader_of_its_name() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        for (name, _) in TWINS {
            assert!(root.join("glsl").join(format!("{name}.frag")).exists());
            let twin = root.join("src/emulator/shaders").join(format!("{name}.rs"));
            assert!(twin.exists(), "{name}");
        }
    }
}
