//! The papers are data: nothing in them runs on a machine.

use std::path::Path;

use crate::imports::House;

/// Where machines are, and what runs listings on them.
const RUNS: &str = "steps/walk.rs";

#[test]
fn no_paper_runs_anything() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let imports = House::read(&folder, "lib.rs").imports();
    let runs = |room: &str| {
        let of_room = imports.iter().filter(|(file, _)| file.starts_with(room));
        let naming = of_room.filter_map(|(file, named)| Some((file, named.get(RUNS)?)));
        naming
            .map(|(file, name)| format!("{file} names {name}"))
            .collect::<Vec<_>>()
    };
    assert_eq!(runs("papers/"), Vec::<String>::new());
    for file in ["papers/vtk.rs", "papers/carr_2008/hybrid.rs"] {
        assert!(imports.contains_key(file), "{file} was not read");
    }
    // Whoever does run listings is found.
    assert!(!runs("methods/").is_empty());
}
