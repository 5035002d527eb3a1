//! `onionskin check`: what it passes and what it finds.

use crate::kit::cli::Desk;
use crate::kit::sheets::{desk, object};
use onionskin::Image;

/// A desk with `mine.png`: the exact image of the sheets as `render` writes it, changed.
fn desk_with_image(change: impl FnOnce(&mut Image)) -> Desk {
    let desk = desk();
    desk.result(&["render", "sheets.toml", "-m", "exact", "-o", "mine.png"]);
    let mut image = Image::load(desk.path("mine.png")).unwrap();
    change(&mut image);
    image.save(desk.path("mine.png")).unwrap();
    desk
}

const CHECK: [&str; 3] = ["check", "sheets.toml", "mine.png"];

#[test]
fn check_passes_the_exact_image_in_8_bits() {
    let desk = desk_with_image(|_| {});
    let out = desk.result(&CHECK);
    assert!(out.contains("exact within the bound"), "{out}");
    assert!(out.contains("0 of 1200"), "{out}");
}

#[test]
fn check_passes_the_exact_image_in_32_bits_with_no_bound_at_all() {
    let desk = desk();
    desk.result(&["render", "sheets.toml", "-m", "exact", "-o", "mine.exr"]);
    desk.result(&["check", "sheets.toml", "mine.exr", "--bound", "0"]);
}

#[test]
fn check_finds_one_changed_pixel_and_shows_it_in_the_third_panel() {
    let desk = desk_with_image(|image| image.pixels[7 * 40 + 5].g -= 0.5);
    let answer = desk.run(&CHECK);
    assert_eq!((answer.code, answer.err.as_str()), (1, ""), "{answer}");
    assert!(answer.out.contains("differs"), "{answer}");
    assert!(answer.out.contains("1 of 1200"), "{answer}");
    assert!(answer.out.contains("5, 7 (from the top left)"), "{answer}");
    // A difference of 0.5, and up to half a step of rounding, times 8 is more than 1: the pixel is yellow, the end of the
    // scale. It is enlarged eight times, so that the panel is 320 pixels wide. No other pixel is, and no picture's.
    let picture = Image::load(desk.path("difference.png")).unwrap();
    assert!(picture.width > 3 * 320 && picture.height > 240 + 60);
    let yellow = |&pixel: &u32| {
        let [r, g, b, _] = picture.pixel(pixel, row_of_the_panel(&picture)).to_array();
        [r, g, b].map(|c| (c * 255.0).round() as u8) == [254, 232, 37]
    };
    assert_eq!((0..picture.width).filter(yellow).count(), 8);

    desk.run(&[&CHECK[..], &["-o", "difference.exr"]].concat());
    let picture = Image::load(desk.path("difference.exr")).unwrap();
    // Three panels with two gaps of four pixels.
    assert_eq!([picture.width, picture.height], [3 * 40 + 2 * 4, 30]);
    assert_eq!(picture.pixel(2 * 44 + 5, 7).g, 1.0);
    // Half a step times 8 is under four steps.
    assert!(picture.pixel(2 * 44 + 6, 7).g <= 4.0 / 255.0);
}

/// The row of the sheet that has the changed pixel's middle: below the frame's first row, which is dark in all three
/// panels.
fn row_of_the_panel(picture: &Image) -> u32 {
    let dark = |row: &u32| {
        let pixels = (0..picture.width).map(|column| picture.pixel(column, *row));
        pixels.filter(|pixel| pixel.r < 0.6).count() >= 3 * 320
    };
    (0..picture.height).find(dark).unwrap() + 1 + 7 * 8 + 4
}

#[test]
fn check_as_json_prints_one_object_with_its_verdict() {
    let desk = desk_with_image(|image| image.pixels[7 * 40 + 5].g -= 0.5);
    let answer = desk.run(&[&CHECK[..], &["--json"]].concat());
    assert_eq!(answer.code, 1, "{answer}");
    let object = object(&answer);
    assert_eq!(object["scene"], "sheets");
    assert_eq!(object["image"], "mine.png");
    assert_eq!(object["passed"], false);
    assert_eq!(object["pixels_over"], 1);
    assert_eq!(object["pixels"], 1200);
    assert_eq!(object["worst_pixel"], serde_json::json!([5, 7]));
    // Rounded to 8 bits twice: a step in all.
    let error = object["max_error"].as_f64().unwrap();
    assert!((error - 0.5).abs() <= 1.0 / 255.0, "{answer}");
}

#[test]
fn check_takes_one_step_of_8_bits_for_rounding_and_two_for_a_difference() {
    let step = |steps: f32| {
        // The exact image is 1 in all the background, so the difference is the change alone.
        let desk = desk_with_image(|image| image.pixels[0].r -= steps / 255.0);
        desk.run(&CHECK).code
    };
    assert_eq!([step(1.0), step(2.0)], [0, 1]);
}

