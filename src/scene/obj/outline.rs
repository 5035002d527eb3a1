//! A polygon's outline on a plane: its corners, where corners at the same place become one, and its edges, which may
//! cross.

use std::collections::HashMap;
use std::ops::Range;

use glam::DVec2;
use robust::{Coord, orient2d};

/// `spade` takes no coordinates below this. Coordinates are at most 1 here, so smaller ones may count as 0.
const NOTHING: f64 = 1e-40;

/// Crossings nearer to each other than this are one. It is some thousand times the distance by which rounding moves a
/// crossing.
const NEAR: f64 = 1.0 / (1_u64 << 40) as f64;

/// A turn with a smaller sine counts as straight on. This decides only about an order, so the value may be large.
const STRAIGHT: f64 = 1e-3;

/// The most pairs of edges that are tested for crossings, in addition to some pairs per edge.
const MOST_PAIRS: usize = 1 << 20;

/// How often a polygon runs along an edge, and how much more often it does so from the lower corner to the higher one
/// than back.
#[derive(Clone, Copy, Default)]
pub(super) struct Runs {
    pub(super) count: u32,
    pub(super) net: i32,
}

impl Runs {
    /// The sum of two counts. The second ones are reversed if `reversed`.
    pub(super) fn joined(self, other: Self, reversed: bool) -> Self {
        let net = if reversed { -other.net } else { other.net };
        Self {
            count: self.count + other.count,
            net: self.net + net,
        }
    }
}

/// An edge of the polygon, or a piece of an edge.
#[derive(Clone, Copy)]
pub(super) struct Edge {
    /// The lower corner first.
    pub(super) ends: [usize; 2],
    pub(super) runs: Runs,
    /// The corners of the polygon at the ends of the whole edge.
    whole: [usize; 2],
}

/// A corner where edges cross: the corners at the ends of one of the edges, and the place between them.
#[derive(Clone, Copy)]
pub(super) struct Crossing {
    pub(super) between: [usize; 2],
    pub(super) at: f64,
}

/// The outline.
pub(super) struct Outline {
    /// The corners of the polygon, first those where it turns, and then the crossings.
    pub(super) places: Vec<DVec2>,
    /// For each place, the number of the polygon's first corner there.
    pub(super) first: Vec<usize>,
    /// The edges that matter. An edge that the polygon follows to and fro, such as the bridge to a hole, does not
    /// matter, because its two sides are alike.
    pub(super) edges: Vec<Edge>,
    /// The crossings, whose numbers follow those of the polygon's own corners.
    pub(super) added: Vec<Crossing>,
    /// The number of corners where the polygon turns.
    pub(super) turning: usize,
    /// How often the polygon goes back the way it came.
    pub(super) spikes: usize,
}

impl Outline {
    /// The outline of a polygon with coordinates of at most 1.
    pub(super) fn new(flat: &[DVec2]) -> Self {
        let flat: Vec<DVec2> = flat.iter().map(|&corner| without_nothing(corner)).collect();
        let turns = Turns::of(&flat);
        let mut outline = Self {
            places: Vec::new(),
            first: Vec::new(),
            edges: Vec::new(),
            added: Vec::new(),
            turning: 0,
            spikes: turns.spikes,
        };
        let mut corners = vec![0; flat.len()];
        let mut known = HashMap::new();
        for (turning, i) in turns.in_order() {
            let place = flat[i];
            let key = place.to_array().map(f64::to_bits);
            corners[i] = *known.entry(key).or_insert_with(|| {
                outline.places.push(place);
                outline.first.push(i);
                outline.turning += usize::from(turning);
                outline.places.len() - 1
            });
        }
        let next = corners.iter().cycle().skip(1);
        let mut edges = Edges::default();
        for (&from, &to) in corners.iter().zip(next) {
            edges.add(from, to, Runs { count: 1, net: 1 }, [from, to]);
        }
        outline.edges = edges.that_matter();
        outline
    }

