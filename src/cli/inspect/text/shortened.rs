//! Names that have to fit into a column.

/// A name in so many columns: its end, after a tilde, if it is longer.
pub(super) fn shortened(name: &str, columns: usize) -> String {
    let length = name.chars().count();
    if length <= columns {
        return name.to_owned();
    }
    let end: String = name.chars().skip(length - columns + 1).collect();
    format!("~{end}")
}
