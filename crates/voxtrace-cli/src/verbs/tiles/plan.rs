//! The plan of `tiles`: what each stage runs, as lines of JSON.

use crate::failure::Failure;
use crate::words::{Word, split};
use crate::{Cli, stdout};
use clap::CommandFactory;
use serde_json::json;
use std::ops::Range;
use std::path::Path;
use voxtrace::points::ColorBy;
use voxtrace::voxelize::{Scale, VoxelizeOptions};

/// Options that belong to one command alone.
const REPLACED: [&str; 10] =
    ["parts", "output", "files", "share", "survey", "part", "levels", "out", "expected", "read_once"];

/// The commands of a plan, which have the options of the one that makes it.
struct Plan<'a> {
    words: Vec<Word>,
    /// The files of each command.
    shares: &'a [Range<usize>],
    parts: usize,
    /// The file to write, without its extension.
    stem: String,
    stages: u32,
}

/// Prints the commands that voxelize so many files each into `out`, which are read once, or more often.
pub fn print(
    shares: &[Range<usize>],
    options: &VoxelizeOptions,
    (out, reads_once): (&Path, bool),
) -> Result<(), Failure> {
    let mut plan = Plan::new(shares, shares.len(), out)?;
    let mut survey = plan.name("survey");
    if reads_once {
        let expected = plan.name("expected");
        plan.expect(&expected);
        // Beside each part is what was found in its files.
        plan.share("voxelize", "part", Some(&expected));
        plan.join(&plan.names("found"), &survey);
        plan.merge(&["--survey", &survey, "--expected", &expected], &out.to_string_lossy());
        return Ok(());
    }
    plan.share("survey", "found", None);
    plan.join(&plan.names("found"), &survey);
    // Whether it is wanted is known only when all files were looked through; where it is not, it takes no time.
    let by = options.points.color_by;
    if options.scale == Scale::Automatic || matches!(by, ColorBy::Auto | ColorBy::Height) {
        plan.share("survey", "measures", Some(&survey));
        let measured = plan.name("measured.survey");
        plan.join(&[vec![survey], plan.names("measures")].concat(), &measured);
        survey = measured;
    }
    plan.share("voxelize", "part", Some(&survey));
    plan.merge(&["--survey", &survey], &out.to_string_lossy());
    Ok(())
}

/// Prints the commands that look through so many files of a mesh each, and voxelize so many shares of its space into `out`.
pub fn print_mesh(shares: &[Range<usize>], parts: usize, out: &Path) -> Result<(), Failure> {
    let mut plan = Plan::new(shares, parts, out)?;
    let survey = plan.name("survey");
    plan.share("survey", "found", None);
    plan.join(&plan.numbered("found", shares.len()), &survey);
    plan.share_space(&survey);
    plan.merge(&["--survey", &survey], &out.to_string_lossy());
    Ok(())
}

impl<'a> Plan<'a> {
    fn new(shares: &'a [Range<usize>], parts: usize, out: &Path) -> Result<Self, Failure> {
        let words = std::env::args_os().skip(1).map(|word| word.into_string()).collect::<Result<Vec<String>, _>>();
        let words = words.map_err(|word| Failure::usage(format!("{} is not Unicode, and JSON is", word.display())))?;
        let mut program = Cli::command();
        program.build();
        let verb = program.find_subcommand("tiles").ok_or_else(|| Failure::other("the verb is missing"))?;
        let stem = out.with_extension("").to_string_lossy().into_owned();
        Ok(Self { words: split(&words, verb), shares, parts, stem, stages: 0 })
    }

    /// A file beside the output.
    fn name(&self, kind: &str) -> String {
        format!("{}.{kind}", self.stem)
    }

    /// Those of all parts.
    fn names(&self, kind: &str) -> Vec<String> {
        self.numbered(kind, self.parts)
    }

    fn numbered(&self, kind: &str, count: usize) -> Vec<String> {
        let digits = (count - 1).to_string().len();
        (0..count).map(|part| self.name(&format!("{part:0digits$}.{kind}"))).collect()
    }

    /// A stage whose commands are for some files each.
    fn share(&mut self, stage: &str, kind: &str, survey: Option<&str>) {
        for (files, output) in self.shares.iter().zip(self.numbered(kind, self.shares.len())) {
            let mut options = vec!["--files".to_owned(), format!("{}..{}", files.start, files.end)];
            options.extend(survey.into_iter().flat_map(|survey| ["--survey".to_owned(), survey.to_owned()]));
            let command = self.command(stage, &options, &output, &[]);
            let line = json!({
                "stage": self.stages, "kind": stage, "files": [files.start, files.end], "output": output, "command": command,
            });
            stdout::print(&format!("{line}\n"));
        }
        self.stages += 1;
    }

    /// A stage whose commands are for a share of a mesh's space each.
    fn share_space(&mut self, survey: &str) {
        for (share, output) in self.names("part").into_iter().enumerate() {
            let of = format!("{share}/{}", self.parts);
            let options = ["--share", &of, "--survey", survey].map(str::to_owned);
            let command = self.command("voxelize", &options, &output, &[]);
            let line = json!({
                "stage": self.stages, "kind": "voxelize", "share": [share, self.parts], "output": output, "command": command,
            });
            stdout::print(&format!("{line}\n"));
        }
        self.stages += 1;
    }

    /// A stage of one command, which reads what others have found and no scan.
    fn join(&mut self, found: &[String], output: &str) {
        let mut command = ["voxtrace", "tiles", "join"].map(str::to_owned).to_vec();
        command.extend(["-o".to_owned(), output.to_owned(), "--".to_owned()]);
        command.extend_from_slice(found);
        let line = json!({ "stage": self.stages, "kind": "join", "output": output, "command": command });
        stdout::print(&format!("{line}\n"));
        self.stages += 1;
    }

    /// A stage of one command, which reads headers and first points.
    fn expect(&mut self, output: &str) {
        let command = self.command("expect", &[], output, &[]);
        let line = json!({ "stage": self.stages, "kind": "expect", "output": output, "command": command });
        stdout::print(&format!("{line}\n"));
        self.stages += 1;
    }

    fn merge(&mut self, surveys: &[&str], output: &str) {
        let mut options: Vec<String> = surveys.iter().map(|&word| word.to_owned()).collect();
        options.extend(self.names("part").into_iter().flat_map(|part| ["--part".to_owned(), part]));
        let command = self.command("merge", &options, output, &["levels"]);
        let line = json!({ "stage": self.stages, "kind": "merge", "output": output, "command": command });
        stdout::print(&format!("{line}\n"));
    }

    /// The same command for another stage, with further options; `kept` are those of the plan that otherwise belong to none.
    fn command(&self, stage: &str, options: &[String], output: &str, kept: &[&str]) -> Vec<String> {
        let mut command = ["voxtrace", "tiles", stage].map(str::to_owned).to_vec();
        let (mut own, mut inputs) = (Vec::new(), Vec::new());
        for word in &self.words {
            match word.id.as_deref() {
                Some(id) if REPLACED.contains(&id) && !kept.contains(&id) => {}
                Some(_) => own.extend(word.text.iter().cloned()),
                None => inputs.extend(word.text.iter().cloned()),
            }
        }
        command.extend(own);
        command.extend_from_slice(options);
        command.extend(["-o".to_owned(), output.to_owned(), "--".to_owned()]);
        // The verb and the stage come first.
        command.extend(inputs.into_iter().skip(2));
        command
    }
}
