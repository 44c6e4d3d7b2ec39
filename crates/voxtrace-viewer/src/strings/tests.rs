//! Tests of the texts: what the code asks for is there, nothing else is, and every language has the same places to fill in.

use super::*;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// Keys that the code asks for: the first words in quotes behind `tr!(`, and those of tables of keys (`key = "…"` in comments of ours none).
fn asked_for(code: &str) -> Vec<String> {
    let is_own =
        |&(at, _): &(usize, &str)| !code[..at].ends_with(|before: char| before.is_alphanumeric() || before == '_');
    let calls = ["tr!(", "text_key!("].into_iter().flat_map(|call| code.match_indices(call));
    let calls = calls.filter(is_own).map(|(at, call)| &code[at + call.len()..]);
    let calls = calls.filter_map(|rest| rest.trim_start().strip_prefix('"')?.split('"').next());
    calls.map(str::to_owned).collect()
}

/// All files of code below a folder, without the tests of texts.
pub fn files_of_code(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for file in std::fs::read_dir(folder).unwrap() {
        let path = file.unwrap().path();
        if path.is_dir() {
            files.extend(files_of_code(&path));
        } else if path.extension().is_some_and(|ending| ending == "rs") && !is_of_texts(&path) {
            files.push(path);
        }
    }
    files
}

fn is_of_texts(path: &Path) -> bool {
    ["strings/tests.rs", "strings/literals.rs"].iter().any(|name| path.ends_with(name))
}

fn placeholders(text: &str) -> BTreeSet<&str> {
    text.split('{').skip(1).filter_map(|rest| Some(rest.split_once('}')?.0)).collect()
}

/// What is wrong with a language, measured by English.
fn faults(english: &Texts, other: &Texts) -> Vec<String> {
    let unknown = other.keys().filter(|key| !english.contains_key(*key)).cloned();
    let different = english.iter().filter_map(|(key, text)| {
        let own = other.get(key)?;
        (placeholders(text) != placeholders(own)).then(|| format!("{key}: {own}"))
    });
    unknown.chain(different).collect()
}

#[test]
fn every_text_that_the_code_asks_for_is_written_and_every_text_is_asked_for() {
    let files = files_of_code(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"));
    let code: String = files.iter().map(|path| std::fs::read_to_string(path).unwrap()).collect();
    let asked: BTreeSet<String> = asked_for(&code).into_iter().filter(|key| !key.contains('…')).collect();
    let english = texts_of(include_str!("en.toml")).unwrap();
    let missing: Vec<_> = asked.iter().filter(|key| !english.contains_key(*key)).collect();
    assert!(missing.is_empty(), "not in en.toml: {missing:?}");
    let unused: Vec<_> = english.keys().filter(|key| *key != "language" && !asked.contains(*key)).collect();
    assert!(unused.is_empty(), "nobody asks for: {unused:?}");
    let found = asked_for("tr!(\"a.b\") include_str!(\"file\") tr!(\n \"c\", x = 1)");
    assert_eq!(found, ["a.b", "c"], "the search sees a call over two lines, and no other macro");
}

#[test]
fn every_language_has_the_places_of_english_and_no_keys_of_its_own() {
    let english = texts_of(include_str!("en.toml")).unwrap();
    for (name, file) in FILES {
        let texts = texts_of(file).unwrap_or_else(|fault| panic!("{name}: {fault}"));
        assert_eq!(faults(&english, &texts), Vec::<String>::new(), "{name}");
        assert!(texts.contains_key("language"), "{name} says what it calls itself");
    }
    let of = |file: &str| texts_of(file).unwrap();
    // German is whole; of a language that is begun, English stands in for the rest.
    let german = of(FILES.iter().find(|(name, _)| *name == "de").unwrap().1);
    let missing: Vec<_> = english.keys().filter(|key| !german.contains_key(*key)).collect();
    assert!(missing.is_empty(), "not in de.toml: {missing:?}");
    let (one, other) = (of("a = \"{n} of {m}\""), of("a = \"{n}\"\nb = \"more\""));
    assert_eq!(faults(&one, &other).len(), 2, "the comparison sees a place that is gone and a key of its own");
    assert!(texts_of("a = 3").is_err());
}

#[test]
fn places_are_filled_in_once() {
    let text = filled("measure.counting", &[("voxels", &"{voxels}")]);
    assert!(text.contains("{voxels}"), "{text}");
    assert_eq!(super::text("nobody.wrote.this"), "nobody.wrote.this");
    assert!(speak("en_GB.UTF-8") && !speak("tlh") && spoken() == ENGLISH);
}
