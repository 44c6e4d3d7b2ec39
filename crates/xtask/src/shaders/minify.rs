//! WGSL made short for pages: no comments, no spaces, and one or two letters for each name that slangc made. Modules that are made short together share the
//! names of what both have, and names within a function follow its own order, so that what modules have in common is the same text and is compressed once.

use super::shorten::shorten;
use std::collections::{BTreeSet, HashMap};

const LETTERS: &[u8; 52] = b"abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
/// Words of two letters that WGSL keeps for itself.
const KEPT: [&str; 6] = ["as", "do", "fn", "if", "of", "on"];

/// The same modules with other names. slangc ends every name of its own in a number; entry points have those of their sources, so they stay.
pub fn minify(texts: &[String]) -> Vec<String> {
    let texts: Vec<String> = texts.iter().map(|text| shorten(text)).collect();
    let modules: Vec<Vec<Token>> = texts.iter().map(|text| kinds(tokens(text))).collect();
    let all = || modules.iter().flatten();
    // Keywords, and whatever else the modules say.
    let taken: BTreeSet<&str> = all().filter(|token| token.kind == Kind::Kept).map(|token| token.text).collect();
    let names_of = |kind: Kind, first: usize| {
        let mut counts: HashMap<&str, usize> = HashMap::new();
        for token in all().filter(|token| token.kind == kind) {
            *counts.entry(token.text).or_default() += 1;
        }
        let mut by_count: Vec<(&str, usize)> = counts.into_iter().collect();
        by_count.sort_by(|a, b| b.1.cmp(&a.1).then(a.0.cmp(b.0)));
        let free = names(first).filter(|name| !taken.contains(name.as_str()));
        by_count.into_iter().map(|(name, _)| name).zip(free).collect::<HashMap<&str, String>>()
    };
    // One letter is left for what functions have.
    let (globals, members) = (names_of(Kind::Global, LETTERS.len()), names_of(Kind::Member, 0));
    modules.iter().map(|module| write(module, &globals, &members, &taken)).collect()
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// It stays as it is.
    Kept,
    /// A name of the module.
    Global,
    /// A member of a struct.
    Member,
    /// A name within a function; the first one of each function says so.
    Local { is_first: bool },
}

#[derive(Clone, Copy)]
struct Token<'a> {
    text: &'a str,
    kind: Kind,
}

/// What each token is.
fn kinds(tokens: Vec<&str>) -> Vec<Token<'_>> {
    let before = |at: usize, by: usize| if at >= by { tokens[at - by] } else { "" };
    // Other functions have no attributes.
    let is_entry = |at: usize| before(at, 1) == "fn" && before(at, 2) == ")";
    let (mut depth, mut owner) = (0_usize, "");
    let mut globals = BTreeSet::new();
    for (at, &token) in tokens.iter().enumerate() {
        match token {
            "{" => depth += 1,
            "}" => depth = depth.saturating_sub(1),
            _ if depth == 0 && is_made_up(token) && !is_entry(at) => {
                let is_variable = before(at, 1) == ">" && tokens[at + 1] == ":";
                if is_variable || ["fn", "struct", "const", "override", "alias", "var"].contains(&before(at, 1)) {
                    globals.insert(token);
                }
            }
            _ => {}
        }
    }
    let mut is_first = false;
    let kind_of = |(at, &text): (usize, &&str)| {
        match text {
            "{" => depth += 1,
            "}" => depth = depth.saturating_sub(1),
            "fn" | "struct" if depth == 0 => (owner, is_first) = (tokens[at], true),
            _ => {}
        }
        let kind = match text {
            _ if !is_made_up(text) || is_entry(at) => Kind::Kept,
            _ if before(at, 1) == "." => Kind::Member,
            _ if owner == "struct" && depth == 1 && tokens[at + 1] == ":" => Kind::Member,
            _ if globals.contains(text) => Kind::Global,
            _ => Kind::Local { is_first: std::mem::take(&mut is_first) },
        };
        Token { text: tokens[at], kind }
    };
    tokens.iter().enumerate().map(kind_of).collect()
}

fn write(
    module: &[Token],
    globals: &HashMap<&str, String>,
    members: &HashMap<&str, String>,
    taken: &BTreeSet<&str>,
) -> String {
    let mut out = String::new();
    let mut locals: HashMap<&str, String> = HashMap::new();
    let mut free: Box<dyn Iterator<Item = String>> = Box::new(std::iter::empty());
    for (at, token) in module.iter().enumerate() {
        if let Kind::Local { is_first: true } = token.kind {
            locals.clear();
            // Those of the module that the function uses.
            let used: BTreeSet<&str> = module[at..]
                .iter()
                .take_while(|token| token.text != "fn")
                .filter(|token| token.kind == Kind::Global)
                .map(|token| globals[token.text].as_str())
                .collect();
            let used: BTreeSet<String> = used.into_iter().chain(taken.iter().copied()).map(str::to_owned).collect();
            free = Box::new(names(0).filter(move |name| !used.contains(name)));
        }
        let text = match token.kind {
            Kind::Kept => token.text,
            Kind::Global => &globals[token.text],
            Kind::Member => &members[token.text],
            Kind::Local { .. } => locals.entry(token.text).or_insert_with(|| free.next().unwrap_or_default()),
        };
        let joins = |letter: char| letter.is_ascii_alphanumeric() || letter == '_';
        if out.ends_with(joins) && text.starts_with(joins) {
            out.push(' ');
        }
        out.push_str(text);
    }
    out
}

