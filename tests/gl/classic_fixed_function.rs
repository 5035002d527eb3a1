//! The OpenGL of 2001: the emulation against the real fixed functions of a compatibility profile, pixel for pixel.
//!
//! Coordinates and matrices are short binary fractions, so that what is done once a vertex is exact in any order of
//! operations; what is done once a fragment (interpolation, r/q, comparison, environment, alpha test) is on whatever
//! numbers come of it. So no bound is needed: every bit of colour and depth has to be the same.

use crate::kit::driver::rounds_each_operation;
use crate::kit::stack;
use std::cell::RefCell;
use std::collections::BTreeMap;

use crate::kit::classic_cases::{
    COMPARISONS, Case, Looked, SIZE, Unit, cases, count, scene, words,
};
use onionskin::low_level::gl::{FixedFunction, Geometry, GlMachine, Profile};
use onionskin::low_level::steps::{
    Call, Capability, ClassicCall, ClassicCapability, DepthTextureMode, Machine, Map, MatrixMode,
    Objects, Shader, Target, TexEnvName, TexEnvValue, TextureTarget, gl::*,
};
use onionskin::{Context, ContextOptions, Format};
use proptest::strategy::{Strategy as _, ValueTree as _};
use proptest::test_runner::{TestCaseError, TestError, TestRunner};

const IMAGE: Map = Map::named("image");
const DEPTH: Map = Map::named("depth");
const MAP_COLOR: [Map; 2] = [Map::numbered("map color", 0), Map::numbered("map color", 1)];
const MAP_DEPTH: [Map; 2] = [Map::numbered("map depth", 0), Map::numbered("map depth", 1)];
const MAP_RECTANGLE: [Map; 2] = [
    Map::numbered("map rectangle", 0),
    Map::numbered("map rectangle", 1),
];
const DRAWN: Target = Target("drawn");
const MAPPED: Target = Target("mapped");

#[test]
pub(crate) fn e04_the_emulation_is_the_real_fixed_functions_pixel_for_pixel() {
    let context = compatibility();
    if !rounds_each_operation(&context) {
        return;
    }
    let machine = RefCell::new(GlMachine::new(&context, SIZE).unwrap());
    let seen = RefCell::new(BTreeMap::<String, u32>::new());
    for_all_words(5, |case| {
        let machine = &mut machine.borrow_mut();
        let emulated = render(machine, &case, &case, false).unwrap();
        let real = render(machine, &case, &case, true).unwrap();
        count(&mut seen.borrow_mut(), &case, &emulated);
        let wrong = emulated.iter().zip(&real).filter(|(a, b)| a != b).count();
        if wrong == 0 {
            Ok(())
        } else {
            Err(TestCaseError::fail(format!("{wrong} pixels differ")))
        }
    });
    let seen = seen.into_inner();
    println!("{seen:#?}");
    // The cases have had everything, and have had something to decide.
    for func in COMPARISONS {
        assert!(seen[&format!("alpha {func:?}")] > 0 && seen[&format!("compare {func:?}")] > 0);
    }
    for mode in ["Luminance", "Intensity", "Alpha"] {
        assert!(seen[mode] > 10, "{mode}");
    }
    for looked in ["Color", "Depth", "Rectangle"] {
        assert!(seen[looked] > 10, "{looked}");
    }
    assert!(seen["has pixels"] > seen["cases"] / 4);
}

