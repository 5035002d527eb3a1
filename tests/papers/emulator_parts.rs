//! The emulated pixel draws what it is told to: a band of the image, a part of the screen, some of the surfaces, in another
//! order. And it says of every watched pixel what became of each of its surfaces.

use onionskin::low_level::emulator::{Emulator, FragmentOutcome, Group, Surface, Texel};
use onionskin::low_level::methods::allocate_maps;
use onionskin::low_level::papers::stage::{self, IMAGE_COLOR, OPAQUE_DEPTH};
use onionskin::low_level::steps::{Call, Machine, Objects, Shader, gl::*};
use onionskin::{Format, Fragment, Rgba};

use crate::kit::peels::{Pixel, before, depth_of, pixel};

/// Four pixels, two by two, each with three surfaces and an opaque one behind the first two.
fn two_by_two() -> Emulator {
    let surfaces = || before(pixel([0, 1, 3].map(|k| depth_of(k, 4))), depth_of(2, 4));
    let pixels: Vec<Pixel> = (0..4).map(|_| surfaces()).collect();
    let mut emulator = Emulator::new(pixels).watching_all();
    let (color, depth) = (Format::Rgba32F, Format::Depth32FStencil8);
    allocate_maps(&mut emulator, &[&stage::RESOURCES], color, depth).unwrap();
    emulator.set_places(vec![[0, 0], [1, 0], [0, 1], [1, 1]]);
    emulator
}

fn perform(emulator: &mut Emulator, calls: &[Call]) {
    calls
        .iter()
        .for_each(|call| emulator.perform(call).unwrap());
}

fn clear_to(red: f32) -> [Call; 3] {
    [
        glBindFramebuffer(stage::IMAGE),
        glClearColor(red, 0.0, 0.0, 1.0),
        glClear(COLOR_AND_DEPTH_BUFFER_BITS),
    ]
}

fn draw(objects: Objects) -> Call {
    Call::Draw { objects }
}

fn reds(emulator: &Emulator) -> Vec<f32> {
    let colors = emulator.colors(IMAGE_COLOR).unwrap();
    colors.iter().map(|[red, ..]| *red).collect()
}

#[test]
fn a_band_is_cleared_and_drawn_alone() {
    let mut emulator = two_by_two();
    perform(&mut emulator, &clear_to(0.25));
    emulator.set_band(Some([1, 1]));
    perform(&mut emulator, &clear_to(0.5));
    assert_eq!(reds(&emulator), [0.25, 0.25, 0.5, 0.5]);
    perform(
        &mut emulator,
        &[glUseProgram(Shader("complexity")), draw(Objects::Opaque)],
    );
    assert_eq!(reds(&emulator), [0.25, 0.25, 1.0, 1.0]);
    emulator.set_band(None);
    perform(&mut emulator, &clear_to(0.75));
    assert_eq!(reds(&emulator), [0.75; 4]);
    assert_eq!(emulator.depths(OPAQUE_DEPTH).unwrap(), [1.0; 4]);
}

#[test]
fn a_draw_over_a_part_of_the_screen_leaves_the_rest() {
    let mut emulator = two_by_two();
    perform(&mut emulator, &clear_to(0.25));
    emulator.set_screen(Some([1, 0, 1, 2]));
    perform(
        &mut emulator,
        &[glUseProgram(Shader("complexity")), draw(Objects::Screen)],
    );
    assert_eq!(reds(&emulator), [0.25, 1.0, 0.25, 1.0]);
    // Surfaces are drawn anywhere.
    perform(&mut emulator, &[draw(Objects::Opaque)]);
    assert_eq!(reds(&emulator), [1.0; 4]);
}

#[test]
fn surfaces_are_drawn_in_the_order_that_was_said_and_no_others() {
    let mut emulator = two_by_two();
    emulator.set_order(Some(&[2, 0]));
    perform(&mut emulator, &clear_to(0.0));
    perform(
        &mut emulator,
        &[
            glEnable(DEPTH_TEST),
            glUseProgram(stage::SURFACE),
            draw(Objects::Opaque),
            draw(Objects::Transparent),
        ],
    );
    let draws = &emulator.records()[3].draws;
    let drawn = |number: usize| {
        let fates = draws[number].fates.iter();
        fates
            .map(|fate| (fate.order, fate.outcome))
            .collect::<Vec<_>>()
    };
    assert_eq!(drawn(0), [(u32::MAX, FragmentOutcome::Pass)]);
    assert_eq!(
        drawn(1),
        [(2, FragmentOutcome::DepthFail), (0, FragmentOutcome::Pass)]
    );
    for (order, drawn) in [
        (None, vec![0, 1, 2]),
        (Some(&[1, 2, 1][..]), vec![1, 2, 1]),
        (Some(&[]), vec![]),
    ] {
        emulator.set_order(order);
        perform(&mut emulator, &[draw(Objects::Transparent)]);
        let last = emulator.records()[0].draws.last().unwrap();
        let orders: Vec<_> = last.fates.iter().map(|fate| fate.order).collect();
        assert_eq!(orders, drawn);
    }
}

#[test]
fn a_record_has_the_maps_and_their_texels_before_and_after_each_surface() {
    let mut emulator = two_by_two();
    perform(&mut emulator, &clear_to(0.5));
    perform(
        &mut emulator,
        &[glUseProgram(Shader("complexity")), draw(Objects::Opaque)],
    );
    for record in emulator.records() {
        let [draw] = &record.draws[..] else {
            panic!("one draw: {record:?}");
        };
        assert_eq!(
            (draw.program, draw.objects),
            ("complexity", Objects::Opaque)
        );
        assert_eq!(draw.target, Some(stage::IMAGE));
        assert_eq!(draw.colors, [Some(IMAGE_COLOR)]);
        assert_eq!(draw.depth, Some(OPAQUE_DEPTH));
        let texels = [[0.5, 0.0, 0.0, 1.0], [1.0; 4]].map(Texel::Color);
        assert_eq!(draw.fates[0].colors, [texels]);
        assert!(draw.fates[0].list.is_none() && draw.fates[0].images.is_empty());
    }
}

/// Boxes around volumes are drawn by their own draw alone.
#[test]
fn no_draw_but_that_of_proxies_draws_a_proxy() {
    let proxy = Surface {
        fragment: Fragment {
            depth: 0.5,
            color: Rgba::default(),
            order: 1 << 30,
        },
        group: Group::Proxy,
    };
    let mut emulator = Emulator::new(vec![vec![proxy]]).watching(0);
    let (color, depth) = (Format::Rgba32F, Format::Depth32FStencil8);
    allocate_maps(&mut emulator, &[&stage::RESOURCES], color, depth).unwrap();
    perform(&mut emulator, &clear_to(0.0));
    perform(&mut emulator, &[glUseProgram(stage::SURFACE)]);
    let others = [
        Objects::Scene,
        Objects::Opaque,
        Objects::Transparent,
        Objects::Sorted,
        Objects::Unsorted,
    ];
    perform(&mut emulator, &others.map(draw));
    perform(&mut emulator, &[draw(Objects::Proxies)]);
    let fates = emulator.record().draws.iter().map(|draw| draw.fates.len());
    assert_eq!(fates.collect::<Vec<_>>(), [0, 0, 0, 0, 0, 1]);
}
