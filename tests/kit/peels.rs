//! Fragment lists for the emulated pixel, what should become of them, and the peeling loops that run on them.

use onionskin::low_level::emulator::{AlgorithmRun, Emulator, Group, Surface, run_algorithm};
use onionskin::low_level::methods::allocate_maps;
use onionskin::low_level::oracle;
use onionskin::low_level::papers::carr_2008::{coherent, hybrid, ideal};
use onionskin::low_level::papers::stage;
use onionskin::low_level::steps::pseudo::Line;
use onionskin::low_level::steps::{
    Amendment, Listing, Machine, Map, Outcome, Resources, Variables, Workspace, run,
};
use onionskin::{Format, Fragment, Rgba};

use super::chance::Chance;

/// A pixel's surfaces in the order of submission.
pub type Pixel = Vec<Surface>;

/// A loop of Carr et al.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Loop {
    LayerPeeling,
    Hybrid,
    A,
    B,
}

pub const LOOPS: [Loop; 4] = [Loop::LayerPeeling, Loop::Hybrid, Loop::A, Loop::B];

/// The map that holds the finished image.
pub const IMAGE: Map = stage::IMAGE_COLOR;

impl Loop {
    pub fn listing(self) -> &'static Listing {
        match self {
            Self::LayerPeeling => &hybrid::LAYER_PEELING,
            Self::Hybrid => &hybrid::HYBRID,
            Self::A => &coherent::VARIANT_A,
            Self::B => &coherent::VARIANT_B,
        }
    }

    pub fn amendments(self) -> Vec<Amendment> {
        match self {
            Self::LayerPeeling | Self::Hybrid => hybrid::AMENDMENTS.to_vec(),
            Self::A | Self::B => coherent::AMENDMENTS.to_vec(),
        }
    }

    /// All amendments but those with this key: what goes wrong without them?
    pub fn without(self, key: &str) -> Vec<Amendment> {
        let all = self.amendments();
        let rest: Vec<_> = all
            .iter()
            .copied()
            .filter(|amendment| amendment.key != key)
            .collect();
        assert!(rest.len() < all.len(), "{self:?} has no amendment {key}");
        rest
    }

    /// Gives a machine everything that the listing draws into.
    pub fn allocate_maps(self, workspace: &mut impl Workspace, color: Format, depth: Format) {
        let mut all = |resources: &[&Resources]| {
            allocate_maps(
                workspace,
                &[&[&stage::RESOURCES], resources].concat(),
                color,
                depth,
            )
        };
        let done = match self {
            Self::LayerPeeling | Self::Hybrid => all(&hybrid::RESOURCES),
            Self::A => all(&coherent::RESOURCES_A),
            Self::B => all(&coherent::RESOURCES_B),
        };
        done.unwrap();
    }

    /// Runs it on a machine that has its maps.
    pub fn run(self, machine: &mut impl Machine, amendments: &[Amendment], limit: f64) -> Outcome {
        let variables = Variables::new().with("iteration_limit", limit);
        run(self.listing(), amendments, variables, machine).unwrap()
    }
}

/// What a loop did on emulated pixels.
pub struct Emulated {
    pub emulator: Emulator,
    pub outcome: Outcome,
}

impl Emulated {
    pub fn iterations(&self) -> u32 {
        self.outcome.variables.get("iterations").unwrap() as u32
    }

    pub fn ended(&self) -> bool {
        self.outcome.stopped.is_some()
    }

    /// Pixels whose surfaces were not composited as they should be.
    pub fn bad(&self, pixels: &[Pixel]) -> usize {
        bad(pixels, self.emulator.composited())
    }
}

/// Runs a loop on emulated pixels in 32-bit float formats, at most one iteration more than any pixel has surfaces and
/// one that finds nothing.
pub fn emulate(which: Loop, pixels: &[Pixel], amendments: &[Amendment]) -> Emulated {
    emulate_in(
        which,
        pixels,
        amendments,
        Format::Rgba32F,
        Format::Depth32FStencil8,
    )
}

/// The same in other formats.
pub fn emulate_in(
    which: Loop,
    pixels: &[Pixel],
    amendments: &[Amendment],
    color: Format,
    depth: Format,
) -> Emulated {
    let mut emulator = Emulator::new(pixels.to_vec());
    which.allocate_maps(&mut emulator, color, depth);
    let deepest = pixels.iter().map(Vec::len).max().unwrap_or(0);
    let outcome = which.run(&mut emulator, amendments, deepest as f64 + 2.0);
    Emulated { emulator, outcome }
}

/// Pixels at which `composited` is not what the oracle lists, each surface once and in order.
pub fn bad(pixels: &[Pixel], composited: &[Vec<u32>]) -> usize {
    pixels
        .iter()
        .zip(composited)
        .filter(|(pixel, composited)| expected(pixel) != **composited)
        .count()
}