#[test]
fn check_holds_an_image_to_a_tighter_bound() {
    let desk = desk_with_image(|image| image.pixels[0].r -= 1.0 / 255.0);
    let answer = desk.run(&[&CHECK[..], &["--bound", "0.003"]].concat());
    assert_eq!(answer.code, 1, "{answer}");
    assert!(answer.out.contains("0, 0 (from the top left)"), "{answer}");
}

#[test]
fn check_writes_the_difference_picture_where_it_is_asked_to() {
    let desk = desk_with_image(|_| {});
    desk.result(&[&CHECK[..], &["-o", "d.exr"]].concat());
    assert_eq!(Image::load(desk.path("d.exr")).unwrap().width, 128);
    assert!(!desk.names().contains(&"difference.png".to_owned()));
}

#[test]
fn check_finds_blending_in_the_wrong_order() {
    let desk = desk();
    desk.result(&["render", "sheets.toml", "-m", "blend", "-o", "mine.png"]);
    assert_eq!(desk.run(&CHECK).code, 1);
}

#[test]
fn check_takes_the_advice_that_it_gave_about_the_size() {
    let desk = desk();
    let render = ["render", "sheets.toml", "-m", "exact", "-o", "mine.png"];
    desk.result(&[&render[..], &["--size", "20x15"]].concat());
    let refused = desk.refused(&CHECK);
    let advice = refused.err.split("add ").nth(1).unwrap().trim_end();
    let advice: Vec<_> = advice.split(' ').collect();
    desk.result(&[&CHECK[..], &advice].concat());
}

/// What `check` says a difference looks like, in words and as JSON.
#[track_caller]
fn looks_like(desk: &Desk, words: &str) {
    let answer = desk.run(&CHECK);
    assert_eq!((answer.code, answer.err.as_str()), (1, ""), "{answer}");
    let line = answer.out.lines().find(|l| l.starts_with("looks like"));
    assert!(line.is_some_and(|line| line.contains(words)), "{answer}");
    let answer = desk.run(&[&CHECK[..], &["--json"]].concat());
    let said = object(&answer)["looks_like"].clone();
    let said = said.as_str().unwrap_or_default();
    assert!(said.contains(words), "{answer}");
}

#[test]
fn check_recognises_an_image_that_is_encoded_as_srgb() {
    let desk = desk();
    desk.result(&[
        "render",
        "sheets.toml",
        "-m",
        "exact",
        "-o",
        "mine.png",
        "--srgb",
    ]);
    looks_like(&desk, "encoded as sRGB");
}

#[test]
fn check_recognises_flips_shifts_channels_and_alpha() {
    let flipped = desk_with_image(|image| {
        let rows: Vec<_> = image.pixels.chunks(40).rev().flatten().copied().collect();
        image.pixels = rows;
    });
    looks_like(&flipped, "upside down");
    let shifted = desk_with_image(|image| image.pixels.rotate_right(2 * 40 + 3));
    looks_like(
        &shifted,
        "shifted by 3 pixels to the right and 2 pixels down",
    );
    let swapped = desk_with_image(|image| {
        let swap = |pixel: &mut onionskin::Rgba| std::mem::swap(&mut pixel.r, &mut pixel.b);
        image.pixels.iter_mut().for_each(swap);
    });
    looks_like(&swapped, "BGR instead of RGB");
    let clear = desk_with_image(|image| image.pixels.iter_mut().for_each(|pixel| pixel.a = 0.5));
    looks_like(&clear, "Only alpha differs");
}

#[test]
fn check_says_nothing_of_a_difference_that_looks_like_no_mistake() {
    let desk = desk_with_image(|image| image.pixels[7 * 40 + 5].g -= 0.5);
    let answer = desk.run(&[&CHECK[..], &["--json"]].concat());
    assert_eq!(
        object(&answer)["looks_like"],
        serde_json::Value::Null,
        "{answer}"
    );
    assert!(!desk.run(&CHECK).out.contains("looks like"));
}

#[test]
fn check_gives_its_verdict_where_no_picture_can_be_written() {
    let desk = desk_with_image(|image| image.pixels[0].g -= 0.5);
    std::fs::create_dir(desk.path("difference.png")).unwrap();
    let answer = desk.run(&CHECK);
    assert_eq!(answer.code, 1, "{answer}");
    assert!(answer.out.contains("1 of 1200"), "{answer}");
    answer.says(&["note: no difference picture", "a folder of that name", "-o"]);
    // Told where to write, it must be able to.
    desk.refused(&[&CHECK[..], &["-o", "difference.png"]].concat());
}

#[test]
#[cfg(unix)]
fn results_go_through_links_and_pipes_stay_pipes() {
    let desk = desk();
    std::os::unix::fs::symlink("target.png", desk.path("link.png")).unwrap();
    for size in ["20x15", "30x20"] {
        desk.result(&["render", "sheets.toml", "-o", "link.png", "--size", size]);
        assert!(desk.path("link.png").is_symlink());
        let [width, height] = Image::size_of_file(desk.path("target.png")).unwrap();
        assert_eq!(format!("{width}x{height}"), size);
    }
    let hidden = desk.names().into_iter().find(|name| name.starts_with('.'));
    assert_eq!(hidden, None);
}
