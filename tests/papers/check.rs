//! Every name in every listing is checked before anything runs, and a misspelt one is refused with the one that was meant.

use std::collections::BTreeMap;

use onionskin::low_level::gl::shaders;
use onionskin::low_level::papers::carr_2008::{coherent, hybrid, ideal};
use onionskin::low_level::papers::everitt_2001::{LISTING_1, REPLACED, TRIED, WINDOW_Z};
use onionskin::low_level::papers::{
    bavoil_2008, lindholm_2015, salvi_2014, stage, vasilakis_2013, vtk,
};
use onionskin::low_level::steps::{
    Amendment, Dialect, Expr, Index, Known, Listing, Map, Met, Name, Query, Reading, Resources,
    Scope, Shader, Statement, Step, Storage, Target, check, gl::*,
};
use onionskin::{Text, papers, steps};

use crate::kit::changed::changed;

/// In every reading.
#[test]
fn every_listing_of_every_paper_names_only_what_there_is() {
    let mut checked = 0;
    for paper in papers() {
        for (key, text) in paper.texts {
            let known = Known::shaders(shaders()).with(&paper.resources_of(key));
            for reading in Reading::ALL {
                if let Text::Listing(listing, amendments) = text {
                    check(listing, &reading.of(amendments), &known)
                        .unwrap_or_else(|error| panic!("{}/{key}: {error}", paper.key));
                    checked += 1;
                }
            }
        }
    }
    assert!(checked >= 3 * 25, "{checked}");
}

/// A name that another text of the same paper has is none of this text's, unless it takes it for granted, too: a map, a
/// framebuffer, a shader, a buffer, a variable or a query.
#[test]
fn a_name_of_another_text_of_the_same_paper_is_refused() {
    let mut refused: BTreeMap<&str, usize> = BTreeMap::new();
    for paper in papers() {
        let listings = || {
            let texts = paper.texts.iter();
            texts.filter_map(|(key, text)| match text {
                Text::Listing(listing, amendments) => Some((*key, names(listing, amendments))),
                _ => None,
            })
        };
        for (key, own) in listings() {
            let resources = paper.resources_of(key);
            let known = Known::shaders(shaders()).with(&resources);
            for (other, theirs) in listings() {
                let not_ours = |name: &&Name| !own.contains(name) && !taken(&resources, name);
                for name in theirs.iter().filter(not_ours) {
                    let (kind, steps) = naming(*name);
                    let error = check(&listing(steps), &[], &known)
                        .expect_err(&format!("{}/{key} knows {name:?} of {other}", paper.key));
                    assert!(error.to_string().contains("does not exist"), "{error}");
                    *refused.entry(kind).or_default() += 1;
                }
            }
        }
    }
    println!("{refused:?}");
    let kinds: Vec<_> = refused.keys().copied().collect();
    assert_eq!(
        kinds,
        [
            "buffer",
            "framebuffer",
            "map",
            "query",
            "shader",
            "variable"
        ]
    );
}

/// Whether a text takes the name for granted, without naming it itself: as a framebuffer's map, or because every method has it.
fn taken(resources: &[&Resources], name: &Name) -> bool {
    resources.iter().any(|it| match name {
        Name::Map(map) => it.maps.iter().any(|(other, _)| other == map),
        Name::Target(target) => it.framebuffers.iter().any(|other| other.target == *target),
        _ => false,
    })
}

/// Everything that a listing names in any reading. A row of maps is one name.
fn names(listing: &'static Listing, amendments: &'static [Amendment]) -> Vec<Name> {
    let mut found = Vec::new();
    for reading in Reading::ALL {
        collect(
            listing.steps,
            Scope::of(&reading.of(amendments)),
            &mut found,
        );
    }
    for name in &mut found {
        if let Name::Map(map) = name
            && map.index != Index::Only
        {
            *map = Map::numbered(map.name, 0);
        }
    }
    found
}

fn collect(steps: &'static [Step], scope: Scope<'_, Step>, found: &mut Vec<Name>) {
    for met in scope.walk(steps) {
        let Met::Statement(step, scope) = met else {
            continue;
        };
        match *step {
            Step::Call(call) => found.extend(call.names()),
            Step::Let { variable, value } => {
                found.push(Name::Variable(variable));
                in_expr(&value, found);
            }
            Step::For { variable, to, .. } => {
                found.push(Name::Variable(variable));
                in_expr(&to, found);
            }
            Step::ForDown { variable, from, .. } => {
                found.push(Name::Variable(variable));
                in_expr(&from, found);
            }
            Step::Stop { when, .. }
            | Step::If {
                condition: when, ..
            } => {
                in_expr(&when.left, found);
                in_expr(&when.right, found);
            }
            Step::Run {
                listing,
                amendments,
            } => {
                collect(listing.steps, scope.around(amendments), found);
            }
            Step::DepthUnit { .. } | Step::Margin(_) => {}
        }
        for body in step.bodies() {
            collect(body, scope, found);
        }
    }
}

