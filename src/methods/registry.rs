//! The registry of methods. It feeds the command line, the help, the documentation and the tests.

use std::fmt;
use std::ops::Deref;
use std::str::FromStr;
use std::sync::LazyLock;

use super::algorithm::{Algorithm, Setup};
use super::choice::{Choice, Setter};
use super::entry::Entry;
use super::technique::{Published, Technique};
use super::*;
use crate::error::{Error, Result, did_you_mean};

/// Every method in one line, in the order in which `compare` shows them. A line has the method's file, its name as a
/// [`Method`], and the type of its options if it has any. The file has the method's [`Entry`]. This list alone makes
/// the method a module, a [`Method`], a row of every table, and a word on the command line.
macro_rules! every_method {
    ($receiver:ident) => {
        $receiver! {
            blend: Blend,
            painter: Painter,
            weighted_blended: WeightedBlended(WeightedBlendedOptions),
            multi_layer_alpha_blending: MultiLayerAlphaBlending(MultiLayerOptions),
            depth_peeling: DepthPeeling(DepthPeelingOptions),
            dual_depth_peeling: DualDepthPeeling(DualDepthPeelingOptions),
            coplanar_depth_peeling: CoplanarDepthPeeling(CoplanarDepthPeelingOptions),
            layer_peeling: LayerPeeling(LayerPeelingOptions),
            hybrid_layer_peeling: HybridLayerPeeling(HybridLayerPeelingOptions),
            coherent_layer_peeling: CoherentLayerPeeling(CoherentOptions),
            ideal_coherent_layer_peeling: IdealCoherentLayerPeeling(IdealOptions),
            a_buffer: ABuffer(ABufferOptions),
            verified_painter: VerifiedPainter,
            automatic: Automatic,
            exact: Exact,
        }
    };
}

macro_rules! method {
    ($($file:ident: $name:ident $(($options:ident))?,)*) => {
        /// A published method with its options.
        #[derive(Clone, Copy, Debug, PartialEq)]
        #[non_exhaustive]
        pub enum Method {
            $(#[doc = of!(doc $name $($options)?)] $name $(($options))?,)*
        }

        impl Method {
            fn technique(&self) -> &dyn Technique {
                match self {
                    $(of!(pattern options $name $($options)?) => of!(value options $name $($options)?),)*
                }
            }

            /// The method's options.
            pub fn choices(&self) -> Vec<Choice> {
                match self {
                    $(of!(pattern _ $name $($options)?) => choices(of!(setters $name $($options)?)),)*
                }
            }

            /// Sets an option by name. The value is ignored if the option takes none.
            ///
            /// # Errors
            /// If the method has no such option, or the value is wrong for it. [`Technique::check`] says whether values
            /// fit together.
            pub fn choose(&mut self, name: &str, value: &str) -> Result<()> {
                let method = *self;
                match self {
                    $(of!(pattern options $name $($options)?) => choose(method, of!(mutable options $name $($options)?), name, value),)*
                }
            }

            /// The value of an option by name, as text. `None` if the method has no such option, if the option takes no
            /// value, or if its value has no short text.
            pub fn value(&self, name: &str) -> Option<String> {
                match self {
                    $(of!(pattern options $name $($options)?) => value(*of!(value options $name $($options)?), name),)*
                }
            }

            fn all() -> Vec<Self> {
                let mut all = Vec::new();
                $(all.extend(of!(variants $name $($options)?));)*
                all
            }
        }
    };
}

/// The parts that differ between a method with options and one without.
macro_rules! of {
    (doc $name:ident) => {
        concat!(
            "[`",
            stringify!($name),
            "`](crate::methods::",
            stringify!($name),
            "), without options."
        )
    };
    (doc $name:ident $options:ident) => {
        concat!("With its [`", stringify!($options), "`].")
    };
    (pattern $bound:tt $name:ident) => {
        Self::$name
    };
    (pattern $bound:tt $name:ident $options:ident) => {
        Self::$name($bound)
    };
    (value $bound:ident $name:ident) => {
        &$name
    };
    (value $bound:ident $name:ident $options:ident) => {
        $bound
    };
    (mutable $bound:ident $name:ident) => {
        &mut $name
    };
    (mutable $bound:ident $name:ident $options:ident) => {
        $bound
    };
    (setters $name:ident) => {
        $name::CHOICES
    };
    (setters $name:ident $options:ident) => {
        $options::CHOICES
    };
    (variants $name:ident) => {
        $name::variants().into_iter().map(|$name| Self::$name)
    };
    (variants $name:ident $options:ident) => {
        $options::variants().into_iter().map(Self::$name)
    };
}

every_method!(method);

impl Default for Method {
    /// A quick exact method for the scene.
    fn default() -> Self {
        Self::Automatic
    }
}

fn choices<O>(setters: &[Setter<O>]) -> Vec<Choice> {
    setters.iter().map(|setter| setter.choice).collect()
}

fn choose<O: Published>(method: Method, options: &mut O, name: &str, value: &str) -> Result<()> {
    let setter = O::CHOICES.iter().find(|setter| setter.choice.name == name);
    let Some(setter) = setter else {
        return Err(refusal(method, name));
    };
    setter.set(options, value).map_err(|error| match error {
        Error::Usage { what, remedy } => Error::option(name, what, remedy),
        Error::Unknown {
            kind,
            name: word,
            known,
        } => Error::option(
            name,
            format!("there is no {kind} '{word}'"),
            did_you_mean(&word, &known),
        ),
        error => error,
    })
}

fn value<O: Published>(options: O, name: &str) -> Option<String> {
    let setter = O::CHOICES.iter().find(|setter| setter.choice.name == name);
    setter?.text(options)
}

/// The error for an unknown option: the methods that have it, and the options of this method.
fn refusal(method: Method, name: &str) -> Error {
    let who = methods_with(name);
    let own: Vec<_> = method.choices().iter().map(|choice| choice.name).collect();
    let own = match own.is_empty() {
        true => format!("{method} has no options"),
        false => format!("{method} has {}", own.join(", ")),
    };
    let remedy = match who.is_empty() {
        true => own,
        false => format!("it is an option of {}; {own}", who.join(", ")),
    };
    Error::option(name, format!("{method} has no such option"), remedy)
}

/// The methods that have an option. Of a name with a `+`, only the part before it is kept.
pub fn methods_with(option: &str) -> Vec<&'static str> {
    let rows = registry().iter().filter(|row| row.method.has(option));
    let mut names: Vec<_> = rows.filter_map(|row| row.name.split('+').next()).collect();
    names.dedup();
    names
}

