//! The state of a pixel while its list is resolved: a count, a stencil value, and ppDP's Local Array.

use super::ray::Ray;
use crate::fragment::Fragment;
use crate::steps::pseudo::list::{Counter, Element, Key, Mark, Start, Taken};

/// The result at a pixel.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Resolved {
    /// The composited fragments in their order of compositing, each by its place in the order of submission.
    pub composited: Vec<u32>,
    /// How often the pixel was resolved.
    pub times: u32,
    /// How often the pixel's list was walked.
    pub subpasses: u32,
    /// The number of records that were read from it.
    pub records_read: u32,
    /// The number of elements of Local Arrays that were reserved for the pixel, and how many of them held a fragment at
    /// some time.
    pub slots: [u32; 2],
    /// What each walk did.
    pub passes: Vec<Subpass>,
}

/// A walk through a pixel's list. Fragments are given by their places in the order of submission.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Subpass {
    /// The fragments that were skipped, because an earlier walk resolved what lies before them.
    pub skipped: Vec<u32>,
    /// The fragments for which the Local Array had no room, in the order in which they were dropped. A static array is full
    /// before it comes to the last ones.
    pub dropped: Vec<u32>,
    /// The Local Array's fragments at the end, nearest first.
    pub array: Vec<u32>,
    /// The fragments that were composited.
    pub composited: Vec<u32>,
}

pub(super) struct Pixel<'a> {
    pub(super) list: &'a [Fragment],
    pub(super) complexity: u32,
    pub(super) stencil: u8,
    pub(super) marked: bool,
    pub(super) peel: Option<Peel>,
    /// The ray, if there are volumes.
    pub(super) ray: Option<Ray<'a>>,
    pub(super) done: Resolved,
}

/// ppDP's variables.
pub(super) struct Peel {
    n: usize,
    pub(super) buffer: Vec<Fragment>,
    /// Min depth and min id, once they are set. Fragments up to there are skipped.
    pub(super) min: Option<(f32, i64)>,
    /// Whether the subpass has dropped an element.
    pub(super) dropped: bool,
    /// The number of fragments that have been resolved, and the last of them.
    pub(super) resolved: usize,
    last: Option<Fragment>,
}

impl<'a> Pixel<'a> {
    pub(super) fn new(list: &'a [Fragment]) -> Self {
        Self {
            list,
            complexity: 0,
            stencil: 0,
            marked: false,
            peel: None,
            ray: None,
            done: Resolved::default(),
        }
    }

    pub(super) fn count(&mut self, counter: Counter) {
        for _ in self.list {
            match counter {
                Counter::Integer => {}
                Counter::Stencil => self.stencil = self.stencil.saturating_add(1),
                Counter::StencilWrapping => self.stencil = self.stencil.wrapping_add(1),
            }
        }
        self.complexity = self.list.len() as u32;
    }

    pub(super) fn mark(&mut self, mark: Mark, size: u32) {
        match mark {
            Mark::Resolved => self.marked = true,
            Mark::Keep => {}
            Mark::Replace => self.stencil = size.min(255) as u8,
            Mark::Invert => self.stencil = !self.stencil,
        }
    }

    pub(super) fn begin_resolve(&mut self, size: u32) {
        self.done.times += 1;
        self.done.slots[0] += size;
        self.done.slots[1] += size.min(self.list.len() as u32);
    }

    pub(super) fn resolve_statically(&mut self, size: u32) {
        self.begin_resolve(size);
        let fits = self.list.len().min(size as usize);
        self.begin_pass();
        self.done.records_read += fits as u32;
        let (array, rest) = self.list.split_at(fits);
        let array = sorted(array);
        self.pass().dropped = orders(rest);
        self.pass().array = orders(&array);
        self.composite(&array);
    }

    /// Begins a walk.
    pub(super) fn begin_pass(&mut self) {
        self.done.subpasses += 1;
        self.done.passes.push(Subpass::default());
    }

    /// The walk that was begun last.
    pub(super) fn pass(&mut self) -> &mut Subpass {
        if self.done.passes.is_empty() {
            self.done.passes.push(Subpass::default());
        }
        self.done.passes.last_mut().expect("one was pushed")
    }

    pub(super) fn composite(&mut self, fragments: &[Fragment]) {
        let orders = orders(fragments);
        self.done.composited.extend(&orders);
        self.pass().composited.extend(orders);
    }

    pub(super) fn sorted(&self) -> Vec<Fragment> {
        sorted(self.list)
    }
}

pub(super) fn orders(fragments: &[Fragment]) -> Vec<u32> {
    fragments.iter().map(|fragment| fragment.order).collect()
}

/// The order by depth, then by id.
fn sorted(list: &[Fragment]) -> Vec<Fragment> {
    let mut array = list.to_vec();
    array.sort_by(|a, b| (a.depth.total_cmp(&b.depth)).then(a.order.cmp(&b.order)));
    array
}

impl Peel {
    pub(super) fn new(size: u32) -> Self {
        Self {
            n: size as usize,
            buffer: Vec::new(),
            min: None,
            dropped: false,
            resolved: 0,
            last: None,
        }
    }

    pub(super) fn start(&mut self, start: Start) {
        self.min = Some(match start {
            Start::Zero => (0.0, i64::MAX),
            Start::BeforeAll => (f32::NEG_INFINITY, -1),
        });
    }

    /// Returns the element that this drops.
    pub(super) fn insert(&mut self, f: Fragment, key: Key) -> Option<Fragment> {
        let before = |other: &Fragment| {
            f.depth < other.depth
                || (key == Key::DepthAndId && f.depth == other.depth && f.order < other.order)
        };
        let at = self.buffer.iter().position(before);
        self.buffer.insert(at.unwrap_or(self.buffer.len()), f);
        if self.buffer.len() <= self.n {
            return None;
        }
        self.dropped = true;
        self.buffer.pop()
    }

    pub(super) fn resolve(&mut self, taken: Taken) -> Vec<Fragment> {
        let count = match taken {
            Taken::AllButLastOnOverflow if self.dropped => self.n - 1,
            Taken::All | Taken::AllButLastOnOverflow => self.buffer.len(),
        };
        let taken = &self.buffer[..count];
        self.resolved += count;
        self.last = taken.last().copied().or(self.last);
        taken.to_vec()
    }

    pub(super) fn store(&mut self, key: Key, element: Element) {
        let stored = match element {
            Element::Last => self.buffer.last().copied(),
            Element::LastResolved => self.last,
        };
        if let Some(stored) = stored {
            let id = match key {
                // Every id at that depth.
                Key::Depth => i64::MAX,
                Key::DepthAndId => i64::from(stored.order),
            };
            self.min = Some((stored.depth, id));
        }
    }
}
