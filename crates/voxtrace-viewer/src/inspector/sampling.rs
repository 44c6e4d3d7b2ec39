//! The values of a volume, which a scene does not keep: its file is read once more, on a thread, when somebody first asks, and stays until another
//! scene is opened.

use super::{Fact, fact};
use crate::load::Wanted;
use crate::scale::grouped;
use crate::threads;
use crate::tr;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, TryRecvError, channel};
use voxtrace::Volume;
use voxtrace::glam::{DAffine3, DVec3};

/// Samples of a volume as its file has them.
#[derive(Clone, Debug, PartialEq)]
pub struct Values {
    /// Samples along each axis.
    pub size: [usize; 3],
    /// The samples, the first axis fastest.
    pub samples: Vec<f32>,
    /// From the coordinates of the source to lattice indices, whole at the middle of a sample.
    index_from_coordinates: DAffine3,
    /// From the world of the scene to the coordinates of the source.
    coordinates_from_world: DAffine3,
    is_labels: bool,
}

/// What the file has at a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// The nearest sample.
    pub index: [usize; 3],
    /// Its value.
    pub value: f32,
    /// The value between the samples around, `None` of labels.
    pub between: Option<f32>,
}

impl Values {
    /// Of a volume and the scene that was made of it, whose coordinates are its own.
    pub fn new(volume: Volume, coordinates_from_world: DAffine3) -> Self {
        Self {
            size: volume.size,
            index_from_coordinates: volume.world_from_index.inverse(),
            samples: volume.values,
            coordinates_from_world,
            is_labels: volume.is_labels,
        }
    }

    /// What the file has at a point of the scene, voxels; `None` beside it.
    pub fn at(&self, point: DVec3) -> Option<Sample> {
        let index = self.index_from_coordinates.transform_point3(self.coordinates_from_world.transform_point3(point));
        let size = DVec3::from_array(self.size.map(|size| size as f64));
        if !index.is_finite() || index.cmplt(DVec3::splat(-0.5 - 1e-6)).any() || index.cmpgt(size - 0.5 + 1e-6).any() {
            return None;
        }
        let clamped = index.clamp(DVec3::ZERO, size - 1.0);
        let nearest = clamped.round().to_array().map(|index| index as usize);
        let value = self.sample(nearest)?;
        let between = if self.is_labels { None } else { self.between(clamped) };
        Some(Sample { index: nearest, value, between })
    }

    fn sample(&self, [x, y, z]: [usize; 3]) -> Option<f32> {
        self.samples.get((z * self.size[1] + y) * self.size[0] + x).copied()
    }

    fn between(&self, index: DVec3) -> Option<f32> {
        let (low, share) = (index.floor(), index - index.floor());
        let mut sum = 0.0;
        for corner in 0..8usize {
            let step = DVec3::from_array([0, 1, 2].map(|axis| (corner >> axis & 1) as f64));
            let weight = (step * share + (1.0 - step) * (1.0 - share)).element_product();
            if weight > 0.0 {
                sum += weight * f64::from(self.sample((low + step).to_array().map(|index| index as usize))?);
            }
        }
        Some(sum as f32)
    }
}

/// What is known of the values of the scene that is shown.
#[derive(Default)]
pub enum Sampling {
    /// Nobody asked yet.
    #[default]
    Unasked,
    /// They are being read.
    Reading {
        /// What comes of it.
        result: Receiver<Result<Option<Values>, String>>,
        /// Ends the reading.
        wanted: Wanted,
    },
    /// Here they are.
    Read(Arc<Values>),
    /// The scene was not made of a volume.
    None,
    /// Why there are none, one line.
    Failed(String),
}

impl Sampling {
    /// Begins to read, by a function that takes its time.
    pub fn start(read: impl FnOnce(&Wanted) -> Result<Option<Values>, String> + Send + 'static) -> Self {
        let (sender, result) = channel();
        let wanted = Wanted::default();
        let of_thread = wanted.clone();
        std::thread::spawn(move || {
            threads::yield_to_window();
            let values = catch_unwind(AssertUnwindSafe(|| read(&of_thread)));
            // Another scene may be there.
            let _ = sender.send(values.unwrap_or_else(|_| Err(tr!("voxel.not_read").into())));
        });
        Self::Reading { result, wanted }
    }

