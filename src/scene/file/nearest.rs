//! Which of the known words was probably meant.

/// The known word that takes the fewest changed, added or left out letters; `None` if it takes more than a third of
/// the letters, because then it is another word.
pub(super) fn nearest<'a>(word: &str, known: &[&'a str]) -> Option<&'a str> {
    let near = known.iter().map(|&other| (distance(word, other), other));
    let (changes, other) = near.min_by_key(|(changes, _)| *changes)?;
    (changes <= other.len().div_ceil(3)).then_some(other)
}

/// The edit distance after Levenshtein, one row of its table at a time.
fn distance(from: &str, to: &str) -> usize {
    // A key that long has nothing to do with ours, and the table would be large.
    if from.len() > 64 {
        return usize::MAX;
    }
    let to: Vec<char> = to.chars().collect();
    let mut row: Vec<usize> = (0..=to.len()).collect();
    for (i, letter) in from.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, other) in to.iter().enumerate() {
            let changed = diagonal + usize::from(letter != *other);
            diagonal = row[j + 1];
            row[j + 1] = changed.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[to.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_distance_counts_changes_additions_and_omissions() {
        assert_eq!(distance("kitten", "sitting"), 3);
        assert_eq!(distance("", "abc"), 3);
        assert_eq!(distance("same", "same"), 0);
    }

    #[test]
    fn a_misspelt_word_is_recognised_and_another_word_is_not() {
        assert_eq!(nearest("colour", &["color", "opacity"]), Some("color"));
        assert_eq!(nearest("wibble", &["color", "opacity"]), None);
    }
}
