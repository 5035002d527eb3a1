//! Amendments that need OpenGL are small: one step less, and the frame is another. `tests/papers/smallest_change.rs` has
//! those that the emulated pixel runs.

use onionskin::low_level::gl::{Geometry, GlMachine};
use onionskin::low_level::methods::allocate_maps;
use onionskin::low_level::papers::carr_2008::ideal;
use onionskin::low_level::papers::everitt_2001::ALPHA;
use onionskin::low_level::papers::{stage, vtk};
use onionskin::low_level::steps::{Amendment, Variables, run};
use onionskin::options::{Compositing, DepthPeelingOptions, Reading};
use onionskin::{Context, Format, Frame, Method, Renderer, Scene};

use crate::kit::carr_scenes::is_ideal;
use crate::kit::peeling::peel;
use crate::kit::shortened::idle;
use crate::kit::stack::{Stack, scattered};

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
    let counted = (stats.iterations, stats.layers, stats.lost, stats.stopped);
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
    if is_ideal(&context) {
        for whole in [&ideal::AMENDMENTS[..], &ideal::TIGHT_BOUND_ON_GL] {
            let right = run(whole, false);
            let idle = idle(whole, |amendments| run(amendments, false) == right);
            assert_eq!(idle, Vec::<String>::new());
        }
    }
    if context.driver().quirks().runs_in_order {
        let whole = [&ideal::AMENDMENTS[..], &ideal::BY_IMAGES].concat();
        let right = run(&whole, true);
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
