//! The exact image's fragments against geometry done by hand, in one piece and in several.

use crate::kit::bounds::F32;
use crate::kit::cast::{Cast, cast};
use crate::kit::exact_scenes::{depth_bound, looking_down_z, place_bound, soup_scene};
use crate::kit::lists::{Lists, captured, sorted};
use onionskin::generate::{Quads, Soup, Teapot, quads, soup, teapot};
use onionskin::low_level::gl::CapturedFragment;
use onionskin::{Camera, Context, Rgba, Scene, Shading};

#[test]
fn random_triangles_are_where_the_rays_meet_them() {
    let context = Context::headless().unwrap();
    for seed in 0..3 {
        let scene = soup_scene(seed);
        Agreement::of(&context, &scene).assert_all();
    }
}

#[test]
fn random_triangles_seen_from_very_near_are_where_the_rays_meet_them() {
    let context = Context::headless().unwrap();
    Agreement::of(&context, &near_soup()).assert_all();
}

#[test]
fn triangles_of_large_meshes_keep_their_places_in_the_order_of_submission() {
    // However many draw calls a large mesh takes: the rays know each fragment's triangle.
    let context = Context::headless().unwrap();
    let parameters = Soup {
        count: 30_000,
        triangle_size: [0.02, 0.06],
        ..Soup::default()
    };
    let mut scene = Scene::of("soup", vec![soup(&parameters).unwrap(); 2]);
    scene.size = [160, 120];
    scene.meshes[1] = scene.meshes[1].shuffled(1);
    Agreement::of(&context, &scene).assert_all();
}

#[test]
fn colors_between_corners_are_interpolated_in_perspective() {
    let context = Context::headless().unwrap();
    let mut scene = near_soup();
    for (number, vertex) in scene.meshes[0].vertices.iter_mut().enumerate() {
        let part = |step: usize| (number * step % 17) as f32 / 16.0;
        vertex.color = Rgba::new(part(5), part(7), part(11), part(3));
    }
    Agreement::of(&context, &scene).assert_all();
}

#[test]
fn the_teapot_is_where_the_rays_meet_it() {
    let context = Context::headless().unwrap();
    Agreement::of(&context, &teapot_scene(Shading::None)).assert_all();
}

#[test]
fn lit_surfaces_follow_the_shader_s_formula() {
    let context = Context::headless().unwrap();
    Agreement::of(&context, &teapot_scene(Shading::Lit)).assert_all();
}

#[test]
fn a_flat_surface_has_the_light_of_its_triangle_s_own_normal() {
    let context = Context::headless().unwrap();
    let mut scene = teapot_scene(Shading::Flat);
    scene.meshes[0] = scene.meshes[0].with_face_normals();
    Agreement::of(&context, &scene).assert_all();
    // The rays' own normals, from the corners, not from what the mesh says.
    let mesh = &mut scene.meshes[0];
    for triangle in 0..mesh.triangle_count() {
        let [a, b, c] = mesh.corners(triangle).map(|v| v.position);
        let normal = (b - a).cross(c - a).normalize().as_vec3();
        for corner in mesh.triangles[triangle] {
            let said = mesh.vertices[corner as usize].normal;
            // Three differences and a product of f32 positions; slivers lose a few more digits.
            assert!(said.distance(normal) < 1e-3, "{triangle}: {said} {normal}");
        }
    }
}

#[test]
fn smooth_light_instead_of_flat_would_be_noticed() {
    let context = Context::headless().unwrap();
    let lit = captured_and_cast(
        &context,
        &teapot_scene(Shading::Lit),
        &teapot_scene(Shading::Lit),
    );
    let mut flat = teapot_scene(Shading::Flat);
    flat.meshes[0] = flat.meshes[0].with_face_normals();
    let mixed = captured_and_cast(&context, &teapot_scene(Shading::Lit), &flat);
    assert_eq!(lit.wrong_colors, 0);
    assert!(mixed.wrong_colors > mixed.fragments / 2, "{mixed:?}");
}

#[test]
fn two_sided_surfaces_show_their_inside_where_they_are_seen_clockwise() {
    let context = Context::headless().unwrap();
    let scene = teapot_scene(Shading::TwoSided);
    Agreement::of(&context, &scene).assert_all();
    let hits = cast(&scene).pixels;
    let front = hits.iter().flatten().filter(|hit| hit.front).count();
    let back = hits.iter().flatten().filter(|hit| !hit.front).count();
    assert!(front > 1000 && back > 1000, "{front} {back}: both are seen");
}

