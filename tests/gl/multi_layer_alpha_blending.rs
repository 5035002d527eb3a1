//! Against the algorithm in f64, which shares nothing with the shaders, and against the exact image.

use glam::DVec3;
use onionskin::low_level::fragment::Rgba;
use onionskin::low_level::methods::{CountBy, MultiLayerOptions, Nodes, Technique};
use onionskin::low_level::scene::{Camera, Mesh, Scene, Vertex};
use onionskin::{Context, Frame, Image, Method, Renderer};

use crate::kit::chance::Chance;
use crate::kit::changed::{Change, with_change};

/// What a fragment adds to the error of a channel, at most. It is interpolated (4 roundings each for colour and opacity),
/// premultiplied, its transmittance taken and both packed (4), perhaps merged and packed again (3 and 2), and composited
/// (3): 20 roundings of 2^-24, of values of at most 1 that are multiplied by at most 1.
const BOUND_OF_A_FRAGMENT: f64 = 20.0 / (1 << 24) as f64;

const SIDE: u32 = 16;
const WALL: [f64; 3] = [0.25, 0.5, 0.75];
const ALL: [Nodes; 2] = [Nodes::Four, Nodes::Eight];

const INSERT: &str = "multi_layer/insert.frag";
const NODE: &str = "multi_layer/node.glsl";

/// A triangle that faces an eye that looks along -z.
#[derive(Clone, Copy, Debug)]
struct Sheet {
    distance: f64,
    /// How far it is moved, in parts of its distance. It fills the view if that is nothing.
    shift: [f64; 2],
    color: [f32; 3],
    alpha: f32,
}

/// Sheets that fill the view, in a random order, each at a distance of its own. So much comes through each that the last
/// ones can be seen.
fn stack(chance: &mut Chance, count: usize) -> Vec<Sheet> {
    let mut sheets: Vec<Sheet> = Vec::new();
    for number in 0..count {
        let sheet = Sheet {
            distance: 2.0 + number as f64,
            shift: [0.0; 2],
            color: [(); 3].map(|()| part(chance)),
            alpha: part(chance) / 2.0,
        };
        let place = chance.below(number + 1);
        sheets.insert(place, sheet);
    }
    sheets
}

/// From 0 to 1, in steps that f32 has.
fn part(chance: &mut Chance) -> f32 {
    chance.below(257) as f32 / 256.0
}

/// The sheets are submitted in their order.
fn scene(sheets: &[Sheet]) -> Scene {
    let mesh = |sheet: &Sheet| {
        let [r, g, b] = sheet.color;
        let corner = |x: f64, y: f64| Vertex {
            position: DVec3::new(2.0 * x + sheet.shift[0], 2.0 * y + sheet.shift[1], -1.0)
                * sheet.distance,
            color: Rgba::new(r, g, b, sheet.alpha),
            ..Vertex::default()
        };
        Mesh {
            vertices: vec![corner(-1.0, -1.0), corner(1.0, -1.0), corner(0.0, 2.0)],
            triangles: vec![[0, 1, 2]],
            ..Mesh::default()
        }
    };
    let mut scene = Scene::of("sheets", sheets.iter().map(mesh).collect());
    scene.size = [SIDE; 2];
    scene.background = WALL.map(|channel| channel as f32);
    scene.camera = Camera {
        eye: DVec3::ZERO,
        target: DVec3::NEG_Z,
        up: DVec3::Y,
        fov: 40.0,
        near: 1.0,
        far: 30.0,
    };
    scene
}

/// Nothing on a driver that does not run the method.
fn renderer(context: &Context) -> Option<Renderer<'_>> {
    let entry = MultiLayerOptions::default().entry();
    if !entry.runs_on(context.driver()) {
        println!("skipped: this driver has none of {:?}", entry.needs);
        return None;
    }
    Some(
        Renderer::new(context, SIDE, SIDE)
            .unwrap()
            .with_given_planes(),
    )
}

