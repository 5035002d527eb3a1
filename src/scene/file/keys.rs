//! Reading a table of a scene file, with types. Unknown keys are errors.
//!
//! The parser's tree is read by hand instead of being deserialised by derived code. Only in this way can an error say
//! which values are allowed, which keys are known at this place, and which of them was probably meant.

use std::ops::{Range, RangeInclusive};

use toml::Spanned;
use toml::de::DeTable;

use super::limits::Limits;
use super::place::Document;
use super::value::Value;
use crate::error::{Error, Place, Result, nearest};
use crate::words::Words;

/// A table and its name.
pub(super) struct Keys<'a> {
    pub(super) document: Document<'a>,
    /// The name as a person writes it, such as `[camera]`. It is empty for the file's top.
    name: &'a str,
    table: &'a DeTable<'a>,
    span: Range<usize>,
}

/// A value that is a number, or the one word that is allowed in its place.
pub(super) enum NumberOrWord {
    Number(f64),
    Word,
}

const THREE: &str = "three numbers, as in [0.5, 0.5, 0.5]";

impl<'a> Keys<'a> {
    /// The table at the file's top.
    pub(super) fn top(document: Document<'a>, table: &'a Spanned<DeTable<'a>>) -> Self {
        Self {
            document,
            name: "",
            table: table.get_ref(),
            span: 0..0,
        }
    }

    /// Returns an error if the table has a key that is not among these.
    pub(super) fn expect_only(&self, known: &[&str]) -> Result<()> {
        // The table is in alphabetical order, but the message shows the first unknown key of the file.
        let keys = self.table.keys();
        let unknown = keys.filter(|key| !known.contains(&key.get_ref().as_ref()));
        let Some(key) = unknown.min_by_key(|key| key.span().start) else {
            return Ok(());
        };
        let (word, list) = (key.get_ref().as_ref(), known.join(", "));
        let place = match self.name {
            "" => "at the top of a scene file".to_owned(),
            name => format!("in {name}"),
        };
        let remedy = match nearest(word, known) {
            Some(meant) => format!("Did you mean '{meant}'? The keys known {place} are: {list}."),
            None => format!("The keys known {place} are: {list}."),
        };
        let what = format!("the key '{word}' is not known {place}");
        Err(Error::input(self.document.place(key.span()), what, remedy))
    }

    /// Whether the key's value is a list.
    pub(super) fn is_list(&self, key: &'a str) -> bool {
        self.value(key).is_some_and(|value| value.get().is_array())
    }

    /// The place of the key's value, or of the table if the key is missing.
    pub(super) fn place(&self, key: &str) -> Place {
        let span = self.table.get(key).map(Spanned::span);
        self.document.place(span.unwrap_or(self.span.clone()))
    }

    /// A number within limits.
    pub(super) fn number(&self, key: &'a str, limits: &Limits) -> Result<Option<f64>> {
        self.read(key, |value| value.number(limits))
    }

    /// A number within limits, or the one word that is allowed in its place.
    pub(super) fn number_or_word(
        &self,
        key: &'a str,
        limits: &Limits,
        word: &str,
    ) -> Result<Option<NumberOrWord>> {
        self.read(key, |value| match value.get().as_str() {
            Some(text) if text == word => Ok(NumberOrWord::Word),
            Some(_) => Err(value.mistyped(&format!("\"{word}\" or {}", limits.words))),
            None => value.number(limits).map(NumberOrWord::Number),
        })
    }

    /// The same in 32 bits.
    pub(super) fn number32(&self, key: &'a str, limits: &Limits) -> Result<Option<f32>> {
        self.read(key, |value| value.number32(limits))
    }

    /// Three numbers within limits.
    pub(super) fn vector(&self, key: &'a str, limits: &Limits) -> Result<Option<[f64; 3]>> {
        self.read(key, |value| value.numbers(limits, THREE))
    }

    /// The same in 32 bits.
    pub(super) fn vector32(&self, key: &'a str, limits: &Limits) -> Result<Option<[f32; 3]>> {
        Ok(self.vector(key, limits)?.map(|v| v.map(|x| x as f32)))
    }

    /// Two numbers within limits, as 32 bits.
    pub(super) fn pair32(&self, key: &'a str, limits: &Limits) -> Result<Option<[f32; 2]>> {
        let wanted = "two numbers, as in [0.5, 1.0]";
        self.read(key, |value| {
            value.exactly(wanted, |item| item.number32(limits))
        })
    }

    /// Any number of numbers, as 32 bits.
    pub(super) fn numbers32(&self, key: &'a str, limits: &Limits) -> Result<Option<Vec<f32>>> {
        let wanted = "a list of numbers, as in [0.0, 0.5]";
        self.read(key, |value| {
            let items = value.items(wanted)?;
            items.map(|item| item.number32(limits)).collect()
        })
    }

    /// Any number of vectors, as 32 bits.
    pub(super) fn vectors32(&self, key: &'a str, limits: &Limits) -> Result<Option<Vec<[f32; 3]>>> {
        let wanted = "a list of colours, as in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]";
        self.read(key, |value| {
            let items = value.items(wanted)?;
            let vectors = items.map(|item| item.exactly(wanted, |x| x.number32(limits)));
            vectors.collect()
        })
    }

