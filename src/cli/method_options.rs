//! Arguments that choose a method and what can be chosen about it.

use clap::{Args, ValueEnum};
use onionskin::methods::{
    ABufferOptions, CoherentOptions, Compositing, CoplanarDepthPeelingOptions, DepthPeelingOptions,
    DepthUnit0, DualDepthPeelingOptions, IdealOptions, LayerPeelingOptions, Manager, Sorting,
};
use onionskin::{Error, Method, Result, Scene};

use super::a_buffer_options::ABufferArguments;
use super::slices::Slices;

const PEELING: &str = "Options of depth-peeling";
const PAPERS: &str = "Options of depth-peeling, layer-peeling, hybrid-layer-peeling, the coherent methods, A-buffers";
const COHERENT: &str = "Options of the coherent methods";

#[derive(Args)]
pub(super) struct MethodOptions {
    /// The method: exact, painter, ffb ...; `onionskin methods` describes them all [default: depth-peeling; dfb+ppdp
    /// where volumes are to be rendered]
    #[arg(short, long)]
    method: Option<String>,
    /// At most this many peels, nearest first; 0 means no limit, as VTK documents it. Dual and coplanar depth peeling
    /// have it too
    #[arg(long, default_value_t = 0, value_name = "N", help_heading = PEELING)]
    pub(super) peels: u32,
    /// Stop after a peel that changed fewer pixels than this part of the image; 0 is exact. Dual depth peeling has it
    /// too
    #[arg(long, default_value_t = 0.0, value_name = "0..1", help_heading = PEELING)]
    occlusion_ratio: f64,
    /// Keep every layer and write it beside the image: FILE-layer-0.png is the nearest, and so on
    #[arg(long, help_heading = PEELING)]
    pub(super) layers: bool,
    /// What peels: a shadow sampler, or the alpha test of 2001 with or without Listing 2's depth replace
    #[arg(long, value_enum, default_value_t = Unit0::Sampler, help_heading = PEELING)]
    depth_unit_0: Unit0,
    /// Run the paper's text with nothing amended. Everitt's needs --peels, because it has no way to find out when to
    /// stop; loops that would never end are given up
    #[arg(long, help_heading = PAPERS)]
    as_printed: bool,
    /// How triangles are sorted beforehand: submission, objects, reversed or buckets=N [default: buckets=256]
    #[arg(long, value_name = "HOW", value_parser = sorting, help_heading = COHERENT)]
    sort: Option<Sorting>,
    /// Improvements that the paper only points at, separated by commas: tie-friendly, early-stop, batches=N for variants
    /// A and B; tight-bound for the ideal GPU
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = improvement, help_heading = COHERENT)]
    improve: Vec<Improvement>,
    #[command(flatten)]
    a_buffer: ABufferArguments,
    #[command(flatten)]
    pub(super) slices: Slices,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Unit0 {
    /// The rasteriser's depth, compared by the sampler
    Sampler,
    /// r/q, compared into alpha
    Classic,
    /// The same, and r/q is what is stored
    ClassicDepthReplace,
}

