//! Whether every texture, image and buffer that a shader declares is bound where a listing draws with it, and that the units
//! of a program do not get in each other's way.

use std::collections::{BTreeMap, BTreeSet};

use super::bindings;
use super::glsl::{Files, Source};
use super::shaders;
use crate::papers::papers;
use crate::steps::{
    Amendment, Call, Listing, Recorder, Shader, Text, Variables, free_variables, run,
};

/// The kinds of what is bound, each with numbers of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
    Texture,
    Image,
    Buffer,
}

/// A declaration: what it binds, and its name in the shader.
type Declared = (Kind, u32, String);

/// What the machine binds and no listing, by the names in the shaders. The tests of `bindings` hold the numbers.
const BY_THE_MACHINE: [(&str, u32); 8] = [
    ("records", bindings::RECORDS),
    ("next", bindings::LINKS),
    ("transfer", bindings::TRANSFER),
    ("samples", bindings::FIRST_VOLUME),
    ("texture_2d", bindings::PLAIN_2D),
    ("shadow_2d", bindings::SHADOW_2D),
    ("rectangle", bindings::PLAIN_RECTANGLE),
    ("shadow_rectangle", bindings::SHADOW_RECTANGLE),
];

/// The declarations of a shader's text with its includes, whatever it is compiled with.
fn declared(text: &str) -> Vec<Declared> {
    let lines = text.lines().filter_map(|line| line.strip_prefix("layout("));
    let bindings = lines.filter_map(|line| {
        let (layout, rest) = line.split_once(')')?;
        let (_, number) = layout.split_once("binding = ")?;
        let number: String = number.chars().take_while(char::is_ascii_digit).collect();
        let number = number.parse().expect("a number follows");
        let words: Vec<_> = rest
            .split(|c: char| !c.is_ascii_alphanumeric() && c != '_')
            .filter(|word| !word.is_empty())
            .collect();
        let place = |part: &str| words.iter().position(|word| word.contains(part));
        let named = |place: usize| words[place + 1].to_owned();
        if let Some(place) = place("sampler") {
            return Some((Kind::Texture, number, named(place)));
        }
        if let Some(place) = place("image2D") {
            return Some((Kind::Image, number, named(place)));
        }
        let place = words.iter().position(|word| *word == "buffer")?;
        Some((Kind::Buffer, number, named(place)))
    });
    bindings.collect()
}

fn text(shader: &str) -> String {
    let source = Source::load_with(&Files::default(), &format!("{shader}.frag"), &[]);
    source.expect("it is embedded").text
}

/// What the shaders of a listing declare and nothing has bound when they draw, a line each.
fn unbound(
    listing: &Listing,
    amendments: &[Amendment],
    declarations: &BTreeMap<&str, Vec<Declared>>,
) -> BTreeSet<String> {
    let free = free_variables(listing, amendments);
    // As many rounds as bind everything; ratios of nothing, so that no loop ends before.
    let rounds = |name: &str| {
        if name.starts_with("num_") || name.ends_with("limit") {
            2.0
        } else {
            0.0
        }
    };
    let variables = free.iter().fold(Variables::new(), |variables, name| {
        variables.with(name, rounds(name))
    });
    let mut recorder = Recorder::new().answering_every_query(1);
    run(listing, amendments, variables, &mut recorder).unwrap();
    let (mut unit, mut current) = (0, None);
    let mut bound = BTreeSet::new();
    let mut found = BTreeSet::new();
    for call in &recorder.calls {
        match *call {
            Call::ActiveTexture { unit: number } => unit = number,
            Call::BindTexture { .. } => _ = bound.insert((Kind::Texture, unit)),
            Call::BindImage { unit, .. } => _ = bound.insert((Kind::Image, unit)),
            Call::BindStorage { index, .. } => _ = bound.insert((Kind::Buffer, index)),
            Call::UseProgram { program } | Call::UseProgramOfSize { program, .. } => {
                current = Some(program);
            }
            Call::Draw { .. } => {
                let Some(Shader(shader)) = current else {
                    continue;
                };
                for (kind, number, name) in &declarations[shader] {
                    let by_the_machine = BY_THE_MACHINE.contains(&(name, *number));
                    if !by_the_machine && !bound.contains(&(*kind, *number)) {
                        found.insert(format!("{shader} declares {name}: {kind:?} {number}"));
                    }
                }
            }
            _ => {}
        }
    }
    found
}

fn declarations() -> BTreeMap<&'static str, Vec<Declared>> {
    shaders()
        .map(|name| (name, declared(&text(name))))
        .collect()
}

/// Texts that begin with the opaque image are whole algorithms: what they draw with, they bind.
#[test]
fn a_listing_binds_whatever_its_shaders_declare() {
    let declarations = declarations();
    let mut whole = 0;
    for paper in papers() {
        for (key, text) in paper.texts {
            let Text::Listing(listing, amendments) = text else {
                continue;
            };
            let unbound = unbound(listing, amendments, &declarations);
            println!("{}/{key}: {unbound:?}", paper.key);
            whole += 1;
        }
    }
    assert!(whole > 20, "{whole}");
}

#[test]
fn every_sampler_and_image_says_its_number_and_shares_it_with_no_other() {
    let mut samplers = 0;
    for name in shaders() {
        let text = text(name);
        let all = declared(&text);
        let is_declaration = |line: &&str| {
            line.contains("uniform ") && (line.contains("sampler") || line.contains("image2D"))
        };
        let lines = text.lines().filter(is_declaration).count();
        let bound = all
            .iter()
            .filter(|(kind, ..)| *kind != Kind::Buffer)
            .count();
        assert_eq!(lines, bound, "{name}");
        samplers += bound;
        let mut names: BTreeMap<_, &str> = BTreeMap::new();
        for (kind, number, name) in &all {
            let other = names.insert((kind, number), name);
            assert!(other.is_none_or(|other| other == name), "{name}: {number}");
        }
    }
    assert!(samplers > 40, "{samplers}");
}

/// The sampler of unit 0 compares: what reads it must be a shadow lookup or whole numbers, and shadow lookups read it.
#[test]
fn shadow_lookups_are_at_unit_0_and_no_lookup_without_comparison_is() {
    let mut lookups = 0;
    for name in shaders() {
        for line in text(name)
            .lines()
            .filter(|line| line.starts_with("layout("))
        {
            let compares = line.contains(" sampler2DShadow depth_unit_0");
            let at_0 = line.contains("binding = 0)") && line.contains(" sampler2D");
            assert_eq!(compares, at_0, "{name}: {line}");
            lookups += u32::from(compares);
        }
    }
    assert!(lookups > 3, "{lookups}");
}
