//! Volumes between surfaces, by the oracle: closed forms for one ray, without OpenGL.

use glam::{DAffine3, DMat3, DVec3};
use onionskin::low_level::oracle::volumes::{Ray, composite};
use onionskin::{Fragment, Rgba, Transfer, TransferPoint, Volume};

const WHITE: Rgba = Rgba::opaque([1.0; 3]);
const BLACK: Rgba = Rgba::opaque([0.0; 3]);
/// f64 sums of at most some thousand terms of size 1.
const ROUNDING: f64 = 1e-12;

/// Along -z from z = 5; distances 0.5 to 20.
fn ray() -> Ray {
    Ray {
        origin: DVec3::Z * 5.0,
        direction: DVec3::NEG_Z,
        near: 0.5,
        far: 20.0,
    }
}

/// One colour, the value as the density.
fn painted(color: [f32; 3]) -> Transfer {
    let point = |value| TransferPoint {
        value,
        color,
        density: value,
    };
    Transfer::new(vec![point(0.0), point(1000.0)]).unwrap()
}

/// A cube from -1 to 1 with one value at its 3 x 3 x 3 samples.
fn fog(value: f32, color: [f32; 3]) -> Volume {
    let placement = DAffine3::from_mat3_translation(DMat3::IDENTITY, DVec3::NEG_ONE);
    let volume = Volume::new("fog", [3; 3], vec![value; 27], placement).unwrap();
    volume.with_transfer(painted(color))
}

/// `volume`, elsewhere along z and longer there.
fn placed(volume: &Volume, from: f64, to: f64) -> Volume {
    let placement = DAffine3::from_mat3_translation(
        DMat3::from_diagonal(DVec3::new(1.0, 1.0, (to - from) / 2.0)),
        DVec3::new(-1.0, -1.0, from),
    );
    let placed = Volume::new(
        "placed",
        volume.dims(),
        volume.samples().to_vec(),
        placement,
    );
    placed.unwrap().with_transfer(volume.transfer.clone())
}

/// A fragment at a distance, up to the rounding of its depth to f32, which is given back as a distance.
fn pane(distance: f64, color: [f32; 4], order: u32) -> (Fragment, f64) {
    let Ray { near, far, .. } = ray();
    let depth = (far * (distance - near) / (distance * (far - near))) as f32;
    let fragment = Fragment {
        depth,
        color: color.into(),
        order,
    };
    (fragment, ray().distance(depth))
}

fn seen(fragments: &[Fragment], background: Rgba, volumes: &[Volume]) -> [f64; 4] {
    composite(&mut fragments.to_vec(), 1.0, background, &ray(), volumes)
}

#[track_caller]
fn near(found: f64, expected: f64) {
    assert!(
        (found - expected).abs() <= ROUNDING,
        "{found} is not {expected}"
    );
}

#[test]
fn l16_constant_fog_lets_exp_minus_sigma_l_through() {
    for sigma in [0.0, 0.01, 0.7, 3.0, 20.0] {
        let [light, _, blue, opacity] = seen(&[], WHITE, &[fog(sigma, [0.25, 0.5, 0.0])]);
        let clear = (-f64::from(sigma) * 2.0).exp();
        near(light, 0.25 * (1.0 - clear) + clear);
        near(blue, clear);
        near(opacity, 1.0);
    }
}

#[test]
fn l16_the_step_does_not_matter_to_constant_fog() {
    let mut volume = fog(0.7, [0.25; 3]);
    for step in [0.001, 0.03, 0.3, 0.5, 0.77, 1.0, 1.9, 2.0, 50.0] {
        volume.step = step;
        near(
            seen(&[], BLACK, &[volume.clone()])[0],
            0.25 * (1.0 - (-2.0 * f64::from(0.7_f32)).exp()),
        );
    }
}

#[test]
fn l16_a_last_step_that_is_not_cut_would_be_noticed() {
    let mut volume = fog(0.7, [1.0; 3]);
    volume.step = 0.3;
    let found = seen(&[], BLACK, &[volume])[0];
    // 0.3 voxels of length 1 are 7 steps in a length of 2, the last one too long by 0.1.
    let uncut = 1.0 - (-0.7_f64 * 2.1).exp();
    assert!((found - uncut).abs() > 1e-2, "{found} {uncut}");
}

