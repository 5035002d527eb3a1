//! A changed word is noticed, and what may be changed is what stands there.

use onionskin::low_level::edition::program_json::{object, programs};
use onionskin::low_level::edition::programs;
use onionskin::low_level::steps::{Reading, Text};
use serde_json::{Value, json};

use crate::cases;
use crate::compare::first_difference;
use crate::node::Node;
use crate::pseudocode;

/// Changes in a program's words: its key, a call or a line, an argument, and two words.
const CHANGES: [[&str; 5]; 16] = [
    [
        "everitt/depth-peeling",
        "glDepthFunc",
        "func",
        "GL_GREATER",
        "GL_GEQUAL",
    ],
    [
        "everitt/depth-peeling",
        "glBlendFuncSeparate",
        "srcRGB",
        "GL_SRC_ALPHA",
        "GL_ONE",
    ],
    [
        "vtk/keep-layers",
        "glDisable",
        "cap",
        "GL_DEPTH_TEST",
        "GL_STENCIL_TEST",
    ],
    [
        "vtk/on-the-fly",
        "glBlendFuncSeparate",
        "dstAlpha",
        "GL_ONE",
        "GL_ZERO",
    ],
    [
        "carr/layer-peeling",
        "glDepthFunc",
        "func",
        "GL_LESS",
        "GL_LEQUAL",
    ],
    ["carr/hybrid", "swap", "a", "zPeel", "zPeelNext"],
    [
        "carr/coherent-a",
        "glStencilOp",
        "dpfail",
        "GL_INVERT",
        "GL_KEEP",
    ],
    ["carr/coherent-a", "glStencilFunc", "ref", "128", "2"],
    [
        "carr/coherent-b",
        "glBlendFuncSeparate",
        "srcRGB",
        "GL_DST_ALPHA",
        "GL_ONE",
    ],
    ["carr/ideal", "glColorMaski", "red", "GL_FALSE", "GL_TRUE"],
    [
        "bavoil/dual-peeling",
        "glBlendEquationi",
        "mode",
        "GL_MAX",
        "GL_MIN",
    ],
    [
        "edition/verified-painter",
        "glDepthFunc",
        "func",
        "GL_LESS",
        "GL_LEQUAL",
    ],
    ["carr/algorithm-1", "if", "ab", "<", "<="],
    ["carr/algorithm-2", "set", "value", "true", "false"],
    ["lindholm/pp-ao", "count", "by", "integer", "INCR"],
    ["lindholm/pp-dp", "if", "by", "depth, id", "depth"],
];

/// Changes the word wherever it stands, and says how often that is.
fn change(value: &mut Value, [call, argument, from, to]: [&str; 4]) -> usize {
    let mut changed = 0;
    if value["name"] == call && value["arguments"][argument] == from {
        value["arguments"][argument] = to.into();
        changed += 1;
    }
    let inside: Vec<&mut Value> = match value {
        Value::Array(all) => all.iter_mut().collect(),
        Value::Object(all) => all.values_mut().collect(),
        _ => Vec::new(),
    };
    for value in inside {
        if !value.is_null() && (value.is_array() || value.is_object()) {
            changed += change(value, [call, argument, from, to]);
        }
    }
    changed
}

#[test]
fn a_word_that_is_changed_for_javascript_alone_is_noticed_on_few_surfaces() {
    let Some(mut node) = Node::start() else {
        return;
    };
    let pixels = cases::random_pixels(1, 300);
    for [key, call, argument, from, to] in CHANGES {
        let program = programs::all().iter().find(|it| it.key == key).unwrap();
        let readings = program.readings();
        let amended = readings.iter().find(|it| it.contains(&Reading::Amended));
        let mut changed = object(program, amended.unwrap());
        let count = change(&mut changed["steps"], [call, argument, from, to]);
        assert!(count > 0, "{key} has no {from} in {call}");
        node.run(&changed);
        let differ = match program.text {
            Text::Listing(..) => first_difference,
            _ => pseudocode::first_difference,
        };
        let found = differ(&mut node, program, Reading::Amended, &pixels);
        let found = found.unwrap_or_else(|| panic!("{key}: {to} in {call} is not noticed"));
        // It is told on as few surfaces as show it: ppDP peels twice where one is left that its array has no room for.
        let surfaces = found.matches("Surface {").count();
        let most = program.array.map_or(3, |array| array as usize + 1);
        assert!(surfaces <= most, "{found}");
        assert!(found.contains("JavaScript"), "{found}");
    }
}

