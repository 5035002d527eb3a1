//! Where VTK does something else than its page or its documentation says, on scenes of a few quads whose image is a sum.
//! What onionskin makes of them is always checked, and what VTK makes of them where VTK is there: figures were found with
//! VTK 9.7.2 on llvmpipe.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use onionskin::low_level::methods::{
    CoplanarDepthPeelingOptions, DepthPeelingOptions, DualDepthPeelingOptions,
};
use onionskin::{Context, Method, Renderer, Scene};

use super::vtk_picture;

/// A quad that faces the eye, at so much behind the plane z = 0.
#[derive(Clone, Copy)]
struct Pane {
    behind: f64,
    half: f64,
    color: usize,
    alpha: f64,
}

const COLORS: [[f64; 3]; 4] = [
    [1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, 0.0, 1.0],
    [1.0, 1.0, 0.0],
];
const SIZE: [u32; 2] = [128, 96];
const PLANES: [f64; 2] = [1.0, 8.0];

/// The scene's files, which both programs read.
struct Files {
    folder: tempfile::TempDir,
}

impl Files {
    /// The panes in this order of submission, before black.
    fn of(panes: &[Pane], [near, far]: [f64; 2]) -> Self {
        let folder = tempfile::tempdir().unwrap();
        let mut scene = format!(
            "size = {SIZE:?}\nbackground = [0.0, 0.0, 0.0]\n\n[camera]\neye = [0.0, 0.0, 3.0]\ntarget = [0.0, 0.0, \
             0.0]\nup = [0.0, 1.0, 0.0]\nfov = 30.0\nnear = {near:?}\nfar = {far:?}\n"
        );
        for (number, pane) in panes.iter().enumerate() {
            let (h, z) = (pane.half, -pane.behind);
            let corners = [[-h, -h], [h, -h], [h, h], [-h, h]];
            let corners = corners.map(|[x, y]| format!("v {x} {y} {z}\n")).concat();
            let model = format!("{corners}f 1 2 3\nf 1 3 4\n");
            std::fs::write(folder.path().join(format!("{number}.obj")), model).unwrap();
            let (color, alpha) = (COLORS[pane.color], pane.alpha);
            write!(
                scene,
                "\n[[mesh]]\nfile = \"{number}.obj\"\ncolor = {color:?}\nopacity = {alpha:?}\nshading = \"none\"\n"
            )
            .unwrap();
        }
        std::fs::write(folder.path().join("scene.toml"), scene).unwrap();
        Self { folder }
    }

    fn scene(&self) -> PathBuf {
        self.folder.path().join("scene.toml")
    }

    /// The middle pixel by a method, in steps of 8 bits, and how many fragments it says are lost.
    fn ours(&self, method: &Method) -> ([f64; 3], u64) {
        let context = Context::headless().unwrap();
        let scene = Scene::load(self.scene()).unwrap();
        let mut renderer = Renderer::new(&context, SIZE[0], SIZE[1]).unwrap();
        let frame = renderer.render(&scene, method).unwrap();
        let middle = frame.image.pixels[middle()].to_array();
        let middle = [0, 1, 2].map(|channel: usize| 255.0 * f64::from(middle[channel]));
        (middle, frame.stats.lost.unwrap())
    }

    /// The middle pixel by VTK, if it is there.
    fn vtk(&self, mode: &str, options: &[&str]) -> Option<[f64; 3]> {
        let picture = vtk_picture(&self.scene(), SIZE, mode, options)?;
        let found = super::bytes(&picture)[middle()].map(f64::from);
        println!("VTK, {mode} {options:?}: {found:?}");
        Some(found)
    }
}

fn middle() -> usize {
    (SIZE[1] / 2 * SIZE[0] + SIZE[0] / 2) as usize
}

/// So many panes front to back, a distance apart, in all colours by turns.
fn panes(count: usize, alpha: f64, apart: f64) -> Vec<Pane> {
    let pane = |number: usize| Pane {
        behind: number as f64 * apart,
        half: 3.0,
        color: number % 4,
        alpha,
    };
    (0..count).map(pane).collect()
}

/// Front to back, over black, in steps of 8 bits.
fn composited(panes: &[Pane]) -> [f64; 3] {
    let (mut light, mut through) = ([0.0; 3], 255.0);
    for pane in panes {
        for (sum, color) in light.iter_mut().zip(COLORS[pane.color]) {
            *sum += through * pane.alpha * color;
        }
        through *= 1.0 - pane.alpha;
    }
    light
}

