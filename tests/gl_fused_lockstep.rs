//! Fused rendering twice: section 6.1 and ppDP line by line on the emulated pixel, and the shaders on OpenGL. The same
//! light from the same lists, in as many subpasses, by as many records.

use std::cell::Cell;

use onionskin::emulator::{RayScene, RayVolume, run_on_rays};
use onionskin::fragment::{Fragment, Rgba, Source};
use onionskin::image::Image;
use onionskin::methods::{ABufferOptions, Frame, Manager, RecordColor};
use onionskin::oracle::volumes::Ray;
use onionskin::papers::lindholm_2015::components::PP_DP;
use onionskin::papers::lindholm_2015::fused::{FUSED, FUSED_AMENDMENTS, FUSED_PP_DP};
use onionskin::papers::vtk;
use onionskin::scene::{Medium, Mesh, Transfer, TransferPoint, Volume};
use onionskin::steps::pseudo::Algorithm;
use onionskin::steps::pseudo::list::Line;
use onionskin::steps::{Amendment, Variables, run};
use onionskin::{Context, Method, Renderer, Scene};
use proptest::prelude::*;
use proptest::test_runner::TestError;

#[path = "common/fog_plans.rs"]
mod fog_plans;
#[path = "common/fog_scenes.rs"]
#[allow(dead_code)]
mod fog_scenes;
#[path = "common/lists.rs"]
#[allow(dead_code)]
mod lists;
#[path = "common/slack.rs"]
#[allow(dead_code)]
mod slack;
#[path = "common/stack.rs"]
#[allow(dead_code)]
mod stack;
use fog_plans::plans;
use fog_scenes::fog_and_pane;
use lists::{Lists, machine};

/// Depths are f32: see `gl_volumes.rs`.
const BOUND: f64 = 1e-5;

/// A scene's pixels, row by row from the top.
struct Pixels<'s> {
    scene: &'s Scene,
    surfaces: Lists,
    /// Bottom row first.
    opaque_depths: Vec<f32>,
    /// What lies behind all transparent surfaces and volumes.
    behind: Image,
}

impl<'s> Pixels<'s> {
    fn of(context: &Context, scene: &'s Scene) -> Self {
        let mut gl = machine(context, scene);
        run(&vtk::OPAQUE_FIRST, &[], Variables::new(), &mut gl).unwrap();
        let mut opaque = scene.clone().with_volumes(Vec::new());
        opaque.meshes.retain(|mesh: &Mesh| mesh.opaque);
        Self {
            scene,
            surfaces: Lists::of(context, scene),
            opaque_depths: gl.read_depths(vtk::OPAQUE_DEPTH).unwrap(),
            behind: render(context, &opaque, &Method::Exact).image,
        }
    }

    /// What the Fill Step leaves of a pixel: GL's surfaces, and where its ray crosses the boxes.
    fn list(&self, ray: &Ray, pixel: usize) -> Vec<Fragment> {
        let surfaces = self.surfaces.pixels[pixel].iter().map(|captured| Fragment {
            depth: captured.depth,
            color: captured.color,
            order: Source::Surface(captured.order).id(),
        });
        let mut list: Vec<Fragment> = surfaces.collect();
        let endless = Ray {
            near: 0.0,
            far: f64::INFINITY,
            ..*ray
        };
        for (number, volume) in (0..).zip(&self.scene.volumes) {
            let crossing = slack::crossing(&endless, volume);
            for (distance, leaves) in crossing.into_iter().zip([false, true]) {
                // Nothing is drawn behind the eye; what is before the near plane or behind the far one is clamped.
                if distance > 0.0 && distance < f64::INFINITY {
                    let depth = ray.far / (ray.far - ray.near) * (1.0 - ray.near / distance);
                    let source = Source::Proxy {
                        volume: number,
                        leaves,
                    };
                    list.push(Fragment {
                        depth: depth.clamp(0.0, 1.0) as f32,
                        color: Rgba::default(),
                        order: source.id(),
                    });
                }
            }
        }
        list
    }

    /// The emulated image, and subpasses and records read of all pixels.
    fn emulate(
        &self,
        algorithm: &Algorithm<Line>,
        amendments: &[Amendment<Line>],
        array: u32,
    ) -> (Image, [u64; 2]) {
        let [width, height] = self.scene.size;
        let mut image = self.behind.clone();
        let mut counts = [0, 0];
        for (pixel, seen) in image.pixels.iter_mut().enumerate() {
            let place = [pixel as u32 % width, height - 1 - pixel as u32 / width];
            let ray = Ray::through(&self.scene.camera, [width, height], place);
            let media: Vec<_> = self.scene.volumes.iter().map(|v| medium(&ray, v)).collect();
            let volumes = self.scene.volumes.iter().zip(&media);
            let scene = RayScene {
                planes: [ray.near, ray.far],
                slant: ray.direction.length(),
                opaque: self.opaque_depths[(place[1] * width + place[0]) as usize],
                volumes: volumes
                    .map(|(volume, medium)| RayVolume {
                        medium,
                        step: volume.sampling_distance(),
                    })
                    .collect(),
            };
            let list = self.list(&ray, pixel);
            if list.is_empty() {
                continue;
            }
            let pixels = [(list, scene)];
            let (lists, rays) = run_on_rays(algorithm, amendments, &pixels, array, 100).unwrap();
            counts[0] += u64::from(lists.pixels[0].subpasses);
            counts[1] += u64::from(lists.pixels[0].records_read);
            let [r, g, b] = rays[0].light;
            let through =
                |behind: f32, light: f64| (light + rays[0].transparency * f64::from(behind)) as f32;
            *seen = Rgba::new(
                through(seen.r, r),
                through(seen.g, g),
                through(seen.b, b),
                1.0,
            );
        }
        (image, counts)
    }
}

