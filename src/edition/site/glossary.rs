//! The papers' words.

use serde_json::{Value, json};

/// A word and what it means.
pub(super) struct Term {
    pub(super) word: &'static str,
    /// Where a paper uses it.
    pub(super) source: &'static str,
    pub(super) meaning: &'static str,
}

const fn term(word: &'static str, source: &'static str, meaning: &'static str) -> Term {
    Term {
        word,
        source,
        meaning,
    }
}

/// In the order of the alphabet.
pub(super) const TERMS: &[Term] = &[
    term(
        "A-buffer",
        "Lindholm et al. 2015, section 4",
        "A list of all fragments for each pixel, which is sorted and blended when the scene has been drawn.",
    ),
    term(
        "alpha",
        "Porter and Duff 1984",
        "How much of the light behind a fragment it stops: 0 is clear, 1 is opaque.",
    ),
    term(
        "blending",
        "Everitt 2001",
        "A fragment's colour goes over what the pixel has: alpha times its own, plus 1 - alpha times the other.",
    ),
    term(
        "clear, fill, resolve",
        "Lindholm et al. 2015, section 3",
        "The three steps of an A-buffer: empty the lists, collect the fragments, sort and composite them.",
    ),
    term(
        "coherent",
        "Carr et al. 2008, section 4",
        "Said of surfaces that come in the order in which they lie. Coherent layer peeling takes a whole run of them at once.",
    ),
    term(
        "composite",
        "Everitt 2001; VTK",
        "To put layers over one another, back to front or front to back, into one colour.",
    ),
    term(
        "coplanar",
        "Vasilakis and Fudos 2013",
        "Said of surfaces that have exactly the same depth at a pixel.",
    ),
    term(
        "depth buffer",
        "Everitt 2001",
        "For each pixel the depth of the nearest surface so far. The depth test compares with it.",
    ),
    term(
        "depth complexity",
        "Lindholm et al. 2015",
        "How many fragments a pixel has.",
    ),
    term(
        "depth complexity histogram",
        "Lindholm et al. 2015, section 3.2",
        "For each depth complexity, how many pixels have it.",
    ),
    term(
        "depth peeling",
        "Everitt 2001",
        "To find the layers one after the other, each by a pass over the scene that ignores the layers before.",
    ),
    term(
        "depth replace",
        "Everitt 2001, An Invariance Issue",
        "A shader's own depth in place of the rasteriser's.",
    ),
    term(
        "Dynamic Fragment Buffer",
        "Lindholm et al. 2015, section 4",
        "DFB: lists side by side in one pool. Each pixel has the room that it needs, at an offset that is the sum of the counts \
         before it.",
    ),
    term(
        "exact",
        "this edition",
        "Said of an image that equals the oracle's, up to the rounding of the stored colours. The oracle sorts every pixel's fragments, and composites them in 64 bits.",
    ),
    term(
        "filling",
        "this edition",
        "A step that a paper leaves open and a program needs, with the sentence that it rests on.",
    ),
    term(
        "Fixed Fragment Buffer",
        "Lindholm et al. 2015, section 4",
        "FFB: lists of one length for all pixels. The place of a pixel's list follows from the pixel's place.",
    ),
    term(
        "fragment",
        "Everitt 2001",
        "What one triangle contributes to one pixel: a colour, an alpha, a depth.",
    ),
    term(
        "fused rendering",
        "Lindholm et al. 2015, section 6",
        "A ray through volumes that is stopped at every surface, so that both are composited in their order.",
    ),
    term(
        "global memory",
        "Lindholm et al. 2015, section 4",
        "The graphics card's large and slow memory, which has the lists of all pixels.",
    ),
    term(
        "hybrid layer peeling",
        "Carr et al. 2008, section 3",
        "Layer peeling of what has no order. What is sorted is blended between one peel and the next.",
    ),
    term(
        "invariance",
        "Everitt 2001, An Invariance Issue",
        "That the same surface, drawn twice, gets the same depth to the last bit.",
    ),
    term(
        "layer",
        "Everitt 2001",
        "Of each pixel the fragment that comes at this place in the order of depth. Layer 0 is the nearest.",
    ),
    term(
        "Local Array",
        "Lindholm et al. 2015, section 5",
        "The array in fast memory in which a pixel's fragments are sorted. A shader has it in one size.",
    ),
    term(
        "occlusion query",
        "VTK; Carr et al. 2008",
        "A question to the graphics card: how many samples passed all tests since the query began?",
    ),
    term(
        "occlusion ratio",
        "VTK, Depth Peeling",
        "The part of the window's pixels below which a peel is the last one. 0 means an exact image.",
    ),
    term(
        "opaque",
        "VTK, Depth Peeling",
        "Said of a surface that lets no light through. Opaque surfaces are drawn first, and hide what lies behind them.",
    ),
    term(
        "oracle",
        "this edition",
        "The program that makes the exact image. It knows neither OpenGL nor listings.",
    ),
    term(
        "order of submission",
        "Carr et al. 2008, section 4",
        "The order in which a program draws its triangles. Of coplanar surfaces, the one submitted first lies in front here.",
    ),
    term(
        "painter's algorithm",
        "Carr et al. 2008, section 1",
        "To sort the triangles by distance, and blend them back to front. It fails where they cross, or overlap in a circle.",
    ),
    term(
        "pass",
        "Everitt 2001; Carr et al. 2008",
        "One time through the scene's triangles, or through a part of them.",
    ),
    term(
        "peel",
        "Everitt 2001; VTK",
        "A pass that finds the next layer; also, to make such passes.",
    ),
    term(
        "Per-Pixel Linked Lists",
        "Lindholm et al. 2015, section 4",
        "PPLL: fragments lie in one pool in the order in which they come, and each is linked to the one before it at its pixel.",
    ),
    term(
        "ppAO",
        "Lindholm et al. 2015, section 5.1",
        "per-pixel Array Optimization: programs with Local Arrays of 8, 16, 32 and so on. Each resolves the pixels that fit into \
         its array and into no smaller one.",
    ),
    term(
        "ppDP",
        "Lindholm et al. 2015, section 5.2",
        "per-pixel Depth Peeling: a list is read again and again, and each time the nearest n of the fragments that are left are \
         sorted and blended.",
    ),
    term(
        "reading",
        "this edition",
        "How far a listing is taken as it stands: literal, as printed with fillings, or amended.",
    ),
    term(
        "run",
        "Carr et al. 2008, section 4",
        "Surfaces at a pixel that come one after the other in the order of submission and of depth, with none in between.",
    ),
    term(
        "sample",
        "Everitt 2001, Depth Peeling",
        "A pixel of a layer that has a fragment.",
    ),
    term(
        "shadow map",
        "Everitt 2001, Shadow Mapping",
        "A depth buffer seen from a light. What is farther than it says lies in shadow.",
    ),
    term(
        "stencil",
        "Carr et al. 2008, section 5",
        "A small whole number at each pixel, which passes can count up and down and test.",
    ),
    term(
        "tie",
        "Carr et al. 2008, section 4",
        "Two fragments of a pixel with exactly the same depth.",
    ),
    term(
        "verdict",
        "this edition",
        "What is to be thought of a claim: reproduced, in kind, contradicted, amended, open.",
    ),
    term(
        "verified painter",
        "this edition",
        "Blending of sorted triangles whose order the depth test proves at each pixel. The pixels where it fails get lists.",
    ),
];

pub(super) fn find(word: &str) -> Option<&'static Term> {
    TERMS.iter().find(|term| term.word == word)
}

/// The name by which links find a word on its page.
pub(super) fn anchor(word: &str) -> String {
    word.replace(' ', "-").replace([',', '\''], "")
}

pub(super) fn data() -> Value {
    let terms = TERMS.iter();
    let terms = terms.map(|it| {
        json!({
            "word": it.word,
            "anchor": anchor(it.word),
            "source": it.source,
            "meaning": it.meaning,
        })
    });
    terms.collect()
}
