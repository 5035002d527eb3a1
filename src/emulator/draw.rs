//! Drawing: surface by surface through the shader's twin and the stages, in GL's order.

use super::color::Texel;
use super::invocation::{Appended, Inputs, Kept};
use super::lists::{RayRun, Resolved};
use super::machine::Emulator;
use super::maps::Attached;
use super::place::Place;
use super::record::{Draw, Fate, FragmentOutcome, InList, Resolve};
use super::shaders::{Program, program};
use super::surface::{SCREEN, Surface};
use crate::error::Result;
use crate::steps::{Map, Objects};

/// What has become of a fragment.
struct Sent {
    outcome: FragmentOutcome,
    /// The framebuffer's pixel before and after it.
    place: [Place; 2],
    images: Vec<(Option<Map>, [Texel; 2])>,
    list: Option<InList>,
    resolved: Option<(Resolved, Option<RayRun>)>,
}

impl Emulator {
    pub(super) fn draw(&mut self, objects: Objects) -> Result<()> {
        let shader = self.program()?;
        let program = program(shader)?;
        program.expect_told(&self.settings)?;
        let attached = self.maps.attached()?;
        let goes_under = self.goes_under(&attached);
        for pixel in 0..self.pixels.len() {
            if !self.is_in_band(pixel) {
                continue;
            }
            if objects == Objects::Screen {
                if self.is_on_screen(pixel) {
                    self.draw_screen(&program, &attached, pixel);
                }
                continue;
            }
            let among = |surface: &&Surface| surface.group.is_among(objects);
            let surfaces: Vec<_> = self.drawn(pixel).iter().filter(among).copied().collect();
            let mut fates = Vec::new();
            for surface in surfaces {
                let sent = self.send(&program, &attached, pixel, surface);
                if sent.outcome == FragmentOutcome::Pass && goes_under {
                    self.composited[pixel].push(surface.fragment.order);
                }
                if self.watched[pixel] {
                    fates.push(sent.fate(surface));
                }
            }
            if self.watched[pixel] {
                let place = Place::at(&self.maps.planes, &attached, pixel);
                self.histories[pixel].draws.push(Draw {
                    program: shader.0,
                    objects,
                    target: self.maps.target,
                    colors: attached
                        .colors
                        .iter()
                        .map(|&it| self.maps.name(it))
                        .collect(),
                    depth: attached.depth.and_then(|plane| self.maps.name(plane)),
                    fates,
                    left: (place.stencil, place.depth),
                });
            }
        }
        Ok(())
    }

    fn draw_screen(&mut self, program: &Program, attached: &Attached, pixel: usize) {
        let sent = self.send(program, attached, pixel, SCREEN);
        let is_seen = sent.outcome == FragmentOutcome::Pass && self.watched[pixel];
        if let Some((resolved, ray)) = sent.resolved.filter(|_| is_seen) {
            self.histories[pixel].resolves.push(Resolve {
                program: program.shader,
                size: self.settings.size,
                resolved,
                ray,
            });
        }
    }

    /// Whether what passes goes under what is there, in the first color map.
    fn goes_under(&self, attached: &Attached) -> bool {
        let first = &self.state.buffers[0];
        let is_drawn = self.state.blend && !attached.colors.is_empty();
        is_drawn && first.blend.is_under() && first.color_mask != [false; 4]
    }

    /// Sends a surface's fragment through the shader and the stages. The tests come behind the shader, unless it says that
    /// they come before.
    fn send(
        &mut self,
        program: &Program,
        attached: &Attached,
        pixel: usize,
        surface: Surface,
    ) -> Sent {
        let before = Place::at(&self.maps.planes, attached, pixel);
        let mut place = before.clone();
        let depth = surface.fragment.depth;
        let mut outcome = FragmentOutcome::Pass;
        if program.tests_early {
            outcome = place.test(&self.state, depth);
            self.count(outcome);
        }
        let mut kept = None;
        if outcome == FragmentOutcome::Pass {
            kept = (program.twin)(&Inputs {
                fragment: surface.fragment,
                pixel,
                maps: &self.maps,
                place: &place,
                settings: &self.settings,
                records: &self.records[pixel],
            });
            outcome = match &kept {
                None => FragmentOutcome::Discarded,
                Some(_) if program.tests_early => outcome,
                Some(kept) => place.test(&self.state, kept.depth.unwrap_or(depth)),
            };
            if !program.tests_early {
                self.count(outcome);
            }
        }
        let kept = kept.unwrap_or_default();
        if outcome == FragmentOutcome::Pass {
            place.write_colors(&self.state, &kept.colors);
        }
        place.write(&mut self.maps.planes, attached, pixel);
        let images = self.store_images(&kept, pixel);
        let list = kept
            .list
            .map(|appended| self.append(appended, attached, pixel));
        Sent {
            outcome,
            place: [before, place],
            images,
            list,
            resolved: kept.resolved,
        }
    }

    fn count(&mut self, outcome: FragmentOutcome) {
        if let (Some(query), FragmentOutcome::Pass) = (self.counting, outcome) {
            *self.queries.entry(query).or_default() += 1;
        }
    }

    fn store_images(&mut self, kept: &Kept, pixel: usize) -> Vec<(Option<Map>, [Texel; 2])> {
        let store = |&(unit, texel): &(u32, Texel)| {
            let plane = self.maps.image_plane(unit)?;
            let before = self.maps.planes[plane].texel(pixel);
            self.maps.planes[plane].set(pixel, texel);
            let after = self.maps.planes[plane].texel(pixel);
            Some((self.maps.name(plane), [before, after]))
        };
        kept.images.iter().filter_map(store).collect()
    }

    /// The counter of an ordered fill is the framebuffer's color map, and that of a fill by atomics is the first image.
    fn append(&mut self, appended: Appended, attached: &Attached, pixel: usize) -> InList {
        let counter = attached.colors.first().copied();
        self.counter = counter.or(self.maps.image_plane(0));
        let records = &mut self.records[pixel];
        match appended {
            Appended::Stored(at, fragment) => {
                records.truncate(at as usize);
                records.push(fragment);
                InList::Stored(at)
            }
            Appended::NoRoom => InList::NoRoom,
        }
    }
}

impl Sent {
    fn fate(self, surface: Surface) -> Fate {
        let [before, after] = self.place;
        let colors = before.colors.into_iter().zip(after.colors);
        Fate {
            order: surface.fragment.order,
            depth: surface.fragment.depth,
            outcome: self.outcome,
            stencil: [before.stencil, after.stencil],
            stored_depth: [before.depth, after.depth],
            colors: colors
                .map(|((_, before), (_, after))| [before, after])
                .collect(),
            images: self.images,
            list: self.list,
        }
    }
}
