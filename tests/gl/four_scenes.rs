//! The four scenes after those of Lindholm et al. 2015 (figures 1, 8, 9, 10 and table 1): what is in them, and claim L03.

use onionskin::generate::{Quads, quads};
use onionskin::{Complexity, Context, CountBy, Renderer, Scene};

/// A file, its volumes and meshes, and what its triangles are thousands of, at the least.
const SCENES: [(&str, usize, usize, usize); 4] = [
    ("molecule_fused", 2, 5, 160),
    ("space", 2, 3, 160),
    ("medical", 2, 4, 500),
    ("flow", 1, 2, 1000),
];

const SIZE: [u32; 2] = [256, 192];

fn load(name: &str) -> Scene {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/scenes");
    Scene::load_at(format!("{folder}/{name}.toml"), Some(SIZE)).unwrap()
}

fn count(scene: &Scene) -> Complexity {
    let context = Context::headless().unwrap();
    let mut renderer = Renderer::new(&context, SIZE[0], SIZE[1]).unwrap();
    renderer.complexity(scene, CountBy::Blending).unwrap()
}

/// Half of the covered pixels have at most such a part of the deepest one's fragments.
fn falls(complexity: &Complexity, part: u32) -> bool {
    part * complexity.percentile(0.5) <= complexity.max()
}

#[test]
fn the_scenes_have_the_sources_of_table_1() {
    for (name, volumes, meshes, thousands) in SCENES {
        let scene = load(name);
        assert_eq!(scene.volumes.len(), volumes, "{name}");
        assert_eq!(scene.meshes.len(), meshes, "{name}");
        let triangles = scene.triangle_count();
        println!("{name}: {triangles} triangles");
        assert!(triangles > 1000 * thousands, "{name}: {triangles}");
        let transparent = scene.meshes.iter().filter(|mesh| !mesh.opaque);
        assert!(transparent.count() > 0, "{name}");
    }
}

/// The surfaces' histograms fall to a third. With the boxes of volumes, two fragments of each on every ray through it, to a
/// half at least: where few surfaces stand in two boxes, as in `space`, the boxes are most of what there is.
#[test]
pub(crate) fn l03_most_pixels_lie_far_below_the_maximum() {
    for (name, ..) in SCENES {
        let mut scene = load(name);
        for part in [2, 3] {
            let complexity = count(&scene);
            let (median, max) = (complexity.percentile(0.5), complexity.max());
            let what = format!("{name}: median {median}, at most {max}");
            println!("{what}");
            assert!(complexity.covered() > 1000, "{name}");
            assert!(falls(&complexity, part), "{what}");
            scene.volumes.clear();
        }
    }
}

#[test]
pub(crate) fn a_stack_that_is_as_deep_everywhere_does_not_fall() {
    let stack = quads(&Quads {
        count: 12,
        alpha: 0.5,
        ..Quads::default()
    })
    .unwrap();
    assert!(!falls(&count(&Scene::of("stack", vec![stack])), 2));
}