/// The surfaces that belong into the image by their order of submission, front to back; unsorted before sorted ones at
/// the same depth.
pub fn expected(pixel: &Pixel) -> Vec<u32> {
    let opaque = opaque_depth(pixel);
    let mut list: Vec<&Surface> = pixel
        .iter()
        .filter(|surface| surface.group != Group::Opaque && surface.fragment.depth < opaque)
        .collect();
    list.sort_by(|a, b| {
        let depths = a.fragment.depth.total_cmp(&b.fragment.depth);
        depths.then((a.group == Group::Sorted).cmp(&(b.group == Group::Sorted)))
    });
    list.iter().map(|surface| surface.fragment.order).collect()
}

/// The image's colour at a pixel, by the oracle, over a background of nothing.
pub fn expected_color(pixel: &Pixel) -> [f64; 4] {
    let opaque = pixel.iter().find(|surface| surface.group == Group::Opaque);
    let background = opaque.map_or(Rgba::default(), |surface| surface.fragment.color);
    let mut list: Vec<Fragment> = pixel
        .iter()
        .filter(|surface| surface.group != Group::Opaque)
        .map(|surface| surface.fragment)
        .collect();
    oracle::composite(&mut list, opaque_depth(pixel), background)
}

pub fn opaque_depth(pixel: &Pixel) -> f32 {
    pixel
        .iter()
        .filter(|surface| surface.group == Group::Opaque)
        .map(|surface| surface.fragment.depth)
        .fold(1.0, f32::min)
}

/// A pixel with surfaces at these depths, in this order of submission, each of a colour of its own.
pub fn pixel(depths: impl IntoIterator<Item = f32>) -> Pixel {
    depths
        .into_iter()
        .zip(0..)
        .map(|(depth, order)| Surface {
            fragment: Fragment {
                depth,
                color: color(order),
                order,
            },
            group: Group::Unsorted,
        })
        .collect()
}

/// The same with an opaque surface.
pub fn before(mut pixel: Pixel, opaque: f32) -> Pixel {
    pixel.push(Surface {
        fragment: Fragment {
            depth: opaque,
            color: Rgba::opaque([0.2, 0.4, 0.6]),
            order: u32::MAX,
        },
        group: Group::Opaque,
    });
    pixel
}

/// Distinct for any two of few surfaces, and not symmetric in its channels.
fn color(order: u32) -> Rgba {
    let part = |step: u32| f32::from((order * step % 17) as u8) / 16.0;
    Rgba::new(part(3), part(5), part(11), 0.25 + part(7) / 2.0)
}

/// 32 x 32 pixels of `n` surfaces in random order at distinct depths.
pub fn random_image(n: usize) -> Vec<Pixel> {
    let mut chance = Chance::new(n as u64);
    (0..1024)
        .map(|_| pixel(chance.shuffled(n).into_iter().map(|k| depth_of(k, n))))
        .collect()
}

/// 32 x 32 pixels of `n` surfaces in order, but for two random exchanges of neighbours or others.
pub fn nearly_sorted_image(n: usize) -> Vec<Pixel> {
    let mut chance = Chance::new(n as u64 + 1);
    (0..1024)
        .map(|_| {
            let mut numbers: Vec<usize> = (0..n).collect();
            for _ in 0..2 {
                numbers.swap(chance.below(n), chance.below(n));
            }
            pixel(numbers.into_iter().map(|k| depth_of(k, n)))
        })
        .collect()
}

/// 32 x 32 pixels of `n` surfaces on few depths.
pub fn tied_image(n: usize, levels: usize) -> Vec<Pixel> {
    let mut chance = Chance::new(n as u64 + 2);
    (0..1024)
        .map(|_| pixel((0..n).map(|_| depth_of(chance.below(levels), levels))))
        .collect()
}

/// Depth number `k` of `n`, between the planes.
pub fn depth_of(k: usize, n: usize) -> f32 {
    (k as f32 + 1.0) / (n as f32 + 2.0)
}

/// One pixel with its surfaces front to back.
pub fn sorted(n: usize) -> Vec<Pixel> {
    vec![pixel((0..n).map(|k| depth_of(k, n)))]
}

/// One pixel with its surfaces back to front.
pub fn reversed(n: usize) -> Vec<Pixel> {
    vec![pixel((0..n).rev().map(|k| depth_of(k, n)))]
}

/// Runs a loop as amended, which must end and composite everything as it should be.
pub fn amended(which: Loop, pixels: &[Pixel]) -> Emulated {
    let emulated = emulate(which, pixels, &which.amendments());
    assert!(emulated.ended());
    assert_eq!(emulated.bad(pixels), 0);
    emulated
}

/// Runs it without an amendment, after it has been seen to be right with it.
pub fn without(which: Loop, key: &str, pixels: &[Pixel]) -> Emulated {
    amended(which, pixels);
    emulate(which, pixels, &which.without(key))
}

/// Algorithm 2 on emulated pixels, given up after more iterations than it can need.
pub fn algorithm_2(amendments: &[Amendment<Line>], pixels: &[Pixel]) -> AlgorithmRun {
    let limit = pixels.iter().map(Vec::len).max().unwrap() as u32 + 2;
    run_algorithm(&ideal::ALGORITHM_2, amendments, pixels, limit).unwrap()
}
