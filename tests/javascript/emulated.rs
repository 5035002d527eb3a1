//! A program on the emulated pixel, with a digest of what it holds after each call.

use std::cell::RefCell;
use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::rc::Rc;

use onionskin::low_level::edition::program_json::{COLOR, DEPTH};
use onionskin::low_level::edition::programs::{Program, Rest};
use onionskin::low_level::emulator::{Emulator, FragmentOutcome, Group, Surface, run_on_lists};
use onionskin::low_level::methods::allocate_maps;
use onionskin::low_level::papers::stage::IMAGE_COLOR;
use onionskin::low_level::steps::{
    Call, DepthUnits, Machine, Map, Objects, Query, Reading, Target, Texel, Text, Variables,
    Workspace, run,
};
use onionskin::{Format, Fragment, Result};

use crate::cases::Pixel;
use crate::digest::Digest;

/// The emulated pixel, which two machines share: one has depth units, the other looks at it after each call.
#[derive(Clone)]
struct Shared(Rc<RefCell<Emulator>>);

impl Machine for Shared {
    fn perform(&mut self, call: &Call) -> Result<()> {
        self.0.borrow_mut().perform(call)
    }

    fn samples(&mut self, query: Query) -> Result<u64> {
        self.0.borrow_mut().samples(query)
    }
}

/// Looks at the pixel after each call.
struct Watched<'m> {
    machine: DepthUnits<'m, Shared>,
    pixel: Shared,
    /// The maps that are there, by name.
    maps: BTreeMap<String, (Map, Format)>,
    digest: Digest,
    /// Every call and what is there after it, if it is wanted.
    said: Option<Vec<String>>,
}

impl Machine for Watched<'_> {
    fn perform(&mut self, call: &Call) -> Result<()> {
        self.machine.perform(call)?;
        self.follow_names(call);
        self.look(call);
        if let Some(said) = &mut self.said {
            let (name, arguments) = call.signature();
            let mut named: Vec<_> = arguments
                .iter()
                .map(|(name, value)| format!("{name} = {value}"))
                .collect();
            named.sort();
            said.push(format!(
                "{name}({}): {}",
                named.join(", "),
                self.digest.take()
            ));
        }
        Ok(())
    }

    fn samples(&mut self, query: Query) -> Result<u64> {
        self.machine.samples(query)
    }
}

impl Watched<'_> {
    fn follow_names(&mut self, call: &Call) {
        match *call {
            Call::CopyImage { from, to } => {
                let (_, format) = self.maps[&from.to_string()];
                self.maps.insert(to.to_string(), (to, format));
            }
            Call::Swap { a, b } => {
                let [of_a, of_b] = [a, b].map(|map| self.maps[&map.to_string()].1);
                self.maps.insert(a.to_string(), (a, of_b));
                self.maps.insert(b.to_string(), (b, of_a));
            }
            _ => {}
        }
    }

    fn look(&mut self, call: &Call) {
        let pixel = self.pixel.0.borrow();
        let digest = &mut self.digest;
        digest.add(1);
        let changes = matches!(
            call,
            Call::Draw { .. }
                | Call::Clear { .. }
                | Call::ClearFloats { .. }
                | Call::ClearIntegers { .. }
                | Call::CopyImage { .. }
                | Call::Swap { .. }
        );
        if changes {
            for &(map, format) in self.maps.values() {
                held(digest, &pixel, map, format);
            }
        }
        match *call {
            Call::Draw { objects } if objects != Objects::Screen => fates(digest, &pixel),
            Call::EndQuery { query } => {
                drop(pixel);
                let samples = self.pixel.samples(query).unwrap();
                self.digest.add(samples as u32);
            }
            _ => {}
        }
    }
}

fn held(digest: &mut Digest, pixel: &Emulator, map: Map, format: Format) {
    if format.has_depth() {
        digest.float(pixel.depths(map).unwrap()[0]);
        digest.add(pixel.stencils(map).unwrap()[0].into());
    } else if matches!(format, Format::R32Ui | Format::Rgba32Ui) {
        let channels = pixel.integers(map).unwrap()[0];
        channels.into_iter().for_each(|channel| digest.add(channel));
    } else {
        digest.floats(&pixel.colors(map).unwrap()[0]);
    }
}

fn fates(digest: &mut Digest, pixel: &Emulator) {
    for fate in &pixel.record().draws.last().unwrap().fates {
        digest.add(fate.order);
        digest.add(match fate.outcome {
            FragmentOutcome::Discarded => 0,
            FragmentOutcome::StencilFail => 1,
            FragmentOutcome::DepthFail => 2,
            FragmentOutcome::Pass => 3,
        });
        for value in fate.stencil {
            digest.add(value.into());
        }
        digest.floats(&fate.stored_depth);
        for texel in fate.colors.iter().flatten() {
            digest.floats(&match texel {
                Texel::Color(color) => *color,
                Texel::Integers(integers) => integers.map(|channel| channel as f32),
            });
        }
    }
}

