//! `onionskin methods`: the registry.

use std::process::ExitCode;

use clap::Args;
use comfy_table::{Table, presets};
use onionskin::Result;
use onionskin::methods::registry;
use serde::Serialize;

use super::output::{print_json, say};

/// List the methods: where they are published, whether they are exact, what they need
///
/// A method is exact if its image is, when nothing stops it early. Fragments of equal depth are ties: some methods keep
/// only one of them. Memory is what it grows with.
#[derive(Args)]
pub(super) struct Methods {
    /// Print one JSON object a method and nothing else
    #[arg(long)]
    json: bool,
}

#[derive(Serialize)]
struct Record {
    name: &'static str,
    source: &'static str,
    exact: bool,
    ties: &'static str,
    memory: &'static str,
    needs: &'static [&'static str],
}

impl Methods {
    pub(super) fn run(self) -> Result<ExitCode> {
        let mut table = Table::new();
        table.load_style(presets::NOTHING).set_header([
            "method",
            "published",
            "exact",
            "equal depths",
            "memory",
            "needs",
        ]);
        for entry in registry() {
            if self.json {
                print_json(&Record {
                    name: entry.name,
                    source: entry.source,
                    exact: entry.exact,
                    ties: entry.ties,
                    memory: entry.memory,
                    needs: entry.needs,
                })?;
            } else {
                let exact = if entry.exact { "yes" } else { "no" };
                let needs = if entry.needs.is_empty() {
                    "OpenGL 4.3".into()
                } else {
                    entry.needs.join(" or ")
                };
                table.add_row([
                    entry.name,
                    entry.source,
                    exact,
                    entry.ties,
                    entry.memory,
                    &needs,
                ]);
            }
        }
        if !self.json {
            say(table)?;
        }
        Ok(ExitCode::SUCCESS)
    }
}
