//! The listings and the pseudocode, in print and on the emulated pixel. No OpenGL.

#[path = "../kit/mod.rs"]
mod kit;

/// Only a path that leads to a test here compiles.
macro_rules! cited {
    (papers $(:: $name:ident)+) => { const _: fn() = crate $(:: $name)+; };
    ($($elsewhere:tt)+) => {};
}

#[path = "../kit/ledger.rs"]
mod ledger;

mod amendment_tests;
mod check;
mod claims_and_errata;
mod emulator_carr_claims;
mod emulator_carr_errata;
mod emulator_coplanar;
mod emulator_exhaustive;
mod emulator_figure_2;
mod emulator_fused;
mod emulator_lists;
mod emulator_parts;
mod emulator_section_6;
mod emulator_sgix_shadow;
mod emulator_subpasses;
mod emulator_verified_painter;
mod errata_carr;
mod errata_in_print;
mod errata_lindholm;
mod everitt_divides;
mod figure_2_orders;
mod lindholm;
mod listings;
mod listings_carr;
mod origins;
mod print;
mod readings;
mod smallest_change;
mod vtk_requirements;
