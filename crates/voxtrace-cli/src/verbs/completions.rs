//! `voxtrace completions`: the script that lets a shell complete verbs and options.

use crate::failure::Failure;
use clap::Command;
use clap_complete::Shell;

/// Print a completion script for a shell
#[derive(clap::Args, Clone, Debug)]
pub struct CompletionsArgs {
    /// The shell
    shell: Shell,
}

impl CompletionsArgs {
    /// Prints the script for a command.
    pub fn run(self, mut command: Command) -> Result<(), Failure> {
        let mut script = Vec::new();
        clap_complete::generate(self.shell, &mut command, "voxtrace", &mut script);
        crate::stdout::print(&String::from_utf8_lossy(&script));
        Ok(())
    }
}
