//! `Tr`. By the format's documents it is the transparency, 1 - `d`. Many programs write the opacity instead.

/// The meaning of `Tr` in a file, and the reason for it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Tr {
    /// Transparency, as the format has it.
    Transparency,
    /// Opacity, because the file names this program, which writes the opacity.
    OpacityOf(&'static str),
    /// Opacity, because other materials of the file have a `d` that is equal to their `Tr`.
    OpacityLikeD,
    /// Opacity, because transparency would leave nothing visible.
    OpacityToBeSeen,
    /// Transparency, because opacity, which was expected, would leave nothing visible.
    TransparencyToBeSeen,
}

/// Words in the comments of programs that write the opacity as `Tr`, in lower case, and the programs' names.
const WRITERS: [(&[u8], &str); 8] = [
    (b"visualization toolkit", "VTK"),
    (b"vtk", "VTK"),
    (b"pyvista", "PyVista"),
    (b"paraview", "ParaView"),
    (b"meshlab", "MeshLab"),
    (b"vcglib", "VCGLib"),
    (b"openmvs", "OpenMVS"),
    (b"texrecon", "MVS-Texturing"),
];

/// Whether two numbers are equal up to the rounding of two decimals.
pub(super) const SAME: f64 = 0.01;

/// The evidence of the materials of a file.
#[derive(Default)]
pub(super) struct Evidence {
    /// The number of materials whose `Tr` is equal to `d` and not to 1 - `d`.
    alike: usize,
    /// The number of materials whose `Tr` is equal to 1 - `d` and not to `d`.
    opposite: usize,
    /// The number of materials that have a `Tr` and no `d`, and how many of them would be invisible if it were the
    /// opacity, or the transparency.
    alone: usize,
    clear: usize,
    full: usize,
}

impl Evidence {
    /// Adds the evidence of a material.
    pub(super) fn add(&mut self, d: Option<f64>, tr: Option<f64>) {
        match (d, tr) {
            (Some(d), Some(tr)) => {
                let [like_d, unlike_d] = [d, 1.0 - d].map(|value| (value - tr).abs() <= SAME);
                self.alike += usize::from(like_d && !unlike_d);
                self.opposite += usize::from(unlike_d && !like_d);
            }
            (None, Some(tr)) => {
                self.alone += 1;
                self.clear += usize::from(tr <= 0.0);
                self.full += usize::from(tr >= 1.0);
            }
            (_, None) => {}
        }
    }
}

impl Tr {
    /// Decides by the program that wrote the file, which its first comments name, or by the values of `d`, or by the
    /// format. If this would make all materials without a `d` invisible and the other meaning would not, the other
    /// meaning is taken.
    pub(super) fn of(head: &[u8], evidence: &Evidence) -> Self {
        let writer = WRITERS.iter().find(|(comment, _)| {
            let mut windows = head.windows(comment.len());
            windows.any(|window| window == *comment)
        });
        let expected = match writer {
            Some((_, name)) => Self::OpacityOf(name),
            None if evidence.alike > evidence.opposite => Self::OpacityLikeD,
            None => Self::Transparency,
        };
        let all = |count| evidence.alone > 0 && evidence.alone == count;
        match expected.opacity(1.0) > 0.5 {
            false if all(evidence.full) => Self::OpacityToBeSeen,
            true if all(evidence.clear) => Self::TransparencyToBeSeen,
            _ => expected,
        }
    }

    /// The opacity that a `Tr` stands for.
    pub(super) fn opacity(self, tr: f64) -> f64 {
        match self {
            Self::Transparency | Self::TransparencyToBeSeen => 1.0 - tr,
            Self::OpacityOf(_) | Self::OpacityLikeD | Self::OpacityToBeSeen => tr,
        }
    }

    /// The sentence for people.
    pub(super) fn sentence(self) -> String {
        match self {
            Self::Transparency => {
                "taken as transparency, 1 less the opacity, as the format has it".to_owned()
            }
            Self::OpacityOf(writer) => {
                format!("taken as opacity, which is what {writer} writes there")
            }
            Self::OpacityLikeD => {
                "taken as opacity, since other materials of the file have a `d` that is equal to it"
                    .to_owned()
            }
            Self::OpacityToBeSeen => {
                "taken as opacity: as transparency it would leave none of them to be seen"
                    .to_owned()
            }
            Self::TransparencyToBeSeen => {
                "taken as transparency: as opacity it would leave none of them to be seen"
                    .to_owned()
            }
        }
    }
}
