//! Scenes with volumes twice: pseudocode on the emulated pixel, and A-buffers on OpenGL.

use onionskin::low_level::emulator::{RayScene, RayVolume, run_on_rays};
use onionskin::low_level::fragment::Source;
use onionskin::low_level::oracle::volumes::Ray;
use onionskin::low_level::papers::stage;
use onionskin::low_level::scene::Medium;
use onionskin::low_level::steps::pseudo::Pseudocode;
use onionskin::low_level::steps::pseudo::list::ListLine;
use onionskin::low_level::steps::{Amendment, Variables, run};
use onionskin::options::{ABufferOptions, Manager, RecordColor};
use onionskin::{Context, Fragment, Frame, Image, Mesh, Method, Renderer, Rgba, Scene, Volume};

use super::lists::{Lists, machine};
use super::slack;

/// A scene's pixels, row by row from the top.
pub struct Pixels<'s> {
    scene: &'s Scene,
    surfaces: Lists,
    /// Bottom row first.
    opaque_depths: Vec<f32>,
    /// What lies behind all transparent surfaces and volumes.
    behind: Image,
}

impl<'s> Pixels<'s> {
    pub fn of(context: &Context, scene: &'s Scene) -> Self {
        let mut gl = machine(context, scene);
        run(&stage::OPAQUE_FIRST, &[], Variables::new(), &mut gl).unwrap();
        let mut opaque = scene.clone().with_volumes(Vec::new());
        opaque.meshes.retain(|mesh: &Mesh| mesh.opaque);
        Self {
            scene,
            surfaces: Lists::of(context, scene),
            opaque_depths: gl.read_depths(stage::OPAQUE_DEPTH).unwrap(),
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

    /// The emulated image, and of all pixels subpasses, records read and fragments that were not composited.
    pub fn emulate(
        &self,
        algorithm: &Pseudocode<ListLine>,
        amendments: &[Amendment<ListLine>],
        array: u32,
    ) -> (Image, [u64; 3]) {
        let [width, height] = self.scene.size;
        let mut image = self.behind.clone();
        let mut counts = [0; 3];
        for (pixel, seen) in image.pixels.iter_mut().enumerate() {
            let place = [pixel as u32 % width, height - 1 - pixel as u32 / width];
            let ray = Ray::through(&self.scene.camera, [width, height], place);
            let media: Vec<_> = self.scene.volumes.iter().map(|v| medium(&ray, v)).collect();
            let volumes = self.scene.volumes.iter().zip(&media);
            let scene = RayScene {
                planes: [ray.near, ray.far],
                inverse_w: false,
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
            let count = list.len();
            let pixels = [(list, scene)];
            let (lists, rays) = run_on_rays(algorithm, amendments, &pixels, array, 100).unwrap();
            let done = &lists.pixels[0];
            counts[0] += u64::from(done.subpasses);
            counts[1] += u64::from(done.records_read);
            counts[2] += (count - done.composited.len()) as u64;
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

pub fn render(context: &Context, scene: &Scene, method: &Method) -> Frame {
    let [width, height] = scene.size;
    // The emulated rays end where the scene's planes are.
    let renderer = Renderer::new(context, width, height).unwrap();
    let mut renderer = renderer.with_given_planes();
    renderer.render(scene, method).unwrap()
}

/// What both count.
pub fn counts(frame: &Frame) -> [u64; 3] {
    let lists = frame.stats.a_buffer.unwrap();
    [
        lists.subpasses,
        lists.records_read,
        frame.stats.lost.unwrap(),
    ]
}

/// By ppDP, if it peels; otherwise by static arrays.
pub fn on_gl(context: &Context, scene: &Scene, manager: Manager, peel: Option<u32>) -> Frame {
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
pub fn apart(frame: &Frame, emulated: Image, scene: &Scene) -> f64 {
    let mut other = frame.clone();
    other.image = emulated;
    slack::compare(frame, &other, scene).1
}
