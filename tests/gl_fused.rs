//! Fused rendering: volumes and surfaces in one list, by A-buffers on GL, against closed forms and against the f64 caster.

use onionskin::methods::{ABufferOptions, Frame, Manager, RecordColor};
use onionskin::{Context, Method, Renderer, Scene};

#[path = "common/fog_scenes.rs"]
#[allow(dead_code)]
mod fog_scenes;
use fog_scenes::{fog_and_pane, off};

/// The issue's. Where a proxy's or a pane's fragment lies is a depth of f32; see the bound of `gl_volumes.rs`.
const BOUND: f64 = 1e-4;

/// Colours in f32, so that what is compared is the rays.
const DFB: ABufferOptions = ABufferOptions {
    manager: Manager::Dfb,
    color: RecordColor::Float,
    ..ABufferOptions::DEFAULT
};

fn render(context: &Context, scene: &Scene, options: ABufferOptions) -> Frame {
    let [width, height] = scene.size;
    let mut renderer = Renderer::new(context, width, height).unwrap();
    renderer.render(scene, &Method::ABuffer(options)).unwrap()
}

#[test]
fn l16_fog_and_a_pane_follow_the_closed_form() {
    let context = Context::headless().unwrap();
    let mut worst = 0.0_f64;
    for eye in [5.0, 0.75] {
        // In front, inside (seen from both eyes), behind, at a face.
        for pane in [2.0, 0.3, -0.4, -2.0, -1.0] {
            if f64::from(pane) > eye - 0.5 {
                continue;
            }
            for alpha in [0.4, 1.0] {
                for step in [0.05, 0.3, 0.5, 7.0] {
                    let scene = fog_and_pane(eye, pane, alpha, step);
                    let frame = render(&context, &scene, DFB);
                    let off = off(&scene, &frame.image, f64::from(0.7_f32));
                    let what = format!("eye {eye} pane {pane} alpha {alpha} step {step}");
                    assert!(off < BOUND, "{what}: {off}");
                    assert_eq!(frame.stats.lost, Some(0), "{what}");
                    worst = worst.max(off);
                }
            }
        }
    }
    println!("at most {worst:e} off");
}
