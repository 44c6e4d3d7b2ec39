//! The labels of a label map.

use super::{Volume, VolumeError};
use rayon::prelude::*;
use std::collections::BTreeSet;

/// Most labels of a map.
const MOST_LABELS: usize = 16_384;
/// The largest whole number below which an `f32` holds all of them.
const EXACT: f32 = 16_777_216.0;
/// Values looked at by one task.
const CHUNK: usize = 1 << 18;

impl Volume {
    /// The labels that occur, ascending, 0 (no label) left out.
    ///
    /// # Errors
    /// If a value is no whole number of at most 2²⁴, or there are more than 16,384 labels.
    pub fn labels(&self) -> Result<Vec<i32>, VolumeError> {
        let refused = |reason: String| VolumeError::NoLabels { name: self.name.clone(), reason };
        let of_chunk = |values: &[f32]| {
            let (mut labels, mut last) = (BTreeSet::new(), 0.0);
            // Neighbours mostly have the same label.
            for &value in values.iter().filter(|&&value| value != std::mem::replace(&mut last, value)) {
                if value.fract() != 0.0 || value.abs() > EXACT {
                    return Err(refused(format!("{value} is among its values")));
                }
                labels.insert(value as i32);
                if labels.len() > MOST_LABELS {
                    return Err(refused(format!("it has more than {MOST_LABELS} values")));
                }
            }
            Ok(labels)
        };
        let both = |mut a: BTreeSet<i32>, b: BTreeSet<i32>| {
            a.extend(b);
            Ok(a)
        };
        let mut labels = self.values.par_chunks(CHUNK).map(of_chunk).try_reduce(BTreeSet::new, both)?;
        labels.remove(&0);
        match labels.len() {
            0 => Err(refused("all its values are 0".into())),
            1..=MOST_LABELS => Ok(labels.into_iter().collect()),
            count => Err(refused(format!("it has {count} values, more than {MOST_LABELS}"))),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_are_whole_numbers_but_zero() {
        let labels = |values: Vec<f32>| Volume::new([values.len(), 1, 1], values).labels();
        assert_eq!(labels(vec![0.0, 7.0, 7.0, -2.0, 0.0, 7.0]).unwrap(), [-2, 7]);
        for (wrong, reason) in [
            (vec![1.0, 2.5], "2.5 is among"),
            (vec![1.0, f32::NAN], "NaN is among"),
            (vec![f32::INFINITY], "inf is among"),
            (vec![3e7], "30000000 is among"),
            (vec![0.0; 9], "all its values are 0"),
            ((0..20_000).map(|i| i as f32).collect(), "more than 16384"),
        ] {
            let said = labels(wrong).unwrap_err().to_string();
            assert!(said.contains(reason), "{said}");
        }
    }
}
