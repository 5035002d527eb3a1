//! `[[volume]]` in scene files, and the volumes that are made by rule.

use crate::kit::scene::{Refused, bad_toml, toml};
use glam::DVec3;
use onionskin::generate::*;
use onionskin::{Error, Result, Scene, Transfer, TransferPoint, Volume};

const LOOK: &str = "transfer = [{ value = 0, color = [0, 0, 0], density = 0 }, { value = 2, color = [1, 0.5, 0], density = 3 }]";

fn volume(keys: &str) -> Scene {
    toml(&format!("[[volume]]\n{keys}\n{LOOK}\n"))
}

#[track_caller]
fn bad(keys: &str) -> Refused {
    bad_toml(&format!("[[volume]]\n{LOOK}\n{keys}\n"))
}

#[test]
fn every_key_of_a_volume_is_read() {
    let scene = volume("generate = \"constant\"\nvalue = 0.5\nsize = 4\nsamples = 5\nstep = 0.25");
    let [volume] = &scene.volumes[..] else {
        panic!("one volume");
    };
    assert_eq!(volume.dims(), [5; 3]);
    assert_eq!(volume.samples(), [0.5; 125]);
    assert_eq!(
        [volume.step, volume.voxel(), volume.sampling_distance()],
        [0.25, 1.0, 0.25]
    );
    let middle = volume.transfer.at(1.0);
    assert_eq!(
        (middle.color, middle.density),
        (DVec3::new(0.5, 0.25, 0.0), 1.5)
    );
    assert_eq!(volume.corners()[7], DVec3::splat(2.0));
}

#[test]
fn a_transform_moves_a_volume_as_it_moves_a_mesh() {
    let place = "transform = { scale = [1, 2, 3], rotate = { axis = [0, 0, 1], degrees = 90 }, translate = [10, 0, 0] }";
    let scene = volume(&format!("generate = \"gradient\"\n{place}"));
    // (1, 1, 1) scaled is (1, 2, 3), turned (-2, 1, 3).
    let corner = scene.volumes[0].corners()[7];
    assert!(
        corner.distance(DVec3::new(8.0, 1.0, 3.0)) < 1e-12,
        "{corner}"
    );
    let middle = scene.volumes[0].at(DVec3::new(10.0, 0.0, 1.5)).unwrap();
    assert!((middle - 0.75).abs() < 1e-7);
    assert_eq!(scene.volumes[0].at(DVec3::new(10.0, 0.0, 3.1)), None);
}

#[test]
fn the_camera_is_fitted_to_volumes_too() {
    let alone = volume("generate = \"constant\"\ntransform = { translate = [10, 0, 0] }");
    assert_eq!(alone.camera.target, DVec3::X * 10.0);
    let bounds = alone.bounds().unwrap();
    assert_eq!(
        (bounds.min, bounds.max),
        (DVec3::new(9.0, -1.0, -1.0), DVec3::new(11.0, 1.0, 1.0))
    );
    let both = toml(&format!(
        "[[mesh]]\ngenerate = \"plane\"\n[[volume]]\ngenerate = \"constant\"\n{LOOK}\ntransform = {{ translate = [10, 0, 0] }}\n"
    ));
    let bounds = both.bounds().unwrap();
    assert_eq!(bounds.max.x, 11.0);
    assert!(bounds.min.x < 0.0);
    assert_eq!(both.camera.target, bounds.centre());
}

#[test]
fn unknown_keys_are_errors() {
    bad("generate = \"ball\"\nradios = 1")
        .at(4, "radios")
        .suggests("radius");
    bad("generate = \"ball\"\ncolor = [1, 1, 1]").at(4, "color");
    bad("file = \"v.nrrd\"\nsize = 2").at(4, "size");
    bad("generate = \"bal\"").at(3, "\"bal\"").suggests("ball");
    bad("stepp = 1").at(3, "stepp").suggests("step");
    bad_toml("[[volume]]\ngenerate = \"ball\"\ntransfer = [{ value = 0, colour = [1, 1, 1], density = 0 }]\n")
        .at(3, "colour")
        .suggests("color");
}

#[test]
fn a_volume_needs_samples_once() {
    bad("").says("without samples").suggests("shepp-logan");
    bad("file = \"v.nrrd\"\ngenerate = \"ball\"")
        .at(4, "\"ball\"")
        .says("either");
    assert_eq!(bad("file = \"v.nrrd\"").file, "v.nrrd");
}

