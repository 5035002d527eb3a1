//! The options of A-buffers, by name.

use super::super::choice::{AS_PRINTED, Choice, LITERAL, Setter, Takes, number, read};
use super::options::{ABufferOptions, ArraySort, Fill, Keep, Manager, RecordColor};
use crate::steps::Reading;
use crate::words::{Words, words};

pub(super) const CHOICES: &[Setter<ABufferOptions>] = &[
    ARRAY.of(|o| &mut o.array),
    KEEP.of(|o| &mut o.keep),
    PEEL.of(|o| &mut o.peel),
    MOST_SUBPASSES.by(|o, text| {
        o.most_subpasses = Some(number(text)?);
        Ok(())
    }),
    TERMINATION.of(|o| &mut o.termination),
    BUDGET.by(|o, text| {
        let mebibytes: u64 = number(text)?;
        o.budget = Some(mebibytes.saturating_mul(1 << 20));
        Ok(())
    }),
    FIXED_LAYERS.by(|o, text| {
        o.fixed_layers = Some(number(text)?);
        Ok(())
    }),
    FILL.of(|o| &mut o.fill),
    ARRAY_SORT.of(|o| &mut o.sort),
    RECORD_COLOR.of(|o| &mut o.color),
    AS_PRINTED.by(|o, _| read(&mut o.reading, Reading::AsPrinted)),
    LITERAL.by(|o, _| read(&mut o.reading, Reading::Literal)),
];

const ARRAY: Choice = Choice {
    name: "array",
    takes: Takes::Value("N"),
    help: "The number of fragments that the local array holds: 8, 16, 32 ... 256. Fragments that a static array cannot \
           hold are lost, and counted",
};

const KEEP: Choice = Choice {
    name: "keep",
    takes: Takes::Word(Keep::WORDS),
    help: "The fragments that a full local array keeps if nothing peels the rest. The paper leaves it open",
};
words! { Keep, "rule for a full array",
    First "first" "The first fragments of the list. With ffb and dfb they were submitted first, with ppll last",
    Nearest "nearest" "The nearest fragments. The image is then that of the nearest N",
}

const PEEL: Choice = Choice {
    name: "peel",
    takes: Takes::Value("N"),
    help: "The number of fragments that ppDP peels at a time, 1 to 64",
};

const MOST_SUBPASSES: Choice = Choice {
    name: "most-subpasses",
    takes: Takes::Value("N"),
    help: "The most subpasses that ppDP takes for a pixel. What lies behind them is lost, and counted [default: no limit]",
};

const TERMINATION: Choice = Choice {
    name: "termination",
    takes: Takes::Value("0..1"),
    help: "End a ray when less light than this comes through. 0 is exact; the paper has 0.02",
};

const BUDGET: Choice = Choice {
    name: "budget",
    takes: Takes::Value("MIB"),
    help: "The most MiB that fragment lists may take. An image that needs more is rendered in horizontal bands. Without \
           it, lists take as many as are quick: on llvmpipe 8, and more for many triangles",
};

const FIXED_LAYERS: Choice = Choice {
    name: "fixed-layers",
    takes: Takes::Value("N"),
    help: "For ffb, give every pixel room for N fragments, and do not count them in a pass of its own. Fragments for which \
           there is no room are lost, and counted [default: count first, and have room for all]",
};

// It is no option: the methods' names begin with it.
words! { Manager, "memory manager",
    Ffb "ffb" "Fixed Fragment Buffer",
    Dfb "dfb" "Dynamic Fragment Buffer",
    Ppll "ppll" "Per-Pixel Linked Lists",
}

const FILL: Choice = Choice {
    name: "fill",
    takes: Takes::Word(Fill::WORDS),
    help: "How lists are filled",
};
words! { Fill, "way to fill lists",
    Automatic "automatic" "Ordered where the driver has it, otherwise atomics",
    Atomics "atomics" "Image atomics, as the paper has it",
    Ordered "ordered" "Framebuffer fetch, by which a pixel's fragments come in order",
}

const ARRAY_SORT: Choice = Choice {
    name: "array-sort",
    takes: Takes::Word(ArraySort::WORDS),
    help: "How local arrays are sorted. The result is the same",
};
words! { ArraySort, "sort of local arrays",
    Automatic "automatic" "The quicker sort for the scene",
    Insertion "insertion" "Insertion sort, as the paper has it",
    Network "network" "A network of comparators",
}

const RECORD_COLOR: Choice = Choice {
    name: "record-color",
    takes: Takes::Word(RecordColor::WORDS),
    help: "How fragment records keep colours",
};
words! { RecordColor, "format of a record's colour",
    Half "half" "Four 16-bit floats, as the paper has it",
    Float "float" "Four 32-bit floats",
    Fixed "fixed" "24 bits each from 0 to 1, for surfaces, where lists are filled in order",
}
