//! Listing 1's imaginary OpenGL, on a real one.
//!
//! Everitt writes depth peeling for an OpenGL with several depth units, then observes that a shadow map which has the
//! camera's own orientation and resolution *is* a read-only depth test ("Shadow Mapping as Depth Test"). So:
//!
//! | listing | depth unit 0 | depth unit 1 |
//! | --- | --- | --- |
//! | bind buffer | bound as a texture for shadow lookups | attached to the framebuffer |
//! | set depth func | the lookup's compare function | `glDepthFunc` |
//! | enable, disable depth test | that function, or `ALWAYS` | `glEnable`, `glDisable` |
//! | disable depth writes | nothing to do: a texture is not written | `glDepthMask` |
//!
//! The shader discards a fragment if the lookup answers 0. Everitt writes the answer into alpha and lets the alpha test
//! discard, which is the same in the GL of his year.

use super::call::Call;
use super::constants::{Buffers, Capability, Compare};
use super::names::Query;
use super::walk::{CallLine, Machine};
use crate::error::{Error, Result};

/// A machine with two depth units, made from one with a single depth buffer and shadow lookups.
#[derive(Debug)]
pub struct DepthUnits<'a, M> {
    machine: &'a mut M,
    /// The unit to which calls go. Outside of a `depth unit` block it is unit 1, the ordinary depth buffer.
    active: u8,
    /// Unit 0's comparison, and whether its test is enabled. These are two states in the listing, and one in a texture.
    func: Compare,
    enabled: bool,
}

impl<'a, M: Machine> DepthUnits<'a, M> {
    /// A machine whose unit 0 tests nothing yet.
    pub fn new(machine: &'a mut M) -> Self {
        Self {
            machine,
            active: 1,
            func: Compare::Less,
            enabled: false,
        }
    }

    fn unit_0(&mut self, call: &Call) -> Result<()> {
        match *call {
            Call::BindDepthBuffer { buffer } => {
                self.machine.perform(&Call::ActiveTexture { unit: 0 })?;
                self.machine.perform(&Call::BindTexture { texture: buffer })
            }
            Call::DepthFunc { func } => {
                self.func = func;
                self.compare()
            }
            Call::Enable {
                cap: Capability::DepthTest,
            } => {
                self.enabled = true;
                self.compare()
            }
            Call::Disable {
                cap: Capability::DepthTest,
            } => {
                self.enabled = false;
                self.compare()
            }
            Call::DepthMask { flag: false } => Ok(()),
            Call::DepthMask { flag: true }
            | Call::Clear {
                mask: Buffers { depth: true, .. },
            } => Err(Error::CannotPerform {
                machine: "depth unit 0",
                call: call.to_string(),
                why: "it is a shadow map, which is only looked up",
                remedy: "let depth unit 1 do it",
            }),
            // Color, stencil and draws belong to no unit.
            _ => self.machine.perform(call),
        }
    }

    fn compare(&mut self) -> Result<()> {
        let func = if self.enabled {
            self.func
        } else {
            Compare::Always
        };
        self.machine.perform(&Call::SamplerCompareFunc { func })
    }
}

impl<M: Machine> Machine for DepthUnits<'_, M> {
    fn perform(&mut self, call: &Call) -> Result<()> {
        match *call {
            Call::ActiveDepthUnit { unit: unit @ 0..=1 } => {
                self.active = unit;
                Ok(())
            }
            Call::ActiveDepthUnit { unit } => Err(Error::usage(
                format!("there is no depth unit {unit}"),
                "Listing 1 has two depth units: 0 peels, 1 is the ordinary depth buffer",
            )),
            _ if self.active == 0 => self.unit_0(call),
            Call::BindDepthBuffer { buffer } => {
                self.machine.perform(&Call::AttachDepth { texture: buffer })
            }
            _ => self.machine.perform(call),
        }
    }

    fn samples(&mut self, query: Query) -> Result<u64> {
        self.machine.samples(query)
    }

    fn follow(&mut self, line: &CallLine) {
        self.machine.follow(line);
    }
}
