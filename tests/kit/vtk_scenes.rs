//! Scenes and renderings of the claims of VTK's page.

use super::bounds::F32;
use super::stack::{Piece, Stack};
use onionskin::generate::{Soup, soup};
use onionskin::options::{Compositing, DepthPeelingOptions};
use onionskin::{Comparison, Context, Frame, Method, Renderer, Scene};

pub const BOTH: [Compositing; 2] = [Compositing::OnTheFly, Compositing::KeepLayers];

/// Six pixels with 4, 3, 2, 2, 1 and 1 fragments, so that the layers have 6, 4, 2 and 1 pixels; at levels 100, 200,
/// 300 and 400, submitted back to front.
pub fn staircase() -> Stack {
    let pixels =
        [4, 3, 2, 2, 1, 1].map(|count| (1..=count).rev().map(|n| piece(n * 100)).collect());
    Stack {
        width: 3,
        pixels: pixels.to_vec(),
        opaque: None,
    }
}

pub fn piece(level: u16) -> Piece {
    Piece {
        level,
        color: [f32::from(level) / 1000.0, 0.5, 0.25, 0.5],
    }
}

/// The stack with the first `count` levels of each pixel.
pub fn nearest(stack: &Stack, count: u32) -> Stack {
    let mut kept = stack.clone();
    for pieces in &mut kept.pixels {
        pieces.sort_by_key(|piece| piece.level);
        pieces.truncate(count as usize);
    }
    kept
}

pub fn soup_scene() -> Scene {
    let mut scene = Scene::of("soup", vec![soup(&Soup::default()).unwrap()]);
    scene.size = [120, 90];
    scene
}

pub fn limited(peels: u32, compositing: Compositing) -> DepthPeelingOptions {
    DepthPeelingOptions {
        maximum_number_of_peels: peels,
        compositing,
        ..Default::default()
    }
}

pub fn render(context: &Context, scene: &Scene, options: DepthPeelingOptions) -> Frame {
    let [width, height] = scene.size;
    let mut renderer = Renderer::new(context, width, height).unwrap();
    renderer
        .render(scene, &Method::DepthPeeling(options))
        .unwrap()
}

pub fn peel(context: &Context, stack: &Stack, options: DepthPeelingOptions) -> Frame {
    render(context, &stack.scene(), options)
}

/// How many pixels of the frame are not the stack's.
pub fn over(frame: &Frame, stack: &Stack) -> usize {
    Comparison::new(&frame.image, &stack.expected(), F32)
        .unwrap()
        .over
}
