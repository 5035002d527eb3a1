//! What the OpenGL of 2001 is tried on: triangles, and what two texture units make of them.

use std::collections::BTreeMap;
use std::fmt::Debug;

use glam::{DVec3, Vec3};
use onionskin::low_level::steps::{Compare, DepthTextureMode, gl::*};
use onionskin::{Camera, Format, Mesh, Rgba, Scene, Vertex};
use proptest::prelude::*;

pub const SIZE: [u32; 2] = [32, 16];
pub const COMPARISONS: [Compare; 8] = [
    NEVER, LESS, EQUAL, LEQUAL, GREATER, NOTEQUAL, GEQUAL, ALWAYS,
];

/// What a unit looks up.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Looked {
    Nothing,
    Color,
    Depth,
    Rectangle,
}

#[derive(Clone, Debug)]
pub struct Unit {
    pub looked: Looked,
    pub compare: Option<Compare>,
    pub mode: DepthTextureMode,
    pub replace: bool,
    /// The modelview matrix when the planes are set: sixteenths, and a power of two.
    pub translate: [i8; 3],
    pub scale: i8,
    /// In place of the identity's planes, which generate eye coordinates: these, in eighths, for s, t and r.
    pub planes: Option<[[i8; 4]; 3]>,
    /// A shadow map is biased by so many 65536ths.
    pub bias: i8,
}

/// A corner in sixteenths, and a colour in eighths.
pub type Corner = ([i8; 3], [u8; 4]);

#[derive(Clone, Debug)]
pub struct Case {
    pub map: Vec<[Corner; 3]>,
    pub drawn: Vec<[Corner; 3]>,
    pub units: [Unit; 2],
    pub alpha: Option<(Compare, u8)>,
    pub depth: Format,
}

/// A camera whose matrices are short binary fractions: 90 degrees, twice as wide as high, near 1, far 3.
pub fn scene(triangles: &[[Corner; 3]]) -> Scene {
    let corners = triangles.iter().flatten();
    let vertices: Vec<_> = corners
        .map(|&([x, y, z], color)| {
            let [r, g, b, a] = color.map(|eighths| f32::from(eighths) / 8.0);
            Vertex {
                position: DVec3::new(f64::from(x), f64::from(y), f64::from(z)) / 16.0,
                normal: Vec3::Z,
                color: Rgba::new(r, g, b, a),
            }
        })
        .collect();
    let indices = (0..vertices.len() as u32).step_by(3);
    let mesh = Mesh {
        name: "case".into(),
        triangles: indices.map(|i| [i, i + 1, i + 2]).collect(),
        vertices,
        ..Mesh::default()
    };
    Scene {
        name: "case".into(),
        size: SIZE,
        background: [0.0; 3],
        camera: Camera {
            eye: DVec3::ZERO,
            target: DVec3::NEG_Z,
            up: DVec3::Y,
            fov: 90.0,
            near: 1.0,
            far: 3.0,
        },
        meshes: vec![mesh],
        volumes: Vec::new(),
        notices: Vec::new(),
    }
}

/// What a driver compiles a program for: each combination of these words is another one.
#[derive(Clone, Debug)]
pub struct Words {
    units: [UnitWords; 2],
    alpha: Option<Compare>,
    depth: Format,
}

type UnitWords = ((Looked, Option<Compare>), DepthTextureMode, bool);

/// So many combinations hold every word of a unit with every comparison, twice in each of the units.
const COMBINATIONS: usize = 48;