/// A row of the registry: a method with its default options, and its facts.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct Listed {
    /// The method.
    pub method: Method,
    /// The method's entry. Its fields are also the row's, as in `row.name`.
    pub entry: &'static Entry,
}

impl Deref for Listed {
    type Target = Entry;

    fn deref(&self) -> &Entry {
        self.entry
    }
}

/// Every method, in the order in which `compare` shows them.
pub fn registry() -> &'static [Listed] {
    static REGISTRY: LazyLock<Vec<Listed>> = LazyLock::new(|| {
        let rows = Method::all().into_iter().map(|method| Listed {
            method,
            entry: method.entry(),
        });
        rows.collect()
    });
    &REGISTRY
}

impl Method {
    /// The method's name in the registry.
    pub fn name(&self) -> &'static str {
        self.entry().name
    }

    /// Whether it has an option of this name.
    pub fn has(&self, name: &str) -> bool {
        self.choices().iter().any(|choice| choice.name == name)
    }

    /// The method's entry in the registry.
    pub fn entry(&self) -> &'static Entry {
        self.technique().entry()
    }
}

impl Technique for Method {
    fn entry(&self) -> &'static Entry {
        self.technique().entry()
    }

    fn algorithm(&self, setup: &Setup) -> Box<dyn Algorithm> {
        self.technique().algorithm(setup)
    }

    fn check(&self) -> Result<()> {
        self.technique().check()
    }

    fn needs_window_depth(&self) -> Option<&'static str> {
        self.technique().needs_window_depth()
    }
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl FromStr for Method {
    type Err = Error;

    /// A method by its name, with its default options.
    fn from_str(name: &str) -> Result<Self> {
        let found = registry().iter().find(|row| row.name == name);
        found.map(|row| row.method).ok_or_else(|| {
            let names: Vec<_> = registry().iter().map(|row| row.name).collect();
            Error::unknown("method", name, &names)
        })
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::*;
    use crate::methods::Takes;

    #[test]
    fn every_word_that_is_offered_can_be_chosen_and_no_other() {
        for row in registry() {
            for choice in row.method.choices() {
                let mut method = row.method;
                match choice.takes {
                    Takes::Nothing => method.choose(choice.name, "").unwrap(),
                    Takes::Word(words) => {
                        let mut choose = |word| method.choose(choice.name, word);
                        words.iter().for_each(|(word, _)| choose(word).unwrap());
                        assert!(choose("").is_err(), "{} {}", row.name, choice.name);
                    }
                    Takes::Value(_) => {
                        assert!(method.choose(choice.name, "").is_err(), "{}", choice.name);
                    }
                }
            }
        }
    }

    #[test]
    fn every_value_that_is_shown_can_be_chosen_and_is_the_same_for_all_methods() {
        let mut shown: BTreeMap<&str, String> = BTreeMap::new();
        for row in registry() {
            for choice in row.method.choices() {
                let Some(value) = row.method.value(choice.name) else {
                    continue;
                };
                let mut method = row.method;
                method.choose(choice.name, &value).unwrap();
                assert_eq!(method, row.method, "{} {value}", choice.name);
                // The help has one default for each option.
                let first = shown.entry(choice.name).or_insert(value.clone());
                assert_eq!(*first, value, "{} {}", row.name, choice.name);
            }
        }
        assert!(shown.len() > 10, "{shown:?}");
    }

    #[test]
    fn a_value_that_was_chosen_is_shown() {
        let mut method: Method = "dual-depth-peeling".parse().unwrap();
        assert_eq!(method.value("peels").as_deref(), Some("0"));
        method.choose("peels", "3").unwrap();
        assert_eq!(method.value("peels").as_deref(), Some("3"));
        assert_eq!(method.value("layers"), None);
    }

    #[test]
    fn names_are_unique_and_lead_back_to_their_methods() {
        for row in registry() {
            assert_eq!(row.name.parse::<Method>().unwrap(), row.method);
            assert_eq!(row.method.entry(), row.entry);
        }
        let error = "peeling".parse::<Method>().unwrap_err().to_string();
        assert!(error.contains("depth-peeling"), "{error}");
    }

    #[test]
    fn what_another_method_has_is_refused_and_its_owner_named() {
        let error = Method::Blend.choose("peels", "0").unwrap_err().to_string();
        assert!(error.contains("blend has no such option"), "{error}");
        assert!(error.contains("coplanar-depth-peeling"), "{error}");
    }
}
