//! WGSL made short for pages: no comments, no spaces, and one to three letters for each name that slangc made.

use std::collections::{BTreeSet, HashMap};

const LETTERS: &[u8; 52] = b"abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";

/// The same module with other names. slangc ends every name of its own in a number; entry points have none, so they stay.
pub fn minify(text: &str) -> String {
    let tokens = tokens(text);
    let mut counts: HashMap<&str, usize> = HashMap::new();
    for token in tokens.iter().filter(|token| is_made_up(token)) {
        *counts.entry(token).or_default() += 1;
    }
    let mut by_count: Vec<(&str, usize)> = counts.into_iter().collect();
    by_count.sort_by(|a, b| b.1.cmp(&a.1).then(a.0.cmp(b.0)));
    // Keywords of two and three letters, and whatever else the module says.
    let taken: BTreeSet<&str> = tokens.iter().filter(|token| !is_made_up(token)).copied().collect();
    let is_free = |name: &String| {
        !taken.contains(name.as_str()) && !["as", "do", "fn", "if", "of", "for", "let", "var"].contains(&name.as_str())
    };
    let mut free = (0..).map(name_of).filter(is_free);
    let names: HashMap<&str, String> =
        by_count.into_iter().filter_map(|(token, _)| Some((token, free.next()?))).collect();
    let mut out = String::with_capacity(text.len() / 2);
    for token in tokens {
        let token = names.get(token).map_or(token, String::as_str);
        let joins = |letter: char| letter.is_ascii_alphanumeric() || letter == '_';
        if out.ends_with(joins) && token.starts_with(joins) {
            out.push(' ');
        }
        out.push_str(token);
    }
    out
}

/// The name with a number: a, b, …, Z, aa, ….
fn name_of(number: usize) -> String {
    let mut name = vec![LETTERS[number % 52]];
    let mut rest = number / 52;
    while rest > 0 {
        rest -= 1;
        name.push(LETTERS[rest % 52]);
        rest /= 52;
    }
    name.into_iter().map(char::from).collect()
}

fn is_made_up(token: &str) -> bool {
    let number = token.trim_start_matches(|letter: char| !letter.is_ascii_digit() || letter == '_');
    let is_name = token.starts_with(|letter: char| letter.is_ascii_alphabetic() || letter == '_');
    let last = token.rsplit('_').next().unwrap_or_default();
    let last = last.strip_prefix('S').unwrap_or(last);
    is_name
        && !number.is_empty()
        && token.contains('_')
        && !last.is_empty()
        && last.bytes().all(|byte| byte.is_ascii_digit())
}

/// Words and numbers whole, every other character by itself.
fn tokens(text: &str) -> Vec<&str> {
    let mut tokens = Vec::new();
    let mut rest = text.trim_start();
    while let Some(first) = rest.chars().next() {
        let length = if rest.starts_with("//") {
            rest = rest.split_once('\n').map_or("", |(_, after)| after).trim_start();
            continue;
        } else if first.is_ascii_alphanumeric() || first == '_' {
            let is_number = first.is_ascii_digit();
            let mut before = first;
            let goes_on = |letter: char| {
                let is_sign = matches!(letter, '+' | '-') && matches!(before, 'e' | 'E') && is_number;
                before = letter;
                letter.is_ascii_alphanumeric() || letter == '_' || (is_number && (letter == '.' || is_sign))
            };
            rest.find({
                let mut goes_on = goes_on;
                move |letter| !goes_on(letter)
            })
            .unwrap_or(rest.len())
        } else {
            first.len_utf8()
        };
        let (token, after) = rest.split_at(length);
        tokens.push(token);
        rest = after.trim_start();
    }
    tokens
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_become_short_and_the_rest_stays() {
        let text = "// A comment.\n@group(0) @binding(3) var<storage, read> words_0 : array<u32>;\nstruct Ray_1\n{\n    t_0 : f32,\n};\n\
            @id(3) override TOP_0 : u32 = u32(0);\n@compute @workgroup_size(64, 1, 1)\nfn walk_all(@builtin(global_invocation_id) id_0 : vec3<u32>)\n\
            {\n    var _S12 : f32 = 1.5e-07f - f32(words_0[id_0.x]) * 0x1p3f;\n    if(words_0[0] == 0u) { return; }\n}\n";
        let short = minify(text);
        assert!(short.contains("fn walk_all(@builtin(global_invocation_id)"), "{short}");
        assert!(short.contains("1.5e-07f-f32("), "{short}");
        assert!(
            !short.contains("words") && !short.contains("_S12") && !short.contains("comment") && !short.contains('\n'),
            "{short}"
        );
        assert!(short.contains("vec3<u32>") && short.contains("@id(3)override "), "{short}");
        let names: BTreeSet<String> = (0..3000).map(name_of).collect();
        assert_eq!(names.len(), 3000);
    }
}
