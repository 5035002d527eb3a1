//! The command line as far as OpenGL.

#[path = "../kit/mod.rs"]
mod kit;

mod bad_input;
mod help;
mod hostile;
mod hostile_options;
mod terminal;
mod without_opengl;
