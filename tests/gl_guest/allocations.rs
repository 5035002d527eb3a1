//! Memory that the driver does not have: each allocation of each method fails in turn. The error names it, nothing is
//! left behind, and the next frame is the right one.

#![allow(unsafe_code)] // a driver without memory is played by functions in OpenGL's place

use crate::kit::loader;
use crate::kit::small_scenes::{fog, surfaces};
use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;
use std::ffi::{c_int, c_uint, c_void};
use std::sync::Arc;

use onionskin::{Backend, Context, Error, Method, Renderer, Scene, registry};

const OUT_OF_MEMORY: c_uint = 0x0505;

thread_local! {
    /// OpenGL's own functions, by the names of those that stand in their place.
    static REAL: RefCell<BTreeMap<&'static str, usize>> = const { RefCell::new(BTreeMap::new()) };
    /// Objects of each kind that have been made and not deleted.
    static ALIVE: RefCell<BTreeMap<&'static str, i64>> = const { RefCell::new(BTreeMap::new()) };
    static ALLOCATIONS: Cell<u32> = const { Cell::new(0) };
    /// Which allocation fails, from 1; none if 0.
    static FAILING: Cell<u32> = const { Cell::new(0) };
    /// `glFinish` finds that there was no memory.
    static FAILS_AT_THE_END: Cell<bool> = const { Cell::new(false) };
    static PENDING: Cell<bool> = const { Cell::new(false) };
}

/// Whether the allocation that is asked for now has room.
fn has_room() -> bool {
    let number = ALLOCATIONS.get() + 1;
    ALLOCATIONS.set(number);
    let fails = number == FAILING.get();
    PENDING.set(PENDING.get() || fails);
    !fails
}

fn count(kind: &'static str, by: i64) {
    ALIVE.with_borrow_mut(|alive| *alive.entry(kind).or_default() += by);
}

fn real(name: &str) -> usize {
    REAL.with_borrow(|real| real[name])
}

/// Functions that stand in OpenGL's place and call it: `let` is their beginning, and whether they call it.
macro_rules! in_place_of {
    ($($name:literal as $function:ident($($argument:ident: $kind:ty),*) $(-> $result:ty)? $body:block)*) => {
        $(extern "system" fn $function($($argument: $kind),*) $(-> $result)? {
            #[allow(unused)]
            let call = || {
                type Function = unsafe extern "system" fn($($kind),*) $(-> $result)?;
                // SAFETY: the function of that name has this signature, and its caller's arguments are passed on.
                unsafe { std::mem::transmute::<usize, Function>(real($name))($($argument),*) }
            };
            in_place_of!(@run call, $body)
        })*
        fn stand_in(name: &str) -> Option<(&'static str, *const c_void)> {
            match name {
                $($name => Some(($name, $function as *const c_void)),)*
                _ => None,
            }
        }
    };
    (@run $call:ident, $body:block) => {{
        let before: Answer<_> = $body;
        match before {
            Answer::Call => $call(),
            Answer::Instead(answer) => answer,
        }
    }};
}

/// What a function in OpenGL's place does: calls it, or answers in its stead.
enum Answer<T> {
    Call,
    Instead(T),
}

fn if_room() -> Answer<()> {
    if has_room() {
        Answer::Call
    } else {
        Answer::Instead(())
    }
}

