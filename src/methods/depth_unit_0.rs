//! Depth unit 0, which peels, in its historical forms and in those of the invariance experiment.

use crate::error::Result;
use crate::gl::GlMachine;
use crate::papers::everitt_2001::{LISTING_2, REPLACED, SHADOW_AS_DEPTH_TEST, WINDOW_Z};
use crate::steps::{
    Amendment, Call, ClassicCall, ClassicDepthUnits, DepthUnits, Listing, Machine, MatrixMode,
    Outcome, Shader, Variables, run,
};

/// The form of Listing 1's depth unit 0.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum DepthUnit0 {
    /// A shadow sampler, which compares the rasteriser's own window z, as in the OpenGL of today.
    #[default]
    Sampler,
    /// As the paper describes it for the OpenGL of 2001, with GREATER and a result in alpha as extensions of 2002 have them: a
    /// projective shadow lookup compares r/q, its result goes into alpha, and the alpha test discards.
    Classic,
    /// The same with Listing 2, so that the stored depth is also r/q.
    ClassicDepthReplace,
    /// The same with the shadow map in a rectangle texture, whose coordinates are texels, as VTK's page has it.
    ClassicRectangle,
    /// A form of the invariance experiment.
    Experiment(Experiment),
}

/// A way to compare depths.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Experiment {
    /// The depth that is stored.
    pub stored: DepthSource,
    /// The depth that is compared with it.
    pub compared: DepthSource,
    /// What compares them.
    pub comparator: Comparator,
    /// A fragment is peeled away unless it lies behind the stored depth by more than this: the 'fudge factor'.
    pub bias: f32,
}

/// The source of a depth.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum DepthSource {
    /// The rasteriser: interpolated linearly in window space.
    #[default]
    WindowZ,
    /// The quotient of r and q, each interpolated linearly in clip space.
    Quotient,
}

/// What compares two depths.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Comparator {
    /// `GL_TEXTURE_COMPARE_FUNC`
    #[default]
    Sampler,
    /// The shader, which compares 32-bit floats.
    Shader,
    /// The shader, which rounds both sides to a fixed-point depth of so many bits, at most 24.
    ShaderInBits(u32),
}

impl DepthUnit0 {
    /// Runs a listing that has Listing 1 in it.
    pub(super) fn run(
        self,
        machine: &mut GlMachine<'_>,
        listing: &Listing,
        amendments: &[Amendment],
        variables: Variables,
    ) -> Result<Outcome> {
        match self {
            Self::Sampler => run(
                listing,
                amendments,
                variables,
                &mut DepthUnits::new(machine),
            ),
            Self::Classic => {
                run(&SHADOW_AS_DEPTH_TEST, &[], Variables::new(), machine)?;
                let mut units = ClassicDepthUnits::new(machine, Shader("classic/fixed"));
                run(listing, amendments, variables, &mut units)
            }
            Self::ClassicDepthReplace => {
                run(&LISTING_2, &[], Variables::new(), machine)?;
                run(&SHADOW_AS_DEPTH_TEST, &[], Variables::new(), machine)?;
                let mut units = ClassicDepthUnits::new(machine, Shader("classic/depth_replace"));
                run(listing, amendments, variables, &mut units)
            }
            Self::ClassicRectangle => {
                run(&LISTING_2, &[], Variables::new(), machine)?;
                run(&SHADOW_AS_DEPTH_TEST, &[], Variables::new(), machine)?;
                for call in texels(machine.size()) {
                    machine.perform(&Call::Classic(call))?;
                }
                let units = ClassicDepthUnits::new(machine, Shader("classic/depth_replace"));
                run(listing, amendments, variables, &mut units.with_rectangles())
            }
            Self::Experiment(experiment) => {
                let mut all = amendments.to_vec();
                all.extend(match experiment.stored {
                    DepthSource::WindowZ => WINDOW_Z,
                    DepthSource::Quotient => REPLACED,
                });
                let variables = experiment.variables(variables);
                run(listing, &all, variables, &mut DepthUnits::new(machine))
            }
        }
    }
}

/// After [`SHADOW_AS_DEPTH_TEST`]: the shadow map's coordinates are texels instead of 0 to 1.
fn texels(size: [u32; 2]) -> [ClassicCall; 7] {
    let [x, y] = size.map(|side| side as f32 / 2.0);
    [
        ClassicCall::ActiveTexture { unit: 3 },
        ClassicCall::MatrixMode {
            mode: MatrixMode::Texture,
        },
        ClassicCall::LoadIdentity,
        ClassicCall::Translate { x, y, z: 0.5 },
        ClassicCall::Scale { x, y, z: 0.5 },
        ClassicCall::ApplyPerspective,
        ClassicCall::MatrixMode {
            mode: MatrixMode::Modelview,
        },
    ]
}

impl Experiment {
    fn variables(&self, variables: Variables) -> Variables {
        let steps = match self.comparator {
            Comparator::ShaderInBits(bits) => f64::from((1_u32 << bits.min(24)) - 1),
            _ => 0.0,
        };
        let flag = |flag| if flag { 1.0 } else { 0.0 };
        variables
            .with("quotient", flag(self.compared == DepthSource::Quotient))
            .with("in_shader", flag(self.comparator != Comparator::Sampler))
            .with("steps", steps)
            .with("bias", f64::from(self.bias))
            .with("depth_test", 0.0)
    }
}
