//! The patient's axes. Files say in which directions x, y and z go. In a scene they go to the patient's right, to the
//! front (anterior) and up (superior), which is called RAS. So volumes of one patient from different files fit
//! together.

use std::path::Path;

use glam::{DAffine3, DVec3};

/// An anatomical space.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Space {
    /// Right, anterior, superior: the axes of the world.
    Ras,
    /// Left, anterior, superior.
    Las,
    /// Left, posterior, superior.
    Lps,
}

impl Space {
    /// The factors that turn this space into RAS.
    fn signs(self) -> DVec3 {
        match self {
            Self::Ras => DVec3::ONE,
            Self::Las => DVec3::new(-1.0, 1.0, 1.0),
            Self::Lps => DVec3::new(-1.0, -1.0, 1.0),
        }
    }

    /// A placement in this space, as a placement in the world.
    pub(super) fn to_world(self, placement: DAffine3) -> DAffine3 {
        DAffine3::from_scale(self.signs()) * placement
    }

    /// A sentence for the user if the axes were turned.
    pub(super) fn notice(self, path: &Path) -> Option<String> {
        let (name, changed) = match self {
            Self::Ras => return None,
            Self::Las => ("left-anterior-superior (LAS)", "x changes its sign"),
            Self::Lps => (
                "left-posterior-superior (LPS)",
                "x and y change their signs",
            ),
        };
        Some(format!(
            "{}: its space is {name}; it is put into the world's right-anterior-superior (RAS): {changed}. Meshes, and volumes that name no such space, stay as they are",
            path.display()
        ))
    }
}
