//! Section 4's static Local Array, and sections 5.1 and 5.2: ppAO and ppDP as the paper prints them, with their
//! corrections.

use crate::lists;
use crate::steps::pseudo::Pseudocode;
use crate::steps::pseudo::list::ListLine;
use crate::steps::{Amendment, Kind};

/// The static Local Array: "allocate a fixed sized array, of size N per thread". "All fragments beyond this number are
/// discarded": beyond it in the Fragment List, whose order the paper leaves open. As the lists of figure 4 are filled
/// and walked, FFB and DFB keep the fragments that came first. A list of PPLL begins at its newest node, so PPLL keeps
/// the fragments that came last.
pub const STATIC_ARRAY: Pseudocode<ListLine> = Pseudocode {
    title: "Static Local Array",
    source: "Lindholm et al. 2015, section 4, Managing Local GPU Caches",
    lines: lists! {
        prose "allocate a fixed sized array, of size N per thread";
        forall pixels do {
            spelt "resolve pixel with Local Array of size N;";
            resolve segment with Local Array;
        }
    },
};

/// A pixel with more fragments than its array keeps the nearest, which hide the others, instead of those that the
/// list's order gives. It takes one subpass of ppDP.
pub const NEAREST: Pseudocode<ListLine> = Pseudocode {
    title: "Static Local Array of the nearest",
    source: "onionskin",
    lines: lists! {
        edition "one subpass of ppDP";
        input list of fragments;
        n <- sizeof Local Array;
        create buffer with n elements;
        foreach fragment f do {
            insert f by depth, then id;
            note "store at most n elements";
            note "drop last element on overflow";
        }
        resolve buffer;
    },
};

/// To [`STATIC_ARRAY`], if the nearest are to be kept.
pub const KEEP_NEAREST: Amendment<ListLine> = Amendment {
    key: "L09",
    kind: Kind::Edition,
    place: "section 4, all fragments beyond this number are discarded",
    printed: lists! { resolve segment with Local Array; },
    amended: lists! { resolve segment by NEAREST; },
    why: "what is dropped is the farthest, whatever the list's order: in a full array a nearer fragment takes its place",
    test: "l09_keeping_the_nearest_gives_the_oracle_s_image_of_the_nearest_n",
};

/// per-pixel Array Optimization, as printed.
pub const PP_AO: Pseudocode<ListLine> = Pseudocode {
    title: "per-pixel Array Optimization",
    source: "Lindholm et al. 2015, section 5.1",
    lines: lists! {
        printed;
        note "Fill Step";
        forall pixels do {
            count depth complexity;
        }
        note "Resolve Step, loop over all complexity segments";
        foreach segment i do {
            activate shader program;
            forall unresolved pixels do {
                note "mask pixel if not part of segment class i";
                if (depth complexity <= i) then {
                    resolve segment with Local Array;
                    mark pixel as resolved;
                }
            }
        }
    },
};

/// per-pixel Depth Peeling, as printed.
pub const PP_DP: Pseudocode<ListLine> = Pseudocode {
    title: "per-pixel Depth Peeling",
    source: "Lindholm et al. 2015, section 5.2",
    lines: lists! {
        printed;
        input list of fragments;
        n <- sizeof Local Array;
        create buffer with n elements;
        set min depth to 0;
        initialize current state;
        note "Resolve Step";
        repeat {
            foreach fragment f do {
                if (depth <= min depth) then {
                    skip f;
                } else {
                    insert f by depth;
                    note "store at most n elements";
                    note "drop last element on overflow";
                }
            }
            resolve buffer;
            store min depth of last buffer element;
            clear buffer;
        } until all fragments are resolved;
    },
};

/// The corrections of ppDP.
pub const PP_DP_AMENDMENTS: [Amendment<ListLine>; 4] = [START, SKIP_BY_ID, STORE_ID, STOP];

/// Erratum LX04.
pub const START: Amendment<ListLine> = Amendment {
    key: "LX04",
    kind: Kind::Correction,
    place: "section 5.2, set min depth to 0",
    printed: lists! { set min depth to 0; },
    amended: lists! { set min depth before all; },
    why: "what lies at depth 0 must not be skipped",
    test: "l13_what_lies_at_depth_0_is_skipped_as_printed",
};

/// Erratum LX01.
pub const SKIP_BY_ID: Amendment<ListLine> = Amendment {
    key: "LX01",
    kind: Kind::Correction,
    place: "section 5.2, if depth(f) ≤ min depth",
    printed: lists! {
        if (depth <= min depth) then {
            skip f;
        } else {
            insert f by depth;
            note "store at most n elements";
            note "drop last element on overflow";
        }
    },
    amended: lists! {
        if ((depth, id) <= (min depth, min id)) then {
            skip f;
        } else {
            insert f by depth, then id;
            note "store at most n elements";
            note "drop last element on overflow";
        }
    },
    why: "of equal depths only some may have been resolved: the id tells which",
    test: "l13_ties_are_lost_where_a_buffer_ends_as_printed",
};

/// Erratum LX01, where the next subpass begins.
pub const STORE_ID: Amendment<ListLine> = Amendment {
    key: "LX01",
    kind: Kind::Correction,
    place: "section 5.2, store min depth",
    printed: lists! { store min depth of last buffer element; },
    amended: lists! { store min depth and id of last buffer element; },
    why: "the id decides between equal depths",
    test: "l13_ties_are_lost_where_a_buffer_ends_as_printed",
};

