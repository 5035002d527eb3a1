//! The resolution of depth buffers: which distances they can tell apart.

use super::surfaces::{Meeting, SNAP};
use crate::scene::Camera;

/// A depth buffer between two clip planes: the window-space depth of a distance, and the error of a rasteriser's depth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DepthBuffer {
    near: f64,
    far: f64,
    /// The larger side of the image in pixels.
    size: f64,
    /// The distance of neighbouring values. It is 0 for a float format, whose steps are smaller than the errors before
    /// them.
    step: f64,
    /// How far a rasteriser may move a corner across a slope, in pixels, before it interpolates depths.
    snap: f64,
    /// Whether it holds 1/w in 32-bit float instead of window-space depth.
    inverse_w: bool,
}

impl DepthBuffer {
    /// A depth buffer of 32-bit floats.
    pub fn float(camera: &Camera, [width, height]: [u32; 2]) -> Self {
        Self {
            near: camera.near,
            far: camera.far,
            size: f64::from(width.max(height)),
            step: 0.0,
            snap: 0.0,
            inverse_w: false,
        }
    }

    /// A depth buffer with so many bits for 0 to 1.
    #[must_use]
    pub fn with_bits(self, bits: u32) -> Self {
        let step = 1.0 / (2.0_f64.powi(bits as i32) - 1.0);
        Self { step, ..self }
    }

    /// A depth buffer whose rasteriser snaps corners to a grid of 1/256 pixel before it interpolates depths between them, as
    /// GPUs do: a corner moves by half a step along each axis.
    #[must_use]
    pub fn with_snapped_corners(self) -> Self {
        Self { snap: SNAP, ..self }
    }

    /// A depth buffer of 32-bit floats that holds 1/w, whose error is relative to its value.
    #[must_use]
    pub fn of_inverse_w(self) -> Self {
        Self {
            inverse_w: true,
            ..self
        }
    }

    /// The distance that two surfaces across the view direction must have, at a distance from the eye, to be told
    /// apart.
    pub fn resolution(&self, distance: f64) -> f64 {
        let inverse = 1.0 / distance;
        2.0 * self.noise(inverse, 0.0) / (self.steepness(inverse) * inverse * inverse)
    }

    /// A depth at the distance 1 / `inverse` from the eye. It grows with the distance. It is the window-space depth, or
    /// the logarithm of w, whose equal steps are equal ratios of w.
    pub fn depth(&self, inverse: f64) -> f64 {
        if self.inverse_w {
            return -(self.near * inverse).ln();
        }
        self.far / (self.far - self.near) * (1.0 - self.near * inverse)
    }

    /// The derivative of the depth with respect to `inverse`.
    fn steepness(&self, inverse: f64) -> f64 {
        if self.inverse_w {
            return 1.0 / inverse;
        }
        self.far * self.near / (self.far - self.near)
    }

    /// The error of a surface's depth at a point: the error of the depth of any surface of this slope, and that of the
    /// triangle's shape.
    pub fn noise_at(&self, at: &Meeting) -> f64 {
        self.noise(at.inverse, at.slope) + self.steepness(at.inverse) * at.error
    }

    /// The error of a surface's depth at the distance 1 / `inverse`, if its 1 / distance changes by `slope` from pixel
    /// to pixel.
    ///
    /// Transform, division and interpolation take some eight roundings of 2^-24. They affect the depth itself, and the
    /// place in the image, over which the depth changes. So does a moved corner. The same bound applies to the fragments of
    /// the exact image.
    pub fn noise(&self, inverse: f64, slope: f64) -> f64 {
        let slope = self.steepness(inverse) * slope;
        8.0 * 2.0_f64.powi(-24) * (1.0 + slope * self.size) + slope * self.snap + self.step / 2.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    fn buffer(near: f64, far: f64) -> DepthBuffer {
        let camera = Camera {
            eye: DVec3::ZERO,
            target: DVec3::NEG_Z,
            up: DVec3::Y,
            fov: 40.0,
            near,
            far,
        };
        DepthBuffer::float(&camera, [64, 48])
    }

    /// Whether two panes across the view direction can be told apart.
    fn tells_apart(buffer: &DepthBuffer, near: f64, far: f64) -> bool {
        buffer.depth(1.0 / far) - buffer.depth(1.0 / near) > 2.0 * buffer.noise(1.0 / far, 0.0)
    }

    #[test]
    fn depths_are_0_at_the_near_plane_and_1_at_the_far_plane() {
        let buffer = buffer(0.1, 1000.0);
        assert_eq!(buffer.depth(1.0 / 0.1), 0.0);
        assert_eq!(buffer.depth(1.0 / 1000.0), 1.0 - f64::EPSILON / 2.0);
    }

    #[test]
    fn planes_close_around_two_panes_tell_them_apart_and_distant_ones_do_not() {
        assert!(!tells_apart(&buffer(0.1, 1000.0), 100.0, 100.01));
        assert!(tells_apart(&buffer(99.0, 101.0), 100.0, 100.01));
    }

    #[test]
    fn corners_that_were_snapped_confuse_slopes_and_not_panes() {
        let buffer = buffer(1.0, 10.0);
        let snapped = buffer.with_snapped_corners();
        assert_eq!(buffer.noise(0.5, 0.0), snapped.noise(0.5, 0.0));
        // A corner moves by half of 1/256 pixel along each axis.
        let slope = 0.01;
        let more = snapped.noise(0.5, slope) - buffer.noise(0.5, slope);
        let moved = f64::hypot(1.0, 1.0) / 512.0 * slope * 10.0 / 9.0;
        assert!((more / moved - 1.0).abs() < 1e-9, "{more} {moved}");
    }

    #[test]
    fn what_is_twice_the_resolution_apart_is_told_apart_and_half_of_it_is_not() {
        for buffer in [buffer(0.1, 1000.0), buffer(99.0, 101.0).with_bits(16)] {
            let resolution = buffer.resolution(100.0);
            assert!(tells_apart(&buffer, 100.0, 100.0 + 2.0 * resolution));
            assert!(!tells_apart(&buffer, 100.0, 100.0 + 0.5 * resolution));
        }
    }

    /// The findings have these numbers, in metres.
    #[test]
    fn a_depth_buffer_tells_apart_centimetres_micrometres_or_tenths_of_millimetres() {
        let given = buffer(0.1, 1000.0);
        let buffers = [given, buffer(99.0, 101.0), given.of_inverse_w()];
        let resolutions = buffers.map(|buffer| buffer.resolution(100.0));
        let said = [0.095, 1.9e-6, 9.5e-5];
        for (resolution, said) in resolutions.into_iter().zip(said) {
            // The findings give two digits.
            assert!(
                (resolution / said - 1.0).abs() < 0.03,
                "{resolution} {said}"
            );
        }
    }

    #[test]
    fn inverse_w_tells_apart_what_is_a_millionth_of_its_distance_apart_at_any_distance() {
        let buffer = buffer(0.1, 1000.0).of_inverse_w();
        for distance in [0.2, 1.0, 30.0, 900.0] {
            assert!(tells_apart(&buffer, distance, distance * (1.0 + 2e-6)));
            assert!(!tells_apart(&buffer, distance, distance * (1.0 + 2e-7)));
        }
    }

    #[test]
    fn sixteen_bits_hold_less_than_a_float() {
        let float = buffer(1.0, 3.0);
        assert!(tells_apart(&float, 2.0, 2.00001));
        assert!(!tells_apart(&float.with_bits(16), 2.0, 2.00001));
    }
}
