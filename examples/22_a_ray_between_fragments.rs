//! What happens on one ray (Lindholm et al. 2015, section 6.1)? The section's sentences, run line by line on the emulated
//! pixel: the list of a ray through two overlapping volumes and two panes, with the eye inside of the first volume.
//!
//! Prints the lines, and the effect of each entry of the list on the ray: its position, its occupancy as bits (volume
//! 0's is the rightmost), and the part of the light that still comes through. Needs no OpenGL.
//!
//! `cargo run --example 22_a_ray_between_fragments`

use onionskin::low_level::edition::figures::lindholm::ray_through_two_volumes;
use onionskin::low_level::emulator::run_on_rays;
use onionskin::low_level::papers::lindholm_2015::components::PP_DP;
use onionskin::low_level::papers::lindholm_2015::fused::{FUSED, FUSED_AMENDMENTS, FUSED_PP_DP};
use onionskin::low_level::steps::pseudo::list;

fn main() -> onionskin::Result<()> {
    println!("{}", list::print(&FUSED, &FUSED_AMENDMENTS));
    let pixel = [ray_through_two_volumes()];
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
