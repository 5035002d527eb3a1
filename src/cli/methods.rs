//! `onionskin methods`: the registry.

use std::process::ExitCode;

use clap::Args;
use comfy_table::{Table, presets};
use onionskin::{Result, registry};
use serde::Serialize;

use super::output::{print_json, say};

/// List the methods: where they are published, whether they are exact, what they need
///
/// A method is exact if its image is exact whenever nothing stops it early. Of volumes, rays take the samples that the
/// exact image has, and slices do not. Fragments of equal depth are ties; some methods keep only one of them. The
/// column for memory says with what it grows. By default a full array keeps the fragments that its column names, even
/// if others are nearer, because the paper leaves this open (Lindholm et al. 2015, section 4). `--keep nearest` keeps
/// the nearest.
#[derive(Args)]
pub(super) struct Methods {
    /// Print one JSON object per method and nothing else
    #[arg(long)]
    json: bool,
}

#[derive(Serialize)]
struct Record {
    name: &'static str,
    source: &'static str,
    exact: bool,
    exact_volumes: Option<bool>,
    exactness: &'static str,
    keeps: Option<&'static str>,
    ties: String,
    memory: String,
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
            "a full array keeps",
            "memory",
            "needs",
        ]);
        for entry in registry() {
            if self.json {
                print_json(&Record {
                    name: entry.name,
                    source: entry.source,
                    exact: entry.exact,
                    exact_volumes: entry.exact_volumes(),
                    exactness: entry.exactness,
                    keeps: entry.keeps,
                    ties: entry.ties.to_string(),
                    memory: entry.memory.to_string(),
                    needs: entry.needs,
                })?;
            } else {
                let needs = if entry.needs.is_empty() {
                    "OpenGL 4.3".into()
                } else {
                    entry.needs.join(" or ")
                };
                table.add_row([
                    entry.name,
                    entry.source,
                    entry.exactness,
                    &entry.ties.to_string(),
                    entry.keeps.unwrap_or("-"),
                    &entry.memory.to_string(),
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
