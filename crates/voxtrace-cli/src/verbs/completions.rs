//! `voxtrace completions`: the script that lets a shell complete verbs and options.

use crate::failure::Failure;
use clap::CommandFactory;
use clap_complete::Shell;

/// Print a completion script for a shell
#[derive(clap::Args, Clone, Debug)]
pub struct CompletionsArgs {
    /// The shell
    shell: Shell,
}

impl CompletionsArgs {
    pub fn run(self) -> Result<(), Failure> {
        let mut script = Vec::new();
        clap_complete::generate(self.shell, &mut crate::Cli::command(), "voxtrace", &mut script);
        crate::print(&String::from_utf8_lossy(&script));
        Ok(())
    }
}