fn frame(renderer: &mut Renderer<'_>, sheets: &[Sheet], nodes: Nodes) -> Frame {
    let method = MultiLayerOptions {
        nodes,
        ..MultiLayerOptions::default()
    };
    let frame = renderer.render(&scene(sheets), &method).unwrap();
    assert_eq!(frame.stats.lost, Some(0));
    assert_eq!(frame.stats.geometry_passes, 1);
    frame
}

fn rendered(renderer: &mut Renderer<'_>, sheets: &[Sheet], nodes: Nodes) -> Image {
    frame(renderer, sheets, nodes).image
}

/// A stack's colour, which is the same at every pixel.
fn color(image: &Image) -> [f64; 3] {
    let Rgba { r, g, b, a } = image.pixels[27];
    assert_eq!(a, 1.0);
    [r, g, b].map(f64::from)
}

/// The algorithm's node: depth, premultiplied colour and transmittance.
type Node = (f64, [f64; 3], f64);

/// The algorithm, over the wall.
fn model(sheets: &[Sheet], most: usize) -> [f64; 3] {
    model_and_merged(sheets, most).0
}

/// And how many nodes it has merged into another.
fn model_and_merged(sheets: &[Sheet], most: usize) -> ([f64; 3], u64) {
    let under = |(depth, near, through): Node, (_, far, rest): Node| {
        let color = [0, 1, 2].map(|channel| near[channel] + through * far[channel]);
        (depth, color, through * rest)
    };
    let mut nodes: Vec<Node> = Vec::new();
    let mut merged = 0;
    for sheet in sheets {
        let alpha = f64::from(sheet.alpha);
        let color = sheet.color.map(|channel| f64::from(channel) * alpha);
        let place = nodes.partition_point(|(depth, ..)| *depth <= sheet.distance);
        nodes.insert(place, (sheet.distance, color, 1.0 - alpha));
        if nodes.len() > most {
            let farthest = nodes.pop().unwrap();
            let last = nodes.pop().unwrap();
            nodes.push(under(last, farthest));
            merged += 1;
        }
    }
    nodes.push((f64::INFINITY, WALL, 0.0));
    (nodes.into_iter().reduce(under).unwrap().1, merged)
}

fn bound(sheets: &[Sheet]) -> f64 {
    BOUND_OF_A_FRAGMENT * (sheets.len() + 1) as f64
}

fn off(a: [f64; 3], b: [f64; 3]) -> f64 {
    let differences = a.iter().zip(b).map(|(a, b)| (a - b).abs());
    // Not a number stays one.
    differences.fold(0.0, |most, off| if off <= most { most } else { off })
}

#[test]
fn the_image_of_random_stacks_is_the_algorithms() {
    let context = Context::headless().unwrap();
    let Some(mut renderer) = renderer(&context) else {
        return;
    };
    let mut chance = Chance::new(1);
    for nodes in ALL {
        let mut most = 0.0_f64;
        for (count, pairs) in (1..=20).flat_map(|count| [(count, false), (count, true)]) {
            let mut sheets = stack(&mut chance, count);
            for sheet in sheets.iter_mut().filter(|_| pairs) {
                sheet.distance = 2.0 + (sheet.distance / 2.0).floor();
            }
            let frame = frame(&mut renderer, &sheets, nodes);
            let (expected, merged) = model_and_merged(&sheets, nodes as usize);
            let off = off(color(&frame.image), expected);
            assert!(off <= bound(&sheets), "{nodes:?}: {off} with {sheets:?}");
            let pixels = u64::from(SIDE * SIDE);
            assert_eq!(frame.stats.merged, Some(pixels * merged), "{sheets:?}");
            most = most.max(off);
        }
        println!("{nodes:?}: off by at most {most:.1e}");
    }
}

