//! What the OpenGL of 2001 is tried on: triangles, and what two texture units make of them.

use std::collections::BTreeMap;

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

pub fn cases() -> impl Strategy<Value = Case> {
    let corner = || {
        (
            (-64..=64_i8, -40..=40_i8, -50..=-14_i8),
            proptest::array::uniform4(0..=8_u8),
        )
            .prop_map(|((x, y, z), color)| ([x, y, z], color))
    };
    let triangle = move || [corner(), corner(), corner()];
    let triangles = move |most| proptest::collection::vec(triangle(), 1..=most);
    let func = || proptest::sample::select(COMPARISONS.to_vec());
    let unit = move || {
        (
            proptest::sample::select(vec![
                Looked::Nothing,
                Looked::Color,
                Looked::Depth,
                Looked::Depth,
                Looked::Rectangle,
                Looked::Rectangle,
            ]),
            proptest::option::weighted(0.75, func()),
            proptest::sample::select(vec![
                DepthTextureMode::Luminance,
                DepthTextureMode::Intensity,
                DepthTextureMode::Alpha,
            ]),
            any::<bool>(),
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
            .prop_map(
                |(looked, compare, mode, replace, (x, y, z), scale, planes, bias)| Unit {
                    looked,
                    compare,
                    mode,
                    replace,
                    translate: [x, y, z],
                    scale,
                    planes,
                    bias,
                },
            )
    };
    let depth = proptest::sample::select(vec![Format::Depth32FStencil8, Format::Depth24Stencil8]);
    (
        triangles(4),
        triangles(6),
        [unit(), unit()],
        proptest::option::weighted(0.8, (func(), 0..=8_u8)),
        depth,
    )
        .prop_map(|(map, drawn, units, alpha, depth)| Case {
            map,
            drawn,
            units,
            alpha,
            depth,
        })
}

pub fn count(seen: &mut BTreeMap<String, u32>, case: &Case, pixels: &[[u32; 5]]) {
    let mut add = |what: String| *seen.entry(what).or_default() += 1;
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
