//! Each mistake is made by separate code, in pictures of random colours that 8 bits can hold, and must be recognised.
//! Where there is no mistake, none may be reported.

use proptest::prelude::*;
use rand_pcg::Pcg32;

use super::*;
use crate::fragment::Rgba;

const BACKGROUND: [f32; 3] = [0.2, 0.4, 0.6];
const BOUND: f64 = 1.0 / 255.0;
const SIZE: [u32; 2] = [40, 30];

/// A picture without symmetry. A third of it is background, and the rest has colours that are nowhere grey.
fn exact(seed: u64) -> Image {
    let mut chance = Pcg32::new(seed, 54);
    let mut unit = move || (chance.next_u32() >> 8) as f32 / (1 << 24) as f32;
    let mut image = Image::filled(SIZE[0], SIZE[1], Rgba::opaque(BACKGROUND));
    for pixel in image.pixels.iter_mut().skip(400) {
        *pixel = Rgba::opaque([unit() * 0.3, 0.35 + unit() * 0.3, 0.7 + unit() * 0.3]);
    }
    image
}

fn changed(image: &Image, change: impl Fn(Rgba) -> Rgba) -> Image {
    Image {
        pixels: image.pixels.iter().map(|&pixel| change(pixel)).collect(),
        ..*image
    }
}

/// The picture as an 8-bit file keeps it.
fn in_8_bits(image: &Image) -> Image {
    let round = |v: f32| (v.clamp(0.0, 1.0) * 255.0).round() / 255.0;
    changed(image, |p| {
        Rgba::new(round(p.r), round(p.g), round(p.b), round(p.a))
    })
}

/// A picture with each pixel taken from another place of `image`, or from the background if that place is outside.
fn moved(image: &Image, place: impl Fn(i64, i64) -> [i64; 2]) -> Image {
    let [width, height] = [i64::from(image.width), i64::from(image.height)];
    let mut moved = Image::filled(image.width, image.height, Rgba::opaque(BACKGROUND));
    for y in 0..height {
        for x in 0..width {
            let [i, j] = place(x, y);
            if (0..width).contains(&i) && (0..height).contains(&j) {
                moved.pixels[(y * width + x) as usize] = image.pixel(i as u32, j as u32);
            }
        }
    }
    moved
}

#[track_caller]
fn looks_like(image: &Image, exact: &Image, words: &[&str]) {
    let image = in_8_bits(image);
    let found = resemblance(&image, exact, BOUND, BACKGROUND).expect("a mistake is found");
    for word in words {
        assert!(found.sentence.contains(word), "no '{word}' in: {found}");
    }
    assert!(found.explains > NEARLY_ALL && found.explains <= 1.0);
}

/// IEC 61966-2-1, in f64 and from the standard's table rather than from this crate.
fn encoded(linear: f32) -> f32 {
    let v = f64::from(linear);
    let encoded = if v <= 0.003_130_8 {
        v * 12.92
    } else {
        1.055 * v.powf(1.0 / 2.4) - 0.055
    };
    encoded as f32
}

fn decoded(encoded: f32) -> f32 {
    let v = f64::from(encoded);
    let linear = if v <= 0.040_45 {
        v / 12.92
    } else {
        ((v + 0.055) / 1.055).powf(2.4)
    };
    linear as f32
}

fn in_colors(image: &Image, change: impl Fn(f32) -> f32) -> Image {
    changed(image, |p| {
        Rgba::new(change(p.r), change(p.g), change(p.b), p.a)
    })
}

#[test]
fn a_difference_in_alpha_alone() {
    let exact = exact(1);
    looks_like(
        &changed(&exact, |p| Rgba { a: 0.3, ..p }),
        &exact,
        &["Only alpha", "colours are equal"],
    );
}

#[test]
fn srgb_both_ways() {
    let exact = exact(2);
    looks_like(&in_colors(&exact, encoded), &exact, &["encoded as sRGB"]);
    looks_like(
        &in_colors(&exact, decoded),
        &exact,
        &["exact one is the sRGB", "encoding of the image"],
    );
}

#[test]
fn a_gamma_of_2_2_is_told_from_srgb() {
    let exact = exact(3);
    looks_like(
        &in_colors(&exact, |v| v.powf(1.0 / 2.2)),
        &exact,
        &["gamma of 2.2", "encoded"],
    );
    looks_like(
        &in_colors(&exact, |v| v.powf(2.2)),
        &exact,
        &["gamma of 2.2", "decoded"],
    );
}

#[test]
fn the_negative() {
    let exact = exact(4);
    looks_like(&in_colors(&exact, |v| 1.0 - v), &exact, &["negative"]);
}

#[test]
fn flips_and_a_half_turn() {
    let exact = exact(5);
    let [right, bottom] = SIZE.map(|side| i64::from(side) - 1);
    looks_like(
        &moved(&exact, |x, y| [x, bottom - y]),
        &exact,
        &["flipped vertically"],
    );
    looks_like(
        &moved(&exact, |x, y| [right - x, y]),
        &exact,
        &["flipped horizontally"],
    );
    looks_like(
        &moved(&exact, |x, y| [right - x, bottom - y]),
        &exact,
        &["180 degrees"],
    );
}

#[test]
fn every_shift_of_up_to_seven_pixels() {
    let exact = exact(6);
    for [dx, dy] in [[1, 0], [-1, 0], [0, 1], [0, -3], [7, -7], [-2, 5]] {
        let x = match dx {
            0 => "",
            1 => "1 pixel to the right",
            -1 => "1 pixel to the left",
            dx if dx < 0 => "2 pixels to the left",
            _ => "7 pixels to the right",
        };
        let y = match dy {
            0 => "",
            1 => "1 pixel down",
            -3 => "3 pixels up",
            -7 => "7 pixels up",
            _ => "5 pixels down",
        };
        looks_like(
            &moved(&exact, |i, j| [i - dx, j - dy]),
            &exact,
            &["shifted by", x, y],
        );
    }
}

