//! Section 6.1 line by line on lists of fragments with proxies: every list of two volumes, a pane and an opaque surface on
//! few depths, against light that is composited back to front, and closed forms.

use glam::DVec3;
use onionskin::low_level::emulator::RayHappening::{Begins, Blends, IsCast, Toggles};
use onionskin::low_level::emulator::{ListRun, RayRun, RayScene, RayVolume, run_on_rays};
use onionskin::low_level::fragment::Source;
use onionskin::low_level::papers::lindholm_2015::components::PP_DP;
use onionskin::low_level::papers::lindholm_2015::fused::*;
use onionskin::low_level::scene::Medium;
use onionskin::low_level::steps::Amendment;
use onionskin::low_level::steps::pseudo::Pseudocode;
use onionskin::low_level::steps::pseudo::list::{self, Beginning, ListLine, ListTest, SegmentEnd};
use onionskin::{Fragment, Result, Rgba};

/// What two constant volumes look like.
const FOGS: [(DVec3, f64); 2] = [
    (DVec3::new(1.0, 0.2, 0.0), 0.7),
    (DVec3::new(0.0, 0.4, 0.9), 1.9),
];
const PANE: Rgba = Rgba::new(0.1, 0.9, 0.3, 0.4);
const PLANES: [f64; 2] = [1.0, 4.0];
const SLANT: f64 = 1.25;
/// From the near to the far plane.
const LEVELS: [f32; 4] = [0.0, 0.4, 0.75, 1.0];

/// Where two volumes are entered, if the eye is not in them, and left; where the pane and the opaque surface are.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Case {
    volumes: [(Option<usize>, usize); 2],
    pane: usize,
    opaque: Option<usize>,
}

pub(crate) fn cases() -> Vec<Case> {
    let ends = 0..LEVELS.len();
    let volumes: Vec<(Option<usize>, usize)> = ends
        .flat_map(|leave| {
            let enters = (0..=leave).map(Some).chain([None]);
            enters.map(move |enter| (enter, leave))
        })
        .collect();
    let mut cases = Vec::new();
    for first in &volumes {
        for second in &volumes {
            for pane in 0..LEVELS.len() {
                for opaque in [None, Some(0), Some(1), Some(2), Some(3)] {
                    cases.push(Case {
                        volumes: [*first, *second],
                        pane,
                        opaque,
                    });
                }
            }
        }
    }
    cases
}

impl Case {
    fn opaque_depth(&self) -> f32 {
        self.opaque.map_or(1.0, |level| LEVELS[level])
    }

    fn shows_pane(&self) -> bool {
        LEVELS[self.pane] < self.opaque_depth()
    }

    /// As the Fill Step leaves it: surfaces before the opaque one, every proxy; in some order.
    fn list(&self) -> Vec<Fragment> {
        let fragment = |level: usize, source: Source, color| Fragment {
            depth: LEVELS[level],
            color,
            order: source.id(),
        };
        let mut list = Vec::new();
        for (volume, (enter, leave)) in (0..).zip(self.volumes) {
            let proxy = |leaves| Source::Proxy { volume, leaves };
            list.push(fragment(leave, proxy(true), Rgba::default()));
            list.extend(enter.map(|enter| fragment(enter, proxy(false), Rgba::default())));
        }
        if self.shows_pane() {
            list.insert(
                list.len() / 2,
                fragment(self.pane, Source::Surface(7), PANE),
            );
        }
        list
    }

    /// Back to front, over black: slabs between neighbouring levels, and the pane at its own.
    fn light(&self) -> ([f64; 3], f64) {
        let at = |level: usize| {
            let depth = f64::from(LEVELS[level].min(self.opaque_depth()));
            PLANES[0] * PLANES[1] / (PLANES[1] - depth * (PLANES[1] - PLANES[0]))
        };
        let (mut light, mut clear) = (DVec3::ZERO, 1.0);
        let mut under = |color: DVec3, passes: f64| {
            light = color * (1.0 - passes) + light * passes;
            clear *= passes;
        };
        for level in (0..LEVELS.len()).rev() {
            if let Some(next) = LEVELS.get(level + 1).map(|_| level + 1) {
                let inside = self.volumes.iter().zip(FOGS).filter(|((enter, leave), _)| {
                    enter.is_none_or(|enter| enter <= level) && *leave >= next
                });
                let (mut mixed, mut density) = (DVec3::ZERO, 0.0);
                for (_, (color, sigma)) in inside {
                    mixed += color * sigma;
                    density += sigma;
                }
                if density > 0.0 {
                    let length = SLANT * (at(next) - at(level));
                    under(mixed / density, (-density * length).exp());
                }
            }
            if self.shows_pane() && self.pane == level {
                let color = DVec3::new(PANE.r.into(), PANE.g.into(), PANE.b.into());
                under(color, 1.0 - f64::from(PANE.a));
            }
        }
        (light.to_array(), clear)
    }

