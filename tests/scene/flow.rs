//! Isosurfaces, streamlines and arrows: closed, where the closed forms say, and clear about bad values.

use std::collections::HashMap;
use std::f64::consts::{PI, TAU};

use glam::{DAffine3, DVec3};
use onionskin::generate::{
    Arrows, Ball, Flow, Isosurface, Lattice, Seeds, Streamlines, Swirl, arrows, ball, isosurface,
    runge_kutta, streamlines,
};
use onionskin::{Mesh, Scene, Volume};
use proptest::prelude::*;

/// How often each directed edge is there, less how often the reverse is: nothing but zeros on a closed surface that is
/// turned alike everywhere.
fn open_edges(mesh: &Mesh) -> usize {
    let mut edges: HashMap<(u32, u32), i32> = HashMap::new();
    for &[a, b, c] in &mesh.triangles {
        for (from, to) in [(a, b), (b, c), (c, a)] {
            *edges.entry((from.min(to), from.max(to))).or_default() +=
                if from < to { 1 } else { -1 };
        }
    }
    edges.values().filter(|&&sum| sum != 0).count()
}

/// The volume that a closed surface encloses, positive if its triangles are turned outwards.
fn enclosed(mesh: &Mesh) -> f64 {
    let corner = |n: u32| mesh.vertices[n as usize].position;
    let part = |t: &[u32; 3]| corner(t[0]).dot(corner(t[1]).cross(corner(t[2]))) / 6.0;
    mesh.triangles.iter().map(part).sum()
}

fn distances(samples: u32) -> Volume {
    // Softness 1 makes the ball's value fall over a whole unit around its radius.
    ball(&Ball {
        lattice: Lattice { size: 3.0, samples },
        radius: 0.8,
        softness: 0.5,
        value: 1.0,
    })
    .unwrap()
}

#[test]
fn an_isosurface_of_a_ball_is_a_closed_sphere_turned_outwards() {
    let errors = [24, 48].map(|samples| {
        let volume = distances(samples);
        let mesh = isosurface(&Isosurface {
            volume: &volume,
            value: 0.5,
        })
        .unwrap();
        assert_eq!(open_edges(&mesh), 0);
        let radius = mesh.vertices[0].position.length();
        let sphere = 4.0 / 3.0 * PI * radius.powi(3);
        for vertex in &mesh.vertices {
            // A cell is 3 / 23 wide; a chord's midpoint lies within its square over eight radii of the sphere.
            assert!((vertex.position.length() - radius).abs() < 0.01);
            assert!(vertex.normal.dot(vertex.position.normalize().as_vec3()) > 0.95);
        }
        (enclosed(&mesh) / sphere - 1.0).abs()
    });
    // Linear pieces: second order, so a quarter; a half leaves room for where the lattice happens to lie.
    assert!(
        errors[0] < 0.03 && errors[1] < errors[0] / 2.0,
        "{errors:?}"
    );
}

#[test]
fn a_surface_with_a_triangle_less_is_found_to_be_open() {
    let volume = distances(24);
    let mut mesh = isosurface(&Isosurface {
        volume: &volume,
        value: 0.5,
    })
    .unwrap();
    mesh.triangles.pop();
    assert_eq!(open_edges(&mesh), 3);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn isosurfaces_of_noise_have_no_cracks(
        inner in prop::collection::vec(0_u8..4, 27),
        mirrored in any::<bool>(),
    ) {
        // Few different values, so that many samples are equal to the surface's; zeros all around close it.
        let mut samples = vec![0.0_f32; 125];
        for (n, &value) in inner.iter().enumerate() {
            samples[1 + n % 3 + 5 * (1 + n / 3 % 3) + 25 * (1 + n / 9)] = f32::from(value);
        }
        prop_assume!(inner.iter().any(|&value| value >= 2));
        let x = if mirrored { -1.0 } else { 1.0 };
        let placement = DAffine3::from_scale(DVec3::new(x, 1.0, 1.0));
        let volume = Volume::new("noise", [5; 3], samples, placement).unwrap();
        let mesh = isosurface(&Isosurface { volume: &volume, value: 2.0 }).unwrap();
        prop_assert_eq!(open_edges(&mesh), 0);
        // Around samples that are the surface's value it encloses nothing, but for the rounding of some hundred products of
        // coordinates up to 5.
        match inner.iter().any(|&value| value > 2) {
            true => prop_assert!(enclosed(&mesh) > 0.0),
            false => prop_assert!(enclosed(&mesh).abs() < 1e-11, "{}", enclosed(&mesh)),
        }
        prop_assert!(mesh.is_finite());
    }
}

#[test]
fn runge_kutta_goes_around_a_circle_at_the_fourth_order() {
    let error = |steps: u32| {
        let step = TAU / f64::from(steps);
        let velocity = |point| Flow::Rotation.velocity(point);
        let around = |point, _| runge_kutta(velocity, point, step);
        (0..steps).fold(DVec3::X, around).distance(DVec3::X)
    };
    let order = (error(32) / error(64)).log2();
    // The next term of the error is a step smaller: 2 pi / 32 changes the order by less than 0.2.
    assert!((order - 4.0).abs() < 0.2, "{order}");
}

