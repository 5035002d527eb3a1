//! Amendments are small: one step less, and the failure is back. Each amendment that runs on the emulated pixel is left out
//! whole, and then without each single step that it adds. A change is noticed if the image, the iterations or the end of the
//! loop are others than by the whole amendment.
//!
//! Amendments that need OpenGL are not here: VTK's and Everitt's, those of Lindholm's state calls, and Algorithm 2 on
//! OpenGL. Their tests leave them out whole.

use onionskin::low_level::emulator::{Group, run_algorithm, run_on_lists};
use onionskin::low_level::fragment::{Fragment, Rgba};
use onionskin::low_level::papers::carr_2008::{coherent, hybrid, ideal};
use onionskin::low_level::papers::lindholm_2015::components;
use onionskin::low_level::steps::pseudo::{self, list};
use onionskin::low_level::steps::{Amendment, Statement, Step};

use crate::emulator_exhaustive::{partly_sorted, sequences_with_ties, with_every_opaque};
use crate::kit::peels::{self, Loop, Pixel, before, depth_of, emulate, random_image, reversed};

/// A statement that can be written again with one of the statements inside of it left out.
trait Shortened: Statement + Copy + std::fmt::Debug {
    fn shortened(&self, kept: &[Self]) -> Vec<Self>;
}

/// A list of statements without any one of them, the innermost ones included, but for those that are kept. Where one
/// decides between two lists, either of them also takes its place. Marks in the margin run nothing, and stay.
fn without_one<S: Shortened>(statements: &[S], kept: &[S]) -> Vec<Vec<S>> {
    let at = |place: usize| {
        let with = |here: &[S]| [&statements[..place], here, &statements[place + 1..]].concat();
        let statement = statements[place];
        let [then, otherwise] = statement.bodies();
        let mut lists: Vec<_> = statement
            .shortened(kept)
            .iter()
            .map(|it| with(&[*it]))
            .collect();
        if !kept.contains(&statement) && statement.margin().is_none() {
            lists.extend(
                [then, otherwise]
                    .into_iter()
                    .filter(|body| !body.is_empty())
                    .map(with),
            );
            lists.push(with(&[]));
        }
        lists
    };
    (0..statements.len()).flat_map(at).collect()
}

/// The same of a branch, which keeps a statement: a choice between something and nothing is another thing.
fn branch_without_one<S: Shortened>(branch: &[S], kept: &[S]) -> Vec<Vec<S>> {
    let mut lists = without_one(branch, kept);
    lists.retain(|list| !list.is_empty());
    lists
}

/// All statements, the innermost ones included.
fn all<S: Shortened>(statements: &[S]) -> Vec<S> {
    let inner = statements.iter().flat_map(|statement| statement.bodies());
    [statements.to_vec(), inner.flat_map(all).collect()].concat()
}

impl Shortened for Step {
    fn shortened(&self, kept: &[Self]) -> Vec<Self> {
        let Self::If {
            condition,
            then,
            otherwise,
        } = *self
        else {
            return Vec::new();
        };
        let of = |then, otherwise| Self::If {
            condition,
            then,
            otherwise,
        };
        let first = branch_without_one(then, kept)
            .into_iter()
            .map(|shorter| of(shorter.leak(), otherwise));
        let second = branch_without_one(otherwise, kept)
            .into_iter()
            .map(|shorter| of(then, shorter.leak()));
        first.chain(second).collect()
    }
}

impl Shortened for pseudo::Line {
    fn shortened(&self, _: &[Self]) -> Vec<Self> {
        Vec::new()
    }
}

impl Shortened for list::ListLine {
    fn shortened(&self, kept: &[Self]) -> Vec<Self> {
        let Self::If(test, then, otherwise) = *self else {
            return Vec::new();
        };
        let of = |then, otherwise| Self::If(test, then, otherwise);
        let first = branch_without_one(then, kept)
            .into_iter()
            .map(|shorter| of(shorter.leak(), otherwise));
        let second = branch_without_one(otherwise, kept)
            .into_iter()
            .map(|shorter| of(then, shorter.leak()));
        first.chain(second).collect()
    }
}

/// The amendments without one of them, or without one step that one of them adds. Each has a name: the amendment's key, and
/// the number of the change.
fn with_less<S: Shortened>(amendments: &[Amendment<S>]) -> Vec<(String, Vec<Amendment<S>>)> {
    let mut less = Vec::new();
    for (place, amendment) in amendments.iter().enumerate() {
        let others = [&amendments[..place], &amendments[place + 1..]].concat();
        less.push((format!("{} {place}", amendment.key), others));
        let shorter = without_one(amendment.amended, &all(amendment.printed));
        for (number, shorter) in shorter.into_iter().enumerate() {
            let mut changed = amendments.to_vec();
            let name = format!("{} {place}.{number}", amendment.key);
            println!("{name}: {shorter:?}");
            changed[place].amended = shorter.leak();
            less.push((name, changed));
        }
    }
    less
}

/// Those that nothing notices.
fn idle<S: Shortened>(
    amendments: &[Amendment<S>],
    same: impl Fn(&[Amendment<S>]) -> bool,
) -> Vec<String> {
    assert!(same(amendments), "compared with itself");
    let less = with_less(amendments);
    println!("{} changes", less.len());
    less.into_iter()
        .filter(|(_, changed)| same(changed))
        .map(|(what, _)| what)
        .collect()
}

