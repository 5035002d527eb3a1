//! A-buffers on the emulated pixel and on OpenGL: after the Fill Step the same counts, and the same records in every list, to
//! the bit; after the Resolve Step the same costs at every pixel, and the same colours.

use onionskin::low_level::emulator::{Emulator, InList, Surface};
use onionskin::low_level::methods::allocate_maps;
use onionskin::low_level::papers::lindholm_2015 as paper;
use onionskin::low_level::papers::stage;
use onionskin::low_level::steps::{Call, Machine, Resources, Variables, Workspace, run};
use onionskin::options::{ABufferOptions, ArraySort, Fill, Keep, Manager, Reading, RecordColor};
use onionskin::{Context, Format, Fragment, Renderer, Scene};

use crate::kit::a_buffer::MANAGERS;
use crate::kit::both::{parting, surfaces_of, transparent_pixels};
use crate::kit::changed::Change;
use crate::kit::gl_lists::{Left, left};
use crate::lockstep::random_stack;

/// What a colour may be off by: nothing where the driver rounds as the emulated pixel does. Elsewhere up to ten fragments of a
/// product and a sum each, and the transparency's product; then a product and a sum over what lies behind. Each is rounded by
/// half a step of 2^-24, on both machines.
fn composited_bound(context: &Context) -> f32 {
    match context.driver().quirks().blends_in_three_roundings {
        true => 0.0,
        false => (10.0 * 3.0 + 2.0) / 16_777_216.0,
    }
}

/// The emulated A-buffer, as the method makes it.
pub(crate) struct Emulated {
    pub(crate) emulator: Emulator,
    options: ABufferOptions,
    ordered: bool,
    has_volumes: bool,
}

impl Emulated {
    /// Of pixels with these surfaces.
    pub(crate) fn new(
        context: &Context,
        scene: &Scene,
        options: ABufferOptions,
        pixels: Vec<Vec<Surface>>,
    ) -> Self {
        const MAPS: Resources = Resources {
            framebuffers: &[],
            ..paper::FILLING
        };
        let mut emulator = Emulator::new(pixels).watching_all();
        let resources = [&stage::RESOURCES, &MAPS, &paper::RESOLVING];
        let (color, depth) = (Format::Rgba32F, Format::Depth32FStencil8);
        allocate_maps(&mut emulator, &resources, color, depth).unwrap();
        let driver = context.driver();
        let ordered =
            options.fill != Fill::Atomics && driver.has("GL_EXT_shader_framebuffer_fetch");
        let depth = Some(stage::OPAQUE_DEPTH);
        let (cleared, counters): (&[_], &[_]) = match ordered {
            true => (&[paper::COUNTER], &[paper::COUNTER]),
            false => (&[paper::COUNTER, paper::ANCHOR], &[]),
        };
        emulator
            .framebuffer_with(paper::CLEARED, cleared, depth)
            .unwrap();
        emulator
            .framebuffer_with(paper::FILL, counters, depth)
            .unwrap();
        let mut defines = defines(&options);
        defines.push(("VOLUMES", scene.volumes.len() as u32));
        emulator.set_defines(&defines);
        if let Some(layers) = options.fixed_layers {
            emulator.set_layers(layers);
        }
        let [red, green, blue] = scene.background;
        let alpha = 1.0;
        emulator
            .perform(&Call::ClearColor {
                red,
                green,
                blue,
                alpha,
            })
            .unwrap();
        Self {
            emulator,
            options,
            ordered,
            has_volumes: !scene.volumes.is_empty(),
        }
    }

