//! Amendments that need OpenGL are small: one step less, and the frame is another. `tests/papers/smallest_change.rs` has
//! those that the emulated pixel runs.

use onionskin::low_level::gl::{Geometry, GlMachine};
use onionskin::low_level::methods::allocate_maps;
use onionskin::low_level::papers::carr_2008::ideal;
use onionskin::low_level::papers::everitt_2001::ALPHA;
use onionskin::low_level::papers::lindholm_2015 as lindholm;
use onionskin::low_level::papers::{stage, vtk};
use onionskin::low_level::steps::{Amendment, Variables, gl::STENCIL_TEST, run};
use onionskin::options::{
    ABufferOptions, Compositing, DepthPeelingOptions, Fill, Manager, Reading,
};
use onionskin::{Context, Format, Frame, Method, Renderer, Scene, Transform, steps};

use crate::kit::a_buffer::options;
use crate::kit::changed::changed;
use crate::kit::driver::keeps_lists_in_order;
use crate::kit::fog_scenes::fog_and_pane;
use crate::kit::peeling::peel;
use crate::kit::shortened::idle;
use crate::kit::stack::{Stack, row, scattered};

/// Few and many layers before, on and behind an opaque surface, with ties, and pixels that have none.
fn scene() -> Scene {
    const OPAQUE: u16 = 250;
    let counts = [0, 1, 2, 3, 5, 8, 12, 1, 2, 4, 9, 12];
    let pixel = |(number, &count): (usize, &usize)| {
        let mut pieces = scattered(count, number * 5, 31 * (number + 1));
        pieces
            .iter_mut()
            .skip(3)
            .step_by(4)
            .for_each(|piece| piece.level = OPAQUE);
        pieces
    };
    let stack = Stack {
        width: 4,
        pixels: counts.iter().enumerate().map(pixel).collect(),
        opaque: Some(OPAQUE),
    };
    stack.scene()
}

/// What is seen and counted of a frame, to the bit.
fn seen(frame: &Frame) -> impl PartialEq + use<> {
    let bits = |image: &onionskin::Image| -> Vec<_> {
        let pixels = image.pixels.iter();
        pixels
            .map(|pixel| pixel.to_array().map(f32::to_bits))
            .collect()
    };
    let layers = frame.layers.iter();
    let layers: Vec<_> = layers
        .map(|layer| (bits(&layer.color), layer.depth.clone()))
        .collect();
    let stats = &frame.stats;
    let counted = (
        stats.iterations,
        stats.layers,
        stats.lost,
        stats.stopped,
        stats.a_buffer,
    );
    (bits(&frame.image), layers, counted)
}

/// Amendments from outside of a listing that turn those inside of it into other ones, or take them out.
fn from_outside(inside: &[Amendment], wanted: &[Amendment]) -> &'static [Amendment] {
    let put = |it: &Amendment| {
        let of_it = |other: &&Amendment| other.place == it.place && other.printed == it.printed;
        let amended = wanted
            .iter()
            .find(of_it)
            .map_or(it.printed, |other| other.amended);
        Amendment {
            printed: it.amended,
            amended,
            ..*it
        }
    };
    let put = inside.iter().map(put).filter(|it| it.printed != it.amended);
    put.collect::<Vec<_>>().leak()
}

/// What VTK's page adds to Listing 1, and this edition to both. Where no layer is kept the colour buffer is not cleared,
/// which has no step that could be left out.
#[test]
fn one_step_less_of_vtk_s_amendments_is_noticed() {
    let context = Context::headless().unwrap();
    let scene = scene();
    let kept = [
        vtk::CULL_BY_OPAQUE,
        vtk::QUERY,
        vtk::KEEP_DEPTH,
        vtk::ONLY_THE_LAYER,
        vtk::COUNT_THE_LAYER,
    ];
    let on_the_fly = [vtk::CULL_BY_OPAQUE, vtk::QUERY, vtk::UNDER];
    // Without a ratio the pixels need not be counted, which is spared; counted, they are not less than a part of 0.
    for (compositing, whole, harmless) in [
        (Compositing::KeepLayers, &kept[..], &["V02 2.15"][..]),
        (Compositing::OnTheFly, &on_the_fly, &[]),
    ] {
        let run = |amendments| {
            let frame = |(maximum_number_of_peels, occlusion_ratio)| {
                let options = DepthPeelingOptions {
                    maximum_number_of_peels,
                    occlusion_ratio,
                    compositing,
                    amendments,
                    ..Default::default()
                };
                // A new one each: the frame before may have left a query open.
                let [width, height] = scene.size;
                let mut renderer = Renderer::new(&context, width, height).unwrap();
                renderer
                    .render(&scene, &Method::DepthPeeling(options))
                    .ok()
                    .as_ref()
                    .map(seen)
            };
            // More peels than there are layers, so that a loop without its end is another frame and no endless one.
            [(20, 0.0), (20, 0.6), (3, 0.0)].map(frame)
        };
        let right = run(&[]);
        assert!(right.iter().all(Option::is_some), "{compositing:?}");
        let idle = idle(whole, |wanted| run(from_outside(whole, wanted)) == right);
        assert_eq!(idle, harmless, "{compositing:?}");
    }
}

