//! What the machine refuses, and how it says so.

use onionskin::low_level::emulator::Emulator;
use onionskin::low_level::gl::GlMachine;
use onionskin::low_level::steps::{
    Call, Machine, Map, Objects, Query, Shader, Storage, Target, Workspace,
};
use onionskin::{Context, Error, Format};

#[test]
#[cfg_attr(
    not(debug_assertions),
    ignore = "only debug builds ask GL for errors after each step"
)]
fn an_error_of_opengl_names_the_step() {
    let context = Context::headless().unwrap();
    let mut machine = GlMachine::new(&context, [4, 4]).unwrap();
    let query = Query("never begun");
    let error = machine.perform(&Call::EndQuery { query }).unwrap_err();
    let Error::Step { step, error, .. } = &error else {
        panic!("{error}")
    };
    assert_eq!(step, &Call::EndQuery { query }.to_string());
    assert_eq!(error, "GL_INVALID_OPERATION");
}

#[test]
#[cfg_attr(
    not(debug_assertions),
    ignore = "only debug builds ask GL for errors after each step"
)]
fn an_error_of_opengl_is_not_blamed_on_the_next_step() {
    let context = Context::headless().unwrap();
    let mut machine = GlMachine::new(&context, [4, 4]).unwrap();
    let query = Query("never begun");
    assert!(machine.perform(&Call::EndQuery { query }).is_err());
    assert!(machine.perform(&Call::DepthMask { flag: true }).is_ok());
}

#[test]
fn a_swap_exchanges_the_names_of_two_maps() {
    let context = Context::headless().unwrap();
    let mut machine = GlMachine::new(&context, [2, 2]).unwrap();
    let (peel, next) = (Map::named("zPeel"), Map::named("zPeelNext"));
    for (map, depth) in [(peel, 0.25), (next, 0.75)] {
        machine.allocate(map, Format::Depth32FStencil8).unwrap();
        machine
            .framebuffer(Target("depth"), None, Some(map))
            .unwrap();
        machine.perform(&Call::ClearDepth { depth }).unwrap();
        let mask = onionskin::low_level::steps::gl::DEPTH_BUFFER_BIT;
        machine.perform(&Call::Clear { mask }).unwrap();
    }
    machine.perform(&Call::Swap { a: peel, b: next }).unwrap();
    assert_eq!(machine.read_depths(peel).unwrap(), [0.75; 4]);
    assert_eq!(machine.read_depths(next).unwrap(), [0.25; 4]);
}

#[test]
fn a_listing_that_names_an_unknown_map_is_told_so() {
    let context = Context::headless().unwrap();
    let mut machine = GlMachine::new(&context, [4, 4]).unwrap();
    let nowhere = Map::numbered("nowhere", 3);
    let known = Map::named("known");
    machine.allocate(known, Format::Rgba8).unwrap();
    for call in [
        Call::BindTexture { texture: nowhere },
        Call::AttachColor { texture: nowhere },
        Call::AttachDepth { texture: nowhere },
        Call::CopyImage {
            from: nowhere,
            to: known,
        },
    ] {
        let error = machine.perform(&call).unwrap_err().to_string();
        assert!(
            error.contains("the map 'nowhere 3', which does not exist"),
            "{error}"
        );
    }
    assert!(machine.read_colors(nowhere).is_err());
    assert!(
        machine
            .perform(&Call::BindTexture { texture: known })
            .is_ok()
    );
}

