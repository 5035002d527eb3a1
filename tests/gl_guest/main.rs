//! Contexts, and hosts that have their own: apart from the other tests, because they play with what Mesa shares in a process.

#[path = "../kit/mod.rs"]
mod kit;

mod allocations;
mod contexts;
mod pixels;
mod state;
mod variables;
