//! How exact compositing is, and how many layers are enough (E12, E13).

use crate::kit::driver::rounds_each_operation;
use crate::kit::figures::expect_figures;
use onionskin::generate::{Quads, SubmissionOrder, quads};
use onionskin::options::DepthPeelingOptions;
use onionskin::{Comparison, Context, Format, Frame, Method, Renderer, Scene};

const D32F: Format = Format::Depth32FStencil8;

#[test]
pub(crate) fn e12_the_accumulator_s_error_grows_with_depth_complexity_and_with_its_step() {
    // n quads of one opacity, front to back. Each layer rounds to half a step at most: of 2^-8 in bytes; of 2^-11, for
    // numbers from 1/2 up, in 16-bit floats; of 2^-24 in 32-bit ones.
    let context = Context::headless().unwrap();
    let mut previous = [0.0; 3];
    for count in [4_u32, 16, 64, 128] {
        let scene = quad_scene(count);
        let exact = render(&context, &scene, &Method::Exact, Format::Rgba32F, D32F);
        let formats = [
            (Format::Rgba8, 0.5 / 255.0),
            (Format::Rgba16F, 0.5 * 2.0_f64.powi(-11)),
            (Format::Rgba32F, 0.5 * 2.0_f64.powi(-24)),
        ];
        let errors = formats.map(|(format, half_step)| {
            let method = Method::DepthPeeling(DepthPeelingOptions::default());
            let image = render(&context, &scene, &method, format, D32F).image;
            let error = Comparison::new(&image, &exact.image, 0.0).unwrap().max;
            // The fragment's own colour is stored, multiplied, added: three roundings a layer, and the final blend.
            let bound = half_step * f64::from(3 * count + 3);
            assert!(
                error <= bound,
                "{format:?}, {count} layers: {error:e} > {bound:e}"
            );
            error
        });
        println!(
            "{count:4} layers: RGBA8 {:.2e}, RGBA16F {:.2e}, RGBA32F {:.2e}",
            errors[0], errors[1], errors[2]
        );
        assert!(errors[0] > errors[1] && errors[1] > errors[2]);
        if count == 128 && rounds_each_operation(&context) {
            assert!(errors[0] > previous[0] && errors[0] > 0.02, "{errors:?}");
        }
        if count == 4 {
            previous = errors;
        }
    }
}

#[test]
pub(crate) fn e13_three_layers_in_numbers() {
    // rms error after k layers, in channels of 0 to 1. 'Good enough' here: under 1/255, what a byte can tell apart, or
    // not.
    let context = Context::headless().unwrap();
    let good_enough = |name: &str, scene: &Scene| {
        let exact = render(&context, scene, &Method::Exact, Format::Rgba32F, D32F).image;
        let errors: Vec<_> = (1..=8)
            .map(|peels| {
                let method = Method::DepthPeeling(DepthPeelingOptions {
                    maximum_number_of_peels: peels,
                    ..Default::default()
                });
                let image = render(&context, scene, &method, Format::Rgba32F, D32F).image;
                Comparison::new(&image, &exact, 0.0).unwrap().rms
            })
            .collect();
        let text: Vec<_> = errors.iter().map(|rms| format!("{:.4}", rms)).collect();
        println!("{name:<10} {}", text.join(" "));
        assert!(
            errors.windows(2).all(|pair| pair[1] <= pair[0] * 1.001),
            "{errors:?}"
        );
        match name {
            "teapot" => expect_figures("E13", 0, &errors[..4]),
            "molecule" => expect_figures("E13", 1, &errors[..4]),
            _ => {}
        }
        errors
            .iter()
            .position(|&rms| rms < 1.0 / 255.0)
            .map(|at| at + 1)
    };
    let teapot = good_enough("teapot", &example("teapot"));
    let molecule = good_enough("molecule", &example("molecule"));
    let knots = good_enough("knots", &example("knots"));
    let soup = good_enough("soup", &example("soup"));
    println!("{teapot:?} {molecule:?} {knots:?} {soup:?}");
    // So three layers are enough for the paper's kind of scene and for no other.
    assert!(teapot.is_some_and(|layers| layers <= 4));
    assert!(molecule.is_none_or(|layers| layers > 4));
    assert!(soup.is_none_or(|layers| layers > 4));
}

fn quad_scene(count: u32) -> Scene {
    let parameters = Quads {
        count,
        alpha: 0.02,
        order: SubmissionOrder::Shuffled,
        ..Quads::default()
    };
    let mut scene = Scene::of("quads", vec![quads(&parameters).unwrap()]);
    scene.size = [40, 30];
    scene.background = [1.0; 3];
    scene
}

fn example(name: &str) -> Scene {
    crate::kit::render::example(name, [160, 120])
}

fn render(
    context: &Context,
    scene: &Scene,
    method: &Method,
    color: Format,
    depth: Format,
) -> Frame {
    let [width, height] = scene.size;
    let renderer = Renderer::new(context, width, height).unwrap();
    let mut renderer = renderer.with_formats(color, depth);
    renderer.render(scene, method).unwrap()
}
