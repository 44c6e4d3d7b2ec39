//! What the window says, in one place: a table of texts by key for each language, the files beside this one. A key that a language lacks is
//! said in English. A text may have places `{name}` that are filled in.

#[cfg(test)]
mod literals;
#[cfg(test)]
mod tests;

use std::collections::HashMap;
use std::sync::LazyLock;
use std::sync::atomic::{AtomicUsize, Ordering};
use toml::{Table, Value};

/// The file of each language by its name, `en` for example.
static FILES: &[(&str, &str)] = include!(concat!(env!("OUT_DIR"), "/languages.rs"));

/// What is spoken where nothing else was chosen.
pub const ENGLISH: &str = "en";

/// Texts by key.
type Texts = HashMap<String, String>;

static LANGUAGES: LazyLock<Vec<(&'static str, Texts)>> =
    LazyLock::new(|| FILES.iter().map(|(name, file)| (*name, texts_of(file).unwrap_or_default())).collect());

/// Index of the language that is spoken.
static SPOKEN: LazyLock<AtomicUsize> = LazyLock::new(|| AtomicUsize::new(index_of(ENGLISH).unwrap_or(0)));

/// A text by its key; with `name = value`, with its places filled in.
#[macro_export]
macro_rules! tr {
    ($key:literal) => {
        $crate::strings::text($key)
    };
    ($key:literal, $($name:ident = $value:expr),+ $(,)?) => {
        $crate::strings::filled($key, &[$((stringify!($name), &$value as &dyn std::fmt::Display)),+])
    };
}

/// The key of a text that is asked for elsewhere: in tables that are constants.
#[macro_export]
macro_rules! text_key {
    ($key:literal) => {
        $key
    };
}

fn index_of(language: &str) -> Option<usize> {
    FILES.iter().position(|(name, _)| *name == language)
}

/// The languages that there are, each with its own name for itself.
pub fn languages() -> impl Iterator<Item = (&'static str, &'static str)> {
    LANGUAGES.iter().map(|(name, texts)| (*name, texts.get("language").map_or(*name, String::as_str)))
}

/// Speaks a language from now on, `de` or `de_CH.UTF-8` for example. One that there is no file of leaves what is spoken. Returns whether
/// there is one.
pub fn speak(language: &str) -> bool {
    let short = language.split(['_', '-', '.', '@']).next().unwrap_or_default();
    let found = index_of(language).or_else(|| index_of(short));
    if let Some(index) = found {
        SPOKEN.store(index, Ordering::Relaxed);
    }
    found.is_some()
}

/// The language that is spoken.
pub fn spoken() -> &'static str {
    FILES.get(SPOKEN.load(Ordering::Relaxed)).map_or(ENGLISH, |(name, _)| name)
}

/// The text of a key; of one that nobody wrote, the key.
pub fn text(key: &'static str) -> &'static str {
    let of = |index: usize| LANGUAGES.get(index).and_then(|(_, texts)| texts.get(key));
    of(SPOKEN.load(Ordering::Relaxed)).or_else(|| of(index_of(ENGLISH)?)).map_or(key, String::as_str)
}

/// The text of a key with its places filled in.
pub fn filled(key: &'static str, values: &[(&str, &dyn std::fmt::Display)]) -> String {
    let mut rest = text(key);
    let mut filled = String::new();
    // What is filled in is not looked through for places.
    while let Some((before, (name, after))) =
        rest.split_once('{').and_then(|(before, after)| Some((before, after.split_once('}')?)))
    {
        filled.push_str(before);
        match values.iter().find(|(own, _)| *own == name) {
            Some((_, value)) => filled.push_str(&value.to_string()),
            None => filled.push_str(name),
        }
        rest = after;
    }
    filled + rest
}

/// The texts of a file, by keys with dots between the names of tables.
fn texts_of(file: &str) -> Result<Texts, String> {
    let table: Table = file.parse().map_err(|error: toml::de::Error| error.message().to_owned())?;
    let mut texts = Texts::new();
    gather(&table, "", &mut texts)?;
    Ok(texts)
}

fn gather(table: &Table, before: &str, texts: &mut Texts) -> Result<(), String> {
    for (name, value) in table {
        let key = if before.is_empty() { name.clone() } else { format!("{before}.{name}") };
        match value {
            Value::String(text) => _ = texts.insert(key, text.clone()),
            Value::Table(table) => gather(table, &key, texts)?,
            _ => return Err(format!("{key} is no text")),
        }
    }
    Ok(())
}
