//! Every order of few surfaces, with every pattern of equal depths, with and without an opaque surface anywhere among
//! them, on the emulated pixel: the amended algorithms composite exactly the oracle's list, each surface once, in order.

use crate::kit::peels;
use onionskin::low_level::emulator::{Group, run_algorithm};
use onionskin::low_level::papers::carr_2008::{hybrid, ideal};

use crate::kit::peels::{Loop, Pixel, bad, before, emulate, pixel};

/// How many they are.
const CASES: usize = 208_848;

/// Pixels at a time: an image, so that pixels finish at different iterations.
const IMAGE: usize = 6000;

/// Every sequence of `n` ranks in which all ranks from 0 to some k occur: every order with every pattern of ties.
pub(crate) fn sequences_with_ties(n: usize) -> Vec<Vec<usize>> {
    let mut all = vec![vec![]];
    for _ in 0..n {
        all = all
            .into_iter()
            .flat_map(|sequence: Vec<usize>| {
                (0..n).map(move |rank| [&sequence[..], &[rank]].concat())
            })
            .collect();
    }
    all.retain(|sequence| {
        let highest = sequence.iter().max().copied().unwrap_or(0);
        (0..=highest).all(|rank| sequence.contains(&rank))
    });
    all
}

/// Every order of `n` distinct ranks.
fn permutations(n: usize) -> Vec<Vec<usize>> {
    if n == 0 {
        return vec![vec![]];
    }
    permutations(n - 1)
        .into_iter()
        .flat_map(|shorter| {
            (0..n).map(move |place| {
                let mut longer = shorter.clone();
                longer.insert(place, n - 1);
                longer
            })
        })
        .collect()
}

/// Rank r lies at (2 r + 2) / 32; opaque surfaces lie at any 1 / 32 from the nearest surface to behind all.
fn depth(half_ranks: usize) -> f32 {
    (half_ranks + 2) as f32 / 32.0
}

/// The sequence without an opaque surface, and with one at, between and behind its surfaces.
pub(crate) fn with_every_opaque(ranks: &[usize]) -> impl Iterator<Item = Pixel> {
    let without = pixel(ranks.iter().map(|rank| depth(rank * 2)));
    let highest = ranks.iter().max().map_or(0, |rank| rank * 2 + 1);
    let with = without.clone();
    (0..=highest)
        .map(move |half_rank| before(with.clone(), depth(half_rank)))
        .chain(std::iter::once(without))
}

/// Up to 6 surfaces with every pattern of ties and every opaque surface; 7 in every order with every opaque surface; 8
/// in every order, without and with one at, between or behind them.
pub(crate) fn cases() -> Vec<Pixel> {
    let mut cases: Vec<Pixel> = Vec::new();
    for n in 1..=6 {
        for ranks in sequences_with_ties(n) {
            cases.extend(with_every_opaque(&ranks));
        }
    }
    for ranks in permutations(7) {
        cases.extend(with_every_opaque(&ranks));
    }
    for (number, ranks) in permutations(8).into_iter().enumerate() {
        let without = pixel(ranks.iter().map(|rank| depth(rank * 2)));
        // The place of the opaque surface goes round: at, between and behind.
        cases.push(before(without.clone(), depth(number % 16)));
        cases.push(without);
    }
    cases
}

fn check(which: Loop) {
    let cases = cases();
    for image in cases.chunks(IMAGE) {
        let emulated = emulate(which, image, &which.amendments());
        assert!(emulated.ended(), "{which:?}");
        report(which, image, emulated.emulator.composited());
    }
    println!("{which:?}: {} cases", cases.len());
    // Sequences of up to 6 surfaces (1, 3, 13, 75, 541, 4683 of them) with 2 k + 1 opaque surfaces each for k depths,
    // 7! with 15, 8! with 2.
    assert_eq!(cases.len(), CASES);
}

/// Prints the first case that is wrong as a list that makes a test.
fn report(which: impl std::fmt::Debug, pixels: &[Pixel], composited: &[Vec<u32>]) {
    if bad(pixels, composited) == 0 {
        return;
    }
    let wrong = pixels.iter().zip(composited);
    let (pixel, composited) = wrong
        .filter(|(pixel, composited)| peels::expected(pixel) != **composited)
        .min_by_key(|(pixel, _)| pixel.len())
        .expect("there is one");
    let depths: Vec<f32> = pixel.iter().map(|surface| surface.fragment.depth).collect();
    let kinds: Vec<Group> = pixel.iter().map(|surface| surface.group).collect();
    panic!("{which:?}: depths {depths:?}, {kinds:?} became {composited:?}");
}

