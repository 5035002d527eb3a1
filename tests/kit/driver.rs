//! What OpenGL leaves open and tests expect of a driver. On a driver that does otherwise, they say aloud what they skip.

use onionskin::{Comparison, Context, Frame, Image};

fn told(context: &Context, holds: bool, otherwise: &str) -> bool {
    if !holds {
        println!("skipped: {} {otherwise}", context.driver().renderer);
    }
    holds
}

/// Whether fragments come into lists in the order of submission. As printed, Lindholm's algorithms lose what comes last.
pub fn keeps_lists_in_order(context: &Context) -> bool {
    let holds = context.driver().quirks().runs_in_order;
    told(
        context,
        holds,
        "brings fragments into lists in an order of its own",
    )
}

/// Whether the keys of a Local Array are doubles, as they are wherever a driver is known to be right with them.
pub fn keys_are_doubles(context: &Context) -> bool {
    let holds = context.driver().quirks().quick_doubles;
    told(context, holds, "has keys in words, never in doubles")
}

/// Whether a fragment lies exactly where its triangle's corners put it.
pub fn interpolates_true_corners(context: &Context) -> bool {
    let holds = context.driver().quirks().interpolates_true_corners;
    told(
        context,
        holds,
        "snaps corners to 1/256 pixel before it interpolates",
    )
}

/// Whether fixed-point depths are rounded as llvmpipe does it, and seen by a fragment before they are.
pub fn fixed_depths_are_products(context: &Context) -> bool {
    let holds = context.driver().quirks().fixed_depths_are_products;
    told(
        context,
        holds,
        "is not llvmpipe, whose fixed-point depths are modelled",
    )
}

/// Whether a product and a sum are rounded apart, in blending and in what a shader computes.
pub fn rounds_each_operation(context: &Context) -> bool {
    let holds = context.driver().quirks().blends_in_three_roundings;
    told(context, holds, "may round a product and a sum together")
}

/// Whether Mesa's variables of the environment mean anything to it.
pub fn is_mesa(context: &Context) -> bool {
    let holds = context.driver().quirks().obeys_version_override;
    told(context, holds, "is not Mesa's")
}

/// A frame's image. Where corners are snapped, it has the exact image's colour at every pixel at which the order of two
/// fragments hangs on a rounding: they may lie in either order there.
pub fn settled(context: &Context, frame: &Frame, exact: &Frame) -> Image {
    let mut image = frame.image.clone();
    if !context.driver().quirks().interpolates_true_corners {
        let hanging = exact.hanging.as_ref().expect("of an exact frame");
        settle(&mut image, &exact.image, &hanging.drawn);
    }
    image
}

fn settle(image: &mut Image, exact: &Image, hanging: &[bool]) {
    let pixels = image.pixels.iter_mut().zip(&exact.pixels);
    for ((pixel, exact), hangs) in pixels.zip(hanging) {
        if *hangs {
            *pixel = *exact;
        }
    }
}

#[test]
fn a_wrong_pixel_that_does_not_hang_would_be_noticed() {
    let [right, mut wrong] = [0.0, 1.0].map(|value| Image::filled(2, 1, [value; 4].into()));
    settle(&mut wrong, &right, &[true, false]);
    let off = Comparison::new(&wrong, &right, 0.0).unwrap();
    assert_eq!((off.over, off.worst), (1, Some([1, 0])));
}
