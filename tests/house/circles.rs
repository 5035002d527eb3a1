//! No two files import each other, not even by way of others: each can be read after those that it needs.
//!
//! A re-export (`pub use`) is not an import: whoever names what it re-exports imports the file that has it.

use std::collections::{BTreeMap, BTreeSet, VecDeque};

use crate::imports::House;
use crate::sources;

/// Files that import each other in a circle, a line each: from where, what, and the way back.
fn circles(imports: &BTreeMap<String, BTreeMap<String, String>>) -> Vec<String> {
    let mut found = Vec::new();
    let mut told = BTreeSet::new();
    for (from, targets) in imports {
        for (to, name) in targets {
            let Some(way) = way(imports, to, from) else {
                continue;
            };
            let files: BTreeSet<_> = way.iter().collect();
            if told.insert(format!("{files:?}")) {
                found.push(format!(
                    "{from} imports {name}, and the circle closes: {}",
                    way.join(" -> ")
                ));
            }
        }
    }
    found
}

/// The shortest way by imports from one file to another.
fn way(
    imports: &BTreeMap<String, BTreeMap<String, String>>,
    from: &str,
    to: &str,
) -> Option<Vec<String>> {
    let mut ways = VecDeque::from([vec![from.to_owned()]]);
    let mut seen = BTreeSet::new();
    while let Some(way) = ways.pop_front() {
        let last = way.last().expect("a way has a beginning");
        if last == to {
            return Some(way);
        }
        if seen.insert(last.clone()) {
            let next = imports.get(last).into_iter().flat_map(BTreeMap::keys);
            ways.extend(next.map(|next| [&way[..], std::slice::from_ref(next)].concat()));
        }
    }
    None
}

#[test]
fn no_files_import_each_other_in_a_circle() {
    for root in ["lib.rs", "main.rs"] {
        let house = House::read(&sources::root(), root);
        let circles = circles(&house.imports());
        assert!(circles.is_empty(), "{}", circles.join("\n"));
    }
}

#[test]
fn a_circle_would_be_found_however_it_is_written() {
    let a = "use super::b::B; pub struct A(B);";
    let straight = ("b.rs", "pub struct B; fn f() -> crate::a::A { todo!() }");
    let by_another_name = ("b.rs", "use crate as c; pub struct B; fn f(_: c::a::A) {}");
    let by_a_re_export = ("b.rs", "use super::A; pub struct B;");
    let in_a_macro = ("b.rs", "pub struct B; fn f() { drop(vec![super::a::A]) }");
    let by_its_parent = ("b.rs", "use super::*; pub struct B; fn f(_: A) {}");
    for (name, b) in [
        straight,
        by_another_name,
        by_a_re_export,
        in_a_macro,
        by_its_parent,
    ] {
        let house = House::of([
            ("lib.rs", "mod a; mod b; pub use a::A;"),
            ("a.rs", a),
            (name, b),
        ]);
        let found = circles(&house.imports());
        assert_eq!(found.len(), 1, "{b}: {found:?}");
        assert!(
            found[0].starts_with("a.rs imports super::b::B"),
            "{found:?}"
        );
    }
    // No circle: a test, another crate, a name in the file itself, and what the file's own module has.
    for b in [
        "pub struct B; #[cfg(test)] mod tests { use crate::a::A; }",
        "pub struct B; use other::a::A;",
        "pub struct B; mod a { pub struct A; } use a::A;",
        "pub struct B; use super::C;",
    ] {
        let lib = "mod a; mod b; pub use a::A; pub struct C;";
        let house = House::of([("lib.rs", lib), ("a.rs", a), ("b.rs", b)]);
        assert_eq!(circles(&house.imports()), [""; 0], "{b}");
    }
}
