//! An example's picture stands alone on a slide: it says what it shows.

use std::fs;

use crate::sources::root;

/// The only ones without a title, and the words with which they say why.
const BARE: [(&str, &str); 1] = [("01_first_light.rs", "The picture has no caption")];

#[test]
fn every_picture_of_an_example_has_a_title() {
    let mut pictures = 0;
    for entry in fs::read_dir(root().join("../examples")).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        if !name.ends_with(".rs") {
            continue;
        }
        let text = fs::read_to_string(&path).unwrap();
        if let Some((_, why)) = BARE.iter().find(|(bare, _)| *bare == name) {
            assert!(text.contains(why), "{name} does not say: {why}");
            continue;
        }
        pictures += usize::from(text.contains("example::output("));
        if let Some(wrong) = without_a_title(&text) {
            panic!("{name}: {wrong}");
        }
    }
    assert!(pictures >= 22, "{pictures}");
}

#[test]
fn a_picture_without_a_title_would_be_noticed() {
    let bare = "let path = example::output(\"a.png\")?;\nframe.image.save(&path)?;";
    assert!(without_a_title(bare).is_some());
    let titled = format!("use onionskin::report::Panels;\n{bare}");
    assert!(without_a_title(&titled).is_some());
    let titled = titled.replace("frame.image.save", "sheet.save");
    assert_eq!(without_a_title(&titled), None);
}

/// What is wrong with an example's source. The report's rooms put a title on what they draw.
fn without_a_title(text: &str) -> Option<&'static str> {
    if !text.contains("example::output(") {
        return None;
    }
    let packed: String = text.split_whitespace().collect();
    match packed.contains("image.save(") || packed.contains("difference_picture(") {
        true => Some("it saves a bare image"),
        false if !text.contains("use onionskin::report::") => {
            Some("it writes a picture and imports nothing that gives it a title")
        }
        false => None,
    }
}
