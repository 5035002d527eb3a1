//! Arguments that are words of a type of the library.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use onionskin::low_level::words::Words;

/// Takes the words of these values, with their meanings in the help.
pub(super) fn one_of<T>(offered: &[T]) -> impl TypedValueParser<Value = T> + use<T>
where
    T: Words + Send + Sync,
{
    let all = T::WORDS.iter().zip(T::VALUES);
    let offered = all.filter(|(_, value)| offered.contains(value));
    PossibleValuesParser::new(possible(offered.map(|(word, _)| word))).map(|word| {
        let place = T::WORDS.iter().position(|(known, _)| *known == word);
        T::VALUES[place.expect("one of the words")]
    })
}

/// Words with their meanings, for the help.
pub(super) fn possible<'w>(
    words: impl Iterator<Item = &'w (&'static str, &'static str)>,
) -> Vec<PossibleValue> {
    let value = |&(word, meaning): &_| PossibleValue::new(word).help(meaning);
    words.map(value).collect()
}
