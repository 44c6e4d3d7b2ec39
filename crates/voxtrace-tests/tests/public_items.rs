//! What users of the library see: the public items of its crates, read from their sources as rustfmt leaves them, are those of
//! `public_items.txt`. Items behind `#[doc(hidden)]` are for our own crates and not covered by semantic versioning: they do not count.
//! `VOXTRACE_BLESS=1` writes the file anew.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// The crates that a program needs by name: the library and what it does not re-export.
const CRATES: [&str; 3] = ["voxtrace", "voxtrace-bench", "voxtrace-vulkan"];
/// Parts of the tracers that must stay inside.
const INTERNALS: [&str; 9] =
    ["CELL_OCCUPIED", "SKIP_DISTANCES", "Faults", "nearest_centre", "pcg4d", "probe", "sampler", "selftest", "walk"];

/// The folder of the sources of one of our crates, by the name that code has for it.
fn sources(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(name.replace('_', "-")).join("src")
}

/// Splits at commas outside of braces.
fn split_list(list: &str) -> Vec<&str> {
    let (mut parts, mut depth, mut start) = (Vec::new(), 0, 0);
    for (at, character) in list.char_indices() {
        match character {
            '{' => depth += 1,
            '}' => depth -= 1,
            ',' if depth == 0 => {
                parts.push(&list[start..at]);
                start = at + 1;
            }
            _ => {}
        }
    }
    parts.push(&list[start..]);
    parts.into_iter().map(str::trim).filter(|part| !part.is_empty()).collect()
}

/// The paths that a `use` tree names, each with the name that it gets.
fn used(tree: &str) -> Vec<(String, String)> {
    if let Some((head, list)) = tree.split_once('{') {
        let parts = split_list(list.strip_suffix('}').unwrap()).into_iter().flat_map(used);
        return parts.map(|(path, name)| (format!("{head}{path}"), name)).collect();
    }
    let (path, name) = tree.split_once(" as ").unwrap_or((tree, tree.rsplit("::").next().unwrap()));
    vec![(path.to_owned(), name.to_owned())]
}

/// Statements of a module that begin with `pub`, each on one line, and whether `#[doc(hidden)]` stands before it. `indent` is that
/// of the module's items.
fn public_statements(text: &str, indent: &str) -> Vec<(String, bool)> {
    let (mut found, mut is_hidden) = (Vec::new(), false);
    let mut lines = text.lines();
    while let Some(line) = lines.next() {
        let Some(line) = line.strip_prefix(indent) else { continue };
        if line.starts_with("#[doc(hidden)]") {
            is_hidden = true;
        } else if line.starts_with("pub ") {
            let mut statement = line.to_owned();
            while statement.starts_with("pub use") && !statement.ends_with(';') {
                statement += lines.next().unwrap().trim();
            }
            found.push((statement, is_hidden));
            is_hidden = false;
        } else if !line.starts_with(['#', '/', ' ']) {
            is_hidden = false;
        }
    }
    found
}

/// The file of a module `path`, whose first part is a crate of ours; `None` where the path is that of an item.
fn module_file(path: &str) -> Option<PathBuf> {
    let mut parts = path.split("::");
    let folder = sources(parts.next()?);
    let place = parts.collect::<Vec<_>>().join("/");
    [format!("{place}.rs"), format!("{place}/mod.rs")]
        .into_iter()
        .map(|file| folder.join(file))
        .find(|file| file.exists())
}

/// Adds the public items of the module `path`, whose text is `text`, under the name `name` that users have for it.
fn collect(path: &str, name: &str, text: &str, items: &mut BTreeSet<String>) {
    for (statement, is_hidden) in public_statements(text, "") {
        let words: Vec<&str> =
            statement.split([' ', '(', '<', ':', ';', '{', '=']).filter(|word| !word.is_empty()).collect();
        match words[1] {
            _ if is_hidden => {}
            "use" => {
                let tree = statement.trim_start_matches("pub use ").trim_end_matches(';');
                for (target, item) in used(tree) {
                    collect_used(path, &target, &format!("{name}::{item}"), items);
                }
            }
            "mod" if statement.ends_with('{') => {
                let inner = text.split_once(statement.as_str()).unwrap().1.split("\n}").next().unwrap();
                let inner: Vec<&str> = inner.lines().map(|line| line.strip_prefix("    ").unwrap_or(line)).collect();
                collect(&format!("{path}::{}", words[2]), &format!("{name}::{}", words[2]), &inner.join("\n"), items);
            }
            "mod" => collect_module(&format!("{path}::{}", words[2]), &format!("{name}::{}", words[2]), items),
            // `pub const fn`, `pub unsafe fn`
            "const" | "unsafe" if words[2] == "fn" => _ = items.insert(format!("{name}::{}", words[3])),
            _ => _ = items.insert(format!("{name}::{}", words[2])),
        }
    }
}

