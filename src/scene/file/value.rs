//! One value of a scene file, read as the type that its key needs.

use std::ops::RangeInclusive;

use toml::Spanned;
use toml::de::DeValue;

use super::limits::Limits;
use super::place::Document;
use crate::error::{Error, Place, Result};

/// A value, or one item of a list, and the key that it belongs to.
#[derive(Clone, Copy)]
pub(super) struct Value<'a> {
    pub(super) document: Document<'a>,
    pub(super) key: &'a str,
    pub(super) value: &'a Spanned<DeValue<'a>>,
}

impl<'a> Value<'a> {
    /// The value's place.
    pub(super) fn place(&self) -> Place {
        self.document.place(self.value.span())
    }

    /// The value as the parser has it.
    pub(super) fn get(&self) -> &'a DeValue<'a> {
        self.value.get_ref()
    }

    /// A number within limits.
    pub(super) fn number(&self, limits: &Limits) -> Result<f64> {
        let number = number_of(self.get()).ok_or_else(|| self.mistyped(limits.words))?;
        if limits.hold(number) {
            return Ok(number);
        }
        Err(self.out_of_range(limits.words))
    }

    /// The same in 32 bits.
    pub(super) fn number32(&self, limits: &Limits) -> Result<f32> {
        Ok(self.number(limits)? as f32)
    }

    /// A whole number within a range.
    pub(super) fn integer(&self, range: &RangeInclusive<u64>) -> Result<u64> {
        let (low, high) = (range.start(), range.end());
        let words = format!("a whole number from {low} to {high}");
        let DeValue::Integer(integer) = self.get() else {
            return Err(self.mistyped(&words));
        };
        match u64::from_str_radix(integer.as_str(), integer.radix()) {
            Ok(number) if range.contains(&number) => Ok(number),
            _ => Err(self.out_of_range(&words)),
        }
    }

    /// A list of exactly `N` numbers.
    pub(super) fn numbers<const N: usize>(
        &self,
        limits: &Limits,
        wanted: &str,
    ) -> Result<[f64; N]> {
        self.exactly(wanted, |item| item.number(limits))
    }

    /// A list of exactly `N` items, each read by a function.
    pub(super) fn exactly<T, const N: usize>(
        &self,
        wanted: &str,
        read: impl Fn(Self) -> Result<T>,
    ) -> Result<[T; N]> {
        let items: Vec<T> = self.items(wanted)?.map(read).collect::<Result<_>>()?;
        <[T; N]>::try_from(items).map_err(|_| self.mistyped(wanted))
    }

    /// The items of a list.
    pub(super) fn items(&self, wanted: &str) -> Result<impl Iterator<Item = Self>> {
        let array = self.get().as_array();
        let array = array.ok_or_else(|| self.mistyped(wanted))?;
        let Self { document, key, .. } = *self;
        Ok(array.iter().map(move |value| Self {
            document,
            key,
            value,
        }))
    }

    /// The error for a value of the wrong type.
    pub(super) fn mistyped(&self, wanted: &str) -> Error {
        let found = match self.get() {
            DeValue::String(_) => "text",
            DeValue::Integer(_) | DeValue::Float(_) => "a number",
            DeValue::Boolean(_) => "true or false",
            DeValue::Datetime(_) => "a date",
            DeValue::Array(items) => &format!("a list of {}", items.len()),
            DeValue::Table(_) => "a table",
        };
        Error::input(
            self.place(),
            format!("`{}` is {found} here", self.key),
            format!("This must be {wanted}."),
        )
    }

    fn out_of_range(&self, words: &str) -> Error {
        Error::input(
            self.place(),
            format!("`{}` is out of range", self.key),
            format!("This must be {words}."),
        )
    }
}

/// The value as a number. A whole number counts as one. So do infinities and NaN, which are out of every range.
fn number_of(value: &DeValue) -> Option<f64> {
    match value {
        DeValue::Float(float) => float.as_str().parse().ok(),
        DeValue::Integer(integer) if integer.radix() == 10 => integer.as_str().parse().ok(),
        DeValue::Integer(integer) => u64::from_str_radix(integer.as_str(), integer.radix())
            .ok()
            .map(|number| number as f64),
        _ => None,
    }
}