in_place_of! {
    "glBufferData" as buffer_data(a: c_uint, b: isize, c: *const c_void, d: c_uint) { if_room() }
    "glBufferStorage" as buffer_storage(a: c_uint, b: isize, c: *const c_void, d: c_uint) { if_room() }
    "glTexStorage2D" as tex_storage_2d(a: c_uint, b: c_int, c: c_uint, d: c_int, e: c_int) { if_room() }
    "glTexStorage3D" as tex_storage_3d(a: c_uint, b: c_int, c: c_uint, d: c_int, e: c_int, f: c_int) { if_room() }
    "glRenderbufferStorage" as renderbuffer_storage(a: c_uint, b: c_uint, c: c_int, d: c_int) { if_room() }
    "glGetError" as get_error() -> c_uint {
        if PENDING.replace(false) { Answer::Instead(OUT_OF_MEMORY) } else { Answer::Call }
    }
    "glFinish" as finish() {
        PENDING.set(PENDING.get() || FAILS_AT_THE_END.get());
        Answer::Call
    }
    "glGenBuffers" as gen_buffers(n: c_int, names: *mut c_uint) { count("buffers", n.into()); Answer::Call }
    "glDeleteBuffers" as delete_buffers(n: c_int, names: *const c_uint) { count("buffers", -i64::from(n)); Answer::Call }
    "glGenTextures" as gen_textures(n: c_int, names: *mut c_uint) { count("textures", n.into()); Answer::Call }
    "glDeleteTextures" as delete_textures(n: c_int, names: *const c_uint) { count("textures", -i64::from(n)); Answer::Call }
    "glGenFramebuffers" as gen_framebuffers(n: c_int, names: *mut c_uint) { count("framebuffers", n.into()); Answer::Call }
    "glDeleteFramebuffers" as delete_framebuffers(n: c_int, names: *const c_uint) { count("framebuffers", -i64::from(n)); Answer::Call }
    "glGenVertexArrays" as gen_vertex_arrays(n: c_int, names: *mut c_uint) { count("vertex arrays", n.into()); Answer::Call }
    "glDeleteVertexArrays" as delete_vertex_arrays(n: c_int, names: *const c_uint) { count("vertex arrays", -i64::from(n)); Answer::Call }
    "glGenSamplers" as gen_samplers(n: c_int, names: *mut c_uint) { count("samplers", n.into()); Answer::Call }
    "glDeleteSamplers" as delete_samplers(n: c_int, names: *const c_uint) { count("samplers", -i64::from(n)); Answer::Call }
    "glGenQueries" as gen_queries(n: c_int, names: *mut c_uint) { count("queries", n.into()); Answer::Call }
    "glDeleteQueries" as delete_queries(n: c_int, names: *const c_uint) { count("queries", -i64::from(n)); Answer::Call }
    "glCreateProgram" as create_program() -> c_uint { count("programs", 1); Answer::Call }
    "glDeleteProgram" as delete_program(name: c_uint) { count("programs", -1); Answer::Call }
    "glCreateShader" as create_shader(kind: c_uint) -> c_uint { count("shaders", 1); Answer::Call }
    "glDeleteShader" as delete_shader(name: c_uint) { count("shaders", -1); Answer::Call }
}

/// A headless context's functions, with those above in their places.
fn failing_functions(backend: Backend) -> glow::Context {
    // SAFETY: the context that the functions are of is current; the stand-ins have OpenGL's signatures.
    unsafe {
        glow::Context::from_loader_function(|name| {
            let found = loader::function(backend, name);
            match stand_in(name) {
                Some((name, function)) if !found.is_null() => {
                    REAL.with_borrow_mut(|real| real.insert(name, found as usize));
                    function
                }
                _ => found,
            }
        })
    }
}

/// What `work` is told when its allocation number `failing` fails, and how many it made.
fn with_failing<T>(failing: u32, work: impl FnOnce() -> T) -> (T, u32) {
    FAILING.set(failing);
    ALLOCATIONS.set(0);
    let result = work();
    FAILING.set(0);
    (result, ALLOCATIONS.get())
}

fn alive() -> BTreeMap<&'static str, i64> {
    ALIVE.with_borrow(|alive| {
        alive
            .iter()
            .map(|(kind, n)| (*kind, *n))
            .filter(|(_, n)| *n != 0)
            .collect()
    })
}

