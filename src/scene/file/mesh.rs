//! `[[mesh]]`.

use std::path::Path;

use super::keys::Keys;
use super::limits::FRACTION;
use super::sources::Source;
use super::volume::NamedVolume;
use super::{generator, transform};
use crate::error::Result;
use crate::scene::generate::MAX_TRIANGLES;
use crate::scene::mesh::{self, Mesh, Shading};
use crate::scene::obj::{self, Paint};

/// All meshes of a file, in its order.
#[derive(Default)]
pub(super) struct Loaded {
    pub(super) meshes: Vec<Mesh>,
    pub(super) notices: Vec<String>,
    /// The meshes that each entry has made.
    pub(super) sources: Vec<Source>,
}

/// The keys of every mesh, from a file or from a generator.
const COMMON: [&str; 5] = ["name", "shading", "inside", "sorted", "transform"];
/// The keys that say where a mesh comes from, and the keys of a model.
const OWN: [&str; 4] = ["file", "generate", "color", "opacity"];

/// Reads all meshes. Isosurfaces are made from these volumes.
pub(super) fn load_all(top: &Keys, volumes: &[NamedVolume]) -> Result<Loaded> {
    let mut loaded = Loaded::default();
    let mut generated = 0;
    for keys in top.tables("mesh", "[[mesh]]")? {
        let first = loaded.meshes.len();
        load(&keys, volumes, &mut generated, &mut loaded)?;
        finish(&keys, &mut loaded, first)?;
        let name = keys.text("name")?.map(str::to_owned);
        let meshes = first..loaded.meshes.len();
        loaded.sources.push(Source {
            name,
            meshes,
            volumes: 0..0,
        });
    }
    Ok(loaded)
}

/// Reads or generates the meshes of one entry.
fn load(
    keys: &Keys,
    volumes: &[NamedVolume],
    generated: &mut u64,
    loaded: &mut Loaded,
) -> Result<()> {
    match (keys.text("file")?, keys.text("generate")?) {
        (Some(_), Some(_)) => Err(keys.wrong(
            "generate",
            "a mesh is either read from a file or generated",
            "Take out `file` or `generate`, or make two [[mesh]] of it.",
        )),
        (None, None) => {
            // A misspelt key is the more likely mistake.
            keys.expect_only(&[&OWN[..], &COMMON].concat())?;
            Err(keys.wrong(
                "file",
                "a mesh without geometry",
                format!(
                    "Give `file = \"model.obj\"`, or `generate` with one of: {}.",
                    generator::names()
                ),
            ))
        }
        (Some(file), None) => {
            keys.expect_only(&[&OWN[..], &COMMON].concat())?;
            read_file(keys, file, loaded)
        }
        (None, Some(_)) => generate(keys, volumes, generated, loaded),
    }
}

fn generate(
    keys: &Keys,
    volumes: &[NamedVolume],
    generated: &mut u64,
    loaded: &mut Loaded,
) -> Result<()> {
    let generator = generator::read(keys, &COMMON, volumes)?;
    *generated += generator.triangle_count();
    if *generated > MAX_TRIANGLES {
        let what = format!(
            "this and the meshes before it make {generated} triangles, at most {MAX_TRIANGLES} are generated"
        );
        return Err(keys.wrong("generate", what, "Ask for fewer."));
    }
    take(
        keys,
        "generate",
        generator.triangle_count(),
        generator.bytes(),
    )?;
    let mesh = generator.build();
    loaded.meshes.push(if generator.has_colors() {
        mesh
    } else {
        let paint = paint(keys)?;
        let [r, g, b] = paint.color.unwrap_or([1.0; 3]);
        mesh.painted([r, g, b, paint.opacity.unwrap_or(1.0)].into())
    });
    Ok(())
}

fn read_file(keys: &Keys, file: &str, loaded: &mut Loaded) -> Result<()> {
    let folder = keys.document.path.parent().unwrap_or(Path::new(""));
    let path = folder.join(file);
    let extension = path.extension().unwrap_or_default();
    if !extension.eq_ignore_ascii_case("obj") {
        return Err(keys.wrong(
            "file",
            "this is not a model that can be read",
            "Give a Wavefront model (.obj).",
        ));
    }
    let model = obj::load(&path, &paint(keys)?, keys.document.memory)?;
    loaded.meshes.extend(model.meshes);
    loaded.notices.extend(model.notices);
    Ok(())
}

/// Takes the memory of so many triangles, or returns the error that there is not enough.
fn take(keys: &Keys, key: &str, triangles: u64, bytes: u64) -> Result<()> {
    let room = keys.document.memory.take(bytes);
    room.map_err(|shortage| shortage.at(keys.place(key), format!("{triangles} triangles")))
}

fn paint(keys: &Keys) -> Result<Paint> {
    Ok(Paint {
        color: keys.vector32("color", &FRACTION)?,
        opacity: keys.number32("opacity", &FRACTION)?,
    })
}

/// The keys that files and generators share.
fn finish(keys: &Keys, loaded: &mut Loaded, first: usize) -> Result<()> {
    let transform = transform::read(keys)?;
    let shading = keys.word("shading")?.unwrap_or_default();
    let inside = keys.vector32("inside", &FRACTION)?;
    let sorted = keys.flag("sorted")?.unwrap_or(false);
    if inside.is_some() && shading != Shading::TwoSided {
        loaded.notices.push(format!(
            "{}: `inside` is used by shading = \"two-sided\" only",
            keys.place("inside")
        ));
    }
    for mesh in &mut loaded.meshes[first..] {
        *mesh = std::mem::take(mesh).transformed(&transform);
        if !mesh.is_finite() {
            return Err(keys.wrong(
                "transform",
                format!(
                    "this takes '{}' out of the range of 32-bit numbers",
                    mesh.name
                ),
                "Scale and move it less.",
            ));
        }
        mesh.shading = shading;
        mesh.inside = inside.unwrap_or(mesh.inside);
        mesh.sorted = sorted;
        if shading == Shading::Flat {
            let triangles = mesh.triangle_count() as u64;
            take(
                keys,
                "shading",
                triangles,
                mesh::bytes(3 * triangles, triangles),
            )?;
            *mesh = mesh.with_face_normals();
        }
    }
    Ok(())
}
