//! The methods, with one file each that reads like its paper, and the renderer that runs them.
//!
//! <!-- methods: generated from the registry -->
//! | method | published | exact | fragments of equal depth | a full array keeps | memory |
//! | --- | --- | --- | --- | --- | --- |
//! | `blend` | Everitt 2001, figure 1b | no | each over those drawn before it |  | pixels |
//! | `painter` | Carr et al. 2008, section 1 | no | each over those drawn before it |  | pixels + triangles |
//! | `weighted-blended` | McGuire and Bavoil 2013 | no, but for one layer, or one colour | no order |  | pixels |
//! | `multi-layer-alpha-blending` | Salvi and Vaidyanathan 2014 | no, but for pixels with at most as many fragments as nodes, 4 or 8 | order of submission |  | pixels |
//! | `depth-peeling` | Everitt 2001; VTK | yes, but for ties; volumes as slices: no, an error of order 1 in the slices' distance | the first submitted, the others lost and counted |  | pixels (layers x pixels if they are kept) |
//! | `dual-depth-peeling` | Bavoil and Myers 2008; VTK today | yes; volumes as slices: no, an error of order 1 in the slices' distance | order of submission |  | pixels |
//! | `coplanar-depth-peeling` | Vasilakis and Fudos 2013 | yes; volumes as slices: no, an error of order 1 in the slices' distance | order of submission |  | pixels |
//! | `layer-peeling` | Carr et al. 2008, sections 1 and 8 | yes; volumes as slices: no, an error of order 1 in the slices' distance | order of submission |  | pixels |
//! | `hybrid-layer-peeling` | Carr et al. 2008, Algorithm 1 | yes; volumes as slices: no, an error of order 1 in the slices' distance | unsorted meshes before sorted ones |  | pixels + triangles |
//! | `coherent-layer-peeling-a` | Carr et al. 2008, section 5 | yes; volumes as slices: no, an error of order 1 in the slices' distance | order of submission after sorting |  | pixels + triangles |
//! | `coherent-layer-peeling-b` | Carr et al. 2008, section 6 | yes; volumes as slices: no, an error of order 1 in the slices' distance | order of submission after sorting |  | pixels + triangles |
//! | `ideal-coherent-layer-peeling` | Carr et al. 2008, Algorithm 2 | yes; volumes as slices: no, an error of order 1 in the slices' distance | order of submission after sorting |  | pixels + triangles |
//! | `ffb`, `ffb+ppao` | Lindholm et al. 2015 | yes, volumes by rays, too, up to 64 fragments a pixel (option array) | order of submission | the first submitted | pixels x layers, in bands |
//! | `ffb+ppdp`, `ffb+ppao+ppdp` | Lindholm et al. 2015 | yes, volumes by rays, too | order of submission |  | pixels x layers, in bands |
//! | `dfb`, `dfb+ppao` | Lindholm et al. 2015 | yes, volumes by rays, too, up to 64 fragments a pixel (option array) | order of submission | the first submitted | pixels + fragments, in bands |
//! | `dfb+ppdp`, `dfb+ppao+ppdp`, `ppll+ppdp`, `ppll+ppao+ppdp` | Lindholm et al. 2015 | yes, volumes by rays, too | order of submission |  | pixels + fragments, in bands |
//! | `ppll`, `ppll+ppao` | Lindholm et al. 2015 | yes, volumes by rays, too, up to 64 fragments a pixel (option array) | order of submission | the last submitted | pixels + fragments, in bands |
//! | `verified-painter` | this edition | yes; volumes as slices: no, an error of order 1 in the slices' distance | order of submission |  | pixels + triangles |
//! | `auto` | this edition | yes, volumes by rays, too | order of submission |  | pixels + fragments, in bands |
//! | `exact` | the oracle | yes, volumes by rays, too | order of submission |  | fragments, in pieces |
//! <!-- /methods -->
//!
//! "a full array keeps" says which fragments of a pixel are in the image if the method's array has no room for all of them.

#[macro_use]
mod registry;

macro_rules! declare {
    ($($file:ident: $name:ident $(($options:ident))?,)*) => {
        $(
            mod $file;
        )*

        /// The options of methods, and the types of their fields. A method without options has a type of its own name.
        ///
        /// Options grow. Name those that you set, and take the others from the default, as in
        /// `ABufferOptions { pp_dp: true, ..Default::default() }`. `#[non_exhaustive]` would forbid exactly this, so these
        /// structs do without it.
        pub mod options {
            $(pub use crate::methods::$file::*;)*
            pub use crate::methods::depth_unit_0::{DepthSource, DepthUnit0, Experiment, Comparator};
            pub use crate::methods::buffer_access::BufferAccess;
            pub use crate::methods::sorting::TriangleSort;
            pub use crate::steps::Reading;
            pub use crate::methods::vtk_settings::VtkSettings;
        }
    };
}

every_method!(declare);

mod algorithm;
mod allocate_maps;
mod batches;
mod buffer_access;
mod choice;
mod complexity;
pub mod coplanar;
mod culling;
mod depth_unit_0;
mod entry;
mod expect_known;
mod film;
mod frame;
mod hanging;
pub mod invariance;
mod inverse_w;
mod iteration_bound;
mod loop_guard;
mod proxies;
mod renderer;
mod requirements;
pub mod shadows;
mod slicing;
mod sorting;
mod stats;
#[cfg(test)]
mod tables;
mod technique;
mod vtk_settings;

pub use algorithm::{Algorithm, Composited, DrawOrder, Drawn, Setup};
pub use allocate_maps::allocate_maps;
pub use batches::begin_batch;
pub use choice::{Choice, Takes};
pub use complexity::{Bin, Complexity, CountBy};
pub use entry::{Entry, Memory, Ties, Volumes};
pub use film::Film;
pub use frame::{Frame, Layer, Times};
pub use hanging::Hanging;
pub use options::*;
pub use registry::{Listed, Method, methods_with, registry};
pub use renderer::Renderer;
pub use slicing::{DEFAULT_SLICES, MOST_SLICES};
pub use stats::{ABufferCounts, Chosen, Peeling, Stats, VerifiedCounts};
pub use technique::Technique;
