//! `multi_layer/insert.frag`: a fragment becomes a node, and if that is one too many, the two farthest are merged.

use super::node::{NO_DEPTH, Node, merged, node_of, texel_of};
use crate::low_level::emulator::color::Texel;
use crate::low_level::emulator::invocation::{Inputs, Kept, Outputs};

fn insert(nodes: &mut [[u32; 4]], mut farther: [u32; 4]) {
    let mut moves = false;
    for node in nodes.iter_mut() {
        moves = moves || farther[0] < node[0];
        if moves {
            std::mem::swap(node, &mut farther);
        }
    }
    if let (Some(last), true) = (nodes.last_mut(), farther[0] != NO_DEPTH) {
        *last = texel_of(merged(node_of(*last), node_of(farther)));
    }
}

pub(in super::super) fn main(i: &Inputs<'_>) -> Outputs {
    let [r, g, b, a] = i.surface_color();
    let node = texel_of(Node {
        depth: i.depth().to_bits(),
        color: [r * a, g * a, b * a],
        transmittance: 1.0 - a,
    });
    let by_images = i.is("IMAGES");
    let node_of_pixel = |number: u32| match by_images {
        true => i.image(number).integers(),
        false => i.fetched(number as usize).integers(),
    };
    let mut nodes: Vec<_> = (0..i.define("NODES")).map(node_of_pixel).collect();
    insert(&mut nodes, node);
    let nodes = nodes.into_iter().map(Texel::Integers);
    let mut kept = Kept::default();
    match by_images {
        true => kept.images = (0..).zip(nodes).collect(),
        false => kept.colors = nodes.collect(),
    }
    Some(kept)
}