/// Combinations of words in which every word is as frequent as any other of its kind. Which ones meet is random.
pub fn words() -> impl Strategy<Value = Vec<Words>> {
    let unit = || {
        let modes = vec![
            DepthTextureMode::Luminance,
            DepthTextureMode::Intensity,
            DepthTextureMode::Alpha,
        ];
        (dealt(looks()), dealt(modes), dealt(vec![false, true]))
    };
    let mut alpha = COMPARISONS.map(Some).to_vec();
    alpha.extend([None; 2]);
    let depths = vec![Format::Depth32FStencil8, Format::Depth24Stencil8];
    (unit(), unit(), dealt(alpha), dealt(depths)).prop_map(|(first, second, alpha, depths)| {
        let of = |unit: &(Vec<_>, Vec<_>, Vec<_>), i| (unit.0[i], unit.1[i], unit.2[i]);
        let all = (0..COMBINATIONS).map(|i| Words {
            units: [of(&first, i), of(&second, i)],
            alpha: alpha[i],
            depth: depths[i],
        });
        all.collect()
    })
}

/// What a unit looks up, and the comparison of what is looked up in a depth texture.
fn looks() -> Vec<(Looked, Option<Compare>)> {
    let mut looks = Vec::new();
    for looked in [Looked::Nothing, Looked::Color] {
        looks.extend([(looked, None), (looked, Some(LEQUAL))]);
    }
    for looked in [Looked::Depth, Looked::Rectangle] {
        looks.extend([(looked, None); 2]);
        looks.extend(COMPARISONS.map(|func| (looked, Some(func))));
    }
    looks
}

/// The words in turn, as many as there are combinations, shuffled.
fn dealt<T: Copy + Debug>(words: Vec<T>) -> impl Strategy<Value = Vec<T>> {
    let all: Vec<T> = words.into_iter().cycle().take(COMBINATIONS).collect();
    Just(all).prop_shuffle()
}

/// Random triangles and numbers, with these words.
pub fn cases(words: Words) -> impl Strategy<Value = Case> {
    let corner = || {
        (
            (-64..=64_i8, -40..=40_i8, -50..=-14_i8),
            proptest::array::uniform4(0..=8_u8),
        )
            .prop_map(|((x, y, z), color)| ([x, y, z], color))
    };
    let triangle = move || [corner(), corner(), corner()];
    let triangles = move |most| proptest::collection::vec(triangle(), 1..=most);
    let numbers = || {
        (
            // z not negative, so that q stays positive.
            (-8..=8_i8, -8..=8_i8, 0..=8_i8),
            -1..=1_i8,
            proptest::option::weighted(
                0.25,
                (
                    [-8..=8_i8, -2..=2, -2..=2, -4..=4],
                    [-2..=2_i8, -8..=8, -2..=2, -4..=4],
                    [-1..=1_i8, -1..=1, 6..=8, -4..=0],
                )
                    .prop_map(|(s, t, r)| [s, t, r]),
            ),
            -100..=100_i8,
        )
    };
    let unit = |words, ((x, y, z), scale, planes, bias)| {
        let ((looked, compare), mode, replace) = words;
        Unit {
            looked,
            compare,
            mode,
            replace,
            translate: [x, y, z],
            scale,
            planes,
            bias,
        }
    };
    (triangles(4), triangles(6), [numbers(), numbers()], 0..=8_u8).prop_map(
        move |(map, drawn, [first, second], reference)| Case {
            map,
            drawn,
            units: [unit(words.units[0], first), unit(words.units[1], second)],
            alpha: words.alpha.map(|func| (func, reference)),
            depth: words.depth,
        },
    )
}

pub fn count(seen: &mut BTreeMap<String, u32>, case: &Case, pixels: &[[u32; 5]]) {
    let mut add = |what: String| *seen.entry(what).or_default() += 1;
    add("cases".into());
    if let Some((func, _)) = case.alpha {
        add(format!("alpha {func:?}"));
    }
    for unit in case
        .units
        .iter()
        .filter(|unit| unit.looked != Looked::Nothing)
    {
        add(format!("{:?}", unit.looked));
        if unit.looked != Looked::Color {
            add(format!("{:?}", unit.mode));
            if let Some(func) = unit.compare {
                add(format!("compare {func:?}"));
            }
        }
    }
    if pixels.iter().any(|pixel| pixel[..4] != [0; 4]) {
        add("has pixels".into());
    }
}
