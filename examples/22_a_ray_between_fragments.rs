//! What happens on one ray (Lindholm et al. 2015, section 6.1)? The section's sentences, run line by line on the emulated
//! pixel: the list of a ray through two overlapping volumes and two panes, with the eye inside of the first volume.
//!
//! Prints the lines, and the effect of each entry of the list on the ray: its position, its occupancy as bits (volume
//! 0's is the rightmost), and the part of the light that still comes through. Needs no OpenGL.
//!
//! `cargo run --example 22_a_ray_between_fragments`

use glam::DVec3;
use onionskin::low_level::emulator::{RayScene, RayVolume, run_on_rays};
use onionskin::low_level::fragment::Source;
use onionskin::low_level::papers::lindholm_2015::components::PP_DP;
use onionskin::low_level::papers::lindholm_2015::fused::{FUSED, FUSED_AMENDMENTS, FUSED_PP_DP};
use onionskin::low_level::scene::Medium;
use onionskin::low_level::steps::pseudo::list;
use onionskin::{Fragment, Rgba};

fn main() -> onionskin::Result<()> {
    println!("{}", list::print(&FUSED, &FUSED_AMENDMENTS));
    let pixel = [(fragments(), ray())];
    let (_, rays) = run_on_rays(&FUSED, &FUSED_AMENDMENTS, &pixel, 16, 1)?;
    println!("{}", rays[0]);

    // In subpasses of two fragments, the ray's state is kept from one to the next, so nothing changes.
    let (lists, again) = run_on_rays(&PP_DP, &FUSED_PP_DP, &pixel, 2, 16)?;
    let subpasses = lists.pixels[0].subpasses;
    println!(
        "by ppDP in {subpasses} subpasses: the same ray, {}",
        again == rays
    );

    let (_, as_printed) = run_on_rays(&FUSED, &[], &pixel, 16, 1)?;
    let [amended, printed] = [&rays, &as_printed].map(|rays| rays[0].transparency);
    println!("{amended:.4} of the light comes through; as the prose has it, {printed:.4}:");
    println!("\n{}", as_printed[0]);
    Ok(())
}

/// The fragments as the Fill Step leaves them, in the order of submission. The eye is inside of volume 0, so volume 0's
/// box has only the face where the ray leaves it.
fn fragments() -> Vec<Fragment> {
    let face = |volume, leaves| Source::Proxy { volume, leaves };
    let entries = [
        (0.55, Source::Surface(0), 0.3),
        (0.85, Source::Surface(1), 0.5),
        (0.7, face(0, true), 0.0),
        (0.9, face(1, true), 0.0),
        (0.4, face(1, false), 0.0),
    ];
    let fragment = |(depth, source, alpha): (f32, Source, f32)| Fragment {
        depth,
        color: Rgba::new(0.2, 0.4, 0.8, alpha),
        order: source.id(),
    };
    entries.map(fragment).to_vec()
}

fn ray() -> RayScene<'static> {
    let volume = |medium, step| RayVolume { medium, step };
    RayScene {
        planes: [1.0, 6.0],
        inverse_w: false,
        slant: 1.0,
        opaque: 0.88,
        volumes: vec![volume(&thin, 0.5), volume(&growing, 0.25)],
    }
}

fn thin(_: f64) -> Medium {
    Medium {
        color: DVec3::X,
        density: 0.2,
    }
}

/// A density that grows with the value.
fn growing(distance: f64) -> Medium {
    Medium {
        color: DVec3::Y,
        density: 0.15 * distance,
    }
}