#[test]
fn one_step_less_of_everitt_s_blending_is_noticed() {
    let context = Context::headless().unwrap();
    let scene = scene();
    let run = |amendments: &[Amendment]| {
        let options = DepthPeelingOptions {
            maximum_number_of_peels: 4,
            reading: Reading::AsPrinted,
            amendments: amendments.to_vec().leak(),
            ..Default::default()
        };
        seen(&peel(&context, &scene, options))
    };
    let right = run(&[ALPHA]);
    let idle = idle(&[ALPHA], |amendments| run(amendments) == right);
    assert_eq!(idle, Vec::<String>::new());
}

#[test]
fn one_step_less_of_algorithm_2_on_opengl_is_noticed() {
    let context = Context::headless().unwrap();
    let scene = scene();
    let run = |amendments: &[Amendment], by_images: bool| {
        let mut machine = GlMachine::new(&context, scene.size).unwrap();
        machine.set_defines(&[("IMAGES", u32::from(by_images))]);
        let resources = [
            &stage::RESOURCES,
            &ideal::RESOURCES,
            &ideal::NO_COLOR_RESOURCES,
        ];
        let formats = [Format::Rgba32F, Format::Depth32FStencil8];
        allocate_maps(&mut machine, &resources, formats[0], formats[1]).unwrap();
        machine.set_geometry(Geometry::upload(&context, &scene, scene.size).unwrap());
        machine.begin_frame();
        let limit = Variables::new().with("iteration_limit", 20.0);
        let outcome = run(&ideal::IDEAL, amendments, limit, &mut machine).ok()?;
        let image = machine.read_colors(stage::IMAGE_COLOR).unwrap();
        let bits: Vec<_> = image.iter().map(|color| color.map(f32::to_bits)).collect();
        Some((
            bits,
            outcome.variables.get("iterations").map(f64::to_bits),
            outcome.stopped,
        ))
    };
    if context.driver().has("GL_EXT_shader_framebuffer_fetch") {
        for whole in [&ideal::AMENDMENTS[..], &ideal::TIGHT_BOUND_ON_GL] {
            let right = run(whole, false);
            assert!(right.is_some());
            let idle = idle(whole, |amendments| run(amendments, false) == right);
            assert_eq!(idle, Vec::<String>::new());
        }
    } else {
        println!("skipped: by framebuffer fetch (no GL_EXT_shader_framebuffer_fetch)");
    }
    if keeps_lists_in_order(&context) {
        let whole = [&ideal::AMENDMENTS[..], &ideal::BY_IMAGES].concat();
        let right = run(&whole, true);
        assert!(right.is_some());
        let idle = idle(&whole, |amendments| run(amendments, true) == right);
        // The barriers, which OpenGL asks for and llvmpipe does without: it runs one draw after the other.
        let barriers = [
            "images 2.4",
            "images 3",
            "images 3.0",
            "images 4",
            "images 4.0",
        ];
        assert_eq!(idle, barriers);
    }
}

/// Amendments that go before a method's own, and turn them into other ones, or take them out.
fn in_place_of(own: &[Amendment], wanted: &[Amendment]) -> &'static [Amendment] {
    let put = |it: &Amendment| {
        let of_it = |other: &&Amendment| other.place == it.place && other.printed == it.printed;
        let other = wanted.iter().find(of_it);
        let amended = other.map_or(it.printed, |other| other.amended);
        Amendment { amended, ..*it }
    };
    own.iter().map(put).collect::<Vec<_>>().leak()
}

/// Two rows of lists, shallow ones and ones past every array, before and behind an opaque surface.
fn lists() -> Scene {
    let stack = Stack {
        width: 4,
        opaque: Some(700),
        ..row(&[0, 1, 5, 9, 20, 60, 100, 400])
    };
    stack.scene()
}

/// The eye in the fog, which ends behind an opaque pane; so many clear panes before that one, one behind it, and one before
/// the near plane.
fn fog(panes: usize) -> Scene {
    let mut scene = fog_and_pane(1.2, -0.4, 0.002, 0.3);
    let clear = scene.meshes[0].clone();
    let moved = |z: f64| {
        clear.clone().transformed(&Transform {
            translate: glam::DVec3::Z * z,
            ..Default::default()
        })
    };
    let (mut opaque, behind) = (moved(-0.2), moved(-0.4));
    opaque.opaque = true;
    let before_the_near_plane = moved(1.3);
    scene
        .meshes
        .extend(std::iter::repeat_n(clear.clone(), panes - 1));
    scene.meshes.extend([opaque, behind, before_the_near_plane]);
    scene
}

