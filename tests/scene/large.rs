//! Small files that ask for a lot: what they take is linear in their size, or is refused before it is taken. Each of these
//! files would take hours or all memory if anything about it were quadratic, so that a test that ends has shown it.

use std::fmt::Write;

use crate::kit::scene::{Folder, Refused, refused};
use onionskin::generate::{Quads, quads};
use onionskin::{Animation, LoadOptions, MemoryLimit, Mesh, Scene, Vertex};

/// What a vertex takes.
const VERTEX: u64 = size_of::<Vertex>() as u64;
const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const QUAD: &str = "[[mesh]]\ngenerate = \"quads\"\ncount = 1\n";

fn animation(content: &str) -> Animation {
    let folder = Folder::new().with("s.toml", content);
    Animation::load(folder.path("s.toml")).unwrap_or_else(|error| panic!("{error}"))
}

/// The scene file's error if it may take so many bytes.
#[track_caller]
fn over(bytes: u64, content: &str) -> Refused {
    let folder = Folder::new().with("s.toml", content);
    let options = LoadOptions {
        memory: MemoryLimit::of(bytes),
        ..LoadOptions::default()
    };
    refused(Scene::load_with(folder.path("s.toml"), &options))
}

/// 20,000 x 15,000 ranges would take 5 GB.
#[test]
fn many_shows_of_many_meshes_of_one_name() {
    let mut content = String::from("[path]\nframes = 30000\n");
    for from in 1..=20_000 {
        writeln!(content, "[[path.show]]\nfrom = {from}\nsources = [\"a\"]").unwrap();
    }
    content += &format!("{QUAD}name = \"a\"\n").repeat(15_000);
    content += &format!("{QUAD}name = \"b\"\n");
    let animation = animation(&content);
    assert_eq!(animation.frame(0).unwrap().meshes.len(), 15_001);
    assert_eq!(animation.frame(12_345).unwrap().meshes.len(), 15_000);
}

/// Each of 20,000 shows would look through each of 20,000 names.
#[test]
fn many_shows_of_as_many_names() {
    let mut content = String::from("[path]\nframes = 30000\n");
    for from in 1..=20_000 {
        writeln!(
            content,
            "[[path.show]]\nfrom = {from}\nsources = [\"{from}\", \"1\", \"{from}\"]"
        )
        .unwrap();
    }
    for name in 1..=20_000 {
        writeln!(content, "{QUAD}name = \"{name}\"").unwrap();
    }
    let animation = animation(&content);
    assert_eq!(animation.frame(1).unwrap().meshes.len(), 1);
    assert_eq!(animation.frame(20_000).unwrap().meshes.len(), 2);
}

/// A notice names its line; counting lines from the file's start for each would read terabytes.
#[test]
fn many_notices() {
    let mesh = format!("{QUAD}inside = [1, 0, 0]\n");
    let scene = animation(&mesh.repeat(200_000)).scene;
    assert_eq!(scene.notices.len(), 200_000);
    assert!(
        scene.notices[0].contains("s.toml:4: "),
        "{}",
        scene.notices[0]
    );
    assert!(scene.notices[199_999].contains("s.toml:800000: "));
}

#[test]
fn many_meshes() {
    let scene = animation(&QUAD.repeat(400_000)).scene;
    assert_eq!(
        (scene.meshes.len(), scene.triangle_count()),
        (400_000, 800_000)
    );
}

#[test]
fn what_is_shown_keeps_the_files_order_whatever_the_shows() {
    let content = "[path]\nframes = 9\n[[path.show]]\nfrom = 2\nsources = [\"b\", \"a\", \"b\"]\n\
                   [[mesh]]\ngenerate = \"plane\"\nname = \"a\"\n[[mesh]]\ngenerate = \"teapot\"\n\
                   [[mesh]]\ngenerate = \"cone\"\nname = \"b\"\n[[mesh]]\ngenerate = \"torus-knot\"\nname = \"a\"\n";
    let animation = animation(content);
    let names = |frame| -> Vec<String> {
        let meshes = animation.frame(frame).unwrap().meshes;
        meshes.into_iter().map(|mesh| mesh.name).collect()
    };
    assert_eq!(names(1), ["plane", "teapot", "cone", "torus-knot"]);
    assert_eq!(names(2), ["plane", "cone", "torus-knot"]);
    assert_eq!(names(8), ["plane", "cone", "torus-knot"]);
}

/// Each generator, as large as it may be, asks for its memory first.
#[test]
fn generators_of_legal_size_are_refused_before_they_take_memory() {
    for (keys, line) in [
        ("generate = \"teapot\"\ncells = 559", 2),
        ("generate = \"plane\"\ncells = 3162", 2),
        ("generate = \"quads\"\ncount = 10000000", 2),
        ("generate = \"slices\"\ncount = 10000000\ncells = 1", 2),
        ("generate = \"cone\"\nsides = 10000000\ntop = 1", 2),
        (
            "generate = \"torus-knot\"\nsegments = 100000\nsides = 100",
            2,
        ),
        ("generate = \"soup\"\ncount = 20000000", 2),
        (
            "generate = \"streamlines\"\ncount = 100\nsteps = 10000\nsides = 9",
            2,
        ),
        ("generate = \"arrows\"\ncount = 300000\nsides = 11", 2),
    ] {
        // Half of what the fewest of them take.
        let refused = over(200 << 20, &format!("[[mesh]]\n{keys}\n"))
            .says("triangles take")
            .says("200.0 MiB may be taken")
            .suggests("allow more memory");
        assert_eq!(refused.line, Some(line), "{refused:?}");
    }
}

