//! Fitting a camera to the scene's bounds.

use glam::DVec3;

use super::axes::Axes;
use super::bounds::Bounds;
use super::camera::Camera;

/// The parts of a camera that are given. The others are fitted, all of them by default:
///
/// - `target`: the middle of the bounds.
/// - `up`: y, or z for an eye straight above or below the target.
/// - `eye`: a three-quarter view from above, just far enough away to see all of the bounds.
/// - `fov`: 30 degrees, or with a given `eye` just wide enough to see all of the bounds, at most 120 degrees.
/// - `near` and `far`: close around the bounds; if the eye is inside them, `near` is a thousandth of `far`.
///
/// An empty scene is seen as if it held a cube from -1 to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PartialCamera {
    /// The eye's position.
    pub eye: Option<DVec3>,
    /// The point that the camera looks at.
    pub target: Option<DVec3>,
    /// The direction that is up in the image.
    pub up: Option<DVec3>,
    /// Vertical field of view in degrees.
    pub fov: Option<f64>,
    /// Distance of the near plane.
    pub near: Option<f64>,
    /// Distance of the far plane.
    pub far: Option<f64>,
}

/// The largest part of half the image that a fitted object fills.
const FILLED: f64 = 0.95;
/// The default of [`PartialCamera::fov`], in degrees.
const FOV: f64 = 30.0;
/// The widest field of view that is fitted, in degrees. With a wider one, perspective looks absurd.
const WIDEST: f64 = 120.0;
/// The margin of the clip planes, as a part of the depth between them and of their distance.
const MARGIN: f64 = 0.01;

impl PartialCamera {
    /// The whole camera for an image of `size` pixels. It is impossible if the given parts are: see [`Camera::check`].
    pub fn fit(&self, bounds: Option<Bounds>, size: [u32; 2]) -> Camera {
        let bounds = bounds.unwrap_or(Bounds {
            min: DVec3::NEG_ONE,
            max: DVec3::ONE,
        });
        let aspect = f64::from(size[0].max(1)) / f64::from(size[1].max(1));
        let target = self.target.unwrap_or_else(|| self.fitted_target(&bounds));
        let up = self.up.unwrap_or_else(|| self.fitted_up(target));
        let (eye, fov) = match self.eye {
            Some(eye) => {
                let fitted = || fitted_fov(&bounds, &Axes::of(target - eye, up), eye, aspect);
                (eye, self.fov.unwrap_or_else(fitted))
            }
            None => {
                let fov = self.fov.unwrap_or(FOV);
                (fitted_eye(&bounds, target, up, fov, aspect), fov)
            }
        };
        let (near, far) = self.planes(&bounds, eye, target);
        Camera {
            eye,
            target,
            up,
            fov,
            near,
            far,
        }
    }

    fn fitted_target(&self, bounds: &Bounds) -> DVec3 {
        let centre = bounds.centre();
        match self.eye {
            Some(eye) if eye == centre => eye - DVec3::Z * longest(bounds).max(1.0),
            _ => centre,
        }
    }

    fn fitted_up(&self, target: DVec3) -> DVec3 {
        let direction = self.eye.map(|eye| (target - eye).normalize_or_zero());
        match direction {
            // Within some two degrees of the vertical, y does not tell which way is up.
            Some(direction) if direction.y.abs() > 0.999 => DVec3::Z,
            _ => DVec3::Y,
        }
    }

    fn planes(&self, bounds: &Bounds, eye: DVec3, target: DVec3) -> (f64, f64) {
        let direction = (target - eye).normalize_or(DVec3::NEG_Z);
        let [nearest, farthest] = depths(bounds, eye, direction);
        let pad = padding(nearest, farthest);
        let far = if farthest > 0.0 {
            farthest + pad
        } else {
            // All of the scene is behind the eye, so any range will do.
            (target - eye).length() * 10.0
        };
        let near = if nearest > 0.0 {
            (nearest - pad).max(nearest * 0.5)
        } else {
            far * 1e-3
        };
        match (self.near, self.far) {
            (Some(near), Some(far)) => (near, far),
            (Some(near), None) => (near, far.max(near * 2.0)),
            (None, Some(far)) => (near.min(far * 0.5), far),
            (None, None) => (near, far),
        }
    }
}

impl Camera {
    /// The same camera with its near and far plane moved close around `bounds`. They cut off nothing more of what is in
    /// the bounds, and a depth buffer holds finer differences. Both planes stay where they are if no part of the bounds
    /// is between them. The near plane stays where it is if the eye is inside the bounds.
    #[must_use]
    pub fn close_around(self, bounds: Bounds) -> Self {
        let direction = (self.target - self.eye).normalize_or(DVec3::NEG_Z);
        let [nearest, farthest] = depths(&bounds, self.eye, direction);
        let pad = padding(nearest, farthest);
        let near = self.near.max((nearest - pad).max(nearest * 0.5));
        let far = self.far.min(farthest + pad);
        if near < far && farthest > self.near {
            Self { near, far, ..self }
        } else {
            self
        }
    }
}

/// The least and the greatest distance that a box reaches along a direction.
fn depths(bounds: &Bounds, eye: DVec3, direction: DVec3) -> [f64; 2] {
    let depths = bounds.corners().map(|corner| (corner - eye).dot(direction));
    [
        depths.into_iter().fold(f64::INFINITY, f64::min),
        depths.into_iter().fold(f64::NEG_INFINITY, f64::max),
    ]
}

/// The distance of a clip plane from the bounds that it encloses.
fn padding(nearest: f64, farthest: f64) -> f64 {
    MARGIN * (farthest - nearest) + MARGIN * farthest.abs()
}

/// The direction of a three-quarter view: from the front, a little from the right, a little from above.
fn fitted_eye(bounds: &Bounds, target: DVec3, up: DVec3, fov: f64, aspect: f64) -> DVec3 {
    let up = up.normalize_or(DVec3::Y);
    let right = (DVec3::X - up * up.x)
        .try_normalize()
        .unwrap_or(DVec3::NEG_Z);
    let front = right.cross(up);
    let axes = Axes::of(-(front + 0.5 * right + 0.4 * up), up);
    let tangent = (fov.to_radians() / 2.0).tan() * FILLED;
    let needed = bounds.corners().map(|corner| {
        let seen = corner - target;
        let half = (seen.dot(axes.right).abs() / aspect).max(seen.dot(axes.up).abs());
        half / tangent - seen.dot(axes.forward)
    });
    let distance = needed.into_iter().fold(0.0, f64::max);
    // A single point has no size.
    let distance = if distance > 0.0 {
        distance
    } else {
        1.0_f64.max(target.abs().max_element() * 1e-6)
    };
    // Where so small a distance is lost in rounding, it would leave the eye at the target: some fifty roundings are kept.
    let distance = distance.max(target.abs().max_element() * 1e-14);
    target - axes.forward * distance
}

fn fitted_fov(bounds: &Bounds, axes: &Axes, eye: DVec3, aspect: f64) -> f64 {
    let tangents = bounds.corners().map(|corner| {
        let seen = corner - eye;
        let depth = seen.dot(axes.forward);
        let half = (seen.dot(axes.right).abs() / aspect).max(seen.dot(axes.up).abs());
        if depth > 0.0 {
            half / depth
        } else {
            f64::INFINITY
        }
    });
    let tangent = tangents.into_iter().fold(0.0, f64::max) / FILLED;
    if tangent > 0.0 {
        (2.0 * tangent.atan().to_degrees()).clamp(1e-3, WIDEST)
    } else {
        FOV
    }
}

fn longest(bounds: &Bounds) -> f64 {
    bounds.size().max_element()
}