/// Erratum LX03. The printed condition, read as a count, never holds once a fragment is lost. But what is processed is told
/// by min depth alone: then nothing is left behind min depth as soon as a subpass has dropped nothing. With LX01 and LX04
/// none is lost, and either end will do.
pub const STOP: Amendment<ListLine> = Amendment {
    key: "LX03",
    kind: Kind::Filling(
        "Section 5.2: \"only the minimal depth is used to distinguish processed fragments from fragments yet to be resolved\"",
    ),
    place: "section 5.2, until all fragments are resolved",
    printed: lists! { until all fragments are resolved; },
    amended: lists! {
        printed;
        spelt "until all fragments f ∈ fragment list are resolved;";
        until no element was dropped;
    },
    why: "a subpass that has dropped nothing is the last",
    test: "l13_a_loop_that_waits_for_a_lost_fragment_never_ends",
};

/// Erratum LX02: "the process sorts n-1 elements in the Fragment List per subpass", but min depth is that "of last buffer
/// element". This is from the text beside the pseudocode.
pub const AS_THE_TEXT_SAYS: Amendment<ListLine> = Amendment {
    key: "LX02",
    kind: Kind::Prose("the process sorts n−1 elements in the Fragment List per subpass"),
    place: "section 5.2, resolve buffer",
    printed: lists! { resolve buffer; },
    amended: lists! { resolve buffer, on overflow its first n - 1 elements; },
    why: "the text resolves n-1",
    test: "l12_n_minus_1_a_pass_but_going_on_from_the_nth_loses_one_a_pass",
};

/// The text's n-1 fragments per subpass, corrected: all of [`PP_DP_AMENDMENTS`], and each subpass goes on from the last
/// fragment that was resolved. It needs an n of at least 2.
pub const N_MINUS_1: [Amendment<ListLine>; 5] = [
    START,
    SKIP_BY_ID,
    AS_THE_TEXT_SAYS,
    Amendment {
        amended: lists! { store min depth and id of last resolved element; },
        key: "LX02",
        kind: Kind::Correction,
        why: "the n-th was not resolved",
        ..STORE_ID
    },
    STOP,
];

/// Erratum LX05. What overflows the last segment's array is dropped, as by a static array.
pub const PP_AO_AMENDMENT: Amendment<ListLine> = Amendment {
    key: "LX05",
    kind: Kind::Correction,
    place: "section 5.1, if depth complexity(p) <= i",
    printed: lists! {
        if (depth complexity <= i) then {
            resolve segment with Local Array;
            mark pixel as resolved;
        }
    },
    amended: lists! {
        if (depth complexity <= i or i = max) then {
            resolve segment with Local Array;
            mark pixel as resolved;
        }
    },
    why: "what no segment holds is the last one's",
    test: "l11_past_the_last_segment_nothing_is_resolved_as_printed",
};

/// The same with ppDP, which peels what overflows the last segment's array.
pub const PP_AO_WITH_PP_DP: Amendment<ListLine> = Amendment {
    amended: lists! {
        if (depth complexity <= i or i = max) then {
            if (depth complexity > i) then {
                resolve segment by PP_DP amended by &PP_DP_AMENDMENTS;
            } else {
                resolve segment with Local Array;
            }
            mark pixel as resolved;
        }
    },
    why: "what no segment holds is the last one's, and is peeled there",
    ..PP_AO_AMENDMENT
};

/// The same with the last segment's array as [`KEEP_NEAREST`] has it.
pub const PP_AO_KEEPING_NEAREST: Amendment<ListLine> = Amendment {
    amended: lists! {
        if (depth complexity <= i or i = max) then {
            if (depth complexity > i) then {
                resolve segment by NEAREST;
            } else {
                resolve segment with Local Array;
            }
            mark pixel as resolved;
        }
    },
    why: "what no segment holds is the last one's, which keeps the nearest",
    test: "l09_keeping_the_nearest_gives_the_oracle_s_image_of_the_nearest_n",
    ..PP_AO_AMENDMENT
};

/// Section 6.2: "the ppAO component is implemented using an 8bit stencil buffer", counted up with `counter`, masked
/// with the stencil function, marked with a stencil operation that the paper does not name.
pub const fn by_stencil(
    counter: &'static [ListLine],
    masked: &'static [ListLine],
) -> [Amendment<ListLine>; 2] {
    [
        Amendment {
            key: "LX16",
            kind: Kind::Prose("the ppAO component is implemented using an 8bit stencil buffer"),
            place: "section 5.1, count depth complexity",
            printed: lists! { count depth complexity; },
            amended: counter,
            why: "implemented using an 8-bit stencil buffer",
            test: "l11_eight_bits_send_what_is_past_255_to_the_wrong_segment",
        },
        Amendment {
            key: "LX07",
            kind: Kind::Prose("the ppAO component is implemented using an 8bit stencil buffer"),
            place: "section 5.1, if depth complexity(p) <= i",
            amended: masked,
            why: "different segments are triggered by the stencil function",
            test: "l11_of_the_marks_only_invert_works_and_only_up_to_128",
            ..PP_AO_AMENDMENT
        },
    ]
}