/// Lets each allocation of each method fail. Returns what was said of each.
fn fail_in_turn(own: &Context, scene: &Scene, methods: &[Method]) -> Vec<String> {
    // SAFETY: the headless context stays current, and outlives the other.
    let context =
        unsafe { Context::from_glow(Arc::new(failing_functions(own.backend().unwrap()))) }.unwrap();
    let [width, height] = scene.size;
    let before = alive();
    let mut said = Vec::new();
    for method in methods {
        let mut renderer = Renderer::new(&context, width, height).unwrap();
        let clean = renderer.render(scene, method).unwrap();
        let (_, allocations) = with_failing(0, || renderer.render(scene, method).unwrap());
        let held = alive();
        assert!(allocations >= 4, "{method} makes {allocations} allocations");
        for failing in 1..=allocations {
            let (frame, _) = with_failing(failing, || renderer.render(scene, method));
            let Err(Error::Driver { what, .. }) = frame else {
                panic!("{method}, allocation {failing} of {allocations}: {frame:?}");
            };
            let named = what.starts_with("the driver has no room for ")
                && what.ends_with("): GL_OUT_OF_MEMORY")
                && [" bytes)", " KiB)", " MiB)"]
                    .iter()
                    .any(|unit| what.contains(unit));
            assert!(named, "{method}: {what}");
            said.push(what);
            let next = renderer.render(scene, method).unwrap();
            assert!(
                next.image == clean.image,
                "{method} after allocation {failing} failed"
            );
            assert_eq!(alive(), held, "{method} after allocation {failing} failed");
        }
        drop(renderer);
        assert_eq!(alive(), before, "{method} leaves objects behind");
    }
    said
}

#[test]
fn each_allocation_of_each_method_that_fails_is_named_and_nothing_of_it_stays() {
    let own = Context::headless().unwrap();
    let runs = registry()
        .iter()
        .filter(|entry| entry.runs_on(own.driver()));
    let methods: Vec<Method> = runs.map(|entry| entry.method).collect();
    let said = fail_in_turn(&own, &surfaces(30), &methods);
    for part in [
        "the vertices of mesh 'soup' (",
        "the triangles of mesh 'soup' (",
        "the map 'image', a 16 x 16 texture (Rgba32F) (4.0 KiB)",
        "a list of ",
    ] {
        assert!(
            said.iter().any(|what| what.contains(part)),
            "{part}: {said:#?}"
        );
    }
}

#[test]
fn each_allocation_for_volumes_that_fails_is_named_and_nothing_of_it_stays() {
    let own = Context::headless().unwrap();
    let methods =
        ["dfb+ppdp", "ppll", "ffb", "hybrid-layer-peeling"].map(|name| name.parse().unwrap());
    let said = fail_in_turn(&own, &fog(), &methods);
    for part in [
        "the volume 'ball' of ",
        "the transfer functions (",
        "the volumes' places (",
    ] {
        assert!(
            said.iter().any(|what| what.contains(part)),
            "{part}: {said:#?}"
        );
    }
}

#[test]
fn the_first_frame_of_a_renderer_fails_as_cleanly_as_any() {
    let own = Context::headless().unwrap();
    // SAFETY: as above.
    let context =
        unsafe { Context::from_glow(Arc::new(failing_functions(own.backend().unwrap()))) }.unwrap();
    let scene = surfaces(30);
    let before = alive();
    for name in ["blend", "painter", "exact"] {
        let method: Method = name.parse().unwrap();
        let mut failing = 1;
        loop {
            let mut renderer = Renderer::new(&context, 16, 16).unwrap();
            let (frame, allocations) = with_failing(failing, || renderer.render(&scene, &method));
            drop(renderer);
            assert_eq!(alive(), before, "{method}, allocation {failing}");
            if allocations < failing {
                frame.unwrap();
                break;
            }
            frame.unwrap_err();
            failing += 1;
        }
        assert!(failing > 4, "{method}");
    }
}

#[test]
fn what_opengl_finds_missing_at_the_end_of_a_frame_is_an_error() {
    let own = Context::headless().unwrap();
    // SAFETY: as above.
    let context =
        unsafe { Context::from_glow(Arc::new(failing_functions(own.backend().unwrap()))) }.unwrap();
    let scene = surfaces(30);
    let mut renderer = Renderer::new(&context, 16, 16).unwrap();
    for name in ["blend", "depth-peeling", "exact"] {
        let method: Method = name.parse().unwrap();
        let clean = renderer.render(&scene, &method).unwrap().image;
        FAILS_AT_THE_END.set(true);
        let error = renderer.render(&scene, &method).unwrap_err().to_string();
        FAILS_AT_THE_END.set(false);
        assert!(error.contains("OpenGL says GL_OUT_OF_MEMORY"), "{error}");
        assert!(
            renderer.render(&scene, &method).unwrap().image == clean,
            "{method}"
        );
    }
}