fn in_expr(expr: &Expr, found: &mut Vec<Name>) {
    match *expr {
        Expr::Number(_) => {}
        Expr::Variable(name) => found.push(Name::Variable(name)),
        Expr::Samples(query) => found.push(Name::Query(query)),
        Expr::Sum(a, b) | Expr::Difference(a, b) | Expr::Product(a, b) | Expr::Remainder(a, b) => {
            in_expr(a, found);
            in_expr(b, found);
        }
    }
}

/// A kind of name, and a listing that has nothing but this name.
fn naming(name: Name) -> (&'static str, &'static [Step]) {
    let (kind, step) = match name {
        Name::Map(map) => ("map", Step::Call(glBindTexture(map))),
        Name::Target(target) => ("framebuffer", Step::Call(glBindFramebuffer(target))),
        Name::Shader(shader) => ("shader", Step::Call(glUseProgram(shader))),
        Name::Storage(storage) => ("buffer", Step::Call(glBindStorageBuffer(0, storage))),
        Name::Query(query) => ("query", set(Expr::Samples(query))),
        Name::Variable(name) => ("variable", set(Expr::Variable(name))),
    };
    (kind, vec![step].leak())
}

const fn set(value: Expr) -> Step {
    Step::Let {
        variable: "a value",
        value,
    }
}

/// What methods run besides, and amendments that they choose.
#[test]
fn listings_and_amendments_that_stand_in_no_text_name_only_what_there_is() {
    let passes = |listing: &Listing, amendments: &[Amendment], resources: &[&'static Resources]| {
        let known = Known::shaders(shaders())
            .with(&[&stage::RESOURCES])
            .with(resources);
        check(listing, amendments, &known).unwrap();
    };
    passes(&stage::COUNT, &[], &[]);
    passes(&stage::COUNT_AT_EACH_PIXEL, &[], &[&stage::COUNTING]);
    passes(&lindholm_2015::COUNT_BY_STENCIL, &[], &[&stage::COUNTING]);
    // It is run where the peels have ended, with their variables.
    let left = [
        &bavoil_2008::RESOURCES,
        &Resources {
            variables: &["B"],
            ..Resources::NONE
        },
    ];
    passes(&bavoil_2008::COUNT_FRAGMENTS_LEFT, &[], &left);
    for amendments in [WINDOW_Z, REPLACED] {
        let resources = [&stage::ACCUMULATING, &vtk::PEELING, &TRIED];
        passes(&vtk::ON_THE_FLY, amendments, &resources);
        passes(&vtk::KEEP_LAYERS, amendments, &resources);
    }
    let nodes = [
        &salvi_2014::RESOURCES_OF_EIGHT,
        &Resources {
            variables: &["nodes"],
            ..Resources::NONE
        },
    ];
    passes(&salvi_2014::COUNT_TAKEN, &[], &nodes);
    passes(
        &vasilakis_2013::COPLANAR_PEELING,
        &[],
        &[&vasilakis_2013::RESOURCES],
    );
    let on_lists = [
        &stage::COUNTING,
        &lindholm_2015::FILLING,
        &lindholm_2015::RESOLVING,
    ];
    for amendments in [
        &[lindholm_2015::PROXIES][..],
        &[lindholm_2015::BEGIN_AT_OFFSETS, lindholm_2015::PROXIES],
        &[lindholm_2015::ORDERED, lindholm_2015::COUNT_WHILE_FILLING],
    ] {
        passes(&lindholm_2015::CLEAR_AND_FILL, amendments, &on_lists);
    }
    passes(&lindholm_2015::CLEAR_AND_COUNTING_FILL, &[], &on_lists);
    let of_volumes = Resources {
        made: &[lindholm_2015::RAY_ENDS],
        ..Resources::NONE
    };
    check(
        &lindholm_2015::OPAQUE_ENDS_RAYS,
        &[],
        &Known::shaders(shaders()).with(&[&stage::RESOURCES, Box::leak(Box::new(of_volumes))]),
    )
    .unwrap();
    passes(&lindholm_2015::CLEAR_COST, &[], &on_lists);
    let by_images = [&ideal::RESOURCES, &ideal::NO_COLOR_RESOURCES];
    passes(
        &ideal::IDEAL,
        &ideal::TIGHT_BOUND_ON_GL,
        &[&ideal::RESOURCES],
    );
    passes(&ideal::IDEAL, &ideal::BY_IMAGES, &by_images);
    passes(&hybrid::HYBRID, &hybrid::AMENDMENTS, &hybrid::RESOURCES);
    for amendment in [
        coherent::TIE_FRIENDLY,
        coherent::STOP_ON_PASS_1,
        coherent::STOP_ON_SECTION_6,
        coherent::UP_TO_THE_BATCH_END,
    ] {
        let amendments = [&coherent::AMENDMENTS[..], &[amendment]].concat();
        passes(&coherent::VARIANT_A, &amendments, &coherent::RESOURCES_A);
        passes(&coherent::VARIANT_B, &amendments, &coherent::RESOURCES_B);
    }
}

