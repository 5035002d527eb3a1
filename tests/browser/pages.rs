//! The edition's pages in a Chromium, as a reader uses them: with the mouse and with the keyboard.
//!
//! `ONIONSKIN_EDITION` is the folder of an edition (`onionskin edition -o FOLDER --quick`). `.ci/tests browser` makes one.

mod exercises;
mod reader;

use std::path::PathBuf;

use reader::{Reader, edition};

/// Every page's file.
fn pages() -> Vec<PathBuf> {
    let files = std::fs::read_dir(edition()).unwrap();
    let files = files.map(|entry| entry.unwrap().path());
    let mut pages: Vec<_> = files
        .filter(|path| path.extension().is_some_and(|it| it == "html"))
        .collect();
    pages.sort();
    assert!(pages.len() > 10, "{pages:?}");
    pages
}

#[test]
fn every_page_opens_without_an_error_every_picture_is_seen_and_nothing_is_wider_than_a_phone() {
    let reader = Reader::new();
    for page in pages() {
        reader.open(&page);
        let pictures = "[...document.images].map((it) => { it.loading = 'eager'; return it.decode().then(() => '', () => it.src); })";
        let lost = reader.ask(&format!(
            "Promise.all({pictures}).then((all) => all.join(''))"
        ));
        assert_eq!(lost, "", "{}", page.display());
        assert_eq!(reader.errors(), Vec::<String>::new(), "{}", page.display());
        reader.resize(360, 800);
        let wider = reader.ask("String(document.documentElement.scrollWidth - innerWidth)");
        assert!(
            wider.parse::<i32>().unwrap() <= 0,
            "{}: {wider}",
            page.display()
        );
    }
}

#[test]
fn an_error_of_a_page_would_be_noticed() {
    let reader = Reader::new();
    reader.open(&edition().join("index.html"));
    assert!(reader.errors().is_empty());
    reader.ask(
        "setTimeout(() => fault(), 0); new Promise((done) => setTimeout(done, 100)).then(() => '')",
    );
    assert!(reader.errors()[0].contains("fault is not defined"));
}

#[test]
fn the_keyboard_steps_through_a_listing_by_call_and_by_pass() {
    let reader = Reader::new();
    reader.open(&edition().join("everitt.html"));
    reader.ask("document.querySelector('.player .stage').focus(); ''");
    let at = || reader.ask("document.querySelector('.player input[type=range]').value");
    let current = || reader.ask("document.querySelector('.player .current')?.textContent ?? ''");
    assert_eq!((at(), current()), ("0".into(), String::new()));
    reader.press(&["ArrowRight", "ArrowRight"]);
    let second = current();
    assert_eq!(at(), "2");
    assert!(!second.is_empty());
    reader.press(&["ArrowRight"]);
    assert_ne!(current(), second);
    reader.press(&["ArrowLeft"]);
    assert_eq!((at(), current()), ("2".into(), second));
    reader.press(&["End"]);
    let end: usize = at().parse().unwrap();
    reader.press(&["Home"]);
    assert_eq!(at(), "0");
    reader.press_with_shift("ArrowRight");
    let pass: usize = at().parse().unwrap();
    assert!(pass > 2 && pass < end, "{pass} of {end}");
    let drawn = reader.ask("document.querySelector('.player .now caption').textContent");
    assert!(drawn.starts_with("This draw"), "{drawn}");
}

/// The stencil values after each draw of figure 2's program, and those after s9 is dragged before s3. The emulated pixel says
/// what they are (`tests/javascript/dragged.rs`).
#[test]
fn s9_dragged_before_s3_changes_the_stencil_values_of_figure_2() {
    let golden: serde_json::Value = serde_json::from_str(include_str!("dragged.json")).unwrap();
    let reader = Reader::new();
    reader.open(&edition().join("carr.html"));
    let player = "[...document.querySelectorAll('.player')].find((it) => it.dataset.program === 'carr/coherent-a')";
    let values = || {
        reader.ask(&format!(
            "(() => {{ const run = {player}.player.run; return JSON.stringify(run.events.filter((it) => it.fates && !it.fates.some((fate) => fate.surface === null)).map((it) => it.fates.reduce((most, fate) => Math.max(most, fate.stencil[1]), null))); }})()"
        ))
    };
    assert_eq!(values(), golden["before"].to_string());
    reader.drag(
        &format!("{player}.querySelectorAll('.handle')[9]"),
        &format!("{player}.querySelectorAll('.handle')[3]"),
        -20.0,
    );
    assert_eq!(values(), golden["after"].to_string());
    let depth = reader.ask(&format!(
        "{player}.querySelector('[data-depth=\"9\"]').value"
    ));
    println!("s9 is at {depth}");
}

#[test]
fn every_exercise_can_be_solved_and_is_then_said_to_be_solved() {
    let reader = Reader::new();
    let mut left: Vec<String> = Vec::new();
    for page in pages() {
        // Most pages have none.
        if !std::fs::read_to_string(&page)
            .unwrap()
            .contains("data-exercise=\"")
        {
            continue;
        }
        reader.open(&page);
        let keys = reader.ask("[...document.querySelectorAll('[data-exercise]')].map((it) => it.dataset.exercise).join(' ')");
        for key in keys.split_whitespace() {
            let is_solved = || {
                reader.ask(&format!("(() => {{ const it = document.querySelector('[data-exercise={key}]'); return `${{it.classList.contains('solved')}} ${{it.querySelector('.said').textContent.startsWith(' Solved.')}}`; }})()"))
            };
            assert_eq!(
                is_solved(),
                "false false",
                "{key} is solved from the beginning"
            );
            let Some(solution) = exercises::solution(key) else {
                left.push(key.to_owned());
                continue;
            };
            reader.ask(&exercises::act(key, solution));
            assert_eq!(is_solved(), "true true", "{key}: {solution}");
        }
        assert_eq!(reader.errors(), Vec::<String>::new(), "{}", page.display());
    }
    assert!(left.is_empty(), "no solution is known of {left:?}");
}

/// For those who want to look at them, in out/browser.
#[test]
fn pictures_of_chapters_at_three_widths_light_and_dark() {
    let reader = Reader::new();
    let folder = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../out/browser"));
    std::fs::create_dir_all(&folder).unwrap();
    for name in ["index", "everitt", "carr", "lindholm", "vtk"] {
        reader.open(&edition().join(format!("{name}.html")));
        for width in [360, 800, 1280] {
            for theme in ["light", "dark"] {
                reader.resize(width, 900);
                let paper = reader.ask(&format!("document.documentElement.dataset.theme = '{theme}'; getComputedStyle(document.body).backgroundColor"));
                let is_light = paper.contains("255, 255, 255");
                assert_eq!(is_light, theme == "light", "{paper}");
                let picture = reader.picture();
                assert!(picture.len() > 5_000, "{name}: {}", picture.len());
                std::fs::write(folder.join(format!("{name}-{width}-{theme}.png")), picture)
                    .unwrap();
            }
        }
    }
}
