//! Two machines that perform every call at the same time: OpenGL and the emulated pixels, held against each other after
//! each clear, each draw and each copy.

use std::collections::HashMap;

use onionskin::low_level::emulator::{Emulator, Group, Surface};
use onionskin::low_level::gl::{GlMachine, capture};
use onionskin::low_level::papers::stage;
use onionskin::low_level::steps::{
    Call, Machine, Map, Query, Target, Variables, Workspace, gl::*, run,
};
use onionskin::{Format, Fragment, Result, Scene};

/// What the two are compared in.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Watched {
    pub map: Map,
    pub format: Format,
}

/// A GL machine and emulated pixels of the same image, pixel by pixel in GL's order: bottom row first.
pub struct LockStep<'m, 'c> {
    pub gl: &'m mut GlMachine<'c>,
    pub emulator: &'m mut Emulator,
    /// Maps that are compared, as far as they are there.
    pub watched: Vec<Watched>,
    /// Pixels without any surface need not agree: GL draws over the screen only where there are surfaces.
    pub pixels: Vec<usize>,
    /// Largest difference of a color that counts as none: 0 for 32-bit floats. It is relative to values over 1.
    pub color_bound: f32,
    /// Comparisons made.
    pub compared: usize,
    /// What OpenGL's maps hold before anything is drawn. llvmpipe makes them all 0, as the emulated pixel does. On a GPU it is
    /// what was there before.
    unwritten: HashMap<Map, Contents>,
}

/// What OpenGL's map holds at every pixel.
#[derive(PartialEq)]
enum Contents {
    Depths(Vec<(f32, u8)>),
    Colors(Vec<[f32; 4]>),
    Integers(Vec<[u32; 4]>),
}

impl Machine for LockStep<'_, '_> {
    fn perform(&mut self, call: &Call) -> Result<()> {
        self.gl.perform(call)?;
        self.emulator.perform(call)?;
        if matches!(
            call,
            Call::Draw { .. }
                | Call::CopyImage { .. }
                | Call::Clear { .. }
                | Call::ClearFloats { .. }
                | Call::ClearIntegers { .. }
        ) {
            self.compare(call);
        }
        Ok(())
    }

    fn samples(&mut self, query: Query) -> Result<u64> {
        let [gl, emulated] = [self.gl.samples(query)?, self.emulator.samples(query)?];
        assert_eq!(gl, emulated, "samples of {}", query.0);
        Ok(gl)
    }
}

impl Workspace for LockStep<'_, '_> {
    fn allocate(&mut self, map: Map, format: Format) -> Result<()> {
        self.gl.allocate(map, format)?;
        self.emulator.allocate(map, format)
    }

    fn framebuffer_with(
        &mut self,
        target: Target,
        colors: &[Map],
        depth: Option<Map>,
    ) -> Result<()> {
        self.gl.framebuffer_with(target, colors, depth)?;
        self.emulator.framebuffer_with(target, colors, depth)
    }
}

impl<'m, 'c> LockStep<'m, 'c> {
    /// Both machines before the first call.
    pub fn new(
        gl: &'m mut GlMachine<'c>,
        emulator: &'m mut Emulator,
        watched: Vec<Watched>,
        pixels: Vec<usize>,
        color_bound: f32,
    ) -> Self {
        let held = |watched: &Watched| contents(gl, *watched).map(|held| (watched.map, held));
        let unwritten = watched.iter().filter_map(held).collect();
        // OpenGL leaves the rounding of a blend open. llvmpipe's is the emulated pixel's, to the bit. A GPU may round a
        // product and a sum together: each of up to 64 blends then is off by half a step of 2^-24, of colors up to 1.
        let rounds_alike = gl.context().driver().quirks().blends_in_three_roundings;
        let blending = if rounds_alike {
            0.0
        } else {
            64.0 * 2.0_f32.powi(-24)
        };
        Self {
            gl,
            emulator,
            watched,
            pixels,
            color_bound: color_bound + blending,
            compared: 0,
            unwritten,
        }
    }