    fn run(
        &self,
        algorithm: &Pseudocode<ListLine>,
        amendments: &[Amendment<ListLine>],
        array: u32,
    ) -> RayRun {
        let (lists, mut rays) = self.try_to_run(algorithm, amendments, array).unwrap();
        assert!(lists.ended);
        assert_eq!(lists.pixels[0].composited.len(), self.list().len());
        rays.remove(0)
    }

    pub(crate) fn try_to_run(
        &self,
        algorithm: &Pseudocode<ListLine>,
        amendments: &[Amendment<ListLine>],
        array: u32,
    ) -> Result<(ListRun, Vec<RayRun>)> {
        let media = FOGS.map(|(color, density)| move |_| Medium { color, density });
        let volumes = media.iter().map(|medium| RayVolume { medium, step: 0.3 });
        let scene = RayScene {
            planes: PLANES,
            inverse_w: false,
            slant: SLANT,
            opaque: self.opaque_depth(),
            volumes: volumes.collect(),
        };
        run_on_rays(algorithm, amendments, &[(self.list(), scene)], array, 20)
    }

    /// Whether the light is what it should be, to the roundings of f64.
    fn comes_out(
        &self,
        algorithm: &Pseudocode<ListLine>,
        amendments: &[Amendment<ListLine>],
        array: u32,
    ) -> bool {
        let run = self.run(algorithm, amendments, array);
        let (light, clear) = self.light();
        let pairs = run
            .light
            .into_iter()
            .zip(light)
            .chain([(run.transparency, clear)]);
        pairs.into_iter().all(|(a, b)| (a - b).abs() < 1e-13)
    }
}

#[test]
pub(crate) fn l16_every_list_is_evaluated_as_light_is() {
    for case in cases() {
        assert!(case.comes_out(&FUSED, &FUSED_AMENDMENTS, 9), "{case:?}");
    }
}

#[test]
pub(crate) fn l17_ppdp_keeps_the_state_whatever_its_buffer() {
    for case in cases() {
        for array in [1, 2, 3, 9] {
            assert!(
                case.comes_out(&PP_DP, &FUSED_PP_DP, array),
                "{case:?} {array}"
            );
        }
    }
}

#[test]
pub(crate) fn l16_without_where_it_begins_a_ray_is_wrong_exactly_where_it_begins_inside() {
    let mut wrong = 0;
    for case in cases() {
        // What is left before it was entered is taken to be entered there, and not left again. So even a volume that ends
        // where the ray begins makes it wrong, if the ray goes on.
        let inside = case.volumes.iter().any(|(enter, leave)| {
            let goes_on = case.list().iter().any(|f| f.depth > 0.0);
            enter.is_none() && (*leave > 0 || goes_on)
        });
        let comes_out = case.comes_out(&FUSED, &[END_AT_OPAQUE], 9);
        assert_eq!(!comes_out, inside && case.opaque_depth() > 0.0, "{case:?}");
        wrong += u32::from(!comes_out);
    }
    println!("{wrong} of {} lists", cases().len());
}

#[test]
pub(crate) fn l16_without_the_opaque_surface_a_ray_goes_on_behind_it() {
    let wrong: Vec<Case> = cases()
        .into_iter()
        .filter(|case| !case.comes_out(&FUSED, &[BEGIN_INSIDE], 9))
        .collect();
    assert!(
        wrong
            .iter()
            .all(|case| case.opaque.is_some_and(|level| level < 3))
    );
    let behind = |case: &&Case| {
        let opaque = case.opaque.is_some_and(|level| level < 3);
        opaque
            && case.volumes.iter().any(|(enter, leave)| {
                let end = case.opaque.unwrap_or(3);
                *leave > end && enter.is_none_or(|enter| enter < *leave)
            })
    };
    assert_eq!(wrong.len(), cases().iter().filter(behind).count());
}

