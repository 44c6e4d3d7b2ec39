//! What the pages of the project name is there: paths, links, verbs, options and the files of the map.

use super::common::Folder;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// Commands of others whose options are not ours.
const FOREIGN: [&str; 8] = ["cargo", "rustup", "nvidia-smi", "git", "apt-get", "pip", "slangc", "python3"];
/// Options of other programs, and of scripts, that the pages put beside ours.
const OF_OTHERS: [&str; 10] = [
    "--i",
    "--o",
    "--heightmap",
    "--color-limit",
    "--disable-quantization",
    "--grid-size",
    "--scale",
    "--chunk-size",
    "--raw",
    "--verify",
];
/// Folders at the root of the repository: a code span that begins with one is a path.
const ROOTS: [&str; 7] = ["crates", "docs", "shaders", "fuzz", "xtask", ".ci", ".github"];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize().unwrap()
}

/// README, ARCHITECTURE, CONTRIBUTING and everything below `docs`, save reports that programs wrote.
fn pages() -> BTreeMap<PathBuf, String> {
    let mut open = vec![root().join("docs")];
    let mut files: Vec<PathBuf> = ["README.md", "ARCHITECTURE.md", "CONTRIBUTING.md"].map(|p| root().join(p)).into();
    while let Some(folder) = open.pop() {
        for entry in std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
            match entry.is_dir() {
                true if !entry.ends_with("results") => open.push(entry),
                false if entry.extension().is_some_and(|extension| extension == "md") => files.push(entry),
                _ => {}
            }
        }
    }
    files.into_iter().map(|file| (file.clone(), std::fs::read_to_string(file).unwrap())).collect()
}

/// The code of a page: each span between backticks, and each line of a block, comments left out.
fn code(page: &str) -> Vec<String> {
    let (mut found, mut in_block) = (Vec::new(), false);
    let mut prose = String::new();
    for line in page.lines() {
        if line.trim_start().starts_with("```") {
            in_block = !in_block;
        } else if in_block {
            found.push(line.split(" #").next().unwrap_or("").trim().to_owned());
        } else {
            prose += line;
            prose.push(' ');
        }
    }
    found.extend(prose.split('`').skip(1).step_by(2).map(str::to_owned));
    found
}

/// Targets of the links and pictures of a page.
fn links(page: &str) -> impl Iterator<Item = &str> {
    let targets = page.split("](").skip(1).filter_map(|rest| rest.split(')').next());
    targets.filter(|target| !target.contains("://")).map(|target| target.split('#').next().unwrap_or(""))
}

/// Paths in a page that are not there. Links lie beside the page, paths in code at the root or, for short, in `src`.
fn missing_paths(file: &Path, page: &str) -> Vec<String> {
    let folder = file.parent().unwrap();
    let links = links(page).filter(|link| !link.is_empty() && !folder.join(link).exists()).map(str::to_owned);
    let mut missing: Vec<String> = links.collect();
    for span in code(page) {
        for word in span.split([' ', ',', ';', '(', ')', '"']) {
            let word = word.trim_end_matches(['.', ':']);
            let begins = ROOTS.iter().any(|root| word.strip_prefix(root).is_some_and(|rest| rest.starts_with('/')));
            // `…`, `*` and braces stand for several.
            let is_path = begins && !word.contains(['…', '*', '{', '<']);
            if is_path && !root().join(word).exists() && !folder.join(word).exists() {
                missing.push(word.to_owned());
            }
        }
    }
    missing
}

/// What `--help` of the program and of each verb names.
struct Help {
    verbs: BTreeMap<String, BTreeSet<String>>,
}

impl Help {
    fn read() -> Self {
        let folder = Folder::new();
        let help = folder.succeed(&["--help"]);
        let list = help.split_once("Commands:").unwrap().1.split("\n\n").next().unwrap();
        let verbs =
            list.lines().filter_map(|line| line.strip_prefix("  ")?.split(' ').next()).filter(|v| !v.is_empty());
        let options = |verb: &str| {
            let help = folder.succeed(&[verb, "--help"]);
            let words = help.split(|c: char| !(c.is_ascii_alphanumeric() || c == '-'));
            words.filter(|word| word.starts_with("--")).map(str::to_owned).collect::<BTreeSet<_>>()
        };
        Self { verbs: verbs.filter(|verb| *verb != "help").map(|verb| (verb.to_owned(), options(verb))).collect() }
    }

    /// Commands of ours in a line of code with a verb or an option that is not there.
    fn faults(&self, line: &str) -> Vec<String> {
        let words: Vec<&str> = line.split([' ', '[', ']', '(', ')', ',', ';', '=', '|']).collect();
        let is_foreign = FOREIGN.iter().any(|name| words[0].ends_with(name));
        // `cargo run … -- render …` runs ours.
        let start = match words.iter().position(|word| *word == "--") {
            Some(at) if !is_foreign || words[1] == "run" => at + 1,
            _ if is_foreign || line.starts_with("VOXTRACE_") => return Vec::new(),
            _ => 0,
        };
        let ours = &words[start..];
        let verb = match ours.iter().position(|word| *word == "voxtrace") {
            Some(at) => ours.get(at + 1).filter(|verb| verb.chars().all(|c| c.is_ascii_lowercase())),
            None => ours.first().filter(|word| self.verbs.contains_key(**word)),
        };
        let mut faults = Vec::new();
        if let Some(verb) = verb.filter(|verb| !verb.is_empty() && **verb != "help" && !self.verbs.contains_key(**verb))
        {
            faults.push(format!("verb {verb}"));
        }
        for option in ours.iter().filter(|word| word.starts_with("--") && word.len() > 2) {
            let known = match verb.and_then(|verb| self.verbs.get(*verb)) {
                Some(options) => options.contains(*option),
                None => self.verbs.values().any(|options| options.contains(*option)),
            };
            // Variables of the element in style sheets are no options.
            if !known && *option != "--version" && !option.starts_with("--voxtrace-") && !OF_OTHERS.contains(option) {
                faults.push(format!("{} {option}", verb.unwrap_or(&"")));
            }
        }
        faults
    }
}