#[test]
fn l16_invisible_surfaces_cut_the_ray_and_change_nothing() {
    let volumes = [fog(0.7, [0.25; 3]), placed(&fog(1.3, [0.75; 3]), -0.3, 3.0)];
    let whole = seen(&[], WHITE, &volumes);
    for count in [1, 2, 7, 50] {
        let cuts: Vec<_> = (0..count)
            .map(|i| {
                pane(
                    1.5 + 5.0 * f64::from(i) / f64::from(count),
                    [1.0, 0.0, 0.0, 0.0],
                    i,
                )
                .0
            })
            .collect();
        let cut = seen(&cuts, WHITE, &volumes);
        for channel in 0..4 {
            near(cut[channel], whole[channel]);
        }
    }
}

#[test]
fn l16_overlapping_constants_add() {
    let whole = seen(&[], WHITE, &[fog(1.9, [0.25; 3])]);
    let parts = [0.4, 1.5].map(|sigma| fog(sigma, [0.25; 3]));
    // 0.4 + 1.5 as f32 differ from 1.9 by up to 2e-7.
    assert!((seen(&[], WHITE, &parts)[0] - whole[0]).abs() < 1e-6);
    let colours = [fog(1.0, [1.0, 0.0, 0.0]), fog(3.0, [0.0, 1.0, 0.0])];
    let [red, green, blue, _] = seen(&[], BLACK, &colours);
    let opacity = 1.0 - (-8.0_f64).exp();
    near(red, 0.25 * opacity);
    near(green, 0.75 * opacity);
    near(blue, 0.0);
}

#[test]
fn l16_partly_overlapping_volumes_are_seen_in_their_parts() {
    // Seen from z = 5: green alone from 2 to 1, both from 1 to 0, red alone from 0 to -1.
    let volumes = [
        fog(0.8, [1.0, 0.0, 0.0]),
        placed(&fog(0.5, [0.0, 1.0, 0.0]), 0.0, 2.0),
    ];
    let [red, green, ..] = seen(&[], BLACK, &volumes);
    let clear = |sigma: f64| (-sigma).exp();
    let [first, second] = [clear(0.5), clear(0.5) * clear(1.3)];
    let both = first * (1.0 - clear(1.3));
    // Densities and colours are f32.
    let close = |found: f64, expected: f64| assert!((found - expected).abs() < 1e-7);
    close(green, 1.0 - first + both * 0.5 / 1.3);
    close(red, both * 0.8 / 1.3 + second * (1.0 - clear(0.8)));
}

#[test]
fn l16_the_order_of_the_volumes_does_not_matter() {
    let volumes = [
        fog(0.8, [1.0, 0.0, 0.0]),
        placed(&fog(0.5, [0.0, 1.0, 0.0]), 0.0, 2.0),
    ];
    let turned = [volumes[1].clone(), volumes[0].clone()];
    let (one, other) = (seen(&[], WHITE, &volumes), seen(&[], WHITE, &turned));
    (0..4).for_each(|channel| near(one[channel], other[channel]));
}

#[test]
fn l16_panes_before_inside_and_behind() {
    let (sigma, alpha) = (f64::from(0.7_f32), 0.5);
    // The fog is at distances 4 to 6.
    for (distance, before) in [(2.0, 0.0), (5.25, 1.25), (9.0, 2.0)] {
        let (fragment, exactly) = pane(distance, [0.0, 0.0, 1.0, 0.5], 0);
        let before = if before == 1.25 {
            exactly - 4.0
        } else {
            before
        };
        let [red, _, blue, _] = seen(&[fragment], BLACK, &[fog(0.7, [1.0, 0.0, 0.0])]);
        let [ahead, behind] = [before, 2.0 - before].map(|length| (-sigma * length).exp());
        near(blue, ahead * alpha);
        near(red, 1.0 - ahead + ahead * (1.0 - alpha) * (1.0 - behind));
    }
}

#[test]
fn l16_an_opaque_depth_ends_the_ray() {
    let volume = fog(0.7, [1.0, 0.0, 0.0]);
    for distance in [2.0, 4.5, 9.0] {
        let (wall, exactly) = pane(distance, [0.0; 4], 0);
        let found = composite(
            &mut vec![],
            wall.depth,
            WHITE,
            &ray(),
            std::slice::from_ref(&volume),
        );
        let length = (exactly - 4.0).clamp(0.0, 2.0);
        near(found[1], (-f64::from(0.7_f32) * length).exp());
    }
}

#[test]
fn l16_an_eye_inside_sees_from_the_near_plane_on() {
    let mut inside = ray();
    inside.origin = DVec3::ZERO;
    // From z = -0.5, the near plane, to -1.
    let found = composite(&mut vec![], 1.0, WHITE, &inside, &[fog(0.7, [0.0; 3])]);
    near(found[0], (-f64::from(0.7_f32) * 0.5).exp());
    // Two of them, and one more before them.
    let volumes = [
        fog(0.7, [0.0; 3]),
        placed(&fog(0.4, [0.0; 3]), -0.75, 3.0),
        placed(&fog(2.0, [0.0; 3]), -4.0, -3.0),
    ];
    let found = composite(&mut vec![], 1.0, WHITE, &inside, &volumes);
    let depth = f64::from(0.7_f32) * 0.5 + f64::from(0.4_f32) * 0.25 + 2.0;
    near(found[0], (-depth).exp());
}

