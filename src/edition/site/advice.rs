//! What a method does, when to take it, and when to take another one.

/// What is said of a method on its page.
pub(super) struct Advice {
    /// Its name, or what its name begins with up to a `+`.
    pub(super) name: &'static str,
    pub(super) does: &'static str,
    pub(super) take: &'static str,
    pub(super) leave: &'static str,
    /// Its listings.
    pub(super) listings: &'static [&'static str],
}

pub(super) const ADVICE: &[Advice] = &[
    Advice {
        name: "blend",
        does: "Draws the transparent triangles once, as they come, each over those before it.",
        take: "Nothing overlaps, or the triangles already come back to front from every point of view.",
        leave: "Surfaces overlap in any order. Then the image depends on the order of submission.",
        listings: &[],
    },
    Advice {
        name: "painter",
        does: "Sorts the triangles by the distance of their middles, and blends them back to front.",
        take: "Triangles are small and do not cross, and small errors do no harm.",
        leave: "Triangles cross each other, overlap in a circle, or differ much in size: no order of whole triangles is right then.",
        listings: &[],
    },
    Advice {
        name: "weighted-blended",
        does: "Adds all fragments up, each with a weight that falls with its depth, and takes the mean colour. One pass, no order.",
        take: "Speed counts and exactness does not: smoke, sparks, many faint layers of similar colours.",
        leave: "A nearly opaque surface of one colour lies before another colour. The mean shows what should be hidden.",
        listings: &["mcguire/weighted-blended"],
    },
    Advice {
        name: "multi-layer-alpha-blending",
        does: "Keeps the nearest four or eight fragments of each pixel sorted, and merges the others. One pass.",
        take: "Most pixels have few fragments, memory is bounded, and the driver has framebuffer fetch or interlock.",
        leave: "Pixels have more fragments than nodes and the image has to be exact.",
        listings: &["salvi/four-nodes"],
    },
    Advice {
        name: "depth-peeling",
        does: "Finds the layers one after the other, nearest first. Each pass draws the scene once and ignores the layers before.",
        take: "There are few layers, memory is short, and no two surfaces lie in the same plane.",
        leave: "Surfaces coincide, as doubled faces do: of fragments with equal depth only the first one is found, and the others are lost and counted.",
        listings: &["everitt/listing-1", "vtk/on-the-fly"],
    },
    Advice {
        name: "dual-depth-peeling",
        does: "Finds the nearest and the farthest layer that is left in each pass, so it takes half as many passes.",
        take: "As for depth peeling, but with more layers. Fragments of equal depth are all in the image.",
        leave: "There are tens of layers and memory for lists: an A-buffer draws the scene twice, whatever the number of layers.",
        listings: &["bavoil/dual-peeling"],
    },
    Advice {
        name: "coplanar-depth-peeling",
        does: "Peels, and takes all fragments of each depth in the order of submission.",
        take: "Surfaces coincide, memory is short, and their order matters.",
        leave: "There are many layers. It draws the scene nearly twice for each.",
        listings: &["vasilakis/coplanar-peeling"],
    },
    Advice {
        name: "layer-peeling",
        does: "Peels with two passes for each layer, by the depth tests of Carr, Měch and Miller. It is what they compare with.",
        take: "To compare with the coherent methods step by step.",
        leave: "For work: coplanar-depth-peeling and dual-depth-peeling do as much with less.",
        listings: &["carr/layer-peeling"],
    },
    Advice {
        name: "hybrid-layer-peeling",
        does: "Peels the unsorted surfaces, and blends sorted ones, such as a volume's slices, between them.",
        take: "Most of the scene is slices or sprites that a sort orders exactly, with a few surfaces among them.",
        leave: "Nothing in the scene is sorted, or volumes have to be exact: slices have an error of order 1 in their distance.",
        listings: &["carr/algorithm-1", "carr/hybrid"],
    },
    Advice {
        name: "coherent-layer-peeling-a",
        does: "Takes in each iteration the whole run of surfaces that came in the right order, and finds where it ends by counting in the stencil.",
        take: "Triangles are sorted roughly, there are many layers, and memory is short.",
        leave: "The order of submission is random: then a run is hardly longer than one layer, and each iteration has up to six passes.",
        listings: &["carr/coherent-a"],
    },
    Advice {
        name: "coherent-layer-peeling-b",
        does: "The same as A with fewer passes: two of them are one, by blending floating-point numbers.",
        take: "As for A.",
        leave: "As for A.",
        listings: &["carr/coherent-b", "carr/section-6"],
    },
    Advice {
        name: "ideal-coherent-layer-peeling",
        does: "Coherent layer peeling on a card whose shaders read the framebuffer: at most two passes an iteration. It was imagined in 2008, and runs today.",
        take: "The driver has framebuffer fetch or interlock, triangles are sorted roughly, and memory is short.",
        leave: "The driver has neither.",
        listings: &["carr/algorithm-2", "carr/ideal"],
    },
    Advice {
        name: "ffb",
        does: "Reserves for every pixel as much room as the deepest one needs, collects the fragments, and sorts each pixel's list.",
        take: "All pixels have about as many layers, and there is memory.",
        leave: "Few pixels are deep and most are not: nearly all of the room stays empty.",
        listings: &["lindholm/clear-and-fill", "lindholm/resolve"],
    },
    Advice {
        name: "dfb",
        does: "Counts the fragments first, so that every pixel's list has exactly its room, then collects and sorts.",
        take: "The usual choice for exact images: it draws the scene twice, whatever the number of layers.",
        leave: "Memory for all fragments is not there. onionskin then works in bands of the image, and draws once more for each.",
        listings: &["lindholm/clear-and-fill", "lindholm/resolve"],
    },
    Advice {
        name: "ppll",
        does: "Links each pixel's fragments by pointers, in the order in which they come, and sorts at the end.",
        take: "As for dfb, where atomics are quick.",
        leave: "Lists are long and read often: their records lie scattered in memory.",
        listings: &["lindholm/clear-and-fill", "lindholm/resolve"],
    },
    Advice {
        name: "verified-painter",
        does: "Sorts the triangles, blends them, and lets the depth test prove at each pixel whether the order was right. Pixels without a proof get lists.",
        take: "A sort is right nearly everywhere, as with slices or small triangles. The image is exact all the same.",
        leave: "Most pixels fail the proof: then the lists do the work, and the sort was in vain.",
        listings: &["edition/verified-painter", "edition/place-resolved"],
    },
    Advice {
        name: "auto",
        does: "Looks at the scene, chooses a quick exact method for it, and says which one and why.",
        take: "You want the exact image, and do not care how.",
        leave: "You compare methods, and need to know beforehand which one runs.",
        listings: &[],
    },
    Advice {
        name: "exact",
        does: "The oracle: collects every fragment, sorts and composites them in 64 bits, without OpenGL's blending.",
        take: "To check other images against it.",
        leave: "Speed counts.",
        listings: &[],
    },
];

