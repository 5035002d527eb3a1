//! Several contexts on one thread: each is current where it is used, and nothing of one is taken for the other's.

#![allow(unsafe_code)] // a host calls GL, and has contexts of its own

use crate::kit::loader;
use std::sync::Arc;

use glow::HasContext;
use khronos_egl as egl;
use onionskin::generate::{Soup, soup};
use onionskin::low_level::gl::{Geometry, GlMachine};
use onionskin::low_level::steps::{Call, Machine, Map, Objects, Shader, Target};
use onionskin::{Backend, Context, Error, Format, Image, Method, Renderer, Scene};

const METHODS: [&str; 4] = ["blend", "depth-peeling", "dfb+ppdp", "exact"];

#[test]
fn two_contexts_in_turn_give_the_images_of_one_alone() {
    let scenes = [scene(1), scene(2)];
    let alone = scenes.each_ref().map(|scene| {
        let context = Context::headless().unwrap();
        images(&mut renderer(&context), scene)
    });
    let (a, b) = (Context::headless().unwrap(), Context::headless().unwrap());
    let (mut of_a, mut of_b) = (renderer(&a), renderer(&b));
    for _ in 0..2 {
        assert!(
            images(&mut of_a, &scenes[0]) == alone[0],
            "the first context"
        );
        assert!(
            images(&mut of_b, &scenes[1]) == alone[1],
            "the second context"
        );
    }
    drop(of_b);
    drop(b);
    assert!(
        images(&mut of_a, &scenes[0]) == alone[0],
        "after the second has gone"
    );
}

#[test]
fn what_is_dropped_deletes_nothing_of_another_context() {
    let (a, b) = (Context::headless().unwrap(), Context::headless().unwrap());
    let scene = scene(1);
    let clean = images(&mut renderer(&b), &scene);
    // Contexts give their objects the same names.
    let mut of_a = renderer(&a);
    let mut of_b = renderer(&b);
    images(&mut of_a, &scene);
    images(&mut of_b, &scene);
    let texture = texture(&b);
    drop(of_a);
    drop(a);
    assert!(images(&mut of_b, &scene) == clean);
    // SAFETY: the context is made current by asking for its functions.
    assert!(unsafe { b.glow().is_texture(texture) });
}

#[test]
fn a_machine_s_calls_go_to_its_own_context() {
    let (a, b) = (Context::headless().unwrap(), Context::headless().unwrap());
    let map = Map::named("map");
    let mut machines = [&a, &b].map(|context| GlMachine::new(context, [2, 2]).unwrap());
    for (machine, depth) in machines.iter_mut().zip([0.25, 0.75]) {
        machine.begin_frame();
        machine.allocate(map, Format::Depth32F).unwrap();
        machine
            .framebuffer(Target("depth"), None, Some(map))
            .unwrap();
        machine.perform(&Call::ClearDepth { depth }).unwrap();
    }
    for machine in &mut machines {
        let mask = onionskin::low_level::steps::gl::DEPTH_BUFFER_BIT;
        machine.perform(&Call::Clear { mask }).unwrap();
    }
    let [of_a, of_b] = machines.map(|machine| machine.read_depths(map).unwrap());
    assert_eq!((of_a, of_b), (vec![0.25; 4], vec![0.75; 4]));
}

#[test]
fn geometry_of_another_context_is_refused() {
    let (a, b) = (Context::headless().unwrap(), Context::headless().unwrap());
    let scene = scene(1);
    let mut machine = GlMachine::new(&b, scene.size).unwrap();
    let map = Map::named("map");
    machine.allocate(map, Format::Rgba8).unwrap();
    machine
        .framebuffer(Target("image"), Some(map), None)
        .unwrap();
    machine.set_geometry(Geometry::upload(&a, &scene, scene.size).unwrap());
    machine.begin_frame();
    let program = Shader("surface");
    machine.perform(&Call::UseProgram { program }).unwrap();
    let objects = Objects::Scene;
    let error = machine
        .perform(&Call::Draw { objects })
        .unwrap_err()
        .to_string();
    assert!(
        error.contains("uploaded to another OpenGL context"),
        "{error}"
    );
    machine.set_geometry(Geometry::upload(&b, &scene, scene.size).unwrap());
    machine.perform(&Call::Draw { objects }).unwrap();
}

