//! Section 4's static Local Array; sections 5.1 and 5.2: ppAO and ppDP as the paper prints them, and what makes them
//! right.

use crate::steps::Amendment;
use crate::steps::pseudo::Algorithm;
use crate::steps::pseudo::list::{
    Counter, Element, End, Key, Line, Line::*, Mark, Start, Taken, Test,
};

/// The static Local Array: "allocate a fixed sized array, of size N per thread". "All fragments beyond this number are
/// discarded": beyond it in the Fragment List, whose order the paper leaves open. As the lists of figure 4 are filled and
/// walked, FFB and DFB keep those that came first, and PPLL, which begins at its newest node, those that came last.
pub const STATIC_ARRAY: Algorithm<Line> = Algorithm {
    title: "Static Local Array",
    source: "Lindholm et al. 2015, section 4, Managing Local GPU Caches",
    lines: &[Pixels(&[ResolveSegment])],
};

/// Which fragments a pixel keeps that has more of them than its array, said instead of left to the list's order: the
/// nearest, which hide the others. It takes one subpass of ppDP.
pub const NEAREST: Algorithm<Line> = Algorithm {
    title: "Static Local Array of the nearest",
    source: "onionskin",
    lines: &[
        Input,
        SizeOfLocalArray,
        CreateBuffer,
        Fragments(&[Insert(Key::DepthAndId), AT_MOST_N, DROP_LAST]),
        ResolveBuffer(Taken::All),
    ],
};

/// To [`STATIC_ARRAY`], if the nearest are to be kept.
pub const KEEP_NEAREST: Amendment<Line> = Amendment {
    key: "L09",
    place: "section 4, all fragments beyond this number are discarded",
    printed: &[ResolveSegment],
    amended: &[Run(&NEAREST, &[])],
    why: "what is dropped is the farthest, whatever the list's order: in a full array a nearer fragment takes its place",
    test: "l09_keeping_the_nearest_gives_the_oracle_s_image_of_the_nearest_n",
};

/// per-pixel Array Optimization, as printed.
pub const PP_AO: Algorithm<Line> = Algorithm {
    title: "per-pixel Array Optimization",
    source: "Lindholm et al. 2015, section 5.1",
    lines: &[
        Note("Fill Step"),
        Pixels(&[Count(Counter::Integer)]),
        Note("Resolve Step, loop over all complexity segments"),
        Segments(&[
            ActivateProgram,
            UnresolvedPixels(&[
                MASK,
                If(
                    Test::FitsSegment,
                    &[ResolveSegment, Mark(Mark::Resolved)],
                    &[],
                ),
            ]),
        ]),
    ],
};

/// per-pixel Depth Peeling, as printed.
pub const PP_DP: Algorithm<Line> = Algorithm {
    title: "per-pixel Depth Peeling",
    source: "Lindholm et al. 2015, section 5.2",
    lines: &[
        Input,
        SizeOfLocalArray,
        CreateBuffer,
        SetMin(Start::Zero),
        InitializeState,
        Note("Resolve Step"),
        Repeat(&[
            Fragments(&[If(
                Test::NotBehindMin(Key::Depth),
                &[Skip],
                &[Insert(Key::Depth), AT_MOST_N, DROP_LAST],
            )]),
            ResolveBuffer(Taken::All),
            Store(Key::Depth, Element::Last),
            ClearBuffer,
            Until(End::AllResolved),
        ]),
    ],
};

const MASK: Line = Note("mask pixel if not part of segment class i");
const AT_MOST_N: Line = Note("store at most n elements");
const DROP_LAST: Line = Note("drop last element on overflow");

/// What makes ppDP right.
pub const PP_DP_AMENDMENTS: [Amendment<Line>; 4] = [START, SKIP_BY_ID, STORE_ID, STOP];

/// Erratum L4.
pub const START: Amendment<Line> = Amendment {
    key: "L4",
    place: "section 5.2, set min depth to 0",
    printed: &[SetMin(Start::Zero)],
    amended: &[SetMin(Start::BeforeAll)],
    why: "what lies at depth 0 must not be skipped",
    test: "l13_what_lies_at_depth_0_is_skipped_as_printed",
};

/// Erratum L1.
pub const SKIP_BY_ID: Amendment<Line> = Amendment {
    key: "L1",
    place: "section 5.2, if depth(f) ≤ min depth",
    printed: &[If(
        Test::NotBehindMin(Key::Depth),
        &[Skip],
        &[Insert(Key::Depth), AT_MOST_N, DROP_LAST],
    )],
    amended: &[If(
        Test::NotBehindMin(Key::DepthAndId),
        &[Skip],
        &[Insert(Key::DepthAndId), AT_MOST_N, DROP_LAST],
    )],
    why: "of equal depths only some may have been resolved: the id tells which",
    test: "l13_ties_are_lost_where_a_buffer_ends_as_printed",
};

