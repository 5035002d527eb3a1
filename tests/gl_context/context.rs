//! Contexts, and what a renderer leaves behind.

use onionskin::generate::{Quads, Soup, quads, soup};
use onionskin::low_level::gl::{GlMachine, Profile};
use onionskin::options::{Compositing, DepthPeelingOptions};
use onionskin::{Backend, Context, ContextOptions, Error, Method, Renderer, Scene, registry};

const METHODS: [&str; 4] = ["blend", "depth-peeling", "dfb+ppdp", "exact"];

#[test]
fn a_headless_context_has_opengl_4_3_or_later() {
    let context = Context::headless().unwrap();
    let driver = context.driver();
    println!("{} ({})", driver.renderer, driver.version_text);
    assert!(driver.version >= (4, 3), "{}", driver.version_text);
    assert!(!driver.embedded);
    assert!(!driver.renderer.is_empty());
}

#[test]
fn the_backend_that_is_asked_for_is_the_one_that_comes() {
    let Ok(name) = std::env::var("ONIONSKIN_BACKEND") else {
        println!("skipped: ONIONSKIN_BACKEND names none, so any may come");
        return;
    };
    let context = Context::headless().unwrap();
    assert_eq!(context.backend(), Some(name.parse().unwrap()));
}

#[test]
fn a_backend_asked_for_in_code_comes_before_the_environment_s() {
    for backend in [Backend::Egl, Backend::OsMesa] {
        let options = ContextOptions {
            backend: Some(backend),
            ..Default::default()
        };
        match Context::new(options) {
            Ok(context) => assert_eq!(context.backend(), Some(backend)),
            // Only one of the two may be installed; then the error is about that one.
            Err(Error::NoContext { tried }) => {
                println!("skipped: there is no {backend} here");
                let about = |what: &str| what.starts_with(&backend.to_string());
                assert!(
                    tried.iter().all(|attempt| about(&attempt.what)),
                    "{tried:?}"
                );
            }
            Err(other) => panic!("{other}"),
        }
    }
}

#[test]
fn contexts_of_both_backends_live_on_one_thread() {
    let of = |backend| {
        let backend = Some(backend);
        Context::new(ContextOptions {
            backend,
            ..Default::default()
        })
    };
    let (Ok(egl), Ok(osmesa)) = (of(Backend::Egl), of(Backend::OsMesa)) else {
        println!("skipped: EGL and OSMesa are not both there");
        return;
    };
    let (mut of_egl, mut of_osmesa) = (renderer(&egl), renderer(&osmesa));
    let image = |of: &mut Renderer<'_>| {
        let method = |name: &str| name.parse::<Method>().unwrap();
        METHODS.map(|name| of.render(&scene(), &method(name)).unwrap().image)
    };
    let clean = image(&mut of_egl);
    for _ in 0..2 {
        assert!(image(&mut of_osmesa) == clean);
        assert!(image(&mut of_egl) == clean);
    }
}

#[test]
fn a_backend_that_does_not_exist_is_refused_by_name() {
    let error = "glx".parse::<Backend>().unwrap_err().to_string();
    assert!(error.contains("'glx'"), "{error}");
    assert!(error.contains("Known are: egl, osmesa"), "{error}");
}

#[test]
fn a_compatibility_context_comes_on_request() {
    let context = of_profile(Profile::Compatibility);
    assert!(context.driver().has("GL_ARB_compatibility"));
    assert!(context.driver().version >= (4, 3));
}

#[test]
fn a_core_context_is_without_the_functions_of_old() {
    let context = of_profile(Profile::Core);
    assert!(!context.driver().has("GL_ARB_compatibility"));
}

#[test]
fn depth_peeling_gives_the_same_image_in_both_profiles() {
    let image = |profile| {
        let context = of_profile(profile);
        frame(&context, &Method::DepthPeeling(Default::default())).image
    };
    assert!(image(Profile::Core) == image(Profile::Compatibility));
}

