//! Figures of the edition, made and looked through.

use onionskin::Context;
use onionskin::low_level::edition::figures::{Drawn, Studio, Table, every};

/// The quick edition's figure of this key. Everything in it can be read without seeing it, and its tables are whole.
pub fn quick_figure(context: &Context, key: &str) -> Drawn {
    let studio = Studio::new(context, true).unwrap();
    let figure = every().find(|figure| figure.key == key).expect(key);
    let drawn = (figure.make)(&studio).unwrap();
    assert!(!drawn.caption.is_empty(), "{key}");
    for picture in &drawn.pictures {
        let texts = [&picture.name, &picture.label, &picture.alt];
        assert!(
            texts.iter().all(|text| !text.is_empty()),
            "{key}: {texts:?}"
        );
    }
    for (svg, alt) in &drawn.drawings {
        roxmltree::Document::parse(svg).unwrap_or_else(|error| panic!("{key}: {error}"));
        assert!(!alt.is_empty(), "{key}");
    }
    for table in &drawn.tables {
        let columns = table.columns.len();
        assert!(
            table.rows.iter().all(|row| row.len() == columns),
            "{key}: {table:?}"
        );
    }
    drawn
}

/// The cells of a row, by the row's head.
#[track_caller]
pub fn row<'t>(table: &'t Table, head: &str) -> &'t [String] {
    let row = table.rows.iter().find(|row| row[0] == head);
    &row.unwrap_or_else(|| panic!("no row '{head}' in {:?}", table.rows))[1..]
}

/// The numbers in a cell, such as 6 and 36 of "6 it, 36 g".
pub fn numbers(cell: &str) -> Vec<f64> {
    let is_part = |c: char| c.is_ascii_digit() || ".-e".contains(c);
    let words = cell.split(|c: char| !is_part(c));
    words.filter_map(|word| word.parse().ok()).collect()
}

#[test]
fn a_cell_s_numbers_are_read() {
    assert_eq!(numbers("6 it, 36 g"), [6.0, 36.0]);
    assert_eq!(numbers("1.2e-7"), [1.2e-7]);
    assert_eq!(numbers("42221 of 59048"), [42221.0, 59048.0]);
    assert!(numbers("it cannot tell").is_empty());
}