/// The changes that nothing notices, of amendments to lists with these options.
fn idle_of_lists(
    scene: &Scene,
    options: ABufferOptions,
    own: &[Amendment],
    put: fn(&[Amendment], &[Amendment]) -> &'static [Amendment],
) -> Vec<String> {
    let context = Context::headless().unwrap();
    let run = |amendments| {
        let [width, height] = scene.size;
        let mut renderer = Renderer::new(&context, width, height).unwrap();
        let method = Method::ABuffer(ABufferOptions {
            amendments,
            ..options
        });
        renderer.render(scene, &method).ok().as_ref().map(seen)
    };
    let right = run(&[]);
    assert!(right.is_some());
    idle(own, |wanted| run(put(own, wanted)) == right)
}

const DFB: ABufferOptions = ABufferOptions {
    manager: Manager::Dfb,
    fill: Fill::Atomics,
    // A row at a time.
    budget: Some(16_500),
    ..ABufferOptions::DEFAULT
};

#[test]
fn one_step_less_of_how_lists_are_filled_is_noticed() {
    let context = Context::headless().unwrap();
    let none = Vec::<String>::new();
    let exact = ABufferOptions { pp_dp: true, ..DFB };
    let own = [lindholm::BEGIN_AT_OFFSETS];
    assert_eq!(idle_of_lists(&lists(), exact, &own, in_place_of), none);
    if context.driver().has("GL_EXT_shader_framebuffer_fetch") {
        let ordered = ABufferOptions {
            fill: Fill::Ordered,
            ..exact
        };
        let own = [lindholm::BEGIN_AT_OFFSETS, lindholm::ORDERED];
        // The atomics in its place fill the same lists. Its one step is needed, for they are left out with it.
        let idle = idle_of_lists(&lists(), ordered, &own, in_place_of);
        assert_eq!(idle, ["L04 1"]);
    } else {
        println!("skipped: ordered fills, for there is no framebuffer fetch");
    }
}

#[test]
fn one_step_less_of_how_volumes_enter_lists_is_noticed() {
    let own = [lindholm::PROXIES];
    // More layers than the stencil buffer counts, so that a second draw counts them.
    let options = ABufferOptions {
        manager: Manager::Ffb,
        pp_dp: true,
        budget: None,
        ..DFB
    };
    let idle = idle_of_lists(&fog(300), options, &own, in_place_of);
    assert_eq!(idle, Vec::<String>::new());
}

#[test]
fn one_step_less_of_pp_ao_s_masking_is_noticed() {
    if !keeps_lists_in_order(&Context::headless().unwrap()) {
        return;
    }
    let none = Vec::<String>::new();
    let amended = ABufferOptions { pp_ao: true, ..DFB };
    let own = [lindholm::BY_COUNTER, lindholm::NO_STENCIL];
    // The stencil test that is left out would let everything pass: nothing sets its function.
    let idle = idle_of_lists(&lists(), amended, &own, in_place_of);
    assert_eq!(idle, ["LX07 1"]);
    let printed = ABufferOptions {
        reading: Reading::AsPrinted,
        ..amended
    };
    let own = [lindholm::MARKED];
    assert_eq!(idle_of_lists(&lists(), printed, &own, in_place_of), none);
    let own = [lindholm::COUNT_WHILE_FILLING];
    assert_eq!(idle_of_lists(&lists(), printed, &own, from_outside), none);
}

#[test]
fn a_misspelt_name_in_an_amendment_to_lists_is_refused() {
    const MISSPELT: [&[Amendment]; 2] = [
        &[changed(
            steps! { glDepthMask(false); },
            steps! { glBindTexture(onionskin::low_level::steps::Map::named("fragment couter")); },
        )],
        &[changed(
            steps! { glEnable(STENCIL_TEST); },
            steps! { glBindTexture(onionskin::low_level::steps::Map::named("list ancor")); },
        )],
    ];
    let context = Context::headless().unwrap();
    for (amendments, meant) in MISSPELT
        .into_iter()
        .zip(["'fragment counter'", "'list anchor'"])
    {
        let method = Method::ABuffer(ABufferOptions {
            amendments,
            pp_ao: true,
            ..options()
        });
        let mut renderer = Renderer::new(&context, 4, 2).unwrap();
        let error = renderer.render(&lists(), &method).unwrap_err().to_string();
        assert!(error.contains(meant), "{error}");
    }
}
