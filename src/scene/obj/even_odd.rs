//! What lies within a polygon by the even-odd rule, as triangles: those of a Delaunay triangulation that has the
//! polygon's edges among its own. Edges may touch, overlap and cross; every corner stays a corner, so that neighbours
//! that share one leave no gap.

use std::collections::HashMap;

use glam::{DVec2, DVec3};
use spade::handles::{DirectedEdgeHandle, FixedDirectedEdgeHandle, FixedVertexHandle};
use spade::{CdtEdge, ConstrainedDelaunayTriangulation, HasPosition, Point2, Triangulation};

use super::cover::{Cover, Point};

/// Below this `spade` takes no coordinates; they are at most 1 here, and this is nothing beside that.
const NOTHING: f64 = 1e-40;

/// A corner on the plane; what it is called is its place in the triangulation.
#[derive(Clone, Copy)]
struct Corner(Point2<f64>);

impl HasPosition for Corner {
    type Scalar = f64;

    fn position(&self) -> Point2<f64> {
        self.0
    }
}

type Delaunay = ConstrainedDelaunayTriangulation<Corner>;
type Edge<'a> = DirectedEdgeHandle<'a, Corner, (), CdtEdge<()>, ()>;

/// How often the polygon runs along an edge, and how much more often from the lower corner to the higher.
#[derive(Clone, Copy, Default)]
struct Runs {
    count: u32,
    net: i32,
}

impl Runs {
    fn add(&mut self, from: usize, to: usize) {
        self.count += 1;
        self.net += if from < to { 1 } else { -1 };
    }

    fn joined(self, other: Self, reversed: bool) -> Self {
        let net = if reversed { -other.net } else { other.net };
        Self {
            count: self.count + other.count,
            net: self.net + net,
        }
    }
}

/// Covers a polygon that `flat` has on a plane and `places` in space.
pub(super) fn cover(flat: &[DVec2], places: &[DVec3]) -> Cover {
    let outline = Outline::new(flat);
    let Some(mut plane) = Plane::new(&outline) else {
        return Cover::Tangled;
    };
    // A polygon with more crossings than this is noise.
    let most = 4 * flat.len() + 64;
    for &[from, to] in &outline.edges {
        let drawn = plane.draw(from, to, outline.runs[&[from, to]]);
        if drawn.is_none() || plane.delaunay.num_vertices() > most {
            return Cover::Tangled;
        }
    }
    let Some(within) = plane.within() else {
        return Cover::Tangled;
    };
    let own = outline.first.len();
    let name = |corner: usize| match corner.checked_sub(own) {
        None => outline.first[corner],
        Some(added) => flat.len() + added,
    };
    let added = plane.added.iter().map(|&(ends, at)| {
        let between = ends.map(|end| outline.first[end]);
        let [a, b] = between.map(|corner| places[corner]);
        let place = a.lerp(b, at);
        Point { place, between, at }
    });
    Cover::Triangles {
        triangles: within
            .into_iter()
            .map(|triangle| triangle.map(name))
            .collect(),
        added: added.collect(),
    }
}

/// A polygon's corners, those at one place made one, and the edges that count.
struct Outline {
    places: Vec<Corner>,
    /// Which of the polygon's corners is the first at each place.
    first: Vec<usize>,
    /// The edges that matter, each in its lower direction: not those that are run along to and fro, as the bridge to a
    /// hole is, for on both sides of them all is the same.
    edges: Vec<[usize; 2]>,
    runs: HashMap<[usize; 2], Runs>,
}

impl Outline {
    fn new(flat: &[DVec2]) -> Self {
        let mut places = Vec::new();
        let mut first = Vec::new();
        let mut known = HashMap::new();
        let corners = flat.iter().enumerate().map(|(i, corner)| {
            let [x, y] = corner
                .to_array()
                .map(|x| if x.abs() < NOTHING { 0.0 } else { x });
            *known.entry([x.to_bits(), y.to_bits()]).or_insert_with(|| {
                places.push(Corner(Point2::new(x, y)));
                first.push(i);
                places.len() - 1
            })
        });
        let corners: Vec<usize> = corners.collect();
        let mut edges = Vec::new();
        let mut runs: HashMap<[usize; 2], Runs> = HashMap::new();
        for (i, &from) in corners.iter().enumerate() {
            let to = corners[(i + 1) % corners.len()];
            let edge = [from.min(to), from.max(to)];
            if from != to {
                let runs = runs.entry(edge).or_insert_with(|| {
                    edges.push(edge);
                    Runs::default()
                });
                runs.add(from, to);
            }
        }
        edges.retain(|edge| runs[edge].count % 2 == 1 || runs[edge].net != 0);
        Self {
            places,
            first,
            edges,
            runs,
        }
    }
}

/// The triangulation, and how the polygon runs along its edges.
struct Plane {
    delaunay: Delaunay,
    runs: HashMap<[usize; 2], Runs>,
    /// Corners where edges cross: the ends of one of them, and how far it is from one to the other.
    added: Vec<([usize; 2], f64)>,
}

impl Plane {
    fn new(outline: &Outline) -> Option<Self> {
        let delaunay = Delaunay::bulk_load_cdt(outline.places.clone(), Vec::new()).ok()?;
        (delaunay.num_vertices() == outline.places.len()).then(|| Self {
            delaunay,
            runs: HashMap::new(),
            added: Vec::new(),
        })
    }

