//! What `tests/browser` sees when a reader drags s9 before s3 in figure 2: the stencil values are the emulated pixel's.

use std::path::Path;

use onionskin::low_level::edition::program_json::{COLOR, DEPTH};
use onionskin::low_level::edition::programs;
use onionskin::low_level::emulator::{Emulator, Group, Surface};
use onionskin::low_level::methods::allocate_maps;
use onionskin::low_level::steps::{Reading, Text, Variables, run};
use onionskin::{Fragment, Rgba};
use serde_json::{Value, json};

/// The largest stencil value that each draw of surfaces leaves a fragment with, or null if there was none.
fn stencil_values(surfaces: &[Value]) -> Vec<Option<u8>> {
    let program = programs::all()
        .iter()
        .find(|it| it.key == "carr/coherent-a");
    let program = program.unwrap();
    let Text::Listing(listing, amendments) = &program.text else {
        panic!("{} is pseudocode", program.key);
    };
    let number = |value: &Value| value.as_f64().unwrap() as f32;
    let surfaces = surfaces.iter().zip(0..).map(|(it, order)| Surface {
        fragment: Fragment {
            depth: number(&it["depth"]),
            color: Rgba::from([0, 1, 2, 3].map(|channel| number(&it["color"][channel]))),
            order,
        },
        group: match it["group"].as_str().unwrap() {
            "sorted" => Group::Sorted,
            "opaque" => Group::Opaque,
            _ => Group::Unsorted,
        },
    });
    let mut emulator = Emulator::new(vec![surfaces.collect()]).watching(0);
    allocate_maps(&mut emulator, &program.resources(), COLOR, DEPTH).unwrap();
    let mut variables = Variables::new();
    for &(name, value) in program.variables {
        variables.set(name, value);
    }
    let amended = Reading::Amended.of(amendments);
    run(listing, &amended, variables, &mut emulator).unwrap();
    let draws = emulator.record().draws.iter();
    draws
        .map(|draw| draw.fates.iter().map(|fate| fate.stencil[1]).max())
        .collect()
}

#[test]
fn the_stencil_values_of_figure_2_before_and_after_s9_is_dragged_are_those_that_the_page_is_held_to()
 {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let book = include_str!("../../src/edition/web/exercises.json");
    let book: Value = serde_json::from_str(book).unwrap();
    let mut surfaces = book["scenes"]["figure-2"]["surfaces"]
        .as_array()
        .unwrap()
        .clone();
    let before = stencil_values(&surfaces);
    // The paper's values after its passes 1 to 4, in the second iteration.
    assert!(
        before
            .windows(2)
            .any(|two| two == [Some(3), Some(1)] || two == [Some(3), Some(3)])
    );
    assert!(before.contains(&Some(251)));
    // Between s4 and s3.
    surfaces[9]["depth"] = json!(0.2);
    let after = stencil_values(&surfaces);
    assert_ne!(before, after);
    let dragged = json!({ "before": before, "after": after });
    let file = folder.join("tests/browser/dragged.json");
    if std::env::var_os("BLESS").is_some() {
        std::fs::write(&file, format!("{dragged}\n")).unwrap();
    }
    // A published archive has no browser tests.
    match std::fs::read_to_string(&file) {
        Ok(kept) => assert_eq!(serde_json::from_str::<Value>(&kept).unwrap(), dragged),
        Err(_) => println!("skipped: there is no {}", file.display()),
    }
}
