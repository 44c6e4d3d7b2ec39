//! The size of the pictures of a quick benchmark on the processor: the largest of which so many frames fit in their time, so that times rest on
//! more than one or two frames.

use crate::plan::{Cell, LEAST_FRAMES, STUDY_SIZE};
use crate::quantity::Size;
use std::path::Path;
use std::sync::Arc;
use std::time::{Duration, Instant};
use voxtrace::{CpuTracer, Frame, Instructions, PackedScene, Progress, TraceError, Tracer};

/// What the frames of all cells of a quick benchmark may take together; loading scenes, and comparing voxels, needs the rest of the minute.
const TIME: Duration = Duration::from_secs(20);
/// Sizes of the shape of the study's pictures, the largest first.
const SIZES: [Size; 8] =
    [STUDY_SIZE, (1320, 720), (990, 540), (660, 360), (495, 270), (330, 180), (198, 108), (110, 60)];
/// The size of the frames that are rendered to find out.
const TRIAL: Size = (198, 108);

/// The size for these cells of so many scenes, found by rendering one of them with the instructions of each cell.
///
/// # Errors
/// What tracing says.
pub fn found(scene: &Arc<PackedScene>, frame: &Frame, cells: &[Cell], scenes: usize) -> Result<Size, TraceError> {
    let usual = Instructions::chosen();
    let mut seconds = 0.0;
    for cell in cells {
        // A cell that the processor has not fails later, and takes no time.
        if cell.instructions.is_none_or(Instructions::force) {
            seconds += trial(scene, frame)?;
        }
        usual.force();
    }
    Ok(fitting(seconds / pixels(TRIAL), scenes))
}

/// Seconds of a frame, the median of three.
fn trial(scene: &Arc<PackedScene>, frame: &Frame) -> Result<f64, TraceError> {
    let mut tracer = CpuTracer::new(None);
    tracer.set_scene(scene)?;
    let mut times = Vec::new();
    // The first fetches the scene into the caches.
    for sample in 0..4 {
        let start = Instant::now();
        tracer.render(&frame.clone().size(TRIAL.0, TRIAL.1).samples(sample + 1), &Progress::default())?;
        times.push(start.elapsed().as_secs_f64());
    }
    times[1..].sort_by(f64::total_cmp);
    Ok(times[2])
}

/// The largest size that fits, where a pixel takes so many seconds of all cells together.
fn fitting(seconds: f64, scenes: usize) -> Size {
    let time = TIME.as_secs_f64() / scenes.max(1) as f64;
    let fits = |size: &Size| seconds * pixels(*size) * f64::from(LEAST_FRAMES) <= time;
    SIZES.into_iter().find(fits).unwrap_or(SIZES[SIZES.len() - 1])
}

fn pixels((width, height): Size) -> f64 {
    f64::from(width) * f64::from(height)
}

/// The size of the benchmark in a folder, which goes on with it; `None` where none is there.
pub fn before(folder: &Path) -> Option<Size> {
    let text = std::fs::read_to_string(folder.join("results.json")).ok()?;
    let json: serde_json::Value = serde_json::from_str(&text).ok()?;
    let number = |name: &str| json["settings"][name].as_u64().and_then(|number| u32::try_from(number).ok());
    Some((number("width")?, number("height")?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sixty_four_frames_of_each_cell_fit_in_the_time_and_pictures_are_no_smaller_than_they_must() {
        assert_eq!(fitting(1e-12, 3), STUDY_SIZE);
        assert_eq!(fitting(1.0, 3), (110, 60), "the smallest where none fits");
        for (seconds, scenes) in [(1e-6, 3), (1e-6, 1), (3e-7, 3), (5e-8, 15)] {
            let size = fitting(seconds, scenes);
            let time = |size: Size| seconds * pixels(size) * 64.0 * scenes as f64;
            assert!(time(size) <= 20.0, "{size:?}");
            let larger = SIZES[..SIZES.iter().position(|&other| other == size).unwrap()].last();
            assert!(larger.is_none_or(|&larger| time(larger) > 20.0), "{size:?}");
        }
        let is_of_its_shape = |(width, height): &Size| width * STUDY_SIZE.1 == height * STUDY_SIZE.0;
        assert!(SIZES.iter().all(is_of_its_shape));
    }
}
