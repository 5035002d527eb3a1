//! The README stays short, and what it and the findings refer to exists.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

const README: &str = include_str!("../../README.md");
const FINDINGS: &str = include_str!("../../src/findings.md");

#[test]
fn the_readme_has_at_most_150_lines() {
    assert!(README.lines().count() <= 150);
}

#[test]
fn every_finding_names_what_shows_it_and_that_exists() {
    let functions = functions();
    let mut findings = 0;
    let mut wrong = Vec::new();
    for (heads, row) in rows(FINDINGS) {
        let shown_by = row.last().unwrap();
        if heads.last() != Some(&"shown by") {
            continue;
        }
        findings += 1;
        let named = quoted(shown_by);
        if named.is_empty() || named.iter().any(|name| !exists(name, &functions)) {
            wrong.push(row.join(" | "));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(findings > 80, "{findings}");
}

#[test]
fn every_path_and_every_long_name_in_the_texts_exists() {
    let functions = functions();
    for text in [README, FINDINGS] {
        for name in quoted(text) {
            let is_path = name.ends_with(".rs") || name.ends_with(".png") || name.ends_with(".md");
            let is_word = name.chars().all(|c| c == '_' || c.is_ascii_alphanumeric());
            let is_test = is_word && name.matches('_').count() > 3;
            assert!(!is_path && !is_test || exists(name, &functions), "{name}");
        }
    }
    for target in README.split("](").skip(1) {
        let (target, _) = target.split_once(')').unwrap();
        assert!(root().join(target).exists(), "{target}");
    }
}

#[test]
fn a_test_that_does_not_exist_would_be_noticed() {
    let functions = functions();
    assert!(exists("the_readme_has_at_most_150_lines", &functions));
    assert!(!exists("the_readme_has_at_most_151_lines", &functions));
    assert!(exists("benches/fused.rs", &functions));
    assert!(!exists("benches/fuse.rs", &functions));
}

#[test]
fn every_dependency_stands_in_the_readme_with_what_it_is_for() {
    let manifest: toml::Table = include_str!("../../Cargo.toml").parse().unwrap();
    let linux = &manifest["target"]["cfg(target_os = \"linux\")"];
    let tables = [
        &manifest["dependencies"],
        &manifest["dev-dependencies"],
        &linux["dependencies"],
    ];
    let crates: BTreeSet<&str> = tables
        .iter()
        .flat_map(|table| table.as_table().unwrap().keys().map(String::as_str))
        .collect();
    let told: BTreeSet<&str> = rows(README)
        .filter(|(heads, _)| heads[0] == "crate")
        .flat_map(|(_, row)| row[0].split(", "))
        .collect();
    assert_eq!(told, crates);
}

/// Every row of every table, after its table's head.
fn rows(text: &str) -> impl Iterator<Item = (Vec<&str>, Vec<&str>)> {
    let mut heads: Option<Vec<&str>> = None;
    text.lines().filter_map(move |line| {
        let Some(cells) = line.strip_prefix('|').and_then(|l| l.strip_suffix('|')) else {
            heads = None;
            return None;
        };
        let cells: Vec<&str> = cells.split('|').map(str::trim).collect();
        match &heads {
            None => {
                heads = Some(cells);
                None
            }
            Some(_) if cells[0].starts_with("---") => None,
            Some(heads) => Some((heads.clone(), cells)),
        }
    })
}

/// What stands between backticks.
fn quoted(text: &str) -> Vec<&str> {
    text.lines()
        .flat_map(|line| line.split('`').skip(1).step_by(2))
        .collect()
}

fn exists(name: &str, functions: &BTreeSet<String>) -> bool {
    match name.contains('/') {
        true => root().join(name).exists(),
        false => functions.contains(name),
    }
}

/// The names of all test functions, those of the crate included.
fn functions() -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    let mut folders = vec![root().join("tests"), root().join("src")];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|ending| ending == "rs") {
                let text = fs::read_to_string(&path).unwrap();
                for after in text.split("#[test]").skip(1) {
                    let (_, name) = after.split_once("fn ").unwrap();
                    let (name, _) = name.split_once('(').unwrap();
                    found.insert(name.to_owned());
                }
            }
        }
    }
    found
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}