/// Names from that of some number on: a, b, …, Z, aa, ….
fn names(first: usize) -> impl Iterator<Item = String> {
    let name_of = |number: usize| {
        let mut name = vec![LETTERS[number % 52]];
        let mut rest = number / 52;
        while rest > 0 {
            rest -= 1;
            name.push(LETTERS[rest % 52]);
            rest /= 52;
        }
        name.into_iter().map(char::from).collect::<String>()
    };
    (first..).map(name_of).filter(|name| !KEPT.contains(&name.as_str()))
}

fn is_made_up(token: &str) -> bool {
    let is_name = token.starts_with(|letter: char| letter.is_ascii_alphabetic() || letter == '_');
    let last = token.rsplit('_').next().unwrap_or_default();
    let last = last.strip_prefix('S').unwrap_or(last);
    is_name && token.contains('_') && !last.is_empty() && last.bytes().all(|byte| byte.is_ascii_digit())
}

/// Words and numbers whole, every other character by itself.
pub fn tokens(text: &str) -> Vec<&str> {
    let mut tokens = Vec::new();
    let mut rest = text.trim_start();
    while let Some(first) = rest.chars().next() {
        if rest.starts_with("//") {
            rest = rest.split_once('\n').map_or("", |(_, after)| after).trim_start();
            continue;
        }
        let is_number = first.is_ascii_digit();
        let mut before = first;
        let ends = |letter: char| {
            let is_sign = is_number && matches!(letter, '+' | '-') && matches!(before, 'e' | 'E');
            before = letter;
            !(letter.is_ascii_alphanumeric() || letter == '_' || is_sign || (is_number && letter == '.'))
        };
        let is_word = first.is_ascii_alphanumeric() || first == '_';
        let length = if is_word { rest.find(ends).unwrap_or(rest.len()) } else { first.len_utf8() };
        let (token, after) = rest.split_at(length);
        tokens.push(token);
        rest = after.trim_start();
    }
    tokens
}

#[cfg(test)]
mod tests {
    use super::*;

    const WALK: &str = "@compute @workgroup_size(64, 1, 1)\nfn walk_all(@builtin(global_invocation_id) id_0 : vec3<u32>)\n\
        {\n    var ray_7 : Ray_1;\n    var _S12 : f32 = 1.5e-07f - f32(words_0[id_0.x]) * ray_7.t_0;\n    if(words_0[0] == 0u) { return; }\n}\n";

    fn module(more: &str) -> String {
        format!(
            "// A comment.\n@group(0) @binding(3) var<storage, read> words_0 : array<u32>;\nstruct Ray_1\n{{\n    t_0 : f32,\n}};\n\
             @id(3) override TOP_0 : u32 = u32(0);\n{more}{WALK}"
        )
    }

    #[test]
    fn names_become_short_and_the_rest_stays() {
        let short = minify(&[module("").replace("walk_all", "level_0")]).remove(0);
        assert!(short.contains("fn level_0("), "an entry point's name may end in a number: {short}");
        let short = minify(&[module("")]).remove(0);
        assert!(short.contains("fn walk_all(@builtin(global_invocation_id)a:vec3u)"), "{short}");
        assert!(short.contains(":u32=0u;") && short.contains("==0u)"), "{short}");
        assert!(short.contains("=1.5e-07f-f32("), "{short}");
        for gone in ["words", "_S12", "comment", "\n", "ray_7", "t_0"] {
            assert!(!short.contains(gone), "{gone}: {short}");
        }
        assert!(short.contains("@id(3)override "), "{short}");
    }

    #[test]
    fn what_modules_share_is_the_same_text() {
        // Another function before it, with names of its own, and other numbers.
        let more = "fn other_3(a_0 : f32, b_5 : f32) -> f32\n{\n    return a_0 * b_5 + words_0[1];\n}\n";
        let both = minify(&[module(""), module(more).replace("_S12", "_S99").replace("ray_7", "ray_8")]);
        let walk = |text: &str| text[text.find("@compute").unwrap()..].to_owned();
        assert_eq!(walk(&both[0]), walk(&both[1]));
        assert!(both[1].contains("(a:f32,b:f32)->f32{return a*b+"), "{}", both[1]);
        assert_eq!(names(0).take(3000).collect::<BTreeSet<_>>().len(), 3000);
    }
}
