//! Commands that the window runs beside itself: the same words as on the command line, and the same work, told to the window.

use crate::failure::Failure;
use crate::interrupt;
use crate::report::{Report, Said};
use crate::{Cli, Verb};
use clap::Parser;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use voxtrace_bench::Results;
use voxtrace_bench::shell::quoted;
use voxtrace_viewer::{Told, Wanted};

type Tell = Mutex<Box<dyn Fn(Told) + Send>>;

fn locked(tell: &Tell) -> MutexGuard<'_, Box<dyn Fn(Told) + Send>> {
    tell.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Runs a command as long as it is wanted.
///
/// # Errors
/// One line: what is wrong, and what to do.
pub fn run(words: &[String], tell: Box<dyn Fn(Told) + Send>, wanted: &Wanted) -> Result<(), String> {
    let done = Cli::try_parse_from(words).map_err(Failure::from).and_then(|cli| {
        let told = Arc::new(Mutex::new(tell));
        let of_report = Arc::clone(&told);
        let report = &mut Report::to(Box::new(move |said| {
            locked(&of_report)(match said {
                Said::Text(text) => Told::Note(text.to_owned()),
                Said::Progress(work, share, seconds_left) => {
                    Told::Progress { work: work.to_owned(), share: Some(share), seconds_left }
                }
            });
        }));
        let wanted = wanted.clone();
        interrupt::also_when(move || wanted.is_over());
        match cli.verb {
            Verb::Animate(args) => args.run(report),
            Verb::Bench(mut args) => {
                args.command = Some(words.iter().map(|word| quoted(word)).collect::<Vec<_>>().join(" "));
                let show = |results: &Results| locked(&told)(Told::Measured(results.measurements()));
                args.run_showing(&show, report)
            }
            _ => Err(Failure::usage("the window runs `animate` and `bench` alone")),
        }
    });
    done.map_err(|failure| failure.line().trim_start_matches("error: ").to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;
    fn words(text: &str, output: &std::path::Path) -> Vec<String> {
        let words = text.split(' ').map(|word| if word == "OUT" { output.display().to_string() } else { word.into() });
        words.collect()
    }

    #[test]
    fn what_the_window_runs_tells_how_far_all_of_it_is_and_can_be_stopped() {
        let folder = tempfile::tempdir().unwrap();
        let told = Arc::new(Mutex::new(Vec::new()));
        let kept = Arc::clone(&told);
        let tell = Box::new(move |said| {
            if let Told::Progress { share, .. } = said {
                kept.lock().unwrap().push(share.unwrap());
            }
        });
        let line = "voxtrace animate city --voxels 2000 --turntable=4 --size 8x6 --spp 1 -o OUT";
        let pattern = folder.path().join("a_####.png");
        assert_eq!(run(&words(line, &pattern), tell, &Wanted::default()), Ok(()));
        let shares = std::mem::take(&mut *told.lock().unwrap());
        assert!(shares.is_sorted() && shares.iter().any(|share| (0.24..0.26).contains(share)), "{shares:?}");
        assert!(folder.path().join("a_0004.png").exists());
        let over = Wanted::default();
        over.end();
        let stopped = run(&words(line, &folder.path().join("b_####.png")), Box::new(|_| {}), &over);
        assert!(stopped.unwrap_err().contains("interrupted") && !folder.path().join("b_0001.png").exists());
        let refused = run(&words("voxtrace info city", folder.path()), Box::new(|_| {}), &Wanted::default());
        assert!(refused.unwrap_err().contains("alone"));
    }
}
