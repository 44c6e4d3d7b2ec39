//! Adaptive sampling: tiles whose estimated error is small enough get no more samples. Every pixel holds the first samples of its sequence,
//! as always, and what is done next follows from the film alone: the one of an interrupted render ends as the same film.

use crate::failure::Failure;
use crate::noise::{Tile, tiles};
use crate::report::Report;
use crate::session::{End, Limits, run};
use std::time::Instant;
use voxtrace::film::Pixel;
use voxtrace::{Film, Frame, Tracer};

/// Samples of the first part; each later round adds half of what there is.
const FIRST: u32 = 8;
/// Part of the error asked for at which a tile stops: estimates vary by some hundredths.
const SAFETY: f64 = 0.9;

/// Samples of a tile whose round began with so many.
fn after(samples: u32, most: u32) -> u32 {
    if samples < FIRST { FIRST.min(most) } else { samples.saturating_add(samples.div_ceil(2)).min(most) }
}

/// The samples that each tile is to have next; `None` for those that are done. Tiles at the end of a round begin the next one.
fn plan(film: &mut Film, tiles: &[Tile], noise: f64, frame: &Frame) -> Vec<Option<u32>> {
    let most = frame.samples;
    let Film { pixels, earlier, .. } = film;
    let earlier = earlier.get_or_insert_with(|| vec![Pixel::default(); pixels.len()]);
    let next = |tile: &Tile| {
        let (begun, least) = (tile.most(earlier), tile.least(pixels));
        let target = after(begun, most);
        if least < target {
            return Some(target);
        }
        let is_clean = tile.error(frame, pixels, earlier).is_some_and(|error| error <= SAFETY * noise);
        if is_clean || least >= most {
            return None;
        }
        tile.pixels.iter().for_each(|&index| earlier[index] = pixels[index]);
        Some(after(tile.most(earlier), most))
    };
    tiles.iter().map(next).collect()
}

/// Renders until the relative error of each tile is estimated to be below `noise`, or has as many samples as `frame` asks for, or a limit
/// is reached. `film` is what there is already.
pub fn run_adaptively(
    tracer: &mut (dyn Tracer + Send),
    frame: &Frame,
    (name, noise): (&str, f64),
    mut film: Film,
    limits: &Limits,
    save: &dyn Fn(&Report, Film),
    report: &mut Report,
) -> Result<(End, Film), Failure> {
    let start = Instant::now();
    let tiles = tiles(&film);
    loop {
        let targets = plan(&mut film, &tiles, noise, frame);
        // Those behind first.
        let Some(target) = targets.iter().flatten().copied().min() else { return Ok((End::Complete, film)) };
        let is_active = |wanted: &Option<u32>| *wanted == Some(target);
        let active: Vec<usize> = tiles
            .iter()
            .zip(&targets)
            .filter(|(_, wanted)| is_active(wanted))
            .flat_map(|(tile, _)| tile.pixels.clone())
            .collect();
        // Tracers leave pixels alone that are ahead.
        let mut round = Film { earlier: None, ..film.clone() };
        round.pixels.iter_mut().for_each(|pixel| pixel.samples = pixel.samples.max(target));
        active.iter().for_each(|&index| round.pixels[index] = film.pixels[index]);
        let part = frame.clone().samples(target);
        tracer.resume(&part, round).map_err(Failure::mismatch)?;
        let with = |round: &Film| {
            let mut film = film.clone();
            active.iter().for_each(|&index| film.pixels[index] = round.pixels[index]);
            film
        };
        let left = limits.time.map(|limit| limit.saturating_sub(start.elapsed()));
        let limits = Limits { time: left, checkpoint_every: limits.checkpoint_every, halfway: false, earlier: None };
        let done: u64 = film.pixels.iter().map(|pixel| u64::from(pixel.samples)).sum();
        let missing = active.iter().map(|&index| u64::from(target.saturating_sub(film.pixels[index].samples)));
        report.begin(name, done, done + missing.sum::<u64>());
        let (end, round) = run(tracer, &part, done, &limits, &|report, round| save(report, with(&round)), report)?;
        film = with(&round);
        film.aovs = round.aovs;
        if end != End::Complete {
            return Ok((end, film));
        }
    }
}
