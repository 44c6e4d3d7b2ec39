//! `--light-groups`: after the picture, the light of the sun, of the sky and of emitters, each as a film of the same paths, so that tracers
//! keep nothing more for each pixel and the groups add up to the picture.

use super::files::Job;
use crate::failure::Failure;
use crate::report::Report;
use crate::session::{End, Limits, run};
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
    let frame = job.frame.clone().samples(film.sample_range().1).light_group(group).aovs(false);
    let mut done = 0;
    if let Some(pixels) = start {
        done = pixels.iter().map(|pixel| u64::from(pixel.samples)).sum();
        let begun = Film::new(frame.width, frame.height, frame.region, frame.first_sample);
        tracer.resume(&frame, Film { pixels, ..begun }).map_err(Failure::mismatch)?;
    }
    let name = format!("{}, light of {}", job.name, group.name());
    report.begin(&name, done, frame.region.pixels() as u64 * u64::from(frame.samples));
    let with = |part: Film| {
        let mut whole = film.clone();
        whole.groups.push((group, part.pixels));
        whole
    };
    let limits = Limits { time: None, checkpoint_every, halfway: false, earlier: None };
    let (end, part) = run(tracer, &frame, done, &limits, &|report, part| save(report, with(part)), report)?;
    Ok((end, part.pixels))
}
