//! What VTK's page requires of OpenGL, and what a driver lacks of it.

use onionskin::low_level::papers::vtk::missing_extensions;

#[test]
pub(crate) fn v09_what_is_core_is_not_missing() {
    assert!(missing_extensions((4, 3), |_| false).is_empty());
}

#[test]
pub(crate) fn v09_an_old_driver_lacks_what_it_does_not_name() {
    // OpenGL 1.5 with the rectangle extension alone.
    let missing = missing_extensions((1, 5), |name| name == "GL_ARB_texture_rectangle");
    let shaders = ["vertex_shader", "fragment_shader", "shader_objects"];
    assert_eq!(missing, shaders.map(|name| format!("GL_ARB_{name}")));
}

#[test]
pub(crate) fn v09_either_of_two_names_will_do() {
    let with = |wanted: &'static str| missing_extensions((1, 1), move |name| name == wanted);
    let clamp = "GL_SGIS_texture_edge_clamp or GL_EXT_texture_edge_clamp".to_owned();
    assert!(with("GL_ARB_shadow").contains(&clamp));
    assert!(!with("GL_EXT_texture_edge_clamp").contains(&clamp));
    assert!(!with("GL_SGIS_texture_edge_clamp").contains(&clamp));
}

#[test]
pub(crate) fn v09_with_nothing_at_all_every_one_is_listed_in_the_page_s_order() {
    let missing = missing_extensions((1, 0), |_| false);
    assert_eq!(missing.len(), 10);
    assert_eq!(missing[0], "GL_ARB_depth_texture");
}
