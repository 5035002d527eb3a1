//! Free variables: those that a listing reads and never sets, so that a caller must set them.

use std::collections::BTreeSet;

use super::call::Call;
use super::expr::{Condition, Expr};
use super::listing::Amendment;
use super::listing::{Listing, Step};
use super::names::Name;

/// The names of the variables that a listing or one of its amendments reads and that nothing in it sets, in
/// alphabetical order. They include variables that are read only in steps that an amendment replaces.
pub fn free_variables(listing: &Listing, amendments: &[Amendment]) -> Vec<&'static str> {
    let mut found = Found::default();
    found.steps(listing.steps);
    found.amendments(amendments);
    found.read.difference(&found.set).copied().collect()
}

#[derive(Default)]
struct Found {
    read: BTreeSet<&'static str>,
    set: BTreeSet<&'static str>,
}

impl Found {
    fn amendments(&mut self, amendments: &[Amendment]) {
        amendments.iter().for_each(|it| self.steps(it.amended));
    }

    fn steps(&mut self, steps: &[Step]) {
        steps.iter().for_each(|step| self.step(step));
    }

    fn step(&mut self, step: &Step) {
        match step {
            Step::Call(call) => self.call(call),
            Step::DepthUnit { body, .. } => self.steps(body),
            Step::Let { variable, value } => {
                self.set.insert(variable);
                self.expr(value);
            }
            Step::If {
                condition,
                then,
                otherwise,
            } => {
                self.condition(condition);
                self.steps(then);
                self.steps(otherwise);
            }
            Step::For {
                variable,
                from,
                to,
                body,
            } => {
                self.set.insert(variable);
                self.expr(from);
                self.expr(to);
                self.steps(body);
            }
            Step::ForDown {
                variable,
                from,
                body,
            } => {
                self.set.insert(variable);
                self.expr(from);
                self.steps(body);
            }
            Step::Stop { when, .. } => self.condition(when),
            Step::Run {
                listing,
                amendments,
            } => {
                self.steps(listing.steps);
                self.amendments(amendments);
            }
            Step::Margin(_) => {}
        }
    }

    fn condition(&mut self, condition: &Condition) {
        self.expr(&condition.left);
        self.expr(&condition.right);
    }

    fn expr(&mut self, expr: &Expr) {
        match expr {
            Expr::Number(_) | Expr::Samples(_) => {}
            Expr::Variable(name) => _ = self.read.insert(name),
            Expr::Sum(a, b)
            | Expr::Difference(a, b)
            | Expr::Product(a, b)
            | Expr::Remainder(a, b) => {
                self.expr(a);
                self.expr(b);
            }
        }
    }

    fn call(&mut self, call: &Call) {
        self.read.extend(call.names().filter_map(|name| match name {
            Name::Variable(name) => Some(name),
            _ => None,
        }));
    }
}