#[test]
fn a_volume_needs_a_transfer_function_in_order() {
    let with = |transfer: &str| bad_toml(&format!("[[volume]]\ngenerate = \"ball\"\n{transfer}\n"));
    with("").says("transfer");
    with("transfer = []").says("missing");
    with("transfer = 3").suggests("tables");
    with("transfer = [{ value = 0, color = [1, 1, 1] }]").says("`density` is missing");
    with("transfer = [{ color = [1, 1, 1], density = 1 }]").says("`value` is missing");
    with("transfer = [{ value = 0, density = 1 }]").says("`color` is missing");
    with("transfer = [{ value = 0, color = [1, 1, 1], density = -1 }]").at(3, "-1");
    with("transfer = [{ value = nan, color = [1, 1, 1], density = 1 }]").at(3, "nan");
    with("transfer = [{ value = 1, color = [1, 1, 1], density = 1 }, { value = 0, color = [1, 1, 1], density = 1 }]")
        .says("point 2");
}

#[test]
fn steps_and_transforms_have_ranges() {
    for step in ["0", "-1", "nan", "1e-9", "1e9"] {
        bad(&format!("generate = \"ball\"\nstep = {step}"))
            .at(4, step)
            .suggests("0.001");
    }
    bad("generate = \"ball\"\ntransform = { translate = [1e30, 0, 0] }").says("first sample");
    bad("generate = \"ball\"\ntransform = { scale = [1e6, 1, 1] }").says("voxels");
}

#[test]
fn every_generator_refuses_what_is_out_of_range_and_names_the_key() {
    for (keys, line, token) in [
        ("generate = \"constant\"\nvalue = 1e7", 4, "1e7"),
        ("generate = \"constant\"\nsize = 0", 4, "0"),
        ("generate = \"constant\"\nsamples = 1", 4, "1"),
        ("generate = \"constant\"\nsamples = 513", 4, "513"),
        ("generate = \"ball\"\nradius = 0", 4, "0"),
        ("generate = \"ball\"\nsoftness = -1", 4, "-1"),
        ("generate = \"gradient\"\nfrom = inf", 4, "inf"),
        ("generate = \"gradient\"\nto = 1e30", 4, "1e30"),
        ("generate = \"shepp-logan\"\nsamples = 0", 4, "0"),
        ("generate = \"potential\"\nsoftness = 0", 4, "0"),
        ("generate = \"potential\"\natoms = []", 4, "[]"),
        (
            "generate = \"potential\"\natoms = [[0, 0, 0, 1e9]]",
            4,
            "[[0, 0, 0, 1e9]]",
        ),
        ("generate = \"ejection\"\nfront = 0", 4, "0"),
        ("generate = \"ejection\"\nspread = 180", 4, "180"),
        ("generate = \"ejection\"\npart = \"light\"", 4, "\"light\""),
        ("generate = \"swirl\"\ncore = 0", 4, "0"),
        ("generate = \"swirl\"\nwinding = 2", 4, "2"),
        ("generate = \"swirl\"\nturns = 11", 4, "11"),
        ("generate = \"swirl\"\njet = -1", 4, "-1"),
    ] {
        bad(keys).at(line, token);
    }
    bad("generate = \"potential\"\natoms = [[0, 0, 0]]").suggests("four numbers");
    let atoms = vec!["[0, 0, 0, 1]"; 40].join(", ");
    bad(&format!(
        "generate = \"potential\"\nsamples = 512\natoms = [{atoms}]"
    ))
    .at(4, "512");
}

/// Each sample against a rule of the test's own.
#[track_caller]
fn follows(volume: Result<Volume>, rule: impl Fn(DVec3) -> f64) {
    let volume = volume.unwrap();
    let [x, y, _] = volume.dims();
    for (number, &sample) in volume.samples().iter().enumerate() {
        let index = [number % x, number / x % y, number / (x * y)];
        let index = DVec3::from_array(index.map(|i| i as f64));
        let point = volume.index_to_world().transform_point3(index);
        // Parameters and samples are f32.
        assert!(
            (rule(point) - f64::from(sample)).abs() < 1e-5,
            "{point} {sample}"
        );
    }
}

#[test]
fn constant_gradient_and_ball_follow_their_rules() {
    follows(
        constant(&Constant {
            value: 3.0,
            ..Constant::default()
        }),
        |_| 3.0,
    );
    let lattice = Lattice {
        size: 4.0,
        samples: 7,
    };
    follows(
        gradient(&Gradient {
            lattice,
            from: -1.0,
            to: 5.0,
        }),
        |p| 2.0 + 1.5 * p.z,
    );
    let hard = Ball {
        lattice,
        radius: 1.5,
        softness: 0.0,
        value: 2.0,
    };
    follows(ball(&hard), |p| if p.length() <= 1.5 { 2.0 } else { 0.0 });
}

