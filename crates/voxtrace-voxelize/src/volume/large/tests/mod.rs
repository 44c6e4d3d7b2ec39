//! A volume that is read layer by layer becomes the file of the same volume in memory, whichever way it lies and however it is cut.

mod choice;
mod shares;

use super::super::{Preset, Ramp, Transfer, voxelize};
use super::*;
use crate::voxelize::Scale;
use glam::{DAffine3, DMat3, DVec3};
use voxtrace_core::packed::PackedScene;

/// Samples in memory that are read as those of a file, and how many were.
struct Kept {
    frame: Volume,
    values: Vec<f32>,
    /// What they are read as; codes stand for whole numbers.
    coding: Coding,
    reads: usize,
    /// The work is cancelled at this many reads.
    stop: Option<(usize, std::sync::Arc<VoxelizeProgress>)>,
}

impl SampleSource for Kept {
    fn frame(&self) -> &Volume {
        &self.frame
    }

    fn frame_mut(&mut self) -> &mut Volume {
        &mut self.frame
    }

    fn coding(&self) -> Coding {
        self.coding.clone()
    }

    fn read(&mut self, layer: usize, rows: Range<usize>, block: &mut Block) -> Result<(), ImportError> {
        let [width, depth, _] = self.frame.size;
        let start = (layer * depth + rows.start) * width;
        let values = self.values[start..start + rows.len() * width].iter();
        match block {
            Block::Bytes(codes) => codes.iter_mut().zip(values).for_each(|(code, &value)| *code = (value + 90.0) as u8),
            Block::Words(codes) => {
                codes.iter_mut().zip(values).for_each(|(code, &value)| *code = (value + 999.0) as u16)
            }
            Block::Reals(own) => own.iter_mut().zip(values).for_each(|(own, &value)| *own = value),
        }
        self.reads += 1;
        if let Some((_, progress)) = self.stop.as_ref().filter(|(reads, _)| *reads <= self.reads) {
            progress.cancel();
        }
        Ok(())
    }
}

/// A lump with a rough surface, of whole numbers or not.
fn lump(size: [usize; 3], are_whole: bool) -> Volume {
    let at = |n: usize| {
        let place = [n % size[0], n / size[0] % size[1], n / (size[0] * size[1])];
        let offset = |axis: usize| (place[axis] as f32 + 0.5) / size[axis] as f32 - 0.5;
        (offset(0).powi(2) + offset(1).powi(2) * 1.5 + offset(2).powi(2) * 0.7).sqrt()
    };
    let value = |n: usize| {
        let noise = (n as u32).wrapping_mul(2_654_435_761) >> 22;
        (0.45 - at(n)) * 900.0 + noise as f32 * 0.06
    };
    let value = |n| if are_whole { value(n).round() } else { value(n) };
    Volume { name: "lump".into(), ..Volume::new(size, (0..size.iter().product()).map(value).collect()) }
}

fn kept(volume: &Volume) -> Kept {
    let frame = Volume { values: Vec::new(), ..volume.clone() };
    Kept { frame, values: volume.values.clone(), coding: Coding::Reals, reads: 0, stop: None }
}

/// The same, read as codes of 8 or 16 bits.
fn coded(volume: &Volume, is_small: bool) -> Kept {
    let table = |count: u32, first: f32| (0..count).map(|code| code as f32 - first).collect();
    let coding = if is_small { Coding::Bytes(table(256, 90.0)) } else { Coding::Words(table(65_536, 999.0)) };
    Kept { coding, ..kept(volume) }
}

fn in_memory(volume: &Volume, options: &VolumeOptions, path: &Path) -> Vec<u8> {
    let scene = voxelize(volume, options, &Limits::default()).unwrap();
    PackedScene::pack_merged(&scene).unwrap().save(path).unwrap();
    std::fs::read(path).unwrap()
}

