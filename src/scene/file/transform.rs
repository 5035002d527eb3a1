//! `transform = { scale, rotate, translate }`, of meshes and volumes alike.

use glam::DVec3;

use super::keys::Keys;
use super::limits::{ANY, FACTOR};
use crate::error::Result;
use crate::scene::transform::Transform;

/// The transform of a mesh or a volume.
pub(super) fn read(keys: &Keys) -> Result<Transform> {
    let Some(keys) = keys.table("transform", "a transform")? else {
        return Ok(Transform::default());
    };
    keys.expect_only(&["scale", "rotate", "translate"])?;
    let mut transform = Transform::default();
    if let Some(rotate) = keys.table("rotate", "a rotation")? {
        rotate.expect_only(&["axis", "degrees"])?;
        let missing = "Write rotate = { axis = [0, 1, 0], degrees = 30 }.";
        let axis = rotate.vector("axis", &ANY)?;
        let axis = axis.ok_or_else(|| rotate.wrong("axis", "`axis` is missing", missing))?;
        let degrees = rotate.number("degrees", &ANY)?;
        transform.degrees =
            degrees.ok_or_else(|| rotate.wrong("degrees", "`degrees` is missing", missing))?;
        transform.axis = DVec3::from_array(axis)
            .try_normalize()
            .ok_or_else(|| rotate.wrong("axis", "an axis of length zero", missing))?;
    }
    if let Some(translate) = keys.vector("translate", &ANY)? {
        transform.translate = DVec3::from_array(translate);
    }
    transform.scale = if keys.is_list("scale") {
        keys.vector("scale", &FACTOR)?.map(DVec3::from_array)
    } else {
        keys.number("scale", &FACTOR)?.map(DVec3::splat)
    }
    .unwrap_or(DVec3::ONE);
    Ok(transform)
}
