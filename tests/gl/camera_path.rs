//! Figure 2 of Lindholm et al. 2015 (claim L20): depth complexity and what a frame costs along a camera path on which what
//! is shown changes. Costs are counts here, which every run repeats; the example of figure 2 shows times beside them.

use onionskin::options::ABufferOptions;
use onionskin::{Animation, Complexity, Context, CountBy, Method, Renderer};

const SIZE: [u32; 2] = [128, 96];
/// The Local Array of ppDP.
const PEEL: u32 = 8;

/// What a frame has, and what it costs.
#[derive(Debug, PartialEq)]
struct Frame {
    complexity: Complexity,
    fragments: u64,
    records_read: u64,
    subpasses: u64,
}

impl Frame {
    /// The part of all pixels that has more layers.
    fn deeper_than(&self, layers: u32) -> f64 {
        let counts = &self.complexity.counts;
        let deep = counts.iter().filter(|&&count| count > layers).count();
        deep as f64 / counts.len() as f64
    }
}

fn animation() -> Animation {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/examples/scenes/molecule_fused.toml"
    );
    Animation::load_at(path, Some(SIZE)).unwrap()
}

fn frames<const N: usize>(numbers: [u32; N]) -> [Frame; N] {
    let animation = animation();
    let context = Context::headless().unwrap();
    let mut renderer = Renderer::new(&context, SIZE[0], SIZE[1]).unwrap();
    let method = Method::ABuffer(ABufferOptions {
        pp_dp: true,
        peel: PEEL,
        ..ABufferOptions::DEFAULT
    });
    numbers.map(|number| {
        let scene = animation.frame(number).unwrap();
        let complexity = renderer.complexity(&scene, CountBy::Blending).unwrap();
        let stats = renderer.render(&scene, &method).unwrap().stats;
        let lists = stats.a_buffer.unwrap();
        println!(
            "frame {number}: {} covered, at most {}; {} records read in {} subpasses",
            complexity.covered(),
            complexity.max(),
            lists.records_read,
            lists.subpasses
        );
        Frame {
            complexity,
            fragments: stats.fragments,
            records_read: lists.records_read,
            subpasses: lists.subpasses,
        }
    })
}

/// What the lists hold is what blending counts; and L12 bounds what ppDP makes of it.
#[test]
pub(crate) fn l20_what_a_frame_costs_follows_from_its_histogram() {
    for frame in frames([0, 70, 120, 199, 200, 290, 300, 399]) {
        assert_eq!(frame.fragments, frame.complexity.fragments());
        let subpasses = |room: u32| -> u64 {
            let of_pixel = |&layers: &u32| u64::from(layers.div_ceil(room));
            frame.complexity.counts.iter().map(of_pixel).sum()
        };
        let bounds = subpasses(PEEL)..=subpasses(PEEL - 1);
        assert!(
            bounds.contains(&frame.subpasses),
            "{} in {bounds:?}",
            frame.subpasses
        );
        // Every subpass of a pixel walks its list.
        let once = frame.complexity.fragments();
        let most = u64::from(frame.complexity.max().div_ceil(PEEL - 1)) * once;
        assert!((once..=most).contains(&frame.records_read));
    }
}

#[test]
pub(crate) fn l20_a_dolly_in_raises_coverage_and_cost_and_a_dolly_out_lowers_them() {
    for [far, nearer, near] in [[200, 230, 290], [399, 360, 310]].map(frames) {
        let covered = [&far, &nearer, &near].map(|frame| frame.complexity.covered());
        assert!(covered.is_sorted(), "{covered:?}");
        let read = [&far, &nearer, &near].map(|frame| frame.records_read);
        assert!(read.is_sorted(), "{read:?}");
        let subpasses = [&far, &nearer, &near].map(|frame| frame.subpasses);
        assert!(subpasses.is_sorted(), "{subpasses:?}");
    }
}

/// The paper: geometry that goes takes pixels of high complexity with it, volumes that go those of low complexity.
#[test]
pub(crate) fn l20_a_change_of_composition_shows_at_once_and_where_it_should() {
    let [before, with, without] = frames([98, 99, 100]);
    // The camera's step alone, without any change, is the control.
    let changed = |a: &Frame, b: &Frame| a.records_read.abs_diff(b.records_read);
    assert!(10 * changed(&before, &with) < changed(&with, &without));
    // The surface: boxes are everywhere, and stay.
    assert!(without.deeper_than(8) < 0.5 * with.deeper_than(8));
    assert!(without.subpasses < with.subpasses);
    let covered = |frame: &Frame| frame.complexity.covered() as f64;
    assert!((covered(&without) / covered(&with) - 1.0).abs() < 0.01);

    // The volumes go, which covered all of the image, and the surface is back: fewer pixels, deeper ones.
    let [with, without] = frames([199, 200]);
    assert!(covered(&without) < 0.7 * covered(&with));

    // The potential's isosurfaces come.
    let [before, without, with] = frames([298, 299, 300]);
    assert!(10 * changed(&before, &without) < changed(&without, &with));
    assert!(with.deeper_than(8) > 2.0 * without.deeper_than(8));
    assert!(with.subpasses > without.subpasses);
}

#[test]
fn a_frame_costs_the_same_whenever_it_is_rendered() {
    let [first, other, again] = frames([250, 350, 250]);
    assert_eq!(first, again);
    assert!(first != other);
}

#[test]
fn a_frame_that_is_counted_is_the_frame_and_the_count() {
    let scene = animation().frame(0).unwrap();
    let context = Context::headless().unwrap();
    let mut renderer = Renderer::new(&context, SIZE[0], SIZE[1]).unwrap();
    let lists = Method::ABuffer(ABufferOptions::DEFAULT);
    // Its slices are counted as the volumes that they stand for.
    let slices = Method::HybridLayerPeeling(Default::default());
    for method in [lists, slices, Method::Exact] {
        let (frame, complexity) = renderer
            .render_and_count(&scene, &method, CountBy::Blending)
            .unwrap();
        let image = renderer.render(&scene, &method).unwrap().image;
        assert_eq!(frame.image, image, "{method:?}");
        let alone = renderer.complexity(&scene, CountBy::Blending).unwrap();
        assert_eq!(complexity, alone, "{method:?}");
        assert!(complexity.max() > 0);
    }
}
