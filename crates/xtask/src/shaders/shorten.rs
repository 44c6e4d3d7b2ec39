//! WGSL in fewer characters: literals and types of vectors in their short forms, no types where values tell them, and no brackets that change nothing.

use super::minify::tokens;

/// The same text, a space after each token.
pub fn shorten(text: &str) -> String {
    let short = with_short_literals(text);
    let without_types = without_types(&tokens(&short));
    without_brackets(without_types).iter().flat_map(|token| [token, " "]).collect()
}

/// The shorter ones of the ways in which WGSL writes literals and types of vectors: `0u` for `u32(0)`, `vec3f` for `vec3<f32>`.
fn with_short_literals(text: &str) -> String {
    let tokens = tokens(text);
    let is_number = |token: &str| token.bytes().all(|byte| byte.is_ascii_digit());
    let (mut out, mut at) = (String::with_capacity(text.len()), 0);
    while at < tokens.len() {
        let (short, length) = match tokens[at..] {
            [kind @ ("u32" | "i32"), "(", number, ")", ..] if is_number(number) => {
                (format!("{number}{}", &kind[..1]), 4)
            }
            [vector @ ("vec2" | "vec3" | "vec4"), "<", scalar @ ("f32" | "i32" | "u32"), ">", ..] => {
                (format!("{vector}{}", &scalar[..1]), 4)
            }
            [token, ..] => match token.strip_suffix(".0f") {
                Some(whole) if is_number(whole) => (format!("{whole}f"), 1),
                _ => (token.to_owned(), 1),
            },
            [] => break,
        };
        out.push_str(&short);
        out.push(' ');
        at += length;
    }
    out
}

/// Without the types of variables that have a value: slangc gives each of its literals a type, so that the value has one, too.
fn without_types<'a>(tokens: &[&'a str]) -> Vec<&'a str> {
    let (mut kept, mut at) = (Vec::with_capacity(tokens.len()), 0);
    while at < tokens.len() {
        kept.push(tokens[at]);
        at += 1;
        if let [.., "var" | "let", _] = kept[..]
            && tokens.get(at) == Some(&":")
        {
            let ends = tokens[at..].iter().position(|token| matches!(*token, "=" | ";"));
            let end = ends.map_or(at, |length| at + length);
            at = if tokens.get(end) == Some(&"=") { end } else { at };
        }
    }
    kept
}

/// Without brackets around the whole of an operand, or of what is in brackets already.
fn without_brackets(mut tokens: Vec<&str>) -> Vec<&str> {
    loop {
        let needless = needless_brackets(&tokens);
        if needless.iter().all(|needless| !needless) {
            return tokens;
        }
        let mut needless = needless.into_iter();
        tokens.retain(|_| needless.next() == Some(false));
    }
}

/// Which tokens are brackets that change nothing; not all of those that only others make needless.
fn needless_brackets(tokens: &[&str]) -> Vec<bool> {
    let (mut open, mut close_of) = (Vec::new(), vec![0; tokens.len()]);
    let mut needless = vec![false; tokens.len()];
    for (at, &token) in tokens.iter().enumerate() {
        match token {
            "(" => open.push(at),
            ")" => close_of[open.pop().expect("brackets in pairs")] = at,
            _ => {}
        }
    }
    for at in 1..tokens.len() {
        let end = close_of[at];
        if end == 0 {
            continue;
        }
        let (before, after) = (tokens[at - 1], tokens.get(end + 1).copied().unwrap_or_default());
        let is_double = before == "(" && close_of[at - 1] == end + 1;
        // The brackets of calls and of statements stay, as do those beside `<` and `>`, which could begin or end a list of types without them.
        let is_operand = !is_word(before) && !matches!(before, ">" | "<" | ")" | "]") && !matches!(after, "<" | ">");
        let inner = outermost(&tokens[at + 1..end]);
        let is_primary = inner.iter().all(|token| is_word(token) || *token == ".");
        // What stands alone between commas or brackets needs none, unless a list of types could be seen in it.
        let is_alone = matches!(before, "(" | "[" | "," | "=") && matches!(after, ";" | ")" | "]" | ",");
        let is_compared = before == "=" && matches!(tokens[at - 2], "=" | "!" | "<" | ">");
        let has_comparison = inner.iter().any(|token| matches!(*token, "<" | ">"));
        let is_whole = is_alone && !is_compared && !has_comparison;
        if is_double || (is_operand && (is_whole || (is_primary && is_word(tokens[at + 1])))) {
            (needless[at], needless[end]) = (true, true);
        }
    }
    needless
}

/// The tokens that are in no brackets.
fn outermost<'a>(tokens: &[&'a str]) -> Vec<&'a str> {
    let mut depth = 0;
    let is_outermost = |token: &&&str| {
        match **token {
            "(" | "[" => depth += 1,
            ")" | "]" => depth -= 1,
            _ => return depth == 0,
        }
        false
    };
    tokens.iter().filter(is_outermost).copied().collect()
}

fn is_word(token: &str) -> bool {
    token.starts_with(|letter: char| letter.is_ascii_alphanumeric() || letter == '_')
}

#[cfg(test)]
mod tests {
    use super::*;

    fn short(text: &str) -> String {
        shorten(text).replace(' ', "")
    }

    #[test]
    fn types_go_where_values_tell_them() {
        assert_eq!(short("var a : f32 = 1.0f;"), "vara=1f;");
        assert_eq!(short("let a : array<vec3<f32>, i32(2)> = b;"), "leta=b;");
        for stays in ["var a : u32; b = a;", "var<private> a : u32 = 1u;", "f(a : u32)", "override a : u32 = 1u;"] {
            assert_eq!(short(stays), stays.replace(' ', ""));
        }
    }

    #[test]
    fn brackets_go_where_they_change_nothing() {
        for (text, expected) in [
            ("if(((a & b)) == 0u) {}", "if((a&b)==0u){}"),
            ("a = (b.c[i]) * (d(e, f)).x;", "a=b.c[i]*d(e,f).x;"),
            ("a = ((b + c));", "a=b+c;"),
            ("f((a + b), (c))", "f(a+b,c)"),
            ("a = (-b);", "a=-b;"),
            ("a += (b | c);", "a+=b|c;"),
            ("for(;; a = (a + 1u)) {}", "for(;;a=a+1u){}"),
        ] {
            assert_eq!(short(text), expected);
        }
    }

    #[test]
    fn brackets_that_change_something_stay() {
        for text in [
            "a=(b+c)*d;",
            "a=-(b.c+d);",
            "a=b==(c&d);",
            "return (a);",
            "f((a<b),(c>d));",
            "a=(b)<(c);",
            "a=bitcast<u32>(b);",
            "while(a){}",
            "a=&(*b);",
            "a=(*b).c;",
            "a=(b<c);",
            "a=b-(-c);",
            "a=-(-b);",
            "switch(a){case(1i):{}}",
            "@align(4)@size(8)a:b;",
        ] {
            assert_eq!(short(text), text.replace(' ', ""));
        }
    }
}
