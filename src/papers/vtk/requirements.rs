//! The page's requirements of OpenGL: "Required OpenGL extensions" and "OpenGL context requirement".

/// "At least 8 alpha bits": a layer is its colour and its opacity.
pub const ALPHA_BITS: u32 = 8;

/// Each required extension, the names under which it may go, and the version of OpenGL that has had it in its core
/// since.
pub const REQUIRED_EXTENSIONS: [(&[&str], (u32, u32)); 10] = [
    (&["GL_ARB_depth_texture"], (1, 4)),
    (&["GL_ARB_shadow"], (1, 4)),
    (&["GL_EXT_shadow_funcs"], (1, 5)),
    (&["GL_ARB_vertex_shader"], (2, 0)),
    (&["GL_ARB_fragment_shader"], (2, 0)),
    (&["GL_ARB_shader_objects"], (2, 0)),
    (&["GL_ARB_occlusion_query"], (1, 5)),
    (&["GL_ARB_multitexture"], (1, 3)),
    (&["GL_ARB_texture_rectangle"], (3, 1)),
    (
        &["GL_SGIS_texture_edge_clamp", "GL_EXT_texture_edge_clamp"],
        (1, 2),
    ),
];

/// The names of the required extensions that a driver of `version` lacks. An extension with several names is listed
/// with all of them.
pub fn missing_extensions(version: (u32, u32), has: impl Fn(&str) -> bool) -> Vec<String> {
    let lacking = REQUIRED_EXTENSIONS
        .iter()
        .filter(|(names, core_since)| version < *core_since && !names.iter().any(|name| has(name)));
    lacking.map(|(names, _)| names.join(" or ")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn v09_what_is_core_is_not_missing() {
        assert!(missing_extensions((4, 3), |_| false).is_empty());
    }

    #[test]
    fn v09_an_old_driver_lacks_what_it_does_not_name() {
        // OpenGL 1.5 with the rectangle extension alone.
        let missing = missing_extensions((1, 5), |name| name == "GL_ARB_texture_rectangle");
        let shaders = ["vertex_shader", "fragment_shader", "shader_objects"];
        assert_eq!(missing, shaders.map(|name| format!("GL_ARB_{name}")));
    }

    #[test]
    fn v09_either_of_two_names_will_do() {
        let with = |wanted: &'static str| missing_extensions((1, 1), move |name| name == wanted);
        let clamp = "GL_SGIS_texture_edge_clamp or GL_EXT_texture_edge_clamp".to_owned();
        assert!(with("GL_ARB_shadow").contains(&clamp));
        assert!(!with("GL_EXT_texture_edge_clamp").contains(&clamp));
        assert!(!with("GL_SGIS_texture_edge_clamp").contains(&clamp));
    }

    #[test]
    fn v09_with_nothing_at_all_every_one_is_listed_in_the_page_s_order() {
        let missing = missing_extensions((1, 0), |_| false);
        assert_eq!(missing.len(), 10);
        assert_eq!(missing[0], "GL_ARB_depth_texture");
    }
}
