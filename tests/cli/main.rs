//! The command line as far as OpenGL.

#[path = "../kit/mod.rs"]
mod kit;

/// Only a path that leads to a test here compiles.
macro_rules! cited {
    (cli $(:: $name:ident)+) => { const _: fn() = crate $(:: $name)+; };
    ($($elsewhere:tt)+) => {};
}

#[path = "../kit/ledger.rs"]
mod ledger;

mod bad_input;
mod help;
mod hostile;
mod hostile_options;
mod ledger_rows;
mod listing;
mod terminal;
mod without_opengl;
