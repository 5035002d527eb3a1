//! What the examples share: the folder of their scenes, and the folder for their pictures.

use std::path::{Path, PathBuf};

use onionskin::low_level::gl::{CapturedFragment, Geometry, GlMachine, capture};
use onionskin::low_level::methods::allocate_maps;
use onionskin::low_level::papers::stage;
use onionskin::low_level::steps::{Variables, run};
use onionskin::{Context, Format, Scene};

/// A file in the folder that the first argument names, or in `out` without an argument. The folder is made if it is
/// missing.
#[allow(dead_code)] // a window writes none
pub fn output(name: &str) -> onionskin::Result<PathBuf> {
    let folder = PathBuf::from(std::env::args().nth(1).unwrap_or_else(|| "out".into()));
    std::fs::create_dir_all(&folder).map_err(|e| {
        let what = format!("cannot make the folder {}: {e}", folder.display());
        onionskin::Error::usage(what, "name another one")
    })?;
    Ok(folder.join(name))
}

/// A bundled scene file.
#[allow(dead_code)] // the first example makes its own
pub fn scene(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("examples/scenes")
        .join(name)
}

/// Every transparent fragment that no opaque surface hides, in the order of submission.
#[allow(dead_code)] // most examples look at images only
pub fn fragments(context: &Context, scene: &Scene) -> onionskin::Result<Vec<CapturedFragment>> {
    let mut machine = GlMachine::new(context, scene.size)?;
    let (color, depth) = (Format::Rgba32F, Format::Depth32FStencil8);
    allocate_maps(&mut machine, &[&stage::RESOURCES], color, depth)?;
    machine.set_geometry(Geometry::upload(context, scene, scene.size)?);
    machine.begin_frame();
    run(&stage::OPAQUE_FIRST, &[], Variables::new(), &mut machine)?;
    let mut fragments = capture(&mut machine, stage::OPAQUE_DEPTH, u32::MAX)?;
    fragments.sort_by_key(|fragment| (fragment.order, fragment.y, fragment.x));
    Ok(fragments)
}
