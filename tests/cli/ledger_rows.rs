//! `onionskin claims` and `onionskin errata`.

use onionskin::papers;

use crate::kit::cli::Desk;

fn array(value: &serde_json::Value) -> &[serde_json::Value] {
    value.as_array().unwrap()
}

fn result(arguments: &[&str]) -> String {
    Desk::new().result(arguments)
}

/// Every row as JSON has these keys and no others, and is the row.
#[test]
fn as_json_every_row_is_an_object_with_the_keys_that_the_help_names() {
    let claims = [
        "claim", "evidence", "figures", "key", "paper", "place", "tests", "verdict",
    ];
    let errata = [
        "change", "executed", "key", "kind", "paper", "place", "printed", "tests",
    ];
    for (command, expected) in [("claims", claims), ("errata", errata)] {
        let objects = Desk::new().run(&[command, "--json"]).objects();
        let help = result(&[command, "--help"]);
        for object in &objects {
            let keys: Vec<_> = object.keys().map(String::as_str).collect();
            assert_eq!(keys, expected);
            for figure in object.get("figures").into_iter().flat_map(array) {
                let keys: Vec<_> = figure.as_object().unwrap().keys().collect();
                assert_eq!(keys, ["here", "of", "paper"]);
            }
        }
        for key in expected {
            assert!(help.contains(key), "{key}: {help}");
        }
        let keys: Vec<_> = objects
            .iter()
            .map(|object| object["key"].as_str().unwrap())
            .collect();
        let rows: Vec<_> = papers()
            .iter()
            .flat_map(|paper| match command {
                "claims" => paper
                    .claims
                    .iter()
                    .map(|claim| claim.key)
                    .collect::<Vec<_>>(),
                _ => paper.errata.iter().map(|erratum| erratum.key).collect(),
            })
            .collect();
        assert_eq!(keys, rows);
    }
}

#[test]
fn a_claim_as_json_has_the_papers_figures_beside_ours() {
    let objects = Desk::new().run(&["claims", "C03", "--json"]).objects();
    let [claim] = &objects[..] else {
        panic!("one claim")
    };
    assert_eq!(claim["paper"], "carr");
    assert_eq!(claim["verdict"], "in kind");
    let figure = &claim["figures"][1];
    assert_eq!(
        (&figure["paper"], &figure["here"]),
        (&"257".into(), &"259".into())
    );
    let name = "gl::claims_carr::c03_figure_1_takes_3_iterations_instead_of_257";
    assert!(claim["tests"].as_array().unwrap().contains(&name.into()));
}

#[test]
fn a_paper_gives_its_rows_and_a_key_in_any_case_one_with_its_tests() {
    for (command, key, test) in [
        ("claims", "L08", "gl::claims_lindholm::l08_"),
        ("errata", "LX14", "gl::claims_lindholm::l08_"),
    ] {
        let of_paper = result(&[command, "lindholm"]);
        assert_eq!(of_paper, result(&[command, "LINDHOLM"]));
        let of_key = result(&[command, key]);
        assert_eq!(of_key, result(&[command, &key.to_lowercase()]));
        for text in [&of_paper, &of_key] {
            assert!(text.contains(key) && text.contains("Lindholm"), "{text}");
            assert!(!text.contains("Everitt, "), "{text}");
        }
        assert!(
            of_key.contains(test) && !of_paper.contains(test),
            "{of_key}"
        );
    }
}

#[test]
fn the_rows_fit_into_80_columns_and_are_counted() {
    for (command, rows, kinds) in [
        (
            "claims",
            papers()
                .iter()
                .map(|paper| paper.claims.len())
                .sum::<usize>(),
            "reproduced",
        ),
        (
            "errata",
            papers().iter().map(|paper| paper.errata.len()).sum(),
            "contradiction",
        ),
    ] {
        let text = result(&[command]);
        for line in text.lines() {
            assert!(
                line.chars().count() <= 80 && line.trim_end() == line,
                "{line:?}"
            );
        }
        let last = text.lines().last().unwrap();
        assert!(
            last.starts_with(&format!("{rows} {command}: ")) && last.contains(kinds),
            "{last}"
        );
    }
}

#[test]
fn an_unknown_name_is_refused_with_what_was_meant_and_what_there_is() {
    for (command, name, meant) in [
        ("claims", "everit", "'everitt'"),
        ("claims", "E99", "'E09'"),
        ("errata", "CXX16", "'CX16'"),
    ] {
        let answer = Desk::new().refused(&[command, name]);
        answer.says(&[&format!("'{name}'"), &format!("Did you mean {meant}")]);
        // Of each paper the first and the last key, and not all in between.
        for paper in papers() {
            let keys: Vec<_> = match command {
                "claims" => paper.claims.iter().map(|claim| claim.key).collect(),
                _ => paper.errata.iter().map(|erratum| erratum.key).collect(),
            };
            if let [first, .., last] = keys[..] {
                answer.says(&[&format!("{} ({first} to {last})", paper.key)]);
            }
        }
    }
    for name in ["nonsense", "carr/pass-1", ""] {
        Desk::new()
            .refused(&["errata", name])
            .says(&[&format!("'{name}'"), "Known are: everitt (EX01 to "]);
    }
    Desk::new()
        .refused(&["claims", "C01", "C02"])
        .says(&["'C02'"]);
    // A paper without rows is none here.
    Desk::new()
        .refused(&["errata", "bavoil"])
        .says(&["'bavoil'"]);
}
