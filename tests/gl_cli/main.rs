//! The command line where it draws.

#[path = "../kit/mod.rs"]
mod kit;

/// Only a path that leads to a test here compiles.
macro_rules! cited {
    (gl_cli $(:: $name:ident)+) => { const _: fn() = crate $(:: $name)+; };
    ($($elsewhere:tt)+) => {};
}

#[path = "../kit/ledger.rs"]
mod ledger;

mod animate;
mod animate_killed;
mod bad_input;
mod bench;
mod check;
mod compare;
mod complexity;
mod depth;
mod depth_unit;
mod doctor;
mod edition;
mod inspect;
mod peeling;
mod render;
mod threads;
mod volumes;