#[test]
fn each_changed_word_would_be_noticed() {
    let context = compatibility();
    if !rounds_each_operation(&context) {
        return;
    }
    let machine = &mut GlMachine::new(&context, SIZE).unwrap();
    // A map that slopes through what is drawn, so that every comparison has both answers.
    let plain = Unit {
        looked: Looked::Depth,
        compare: Some(LEQUAL),
        mode: DepthTextureMode::Alpha,
        replace: false,
        translate: [0; 3],
        scale: 0,
        planes: None,
        bias: 0,
    };
    let corner = |x, y, z| ([x, y, z], [7, 5, 3, 6]);
    let case = Case {
        map: vec![[
            corner(-64, -64, -20),
            corner(64, -64, -40),
            corner(0, 64, -36),
        ]],
        drawn: vec![
            [
                corner(-40, -32, -34),
                corner(40, -32, -24),
                corner(0, 32, -28),
            ],
            [
                corner(-24, 28, -44),
                corner(28, 24, -40),
                corner(4, -28, -20),
            ],
        ],
        units: [
            plain.clone(),
            Unit {
                looked: Looked::Nothing,
                ..plain.clone()
            },
        ],
        alpha: Some((GREATER, 2)),
        depth: Format::Depth32FStencil8,
    };
    let real = render(machine, &case, &case, true).unwrap();
    assert!(render(machine, &case, &case, false).unwrap() == real);
    let with = |change: &dyn Fn(&mut Case)| {
        let mut other = case.clone();
        change(&mut other);
        other
    };
    let others = [
        ("alpha func", with(&|case| case.alpha = Some((LESS, 2)))),
        ("alpha test off", with(&|case| case.alpha = None)),
        (
            "compare func",
            with(&|case| case.units[0].compare = Some(GREATER)),
        ),
        ("no comparison", with(&|case| case.units[0].compare = None)),
        (
            "depth mode",
            with(&|case| case.units[0].mode = DepthTextureMode::Luminance),
        ),
        ("environment", with(&|case| case.units[0].replace = true)),
        (
            "modelview of the planes",
            with(&|case| case.units[0].translate = [8, 0, 0]),
        ),
        (
            "planes",
            with(&|case| case.units[0].planes = Some([[8, 0, 0, 0], [0, 8, 0, 0], [0, 0, 9, 0]])),
        ),
    ];
    for (name, other) in others {
        let emulated = render(machine, &case, &other, false).unwrap();
        assert!(emulated != real, "{name} was not noticed");
    }
}

#[test]
pub(crate) fn v08_a_rectangle_texture_gives_what_a_texture_of_2d_gives() {
    // sampler2DRectShadow against sampler2DShadow: the same texels by coordinates in texels instead of 0 to 1. Sides
    // are powers of two, so that scaling by them is exact.
    let context = compatibility();
    let machine = RefCell::new(GlMachine::new(&context, SIZE).unwrap());
    for_all_words(1, |case| {
        let as_a = |looked| {
            let mut case = case.clone();
            case.units[0].looked = looked;
            case.units[0].planes = None;
            case.units[1].looked = Looked::Nothing;
            render(&mut machine.borrow_mut(), &case, &case, false).unwrap()
        };
        if as_a(Looked::Depth) == as_a(Looked::Rectangle) {
            Ok(())
        } else {
            Err(TestCaseError::fail("they differ"))
        }
    });
}

#[test]
fn a_core_context_is_refused_with_what_to_do() {
    let context = Context::headless().unwrap();
    let mut machine = GlMachine::new(&context, SIZE).unwrap();
    machine.set_geometry(Geometry::upload(&context, &scene(&[]), SIZE).unwrap());
    let error = FixedFunction::new(&mut machine).unwrap_err().to_string();
    assert!(
        error.contains("core profile") && error.contains("Compatibility"),
        "{error}"
    );
}

#[test]
fn nv_texture_shader_is_refused_by_name_where_it_does_not_exist() {
    let context = compatibility();
    let mut machine = GlMachine::new(&context, SIZE).unwrap();
    machine.set_geometry(Geometry::upload(&context, &scene(&[]), SIZE).unwrap());
    let mut fixed = FixedFunction::new(&mut machine).unwrap();
    for call in [
        ClassicCall::BindUnsignedHilo,
        ClassicCall::TexEnv {
            target: TexEnvName::TextureShader,
            pname: TexEnvName::ShaderOperation,
            param: TexEnvValue::DotProduct,
        },
        ClassicCall::Enable {
            cap: ClassicCapability::TextureShader,
        },
    ] {
        let error = fixed.perform(&Call::Classic(call)).unwrap_err().to_string();
        assert!(error.contains("NV_texture_shader"), "{error}");
    }
}