#[test]
fn several_meshes_are_added_up_and_facets_take_their_own() {
    let soup = "[[mesh]]\ngenerate = \"soup\"\ncount = 100000\n";
    // A triangle takes three vertices and three indices.
    let bytes = 100_000 * (3 * VERTEX + 12);
    let two = over(2 * bytes - 1, &soup.repeat(2)).says("100000 triangles take");
    assert_eq!(two.line, Some(5));
    let flat = over(2 * bytes - 1, &format!("{soup}shading = \"flat\"\n")).says("100000 triangles");
    assert_eq!(flat.line, Some(4));
    let folder = Folder::new().with("s.toml", soup.repeat(2));
    let options = LoadOptions {
        memory: MemoryLimit::of(2 * bytes),
        ..LoadOptions::default()
    };
    assert_eq!(
        Scene::load_with(folder.path("s.toml"), &options)
            .unwrap()
            .meshes
            .len(),
        2
    );
    assert_eq!(options.memory.left(), 0);
}

#[test]
fn volumes_that_are_generated_are_refused_before_they_take_memory() {
    let transfer = "transfer = [{ value = 0, color = [1, 1, 1], density = 0 }]\n";
    for name in [
        "constant",
        "ball",
        "gradient",
        "shepp-logan",
        "potential",
        "ejection",
        "swirl",
    ] {
        let content = format!("[[volume]]\ngenerate = \"{name}\"\nsamples = 512\n{transfer}");
        over(500 << 20, &content)
            .at(3, "512")
            .says("the samples take 512.0 MiB");
    }
}

#[test]
fn files_are_refused_by_their_size() {
    let folder = Folder::new().with("m.obj", TRIANGLE.repeat(1000));
    let options = LoadOptions {
        memory: MemoryLimit::of(1000),
        ..LoadOptions::default()
    };
    refused(Scene::load_with(folder.path("m.obj"), &options)).says("bytes take");
}

/// What a generator says it takes is what it takes.
#[test]
fn the_memory_that_is_asked_for_is_the_meshs() {
    let mesh: Mesh = quads(&Quads {
        count: 1000,
        ..Quads::default()
    })
    .unwrap();
    assert_eq!(mesh.bytes(), 1000 * (4 * VERTEX + 2 * 12));
    for keys in [
        "generate = \"teapot\"\ncells = 7",
        "generate = \"plane\"\ncells = 9",
        "generate = \"slices\"\ncount = 5\ncells = 3",
        "generate = \"cone\"\nsides = 12\ntop = 1",
        "generate = \"torus-knot\"\nsegments = 40\nsides = 9",
        "generate = \"soup\"\ncount = 77",
        "generate = \"streamlines\"\nflow = \"bundle\"\ncount = 4\nsteps = 9\nsides = 5\nlength = 0.1",
        "generate = \"arrows\"\nflow = \"bundle\"\ncount = 4\nsides = 5",
    ] {
        let folder = Folder::new().with("s.toml", format!("[[mesh]]\n{keys}\n"));
        let options = LoadOptions {
            memory: MemoryLimit::of(1 << 30),
            ..LoadOptions::default()
        };
        let scene = Scene::load_with(folder.path("s.toml"), &options).unwrap();
        let taken = (1 << 30) - options.memory.left();
        // Never less; a teapot drops the triangles that vanish at its poles, and a line may end early.
        let mesh = scene.meshes[0].bytes();
        assert!(taken >= mesh, "{keys}: {taken} for {mesh}");
        let most = if keys.contains("teapot") {
            mesh + 8 * 7 * 12 + 100
        } else {
            mesh
        };
        assert!(taken <= most, "{keys}: {taken} for {mesh}");
    }
}

#[test]
fn an_isosurface_asks_for_its_mesh_and_what_it_needs_to_make_it() {
    let content = "[[volume]]\ngenerate = \"ball\"\nsamples = 32\nname = \"v\"\nhidden = true\n\
                   [[mesh]]\ngenerate = \"isosurface\"\nvolume = \"v\"\nvalue = 0.5\n";
    let folder = Folder::new().with("s.toml", content);
    let options = LoadOptions {
        memory: MemoryLimit::of(1 << 30),
        ..LoadOptions::default()
    };
    let scene = Scene::load_with(folder.path("s.toml"), &options).unwrap();
    let taken = (1 << 30) - options.memory.left();
    let vertices = scene.meshes[0].vertices.len() as u64;
    // Its triangles, vertices and their table, and the volume's samples.
    assert_eq!(
        taken,
        scene.meshes[0].bytes() + vertices * 48 + 4 * 32 * 32 * 32
    );
    over(200_000, content).says("triangles take");
}
