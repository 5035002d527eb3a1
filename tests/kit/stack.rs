//! Fragment stacks: a small image of which every pixel has its own list of fragments, drawn as a list of pixel-sized
//! quads. What the list should look like is known from how it was made, not from what was drawn.

use glam::{DVec3, Vec3};
use onionskin::low_level::oracle;
use onionskin::{Camera, Fragment, Image, Mesh, Rgba, Scene, Vertex};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestError, TestRng, TestRunner};

/// A fragment of a pixel: on which of [`LEVELS`] depths it lies, and its colour. Submitted in the order of the list.
#[derive(Clone, Debug)]
pub struct Piece {
    pub level: u16,
    pub color: [f32; 4],
}

/// Every pixel's fragments, row by row from the top, and the level of an opaque surface, if there is one.
#[derive(Clone, Debug)]
pub struct Stack {
    pub width: u32,
    pub pixels: Vec<Vec<Piece>>,
    pub opaque: Option<u16>,
}

/// Distinguishable depths: an f32 depth buffer resolves thousands of times as many between near and far.
pub const LEVELS: u16 = 1000;

const NEAR: f64 = 1.0;
const FAR: f64 = 4.0;
const BACKGROUND: [f32; 3] = [0.9, 0.8, 0.7];
const OPAQUE: [f32; 3] = [0.25, 0.5, 0.125];

impl Stack {
    fn height(&self) -> u32 {
        self.pixels.len() as u32 / self.width
    }

    /// The scene that has these fragments.
    pub fn scene(&self) -> Scene {
        let mut meshes = Vec::new();
        if let Some(level) = self.opaque {
            let [r, g, b] = OPAQUE;
            let mut mesh = Mesh {
                name: "opaque".into(),
                opaque: true,
                ..Mesh::default()
            };
            (0..self.pixels.len())
                .for_each(|pixel| self.add_quad(&mut mesh, pixel, level, [r, g, b, 1.0]));
            meshes.push(mesh);
        }
        let mut mesh = Mesh {
            name: "stack".into(),
            ..Mesh::default()
        };
        // Layer by layer, so that a pixel's fragments come in the order of its list with others' in between.
        let longest = self.pixels.iter().map(Vec::len).max().unwrap_or(0);
        for place in 0..longest {
            for (pixel, pieces) in self.pixels.iter().enumerate() {
                if let Some(piece) = pieces.get(place) {
                    self.add_quad(&mut mesh, pixel, piece.level, piece.color);
                }
            }
        }
        meshes.push(mesh);
        Scene {
            name: "stack".into(),
            size: [self.width, self.height()],
            background: BACKGROUND,
            camera: Camera {
                eye: DVec3::ZERO,
                target: DVec3::NEG_Z,
                up: DVec3::Y,
                fov: 90.0,
                near: NEAR,
                far: FAR,
            },
            meshes,
            volumes: Vec::new(),
            notices: Vec::new(),
        }
    }

    /// The image, by the oracle, straight from the lists.
    pub fn expected(&self) -> Image {
        let opaque = self.opaque.map_or(f32::INFINITY, f32::from);
        let background = Rgba::opaque(if self.opaque.is_some() {
            OPAQUE
        } else {
            BACKGROUND
        });
        let pixels = self.pixels.iter().map(|pieces| {
            let mut list = fragments(pieces);
            oracle::composite(&mut list, opaque, background)
                .map(|channel| channel as f32)
                .into()
        });
        Image {
            width: self.width,
            height: self.height(),
            pixels: pixels.collect(),
        }
    }

    /// Fragments before the opaque surface, and how many of them have the same depth as an earlier one of their pixel.
    pub fn counts(&self) -> (u64, u64) {
        let opaque = self.opaque.unwrap_or(u16::MAX);
        let (mut fragments, mut ties) = (0, 0);
        for pieces in &self.pixels {
            let mut levels: Vec<u16> = pieces
                .iter()
                .map(|piece| piece.level)
                .filter(|&l| l < opaque)
                .collect();
            fragments += levels.len() as u64;
            levels.sort_unstable();
            ties += levels.windows(2).filter(|pair| pair[0] == pair[1]).count() as u64;
        }
        (fragments, ties)
    }

