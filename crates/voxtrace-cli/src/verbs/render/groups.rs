//! `--light-groups`: after the picture, the light of the sun, of the sky and of emitters, each as a film of the same paths, so that tracers
//! keep nothing more for each pixel and the groups add up to the picture.

use super::files::Job;
use crate::failure::Failure;
use crate::report::Report;
use crate::session::{End, Limits, run};
use std::collections::BTreeSet;
use std::time::Duration;
use voxtrace::film::Pixel;
use voxtrace::{Film, LightGroup, PackedScene, Tracer};

/// Whether a scene has light of a group at all.
fn shines(scene: &PackedScene, group: LightGroup) -> bool {
    match group {
        LightGroup::Sun => scene.sky.sun().is_some(),
        LightGroup::Emitters => scene.materials().iter().any(|material| material.emission.max_element() > 0.0),
        _ => true,
    }
}

/// Brings the light groups of `film` to the samples that it has, going on with those that it has already.
pub fn trace_groups(
    tracer: &mut (dyn Tracer + Send),
    job: &Job,
    film: &mut Film,
    scene: &PackedScene,
    checkpoint_every: Option<Duration>,
    save: &dyn Fn(&Report, Film),
    report: &mut Report,
) -> Result<End, Failure> {
    for group in LightGroup::PARTS {
        let known = film.groups.iter().position(|(known, _)| *known == group);
        let start = known.map(|index| film.groups.remove(index).1);
        let (end, pixels) = if shines(scene, group) {
            trace_group(tracer, job, (group, start), film, checkpoint_every, save, report)?
        } else {
            let black = |pixel: &Pixel| Pixel { radiance: [0; 3], ..*pixel };
            (End::Complete, film.pixels.iter().map(black).collect())
        };
        film.groups.push((group, pixels));
        if end == End::Interrupted {
            return Ok(end);
        }
    }
    film.groups.sort_by_key(|(group, _)| *group as u32);
    Ok(End::Complete)
}

/// The pixels of one group, from `start` on where there is one.
fn trace_group(
    tracer: &mut (dyn Tracer + Send),
    job: &Job,
    (group, start): (LightGroup, Option<Vec<Pixel>>),
    film: &Film,
    checkpoint_every: Option<Duration>,
    save: &dyn Fn(&Report, Film),
    report: &mut Report,
) -> Result<(End, Vec<Pixel>), Failure> {
    let empty = || Film::new(job.frame.width, job.frame.height, job.frame.region, job.frame.first_sample);
    let mut pixels = start.unwrap_or_else(|| empty().pixels);
    let name = format!("{}, light of {}", job.name, group.name());
    let all = film.pixels.iter().map(|pixel| u64::from(pixel.samples)).sum();
    // Where parts of the picture have fewer samples than others (`--noise`), those of each number end together.
    for level in film.pixels.iter().map(|pixel| pixel.samples).collect::<BTreeSet<_>>() {
        let is_active = |index: usize| film.pixels[index].samples >= level && pixels[index].samples < level;
        let active: Vec<usize> = (0..pixels.len()).filter(|&index| is_active(index)).collect();
        if active.is_empty() {
            continue;
        }
        let frame = job.frame.clone().samples(level).light_group(group).aovs(false);
        // Tracers leave pixels alone that are ahead.
        let ahead = |pixel: &Pixel| Pixel { samples: pixel.samples.max(level), ..*pixel };
        let mut round = Film { pixels: pixels.iter().map(ahead).collect(), ..empty() };
        active.iter().for_each(|&index| round.pixels[index] = pixels[index]);
        tracer.resume(&frame, round).map_err(Failure::mismatch)?;
        let with = |round: &Film| {
            let mut pixels = pixels.clone();
            active.iter().for_each(|&index| pixels[index] = round.pixels[index]);
            pixels
        };
        let done = pixels.iter().map(|pixel| u64::from(pixel.samples)).sum();
        report.begin(&name, done, all);
        let save = |report: &Report, round: Film| {
            let mut whole = film.clone();
            whole.groups.push((group, with(&round)));
            save(report, whole);
        };
        let limits = Limits { time: None, checkpoint_every, halfway: false, earlier: None };
        let (end, round) = run(tracer, &frame, done, &limits, &save, report)?;
        pixels = with(&round);
        if end != End::Complete {
            return Ok((end, pixels));
        }
    }
    Ok((End::Complete, pixels))
}