    /// Whether OpenGL's map at a pixel is what it was before anything was drawn.
    fn is_unwritten(&self, map: Map, is_held: impl Fn(&Contents) -> bool) -> bool {
        self.unwritten.get(&map).is_some_and(is_held)
    }

    fn compare(&mut self, call: &Call) {
        for Watched { map, format } in self.watched.clone() {
            if format.has_depth() {
                self.compare_depths(call, map, format);
            } else if has_integers(format) {
                self.compare_integers(call, map);
            } else {
                self.compare_colors(call, map);
            }
        }
    }

    fn compare_depths(&mut self, call: &Call, map: Map, format: Format) {
        let maps = both(map, self.gl.read_depths(map), self.emulator.depths(map));
        let Some((gl, emulated)) = maps else {
            return;
        };
        let stencils = self.gl.read_stencils(map).unwrap();
        let emulated_stencils = self.emulator.stencils(map).unwrap();
        for &pixel in &self.pixels {
            let depth = raw(format, gl[pixel]);
            let held = (gl[pixel], stencils[pixel]);
            let is_held = |contents: &Contents| matches!(contents, Contents::Depths(all) if all[pixel].0.to_bits() == held.0.to_bits() && all[pixel].1 == held.1);
            if emulated[pixel] == 0.0
                && emulated_stencils[pixel] == 0
                && self.is_unwritten(map, is_held)
            {
                self.compared += 1;
                continue;
            }
            assert!(
                depth == emulated[pixel] && stencils[pixel] == emulated_stencils[pixel],
                "{map} after {call} at pixel {pixel}: OpenGL has depth {depth:?} and stencil {}, the emulated pixel \
                 {:?} and {}",
                stencils[pixel],
                emulated[pixel],
                emulated_stencils[pixel]
            );
            self.compared += 1;
        }
    }

    fn compare_colors(&mut self, call: &Call, map: Map) {
        let maps = both(map, self.gl.read_colors(map), self.emulator.colors(map));
        let Some((gl, emulated)) = maps else {
            return;
        };
        for &pixel in &self.pixels {
            let is_held = |contents: &Contents| matches!(contents, Contents::Colors(all) if all[pixel].map(f32::to_bits) == gl[pixel].map(f32::to_bits));
            // Alpha reads 1 where the format has none.
            if emulated[pixel][..3] == [0.0; 3] && self.is_unwritten(map, is_held) {
                self.compared += 1;
                continue;
            }
            let off = gl[pixel]
                .iter()
                .zip(emulated[pixel])
                .map(|(a, b)| (a - b).abs() / b.abs().max(1.0));
            // Of these an order in which what is not a number is the largest.
            let off = off.max_by(f32::total_cmp).unwrap();
            assert!(
                off <= self.color_bound,
                "{map} after {call} at pixel {pixel}: OpenGL has {:?}, the emulated pixel {:?}",
                gl[pixel],
                emulated[pixel]
            );
            self.compared += 1;
        }
    }

    fn compare_integers(&mut self, call: &Call, map: Map) {
        let maps = both(map, self.gl.read_integers(map), self.emulator.integers(map));
        let Some((gl, emulated)) = maps else {
            return;
        };
        for &pixel in &self.pixels {
            let is_held = |contents: &Contents| matches!(contents, Contents::Integers(all) if all[pixel] == gl[pixel]);
            let is_new = emulated[pixel][..3] == [0; 3];
            assert!(
                gl[pixel] == emulated[pixel] || is_new && self.is_unwritten(map, is_held),
                "{map} after {call} at pixel {pixel}: OpenGL has {:?}, the emulated pixel {:?}",
                gl[pixel],
                emulated[pixel]
            );
            self.compared += 1;
        }
    }
}

fn has_integers(format: Format) -> bool {
    matches!(format, Format::R32Ui | Format::Rgba32Ui)
}