#[test]
fn a_host_s_context_that_is_not_current_is_refused_and_nothing_is_deleted() {
    let own = Context::headless().unwrap();
    // SAFETY: the headless context is current; where it is not, the test is that this is noticed.
    let guest = unsafe { Context::from_glow(Arc::new(loader::functions(&own))) }.unwrap();
    let mut of_guest = renderer(&guest);
    let clean = images(&mut of_guest, &scene(1));
    let other = Context::headless().unwrap();
    let texture = texture(&other);
    let error = of_guest
        .render(&scene(1), &Method::Blend)
        .unwrap_err()
        .to_string();
    assert!(
        error.contains("another OpenGL context is current"),
        "{error}"
    );
    let error = Renderer::new(&guest, 16, 16).unwrap_err();
    assert!(matches!(error, Error::HostContext { .. }), "{error:?}");
    let error = Geometry::upload(&guest, &scene(1), [16, 16])
        .unwrap_err()
        .to_string();
    assert!(
        error.contains("another OpenGL context is current"),
        "{error}"
    );
    // Made current again, it goes on.
    own.glow();
    assert!(images(&mut of_guest, &scene(1)) == clean);
    other.glow();
    drop(of_guest);
    // SAFETY: the context is current.
    assert!(unsafe { other.glow().is_texture(texture) });
}

#[test]
fn a_host_s_own_context_is_current_again_after_a_frame() {
    let headless = Context::headless().unwrap();
    if headless.backend() != Some(Backend::Egl) {
        println!("skipped: the host's context is EGL's");
        return;
    }
    let mut renderer = renderer(&headless);
    let clean = images(&mut renderer, &scene(1));
    // SAFETY: libEGL is loaded already.
    let egl = unsafe { egl::DynamicInstance::<egl::EGL1_5>::load_required() }.unwrap();
    let display = egl.get_current_display().unwrap();
    let config =
        egl.choose_first_config(display, &[egl::SURFACE_TYPE, egl::PBUFFER_BIT, egl::NONE]);
    let config = config.unwrap().unwrap();
    let surface = egl
        .create_pbuffer_surface(display, config, &[egl::WIDTH, 8, egl::HEIGHT, 8, egl::NONE])
        .unwrap();
    let context = egl
        .create_context(
            display,
            config,
            None,
            &[egl::CONTEXT_MAJOR_VERSION, 3, egl::NONE],
        )
        .unwrap();
    egl.make_current(display, Some(surface), Some(surface), Some(context))
        .unwrap();
    assert!(images(&mut renderer, &scene(1)) == clean);
    assert_eq!(egl.get_current_context(), Some(context));
    assert_eq!(egl.get_current_surface(egl::DRAW), Some(surface));
    drop(renderer);
    assert_eq!(egl.get_current_context(), Some(context));
    drop(headless);
    assert_eq!(egl.get_current_context(), Some(context));
    egl.make_current(display, None, None, None).unwrap();
    egl.destroy_context(display, context).unwrap();
    egl.destroy_surface(display, surface).unwrap();
}

/// A texture of the context's, which is current then.
fn texture(context: &Context) -> glow::Texture {
    let gl = context.glow();
    // SAFETY: the context is current.
    unsafe {
        // Enough to reach the names that another context's objects have.
        let made: Vec<_> = (0..64).map(|_| gl.create_texture().unwrap()).collect();
        for texture in &made {
            gl.bind_texture(glow::TEXTURE_2D, Some(*texture));
        }
        gl.bind_texture(glow::TEXTURE_2D, None);
        made[0]
    }
}

fn images(renderer: &mut Renderer<'_>, scene: &Scene) -> Vec<Image> {
    let image = |name: &str| {
        let method: Method = name.parse().unwrap();
        renderer.render(scene, &method).unwrap().image
    };
    METHODS.map(image).to_vec()
}

fn renderer(context: &Context) -> Renderer<'_> {
    Renderer::new(context, 16, 16).unwrap()
}

fn scene(seed: u64) -> Scene {
    let parameters = Soup {
        count: 40,
        seed,
        ..Soup::default()
    };
    let mut scene = Scene::of("soup", vec![soup(&parameters).unwrap()]);
    scene.size = [16, 16];
    scene
}