/// What a component adds to an A-buffer.
pub(super) const COMPONENTS: [(&str, &str, &[&str]); 2] = [
    (
        "ppao",
        "With ppAO, pixels with few fragments get a program with a small local array, so that more of them run at once.",
        &["lindholm/section-5.1", "lindholm/pp-ao"],
    ),
    (
        "ppdp",
        "With ppDP, a list that is longer than the local array is read several times, so that no fragment is dropped.",
        &["lindholm/section-5.2"],
    ),
];

/// What is said of a method.
pub(super) fn of(name: &str) -> Option<&'static Advice> {
    let base = name.split('+').next();
    ADVICE.iter().find(|advice| Some(advice.name) == base)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::methods::registry;
    use crate::papers::texts;

    #[test]
    fn every_method_has_its_advice_and_no_other_has_any() {
        let mut named: Vec<_> = registry()
            .iter()
            .filter_map(|row| of(row.name))
            .map(|it| it.name)
            .collect();
        assert_eq!(named.len(), registry().len());
        named.dedup();
        let all: Vec<_> = ADVICE.iter().map(|it| it.name).collect();
        assert_eq!(named, all);
    }

    #[test]
    fn every_listing_that_is_named_is_there() {
        let all = ADVICE.iter().flat_map(|it| it.listings);
        for name in all.chain(COMPONENTS.iter().flat_map(|it| it.2)) {
            assert_eq!(texts(name).unwrap().len(), 1, "{name}");
        }
    }
}
