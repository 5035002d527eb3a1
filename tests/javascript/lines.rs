//! Every step of a program says at which printed line it stands.

use onionskin::low_level::edition::program_json::programs;
use serde_json::Value;

/// Steps in the order of printing, those inside of others behind them.
fn steps<'v>(steps: &'v Value, found: &mut Vec<&'v Value>) {
    for step in steps.as_array().into_iter().flatten() {
        found.push(step);
        for part in ["body", "then", "otherwise"] {
            self::steps(&step[part], found);
        }
    }
}

/// What stands in the line of a step, as far as it is always the same.
fn begins(step: &Value) -> &str {
    match step["step"].as_str().unwrap() {
        "call" => step["name"].as_str().unwrap(),
        "let" => step["variable"].as_str().unwrap(),
        "if" => "if",
        "for" | "for-down" => "for",
        "stop" => "break",
        "depth-unit" => "depth unit",
        "run" => step["title"].as_str().unwrap(),
        "silence" => "the paper does not say",
        _ => "",
    }
}

#[test]
fn every_step_stands_at_the_line_that_is_printed_for_it() {
    let mut compared = 0;
    for program in programs() {
        let lines = program["lines"].as_array().unwrap();
        let mut found = Vec::new();
        steps(&program["steps"], &mut found);
        let mut last = None;
        for step in found {
            let Some(number) = step["line"].as_u64() else {
                // What a line of pseudocode runs is not printed.
                assert_eq!(step["step"], "line", "{step}");
                continue;
            };
            let line = &lines[number as usize];
            let text = line["text"].as_str().unwrap();
            let resolves = step["step"] == "resolve";
            assert!(
                resolves || last < Some(number),
                "{}: {step}",
                program["key"]
            );
            last = Some(number);
            // Everitt's words for calls are not OpenGL's.
            let in_words = line["source"] == "Everitt 2001, Listing 1" && step["step"] == "call";
            assert!(
                in_words || text.contains(begins(step)),
                "{}: {text}: {step}",
                program["key"]
            );
            assert_eq!(
                line["note"].as_bool().unwrap(),
                ["run", "silence", "resolve"].contains(&step["step"].as_str().unwrap())
                    || text.starts_with("// if the query"),
                "{text}"
            );
            compared += 1;
        }
    }
    assert!(compared > 1000, "{compared}");
}

#[test]
fn listing_1_s_lines_are_those_of_its_steps() {
    let all = programs();
    let program = all
        .iter()
        .find(|it| it["key"] == "everitt/depth-peeling")
        .unwrap();
    let mut found = Vec::new();
    steps(&program["steps"], &mut found);
    let texts = found.iter().filter_map(|step| step["line"].as_u64());
    let lines = texts.map(|number| &program["lines"][number as usize]);
    let printed =
        lines.filter(|line| line["source"] == "Everitt 2001, Listing 1" && line["note"] == false);
    let printed: Vec<_> = printed
        .map(|line| line["text"].as_str().unwrap().trim())
        .collect();
    assert_eq!(
        printed[..12],
        [
            "for (i=0; i<num_passes; i++)",
            "clear color buffer",
            "A = i % 2",
            "B = (i+1) % 2",
            "depth unit 0:",
            "if(i == 0)",
            "disable depth test",
            "enable depth test",
            "bind buffer A",
            "disable depth writes",
            "set depth func to GREATER",
            "depth unit 1:",
        ]
    );
}
