//! What can go wrong on the command line: one line with a hint, and an exit code that scripts can rely on.
//! `docs/command-line.md` lists the codes.

use crate::{Cli, hints};
use clap::CommandFactory;
use clap::error::{ContextKind, ContextValue, ErrorKind};
use std::fmt::Display;
use std::path::Path;
pub use voxtrace_bench::reason;

/// Exit code of success.
pub const OK: u8 = 0;

/// Why the program ends without having done what it was asked.
#[derive(Debug)]
pub struct Failure {
    /// Kind, which is also the exit code.
    pub kind: Kind,
    message: String,
    hint: Option<String>,
}

/// Kinds of failure; their numbers are the exit codes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Kind {
    /// Anything that no other code names.
    Other = 1,
    /// The arguments make no sense.
    Usage = 2,
    /// An input cannot be read, or is not what it should be.
    Input = 3,
    /// An output cannot be written.
    Output = 4,
    /// A film does not belong to this scene, these settings or the other films.
    Mismatch = 5,
    /// SIGINT or SIGTERM; what there was has been written.
    Interrupted = 130,
}

impl Failure {
    pub fn new(kind: Kind, message: impl Display) -> Self {
        Self { kind, message: message.to_string(), hint: None }
    }

    pub fn other(message: impl Display) -> Self {
        Self::new(Kind::Other, message)
    }

    pub fn usage(message: impl Display) -> Self {
        Self::new(Kind::Usage, message)
    }

    pub fn input(message: impl Display) -> Self {
        Self::new(Kind::Input, message)
    }

    pub fn mismatch(message: impl Display) -> Self {
        Self::new(Kind::Mismatch, message)
    }

    /// A file that could not be written.
    pub fn output(path: &Path, error: &std::io::Error) -> Self {
        let failure = Self::new(Kind::Output, format!("cannot write {}: {}", path.display(), reason(error)));
        match error.kind() {
            std::io::ErrorKind::NotFound => failure.hint("the folder does not exist; create it first"),
            std::io::ErrorKind::PermissionDenied => failure.hint("check the permissions of the file and its folder"),
            std::io::ErrorKind::StorageFull => failure.hint("free some space; the old file, if any, is unchanged"),
            std::io::ErrorKind::IsADirectory => failure.hint("name a file inside it"),
            _ => failure,
        }
    }

    pub fn hint(self, hint: impl Display) -> Self {
        Self { hint: Some(hint.to_string()), ..self }
    }

    /// The same reason and hint, said by somebody else.
    pub fn retold(self, retell: impl FnOnce(&str) -> Self) -> Self {
        let told = retell(&self.message);
        Self { hint: self.hint.or(told.hint), ..told }
    }

    /// The one line that people read.
    pub fn line(&self) -> String {
        // Names of files may hold line breaks.
        let text = match &self.hint {
            Some(hint) => format!("error: {}; hint: {hint}", self.message),
            None => format!("error: {}", self.message),
        };
        text.replace(['\n', '\r'], " ")
    }
}

impl From<clap::Error> for Failure {
    /// Turns clap's several lines into one.
    fn from(error: clap::Error) -> Self {
        let text = error.to_string();
        let mut message = Vec::new();
        let mut hint = match error.get(ContextKind::InvalidArg) {
            Some(ContextValue::String(typed)) if error.kind() == ErrorKind::UnknownArgument => {
                verb_of(&text).and_then(|verb| hints::for_option(typed, &verb)).map(str::to_owned)
            }
            Some(ContextValue::String(option)) => match error.get(ContextKind::InvalidValue) {
                Some(ContextValue::String(value)) => hints::for_value(option, value),
                _ => None,
            },
            _ => None,
        };
        for line in text.lines().map(str::trim) {
            if line.starts_with("Usage:") || line.starts_with("For more information") {
                break;
            } else if let Some(tip) = line.strip_prefix("tip: ") {
                hint.get_or_insert(tip.to_owned());
            } else if !line.is_empty() {
                message.push(line);
            }
        }
        let message = message.join(" ");
        let message = message.strip_prefix("error: ").unwrap_or(&message).to_owned();
        Self::usage(message)
            .hint(hint.unwrap_or_else(|| "`voxtrace help` and `voxtrace help VERB` list what there is".into()))
    }
}

/// The verb whose usage a message of the command line's parser shows.
fn verb_of(message: &str) -> Option<clap::Command> {
    let usage = message.lines().find_map(|line| line.trim().strip_prefix("Usage: "))?;
    // After the program, whose file may have been given another name.
    Cli::command().find_subcommand(usage.split_whitespace().nth(1)?).cloned()
}