/// What the verified painter does with a pixel that failed, between two of its texts.
fn resolve(
    watched: &mut Watched<'_>,
    program: &Program,
    rest: &Rest,
    reading: Reading,
    pixel: &Pixel,
) {
    if watched.samples(rest.unless_zero).unwrap() == 0 {
        return;
    }
    let Text::Lists(algorithm, amendments) = &rest.lists else {
        panic!("the rest is pseudocode on lists");
    };
    let list = vec![fragments(pixel)];
    let array = program.array.unwrap();
    let amendments = reading.of(amendments);
    let resolved = run_on_lists(algorithm, &amendments, &list, array, 100).unwrap();
    let (behind, into) = (rest.behind, rest.into);
    let mut emulator = watched.pixel.0.borrow_mut();
    let behind = emulator.colors(behind).unwrap()[0];
    let value = over(pixel, &resolved.pixels[0].composited, behind);
    emulator.allocate(into, COLOR).unwrap();
    let alone = Target("alone");
    emulator.framebuffer_with(alone, &[into], None).unwrap();
    for call in [
        Call::BindFramebuffer { framebuffer: alone },
        Call::ClearFloats {
            drawbuffer: 0,
            value,
        },
    ] {
        emulator.perform(&call).unwrap();
    }
    drop(emulator);
    watched.maps.insert(into.to_string(), (into, COLOR));
    let Text::Listing(listing, amendments) = &rest.then else {
        panic!("a listing comes then");
    };
    run(listing, &reading.of(amendments), Variables::new(), watched).unwrap();
}

/// The surfaces in the order in which the program's method draws them.
pub(crate) fn drawn(program: &Program, pixel: &Pixel) -> Pixel {
    let mut drawn = pixel.clone();
    if program.sorts {
        drawn.sort_by(|a, b| {
            let is_sorted = |it: &Surface| it.group == Group::Sorted;
            let groups = is_sorted(a).cmp(&is_sorted(b));
            let depths = match is_sorted(a) && is_sorted(b) {
                true => a.fragment.depth.total_cmp(&b.fragment.depth),
                false => Ordering::Equal,
            };
            groups.then(depths)
        });
    }
    drawn
}

/// The fragments that the Fill Step leaves: what no opaque surface hides.
pub(crate) fn fragments(pixel: &Pixel) -> Vec<Fragment> {
    let opaque = pixel.iter().filter(|it| it.group == Group::Opaque);
    let opaque = opaque.map(|it| it.fragment.depth).fold(1.0, f32::min);
    let others = pixel.iter().filter(|it| it.group != Group::Opaque);
    let fragments = others.map(|it| it.fragment);
    fragments.filter(|it| it.depth < opaque).collect()
}

/// Surfaces in this order, nearest first, over what lies behind them. Every product and every sum is rounded to 32 bits.
pub(crate) fn over(pixel: &Pixel, composited: &[u32], behind: [f32; 4]) -> [f32; 4] {
    let mut color = [0.0; 4];
    let mut put_under = |layer: [f32; 4]| {
        let visible = 1.0 - color[3];
        for (channel, layer) in color.iter_mut().zip(layer) {
            *channel += layer * visible;
        }
    };
    for &order in composited {
        let [r, g, b, a] = pixel[order as usize].fragment.color.to_array();
        put_under([r * a, g * a, b * a, a]);
    }
    put_under(behind);
    color
}

/// A listing's program, run on a pixel.
pub(crate) struct Emulated {
    pub(crate) digest: [u32; 2],
    pub(crate) said: Vec<String>,
    /// Surfaces that were drawn under others, nearest first.
    pub(crate) composited: Vec<u32>,
}

/// Runs a listing's program as it is read, with these variables. `order` is that of drawing, if it is another than the
/// program's.
pub(crate) fn listing(
    program: &Program,
    reading: Reading,
    pixel: &Pixel,
    variables: &Variables,
    order: Option<&[u32]>,
    detail: bool,
) -> Emulated {
    let Text::Listing(listing, amendments) = &program.text else {
        panic!("{} is pseudocode", program.key);
    };
    let mut emulator = Emulator::new(vec![drawn(program, pixel)]).watching(0);
    if order.is_some() {
        emulator.set_order(order);
    }
    let resources = program.resources();
    allocate_maps(&mut emulator, &resources, COLOR, DEPTH).unwrap();
    let maps = resources.iter().flat_map(|it| it.maps);
    let maps = maps.map(|(map, holds)| (map.to_string(), (*map, holds.format(COLOR, DEPTH))));
    let pixel_machine = Shared(Rc::new(RefCell::new(emulator)));
    let mut beneath = pixel_machine.clone();
    let mut watched = Watched {
        machine: DepthUnits::new(&mut beneath),
        pixel: pixel_machine.clone(),
        maps: maps.collect(),
        digest: Digest::new(detail),
        said: detail.then(Vec::new),
    };
    let outcome = run(
        listing,
        &reading.of(amendments),
        variables.clone(),
        &mut watched,
    )
    .unwrap();
    if let Some(rest) = &program.rest {
        resolve(&mut watched, program, rest, reading, pixel);
    }
    let Watched {
        mut digest, said, ..
    } = watched;
    let emulator = pixel_machine.0.borrow();
    let stopped = outcome.stopped.map(|why| why.to_string());
    digest.text(&stopped.unwrap_or_default());
    held(&mut digest, &emulator, IMAGE_COLOR, COLOR);
    let mut said = said.unwrap_or_default();
    said.push(format!("at the end: {}", digest.take()));
    Emulated {
        digest: digest.value(),
        composited: emulator.composited()[0].clone(),
        said,
    }
}
