//! Tables of an animation's TOML: every fault is one line with the file, the line in it and the key.

use crate::failure::Failure;
use std::fmt::Display;
use std::ops::Range;
use std::path::Path;
use toml::Spanned;
use toml::de::{DeTable, DeValue};
use voxtrace::glam::DVec3;

/// The text that a table comes from.
#[derive(Clone, Copy)]
pub struct Text<'t> {
    pub path: &'t Path,
    pub text: &'t str,
}

impl<'t> Text<'t> {
    /// The whole file as a table.
    pub fn parse(self) -> Result<Spanned<DeTable<'t>>, Failure> {
        DeTable::parse(self.text).map_err(|error| {
            let at = error.span().map_or(0, |span| span.start);
            Failure::input(format!("{}: {}", self.place(at), error.message()))
        })
    }

    /// File and line of a byte.
    fn place(self, at: usize) -> String {
        let line = 1 + self.text.bytes().take(at).filter(|&byte| byte == b'\n').count();
        format!("{}:{line}", self.path.display())
    }
}

/// A table, or the whole file.
#[derive(Clone)]
pub struct Table<'t> {
    pub text: Text<'t>,
    table: &'t DeTable<'t>,
    /// What it is called, empty for the file.
    name: String,
    span: Range<usize>,
}

impl<'t> Table<'t> {
    pub fn new(text: Text<'t>, table: &'t Spanned<DeTable<'t>>) -> Self {
        Self { text, table: table.get_ref(), name: String::new(), span: 0..0 }
    }

    fn full_name(&self, key: &str) -> String {
        if self.name.is_empty() { key.to_owned() } else { format!("{}.{key}", self.name) }
    }

    /// The fault of the table as a whole.
    pub fn fault(&self, reason: impl Display) -> Failure {
        let name = if self.name.is_empty() { String::new() } else { format!("{}: ", self.name) };
        Failure::input(format!("{}: {name}{reason}", self.text.place(self.span.start)))
    }

    /// The fault of a key.
    pub fn fault_at(&self, key: &str, reason: impl Display) -> Failure {
        let found = self.table.iter().find(|(own, _)| own.get_ref() == key);
        let at = found.map_or(self.span.start, |(own, _)| own.span().start);
        Failure::input(format!("{}: {}: {reason}", self.text.place(at), self.full_name(key)))
    }

    /// Refuses keys that nothing reads.
    pub fn only(&self, known: &[&str]) -> Result<(), Failure> {
        match self.table.keys().find(|key| !known.contains(&key.get_ref().as_ref())) {
            Some(key) => {
                Err(self.fault_at(key.get_ref(), "nothing reads it").hint(format!("there are {}", known.join(", "))))
            }
            None => Ok(()),
        }
    }

    pub fn has(&self, key: &str) -> bool {
        self.table.contains_key(key)
    }

    fn value(&self, key: &str) -> Option<&'t Spanned<DeValue<'t>>> {
        self.table.iter().find(|(own, _)| own.get_ref() == key).map(|(_, value)| value)
    }

    fn read<R>(
        &self,
        key: &str,
        what: &str,
        read: impl Fn(&'t DeValue<'t>) -> Option<R>,
    ) -> Result<Option<R>, Failure> {
        let Some(value) = self.value(key) else { return Ok(None) };
        read(value.get_ref()).map(Some).ok_or_else(|| self.fault_at(key, format!("{what} is needed")))
    }

    pub fn number(&self, key: &str) -> Result<Option<f64>, Failure> {
        self.read(key, "a finite number", number_of)
    }

    /// A number above 0.
    pub fn positive(&self, key: &str) -> Result<Option<f64>, Failure> {
        self.read(key, "a number above 0", |value| number_of(value).filter(|&number| number > 0.0))
    }

    /// A whole number from 1 to a million.
    pub fn count(&self, key: &str) -> Result<Option<u32>, Failure> {
        let count = |value| {
            number_of(value)
                .filter(|&number| number.fract() == 0.0 && (1.0..=1e6).contains(&number))
                .map(|number| number as u32)
        };
        self.read(key, "a whole number from 1 to a million", count)
    }

