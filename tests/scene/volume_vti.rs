//! VTK's images as people have them: data of cells, several arrays, pieces in one file and in several.

use crate::kit::scene::{Refused, refused};
use crate::kit::volume::*;
use glam::DVec3;
use onionskin::{Scene, Volume};

/// A file with this image element in it.
fn file(kind: &str, image: &str) -> String {
    format!(
        "<VTKFile type=\"{kind}\" version=\"1.0\" byte_order=\"LittleEndian\">\n{image}\n</VTKFile>\n"
    )
}

fn array(name: &str, components: usize, numbers: impl IntoIterator<Item = usize>) -> String {
    let words: Vec<String> = numbers
        .into_iter()
        .map(|number| number.to_string())
        .collect();
    format!(
        "<DataArray type=\"Float32\" Name=\"{name}\" NumberOfComponents=\"{components}\" format=\"ascii\">{}</DataArray>",
        words.join(" ")
    )
}

/// An image of 4 x 3 x 5 points, which are 3 x 2 x 4 cells.
fn image(data: &str) -> String {
    let head = "WholeExtent=\"0 3 0 2 0 4\" Origin=\"10 20 30\" Spacing=\"2 4 8\"";
    file(
        "ImageData",
        &format!("<ImageData {head}><Piece>{data}</Piece></ImageData>"),
    )
}

fn of_points(arrays: &str, active: &str) -> String {
    image(&format!("<PointData{active}>{arrays}</PointData>"))
}

fn scene_with(keys: &str, vti: &str) -> Scene {
    load_scene_with(keys, &[("v.vti", vti.as_bytes())]).unwrap_or_else(|error| panic!("{error}"))
}

fn refused_with(keys: &str, vti: &str) -> Refused {
    refused(load_scene_with(keys, &[("v.vti", vti.as_bytes())]))
}

fn first_of(scene: &Scene) -> f32 {
    scene.volumes[0].samples()[0]
}

#[test]
fn samples_of_cells_are_in_the_middles_of_the_cells() {
    let vti = image(&format!(
        "<PointData/><CellData Scalars=\"rho\">{}</CellData>",
        array("rho", 1, 0..24)
    ));
    let volume = read("v.vti", vti.as_bytes());
    assert_eq!(volume.dims(), [3, 2, 4]);
    assert_eq!(
        volume.samples(),
        (0..24).map(|i| i as f32).collect::<Vec<_>>()
    );
    let at = |index: DVec3| volume.index_to_world().transform_point3(index);
    assert_eq!(at(DVec3::ZERO), DVec3::new(11.0, 22.0, 34.0));
    assert_eq!(at(DVec3::new(2.0, 1.0, 3.0)), DVec3::new(15.0, 26.0, 58.0));
    // An extent that does not begin at 0, and a direction: x goes along y, y against x.
    let turned = vti
        .replace("0 3 0 2 0 4", "-1 2 5 7 0 4")
        .replace("Spacing", "Direction=\"0 -1 0 1 0 0 0 0 1\" Spacing");
    let volume = read("v.vti", turned.as_bytes());
    let first = volume.index_to_world().transform_point3(DVec3::ZERO);
    // 10 - 5.5 x 4, 20 - 0.5 x 2, 30 + 0.5 x 8.
    assert_eq!(first, DVec3::new(-12.0, 19.0, 34.0));
    // One cell along z is one sample.
    let flat = vti.replace("0 3 0 2 0 4", "0 3 0 4 0 1");
    bad("v.vti", flat.as_bytes()).says("middles of the cells");
}

#[test]
fn the_active_scalars_are_taken_or_the_only_ones_or_the_named_ones() {
    let a = array("a", 1, 100..160);
    let b = array("b", 1, 200..260);
    let v = array("v", 3, 0..180);
    let ghosts = array("vtkGhostType", 1, 0..60);
    let active = " Scalars=\"b\"";
    for (arrays, active, first) in [
        (format!("{a}{b}"), active, 200.0),
        (format!("{a}{v}{b}"), active, 200.0),
        (format!("{v}{a}"), "", 100.0),
        (format!("{v}{ghosts}{a}"), " Vectors=\"v\"", 100.0),
        // Vectors cannot be what is looked at.
        (format!("{v}{a}"), " Scalars=\"v\"", 100.0),
        // The active ones are not there.
        (a.clone(), active, 100.0),
    ] {
        let scene = scene_with("", &of_points(&arrays, active));
        assert_eq!(first_of(&scene), first);
        assert!(scene.notices.is_empty(), "{:?}", scene.notices);
    }
    let both = of_points(&format!("{v}{a}{b}"), "");
    let scene = scene_with("", &both);
    assert_eq!(first_of(&scene), 100.0);
    assert!(scene.notices[0].contains("'a', 'b'"), "{:?}", scene.notices);
    let scene = scene_with("array = \"b\"", &both);
    assert_eq!(first_of(&scene), 200.0);
    assert!(scene.notices.is_empty());
}