/// Tests so many random cases of each combination of words. Cases of the same words follow each other, because a driver
/// compiles for a fifth of a second for each combination, and keeps few.
#[track_caller]
fn for_all_words(count: u32, test: impl Fn(Case) -> Result<(), TestCaseError>) {
    let mut random = stack::runner(count);
    let all = words().new_tree(&mut random).expect("words").current();
    for words in all {
        let rng = random.new_rng();
        let mut runner = TestRunner::new_with_rng(random.config().clone(), rng);
        if let Err(error) = runner.run(&cases(words), &test) {
            match error {
                TestError::Fail(why, case) => panic!("{why}\nthe smallest case: {case:#?}"),
                error => panic!("{error}"),
            }
        }
    }
}

fn compatibility() -> Context {
    Context::new(ContextOptions {
        profile: Profile::Compatibility,
        ..Default::default()
    })
    .unwrap()
}

/// The image by `calls_of`'s calls on `geometry_of`'s scenes, each pixel's colour and depth as bits.
fn render(
    machine: &mut GlMachine<'_>,
    geometry_of: &Case,
    calls_of: &Case,
    real: bool,
) -> onionskin::Result<Vec<[u32; 5]>> {
    let depth = geometry_of.depth;
    for unit in 0..2 {
        machine.allocate(MAP_COLOR[unit], Format::Rgba32F)?;
        machine.allocate(MAP_DEPTH[unit], depth)?;
    }
    machine.allocate(IMAGE, Format::Rgba32F)?;
    machine.allocate(DEPTH, depth)?;
    let context = machine.context();
    machine.set_geometry(Geometry::upload(context, &scene(&geometry_of.map), SIZE)?);
    machine.begin_frame();
    for unit in 0..2 {
        machine.framebuffer(MAPPED, Some(MAP_COLOR[unit]), Some(MAP_DEPTH[unit]))?;
        draw(machine, Shader("surface"))?;
    }
    machine.set_geometry(Geometry::upload(context, &scene(&geometry_of.drawn), SIZE)?);
    machine.begin_frame();
    machine.framebuffer(DRAWN, Some(IMAGE), Some(DEPTH))?;
    let calls = classic_calls(calls_of);
    if real {
        let fixed = &mut FixedFunction::new(machine)?;
        calls.iter().try_for_each(|call| fixed.perform(call))?;
        draw(fixed, Shader("classic/fixed"))?;
    } else {
        calls.iter().try_for_each(|call| machine.perform(call))?;
        draw(machine, Shader("classic/fixed"))?;
    }
    let colors = machine.read_colors(IMAGE)?;
    let depths = machine.read_depths(DEPTH)?;
    let pixels = colors.iter().zip(depths);
    Ok(pixels
        .map(|(color, depth)| {
            let [r, g, b, a] = color.map(f32::to_bits);
            [r, g, b, a, depth.to_bits()]
        })
        .collect())
}

fn draw(machine: &mut impl Machine, program: Shader) -> onionskin::Result<()> {
    for call in [
        Call::Enable {
            cap: Capability::DepthTest,
        },
        Call::Clear {
            mask: COLOR_AND_DEPTH_BUFFER_BITS,
        },
        Call::UseProgram { program },
        Call::Draw {
            objects: Objects::Scene,
        },
    ] {
        machine.perform(&call)?;
    }
    Ok(())
}

