//! The tests that amendments name and that draw with OpenGL: their names, and whether they are compiled.
//!
//! An amendment names the test that fails without it. A name in a string could be that of no test at all, so it is held
//! against the tests that the binaries were compiled with, as they list them themselves.

use std::collections::BTreeSet;
use std::process::Command;

/// Those in the binary `gl`, which holds them against its own tests; `papers` holds every amendment against these and its
/// own.
pub const IN_GL: &[&str] = &[
    "batches_give_the_same_image_in_fewer_iterations_each",
    "c19_the_ideal_gpu_by_images_gives_the_same_image",
    "e06_comparing_r_over_q_with_the_rasterisers_depth_mis_peels",
    "e06_window_z_compared_in_the_shader_and_in_the_sampler_give_the_same_image",
    "e12_the_printed_blend_function_leaves_an_opaque_image_translucent",
    "every_pixel_of_a_layer_is_counted_once",
    "l04_every_manager_and_fill_gives_the_oracle_s_image",
    "l05_base_offsets_keep_every_pixel_s_list_to_itself",
    "l07_as_printed_pixels_are_resolved_twice",
    "l09_keeping_the_nearest_gives_the_oracle_s_image_of_the_nearest_n",
    "l10_the_fill_counts_and_no_geometry_pass_is_added",
    "l11_as_printed_the_stencil_loses_what_lies_past_the_last_segment",
    "l16_fog_and_a_pane_follow_the_closed_form",
    "v02_the_loop_stops_when_a_peel_changed_fewer_pixels_than_the_ratio",
    "v03_opaque_geometry_culls_what_lies_behind_it_and_lowers_the_number_of_layers",
    "v04_the_empty_layer_ends_the_loop",
    "v06_both_ways_of_compositing_give_the_same_image",
    "v3_coplanar_peeling_has_every_tie_in_the_order_of_submission",
];

/// The names of the tests that the running binary was compiled with, without their modules.
pub fn compiled() -> BTreeSet<String> {
    let binary = std::env::current_exe().unwrap();
    let list = Command::new(binary)
        .args(["--list", "--format", "terse"])
        .output()
        .unwrap();
    assert!(list.status.success(), "{list:?}");
    let list = String::from_utf8(list.stdout).unwrap();
    let tests = list.lines().filter_map(|line| line.strip_suffix(": test"));
    let name = |path: &str| path.rsplit("::").next().unwrap_or(path).to_owned();
    tests.map(name).collect()
}