fn large(source: &mut Kept, options: &VolumeOptions, budget: u64, path: &Path) -> Result<Vec<u8>, VoxelizeError> {
    let progress = source.stop.as_ref().map_or_else(Default::default, |(_, progress)| progress.clone());
    let mut survey = Survey::of(source, options, Some(budget), &VoxelizeProgress::default())?;
    source.reads = 0;
    let options = (options, Some(budget));
    voxelize_large_volume_to_file((source, "stamp"), &mut survey, options, &Limits::default(), path, &progress)?;
    Ok(resaved(path))
}

/// A file with its sections in the order in which a scene in memory is saved.
fn resaved(path: &Path) -> Vec<u8> {
    let again = path.with_extension("again");
    PackedScene::read(path).unwrap().save(&again).unwrap();
    let bytes = std::fs::read(&again).unwrap();
    std::fs::remove_file(again).unwrap();
    bytes
}

/// The axes of the lattice along axes of the world, some backwards.
fn placed(volume: Volume, order: [usize; 3], backwards: [bool; 3]) -> Volume {
    let axis = |n: usize| DVec3::AXES[order[n]] * if backwards[n] { -1.0 } else { 1.0 } * [0.5, 0.6, 0.8][n];
    let matrix3 = DMat3::from_cols(axis(0), axis(1), axis(2));
    Volume { world_from_index: DAffine3 { matrix3, translation: DVec3::new(3.0, -40.0, 5.5) }, ..volume }
}

#[test]
fn a_volume_read_layer_by_layer_gives_the_same_bytes_whichever_way_it_lies() {
    let folder = tempfile::tempdir().unwrap();
    let (a, b) = (folder.path().join("a.vxt"), folder.path().join("b.vxt"));
    let orders = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
    let scales = [None, Some(Scale::Resolution(19)), Some(Scale::Resolution(83))];
    let mut planted = 0;
    for (n, order) in orders.into_iter().enumerate() {
        let backwards = [n % 2 == 0, n % 3 == 0, n % 4 < 2];
        let volume = placed(lump([70, 41, 37], n % 2 == 0), order, backwards);
        for (k, scale) in scales.into_iter().enumerate() {
            let transfer = (k == 1).then(|| Preset::CtBone.transfer());
            let options = VolumeOptions { scale, transfer, shell: (n + k) % 2 == 0, ..VolumeOptions::default() };
            let wanted = in_memory(&volume, &options, &a);
            for budget in [1, 200_000, 1 << 30] {
                let found = large(&mut kept(&volume), &options, budget, &b).unwrap();
                assert!(found == wanted, "{order:?} {scale:?} {budget}");
            }
            // One sample is another.
            let mut wrong = kept(&volume);
            let middle = wrong.values.len() / 2;
            wrong.values[middle..middle + 3].fill(-999.0);
            planted += usize::from(large(&mut wrong, &options, 1 << 30, &b).unwrap() != wanted);
        }
    }
    assert!(planted >= 12, "{planted}");
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 2, "nothing is left beside the output");
}

#[test]
fn interrupted_work_goes_on_where_it_was_and_ends_with_the_same_bytes() {
    let folder = tempfile::tempdir().unwrap();
    let (a, b) = (folder.path().join("a.vxt"), folder.path().join("b.vxt"));
    let volume = placed(lump([60, 50, 90], true), [0, 1, 2], [false, true, true]);
    let options = VolumeOptions::default();
    let wanted = in_memory(&volume, &options, &a);
    // In one stripe, and in many.
    for budget in [1 << 30, 1] {
        let mut source = kept(&volume);
        let all = {
            large(&mut source, &options, budget, &b).unwrap();
            std::fs::remove_file(&b).unwrap();
            source.reads
        };
        let progress = std::sync::Arc::default();
        // The survey reads each layer once for each of its stripes.
        source.stop = Some((all * 2 / 3, progress));
        source.reads = 0;
        let mut survey = Survey::of(&mut kept(&volume), &options, Some(budget), &VoxelizeProgress::default()).unwrap();
        let stopped = source.stop.clone().unwrap().1;
        let result = voxelize_large_volume_to_file(
            (&mut source, "stamp"),
            &mut survey,
            (&options, Some(budget)),
            &Limits::default(),
            &b,
            &stopped,
        );
        assert!(matches!(result, Err(VoxelizeError::Cancelled)) && !b.exists());
        let mut again = kept(&volume);
        let found = large(&mut again, &options, budget, &b).unwrap();
        assert!(found == wanted && again.reads < all * 2 / 3, "{} of {all}", again.reads);
    }
}

