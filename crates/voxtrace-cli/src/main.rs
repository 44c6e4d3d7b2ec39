//! The command line of voxtrace: render, inspect and convert voxel scenes. One file for each verb in `verbs`.

#![forbid(unsafe_code)]

mod adaptive;
mod animation;
mod blocks;
mod camera_file;
mod changes;
mod clip;
mod cluster;
mod cuts;
mod edits;
mod failure;
mod heights;
mod hints;
mod hounsfield;
mod import;
mod instructions;
mod integrator;
mod interrupt;
mod lattice;
mod lens;
mod levels;
mod light;
mod lines;
mod load;
mod mesh;
mod noise;
mod normals;
mod outputs;
mod overlays;
mod parse;
mod picture;
mod probes;
mod read_failure;
mod report;
mod session;
mod stdout;
mod surroundings;
mod tracer;
mod transfer_text;
mod verbs;
mod views;
mod volume;
mod words;

use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};
use failure::Failure;
use report::{ProgressStyleArg, Report};
use std::io::Write;
use std::process::ExitCode;

const AFTER_HELP: &str = "\
Examples:
  voxtrace render church -o church.png
  voxtrace view castle.vox
  voxtrace animate castle.vox --turntable=96 -o castle.mp4
  voxtrace render castle.vox -o castle.png -o castle.exr --spp 256 --aovs
  voxtrace voxelize scan.glb -o scan.vxt --resolution 2048
  voxtrace info castle.vox --json

Exit codes:
  0 done              3 input unreadable or malformed    5 film does not fit
  1 other failure     4 output cannot be written         130 interrupted (SIGINT, SIGTERM)
  2 wrong arguments";

/// Path tracing of voxel scenes.
#[derive(Parser, Debug)]
#[command(name = "voxtrace", version, after_help = AFTER_HELP, max_term_width = 110)]
pub struct Cli {
    #[command(subcommand)]
    verb: Verb,
    /// Threads to use [default: all cores]
    #[arg(long, global = true, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
    /// Vector instructions that the CPU traces with, to compare them; all give the same picture [default: those that this processor is fastest with]
    #[arg(long, global = true, value_name = "NAME", env = "VOXTRACE_INSTRUCTIONS", hide_env_values = true)]
    instructions: Option<instructions::InstructionsArg>,
    /// How progress is shown on stderr
    #[arg(long, global = true, value_name = "STYLE", default_value = "auto")]
    progress: ProgressStyleArg,
    /// Say nothing but errors
    #[arg(short, long, global = true)]
    quiet: bool,
}

#[derive(Subcommand, Debug)]
enum Verb {
    Render(Box<verbs::render::RenderArgs>),
    Animate(Box<verbs::animate::AnimateArgs>),
    #[cfg(feature = "view")]
    View(Box<verbs::view::ViewerArgs>),
    #[cfg(feature = "serve")]
    Serve(Box<verbs::serve::ServeArgs>),
    Info(verbs::info::InfoArgs),
    Convert(verbs::convert::ConvertArgs),
    Voxelize(verbs::voxelize::VoxelizeArgs),
    Tiles(Box<verbs::tiles::TilesArgs>),
    Plan(Box<verbs::plan::PlanArgs>),
    Merge(verbs::merge::MergeArgs),
    Scenes(verbs::scenes::ScenesArgs),
    Formats(verbs::formats::FormatsArgs),
    Devices(verbs::devices::DevicesArgs),
    Doctor(verbs::doctor::DoctorArgs),
    Bench(Box<verbs::bench::BenchArgs>),
    Compare(verbs::compare::CompareArgs),
    Completions(verbs::completions::CompletionsArgs),
    Man(verbs::man::ManArgs),
}

fn main() -> ExitCode {
    stdout::begin();
    match parse_arguments().and_then(|cli| cli.map_or(Ok(()), run)).and_then(|()| stdout::lost()) {
        Ok(()) => ExitCode::from(failure::OK),
        Err(failure) => {
            let _ = writeln!(std::io::stderr(), "{}", failure.line());
            ExitCode::from(failure.kind as u8)
        }
    }
}

/// A command and those under it, whose options take what looks like a number below 0 as their value, so that they say themselves what is wrong with it.
fn numbers_below_zero(command: clap::Command) -> clap::Command {
    command.allow_negative_numbers(true).mut_subcommands(numbers_below_zero)
}

/// The arguments, or `None` where they asked for help or the version, which is printed.
fn parse_arguments() -> Result<Option<Cli>, Failure> {
    use clap::error::ErrorKind::{
        DisplayHelp, DisplayHelpOnMissingArgumentOrSubcommand, DisplayVersion, MissingSubcommand,
    };
    let mut command = numbers_below_zero(Cli::command());
    let parsed = command.try_get_matches_from_mut(std::env::args_os());
    let parsed = parsed.and_then(|matches| Cli::from_arg_matches(&matches).map_err(|error| error.format(&mut command)));
    match parsed {
        Ok(cli) => Ok(Some(cli)),
        Err(error) if matches!(error.kind(), DisplayHelp | DisplayVersion) => {
            stdout::keep(error.print().and_then(|()| std::io::stdout().flush()));
            Ok(None)
        }
        Err(error) if matches!(error.kind(), MissingSubcommand | DisplayHelpOnMissingArgumentOrSubcommand) => {
            Err(Failure::usage("a verb is missing").hint("`voxtrace help` lists them; try `voxtrace render church`"))
        }
        Err(error) => Err(error.into()),
    }
}

fn run(cli: Cli) -> Result<(), Failure> {
    interrupt::install()?;
    voxtrace::import::opened::record();
    if let Some(threads) = cli.threads {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads.into());
        pool.build_global().map_err(|error| Failure::other(format!("cannot start {threads} threads: {error}")))?;
    }
    cli.instructions.map_or(Ok(()), instructions::InstructionsArg::force)?;
    let report = &mut Report::new(cli.progress, cli.quiet);
    match cli.verb {
        Verb::Render(args) => args.run(report),
        Verb::Animate(args) => args.run(report),
        #[cfg(feature = "view")]
        Verb::View(args) => args.run(),
        #[cfg(feature = "serve")]
        Verb::Serve(args) => args.run(report),
        Verb::Info(args) => args.run(report),
        Verb::Convert(args) => args.run(report),
        Verb::Voxelize(args) => args.run(report),
        Verb::Tiles(args) => args.run(report),
        Verb::Plan(args) => args.run(report),
        Verb::Merge(args) => args.run(report),
        Verb::Scenes(args) => args.run(),
        Verb::Formats(args) => args.run(),
        Verb::Devices(args) => args.run(),
        Verb::Doctor(args) => args.run(report),
        Verb::Bench(args) => args.run(report),
        Verb::Compare(args) => args.run(report),
        Verb::Completions(args) => args.run(Cli::command()),
        Verb::Man(args) => args.run(Cli::command()),
    }
}
