//! Whether everything that a listing names exists, before any of it runs.
//!
//! A machine finds a misspelt name when it comes to it: in the third round of a loop, or in a branch that is seldom taken,
//! or never. [`check`] looks at every step, with amendments in place, and at every branch.

use std::collections::BTreeSet;
use std::fmt;

use super::amend::{Met, Scope};
use super::call::Call;
use super::expr::{Condition, Expr};
use super::listing::{Amendment, Listing, Step};
use super::names::{Index, Map, Name, Query, Shader};
use super::resources::Resources;
use crate::error::{Error, Result, did_you_mean};

/// The resources that listings may name. A listing may also name the variables that it sets and the queries that it
/// makes.
#[derive(Clone, Debug, Default)]
pub struct Known {
    resources: Vec<&'static Resources>,
    shaders: Vec<String>,
    variables: Vec<&'static str>,
}

impl Known {
    /// The names of these shaders, and nothing else. Only a machine knows which shaders exist.
    pub fn shaders(shaders: impl IntoIterator<Item = impl Into<String>>) -> Self {
        Self {
            shaders: shaders.into_iter().map(Into::into).collect(),
            ..Self::default()
        }
    }

    /// And these resources.
    #[must_use]
    pub fn with(mut self, resources: &[&'static Resources]) -> Self {
        self.resources.extend_from_slice(resources);
        self
    }

    /// And these variables, which have values already.
    #[must_use]
    pub fn with_variables(mut self, names: impl IntoIterator<Item = &'static str>) -> Self {
        self.variables.extend(names);
        self
    }

    /// The shaders that exist, and of them those that the resources name, if any do.
    fn drawn_with(&self) -> impl Iterator<Item = &str> {
        let named = self.resources.iter().filter_map(|it| it.shaders);
        let named: Vec<_> = named.collect();
        let existing = self.shaders.iter().map(String::as_str);
        existing.filter(move |shader| {
            let names = |it: &&[Shader]| it.iter().any(|other| other.0 == *shader);
            named.is_empty() || named.iter().any(names)
        })
    }

    fn maps(&self) -> Vec<Map> {
        let maps = |it: &&Resources| it.maps.iter().map(|(map, _)| *map).chain(it.made.to_vec());
        self.resources.iter().flat_map(maps).collect()
    }
}

/// Checks a listing with the amendments in place that it will run with.
///
/// # Errors
/// If it names a map, a framebuffer, a shader, a storage buffer, a variable or a query that is not known: the first such,
/// where it stands, and the name that was probably meant.
pub fn check(listing: &Listing, amendments: &[Amendment], known: &Known) -> Result<()> {
    let mut found = Found::default();
    found.steps(listing.steps, Scope::of(amendments));
    let names = Names::of(known, &found);
    for (name, place) in &found.names {
        names
            .expect(name)
            .map_err(|Unknown { what, remedy }| Error::Listing {
                listing: listing.title,
                what: format!("names {what}, which does not exist: {place}"),
                remedy,
            })?;
    }
    for (query, place) in &found.begun {
        if !found.ended.contains(query.0) {
            return Err(Error::Listing {
                listing: listing.title,
                what: format!("begins the query '{}' and never ends it: {place}", query.0),
                remedy: "end it behind the draws that it counts: glEndQuery".into(),
            });
        }
    }
    Ok(())
}

/// Everything that a listing names, each with its place, and the names that it sets and makes itself.
#[derive(Default)]
struct Found {
    names: Vec<(Name, String)>,
    set: BTreeSet<&'static str>,
    begun: Vec<(Query, String)>,
    ended: BTreeSet<&'static str>,
}

impl Found {
    fn steps(&mut self, steps: &'static [Step], scope: Scope<'_, Step>) {
        for met in scope.walk(steps) {
            if let Met::Statement(step, scope) = met {
                self.step(step, scope);
            }
        }
    }

    fn step(&mut self, step: &Step, scope: Scope<'_, Step>) {
        match *step {
            Step::Call(call) => self.call(&call),
            Step::DepthUnit { body, .. } => self.steps(body, scope),
            Step::Let { variable, value } => {
                self.expr(&value, format_args!("{variable} = {value}"));
                self.set.insert(variable);
            }
            Step::If {
                condition,
                then,
                otherwise,
            } => {
                self.condition(&condition);
                self.steps(then, scope);
                self.steps(otherwise, scope);
            }
            Step::For {
                variable,
                from,
                to,
                body,
            } => {
                let place = format_args!("for {variable} from {from} to {to}");
                self.expr(&from, place);
                self.expr(&to, place);
                self.set.insert(variable);
                self.steps(body, scope);
            }
            Step::ForDown {
                variable,
                from,
                body,
            } => {
                self.expr(&from, format_args!("for {variable} from {from} down"));
                self.set.insert(variable);
                self.steps(body, scope);
            }
            Step::Stop { when, .. } => self.condition(&when),
            Step::Run {
                listing,
                amendments,
            } => self.steps(listing.steps, scope.around(amendments)),
            Step::Margin(_) => {}
        }
    }

