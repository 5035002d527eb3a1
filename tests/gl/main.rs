//! Everything that OpenGL draws, held against what shares no code with it.

#[path = "../kit/mod.rs"]
mod kit;

/// Only a path that leads to a test here compiles.
macro_rules! cited {
    (gl $(:: $name:ident)+) => { const _: fn() = crate $(:: $name)+; };
    ($($elsewhere:tt)+) => {};
}

#[path = "../kit/ledger.rs"]
mod ledger;

mod a_buffer;
mod a_buffer_bands;
mod a_buffer_kept;
mod a_buffer_keys;
mod accumulation;
mod automatic;
mod bounded;
mod by_images;
mod camera_path;
mod claims_carr;
mod claims_carr_options;
mod claims_carr_table_1;
mod claims_carr_work;
mod claims_everitt;
mod claims_everitt_compositing;
mod claims_everitt_depth_units;
mod claims_everitt_shadows;
mod claims_lindholm;
mod claims_lindholm_conditions;
mod claims_lindholm_pp_ao;
mod claims_lindholm_resolve;
mod claims_vtk;
mod claims_vtk_layers;
mod claims_vtk_requirements;
mod claims_vtk_settings;
mod classic_fixed_function;
mod classic_listing_2;
mod coplanar;
mod cross_section;
mod depth_noise;
mod dual_peeling;
mod edition_carr;
mod edition_lindholm;
mod errata_everitt;
mod exact;
mod exact_depth;
mod exact_measures;
mod figure_2;
mod figure_3;
mod figures_4_and_5;
mod four_scenes;
mod fused;
mod fused_as_printed;
mod fused_changed;
mod fused_lockstep;
mod inspect;
mod inspect_changed;
mod inspect_told;
mod invariance;
mod lists_lockstep;
mod lockstep;
mod lockstep_bounded;
mod lockstep_ideal;
mod lockstep_lists;
mod lockstep_maps;
mod lockstep_marked;
mod lockstep_order;
mod lockstep_volumes;
mod machine;
mod multi_layer_alpha_blending;
mod own_shader;
mod peeling;
mod peeling_changed;
mod peeling_improved;
mod peeling_improved_words;
mod readings;
mod slices;
mod smallest_change;
mod uploads;
mod verified_painter;
mod verified_painter_pieces;
mod volumes;
mod weighted_blended;
