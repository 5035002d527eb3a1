//! Section 6.1: what happens on one ray.

use glam::DVec3;

use crate::emulator::{RayHappening, RayRun, RayScene, RayVolume, run_on_rays};
use crate::error::Result;
use crate::fragment::{Fragment, Rgba, Source};
use crate::low_level::edition::figures::{Drawn, Figure, Studio};
use crate::papers::lindholm_2015::fused::{FUSED, FUSED_AMENDMENTS};
use crate::scene::Medium;

pub(super) const FIGURE: Figure = Figure {
    key: "lindholm-ray",
    source: "Lindholm et al. 2015, section 6.1",
    title: "One ray through two volumes and two panes",
    make,
};

/// A ray through two volumes that overlap and two panes. The eye is inside of the first volume, so this volume's box has only
/// the face where the ray leaves it. The fragments are as the Fill Step leaves them, in the order of submission.
pub fn two_volumes() -> (Vec<Fragment>, RayScene<'static>) {
    let face = |volume, leaves| Source::Proxy { volume, leaves };
    let entries = [
        (0.55, Source::Surface(0), 0.3),
        (0.85, Source::Surface(1), 0.5),
        (0.7, face(0, true), 0.0),
        (0.9, face(1, true), 0.0),
        (0.4, face(1, false), 0.0),
    ];
    let fragment = |(depth, source, alpha): (f32, Source, f32)| Fragment {
        depth,
        color: Rgba::new(0.2, 0.4, 0.8, alpha),
        order: source.id(),
    };
    let volume = |medium, step| RayVolume { medium, step };
    let ray = RayScene {
        planes: [1.0, 6.0],
        slant: 1.0,
        inverse_w: false,
        opaque: 0.88,
        volumes: vec![volume(&thin, 0.5), volume(&growing, 0.25)],
    };
    (entries.map(fragment).to_vec(), ray)
}

fn thin(_: f64) -> Medium {
    Medium {
        color: DVec3::X,
        density: 0.2,
    }
}

/// A density that grows with the value.
fn growing(distance: f64) -> Medium {
    Medium {
        color: DVec3::Y,
        density: 0.15 * distance,
    }
}

fn make(_: &Studio) -> Result<Drawn> {
    let pixel = [two_volumes()];
    let (_, amended) = run_on_rays(&FUSED, &FUSED_AMENDMENTS, &pixel, 16, 1)?;
    let (_, printed) = run_on_rays(&FUSED, &[], &pixel, 16, 1)?;
    let columns = [
        "the ray",
        "distance",
        "inside of",
        "light that comes through",
    ];
    Ok(Drawn::new(
        "The eye is inside of volume 0, and an opaque surface stands behind both panes. The columns say where the ray is, which \
         volumes' bits are on after the step, and how much of the light behind still comes through. As the prose has it, the ray \
         begins outside of volume 0, and the face where it should leave this volume turns the bit on instead. And it does not end \
         at the opaque surface.",
    )
    .table("As amended: the ray begins inside, and ends at what is opaque", &columns, rows(&amended[0]))
    .table("As the prose has it", &columns, rows(&printed[0])))
}

fn rows(run: &RayRun) -> Vec<Vec<String>> {
    let row = |event: &crate::emulator::RayEvent| {
        let what = match event.what {
            RayHappening::Begins => "begins".to_owned(),
            RayHappening::IsCast(1) => "is cast, 1 sample".to_owned(),
            RayHappening::IsCast(count) => format!("is cast, {count} samples"),
            RayHappening::Toggles(volume) => format!("crosses a face of volume {volume}"),
            RayHappening::Blends(surface) => format!("meets pane {surface}"),
        };
        let inside: Vec<String> = (0..32)
            .filter(|volume| event.occupancy >> volume & 1 == 1)
            .map(|volume| format!("volume {volume}"))
            .collect();
        vec![
            what,
            format!("{:.3}", event.distance),
            if inside.is_empty() {
                "none".into()
            } else {
                inside.join(" and ")
            },
            format!("{:.4}", event.transparency),
        ]
    };
    run.events.iter().map(row).collect()
}