    pub(crate) fn fill(&mut self) {
        let options = &self.options;
        let filling = match (options.pp_ao, options.reading) {
            (true, Reading::Literal) => &paper::FILL_FOR_PP_AO,
            (true, Reading::AsPrinted) => &paper::CLEAR_AND_COUNTING_FILL,
            _ => &paper::CLEAR_AND_FILL,
        };
        let mut amendments = Vec::new();
        let has_offsets = match (options.manager, options.fill) {
            (Manager::Ffb, _) | (Manager::Ppll, Fill::Atomics) => false,
            (Manager::Dfb | Manager::Ppll, _) => true,
        };
        if has_offsets {
            amendments.push(paper::BEGIN_AT_OFFSETS);
        }
        if self.ordered {
            amendments.push(paper::ORDERED);
        }
        if self.has_volumes {
            amendments.insert(0, paper::PROXIES);
        }
        for (listing, amendments) in [
            (&stage::OPAQUE_FIRST, &[][..]),
            (&paper::CLEAR_COST, &[]),
            (filling, &amendments),
        ] {
            run(listing, amendments, Variables::new(), &mut self.emulator).unwrap();
        }
    }

    pub(crate) fn resolve(&mut self) {
        let options = &self.options;
        let size = match options.pp_dp {
            true => options.peel,
            false => options.array,
        };
        // Segments for which no pixel is deep enough resolve nothing.
        let segments = options.segments().count() as f64;
        let variables = Variables::new()
            .with("N", f64::from(size))
            .with("num_segments", segments);
        let masking = [paper::BY_COUNTER, paper::NO_STENCIL, paper::MARKED];
        let masking = options.reading.of(&masking);
        let (listing, amendments) = match options.pp_ao {
            true => (&paper::PP_AO, &masking[..]),
            false => (&paper::RESOLVE, &[][..]),
        };
        if self.has_volumes {
            let nothing = Variables::new();
            run(&paper::OPAQUE_ENDS_RAYS, &[], nothing, &mut self.emulator).unwrap();
        }
        run(listing, amendments, variables, &mut self.emulator).unwrap();
    }
}

/// As the method has them, but for volumes.
fn defines(options: &ABufferOptions) -> Vec<(&'static str, u32)> {
    let yes = u32::from;
    let printed = options.pp_dp && options.reading != Reading::Amended;
    let literal = options.pp_dp && options.reading == Reading::Literal;
    vec![
        ("FFB", Manager::Ffb as u32),
        ("DFB", Manager::Dfb as u32),
        ("PPLL", Manager::Ppll as u32),
        ("MANAGER", options.manager as u32),
        ("FLOAT_COLOR", yes(options.color == RecordColor::Float)),
        ("TERMINATION", options.termination.to_bits()),
        ("AS_PRINTED", yes(printed)),
        ("LITERAL", yes(literal)),
        ("PEEL_ALWAYS", yes(options.pp_dp && !options.pp_ao)),
        ("PP_DP", yes(options.pp_dp)),
        (
            "MOST_SUBPASSES",
            options.most_subpasses.unwrap_or(i32::MAX as u32),
        ),
        ("FIRST_SEGMENT", 8),
        ("LAST_SEGMENT", options.array),
        ("KEEP_NEAREST", yes(options.keep == Keep::Nearest)),
    ]
}

/// Bits, so that what is not a number is compared, too.
fn bits(fragment: &Fragment) -> [u32; 6] {
    let [r, g, b, a] = fragment.color.to_array().map(f32::to_bits);
    [fragment.depth.to_bits(), fragment.order, r, g, b, a]
}

/// Fills and resolves on both, and compares. Returns how many records there were, and how many fragments found no room.
fn compare(
    context: &Context,
    scene: &Scene,
    options: ABufferOptions,
    change: Option<Change>,
) -> [usize; 2] {
    let renderer = Renderer::new(context, scene.size[0], scene.size[1]).unwrap();
    let left = left(&mut renderer.with_given_planes(), scene, options, change);
    let surfaces = surfaces_of(context, scene);
    let pixels = transparent_pixels(&surfaces);
    let mut emulated = Emulated::new(context, scene, options, surfaces);
    emulated.fill();
    let mut counts = [0; 2];
    for &pixel in &pixels {
        compare_lists(&emulated, &left, pixel, &mut counts);
    }
    emulated.resolve();
    let bound = composited_bound(context);
    let costs = emulated.emulator.integers(paper::COST).unwrap();
    let image = emulated.emulator.colors(stage::IMAGE_COLOR).unwrap();
    for &pixel in &pixels {
        assert!(
            left.costs[pixel] == costs[pixel],
            "the resolve of pixel {pixel} costs {:?} on OpenGL and {:?} on the emulated pixel",
            left.costs[pixel],
            costs[pixel],
        );
        let last = emulated.emulator.records()[pixel].resolves.last();
        let walks = last.map_or(0, |last| last.resolved.passes.len());
        assert_eq!(walks, costs[pixel][2] as usize, "walks of pixel {pixel}");
        let channels = left.image[pixel].iter().zip(image[pixel]);
        let off = channels.map(|(a, b)| (a - b).abs());
        assert!(
            off.max_by(f32::total_cmp).unwrap() <= bound,
            "the image at pixel {pixel} is {:?} on OpenGL and {:?} on the emulated pixel",
            left.image[pixel],
            image[pixel],
        );
    }
    counts
}

