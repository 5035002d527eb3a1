//! Environment variables that change which OpenGL is found, so that an error can name those that may be the cause.

use crate::error::Attempt;

/// The effect of each variable on Mesa, or on the library that looks for Mesa.
const VARIABLES: [(&str, &str); 13] = [
    ("GALLIUM_DRIVER", "chooses Mesa's driver"),
    ("MESA_LOADER_DRIVER_OVERRIDE", "chooses Mesa's driver"),
    (VERSION, "has Mesa offer another OpenGL than the driver has"),
    (
        SHADING_LANGUAGE,
        "has Mesa offer another shading language than the driver has",
    ),
    ("MESA_EXTENSION_OVERRIDE", "adds and takes away extensions"),
    (
        "LIBGL_DRIVERS_PATH",
        "says where Mesa looks for its drivers",
    ),
    ("LIBGL_DRIVERS_DIR", "says where Mesa looks for its drivers"),
    (
        "LIBGL_ALWAYS_SOFTWARE",
        "chooses between software and hardware",
    ),
    ("EGL_PLATFORM", "chooses EGL's platform"),
    ("__EGL_VENDOR_LIBRARY_FILENAMES", "says which EGL there is"),
    ("__EGL_VENDOR_LIBRARY_DIRS", "says where to look for an EGL"),
    ("DRI_PRIME", "chooses the GPU"),
    (DRAWING, "takes away what Mesa draws vertices with"),
];

/// Makes Mesa offer another version.
pub(super) const VERSION: &str = "MESA_GL_VERSION_OVERRIDE";
/// The same for the shading language.
pub(super) const SHADING_LANGUAGE: &str = "MESA_GLSL_VERSION_OVERRIDE";

/// The drivers of Mesa's OSMesa. With the name of any other driver it follows a null pointer.
const OF_OSMESA: [&str; 2] = ["llvmpipe", "softpipe"];

/// The least version with OpenGL 3.1's shading language. Without it OSMesa makes no context of a core profile.
const OF_OPENGL_3_1: u32 = 140;
/// The variable that says whether Mesa compiles its vertex processing, and its values for 'no'.
const DRAWING: &str = "DRAW_USE_LLVM";
const OFF: [&str; 5] = ["0", "n", "no", "f", "false"];

/// The variables that are set, as `NAME=value`, with their effects.
fn set() -> impl Iterator<Item = (String, &'static str)> {
    VARIABLES
        .iter()
        .filter_map(|(name, effect)| Some((assignment(name)?, *effect)))
}

/// `NAME=value`, if it is set to something.
pub(super) fn assignment(name: &str) -> Option<String> {
    let value = std::env::var_os(name).filter(|value| !value.is_empty())?;
    Some(format!("{name}={}", value.to_string_lossy().escape_debug()))
}

/// The environment variables that are set and change which OpenGL is found, each with its effect and the remedy.
pub fn suspect_variables() -> Vec<Attempt> {
    set()
        .map(|(assignment, effect)| {
            let name = assignment.split('=').next().unwrap_or_default();
            Attempt {
                answer: format!("it {effect}; unset {name} and try again"),
                what: format!("the environment variable {assignment}"),
            }
        })
        .collect()
}

/// The reason not to ask OSMesa for a context. If it cannot make one, it follows a null pointer.
pub(super) fn crashes_osmesa() -> Option<String> {
    let value = |name| std::env::var(name).unwrap_or_default();
    let driver = value("GALLIUM_DRIVER");
    let shading_language = value(SHADING_LANGUAGE).parse::<u32>();
    let name = if !driver.is_empty() && !OF_OSMESA.contains(&driver.as_str()) {
        "GALLIUM_DRIVER"
    } else if shading_language.is_ok_and(|version| version < OF_OPENGL_3_1) {
        SHADING_LANGUAGE
    } else if OFF.contains(&value(DRAWING).as_str()) {
        DRAWING
    } else {
        return None;
    };
    let assignment = assignment(name)?;
    Some(format!(
        "not tried, because it would crash with the environment variable {assignment}; unset {name}"
    ))
}

/// The text to add to "the driver offers only ...": the variable that hides the driver's version.
pub(super) fn hides(name: &str) -> String {
    assignment(name).map_or_else(String::new, |assignment| {
        format!("; the environment variable {assignment} hides what it has: unset {name}")
    })
}

#[cfg(test)]
mod tests {
    use super::VARIABLES;

    #[test]
    fn each_variable_is_named_once() {
        for (number, (name, _)) in VARIABLES.iter().enumerate() {
            assert!(VARIABLES[..number].iter().all(|(other, _)| other != name));
        }
    }
}
