//! The command line where it draws.

#[path = "../kit/mod.rs"]
mod kit;

mod animate;
mod animate_killed;
mod bad_input;
mod check;
mod compare;
mod complexity;
mod depth;
mod depth_unit;
mod doctor;
mod peeling;
mod render;
mod threads;
mod volumes;
