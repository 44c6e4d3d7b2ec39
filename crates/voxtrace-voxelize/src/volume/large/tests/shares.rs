//! Layers of bricks that are shared among processes make the file of one process; what is missing, damaged or of other work is told.

use super::super::super::Preset;
use super::*;
use std::path::PathBuf;

/// Work with a volume, each step by a source of its own.
struct Shared<'a> {
    make: &'a dyn Fn() -> Kept,
    options: &'a VolumeOptions,
    folder: &'a Path,
    budget: Option<u64>,
}

impl Shared<'_> {
    fn survey(&self, shares: &[Range<usize>]) -> Vec<u8> {
        let (progress, frame) = (VoxelizeProgress::default(), (self.make)().frame);
        let looks: Vec<Vec<u8>> = shares
            .iter()
            .rev()
            .map(|layers| Survey::look(&mut (self.make)(), layers.clone(), self.budget, &progress).unwrap())
            .collect();
        let mut binned = |low, high| {
            let counts = shares.iter().map(|layers| {
                Survey::count(&mut (self.make)(), (layers.clone(), low, high), self.budget, &progress).unwrap()
            });
            Ok(counts.reduce(|a, b| a.iter().zip(b).map(|(a, b)| a + b).collect()).unwrap())
        };
        let survey = Survey::of_looks(&frame, self.options, looks.iter().map(Vec::as_slice), &mut binned).unwrap();
        survey.to_bytes()
    }

    fn read(&self, survey: &[u8]) -> Survey {
        Survey::from_bytes(survey, &(self.make)().frame, self.options).unwrap()
    }

    fn part(&self, survey: &[u8], layers: Range<usize>) -> Result<PathBuf, VoxelizeError> {
        let path = self.folder.join(format!("{}-{}.part", layers.start, layers.end));
        let survey = self.read(survey);
        let (options, progress) = ((self.options, self.budget), VoxelizeProgress::default());
        let source = &mut (self.make)();
        voxelize_volume_part((source, "stamp"), &survey, layers, options, &Limits::default(), &path, &progress)?;
        Ok(path)
    }

    fn merge(&self, survey: &[u8], parts: &[PathBuf]) -> Result<Vec<u8>, VoxelizeError> {
        let (out, survey) = (self.folder.join("out.vxt"), self.read(survey));
        let (frame, progress) = ((self.make)().frame, VoxelizeProgress::default());
        merge_volume_parts((&frame, "stamp"), &survey, parts, self.options, &Limits::default(), &out, &progress)?;
        Ok(std::fs::read(out).unwrap())
    }

    fn alone(&self) -> Vec<u8> {
        let (source, out) = (&mut (self.make)(), self.folder.join("alone.vxt"));
        let progress = VoxelizeProgress::default();
        let mut survey = Survey::of(source, self.options, self.budget, &progress).unwrap();
        let options = (self.options, self.budget);
        voxelize_large_volume_to_file((source, "stamp"), &mut survey, options, &Limits::default(), &out, &progress)
            .unwrap();
        std::fs::read(out).unwrap()
    }

    fn layers(&self, survey: &[u8]) -> usize {
        layers_of_bricks(&(self.make)().frame, &self.read(survey), self.options).unwrap()
    }
}

fn in_runs(count: usize, run: usize) -> Vec<Range<usize>> {
    (0..count).step_by(run).map(|start| start..(start + run).min(count)).collect()
}