    /// Takes what was read. Returns whether one has to look again soon.
    pub fn take(&mut self) -> bool {
        let Self::Reading { result, .. } = self else { return false };
        *self = match result.try_recv() {
            Err(TryRecvError::Empty) => return true,
            Err(TryRecvError::Disconnected) => Self::Failed(tr!("voxel.not_read").into()),
            Ok(Err(error)) => Self::Failed(error),
            Ok(Ok(None)) => Self::None,
            Ok(Ok(Some(values))) => Self::Read(Arc::new(values)),
        };
        false
    }

    /// Lines about the value at a point of the scene.
    pub fn facts(&self, point: DVec3) -> Vec<Fact> {
        match self {
            Self::Unasked | Self::None => Vec::new(),
            Self::Reading { .. } => vec![fact(tr!("voxel.value"), tr!("voxel.reading"))],
            Self::Failed(error) => vec![fact(tr!("voxel.value"), error.clone())],
            Self::Read(values) => match values.at(point) {
                None => vec![fact(tr!("voxel.value"), tr!("voxel.beside"))],
                Some(Sample { index: [x, y, z], value, between }) => {
                    let number = |value: f32| grouped(f64::from(value), 4);
                    let own = fact(tr!("voxel.value"), number(value));
                    let between = between.filter(|between| (between - value).abs() > 1e-4 * value.abs().max(1.0));
                    let between = between.map(|value| fact(tr!("voxel.between"), number(value)));
                    let sample = fact(tr!("voxel.sample"), format!("{x}, {y}, {z}"));
                    [Some(own), between, Some(sample)].into_iter().flatten().collect()
                }
            },
        }
    }
}

impl Drop for Sampling {
    fn drop(&mut self) {
        if let Self::Reading { wanted, .. } = self {
            wanted.end();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use voxtrace::glam::DMat3;

    fn values() -> Values {
        let size = [3, 4, 5];
        let samples = (0..60).map(|index| index as f32).collect();
        // Samples of 2 mm from 10 mm on, along the axes; voxels of 1 mm.
        let coordinates =
            DAffine3 { matrix3: DMat3::from_diagonal(DVec3::splat(2.0)), translation: DVec3::splat(10.0) };
        let world = DAffine3 { matrix3: DMat3::IDENTITY, translation: DVec3::splat(9.0) };
        let index_from_coordinates = coordinates.inverse();
        Values { size, samples, index_from_coordinates, coordinates_from_world: world, is_labels: false }
    }

    #[test]
    fn the_value_is_that_of_the_nearest_sample_and_that_between_the_samples_around() {
        let values = values();
        let at = |x, y, z| values.at(DVec3::new(x, y, z)).unwrap();
        assert_eq!(at(1.0, 1.0, 1.0), Sample { index: [0; 3], value: 0.0, between: Some(0.0) });
        assert_eq!(at(5.0, 7.0, 9.0), Sample { index: [2, 3, 4], value: 59.0, between: Some(59.0) });
        assert_eq!(at(2.5, 1.0, 4.0), Sample { index: [1, 0, 2], value: 25.0, between: Some(0.75 + 1.5 * 12.0) });
        assert_ne!(at(2.5, 1.0, 4.0).between, Some(25.0));
        assert_eq!(values.at(DVec3::new(-0.1, 1.0, 1.0)), None, "half a sample beside the first is beside the volume");
        assert!(values.at(DVec3::new(0.01, 1.0, 1.0)).is_some());
        let labels = Values { is_labels: true, ..values };
        assert_eq!(labels.at(DVec3::new(2.5, 1.0, 4.0)).unwrap().between, None, "labels have nothing between them");
    }

    #[test]
    fn what_is_read_comes_from_a_thread_and_what_fails_is_one_line() {
        let wait = |mut sampling: Sampling| {
            let start = std::time::Instant::now();
            while sampling.take() {
                assert!(start.elapsed().as_secs() < 60);
                std::thread::yield_now();
            }
            sampling
        };
        let read = wait(Sampling::start(|_| Ok(Some(values()))));
        let facts = read.facts(DVec3::new(2.5, 1.0, 4.0));
        let texts: Vec<&str> = facts.iter().map(|fact| fact.text.as_str()).collect();
        assert_eq!(texts, ["25", "18.75", "1, 0, 2"]);
        assert_eq!(wait(Sampling::start(|_| Err("it is gone".into()))).facts(DVec3::ZERO)[0].text, "it is gone");
        assert!(wait(Sampling::start(|_| Ok(None))).facts(DVec3::ZERO).is_empty());
        assert!(matches!(wait(Sampling::start(|_| panic!("planted"))), Sampling::Failed(_)));
    }
}