    fn add_quad(&self, mesh: &mut Mesh, pixel: usize, level: u16, [r, g, b, a]: [f32; 4]) {
        let (width, height) = (f64::from(self.width), f64::from(self.height()));
        let (column, row) = (
            (pixel as u32 % self.width) as f64,
            (pixel as u32 / self.width) as f64,
        );
        // Between the planes with room to spare: GL clips what lies on them.
        let depth = NEAR + (FAR - NEAR) * (f64::from(level) + 1.0) / f64::from(LEVELS + 2);
        let first = mesh.vertices.len() as u32;
        for (dx, dy) in [(0.0, 0.0), (0.0, 1.0), (1.0, 1.0), (1.0, 0.0)] {
            // With a vertical opening of 90 degrees the half height at a depth is the depth.
            let x = ((column + dx) / width * 2.0 - 1.0) * depth * width / height;
            let y = (1.0 - (row + dy) / height * 2.0) * depth;
            mesh.vertices.push(Vertex {
                position: DVec3::new(x, y, -depth),
                normal: Vec3::Z,
                color: Rgba::new(r, g, b, a),
            });
        }
        mesh.triangles
            .extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
    }
}

/// A pixel's list as the oracle takes it.
pub fn fragments(pieces: &[Piece]) -> Vec<Fragment> {
    let fragment = |(order, piece): (usize, &Piece)| Fragment {
        depth: f32::from(piece.level),
        color: piece.color.into(),
        order: order as u32,
    };
    pieces.iter().enumerate().map(fragment).collect()
}

/// Fragments in an order that is neither front to back nor back to front, on so many levels of [`LEVELS`]; with 997 of
/// them hardly one twice.
pub fn scattered(count: usize, seed: usize, levels: usize) -> Vec<Piece> {
    let part = |number: usize, step: usize| ((number + seed) * step % 101) as f32 / 100.0;
    let piece = |number: usize| Piece {
        // 997 is prime.
        level: ((number + seed) * 389 % 997 % levels) as u16,
        color: [
            part(number, 7),
            part(number, 13),
            part(number, 29),
            0.02 + 0.1 * part(number, 37),
        ],
    };
    (0..count).map(piece).collect()
}

/// A row of pixels with so many fragments each.
pub fn row(counts: &[usize]) -> Stack {
    let pixel = |(pixel, &count): (usize, &usize)| scattered(count, pixel, 997);
    Stack {
        width: counts.len() as u32,
        pixels: counts.iter().enumerate().map(pixel).collect(),
        opaque: None,
    }
}

/// Random stacks of 3 x 2 pixels on `levels` depths; on few of them there are ties, `distinct` takes them out.
pub fn stacks(levels: u16, distinct: bool) -> impl Strategy<Value = Stack> {
    // 0 and 1 are the alphas that go wrong.
    let alpha = prop_oneof![1 => Just(0.0_f32), 1 => Just(1.0_f32), 8 => 0.0..=1.0_f32];
    let channel = 0.0..=1.0_f32;
    let piece = (
        0..levels,
        [channel.clone(), channel.clone(), channel],
        alpha,
    )
        .prop_map(move |(level, [r, g, b], a)| Piece {
            level: level * (LEVELS / levels),
            color: [r, g, b, a],
        });
    let pixel = proptest::collection::vec(piece, 0..=12).prop_map(move |mut pieces| {
        if distinct {
            let mut seen = std::collections::HashSet::new();
            pieces.retain(|piece| seen.insert(piece.level));
        }
        pieces
    });
    let opaque = proptest::option::of((0..levels).prop_map(move |level| level * (LEVELS / levels)));
    (proptest::collection::vec(pixel, 6), opaque).prop_map(|(pixels, opaque)| Stack {
        width: 3,
        pixels,
        opaque,
    })
}

/// A runner that prints its seed; `ONIONSKIN_SEED` repeats a run.
pub fn runner(cases: u32) -> TestRunner {
    let seed: u64 = match std::env::var("ONIONSKIN_SEED") {
        Ok(seed) => seed.parse().expect("ONIONSKIN_SEED is a number"),
        Err(_) => std::time::SystemTime::UNIX_EPOCH
            .elapsed()
            .expect("a clock after 1970")
            .as_nanos() as u64,
    };
    println!("ONIONSKIN_SEED={seed} repeats this run");
    let mut bytes = [0; 32];
    bytes[..8].copy_from_slice(&seed.to_le_bytes());
    let config = Config {
        cases,
        max_shrink_iters: 1000,
        failure_persistence: None,
        ..Config::default()
    };
    TestRunner::new_with_rng(config, TestRng::from_seed(RngAlgorithm::ChaCha, &bytes))
}

/// Expects that none of the random stacks has failed. Otherwise the smallest one is printed as fragment lists.
#[track_caller]
pub fn expect_none(outcome: Result<(), TestError<Stack>>) {
    if let Err(TestError::Fail(why, stack)) = outcome {
        let lists = stack.pixels.iter().map(|pieces| fragments(pieces));
        let lists: Vec<_> = lists.collect();
        let opaque = stack.opaque;
        panic!("{why}\nthe smallest stack, opaque at {opaque:?}:\n{lists:#?}");
    }
    outcome.unwrap();
}