#[test]
fn a_changed_word_in_the_shaders_or_another_count_of_nodes_is_noticed() {
    const CHANGES: [Change; 7] = [
        [INSERT, "farther.x < here.x", "farther.x > here.x"],
        [INSERT, "straight.rgb * straight.a,", "straight.rgb,"],
        [
            INSERT,
            "merged(node_of(nodes[NODES - 1]), node_of(farther))",
            "node_of(nodes[NODES - 1])",
        ],
        [NODE, "Node(near.depth,", "Node(far.depth,"],
        [
            NODE,
            "near.transmittance * far.transmittance)",
            "near.transmittance)",
        ],
        [
            NODE,
            "near.color + near.transmittance * far.color",
            "near.color + far.color",
        ],
        [NODE, "bytes.y << 8", "bytes.y << 9"],
    ];
    let context = Context::headless().unwrap();
    if renderer(&context).is_none() {
        return;
    }
    let mut chance = Chance::new(2);
    let stacks: Vec<_> = (0..16).map(|_| stack(&mut chance, 12)).collect();
    let most_off = |renderer: &mut Renderer<'_>, nodes, expected: usize| {
        let off = stacks.iter().map(|sheets| {
            let found = color(&rendered(renderer, sheets, nodes));
            off(found, model(sheets, expected)) / bound(sheets)
        });
        off.fold(0.0, |a: f64, b| if b <= a { a } else { b })
    };
    let with = |change, nodes, expected| {
        let mut changed = with_change(renderer(&context).unwrap(), change);
        most_off(&mut changed, nodes, expected)
    };
    for nodes in ALL {
        let unchanged = [NODE, "bytes.y << 8", "bytes.y << 8"];
        assert!(with(unchanged, nodes, nodes as usize) <= 1.0);
        assert!(with(unchanged, nodes, nodes as usize - 1) > 100.0);
        for change in CHANGES {
            let off = with(change, nodes, nodes as usize);
            assert!(off.is_nan() || off > 100.0, "{nodes:?}: {change:?}: {off}");
        }
    }
}

#[test]
fn a_changed_word_in_the_count_of_what_was_merged_is_noticed() {
    let context = Context::headless().unwrap();
    if renderer(&context).is_none() {
        return;
    }
    let mut chance = Chance::new(7);
    let sheets = stack(&mut chance, 6);
    for (change, merged) in [
        (["multi_layer/taken.frag", "== NO_DEPTH", "== NO_DEPTH"], 2),
        (["multi_layer/taken.frag", "== NO_DEPTH", "!= NO_DEPTH"], 6),
    ] {
        let mut renderer = with_change(renderer(&context).unwrap(), change);
        let counted = frame(&mut renderer, &sheets, Nodes::Four).stats.merged;
        assert_eq!(counted, Some(u64::from(SIDE * SIDE) * merged), "{change:?}");
    }
    let without_costs = renderer(&context).unwrap().without_costs();
    let mut renderer = without_costs;
    let stats = frame(&mut renderer, &sheets, Nodes::Four).stats;
    assert_eq!(stats.merged, None);
}

/// Pixels with more fragments than nodes stand beside them, and differ.
#[test]
fn a_pixel_with_no_more_fragments_than_nodes_is_exact() {
    let context = Context::headless().unwrap();
    let Some(mut renderer) = renderer(&context) else {
        return;
    };
    let mut chance = Chance::new(3);
    for nodes in ALL {
        let mut pixels = [0; 2];
        let mut inexact = 0;
        for _ in 0..6 {
            let mut sheets = stack(&mut chance, 24);
            for sheet in &mut sheets {
                sheet.shift = [(); 2].map(|()| 6.0 * f64::from(part(&mut chance)) - 3.0);
            }
            let scene = scene(&sheets);
            let exact = renderer.render(&scene, &Method::Exact).unwrap().image;
            let counted = renderer.complexity(&scene, CountBy::default()).unwrap();
            let frame = frame(&mut renderer, &sheets, nodes);
            // A pixel keeps as many fragments as it has nodes.
            let beyond = |&count: &u32| u64::from(count.saturating_sub(nodes as u32));
            let merged = counted.counts.iter().map(beyond).sum();
            assert_eq!(frame.stats.merged, Some(merged));
            let both = frame.image.pixels.iter().zip(&exact.pixels);
            for ((found, exact), &fragments) in both.zip(&counted.counts) {
                let [found, exact] = [found, exact].map(|p| [p.r, p.g, p.b].map(f64::from));
                let off = off(found, exact);
                let is_exact = off <= bound(&sheets);
                let fits = fragments <= nodes as u32;
                assert!(is_exact || !fits, "{nodes:?}, {fragments} fragments: {off}");
                pixels[usize::from(fits)] += u32::from(fragments > 0);
                inexact += u32::from(!is_exact);
            }
        }
        let [more, fit] = pixels;
        println!("{nodes:?}: {fit} pixels fit, {more} do not, {inexact} of them are inexact");
        assert!(fit > 100 && more > 100 && inexact > 0);
    }
}

