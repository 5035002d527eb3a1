//! The fitted camera sees everything, whatever is given and whatever is left out.

use crate::kit::scene::{Folder, obj, toml};
use glam::{DVec3, Vec4Swizzles};
use onionskin::Camera;
use onionskin::low_level::scene::{Bounds, PartialCamera};
use proptest::prelude::*;

fn bounds(min: [f64; 3], max: [f64; 3]) -> Bounds {
    Bounds {
        min: DVec3::from_array(min),
        max: DVec3::from_array(max),
    }
}

fn unit_cube() -> Bounds {
    bounds([-1.0; 3], [1.0; 3])
}

/// The corners in normalised device coordinates; what is seen is between -1 and 1 in each.
fn projected(camera: &Camera, bounds: &Bounds, [width, height]: [u32; 2]) -> [DVec3; 8] {
    let to_clip = camera.projection(width, height) * camera.view();
    bounds.corners().map(|corner| {
        let clip = to_clip * corner.extend(1.0);
        clip.xyz() / clip.w
    })
}

fn sees_all(camera: &Camera, bounds: &Bounds, size: [u32; 2]) -> bool {
    let inside = |corner: DVec3| corner.abs().max_element() <= 1.0;
    projected(camera, bounds, size).into_iter().all(inside)
}

#[test]
fn the_whole_of_the_bounds_is_seen() {
    let camera = PartialCamera::default().fit(Some(unit_cube()), [1024, 768]);
    assert!(sees_all(&camera, &unit_cube(), [1024, 768]));
}

#[test]
fn a_camera_nearer_by_a_tenth_does_not_see_it_all() {
    // The control of the test above: its comparison can fail, and the fit is tight.
    let mut camera = PartialCamera::default().fit(Some(unit_cube()), [1024, 768]);
    camera.eye = camera.target + (camera.eye - camera.target) * 0.9;
    assert!(!sees_all(&camera, &unit_cube(), [1024, 768]));
}

#[test]
fn the_bounds_fill_most_of_the_picture() {
    let camera = PartialCamera::default().fit(Some(unit_cube()), [1024, 768]);
    let corners = projected(&camera, &unit_cube(), [1024, 768]);
    let reach = corners.map(|corner| corner.x.abs().max(corner.y.abs()));
    assert!(reach.into_iter().fold(0.0, f64::max) > 0.9);
}

#[test]
fn the_planes_enclose_the_bounds_closely() {
    let camera = PartialCamera::default().fit(Some(unit_cube()), [1024, 768]);
    let direction = (camera.target - camera.eye).normalize();
    let depths = unit_cube()
        .corners()
        .map(|c| (c - camera.eye).dot(direction));
    let nearest = depths.into_iter().fold(f64::INFINITY, f64::min);
    let farthest = depths.into_iter().fold(0.0, f64::max);
    let range = farthest - nearest;
    assert!(camera.near < nearest && camera.near > nearest - 0.1 * range);
    assert!(camera.far > farthest && camera.far < farthest + 0.1 * range);
}

#[test]
fn the_view_is_from_above_the_right_and_the_front() {
    let camera = PartialCamera::default().fit(Some(unit_cube()), [1024, 768]);
    assert!(camera.eye.cmpgt(DVec3::splat(1.0)).all(), "{}", camera.eye);
}

#[test]
fn a_tall_picture_sees_all_of_a_wide_thing() {
    let wide = bounds([-10.0, -1.0, -1.0], [10.0, 1.0, 1.0]);
    let camera = PartialCamera::default().fit(Some(wide), [100, 1000]);
    assert!(sees_all(&camera, &wide, [100, 1000]));
}

#[test]
fn a_single_point_is_in_the_middle() {
    let point = bounds([5.0, 6.0, 7.0], [5.0, 6.0, 7.0]);
    let camera = PartialCamera::default().fit(Some(point), [64, 64]);
    assert!(camera.check().is_ok(), "{camera:?}");
    assert!(sees_all(&camera, &point, [64, 64]));
}

#[test]
fn a_single_point_far_out_is_seen_as_well() {
    let point = bounds([3e38; 3], [3e38; 3]);
    let camera = PartialCamera::default().fit(Some(point), [64, 64]);
    assert!(camera.check().is_ok(), "{camera:?}");
}

#[test]
fn an_empty_scene_has_a_camera_that_works() {
    let camera = PartialCamera::default().fit(None, [64, 64]);
    assert!(camera.check().is_ok(), "{camera:?}");
}

#[test]
fn an_eye_at_the_middle_of_the_bounds_looks_along_minus_z() {
    let partial = PartialCamera {
        eye: Some(DVec3::ZERO),
        ..PartialCamera::default()
    };
    let camera = partial.fit(Some(unit_cube()), [64, 64]);
    assert!(camera.check().is_ok(), "{camera:?}");
    assert!(camera.target.z < 0.0);
}

#[test]
fn an_eye_straight_above_has_another_up() {
    let partial = PartialCamera {
        eye: Some(DVec3::new(0.0, 9.0, 0.0)),
        ..PartialCamera::default()
    };
    let camera = partial.fit(Some(unit_cube()), [64, 64]);
    assert!(camera.check().is_ok(), "{camera:?}");
    assert!(sees_all(&camera, &unit_cube(), [64, 64]));
}