#[test]
fn labels_stay_labels_and_what_shows_nothing_is_said() {
    let folder = tempfile::tempdir().unwrap();
    let (a, b) = (folder.path().join("a.vxt"), folder.path().join("b.vxt"));
    let mut volume = lump([40, 30, 33], true);
    volume.values.iter_mut().for_each(|value| *value = (*value / 60.0).round().max(0.0));
    let options = VolumeOptions { scale: Some(Scale::Resolution(57)), ..VolumeOptions::default() };
    assert!(large(&mut kept(&volume), &options, 1, &b).unwrap() == in_memory(&volume, &options, &a));
    let none = VolumeOptions { threshold: Some(1e9), ..options.clone() };
    let error = large(&mut kept(&volume), &none, 1, &b).unwrap_err();
    assert!(matches!(error, VoxelizeError::Volume(VolumeError::Empty { .. })), "{error}");
    let few = Limits { voxels: 10, ..Limits::default() };
    let mut source = kept(&volume);
    let mut survey = Survey::of(&mut source, &options, None, &VoxelizeProgress::default()).unwrap();
    let progress = VoxelizeProgress::default();
    let result = voxelize_large_volume_to_file((&mut source, ""), &mut survey, (&options, None), &few, &b, &progress);
    assert!(matches!(result, Err(VoxelizeError::TooLarge { what: "voxels", .. })));
}

#[test]
fn codes_of_8_and_16_bits_become_the_bytes_that_their_values_become() {
    let folder = tempfile::tempdir().unwrap();
    let (a, b) = (folder.path().join("a.vxt"), folder.path().join("b.vxt"));
    let mut planted = 0;
    for n in 0..6usize {
        let mut volume = placed(lump([70, 40, 36], true), [[0, 1, 2], [2, 0, 1]][n % 2], [n < 3, n % 3 == 0, n == 4]);
        // Nothing around the lump, or noise that is not seen.
        let noise = |at: usize| if n % 3 == 1 { (at * 7 % 5) as f32 - 3.0 } else { 0.0 };
        let values = volume.values.iter_mut().enumerate();
        values.for_each(|(at, value)| *value = if *value > 20.0 { (*value / 4.0).round() } else { noise(at) });
        // As it is; two, about four and about seven samples in a row for a voxel; voxels finer than samples.
        for (k, count) in [70, 35, 19, 10, 83].into_iter().enumerate() {
            let transfer = match (n + k) % 3 {
                0 => None,
                1 => Some(Preset::Surface.transfer()),
                _ => Some(Transfer::new(
                    "band",
                    Ramp::Absolute { low: 30.0, high: 80.0, stops: vec![(30.0, glam::Vec3::ONE)] },
                )),
            };
            let scale = Some(Scale::Resolution(count));
            let options = VolumeOptions {
                scale,
                transfer,
                shell: k % 2 == 0,
                threshold: (n == 5).then_some(4.5),
                ..VolumeOptions::default()
            };
            let wanted = in_memory(&volume, &options, &a);
            for budget in [1, 1 << 30] {
                for is_small in [true, false] {
                    let found = large(&mut coded(&volume, is_small), &options, budget, &b).unwrap();
                    assert!(found == wanted, "{n} {count} {budget} {is_small}");
                }
                assert!(large(&mut kept(&volume), &options, budget, &b).unwrap() == wanted, "{n} {count} {budget}");
            }
            // A single sample of nothing is something.
            let mut wrong = coded(&volume, true);
            let empty = wrong.values.iter().position(|&value| value <= 1.0).unwrap();
            wrong.values[empty] = 160.0;
            planted += usize::from(large(&mut wrong, &options, 1 << 30, &b).unwrap() != wanted);
        }
    }
    assert!(planted >= 15, "{planted}");
}