    /// Any number of four numbers, as 32 bits.
    pub(super) fn fours32(&self, key: &'a str, limits: &Limits) -> Result<Option<Vec<[f32; 4]>>> {
        let wanted =
            "a list of four numbers each, as in [[0.0, 0.0, 0.0, 1.0], [1.0, 0.0, 0.0, -1.0]]";
        self.read(key, |value| {
            let items = value.items(wanted)?;
            let fours = items.map(|item| item.exactly(wanted, |x| x.number32(limits)));
            fours.collect()
        })
    }

    /// A whole number within a range.
    pub(super) fn integer(&self, key: &'a str, range: &RangeInclusive<u64>) -> Result<Option<u64>> {
        self.read(key, |value| value.integer(range))
    }

    /// A whole number of 32 bits.
    pub(super) fn integer32(&self, key: &'a str) -> Result<Option<u32>> {
        let number = self.integer(key, &(0..=u64::from(u32::MAX)))?;
        Ok(number.map(|number| u32::try_from(number).expect("the range was checked")))
    }

    /// Two whole numbers within a range.
    pub(super) fn integers(
        &self,
        key: &'a str,
        range: &RangeInclusive<u64>,
    ) -> Result<Option<[u64; 2]>> {
        let wanted = "two whole numbers, as in [1024, 768]";
        self.read(key, |value| {
            value.exactly(wanted, |item| item.integer(range))
        })
    }

    /// True or false.
    pub(super) fn flag(&self, key: &'a str) -> Result<Option<bool>> {
        self.read(key, |value| {
            let flag = value.get().as_bool();
            flag.ok_or_else(|| value.mistyped("true or false"))
        })
    }

    /// Some text.
    pub(super) fn text(&self, key: &'a str) -> Result<Option<&'a str>> {
        self.read(key, |value| {
            let text = value.get().as_str();
            text.ok_or_else(|| value.mistyped("text in quotes"))
        })
    }

    /// Any number of texts.
    pub(super) fn texts(&self, key: &'a str) -> Result<Option<Vec<&'a str>>> {
        let wanted = "a list of texts, as in [\"one\", \"two\"]";
        self.read(key, |value| {
            let text = |item: Value<'a>| item.get().as_str().ok_or_else(|| item.mistyped(wanted));
            value.items(wanted)?.map(text).collect()
        })
    }

    /// A word of a type.
    pub(super) fn word<T: Words>(&self, key: &'a str) -> Result<Option<T>> {
        let words = T::WORDS.iter().map(|(word, _)| *word);
        let choices: Vec<_> = words.zip(T::VALUES.iter().copied()).collect();
        self.choice(key, &choices)
    }

    /// One of several words, as the value that it stands for.
    pub(super) fn choice<T: Copy>(&self, key: &'a str, choices: &[(&str, T)]) -> Result<Option<T>> {
        let Some(text) = self.text(key)? else {
            return Ok(None);
        };
        if let Some((_, choice)) = choices.iter().find(|(word, _)| *word == text) {
            return Ok(Some(*choice));
        }
        let words: Vec<&str> = choices.iter().map(|(word, _)| *word).collect();
        let list = words.join(", ");
        let remedy = match nearest(text, &words) {
            Some(meant) => format!("Did you mean \"{meant}\"? Known are: {list}."),
            None => format!("Known are: {list}."),
        };
        let what = format!("`{key}` cannot be \"{text}\"");
        Err(self.wrong(key, what, remedy))
    }

    /// A table within this one, and its name.
    pub(super) fn table(&self, key: &'a str, name: &'a str) -> Result<Option<Self>> {
        self.read(key, |value| self.inner(value, name, "a table"))
    }

    /// The tables of an array of tables, and the name of each.
    pub(super) fn tables(&self, key: &'a str, name: &'a str) -> Result<Vec<Self>> {
        let wanted = format!("tables, each under a line {name}");
        let tables = self.read(key, |value| {
            let items = value.items(&wanted)?;
            items.map(|item| self.inner(item, name, &wanted)).collect()
        });
        Ok(tables?.unwrap_or_default())
    }

    /// The error for this key's value, or for the table if the key is missing.
    pub(super) fn wrong(
        &self,
        key: &str,
        what: impl Into<String>,
        remedy: impl Into<String>,
    ) -> Error {
        Error::input(self.place(key), what, remedy)
    }

    fn inner(&self, value: Value<'a>, name: &'a str, wanted: &str) -> Result<Self> {
        let table = value.get().as_table();
        Ok(Self {
            document: self.document,
            name,
            table: table.ok_or_else(|| value.mistyped(wanted))?,
            span: value.value.span(),
        })
    }

    fn read<T>(
        &self,
        key: &'a str,
        read: impl FnOnce(Value<'a>) -> Result<T>,
    ) -> Result<Option<T>> {
        self.value(key).map(read).transpose()
    }

    fn value(&self, key: &'a str) -> Option<Value<'a>> {
        Some(Value {
            document: self.document,
            key,
            value: self.table.get(key)?,
        })
    }
}