#[test]
fn layers_shared_in_any_way_make_the_file_of_one_process() {
    let folder = tempfile::tempdir().unwrap();
    let (whole, real) = (lump([40, 33, 61], true), lump([40, 33, 61], false));
    let turned = placed(lump([30, 37, 50], false), [2, 0, 1], [true, false, true]);
    let backwards = placed(lump([31, 20, 70], true), [0, 1, 2], [false, true, true]);
    let plain = VolumeOptions::default();
    let given = VolumeOptions { transfer: Some(Preset::CtBone.transfer()), threshold: Some(80.0), ..plain.clone() };
    let coarse = VolumeOptions { scale: Some(Scale::Resolution(29)), shell: false, ..plain.clone() };
    let fine = VolumeOptions { scale: Some(Scale::VoxelSize(0.3)), ..plain.clone() };
    let cases: [(&dyn Fn() -> Kept, &VolumeOptions); 8] = [
        (&|| kept(&whole), &plain),
        (&|| kept(&real), &plain),
        (&|| coded(&whole, false), &plain),
        (&|| kept(&real), &given),
        (&|| kept(&turned), &plain),
        (&|| kept(&turned), &fine),
        (&|| kept(&backwards), &coarse),
        (&|| coded(&backwards, false), &given),
    ];
    for (number, (make, options)) in cases.into_iter().enumerate() {
        let mut shared = Shared { make, options, folder: folder.path(), budget: None };
        let alone = shared.alone();
        let samples = make().frame.size[2];
        for (run, budget) in [(1, None), (3, Some(1)), (100, Some(40_000))] {
            shared.budget = budget;
            let survey = shared.survey(&in_runs(samples, 7 * run));
            let shares = in_runs(shared.layers(&survey), run);
            let parts: Vec<PathBuf> =
                shares.iter().rev().map(|layers| shared.part(&survey, layers.clone()).unwrap()).collect();
            assert!(shared.merge(&survey, &parts).unwrap() == alone, "case {number}, {run}");
        }
    }
}

#[test]
fn a_part_reads_no_more_than_its_layers_need() {
    let folder = tempfile::tempdir().unwrap();
    let volume = lump([16, 16, 160], false);
    let options = VolumeOptions { transfer: Some(Preset::CtBone.transfer()), ..VolumeOptions::default() };
    let survey = Survey::without_values(&volume, &options).unwrap().unwrap();
    let mut source = kept(&volume);
    let (work, progress) = ((&options, None), VoxelizeProgress::default());
    let path = folder.path().join("a.part");
    voxelize_volume_part((&mut source, ""), &survey, 5..7, work, &Limits::default(), &path, &progress).unwrap();
    assert_eq!(source.reads, 18, "two layers of bricks and one of voxels at either side");
}

#[test]
fn what_is_missing_damaged_of_other_work_or_empty_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let volume = lump([20, 20, 40], true);
    let options = VolumeOptions::default();
    let shared = Shared { make: &|| kept(&volume), options: &options, folder: folder.path(), budget: None };
    let survey = shared.survey(&in_runs(40, 11));
    let count = shared.layers(&survey);
    let parts: Vec<PathBuf> =
        in_runs(count, 2).into_iter().map(|layers| shared.part(&survey, layers).unwrap()).collect();
    let told = |found: Result<Vec<u8>, VoxelizeError>, wanted: &str| {
        let error = found.expect_err(wanted).to_string();
        assert!(error.contains(wanted), "{error}");
    };
    told(shared.merge(&survey, &parts[1..]), "layers 0..2 of 5 are in no part");
    told(shared.part(&survey, 4..6).map(|_| vec![]), "there are no layers 4..6 among 5");
    let other = VolumeOptions { threshold: Some(1.0), ..options.clone() };
    let other = Shared { options: &other, ..shared };
    told(other.merge(&survey, &parts), "no part of these layers with these options");
    for at in 0..survey.len() {
        let mut damaged = survey.clone();
        damaged[at] ^= 2;
        assert!(Survey::from_bytes(&damaged, &volume, &options).is_err(), "{at}");
    }
    // Nothing is so bright.
    let dark = VolumeOptions { transfer: Some(Preset::CtBone.transfer()), threshold: Some(9e6), ..options.clone() };
    let dark = Shared { options: &dark, ..other };
    let survey = dark.survey(&in_runs(40, 40));
    let part = dark.part(&survey, 0..5).unwrap();
    told(dark.merge(&survey, &[part]), "no sample is to be seen");
}
