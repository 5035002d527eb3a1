//! The nodes of multi-layer alpha blending, by the fragments in them.

use crate::emulator::Fate;
use crate::steps::Texel;

/// The program that makes nodes of fragments.
pub(super) const INSERTS: &str = "multi_layer/insert";

/// The depth of an empty node.
const EMPTY: u32 = u32::MAX;

/// A node: the bits of its depth, and the fragments that were merged into it, nearest first.
type Node = (u32, Vec<u32>);

/// The nodes after each fragment, each as the fragments in it.
///
/// It is read off the depths that the nodes have before and after a fragment. A depth that has gone was that of a node which
/// was merged into the farthest.
pub(super) fn after_each(fates: &[Fate]) -> Vec<Vec<Vec<u32>>> {
    let mut nodes: Vec<Node> = Vec::new();
    let mut all = Vec::new();
    for fate in fates {
        let mut before = nodes.clone();
        let depth = fate.depth.to_bits();
        let behind = before.partition_point(|(other, _)| *other <= depth);
        before.insert(behind, (depth, vec![fate.order]));
        nodes = Vec::new();
        for depth in depths(fate) {
            if let Some(at) = before.iter().position(|(other, _)| *other == depth) {
                nodes.push(before.remove(at));
            }
        }
        if let Some((_, merged)) = nodes.last_mut() {
            merged.extend(before.into_iter().flat_map(|(_, fragments)| fragments));
        }
        all.push(
            nodes
                .iter()
                .map(|(_, fragments)| fragments.clone())
                .collect(),
        );
    }
    all
}

/// The depths of the nodes after a fragment, nearest first. They are images or color maps.
fn depths(fate: &Fate) -> Vec<u32> {
    let images = fate.images.iter().map(|(_, [_, after])| after);
    let texels = images.chain(fate.colors.iter().map(|[_, after]| after));
    let depths = texels.filter_map(|texel| match texel {
        Texel::Integers([depth, ..]) if *depth != EMPTY => Some(*depth),
        _ => None,
    });
    depths.collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::emulator::FragmentOutcome;

    /// A fragment after which nodes have these depths.
    fn fate(order: u32, depth: f32, nodes: [Option<f32>; 2]) -> Fate {
        let texel = |depth: Option<f32>| {
            let depth = depth.map_or(EMPTY, f32::to_bits);
            [Texel::Integers([0; 4]), Texel::Integers([depth, 0, 0, 0])]
        };
        Fate {
            order,
            depth,
            outcome: FragmentOutcome::Pass,
            stencil: [0; 2],
            stored_depth: [1.0; 2],
            colors: nodes.map(texel).into(),
            images: Vec::new(),
            list: None,
        }
    }

    #[test]
    fn fragments_are_in_nodes_by_depth_and_the_farthest_are_merged() {
        let fates = [
            fate(0, 0.5, [Some(0.5), None]),
            fate(1, 0.25, [Some(0.25), Some(0.5)]),
            fate(2, 0.375, [Some(0.25), Some(0.375)]),
            fate(3, 0.75, [Some(0.25), Some(0.375)]),
            // As near as the nearest: it goes behind it.
            fate(4, 0.25, [Some(0.25), Some(0.25)]),
        ];
        let expected: [Vec<Vec<u32>>; 5] = [
            vec![vec![0]],
            vec![vec![1], vec![0]],
            vec![vec![1], vec![2, 0]],
            vec![vec![1], vec![2, 0, 3]],
            vec![vec![1], vec![4, 2, 0, 3]],
        ];
        assert_eq!(after_each(&fates), expected);
    }
}
