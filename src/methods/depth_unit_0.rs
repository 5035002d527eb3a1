//! Depth unit 0, which peels, in its historical forms and in those of the invariance experiment.

use crate::error::Result;
use crate::gl::GlMachine;
use crate::papers::everitt_2001::{
    COMBINED, ENABLED, LISTING_2, LOOKED_UP_AS_2D, RECTANGLE_FILLINGS, REPLACED, SGIX_LEQUAL,
    SHADOW_AS_DEPTH_TEST, SHADOW_FILLINGS, WINDOW_Z,
};
use crate::steps::{
    Amendment, ClassicDepthUnits, DepthUnits, Listing, Outcome, Reading, Shader, Variables, run,
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
    /// As [`ClassicDepthReplace`](Self::ClassicDepthReplace), with what SGIX_shadow had in 2001: LEQUAL, whose inverse
    /// register combiners carry from a luminance into alpha.
    ClassicSgix,
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
    /// Runs a listing that has Listing 1 in it. The paper's texts on depth unit 0 are read like this, amended by
    /// `amendments` first.
    pub(super) fn run(
        self,
        machine: &mut GlMachine<'_>,
        reading: Reading,
        listing: &Listing,
        amendments: &[Amendment],
        variables: Variables,
    ) -> Result<Outcome> {
        let read = |fillings: &[Amendment]| [amendments, &reading.of(fillings)].concat();
        let [width, height] = machine.size().map(f64::from);
        let size = || Variables::new().with("width", width).with("height", height);
        match self {
            Self::Sampler => run(
                listing,
                amendments,
                variables,
                &mut DepthUnits::new(machine),
            ),
            Self::Classic => {
                let mut units = ClassicDepthUnits::new(machine, Shader("classic/fixed"));
                let fillings = read(&SHADOW_FILLINGS);
                run(&SHADOW_AS_DEPTH_TEST, &fillings, size(), &mut units)?;
                run(listing, amendments, variables, &mut units)
            }
            Self::ClassicDepthReplace => {
                let mut units = ClassicDepthUnits::new(machine, Shader("classic/depth_replace"));
                run(&LISTING_2, &read(&[ENABLED]), size(), &mut units)?;
                let fillings = read(&SHADOW_FILLINGS);
                run(&SHADOW_AS_DEPTH_TEST, &fillings, size(), &mut units)?;
                run(listing, amendments, variables, &mut units)
            }
            Self::ClassicRectangle => {
                let units = ClassicDepthUnits::new(machine, Shader("classic/depth_replace"));
                let mut units = units.with_rectangles();
                run(&LISTING_2, &read(&[ENABLED]), size(), &mut units)?;
                let fillings = read(&RECTANGLE_FILLINGS);
                run(&SHADOW_AS_DEPTH_TEST, &fillings, size(), &mut units)?;
                run(listing, amendments, variables, &mut units)
            }
            Self::ClassicSgix => {
                let units = ClassicDepthUnits::new(machine, Shader("classic/depth_replace"));
                let mut units = units.with_sgix_shadow();
                run(&LISTING_2, &read(&[ENABLED]), size(), &mut units)?;
                let fillings = [&read(&[LOOKED_UP_AS_2D])[..], &[COMBINED]].concat();
                run(&SHADOW_AS_DEPTH_TEST, &fillings, size(), &mut units)?;
                let amendments = [amendments, &[SGIX_LEQUAL]].concat();
                run(listing, &amendments, variables, &mut units)
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