#[test]
fn limits_are_at_least_those_that_opengl_4_3_promises() {
    let context = Context::headless().unwrap();
    // OpenGL 4.3 core specification, tables of implementation dependent values.
    for (name, least) in [
        ("GL_MAX_TEXTURE_SIZE", 16384),
        ("GL_MAX_RENDERBUFFER_SIZE", 16384),
        ("GL_MAX_ARRAY_TEXTURE_LAYERS", 2048),
        ("GL_MAX_DRAW_BUFFERS", 8),
        ("GL_MAX_SHADER_STORAGE_BLOCK_SIZE", 1 << 24),
        ("GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS", 8),
        ("GL_MAX_FRAGMENT_IMAGE_UNIFORMS", 8),
        ("GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS", 1024),
    ] {
        let limit = context.driver().limit(name);
        assert!(limit >= least, "{name} is {limit}");
    }
}

#[test]
fn a_limit_that_is_not_asked_is_0() {
    let context = Context::headless().unwrap();
    assert_eq!(context.driver().limit("GL_MAX_PATIENCE"), 0);
}

#[test]
fn an_image_without_pixels_is_refused_with_the_numbers() {
    let context = Context::headless().unwrap();
    let largest = context.driver().largest_image();
    for (width, height) in [(0, 768), (1024, 0), (0, 0)] {
        let error = refused(&context, width, height);
        assert!(
            error.contains(&format!("{width} x {height} pixels")),
            "{error}"
        );
        assert!(
            error.contains(&format!("1 x 1 to {largest} x {largest}")),
            "{error}"
        );
    }
}

#[test]
fn an_image_over_the_driver_s_limit_is_refused_with_the_numbers() {
    let context = Context::headless().unwrap();
    let largest = context.driver().largest_image();
    for (width, height) in [(largest + 1, 1), (1, largest + 1), (u32::MAX, u32::MAX)] {
        let error = refused(&context, width, height);
        assert!(
            error.contains(&format!("{width} x {height} pixels")),
            "{error}"
        );
        assert!(
            error.contains(&format!("1 x 1 to {largest} x {largest}")),
            "{error}"
        );
    }
}

#[test]
fn an_image_of_the_driver_s_limit_is_not_refused() {
    let context = Context::headless().unwrap();
    let largest = context.driver().largest_image();
    assert!(Renderer::new(&context, largest, 1).is_ok());
    assert!(Renderer::new(&context, 1, largest).is_ok());
}

#[test]
fn the_known_trap_is_reported_where_it_is_known_to_be() {
    let context = Context::headless().unwrap();
    let driver = context.driver();
    if !(driver.renderer.contains("llvmpipe") && driver.version_text.contains("Mesa 22.3")) {
        println!(
            "skipped: this is {}, {}",
            driver.renderer, driver.version_text
        );
        return;
    }
    let traps = GlMachine::new(&context, [256, 256])
        .unwrap()
        .traps()
        .unwrap();
    assert_eq!(traps.len(), 1);
    assert!(traps[0].what.contains("atomics are lost"), "{traps:?}");
}

#[test]
fn traps_are_the_same_every_time() {
    let context = Context::headless().unwrap();
    let mut machine = GlMachine::new(&context, [256, 256]).unwrap();
    let first = machine.traps().unwrap();
    for _ in 0..5 {
        assert_eq!(machine.traps().unwrap(), first);
    }
    let other = GlMachine::new(&context, [256, 256])
        .unwrap()
        .traps()
        .unwrap();
    assert_eq!(other, first);
}

#[test]
fn looking_for_traps_leaves_the_image_alone() {
    let context = Context::headless().unwrap();
    let method = Method::DepthPeeling(Default::default());
    let before = frame(&context, &method).image;
    GlMachine::new(&context, [64, 64]).unwrap().traps().unwrap();
    assert!(frame(&context, &method).image == before);
}

#[test]
fn many_frames_of_all_methods_in_turn_take_no_more_memory() {
    let context = Context::headless().unwrap();
    let scene = scene();
    let mut renderer = renderer(&context);
    let methods = all_methods();
    let mut round = || -> Vec<u64> {
        let bytes = |method: &Method| renderer.render(&scene, method).unwrap().stats.bytes;
        methods.iter().map(bytes).collect()
    };
    let first = round();
    println!("{first:?}");
    for _ in 0..6 {
        assert_eq!(round(), first);
    }
    // Kept layers are not kept for the next method.
    let alone: Vec<u64> = methods
        .iter()
        .map(|method| frame(&context, method).stats.bytes)
        .collect();
    assert_eq!(first, alone);
}