/// Also that what happened to each fragment is what is in the list.
pub(crate) fn compare_lists(
    emulated: &Emulated,
    left: &Left,
    pixel: usize,
    counts: &mut [usize; 2],
) {
    let list = emulated.emulator.list(pixel);
    let on_gl = left.list(pixel);
    let same = |list: &[Fragment]| list.iter().map(bits).collect::<Vec<_>>();
    assert!(
        same(&on_gl) == same(list),
        "the list of pixel {pixel} is {on_gl:?} on OpenGL and {list:?} on the emulated pixel"
    );
    let draws = &emulated.emulator.records()[pixel].draws;
    let fates = draws.iter().flat_map(|draw| &draw.fates);
    let in_list: Vec<_> = fates.filter_map(|fate| fate.list).collect();
    let stored = (0..list.len() as u32).map(InList::Stored);
    let lost = in_list.len() - list.len();
    let lost_ones = std::iter::repeat_n(InList::NoRoom, lost);
    assert!(
        in_list.iter().copied().eq(stored.chain(lost_ones)),
        "{in_list:?}"
    );
    assert_eq!(
        in_list.len(),
        left.counted(pixel),
        "the counter of pixel {pixel}"
    );
    counts[0] += list.len();
    counts[1] += lost;
}

/// Whether the driver fills lists in an order that is known: by framebuffer fetch, or on llvmpipe, whose atomics come in the
/// order of submission.
pub(crate) fn fills_in_order(context: &Context, fill: Fill) -> bool {
    let driver = context.driver();
    let fetches = fill != Fill::Atomics && driver.has("GL_EXT_shader_framebuffer_fetch");
    let is_known = fetches || driver.renderer.contains("llvmpipe");
    if !is_known {
        println!("skipped: {} fills lists in any order", driver.renderer);
    }
    is_known
}

/// Every manager and fill, with records of both sizes.
fn fills() -> Vec<ABufferOptions> {
    let of = |manager| {
        [
            (Fill::Automatic, RecordColor::Float),
            (Fill::Atomics, RecordColor::Half),
        ]
        .map(|(fill, color)| ABufferOptions {
            manager,
            fill,
            color,
            array: 8,
            ..ABufferOptions::DEFAULT
        })
    };
    MANAGERS.into_iter().flat_map(of).collect()
}

#[test]
fn ten_thousand_lists_by_every_manager_and_every_fill() {
    let context = Context::headless().unwrap();
    for (number, options) in fills().into_iter().enumerate() {
        if !fills_in_order(&context, options.fill) {
            continue;
        }
        let scene = random_stack(number as u64).scene();
        let [records, lost] = compare(&context, &scene, options, None);
        println!(
            "{:?} {:?}: {records} records",
            options.manager, options.fill
        );
        assert!(records > 20_000 && lost == 0, "{records} {lost}");
    }
}

