//! The invariance experiment (Everitt 2001, "An Invariance Issue").
//!
//! Depth peeling compares a depth with one that an earlier pass has stored. Here both depths are made in every way.
//! They are the rasteriser's window z or the quotient r/q. The sampler or the shader compares them. They are stored in
//! 16, 24 or 32 bits. Renderers use fudge factors where the two sides do not agree, and these are tried, too. At the
//! end, the rounding of colours is measured in three formats of the image.
//!
//! Writes one picture of the wrong pixels.
//!
//! `cargo run --example 14_the_invariance_experiment [FOLDER]`

use onionskin::generate::{Quads, SubmissionOrder, quads};
use onionskin::low_level::methods::invariance::{
    SOURCES, Verdict, perspective_soup, run_experiment,
};
use onionskin::options::{Comparator, DepthPeelingOptions, Experiment};
use onionskin::report::Panels;
use onionskin::{Comparison, Context, Format, Image, Method, Renderer, Result, Scene};

#[path = "common/example.rs"]
mod example;

const SIZE: [u32; 2] = [192, 144];
const D32F: Format = Format::Depth32F;

fn main() -> Result<()> {
    let context = Context::headless()?;
    stored_and_compared(&context)?;
    fudge_factors(&context)?;
    accumulators(&context)?;
    picture(&context)
}

/// The wrong pixels, and how many of them are stuck, for each format and each ratio far/near.
fn stored_and_compared(context: &Context) -> Result<()> {
    let formats = [
        ("D16", Format::Depth16, 16),
        ("D24", Format::Depth24, 24),
        ("D32F", D32F, 24),
    ];
    println!("wrong pixels (stuck ones), of {}", SIZE[0] * SIZE[1]);
    println!(
        "{:<22}{:<24}{:<6}{:>15}{:>15}{:>15}{:>15}",
        "stored : compared", "compared in", "", "far/near = 10", "100", "1000", "10000"
    );
    let ratios = [10.0, 100.0, 1000.0, 10_000.0];
    let mut studies = Vec::new();
    for ratio in ratios {
        studies.push(study(context, ratio)?);
    }
    for (name, stored, compared) in SOURCES {
        for (format_name, format, bits) in formats {
            let comparators = [
                Comparator::Sampler,
                Comparator::Shader,
                Comparator::ShaderInBits(bits),
            ];
            for comparator in comparators {
                if format == D32F && comparator == Comparator::ShaderInBits(bits) {
                    continue;
                }
                let mut cells = String::new();
                for (scene, exact) in &studies {
                    let experiment = Experiment {
                        stored,
                        compared,
                        comparator,
                        bias: 0.0,
                    };
                    let finding = run_experiment(context, scene, exact, experiment, format)?;
                    let stuck = finding.count(Verdict::Stuck);
                    cells += &format!("{:>15}", format!("{} ({stuck})", finding.wrong()));
                }
                println!(
                    "{name:<22}{:<24}{format_name:<6}{cells}",
                    comparator_name(comparator)
                );
            }
        }
    }
    Ok(())
}

fn comparator_name(comparator: Comparator) -> String {
    match comparator {
        Comparator::Sampler => "sampler".into(),
        Comparator::Shader => "shader".into(),
        Comparator::ShaderInBits(bits) => format!("shader, both in {bits} bits"),
    }
}

/// The cost of each bias: doubled layers and missing layers.
fn fudge_factors(context: &Context) -> Result<()> {
    println!("\nbias, D32F, far/near 1000   fragments missing   doubled   wrong pixels   ended");
    let (scene, exact) = study(context, 1000.0)?;
    for (name, stored, compared) in SOURCES {
        for bias in [0.0, 1e-7, 1e-6, 2e-3] {
            let experiment = Experiment {
                stored,
                compared,
                bias,
                ..Experiment::default()
            };
            let finding = run_experiment(context, &scene, &exact, experiment, D32F)?;
            println!(
                "{name:<20} {bias:<8e}{:17} {:9} {:14}   {}",
                finding.missing,
                finding.doubled,
                finding.wrong(),
                if finding.ended { "yes" } else { "no" }
            );
        }
    }
    Ok(())
}

/// The error of the image's format against depth complexity.
fn accumulators(context: &Context) -> Result<()> {
    println!("\nlayers of opacity 0.02   largest error in RGBA8   RGBA16F    RGBA32F");
    for count in [4, 8, 16, 32, 64, 128, 256] {
        let parameters = Quads {
            count,
            alpha: 0.02,
            order: SubmissionOrder::Shuffled,
            ..Quads::default()
        };
        let mut scene = Scene::of("quads", vec![quads(&parameters)?]);
        scene.size = [40, 30];
        scene.background = [1.0; 3];
        let mut renderer = Renderer::new(context, 40, 30)?;
        let exact = renderer.render(&scene, &Method::Exact)?.image;
        let mut cells = String::new();
        for color in [Format::Rgba8, Format::Rgba16F, Format::Rgba32F] {
            renderer = renderer.with_formats(color, D32F);
            let method = Method::DepthPeeling(DepthPeelingOptions::default());
            let image = renderer.render(&scene, &method)?.image;
            let error = Comparison::new(&image, &exact, 0.0)?.max;
            cells += &format!("{error:11.1e}");
        }
        println!("{count:22}   {cells}");
    }
    Ok(())
}

fn picture(context: &Context) -> Result<()> {
    let (scene, exact) = study(context, 1000.0)?;
    let (near, near_exact) = study(context, 10.0)?;
    let [window_z, mixed, replaced] = SOURCES.map(|(_, stored, compared)| Experiment {
        stored,
        compared,
        ..Experiment::default()
    });
    let with_bias = |bias| Experiment { bias, ..mixed };
    let title = "An invariance issue (Everitt 2001): depths that were stored, and others that are compared with them";
    let mut sheet = Panels::new(title).columns(3);
    for (caption, experiment) in [
        ("window z : r/q, no bias", mixed),
        ("window z : r/q, bias 1e-7", with_bias(1e-7)),
        ("window z : r/q, bias 2e-3", with_bias(2e-3)),
    ] {
        let finding = run_experiment(context, &scene, &exact, experiment, D32F)?;
        sheet = sheet.picture(&finding.picture(), caption);
    }
    for (caption, experiment, format) in [
        ("window z : window z, 24 bits", window_z, Format::Depth24),
        ("depth replace : r/q, 24 bits", replaced, Format::Depth24),
        ("depth replace : r/q, 32-bit floats", replaced, D32F),
    ] {
        let finding = run_experiment(context, &near, &near_exact, experiment, format)?;
        sheet = sheet.picture(&finding.picture(), caption);
    }
    let path = example::output("14_the_invariance_experiment.png")?;
    sheet
        .key(Verdict::Right.color(), "right")
        .key(Verdict::Stuck.color(), "repeats a layer for ever")
        .key(Verdict::Doubled.color(), "has a layer twice")
        .key(Verdict::Missing.color(), "lacks a layer")
        .key(Verdict::Reordered.color(), "in another order")
        .save(&path)?;
    println!("{}", path.display());
    Ok(())
}

/// Random triangles in perspective, and their exact image.
fn study(context: &Context, ratio: f64) -> Result<(Scene, Image)> {
    let scene = perspective_soup(1, 200, ratio, SIZE)?;
    let mut renderer = Renderer::new(context, SIZE[0], SIZE[1])?;
    let exact = renderer.render(&scene, &Method::Exact)?.image;
    Ok((scene, exact))
}
