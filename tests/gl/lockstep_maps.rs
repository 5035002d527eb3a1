//! The emulated pixel and OpenGL draw into several color maps alike: dual depth peeling, on random stacks, in every format
//! of depths.

use onionskin::low_level::papers::bavoil_2008::{
    COUNT_FRAGMENTS_LEFT, DEPTHS, DUAL_DEPTH_PEELING, FRAGMENTS_LEFT, PEELS, RESOURCES,
};
use onionskin::low_level::steps::{
    BlendEquation, BlendFactor, Call, Machine, Objects, Reason, Shader, Variables, gl::*, run,
};
use onionskin::{Context, Format};

use crate::kit::both::{Both, blending_bound, parting};
use crate::kit::changed::Change;
use crate::kit::lockstep::LockStep;
use crate::lockstep::{color_bound, random_stack};

/// Peels all layers, or so many times two of them.
fn dual_peeling(peels: f64) -> impl Fn(&mut LockStep<'_, '_>) {
    move |both| {
        let variables = Variables::new()
            .with("num_passes", peels)
            .with("occlusion_ratio", 0.0)
            .with("window_area", 1.0);
        let outcome = run(&DUAL_DEPTH_PEELING, &[], variables, both).unwrap();
        if peels.is_infinite() {
            assert_eq!(outcome.stopped, Some(Reason::EmptyLayer));
            return;
        }
        run(&COUNT_FRAGMENTS_LEFT, &[], outcome.variables, both).unwrap();
        assert!(both.samples(FRAGMENTS_LEFT).unwrap() > 1000);
    }
}

fn both() -> Both {
    Both::with(&[&RESOURCES])
}

#[test]
fn ten_thousand_sequences_by_dual_depth_peeling() {
    let context = Context::headless().unwrap();
    for (seed, peels) in [(1, f64::INFINITY), (2, 2.0)] {
        let scene = random_stack(seed).scene();
        let compared = both().drive(&context, &scene, dual_peeling(peels));
        println!("{compared} comparisons");
        assert!(compared > 1_000_000, "{compared}");
    }
}

#[test]
fn ten_thousand_sequences_by_dual_depth_peeling_with_other_formats() {
    let context = Context::headless().unwrap();
    let scene = random_stack(3).scene();
    for color in [Format::Rgba16F, Format::Rgba8] {
        let both = Both {
            formats: [color, Format::Depth32FStencil8],
            color_bound: color_bound(color),
            ..both()
        };
        both.drive(&context, &scene, dual_peeling(f64::INFINITY));
    }
}

#[test]
fn a_changed_word_of_dual_depth_peeling_is_noticed() {
    let context = Context::headless().unwrap();
    let scene = random_stack(4).scene();
    const CHANGES: [(Change, &str); 3] = [
        (
            ["dual/peel.frag", "z == bounds.y", "z >= bounds.x"],
            "depths",
        ),
        (["dual/peel.frag", "&& !at_nearest", ""], "farthest"),
        (
            [
                "dual/left.frag",
                "bounds.x > bounds.y",
                "bounds.x >= bounds.y",
            ],
            "samples",
        ),
    ];
    for (change, said) in CHANGES {
        let changed = both().changed(change);
        let what = parting(|| {
            changed.drive(&context, &scene, dual_peeling(f64::INFINITY));
        });
        assert!(what.contains(said), "{change:?}: {what}");
    }
}

/// Between two peels, everything left is drawn into three color maps: every equation for one, and every pair of factors for
/// the others, under masks that differ.
/// Sums of ten colours and more stay below 16.
#[test]
fn equations_factors_and_masks_agree_map_by_map() {
    use BlendEquation::{FuncAdd, Max, Min};
    const FACTORS: [BlendFactor; 6] = {
        use BlendFactor::*;
        [
            Zero,
            One,
            SrcAlpha,
            OneMinusSrcAlpha,
            DstAlpha,
            OneMinusDstAlpha,
        ]
    };
    let pairs: Vec<_> = FACTORS
        .iter()
        .flat_map(|&src| FACTORS.map(|dst| (src, dst)))
        .collect();
    let context = Context::headless().unwrap();
    let scene = random_stack(5).scene();
    let both = Both {
        color_bound: 16.0 * blending_bound(),
        ..both()
    };
    let compared = both.drive(&context, &scene, |both| {
        dual_peeling(1.0)(both);
        let mut perform =
            |calls: &[Call]| calls.iter().for_each(|call| both.perform(call).unwrap());
        perform(&[
            glBindFramebuffer(PEELS),
            glFramebufferColor(DEPTHS[0]),
            glDisable(DEPTH_TEST),
            glDepthMask(false),
            glEnable(BLEND),
            glActiveTexture(2),
            glBindTexture(DEPTHS[1]),
            glUseProgram(Shader("dual/peel")),
        ]);
        for (number, equation) in [FuncAdd, Min, Max].into_iter().enumerate() {
            for &(src, dst) in &pairs {
                let is_odd = number % 2 == 1;
                perform(&[
                    glClearBufferfv(0, [-0.25, 0.5, 0.125, 0.5]),
                    glClearBufferfv(1, [0.75, 0.25, 0.5, 0.25]),
                    glClearBufferfv(2, [0.5, 0.5, 0.125, 0.75]),
                    glColorMaski(1, is_odd, true, !is_odd, true),
                    glColorMaski(2, true, !is_odd, true, is_odd),
                    // The shader has no alpha for this map.
                    glBlendFunci(0, ONE, ONE),
                    glBlendFunci(1, dst, src),
                    glBlendFunci(2, src, dst),
                    glBlendEquationi(0, equation),
                    glBlendEquationi(1, FuncAdd),
                    glBlendEquationi(2, equation),
                    Call::Draw {
                        objects: Objects::Transparent,
                    },
                    glColorMask(true, true, true, true),
                ]);
            }
        }
    });
    assert!(compared > 1_000_000, "{compared}");
}