fn apart(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3)
        .map(|channel| (a[channel] - b[channel]).abs())
        .fold(0.0, f64::max)
}

fn peeling(peels: u32) -> Method {
    Method::DepthPeeling(DepthPeelingOptions {
        maximum_number_of_peels: peels,
        ..DepthPeelingOptions::default()
    })
}

fn dual() -> Method {
    Method::DualDepthPeeling(DualDepthPeelingOptions::default())
}

fn coplanar() -> Method {
    Method::CoplanarDepthPeeling(CoplanarDepthPeelingOptions::default())
}

/// By each of these methods the image is the sum, and nothing is lost. 256 layers of 32-bit floats round by less than a
/// hundredth of a step of 8 bits: 256 x 3 x 2^-24 x 255.
#[track_caller]
fn right_here(files: &Files, expected: [f64; 3], methods: &[Method]) {
    for method in methods {
        let (found, lost) = files.ours(method);
        assert!(
            apart(found, expected) < 0.02,
            "{method}: {found:?}, not {expected:?}"
        );
        assert_eq!(lost, 0, "{method}");
    }
}

#[test]
pub(crate) fn vx01_by_0_peels_vtk_s_dual_pass_blends_unsorted() {
    let list = panes(4, 0.5, 0.1);
    let (expected, files) = (composited(&list), Files::of(&list, PLANES));
    right_here(&files, expected, &[peeling(0), dual()]);
    let unsorted: Vec<Pane> = list.iter().rev().copied().collect();
    let none = ["--max-peels", "0"];
    if let Some(found) = files.vtk("dual", &none) {
        // The order of submission is front to back, so blending puts the last in front.
        assert!(apart(found, composited(&unsorted)) <= 2.0, "{found:?}");
        assert!(apart(found, expected) > 50.0, "{found:?}, {expected:?}");
    }
    if let Some(found) = files.vtk("peel", &none) {
        assert!(apart(found, expected) <= 2.0, "{found:?}, {expected:?}");
    }
}

#[test]
pub(crate) fn vx02_four_peels_leave_layers_out() {
    let list = panes(12, 0.2, 0.1);
    let (expected, files) = (composited(&list), Files::of(&list, PLANES));
    right_here(&files, expected, &[peeling(0), dual()]);
    // Four peels here are off as much as VTK's, and say so.
    let (found, lost) = files.ours(&peeling(4));
    assert!(apart(found, expected) > 30.0, "{found:?}, {expected:?}");
    assert_eq!(lost, 8 * u64::from(SIZE[0] * SIZE[1]));
    let four = ["--max-peels", "4"];
    for (mode, least) in [("peel", 8.0), ("dual", 4.0)] {
        if let Some(found) = files.vtk(mode, &four) {
            assert!(
                apart(found, expected) > least,
                "{mode}: {found:?}, {expected:?}"
            );
        }
    }
}

#[test]
pub(crate) fn vx03_vtk_merges_or_drops_what_is_coplanar() {
    let red = panes(1, 0.5, 0.0)[0];
    let green = Pane { color: 1, ..red };
    for list in [[red, green], [green, red]] {
        let (expected, files) = (composited(&list), Files::of(&list, PLANES));
        right_here(&files, expected, &[coplanar(), dual(), Method::Exact]);
        if let Some(found) = files.vtk("dual", &[]) {
            assert_eq!(found, [128.0, 128.0, 0.0], "the larger of each channel");
        }
        if let Some(found) = files.vtk("peel", &[]) {
            // The second alone.
            assert!(apart(found, composited(&list[1..])) <= 1.0, "{found:?}");
        }
    }
}

#[test]
pub(crate) fn vx04_vtk_loses_a_layer_where_faces_are_doubled() {
    let red = panes(1, 0.5, 0.0)[0];
    let behind = Pane {
        color: 1,
        behind: 0.1,
        ..red
    };
    let list = [red, red, behind];
    let (expected, files) = (composited(&list), Files::of(&list, PLANES));
    right_here(&files, expected, &[coplanar(), dual()]);
    for mode in ["dual", "peel"] {
        if let Some(found) = files.vtk(mode, &[]) {
            assert!(
                apart(found, composited(&list[1..])) <= 2.0,
                "{mode}: {found:?}"
            );
            assert!(
                apart(found, expected) > 30.0,
                "{mode}: {found:?}, {expected:?}"
            );
        }
    }
}

