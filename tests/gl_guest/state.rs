//! Rendering in someone else's context: the image does not hang on the host's state, and the state comes back.

#![allow(unsafe_code)] // a host calls GL

use crate::kit::host;
use crate::kit::loader;
use crate::kit::small_scenes::{fog, surfaces};
use std::sync::Arc;

use crate::kit::host::{Host, ODD, gl_call};
use glow::HasContext;
use onionskin::{Context, CountBy, Error, Image, Method, Renderer, Scene, registry};

#[test]
fn with_every_state_odd_every_method_gives_the_image_of_a_clean_context_and_the_state_back() {
    let (own, guest) = contexts();
    let methods: Vec<Method> = registry()
        .iter()
        .filter(|entry| entry.runs_on(own.driver()))
        .map(|entry| entry.method)
        .collect();
    let clean: Vec<Image> = methods
        .iter()
        .map(|method| image(&own, &surfaces(40), method))
        .collect();
    let volumes: Vec<Method> = ["exact", "dfb", "ppll+ppdp", "hybrid-layer-peeling"]
        .map(|name| name.parse().unwrap())
        .to_vec();
    let foggy: Vec<Image> = volumes
        .iter()
        .map(|method| image(&own, &fog(), method))
        .collect();
    let host = Host::new(own.glow(), own.backend().unwrap());
    let initial = host.state();
    host.set_all();
    let odd = host.state();
    // The control: what is not odd would not be missed.
    let same: Vec<_> = odd
        .iter()
        .filter(|(name, value)| initial[*name] == **value)
        .map(|(name, _)| name)
        .collect();
    println!("not odd: {same:?}");
    assert!(
        same.len() < odd.len() / 3,
        "{} of {} are not odd",
        same.len(),
        odd.len()
    );
    for (method, clean) in methods.iter().zip(&clean) {
        assert!(image(&guest, &surfaces(40), method) == *clean, "{method}");
        expect(&host, &odd, &method.to_string());
    }
    for (method, clean) in volumes.iter().zip(&foggy) {
        assert!(
            image(&guest, &fog(), method) == *clean,
            "{method} of volumes"
        );
        expect(&host, &odd, &method.to_string());
    }
}

#[test]
fn each_odd_state_alone_changes_no_image_and_comes_back() {
    let methods: [Method; 4] = [
        "exact",
        "depth-peeling",
        "coherent-layer-peeling-a",
        "dfb+ppdp",
    ]
    .map(|name| name.parse().unwrap());
    for (name, set) in ODD {
        let (own, guest) = contexts();
        let scene = surfaces(40);
        let mut clean = Renderer::new(&own, 16, 16).unwrap();
        let mut renderer = Renderer::new(&guest, 16, 16).unwrap();
        let before = methods.map(|method| clean.render(&scene, &method).unwrap().image);
        let host = Host::new(own.glow(), own.backend().unwrap());
        host.set(name, *set);
        let odd = host.state();
        for (method, before) in methods.iter().zip(&before) {
            let frame = renderer.render(&scene, method).unwrap();
            assert!(frame.image == *before, "{name}, {method}");
            assert!(frame.notices.is_empty(), "{name}: {:?}", frame.notices);
        }
        expect(&host, &odd, name);
    }
}

#[test]
fn counting_layers_and_looking_for_traps_give_the_state_back_too() {
    let (own, guest) = contexts();
    let scene = surfaces(40);
    let count = |context| {
        Renderer::new(context, 16, 16)
            .unwrap()
            .complexity(&scene, CountBy::Atomics)
            .unwrap()
    };
    let clean = count(&own);
    let host = Host::new(own.glow(), own.backend().unwrap());
    host.set_all();
    let odd = host.state();
    assert_eq!(count(&guest).counts, clean.counts);
    expect(&host, &odd, "counting layers");
    onionskin::low_level::gl::GlMachine::new(&guest, [64, 64])
        .unwrap()
        .traps()
        .unwrap();
    expect(&host, &odd, "traps");
}

#[test]
fn transform_feedback_that_is_active_is_paused_and_goes_on() {
    let (own, guest) = contexts();
    let method: Method = "depth-peeling".parse().unwrap();
    let clean = image(&own, &surfaces(40), &method);
    let host = Host::new(own.glow(), own.backend().unwrap());
    host.begin_feedback();
    let odd = host.state();
    assert!(image(&guest, &surfaces(40), &method) == clean);
    expect(&host, &odd, "transform feedback");
    host.end_feedback();
}

