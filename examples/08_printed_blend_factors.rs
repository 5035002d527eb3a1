//! The effect of the blend factors that Carr et al. (2008) print in section 6.
//!
//! Variant B moves the depth of the previous nearest surface into the color channels: "by using a blend method that
//! multiplies the source color by the destination alpha". The printed factors, `(ZERO, DEST_ALPHA, ONE, ZERO)`,
//! multiply the *destination* color by it, so that the color becomes the product of all earlier depths. This is right
//! after two surfaces, and too small after three. The run then ends before it begins.
//!
//! Writes one picture: the factors of the sentence on the left, the printed factors in the middle, and the difference
//! of the images on the right.
//!
//! `cargo run --example 08_printed_blend_factors [FOLDER]`

use onionskin::low_level::steps::{Amendment, gl::*};
use onionskin::options::{CoherentOptions, TriangleSort, Variant};
use onionskin::report::Panels;
use onionskin::{Comparison, Context, Method, Renderer, Scene, steps};

#[path = "common/example.rs"]
mod example;

/// Undoes the one amended word.
const AS_PRINTED: Amendment = Amendment {
    key: "CX16, undone",
    kind: onionskin::low_level::steps::Kind::Correction,
    place: "section 6, the blend function",
    printed: steps! { glBlendFuncSeparate(DEST_ALPHA, ZERO, ONE, ZERO); },
    amended: steps! { glBlendFuncSeparate(ZERO, DEST_ALPHA, ONE, ZERO); },
    why: "as the paper prints it",
    test: "cx16_the_printed_blend_factors_multiply_all_earlier_depths",
};

fn main() -> onionskin::Result<()> {
    let scene = Scene::load_at(example::scene("knots.toml"), Some([512, 384]))?;
    let context = Context::headless()?;
    let mut renderer = Renderer::new(&context, 512, 384)?;
    let mut render = |amendments: &'static [Amendment]| {
        let options = CoherentOptions {
            sorting: TriangleSort::Submission,
            amendments,
            ..Variant::B.into()
        };
        renderer.render(&scene, &Method::CoherentLayerPeeling(options))
    };
    let (amended, printed) = (render(&[])?, render(&[AS_PRINTED])?);
    for (name, frame) in [("as the text says", &amended), ("as printed", &printed)] {
        let stats = &frame.stats;
        println!(
            "{name:<17} {:2} iterations, {} of {} fragments in the image, stopped: {}",
            stats.iterations,
            stats.fragments - stats.lost.unwrap_or(0),
            stats.fragments,
            stats.stopped_text()
        );
    }
    let error = Comparison::new(&amended.image, &printed.image, 1.0 / 255.0)?;
    println!("{} pixels differ by more than 1/255", error.over);

    let path = example::output("08_printed_blend_factors.png")?;
    Panels::new("The blend factors of Carr et al. 2008, section 6")
        .picture(&amended.image, "as the text says: ZERO, DEST_ALPHA")
        .picture(&printed.image, "as printed: DEST_ALPHA, ZERO")
        .difference(
            &amended.image,
            &printed.image,
            "difference of the two: largest channel",
        )?
        .save(&path)?;
    println!("{}", path.display());
    Ok(())
}
