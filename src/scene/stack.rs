//! Volumes as a stack of slices: planes across the view, each clipped to the volumes' boxes. Methods that know only
//! surfaces draw volumes in this way, as graphics hardware did before rays were cast on it (and as Carr et al. 2008
//! have it).
//!
//! All volumes of a scene share one stack. So overlapping volumes do not have two sorted slices at one place but a
//! single slice, in which their samples are mixed and not composited one after the other.

use glam::{DVec2, DVec3};

use super::{Axes, Camera, Mesh, Scene, Shading, Vertex, Volume};
use crate::fragment::Rgba;

/// A scene whose volumes were replaced by slices.
pub(crate) struct Stack {
    /// The scene: the surfaces first, then the slices, in the order of submission. It has no volumes.
    pub(crate) scene: Scene,
    /// The distance from slice to slice along the view direction. Where a ray crosses a slice, the slice stands for
    /// this distance times the ray's length over a distance of 1.
    pub(crate) spacing: f64,
}

impl Scene {
    /// The scene with `count` slices instead of its volumes.
    ///
    /// The boxes take up a part of the view direction between the near and the far plane. This part is cut into equal
    /// slabs, and a slice stands in the middle of each slab. A slice is the convex hull of the boxes' cross-sections.
    /// [`Shading::Slice`] gives it its colours, and makes it clear outside of the boxes. No other mesh of the result
    /// counts as sorted.
    pub(crate) fn as_slices(&self, count: u32) -> Stack {
        let view = View::of(&self.camera);
        let boxes: Vec<[DVec3; 8]> = self
            .volumes
            .iter()
            .map(|volume| view.seen(volume))
            .collect();
        let distances = || boxes.iter().flatten().map(|corner| corner.z);
        let near = distances()
            .fold(f64::INFINITY, f64::min)
            .max(self.camera.near);
        let far = distances()
            .fold(f64::NEG_INFINITY, f64::max)
            .min(self.camera.far);
        let spacing = ((far - near) / f64::from(count)).max(0.0);
        let mut mesh = Mesh::default();
        for number in 0..count {
            let distance = near + (f64::from(number) + 0.5) * spacing;
            if distance < far {
                let points = boxes
                    .iter()
                    .flat_map(|corners| cross_section(corners, distance));
                add(&mut mesh, &view, &hull(points.collect()), distance);
            }
        }
        let slices = Mesh {
            name: "slices".into(),
            shading: Shading::Slice,
            sorted: true,
            ..mesh
        };
        // Triangles of a sorted mesh may cross the slices, and are then not sorted among them.
        let unsorted = self.meshes.iter().map(|mesh| Mesh {
            sorted: false,
            ..mesh.clone()
        });
        let mut meshes: Vec<Mesh> = unsorted.collect();
        meshes.push(slices);
        Stack {
            scene: Self {
                name: self.name.clone(),
                meshes,
                volumes: Vec::new(),
                notices: Vec::new(),
                ..*self
            },
            spacing,
        }
    }
}

/// The eye and the view's axes.
struct View {
    eye: DVec3,
    axes: Axes,
}

impl View {
    fn of(camera: &Camera) -> Self {
        Self {
            eye: camera.eye,
            axes: camera.axes(),
        }
    }

    /// A box's corners in the view: right, up, distance.
    fn seen(&self, volume: &Volume) -> [DVec3; 8] {
        volume.corners().map(|corner| {
            let from_eye = corner - self.eye;
            DVec3::new(
                from_eye.dot(self.axes.right),
                from_eye.dot(self.axes.up),
                from_eye.dot(self.axes.forward),
            )
        })
    }

    fn world(&self, point: DVec2, distance: f64) -> DVec3 {
        let from_eye =
            self.axes.right * point.x + self.axes.up * point.y + self.axes.forward * distance;
        self.eye + from_eye
    }
}

/// The points where a plane at this distance cuts a box's edges: 3 to 6, or none.
fn cross_section(corners: &[DVec3; 8], distance: f64) -> impl Iterator<Item = DVec2> {
    // An edge joins two corners whose numbers differ in one bit.
    let edges = (0..8_usize).flat_map(|from| [1, 2, 4].map(|bit| (from, from | bit)));
    edges.filter_map(move |(from, to)| {
        let (from, to) = (corners[from], corners[to]);
        let crosses = (from.z < distance) != (to.z < distance);
        crosses.then(|| {
            let part = (distance - from.z) / (to.z - from.z);
            from.lerp(to, part).truncate()
        })
    })
}

/// The corners of the convex hull, counterclockwise (Andrew's monotone chain).
fn hull(mut points: Vec<DVec2>) -> Vec<DVec2> {
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    points.dedup();
    let mut hull = chain(points.iter().copied());
    hull.extend(chain(points.iter().rev().copied()));
    hull
}

/// Half of a hull: from the first point to the one before the last, every turn to the left.
fn chain(points: impl Iterator<Item = DVec2>) -> Vec<DVec2> {
    let mut chain: Vec<DVec2> = Vec::new();
    for point in points {
        while let [.., a, b] = chain[..] {
            if (b - a).perp_dot(point - b) > 0.0 {
                break;
            }
            chain.pop();
        }
        chain.push(point);
    }
    chain.pop();
    chain
}

