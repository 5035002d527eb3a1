//! What VTK's page asks of OpenGL (V07, V09), and where its documents and its behaviour differ.

use onionskin::generate::{Soup, soup};
use onionskin::low_level::papers::vtk::{REQUIRED_EXTENSIONS, missing_extensions};
use onionskin::options::{
    CoplanarDepthPeelingOptions, DepthPeelingOptions, DualDepthPeelingOptions,
};
use onionskin::{Context, Format, Method, Renderer, Scene};

#[test]
pub(crate) fn v07_fewer_than_8_alpha_bits_are_refused_with_what_to_choose() {
    let context = Context::headless().unwrap();
    for method in peeling() {
        let error = render(&context, &method, Format::Rgb10A2).unwrap_err();
        let text = error.to_string();
        for part in ["at least 8 alpha bits", "rgb10a2 has 2", "rgba8"] {
            assert!(text.contains(part), "{method}: {text}");
        }
    }
}

#[test]
pub(crate) fn v07_8_alpha_bits_will_do_and_methods_without_layers_need_none() {
    let context = Context::headless().unwrap();
    for method in peeling() {
        render(&context, &method, Format::Rgba8).unwrap();
    }
    render(&context, &Method::Blend, Format::Rgb10A2).unwrap();
}

#[test]
pub(crate) fn v07_the_bits_are_those_that_opengl_counts() {
    let context = Context::headless().unwrap();
    for format in [
        Format::Rgba8,
        Format::Rgb10A2,
        Format::Rgba16F,
        Format::Rgba32F,
    ] {
        assert_eq!(context.alpha_bits(format).unwrap(), format.alpha_bits());
    }
}

#[test]
pub(crate) fn v09_this_driver_lacks_nothing() {
    let context = Context::headless().unwrap();
    let driver = context.driver();
    let missing = missing_extensions(driver.version, |name| driver.has(name));
    assert_eq!(missing, Vec::<String>::new());
    assert_eq!(REQUIRED_EXTENSIONS.len(), 10);
}

#[test]
pub(crate) fn v01_0_peels_is_no_limit_in_every_method_as_vtk_documents_it() {
    // VX01: VTK's own dual pass peels nothing then.
    let context = Context::headless().unwrap();
    for method in peeling() {
        let stats = render(&context, &method, Format::Rgba32F).unwrap().stats;
        assert!(stats.iterations > 3, "{stats}");
        assert_eq!(stats.lost, Some(0), "{stats}");
    }
}

fn peeling() -> [Method; 3] {
    [
        Method::DepthPeeling(DepthPeelingOptions::default()),
        Method::DualDepthPeeling(DualDepthPeelingOptions::default()),
        Method::CoplanarDepthPeeling(CoplanarDepthPeelingOptions::default()),
    ]
}

fn render(
    context: &Context,
    method: &Method,
    color: Format,
) -> onionskin::Result<onionskin::Frame> {
    let mut scene = Scene::of("soup", vec![soup(&Soup::default()).unwrap()]);
    scene.size = [60, 45];
    let renderer = Renderer::new(context, 60, 45).unwrap();
    let mut renderer = renderer.with_formats(color, Format::Depth32FStencil8);
    renderer.render(&scene, method)
}
