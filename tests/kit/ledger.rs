//! The tests that claims and errata name are compiled: a name that is none is an error of the compiler.
//!
//! A test binary that has this module defines `cited!` before it, which makes a constant of each path into its own
//! functions. `papers/claims_and_errata.rs` holds that every path is one of such a binary.

use std::collections::BTreeSet;
use std::process::Command;

use onionskin::low_level::papers::papers;

/// Of a table's rows, the tests.
macro_rules! rows {
    ($($key:ident ($place:literal) $verdict:ident { $($field:ident: $value:tt),* $(,)? })*) => {
        $($( field!($field $value); )*)*
    };
}

macro_rules! field {
    (tests [$($binary:ident $(:: $name:ident)+),+ $(,)?]) => { $( cited!($binary $(:: $name)+); )+ };
    ($field:ident $value:tt) => {};
}

macro_rules! claims {
    ($($row:tt)*) => { rows! { $($row)* } };
}

macro_rules! errata {
    ($($row:tt)*) => { rows! { $($row)* } };
}

#[path = "../../src/papers/carr_2008/claims.rs"]
mod carr_claims;
#[path = "../../src/papers/carr_2008/errata.rs"]
mod carr_errata;
#[path = "../../src/papers/everitt_2001/claims.rs"]
mod everitt_claims;
#[path = "../../src/papers/everitt_2001/errata.rs"]
mod everitt_errata;
#[path = "../../src/papers/lindholm_2015/claims.rs"]
mod lindholm_claims;
#[path = "../../src/papers/lindholm_2015/errata.rs"]
mod lindholm_errata;
#[path = "../../src/papers/vtk/claims.rs"]
mod vtk_claims;
#[path = "../../src/papers/vtk/errata.rs"]
mod vtk_errata;

/// The tests that claims and errata name, as paths that begin with a binary's name.
pub(crate) fn cited() -> BTreeSet<&'static str> {
    let of_paper = |paper: &'static onionskin::low_level::papers::Paper| {
        let claims = paper.claims.iter().flat_map(|claim| claim.tests);
        claims.chain(paper.errata.iter().flat_map(|erratum| erratum.tests))
    };
    papers().iter().flat_map(of_paper).copied().collect()
}

/// The tests that the running binary was compiled with, as paths, in its own words.
pub(crate) fn compiled() -> BTreeSet<String> {
    let binary = std::env::current_exe().unwrap();
    let list = Command::new(binary)
        .args(["--list", "--format", "terse"])
        .output()
        .unwrap();
    assert!(list.status.success(), "{list:?}");
    let list = String::from_utf8(list.stdout).unwrap();
    let tests = list.lines().filter_map(|line| line.strip_suffix(": test"));
    tests.map(str::to_owned).collect()
}

/// What compiles may still be a function that nothing calls.
#[test]
fn the_functions_that_claims_and_errata_name_are_tests() {
    let (binary, _) = module_path!().split_once("::").unwrap();
    let compiled = compiled();
    let ours = cited().into_iter();
    let ours = ours.filter_map(|path| path.strip_prefix(binary)?.strip_prefix("::"));
    let missing: Vec<_> = ours.filter(|path| !compiled.contains(*path)).collect();
    assert!(missing.is_empty(), "{missing:?} are no tests");
}