#[test]
fn l16_planes_cut_volumes() {
    let mut short = ray();
    (short.near, short.far) = (4.5, 5.0);
    let found = composite(&mut vec![], 1.0, WHITE, &short, &[fog(0.7, [0.0; 3])]);
    near(found[0], (-f64::from(0.7_f32) * 0.5).exp());
    (short.near, short.far) = (0.5, 3.0);
    assert_eq!(
        composite(&mut vec![], 1.0, WHITE, &short, &[fog(0.7, [0.0; 3])])[0],
        1.0
    );
}

#[test]
fn l16_volumes_behind_or_beside_are_not_seen() {
    let mut beside = ray();
    beside.origin.x = 1.5;
    let mut away = ray();
    away.direction = DVec3::Z;
    for ray in [beside, away] {
        let found = composite(&mut vec![], 1.0, WHITE, &ray, &[fog(5.0, [0.0; 3])]);
        assert_eq!(found, [1.0; 4]);
    }
}

#[test]
fn l16_a_slanted_ray_is_longer() {
    let mut slanted = ray();
    slanted.direction = DVec3::new(0.1, 0.05, -1.0);
    slanted.origin = DVec3::new(-0.5, -0.25, 5.0);
    let found = composite(&mut vec![], 1.0, WHITE, &slanted, &[fog(0.7, [0.0; 3])]);
    let length = 2.0 * (1.0_f64 + 0.01 + 0.0025).sqrt();
    near(found[0], (-f64::from(0.7_f32) * length).exp());
}

/// From `first` at z = 1 to `last` at z = -1, in two samples.
fn along_the_ray(first: TransferPoint, last: TransferPoint) -> Volume {
    let placement =
        DAffine3::from_mat3_translation(DMat3::from_diagonal(DVec3::splat(2.0)), DVec3::NEG_ONE);
    let samples = [last.value, first.value]
        .into_iter()
        .flat_map(|value| [value; 4]);
    let volume = Volume::new("gradient", [2; 3], samples.collect(), placement).unwrap();
    volume.with_transfer(Transfer::new(vec![first, last]).unwrap())
}

const THIN: TransferPoint = TransferPoint {
    value: 0.0,
    color: [0.0; 3],
    density: 0.0,
};

#[test]
fn l16_a_linear_density_is_exact_at_any_step() {
    // The middle of a step has its mean density, and only the mean counts.
    let mut volume = along_the_ray(
        THIN,
        TransferPoint {
            value: 1.0,
            density: 1.5,
            ..THIN
        },
    );
    for step in [0.01, 0.3, 0.5, 2.0] {
        volume.step = step;
        near(seen(&[], WHITE, &[volume.clone()])[0], (-1.5_f64).exp());
    }
}

#[test]
fn l16_a_linear_colour_converges_with_the_square_of_the_step() {
    let sigma = 1.5;
    let first = TransferPoint {
        density: 1.5,
        ..THIN
    };
    let mut volume = along_the_ray(
        first,
        TransferPoint {
            value: 1.0,
            color: [1.0; 3],
            ..first
        },
    );
    // The integral of sigma (s/L) exp(-sigma s) over 0..L, with L = 2.
    let through = sigma * 2.0_f64;
    let exact = (1.0 - (-through).exp() * (1.0 + through)) / through;
    let errors = [8.0, 16.0, 32.0, 64.0].map(|steps| {
        volume.step = 1.0 / steps;
        (seen(&[], BLACK, &[volume.clone()])[0] - exact).abs()
    });
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((order - 2.0).abs() < 0.02, "{order} {errors:?}");
    }
}

#[test]
fn the_ray_of_a_pixel_goes_through_its_centre() {
    let camera = onionskin::Camera {
        eye: DVec3::Z * 5.0,
        target: DVec3::ZERO,
        up: DVec3::Y,
        fov: 90.0,
        near: 1.0,
        far: 10.0,
    };
    let ray = Ray::through(&camera, [4, 2], [3, 0]);
    assert!(ray.direction.distance(DVec3::new(1.5, -0.5, -1.0)) < 1e-15);
    assert_eq!([ray.distance(0.0), ray.distance(1.0)], [1.0, 10.0]);
}