    pub fn flag(&self, key: &str) -> Result<Option<bool>, Failure> {
        self.read(key, "true or false", DeValue::as_bool)
    }

    pub fn words(&self, key: &str) -> Result<Option<&'t str>, Failure> {
        self.read(key, "text in quotes", DeValue::as_str)
    }

    /// One of some words.
    pub fn choice<T: Copy>(&self, key: &str, choices: &[(&str, T)]) -> Result<Option<T>, Failure> {
        let Some(word) = self.words(key)? else { return Ok(None) };
        let found = choices.iter().find(|(own, _)| *own == word).map(|(_, value)| *value);
        let names = || choices.iter().map(|(name, _)| format!("{name:?}")).collect::<Vec<_>>().join(", ");
        found.map(Some).ok_or_else(|| self.fault_at(key, format!("one of {} is needed", names())))
    }

    pub fn vector(&self, key: &str) -> Result<Option<DVec3>, Failure> {
        self.read(key, "[x, y, z]", vector_of)
    }

    pub fn vectors(&self, key: &str) -> Result<Option<Vec<DVec3>>, Failure> {
        let vectors =
            |value: &'t DeValue<'t>| value.as_array()?.iter().map(|value| vector_of(value.get_ref())).collect();
        self.read(key, "a list of [x, y, z]", vectors)
    }

    pub fn texts(&self, key: &str) -> Result<Option<Vec<&'t str>>, Failure> {
        let texts = |value: &'t DeValue<'t>| value.as_array()?.iter().map(|value| value.get_ref().as_str()).collect();
        self.read(key, "a list of texts", texts)
    }

    /// Whether a key holds text.
    pub fn is_text(&self, key: &str) -> bool {
        self.value(key).is_some_and(|value| value.get_ref().is_str())
    }

    fn within(&self, name: String, value: &'t Spanned<DeValue<'t>>) -> Option<Self> {
        Some(Self { text: self.text, table: value.get_ref().as_table()?, name, span: value.span() })
    }

    pub fn table(&self, key: &str) -> Result<Option<Self>, Failure> {
        let Some(value) = self.value(key) else { return Ok(None) };
        let table = self.within(self.full_name(key), value);
        table.map(Some).ok_or_else(|| self.fault_at(key, "a table is needed"))
    }

    /// A list of tables; none where the key is not there.
    pub fn tables(&self, key: &str) -> Result<Vec<Self>, Failure> {
        let Some(value) = self.value(key) else { return Ok(Vec::new()) };
        let fault = || self.fault_at(key, "a list of tables is needed");
        let array = value.get_ref().as_array().ok_or_else(fault)?;
        let table = |(index, value)| self.within(format!("{}[{index}]", self.full_name(key)), value).ok_or_else(fault);
        array.iter().enumerate().map(table).collect()
    }

    /// The times of keys, `at`, which must rise.
    pub fn times(keys: &[Self]) -> Result<Vec<f64>, Failure> {
        let mut times: Vec<f64> = Vec::with_capacity(keys.len());
        for key in keys {
            let time = key.number("at")?.ok_or_else(|| key.fault("`at` is missing, the time in seconds"))?;
            if times.last().is_some_and(|&before| before >= time) {
                return Err(key.fault_at("at", "it is not after the key before"));
            }
            times.push(time);
        }
        Ok(times)
    }
}

fn number_of(value: &DeValue) -> Option<f64> {
    let number = match value {
        DeValue::Float(float) => float.as_str().parse().ok()?,
        DeValue::Integer(integer) if integer.radix() == 10 => integer.as_str().parse().ok()?,
        _ => return None,
    };
    // What is computed with it ends in 32 bits.
    (number as f32).is_finite().then_some(number)
}

fn vector_of(value: &DeValue) -> Option<DVec3> {
    let numbers: Vec<f64> = value.as_array()?.iter().map(|value| number_of(value.get_ref())).collect::<Option<_>>()?;
    <[f64; 3]>::try_from(numbers).ok().map(DVec3::from_array)
}
