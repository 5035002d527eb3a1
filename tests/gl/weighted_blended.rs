//! Against equations 6 to 10 in f64, which share nothing with the shaders.

use glam::DVec3;

use onionskin::low_level::fragment::Rgba;
use onionskin::low_level::methods::{Weight, WeightedBlendedOptions};
use onionskin::low_level::scene::{Camera, Mesh, Scene, Vertex};
use onionskin::{Context, Method, Renderer};

use crate::kit::changed::{Change, with_change};

/// Fourteen roundings of 2^-24 in each weight and its colour, as many in the sums of six fragments, and the rasteriser's
/// 1/w to 2^-20 of itself, of which a weight has up to the sixth power: 6 x 2^-20 + 28 x 2^-24 = 8e-6.
const BOUND: f64 = 8e-6;

const NEAR: f64 = 1.0;
const FAR: f64 = 300.0;
const WALL: [f64; 3] = [0.25, 0.5, 0.75];

/// How far away, the colour, the opacity.
type Sheet = (f64, [f32; 3], f32);

const SHEETS: [Sheet; 6] = [
    (80.0, [0.9, 0.1, 0.2], 0.7),
    (3.0, [0.1, 0.8, 0.3], 0.2),
    (7.5, [0.2, 0.3, 1.0], 0.5),
    (7.0, [1.0, 1.0, 0.0], 0.05),
    (220.0, [0.0, 0.6, 0.6], 0.9),
    (30.0, [0.5, 0.5, 0.5], 0.4),
];

/// Sheets that fill the view of an eye that looks along -z, submitted in this order.
fn scene(sheets: &[Sheet]) -> Scene {
    let mesh = |&(distance, [r, g, b], alpha): &Sheet| {
        let side = 2.0 * distance;
        let corner = |x: f64, y: f64| Vertex {
            position: DVec3::new(x * side, y * side, -distance),
            color: Rgba::new(r, g, b, alpha),
            ..Vertex::default()
        };
        Mesh {
            vertices: vec![corner(-1.0, -1.0), corner(1.0, -1.0), corner(0.0, 2.0)],
            triangles: vec![[0, 1, 2]],
            ..Mesh::default()
        }
    };
    let mut scene = Scene::of("sheets", sheets.iter().map(mesh).collect());
    scene.size = [8, 8];
    scene.background = WALL.map(|channel| channel as f32);
    scene.camera = Camera {
        eye: DVec3::ZERO,
        target: DVec3::NEG_Z,
        up: DVec3::Y,
        fov: 40.0,
        near: NEAR,
        far: FAR,
    };
    scene
}

/// The image's colour, which is everywhere the same.
fn rendered(context: &Context, sheets: &[Sheet], method: &Method, change: Change) -> [f64; 3] {
    let renderer = Renderer::new(context, 8, 8).unwrap().with_given_planes();
    let frame = with_change(renderer, change)
        .render(&scene(sheets), method)
        .unwrap();
    assert_eq!(frame.stats.fragments, 64 * sheets.len() as u64);
    assert_eq!(frame.stats.lost, Some(0));
    assert_eq!(frame.stats.geometry_passes, 1);
    let Rgba { r, g, b, a } = frame.image.pixels[27];
    assert_eq!(a, 1.0);
    [r, g, b].map(f64::from)
}

fn method(weight: Weight) -> Method {
    Method::WeightedBlended(WeightedBlendedOptions { weight })
}

/// The paper's equations 7 to 10.
fn weight(equation: Weight, z: f64, alpha: f64) -> f64 {
    let far = (z / 200.0).powi(6);
    alpha
        * match equation {
            Weight::Equation7 => (10.0 / (1e-5 + (z / 5.0).powi(2) + far)).clamp(1e-2, 3e3),
            Weight::Equation8 => (10.0 / (1e-5 + (z / 10.0).powi(3) + far)).clamp(1e-2, 3e3),
            Weight::Equation9 => (0.03 / (1e-5 + (z / 200.0).powi(4))).clamp(1e-2, 3e3),
            Weight::Equation10 => {
                let depth = FAR / (FAR - NEAR) * (1.0 - NEAR / z);
                (3e3 * (1.0 - depth).powi(3)).max(1e-2)
            }
        }
}

/// Equation 6.
fn equation_6(equation: Weight, sheets: &[Sheet]) -> [f64; 3] {
    let (mut sum, mut opacity, mut through) = ([0.0; 3], 0.0, 1.0);
    for &(z, color, alpha) in sheets {
        let alpha = f64::from(alpha);
        let weight = weight(equation, z, alpha);
        for channel in 0..3 {
            sum[channel] += f64::from(color[channel]) * alpha * weight;
        }
        opacity += alpha * weight;
        through *= 1.0 - alpha;
    }
    [0, 1, 2].map(|c| sum[c] / opacity * (1.0 - through) + WALL[c] * through)
}