    /// Cuts edges where they cross. `None` if they cross so often that the polygon is noise.
    pub(super) fn cut(&mut self) -> Option<()> {
        let most_added = self.first.len() + 256;
        let mut near = Near::new(&self.places);
        let mut cuts: Vec<Vec<(f64, usize)>> = vec![Vec::new(); self.edges.len()];
        for [one, other] in self.pairs()? {
            let [a, b, c, d] = self.corners(one, other);
            let Some((along, along_other)) = crossing([a, b, c, d].map(|i| self.places[i])) else {
                continue;
            };
            let place = self.places[a].lerp(self.places[b], along);
            let corner = near.corner(&self.places, place);
            let corner = corner.unwrap_or_else(|| self.add(one, place, &mut near));
            cuts[one].push((along, corner));
            cuts[other].push((along_other, corner));
            if self.added.len() > most_added {
                return None;
            }
        }
        let mut pieces = Edges::default();
        for (edge, cuts) in self.edges.iter().zip(&mut cuts) {
            cuts.sort_by(|a, b| a.0.total_cmp(&b.0));
            let [mut from, last] = edge.ends;
            let to = cuts.iter().map(|&(_, corner)| corner).chain([last]);
            for to in to {
                pieces.add(from, to, edge.runs, edge.whole);
                from = to;
            }
        }
        self.edges = pieces.that_matter();
        Some(())
    }

    fn corners(&self, one: usize, other: usize) -> [usize; 4] {
        let [[a, b], [c, d]] = [one, other].map(|edge| self.edges[edge].ends);
        [a, b, c, d]
    }

    /// Adds a corner on this edge.
    fn add(&mut self, edge: usize, place: DVec2, near: &mut Near) -> usize {
        let whole = self.edges[edge].whole;
        let [start, end] = whole.map(|corner| self.places[corner]);
        let along = (place - start).dot(end - start) / (end - start).length_squared();
        let between = whole.map(|corner| self.first[corner]);
        let at = along.clamp(0.0, 1.0);
        self.added.push(Crossing { between, at });
        self.places.push(place);
        near.add(place, self.places.len() - 1);
        self.places.len() - 1
    }

    /// The pairs of edges whose boxes meet. `None` if there are too many.
    fn pairs(&self) -> Option<Vec<[usize; 2]>> {
        let boxes = self.edges.iter().map(|edge| {
            let [a, b] = edge.ends.map(|end| self.places[end]);
            (a.min(b), a.max(b))
        });
        let boxes: Vec<(DVec2, DVec2)> = boxes.collect();
        let mut order: Vec<usize> = (0..boxes.len()).collect();
        order.sort_by(|&a, &b| boxes[a].0.x.total_cmp(&boxes[b].0.x));
        let mut left = MOST_PAIRS + 16 * boxes.len();
        let mut pairs = Vec::new();
        for (i, &one) in order.iter().enumerate() {
            let (low, high) = boxes[one];
            let after = order[i + 1..].iter();
            for &other in after.take_while(|&&other| boxes[other].0.x <= high.x) {
                left = left.checked_sub(1)?;
                if boxes[other].0.y <= high.y && boxes[other].1.y >= low.y {
                    pairs.push([one, other]);
                }
            }
        }
        Some(pairs)
    }
}

/// The coordinate, or 0 if it is too small for `spade`. Negative zero becomes 0.
fn without_nothing(corner: DVec2) -> DVec2 {
    let [x, y] = corner
        .to_array()
        .map(|x| if x.abs() < NOTHING { 0.0 } else { x });
    DVec2::new(x, y)
}

/// The corners where a polygon turns, and those where it goes straight on.
struct Turns {
    turning: Vec<bool>,
    spikes: usize,
}

impl Turns {
    fn of(flat: &[DVec2]) -> Self {
        let last = flat.last().copied().unwrap_or_default();
        // The nearest corners before and after each corner that are at another place.
        let before = apart(last, flat.iter().copied());
        let first = flat.first().copied().unwrap_or_default();
        let mut after = apart(first, flat.iter().rev().copied());
        after.reverse();
        let mut spikes = 0;
        let corners = flat.iter().zip(before.into_iter().zip(after));
        let turning = corners.map(|(&here, (before, after))| {
            let [came, goes] = [here - before, after - here];
            let sideways = came.perp_dot(goes).abs();
            let onwards = came.dot(goes);
            spikes += usize::from(sideways == 0.0 && onwards < 0.0);
            onwards < 0.0 || sideways > STRAIGHT * onwards
        });
        let turning: Vec<bool> = turning.collect();
        Self { turning, spikes }
    }

