//! The maps, buffers, framebuffers and shaders of its listings.

use crate::steps::{Map, Query, Shader, Storage, Target};

/// One counter per pixel, which the Fill Step counts up from 0 or from the pixel's base offset.
pub const COUNTER: Map = Map::named("fragment counter");
/// For PPLL that is filled by atomics, the number of the node at which each pixel's list begins, plus 1, or 0 for an
/// empty list.
pub const ANCHOR: Map = Map::named("list anchor");
/// The costs of each pixel's resolve: records read, fragments composited, subpasses, and the elements of the Local
/// Array that were reserved (upper half) and used.
pub const COST: Map = Map::named("resolve cost");
/// A copy of the opaque depth, because a map that is looked up must not be part of the framebuffer.
pub const RAY_ENDS: Map = Map::named("ray ends");
/// The global memory pool: fragment records.
pub const RECORDS: Storage = Storage("fragment records");
/// For PPLL, the number of the record after each record, plus 1. A list ends by its length.
pub const NEXT: Storage = Storage("list links");
/// For DFB, and for PPLL that is filled in order, each pixel's base offset into the pool.
pub const OFFSETS: Storage = Storage("base offsets");
/// For PPLL that is filled by atomics, the number of nodes that have been taken from the pool.
pub const POOL: Storage = Storage("node pool");
/// The counters and anchors, to be cleared.
pub const CLEARED: Target = Target("clear");
/// The framebuffer in which lists are filled.
pub const FILL: Target = Target("fill");
/// The framebuffer in which lists are resolved: the image over opaque geometry, and [`COST`].
pub const RESOLVED: Target = Target("resolve");
/// The covered pixels that a resolve draws.
pub const COVERED: Query = Query("resolved pixels");

pub(super) const COUNT_ATOMICALLY: Shader = Shader("a_buffer/count");
pub(super) const BEGIN: Shader = Shader("a_buffer/begin");
pub(super) const FILL_ATOMICALLY: Shader = Shader("a_buffer/fill");
pub(super) const FILL_IN_ORDER: Shader = Shader("a_buffer/fill_ordered");
pub(super) const RESOLVE_ALL: Shader = Shader("a_buffer/resolve");
pub(super) const RESOLVE_SEGMENT: Shader = Shader("a_buffer/resolve_segment");
pub(super) const RESOLVE_SEGMENT_OR_REST: Shader = Shader("a_buffer/resolve_segment_or_rest");