#[test]
fn a_misspelt_name_is_refused_with_the_one_that_was_meant() {
    // As long as nothing is misspelt, it is fine.
    check(
        &listing(steps! { glBindTexture(stage::OPAQUE_DEPTH); }),
        &[],
        &known(),
    )
    .unwrap();
    let misspelt: [(&[Step], [&str; 3]); 7] = [
        (
            steps! { glBindTexture(Map::named("opaque dpeth")); },
            ["the map 'opaque dpeth'", "glBindTexture(", "'opaque depth'"],
        ),
        (
            steps! { glBindFramebuffer(Target("imgae")); },
            ["the framebuffer 'imgae'", "glBindFramebuffer(", "'image'"],
        ),
        (
            steps! { glUseProgram(Shader("clip/open_closd")); },
            [
                "the shader 'clip/open_closd'",
                "glUseProgram(",
                "'clip/open_closed'",
            ],
        ),
        (
            steps! { glBindStorageBuffer(0, Storage("fragment record")); },
            [
                "the storage buffer 'fragment record'",
                "glBindBufferBase(",
                "'fragment records'",
            ],
        ),
        (
            steps! { num_peels = 1; for (i in 0..num_peel) { drawScreen(); } },
            [
                "the variable 'num_peel'",
                "for i from 0 to num_peel",
                "'num_peels'",
            ],
        ),
        (
            steps! { glBeginQuery(PIXELS); glEndQuery(PIXELS); n = samples(PIXLES); },
            [
                "the query 'pixles'",
                "n = glGetQueryObject(pixles)",
                "'pixels'",
            ],
        ),
        (
            steps! { glBeginQuery(PIXELS); glEndQuery(PIXLES); },
            ["the query 'pixles'", "glEndQuery(", "'pixels'"],
        ),
    ];
    for (steps, said) in misspelt {
        let error = check(&listing(steps), &[], &known())
            .unwrap_err()
            .to_string();
        for words in said {
            assert!(error.contains(words), "{words}: {error}");
        }
    }
}

const PIXELS: Query = Query("pixels");
const PIXLES: Query = Query("pixles");

/// In a branch, in a loop, in what is run, and in what an amendment puts in.
#[test]
fn a_misspelt_name_is_found_wherever_it_stands() {
    const INNER: Listing = listing(steps! { glUseProgram(Shader("surfcae")); });
    for steps in [
        steps! { n = 1; if (n == 0) { glUseProgram(Shader("surfcae")); } else {} },
        steps! { n = 1; if (n == 1) {} else { glUseProgram(Shader("surfcae")); } },
        steps! { for (i in 0..0) { glUseProgram(Shader("surfcae")); } },
        steps! { run INNER; },
        steps! { depth unit 0: { glUseProgram(Shader("surfcae")); } },
    ] {
        let error = check(&listing(steps), &[], &known()).unwrap_err();
        assert!(
            error.to_string().contains("Did you mean 'surface'?"),
            "{error}"
        );
    }
    const AMENDED: Amendment = changed(
        steps! { clear color buffer; },
        steps! { glUseProgram(Shader("surfcae")); },
    );
    let known = known().with(&[&vtk::PEELING]);
    let error = check(&LISTING_1, &[AMENDED], &known).unwrap_err();
    assert!(error.to_string().contains("surfcae"), "{error}");
    check(&LISTING_1, &[], &known).unwrap();
    // What an amendment replaces need not be there.
    const CURED: Amendment = changed(
        steps! { glUseProgram(Shader("surfcae")); },
        steps! { glUseProgram(stage::SURFACE); },
    );
    check(&INNER, &[CURED], &known).unwrap();
}

#[test]
fn a_row_of_maps_is_known_under_any_variable_and_under_its_numbers() {
    let known = known().with(&[&vtk::PEELING]);
    let passes = |steps| check(&listing(steps), &[], &known).is_ok();
    assert!(passes(
        steps! { k = 0; glBindTexture(Map::at("depth buffer", "k")); }
    ));
    assert!(passes(
        steps! { glBindTexture(Map::numbered("depth buffer", 1)); }
    ));
    assert!(!passes(
        steps! { glBindTexture(Map::numbered("depth buffer", 2)); }
    ));
    assert!(!passes(
        steps! { glBindTexture(Map::named("depth buffer")); }
    ));
    assert!(!passes(
        steps! { glBindTexture(Map::at("depth buffer", "k")); }
    ));
    assert!(!passes(
        steps! { glBindTexture(Map::numbered("opaque depth", 0)); }
    ));
    // Layers are made as they come.
    assert!(passes(steps! { glBindTexture(Map::numbered("layer", 7)); }));
}

#[test]
fn a_query_that_is_never_ended_is_refused() {
    let begun = listing(steps! { glBeginQuery(PIXELS); drawScreen(); });
    let error = check(&begun, &[], &known()).unwrap_err().to_string();
    assert!(error.contains("never ends it"), "{error}");
}

fn known() -> Known {
    Known::shaders(shaders()).with(&[&stage::RESOURCES, &lindholm_2015::FILLING])
}

const fn listing(steps: &'static [Step]) -> Listing {
    Listing {
        title: "a test",
        source: "this test",
        dialect: Dialect::Calls,
        steps,
    }
}