/// Stems of the files and names of the folders below those that the map is about.
fn names_of_files() -> BTreeSet<String> {
    let mut names = BTreeSet::from(["crates".to_owned()]);
    let mut open: Vec<PathBuf> =
        ["crates", "shaders", "fuzz", "docs", "python", "web"].map(|folder| root().join(folder)).into();
    while let Some(folder) = open.pop() {
        for entry in std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
            names.insert(entry.file_stem().unwrap().to_string_lossy().into_owned());
            if entry.is_dir() && !["corpus", "target", "node_modules", "dist"].iter().any(|name| entry.ends_with(name))
            {
                open.push(entry);
            }
        }
    }
    names
}

/// Files and folders that the tables of the map name and that are nowhere.
fn missing_files(map: &str, names: &BTreeSet<String>) -> Vec<String> {
    let rows = map.lines().filter(|line| line.starts_with("| ") && !line.starts_with("|---"));
    let places = rows.filter_map(|row| row.trim_end_matches(" |").rsplit(" | ").next());
    let spans = places.flat_map(|place| place.split('`').skip(1).step_by(2));
    let parts = spans.flat_map(|span| span.trim_end_matches('/').split('/'));
    let is_name =
        |part: &&str| !part.is_empty() && part.chars().all(|c| c.is_ascii_lowercase() || "_0123456789-".contains(c));
    parts.filter(is_name).filter(|part| !names.contains(*part)).map(str::to_owned).collect()
}

/// Examples and benchmarks that commands of a page name and no crate has.
fn missing_targets(page: &str) -> Vec<String> {
    let crates = || std::fs::read_dir(root().join("crates")).unwrap().map(|entry| entry.unwrap().path());
    let mut missing = Vec::new();
    for line in code(page).iter().filter(|line| line.contains("cargo ")) {
        let words: Vec<&str> = line.split_whitespace().collect();
        for pair in words.windows(2) {
            let folder = match pair[0] {
                "--example" => "examples",
                "--bench" => "benches",
                _ => continue,
            };
            let is_one = |path: PathBuf| path.with_extension("rs").exists() || path.join("main.rs").exists();
            if !crates().any(|own| is_one(own.join(folder).join(pair[1]))) {
                missing.push(pair.join(" "));
            }
        }
    }
    missing
}

#[test]
fn every_example_and_benchmark_in_the_pages_is_there() {
    for (file, page) in pages() {
        assert_eq!(missing_targets(&page), Vec::<String>::new(), "{}", file.display());
    }
    let planted =
        missing_targets("`cargo run -p a --example none` or `cargo bench --bench rays`, `cargo bench --bench no`");
    assert_eq!(planted, ["--example none", "--bench no"]);
}

#[test]
fn every_path_and_link_in_the_pages_is_there() {
    let missing: Vec<_> = pages().iter().map(|(file, page)| (file.clone(), missing_paths(file, page))).collect();
    let missing: Vec<_> = missing.into_iter().filter(|(_, missing)| !missing.is_empty()).collect();
    assert!(missing.is_empty(), "{missing:#?}");
    let planted = missing_paths(&root().join("README.md"), "see [it](docs/none.md) and `crates/none/src`");
    assert_eq!(planted, ["docs/none.md", "crates/none/src"]);
}

#[test]
fn every_verb_and_option_in_the_pages_is_one_of_the_program() {
    let help = Help::read();
    assert!(help.verbs.len() > 8 && help.verbs["render"].contains("--spp"), "{:?}", help.verbs.keys());
    let mut faults = Vec::new();
    for (file, page) in pages() {
        // The options of the benchmark of rays, which is no verb, stand in its source.
        let is_benchmark = file.ends_with("docs/benchmarks.md");
        for line in code(&page).iter().filter(|_| !is_benchmark) {
            faults.extend(help.faults(line).into_iter().map(|fault| format!("{}: {fault} in {line}", file.display())));
        }
    }
    assert!(faults.is_empty(), "{faults:#?}");
    assert_eq!(help.faults("voxtrace rendre a.vox"), ["verb rendre"]);
    assert_eq!(help.faults("cargo run --release -- info a.vox --spp 4"), ["info --spp"]);
    assert_eq!(help.faults("voxtrace render a.vox --nonesuch"), ["render --nonesuch"]);
}

#[test]
fn every_file_that_the_map_names_is_there() {
    let (map, names) = (std::fs::read_to_string(root().join("ARCHITECTURE.md")).unwrap(), names_of_files());
    assert_eq!(missing_files(&map, &names), Vec::<String>::new());
    assert_eq!(missing_files("| light | `light/`, `gone_for_good` |", &names), ["gone_for_good"]);
}