fn classic_calls(case: &Case) -> Vec<Call> {
    let mut calls = Vec::new();
    for (number, unit) in (0..).zip(&case.units) {
        let place = number as usize;
        calls.push(ClassicCall::ActiveTexture { unit: number });
        let (target, texture, cap) = match unit.looked {
            Looked::Nothing => continue,
            Looked::Color => (
                TextureTarget::Texture2D,
                MAP_COLOR[place],
                ClassicCapability::Texture2D,
            ),
            Looked::Depth => (
                TextureTarget::Texture2D,
                MAP_DEPTH[place],
                ClassicCapability::Texture2D,
            ),
            Looked::Rectangle => {
                calls.push(ClassicCall::CopyToRectangle {
                    from: MAP_DEPTH[place],
                    to: MAP_RECTANGLE[place],
                });
                (
                    TextureTarget::Rectangle,
                    MAP_RECTANGLE[place],
                    ClassicCapability::TextureRectangle,
                )
            }
        };
        calls.extend([
            ClassicCall::BindTexture { target, texture },
            ClassicCall::Enable { cap },
        ]);
        if unit.looked != Looked::Color {
            calls.push(ClassicCall::TextureCompareMode {
                on: unit.compare.is_some(),
            });
            calls.push(ClassicCall::DepthTextureMode { mode: unit.mode });
            if let Some(func) = unit.compare {
                calls.push(ClassicCall::TextureCompareFunc { func });
            }
        }
        calls.push(ClassicCall::TexEnv {
            target: TexEnvName::TextureEnv,
            pname: TexEnvName::TextureEnvMode,
            param: if unit.replace {
                TexEnvValue::Replace
            } else {
                TexEnvValue::Modulate
            },
        });
        calls.extend(coordinates(unit));
    }
    if let Some((func, reference)) = case.alpha {
        calls.extend([
            ClassicCall::Enable {
                cap: ClassicCapability::AlphaTest,
            },
            ClassicCall::AlphaFunc {
                func,
                reference: f32::from(reference) / 8.0,
            },
        ]);
    }
    calls.into_iter().map(Call::Classic).collect()
}

/// Generation with the planes at the unit's modelview matrix, then the camera's projection, scaled and biased to the
/// texture.
fn coordinates(unit: &Unit) -> Vec<ClassicCall> {
    let [x, y, z] = unit.translate.map(|n| f32::from(n) / 16.0);
    let scale = f32::from(unit.scale).exp2();
    let planes = match unit.planes {
        None => ClassicCall::EyeLinearTexgen,
        Some([s, t, r]) => ClassicCall::EyePlanes {
            planes: [
                s.map(|n| f32::from(n) / 8.0),
                t.map(|n| f32::from(n) / 8.0),
                r.map(|n| f32::from(n) / 8.0),
                [0.0, 0.0, 0.0, 1.0],
            ],
        },
    };
    let [width, height] = match unit.looked {
        Looked::Rectangle => SIZE.map(|side| side as f32),
        _ => [1.0; 2],
    };
    let bias = f32::from(unit.bias) / 65536.0;
    vec![
        ClassicCall::MatrixMode {
            mode: MatrixMode::Modelview,
        },
        ClassicCall::PushMatrix,
        ClassicCall::LoadIdentity,
        ClassicCall::Translate { x, y, z },
        ClassicCall::Scale {
            x: scale,
            y: scale,
            z: scale,
        },
        planes,
        ClassicCall::Texgen { on: true },
        ClassicCall::PopMatrix,
        ClassicCall::MatrixMode {
            mode: MatrixMode::Texture,
        },
        ClassicCall::LoadIdentity,
        ClassicCall::Translate {
            x: width / 2.0,
            y: height / 2.0,
            z: 0.5 + bias,
        },
        ClassicCall::Scale {
            x: width / 2.0,
            y: height / 2.0,
            z: 0.5,
        },
        ClassicCall::ApplyPerspective,
        ClassicCall::MatrixMode {
            mode: MatrixMode::Modelview,
        },
    ]
}