fn collect_module(path: &str, name: &str, items: &mut BTreeSet<String>) {
    let file = module_file(path).unwrap_or_else(|| panic!("no file for {path}"));
    collect(path, name, &std::fs::read_to_string(file).unwrap(), items);
}

/// What `pub use target` in the module `path` gives: the items of a module of ours, or the one item.
fn collect_used(path: &str, target: &str, name: &str, items: &mut BTreeSet<String>) {
    let from_root = target.strip_prefix("crate").map(|rest| format!("{}{rest}", path.split("::").next().unwrap()));
    let target = from_root.unwrap_or_else(|| target.to_owned());
    if let Some(module) = target.strip_suffix("::*") {
        return collect_used(path, module, name.trim_end_matches("::*"), items);
    }
    let is_ours = target.starts_with("voxtrace_") || target == "voxtrace";
    let absolute = if is_ours { target } else { format!("{path}::{}", target.trim_start_matches("self::")) };
    if is_ours && !absolute.contains("::") {
        return collect(&absolute, name, &std::fs::read_to_string(sources(&absolute).join("lib.rs")).unwrap(), items);
    }
    match module_file(&absolute) {
        Some(_) => collect_module(&absolute, name, items),
        None => _ = items.insert(name.to_owned()),
    }
}

/// The public items of a crate whose root is `root`.
fn public_items(name: &str, root: &str) -> BTreeSet<String> {
    let mut items = BTreeSet::new();
    collect(name, name, root, &mut items);
    items
}

fn root_of(name: &str) -> String {
    std::fs::read_to_string(sources(name).join("lib.rs")).unwrap()
}

fn is_internal(item: &str) -> bool {
    item.split("::").any(|part| INTERNALS.contains(&part))
}

#[test]
fn the_public_items_are_those_that_were_agreed_on() {
    let crates = CRATES.map(|name| name.replace('-', "_"));
    let items: Vec<String> = crates.iter().flat_map(|name| public_items(name, &root_of(name))).collect();
    let list = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/public_items.txt");
    if std::env::var_os("VOXTRACE_BLESS").is_some() {
        std::fs::write(&list, items.join("\n") + "\n").unwrap();
    }
    let agreed = std::fs::read_to_string(&list).unwrap();
    let agreed: Vec<&str> = agreed.lines().collect();
    let added: Vec<&String> = items.iter().filter(|item| !agreed.contains(&item.as_str())).collect();
    let gone: Vec<&&str> = agreed.iter().filter(|item| !items.iter().any(|there| there == *item)).collect();
    assert!(added.is_empty() && gone.is_empty(), "new: {added:#?}, gone: {gone:#?}; see {}", list.display());
    assert!(items.iter().any(|item| item == "voxtrace::Renderer"), "{items:?}");
    let internal: Vec<&String> = items.iter().filter(|item| is_internal(item)).collect();
    assert!(internal.is_empty(), "{internal:?}");
}

#[test]
fn an_internal_part_that_becomes_public_is_noticed() {
    let root =
        root_of("voxtrace") + "pub use voxtrace_core::{\n    packed::{CELL_OCCUPIED, PackError as P}, walk,\n};\n";
    let added: Vec<String> =
        public_items("voxtrace", &root).difference(&public_items("voxtrace", &root_of("voxtrace"))).cloned().collect();
    assert!(added.contains(&"voxtrace::P".to_owned()), "{added:?}");
    assert!(added.contains(&"voxtrace::walk::cast".to_owned()), "{added:?}");
    assert!(added.iter().any(|item| is_internal(item)), "{added:?}");
    assert!(added.contains(&"voxtrace::CELL_OCCUPIED".to_owned()), "{added:?}");
    let hidden = "/// Inside.\n#[doc(hidden)]\npub fn a() {}\n/// Outside.\npub fn b() {}\npub mod c {\n    pub const fn d() {}\n}\n";
    assert_eq!(public_items("voxtrace", hidden), ["voxtrace::b", "voxtrace::c::d"].map(str::to_owned).into());
}
