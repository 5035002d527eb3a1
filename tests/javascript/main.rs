//! The machine of the pages is the emulated pixel: it runs every program in every reading on random surfaces, call by call.
//! No OpenGL. Without node the tests are skipped, aloud.

#[path = "../kit/chance.rs"]
#[allow(dead_code, unreachable_pub)] // it has more than is used here
mod chance;

mod calls;
mod calls_coherent;
mod cases;
mod compare;
mod control;
mod digest;
mod dragged;
mod emulated;
mod exact;
mod followed;
mod lines;
mod node;
mod pseudocode;
