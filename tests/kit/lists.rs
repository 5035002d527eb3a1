//! Every pixel's fragments, nearest first: captured from GL, sorted here.

use onionskin::low_level::gl::{CapturedFragment, Geometry, GlMachine, capture};
use onionskin::low_level::methods::allocate_maps;
use onionskin::low_level::papers::stage;
use onionskin::low_level::steps::{Variables, run};
use onionskin::{Context, Format, Result, Scene};

/// The lists of an image.
#[derive(Clone, Debug)]
pub struct Lists {
    pub width: u32,
    pub height: u32,
    /// Row by row from the top; a pixel's fragments by depth, those of equal depth by order of submission.
    pub pixels: Vec<Vec<CapturedFragment>>,
}

impl Lists {
    /// Captures a scene.
    pub fn of(context: &Context, scene: &Scene) -> Self {
        let [width, height] = scene.size;
        let mut pixels = vec![Vec::new(); (width * height) as usize];
        for fragment in captured(context, scene, u32::MAX).unwrap() {
            let row = height - 1 - fragment.y;
            pixels[(row * width + fragment.x) as usize].push(fragment);
        }
        for list in &mut pixels {
            list.sort_by(nearer);
        }
        Self {
            width,
            height,
            pixels,
        }
    }

    /// The same with one fragment of each depth, the first submitted.
    pub fn distinct(mut self) -> Self {
        for list in &mut self.pixels {
            list.dedup_by(|later, first| later.depth == first.depth);
        }
        self
    }

    /// How many fragments there are.
    pub fn count(&self) -> u64 {
        self.pixels.iter().map(|list| list.len() as u64).sum()
    }

    /// How many pixels have a fragment number `layer`, from 0.
    pub fn samples(&self, layer: usize) -> u64 {
        self.pixels.iter().filter(|list| list.len() > layer).count() as u64
    }

    /// The longest list.
    pub fn complexity(&self) -> usize {
        self.pixels.iter().map(Vec::len).max().unwrap_or(0)
    }
}

/// Every fragment before the opaque surfaces, unordered, with at most `limit` in GL's memory at a time.
pub fn captured(context: &Context, scene: &Scene, limit: u32) -> Result<Vec<CapturedFragment>> {
    let mut machine = machine(context, scene);
    run(&stage::OPAQUE_FIRST, &[], Variables::new(), &mut machine)?;
    capture(&mut machine, stage::OPAQUE_DEPTH, limit)
}

/// A machine that is ready to draw the scene into the target [`stage::IMAGE`].
pub fn machine<'c>(context: &'c Context, scene: &Scene) -> GlMachine<'c> {
    let mut machine = GlMachine::new(context, scene.size).unwrap();
    let (color, depth) = (Format::Rgba32F, Format::Depth32FStencil8);
    allocate_maps(&mut machine, &[&stage::RESOURCES], color, depth).unwrap();
    machine.set_geometry(Geometry::upload(context, scene, scene.size).unwrap());
    machine.begin_frame();
    machine
}

/// By pixel, then as the oracle sorts.
pub fn sorted(mut fragments: Vec<CapturedFragment>) -> Vec<CapturedFragment> {
    fragments.sort_unstable_by(|a, b| (a.y, a.x).cmp(&(b.y, b.x)).then(nearer(a, b)));
    fragments
}

/// How many of the sorted fragments have exactly the depth of an earlier one of their pixel.
pub fn ties(sorted: &[CapturedFragment]) -> u64 {
    let tie = |pair: &&[CapturedFragment]| {
        (pair[0].x, pair[0].y, pair[0].depth) == (pair[1].x, pair[1].y, pair[1].depth)
    };
    sorted.windows(2).filter(tie).count() as u64
}

fn nearer(a: &CapturedFragment, b: &CapturedFragment) -> std::cmp::Ordering {
    a.depth.total_cmp(&b.depth).then(a.order.cmp(&b.order))
}
