//! The words of a command line by the option that they belong to, so that a command can be written anew with other options.

use clap::{Arg, Command};

/// An option with its values, or a word that belongs to none.
#[derive(Debug, PartialEq, Eq)]
pub struct Word {
    /// The name of the option in the program; `None` for what is no option.
    pub id: Option<String>,
    pub text: Vec<String>,
}

/// Splits words as the parser of a verb does, which has been built and has taken them.
pub fn split(words: &[String], verb: &Command) -> Vec<Word> {
    let mut found = Vec::new();
    let mut rest = words.iter().map(String::as_str).peekable();
    while let Some(word) = rest.next() {
        if word == "--" {
            found.extend(rest.by_ref().map(|word| Word { id: None, text: vec![word.into()] }));
        } else if let Some(long) = word.strip_prefix("--") {
            let (name, value) = long.split_once('=').map_or((long, None), |(name, value)| (name, Some(value)));
            let Some(option) = verb.get_arguments().find(|option| has_long(option, name)) else { continue };
            let mut text = vec![word.to_owned()];
            if value.is_none() {
                take_values(option, &mut text, &mut rest);
            }
            found.push(Word { id: Some(option.get_id().to_string()), text });
        } else if word.starts_with('-') && word.len() > 1 {
            for (at, letter) in word.char_indices().skip(1) {
                let Some(option) = verb.get_arguments().find(|option| option.get_short() == Some(letter)) else { break };
                let mut text = vec![format!("-{letter}")];
                let value = &word[at + letter.len_utf8()..];
                let has_value = option.get_action().takes_values();
                match value.strip_prefix('=').unwrap_or(value) {
                    "" => take_values(option, &mut text, &mut rest),
                    value if has_value => text.push(value.to_owned()),
                    _ => {}
                }
                found.push(Word { id: Some(option.get_id().to_string()), text });
                if has_value {
                    break;
                }
            }
        } else {
            found.push(Word { id: None, text: vec![word.into()] });
        }
    }
    found
}

fn has_long(option: &Arg, name: &str) -> bool {
    let aliases = option.get_all_aliases().unwrap_or_default();
    option.get_long() == Some(name) || aliases.contains(&name)
}

/// Takes the values of an option that stand in words of their own.
fn take_values<'a>(
    option: &Arg,
    text: &mut Vec<String>,
    rest: &mut std::iter::Peekable<impl Iterator<Item = &'a str>>,
) {
    if !option.get_action().takes_values() || option.is_require_equals_set() {
        return;
    }
    let counts = option.get_num_args().unwrap_or_else(|| 1.into());
    for count in 0..counts.max_values() {
        let is_option = rest.peek().is_none_or(|word| word.starts_with('-'));
        if count >= counts.min_values() && is_option {
            break;
        }
        let Some(value) = rest.next() else { break };
        text.push(value.to_owned());
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Cli;
    use clap::CommandFactory;

    #[test]
    fn words_go_with_the_option_that_takes_them() {
        let mut program = Cli::command();
        program.build();
        let verb = program.find_subcommand("plan").unwrap();
        let words = "--threads 3 plan -qo a.png x.vox --eye -1,2,3 --samples=4 --denoise --edges -ob.png --sun 10,20 -- -y.vox";
        let words: Vec<String> = words.split(' ').map(str::to_owned).collect();
        let found = split(&words, verb);
        let found: Vec<(&str, String)> =
            found.iter().map(|word| (word.id.as_deref().unwrap_or("-"), word.text.join(" "))).collect();
        let wanted = [
            ("threads", "--threads 3"),
            ("-", "plan"),
            ("quiet", "-q"),
            ("output", "-o a.png"),
            ("-", "x.vox"),
            ("eye", "--eye -1,2,3"),
            ("spp", "--samples=4"),
            ("denoise", "--denoise"),
            ("edges", "--edges"),
            ("output", "-o b.png"),
            ("sun", "--sun 10,20"),
            ("-", "-y.vox"),
        ];
        assert_eq!(found, wanted.map(|(id, text)| (id, text.to_owned())));
    }
}
