//! The inside of a polygon by the even-odd rule, as triangles. They come from a Delaunay triangulation that has the
//! polygon's edges among its own. Edges may touch, overlap and cross. Every corner stays a corner, so that neighbouring
//! polygons that share one leave no gap.

use std::collections::HashMap;

use glam::{DVec2, DVec3};
use spade::handles::{DirectedEdgeHandle, FixedDirectedEdgeHandle, FixedVertexHandle};
use spade::{CdtEdge, ConstrainedDelaunayTriangulation, Intersection, LineIntersectionIterator};
use spade::{Point2, Triangulation};

use super::cover::{Cover, Point};
use super::outline::{Edge, Outline, Runs};

type Delaunay = ConstrainedDelaunayTriangulation<Point2<f64>>;
type Side<'a> = DirectedEdgeHandle<'a, Point2<f64>, (), CdtEdge<()>, ()>;

/// How often edges are cut where they cross. Once is enough, except where rounding moves a piece across another.
const MOST_CUTS: usize = 8;

/// Edges with at most so many edges in their way cost next to nothing.
const FEW: usize = 256;

/// The work that may still be spent on edges with many others in their way. Edges of corners in one long row take a
/// time that grows with the square of their number, and a model may have many such rows.
pub(super) struct Effort(usize);

impl Default for Effort {
    /// About a second of work.
    fn default() -> Self {
        Self(1 << 25)
    }
}

/// Covers a polygon. `flat` has its corners on a plane, `places` has them in space.
pub(super) fn cover(flat: &[DVec2], places: &[DVec3], effort: &mut Effort) -> Cover {
    let mut outline = Outline::new(flat);
    // A polygon that goes to and fro more often than this is noise.
    if outline.spikes > 64 + flat.len() / 256 {
        return Cover::Tangled;
    }
    for cuts in 0..=MOST_CUTS {
        match Plane::of(&outline, effort) {
            Drawn::Whole(plane) => {
                return match plane.within() {
                    Some(within) => named(&outline, &within, places, cuts > 0),
                    None => Cover::Tangled,
                };
            }
            Drawn::Crossed if outline.cut().is_some() => {}
            Drawn::Crossed | Drawn::Tangled => break,
        }
    }
    Cover::Tangled
}

/// The triangles, with the polygon's numbers of its corners.
fn named(outline: &Outline, within: &[[usize; 3]], places: &[DVec3], crossed: bool) -> Cover {
    let own = outline.first.len();
    let name = |corner: usize| match corner.checked_sub(own) {
        None => outline.first[corner],
        Some(added) => places.len() + added,
    };
    let triangles = within.iter().map(|triangle| triangle.map(name));
    let added = outline.added.iter().map(|crossing| {
        let [a, b] = crossing.between.map(|corner| places[corner]);
        Point {
            place: a.lerp(b, crossing.at),
            between: crossing.between,
            at: crossing.at,
        }
    });
    Cover::Triangles {
        triangles: triangles.collect(),
        added: added.collect(),
        crossed,
    }
}

/// An outline in a triangulation, and how the polygon runs along the triangulation's edges.
struct Plane {
    delaunay: Delaunay,
    runs: HashMap<[usize; 2], Runs>,
}

/// The result of drawing an outline.
enum Drawn {
    Whole(Plane),
    /// Two edges of it cross.
    Crossed,
    /// Its edges run over each other too often; it is noise.
    Tangled,
}

