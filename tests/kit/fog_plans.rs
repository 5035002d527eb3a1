//! Random scenes of volumes and triangles that shrink: what fails is printed as a plan with as few of either, as plain, as
//! still fail.

use glam::{DAffine3, DQuat, DVec3, Vec3};
use onionskin::{Mesh, Rgba, Scene, Transfer, TransferPoint, Vertex, Volume};
use proptest::prelude::*;

use super::chance::Chance;
use super::fog_scenes::seen_closely;

/// A scene, to be printed and made.
#[derive(Clone, Debug)]
pub struct Plan {
    pub surfaces: Vec<Triangle>,
    pub opaque: Vec<Triangle>,
    pub volumes: Vec<Lattice>,
}

#[derive(Clone, Debug)]
pub struct Triangle {
    pub corners: [[f32; 3]; 3],
    pub color: [f32; 3],
    /// Of the transparent ones.
    pub alpha: f32,
}

/// A volume: random samples in a box with an edge of 1 or more, moved, turned and sheared.
#[derive(Clone, Debug)]
pub struct Lattice {
    pub dims: [usize; 3],
    /// What its samples, from 0 to 1, are made of.
    pub seed: u64,
    pub half: f64,
    pub middle: [f64; 3],
    pub axis: [f64; 3],
    pub degrees: f64,
    pub shear: f64,
    pub step: f64,
    /// Between which densities and colours the samples from 0 to 1 go.
    pub look: [([f32; 3], f32); 3],
}

impl Plan {
    pub fn scene(&self) -> Scene {
        let mut surfaces = mesh("surfaces", &self.surfaces, |triangle| triangle.alpha);
        surfaces.opaque = false;
        let mut meshes = vec![surfaces];
        if !self.opaque.is_empty() {
            meshes.push(mesh("opaque", &self.opaque, |_| 1.0));
        }
        let volumes = self.volumes.iter().map(Lattice::volume).collect();
        let mut scene = Scene::of("plan", meshes).with_volumes(volumes);
        seen_closely(&mut scene);
        scene
    }
}

impl Lattice {
    fn volume(&self) -> Volume {
        let cells = DVec3::from_array(self.dims.map(|count| (count - 1) as f64));
        let axis = DVec3::from_array(self.axis).normalize_or(DVec3::Y);
        let turn = DQuat::from_axis_angle(axis, self.degrees.to_radians());
        let mut unit = DAffine3::from_scale(2.0 * self.half / cells);
        unit.translation = DVec3::splat(-self.half);
        let mut shear = DAffine3::IDENTITY;
        shear.matrix3.y_axis.x = self.shear;
        let middle = DVec3::from_array(self.middle);
        let place = DAffine3::from_rotation_translation(turn, middle) * shear * unit;
        let mut chance = Chance::new(self.seed);
        let samples = (0..self.dims.iter().product()).map(|_| chance.unit() as f32);
        let samples = samples.collect();
        let mut volume = Volume::new("lattice", self.dims, samples, place).unwrap();
        volume.step = self.step;
        let value = [0.0, 0.4, 1.0];
        let points = value.into_iter().zip(self.look);
        let points = points.map(|(value, (color, density))| TransferPoint {
            value,
            color,
            // As much of a large volume as of a small one.
            density: density / self.half as f32,
        });
        volume.with_transfer(Transfer::new(points.collect()).unwrap())
    }
}

fn mesh(name: &str, triangles: &[Triangle], alpha: impl Fn(&Triangle) -> f32) -> Mesh {
    let vertices = triangles.iter().flat_map(|triangle| {
        let [r, g, b] = triangle.color;
        let color = Rgba::new(r, g, b, alpha(triangle));
        triangle.corners.map(|corner| Vertex {
            position: Vec3::from_array(corner).as_dvec3(),
            normal: Vec3::Z,
            color,
        })
    });
    let numbers = 0..triangles.len() as u32;
    Mesh::new(
        name,
        vertices.collect(),
        numbers.map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect(),
    )
}

/// Up to 24 transparent triangles, 6 opaque ones, and 1 to 4 volumes, some around the eye.
pub fn plans() -> impl Strategy<Value = Plan> {
    let surfaces = prop::collection::vec(triangle(), 0..=24);
    let opaque = prop_oneof![Just(Vec::new()), prop::collection::vec(triangle(), 1..=6)];
    let volumes = prop::collection::vec(lattice(), 1..=4);
    (surfaces, opaque, volumes).prop_map(|(surfaces, opaque, volumes)| Plan {
        surfaces,
        opaque,
        volumes,
    })
}

fn triangle() -> impl Strategy<Value = Triangle> {
    // In front of the eye, whatever the triangle; a thin one is as good as any.
    let corner = [-1.2..1.2_f32, -1.2..1.2, -1.2..1.2];
    let color = [0.0..=1.0_f32, 0.0..=1.0, 0.0..=1.0];
    (
        [corner.clone(), corner.clone(), corner],
        color,
        0.1..=0.9_f32,
    )
        .prop_map(|(corners, color, alpha)| Triangle {
            corners,
            color,
            alpha,
        })
}

fn lattice() -> impl Strategy<Value = Lattice> {
    let dims = [2..=5_usize, 2..=5, 2..=5];
    // One in five has the eye in it.
    let half = prop_oneof![4 => 0.4..1.2_f64, 1 => 5.0..6.0];
    let place = (
        [-1.0..1.0_f64, -1.0..1.0, -1.0..1.0],
        [0.0..1.0_f64, 0.0..1.0, 0.0..1.0],
        0.0..360.0_f64,
    );
    let look = || ([0.0..=1.0_f32, 0.0..=1.0, 0.0..=1.0], 0.0..=2.0_f32);
    let shape = (-0.3..0.3_f64, 0.1..0.9_f64);
    (
        dims,
        0..1_000_000_u64,
        half,
        place,
        shape,
        [look(), look(), look()],
    )
        .prop_map(
            |(dims, seed, half, (middle, axis, degrees), (shear, step), look)| Lattice {
                dims,
                seed,
                half,
                middle,
                axis,
                degrees,
                shear,
                step,
                look,
            },
        )
}
