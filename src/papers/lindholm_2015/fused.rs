//! Section 6.1: the ray through a pixel, cast between the fragments of its list. The paper describes it in prose. Here
//! each sentence is a line, and amendments fill what the prose leaves open.

use super::components::{PP_DP, SKIP_BY_ID, START, STOP, STORE_ID};
use crate::lists;
use crate::steps::pseudo::Pseudocode;
use crate::steps::pseudo::list::ListLine;
use crate::steps::{Amendment, Kind};

/// "Ray casting of the scene is performed by sequentially looping over all entries in the Fragment List. Geometry fragments
/// are blended directly while volume rendering is performed for the interleaved ray segments. Volume occupancy is tracked
/// through a bitmask which is updated every time a fragment of a volume proxy geometry is encountered."
pub const FUSED: Pseudocode<ListLine> = Pseudocode {
    title: "Fused rendering: a ray cast between the fragments of the list",
    source: "Lindholm et al. 2015, section 6.1",
    lines: lists! {
        prose "all entries in the Fragment List can be interpreted as intersection points along the view rays";
        input list of fragments;
        prose "ray casting of the scene is performed in world space by sequentially looping over all entries";
        begin ray outside;
        foreach sorted fragment f do {
            prose "volume rendering is performed for the interleaved ray segments";
            cast ray up to f;
            prose "geometry fragments are blended directly to the buffer ... volume occupancy is tracked through a bitmask which is updated every time a fragment of a volume proxy geometry is encountered";
            if (f is of a proxy) then {
                toggle the volume of f;
            } else {
                blend f;
            }
        }
    },
};

/// The amendments for what the prose leaves open.
pub const FUSED_AMENDMENTS: [Amendment<ListLine>; 2] = [BEGIN_INSIDE, END_AT_OPAQUE];

/// The eye may be inside of a volume.
pub const BEGIN_INSIDE: Amendment<ListLine> = Amendment {
    key: "LX15",
    kind: Kind::Filling(
        "Section 6.1: occupancy \"is updated every time a fragment of a volume proxy geometry is encountered\", and none is where the eye is inside",
    ),
    place: "section 6.1, volume occupancy is tracked",
    printed: lists! { begin ray outside; },
    amended: lists! { begin ray inside what is only left; },
    why: "no fragment is encountered where a volume is entered that the eye is in",
    test: "l16_without_where_it_begins_a_ray_is_wrong_exactly_where_it_begins_inside",
};

/// Proxies behind the opaque surface must be in the list, so that it says where the ray begins.
pub const END_AT_OPAQUE: Amendment<ListLine> = Amendment {
    key: "LX15",
    kind: Kind::Filling(
        "Section 6.1: entries are \"intersection points along the view rays\", and rays end where nothing behind is seen",
    ),
    place: "section 6.1, the interleaved ray segments",
    printed: lists! { cast ray up to f; },
    amended: lists! { cast ray up to f or opaque depth; },
    why: "what lies behind the opaque surface is not seen",
    test: "l16_without_the_opaque_surface_a_ray_goes_on_behind_it",
};

/// The amendments to [`PP_DP`] for a scene with volumes: "to ensure consistency between the individual resolve passes,
/// we temporarily store the current state of the rendering, including volume occupancy and ray position" (section 5.2).
/// The state is the ray's, and is kept between subpasses.
pub const FUSED_PP_DP: [Amendment<ListLine>; 6] = [
    START,
    SKIP_BY_ID,
    STORE_ID,
    STOP,
    Amendment {
        key: "L17",
        kind: Kind::Prose(
            "we temporarily store the current state of the rendering, including volume occupancy and ray position",
        ),
        place: "section 5.2, initialize current state",
        printed: lists! { initialize current state; },
        amended: lists! { begin ray inside what is only left; },
        why: "the state is a ray's",
        test: "l17_a_state_that_is_not_kept_loses_what_subpasses_share",
    },
    EVALUATE_BUFFER,
];

/// "Resolve buffer considering current state", with volumes.
pub const EVALUATE_BUFFER: Amendment<ListLine> = Amendment {
    key: "L17",
    kind: Kind::Prose(
        "we temporarily store the current state of the rendering, including volume occupancy and ray position",
    ),
    place: "section 5.2, resolve buffer considering current state",
    printed: lists! { resolve buffer; },
    amended: lists! {
        foreach element f of buffer do {
            cast ray up to f or opaque depth;
            if (f is of a proxy) then {
                toggle the volume of f;
            } else {
                blend f;
            }
        }
    },
    why: "the ray goes on from where the subpass before has left it",
    test: "l17_a_state_that_is_not_kept_loses_what_subpasses_share",
};

/// ppDP on lists with proxies, for the index: [`PP_DP`] with the title of its amended form, [`FUSED_PP_DP`].
pub const PP_DP_ON_RAYS: Pseudocode<ListLine> = Pseudocode {
    title: "per-pixel Depth Peeling with volumes",
    source: "Lindholm et al. 2015, sections 5.2 and 6.1",
    ..PP_DP
};