impl Plane {
    fn of(outline: &Outline, effort: &mut Effort) -> Drawn {
        let places = outline.places.iter();
        let places: Vec<Point2<f64>> = places.map(|place| Point2::new(place.x, place.y)).collect();
        let count = places.len();
        // Many corners on a line would take quadratic time if they were inserted all at once.
        let (turning, others) = places.split_at(outline.turning);
        let Ok(mut delaunay) = Delaunay::bulk_load_cdt(turning.to_vec(), Vec::new()) else {
            return Drawn::Tangled;
        };
        for &place in others {
            if delaunay.insert(place).is_err() {
                return Drawn::Tangled;
            }
        }
        if delaunay.num_vertices() != count {
            return Drawn::Tangled;
        }
        let mut plane = Self {
            delaunay,
            runs: HashMap::new(),
        };
        // This bounds the number of pieces: a few edges may have corners on them, but not each edge all corners.
        let mut left = 8 * count + 256;
        for edge in &outline.edges {
            if plane.pay(edge, effort).is_none() {
                return Drawn::Tangled;
            }
            let pieces = plane.draw(edge);
            if pieces == 0 {
                return Drawn::Crossed;
            }
            let Some(rest) = left.checked_sub(pieces) else {
                return Drawn::Tangled;
            };
            left = rest;
        }
        Drawn::Whole(plane)
    }

    /// Adds an edge to the triangulation, in several pieces if there are corners on it, and notes how the polygon runs
    /// along the pieces. Returns the number of pieces, or 0 if the edge crosses another.
    fn draw(&mut self, edge: &Edge) -> usize {
        let [from, to] = edge.ends.map(FixedVertexHandle::from_index);
        let pieces = self.delaunay.try_add_constraint(from, to);
        for &piece in &pieces {
            let [a, b] = self.ends(piece);
            let known = self.runs.entry([a.min(b), a.max(b)]).or_default();
            *known = known.joined(edge.runs, a > b);
        }
        pieces.len()
    }

    /// Spends the work of drawing an edge, which is the squared number of edges in its way. `None` if more is needed
    /// than is left.
    fn pay(&self, edge: &Edge, effort: &mut Effort) -> Option<()> {
        let [from, to] = edge.ends.map(FixedVertexHandle::from_index);
        let met = LineIntersectionIterator::new_from_handles(&self.delaunay, from, to);
        let crossed = met.filter(|met| matches!(met, Intersection::EdgeIntersection(_)));
        let count = crossed.count();
        if count > FEW {
            effort.0 = effort.0.checked_sub(count * count)?;
        }
        Some(())
    }

    fn ends(&self, piece: FixedDirectedEdgeHandle) -> [usize; 2] {
        ends(self.delaunay.directed_edge(piece))
    }

    /// The triangles inside. `None` if it depends on the path whether a triangle is inside.
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
        // An outline that the polygon follows twice would have no inside.
        Some(match odd.is_empty() {
            true => taken(|turns| turns.net != 0),
            false => odd,
        })
    }

    /// For each face, how often a path to it from outside crosses the polygon, and how often the polygon runs around it
    /// counter-clockwise.
    fn turns(&self) -> Option<Vec<Runs>> {
        let mut turns: Vec<Option<Runs>> = vec![None; self.delaunay.num_all_faces()];
        turns[self.delaunay.outer_face().fix().index()] = Some(Runs::default());
        let hull = self.delaunay.convex_hull();
        let outside = hull.map(|side| match side.face().is_outer() {
            true => side,
            false => side.rev(),
        });
        let mut open: Vec<Side> = outside.collect();
        while let Some(side) = open.pop() {
            let here = turns[side.face().fix().index()]?;
            let there = self.beyond(here, side);
            let face = side.rev().face();
            match &mut turns[face.fix().index()] {
                Some(known) if known.count % 2 == there.count % 2 && known.net == there.net => {}
                Some(_) => return None,
                unknown => {
                    *unknown = Some(there);
                    let sides = face.as_inner().map(|face| face.adjacent_edges());
                    open.extend(sides.into_iter().flatten());
                }
            }
        }
        turns.into_iter().collect()
    }

    /// The same numbers to the right of a side, from those to its left.
    fn beyond(&self, left: Runs, side: Side) -> Runs {
        let [from, to] = ends(side);
        let runs = self.runs.get(&[from.min(to), from.max(to)]).copied();
        left.joined(runs.unwrap_or_default(), from < to)
    }
}

fn ends(side: Side) -> [usize; 2] {
    [side.from(), side.to()].map(|end| end.fix().index())
}
