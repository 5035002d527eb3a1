//! The listings and the pseudocode, in print and on the emulated pixel. No OpenGL.

#[path = "../kit/mod.rs"]
mod kit;

mod amendment_tests;
mod check;
mod emulator_carr_claims;
mod emulator_carr_errata;
mod emulator_coplanar;
mod emulator_exhaustive;
mod emulator_figure_2;
mod emulator_fused;
mod emulator_lists;
mod lindholm;
mod listings;
mod listings_carr;
mod print;
