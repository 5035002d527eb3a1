//! Whether every texture, image and buffer that a shader declares is bound where a listing draws with it, and that the units
//! of a program do not get in each other's way.

use std::collections::{BTreeMap, BTreeSet};

use super::bindings;
use super::glsl::{Files, Source};
use super::shaders;
use crate::papers::carr_2008::ideal;
use crate::papers::edition;
use crate::papers::papers;
use crate::papers::salvi_2014;
use crate::papers::stage::OPAQUE_DEPTH;
use crate::steps;
use crate::steps::{
    Amendment, Call, DepthUnits, Dialect, Listing, Recorder, Shader, Text, Variables,
    free_variables, run,
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
const BY_THE_MACHINE: [(&str, u32); 10] = [
    ("records", bindings::RECORDS),
    ("next", bindings::LINKS),
    ("pieces", bindings::PIECES),
    ("numbers", bindings::NUMBERS),
    ("transfer", bindings::TRANSFER),
    ("samples", bindings::FIRST_VOLUME),
    ("texture_2d", bindings::PLAIN_2D),
    ("shadow_2d", bindings::SHADOW_2D),
    ("rectangle", bindings::PLAIN_RECTANGLE),
    ("shadow_rectangle", bindings::SHADOW_RECTANGLE),
];

/// What a text's shaders declare and the text does not bind, with what does.
const ELSEWHERE: [(&str, &[&str], &str); 9] = [
    (
        "carr/pass-6",
        &["lower", "opaque", "other_upper", "upper"],
        "pass 5, whose shader has the same",
    ),
    (
        "carr/ideal",
        &["depths_image", "image_image", "peel_image"],
        "BY_IMAGES, where images are used in place of framebuffer fetch",
    ),
    ("lindholm/complexity-image", &["opaque"], RAYS),
    ("lindholm/clear-and-fill", &["opaque"], RAYS),
    (
        "lindholm/fill-for-pp-ao",
        &["opaque"],
        "the verified painter, which fills lists for the pixels that it marked; and OPAQUE_ENDS_RAYS",
    ),
    ("lindholm/resolve", &["Offsets", "opaque"], OFFSETS),
    ("lindholm/pp-ao", &["Offsets", "opaque"], OFFSETS),
    ("salvi/four-nodes", &["node_images", "opaque"], IMAGES),
    ("salvi/eight-nodes", &["node_images", "opaque"], IMAGES),
];
const IMAGES: &str =
    "FOUR_IMAGES or EIGHT_IMAGES, where images are used in place of framebuffer fetch";
const RAYS: &str = "OPAQUE_ENDS_RAYS, where there are volumes or depths are 1/w";
const OFFSETS: &str = "BEGIN_AT_OFFSETS in the Fill Step, and OPAQUE_ENDS_RAYS";

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
    let source = Source::load_with(&Files::default(), &[&format!("{shader}.frag")], &[]);
    source.expect("it is embedded").text
}

/// What the shaders of a listing declare and nothing has bound when they draw: the shader and the name.
fn unbound(
    listing: &Listing,
    amendments: &[Amendment],
    declarations: &BTreeMap<&str, Vec<Declared>>,
) -> BTreeSet<(&'static str, String)> {
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
    let mut machine = DepthUnits::new(&mut recorder);
    run(listing, amendments, variables, &mut machine).unwrap();
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
                        found.insert((shader, name.clone()));
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

#[test]
fn a_listing_binds_whatever_its_shaders_declare() {
    let declarations = declarations();
    let mut listings = 0;
    for paper in papers() {
        for (key, text) in paper.texts {
            let Text::Listing(listing, amendments) = text else {
                continue;
            };
            let unbound = unbound(listing, amendments, &declarations);
            let names: BTreeSet<&str> = unbound.iter().map(|(_, name)| name.as_str()).collect();
            let text = format!("{}/{key}", paper.key);
            let elsewhere = ELSEWHERE.iter().find(|(other, ..)| *other == text);
            let elsewhere = elsewhere.map_or(&[][..], |(_, names, _)| names);
            let expected = elsewhere.iter().copied().collect();
            assert_eq!(names, expected, "{text}: {unbound:?}");
            listings += 1;
        }
    }
    assert!(listings > 20, "{listings}");
    for (listing, amendments) in [
        (&ideal::IDEAL, &ideal::BY_IMAGES[..]),
        (&salvi_2014::FOUR_NODES, &[salvi_2014::FOUR_IMAGES]),
        (&salvi_2014::EIGHT_NODES, &[salvi_2014::EIGHT_IMAGES]),
        (&edition::VERIFIED_PAINTER, &[]),
    ] {
        let by_images = unbound(listing, amendments, &declarations);
        assert!(by_images.is_empty(), "{by_images:?}");
    }
}

#[test]
fn a_unit_that_a_listing_forgets_is_noticed() {
    let forgets = Listing {
        title: "A layer that is not bound",
        source: "a test",
        dialect: Dialect::Calls,
        steps: steps! {
            glUseProgram(Shader("layer"));
            glActiveTexture(3);
            glBindTexture(OPAQUE_DEPTH);
            drawScreen();
        },
    };
    let unbound = unbound(&forgets, &[], &declarations());
    assert_eq!(unbound, BTreeSet::from([("layer", "picture".into())]));
}

#[test]
fn every_sampler_and_image_says_its_number_and_shares_it_with_no_other() {
    let mut samplers = 0;
    for name in shaders() {
        let text = text(name);
        let all = declared(&text);
        let is_declaration = |line: &&str| {
            let is_bound = line.contains("sampler") || line.contains("image2D");
            // The machine tells this one its unit by a uniform.
            line.contains("uniform ") && is_bound && !line.contains("unsigned_hilo")
        };
        let code = text.lines().filter_map(|line| line.split("//").next());
        let lines = code.filter(is_declaration).count();
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