#[test]
fn a_transfer_function_of_its_own_scale_needs_no_look_before_the_voxels_and_knows_the_values_after_them() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.vxt");
    let volume = lump([40, 50, 33], true);
    let options = VolumeOptions { transfer: Some(Preset::CtBone.transfer()), ..VolumeOptions::default() };
    let progress = VoxelizeProgress::default();
    for budget in [1, 1 << 30] {
        for mut source in [kept(&volume), coded(&volume, false)] {
            let mut survey = Survey::of(&mut source, &options, Some(budget), &progress).unwrap();
            assert!(survey.values().is_none() && source.reads == 0);
            let how = (&options, Some(budget));
            voxelize_large_volume_to_file((&mut source, ""), &mut survey, how, &Limits::default(), &path, &progress)
                .unwrap();
            let (values, wanted) = (survey.values().unwrap(), volume.statistics());
            assert_eq!(
                (values.lowest, values.highest, &values.labels),
                (wanted.lowest, wanted.highest, &wanted.labels)
            );
            let above = volume.values.iter().filter(|&&value| value >= 100.0).count();
            assert_eq!(survey.share_from(100.0), Some(above as f64 / volume.values.len() as f64));
        }
    }
    let mut source = kept(&volume);
    Survey::of(&mut source, &VolumeOptions::default(), None, &progress).unwrap();
    assert_eq!(source.reads, 33, "the automatic one does");
}

#[test]
fn a_layer_that_cannot_be_read_ends_the_work_with_its_error() {
    struct Broken(Kept);
    impl SampleSource for Broken {
        fn frame(&self) -> &Volume {
            &self.0.frame
        }

        fn frame_mut(&mut self) -> &mut Volume {
            &mut self.0.frame
        }

        fn read(&mut self, layer: usize, rows: Range<usize>, block: &mut Block) -> Result<(), ImportError> {
            if layer == 17 {
                Err(ImportError::malformed(Path::new("x.raw"), 17, "a layer"))
            } else {
                self.0.read(layer, rows, block)
            }
        }
    }
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.vxt");
    let progress = VoxelizeProgress::default();
    let mut source = Broken(kept(&lump([40, 50, 33], true)));
    let error = Survey::of(&mut source, &VolumeOptions::default(), None, &progress).unwrap_err();
    assert!(error.to_string().contains("a layer"), "{error}");
    let options = VolumeOptions { transfer: Some(Preset::CtBone.transfer()), ..VolumeOptions::default() };
    let mut survey = Survey::of(&mut source, &options, None, &progress).unwrap();
    let work = ((&mut source as &mut dyn SampleSource, ""), &mut survey, (&options, None));
    let error =
        voxelize_large_volume_to_file(work.0, work.1, work.2, &Limits::default(), &path, &progress).unwrap_err();
    assert!(error.to_string().contains("a layer") && !path.exists(), "{error}");
}

#[test]
fn what_is_no_finite_number_is_not_seen_and_spoils_no_other_voxel() {
    let folder = tempfile::tempdir().unwrap();
    let (a, b) = (folder.path().join("a.vxt"), folder.path().join("b.vxt"));
    let mut volume = lump([70, 41, 37], false);
    let finite = volume.clone();
    for (n, value) in volume.values.iter_mut().enumerate() {
        match n.wrapping_mul(2_654_435_761) >> 16 & 0xfff {
            0 => *value = f32::NAN,
            1 => *value = f32::INFINITY,
            2 => *value = f32::NEG_INFINITY,
            _ => {}
        }
    }
    for (k, count) in [70, 48, 35, 19, 83].into_iter().enumerate() {
        let transfer = (k % 2 == 0).then(|| Preset::Surface.transfer());
        let options = VolumeOptions { scale: Some(Scale::Resolution(count)), transfer, ..VolumeOptions::default() };
        let wanted = in_memory(&volume, &options, &a);
        assert!(large(&mut kept(&volume), &options, 1 << 30, &b).unwrap() == wanted, "{count}");
        assert!(large(&mut kept(&finite), &options, 1 << 30, &b).unwrap() != wanted, "{count}");
    }
}
