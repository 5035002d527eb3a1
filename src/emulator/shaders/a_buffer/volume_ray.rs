//! `a_buffer/volume_ray.glsl`: the ray that is cast between the fragments of the list, by the paper's prose, in f64.

use crate::low_level::emulator::invocation::Inputs;
use crate::low_level::emulator::lists::{RayRun, RayScene, RayVolume, Resolved, run_on_rays};
use crate::low_level::emulator::settings::PixelRay;
use crate::low_level::error::Result;
use crate::low_level::fragment::Fragment;
use crate::low_level::papers::lindholm_2015::components::PP_DP;
use crate::low_level::papers::lindholm_2015::fused::{FUSED, FUSED_AMENDMENTS, FUSED_PP_DP};
use crate::low_level::scene::{Medium, Volume};

/// Casts the ray of a pixel with this list. A Local Array of so many elements peels it, in at most so many subpasses;
/// without one the list is sorted whole.
pub(super) fn cast(
    i: &Inputs<'_>,
    list: Vec<Fragment>,
    peeled_by: Option<[u32; 2]>,
) -> Result<(Resolved, RayRun)> {
    let ray = i.settings.rays[i.pixel];
    let media: Vec<_> = i
        .settings
        .volumes
        .iter()
        .map(|it| medium(ray, it))
        .collect();
    let volumes = i.settings.volumes.iter().zip(&media);
    let scene = RayScene {
        planes: i.settings.planes,
        inverse_w: i.settings.inverse_w,
        slant: ray.direction.length(),
        opaque: i.texel(5)[0],
        volumes: volumes
            .map(|(volume, medium)| RayVolume {
                medium,
                step: volume.sampling_distance(),
            })
            .collect(),
    };
    // A ray's state is kept in every reading.
    let [.., stop, begin, evaluate] = FUSED_PP_DP;
    let (literal, printed) = ([begin, evaluate], [stop, begin, evaluate]);
    let (algorithm, amendments, array, limit) = match peeled_by {
        Some([array, limit]) if i.is("LITERAL") => (PP_DP, &literal[..], array, limit),
        Some([array, limit]) if i.is("AS_PRINTED") => (PP_DP, &printed[..], array, limit),
        Some([array, limit]) => (PP_DP, &FUSED_PP_DP[..], array, limit),
        None => (FUSED, &FUSED_AMENDMENTS[..], 1, 1),
    };
    let pixels = [(list, scene)];
    let (mut run, mut rays) = run_on_rays(&algorithm, amendments, &pixels, array, limit)?;
    Ok((run.pixels.remove(0), rays.remove(0)))
}

/// A volume's colour and density along a ray.
fn medium(ray: PixelRay, volume: &Volume) -> impl Fn(f64) -> Medium {
    let to_index = volume.world_to_index();
    move |distance| {
        let place = to_index.transform_point3(ray.origin + ray.direction * distance);
        volume.transfer.at(volume.at_index(place))
    }
}
