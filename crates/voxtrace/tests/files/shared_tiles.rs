//! Tiles of a scan that several processes voxelize: the bytes that one process writes, however files are shared among them and in
//! whichever order what they have found comes together; and what is missing, doubled, damaged or of other work is told.

use crate::meshes::Random;
use crate::point_samples::{Point, las, laz, options};
use crate::tiles::with_bounds;
use std::ops::Range;
use std::path::{Path, PathBuf};
use voxtrace::import::{self, ImportOptions, Limits, PointFilter, READERS, TiledCloud};
use voxtrace::mesh::UpAxis;
use voxtrace::points::ColorBy;
use voxtrace::voxelize::large_points::{TileSurvey, joined_bytes};
use voxtrace::voxelize::{PointOptions, Scale, VoxelizeError, VoxelizeOptions, VoxelizeProgress};

/// A scan of six files: two halves, one that lies over both, one whose points have no colours and no classes, one of dark points whose
/// 16 bits look like bytes, and one without points.
fn scan(folder: &Path) {
    let mut random = Random(3);
    let mut points = |count: usize, low: i32, width: usize| -> Vec<Point> {
        let mut point = |_| {
            let place = [low + random.below(width) as i32, random.below(300) as i32, random.below(90) as i32];
            let color = [random.below(256) as u8, random.below(16) as u8, 1 + random.below(2) as u8];
            (place, color, random.below(3000) as u16, 1 + random.below(9) as u8)
        };
        (0..count).map(&mut point).collect()
    };
    let (west, east, over) = (points(4000, 0, 160), points(5000, 160, 160), points(3000, 40, 200));
    let bare: Vec<Point> = points(2000, 300, 60).iter().map(|&(place, ..)| (place, [0; 3], 0, 0)).collect();
    let dark: Vec<Point> = points(1500, 340, 60).iter().map(|&(place, _, i, c)| (place, [1, 0, 0], i, c)).collect();
    for (name, bytes) in [
        ("1.las", with_bounds(las(&west, (2, 3)))),
        ("2.laz", with_bounds(laz(&east, (4, 7)))),
        ("3.laz", with_bounds(laz(&over, (2, 3)))),
        ("4.las", with_bounds(las(&bare, (2, 2)))),
        ("5.las", las(&[], (2, 2))),
        ("10.laz", with_bounds(laz(&dark, (2, 3)))),
    ] {
        std::fs::write(folder.join(name), bytes).unwrap();
    }
}

/// Work with a scan, each step by a process that knows of no other.
struct Work<'a> {
    folder: &'a Path,
    import: ImportOptions,
    options: VoxelizeOptions,
}

const PROGRESS: fn() -> VoxelizeProgress = VoxelizeProgress::default;