fn medium<'v>(ray: &'v Ray, volume: &'v Volume) -> impl Fn(f64) -> Medium + 'v {
    let to_index = volume.world_to_index();
    move |distance| {
        let place = to_index.transform_point3(ray.origin + ray.direction * distance);
        volume.transfer.at(volume.at_index(place))
    }
}

fn render(context: &Context, scene: &Scene, method: &Method) -> Frame {
    let [width, height] = scene.size;
    let mut renderer = Renderer::new(context, width, height).unwrap();
    renderer.render(scene, method).unwrap()
}

fn on_gl(context: &Context, scene: &Scene, manager: Manager, peel: Option<u32>) -> Frame {
    let options = ABufferOptions {
        manager,
        color: RecordColor::Float,
        pp_dp: peel.is_some(),
        peel: peel.unwrap_or(ABufferOptions::DEFAULT.peel),
        ..ABufferOptions::DEFAULT
    };
    render(context, scene, &Method::ABuffer(options))
}

/// How far the two are apart, less what the rasteriser may move the boxes by.
fn apart(frame: &Frame, emulated: Image, scene: &Scene) -> f64 {
    let emulated = Frame {
        image: emulated,
        ..frame.clone()
    };
    slack::compare(frame, &emulated, scene).1
}

/// Panes in, before and behind overlapping volumes, the eye in one, in two or in none of them: every ray meets the same.
fn whole_scenes() -> Vec<Scene> {
    let mut scenes = Vec::new();
    for (eye, alpha) in [(5.0, 0.4), (1.2, 0.4), (0.75, 0.4), (5.0, 1.0)] {
        let mut scene = fog_and_pane(eye, -0.4, alpha, 0.3);
        for (height, alpha) in [(0.2, 0.3), (-0.8, 0.5), (-1.5, 0.2)] {
            scene
                .meshes
                .extend(fog_and_pane(eye, height, alpha, 0.3).meshes);
        }
        let mut second = scene.volumes[0].clone();
        second = second
            .transformed(&onionskin::scene::Transform {
                scale: glam::DVec3::splat(1.4),
                ..Default::default()
            })
            .unwrap();
        let points = [0.0_f32, 1.0].map(|value| TransferPoint {
            value,
            color: [0.2, 1.0 - value, 0.3],
            density: value * 0.5,
        });
        scene
            .volumes
            .push(second.with_transfer(Transfer::new(points.into()).unwrap()));
        scenes.push(scene);
    }
    scenes
}

#[test]
fn l16_l17_the_pseudocode_and_the_shaders_see_the_same_light() {
    let context = Context::headless().unwrap();
    let mut worst = 0.0_f64;
    for scene in whole_scenes() {
        let pixels = Pixels::of(&context, &scene);
        for manager in [Manager::Ffb, Manager::Dfb, Manager::Ppll] {
            for peel in [None, Some(1), Some(3), Some(8)] {
                let frame = on_gl(&context, &scene, manager, peel);
                let (image, emulated) = match peel {
                    None => pixels.emulate(&FUSED, &FUSED_AMENDMENTS, 64),
                    Some(array) => pixels.emulate(&PP_DP, &FUSED_PP_DP, array),
                };
                let what = format!("{manager:?} {peel:?} eye {}", scene.camera.eye);
                let off = apart(&frame, image, &scene);
                assert!(off < BOUND, "{what}: {off}");
                worst = worst.max(off);
                let counts = frame.stats.a_buffer.unwrap();
                let on_gl = [counts.subpasses, counts.records_read];
                assert_eq!(emulated, on_gl, "{what}");
            }
        }
    }
    println!("at most {worst:e} apart");
}

#[test]
fn l16_l17_random_scenes_are_the_same_on_both() {
    let context = Context::headless().unwrap();
    let largest = Cell::new(0.0_f64);
    let ran = stack::runner(16).run(&(plans(), 1..9_u32), |(plan, array)| {
        let scene = plan.scene();
        let pixels = Pixels::of(&context, &scene);
        let frame = on_gl(&context, &scene, Manager::Dfb, Some(array));
        let (image, _) = pixels.emulate(&PP_DP, &FUSED_PP_DP, array);
        let off = apart(&frame, image, &scene);
        largest.set(largest.get().max(off));
        prop_assert!(off < BOUND, "{off}");
        Ok(())
    });
    match ran {
        Ok(()) => println!("at most {:e} apart", largest.get()),
        Err(TestError::Fail(why, (plan, array))) => panic!("arrays of {array}: {why}\n{plan:#?}"),
        Err(other) => panic!("{other}"),
    }
}

/// As the prose alone has it, without where a ray begins and what ends it.
#[test]
fn an_algorithm_that_differs_would_be_noticed() {
    let context = Context::headless().unwrap();
    let scenes = whole_scenes();
    for (scene, dropped) in [(&scenes[2], 0), (&scenes[3], 1)] {
        let pixels = Pixels::of(&context, scene);
        let frame = on_gl(&context, scene, Manager::Dfb, None);
        let (image, _) = pixels.emulate(&FUSED, &[FUSED_AMENDMENTS[1 - dropped]], 64);
        assert!(apart(&frame, image, scene) > 2.0 * BOUND);
    }
}