#[test]
fn channels_in_another_order() {
    let exact = exact(7);
    looks_like(
        &changed(&exact, |p| Rgba::new(p.b, p.g, p.r, p.a)),
        &exact,
        &["BGR"],
    );
    looks_like(
        &changed(&exact, |p| Rgba::new(p.g, p.b, p.r, p.a)),
        &exact,
        &["GBR"],
    );
}

#[test]
fn a_factor_even_where_it_takes_colours_out_of_range() {
    let exact = exact(8);
    looks_like(&in_colors(&exact, |v| v * 0.5), &exact, &["times 0.5"]);
    looks_like(&in_colors(&exact, |v| v * 1.25), &exact, &["times 1.2"]);
}

#[test]
fn premultiplied_against_straight_and_the_other_way() {
    let alpha = |p: Rgba| Rgba { a: 0.25 + p.r, ..p };
    let straight = changed(&exact(9), alpha);
    let premultiplied = changed(&straight, |p| {
        Rgba::new(p.r * p.a, p.g * p.a, p.b * p.a, p.a)
    });
    looks_like(&premultiplied, &straight, &["it is premultiplied"]);
    looks_like(&straight, &premultiplied, &["the image is straight"]);
}

/// Sheets of varying opacity over a background: the exact image, and the same over another background or over none.
fn sheets(background: Rgba) -> Image {
    let mut image = exact(10);
    for (index, pixel) in image.pixels.iter_mut().enumerate() {
        let alpha = if index < 400 {
            0.0
        } else {
            (index % 17) as f32 / 20.0
        };
        let [over, under] = [alpha, 1.0 - alpha];
        *pixel = Rgba::new(
            pixel.r * over + background.r * under,
            pixel.g * over + background.g * under,
            pixel.b * over + background.b * under,
            over + background.a * under,
        );
    }
    image
}

#[test]
fn another_background_behind_what_is_translucent() {
    let exact = sheets(Rgba::opaque(BACKGROUND));
    let black = sheets(Rgba::opaque([0.0; 3]));
    looks_like(
        &black,
        &exact,
        &[
            "another background",
            "[0.000, 0.000, 0.000]",
            "[0.200, 0.400, 0.600]",
        ],
    );
}

#[test]
fn no_background_at_all() {
    let exact = sheets(Rgba::opaque(BACKGROUND));
    let premultiplied = sheets(Rgba::new(0.0, 0.0, 0.0, 0.0));
    looks_like(
        &premultiplied,
        &exact,
        &["transparent background", "premultiplied"],
    );
    let straight = changed(&premultiplied, |p| {
        let divided = |v: f32| if p.a > 0.0 { v / p.a } else { 0.0 };
        Rgba::new(divided(p.r), divided(p.g), divided(p.b), p.a)
    });
    // An EXR: 8 bits of a colour that is divided and multiplied again would be less than the bound.
    let found = resemblance(&straight, &exact, BOUND, BACKGROUND).unwrap();
    assert!(found.sentence.contains("straight"), "{found}");
}

#[test]
fn a_mistake_with_a_few_other_pixels_is_named_with_how_much_it_explains() {
    let exact = exact(11);
    let mut image = in_colors(&exact, encoded);
    for pixel in image.pixels.iter_mut().take(60) {
        *pixel = Rgba::opaque([1.0, 0.0, 1.0]);
    }
    let found = resemblance(&in_8_bits(&image), &exact, BOUND, BACKGROUND).unwrap();
    assert_eq!(found.explains, 1.0 - 60.0 / 1200.0);
    assert!(
        found
            .to_string()
            .ends_with("95 % of the pixels that differ.)"),
        "{found}"
    );
}

#[test]
fn equal_pictures_look_like_nothing() {
    let exact = exact(12);
    assert_eq!(
        resemblance(&in_8_bits(&exact), &exact, BOUND, BACKGROUND),
        None
    );
}

#[test]
fn what_none_of_the_mistakes_makes_looks_like_nothing() {
    let exact = exact(13);
    // Another scene, a hole, and a picture that is not a number.
    assert_eq!(
        resemblance(&super::tests::exact(14), &exact, BOUND, BACKGROUND),
        None
    );
    let mut hole = exact.clone();
    for y in 12..20 {
        for x in 5 + y % 3..17 {
            hole.pixels[y * 40 + x] = Rgba::opaque([0.9, (x % 5) as f32 / 5.0, 0.1]);
        }
    }
    assert_eq!(resemblance(&hole, &exact, BOUND, BACKGROUND), None);
    let nothing = changed(&exact, |_| {
        Rgba::new(f32::NAN, f32::NAN, f32::NAN, f32::NAN)
    });
    assert_eq!(resemblance(&nothing, &exact, BOUND, BACKGROUND), None);
}

proptest! {
    #[test]
    fn pictures_of_any_size_and_colours_are_answered(
        width in 1_u32..12,
        height in 1_u32..12,
        seed in any::<u64>(),
    ) {
        let crop = |image: &Image| Image {
            width,
            height,
            pixels: image.pixels[..(width * height) as usize].to_vec(),
        };
        let [a, b] = [crop(&exact(seed)), crop(&exact(!seed))];
        let _ = resemblance(&a, &b, BOUND, BACKGROUND);
        prop_assert_eq!(resemblance(&a, &a, 0.0, BACKGROUND), None);
    }
}