fn off(a: [f64; 3], b: [f64; 3]) -> f64 {
    let differences = a.iter().zip(b).map(|(a, b)| (a - b).abs());
    // Not a number stays one.
    differences.fold(0.0, |most, off| if off <= most { most } else { off })
}

const NONE: Change = [
    "weighted/accumulate.frag",
    "return 1.0 / gl_FragCoord.w;",
    "return 1.0 / gl_FragCoord.w;",
];
const ALL: [Weight; 4] = [
    Weight::Equation7,
    Weight::Equation8,
    Weight::Equation9,
    Weight::Equation10,
];

#[test]
fn the_image_is_equation_6_with_each_of_the_weights() {
    let context = Context::headless().unwrap();
    for equation in ALL {
        for count in 1..=SHEETS.len() {
            let sheets = &SHEETS[..count];
            let found = rendered(&context, sheets, &method(equation), NONE);
            let off = off(found, equation_6(equation, sheets));
            println!("{equation:?}, {count} sheets: {off:.1e}");
            assert!(off < BOUND, "{equation:?}, {count} sheets: {off}");
        }
    }
}

#[test]
fn a_changed_word_in_the_shaders_or_another_equation_is_noticed() {
    let context = Context::headless().unwrap();
    for change in [
        [
            NONE[0],
            "return 1.0 / gl_FragCoord.w;",
            "return gl_FragCoord.w;",
        ],
        [NONE[0], "* weight(straight.a);", ";"],
        [NONE[0], "straight.rgb * straight.a, ", "straight.rgb, "],
        [
            NONE[0],
            "revealage = vec4(straight.a)",
            "revealage = vec4(0.5)",
        ],
        ["weighted/composite.frag", "sums.rgb / sums.a", "sums.rgb"],
    ] {
        let equation = Weight::Equation7;
        let found = rendered(&context, &SHEETS, &method(equation), change);
        let off = off(found, equation_6(equation, &SHEETS));
        assert!(off > 10.0 * BOUND, "{change:?}: {off}");
    }
    for (a, b) in [(0, 1), (1, 2), (2, 3), (3, 0)] {
        let found = rendered(&context, &SHEETS, &method(ALL[a]), NONE);
        assert!(
            off(found, equation_6(ALL[b], &SHEETS)) > 10.0 * BOUND,
            "{a} {b}"
        );
    }
}

#[test]
fn one_layer_and_one_colour_are_exact_and_other_scenes_are_not() {
    let context = Context::headless().unwrap();
    let exact = |sheets: &[Sheet]| rendered_exactly(&context, sheets);
    let one_color = SHEETS.map(|(z, _, alpha)| (z, SHEETS[0].1, alpha));
    for equation in ALL {
        let method = method(equation);
        for sheets in [&SHEETS[..1], &SHEETS[3..4], &one_color] {
            let off = off(rendered(&context, sheets, &method, NONE), exact(sheets));
            assert!(off < BOUND, "{equation:?}: {off}");
        }
        let off = off(rendered(&context, &SHEETS, &method, NONE), exact(&SHEETS));
        println!("{equation:?}: off the exact image by {off:.2}");
        assert!(off > 0.01, "{equation:?}: {off}");
    }
}

/// The error is bounded: the mean lies among the fragments' colours, as the exact mixture does.
#[test]
fn no_channel_is_further_off_than_the_colours_are_apart() {
    let context = Context::headless().unwrap();
    let exact = rendered_exactly(&context, &SHEETS);
    let covered: f64 = 1.0
        - SHEETS
            .iter()
            .map(|(.., a)| f64::from(1.0 - a))
            .product::<f64>();
    for equation in ALL {
        let found = rendered(&context, &SHEETS, &method(equation), NONE);
        for channel in 0..3 {
            let of = |sheet: &Sheet| f64::from(sheet.1[channel]);
            let most = SHEETS.iter().map(of).fold(0.0, f64::max);
            let least = SHEETS.iter().map(of).fold(1.0, f64::min);
            let bound = covered * (most - least) + BOUND;
            assert!(
                (found[channel] - exact[channel]).abs() <= bound,
                "{equation:?}"
            );
        }
    }
}

#[test]
fn the_order_of_submission_makes_no_difference() {
    let context = Context::headless().unwrap();
    let mut reversed = SHEETS;
    reversed.reverse();
    for equation in ALL {
        let [forward, backward] =
            [SHEETS, reversed].map(|sheets| rendered(&context, &sheets, &method(equation), NONE));
        assert!(off(forward, backward) < BOUND, "{equation:?}");
    }
}

fn rendered_exactly(context: &Context, sheets: &[Sheet]) -> [f64; 3] {
    let mut renderer = Renderer::new(context, 8, 8).unwrap().with_given_planes();
    let image = renderer
        .render(&scene(sheets), &Method::Exact)
        .unwrap()
        .image;
    let Rgba { r, g, b, .. } = image.pixels[27];
    [r, g, b].map(f64::from)
}
