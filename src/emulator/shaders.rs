//! The twins of `glsl/`: one file for each fragment shader of a listing, of the same name, whose `main` reads like the
//! shader's. What shaders include is in `common`, likewise. The compute shaders of the prefix scan have twins, too, for all
//! pixels at a time.

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

pub(super) use a_buffer::scan_gather::main as scan_gather;
pub(super) use a_buffer::scan_reduce::main as scan_reduce;
pub(super) use a_buffer::scan_spread::main as scan_spread;

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
    verified / pieces,
    verified / mark,
    verified / behind,
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
    "verified/behind",
    "verified/mark",
];

/// The `#define`s without which a shader is not compiled.
const DEFINES: &[(&str, &[&str])] = &[
    ("weighted/accumulate", &["EQUATION"]),
    ("multi_layer/begin", &["NODES"]),
    ("multi_layer/insert", &["NODES", "IMAGES"]),
    ("multi_layer/composite", &["NODES"]),
    ("a_buffer/fill", LISTS),
    ("a_buffer/fill_ordered", LISTS),
    ("a_buffer/resolve", LISTS),
    ("a_buffer/resolve_segment", LISTS),
    ("a_buffer/resolve_segment_or_rest", LISTS),
];

const LISTS: &[&str] = &["MANAGER", "FFB", "PPLL", "FLOAT_COLOR", "LAST_SEGMENT"];

/// A program.
pub(super) struct Program {
    pub(super) shader: &'static str,
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
    /// If the machine has not been told a `#define` that the shader needs, or the rays that it casts.
    pub(super) fn expect_told(&self, settings: &Settings) -> Result<()> {
        let needed = DEFINES.iter().filter(|(shader, _)| *shader == self.shader);
        let mut needed = needed.flat_map(|(_, names)| *names);
        let missing = needed.find(|name| !settings.defines.contains_key(**name));
        if let Some(name) = missing {
            return Err(Error::out_of_order(
                format!("the shader {} needs the define {name}", self.shader),
                "give the machine the method's defines first: set_defines",
            ));
        }
        let casts_rays = settings
            .defines
            .get("VOLUMES")
            .is_some_and(|&count| count > 0);
        if casts_rays && settings.rays.is_empty() {
            return Err(Error::out_of_order(
                format!("the shader {} is to cast rays through volumes", self.shader),
                "give the machine the volumes and the rays first: set_volumes",
            ));
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;
    use std::fs;
    use std::path::Path;

    use super::*;

    /// What looks at OpenGL itself, what the emulated pixel leaves out, and the parts of programs that say what a surface's colour is.
    const WITHOUT_TWINS: &[&str] = &["capture", "trap", "classic/", "invariance/", "surface/"];

    fn root() -> &'static Path {
        Path::new(env!("CARGO_MANIFEST_DIR"))
    }

    /// The fragment shaders in `glsl/`, by name.
    fn shaders() -> BTreeSet<String> {
        let folder = root().join("glsl");
        let mut folders = vec![folder.clone()];
        let mut found = BTreeSet::new();
        while let Some(next) = folders.pop() {
            for entry in fs::read_dir(next).unwrap() {
                let path = entry.unwrap().path();
                if path.is_dir() {
                    folders.push(path);
                } else if path
                    .extension()
                    .is_some_and(|extension| extension == "frag")
                {
                    let path = path.with_extension("");
                    let name = path.strip_prefix(&folder).unwrap().to_str().unwrap();
                    found.insert(name.replace('\\', "/"));
                }
            }
        }
        found
    }

    /// A file of `glsl/` with all that it includes.
    fn whole(file: &str) -> String {
        let text = fs::read_to_string(root().join("glsl").join(file)).unwrap_or_default();
        let includes = text
            .lines()
            .filter_map(|line| line.strip_prefix("#include \""));
        let included = includes.map(|rest| whole(rest.trim_end_matches('"')));
        let included: String = included.collect();
        text + &included
    }

    #[test]
    fn every_shader_of_a_method_has_a_twin_in_a_file_of_its_name() {
        let mut shaders = shaders();
        let is_left_out = |name: &String| WITHOUT_TWINS.iter().any(|out| name.starts_with(out));
        shaders.retain(|name| name == "surface" || !is_left_out(name));
        let twins: BTreeSet<_> = TWINS.iter().map(|(name, _)| (*name).to_owned()).collect();
        assert_eq!(twins, shaders);
        for name in twins {
            let file = root()
                .join("src/emulator/shaders")
                .join(format!("{name}.rs"));
            assert!(file.exists(), "{name}");
        }
    }

    #[test]
    fn twins_come_after_the_tests_where_their_shaders_ask_for_it() {
        for (name, _) in TWINS {
            let asks = whole(&format!("{name}.frag")).contains("layout(early_fragment_tests) in;");
            assert_eq!(TESTED_EARLY.contains(name), asks, "{name}");
        }
    }

    #[test]
    fn a_define_that_is_missing_is_an_error_that_names_it() {
        let program = program(Shader("weighted/accumulate")).unwrap();
        let mut settings = Settings::new();
        let error = program.expect_told(&settings).unwrap_err();
        assert!(error.to_string().contains("EQUATION"), "{error}");
        settings.defines.insert("EQUATION", 7);
        program.expect_told(&settings).unwrap();
    }
}
