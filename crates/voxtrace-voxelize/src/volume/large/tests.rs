//! A volume that is read layer by layer becomes the file of the same volume in memory, whichever way it lies and however it is cut.

use super::super::{Preset, voxelize};
use super::*;
use crate::voxelize::Scale;
use glam::{DAffine3, DMat3, DVec3};
use voxtrace_core::packed::PackedScene;

/// Samples in memory that are read as those of a file, and how many were.
struct Kept {
    frame: Volume,
    values: Vec<f32>,
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

    fn read(&mut self, layer: usize, rows: Range<usize>, values: &mut [f32]) -> Result<(), ImportError> {
        let [width, depth, _] = self.frame.size;
        let start = (layer * depth + rows.start) * width;
        values.copy_from_slice(&self.values[start..start + rows.len() * width]);
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
    Kept { frame, values: volume.values.clone(), reads: 0, stop: None }
}

fn in_memory(volume: &Volume, options: &VolumeOptions, path: &Path) -> Vec<u8> {
    let scene = voxelize(volume, options, &Limits::default()).unwrap();
    PackedScene::pack_merged(&scene).unwrap().save(path).unwrap();
    std::fs::read(path).unwrap()
}

fn large(source: &mut Kept, options: &VolumeOptions, budget: u64, path: &Path) -> Result<Vec<u8>, VoxelizeError> {
    let progress = source.stop.as_ref().map_or_else(Default::default, |(_, progress)| progress.clone());
    let survey = Survey::of(source, options, Some(budget), &VoxelizeProgress::default())?;
    source.reads = 0;
    let options = (options, Some(budget));
    voxelize_large_volume_to_file((source, "stamp"), &survey, options, &Limits::default(), path, &progress)?;
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
        let survey = Survey::of(&mut kept(&volume), &options, Some(budget), &VoxelizeProgress::default()).unwrap();
        let stopped = source.stop.clone().unwrap().1;
        let result = voxelize_large_volume_to_file(
            (&mut source, "stamp"),
            &survey,
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
    let survey = Survey::of(&mut source, &options, None, &VoxelizeProgress::default()).unwrap();
    let progress = VoxelizeProgress::default();
    let result = voxelize_large_volume_to_file((&mut source, ""), &survey, (&options, None), &few, &b, &progress);
    assert!(matches!(result, Err(VoxelizeError::TooLarge { what: "voxels", .. })));
}

/// Few bright samples in what is dark and rough, so that coarse voxels do not reach the threshold of the samples.
fn sparks(size: [usize; 3], are_whole: bool) -> Volume {
    let value = |n: usize| {
        let noise = ((n as u32).wrapping_mul(2_654_435_761) >> 20) as f32 / 40.0;
        let value = if n % 211 == 17 { 900.0 - noise } else { noise };
        if are_whole { value.round() } else { value }
    };
    Volume { name: "sparks".into(), ..Volume::new(size, (0..size.iter().product()).map(value).collect()) }
}

#[test]
fn voxels_that_do_not_reach_the_threshold_are_shown_from_the_same_one_on_as_in_memory() {
    let folder = tempfile::tempdir().unwrap();
    let (a, b) = (folder.path().join("a.vxt"), folder.path().join("b.vxt"));
    let orders = [[0, 1, 2], [2, 0, 1], [1, 2, 0]];
    for (n, order) in orders.into_iter().enumerate() {
        for are_whole in [true, false] {
            let volume = placed(sparks([50, 41, 37], are_whole), order, [n == 0, n != 1, n == 2]);
            let options = VolumeOptions { scale: Some(Scale::Resolution(11)), ..VolumeOptions::default() };
            let wanted = in_memory(&volume, &options, &a);
            let threshold = super::super::threshold_of_voxels(&volume, &options, &Limits::default()).unwrap();
            for budget in [1, 3_000, 1 << 30] {
                let mut source = kept(&volume);
                let progress = VoxelizeProgress::default();
                let mut survey = Survey::of(&mut source, &options, Some(budget), &progress).unwrap();
                let empty = large(&mut source, &options, budget, &b).unwrap_err();
                assert!(matches!(empty, VoxelizeError::Volume(VolumeError::Empty { .. })), "{empty}");
                let lowered = survey.lower(&mut source, &options, Some(budget), &progress).unwrap();
                assert_eq!(
                    (lowered, survey.values.bright),
                    (threshold, volume.statistics().bright),
                    "{order:?} {budget}"
                );
                let how = (&options, Some(budget));
                let limits = Limits::default();
                voxelize_large_volume_to_file((&mut source, "stamp"), &survey, how, &limits, &b, &progress).unwrap();
                assert!(resaved(&b) == wanted, "{order:?} {are_whole} {budget}");
                // Other samples have another one.
                source.values[..37 * 41 * 25].fill(1e3);
                assert_ne!(survey.lower(&mut source, &options, Some(budget), &progress).unwrap(), threshold);
            }
        }
    }
}

#[test]
fn the_function_that_suits_is_the_same_layer_by_layer() {
    let lump = lump([40, 30, 33], false);
    let with = |change: &dyn Fn(f32) -> f32, suited: Option<Preset>, is_labels: bool| {
        let values = lump.values.iter().map(|&value| change(value)).collect();
        Volume { suited, is_labels, values, ..Volume::new(lump.size, Vec::new()) }
    };
    let mut chosen = Vec::new();
    for volume in [
        with(&|value| value, None, false),
        with(&f32::round, None, false),
        with(&|value| (value / 60.0).round().max(0.0), None, false),
        with(&|value| (value * 7.0).round(), None, true),
        with(&|value| value * 4.0 - 300.0, None, false),
        with(&|value| value, Some(Preset::CtBone), false),
        with(&|value| value * 0.1, Some(Preset::CtBone), false),
        with(&|value| value, Some(Preset::Fog), false),
        with(&|value| value, Some(Preset::Surface), false),
        with(&|value| if value > 390.0 { f32::NAN } else { value }, None, false),
        with(&|_| 5.0, None, false),
        with(&|_| 5.5, None, false),
        sparks([50, 41, 37], true),
        sparks([50, 41, 37], false),
    ] {
        let values = volume.statistics();
        let mut wanted = Transfer::automatic(&values);
        wanted.resolve(&values, None);
        for budget in [1, 5_000, 1 << 30] {
            let options = VolumeOptions::default();
            let survey = Survey::of(&mut kept(&volume), &options, Some(budget), &VoxelizeProgress::default()).unwrap();
            assert_eq!(survey.transfer(), &wanted, "{budget}");
        }
        chosen.push(wanted);
    }
    // Each kind is among them, and functions of one kind differ by their scale.
    let mut names: Vec<&str> = chosen.iter().map(|transfer| transfer.name.as_str()).collect();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names, ["ct-bone", "fog", "labels", "mri", "surface"]);
    assert_ne!(chosen[0], chosen[1]);
}
