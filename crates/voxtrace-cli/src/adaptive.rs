//! Adaptive sampling: tiles whose estimated error is small enough get no more samples. Every pixel holds the first samples of its sequence,
//! as always, and what is done next follows from the film alone: the one of an interrupted render ends as the same film.

use crate::failure::Failure;
use crate::noise::Tiles;
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

/// The samples that each tile is to have next; `None` for those that are done or have to wait. Tiles within a round end it first: what is
/// decided between rounds is then the same wherever a render was interrupted. Then those that are too noisy begin the next one, also tiles
/// that had stopped before the ones around them turned out to be noisier.
fn plan(film: &mut Film, tiles: &Tiles, noise: f64, frame: &Frame) -> Vec<Option<u32>> {
    let most = frame.samples;
    let Film { pixels, earlier, .. } = film;
    let earlier = earlier.get_or_insert_with(|| vec![Pixel::default(); pixels.len()]);
    let unfinished = tiles.list.iter().map(|tile| {
        let target = after(tile.most(earlier), most);
        (tile.least(pixels) < target).then_some(target)
    });
    let unfinished: Vec<Option<u32>> = unfinished.collect();
    if unfinished.iter().any(Option::is_some) {
        return unfinished;
    }
    let errors = tiles.errors(frame, pixels, earlier);
    let next = tiles.list.iter().zip(errors).map(|(tile, error)| {
        let is_clean = error.is_some_and(|error| error <= SAFETY * noise);
        if is_clean || tile.least(pixels) >= most {
            return None;
        }
        tile.pixels.iter().for_each(|&index| earlier[index] = pixels[index]);
        Some(after(tile.most(earlier), most))
    });
    next.collect()
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
    let tiles = Tiles::of(&film);
    loop {
        let targets = plan(&mut film, &tiles, noise, frame);
        // Those behind first.
        let Some(target) = targets.iter().flatten().copied().min() else { return Ok((End::Complete, film)) };
        let is_active = |wanted: &Option<u32>| *wanted == Some(target);
        let active: Vec<usize> = tiles
            .list
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

#[cfg(test)]
mod tests {
    use super::*;
    use voxtrace::glam::Vec3;
    use voxtrace::{Camera, Region};

    /// Adds samples of brightness 1 to a tile of 32 pixels' width, and light to one pixel.
    fn add(film: &mut Film, tile: usize, samples: u32, more: u64) {
        for (index, pixel) in film.pixels.iter_mut().enumerate().filter(|(index, _)| index / 32 % 2 == tile) {
            (0..samples).for_each(|_| pixel.add(Vec3::ONE, true));
            if index % 32 == 5 && index / 64 == 5 {
                pixel.radiance.iter_mut().for_each(|sum| *sum += more << 32);
            }
        }
    }

    #[test]
    fn nothing_is_decided_within_a_round_and_a_stopped_tile_goes_on_with_a_noisier_neighbor() {
        let mut film = Film::new(64, 32, Region::full(64, 32), 0);
        let frame = Frame::new(Camera::look_at(Vec3::ONE, Vec3::ZERO), 64, 32).samples(100);
        let tiles = Tiles::of(&film);
        let next = |film: &mut Film| plan(film, &tiles, 0.1, &frame);
        assert_eq!(next(&mut film), [Some(8); 2]);
        (0..2).for_each(|tile| add(&mut film, tile, 8, 0));
        assert_eq!(next(&mut film), [Some(12); 2], "one part of the samples says nothing");
        add(&mut film, 0, 4, 0);
        // A bright path too few to begin another round with.
        add(&mut film, 1, 2, 400);
        assert_eq!(next(&mut film), [None, Some(12)], "the other is within its round");
        add(&mut film, 1, 2, 0);
        assert_eq!(next(&mut film), [Some(18); 2]);
        // The first tile by itself is clean, and stays so beside one that is.
        let mut film = Film::new(64, 32, Region::full(64, 32), 0);
        (0..2).for_each(|tile| add(&mut film, tile, 8, 0));
        next(&mut film);
        (0..2).for_each(|tile| add(&mut film, tile, 4, 0));
        assert_eq!(next(&mut film), [None; 2]);
    }
}
