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