#[test]
fn many_frames_of_all_methods_in_turn_give_the_images_of_fresh_renderers() {
    let context = Context::headless().unwrap();
    let scene = scene();
    let mut renderer = renderer(&context);
    for method in all_methods().iter().chain(all_methods().iter().rev()) {
        let image = renderer.render(&scene, method).unwrap().image;
        assert!(image == frame(&context, method).image, "{method}");
    }
}

#[test]
fn without_costs_the_image_is_the_same_and_nothing_is_said_of_them() {
    let context = Context::headless().unwrap();
    let scene = scene();
    let mut renderer = renderer(&context).without_costs();
    for method in all_methods() {
        let counted = frame(&context, &method);
        let uncounted = renderer.render(&scene, &method).unwrap();
        assert!(uncounted.image == counted.image, "{method}");
        assert_eq!(uncounted.stats.a_buffer, None);
        let lost = counted.stats.a_buffer.map_or(counted.stats.lost, |_| None);
        assert_eq!(uncounted.stats.lost, lost, "{method}");
    }
}

#[test]
fn a_measured_frame_is_the_rendered_one_but_for_its_time() {
    let context = Context::headless().unwrap();
    let scene = scene();
    let mut renderer = renderer(&context);
    for method in all_methods() {
        let mut measured = renderer.measure(&scene, &method, 2).unwrap();
        let rendered = renderer.render(&scene, &method).unwrap();
        measured.stats.ms = rendered.stats.ms;
        assert_eq!(measured.stats, rendered.stats);
        assert!(measured.image == rendered.image, "{method}");
    }
}

#[test]
fn a_smaller_scene_after_a_larger_one_leaves_nothing_of_it() {
    let context = Context::headless().unwrap();
    let large = scene();
    let mut small = large.clone();
    small.meshes = vec![quads(&Quads::default()).unwrap()];
    let mut used = renderer(&context);
    for method in all_methods() {
        used.render(&large, &method).unwrap();
        let after = used.render(&small, &method).unwrap();
        let fresh = renderer(&context).render(&small, &method).unwrap();
        assert!(after.image == fresh.image, "{method}");
        assert_eq!(after.stats.bytes, fresh.stats.bytes, "{method}");
    }
}

#[test]
fn two_contexts_one_after_the_other_give_the_same_image() {
    let image = || {
        let context = Context::headless().unwrap();
        frame(&context, &Method::DepthPeeling(Default::default())).image
    };
    assert!(image() == image());
}

#[test]
fn twenty_contexts_one_after_the_other_can_be_had() {
    for _ in 0..20 {
        let context = Context::headless().unwrap();
        GlMachine::new(&context, [4, 4]).unwrap();
    }
}

#[test]
fn contexts_of_several_threads_do_not_disturb_each_other() {
    let image = || {
        let context = Context::headless().unwrap();
        frame(&context, &Method::DepthPeeling(Default::default())).image
    };
    let alone = image();
    let threads: Vec<_> = (0..4).map(|_| std::thread::spawn(image)).collect();
    for thread in threads {
        assert!(thread.join().unwrap() == alone);
    }
}

fn of_profile(profile: Profile) -> Context {
    let options = ContextOptions {
        profile,
        ..Default::default()
    };
    Context::new(options).unwrap()
}

fn refused(context: &Context, width: u32, height: u32) -> String {
    Renderer::new(context, width, height)
        .unwrap_err()
        .to_string()
}

/// Every method of the registry, and depth peeling in its other way.
fn all_methods() -> Vec<Method> {
    let keeping = DepthPeelingOptions {
        compositing: Compositing::KeepLayers,
        ..Default::default()
    };
    let registered = registry().iter().map(|entry| entry.method);
    registered.chain([Method::DepthPeeling(keeping)]).collect()
}

fn scene() -> Scene {
    let parameters = Soup {
        count: 200,
        ..Soup::default()
    };
    let mut scene = Scene::of("soup", vec![soup(&parameters).unwrap()]);
    scene.size = [60, 40];
    scene
}

/// For images of the scene's size.
fn renderer(context: &Context) -> Renderer<'_> {
    let [width, height] = scene().size;
    Renderer::new(context, width, height).unwrap()
}

fn frame(context: &Context, method: &Method) -> onionskin::Frame {
    renderer(context).render(&scene(), method).unwrap()
}