/// Every call and every line of pseudocode with its arguments.
fn words(value: &Value, found: &mut Vec<[String; 3]>) {
    let inside: Vec<&Value> = match value {
        Value::Array(all) => all.iter().collect(),
        Value::Object(all) => all.values().collect(),
        _ => return,
    };
    if let (Some(name), Some(arguments)) = (value["name"].as_str(), value["arguments"].as_object())
    {
        for (argument, word) in arguments {
            if let Some(word) = word.as_str() {
                found.push([name, argument, word].map(str::to_owned));
            }
        }
    }
    inside.into_iter().for_each(|value| words(value, found));
}

#[test]
fn the_words_that_may_stand_somewhere_are_those_that_do_among_others() {
    let Some(mut node) = Node::start() else {
        return;
    };
    let mut found = Vec::new();
    for program in programs() {
        words(&program["steps"], &mut found);
    }
    found.sort();
    found.dedup();
    let asked: Vec<_> = found
        .iter()
        .map(|[call, argument, _]| json!([call, argument]))
        .collect();
    let answer = node.answer_to(&json!({ "words": asked }));
    let mut chosen = 0;
    for ([call, argument, word], words) in found.iter().zip(answer.as_array().unwrap()) {
        let words = words.as_array().unwrap();
        // A word of OpenGL's is one of several, but for names and for bits.
        let is_free = [
            "texture",
            "target",
            "mask",
            "attachment",
            "textarget",
            "barriers",
            "sampler",
            "pname",
            "buffer",
        ];
        let is_word = word.starts_with("GL_") && !is_free.contains(&argument.as_str());
        assert!(!is_word || words.len() > 1, "{call} {argument} {word}");
        assert!(
            words.is_empty() || words.contains(&json!(word)),
            "{call} {argument} {word}: {words:?}"
        );
        chosen += usize::from(words.len() > 1);
    }
    assert!(chosen > 50, "{chosen}");
}

#[test]
fn what_no_machine_performs_is_an_error_and_names_its_event() {
    let Some(mut node) = Node::start() else {
        return;
    };
    let program = programs::all()
        .iter()
        .find(|it| it.key == "carr/coherent-a")
        .unwrap();
    assert!(matches!(program.text, Text::Listing(..)));
    let case = json!({ "surfaces": [[0.5, 1.0, 0.0, 0.0, 0.5, "unsorted"]], "options": { "variables": { "iteration_limit": 9.0 } } });
    for (from, to, says) in [
        ("GL_LESS", "GL_FEWER", "GL_FEWER cannot stand here"),
        ("GL_LESS", "GL_INVERT", "GL_INVERT cannot stand here"),
    ] {
        let mut changed = object(program, &[Reading::Amended]);
        change(&mut changed["steps"], ["glDepthFunc", "func", from, to]);
        node.run(&changed);
        let left = node.answer_to(&json!({ "runs": [case] }));
        assert_eq!(left[0]["error"]["what"], says);
        assert_eq!(left[0]["error"]["event"], left[0]["events"]);
    }
    // A loop that does not end is left after as many calls as are wanted.
    // As printed, this one composites what lies on the opaque surface for ever.
    let surfaces = [
        json!([0.5, 1.0, 0.0, 0.0, 0.5, "unsorted"]),
        json!([0.5, 0.0, 0.0, 1.0, 1.0, "opaque"]),
    ];
    let variables = json!({ "iteration_limit": null });
    let endless =
        json!({ "surfaces": surfaces, "options": { "variables": variables, "limit": 5000 } });
    node.run(&object(program, &[Reading::AsPrinted]));
    let left = node.answer_to(&json!({ "runs": [endless] }));
    assert_eq!(left[0]["error"], Value::Null);
    assert_eq!(left[0]["stopped"], "limit");
}

#[test]
fn in_a_page_the_machine_is_one_global_that_runs_programs_and_tells_words() {
    let Some(mut node) = Node::start() else {
        return;
    };
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/src/edition/web/machine.js");
    let names = node.answer_to(&json!({ "page": path }));
    assert_eq!(names, json!(["onionskin", "run", "words"]));
}