/// Every sequence of up to four surfaces with every tie and every opaque surface; the same from the near plane on; random
/// images, in which pixels end at different iterations.
fn images() -> Vec<Vec<Pixel>> {
    let small = (1..=4).flat_map(sequences_with_ties);
    let small: Vec<Pixel> = small
        .flat_map(|ranks| with_every_opaque(&ranks).collect::<Vec<_>>())
        .collect();
    let mut near = small.clone();
    for surface in near.iter_mut().flatten() {
        surface.fragment.depth -= 2.0 / 32.0;
    }
    let half = random_image(8)
        .into_iter()
        .map(|pixel| before(pixel, depth_of(4, 8)))
        .collect();
    vec![small, near, random_image(8), half, reversed(16)]
}

fn of_loop(
    which: Loop,
    images: &[Vec<Pixel>],
    amendments: &[Amendment],
) -> Vec<impl PartialEq + use<>> {
    let run = |pixels: &Vec<Pixel>| {
        let emulated = emulate(which, pixels, amendments);
        let image = emulated.emulator.colors(peels::IMAGE).unwrap();
        let image: Vec<_> = image.iter().map(|color| color.map(f32::to_bits)).collect();
        (image, emulated.iterations(), emulated.ended())
    };
    images.iter().map(run).collect()
}

/// What nothing notices. Pass 5's amendment already resets what variant B's pass would meet. Pass 2 may leave out the near
/// plane in the first iteration, too, for what lies there is s_n itself; and pass 1's program is bound still.
const HARMLESS: [&str; 5] = ["CX12 1", "CX12 1.0", "CX12 1.1", "CX11 4.1", "CX11 4.2"];

#[test]
fn one_step_less_of_sections_5_and_6_is_noticed() {
    let images = images();
    let loops = [Loop::A, Loop::B];
    let right = loops.map(|which| of_loop(which, &images, &coherent::AMENDMENTS));
    let idle = idle(&coherent::AMENDMENTS, |amendments| {
        loops
            .iter()
            .zip(&right)
            .all(|(&which, right)| of_loop(which, &images, amendments) == *right)
    });
    assert_eq!(idle, HARMLESS);
}

/// The images with each part of their surfaces sorted.
fn partly() -> Vec<Vec<Pixel>> {
    let parts = |pixels: Vec<Pixel>| -> Vec<Pixel> {
        let masks = [0b0101, 0b1100, 0b0010, 0];
        let part = |(place, pixel)| partly_sorted(pixel, masks[place % 4]);
        pixels.into_iter().enumerate().map(part).collect()
    };
    images().into_iter().map(parts).collect()
}

#[test]
fn one_step_less_of_algorithm_1_is_noticed() {
    let images = partly();
    assert!(
        images[0]
            .iter()
            .flatten()
            .any(|surface| surface.group == Group::Sorted)
    );
    let right = of_loop(Loop::Hybrid, &images, &hybrid::AMENDMENTS);
    let on_opengl = idle(&hybrid::AMENDMENTS, |amendments| {
        of_loop(Loop::Hybrid, &images, amendments) == right
    });
    assert_eq!(on_opengl, Vec::<String>::new());
    let run = |amendments: &[_]| {
        let run =
            |pixels: &Vec<Pixel>| run_algorithm(&hybrid::ALGORITHM_1, amendments, pixels, 20).ok();
        images.iter().map(run).collect::<Vec<_>>()
    };
    let right = run(&hybrid::AMENDMENTS_1);
    assert_eq!(
        idle(&hybrid::AMENDMENTS_1, |amendments| run(amendments) == right),
        Vec::<String>::new()
    );
}

#[test]
fn one_step_less_of_algorithm_2_is_noticed() {
    let images = images();
    let run = |amendments: &[_]| {
        let run =
            |pixels: &Vec<Pixel>| run_algorithm(&ideal::ALGORITHM_2, amendments, pixels, 40).ok();
        images.iter().map(run).collect::<Vec<_>>()
    };
    for whole in [&ideal::AMENDMENTS_2[..], &ideal::TIGHT_BOUND] {
        let right = run(whole);
        assert!(right.iter().all(Option::is_some));
        assert_eq!(
            idle(whole, |amendments| run(amendments) == right),
            Vec::<String>::new()
        );
    }
}

#[test]
fn one_step_less_of_lindholm_s_components_is_noticed() {
    let lists: Vec<Vec<Fragment>> = (0..=40_u32)
        .map(|count| {
            let fragment = |order| Fragment {
                depth: (order * 7 % 5) as f32 / 8.0,
                color: Rgba::default(),
                order,
            };
            (0..count).map(fragment).collect()
        })
        .collect();
    let run = |algorithm, amendments: &[_], array| {
        run_on_lists(algorithm, amendments, &lists, array, 100)
            .ok()
            .map(|run| (run.pixels, run.ended))
    };
    // An emulated pixel begins before all depths if it is not told where. And once no fragment is lost, the printed end
    // of the loop is as good as the amended one. ppAO may peel every segment: one that holds the list takes one subpass.
    let harmless = ["LX04 0.0", "LX03 3"];
    for (algorithm, whole, array, harmless) in [
        (
            &components::PP_DP,
            &components::PP_DP_AMENDMENTS[..],
            3,
            &harmless[..],
        ),
        (&components::PP_AO, &[components::PP_AO_AMENDMENT], 16, &[]),
        (
            &components::STATIC_ARRAY,
            &[components::KEEP_NEAREST],
            8,
            &[],
        ),
    ] {
        let right = run(algorithm, whole, array);
        assert!(right.is_some());
        let idle = idle(whole, |amendments| {
            run(algorithm, amendments, array) == right
        });
        assert_eq!(idle, harmless, "{}", algorithm.title);
    }
}