#[test]
fn a_misspelt_map_or_buffer_is_refused_with_the_one_that_was_meant() {
    let context = Context::headless().unwrap();
    let mut machine = GlMachine::new(&context, [4, 4]).unwrap();
    let texture = Map::named("opaque dpeth");
    let bind = Call::BindTexture { texture };
    let error = machine.perform(&bind).unwrap_err().to_string();
    assert!(error.ends_with("Allocate it first."), "{error}");
    for map in ["layer", "opaque depth"] {
        let depth = Format::Depth32FStencil8;
        machine.allocate(Map::named(map), depth).unwrap();
    }
    let error = machine.perform(&bind).unwrap_err();
    assert!(matches!(error, Error::UnknownMap { .. }), "{error:?}");
    let error = error.to_string();
    assert!(error.contains("Did you mean 'opaque depth'?"), "{error}");
    machine
        .allocate_storage(Storage("records"), 16, None)
        .unwrap();
    let error = machine
        .perform(&Call::BindStorage {
            index: 0,
            buffer: Storage("recrods"),
        })
        .unwrap_err();
    assert!(matches!(error, Error::UnknownBuffer { .. }), "{error:?}");
    let error = error.to_string();
    assert!(error.contains("Did you mean 'records'?"), "{error}");
    // The emulated pixel says the same.
    let mut pixel = Emulator::new(vec![Vec::new()]);
    pixel
        .allocate(Map::named("opaque depth"), Format::Depth32FStencil8)
        .unwrap();
    let error = pixel.perform(&bind).unwrap_err().to_string();
    assert!(error.contains("Did you mean 'opaque depth'?"), "{error}");
}

#[test]
fn a_listing_that_draws_before_it_has_a_program_is_told_so() {
    let context = Context::headless().unwrap();
    let mut machine = GlMachine::new(&context, [4, 4]).unwrap();
    for objects in [Objects::Scene, Objects::Screen] {
        let error = machine.perform(&Call::Draw { objects }).unwrap_err();
        assert!(
            error.to_string().contains("before it chooses a program"),
            "{error}"
        );
    }
}

#[test]
fn a_listing_that_draws_a_scene_before_there_is_one_is_told_so() {
    let context = Context::headless().unwrap();
    let mut machine = GlMachine::new(&context, [4, 4]).unwrap();
    let program = Shader("surface");
    machine.perform(&Call::UseProgram { program }).unwrap();
    let objects = Objects::Transparent;
    let error = machine.perform(&Call::Draw { objects }).unwrap_err();
    assert!(error.to_string().contains("before there is one"), "{error}");
}

#[test]
fn a_program_for_surfaces_does_not_draw_the_screen_nor_the_other_way_round() {
    let context = Context::headless().unwrap();
    let mut machine = GlMachine::new(&context, [4, 4]).unwrap();
    for (shader, objects) in [("surface", Objects::Screen), ("layer", Objects::Scene)] {
        let program = Shader(shader);
        machine.perform(&Call::UseProgram { program }).unwrap();
        let error = machine.perform(&Call::Draw { objects }).unwrap_err();
        assert!(error.to_string().contains("does not draw"), "{error}");
    }
}

#[test]
fn a_shader_that_does_not_exist_is_named() {
    let context = Context::headless().unwrap();
    let mut machine = GlMachine::new(&context, [4, 4]).unwrap();
    let program = Shader("no such");
    let error = machine.perform(&Call::UseProgram { program }).unwrap_err();
    assert!(error.to_string().contains("'no such'"), "{error}");
}

#[test]
fn a_query_that_was_never_made_is_named() {
    let context = Context::headless().unwrap();
    let mut machine = GlMachine::new(&context, [4, 4]).unwrap();
    let error = machine.samples(Query("unasked")).unwrap_err();
    assert!(error.to_string().contains("'unasked'"), "{error}");
}

#[test]
fn depth_units_are_refused_by_a_real_opengl() {
    let context = Context::headless().unwrap();
    let mut machine = GlMachine::new(&context, [4, 4]).unwrap();
    let error = machine
        .perform(&Call::ActiveDepthUnit { unit: 0 })
        .unwrap_err();
    assert!(error.to_string().contains("no depth units"), "{error}");
    assert!(matches!(error, Error::CannotPerform { .. }), "{error:?}");
}

#[test]
fn a_framebuffer_that_the_driver_does_not_take_is_named() {
    let context = Context::headless().unwrap();
    let mut machine = GlMachine::new(&context, [4, 4]).unwrap();
    let depth = Map::named("depth");
    machine.allocate(depth, Format::Depth32FStencil8).unwrap();
    // A depth map is no colour.
    let error = machine
        .framebuffer(Target("wrong"), Some(depth), None)
        .unwrap_err();
    assert!(error.to_string().contains("'wrong'"), "{error}");
}