#[test]
pub(crate) fn vx05_vtk_s_8_bits_do_not_add_up_faint_layers() {
    // Alphas below half a step of 8 bits, 1/510, vanish; of 256 layers the roundings add up.
    for (count, alpha, modes, off) in [
        (64, 0.0015, &["dual", "peel"][..], 10.0),
        (256, 0.02, &["peel"], 8.0),
    ] {
        let list = panes(count, alpha, 0.005);
        let (expected, files) = (composited(&list), Files::of(&list, PLANES));
        right_here(&files, expected, &[peeling(0), dual()]);
        for mode in modes {
            if let Some(found) = files.vtk(mode, &[]) {
                assert!(
                    apart(found, expected) > off,
                    "{mode}: {found:?}, {expected:?}"
                );
                assert!(
                    alpha > 1.0 / 510.0 || found == [0.0; 3],
                    "{mode}: {found:?}"
                );
            }
        }
    }
}

#[test]
pub(crate) fn vx06_by_loose_planes_vtk_merges_layers() {
    let list = panes(4, 0.5, 0.001);
    let (expected, files) = (composited(&list), Files::of(&list, [0.001, 10_000.0]));
    right_here(&files, expected, &[peeling(0), dual(), Method::Exact]);
    for mode in ["dual", "peel"] {
        if let Some(found) = files.vtk(mode, &[]) {
            assert!(
                apart(found, expected) > 30.0,
                "{mode}: {found:?}, {expected:?}"
            );
        }
        let close = Files::of(&list, PLANES);
        if let Some(found) = close.vtk(mode, &[]) {
            assert!(
                apart(found, expected) <= 2.0,
                "{mode}: {found:?}, {expected:?}"
            );
        }
    }
}

#[test]
pub(crate) fn vx07_without_peeling_vtk_averages_colours() {
    let list = panes(4, 0.5, 0.1);
    let (expected, files) = (composited(&list), Files::of(&list, PLANES));
    right_here(&files, expected, &[peeling(0), dual()]);
    let turned: Vec<Pane> = list.iter().rev().copied().collect();
    let pictures = [&files, &Files::of(&turned, PLANES)].map(|files| files.vtk("oit", &[]));
    if let [Some(found), Some(turned)] = pictures {
        assert_eq!(found, turned, "whatever the order");
        assert!(apart(found, expected) > 20.0, "{found:?}, {expected:?}");
    }
}

#[test]
pub(crate) fn vx08_an_occlusion_ratio_does_not_bound_the_image_s_error() {
    // Each pane has 0.56 of the area of the one before it.
    let pane = |(number, pane): (usize, Pane)| Pane {
        half: 0.9 * 0.75_f64.powi(number as i32),
        ..pane
    };
    let list: Vec<Pane> = panes(12, 0.3, 0.1)
        .into_iter()
        .enumerate()
        .map(pane)
        .collect();
    let (expected, files) = (composited(&list), Files::of(&list, PLANES));
    right_here(&files, expected, &[peeling(0), dual()]);
    let by_ratio = Method::DepthPeeling(DepthPeelingOptions {
        occlusion_ratio: 0.05,
        ..DepthPeelingOptions::default()
    });
    let (found, lost) = files.ours(&by_ratio);
    println!("here, by 0.05: {found:?}, {lost} lost");
    assert!(
        apart(found, expected) > 2.0 && lost > 0,
        "{found:?}, {expected:?}"
    );
    let ratio = ["--occlusion-ratio", "0.05"];
    for (mode, least) in [("dual", 10.0), ("peel", 2.0)] {
        if let Some(found) = files.vtk(mode, &ratio) {
            assert!(
                apart(found, expected) > least,
                "{mode}: {found:?}, {expected:?}"
            );
        }
    }
}

/// The scene's files are what both read.
#[test]
fn a_pane_less_would_be_noticed() {
    let list = panes(4, 0.5, 0.1);
    let files = Files::of(&list[..3], PLANES);
    let (found, _) = files.ours(&dual());
    assert!(apart(found, composited(&list)) > 10.0, "{found:?}");
    assert!(Path::new(&files.scene()).exists());
}