#[test]
fn a_query_that_is_active_is_refused_by_name_and_goes_on() {
    let (own, guest) = contexts();
    let gl = own.glow();
    for (target, name) in [
        (glow::SAMPLES_PASSED, "GL_SAMPLES_PASSED"),
        (glow::ANY_SAMPLES_PASSED, "GL_ANY_SAMPLES_PASSED"),
    ] {
        // SAFETY: the context is current.
        let query = unsafe {
            let query = gl.create_query().unwrap();
            gl.begin_query(target, query);
            query
        };
        let refusal = refusal(&guest);
        assert!(
            refusal.contains(&format!("in the middle of the query {} ({name})", query.0)),
            "{refusal}"
        );
        assert!(refusal.contains("glEndQuery"), "{refusal}");
        // SAFETY: as above; it is still active, or ending it were an error.
        unsafe {
            gl.end_query(target);
            assert_eq!(gl.get_error(), glow::NO_ERROR);
        }
    }
    assert!(guest.visit().is_ok());
}

#[test]
fn a_conditional_render_is_refused_and_goes_on() {
    let (own, guest) = contexts();
    let host = Host::new(own.glow(), own.backend().unwrap());
    // SAFETY: the context is current; the query has begun and ended.
    unsafe {
        let query = host.gl.create_query().unwrap();
        host.gl.begin_query(glow::SAMPLES_PASSED, query);
        host.gl.end_query(glow::SAMPLES_PASSED);
        gl_call!(host, "glBeginConditionalRender"(query.0.get() => u32, 0x8E13 => u32));
    }
    let refusal = refusal(&guest);
    assert!(
        refusal.contains("in the middle of a conditional render"),
        "{refusal}"
    );
    // SAFETY: as above; it goes on, or ending it were an error.
    unsafe {
        gl_call!(host, "glEndConditionalRender"());
        assert_eq!(host.gl.get_error(), glow::NO_ERROR);
    }
    assert!(guest.visit().is_ok());
}

#[test]
fn a_program_in_use_that_has_been_deleted_is_refused() {
    let (own, guest) = contexts();
    let host = Host::new(own.glow(), own.backend().unwrap());
    // SAFETY: the context is current; the program lives until it is in use no more.
    unsafe {
        host.gl.use_program(Some(host.program()));
        host.gl.delete_program(host.program());
    }
    let refusal = refusal(&guest);
    assert!(refusal.contains("glUseProgram(0)"), "{refusal}");
    // SAFETY: as above.
    unsafe { host.gl.use_program(None) };
    assert!(guest.visit().is_ok());
}

#[test]
fn an_error_that_was_pending_is_said_to_be_someone_elses_and_the_frame_is_right() {
    let (own, guest) = contexts();
    let method: Method = "exact".parse().unwrap();
    let clean = image(&own, &surfaces(40), &method);
    let mut renderer = Renderer::new(&guest, 16, 16).unwrap();
    for _ in 0..2 {
        // SAFETY: the context is current; OpenGL refuses it.
        unsafe { own.glow().enable(0xDEAD) };
        let frame = renderer.render(&surfaces(40), &method).unwrap();
        assert!(frame.image == clean);
        assert_eq!(frame.notices.len(), 1, "{:?}", frame.notices);
        assert!(
            frame.notices[0].contains("GL_INVALID_ENUM pending before the frame"),
            "{:?}",
            frame.notices
        );
    }
    assert!(
        renderer
            .render(&surfaces(40), &method)
            .unwrap()
            .notices
            .is_empty()
    );
    // Nor is it taken for a lack of room.
    // SAFETY: as above.
    unsafe { own.glow().enable(0xDEAD) };
    drop(Renderer::new(&guest, 16, 16).unwrap());
    assert_eq!(guest.foreign_errors(), ["GL_INVALID_ENUM"]);
}

#[test]
fn errors_of_a_frame_are_not_left_to_the_host() {
    let (own, guest) = contexts();
    let host = Host::new(own.glow(), own.backend().unwrap());
    let visit = guest.visit().unwrap();
    // SAFETY: the context is current; OpenGL refuses it.
    unsafe { guest.glow().enable(0xDEAD) };
    drop(visit);
    // SAFETY: as above.
    assert_eq!(unsafe { host.gl.get_error() }, glow::NO_ERROR);
}

/// A headless context, and the same one as a host hands it over. Only one of them is used at a time.
fn contexts() -> (Context, Context) {
    let own = Context::headless().unwrap();
    // SAFETY: the headless context is current, and outlives the other: they are dropped last to first.
    let guest = unsafe { Context::from_glow(Arc::new(loader::functions(&own))) }.unwrap();
    (own, guest)
}

fn refusal(guest: &Context) -> String {
    let mut renderer = Renderer::new(guest, 16, 16).unwrap();
    let error = renderer
        .render(&surfaces(40), &"exact".parse::<Method>().unwrap())
        .unwrap_err();
    assert!(matches!(error, Error::HostContext { .. }), "{error:?}");
    error.to_string()
}

fn expect(host: &Host<'_>, before: &host::State, after: &str) {
    for (name, value) in host.state() {
        assert_eq!(value, before[&name], "{name} after {after}");
    }
}

fn image(context: &Context, scene: &Scene, method: &Method) -> Image {
    let mut renderer = Renderer::new(context, 16, 16).unwrap();
    renderer.render(scene, method).unwrap().image
}