#[test]
fn inside_and_outside_exchanged_would_be_noticed() {
    let context = Context::headless().unwrap();
    let scene = teapot_scene(Shading::TwoSided);
    let mut turned = scene.clone();
    turned.meshes[0]
        .triangles
        .iter_mut()
        .for_each(|t| t.swap(1, 2));
    let agreement = captured_and_cast(&context, &scene, &turned);
    assert_eq!(agreement.wrong_colors, agreement.fragments, "{agreement:?}");
}

#[test]
fn two_missing_triangles_of_600_would_be_noticed() {
    let context = Context::headless().unwrap();
    let scene = soup_scene(0);
    let mut missing = scene.clone();
    missing.meshes[0].triangles.truncate(598);
    let agreement = captured_and_cast(&context, &missing, &scene);
    assert!(agreement.wrong_counts > 5, "{agreement:?}");
}

#[test]
fn a_shift_by_a_hundredth_of_a_pixel_would_be_noticed() {
    let context = Context::headless().unwrap();
    let scene = soup_scene(0);
    let mut shifted = scene.clone();
    // The image is about 2 high here.
    let step = 0.01 * 2.0 / f64::from(scene.size[1]);
    shifted.camera.eye.x += step;
    shifted.camera.target.x += step;
    let agreement = captured_and_cast(&context, &scene, &shifted);
    assert!(
        agreement.wrong_depths > agreement.fragments / 10,
        "{agreement:?}"
    );
}

#[test]
fn fragments_captured_in_pieces_are_those_captured_in_one_go() {
    let context = Context::headless().unwrap();
    let scene = soup_scene(4);
    let whole = sorted(captured(&context, &scene, u32::MAX).unwrap());
    let most = Lists::of(&context, &scene).complexity() as u32;
    // Down to pieces of a single pixel.
    for limit in [5000, 333, most] {
        let pieces = sorted(captured(&context, &scene, limit).unwrap());
        assert!(whole == pieces, "at most {limit} at a time");
    }
}

#[test]
fn a_pixel_with_more_fragments_than_fit_is_an_error_that_names_it() {
    let context = Context::headless().unwrap();
    let scene = soup_scene(4);
    let lists = Lists::of(&context, &scene);
    let most = lists.complexity();
    let error = captured(&context, &scene, most as u32 - 1)
        .unwrap_err()
        .to_string();
    let deepest: Vec<_> = lists
        .pixels
        .iter()
        .filter(|list| list.len() == most)
        .map(|list| {
            format!(
                "the pixel {}, {} has {most} fragments",
                list[0].x, list[0].y
            )
        })
        .collect();
    assert!(deepest.iter().any(|named| error.contains(named)), "{error}");
    assert!(
        error.contains(&format!("at most {} fit", most - 1)),
        "{error}"
    );
}

#[test]
fn a_list_longer_than_any_buffer_is_captured_whole() {
    let context = Context::headless().unwrap();
    let bytes = context.driver().limit("GL_MAX_SHADER_STORAGE_BLOCK_SIZE");
    let fit = bytes.min(i64::from(i32::MAX)) / size_of::<CapturedFragment>() as i64;
    let size = [256, 192];
    let pixels = i64::from(size[0]) * i64::from(size[1]);
    let count = fit / pixels + 1;
    if count > 128 {
        println!("skipped: one buffer of this driver holds {fit} fragments");
        return;
    }
    let sheets = quads(&Quads {
        count: count as u32,
        size: [100.0, 100.0],
        spacing: 0.01,
        ..Quads::default()
    });
    let mut scene = Scene::of("sheets", vec![sheets.unwrap()]);
    scene.size = size;
    scene.camera = looking_down_z(6.0, 40.0);
    let mut seen = vec![0_u128; pixels as usize];
    for fragment in captured(&context, &scene, u32::MAX).unwrap() {
        let sheet = 1_u128 << (fragment.order / 2);
        let pixel = &mut seen[(fragment.y * size[0] + fragment.x) as usize];
        assert_eq!(*pixel & sheet, 0, "twice: {fragment:?}");
        *pixel |= sheet;
    }
    let all = u128::MAX >> (128 - count);
    assert!(seen.iter().all(|pixel| *pixel == all));
}

/// Captured fragments against cast rays.
#[derive(Clone, Copy, Debug, Default)]
struct Agreement {
    /// Pixels whose centre is clear of every edge, and pixels that are not.
    certain: usize,
    doubtful: usize,
    /// Fragments of certain pixels.
    fragments: usize,
    /// Pixels with other triangles than the rays met.
    wrong_counts: usize,
    wrong_depths: usize,
    wrong_colors: usize,
    /// The largest error, as a part of its bound.
    depth: f64,
    color: f64,
}