#[test]
fn points_come_before_cells_unless_others_are_named() {
    let points = array("p", 1, 100..160);
    let cells = array("c", 1, 200..224);
    let with = |active: &str| {
        image(&format!(
            "<CellData{active}>{cells}</CellData><PointData>{points}</PointData>"
        ))
    };
    assert_eq!(scene_with("", &with("")).volumes[0].dims(), [4, 3, 5]);
    assert_eq!(
        scene_with("", &with(" Scalars=\"c\"")).volumes[0].dims(),
        [3, 2, 4]
    );
    let scene = scene_with("array = \"c\"", &with(""));
    assert_eq!(
        (first_of(&scene), scene.volumes[0].dims()),
        (200.0, [3, 2, 4])
    );
}

#[test]
fn arrays_that_cannot_be_a_volume_are_refused_in_words() {
    let v = array("velocity", 3, 0..180);
    let a = array("rho", 1, 0..60);
    let both = of_points(&format!("{v}{a}"), "");
    refused_with("array = \"velocity\"", &both)
        .says("3 components")
        .suggests("'rho'");
    refused_with("array = \"roh\"", &both)
        .says("no array 'roh'")
        .suggests("'velocity', 'rho'");
    refused_with("", &of_points(&v, " Vectors=\"velocity\"")).says("'velocity' has 3 components");
    refused_with("", &image(""))
        .says("no arrays")
        .suggests("CellData");
    refused_with("array = \"x\"", &image("")).suggests("no arrays at all");
    // Formats with one array have no names for it.
    let head = nrrd_head("uchar", "raw", "little", "");
    let nrrd = [head.as_bytes(), b"\n", &[0; 24]].concat();
    refused(load_scene_with("array = \"x\"", &[("v.nrrd", &nrrd)]))
        .says("'x'")
        .suggests("Take out");
}

#[test]
fn text_of_an_array_may_stand_between_other_elements() {
    let words: Vec<String> = (0..60).map(|i| i.to_string()).collect();
    let (head, tail) = words.split_at(7);
    let data = format!(
        "<DataArray type=\"Int32\" Name=\"a\" format=\"ascii\"><InformationKey name=\"UNITS\"/>{}\n<!-- and -->{}</DataArray>",
        head.join(" "),
        tail.join(" ")
    );
    let volume = read("v.vti", of_points(&data, "").as_bytes());
    assert_eq!(volume.samples()[59], 59.0);
}

/// What the sample at these indices of the whole is in the tests of pieces.
fn value([x, y, z]: [usize; 3]) -> usize {
    x + 10 * y + 100 * z
}

/// A piece of points or of cells, by its extent.
fn piece(kind: &str, extent: [usize; 6]) -> String {
    let [x0, x1, y0, y1, z0, z1] = extent;
    let end = usize::from(kind == "PointData");
    let numbers = (z0..z1 + end).flat_map(|z| {
        (y0..y1 + end).flat_map(move |y| (x0..x1 + end).map(move |x| value([x, y, z])))
    });
    let data = array("a", 1, numbers);
    let extent = extent.map(|number| number.to_string()).join(" ");
    format!("<Piece Extent=\"{extent}\"><{kind}>{data}</{kind}></Piece>")
}

const WHOLE: &str = "WholeExtent=\"0 4 0 3 0 2\"";

#[track_caller]
fn is_whole(volume: &Volume, dims: [usize; 3]) {
    assert_eq!(volume.dims(), dims);
    for (i, &sample) in volume.samples().iter().enumerate() {
        let index = [i % dims[0], i / dims[0] % dims[1], i / dims[0] / dims[1]];
        assert_eq!(sample, value(index) as f32, "{index:?}");
    }
}

#[test]
fn several_pieces_are_put_together() {
    let halves = [[0, 2, 0, 3, 0, 2], [2, 4, 0, 3, 0, 2]];
    let eighths = [
        [0, 1, 0, 3, 0, 2],
        [1, 4, 0, 2, 0, 1],
        [1, 4, 2, 3, 0, 1],
        [1, 4, 0, 3, 1, 2],
    ];
    let nothing = "<Piece Extent=\"0 -1 0 -1 0 -1\"><PointData/><CellData/></Piece>";
    for (kind, dims) in [("PointData", [5, 4, 3]), ("CellData", [4, 3, 2])] {
        for pieces in [&halves[..], &eighths[..], &[[0, 4, 0, 3, 0, 2]][..]] {
            let pieces: String = pieces.iter().map(|extent| piece(kind, *extent)).collect();
            let vti = file(
                "ImageData",
                &format!("<ImageData {WHOLE}>{nothing}{pieces}</ImageData>"),
            );
            is_whole(&read("v.vti", vti.as_bytes()), dims);
        }
        let vti = file(
            "ImageData",
            &format!("<ImageData {WHOLE}>{}</ImageData>", piece(kind, halves[0])),
        );
        bad("v.vti", vti.as_bytes()).says("leave out");
    }
    // The whole and a part of it; the whole again and again.
    let whole = piece("PointData", [0, 4, 0, 3, 0, 2]);
    let half = piece("PointData", halves[0]);
    let of = |pieces: &str| {
        file(
            "ImageData",
            &format!("<ImageData {WHOLE}>{pieces}</ImageData>"),
        )
    };
    for pieces in [
        format!("{whole}{half}"),
        format!("{half}{whole}"),
        whole.repeat(8),
    ] {
        is_whole(&read("v.vti", of(&pieces).as_bytes()), [5, 4, 3]);
    }
    bad("v.vti", of(&whole.repeat(9)).as_bytes()).says("times over");
}

