//! Surfaces in other orders than that of submission, and only some of them, on the emulated pixel and on OpenGL: the painter's
//! algorithm, the verified painter's proof with its marks, and coherent layer peeling batch by batch.

use onionskin::low_level::gl::Numbers;
use onionskin::low_level::methods::begin_batch;
use onionskin::low_level::papers::carr_2008::coherent::{
    AMENDMENTS, LOOP_A, RESOURCES_A, UP_TO_THE_BATCH_END,
};
use onionskin::low_level::papers::edition::{
    BLEND_AND_PROVE, FAILED, MARKS, NOTHING_OPAQUE, PROOF_DEPTH, RESOURCES, VERIFIED_PAINTER,
};
use onionskin::low_level::papers::stage;
use onionskin::low_level::steps::{Dialect, Listing, Machine, Reason, Variables, gl::*, run};
use onionskin::{Camera, Context, Scene, steps};

use crate::kit::both::{Both, parting};
use crate::kit::chance::Chance;
use crate::kit::changed::Change;
use crate::kit::lockstep::LockStep;
use crate::kit::stack::Stack;
use crate::lockstep::random_stack;

/// Every triangle by mesh and number, the opaque ones first and the others shuffled.
pub(crate) fn shuffled(scene: &Scene, seed: u64) -> Vec<[u32; 2]> {
    let triangles = scene.meshes.iter().zip(0..).flat_map(|(mesh, number)| {
        (0..mesh.triangles.len() as u32).map(move |triangle| (mesh.opaque, [number, triangle]))
    });
    let (opaque, others): (Vec<_>, Vec<_>) = triangles.partition(|(opaque, _)| *opaque);
    let places = Chance::new(seed).shuffled(others.len());
    let others = places.into_iter().map(|place| others[place]);
    opaque
        .iter()
        .copied()
        .chain(others)
        .map(|(_, triangle)| triangle)
        .collect()
}

/// The same by their places in the order of submission.
pub(crate) fn places(scene: &Scene, order: &[[u32; 2]]) -> Vec<u32> {
    let mut first = 0;
    let firsts = scene.meshes.iter().map(|mesh| {
        first += mesh.triangles.len() as u32;
        first - mesh.triangles.len() as u32
    });
    let firsts: Vec<_> = firsts.collect();
    let place = |&[mesh, triangle]: &[u32; 2]| firsts[mesh as usize] + triangle;
    order.iter().map(place).collect()
}

/// The painter's algorithm, whatever the order.
const PAINTER: Listing = Listing {
    title: "Each over those before it",
    source: "Everitt 2001, Introduction",
    dialect: Dialect::Calls,
    steps: steps! {
        run stage::OPAQUE_FIRST;
        glDepthMask(false);
        glEnable(BLEND);
        glBlendFuncSeparate(SRC_ALPHA, ONE_MINUS_SRC_ALPHA, ONE, ONE_MINUS_SRC_ALPHA);
        drawTransparentObjects();
        glDisable(BLEND);
        glDepthMask(true);
    },
};

fn painter(orders: Vec<Vec<[u32; 2]>>) -> Both {
    Both {
        color_bound: 0.0,
        orders,
        ..Both::with(&[])
    }
}

/// All surfaces as they were submitted, all of them shuffled, and half of them shuffled in another way.
#[test]
fn ten_thousand_sequences_in_other_orders_and_in_part() {
    let context = Context::headless().unwrap();
    let scene = random_stack(1).scene();
    let mut half = shuffled(&scene, 3);
    half.truncate(half.len() / 2);
    let orders = [shuffled(&scene, 2), half];
    painter(Vec::new()).drive(&context, &scene, |both| {
        run(&PAINTER, &[], Variables::new(), both).unwrap();
    });
    let compared = painter(orders.to_vec()).drive(&context, &scene, |both| {
        for (number, order) in orders.iter().enumerate() {
            both.gl.choose_order(number).unwrap();
            both.emulator.set_order(Some(&places(&scene, order)));
            run(&PAINTER, &[], Variables::new(), both).unwrap();
        }
    });
    assert!(compared > 100_000, "{compared}");
}

#[test]
fn another_order_is_noticed() {
    let context = Context::headless().unwrap();
    let scene = random_stack(1).scene();
    let order = shuffled(&scene, 2);
    let draw = |both: &mut LockStep<'_, '_>| {
        run(&PAINTER, &[], Variables::new(), both).unwrap();
    };
    let what = parting(|| {
        painter(vec![order.clone()]).drive(&context, &scene, draw);
    });
    assert!(
        what.starts_with("image after drawTransparentObjects()"),
        "{what}"
    );
    // One triangle is missing: the last of the first pixel that has two.
    let what = parting(|| {
        painter(vec![order.clone()]).drive(&context, &scene, |both| {
            let mut places = places(&scene, &order);
            places.truncate(places.len() - 4);
            both.emulator.set_order(Some(&places));
            draw(both);
        });
    });
    assert!(
        what.starts_with("image after drawTransparentObjects()"),
        "{what}"
    );
}

/// The proof, where opaque surfaces hide some, and the whole pass with its marks, where none does. The lists' numbers are
/// OpenGL's own.
#[test]
fn ten_thousand_sequences_by_the_verified_painter() {
    let context = Context::headless().unwrap();
    for opaque in [Some(700), None] {
        let scene = Stack {
            opaque,
            ..random_stack(6)
        }
        .scene();
        let compared = verified(&scene, 7).drive(&context, &scene, |both| prove(both, &scene, 7));
        assert!(compared > 100_000, "{compared}");
    }
}