/// What OpenGL's map holds, or `None` before it is made.
fn contents(gl: &GlMachine<'_>, Watched { map, format }: Watched) -> Option<Contents> {
    if has_integers(format) {
        return gl.read_integers(map).ok().map(Contents::Integers);
    }
    if !format.has_depth() {
        return gl.read_colors(map).ok().map(Contents::Colors);
    }
    let depths = gl.read_depths(map).ok()?;
    let stencils = gl.read_stencils(map).ok()?;
    Some(Contents::Depths(depths.into_iter().zip(stencils).collect()))
}

/// What both machines hold of a map; `None` before it is made. That one has it and the other does not is an error of either.
fn both<A, B>(map: Map, gl: Result<A>, emulated: Result<B>) -> Option<(A, B)> {
    match (gl, emulated) {
        (Ok(gl), Ok(emulated)) => Some((gl, emulated)),
        (Err(_), Err(_)) => None,
        (gl, _) => panic!(
            "only {} has the map {map}",
            if gl.is_ok() {
                "OpenGL"
            } else {
                "the emulated pixel"
            }
        ),
    }
}

/// A depth as the emulated pixel stores it. GL reads a fixed-point depth back as a quotient, of which the integer is the
/// nearest.
fn raw(format: Format, depth: f32) -> f32 {
    let scale = match format {
        Format::Depth24Stencil8 => 16_777_215.0,
        Format::Depth16 => 65_535.0,
        _ => return depth,
    };
    (f64::from(depth) * scale).round() as f32
}

/// Every surface of every pixel of the scene that the machine has, bottom row first: the transparent fragments as OpenGL
/// makes them, whatever lies before them, and the opaque surface that OpenGL keeps.
///
/// The machine must have the maps of [`stage::OPAQUE_FIRST`] and GL's initial state; its state is left anywhere.
pub fn surfaces(gl: &mut GlMachine<'_>, scene: &Scene, image: Map) -> Vec<Vec<Surface>> {
    const NOTHING: Map = Map::named("nothing");
    run(&stage::OPAQUE_FIRST, &[], Variables::new(), gl).unwrap();
    let opaque_depths = gl.read_depths(stage::OPAQUE_DEPTH).unwrap();
    let opaque_colors = gl.read_colors(image).unwrap();
    gl.allocate(NOTHING, Format::Depth32FStencil8).unwrap();
    let target = Target("nothing");
    gl.framebuffer_with(target, &[], Some(NOTHING)).unwrap();
    gl.perform(&Call::BindFramebuffer {
        framebuffer: target,
    })
    .unwrap();
    gl.perform(&Call::Clear {
        mask: DEPTH_BUFFER_BIT,
    })
    .unwrap();
    let mut captured = capture(gl, NOTHING, 1 << 22).unwrap();
    captured.sort_by_key(|fragment| fragment.order);
    let [width, height] = gl.size();
    let mut pixels = vec![Vec::new(); (width * height) as usize];
    for fragment in captured {
        pixels[(fragment.y * width + fragment.x) as usize].push(Surface {
            fragment: Fragment {
                depth: fragment.depth,
                color: fragment.color,
                order: fragment.order,
            },
            group: group_of(scene, fragment.order),
        });
    }
    if scene.meshes.iter().any(|mesh| mesh.opaque) {
        for (pixel, (depth, color)) in pixels
            .iter_mut()
            .zip(opaque_depths.iter().zip(opaque_colors))
        {
            if *depth < 1.0 {
                pixel.push(Surface {
                    fragment: Fragment {
                        depth: *depth,
                        color: color.into(),
                        order: u32::MAX,
                    },
                    group: Group::Opaque,
                });
            }
        }
    }
    pixels
}

/// Among what the triangle with this place in the order of submission is drawn.
fn group_of(scene: &Scene, order: u32) -> Group {
    let mut end = 0;
    for mesh in &scene.meshes {
        end += mesh.triangles.len() as u32;
        if order < end {
            return match (mesh.opaque, mesh.sorted) {
                (true, _) => Group::Opaque,
                (false, true) => Group::Sorted,
                (false, false) => Group::Unsorted,
            };
        }
    }
    panic!("no mesh has triangle {order}")
}
