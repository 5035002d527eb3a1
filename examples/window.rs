//! A turning scene in a window: onionskin in a context that glutin has made.
//!
//! Without a display it says so and ends. With a number as its second argument, it shows that many frames and ends.
//!
//! `cargo run --release --example window [SCENE.toml] [FRAMES]`

#![allow(unsafe_code)] // making a window's context current is

use std::ffi::CString;
use std::num::NonZeroU32;
use std::sync::Arc;

use glam::DQuat;
use glutin::config::ConfigTemplateBuilder;
use glutin::context::{ContextApi, ContextAttributesBuilder, PossiblyCurrentContext, Version};
use glutin::display::GetGlDisplay;
use glutin::prelude::*;
use glutin::surface::{Surface, WindowSurface};
use glutin_winit::{DisplayBuilder, GlWindow};
use onionskin::{Context, Method, Renderer, Scene};
use winit::application::ApplicationHandler;
use winit::event::WindowEvent;
use winit::event_loop::{ActiveEventLoop, EventLoop};
use winit::raw_window_handle::HasWindowHandle;
use winit::window::{Window, WindowAttributes, WindowId};

#[path = "common/example.rs"]
mod example;

type Failure = Box<dyn std::error::Error>;

fn main() -> Result<(), Failure> {
    let scene = std::env::args()
        .nth(1)
        .filter(|argument| argument.ends_with(".toml"));
    let scene = Scene::load_at(
        scene.map_or_else(|| example::scene("knots.toml"), Into::into),
        Some([512, 384]),
    )?;
    let frames = std::env::args()
        .nth(2)
        .and_then(|number| number.parse().ok());
    let Ok(event_loop) = EventLoop::new() else {
        println!("skipped: there is no display to open a window on");
        return Ok(());
    };
    let mut viewer = Viewer {
        scene,
        frames,
        shown: None,
        done: 0,
        failure: None,
    };
    event_loop.run_app(&mut viewer)?;
    viewer.failure.map_or(Ok(()), Err)
}

/// The scene and, once there is one, its window.
struct Viewer {
    scene: Scene,
    frames: Option<u32>,
    shown: Option<Shown>,
    done: u32,
    failure: Option<Failure>,
}

/// A window with its context.
struct Shown {
    context: Context,
    surface: Surface<WindowSurface>,
    current: PossiblyCurrentContext,
    window: Window,
}

impl ApplicationHandler for Viewer {
    fn resumed(&mut self, event_loop: &ActiveEventLoop) {
        match open(event_loop, self.scene.size) {
            Ok(shown) => {
                shown.window.request_redraw();
                self.shown = Some(shown);
            }
            Err(failure) => self.end(event_loop, failure),
        }
    }

    fn window_event(&mut self, event_loop: &ActiveEventLoop, _: WindowId, event: WindowEvent) {
        match event {
            WindowEvent::CloseRequested => event_loop.exit(),
            WindowEvent::RedrawRequested => {
                if let Err(failure) = self.draw() {
                    self.end(event_loop, failure);
                }
                if self.frames.is_some_and(|frames| self.done >= frames) {
                    println!("{} frames shown", self.done);
                    event_loop.exit();
                }
            }
            _ => {}
        }
    }
}

impl Viewer {
    fn draw(&mut self) -> Result<(), Failure> {
        let Some(shown) = &self.shown else {
            return Ok(());
        };
        let camera = &mut self.scene.camera;
        let turn = DQuat::from_axis_angle(camera.up.normalize(), 1_f64.to_radians());
        camera.eye = camera.target + turn * (camera.eye - camera.target);
        let [width, height] = self.scene.size;
        let mut renderer = Renderer::new(&shown.context, width, height)?;
        let frame = renderer.render(&self.scene, &Method::DepthPeeling(Default::default()))?;
        renderer.present()?;
        shown.surface.swap_buffers(&shown.current)?;
        let layers = frame.stats.layers.unwrap_or(0);
        shown.window.set_title(&format!(
            "{}: {layers} layers, {:.0} ms",
            self.scene.name, frame.stats.ms
        ));
        shown.window.request_redraw();
        self.done += 1;
        Ok(())
    }

    fn end(&mut self, event_loop: &ActiveEventLoop, failure: Failure) {
        self.failure = Some(failure);
        event_loop.exit();
    }
}

/// A window of this size, and a current OpenGL 4.3 core context for it.
fn open(event_loop: &ActiveEventLoop, [width, height]: [u32; 2]) -> Result<Shown, Failure> {
    let attributes = WindowAttributes::default()
        .with_inner_size(winit::dpi::PhysicalSize::new(width, height))
        .with_resizable(false);
    let (window, config) = DisplayBuilder::new()
        .with_window_attributes(Some(attributes))
        .build(event_loop, ConfigTemplateBuilder::new(), |mut configs| {
            configs.next().expect("a display has a configuration")
        })?;
    let window = window.ok_or("the display made no window")?;
    let display = config.display();
    let api = ContextApi::OpenGl(Some(Version::new(4, 3)));
    let attributes = ContextAttributesBuilder::new()
        .with_context_api(api)
        .build(Some(window.window_handle()?.as_raw()));
    // SAFETY: the window lives as long as the context: both are kept in `Shown`.
    let context = unsafe { display.create_context(&config, &attributes) }?;
    let surface = window.build_surface_attributes(Default::default())?;
    // SAFETY: as above.
    let surface = unsafe { display.create_window_surface(&config, &surface) }?;
    let current = context.make_current(&surface)?;
    let _ = surface.set_swap_interval(
        &current,
        glutin::surface::SwapInterval::Wait(NonZeroU32::MIN),
    );
    let function = |name: &str| {
        CString::new(name).map_or(std::ptr::null(), |name| display.get_proc_address(&name))
    };
    // SAFETY: the context has just been made current on this thread.
    let gl = unsafe { glow::Context::from_loader_function(function) };
    // SAFETY: the context is current, stays so, and is kept in `Shown` behind what is made with it.
    let context = unsafe { Context::from_glow(Arc::new(gl)) }?;
    Ok(Shown {
        context,
        surface,
        current,
        window,
    })
}