impl Agreement {
    fn of(context: &Context, scene: &Scene) -> Self {
        captured_and_cast(context, scene, scene)
    }

    #[track_caller]
    fn assert_all(self) {
        println!("{self:?}");
        assert!(self.fragments > 5000, "a scene worth the name: {self:?}");
        assert!(self.certain > self.doubtful * 10, "{self:?}");
        assert_eq!(
            (self.wrong_counts, self.wrong_depths, self.wrong_colors),
            (0, 0, 0),
            "{self:?}"
        );
    }
}

/// Captures one scene and casts rays at the other, which should be the same.
fn captured_and_cast(context: &Context, drawn: &Scene, scene: &Scene) -> Agreement {
    let lists = Lists::of(context, drawn);
    let Cast { pixels, doubtful } = cast(scene);
    let mut agreement = Agreement::default();
    let place = place_bound(context, f64::from(scene.size[0].max(scene.size[1])));
    for ((list, hits), doubtful) in lists.pixels.into_iter().zip(pixels).zip(doubtful) {
        if doubtful {
            agreement.doubtful += 1;
            continue;
        }
        agreement.certain += 1;
        let mut list = list;
        list.sort_by_key(|fragment| fragment.order);
        agreement.fragments += list.len();
        if !list
            .iter()
            .map(|f| f.order)
            .eq(hits.iter().map(|hit| hit.order))
        {
            agreement.wrong_counts += 1;
            continue;
        }
        for (fragment, hit) in list.iter().zip(&hits) {
            let off = (f64::from(fragment.depth) - hit.depth).abs();
            let depth = off / depth_bound(hit.slope, place);
            let color = fragment.color.to_array().into_iter().zip(hit.color);
            let off = color.map(|(a, b)| (f64::from(a) - b).abs());
            let color = off.fold(0.0, f64::max) / color_bound(hit.color_slope, place);
            agreement.wrong_depths += usize::from(depth > 1.0);
            agreement.wrong_colors += usize::from(color > 1.0);
            agreement.depth = agreement.depth.max(depth);
            agreement.color = agreement.color.max(color);
        }
    }
    agreement
}

/// How far a colour may be off: interpolation and lighting in f32 (some 80 roundings of 2^-24 at most, which is 1e-5, no
/// more than the oracle is held to), and what a place that is off as in [`place_bound`] adds.
fn color_bound(slope: f64, place: f64) -> f64 {
    F32 + slope * place
}

/// From just outside, with a wide angle: depths and sizes change much within a triangle.
fn near_soup() -> Scene {
    let mut scene = soup_scene(1);
    scene.camera = Camera {
        near: 0.05,
        far: 5.0,
        ..looking_down_z(1.6, 90.0)
    };
    scene
}

fn teapot_scene(shading: Shading) -> Scene {
    let mut mesh = teapot(&Teapot { cells: 4 })
        .unwrap()
        .painted(Rgba::new(0.9, 0.2, 0.1, 0.5));
    mesh.inside = [0.1, 0.8, 0.3];
    mesh.shading = shading;
    let mut scene = Scene::of("teapot", vec![mesh]);
    scene.size = [160, 120];
    scene
}

/// A building's coordinates on a map: 500 km and 5000 km from the origin of its grid. In f32 they are half a metre apart.
const ON_THE_MAP: glam::DVec3 = glam::DVec3::new(500_000.125, 5_000_000.25, 300.5);

fn moved_to_the_map(scene: &Scene) -> Scene {
    let mut scene = scene.clone();
    for vertex in &mut scene.meshes[0].vertices {
        vertex.position += ON_THE_MAP;
    }
    scene.camera.eye += ON_THE_MAP;
    scene.camera.target += ON_THE_MAP;
    scene
}

#[test]
fn a_scene_at_map_coordinates_is_drawn_as_finely_as_at_the_origin() {
    let context = Context::headless().unwrap();
    let scene = moved_to_the_map(&soup_scene(2));
    // 5e6 has 2^-30 in f64, a hundredth of what f32 holds of this scene's coordinates: the bounds stay what they were.
    Agreement::of(&context, &scene).assert_all();
}

#[test]
fn coordinates_rounded_to_32_bits_would_be_noticed() {
    let context = Context::headless().unwrap();
    let scene = moved_to_the_map(&soup_scene(2));
    let mut rounded = scene.clone();
    for vertex in &mut rounded.meshes[0].vertices {
        vertex.position = vertex.position.as_vec3().as_dvec3();
    }
    let agreement = captured_and_cast(&context, &rounded, &scene);
    assert!(agreement.wrong_counts > 100, "{agreement:?}");
}
