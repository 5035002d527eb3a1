//! Which file imports which, read from the source.

use std::collections::BTreeMap;
use std::path::Path;

use proc_macro2::{TokenStream, TokenTree};
use syn::visit::{self, Visit};
use syn::{Attribute, Item, ItemMod, ItemUse, Macro, UseTree, Visibility};

/// The modules that a macro of the first child declares which defines it, as in `every_paper!(declare)`: of all words in
/// that macro those that are files beside it.
fn declared_by_macros(items: &[Item], child: &dyn Fn(&str) -> Option<String>) -> Vec<String> {
    let called = |item: &Item| match item {
        Item::Macro(it) if it.ident.is_none() && it.mac.tokens.to_string() == "declare" => {
            it.mac.path.get_ident().map(ToString::to_string)
        }
        _ => None,
    };
    let mut found = Vec::new();
    for name in items.iter().filter_map(called) {
        let files = items.iter().filter_map(|item| match item {
            Item::Mod(it) if it.content.is_none() => child(&it.ident.to_string()),
            _ => None,
        });
        for file in files.filter_map(|text| syn::parse_file(&text).ok()) {
            let defined = file.items.into_iter().find_map(|item| match item {
                Item::Macro(it) if it.ident.as_ref().is_some_and(|ident| *ident == name) => {
                    Some(it.mac.tokens)
                }
                _ => None,
            });
            words(defined.unwrap_or_default(), &mut found);
        }
    }
    found.sort();
    found.dedup();
    found.retain(|word| child(word).is_some());
    found
}

fn words(tokens: TokenStream, found: &mut Vec<String>) {
    for token in tokens {
        match token {
            TokenTree::Ident(ident) => found.push(ident.to_string()),
            TokenTree::Group(group) => words(group.stream(), found),
            _ => {}
        }
    }
}

/// A path from the crate's root.
type Names = Vec<String>;

/// A crate's modules.
pub struct House {
    modules: BTreeMap<Names, Module>,
}

#[derive(Default)]
struct Module {
    /// Where it stands, from the folder of the crate's root.
    file: String,
    /// What `use` gives names to here, as written from the crate's root.
    uses: BTreeMap<String, Names>,
    /// What `use` takes everything from.
    globs: Vec<Names>,
    /// All paths that are named here, but those of re-exports, as written.
    paths: Vec<Names>,
}

impl House {
    /// The modules of a crate, from its root's file.
    pub fn read(folder: &Path, root: &str) -> Self {
        let source = |file: &str| std::fs::read_to_string(folder.join(file)).ok();
        Self::from(root, &source)
    }

    /// The same of sources that are in no folder.
    pub fn of<const N: usize>(files: [(&str, &str); N]) -> Self {
        let files = BTreeMap::from(files);
        Self::from("lib.rs", &|file| {
            files.get(file).map(|&text| text.to_owned())
        })
    }

    fn from(root: &str, source: &dyn Fn(&str) -> Option<String>) -> Self {
        let mut modules = BTreeMap::new();
        let mut files = vec![(Names::new(), String::new(), root.to_owned())];
        while let Some((names, folder, file)) = files.pop() {
            let text = source(&file).unwrap_or_else(|| panic!("{file} is not there"));
            let parsed = syn::parse_file(&text).unwrap_or_else(|error| panic!("{file}: {error}"));
            let mut reader = Reader {
                file: &file,
                names,
                modules: &mut modules,
                children: Vec::new(),
            };
            reader.module(&parsed.items);
            let mut children = reader.children;
            let mut declared = declared_by_macros(&parsed.items, &|child| {
                source(&format!("{folder}{child}.rs"))
                    .or_else(|| source(&format!("{folder}{child}/mod.rs")))
            });
            let parent = children
                .first()
                .map(|child| child[..child.len() - 1].to_vec());
            declared.retain(|name| children.iter().all(|child| child.last() != Some(name)));
            children.extend(
                declared
                    .into_iter()
                    .map(|name| [parent.clone().unwrap_or_default(), vec![name]].concat()),
            );
            for child in children {
                let name = child.last().expect("a child has a name");
                // A module that is written out in a file has its modules' files beside that file: so does its `#[path]` say.
                let inside = format!("{folder}{name}/");
                let alone = format!("{folder}{name}.rs");
                let file = match source(&alone) {
                    Some(_) => alone,
                    None => format!("{inside}mod.rs"),
                };
                files.push((child, inside, file));
            }
        }
        Self { modules }
    }