/// Erratum L1, where the next subpass begins.
pub const STORE_ID: Amendment<Line> = Amendment {
    key: "L1",
    place: "section 5.2, store min depth",
    printed: &[Store(Key::Depth, Element::Last)],
    amended: &[Store(Key::DepthAndId, Element::Last)],
    why: "the id decides between equal depths",
    test: "l13_ties_are_lost_where_a_buffer_ends_as_printed",
};

/// Erratum L3. What was printed, read as a count, never holds once a fragment is lost.
pub const STOP: Amendment<Line> = Amendment {
    key: "L3",
    place: "section 5.2, until all fragments are resolved",
    printed: &[Until(End::AllResolved)],
    amended: &[Until(End::NothingDropped)],
    why: "a subpass that has dropped nothing is the last",
    test: "l13_a_loop_that_waits_for_a_lost_fragment_never_ends",
};

/// Erratum L2: "the process sorts n-1 elements in the Fragment List per subpass", but min depth is that "of last buffer
/// element". So says the text beside the pseudocode.
pub const AS_THE_TEXT_SAYS: Amendment<Line> = Amendment {
    key: "L2",
    place: "section 5.2, resolve buffer",
    printed: &[ResolveBuffer(Taken::All)],
    amended: &[ResolveBuffer(Taken::AllButLastOnOverflow)],
    why: "the text resolves n-1",
    test: "l12_n_minus_1_a_pass_but_going_on_from_the_nth_loses_one_a_pass",
};

/// The text's n-1 a subpass made right: all of [`PP_DP_AMENDMENTS`], and going on from the last that was resolved. It
/// needs n of 2 and more.
pub const N_MINUS_1: [Amendment<Line>; 5] = [
    START,
    SKIP_BY_ID,
    AS_THE_TEXT_SAYS,
    Amendment {
        amended: &[Store(Key::DepthAndId, Element::LastResolved)],
        key: "L2",
        why: "the n-th was not resolved",
        ..STORE_ID
    },
    STOP,
];

/// What makes ppAO right, errata L5 to L7: a pixel belongs to one segment by its own count, which needs no mark; the
/// last segment takes every pixel that is left, and what is too many for its array is peeled.
pub const PP_AO_AMENDMENT: Amendment<Line> = Amendment {
    key: "L5, L6, L7",
    place: "section 5.1, if depth complexity(p) <= i",
    printed: &[If(
        Test::FitsSegment,
        &[ResolveSegment, Mark(Mark::Resolved)],
        &[],
    )],
    amended: &[If(
        Test::InSegment,
        &[If(
            Test::Overflows,
            &[Run(&PP_DP, &PP_DP_AMENDMENTS)],
            &[ResolveSegment],
        )],
        &[],
    )],
    why: "every pixel in one segment, none in two; what overflows the last is peeled",
    test: "l11_past_the_last_segment_nothing_is_resolved_as_printed",
};

/// The same without ppDP: what overflows the last segment's array is dropped.
pub const PP_AO_WITHOUT_PP_DP: Amendment<Line> = Amendment {
    amended: &[If(Test::InSegment, &[ResolveSegment], &[])],
    why: "every pixel in one segment, none in two; what overflows the last is dropped",
    test: "l09_without_pp_dp_the_last_segment_drops_what_overflows_it",
    ..PP_AO_AMENDMENT
};

/// Again without ppDP, with the last segment's array as [`KEEP_NEAREST`] has it.
pub const PP_AO_KEEPING_NEAREST: Amendment<Line> = Amendment {
    amended: &[If(
        Test::InSegment,
        &[If(
            Test::Overflows,
            &[Run(&NEAREST, &[])],
            &[ResolveSegment],
        )],
        &[],
    )],
    why: "every pixel in one segment, none in two; of what overflows the last the nearest are kept",
    test: "l09_keeping_the_nearest_gives_the_oracle_s_image_of_the_nearest_n",
    ..PP_AO_AMENDMENT
};

/// Section 6.2: "the ppAO component is implemented using an 8bit stencil buffer", counted up with `counter`, masked with
/// the stencil function, marked with a stencil operation of which the paper does not say which.
pub const fn by_stencil(counter: &'static [Line], masked: &'static [Line]) -> [Amendment<Line>; 2] {
    [
        Amendment {
            key: "6.2",
            place: "section 5.1, count depth complexity",
            printed: &[Count(Counter::Integer)],
            amended: counter,
            why: "implemented using an 8-bit stencil buffer",
            test: "l11_eight_bits_send_what_is_past_255_to_the_wrong_segment",
        },
        Amendment {
            key: "6.2",
            place: "section 5.1, if depth complexity(p) <= i",
            amended: masked,
            why: "different segments are triggered by the stencil function",
            test: "l11_of_the_marks_only_invert_works_and_only_up_to_128",
            ..PP_AO_AMENDMENT
        },
    ]
}
