//! `voxtrace plan`: a picture as commands, of which each renders a part, for whatever runs commands on many machines.

use super::render::RenderArgs;
use crate::failure::Failure;
use crate::picture::PictureArgs;
use crate::report::Report;
use crate::words::{Word, split};
use crate::{Cli, stdout};
use clap::{Args, Command, CommandFactory};
use serde_json::{Value, json};
use voxtrace_bench::quantity::counted;

/// Share a picture among machines: one command for each part, as lines of JSON, and one that merges their films
///
/// Takes the options of `render`. Each line has the `command`, a list of words, the `film` that it writes, and its samples; the last one is the
/// command for when all of them are there. Files are named as they were here: machines share a folder, or files are brought to where commands run.
#[derive(Args, Clone, Debug)]
pub struct PlanArgs {
    /// Number of parts; no more than there are samples
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    parts: u32,
    #[command(flatten)]
    render: RenderArgs,
}

impl PlanArgs {
    pub fn run(self, report: &mut Report) -> Result<(), Failure> {
        let shared = self.render.shared()?;
        let words = std::env::args_os().skip(1).map(|word| word.into_string());
        let words = words
            .collect::<Result<Vec<String>, _>>()
            .map_err(|word| Failure::usage(format!("{} is not Unicode, and JSON is", word.display())))?;
        let mut program = Cli::command();
        program.build();
        let verb = program.find_subcommand("plan").ok_or_else(|| Failure::other("the verb is missing"))?;
        let words = split(&words, verb);
        let parts = self.parts.min(shared.samples);
        if parts < self.parts {
            report.warn(&format!("{}: there are no more samples of a pixel", counted(parts.into(), "part")));
        }
        let digits = (parts - 1).to_string().len();
        let bound = |part: u32| (u64::from(shared.samples) * u64::from(part) / u64::from(parts)) as u32;
        let mut films = Vec::new();
        for part in 0..parts {
            let (first, samples) = (shared.first_sample + bound(part), bound(part + 1) - bound(part));
            let film = format!("{}-part-{part:0digits$}.vxf", shared.stem);
            let command = part_command(&words, (first, samples), &film);
            let line = json!({
                "kind": "part", "part": part, "first_sample": first, "samples": samples, "film": film, "command": command,
            });
            stdout::print(&format!("{line}\n"));
            films.push(film);
        }
        let command = merge_command(&words, &films, &shared.outputs);
        let line = json!({ "kind": "merge", "films": films, "outputs": shared.outputs, "command": command });
        stdout::print(&format!("{line}\n"));
        Ok(())
    }
}

/// What renders a part: the same command with another verb, other samples and another output.
fn part_command(words: &[Word], (first, samples): (u32, u32), film: &str) -> Vec<Value> {
    // What says how films become pictures is for the command that merges them.
    const REPLACED: [&str; 7] = ["parts", "spp", "first_sample", "output", "exposure", "tone_map", "bit_depth"];
    let mut command: Vec<String> = vec!["voxtrace".into()];
    let mut has_verb = false;
    let (mut options, mut scenes) = (Vec::new(), Vec::new());
    for word in words {
        match word.id.as_deref() {
            Some(id) if REPLACED.contains(&id) => {}
            Some(_) => options.extend(word.text.iter().cloned()),
            None if !has_verb => has_verb = true,
            None => scenes.extend(word.text.iter().cloned()),
        }
    }
    command.push("render".into());
    command.extend(options);
    let [samples, first] = [samples, first].map(|number| number.to_string());
    command.extend(["--spp", &samples, "--first-sample", &first, "-o", film].map(str::to_owned));
    extend_by_names(&mut command, &scenes);
    command.into_iter().map(Value::from).collect()
}

/// What adds the films up, with the options that say how films become pictures.
fn merge_command(words: &[Word], films: &[String], outputs: &[String]) -> Vec<Value> {
    let picture = PictureArgs::augment_args(Command::new("merge"));
    let is_of_pictures = |id: &str| id != "output" && picture.get_arguments().any(|option| option.get_id() == id);
    let options = words.iter().filter(|word| word.id.as_deref().is_some_and(is_of_pictures));
    let mut command: Vec<String> = vec!["voxtrace".into(), "merge".into()];
    command.extend(options.flat_map(|word| word.text.iter().cloned()));
    command.extend(outputs.iter().flat_map(|output| ["-o".to_owned(), output.clone()]));
    extend_by_names(&mut command, films);
    command.into_iter().map(Value::from).collect()
}

/// Names of files at the end of a command, which are no options even where they look like some.
fn extend_by_names(command: &mut Vec<String>, names: &[String]) {
    if names.iter().any(|name| name.starts_with('-')) {
        command.push("--".into());
    }
    command.extend(names.iter().cloned());
}
