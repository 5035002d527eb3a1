//! What tests share. Every binary has all of it, and none uses all.
#![allow(dead_code, unreachable_pub)]

pub mod a_buffer;
pub mod bounds;
pub mod carr_scenes;
pub mod cast;
pub mod chance;
pub mod changed;
pub mod classic_cases;
pub mod cli;
pub mod diff;
pub mod emulated;
pub mod everitt_scenes;
pub mod exact_scenes;
pub mod fog;
pub mod fog_plans;
pub mod fog_scenes;
pub mod golden;
pub mod host;
pub mod lists;
pub mod loader;
pub mod lockstep;
pub mod masks;
pub mod peeling;
pub mod peels;
pub mod pp_dp;
pub mod records;
pub mod render;
pub mod scene;
pub mod sheets;
pub mod shortened;
pub mod slack;
pub mod slices;
pub mod small_scenes;
pub mod stack;
pub mod volume;
pub mod vtk_scenes;
