//! Every name in every listing is checked before anything runs, and a misspelt one is refused with the one that was meant.

use onionskin::low_level::gl::shaders;
use onionskin::low_level::papers::carr_2008::{coherent, hybrid, ideal};
use onionskin::low_level::papers::everitt_2001::{LISTING_1, REPLACED, TRIED, WINDOW_Z};
use onionskin::low_level::papers::{
    bavoil_2008, lindholm_2015, salvi_2014, stage, vasilakis_2013, vtk,
};
use onionskin::low_level::steps::{
    Amendment, Dialect, Known, Listing, Map, Query, Reading, Resources, Shader, Step, Storage,
    Target, check,
};
use onionskin::{Text, papers, steps};

use crate::kit::changed::changed;

/// In every reading.
#[test]
fn every_listing_of_every_paper_names_only_what_there_is() {
    let mut checked = 0;
    for paper in papers() {
        let known = Known::shaders(shaders()).with(paper.resources);
        for (key, text) in paper.texts {
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
    let on_lists = [&stage::COUNTING, &lindholm_2015::RESOURCES];
    for amendments in [
        &[lindholm_2015::PROXIES][..],
        &[lindholm_2015::BEGIN_AT_OFFSETS, lindholm_2015::PROXIES],
        &[lindholm_2015::ORDERED, lindholm_2015::COUNT_WHILE_FILLING],
    ] {
        passes(&lindholm_2015::CLEAR_AND_FILL, amendments, &on_lists);
    }
    passes(&lindholm_2015::CLEAR_AND_COUNTING_FILL, &[], &on_lists);
    passes(&lindholm_2015::OPAQUE_ENDS_RAYS, &[], &on_lists);
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
    Known::shaders(shaders()).with(&[&stage::RESOURCES, &lindholm_2015::RESOURCES])
}

const fn listing(steps: &'static [Step]) -> Listing {
    Listing {
        title: "a test",
        source: "this test",
        dialect: Dialect::Calls,
        steps,
    }
}