/// Triangles in an order of this seed.
fn verified(scene: &Scene, seed: u64) -> Both {
    let has_opaque = scene.meshes.iter().any(|mesh| mesh.opaque);
    Both {
        color_bound: 0.0,
        orders: vec![shuffled(scene, seed)],
        ..Both::with(&[&RESOURCES])
    }
    .defining(&[
        ("OPAQUE", u32::from(has_opaque)),
        ("WORDS_ACROSS", Numbers::words_across(scene.size)),
    ])
}

fn prove(both: &mut LockStep<'_, '_>, scene: &Scene, seed: u64) {
    let order = places(scene, &shuffled(scene, seed));
    both.emulator.set_order(Some(&order));
    let bytes = Numbers::bytes_of_marks(scene.size);
    both.gl.allocate_storage(MARKS, bytes, None).unwrap();
    both.gl.clear_storage(MARKS).unwrap();
    let has_opaque = scene.meshes.iter().any(|mesh| mesh.opaque);
    if has_opaque {
        // What lies behind the marked pixels goes into lists, which lie elsewhere on OpenGL.
        run(&stage::OPAQUE_FIRST, &[], Variables::new(), both).unwrap();
        run(&BLEND_AND_PROVE, &[], Variables::new(), both).unwrap();
        return;
    }
    run(&VERIFIED_PAINTER, &NOTHING_OPAQUE, Variables::new(), both).unwrap();
    let failed = both.samples(FAILED).unwrap();
    assert!((1000..9000).contains(&failed), "{failed}");
    let marks = both.gl.read_storage(MARKS).unwrap();
    let numbers = Numbers::of(bytemuck::cast_slice(&marks), scene.size);
    assert_eq!(u64::from(numbers.count()), failed);
    let stencils = both.emulator.stencils(PROOF_DEPTH).unwrap();
    for (pixel, stencil) in (0..).zip(stencils) {
        let place = [pixel % scene.size[0], pixel / scene.size[0]];
        assert_eq!(numbers.number(place).is_some(), *stencil != 0);
    }
}

#[test]
fn a_changed_word_of_the_proof_is_noticed() {
    const CHANGES: [(Change, &str); 2] = [
        (
            ["verified/hidden.glsl", ">= texelFetch", "> texelFetch"],
            "image",
        ),
        (
            [
                "verified/surface.frag",
                "color = surface_color();",
                "color = vec4(1.0);",
            ],
            "image",
        ),
    ];
    let context = Context::headless().unwrap();
    let scene = random_stack(6).scene();
    for (change, said) in CHANGES {
        let what = parting(|| {
            let changed = verified(&scene, 7).changed(change);
            changed.drive(&context, &scene, |both| prove(both, &scene, 7));
        });
        assert!(what.starts_with(said), "{change:?}: {what}");
    }
}

/// The first batch ends in the middle of the depths, where the second begins. Each draws the triangles that reach into it.
#[test]
fn ten_thousand_sequences_batch_by_batch() {
    let context = Context::headless().unwrap();
    let scene = random_stack(8).scene();
    let Camera { near, far, .. } = scene.camera;
    let middle = 0.75_f32;
    let cut = near * far / (far - f64::from(middle) * (far - near));
    let all = shuffled(&scene, 9);
    let reaching = |batch: [f64; 2]| {
        let mut order = all.clone();
        order.retain(|&[mesh, triangle]| {
            let corner = scene.meshes[mesh as usize].corners(triangle as usize)[0];
            (batch[0]..=batch[1]).contains(&-corner.position.z)
        });
        order
    };
    // With room for the rasteriser's rounding.
    let orders = [reaching([near, cut + 0.01]), reaching([cut - 0.01, far])];
    let both = Both {
        orders: [std::slice::from_ref(&all), &orders].concat(),
        ..Both::with(&RESOURCES_A)
    };
    let mut composited = 0.0;
    let compared = both.drive(&context, &scene, |both| {
        both.emulator.set_order(Some(&places(&scene, &all)));
        run(&stage::OPAQUE_FIRST, &[], Variables::new(), both).unwrap();
        run(&stage::CLEAR_ACCUMULATION, &[], Variables::new(), both).unwrap();
        for (number, batch) in [[0.0, middle], [middle, 1.0]].into_iter().enumerate() {
            both.gl.choose_order(number + 1).unwrap();
            both.emulator
                .set_order(Some(&places(&scene, &orders[number])));
            begin_batch(both, batch[0], batch[1]).unwrap();
            let limit = Variables::new().with("iteration_limit", 12.0);
            let outcome = run(&BATCH, &[UP_TO_THE_BATCH_END], limit, both).unwrap();
            assert_eq!(outcome.stopped, Some(Reason::EmptyLayer));
            composited += outcome.variables.get("composited").unwrap();
        }
        run(&stage::OVER_OPAQUE, &[], Variables::new(), both).unwrap();
    });
    println!("{composited} composited, {compared} comparisons");
    assert!(composited > 20_000.0 && compared > 1_000_000);
}

/// Amended before it ends with the batch.
const BATCH: Listing = Listing {
    title: "A batch",
    source: "Carr et al. 2008, section 9",
    dialect: Dialect::Calls,
    steps: steps! { run LOOP_A amended by &AMENDMENTS; },
};
