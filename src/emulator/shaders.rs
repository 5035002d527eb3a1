//! The twins of `glsl/`: one file for each fragment shader of a listing, of the same name, whose `main` reads like the
//! shader's. What shaders include is in `common`, likewise.

mod alive;
mod clip;
mod common;
mod coplanar;
mod layer;
mod over;
mod peel;
mod surface;
mod under;
mod verified;

use super::invocation::Twin;
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
    verified / surface,
};

/// The twin of a shader.
///
/// # Errors
/// If it has none.
pub(super) fn twin(Shader(name): Shader) -> Result<Twin> {
    let found = TWINS.iter().find(|(file, _)| *file == name);
    found.map(|(_, twin)| *twin).ok_or_else(|| Error::NoTwin {
        shader: name.into(),
        known: TWINS.iter().map(|(file, _)| *file).collect(),
    })
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
