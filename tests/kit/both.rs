//! A scene on both machines, OpenGL and the emulated pixels, with all maps that a listing takes for granted.

use onionskin::low_level::emulator::{Emulator, Group, Surface};
use onionskin::low_level::gl::{Geometry, GlMachine};
use onionskin::low_level::methods::allocate_maps;
use onionskin::low_level::papers::stage;
use onionskin::low_level::steps::{Map, Resources};
use onionskin::{Context, Format, Scene};

use super::changed::Change;
use super::lockstep::{LockStep, Watched, surfaces};

/// What the machines have before a listing runs.
#[derive(Clone)]
pub struct Both {
    /// Besides the common stage's.
    pub resources: Vec<&'static Resources>,
    /// Of colours and of depths.
    pub formats: [Format; 2],
    pub defines: Vec<(&'static str, u32)>,
    /// As in [`LockStep`].
    pub color_bound: f32,
    /// Maps that are not compared.
    pub unwatched: Vec<Map>,
    /// Orders in which OpenGL's triangles are uploaded, each by mesh and number, if not in that of submission.
    pub orders: Vec<Vec<[u32; 2]>>,
    /// A changed word in one of OpenGL's shaders, to see whether it is noticed.
    pub change: Option<Change>,
}

impl Both {
    /// 32-bit floats, of which nothing may differ.
    pub fn with(resources: &[&'static Resources]) -> Self {
        Self {
            resources: resources.to_vec(),
            formats: [Format::Rgba32F, Format::Depth32FStencil8],
            defines: Vec::new(),
            color_bound: 0.0,
            unwatched: Vec::new(),
            orders: Vec::new(),
            change: None,
        }
    }

    pub fn defining(mut self, defines: &[(&'static str, u32)]) -> Self {
        self.defines.extend_from_slice(defines);
        self
    }

    pub fn changed(mut self, change: Change) -> Self {
        self.change = Some(change);
        self
    }

    fn watched(&self) -> Vec<Watched> {
        let [color, depth] = self.formats;
        let all = [&[&stage::RESOURCES], &self.resources[..]].concat();
        let maps = all.iter().flat_map(|resources| resources.maps);
        let maps = maps.filter(|(map, _)| !self.unwatched.contains(map));
        maps.map(|(map, holds)| Watched {
            map: *map,
            format: holds.format(color, depth),
        })
        .collect()
    }

    /// Makes both machines and drives them. Returns how many comparisons that were.
    pub fn drive(
        &self,
        context: &Context,
        scene: &Scene,
        drive: impl FnOnce(&mut LockStep<'_, '_>),
    ) -> usize {
        let [color, depth] = self.formats;
        let resources = [&[&stage::RESOURCES], &self.resources[..]].concat();
        let mut gl = GlMachine::new(context, scene.size).unwrap();
        if let Some(change) = self.change {
            change_shader(&mut gl, change);
        }
        allocate_maps(&mut gl, &resources, color, depth).unwrap();
        gl.set_geometry(Geometry::upload(context, scene, scene.size).unwrap());
        gl.begin_frame();
        let pixels = surfaces(&mut gl, scene, stage::IMAGE_COLOR);
        let mut emulator = Emulator::new(pixels.clone());
        allocate_maps(&mut emulator, &resources, color, depth).unwrap();
        emulator.set_planes([scene.camera.near, scene.camera.far]);
        emulator.set_defines(&self.defines);
        gl.set_defines(&self.defines);
        if !self.orders.is_empty() {
            let upload = Geometry::upload_in_orders(context, scene, scene.size, &self.orders);
            gl.set_geometry(upload.unwrap());
        }
        gl.begin_frame();
        let mut both = LockStep::new(
            &mut gl,
            &mut emulator,
            self.watched(),
            transparent_pixels(&pixels),
            self.color_bound,
        );
        drive(&mut both);
        both.compared
    }
}

/// Every pixel's surfaces, as [`surfaces`] has them of a machine.
pub fn surfaces_of(context: &Context, scene: &Scene) -> Vec<Vec<Surface>> {
    let mut gl = super::lists::machine(context, scene);
    surfaces(&mut gl, scene, stage::IMAGE_COLOR)
}

/// The pixels that have a transparent surface.
pub fn transparent_pixels(pixels: &[Vec<Surface>]) -> Vec<usize> {
    let has_one = |pixel: &usize| {
        let mut surfaces = pixels[*pixel].iter();
        surfaces.any(|surface| surface.group != Group::Opaque)
    };
    (0..pixels.len()).filter(has_one).collect()
}

/// Changes a word in a shader of OpenGL's.
pub fn change_shader(gl: &mut GlMachine<'_>, [file, from, to]: Change) {
    let text = onionskin::low_level::gl::shader_file(file).expect("the file exists");
    assert_eq!(text.matches(from).count(), 1, "'{from}' in glsl/{file}");
    gl.set_shader_file(file, &text.replace(from, to)).unwrap();
}

/// What the two machines say where they part, which they must.
#[track_caller]
pub fn parting(run: impl FnOnce()) -> String {
    let panic = std::panic::catch_unwind(std::panic::AssertUnwindSafe(run)).expect_err("noticed");
    panic.downcast_ref::<String>().expect("words").clone()
}

/// What colours up to 1 may differ by after ten blends, whatever the factors. The emulated pixel rounds two products and
/// their sum, each by at most half a step of 2^-24. So does llvmpipe, unless both factors are the same: it then adds first,
/// and multiplies once. Both are that far from what is exact.
pub const fn blending_bound() -> f32 {
    10.0 * 3.0 / 16_777_216.0
}
