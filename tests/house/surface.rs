//! The library's surface, in two files that are kept: the names that the crate's root offers, and every `pub` item of the
//! source. A name that appears or goes is seen in the diff. `BLESS=1` rewrites the files.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use syn::{ImplItem, Item, UseTree, Visibility};

use crate::sources::{files, root};

#[test]
fn the_root_offers_the_names_that_are_kept() {
    let names = names();
    expect_kept(
        "public_names.txt",
        names.iter().map(|(_, name)| name.clone()).collect(),
    );
    // A newcomer reads them all.
    assert!((30..=50).contains(&names.len()), "{}", names.len());
}

#[test]
fn public_items_are_those_that_are_kept() {
    let mut all = BTreeSet::new();
    for file in files(&root()) {
        let name = file.strip_prefix(root()).unwrap();
        if !name.starts_with("cli") {
            let text = fs::read_to_string(&file).unwrap();
            let items = public(&syn::parse_file(&text).unwrap().items);
            all.extend(
                items
                    .iter()
                    .map(|item| format!("{}: {item}", name.display())),
            );
        }
    }
    expect_kept("public_items.txt", all);
}

/// The names that the crate's root offers, each after its path from there. Modules that are written out in the root are
/// their own path.
pub fn names() -> Vec<(String, String)> {
    let text = fs::read_to_string(root().join("lib.rs")).unwrap();
    let mut found = Vec::new();
    for item in syn::parse_file(&text).unwrap().items {
        match item {
            Item::Use(item) if is_public(&item.vis) => paths(&item.tree, "", &mut found),
            Item::Mod(item) if is_public(&item.vis) => {
                found.push((item.ident.to_string(), item.ident.to_string()));
            }
            _ => {}
        }
    }
    found.sort_by(|(_, a), (_, b)| a.cmp(b));
    found
}

fn paths(tree: &UseTree, before: &str, found: &mut Vec<(String, String)>) {
    match tree {
        UseTree::Path(path) => paths(&path.tree, &format!("{before}{}::", path.ident), found),
        UseTree::Name(name) => {
            found.push((format!("{before}{}", name.ident), name.ident.to_string()))
        }
        UseTree::Group(group) => group
            .items
            .iter()
            .for_each(|tree| paths(tree, before, found)),
        UseTree::Rename(_) | UseTree::Glob(_) => panic!("the root offers names by name"),
    }
}

/// Holds lines against a file's, which `BLESS=1` rewrites.
fn expect_kept(file: &str, all: BTreeSet<String>) {
    let kept = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/transcripts")
        .join(file);
    let found: String = all.iter().map(|line| format!("{line}\n")).collect();
    if std::env::var_os("BLESS").is_some() {
        fs::write(&kept, &found).unwrap();
    }
    let before = fs::read_to_string(&kept).unwrap_or_default();
    let before: BTreeSet<_> = before.lines().map(str::to_owned).collect();
    let new: Vec<_> = all.difference(&before).collect();
    let gone: Vec<_> = before.difference(&all).collect();
    assert!(
        new.is_empty() && gone.is_empty(),
        "new: {new:#?}\ngone: {gone:#?}\n(BLESS=1 rewrites {file})"
    );
}

#[test]
fn a_public_item_is_listed_and_a_private_one_is_not() {
    let file = syn::parse_file(
        "pub use a::{B, c as D}; pub(crate) fn e() {} fn f() {} pub struct G;
         impl G { pub const H: u8 = 0; pub fn i() {} fn j() {} } impl K for G { fn l() {} }",
    );
    let listed = public(&file.unwrap().items);
    assert_eq!(
        listed,
        ["use B", "use D", "struct G", "const G::H", "fn G::i"]
    );
}

/// The public items of a module, those of its inherent implementations too.
fn public(items: &[Item]) -> Vec<String> {
    let mut found = Vec::new();
    for item in items {
        let (visibility, kind, name) = match item {
            Item::Const(item) => (&item.vis, "const", &item.ident),
            Item::Enum(item) => (&item.vis, "enum", &item.ident),
            Item::Fn(item) => (&item.vis, "fn", &item.sig.ident),
            Item::Mod(item) => (&item.vis, "mod", &item.ident),
            Item::Static(item) => (&item.vis, "static", &item.ident),
            Item::Struct(item) => (&item.vis, "struct", &item.ident),
            Item::Trait(item) => (&item.vis, "trait", &item.ident),
            Item::Type(item) => (&item.vis, "type", &item.ident),
            Item::Use(item) => {
                if is_public(&item.vis) {
                    imported(&item.tree, &mut found);
                }
                continue;
            }
            Item::Impl(item) if item.trait_.is_none() => {
                if let syn::Type::Path(of) = &*item.self_ty {
                    let of = &of.path.segments.last().unwrap().ident;
                    found.extend(item.items.iter().filter_map(|item| match item {
                        ImplItem::Fn(item) if is_public(&item.vis) => {
                            Some(format!("fn {of}::{}", item.sig.ident))
                        }
                        ImplItem::Const(item) if is_public(&item.vis) => {
                            Some(format!("const {of}::{}", item.ident))
                        }
                        _ => None,
                    }));
                }
                continue;
            }
            _ => continue,
        };
        if is_public(visibility) {
            found.push(format!("{kind} {name}"));
        }
    }
    found
}

fn is_public(visibility: &Visibility) -> bool {
    matches!(visibility, Visibility::Public(_))
}

fn imported(tree: &UseTree, found: &mut Vec<String>) {
    match tree {
        UseTree::Path(path) => imported(&path.tree, found),
        UseTree::Name(name) => found.push(format!("use {}", name.ident)),
        UseTree::Rename(rename) => found.push(format!("use {}", rename.rename)),
        UseTree::Glob(_) => found.push("use *".into()),
        UseTree::Group(group) => group.items.iter().for_each(|tree| imported(tree, found)),
    }
}