#[test]
fn a_soft_ball_has_the_volume_of_a_hard_one_and_a_little_more() {
    let (radius, soft) = (0.7_f64, 0.2_f64);
    let parameters = Ball {
        radius: 0.7,
        softness: 0.2,
        ..Ball::default()
    };
    let found = ball(&parameters).unwrap();
    let cell = found.voxel().powi(3);
    let sum: f64 = found
        .samples()
        .iter()
        .map(|&sample| f64::from(sample) * cell)
        .sum();
    // A smooth step's slope is a density of radii with the mean r and the variance s^2/5:
    // the mean of r^3 is r^3 + 3 r s^2/5.
    let cubed = radius.powi(3) + 3.0 * radius * soft * soft / 5.0;
    let expected = 4.0 / 3.0 * std::f64::consts::PI * cubed;
    assert!((sum / expected - 1.0).abs() < 1e-3, "{sum} {expected}");
}

#[test]
fn the_phantom_has_its_known_values() {
    let head = shepp_logan(&SheppLogan {
        lattice: Lattice {
            size: 2.0,
            samples: 201,
        },
        softness: 0.0,
    })
    .unwrap();
    for (place, value) in [
        ([0.0, 0.0, 0.0], 0.2),
        ([0.0, 0.9, 0.0], 1.0),
        ([0.68, 0.0, 0.0], 1.0),
        ([0.0, 0.0, 0.8], 1.0),
        ([0.22, 0.0, 0.0], 0.0),
        ([-0.22, 0.0, 0.0], 0.0),
        ([0.0, 0.35, -0.15], 0.3),
        ([0.0, 0.1, 0.25], 0.3),
        ([0.0, -0.1, 0.25], 0.3),
        ([-0.08, -0.61, 0.0], 0.3),
        ([0.7, 0.7, 0.0], 0.0),
        ([0.0, 0.0, 0.9], 0.0),
        // The ventricles lean outwards at the top: the left one to the left.
        ([-0.3, 0.3, 0.0], 0.0),
        ([0.3, -0.2, 0.0], 0.2),
    ] {
        let found = head.at(place.into()).unwrap();
        assert!((found - value).abs() < 1e-6, "{place:?} {found} {value}");
    }
}

/// Rings in images come from here: between two rays side by side, a hard surface moves by a whole sample or not at all.
#[test]
fn the_phantom_with_soft_edges_lets_as_much_light_through_as_the_ellipsoids_do() {
    let samples = 96;
    let spacing = 2.0 / (samples - 1) as f64;
    let largest_error = |softness: f64| {
        let lattice = Lattice { size: 2.0, samples };
        let softness = softness as f32;
        let head = shepp_logan(&SheppLogan { lattice, softness }).unwrap();
        // Lines from the chin to the crown, where there is only skull and brain. A chord of each ellipsoid has a closed
        // form.
        let error = |x: f64| {
            let y = 0.7;
            let chord = |axes: [f64; 3], y: f64| {
                2.0 * axes[2] * (1.0 - (x / axes[0]).powi(2) - (y / axes[1]).powi(2)).sqrt()
            };
            let exact =
                chord([0.69, 0.92, 0.81], y) - 0.8 * chord([0.6624, 0.874, 0.78], y + 0.0184);
            let heights = (0..8 * samples).map(|n| f64::from(n) * spacing / 8.0 - 1.0);
            let values = heights.filter_map(|z| head.at([x, y, z].into()));
            (values.sum::<f64>() * spacing / 8.0 - exact).abs()
        };
        (-20..=20)
            .map(|n| error(f64::from(n) * 0.005))
            .fold(0.0, f64::max)
    };
    let (hard, soft) = (largest_error(0.0), largest_error(2.0 * spacing));
    println!("largest error of a line's sum: {hard:.5} with hard edges, {soft:.5} with soft ones");
    assert!(soft < hard / 4.0, "{soft} {hard}");
}

#[test]
fn potentials_follow_coulomb() {
    let one = Potential {
        lattice: Lattice {
            size: 4.0,
            samples: 9,
        },
        atoms: vec![Atom {
            position: [0.5, 0.0, 0.0],
            charge: 2.0,
        }],
        softness: 0.1,
    };
    let distance = |p: DVec3| p.distance(DVec3::X * 0.5);
    follows(potential(&one), |p| {
        2.0 / distance(p).hypot(f64::from(0.1_f32))
    });
    let water = potential(&Potential::default()).unwrap();
    // Negative at the oxygen, positive beyond the hydrogens, and the same left and right.
    assert!(water.at(DVec3::ZERO).unwrap() < -0.5);
    assert!(water.at(DVec3::new(1.5, -1.2, 0.0)).unwrap() > 0.05);
    let [left, right] = [-1.0, 1.0].map(|x| water.at(DVec3::new(x, -0.5, 0.3)).unwrap());
    assert!((left - right).abs() < 1e-6);
}

