//! What is read, and what is made of it: scene files, models, volumes, images. No OpenGL.

#[path = "../kit/mod.rs"]
mod kit;

/// Only a path that leads to a test here compiles.
macro_rules! cited {
    (scene $(:: $name:ident)+) => { const _: fn() = crate $(:: $name)+; };
    ($($elsewhere:tt)+) => {};
}

#[path = "../kit/ledger.rs"]
mod ledger;

mod any_bytes;
mod bad_models;
mod camera;
mod files;
mod flow;
mod fuzz_findings;
mod generators;
mod image_files;
mod large;
mod obj;
mod obj_libraries;
mod obj_materials;
mod obj_polygons;
mod obj_polygons_random;
mod obj_tolerated;
mod obj_writers;
mod oracle_volumes;
mod path;
mod soup;
mod teapot;
mod toml;
mod toml_refused;
mod torus_knot;
mod volume_any_bytes;
mod volume_bad_files;
mod volume_bad_vti;
mod volume_empty;
mod volume_files;
mod volume_nrrd;
mod volume_scenes;
mod volume_vti;
