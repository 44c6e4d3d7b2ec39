//! No text that people see stands in the code: texts are in the tables, so that every language can have them. The test reads the code for literals that look
//! like texts: in the panels all with a word, elsewhere those of two words or more.

use super::tests::files_of_code;
use std::path::Path;

/// Files without texts for the window, and whose words their literals are.
const NOT_SHOWN: &[&str] = &[
    // What is wrong inside of files that the window keeps, in the words of their keys.
    "bookmarks.rs",
    "camera_toml.rs",
    "kept_file.rs",
    "measuring/file.rs",
    "timeline/file.rs",
    // Names in CSV files, which the panel translates.
    "measuring/component.rs",
    "measuring/csv.rs",
    "measuring/values.rs",
    // The terminal's: times, and errors of Vulkan.
    "app/graphics.rs",
    "app/stopwatch.rs",
    "engine/side.rs",
    "engine/worker/loss.rs",
    "frame_bench/mod.rs",
    "frame_bench/moving.rs",
    "frame_bench/window.rs",
    "gpu/mod.rs",
    "gpu/painter.rs",
    "gpu/pipeline.rs",
    "gpu/presenter.rs",
    "gpu/screen.rs",
    "gpu/swapchain.rs",
    "gpu/target.rs",
    "gpu/timestamps.rs",
    "gpu/window_system.rs",
    "phases.rs",
    "strings/mod.rs",
    // Names of keys, which are the same everywhere.
    "keys/chord.rs",
];

/// Words that are the same in every language: units, names, and words of commands.
const WORDS: &[&str] = &["ms", "MiB", "MB", "G/s", "vx", "min", "Δx", "Δy", "Δz", "voxtrace"];

/// What stands before a literal that nobody sees: keys of texts, invariants, the terminal, names by which panels know their parts.
const BEFORE: &[&str] = &[
    "tr!(",
    "text_key!(",
    "expect(",
    "println!(",
    "assert!(",
    "id_salt(",
    "Grid::new(",
    "Grid::new((",
    "Panel::right(",
    "Panel::bottom(",
    "Id::new(",
    "Order::Background,",
    "Area::new(",
    ".with(",
    ".with((",
    "table(ui,",
    "memory,",
    "lap(",
    "Self::System =>",
    "Self::Dark =>",
    "Self::Light =>",
];

/// Texts that are no text of the window, each with the reason.
const OTHERS: &[&str] = &[
    // A command of another program, which is copied.
    "ffmpeg -framerate {rate} -i {pattern}{pad} -c:v libx264 -crf 16 -pix_fmt yuv420p {}",
    " -vf 'pad=ceil(iw/2)*2:ceil(ih/2)*2'",
    // What the program's own commands say.
    " a pixel in ",
    // Of a loader that has no commands: none of the window's.
    "this window runs no commands: {}",
    "Motion of {:?}",
];

/// The literals of code, each with what stands before it and behind it. Comments are none; raw strings and those of attributes are left out.
fn literals(code: &str) -> Vec<(&str, &str, &str)> {
    let bytes = code.as_bytes();
    let (mut at, mut found) = (0, Vec::new());
    while at < bytes.len() {
        match bytes[at] {
            b'/' if bytes.get(at + 1) == Some(&b'/') => at += code[at..].find('\n').unwrap_or(code.len() - at),
            // A character; lifetimes have no second quote so near.
            b'\'' if bytes.get(at + 1) == Some(&b'\\') => at += 2 + code[at + 2..].find('\'').unwrap_or(0).max(1),
            b'\'' => {
                let character = code[at + 1..].chars().next().map_or(1, char::len_utf8);
                at += if bytes.get(at + 1 + character) == Some(&b'\'') { character + 2 } else { 1 };
            }
            b'"' => {
                let mut end = at + 1;
                while bytes[end] != b'"' {
                    end += if bytes[end] == b'\\' { 2 } else { 1 };
                }
                found.push((&code[..at], &code[at + 1..end], &code[end + 1..]));
                at = end + 1;
            }
            _ => at += 1,
        }
    }
    found
}

/// A text without the places that are filled in.
fn without_places(text: &str) -> String {
    let mut parts = text.split('{');
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |text, part| text + part.split_once('}').map_or("", |(_, after)| after))
}

/// Whether a literal looks like a text for people.
fn is_text(literal: &str, in_panels: bool) -> bool {
    let text = without_places(literal);
    let is_word =
        |word: &&str| word.chars().filter(|letter| letter.is_alphabetic()).count() > 1 && !WORDS.contains(word);
    let words = text.split(' ').filter(is_word).count();
    words > usize::from(!in_panels)
}

/// Texts in code, outside of its tests.
fn texts_in(code: &str, in_panels: bool) -> Vec<String> {
    let code = code.split("\nmod tests {").next().unwrap_or_default();
    let is_seen = |&(before, literal, after): &(&str, &str, &str)| {
        let line = before.rsplit('\n').next().unwrap_or_default().trim_start();
        let before = before.trim_end();
        let is_name = after.starts_with(", |ui|") || after.trim_start().starts_with("=>");
        let is_word_of_a_file = before.ends_with("write!(f,") || line.starts_with("const ");
        let is_attribute = line.starts_with("#[") || line.starts_with("#![");
        let is_known = BEFORE.iter().any(|call| before.ends_with(call)) || OTHERS.contains(&literal);
        let is_none = is_attribute || is_name || is_word_of_a_file || is_known;
        !is_none && is_text(literal, in_panels)
    };
    literals(code).into_iter().filter(is_seen).map(|(_, literal, _)| literal.to_owned()).collect()
}

#[test]
fn no_text_that_people_see_stands_in_the_code() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut found = Vec::new();
    for path in files_of_code(&source) {
        let name = path.strip_prefix(&source).unwrap().to_string_lossy().replace('\\', "/");
        if name.contains("tests") || NOT_SHOWN.contains(&name.as_str()) {
            continue;
        }
        let code = std::fs::read_to_string(&path).unwrap();
        found.extend(texts_in(&code, name.starts_with("panels")).into_iter().map(|text| format!("{name}: {text:?}")));
    }
    assert!(found.is_empty(), "these belong into strings/en.toml and strings/de.toml:\n{}", found.join("\n"));
}

#[test]
fn the_search_sees_texts_and_nothing_else() {
    let code = r#"
        // "a comment is none"
        ui.button("Save"); ui.label(format!("{} of {n} voxels", 3)); ui.label(tr!("said.nothing"));
        let quote = '"'; session.say("two words", false); CollapsingHeader::new(title).id_salt("parts");
        map.get("key"); format!("{:.1} MiB", 3.0); x.expect("it was checked above");
    "#;
    assert_eq!(texts_in(code, true), ["Save", "{} of {n} voxels", "two words", "key"]);
    assert_eq!(texts_in(code, false), ["{} of {n} voxels", "two words"], "outside of panels a word may be a key");
}
