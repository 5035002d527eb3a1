//! The library's surface: every `pub` item of the source, in a file that is kept. A name that appears or goes is seen in
//! the diff. `BLESS=1` rewrites the file.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use syn::{ImplItem, Item, UseTree, Visibility};

use crate::sources::{files, root};

#[test]
fn public_items_are_those_that_are_kept() {
    let kept = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/transcripts/public_items.txt");
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
        "new: {new:#?}\ngone: {gone:#?}\n(BLESS=1 rewrites the list)"
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