#[test]
fn a_given_eye_gets_a_field_of_view_that_sees_all() {
    let partial = PartialCamera {
        eye: Some(DVec3::new(20.0, 5.0, 30.0)),
        ..PartialCamera::default()
    };
    let camera = partial.fit(Some(unit_cube()), [100, 300]);
    assert!(sees_all(&camera, &unit_cube(), [100, 300]));
    assert!(camera.fov < 15.0);
}

#[test]
fn what_is_given_is_kept() {
    let partial = PartialCamera {
        eye: Some(DVec3::new(1.0, 2.0, 3.0)),
        target: Some(DVec3::new(0.5, 0.0, 0.0)),
        up: Some(DVec3::X),
        fov: Some(77.0),
        near: Some(0.25),
        far: Some(123.0),
    };
    let camera = partial.fit(Some(unit_cube()), [64, 64]);
    assert_eq!(Some(camera.eye), partial.eye);
    assert_eq!(Some(camera.target), partial.target);
    assert_eq!(Some(camera.up), partial.up);
    assert_eq!(Some(camera.fov), partial.fov);
    assert_eq!(Some(camera.near), partial.near);
    assert_eq!(Some(camera.far), partial.far);
}

#[test]
fn a_scene_behind_the_eye_still_has_planes_in_order() {
    let scene = toml(
        "[camera]\neye = [0, 0, 0]\ntarget = [0, 0, -1]\n[[mesh]]\ngenerate = \"plane\"\ntransform = { translate = [0, 0, 100] }\n",
    );
    assert!(scene.camera.check().is_ok());
}

#[test]
fn a_given_near_plane_beyond_everything_still_has_a_far_plane_beyond_it() {
    let scene = toml("[camera]\nnear = 1e6\n[[mesh]]\ngenerate = \"plane\"\n");
    assert!(scene.camera.far > 1e6);
}

#[test]
fn the_bounds_are_those_after_the_transform() {
    let scene = toml(
        "[[mesh]]\ngenerate = \"plane\"\nsize = [2, 2]\ntransform = { translate = [10, 0, 0] }\n",
    );
    assert_eq!(
        scene.bounds(),
        Some(bounds([9.0, 0.0, -1.0], [11.0, 0.0, 1.0]))
    );
    assert_eq!(scene.camera.target, DVec3::new(10.0, 0.0, 0.0));
}

#[test]
fn a_model_of_nothing_but_degenerate_triangles_has_a_camera() {
    let scene = obj("v 3 3 3\nf 1 1 1\n");
    assert_eq!(scene.triangle_count(), 0);
    assert!(scene.camera.check().is_ok());
}

/// A model as long as a step, 3e38 away, where a distance of a step is lost in rounding.
#[test]
fn a_model_that_is_small_for_its_place_has_a_camera() {
    let text = "v 0 0 0\nv -3e38 0 3e38\nv -3e38 1 3e38\nv 0 0 0\nf -2 -3 -2\n";
    let scene = Folder::new().with("m.obj", text).load("m.obj").unwrap();
    assert!(scene.camera.check().is_ok(), "{:?}", scene.camera);
}

#[test]
fn a_camera_from_code_is_checked_too() {
    let good = PartialCamera::default().fit(None, [64, 64]);
    let bad = [
        Camera { near: 0.0, ..good },
        Camera {
            far: f64::NAN,
            ..good
        },
        Camera { fov: 180.0, ..good },
        Camera {
            target: good.eye,
            ..good
        },
        Camera {
            up: good.target - good.eye,
            ..good
        },
        Camera {
            eye: DVec3::NAN,
            ..good
        },
    ];
    assert!(good.check().is_ok());
    for camera in bad {
        assert!(camera.check().is_err(), "{camera:?}");
    }
}

proptest! {
    #[test]
    fn any_bounds_and_any_picture_are_seen_whole(
        corner in prop::array::uniform3(-1e6..1e6_f64),
        extent in prop::array::uniform3(0.0..1e4_f64),
        size in prop::array::uniform2(1..=4096_u32),
        fov in 1.0..170.0_f64,
    ) {
        let min = DVec3::from_array(corner);
        let box_ = Bounds { min, max: min + DVec3::from_array(extent) };
        let camera = PartialCamera { fov: Some(fov), ..PartialCamera::default() }.fit(Some(box_), size);
        prop_assert!(camera.check().is_ok());
        prop_assert!(sees_all(&camera, &box_, size), "{camera:?}");
    }

    #[test]
    fn the_fitted_view_is_upright_for_any_up(up in prop::array::uniform3(-1.0..1.0_f64)) {
        let up = DVec3::from_array(up);
        prop_assume!(up.length() > 1e-3);
        let camera = PartialCamera { up: Some(up), ..PartialCamera::default() }.fit(Some(unit_cube()), [64, 64]);
        prop_assert!(camera.check().is_ok());
        prop_assert!(sees_all(&camera, &unit_cube(), [64, 64]));
        prop_assert!((camera.eye - camera.target).dot(up) > 0.0);
    }
}