#[test]
fn streamlines_of_a_rotation_are_closed_tubes_on_circles() {
    let parameters = Streamlines {
        seeds: Seeds {
            flow: Flow::Rotation,
            count: 9,
            centre: [1.0, 0.0, 0.0],
            extent: [0.0, 0.0, 1.0],
            seed: 3,
        },
        length: 3.0,
        steps: 64,
        tube: 0.01,
        sides: 5,
    };
    let mesh = streamlines(&parameters).unwrap();
    assert_eq!(open_edges(&mesh), 0);
    assert_eq!(mesh.triangle_count(), 9 * 2 * 5 * 65);
    for vertex in &mesh.vertices {
        let off = (vertex.position.truncate().length() - 1.0).abs();
        assert!(off < 0.01 + 1e-5, "{off}");
    }
    // A tube's volume is its cross-section times its length: a pentagon's area here.
    let pentagon = 2.5 * (TAU / 5.0).sin() * 1e-4;
    let all = enclosed(&mesh) / (9.0 * 3.0 * pentagon);
    assert!((all - 1.0).abs() < 0.01, "{all}");
}

/// dx/dz = x z / (1 + z squared) goes from x at z = 0 along x sqrt(1 + z squared).
#[test]
fn a_bundle_opens_as_a_hyperbola_around_its_tie() {
    let start = DVec3::new(0.3, -0.2, 0.0);
    let step = 1.0 / 64.0;
    let velocity = |point| Flow::Bundle.velocity(point);
    for direction in [1.0, -1.0] {
        let mut point = start;
        for _ in 0..128 {
            point = runge_kutta(velocity, point, direction * step);
        }
        let expected = start * 5.0_f64.sqrt() + DVec3::Z * 2.0 * direction;
        // 128 steps' errors of the fifth order: 128 (1/64)^5 is 1e-7, times derivatives below 10.
        assert!(point.distance(expected) < 1e-6, "{point} {expected}");
    }
}

#[test]
fn arrows_are_closed_and_as_long_as_the_flow_is_fast() {
    let seeds = Seeds {
        flow: Flow::Rotation,
        count: 1,
        centre: [2.0, 0.0, 0.0],
        extent: [0.0; 3],
        seed: 0,
    };
    let mesh = arrows(&Arrows {
        seeds: seeds.clone(),
        length: 0.5,
        sides: 7,
    })
    .unwrap();
    assert_eq!(open_edges(&mesh), 0);
    assert!(enclosed(&mesh) > 0.0);
    let bounds = mesh.bounds().unwrap();
    assert!(
        (bounds.size().y - 1.0).abs() < 1e-6,
        "speed 2 at 0.5: {bounds:?}"
    );
    let still = Seeds {
        centre: [0.0; 3],
        ..seeds
    };
    let none = arrows(&Arrows {
        seeds: still,
        ..Arrows::default()
    })
    .unwrap();
    assert_eq!(none.triangle_count(), 0);
}

#[test]
fn streamlines_of_a_swirl_stay_finite_and_end_where_it_stands_still() {
    let mesh = streamlines(&Streamlines::default()).unwrap();
    assert_eq!(open_edges(&mesh), 0);
    let still = Flow::Swirl(Swirl {
        winding: 0.0,
        jet: 0.0,
        ..Swirl::default()
    });
    let seeds = Seeds {
        flow: still,
        count: 2,
        centre: [0.0; 3],
        extent: [0.0; 3],
        seed: 0,
    };
    let none = streamlines(&Streamlines {
        seeds,
        ..Streamlines::default()
    })
    .unwrap();
    assert_eq!(none.triangle_count(), 0);
}

const VOLUME: &str = "[[volume]]\ngenerate = \"ball\"\nname = \"fog\"\nhidden = true\n[[mesh]]\n";

#[test]
fn an_isosurface_in_a_scene_file_is_of_a_named_volume_even_a_hidden_one() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("s.toml");
    let text = format!(
        "{VOLUME}generate = \"isosurface\"\nvolume = \"fog\"\nvalue = 0.5\nopacity = 0.5\n"
    );
    std::fs::write(&path, text).unwrap();
    let scene = Scene::load(&path).unwrap();
    assert_eq!((scene.meshes.len(), scene.volumes.len()), (1, 0));
    assert_eq!(scene.meshes[0].vertices[0].color.a, 0.5);
}

#[test]
fn bad_values_are_refused_with_what_to_do() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("s.toml");
    let cases = [
        ("generate = \"isosurface\"\nvalue = 1.0", "has no volume"),
        (
            "generate = \"isosurface\"\nvolume = \"fig\"\nvalue = 1.0",
            "Did you mean \"fog\"?",
        ),
        (
            "generate = \"isosurface\"\nvolume = \"fog\"",
            "`value` is missing",
        ),
        (
            "generate = \"isosurface\"\nvolume = \"fog\"\nvalue = 7",
            "its values go from 0 to 1",
        ),
        (
            "generate = \"isosurface\"\nvolume = \"fog\"\nvalue = 0.5\nsteps = 2",
            "key 'steps' is not known",
        ),
        (
            "generate = \"streamlines\"\nflow = \"rotaton\"",
            "Did you mean \"rotation\"?",
        ),
        (
            "generate = \"streamlines\"\ncount = 0",
            "Give a whole number from 1",
        ),
        (
            "generate = \"streamlines\"\nsteps = 100000\ncount = 1000000",
            "triangles, and at most",
        ),
        ("generate = \"streamlines\"\nlength = -1", "`length` is -1"),
        ("generate = \"arrows\"\nsides = 2", "`sides` is 2"),
        ("generate = \"isosurfaces\"", "Did you mean \"isosurface\"?"),
    ];
    for (mesh, says) in cases {
        std::fs::write(&path, format!("{VOLUME}{mesh}\n")).unwrap();
        let error = Scene::load(&path).unwrap_err().to_string();
        assert!(error.contains(says), "{mesh}: {error}");
    }
}