#[test]
fn every_sequence_is_there_once() {
    // The ordered Bell numbers, and the factorials.
    assert_eq!(
        [1, 2, 3, 4, 5].map(|n| sequences_with_ties(n).len()),
        [1, 3, 13, 75, 541]
    );
    let mut orders = permutations(5);
    orders.sort();
    orders.dedup();
    assert_eq!(orders.len(), 120);
}

#[test]
fn coherent_layer_peeling_a_composites_every_sequence() {
    check(Loop::A);
}

#[test]
fn coherent_layer_peeling_b_composites_every_sequence() {
    check(Loop::B);
}

#[test]
fn layer_peeling_composites_every_sequence() {
    check(Loop::LayerPeeling);
}

/// For hybrid layer peeling, the surfaces of `mask` are sorted geometry, submitted front to back.
pub(crate) fn partly_sorted(mut pixel: Pixel, mask: usize) -> Pixel {
    let chosen: Vec<usize> = (0..pixel.len())
        .filter(|&place| mask >> place & 1 == 1 && pixel[place].group != Group::Opaque)
        .collect();
    let mut depths: Vec<f32> = chosen
        .iter()
        .map(|&place| pixel[place].fragment.depth)
        .collect();
    depths.sort_by(f32::total_cmp);
    for (place, depth) in chosen.into_iter().zip(depths) {
        pixel[place].fragment.depth = depth;
        pixel[place].group = Group::Sorted;
    }
    pixel
}

/// Every sequence of up to 5 surfaces with ties, every part of it sorted, every opaque surface; 8 in every order with
/// every other one sorted.
fn hybrid_cases() -> Vec<Pixel> {
    let mut cases = Vec::new();
    for n in 1..=5 {
        for ranks in sequences_with_ties(n) {
            for pixel in with_every_opaque(&ranks) {
                cases.extend((0..1 << n).map(|mask| partly_sorted(pixel.clone(), mask)));
            }
        }
    }
    for ranks in permutations(8) {
        let pixel = pixel(ranks.iter().map(|rank| depth(rank * 2)));
        cases.push(partly_sorted(pixel, 0b0101_0101));
    }
    cases
}

#[test]
pub(crate) fn hybrid_layer_peeling_composites_every_sequence_with_every_part_of_it_sorted() {
    let cases = hybrid_cases();
    for image in cases.chunks(IMAGE) {
        let emulated = emulate(Loop::Hybrid, image, &Loop::Hybrid.amendments());
        assert!(emulated.ended());
        report(Loop::Hybrid, image, emulated.emulator.composited());
        let printed = &hybrid::AMENDMENTS_1;
        let algorithm = run_algorithm(&hybrid::ALGORITHM_1, printed, image, 20).unwrap();
        report("Algorithm 1", image, &algorithm.composited);
        // The pseudocode and what OpenGL runs are one algorithm.
        assert_eq!(algorithm.iterations, emulated.iterations());
    }
    println!("hybrid: {} cases", cases.len());
    assert_eq!(cases.len(), 199_490);
}

#[test]
pub(crate) fn algorithm_2_composites_every_sequence() {
    let cases = cases();
    for amendments in [&ideal::AMENDMENTS_2[..], &ideal::TIGHT_BOUND] {
        for image in cases.chunks(IMAGE) {
            let run = run_algorithm(&ideal::ALGORITHM_2, amendments, image, 20).unwrap();
            assert!(run.ended);
            report(amendments[0].key, image, &run.composited);
        }
    }
}

#[test]
fn one_surface_less_or_two_exchanged_would_be_noticed() {
    let pixels = vec![pixel([0.5, 0.25, 0.75])];
    assert_eq!(bad(&pixels, &[vec![1, 0, 2]]), 0);
    for wrong in [vec![1, 0], vec![0, 1, 2], vec![1, 0, 2, 2]] {
        assert_eq!(bad(&pixels, &[wrong]), 1);
    }
}