/// Where a subpass begins as if it were the first, from the near plane and with the occupancy of the whole list, light is
/// counted again; only lists that fit into the buffer come out.
#[test]
pub(crate) fn l17_a_state_that_is_not_kept_loses_what_subpasses_share() {
    const EVALUATION: [ListLine; 2] = [
        ListLine::Cast(SegmentEnd::FragmentOrOpaque),
        ListLine::If(ListTest::IsProxy, &[ListLine::Toggle], &[ListLine::Blend]),
    ];
    let mut amendments = FUSED_PP_DP;
    amendments[5].amended = &[
        ListLine::BeginRay(Beginning::WhatIsOnlyLeft),
        ListLine::Elements(&EVALUATION),
    ];
    let wrong = |array| {
        let cases = cases().into_iter();
        cases
            .filter(|case| !case.comes_out(&PP_DP, &amendments, array))
            .count()
    };
    assert_eq!(wrong(9), 0);
    assert!(wrong(2) > cases().len() / 4, "{}", wrong(2));
}

/// The toggle dropped, or turned the other way round.
#[test]
fn l16_a_toggle_that_is_left_out_is_noticed() {
    const NO_TOGGLE: Amendment<ListLine> = Amendment {
        printed: &[ListLine::If(
            ListTest::IsProxy,
            &[ListLine::Toggle],
            &[ListLine::Blend],
        )],
        amended: &[ListLine::If(ListTest::IsProxy, &[], &[ListLine::Blend])],
        ..END_AT_OPAQUE
    };
    let [begin, end] = FUSED_AMENDMENTS;
    let cases = cases();
    let wrong = cases
        .iter()
        .filter(|case| !case.comes_out(&FUSED, &[begin, end, NO_TOGGLE], 9));
    assert!(wrong.count() > cases.len() / 2);
}

/// The eye in the first volume; distances 1 to 4, samples 0.3 long on a ray that slants by 1.25.
#[test]
fn l16_a_ray_writes_down_what_happens_on_it() {
    let case = Case {
        volumes: [(None, 2), (Some(1), 3)],
        pane: 1,
        opaque: Some(3),
    };
    let run = case.run(&FUSED, &FUSED_AMENDMENTS, 9);
    let happened: Vec<_> = run
        .events
        .iter()
        .map(|event| (event.what, event.occupancy))
        .collect();
    // At depth 0.4 a distance of 1/(1 - 0.75 x 0.4) = 1.43, at 0.75 of 2.29: 1.8 samples, 3.6, 7.1.
    let expected = [
        (Begins, 0b01),
        (IsCast(2), 0b01),
        (Blends(7), 0b01),
        (Toggles(1), 0b11),
        (IsCast(4), 0b11),
        (Toggles(0), 0b10),
        (IsCast(8), 0b10),
        (Toggles(1), 0b00),
    ];
    assert_eq!(happened, expected);
    let table = run.to_string();
    assert_eq!(table.lines().count(), 9, "{table}");
    assert!(
        table.contains("meets surface 7            1.4286    1  "),
        "{table}"
    );
}

#[test]
fn l16_section_6_1_prints_as_its_sentences_go() {
    let expected = "\
input : list of fragment data per pixel
ray position, occupancy ← near plane, ∅;
foreach fragment f ∈ sorted fragment list do
  cast ray through the occupied volumes up to depth(f);
  if f is of a volume proxy geometry then
    toggle the volume of f in occupancy;
  else
    blend f;
  end
end
";
    let lines = list::lines(&FUSED, &[]);
    let lines = lines.iter().filter(|line| !line.note);
    let printed: String = lines.map(|line| format!("{}\n", line.text)).collect();
    assert_eq!(printed, expected);
    let amended = list::print(&PP_DP, &FUSED_PP_DP);
    for line in [
        "// L17: the ray goes on from where the subpass before has left it",
        "foreach fragment f ∈ buffer do",
        "the volumes that the list leaves but does not enter;",
        "up to min(depth(f), opaque depth);",
    ] {
        assert!(amended.contains(line), "{amended}");
    }
}