impl Work<'_> {
    fn cloud(&self) -> TiledCloud {
        let paths = [self.folder.to_path_buf()];
        READERS.open_all(&paths, &self.import).unwrap().open_tiled().unwrap()
    }

    fn survey(&self, shares: &[Range<usize>]) -> Vec<u8> {
        let survey = |files: &Range<usize>| {
            self.cloud().survey(files.clone(), &self.options, &PROGRESS()).map(|mut survey| survey.to_bytes()).unwrap()
        };
        // In two steps, from the last one on.
        let found: Vec<Vec<u8>> = shares.iter().rev().map(survey).collect();
        let (some, others) = found.split_at(found.len() / 2);
        let mut all = join(others);
        if !some.is_empty() {
            all = join(&[join(some), all]);
        }
        if read(&all).wants_measures(&self.options).unwrap() {
            let measure = |files: &Range<usize>| {
                self.cloud().measure(&read(&all), files.clone(), &self.options, &PROGRESS()).unwrap()
            };
            let measured: Vec<Vec<u8>> = shares.iter().map(measure).collect();
            all = join(&[join(&measured), all]);
            assert!(!read(&all).wants_measures(&self.options).unwrap());
        }
        all
    }

    fn part(&self, survey: &[u8], files: Range<usize>) -> Result<PathBuf, VoxelizeError> {
        self.part_and_found(survey, files).map(|(path, _)| path)
    }

    fn part_and_found(&self, survey: &[u8], files: Range<usize>) -> Result<(PathBuf, Option<Vec<u8>>), VoxelizeError> {
        let path = self.folder.join(format!("{}-{}.part", files.start, files.end));
        let part =
            self.cloud().voxelize(&read(survey), files, &self.options, &Limits::default(), &path, &PROGRESS())?;
        Ok((path, part.found.map(|mut found| found.to_bytes())))
    }

    fn expected(&self) -> Option<Vec<u8>> {
        self.cloud().expected(&self.options).unwrap().map(|mut expected| expected.to_bytes())
    }

    /// Reads each file once; whether what was expected is borne out, and the scene: of those parts, or of ones that are made with what they have found.
    fn shared_once(&self, shares: &[Range<usize>]) -> (bool, Vec<u8>) {
        let expected = self.expected().unwrap();
        let made = shares.iter().rev().map(|files| self.part_and_found(&expected, files.clone()).unwrap());
        let (parts, found): (Vec<PathBuf>, Vec<Option<Vec<u8>>>) = made.unzip();
        let found: Vec<Vec<u8>> = found.into_iter().map(Option::unwrap).collect();
        let mut survey = read(&join(&found));
        let is_so = survey.bear_out(&read(&expected), &self.options).unwrap();
        let survey = survey.to_bytes();
        let refused = self.merge(&expected, &parts).unwrap_err().to_string();
        assert!(refused.contains("is not held against"), "{refused}");
        if is_so {
            return (true, self.merge(&survey, &parts).unwrap());
        }
        let refused = self.merge(&survey, &parts).unwrap_err().to_string();
        assert!(refused.contains("no part of these files with these options"), "{refused}");
        let parts: Vec<PathBuf> = shares.iter().map(|files| self.part(&survey, files.clone()).unwrap()).collect();
        (false, self.merge(&survey, &parts).unwrap())
    }

    fn merge(&self, survey: &[u8], parts: &[PathBuf]) -> Result<Vec<u8>, VoxelizeError> {
        let out = self.folder.join("out.vxt");
        self.cloud().merge(&read(survey), parts, &self.options, &Limits::default(), &out, &PROGRESS())?;
        Ok(std::fs::read(out).unwrap())
    }

    fn shared(&self, shares: &[Range<usize>]) -> Result<Vec<u8>, VoxelizeError> {
        let survey = self.survey(shares);
        let parts: Result<Vec<PathBuf>, _> =
            shares.iter().rev().map(|files| self.part(&survey, files.clone())).collect();
        self.merge(&survey, &parts?)
    }

    fn alone(&self) -> Result<Vec<u8>, VoxelizeError> {
        let out = self.folder.join("alone.vxt");
        let mut large = import::open_large(self.folder, &self.import, 1).unwrap().unwrap();
        large.voxelize_to_file(&self.options, &Limits::default(), &out, &PROGRESS())?;
        Ok(std::fs::read(out).unwrap())
    }
}

fn join(found: &[Vec<u8>]) -> Vec<u8> {
    joined_bytes(found.iter().map(Vec::as_slice)).unwrap()
}

fn read(survey: &[u8]) -> TileSurvey {
    TileSurvey::from_bytes(survey).unwrap()
}

/// All files in one part.
fn in_one(count: usize) -> Vec<Range<usize>> {
    std::iter::once(0..count).collect()
}

fn one_each(count: usize) -> Vec<Range<usize>> {
    (0..count).map(|file| file..file + 1).collect()
}

#[test]
fn files_shared_in_any_way_make_the_bytes_of_one_process() {
    let folder = tempfile::tempdir().unwrap();
    scan(folder.path());
    let far = |x: f64| 691_000.0 + x;
    let bounds = format!("{},5335003,{},5335070", far(11.0), far(79.5)).parse().unwrap();
    let of_classes = PointFilter { classes: Some("1,2,3,4".parse().unwrap()), bounds: None };
    let in_box = PointFilter { classes: None, bounds: Some(bounds) };
    let (all, palette) = (PointFilter::default(), VoxelizeOptions::default().max_materials);
    for (points, up, color_by, scale, min_points, max_materials) in [
        (all, None, ColorBy::Auto, Scale::VoxelSize(0.5), 1, palette),
        (all, None, ColorBy::Auto, Scale::VoxelSize(2.0), 3, 16),
        (all, None, ColorBy::Intensity, Scale::Automatic, 1, palette),
        (all, Some(UpAxis::MinusY), ColorBy::Height, Scale::Resolution(200), 1, palette),
        (of_classes, None, ColorBy::Height, Scale::Automatic, 2, palette),
        (in_box, Some(UpAxis::X), ColorBy::Classification, Scale::Automatic, 1, palette),
    ] {
        let import = ImportOptions { points, up, ..ImportOptions::default() };
        let plain = VoxelizeOptions { max_materials, ..options(scale, PointOptions { color_by, min_points }) };
        let mut work = Work { folder: folder.path(), import, options: plain };
        let (alone, count) = (work.alone().unwrap(), work.cloud().points_of_tiles().len());
        assert!((4..=6).contains(&count));
        for (shares, memory_budget) in
            [(one_each(count), None), (vec![0..2, 2..3, 3..count], Some(1)), (in_one(count), Some(1 << 20))]
        {
            work.options.memory_budget = memory_budget;
            assert!(work.shared(&shares).unwrap() == alone, "{shares:?} {plain:?} {up:?}");
        }
        let notes = |files: &mut TiledCloud| files.notes().to_vec();
        let mut cloud = work.cloud();
        cloud.check(&read(&work.survey(&one_each(count))), &work.options).unwrap();
        let mut large = import::open_large(folder.path(), &work.import, 1).unwrap().unwrap();
        large.survey(&plain, &PROGRESS()).unwrap();
        assert_eq!(notes(&mut cloud), large.notes());
    }
}

