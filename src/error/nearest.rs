//! Guessing the word or the path that was probably meant.

use std::path::{Path, PathBuf};

/// The longest word that is compared. A longer one cannot be a misspelt known word, and would take long.
const LONGEST: usize = 64;

/// The known word that is reached by the fewest changed, added, left out or swapped letters, in any case. `None` if
/// that takes more than a third of the letters, because then it is another word.
pub fn nearest<'a>(word: &str, known: &[&'a str]) -> Option<&'a str> {
    if word.len() > LONGEST {
        return None;
    }
    let word = word.to_lowercase();
    let near = known.iter().filter(|other| other.len() <= LONGEST);
    let near = near.map(|&other| (strsim::osa_distance(&word, &other.to_lowercase()), other));
    let (changes, other) = near.min_by_key(|(changes, _)| *changes)?;
    (changes <= other.len().div_ceil(3)).then_some(other)
}

/// The remedy for an unknown word: the known word that was probably meant, if there is one, and all known words.
pub fn did_you_mean(word: &str, known: &[impl AsRef<str>]) -> String {
    let known: Vec<_> = known.iter().map(AsRef::as_ref).collect();
    let all = known.join(", ");
    match nearest(word, &known) {
        Some(meant) => format!("Did you mean '{meant}'? Known are: {all}."),
        None => format!("Known are: {all}."),
    }
}

/// The remedy for a path that does not exist but does with its backslashes turned into slashes. On Windows `\\`
/// separates folders; elsewhere it is a letter of a name.
pub fn with_slashes(path: &Path) -> Option<String> {
    let meant = PathBuf::from(path.to_str()?.replace('\\', "/"));
    let is_meant = meant != path && meant.exists() && !path.exists();
    let meant = meant.display();
    is_meant.then(|| format!("Did you mean '{meant}'? Folders are separated by '/' here."))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_misspelt_word_is_recognised_and_another_word_is_not() {
        let known = ["color", "opacity", "depth-peeling"];
        assert_eq!(nearest("colour", &known), Some("color"));
        assert_eq!(nearest("Depth-Peeling", &known), Some("depth-peeling"));
        assert_eq!(nearest("depthpeeling", &known), Some("depth-peeling"));
        assert_eq!(nearest("opactiy", &known), Some("opacity"));
        assert_eq!(nearest("wibble", &known), None);
    }

    #[test]
    fn words_of_any_length_and_none_are_answered() {
        assert_eq!(nearest("", &["color"]), None);
        assert_eq!(nearest("color", &[]), None);
        assert_eq!(nearest(&"c".repeat(1 << 20), &["color"]), None);
        assert_eq!(nearest("ß", &["ss", "s"]), Some("s"));
    }
}
