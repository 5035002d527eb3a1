//! `onionskin doctor`: what OpenGL there is, and what will not work with it.

use std::fmt;
use std::process::ExitCode;

use clap::Args;
use onionskin::gl::{
    Backend, Context, ContextOptions, Driver, GlMachine, Profile, Trap, WANTED_EXTENSIONS,
};
use onionskin::methods::registry;
use onionskin::{Error, Result};
use serde::{Serialize, Serializer};

use super::output::{print_json, say};
use super::probe;

/// Report the OpenGL that is there and what will not work with it
///
/// Tries every way to a context: for each, the renderer, its version, its limits, the extensions that methods want,
/// and the driver's known traps. One way is enough; OSMesa is optional, and Mesa 25.1 and later do not have it. Exits with
/// 2 if there is no way at all, and says what to install.
#[derive(Args)]
pub(super) struct Doctor {
    /// Print one JSON object a backend and nothing else
    #[arg(long)]
    json: bool,
}

#[derive(Serialize)]
struct Report {
    backend: String,
    works: bool,
    /// It does not work, and need not.
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

impl Doctor {
    pub(super) fn run(self) -> Result<ExitCode> {
        let mut errors = Vec::new();
        let mut works = false;
        for backend in [Backend::Egl, Backend::OsMesa] {
            let report = match probe::tried(backend) {
                Ok(context) => Report::of(backend, &context)?,
                Err(Error::NoContext { tried }) => {
                    let mut tried = tried;
                    tried.retain(|attempt| !errors.contains(attempt));
                    let answers = tried
                        .iter()
                        .map(|attempt| format!("{}: {}", attempt.what, attempt.answer));
                    let answer = answers.collect::<Vec<_>>().join("; ");
                    errors.extend(tried);
                    // With EGL nothing is missing.
                    Report::failed(backend, answer, works)
                }
                Err(error) => return Err(error),
            };
            works |= report.works;
            if self.json {
                print_json(&report)?;
            } else {
                say(&report)?;
            }
        }
        if works {
            Ok(ExitCode::SUCCESS)
        } else {
            Err(Error::NoContext { tried: errors })
        }
    }
}

impl Report {
    fn of(backend: Backend, context: &Context) -> Result<Self> {
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

    fn failed(backend: Backend, answer: String, optional: bool) -> Self {
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

/// Pairs as one JSON object, in their order.
fn as_map<V: Serialize, S: Serializer>(
    pairs: &[(&'static str, V)],
    serializer: S,
) -> Result<S::Ok, S::Error> {
    serializer.collect_map(pairs.iter().map(|(name, value)| (name, value)))
}

/// Whether the backend also gives a compatibility context. Replaces the current context.
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
