//! What Everitt 2001 claims of his two depth units (E04, E05), each claim under its key.

use crate::kit::everitt_scenes::{disagreements, example, keeping, peel, piece, soup_scene};
use crate::kit::lists;
use crate::kit::lists::Lists;
use crate::kit::stack::Stack;
use onionskin::low_level::gl::{CapturedFragment, Geometry};
use onionskin::low_level::papers::{stage, vtk};
use onionskin::low_level::steps::{
    Call, Capability, Compare, DepthUnits, Machine, Map, Objects, Query, gl::*,
};
use onionskin::{Context, Format, Image, Scene};

#[test]
pub(crate) fn e04_a_shadow_lookup_passes_exactly_what_the_depth_comparison_passes() {
    let context = Context::headless().unwrap();
    // Map: levels 10 to 30, one pixel of the cleared depth 1. Quads: before, at, and behind the map's surface.
    let map = [20, 20, 20, 10, 30].map(|level| vec![piece(level)]);
    let map = Stack {
        width: 3,
        pixels: map.into_iter().chain([vec![]]).collect(),
        opaque: None,
    };
    let drawn = Stack {
        pixels: [10, 20, 30, 10, 30, 999]
            .map(|level| vec![piece(level)])
            .to_vec(),
        ..map.clone()
    };
    for func in COMPARISONS {
        let survivors = survivors(&context, &map.scene(), &drawn.scene(), func);
        let level = |stack: &Stack, pixel: usize| {
            stack.pixels[pixel]
                .first()
                .map_or(u16::MAX, |piece| piece.level)
        };
        let expected: Vec<_> = (0..6)
            .map(|pixel| func.holds(level(&drawn, pixel), level(&map, pixel)))
            .collect();
        assert_eq!(survivors.pixels, expected, "{func:?}");
    }
}

#[test]
pub(crate) fn e04_the_comparison_is_of_every_bit_of_the_depth() {
    // A soup against its own nearest depths: most fragments are behind, and the nearest are on the razor's edge.
    let context = Context::headless().unwrap();
    let scene = soup_scene(5);
    let lists = Lists::of(&context, &scene);
    let mut counts = Vec::new();
    for func in COMPARISONS {
        let survive = |list: &Vec<CapturedFragment>| {
            let holds = |fragment: &&CapturedFragment| func.holds(fragment.depth, list[0].depth);
            list.iter().filter(holds).count() as u64
        };
        let expected: u64 = lists.pixels.iter().map(survive).sum();
        let survivors = survivors(&context, &scene, &scene, func);
        assert_eq!(survivors.samples, expected, "{func:?}");
        counts.push(expected);
    }
    // NEVER, LESS and the rest in GL's order: the scene tells all kinds of comparison apart but NEVER from LESS, which
    // the test above does.
    let [
        never,
        less,
        equal,
        lequal,
        greater,
        notequal,
        gequal,
        always,
    ] = counts[..]
    else {
        panic!("eight comparisons")
    };
    assert_eq!((never, less), (0, 0));
    assert_eq!((lequal, notequal, gequal), (equal, greater, always));
    assert!(0 < equal && equal < greater && greater < always);
}

#[test]
pub(crate) fn e05_the_peeling_buffer_is_the_camera_s_own_depth_buffer() {
    let context = Context::headless().unwrap();
    for scene in [soup_scene(3), example("teapot")] {
        let lists = Lists::of(&context, &scene);
        let [width, height] = scene.size;
        let frame = peel(&context, &scene, keeping(1));
        let depth = &frame.layers[0].depth;
        assert_eq!(depth.len(), (width * height) as usize);
        let nearest: Vec<f32> = lists
            .pixels
            .iter()
            .map(|list| list.first().map_or(1.0, |fragment| fragment.depth))
            .collect();
        assert!(*depth == nearest, "{}", scene.name);
        // Turned upside down it would be another one.
        let upside_down: Vec<f32> = depth
            .chunks_exact(width as usize)
            .rev()
            .flatten()
            .copied()
            .collect();
        assert!(upside_down != nearest, "{}", scene.name);
    }
}

#[test]
pub(crate) fn e05_every_pixel_looks_up_its_own_texel_whatever_the_size() {
    let context = Context::headless().unwrap();
    // A lookup that hit a neighbour would peel too much or too little where depths change from pixel to pixel.
    for size in [[1021, 3], [3, 1021], [127, 61], [1, 1]] {
        let mut scene = soup_scene(9);
        scene.size = size;
        let lists = Lists::of(&context, &scene);
        let distinct = lists.clone().distinct();
        let frame = peel(&context, &scene, keeping(0));
        assert_eq!(
            frame.stats.lost,
            Some(lists.count() - distinct.count()),
            "{size:?}"
        );
        assert_eq!(disagreements(&frame.layers, &distinct), (0, 0), "{size:?}");
    }
}

const COMPARISONS: [Compare; 8] = [
    NEVER, LESS, EQUAL, LEQUAL, GREATER, NOTEQUAL, GEQUAL, ALWAYS,
];

struct Survivors {
    /// Whether each pixel has been drawn, row by row from the top.
    pixels: Vec<bool>,
    /// How many fragments have been drawn.
    samples: u64,
}

/// Draws one scene against the depths of another, with depth unit 0 alone.
fn survivors(context: &Context, depths: &Scene, drawn: &Scene, func: Compare) -> Survivors {
    const MAP: Map = Map::named("map");
    const QUERY: Query = Query("survivors");
    let mut machine = lists::machine(context, depths);
    machine.allocate(MAP, Format::Depth32FStencil8).unwrap();
    machine
        .allocate(vtk::COLOR_BUFFER, Format::Rgba32F)
        .unwrap();
    machine
        .framebuffer(stage::PEEL, Some(vtk::COLOR_BUFFER), Some(MAP))
        .unwrap();
    for call in [
        Call::BindFramebuffer {
            framebuffer: stage::PEEL,
        },
        Call::Clear {
            mask: COLOR_AND_DEPTH_BUFFER_BITS,
        },
        Call::Enable {
            cap: Capability::DepthTest,
        },
        Call::UseProgram {
            program: stage::SURFACE,
        },
        Call::Draw {
            objects: Objects::Scene,
        },
        Call::Disable {
            cap: Capability::DepthTest,
        },
    ] {
        machine.perform(&call).unwrap();
    }
    machine.set_geometry(Geometry::upload(context, drawn, drawn.size).unwrap());
    // Not attached while it is looked up.
    machine
        .framebuffer(stage::PEEL, Some(vtk::COLOR_BUFFER), None)
        .unwrap();
    let mut units = DepthUnits::new(&mut machine);
    for call in [
        Call::Clear {
            mask: COLOR_BUFFER_BIT,
        },
        Call::UseProgram {
            program: stage::PEEL_SURFACE,
        },
        Call::ActiveDepthUnit { unit: 0 },
        Call::BindDepthBuffer { buffer: MAP },
        Call::DepthFunc { func },
        Call::Enable {
            cap: Capability::DepthTest,
        },
        Call::ActiveDepthUnit { unit: 1 },
        Call::BeginQuery { query: QUERY },
        Call::Draw {
            objects: Objects::Scene,
        },
        Call::EndQuery { query: QUERY },
    ] {
        units.perform(&call).unwrap();
    }
    let samples = units.samples(QUERY).unwrap();
    let [width, height] = machine.size();
    let texels = machine.read_colors(vtk::COLOR_BUFFER).unwrap();
    let image = Image::from_bottom_up(width, height, &texels);
    Survivors {
        pixels: image.pixels.iter().map(|pixel| pixel.a > 0.0).collect(),
        samples,
    }
}