    /// For each file the other files of the crate that it imports, each with a path by which it does.
    pub fn imports(&self) -> BTreeMap<String, BTreeMap<String, String>> {
        let mut imports: BTreeMap<_, BTreeMap<_, _>> = BTreeMap::new();
        for (names, module) in &self.modules {
            let targets = imports.entry(module.file.clone()).or_default();
            for path in &module.paths {
                let target = self.absolute(names, path).and_then(|it| self.home(it, 0));
                if let Some(target) = target.filter(|target| *target != module.file) {
                    targets.entry(target).or_insert_with(|| path.join("::"));
                }
            }
        }
        imports
    }

    /// A path from the root, if it does not lead to another crate or stay in its module.
    fn absolute(&self, module: &[String], path: &[String]) -> Option<Names> {
        let (first, rest) = path.split_first()?;
        let from = |start: &[String]| Some([start, rest].concat());
        match first.as_str() {
            "crate" => from(&[]),
            "self" => from(module),
            "super" => {
                let parent = module.split_last()?.1;
                match rest.first().map(String::as_str) {
                    Some("super") => self.absolute(parent, rest),
                    _ => from(parent),
                }
            }
            name => {
                let here = self.modules.get(module)?;
                let child = [module, std::slice::from_ref(first)].concat();
                // A name alone may be a variable's; if it is imported, then the import has been read.
                if !rest.is_empty() && self.modules.contains_key(&child) {
                    return from(&child);
                }
                if let Some(target) = here.uses.get(name) {
                    return (!rest.is_empty()).then(|| [target, rest].concat());
                }
                // What a glob may have brought: whether it has, `home` finds out.
                here.globs
                    .iter()
                    .map(|glob| [&glob[..], path].concat())
                    .find(|path| self.has(path))
            }
        }
    }

    /// Whether a module re-exports or contains the last name of a path, as far as that can be told from modules and `use`.
    fn has(&self, path: &[String]) -> bool {
        let (glob, rest) = path.split_at(path.len() - 1);
        let Some(module) = self.modules.get(glob) else {
            return false;
        };
        module.uses.contains_key(&rest[0]) || self.modules.contains_key(path)
    }

    /// The file that has what a path from the root leads to, through re-exports.
    fn home(&self, path: Names, steps: usize) -> Option<String> {
        // Imports of the same name in a circle are no Rust.
        assert!(steps < 32, "{path:?}");
        let mut at = Names::new();
        for (place, name) in path.iter().enumerate() {
            let child = [&at[..], std::slice::from_ref(name)].concat();
            if self.modules.contains_key(&child) {
                at = child;
                continue;
            }
            let target = self.modules.get(&at)?.uses.get(name);
            // `use name` of a name itself makes a macro of the file known outside.
            if let Some(target) = target.filter(|target| **target != child) {
                let path = [target, &path[place + 1..]].concat();
                return self.home(path, steps + 1);
            }
            break;
        }
        self.modules.get(&at).map(|module| module.file.clone())
    }
}

struct Reader<'a> {
    file: &'a str,
    names: Names,
    modules: &'a mut BTreeMap<Names, Module>,
    /// Modules in files of their own.
    children: Vec<Names>,
}

