//! `multi_layer/node.glsl`: a node, which is one fragment or several that were merged, and its texel.

/// A node.
#[derive(Clone, Copy)]
pub(super) struct Node {
    /// The nearest one's bits.
    pub(super) depth: u32,
    /// Premultiplied.
    pub(super) color: [f32; 3],
    pub(super) transmittance: f32,
}

/// An empty node's depth, which lies behind every other.
pub(super) const NO_DEPTH: u32 = 0xFFFF_FFFF;

pub(super) const NOTHING: Node = Node {
    depth: NO_DEPTH,
    color: [0.0; 3],
    transmittance: 1.0,
};

/// 2^24 - 1
const STEPS: f32 = 16_777_215.0;

pub(super) fn texel_of(node: Node) -> [u32; 4] {
    let part = |value: f32| (value.clamp(0.0, 1.0) * STEPS).round_ties_even() as u32;
    let alpha = part(node.transmittance);
    let word = |channel: usize| {
        let byte = alpha >> (8 * channel) & 0xFF;
        part(node.color[channel]) | byte << 24
    };
    [node.depth, word(0), word(1), word(2)]
}

pub(super) fn node_of([depth, words @ ..]: [u32; 4]) -> Node {
    let [low, middle, high] = words.map(|word| word >> 24);
    Node {
        depth,
        color: words.map(|word| (word & 0xFF_FFFF) as f32 / STEPS),
        transmittance: (low | middle << 8 | high << 16) as f32 / STEPS,
    }
}

/// Two nodes as one, at the nearer one's depth.
pub(super) fn merged(near: Node, far: Node) -> Node {
    let channel = |channel: usize| near.color[channel] + near.transmittance * far.color[channel];
    Node {
        depth: near.depth,
        color: [0, 1, 2].map(channel),
        transmittance: near.transmittance * far.transmittance,
    }
}
