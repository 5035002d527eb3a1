//! Scenes and renderings of the claims of Everitt 2001.

use super::lists::Lists;
use super::stack::{self, Piece, Stack};
use onionskin::generate::{Soup, soup};
use onionskin::options::{Compositing, DepthPeelingOptions};
use onionskin::{Context, Frame, Layer, Method, Renderer, Rgba, Scene};
use proptest::test_runner::TestCaseError;

/// What an eye, or a file of 8 bits, can tell apart.
pub const VISIBLE: f64 = 1.0 / 255.0;

pub fn example(name: &str) -> Scene {
    super::render::example(name, [160, 120])
}

pub fn soup_scene(seed: u64) -> Scene {
    let parameters = Soup {
        seed,
        count: 900,
        ..Soup::default()
    };
    let mut scene = Scene::of("soup", vec![soup(&parameters).unwrap()]);
    scene.size = [120, 90];
    scene
}

pub fn piece(level: u16) -> Piece {
    Piece {
        level,
        color: [f32::from(level) / 1000.0, 0.5, 0.25, 0.5],
    }
}

pub fn limited(peels: u32) -> DepthPeelingOptions {
    DepthPeelingOptions {
        maximum_number_of_peels: peels,
        ..Default::default()
    }
}

pub fn keeping(peels: u32) -> DepthPeelingOptions {
    DepthPeelingOptions {
        compositing: Compositing::KeepLayers,
        ..limited(peels)
    }
}

pub fn render(context: &Context, scene: &Scene, method: Method) -> Frame {
    let [width, height] = scene.size;
    let mut renderer = Renderer::new(context, width, height).unwrap();
    renderer.render(scene, &method).unwrap()
}

pub fn peel(context: &Context, scene: &Scene, options: DepthPeelingOptions) -> Frame {
    render(context, scene, Method::DepthPeeling(options))
}

/// How many of the layers' depths and how many of their colours are not those of the lists; depths to the last bit.
pub fn disagreements(layers: &[Layer], lists: &Lists) -> (usize, usize) {
    let (mut depths, mut colors) = (0, 0);
    for (number, layer) in layers.iter().enumerate() {
        for (pixel, list) in lists.pixels.iter().enumerate() {
            let expected = list.get(number);
            let depth = expected.map_or(1.0, |fragment| fragment.depth);
            let color = expected.map_or(Rgba::default(), |fragment| fragment.color);
            depths += usize::from(layer.depth[pixel].to_bits() != depth.to_bits());
            colors += usize::from(!near(layer.color.pixels[pixel], color));
        }
    }
    (depths, colors)
}

/// The same colour by two programs, of which nobody promises the same last bit (only positions are invariant): a dozen
/// roundings of 2^-24 each.
pub fn near(a: Rgba, b: Rgba) -> bool {
    let (a, b) = (a.to_array(), b.to_array());
    a.iter().zip(b).all(|(a, b)| (a - b).abs() <= 1e-6)
}

/// The stack with the first `count` distinct levels of each pixel before the opaque surface, in their order.
pub fn nearest(stack: &Stack, count: u32) -> Stack {
    let mut kept = stack.clone();
    for pieces in &mut kept.pixels {
        pieces.retain(|piece| piece.level < stack.opaque.unwrap_or(u16::MAX));
        pieces.sort_by_key(|piece| piece.level);
        pieces.dedup_by_key(|piece| piece.level);
        pieces.truncate(count as usize);
    }
    kept
}

pub fn samples(layer: &Layer) -> usize {
    layer.depth.iter().filter(|&&depth| depth < 1.0).count()
}

/// Judges random stacks. A failure prints the smallest stack as fragment lists.
pub fn check_stacks(
    strategy: impl proptest::strategy::Strategy<Value = Stack>,
    cases: u32,
    judge: impl Fn(&Context, &Stack) -> Result<(), String>,
) {
    let context = Context::headless().unwrap();
    let outcome = stack::runner(cases).run(&strategy, |stack| {
        judge(&context, &stack).map_err(TestCaseError::fail)
    });
    stack::expect_none(outcome);
}