/// The files of a parallel image, the one that names the others first.
fn parallel(kind: &str, extents: &[[usize; 6]]) -> Vec<(String, String)> {
    let mut named = String::new();
    let mut files = Vec::new();
    for (i, extent) in extents.iter().enumerate() {
        let shown = extent.map(|number| number.to_string()).join(" ");
        named += &format!("<Piece Extent=\"{shown}\" Source=\"v_{i}.vti\"/>");
        let own = format!(
            "<ImageData WholeExtent=\"{shown}\">{}</ImageData>",
            piece(kind, *extent)
        );
        files.push((format!("v_{i}.vti"), file("ImageData", &own)));
    }
    let head = format!(
        "<PImageData {WHOLE} GhostLevel=\"0\" Origin=\"1 2 3\" Spacing=\"2 2 2\"><P{kind} Scalars=\"a\"><PDataArray type=\"Float32\" Name=\"a\"/></P{kind}>{named}<Piece Extent=\"0 -1 0 -1 0 -1\" Source=\"none.vti\"/></PImageData>"
    );
    files.insert(0, ("v.pvti".to_owned(), file("PImageData", &head)));
    files
}

fn load_parallel(files: &[(String, String)]) -> Result<Volume, onionskin::Error> {
    let files: Vec<_> = files
        .iter()
        .map(|(name, text)| (name.as_str(), text.as_bytes()))
        .collect();
    load(&files)
}

#[test]
fn pieces_in_files_of_their_own_are_put_together() {
    for (kind, dims, first) in [("PointData", [5, 4, 3], 1.0), ("CellData", [4, 3, 2], 2.0)] {
        let files = parallel(
            kind,
            &[[0, 2, 0, 3, 0, 2], [2, 4, 0, 3, 0, 1], [2, 4, 0, 3, 1, 2]],
        );
        let volume = load_parallel(&files).unwrap();
        is_whole(&volume, dims);
        let corner = volume.index_to_world().transform_point3(DVec3::ZERO);
        assert_eq!(corner, DVec3::new(first, first + 1.0, first + 2.0));
    }
}

#[test]
fn pieces_that_do_not_fit_are_refused() {
    let files = parallel("PointData", &[[0, 2, 0, 3, 0, 2], [2, 4, 0, 3, 0, 2]]);
    let changed = |from: &str, to: &str| {
        let mut files = files.clone();
        assert!(files[0].1.contains(from), "{from}");
        files[0].1 = files[0].1.replace(from, to);
        refused(load_parallel(&files))
    };
    assert_eq!(changed("v_1.vti", "v_7.vti").file, "v_7.vti");
    changed("v_1.vti", "v_0.vti").says("two pieces");
    changed("Source=\"v_1.vti\"", "").says("in which file");
    changed("WholeExtent=\"0 4", "WholeExtent=\"0 9")
        .says("leave out 60 of the whole extent's 120");
    changed("PImageData", "ImageData")
        .says("ImageData")
        .suggests(".vti");
    changed("Name=\"a\"", "Name=\"b\"").says("no array 'b'");
    changed("0 4 0 3 0 2", "0 2000 0 2000 0 2000").says("more than");
    let wrong = [("v.vti".to_owned(), files[0].1.clone())];
    refused(load_parallel(&wrong))
        .says("PImageData")
        .suggests(".pvti");
}

#[test]
fn a_piece_that_promises_much_takes_nothing() {
    let vti = file(
        "ImageData",
        "<ImageData WholeExtent=\"0 700 0 700 0 700\"><Piece Extent=\"0 1 0 1 0 1\"><PointData><DataArray type=\"Float32\" Name=\"a\" format=\"ascii\">0 0 0 0 0 0 0 0</DataArray></PointData></Piece></ImageData>",
    );
    bad("v.vti", vti.as_bytes()).says("leave out");
    let vti = vti.replace(
        "Piece Extent=\"0 1 0 1 0 1\"",
        "Piece Extent=\"-2147483648 2147483647 0 1 0 1\"",
    );
    bad("v.vti", vti.as_bytes()).says("more than");
}
