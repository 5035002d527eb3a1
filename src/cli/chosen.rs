//! The options of methods, from the registry. An option belongs to the methods that have it.

use std::sync::LazyLock;

use clap::builder::PossibleValuesParser;
use clap::{Arg, ArgAction, ArgMatches, Args, Command, FromArgMatches};
use onionskin::low_level::methods::{Choice, Listed, Takes, Technique, methods_with};
use onionskin::{Method, Result, registry};

use super::words::possible;

/// The options that are given on the command line, by name and value.
pub(super) struct Chosen(Vec<(&'static str, String)>);

impl Chosen {
    /// Whether any option is given.
    pub(super) fn is_any(&self) -> bool {
        !self.0.is_empty()
    }

    /// Whether this option is given.
    pub(super) fn has(&self, name: &str) -> bool {
        self.value(name).is_some()
    }

    /// The value of this option as text, or `None` if it is not given.
    pub(super) fn value(&self, name: &str) -> Option<&str> {
        let chosen = self.0.iter().find(|(chosen, _)| *chosen == name);
        chosen.map(|(_, value)| value.as_str())
    }

    /// The method with these options.
    ///
    /// # Errors
    /// If the method does not have an option, or options do not fit together.
    pub(super) fn apply_to(&self, mut method: Method) -> Result<Method> {
        for (name, value) in &self.0 {
            method.choose(name, value)?;
        }
        method.check()?;
        Ok(method)
    }
}

/// An option, its default, and the heading under which the help has it.
struct Offer {
    choice: Choice,
    default: Option<String>,
    heading: String,
}

/// Every option of the methods of the registry, in the registry's order and without repetition.
fn offered() -> &'static [Offer] {
    static OFFERED: LazyLock<Vec<Offer>> = LazyLock::new(|| {
        let mut offered: Vec<Offer> = Vec::new();
        for Listed { method, .. } in registry() {
            for choice in method.choices() {
                if offered.iter().all(|other| other.choice.name != choice.name) {
                    offered.push(Offer {
                        choice,
                        default: method.value(choice.name),
                        heading: format!("Options of {}", methods_with(choice.name).join(", ")),
                    });
                }
            }
        }
        offered
    });
    &OFFERED
}

fn argument(offer: &'static Offer) -> Arg {
    let Offer {
        choice,
        default,
        heading,
    } = offer;
    let default = default.as_ref().map(|value| format!(" [default: {value}]"));
    let argument = Arg::new(choice.name)
        .long(choice.name)
        .help(choice.help.to_owned() + &default.unwrap_or_default())
        .help_heading(heading.as_str());
    match choice.takes {
        Takes::Nothing => argument.action(ArgAction::SetTrue),
        Takes::Value(name) => argument.value_name(name),
        Takes::Word(words) => argument
            .value_name("WORD")
            .value_parser(PossibleValuesParser::new(possible(words.iter()))),
    }
}

impl Args for Chosen {
    fn augment_args(command: Command) -> Command {
        command.args(offered().iter().map(argument))
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl FromArgMatches for Chosen {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let chosen = offered().iter().filter_map(|Offer { choice, .. }| {
            let value = match choice.takes {
                Takes::Nothing => matches.get_flag(choice.name).then(String::new),
                Takes::Value(_) | Takes::Word(_) => matches.get_one(choice.name).cloned(),
            };
            value.map(|value| (choice.name, value))
        });
        Ok(Self(chosen.collect()))
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}
