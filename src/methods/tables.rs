//! The documentation's tables of methods are generated from the registry. `BLESS=1` rewrites them.

use std::fs;
use std::path::Path;

use super::entry::{Entry, Ties};
use super::registry::registry;

/// Every method with its facts. Methods with the same facts share a row.
fn of_methods() -> Vec<String> {
    let mut rows: Vec<(Vec<String>, String)> = Vec::new();
    for row in registry() {
        let rest = rest(row.entry);
        match rows.iter_mut().find(|(_, other)| *other == rest) {
            Some((names, _)) => names.push(quoted(row.name)),
            None => rows.push((vec![quoted(row.name)], rest)),
        }
    }
    let head = [
        "| method | published | exact | fragments of equal depth | a full array keeps | memory |",
        "| --- | --- | --- | --- | --- | --- |",
    ];
    let rows = rows
        .iter()
        .map(|(names, rest)| format!("| {} {rest}", names.join(", ")));
    head.map(String::from).into_iter().chain(rows).collect()
}

fn rest(entry: &Entry) -> String {
    let Entry {
        source,
        exactness,
        ties,
        memory,
        ..
    } = entry;
    let keeps = entry.keeps.unwrap_or("");
    format!("| {source} | {exactness} | {ties} | {keeps} | {memory} |")
}

/// The orders of coplanar fragments, and their methods.
fn of_ties() -> Vec<String> {
    let mut kinds: Vec<Ties> = Vec::new();
    for row in registry() {
        if !kinds.contains(&row.ties) {
            kinds.push(row.ties);
        }
    }
    let head = ["| fragments of equal depth | methods |", "| --- | --- |"].map(String::from);
    let row = |kind: Ties| {
        let names = registry().iter().filter(|row| row.ties == kind);
        let names: Vec<_> = names.map(|row| quoted(row.name)).collect();
        format!("| {kind} | {} |", names.join(", "))
    };
    head.into_iter().chain(kinds.into_iter().map(row)).collect()
}

fn quoted(name: &str) -> String {
    format!("`{name}`")
}

/// The file, with these lines between its markers.
fn with_table(text: &str, comment: &str, lines: &[String]) -> String {
    let begin = format!("{comment}<!-- methods: generated from the registry -->\n");
    let end = format!("{comment}<!-- /methods -->\n");
    let (before, rest) = text
        .split_once(&begin)
        .expect("the table's begin is marked");
    let (_, after) = rest.split_once(&end).expect("the table's end is marked");
    let table: String = lines
        .iter()
        .map(|line| format!("{comment}{line}\n"))
        .collect();
    format!("{before}{begin}{table}{end}{after}")
}

#[track_caller]
fn check(file: &str, comment: &str, lines: &[String]) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(file);
    let text = fs::read_to_string(&path).unwrap();
    let expected = with_table(&text, comment, lines);
    if std::env::var_os("BLESS").is_some() {
        fs::write(&path, expected).unwrap();
    } else {
        assert!(
            text == expected,
            "the table of methods in {file} is not the registry's: BLESS=1 writes it again"
        );
    }
}

#[test]
fn the_readme_has_the_registry_s_table() {
    check("README.md", "", &of_methods());
}

#[test]
fn the_documentation_has_the_registry_s_table() {
    check("src/methods/mod.rs", "//! ", &of_methods());
}

#[test]
fn the_policy_for_coplanar_surfaces_has_the_registry_s_table() {
    check("src/methods/coplanar.rs", "//! ", &of_ties());
}

#[test]
fn a_table_with_a_changed_word_is_noticed() {
    let text = "<!-- methods: generated from the registry -->\n| a |\n<!-- /methods -->\n";
    assert_eq!(with_table(text, "", &["| a |".into()]), text);
    assert_ne!(with_table(text, "", &["| b |".into()]), text);
}
