//! Shaders of a user's own: by name, with includes and declarations, and errors that name the line.

use onionskin::low_level::gl::{GlMachine, shader_file};
use onionskin::low_level::methods::{
    Algorithm, DepthPeelingOptions, Drawn, Entry, Setup, Technique, Ties,
};
use onionskin::low_level::papers::stage;
use onionskin::low_level::scene::generate::{Quads, quads};
use onionskin::low_level::steps::{Amendment, Dialect, Listing, Shader, Variables, gl::*, run};
use onionskin::{Context, Error, Image, Method, Renderer, Result, Scene, steps};

use crate::kit::changed::changed;

/// A method that draws the surfaces with one shader of its own, and then the screen with another.
#[derive(Clone, Copy, Debug)]
struct Mine {
    surface: &'static str,
    screen: &'static str,
}

const SURFACE: &str = "#version 430 core
// defines: method
vec4 surface_color();
#include \"mine/part.glsl\"
layout(location = 0) out vec4 color;
void main() {
    color = vec4(part(surface_color().a), float(LEVEL) / 8.0, gl_FragCoord.z, 1.0);
}
";
const PART: &str = "float part(float alpha) {\n    return alpha / 2.0;\n}\n";
/// It doubles what is there, by blending.
const SCREEN: &str = "#version 430 core
// vertex: mine/screen.vert
layout(location = 0) out vec4 color;
void main() {
    color = vec4(0.0, 0.0, 0.25, 0.0);
}
";

const DRAW: Listing = Listing {
    title: "A surface, and the screen",
    source: "a test",
    dialect: Dialect::Calls,
    steps: steps! {
        run stage::OPAQUE_FIRST;
        glUseProgram(Shader("mine/surface"));
        drawTransparentObjects();
        glDisable(DEPTH_TEST);
        glEnable(BLEND);
        glBlendFuncSeparate(ONE, ONE, ONE, ONE);
        glUseProgram(Shader("mine/screen"));
        drawScreen();
        glDisable(BLEND);
    },
};

impl Technique for Mine {
    fn entry(&self) -> &'static Entry {
        const ENTRY: Entry = {
            let mut entry = Entry::new("mine", "a test");
            entry.ties = Ties::OverEarlier;
            entry
        };
        &ENTRY
    }

    fn algorithm(&self, _: &Setup) -> Box<dyn Algorithm> {
        Box::new(*self)
    }
}

impl Algorithm for Mine {
    fn prepare(&mut self, machine: &mut GlMachine<'_>, _: &Scene) -> Result<()> {
        machine.set_defines(&[("LEVEL", 3)]);
        machine.set_shader_file("mine/surface.frag", self.surface)?;
        machine.set_shader_file("mine/part.glsl", PART)?;
        machine.set_shader_file("mine/screen.vert", shader_file("screen.vert").unwrap())?;
        machine.set_shader_file("mine/screen.frag", self.screen)
    }

    fn draw(&mut self, machine: &mut GlMachine<'_>, _: &Scene) -> Result<Drawn> {
        run(&DRAW, &[], Variables::new(), machine)?;
        Ok(Drawn::default())
    }
}

const MINE: Mine = Mine {
    surface: SURFACE,
    screen: SCREEN,
};

/// A quad that fills the view, with an opacity of a half.
fn scene() -> Scene {
    let quad = quads(&Quads {
        count: 1,
        alpha: 0.5,
        ..Quads::default()
    });
    Scene::of("a quad", vec![quad.unwrap()])
}

fn render(renderer: &mut Renderer<'_>, mine: Mine) -> Result<Image> {
    Ok(renderer.render(&scene(), &mine)?.image)
}

fn middle(image: &Image) -> [f32; 3] {
    let pixel = image.pixels[image.pixels.len() / 2 + 4];
    [pixel.r, pixel.g, pixel.b]
}

#[test]
fn own_surfaces_and_own_screens_draw_with_includes_and_declarations() {
    let context = Context::headless().unwrap();
    let mut renderer = Renderer::new(&context, 8, 8).unwrap();
    let [red, green, blue] = middle(&render(&mut renderer, MINE).unwrap());
    // All of them are exact in f32; the depth is between 0 and 1, and the screen adds to it.
    assert_eq!([red, green], [0.25, 0.375]);
    assert!(blue > 0.25 && blue < 1.25, "{blue}");
}

