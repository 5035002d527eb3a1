use roxmltree::Document;

use super::*;
use crate::report::canvas::{line_height, width_of};

const RED: Rgba = Rgba::opaque([1.0, 0.0, 0.0]);
const BLUE: Rgba = Rgba::opaque([0.0, 0.0, 1.0]);

/// Five panels in rows of three: of two sizes, two of them measures, one caption long.
fn sheet() -> Panels {
    let (large, small) = (Image::filled(400, 300, RED), Image::filled(40, 20, BLUE));
    Panels::new(
        "What a sheet is: a long title for a picture that needs one, so long that it has two lines, because it says \
         everything that could ever be said about all of it",
    )
    .columns(3)
    .picture(&large, "large")
    .picture(
        &small,
        "a small picture, enlarged, with a caption that is far too long for one line",
    )
    .difference(&large, &Image::filled(400, 300, BLUE), "difference")
    .unwrap()
    .measure(Measure::of_counts(2, 1, &[0, 3]), "two pixels")
    .picture(&large, "last")
    .key(RED, "red & <large>")
    .key(BLUE, "blue")
}

fn svg_and_png(sheet: &Panels) -> (String, Image) {
    match sheet.draw().unwrap() {
        [Plot::Svg(text), Plot::Png(image)] => (text, image),
        other => panic!("{other:?}"),
    }
}

#[test]
fn nothing_overlaps_and_everything_is_on_the_sheet() {
    let sheet = sheet();
    let layout = sheet.layout();
    let mut boxes = Vec::new();
    for (panel, place) in sheet.panels.iter().zip(&layout.places) {
        boxes.push([place.left, place.top, place.width, place.height]);
        for (number, line) in (0..).zip(&place.caption) {
            let width = width_of(line, layout.text);
            let top = place.caption_top + number * line_height(layout.text);
            let middle = place.left + place.width / 2;
            boxes.push([middle - width / 2, top, width, line_height(layout.text)]);
        }
        if panel.measure.is_some() {
            let height = crate::report::scale::bar_height(layout.text);
            boxes.push([place.left, place.bar_top, place.width, height]);
        }
    }
    let (key_left, key_top) = layout.key;
    boxes.push([key_left, key_top, 100, line_height(layout.text)]);
    let title = layout.title.len() as u32 * line_height(layout.title_text);
    boxes.push([layout.margin, layout.margin, 100, title]);
    assert_eq!((layout.title.len(), boxes.len()), (2, 5 + 6 + 2 + 2));
    for (n, a) in boxes.iter().enumerate() {
        assert!(
            a[0] + a[2] <= layout.size.0 && a[1] + a[3] <= layout.size.1,
            "{a:?}"
        );
        for b in &boxes[..n] {
            let apart =
                |axis: usize| a[axis] + a[axis + 2] <= b[axis] || b[axis] + b[axis + 2] <= a[axis];
            assert!(apart(0) || apart(1), "{a:?} {b:?}");
        }
    }
}

#[test]
fn a_panel_has_the_pictures_own_pixels() {
    let mut image = Image::filled(4, 2, RED);
    image.pixels[5] = Rgba::opaque([0.3, 0.123_456, 0.9]);
    image.pixels[6] = Rgba::new(0.0, 0.0, 0.0, 0.25);
    let sheet = Panels::new("title").picture(&image, "caption");
    let place = &sheet.layout().places[0];
    assert_eq!([place.zoom, place.width, place.height], [80, 320, 160]);
    let (_, picture) = svg_and_png(&sheet);
    assert_eq!((picture.width, picture.height), sheet.layout().size);
    for (x, y) in (0..4).flat_map(|x| (0..2).map(move |y| (x, y))) {
        for (dx, dy) in [(0, 0), (79, 79), (40, 3)] {
            let there = picture.pixel(place.left + 80 * x + dx, place.top + 80 * y + dy);
            // The one that is not opaque is over white.
            let own = match (x, y) {
                (2, 1) => Rgba::opaque([0.75; 3]),
                _ => image.pixel(x, y),
            };
            assert_eq!(there, own, "{x}, {y}");
        }
    }
}

#[test]
fn the_svg_is_well_formed_and_has_every_text_and_picture() {
    let (text, _) = svg_and_png(&sheet());
    let document = Document::parse(&text).unwrap_or_else(|error| panic!("{error}: {text}"));
    let images: Vec<_> = document
        .descendants()
        .filter(|n| n.has_tag_name("image"))
        .collect();
    assert_eq!(images.len(), 5);
    for image in images {
        let data = image.attribute("href").unwrap();
        let bytes = STANDARD
            .decode(data.strip_prefix("data:image/png;base64,").unwrap())
            .unwrap();
        let own = image::load_from_memory(&bytes).unwrap();
        assert!([400, 40, 2].contains(&own.width()));
    }
    let words: Vec<_> = document
        .descendants()
        .filter(|n| n.has_tag_name("text"))
        .flat_map(|n| n.text().unwrap_or("").split_whitespace())
        .collect();
    let all = words.join(" ");
    for expected in [
        "What a sheet is: a long title",
        "a small picture, enlarged,",
        "difference",
        "two pixels",
        "red & <large>",
        // The measures' ticks.
        "0 0.2 0.4 0.6 0.8 1",
        "0 1 2 3",
    ] {
        assert!(all.contains(expected), "no {expected}: {all}");
    }
}

#[test]
fn text_is_beside_the_pictures_in_pixels_too() {
    let (_, picture) = svg_and_png(&sheet());
    let layout = sheet().layout();
    let dark = |top: u32, height: u32| {
        let row = picture.width as usize;
        let rows = &picture.pixels[top as usize * row..(top + height) as usize * row];
        rows.iter()
            .filter(|p| p.r < 0.5 && p.g < 0.5 && p.b < 0.5)
            .count()
    };
    assert!(dark(layout.margin, line_height(layout.title_text)) > 300);
    assert!(dark(layout.places[0].caption_top, line_height(layout.text)) > 100);
}

#[test]
fn a_sheet_of_extreme_pictures_can_be_drawn() {
    for (width, height) in [(1, 2000), (2000, 1), (1, 1)] {
        let image = Image::filled(width, height, RED);
        let (_, picture) = svg_and_png(&Panels::new("").picture(&image, ""));
        assert!(picture.width < 2200 && picture.height < 2200);
    }
    svg_and_png(&Panels::new("nothing"));
}