/// Every Local Array: static ones that keep the first or the nearest, ppAO's segments, ppDP's subpasses, both, as printed,
/// literally, with fewer subpasses, and with rays that end early.
fn resolves(manager: Manager) -> Vec<(&'static str, ABufferOptions)> {
    let of = ABufferOptions {
        manager,
        color: RecordColor::Float,
        array: 4,
        peel: 3,
        // It compiles at once.
        sort: ArraySort::Insertion,
        ..ABufferOptions::DEFAULT
    };
    let pp_ao = ABufferOptions {
        pp_ao: true,
        array: 8,
        ..of
    };
    let pp_dp = ABufferOptions { pp_dp: true, ..of };
    let both = ABufferOptions {
        pp_dp: true,
        ..pp_ao
    };
    let nearest = |options| ABufferOptions {
        keep: Keep::Nearest,
        ..options
    };
    let read = |options, reading| ABufferOptions { reading, ..options };
    let ending = |options| ABufferOptions {
        termination: 0.25,
        ..options
    };
    vec![
        ("static", of),
        ("static, nearest", nearest(of)),
        ("ppAO", pp_ao),
        ("ppAO, nearest", nearest(pp_ao)),
        ("ppDP", pp_dp),
        ("ppAO and ppDP", both),
        ("ppAO as printed", read(pp_ao, Reading::AsPrinted)),
        ("ppAO literally", read(pp_ao, Reading::Literal)),
        ("ppDP as printed", read(pp_dp, Reading::AsPrinted)),
        ("ppDP literally", read(pp_dp, Reading::Literal)),
        (
            "two subpasses",
            ABufferOptions {
                most_subpasses: Some(2),
                ..pp_dp
            },
        ),
        ("static, ending early", ending(of)),
        ("ppDP, ending early", ending(pp_dp)),
    ]
}

#[test]
fn ten_thousand_lists_by_every_local_array() {
    let context = Context::headless().unwrap();
    if !fills_in_order(&context, Fill::Automatic) {
        return;
    }
    let scene = random_stack(20).scene();
    for (name, options) in MANAGERS.into_iter().flat_map(resolves) {
        println!("{:?}, {name}", options.manager);
        compare(&context, &scene, options, None);
    }
}

/// A fixed buffer with room for four fragments, whose counters go on.
#[test]
fn ten_thousand_fixed_buffers_that_overflow() {
    let context = Context::headless().unwrap();
    let scene = random_stack(21).scene();
    for fill in [Fill::Automatic, Fill::Atomics] {
        if !fills_in_order(&context, fill) {
            continue;
        }
        for pp_dp in [false, true] {
            let options = ABufferOptions {
                manager: Manager::Ffb,
                fixed_layers: Some(4),
                array: 8,
                color: RecordColor::Float,
                fill,
                pp_dp,
                ..ABufferOptions::DEFAULT
            };
            let [records, lost] = compare(&context, &scene, options, None);
            println!("{records} records, {lost} lost");
            assert!(records > 10_000 && lost > 5_000);
        }
    }
}

#[test]
fn a_changed_word_of_an_a_buffer_is_noticed() {
    const CHANGES: [(Change, &str); 5] = [
        (
            [
                "a_buffer/record.glsl",
                "uvec4(floatBitsToUint(z), id, 0u, 0u)",
                "uvec4(floatBitsToUint(z) + 1u, id, 0u, 0u)",
            ],
            "the list",
        ),
        (
            ["a_buffer/place.glsl", "return count;", "return count ^ 1u;"],
            "the list",
        ),
        (
            [
                "a_buffer/static.glsl",
                "subpasses += 1u;",
                "subpasses += 2u;",
            ],
            "the resolve",
        ),
        (
            ["a_buffer/list.glsl", "return at + 1u;", "return at;"],
            "the image",
        ),
        (
            [
                "a_buffer/ray.glsl",
                "ray_transparency *= 1.0 - fragment.a;",
                "ray_transparency *= 1.001 - fragment.a;",
            ],
            "the image",
        ),
    ];
    let context = Context::headless().unwrap();
    if !fills_in_order(&context, Fill::Automatic) {
        return;
    }
    let scene = random_stack(22).scene();
    let options = ABufferOptions {
        manager: Manager::Dfb,
        color: RecordColor::Float,
        ..ABufferOptions::DEFAULT
    };
    for (change, said) in CHANGES {
        let what = parting(|| {
            compare(&context, &scene, options, Some(change));
        });
        assert!(what.starts_with(said), "{change:?}: {what}");
    }
}
