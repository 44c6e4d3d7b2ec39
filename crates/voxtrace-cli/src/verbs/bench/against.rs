//! `voxtrace bench --against PROGRAM`: this program and another one measure the same in turns, as child processes.

use super::{BenchArgs, CommandLine};
use crate::failure::{Failure, Kind};
use crate::interrupt;
use crate::report::Report;
use std::ffi::OsString;
use std::path::Path;
use voxtrace_bench::{Against, AgainstError, Request};

/// Rounds where nobody says how many.
pub const ROUNDS: u32 = 5;

/// Words that the children are told in another way or not at all, and whether a value follows.
const OWN: [(&str, bool); 11] = [
    ("--against", true),
    ("--rounds", true),
    ("--output", true),
    ("-o", true),
    ("--frames", true),
    ("--time-limit", true),
    ("--progress", true),
    ("--json", false),
    ("--force", false),
    ("--quiet", false),
    ("-q", false),
];

/// Measures both programs in turns and prints what came of it.
pub fn run(
    program: &Path,
    rounds: u32,
    args: &BenchArgs,
    request: &Request,
    report: &mut Report,
) -> Result<(), Failure> {
    let own = std::env::current_exe().map_err(|error| Failure::other(format!("this program is nowhere: {error}")))?;
    let (frames, limit) = request.share(rounds);
    let against = Against {
        programs: [own, program.to_owned()],
        rounds,
        words: words(std::env::args_os().skip(1)),
        output: args.output.clone(),
        frames,
        limit_ms: u64::try_from(limit.as_millis()).unwrap_or(u64::MAX).max(1),
        has_size: request.size.is_some(),
    };
    report.remark(&format!("{rounds} rounds, in each of them both programs"));
    let duel = against.run(request, &mut CommandLine { args, report })?;
    crate::stdout::print(&if args.json { format!("{:#}\n", duel.json()) } else { duel.text() });
    report.remark(&format!("the reports of all rounds are in {}", args.output.display()));
    if interrupt::is_requested() {
        let hint = format!("the rounds before are in {}", args.output.display());
        return Err(Failure::new(Kind::Interrupted, "interrupted").hint(hint));
    }
    Ok(())
}

/// What was typed, up to the verb and behind it, without our [`OWN`] words.
fn words(typed: impl Iterator<Item = OsString>) -> [Vec<OsString>; 2] {
    let [mut before, mut behind] = [Vec::new(), Vec::new()];
    let (mut is_behind, mut are_names, mut is_value) = (false, false, false);
    for word in typed {
        if std::mem::take(&mut is_value) {
            continue;
        }
        let text = word.to_string_lossy();
        // `-qo OUT` is `-q -o OUT`.
        let text = match text.strip_prefix("-q") {
            Some(rest) if !rest.is_empty() => format!("-{rest}"),
            _ => text.into_owned(),
        };
        if !are_names {
            let name = text.split_once('=').map_or(text.as_str(), |(name, _)| name);
            let glued = |own: &str| own.len() == 2 && text.starts_with(own) && text.len() > 2;
            if let Some((_, takes)) = OWN.iter().find(|(own, takes)| name == *own || *takes && glued(own)) {
                is_value = *takes && OWN.iter().any(|(own, _)| text == *own);
                continue;
            }
            are_names = text == "--";
        }
        let is_verb = !is_behind && text == "bench";
        if is_behind {
            behind.push(word)
        } else {
            before.push(word)
        }
        is_behind |= is_verb;
    }
    [before, behind]
}

impl From<AgainstError> for Failure {
    fn from(error: AgainstError) -> Self {
        let text = error.to_string();
        match error {
            AgainstError::Request(error) => error.into(),
            AgainstError::Start { .. } | AgainstError::Foreign { .. } => {
                Self::input(text).hint("--against names a program: voxtrace bench --against ./voxtrace-1.0")
            }
            AgainstError::Report { .. } => {
                Self::input(text).hint("it has to be a voxtrace whose `compare` reads the same reports")
            }
            _ => Self::other(text),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told(typed: &str) -> [String; 2] {
        let join = |words: &[OsString]| words.iter().map(|word| word.to_string_lossy()).collect::<Vec<_>>().join(" ");
        words(typed.split(' ').map(OsString::from)).each_ref().map(|words| join(words))
    }

    #[test]
    fn both_programs_are_told_what_was_typed_but_for_what_each_round_has_of_its_own() {
        let typed = "--threads 1 bench city --against ./old -o out --cells cpu,walk --rounds=7 --quick --json -q";
        assert_eq!(told(typed), ["--threads 1 bench", "city --cells cpu,walk --quick"]);
        let typed =
            "--progress json bench --against=x -oout --output=b --frames 9 --time-limit=3s --force --plan p.toml";
        assert_eq!(told(typed), ["bench", "--plan p.toml"]);
        assert_eq!(told("bench -qo out a.vox --against x -qob"), ["bench", "a.vox"]);
        let typed = "bench --against x --integrator path -- --frames bench";
        assert_eq!(told(typed), ["bench", "--integrator path -- --frames bench"]);
    }
}