    /// The corners, each with whether the polygon turns there. Corners with a turn come first. Of the corners on each
    /// line, the middle one comes next, then the middle ones of its halves, and so on. In this order each insertion
    /// changes few edges of a triangulation. Along the line, each would change all of them.
    fn in_order(&self) -> Vec<(bool, usize)> {
        let all = 0..self.turning.len();
        let turning = all.filter(|&i| self.turning[i]).map(|i| (true, i));
        let mut order: Vec<(bool, usize)> = turning.collect();
        let mut start = 0;
        for line in self.turning.split(|&turns| turns) {
            halve(start..start + line.len(), &mut |i| order.push((false, i)));
            start += line.len() + 1;
        }
        order
    }
}

/// The middle of a range, then the middles of its halves.
fn halve(range: Range<usize>, take: &mut impl FnMut(usize)) {
    if !range.is_empty() {
        let middle = range.start + range.len() / 2;
        take(middle);
        halve(range.start..middle, take);
        halve(middle + 1..range.end, take);
    }
}

/// For each place the one before it. For equal consecutive places it is the one before all of them.
fn apart(first: DVec2, places: impl Iterator<Item = DVec2>) -> Vec<DVec2> {
    let (mut before, mut latest) = (first, first);
    let apart = places.map(|place| {
        if place != latest {
            (before, latest) = (latest, place);
        }
        before
    });
    apart.collect()
}

/// The point where two edges cross between their ends, as parts of their lengths.
fn crossing(places: [DVec2; 4]) -> Option<(f64, f64)> {
    let [a, b, c, d] = places.map(|place| Coord {
        x: place.x,
        y: place.y,
    });
    let [of_c, of_d] = [c, d].map(|end| orient2d(a, b, end));
    let [of_a, of_b] = [a, b].map(|end| orient2d(c, d, end));
    let crosses = |one: f64, other: f64| (one < 0.0 && other > 0.0) || (one > 0.0 && other < 0.0);
    let both = crosses(of_a, of_b) && crosses(of_c, of_d);
    both.then(|| (of_a / (of_a - of_b), of_c / (of_c - of_d)))
}

/// Collects edges, each once.
#[derive(Default)]
struct Edges {
    edges: Vec<Edge>,
    known: HashMap<[usize; 2], usize>,
}

impl Edges {
    /// Adds an edge along which the polygon runs so from the first corner to the second.
    fn add(&mut self, from: usize, to: usize, runs: Runs, whole: [usize; 2]) {
        if from == to {
            return;
        }
        let ends = [from.min(to), from.max(to)];
        let at = *self.known.entry(ends).or_insert_with(|| {
            let runs = Runs::default();
            self.edges.push(Edge { ends, runs, whole });
            self.edges.len() - 1
        });
        let edge = &mut self.edges[at];
        edge.runs = edge.runs.joined(runs, from > to);
    }

    fn that_matter(self) -> Vec<Edge> {
        let matters = |edge: &Edge| edge.runs.count % 2 == 1 || edge.runs.net != 0;
        self.edges.into_iter().filter(matters).collect()
    }
}

/// Finds corners near a place.
struct Near(HashMap<[i64; 2], Vec<usize>>);

impl Near {
    fn new(places: &[DVec2]) -> Self {
        let mut near = Self(HashMap::new());
        for (corner, &place) in places.iter().enumerate() {
            near.add(place, corner);
        }
        near
    }

    fn cell(place: DVec2) -> [i64; 2] {
        place.to_array().map(|x| (x / NEAR).floor() as i64)
    }

    fn add(&mut self, place: DVec2, corner: usize) {
        self.0.entry(Self::cell(place)).or_default().push(corner);
    }

    /// The first corner near a place.
    fn corner(&self, places: &[DVec2], place: DVec2) -> Option<usize> {
        let [x, y] = Self::cell(place);
        let cells = (-1..=1).flat_map(|i| (-1..=1).map(move |j| [x + i, y + j]));
        let corners = cells
            .filter_map(|cell| self.0.get(&cell))
            .flatten()
            .copied();
        let near = corners.filter(|&corner| places[corner].distance(place) <= NEAR);
        near.min()
    }
}