/// A polygon as a fan of triangles that face the eye. The colour comes from the volumes, so the vertices are clear.
fn add(mesh: &mut Mesh, view: &View, polygon: &[DVec2], distance: f64) {
    let first = mesh.vertices.len() as u32;
    mesh.vertices.extend(polygon.iter().map(|&point| Vertex {
        position: view.world(point, distance),
        normal: -view.axes.forward.as_vec3(),
        color: Rgba::default(),
    }));
    let fan = (2..polygon.len() as u32).map(|i| [first, first + i - 1, first + i]);
    mesh.triangles.extend(fan);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Transform;
    use crate::scene::generate::{Constant, Lattice, constant};

    /// A cube with edges of 2 around the origin, and the eye on the z axis.
    fn cube() -> Scene {
        let lattice = Lattice {
            size: 2.0,
            samples: 2,
        };
        let volume = constant(&Constant {
            lattice,
            value: 1.0,
        });
        let mut scene = Scene::of("cube", Vec::new()).with_volumes(vec![volume.unwrap()]);
        scene.camera = Camera {
            eye: DVec3::Z * 5.0,
            target: DVec3::ZERO,
            up: DVec3::Y,
            fov: 40.0,
            near: 0.5,
            far: 20.0,
        };
        scene
    }

    fn turned(scene: &mut Scene, translate: DVec3) {
        let transform = Transform {
            axis: DVec3::new(1.0, 2.0, 3.0),
            degrees: 50.0,
            translate,
            ..Transform::default()
        };
        let volume = scene.volumes[0].clone();
        scene.volumes.push(volume.transformed(&transform).unwrap());
    }

    /// The area of all triangles between two distances.
    fn area(stack: &Stack, range: [f64; 2]) -> f64 {
        let mesh = &stack.scene.meshes[0];
        let corners = (0..mesh.triangle_count()).map(|i| mesh.corners(i).map(|c| c.position));
        let among = corners.filter(|[a, ..]| (range[0]..range[1]).contains(&(5.0 - a.z)));
        among
            .map(|[a, b, c]| (b - a).cross(c - a).dot(DVec3::Z) / 2.0)
            .sum()
    }

    #[test]
    fn slices_stand_in_the_middles_of_equal_slabs_front_to_back() {
        let stack = cube().as_slices(4);
        let mesh = &stack.scene.meshes[0];
        assert_eq!((mesh.triangle_count(), stack.spacing), (8, 0.5));
        let heights: Vec<f64> = mesh.vertices.iter().map(|v| v.position.z).collect();
        let expected = [0.75, 0.25, -0.25, -0.75];
        let expected = expected.iter().flat_map(|z| [*z; 4]).collect::<Vec<f64>>();
        assert_eq!(heights, expected);
        assert!(stack.scene.volumes.is_empty() && mesh.sorted && !mesh.opaque);
    }

    /// Cavalieri: the cross-sections times the spacing are the volume, whichever way the box is turned.
    #[test]
    fn the_slices_of_a_turned_box_fill_its_volume() {
        let mut scene = cube();
        turned(&mut scene, DVec3::new(0.2, -0.1, 0.0));
        scene.volumes.remove(0);
        let stack = scene.as_slices(1000);
        let filled = area(&stack, [0.0, 9.0]) * stack.spacing;
        // A midpoint sum of a function with bounded second derivative over 1000 slabs, and f32 sums.
        assert!((filled - 8.0).abs() < 1e-3, "{filled}");
    }

    #[test]
    fn several_boxes_have_one_stack_of_hulls() {
        let mut scene = cube();
        turned(&mut scene, DVec3::X * 2.5);
        let stack = scene.as_slices(100);
        let alone = cube().as_slices(100);
        assert!(stack.spacing > alone.spacing, "the turned box is longer");
        let slices: std::collections::BTreeSet<u32> = stack.scene.meshes[0]
            .vertices
            .iter()
            .map(|vertex| ((5.0 - vertex.position.z) / stack.spacing * 2.0) as u32)
            .collect();
        assert_eq!(slices.len(), 100);
        // From the cube's left side over the gap: more than the two cross-sections.
        let filled = |stack: &Stack| area(stack, [4.5, 5.5]) * stack.spacing;
        assert!(filled(&stack) > filled(&alone) * 2.2);
    }

    #[test]
    fn only_what_is_between_the_near_and_the_far_plane_is_sliced() {
        let mut scene = cube();
        (scene.camera.near, scene.camera.far) = (4.5, 5.0);
        let stack = scene.as_slices(2);
        assert_eq!(stack.spacing, 0.25);
        let heights = stack.scene.meshes[0].vertices.iter().map(|v| v.position.z);
        assert_eq!(heights.fold(f64::INFINITY, f64::min), 0.125);
        scene.camera.near = 8.0;
        scene.camera.far = 9.0;
        assert_eq!(scene.as_slices(2).scene.meshes[0].triangle_count(), 0);
    }
}