    fn call(&mut self, call: &Call) {
        match *call {
            Call::BeginQuery { query } => self.begun.push((query, call.to_string())),
            Call::EndQuery { query } => {
                self.ended.insert(query.0);
            }
            _ => {}
        }
        let place = call.to_string();
        self.names
            .extend(call.names().map(|name| (name, place.clone())));
    }

    fn condition(&mut self, condition: &Condition) {
        self.expr(&condition.left, format_args!("{condition}"));
        self.expr(&condition.right, format_args!("{condition}"));
    }

    fn expr(&mut self, expr: &Expr, place: fmt::Arguments<'_>) {
        let name = match *expr {
            Expr::Number(_) => return,
            Expr::Variable(name) => Name::Variable(name),
            Expr::Samples(query) => Name::Query(query),
            Expr::Sum(a, b)
            | Expr::Difference(a, b)
            | Expr::Product(a, b)
            | Expr::Remainder(a, b) => {
                self.expr(a, place);
                return self.expr(b, place);
            }
        };
        self.names.push((name, place.to_string()));
    }
}

/// Every name that may be named.
struct Names<'k> {
    maps: Vec<Map>,
    targets: Vec<&'static str>,
    shaders: Vec<&'k str>,
    storages: Vec<&'static str>,
    queries: Vec<&'static str>,
    variables: Vec<&'static str>,
}

struct Unknown {
    what: String,
    remedy: String,
}

impl<'k> Names<'k> {
    fn of(known: &'k Known, found: &Found) -> Self {
        let all = known.resources.iter();
        let targets = all
            .clone()
            .flat_map(|it| it.framebuffers)
            .map(|it| it.target.0);
        let storages = all.clone().flat_map(|it| it.storages).map(|it| it.0);
        let given = all.flat_map(|it| it.variables).chain(&known.variables);
        Self {
            maps: known.maps(),
            targets: targets.collect(),
            shaders: known.drawn_with().collect(),
            storages: storages.collect(),
            queries: found.begun.iter().map(|(query, _)| query.0).collect(),
            variables: given.chain(&found.set).copied().collect(),
        }
    }

    fn expect(&self, name: &Name) -> std::result::Result<(), Unknown> {
        let (kind, word, words) = match *name {
            Name::Map(map) => return self.expect_map(map),
            Name::Target(target) => ("framebuffer", target.0, &self.targets),
            Name::Shader(shader) => ("shader", shader.0, &self.shaders),
            Name::Storage(storage) => ("storage buffer", storage.0, &self.storages),
            Name::Query(query) => ("query", query.0, &self.queries),
            Name::Variable(name) => ("variable", name, &self.variables),
        };
        match words.contains(&word) {
            true => Ok(()),
            false => Err(Unknown {
                what: format!("the {kind} '{word}'"),
                remedy: meant(word, words),
            }),
        }
    }

    /// A map of a row is known if the row is, with any variable.
    fn expect_map(&self, map: Map) -> std::result::Result<(), Unknown> {
        let same = |other: &Map| {
            other.name == map.name
                && match (other.index, map.index) {
                    (Index::Only, _) | (_, Index::Only) => other.index == map.index,
                    (Index::Number(a), Index::Number(b)) => a == b,
                    _ => true,
                }
        };
        if self.maps.iter().any(same) {
            return Ok(());
        }
        let names: Vec<String> = self.maps.iter().map(Map::to_string).collect();
        let words: Vec<&str> = names.iter().map(String::as_str).collect();
        Err(Unknown {
            what: format!("the map '{map}'"),
            remedy: meant(&map.to_string(), &words),
        })
    }
}

fn meant(word: &str, words: &[&str]) -> String {
    let words: BTreeSet<&str> = words.iter().copied().collect();
    match words.is_empty() {
        true => "There is none.".into(),
        false => did_you_mean(word, &words.into_iter().collect::<Vec<_>>()),
    }
}
