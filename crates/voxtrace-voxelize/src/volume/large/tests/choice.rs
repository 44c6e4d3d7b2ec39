//! What is shown of a volume that is read layer by layer is what is shown of the same volume in memory.

use super::*;

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
    let (limits, progress) = (Limits::default(), VoxelizeProgress::default());
    let orders = [[0, 1, 2], [2, 0, 1], [1, 2, 0]];
    for (n, order) in orders.into_iter().enumerate() {
        // Many layers of samples under one of voxels, few, and such far apart that voxels lie between them.
        for (size, count, apart) in [([50, 41, 37], 11, 1.0), ([50, 41, 37], 17, 1.0), ([50, 41, 9], 15, 7.0)] {
            for are_whole in [true, false] {
                let mut volume = placed(sparks(size, are_whole), order, [n == 0, n != 1, n == 2]);
                volume.world_from_index.matrix3.z_axis *= apart;
                let options = VolumeOptions { scale: Some(Scale::Resolution(count)), ..VolumeOptions::default() };
                let wanted = in_memory(&volume, &options, &a);
                let threshold = crate::volume::threshold_of_voxels(&volume, &options, &limits).unwrap();
                let sources = [Some(kept(&volume)), are_whole.then(|| coded(&volume, false))];
                for mut source in sources.into_iter().flatten() {
                    for budget in [1, 3_000, 1 << 30] {
                        let how = (&options, Some(budget));
                        let mut survey = Survey::of(&mut source, how.0, how.1, &progress).unwrap();
                        let empty = large(&mut source, &options, budget, &b).unwrap_err();
                        assert!(matches!(empty, VoxelizeError::Volume(VolumeError::Empty { .. })), "{empty}");
                        let lowered = survey.lower(&mut source, how.0, how.1, &progress).unwrap();
                        let bright = survey.values().unwrap().bright;
                        let context = format!("{order:?} {count} {are_whole} {budget}");
                        assert_eq!((lowered, bright), (Some(threshold), volume.statistics().bright), "{context}");
                        let read = (&mut source as &mut dyn SampleSource, "stamp");
                        voxelize_large_volume_to_file(read, &mut survey, how, &limits, &b, &progress).unwrap();
                        assert!(resaved(&b) == wanted, "{context}");
                    }
                    // Other samples have another one.
                    let mut survey = Survey::of(&mut source, &options, None, &progress).unwrap();
                    let half = source.values.len() / 2;
                    source.values[..half].fill(1e3);
                    let other = survey.lower(&mut source, &options, None, &progress).unwrap();
                    assert!(other.is_some_and(|other| other != threshold), "{order:?} {count} {are_whole}");
                }
            }
        }
    }
}

#[test]
fn nothing_is_lowered_where_the_options_choose_what_is_shown() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.vxt");
    let progress = VoxelizeProgress::default();
    let volume = sparks([50, 41, 37], true);
    let chosen = [
        (Some(Preset::CtBone.transfer()), Some(500.0)),
        (Some(Preset::Mri.transfer()), None),
        (Some(Preset::Surface.transfer()), Some(890.0)),
        (None, Some(400.0)),
    ];
    for (transfer, threshold) in chosen {
        let scale = Some(Scale::Resolution(11));
        let options = VolumeOptions { scale, transfer, threshold, ..VolumeOptions::default() };
        let mut source = kept(&volume);
        let mut survey = Survey::of(&mut source, &options, None, &progress).unwrap();
        let own = survey.transfer().clone();
        let work = ((&mut source as &mut dyn SampleSource, ""), &mut survey, (&options, None));
        let error = voxelize_large_volume_to_file(work.0, work.1, work.2, &Limits::default(), &path, &progress);
        assert!(matches!(error, Err(VoxelizeError::Volume(VolumeError::Empty { .. }))));
        let reads = source.reads;
        assert_eq!(survey.lower(&mut source, &options, None, &progress).unwrap(), None);
        assert!(survey.transfer() == &own && source.reads == reads);
    }
    let options = VolumeOptions { scale: Some(Scale::Resolution(11)), ..VolumeOptions::default() };
    let mut source = kept(&volume);
    let mut survey = Survey::of(&mut source, &options, None, &progress).unwrap();
    assert!(survey.lower(&mut source, &options, None, &progress).unwrap().is_some(), "else it is");
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
