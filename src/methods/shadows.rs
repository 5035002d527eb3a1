//! Shadows from a light's own view (Everitt 2001, "Shadow Mapping" and figure 2): the comparison by which layers are peeled,
//! with a map that a light has made.

use crate::error::Result;
use crate::gl::{Context, Format, Geometry, GlMachine};
use crate::image::Image;
use crate::papers::stage;
use crate::scene::{Camera, Scene};
use crate::steps::{Call, Capability, ClassicCall, Machine, Map, Objects, Shader, Target, gl::*};

const SHADOW_MAP: Map = Map::named("shadow map");
const IMAGE: Map = Map::named("shadowed");
const DEPTH: Map = Map::named("shadowed depth");
const FROM_THE_LIGHT: Target = Target("from the light");
const FROM_THE_EYE: Target = Target("from the eye");

/// A scene with shadows, and the map that they come from.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Shadowed {
    /// The scene from its camera: what lies in shadow is black.
    pub image: Image,
    /// The scene's depths from the light, 0 to 1, row by row from the top. The map has the image's size.
    pub map: Vec<f32>,
}

/// Draws an opaque scene with the shadows of a light. `bias` is taken from the compared depth, because a texel's depth is
/// not that of every fragment that falls into it.
///
/// # Errors
/// If the driver fails.
pub fn shadowed(context: &Context, scene: &Scene, light: Camera, bias: f32) -> Result<Shadowed> {
    let size = scene.size;
    let mut machine = GlMachine::new(context, size)?;
    machine.allocate(SHADOW_MAP, Format::Depth32F)?;
    machine.allocate(DEPTH, Format::Depth32F)?;
    machine.allocate(IMAGE, Format::Rgba32F)?;
    machine.framebuffer(FROM_THE_LIGHT, None, Some(SHADOW_MAP))?;
    machine.framebuffer(FROM_THE_EYE, Some(IMAGE), Some(DEPTH))?;
    let lit = Scene {
        camera: light,
        ..scene.clone()
    };
    // "In the first pass, the scene is rendered from the light's point of view."
    machine.set_geometry(Geometry::upload(context, &lit, size)?);
    machine.begin_frame();
    draw(&mut machine, FROM_THE_LIGHT, stage::SURFACE)?;
    let map = machine.read_depths(SHADOW_MAP)?;
    // "In the second pass, the shadow map is projected onto the scene."
    machine.look(scene);
    for call in projected_from(light, size, bias) {
        machine.perform(&call)?;
    }
    draw(&mut machine, FROM_THE_EYE, Shader("classic/fixed"))?;
    let rows = map.chunks_exact(size[0] as usize).rev();
    Ok(Shadowed {
        image: Image::from_bottom_up(size[0], size[1], &machine.read_colors(IMAGE)?),
        map: rows.flatten().copied().collect(),
    })
}

fn draw(machine: &mut GlMachine, framebuffer: Target, program: Shader) -> Result<()> {
    let calls = [
        Call::BindFramebuffer { framebuffer },
        Call::Clear {
            mask: COLOR_AND_DEPTH_BUFFER_BITS,
        },
        Call::Enable {
            cap: Capability::DepthTest,
        },
        Call::UseProgram { program },
        Call::Draw {
            objects: Objects::Scene,
        },
    ];
    calls.iter().try_for_each(|call| machine.perform(call))
}

/// r <= lookup(s, t): a fragment that is not behind the light's nearest surface keeps its colour. With the camera's view as
/// modelview matrix, the planes of the texture coordinates give places in the world.
fn projected_from(light: Camera, [width, height]: [u32; 2], bias: f32) -> Vec<Call> {
    let to_light = light.projection(width, height) * light.view();
    let rows = to_light
        .transpose()
        .to_cols_array_2d()
        .map(|row| row.map(|x| x as f32));
    let set_m = Call::Classic(ClassicCall::SetM { rows });
    vec![
        glActiveTextureARB(GL_TEXTURE3_ARB),
        bind_texture_2d(SHADOW_MAP),
        enable_classic(GL_TEXTURE_2D),
        compare_r_to_texture(true),
        texture_compare_func(LEQUAL),
        depth_texture_mode(GL_LUMINANCE),
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE),
        eye_linear_texgen(),
        texgen(true),
        glMatrixMode(GL_TEXTURE),
        glLoadIdentity(),
        glTranslatef(0.5, 0.5, 0.5 - bias),
        glScalef(0.5, 0.5, 0.5),
        set_m,
        glMultMatrix_m(),
        glMatrixMode(GL_MODELVIEW),
    ]
}