    fn place(&self, corner: usize) -> DVec2 {
        let Point2 { x, y } = self.delaunay.vertex(handle(corner)).position();
        DVec2::new(x, y)
    }

    /// Makes an edge one of the triangulation, in several pieces where it meets corners or other edges, and notes how
    /// the polygon runs along it. `None` if that cannot be followed for rounding.
    fn draw(&mut self, from: usize, to: usize, runs: Runs) -> Option<()> {
        let before = self.delaunay.num_vertices();
        let pieces = self
            .delaunay
            .add_constraint_and_split(handle(from), handle(to), Corner);
        let pieces: Vec<[usize; 2]> = pieces.into_iter().map(|piece| self.ends(piece)).collect();
        let is_chain = pieces.windows(2).all(|pair| pair[0][1] == pair[1][0]);
        if pieces.first()?[0] != from || pieces.last()?[1] != to || !is_chain {
            return None;
        }
        for &[_, corner] in pieces.iter().filter(|piece| piece[1] >= before) {
            self.split(corner, &pieces)?;
        }
        for corner in before..self.delaunay.num_vertices() {
            let [start, end, here] = [from, to, corner].map(|corner| self.place(corner));
            let along = end - start;
            let at = (here - start).dot(along) / along.length_squared();
            self.added.push(([from, to], at.clamp(0.0, 1.0)));
        }
        for [a, b] in pieces {
            let known = self.runs.entry([a.min(b), a.max(b)]).or_default();
            *known = known.joined(runs, a > b);
        }
        Some(())
    }

    /// Hands on what is known of an edge to its halves: this corner was put between them by these pieces of another.
    fn split(&mut self, corner: usize, pieces: &[[usize; 2]]) -> Option<()> {
        let vertex = self.delaunay.vertex(handle(corner));
        let edges = vertex.out_edges().filter(|edge| edge.is_constraint_edge());
        let ends = edges.map(|edge| edge.to().fix().index());
        let ends: Vec<usize> = ends
            .filter(|&end| !pieces.contains(&[end, corner]) && !pieces.contains(&[corner, end]))
            .collect();
        let &[a, b] = &ends[..] else { return None };
        let [low, high] = [a.min(b), a.max(b)];
        let runs = self.runs.remove(&[low, high])?;
        // The corner is newer than both ends, so it is the higher one.
        self.runs.insert([low, corner], runs);
        self.runs
            .insert([high, corner], Runs::default().joined(runs, true));
        Some(())
    }

    fn ends(&self, piece: FixedDirectedEdgeHandle) -> [usize; 2] {
        let edge = self.delaunay.directed_edge(piece);
        [edge.from(), edge.to()].map(|end| end.fix().index())
    }

    /// The triangles within. `None` if it depends on the way there whether one is.
    fn within(&self) -> Option<Vec<[usize; 3]>> {
        let turns = self.turns()?;
        let faces = self.delaunay.inner_faces();
        let faces = faces.map(|face| {
            let corners = face.vertices().map(|vertex| vertex.fix().index());
            (corners, turns[face.fix().index()])
        });
        let faces: Vec<([usize; 3], Runs)> = faces.collect();
        let taken = |is_within: fn(&Runs) -> bool| -> Vec<[usize; 3]> {
            let within = faces.iter().filter(|(_, turns)| is_within(turns));
            let facing = within.map(|&([a, b, c], turns)| match turns.net < 0 {
                true => [a, c, b],
                false => [a, b, c],
            });
            facing.collect()
        };
        let odd = taken(|turns| turns.count % 2 == 1);
        // An outline that is run along twice would have nothing within.
        Some(match odd.is_empty() {
            true => taken(|turns| turns.net != 0),
            false => odd,
        })
    }

    /// How often, for each face, a way to it from outside crosses the polygon, and how often the polygon runs around
    /// it counter-clockwise.
    fn turns(&self) -> Option<Vec<Runs>> {
        let mut turns: Vec<Option<Runs>> = vec![None; self.delaunay.num_all_faces()];
        turns[self.delaunay.outer_face().fix().index()] = Some(Runs::default());
        let hull = self.delaunay.convex_hull();
        let outside = hull.map(|edge| {
            if edge.face().is_outer() {
                edge
            } else {
                edge.rev()
            }
        });
        let mut open: Vec<Edge> = outside.collect();
        while let Some(edge) = open.pop() {
            let here = turns[edge.face().fix().index()]?;
            let there = self.beyond(here, edge);
            let face = edge.rev().face();
            match &mut turns[face.fix().index()] {
                Some(known) if known.count % 2 == there.count % 2 && known.net == there.net => {}
                Some(_) => return None,
                unknown => {
                    *unknown = Some(there);
                    let edges = face.as_inner().map(|face| face.adjacent_edges());
                    open.extend(edges.into_iter().flatten());
                }
            }
        }
        turns.into_iter().collect()
    }

    /// What holds to the right of an edge, if this holds to its left.
    fn beyond(&self, left: Runs, edge: Edge) -> Runs {
        let [from, to] = [edge.from(), edge.to()].map(|end| end.fix().index());
        let runs = self.runs.get(&[from.min(to), from.max(to)]).copied();
        left.joined(runs.unwrap_or_default(), from < to)
    }
}

fn handle(corner: usize) -> FixedVertexHandle {
    FixedVertexHandle::from_index(corner)
}