#[test]
fn files_that_are_read_once_make_the_bytes_of_one_process() {
    let folder = tempfile::tempdir().unwrap();
    scan(folder.path());
    for (scale, color_by, min_points) in [
        (Scale::VoxelSize(0.5), ColorBy::Auto, 1),
        (Scale::VoxelSize(2.0), ColorBy::Rgb, 3),
        (Scale::Resolution(200), ColorBy::Classification, 1),
    ] {
        let plain = options(scale, PointOptions { color_by, min_points });
        let mut work = Work { folder: folder.path(), import: ImportOptions::default(), options: plain };
        let alone = work.alone().unwrap();
        for (shares, memory_budget) in
            [(one_each(6), None), (vec![0..2, 2..3, 3..6], Some(1)), (in_one(6), Some(1 << 20))]
        {
            work.options.memory_budget = memory_budget;
            assert!(work.shared_once(&shares) == (true, alone.clone()), "{shares:?} {plain:?}");
        }
    }
    // Where all points decide something, nothing is expected.
    let some = PointFilter { classes: Some("1,2".parse().unwrap()), bounds: None };
    let (all, size) = (PointFilter::default(), Scale::VoxelSize(0.5));
    for (points, up, color_by, scale) in [
        (all, None, ColorBy::Auto, Scale::Automatic),
        (all, None, ColorBy::Height, size),
        (all, None, ColorBy::Intensity, size),
        (all, Some(UpAxis::X), ColorBy::Auto, size),
        (some, None, ColorBy::Auto, size),
    ] {
        let import = ImportOptions { points, up, ..ImportOptions::default() };
        let plain = options(scale, PointOptions { color_by, min_points: 1 });
        assert!(Work { folder: folder.path(), import, options: plain }.expected().is_none(), "{plain:?}");
    }
}

#[test]
fn headers_and_first_points_that_mislead_are_seen_and_cost_a_second_reading() {
    let folder = tempfile::tempdir().unwrap();
    let plain = options(Scale::VoxelSize(0.5), PointOptions::default());
    let work = Work { folder: folder.path(), import: ImportOptions::default(), options: plain };
    // The bounds that a header says: wider ones matter where they are those of all.
    let bounds = |name: &str, change: &dyn Fn(usize, f64) -> f64| {
        let path = folder.path().join(name);
        let mut bytes = std::fs::read(&path).unwrap();
        for number in 0..6 {
            let at = 179 + 8 * number;
            let value = f64::from_le_bytes(bytes[at..at + 8].try_into().unwrap());
            bytes[at..at + 8].copy_from_slice(&change(number, value).to_le_bytes());
        }
        std::fs::write(path, bytes).unwrap();
    };
    let shares = [0..2, 2..3, 3..6];
    let narrow = |number: usize, value: f64| if number == 0 { value - 5.0 } else { value };
    let wide = |number: usize, value: f64| if number == 1 { value - 50.0 } else { value };
    let inner = |number: usize, value: f64| if number == 0 { value + 3.0 } else { value };
    for (name, change, is_so) in [
        // A brick of a neighbour would have been taken for one that only its own file reaches.
        ("2.laz", &narrow as &dyn Fn(usize, f64) -> f64, false),
        ("1.las", &wide, false),
        // More seams than there are.
        ("1.las", &inner, true),
    ] {
        scan(folder.path());
        bounds(name, change);
        let alone = work.alone().unwrap();
        assert!(work.shared_once(&shares) == (is_so, alone), "{name}");
    }
    // The first points are dark, so that their colours look like bytes.
    scan(folder.path());
    let mut points: Vec<Point> = (0..6000).map(|i| ([i % 300, i / 300, 5], [1, 0, 0], 7, 1)).collect();
    let bytes = |points: &[Point]| {
        let mut bytes = las(points, (2, 2));
        // 16 bits, none above 255.
        for record in bytes[227..].chunks_exact_mut(26).take(5500) {
            record[20..26].copy_from_slice(&[200, 0, 90, 0, 0, 0]);
        }
        with_bounds(bytes)
    };
    std::fs::write(folder.path().join("1.las"), bytes(&points)).unwrap();
    assert!(!work.shared_once(&shares).0, "the last of them are bright");
    assert!(work.shared_once(&shares).1 == work.alone().unwrap());
    points.truncate(5500);
    std::fs::write(folder.path().join("1.las"), bytes(&points)).unwrap();
    assert!(work.shared_once(&shares) == (true, work.alone().unwrap()));
}