#[test]
fn the_order_of_submission_makes_a_difference_only_beyond_the_nodes() {
    let context = Context::headless().unwrap();
    let Some(mut renderer) = renderer(&context) else {
        return;
    };
    let mut chance = Chance::new(4);
    for nodes in ALL {
        let most = nodes as usize;
        for (count, differs) in [(most, false), (most + 4, true)] {
            let mut sheets = stack(&mut chance, count);
            sheets.sort_by(|a, b| a.distance.total_cmp(&b.distance));
            for sheet in &mut sheets {
                sheet.alpha = 0.5;
            }
            let forward = rendered(&mut renderer, &sheets, nodes);
            let mut rotated = sheets.clone();
            rotated.rotate_left(count / 2);
            let rotated = rendered(&mut renderer, &rotated, nodes);
            // Every other one fills the nodes before those between come.
            sheets.sort_by_key(|sheet| sheet.distance as u32 % 2);
            let alternating = rendered(&mut renderer, &sheets, nodes);
            let same = forward == rotated && rotated == alternating;
            assert_eq!(same, !differs, "{nodes:?}, {count} sheets");
        }
    }
}

#[test]
fn of_fragments_at_one_depth_the_first_submitted_lies_in_front() {
    let context = Context::headless().unwrap();
    if renderer(&context).is_none() {
        return;
    }
    let mut chance = Chance::new(6);
    let mut sheets = stack(&mut chance, 4);
    // The last one comes in front of the others and moves them.
    for (sheet, distance) in sheets.iter_mut().zip([7.0, 7.0, 7.0, 3.0]) {
        sheet.distance = distance;
    }
    let off = |to, nodes| {
        let change = [INSERT, "moves || farther.x < here.x", to];
        let mut changed = with_change(renderer(&context).unwrap(), change);
        let found = rendered(&mut changed, &sheets, nodes);
        off(color(&found), model(&sheets, nodes as usize))
    };
    for nodes in ALL {
        assert!(off("moves || farther.x < here.x", nodes) <= bound(&sheets));
        for change in ["moves || farther.x <= here.x", "farther.x < here.x"] {
            let off = off(change, nodes);
            assert!(off > 100.0 * bound(&sheets), "{nodes:?}: {change}: {off}");
        }
    }
}

/// What comes through to the wall is a product, whatever was merged: black sheets show it.
#[test]
fn what_comes_through_is_right_beyond_the_nodes() {
    let context = Context::headless().unwrap();
    let Some(mut renderer) = renderer(&context) else {
        return;
    };
    let mut chance = Chance::new(5);
    let mut sheets = stack(&mut chance, 20);
    for sheet in &mut sheets {
        sheet.color = [0.0; 3];
        sheet.alpha *= 0.25;
    }
    let clear: f64 = sheets
        .iter()
        .map(|sheet| 1.0 - f64::from(sheet.alpha))
        .product();
    for nodes in ALL {
        let found = color(&rendered(&mut renderer, &sheets, nodes));
        let off = off(found, WALL.map(|channel| channel * clear));
        assert!(off <= bound(&sheets), "{nodes:?}: {off}");
    }
}

#[test]
fn a_count_of_nodes_that_is_neither_is_refused() {
    let mut method = Method::MultiLayerAlphaBlending(MultiLayerOptions::default());
    method.choose("nodes", "8").unwrap();
    assert_eq!(
        method,
        Method::MultiLayerAlphaBlending(MultiLayerOptions {
            nodes: Nodes::Eight,
            ..MultiLayerOptions::default()
        })
    );
    let error = method.choose("nodes", "5").unwrap_err().to_string();
    assert!(error.contains("Known are: 4, 8"), "{error}");
}