impl Reader<'_> {
    fn module(&mut self, items: &[Item]) {
        let module = Module {
            file: self.file.to_owned(),
            ..Module::default()
        };
        self.modules.insert(self.names.clone(), module);
        for item in items {
            self.visit_item(item);
        }
    }

    fn here(&mut self) -> &mut Module {
        let module = self.modules.get_mut(&self.names);
        module.expect("it was inserted")
    }

    fn used(&mut self, tree: &UseTree, before: &[String], is_import: bool) {
        let with = |name: &syn::Ident| [before, &[name.to_string()]].concat();
        match tree {
            UseTree::Path(path) => self.used(&path.tree, &with(&path.ident), is_import),
            UseTree::Group(group) => {
                for tree in &group.items {
                    self.used(tree, before, is_import);
                }
            }
            UseTree::Name(name) if name.ident == "self" => {
                let name = before.last().expect("self stands after a path").clone();
                self.named(name, before.to_vec(), is_import);
            }
            UseTree::Name(name) => {
                self.named(name.ident.to_string(), with(&name.ident), is_import);
            }
            UseTree::Rename(rename) => {
                self.named(rename.rename.to_string(), with(&rename.ident), is_import);
            }
            UseTree::Glob(_) => {
                let from = from_root(&self.names, before);
                self.here().globs.extend(from);
                // A test's `super::*` is not read; elsewhere what is used of it counts, and not the glob.
            }
        }
    }

    fn named(&mut self, name: String, path: Names, is_import: bool) {
        let from = from_root(&self.names, &path);
        if is_import {
            self.here().paths.push(path.clone());
        }
        // A path without a beginning leads to a child, or to another crate.
        let target = from.unwrap_or_else(|| [&self.names[..], &path].concat());
        // A function may have its module's name; who names more than that means the module.
        let is_function = path.len() > 1 && path[path.len() - 2] == name;
        let uses = &mut self.here().uses;
        if !(is_function && uses.contains_key(&name)) {
            uses.insert(name, target);
        }
    }

    /// Paths in a macro's words, which nobody has parsed.
    fn words(&mut self, tokens: TokenStream) {
        let mut path = Names::new();
        let mut colons = 0;
        for token in tokens {
            match token {
                TokenTree::Punct(punct) if punct.as_char() == ':' => colons += 1,
                TokenTree::Ident(name) => {
                    if colons != 2 {
                        self.here().paths.push(std::mem::take(&mut path));
                    }
                    path.push(name.to_string());
                    colons = 0;
                }
                other => {
                    self.here().paths.push(std::mem::take(&mut path));
                    colons = 0;
                    if let TokenTree::Group(group) = other {
                        self.words(group.stream());
                    }
                }
            }
        }
        self.here().paths.push(path);
    }
}

/// A path that says where it begins, from the root.
fn from_root(module: &[String], path: &[String]) -> Option<Names> {
    let (first, rest) = path.split_first()?;
    match first.as_str() {
        "crate" => Some(rest.to_vec()),
        "self" => Some([module, rest].concat()),
        "super" => {
            let parent = module.split_last()?.1;
            from_root(parent, rest).or_else(|| Some([parent, rest].concat()))
        }
        _ => None,
    }
}

fn is_for_tests(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| {
        let list = attribute.meta.require_list();
        attribute.path().is_ident("cfg") && list.is_ok_and(|list| list.tokens.to_string() == "test")
    })
}

impl Visit<'_> for Reader<'_> {
    fn visit_item_mod(&mut self, item: &ItemMod) {
        if is_for_tests(&item.attrs) {
            return;
        }
        let name = item.ident.to_string();
        self.names.push(name);
        match &item.content {
            Some((_, items)) => self.module(items),
            None => self.children.push(self.names.clone()),
        }
        self.names.pop();
    }

    fn visit_item_use(&mut self, item: &ItemUse) {
        let is_import = matches!(item.vis, Visibility::Inherited);
        self.used(&item.tree, &[], is_import);
    }

    fn visit_path(&mut self, path: &syn::Path) {
        let names = path
            .segments
            .iter()
            .map(|segment| segment.ident.to_string());
        let names = names.collect();
        self.here().paths.push(names);
        visit::visit_path(self, path);
    }

    /// `pub(super)` imports nothing.
    fn visit_visibility(&mut self, _: &Visibility) {}

    fn visit_macro(&mut self, found: &Macro) {
        self.visit_path(&found.path);
        self.words(found.tokens.clone());
    }
}