#[test]
fn points_are_shared_evenly_among_parts() {
    let folder = tempfile::tempdir().unwrap();
    scan(folder.path());
    let plain = options(Scale::VoxelSize(0.5), PointOptions::default());
    let work = Work { folder: folder.path(), import: ImportOptions::default(), options: plain };
    let mut cloud = work.cloud();
    assert_eq!(cloud.points_of_tiles(), [4000, 5000, 3000, 2000, 0, 1500]);
    assert_eq!(cloud.shares(1), in_one(6));
    assert_eq!(cloud.shares(2), [0..2, 2..6]);
    assert_eq!(cloud.shares(3), [0..2, 2..3, 3..6]);
    let many = cloud.shares(100);
    assert!(many.len() <= 6 && many.iter().flat_map(Range::clone).eq(0..6), "{many:?}");
}

#[test]
fn what_is_missing_doubled_damaged_or_of_other_work_is_told() {
    let folder = tempfile::tempdir().unwrap();
    scan(folder.path());
    let plain = options(Scale::VoxelSize(0.5), PointOptions::default());
    let mut work = Work { folder: folder.path(), import: ImportOptions::default(), options: plain };
    let survey = work.survey(&one_each(6));
    let parts: Vec<PathBuf> = [0..2, 2..3, 3..6].map(|files| work.part(&survey, files).unwrap()).into();
    let whole = work.merge(&survey, &parts).unwrap();
    let told = |found: Result<Vec<u8>, VoxelizeError>, wanted: &str| {
        let error = found.expect_err(wanted).to_string();
        assert!(error.contains(wanted), "{error}");
    };
    told(work.merge(&survey, &parts[..2]), "files 3..6 of 6 are in no part");
    told(work.merge(&survey, &parts[1..]), "files 0..2 of 6 are in no part");
    let doubled = work.part(&survey, 1..3).unwrap();
    told(work.merge(&survey, &[parts.clone(), vec![doubled]].concat()), "are in another part, too");
    let good = std::fs::read(&parts[1]).unwrap();
    for at in (0..good.len()).step_by(good.len() / 40).chain([good.len() - 1]) {
        let mut bytes = good.clone();
        bytes[at] ^= 1;
        std::fs::write(&parts[1], &bytes).unwrap();
        told(work.merge(&survey, &parts), "2-3.part: ");
        std::fs::write(&parts[1], &good[..at]).unwrap();
        told(work.merge(&survey, &parts), "2-3.part: ");
    }
    std::fs::write(&parts[1], &good).unwrap();
    assert!(work.merge(&survey, &parts).unwrap() == whole);

    // Other options, a survey of some files, one that wants measures, other files.
    work.options.points.min_points = 2;
    told(work.merge(&survey, &parts), "with other options");
    let other = work.survey(&one_each(6));
    told(work.merge(&other, &parts), "no part of these files with these options");
    let some = work.cloud().survey(0..3, &work.options, &PROGRESS()).map(|mut survey| survey.to_bytes()).unwrap();
    told(work.merge(&some, &parts), "file 3 of 6 was not surveyed");
    let twice = joined_bytes([&some[..], &some]).map(drop).unwrap_err().to_string();
    assert!(twice.contains("file 0 is in two surveys"), "{twice}");
    assert!(joined_bytes([&some[..], &survey]).is_err() && joined_bytes([&some[1..]]).is_err());
    work.options.points.color_by = ColorBy::Height;
    let heights = work.cloud().survey(0..6, &work.options, &PROGRESS()).map(|mut survey| survey.to_bytes()).unwrap();
    let error = work.part(&heights, 0..1).unwrap_err().to_string();
    assert!(error.contains("wants measures"), "{error}");
    let half = work.cloud().measure(&read(&heights), 0..3, &work.options, &PROGRESS()).unwrap();
    let error = joined_bytes([&heights[..], &half]).map(drop).unwrap_err().to_string();
    assert!(error.contains("file 3 of 6 was not measured"), "{error}");
    assert!(work.cloud().survey(4..7, &work.options, &PROGRESS()).is_err());
    std::fs::remove_file(folder.path().join("10.laz")).unwrap();
    told(work.merge(&heights, &parts), "of other files");

    // A tile whose points are damaged is named, whoever reads it.
    let path = folder.path().join("2.laz");
    let mut bytes = std::fs::read(&path).unwrap();
    let middle = bytes.len() / 2;
    bytes[middle..middle + 400].fill(0xa5);
    std::fs::write(&path, bytes).unwrap();
    let paths = [folder.path().to_path_buf()];
    let error = READERS.open_all(&paths, &work.import).unwrap().open_tiled().map(drop).unwrap_err();
    assert!(error.path.ends_with("2.laz"), "{error}");
}