#[test]
fn an_ejection_runs_along_x_in_two_fields_from_0_to_1() {
    let part = |part| {
        ejection(&Ejection {
            part,
            ..Ejection::default()
        })
        .unwrap()
    };
    let fields = [EjectionPart::Particles, EjectionPart::Energy].map(part);
    for field in &fields {
        assert!(
            field
                .samples()
                .iter()
                .all(|sample| (0.0..=1.0).contains(sample))
        );
        let along = |x: f64| field.at(DVec3::X * x).unwrap();
        let strongest = (0..100)
            .map(|i| f64::from(i) / 100.0)
            .max_by(|a, b| along(*a).total_cmp(&along(*b)));
        assert!((strongest.unwrap() - 0.65).abs() < 0.03, "{strongest:?}");
        assert!(along(-0.65) < 0.05);
    }
    let aside = DVec3::new(0.39, 0.5, 0.0);
    let [particles, energy] = fields.map(|field| field.at(aside).unwrap());
    assert!(particles > 2.0 * energy, "{particles} {energy}");
}

#[test]
fn a_swirl_turns_without_sources_and_is_no_faster_than_said() {
    let flow = Swirl {
        jet: 0.0,
        ..Swirl::default()
    };
    let step = 1e-4;
    for i in 0..50 {
        let f = f64::from(i);
        let point = DVec3::new((f * 0.37).sin(), (f * 0.73).cos(), (f * 0.11).sin()) * 0.9;
        let slope = |axis: DVec3| {
            (flow.velocity(point + axis * step) - flow.velocity(point - axis * step)).dot(axis)
                / (2.0 * step)
        };
        let divergence = slope(DVec3::X) + slope(DVec3::Y) + slope(DVec3::Z);
        // Differences over 1e-4 of a field that changes over 0.2: second order, about 1e-6 relative.
        assert!(divergence.abs() < 1e-5, "{point} {divergence}");
        assert!(flow.velocity(point).length() <= 0.6382);
    }
    follows(swirl(&flow), |p| flow.velocity(p).length());
    let jet = Swirl {
        winding: 0.0,
        jet: 2.0,
        ..Swirl::default()
    };
    assert_eq!(jet.velocity(DVec3::ZERO), DVec3::Z * 2.0);
}

#[test]
fn samples_are_interpolated_and_end_at_the_box() {
    let samples = vec![0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0];
    let cube = Volume::new("cube", [2; 3], samples, glam::DAffine3::IDENTITY).unwrap();
    assert_eq!(cube.at(DVec3::new(0.25, 0.5, 0.75)), Some(0.25 + 1.0 + 3.0));
    assert_eq!(cube.at(DVec3::ONE), Some(7.0));
    assert_eq!(cube.at(DVec3::new(1.0, 1.0, 1.0001)), None);
    assert_eq!(cube.at(DVec3::new(-1e-9, 0.0, 0.0)), None);
}

#[test]
fn transfer_functions_are_linear_between_points_and_may_jump() {
    let point = |value, density| TransferPoint {
        value,
        color: [density / 8.0; 3],
        density,
    };
    let transfer = Transfer::new(vec![
        point(1.0, 2.0),
        point(3.0, 4.0),
        point(3.0, 8.0),
        point(5.0, 0.0),
    ])
    .unwrap();
    for (value, density) in [
        (-9.0, 2.0),
        (1.0, 2.0),
        (2.0, 3.0),
        (3.0, 8.0),
        (4.0, 4.0),
        (5.0, 0.0),
        (9.0, 0.0),
    ] {
        assert_eq!(transfer.at(value).density, density, "{value}");
        assert_eq!(transfer.at(value).color, DVec3::splat(density / 8.0));
    }
    let usage = |points: Vec<TransferPoint>| match Transfer::new(points) {
        Err(Error::Scene { what, .. }) => what,
        other => panic!("{other:?}"),
    };
    assert!(usage(vec![]).contains("missing"));
    assert!(usage(vec![point(1.0, 2.0), point(0.5, 2.0)]).contains("point 2"));
    assert!(usage(vec![point(f32::NAN, 2.0)]).contains("point 1"));
    let thin = TransferPoint {
        density: -1.0,
        ..point(0.0, 0.0)
    };
    assert!(usage(vec![thin]).contains("density"));
    assert!(
        usage(vec![TransferPoint {
            color: [2.0; 3],
            ..point(0.0, 1.0)
        }])
        .contains("colour")
    );
}

#[test]
fn volumes_from_code_are_checked() {
    let usage =
        |dims, count: usize, placement| match Volume::new("v", dims, vec![0.0; count], placement) {
            Err(Error::Scene { what, .. }) => what,
            other => panic!("{other:?}"),
        };
    let unit = glam::DAffine3::IDENTITY;
    assert!(usage([2, 2, 1], 4, unit).contains("1 samples"));
    assert!(usage([2, 2, 2], 7, unit).contains("7 samples"));
    assert!(usage([usize::MAX; 3], 7, unit).contains("more than"));
    assert!(usage([2, 2, 2], 8, glam::DAffine3::ZERO).contains("0 apart"));
}
