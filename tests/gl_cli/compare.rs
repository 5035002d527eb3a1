//! `onionskin compare`: its table and its JSON are what the library has.

use crate::kit::sheets::{F32, KEYS, SHEETS, desk, library, object};
use onionskin::{Method, registry};

#[test]
fn compare_shows_every_method_in_the_registrys_order() {
    let desk = desk();
    let out = desk.result(&["compare", "sheets.toml"]);
    let rows: Vec<Vec<_>> = out
        .lines()
        .map(|line| line.split_whitespace().collect())
        .collect();
    assert_eq!(rows[0][0], "method");
    for (row, entry) in rows[1..].iter().zip(registry()) {
        assert_eq!(row[0], entry.name);
        // Iterations, passes, lost, memory, time, two errors; 'not counted' is two words.
        assert!(row.len() == 8 || out.contains("not counted"), "{out}");
    }
    let fragments = library(&desk, "sheets.toml", None, &Method::Exact)
        .stats
        .fragments;
    let after = out.lines().nth(registry().len() + 1).unwrap();
    assert_eq!(after, format!("{fragments} fragments in 40 x 30 pixels"));
    // And then what lists have cost those that have them.
    let with_lists: Vec<_> = registry()
        .iter()
        .filter(|entry| matches!(entry.method, Method::ABuffer(_)))
        .map(|entry| entry.name)
        .collect();
    let second = &rows[registry().len() + 2..];
    assert!(second[0].is_empty() && second[1][..2] == ["fragment", "lists"]);
    let names: Vec<_> = second[2..].iter().map(|row| row[0]).collect();
    assert_eq!(names, with_lists, "{out}");
    assert!(out.lines().all(|line| line.len() <= 100), "{out}");
}

#[test]
fn compare_writes_a_sheet_of_all_images_with_their_names_and_errors() {
    let desk = desk();
    let compare = ["compare", "sheets.toml", "-m", "blend,depth-peeling", "-o"];
    desk.result(&[&compare[..], &["sheet.svg"]].concat());
    let text = std::fs::read_to_string(desk.path("sheet.svg")).unwrap();
    let document = roxmltree::Document::parse(&text).unwrap();
    let named = |name| {
        document
            .descendants()
            .filter(move |node| node.has_tag_name(name))
    };
    assert_eq!(named("image").count(), 3);
    let words: Vec<_> = named("text").filter_map(|node| node.text()).collect();
    let words = words.join(" ");
    let words: Vec<_> = words.split_whitespace().collect();
    let words = words.join(" ");
    for expected in [
        "exact",
        "blend: largest error",
        "depth-peeling: largest error",
    ] {
        assert!(words.contains(expected), "no {expected}: {words}");
    }
    desk.refused(&[&compare[..], &["sheet.exr"]].concat());
}

#[test]
fn compare_as_json_prints_one_object_for_each_method() {
    let desk = desk();
    let answer = desk.run(&["compare", "sheets.toml", "--json"]);
    assert_eq!((answer.code, answer.err.as_str()), (0, ""), "{answer}");
    let objects = answer.objects();
    assert_eq!(objects.len(), registry().len(), "{answer}");
    for (object, entry) in objects.iter().zip(registry()) {
        for key in KEYS {
            assert!(object.contains_key(key), "no {key}: {answer}");
        }
        assert_eq!(object["method"], entry.name);
        let error = object["max_error"].as_f64().unwrap();
        // Fragment lists keep colours in 16 bits: the bound of `gl/a_buffer.rs`.
        let bound = match entry.method {
            Method::ABuffer(_) => 1.5e-3,
            _ => F32,
        };
        assert!(!entry.exact || error <= bound, "{answer}");
    }
    let by_name = |name| objects.iter().find(|object| object["method"] == name);
    let blend = &by_name("blend").unwrap()["max_error"];
    assert!(
        blend.as_f64().unwrap() > 0.1,
        "the sheets are shuffled: {answer}"
    );
    assert_eq!(by_name("exact").unwrap()["max_error"], 0.0);
}

#[test]
fn compare_takes_methods_by_name_in_the_order_that_is_asked_for() {
    let answer = desk().run(&["compare", "sheets.toml", "--json", "-m", "painter, blend"]);
    let objects = answer.objects();
    let names: Vec<_> = objects.iter().map(|object| &object["method"]).collect();
    assert_eq!(names, ["painter", "blend"]);
}

#[test]
fn fragments_that_a_tie_has_cost_are_a_note_of_compare() {
    let scene = SHEETS.replace("spacing = 0.3", "spacing = 0.0");
    let desk = desk().with("ties.toml", scene);
    let answer = desk.run(&["compare", "ties.toml", "-m", "depth-peeling", "--json"]);
    let object = object(&answer);
    // Of five sheets in one place one is kept.
    let (lost, fragments) = (object["lost"].as_u64(), object["fragments"].as_u64());
    assert_eq!(lost.unwrap() * 5, fragments.unwrap() * 4);
    answer.says(&["note: ", "fragments are not in the image of depth-peeling"]);
}

#[test]
fn work_of_some_seconds_draws_no_progress_where_there_is_no_terminal() {
    let scene = SHEETS
        .replace("count = 5", "count = 48")
        .replace("[40, 30]", "[1024, 768]");
    let desk = desk().with("long.toml", scene);
    // `result` holds that standard error is empty.
    let out = desk.result(&["compare", "long.toml", "-m", "depth-peeling"]);
    assert!(!out.contains(['\r', '\u{1b}']), "{out}");
}

#[test]
fn in_every_reading_both_tables_say_which() {
    let out = desk().result(&["compare", "sheets.toml", "-m", "ppll+ppdp", "--readings"]);
    let readings = ["literal", "as-printed", "amended"];
    for table in ["method ", "fragment lists "] {
        let rows = out
            .lines()
            .skip_while(|line| !line.trim_start().starts_with(table));
        let rows: Vec<_> = rows.take(4).collect();
        assert!(rows[0].contains("reading"), "{out}");
        for (row, reading) in rows[1..].iter().zip(readings) {
            let mut words = row.split_whitespace();
            assert_eq!(
                (words.next(), words.next()),
                (Some("ppll+ppdp"), Some(reading)),
                "{out}"
            );
        }
    }
}