impl From<Unit0> for DepthUnit0 {
    fn from(unit: Unit0) -> Self {
        match unit {
            Unit0::Sampler => Self::Sampler,
            Unit0::Classic => Self::Classic,
            Unit0::ClassicDepthReplace => Self::ClassicDepthReplace,
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Improvement {
    TieFriendly,
    EarlyStop,
    Batches(u32),
    TightBound,
}

impl MethodOptions {
    /// The method with its options; depth peeling if none is named.
    ///
    /// # Errors
    /// If there is no such method, or it has no such option.
    pub(super) fn method(&self) -> Result<Method> {
        let method = self.of_surfaces_and_lists()?;
        self.slices.check(&method)?;
        Ok(method)
    }

    fn of_surfaces_and_lists(&self) -> Result<Method> {
        let method: Method = self.method.as_deref().map_or_else(
            || Ok(Method::DepthPeeling(DepthPeelingOptions::default())),
            str::parse,
        )?;
        let kept = self.layers || self.depth_unit_0 != Unit0::Sampler;
        let peels = self.peels != 0 || self.occlusion_ratio != 0.0 || kept;
        let sorted = self.sort.is_some() || !self.improve.is_empty();
        let lists = self.a_buffer.are_given();
        match method {
            Method::ABuffer(options) if !peels && !sorted => {
                self.a_buffer.method(options, self.as_printed)
            }
            _ if lists => Err(Error::usage(
                format!("{method} has none of the options of A-buffers"),
                "they are for ffb, dfb and ppll",
            )),
            Method::DepthPeeling(_) if !sorted => self.depth_peeling(),
            Method::DualDepthPeeling(_) if !kept && !sorted && !self.as_printed => self.dual(),
            Method::CoplanarDepthPeeling(_)
                if !kept && !sorted && !self.as_printed && self.occlusion_ratio == 0.0 =>
            {
                Ok(Method::CoplanarDepthPeeling(CoplanarDepthPeelingOptions {
                    maximum_number_of_peels: self.peels,
                }))
            }
            Method::DualDepthPeeling(_) if kept || self.as_printed => Err(Error::usage(
                format!("{method} has no --layers, --depth-unit-0 or --as-printed"),
                "it has --peels and --occlusion-ratio; the others are for depth-peeling",
            )),
            Method::CoplanarDepthPeeling(_) if !sorted => Err(Error::usage(
                format!(
                    "{method} has no --occlusion-ratio, --layers, --depth-unit-0 or --as-printed"
                ),
                "it has --peels; the others are for depth-peeling",
            )),
            Method::LayerPeeling(_) if !peels && !sorted => {
                Ok(Method::LayerPeeling(self.layer_peeling()))
            }
            Method::HybridLayerPeeling(_) if !peels && !sorted => {
                Ok(Method::HybridLayerPeeling(self.layer_peeling()))
            }
            Method::CoherentLayerPeeling(options) if !peels => self.coherent(options),
            Method::IdealCoherentLayerPeeling(options) if !peels => self.ideal(options),
            _ if peels || self.as_printed && !sorted => Err(Error::usage(
                format!(
                    "{method} has no --peels, --occlusion-ratio, --layers, --depth-unit-0 or --as-printed"
                ),
                "they are for depth-peeling; the peeling methods of Carr et al. and A-buffers have --as-printed",
            )),
            _ if sorted => Err(Error::usage(
                format!("{method} has no --sort or --improve"),
                "they are for coherent-layer-peeling-a, -b and ideal-coherent-layer-peeling",
            )),
            _ => Ok(method),
        }
    }

    /// `method`, or if none was named, and nothing that only depth peeling has, one that renders the scene's volumes.
    pub(super) fn for_scene(&self, method: Method, scene: &Scene) -> Method {
        let peeling = Method::DepthPeeling(DepthPeelingOptions::default());
        let asked = self.method.is_some() || self.slices.is_given() || method != peeling;
        if asked || scene.volumes.is_empty() {
            return method;
        }
        Method::ABuffer(ABufferOptions {
            manager: Manager::Dfb,
            pp_dp: true,
            ..ABufferOptions::default()
        })
    }

    fn depth_peeling(&self) -> Result<Method> {
        let options = DepthPeelingOptions {
            maximum_number_of_peels: self.peels,
            occlusion_ratio: self.occlusion_ratio,
            compositing: if self.layers {
                Compositing::KeepLayers
            } else {
                Compositing::OnTheFly
            },
            as_printed: self.as_printed,
            depth_unit_0: self.depth_unit_0.into(),
            amendments: &[],
        };
        options.check()?;
        Ok(Method::DepthPeeling(options))
    }

    fn dual(&self) -> Result<Method> {
        let options = DualDepthPeelingOptions {
            maximum_number_of_peels: self.peels,
            occlusion_ratio: self.occlusion_ratio,
            amendments: &[],
        };
        options.check()?;
        Ok(Method::DualDepthPeeling(options))
    }

    fn layer_peeling(&self) -> LayerPeelingOptions {
        LayerPeelingOptions {
            as_printed: self.as_printed,
        }
    }

    fn coherent(&self, options: CoherentOptions) -> Result<Method> {
        let mut options = CoherentOptions {
            sorting: self.sort.unwrap_or(options.sorting),
            as_printed: self.as_printed,
            ..options
        };
        for improvement in &self.improve {
            match *improvement {
                Improvement::TieFriendly => options.tie_friendly = true,
                Improvement::EarlyStop => options.stop_early = true,
                Improvement::Batches(count) => options.batches = count,
                Improvement::TightBound => {
                    return Err(Error::usage(
                        "tight-bound is an improvement of Algorithm 2",
                        "it is for ideal-coherent-layer-peeling",
                    ));
                }
            }
        }
        self.not_both()?;
        Ok(Method::CoherentLayerPeeling(options))
    }

    fn ideal(&self, options: IdealOptions) -> Result<Method> {
        if let Some(other) = self.improve.iter().find(|i| **i != Improvement::TightBound) {
            return Err(Error::usage(
                format!("the ideal GPU has no improvement {other:?}"),
                "it has tight-bound; the others are for coherent-layer-peeling-a and -b",
            ));
        }
        self.not_both()?;
        Ok(Method::IdealCoherentLayerPeeling(IdealOptions {
            sorting: self.sort.unwrap_or(options.sorting),
            tight_bound: !self.improve.is_empty(),
            as_printed: self.as_printed,
            ..options
        }))
    }

    fn not_both(&self) -> Result<()> {
        if self.as_printed && !self.improve.is_empty() {
            return Err(Error::usage(
                "--as-printed and --improve exclude each other",
                "choose one of them",
            ));
        }
        Ok(())
    }
}

fn sorting(text: &str) -> Result<Sorting> {
    match text.split_once('=') {
        None if text == "submission" => Ok(Sorting::Submission),
        None if text == "objects" => Ok(Sorting::Objects),
        None if text == "buckets" => Ok(Sorting::default()),
        None if text == "reversed" => Ok(Sorting::Reversed(256)),
        Some(("buckets", count)) if count.parse::<u32>().is_ok_and(within_reason) => {
            Ok(Sorting::Buckets(count.parse().unwrap_or(1)))
        }
        _ => Err(Error::usage(
            format!("'{text}' is no way to sort"),
            "write submission, objects, or buckets=N with N from 1 to 16777216",
        )),
    }
}

fn improvement(text: &str) -> Result<Improvement> {
    match text.split_once('=') {
        None if text == "tie-friendly" => Ok(Improvement::TieFriendly),
        None if text == "early-stop" => Ok(Improvement::EarlyStop),
        None if text == "tight-bound" => Ok(Improvement::TightBound),
        Some(("batches", count)) if count.parse::<u32>().is_ok_and(|n| (1..=1000).contains(&n)) => {
            Ok(Improvement::Batches(count.parse().unwrap_or(1)))
        }
        _ => Err(Error::usage(
            format!("'{text}' is no improvement"),
            "write tie-friendly, early-stop, tight-bound, or batches=N with N from 1 to 1000",
        )),
    }
}

/// As many buckets as still fit into memory.
fn within_reason(buckets: u32) -> bool {
    (1..=1 << 24).contains(&buckets)
}
