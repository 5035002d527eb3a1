//! The report of a driver: its limits, its missing features, and its known traps.

use std::fmt;

use clap::ValueEnum;
use onionskin::low_level::gl::{Driver, GlMachine, Profile, Trap, WANTED_EXTENSIONS};
use onionskin::{Backend, Context, ContextOptions, Result, registry};
use serde::{Serialize, Serializer};

use super::output::{print_json, say};

/// The form in which a report is printed.
#[derive(Clone, Copy, ValueEnum)]
pub(super) enum Form {
    Text,
    Json,
}

/// Prints the report.
#[derive(Serialize)]
pub(super) struct Report {
    backend: String,
    works: bool,
    /// The backend does not work, and is not needed.
    optional: bool,
    answer: Option<String>,
    renderer: Option<String>,
    version: Option<String>,
    compatibility_profile: bool,
    #[serde(serialize_with = "as_map")]
    limits: Vec<(&'static str, i64)>,
    #[serde(serialize_with = "as_map")]
    extensions: Vec<(&'static str, bool)>,
    #[serde(serialize_with = "as_map")]
    methods_missing: Vec<(&'static str, Vec<&'static str>)>,
    traps: Vec<Trap>,
}

impl Report {
    pub(super) fn print(&self, form: Form) -> Result<()> {
        match form {
            Form::Text => say(self),
            Form::Json => print_json(self),
        }
    }

    /// The report of a backend. This replaces the current context.
    pub(super) fn of(backend: Backend, context: &Context) -> Result<Self> {
        let driver = context.driver();
        let traps = GlMachine::new(context, [256, 256])?.traps()?;
        Ok(Self {
            backend: backend.to_string(),
            works: true,
            optional: false,
            answer: None,
            renderer: Some(driver.renderer.clone()),
            version: Some(driver.version_text.clone()),
            compatibility_profile: has_compatibility(backend),
            limits: driver.limits.clone(),
            extensions: WANTED_EXTENSIONS
                .iter()
                .map(|(name, _)| (*name, driver.has(name)))
                .collect(),
            methods_missing: missing(driver),
            traps,
        })
    }

    /// The report of a backend that gives no context, with the reason.
    pub(super) fn failed(backend: Backend, answer: String, optional: bool) -> Self {
        Self {
            backend: backend.to_string(),
            works: false,
            optional,
            answer: Some(answer),
            renderer: None,
            version: None,
            compatibility_profile: false,
            limits: Vec::new(),
            extensions: Vec::new(),
            methods_missing: Vec::new(),
            traps: Vec::new(),
        }
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.backend)?;
        let mut line = |name: &str, value: &str| write!(f, "\n  {name:<46} {value}");
        if let Some(answer) = &self.answer {
            if self.optional {
                return line("not there, and not needed (optional)", answer);
            }
            return line("does not work", answer);
        }
        line("renderer", self.renderer.as_deref().unwrap_or("?"))?;
        line("version", self.version.as_deref().unwrap_or("?"))?;
        let yes_no = |yes| if yes { "yes" } else { "no" };
        line("compatibility profile", yes_no(self.compatibility_profile))?;
        for (name, value) in &self.limits {
            line(name, &value.to_string())?;
        }
        for (name, there) in &self.extensions {
            let purpose = WANTED_EXTENSIONS.iter().find(|(n, _)| n == name);
            let purpose = purpose.map_or("", |(_, purpose)| purpose);
            line(name, &format!("{} ({purpose})", yes_no(*there)))?;
        }
        if self.methods_missing.is_empty() {
            line("methods", "all of them work")?;
        }
        for (method, lacks) in &self.methods_missing {
            line(
                method,
                &format!("will not work: it needs {}", lacks.join(" or ")),
            )?;
        }
        if self.traps.is_empty() {
            line("traps", "none of those known")?;
        }
        for Trap { what, avoided } in &self.traps {
            line("trap", what)?;
            line("  avoided", avoided)?;
        }
        Ok(())
    }
}

/// Pairs as one JSON object, in the order of the pairs.
fn as_map<V: Serialize, S: Serializer>(
    pairs: &[(&'static str, V)],
    serializer: S,
) -> Result<S::Ok, S::Error> {
    serializer.collect_map(pairs.iter().map(|(name, value)| (name, value)))
}

/// Whether the backend also gives a compatibility context. This replaces the current context.
fn has_compatibility(backend: Backend) -> bool {
    Context::new(ContextOptions {
        backend: Some(backend),
        profile: Profile::Compatibility,
    })
    .is_ok()
}

fn missing(driver: &Driver) -> Vec<(&'static str, Vec<&'static str>)> {
    registry()
        .iter()
        .filter(|entry| !entry.runs_on(driver))
        .map(|entry| (entry.name, entry.needs.to_vec()))
        .collect()
}
