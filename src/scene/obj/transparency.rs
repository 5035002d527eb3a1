//! `Tr`: by the format's documents it is transparency, 1 less `d`; many programs write the opacity there.

/// What `Tr` means in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Tr {
    /// As the format has it.
    Transparency,
    /// This program, which is named in the file, writes the opacity.
    OpacityOf(&'static str),
    /// Other materials of the file have a `d`, too, and it is equal to their `Tr`.
    OpacityLikeD,
    /// By the other meaning nothing could be seen.
    OpacityToBeSeen,
    /// The same, where the opacity was to be expected.
    TransparencyToBeSeen,
}

/// What the comments of programs say that write opacity as `Tr`, in lower case, and what the programs are called.
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

/// Two numbers that a program has written of the same: they differ by the rounding of two decimals at most.
pub(super) const SAME: f64 = 0.01;

/// What the materials of a file tell.
#[derive(Default)]
pub(super) struct Evidence {
    /// How many have a `Tr` that is equal to their `d`, and not to 1 less that.
    alike: usize,
    /// The other way around.
    opposite: usize,
    /// How many have a `Tr` and no `d`, and how many of those it makes invisible if it is opacity, or transparency.
    alone: usize,
    clear: usize,
    full: usize,
}

impl Evidence {
    /// What one material tells.
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
    /// By who wrote the file, as its first comments say, or by what its `d` say, or by the format; but not so that all
    /// of its materials without a `d` are invisible if there is another way.
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

    /// For people.
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
