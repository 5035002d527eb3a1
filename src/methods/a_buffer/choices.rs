//! The options of A-buffers, by name.

use super::super::choice::{AS_PRINTED, Choice, Setter, Takes, number, set, word};
use super::options::{ABufferOptions, ArraySort, Fill, Keep, RecordColor};

pub(super) const CHOICES: &[Setter<ABufferOptions>] = &[
    ARRAY.sets(|o, text| set(&mut o.array, number(text))),
    KEEP.sets(|o, text| set(&mut o.keep, word(text, &KEEPS))),
    PEEL.sets(|o, text| set(&mut o.peel, number(text))),
    TERMINATION.sets(|o, text| set(&mut o.termination, number(text))),
    BUDGET.sets(|o, text| {
        let mebibytes: u64 = number(text)?;
        set(&mut o.budget, Ok(Some(mebibytes.saturating_mul(1 << 20))))
    }),
    FILL.sets(|o, text| set(&mut o.fill, word(text, &FILLS))),
    ARRAY_SORT.sets(|o, text| set(&mut o.sort, word(text, &SORTS))),
    RECORD_COLOR.sets(|o, text| set(&mut o.color, word(text, &COLORS))),
    AS_PRINTED.sets(|o, _| set(&mut o.as_printed, Ok(true))),
];

const ARRAY: Choice = Choice {
    name: "array",
    takes: Takes::Value("N"),
    help: "The number of fragments that the local array holds: 8, 16, 32 ... 256. Fragments that a static array cannot \
           hold are lost, and counted [default: 64]",
};

const KEEP: Choice = Choice {
    name: "keep",
    takes: Takes::Word(&[
        (
            "first",
            "The first fragments of the list. With ffb and dfb they were submitted first, with ppll last",
        ),
        (
            "nearest",
            "The nearest fragments. The image is then that of the nearest N",
        ),
    ]),
    help: "The fragments that a full local array keeps if nothing peels the rest. The paper leaves it open [default: \
           first]",
};
const KEEPS: [(&str, Keep); 2] = [("first", Keep::First), ("nearest", Keep::Nearest)];

const PEEL: Choice = Choice {
    name: "peel",
    takes: Takes::Value("N"),
    help: "The number of fragments that ppDP peels at a time, 1 to 64 [default: 8]",
};

const TERMINATION: Choice = Choice {
    name: "termination",
    takes: Takes::Value("0..1"),
    help: "End a ray when less light than this comes through. The paper has 0.02 [default: 0, which is exact]",
};

const BUDGET: Choice = Choice {
    name: "budget",
    takes: Takes::Value("MIB"),
    help: "The most MiB that fragment lists may take. An image that needs more is rendered in horizontal bands \
           [default: as many as are quick, on llvmpipe 8, and more for many triangles]",
};

const FILL: Choice = Choice {
    name: "fill",
    takes: Takes::Word(&[
        ("atomics", "Image atomics, as the paper has it"),
        (
            "ordered",
            "Framebuffer fetch, by which a pixel's fragments come in order",
        ),
    ]),
    help: "How lists are filled [default: ordered where the driver has it]",
};
const FILLS: [(&str, Fill); 2] = [("atomics", Fill::Atomics), ("ordered", Fill::Ordered)];

const ARRAY_SORT: Choice = Choice {
    name: "array-sort",
    takes: Takes::Word(&[
        ("insertion", "Insertion sort, as the paper has it"),
        ("network", "A network of comparators"),
    ]),
    help: "How local arrays are sorted. The result is the same [default: the quicker sort for the scene]",
};
const SORTS: [(&str, ArraySort); 2] = [
    ("insertion", ArraySort::Insertion),
    ("network", ArraySort::Network),
];

const RECORD_COLOR: Choice = Choice {
    name: "record-color",
    takes: Takes::Word(&[
        ("half", "Four 16-bit floats, as the paper has it"),
        ("float", "Four 32-bit floats"),
    ]),
    help: "How fragment records keep colours [default: half]",
};
const COLORS: [(&str, RecordColor); 2] =
    [("half", RecordColor::Half), ("float", RecordColor::Float)];
