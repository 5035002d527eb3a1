//! Walking a listing: evaluating its expressions, resolving its names, and handing its calls to a machine.

use super::amend::{Met, Scope, Spelling};
use super::call::Call;
use super::expr::{Condition, Expr, Variables};
use super::format::Format;
use super::listing::{Amendment, Dialect, Listing, Reason, Step};
use super::names::{Map, Query, Target};
use super::origin::Origin;
use crate::error::{Error, Result};

/// A machine, which performs calls.
pub trait Machine {
    /// Performs a call. The call is resolved: no [`Map`] and no [`Number`](super::Number) in it is a variable.
    ///
    /// # Errors
    /// If the machine cannot perform the call. The error names the call.
    fn perform(&mut self, call: &Call) -> Result<()>;

    /// The number of samples that passed the depth and stencil tests between the query's last begin and end.
    ///
    /// # Errors
    /// If the query has never been made.
    fn samples(&mut self, query: Query) -> Result<u64>;

    /// Says which line of which listing the next call comes from. Only machines that keep a record of it do anything.
    fn follow(&mut self, _: &CallLine) {}
}

/// A line of a listing that is a call: as it is written, with the names of variables.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CallLine {
    /// The listing's title. Another listing may run it.
    pub title: &'static str,
    /// Where the listing is printed: paper, section, listing.
    pub source: &'static str,
    /// The listing's way of writing.
    pub dialect: Dialect,
    /// The call.
    pub call: Call,
    /// Where the line comes from, or `None` if nothing says so.
    pub origin: Option<Origin>,
    /// The paper's own spelling, if it is not how listings are printed anyway.
    pub spelling: Option<Spelling>,
}

/// A machine that can be given maps, and framebuffers that draw into them.
pub trait Workspace: Machine {
    /// Makes a map of the image's size, unless it exists in this format.
    ///
    /// # Errors
    /// If the machine has too little memory.
    fn allocate(&mut self, map: Map, format: Format) -> Result<()>;

    /// Makes a framebuffer that draws into these maps, the first color for the shaders' location 0.
    ///
    /// # Errors
    /// If a map is missing, or the combination is not possible.
    fn framebuffer_with(
        &mut self,
        target: Target,
        colors: &[Map],
        depth: Option<Map>,
    ) -> Result<()>;
}

/// The result of a listing, besides the machine's state.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Outcome {
    /// The reason for which the last stopped loop was left, or `None` if every loop ran to its end.
    pub stopped: Option<Reason>,
    /// The variables at the end.
    pub variables: Variables,
}

/// Runs a listing on a machine. The amendments hold in it and in every listing that it runs.
///
/// Names are not checked beforehand, because only its caller knows what the machine has been given. A machine refuses a map,
/// a buffer or a shader that it does not have when it comes to it, and says which was probably meant; a framebuffer's maps
/// may be attached later, so a misspelt one is only noticed when something is drawn. [`check`](super::check) looks at every
/// name in every branch before anything runs; methods do so with a user's amendments.
///
/// # Errors
/// The machine's errors, or an error if a variable is read before it is set.
pub fn run(
    listing: &Listing,
    amendments: &[Amendment],
    variables: Variables,
    machine: &mut impl Machine,
) -> Result<Outcome> {
    let outcome = Outcome {
        stopped: None,
        variables,
    };
    let mut walk = Walk {
        machine,
        listing: Named::of(listing),
        outcome,
    };
    walk.steps(listing.steps, Scope::of(amendments))?;
    Ok(walk.outcome)
}

struct Walk<'a, M> {
    machine: &'a mut M,
    /// The innermost listing.
    listing: Named,
    outcome: Outcome,
}

/// A listing without its steps.
struct Named {
    title: &'static str,
    source: &'static str,
    dialect: Dialect,
}

impl Named {
    fn of(listing: &Listing) -> Self {
        Self {
            title: listing.title,
            source: listing.source,
            dialect: listing.dialect,
        }
    }
}

/// Whether the innermost loop goes on.
#[derive(PartialEq)]
enum Flow {
    On,
    Stop,
}

impl<M: Machine> Walk<'_, M> {
    fn steps(&mut self, steps: &'static [Step], scope: Scope<'_, Step>) -> Result<Flow> {
        for met in scope.walk(steps) {
            if let Met::Statement(step, scope) = met
                && self.step(step, scope)? == Flow::Stop
            {
                return Ok(Flow::Stop);
            }
        }
        Ok(Flow::On)
    }

    fn step(&mut self, step: &Step, scope: Scope<'_, Step>) -> Result<Flow> {
        match *step {
            Step::Call(call) => {
                self.machine.follow(&CallLine {
                    title: self.listing.title,
                    source: self.listing.source,
                    dialect: self.listing.dialect,
                    call,
                    origin: scope.origin(),
                    spelling: scope.spelling(),
                });
                let call = call.resolved(&|name| self.variable(name))?;
                self.machine.perform(&call)?;
            }
            Step::DepthUnit { unit, body } => {
                self.machine.perform(&Call::ActiveDepthUnit { unit })?;
                return self.steps(body, scope);
            }
            Step::Let { variable, value } => {
                let value = self.value(&value)?;
                self.outcome.variables.set(variable, value);
            }
            Step::If {
                condition,
                then,
                otherwise,
            } => {
                let branch = if self.holds(&condition)? {
                    then
                } else {
                    otherwise
                };
                return self.steps(branch, scope);
            }
            Step::For {
                variable,
                from,
                to,
                body,
            } => {
                let mut number = self.value(&from)?;
                while number < self.value(&to)? {
                    self.outcome.variables.set(variable, number);
                    if self.steps(body, scope)? == Flow::Stop {
                        break;
                    }
                    number += 1.0;
                }
            }
            Step::ForDown {
                variable,
                from,
                body,
            } => {
                let mut number = self.value(&from)?;
                while number > 0.0 {
                    number -= 1.0;
                    self.outcome.variables.set(variable, number);
                    if self.steps(body, scope)? == Flow::Stop {
                        break;
                    }
                }
            }
            Step::Stop { when, why } => {
                if self.holds(&when)? {
                    self.outcome.stopped = Some(why);
                    return Ok(Flow::Stop);
                }
            }
            Step::Run {
                listing,
                amendments,
            } => {
                let outer = std::mem::replace(&mut self.listing, Named::of(listing));
                self.steps(listing.steps, scope.around(amendments))?;
                self.listing = outer;
            }
            Step::Margin(_) => {}
        }
        Ok(Flow::On)
    }

    fn holds(&mut self, condition: &Condition) -> Result<bool> {
        Ok(condition
            .compare
            .holds(self.value(&condition.left)?, self.value(&condition.right)?))
    }

    fn value(&mut self, expr: &Expr) -> Result<f64> {
        Ok(match *expr {
            Expr::Number(number) => number,
            Expr::Variable(name) => self.variable(name)?,
            // This is exact up to 2^53 samples.
            Expr::Samples(query) => self.machine.samples(query)? as f64,
            Expr::Sum(a, b) => self.value(a)? + self.value(b)?,
            Expr::Difference(a, b) => self.value(a)? - self.value(b)?,
            Expr::Product(a, b) => self.value(a)? * self.value(b)?,
            Expr::Remainder(a, b) => self.value(a)?.rem_euclid(self.value(b)?),
        })
    }

    fn variable(&self, name: &'static str) -> Result<f64> {
        self.outcome.variables.get(name).ok_or_else(|| {
            Error::out_of_order(
                format!("the listing reads the variable {name} before it is set"),
                "set it in the listing, or in the variables it is run with",
            )
        })
    }
}
