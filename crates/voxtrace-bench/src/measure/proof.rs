//! What makes a frame count: a verdict over what the device said about it, and nothing else, so that every way of not
//! rendering can be planted in a test. The study could count frames that its GPU no longer rendered.

use voxtrace::Film;

/// What there is to be known about a frame once the tracer has returned.
#[derive(Clone, Debug, PartialEq)]
pub struct Said {
    /// What the tracer said went wrong; it checks itself that every submit wrote its sequence number and counted its
    /// workgroups.
    pub error: Option<String>,
    /// Whether the device was lost and work was done again on the way.
    pub is_mended: bool,
    /// Pixels of the picture.
    pub pixels: u64,
    /// Camera rays that the shaders counted; on the CPU the samples that were finished.
    pub camera_rays: u64,
    /// Submits of the frame.
    pub submits: u64,
    /// Sequence number that the shaders of the last submit wrote.
    pub sequence: u32,
    /// Milliseconds between the device's timestamps; `None` where it has no clock.
    pub gpu_ms: Option<f64>,
    /// Milliseconds of the host's clock around everything.
    pub wall_ms: f64,
}

/// Why a frame, or those of a film, do not count.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Doubt {
    #[error("{0}")]
    Failed(String),
    #[error("the device was lost on the way")]
    Mended,
    #[error("{rays} of {pixels} pixels got their ray")]
    Rays { rays: u64, pixels: u64 },
    #[error("the device wrote the sequence number {written}, not at least {fewest}")]
    Sequence { written: u32, fewest: u64 },
    #[error("the device's clock stands still ({0} ms)")]
    ClockStandsStill(f64),
    #[error("the device's clock says {device:.3} ms, the host's {host:.3} ms")]
    ClocksDiffer { device: f64, host: f64 },
    #[error("the host's clock gave no time")]
    NoTime,
    #[error("the film holds {least} to {most} samples a pixel after {frames} frames")]
    Film { least: u32, most: u32, frames: u32 },
}

/// Whether a frame was rendered; `last` is the sequence number of the frame before it.
///
/// # Errors
/// Why it does not count.
pub fn judge(said: &Said, last: u32) -> Result<(), Doubt> {
    if let Some(error) = &said.error {
        return Err(Doubt::Failed(error.clone()));
    }
    if said.is_mended {
        return Err(Doubt::Mended);
    }
    if said.camera_rays != said.pixels {
        return Err(Doubt::Rays { rays: said.camera_rays, pixels: said.pixels });
    }
    let fewest = u64::from(last) + said.submits;
    if said.submits == 0 || u64::from(said.sequence) < fewest {
        return Err(Doubt::Sequence { written: said.sequence, fewest });
    }
    // Clocks of host and device differ by less than a hundredth; a clock that went backwards gives an absurd length.
    let most = said.wall_ms * 1.05 + 1.0;
    match said.gpu_ms {
        Some(ms) if ms.is_nan() || ms <= 0.0 => Err(Doubt::ClockStandsStill(ms)),
        Some(ms) if ms > most => Err(Doubt::ClocksDiffer { device: ms, host: said.wall_ms }),
        _ if !said.wall_ms.is_finite() => Err(Doubt::NoTime),
        _ => Ok(()),
    }
}

/// Whether a film that was read back holds all of its frames: a sample of each of `frames` in every pixel.
///
/// # Errors
/// What is missing.
pub fn judge_film(film: &Film, frames: u32) -> Result<(), Doubt> {
    match film.sample_range() {
        (least, most) if (least, most) == (frames, frames) => Ok(()),
        (least, most) => Err(Doubt::Film { least, most, frames }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use voxtrace::Region;
    use voxtrace::glam::Vec3;

    fn good() -> Said {
        Said {
            error: None,
            is_mended: false,
            pixels: 768,
            camera_rays: 768,
            submits: 2,
            sequence: 12,
            gpu_ms: Some(3.0),
            wall_ms: 3.5,
        }
    }

    #[test]
    fn a_frame_counts_when_the_device_says_that_it_ran() {
        assert_eq!(judge(&good(), 10), Ok(()));
        assert_eq!(judge(&Said { gpu_ms: None, ..good() }, 3), Ok(()));
    }

    #[test]
    fn a_skipped_frame_is_lost() {
        // The host went on, the device did nothing: counters and sequence stay where they were.
        let skipped = Said { camera_rays: 0, sequence: 10, submits: 0, ..good() };
        assert!(judge(&skipped, 10).is_err());
        assert!(judge(&Said { camera_rays: 767, ..good() }, 10).unwrap_err().to_string().contains("767 of 768"));
        assert!(judge(&Said { submits: 0, ..good() }, 10).is_err());
    }

    #[test]
    fn a_wrong_sequence_number_is_noticed() {
        for wrong in [0, 10, 11] {
            let error = judge(&Said { sequence: wrong, ..good() }, 10).unwrap_err().to_string();
            assert!(error.contains("sequence number"), "{error}");
        }
    }

    #[test]
    fn a_timer_that_stops_runs_backwards_or_is_not_a_number_is_noticed() {
        assert!(judge(&Said { gpu_ms: Some(0.0), ..good() }, 10).unwrap_err().to_string().contains("stands still"));
        assert!(judge(&Said { gpu_ms: Some(f64::NAN), ..good() }, 10).is_err());
        assert!(judge(&Said { gpu_ms: Some(-1.0), ..good() }, 10).is_err());
        let backwards = 2_u64.wrapping_sub(7) as f64 * 1e-6;
        assert!(judge(&Said { gpu_ms: Some(backwards), ..good() }, 10).unwrap_err().to_string().contains("the host's"));
    }

    #[test]
    fn what_the_tracer_says_went_wrong_is_the_reason() {
        let error = "rendering failed: the device did not do the work".to_owned();
        assert_eq!(judge(&Said { error: Some(error.clone()), ..good() }, 10), Err(Doubt::Failed(error)));
        assert!(judge(&Said { is_mended: true, ..good() }, 10).is_err());
    }

    #[test]
    fn a_stale_film_is_noticed_although_sequence_numbers_grow() {
        let mut film = Film::new(4, 3, Region::full(4, 3), 0);
        for _ in 0..5 {
            film.pixels.iter_mut().for_each(|pixel| pixel.add(Vec3::ONE, true));
        }
        assert_eq!(judge_film(&film, 5), Ok(()));
        // The sixth frame said that it ran, but the film is that of the fifth.
        assert!(judge_film(&film, 6).unwrap_err().to_string().contains("5 to 5 samples a pixel after 6 frames"));
        // One pixel alone is behind.
        let mut partly = film.clone();
        partly.pixels.iter_mut().skip(1).for_each(|pixel| pixel.add(Vec3::ZERO, false));
        assert!(judge_film(&partly, 6).unwrap_err().to_string().contains("5 to 6 samples"));
    }
}
