//! Algorithm 2 and its shaders on the emulated pixel and on OpenGL: depths and flags bit for bit, by a framebuffer that is
//! fetched and by images.

use onionskin::Context;
use onionskin::low_level::papers::carr_2008::ideal::{
    AMENDMENTS, BY_IMAGES, IDEAL, NO_COLOR_RESOURCES, RESOURCES, TIGHT_BOUND_ON_GL,
};
use onionskin::low_level::steps::{Amendment, Reason, Variables, run};

use crate::kit::both::{Both, parting};
use crate::kit::changed::Change;
use crate::kit::lockstep::LockStep;
use crate::lockstep::random_stack;
use crate::lockstep_bounded::has_order;

fn both(by_images: bool) -> Both {
    let resources: &[_] = match by_images {
        true => &[&RESOURCES, &NO_COLOR_RESOURCES],
        false => &[&RESOURCES],
    };
    Both::with(resources).defining(&[("IMAGES", u32::from(by_images))])
}

fn peeling(amendments: &[Amendment], by_images: bool) -> impl Fn(&mut LockStep<'_, '_>) {
    let mut all = amendments.to_vec();
    if by_images {
        all.extend(BY_IMAGES);
    }
    move |both| {
        let variables = Variables::new().with("iteration_limit", 12.0);
        let outcome = run(&IDEAL, &all, variables, both).unwrap();
        assert_eq!(outcome.stopped, Some(Reason::EmptyLayer));
    }
}

#[test]
fn ten_thousand_sequences_by_algorithm_2() {
    let context = Context::headless().unwrap();
    for by_images in [false, true] {
        if !has_order(&context, by_images) {
            continue;
        }
        for (seed, amendments) in [(1, &AMENDMENTS[..]), (2, &TIGHT_BOUND_ON_GL), (3, &[])] {
            let scene = random_stack(seed).scene();
            let compared = both(by_images).drive(&context, &scene, peeling(amendments, by_images));
            println!("{compared} comparisons");
            assert!(compared > 1_000_000, "{compared}");
        }
    }
}

#[test]
fn a_changed_word_of_algorithm_2_is_noticed() {
    const CHANGES: [(Change, &str); 3] = [
        (
            [
                "common/ideal_pass_1.glsl",
                "depths.z = min(depths.z, z);",
                "depths.z = z;",
            ],
            "z1 z2 z3",
        ),
        (
            ["ideal/pass_2.frag", "z < depths.z", "z <= depths.z"],
            "accumulated",
        ),
        (
            [
                "ideal/begin.frag",
                "peel = vec4(depths.z)",
                "peel = vec4(depths.y)",
            ],
            "zPeel",
        ),
    ];
    let context = Context::headless().unwrap();
    if !has_order(&context, false) {
        return;
    }
    let scene = random_stack(4).scene();
    for (change, said) in CHANGES {
        let what = parting(|| {
            let changed = both(false).changed(change);
            changed.drive(&context, &scene, peeling(&AMENDMENTS, false));
        });
        assert!(what.starts_with(said), "{change:?}: {what}");
    }
}