#[test]
fn another_text_under_the_same_name_is_drawn_from_the_next_frame_on() {
    let context = Context::headless().unwrap();
    let mut renderer = Renderer::new(&context, 8, 8).unwrap();
    let first = render(&mut renderer, MINE).unwrap();
    const LESS: &str = "#version 430 core
// vertex: screen.vert
out vec4 color;
void main() {
    color = vec4(0.0, 0.125, 0.0, 0.0);
}
";
    let other = Mine {
        screen: LESS,
        ..MINE
    };
    let second = render(&mut renderer, other).unwrap();
    let [first, second] = [first, second].map(|image| middle(&image));
    assert_eq!(second[1], first[1] + 0.125);
    assert_eq!(second[2], first[2] - 0.25);
}

#[test]
fn an_error_names_the_file_and_the_line() {
    let context = Context::headless().unwrap();
    let refused = |mine: Mine| {
        let mut renderer = Renderer::new(&context, 8, 8).unwrap();
        let error = render(&mut renderer, mine).unwrap_err();
        assert!(matches!(error, Error::Shader { .. }), "{error:?}");
        error.to_string()
    };
    // The fifth line, and the defines come before it.
    let error = refused(Mine {
        surface: "#version 430 core\n// defines: method\n\nvoid main() {\n    oops();\n}\n",
        ..MINE
    });
    assert!(error.starts_with("mine/surface.frag does not"), "{error}");
    let line = error.lines().find(|line| line.contains("oops"));
    let line = line.unwrap_or_else(|| panic!("{error}"));
    assert!(
        line.starts_with("mine/surface.frag:5(") || line.starts_with("mine/surface.frag(5)"),
        "{error}"
    );
    let error = refused(Mine {
        surface: "#version 430 core\n\n#include \"mine/pat.glsl\"\n",
        ..MINE
    });
    assert!(
        error.contains("mine/surface.frag:3: there is no"),
        "{error}"
    );
    assert!(error.contains("Did you mean 'mine/part.glsl'?"), "{error}");
    let error = refused(Mine {
        screen: "#version 430 core\n// vertex: sreen.vert\nvoid main() {}\n",
        ..MINE
    });
    assert!(error.contains("Did you mean"), "{error}");
}

#[test]
fn a_name_that_no_shader_has_is_refused_with_what_was_meant() {
    const MISSPELT: Listing = Listing {
        title: "A misspelt shader",
        source: "a test",
        dialect: Dialect::Calls,
        steps: steps! {
            glUseProgram(Shader("mine/surfaec"));
        },
    };
    let context = Context::headless().unwrap();
    let mut machine = GlMachine::new(&context, [8, 8]).unwrap();
    machine
        .set_shader_file("mine/surface.frag", SURFACE)
        .unwrap();
    let error = run(&MISSPELT, &[], Variables::new(), &mut machine).unwrap_err();
    assert!(matches!(error, Error::UnknownShader { .. }), "{error:?}");
    let error = error.to_string();
    assert!(error.contains("Did you mean 'mine/surface'?"), "{error}");
}

/// An amendment of a published method may name a shader of one's own.
#[test]
fn a_published_listing_runs_with_an_own_shader() {
    const MY_PEEL: &[Amendment] = &[changed(
        steps! { glUseProgram(stage::PEEL_SURFACE); },
        steps! { glUseProgram(Shader("mine/peel")); },
    )];
    let context = Context::headless().unwrap();
    let image = |text: &str| {
        let renderer = Renderer::new(&context, 8, 8).unwrap();
        let mut renderer = renderer.with_shader_file("mine/peel.frag", text).unwrap();
        let method = Method::DepthPeeling(DepthPeelingOptions {
            amendments: MY_PEEL,
            ..Default::default()
        });
        renderer.render(&scene(), &method).unwrap().image
    };
    let peel = shader_file("peel.frag").unwrap();
    let as_it_is = Renderer::new(&context, 8, 8)
        .unwrap()
        .render(&scene(), &Method::DepthPeeling(Default::default()))
        .unwrap()
        .image;
    assert_eq!(image(peel), as_it_is);
    let darker = peel.replace("surface_color();\n}", "surface_color() * 0.5;\n}");
    assert_ne!(darker, peel);
    assert_ne!(image(&darker), as_it_is);
}
