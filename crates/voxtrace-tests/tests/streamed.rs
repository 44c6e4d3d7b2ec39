//! Files for streaming: they are the scene, whole and level by level, and scenes of their parts are what those levels are there.

use flate2::read::DeflateDecoder;
use std::collections::{HashMap, HashSet};
use std::io::Read;
use std::path::Path;
use voxtrace::glam::{IVec3, Mat3, Vec3};
use voxtrace::packed::{LevelCount, LevelProgress, LevelStep, Levels, rewrite_for_streaming};
use voxtrace::{Camera, Material, PackedScene, Scene, Transform, VoxelGrid};
use voxtrace_core::normals::Normals;
use voxtrace_core::packed::{StreamHead, StreamedLevels, WholeLevel};
use voxtrace_tests::random::Random;

/// Hills of many colours, lamps, glass and fog over several chunks, and a second grid that stands twice, turned and smaller.
fn scene() -> Scene {
    let mut random = Random(7);
    let mut grid = VoxelGrid::new();
    for x in -150..190 {
        for y in -140..150 {
            let height = ((x as f32 * 0.05).sin() * 20.0 + (y as f32 * 0.04).cos() * 15.0) as i32;
            grid.set(IVec3::new(x, y, height), random.below(20) as u16);
            if x % 37 == 0 && y % 29 == 0 {
                grid.set(IVec3::new(x, y, height + 40), 20);
            }
            if y == 11 {
                (0..30).for_each(|z| _ = grid.set(IVec3::new(x, y, height + z), 21 + (z > 20) as u16));
            }
        }
    }
    let mut materials: Vec<Material> =
        (0..20).map(|n| Material::diffuse(Vec3::new(0.04 * n as f32, 0.9 - 0.04 * n as f32, 0.3))).collect();
    materials.push(Material::emissive(Vec3::new(30.0, 20.0, 10.0)));
    materials.push(Material::glass(1.5, 0.0));
    materials.push(Material::cloud(Vec3::splat(0.8), 0.3, 0.2));
    let mut scene = Scene::from_grid("hills", grid, materials);
    let mut other = VoxelGrid::new();
    (0..9000).for_each(|n| _ = other.set(IVec3::new(n % 30 - 15, n / 30 % 150, n / 4500), (n % 21) as u16));
    let linear = Mat3::from_axis_angle(Vec3::new(0.3, 0.5, 0.8).normalize(), 0.7) * 0.5;
    scene.add_instance(other, Transform { linear, translation: Vec3::new(90.0, 5.0, 60.0) });
    let again = scene.instances[1].clone();
    let translation = Vec3::new(-90.0, 5.0, 60.0);
    scene.instances.push(voxtrace::Instance { world_from_grid: Transform { linear, translation }, ..again });
    scene.cameras = vec![Camera::look_at(Vec3::new(90.0, -300.0, 140.0), Vec3::ZERO)];
    scene
}

/// The sections of a file for streaming, read as `docs/format.md` tells.
struct File {
    bytes: Vec<u8>,
    places: HashMap<String, (usize, usize)>,
}

fn number<const N: usize>(bytes: &[u8], at: usize) -> u64 {
    (0..N).map(|byte| u64::from(bytes[at + byte]) << (8 * byte)).sum()
}

fn inflated(bytes: &[u8]) -> Vec<u8> {
    let mut inflated = Vec::new();
    DeflateDecoder::new(bytes).read_to_end(&mut inflated).unwrap();
    inflated
}

impl File {
    fn read(path: &Path) -> Self {
        let bytes = std::fs::read(path).unwrap();
        assert_eq!((&bytes[..8], number::<4>(&bytes, 8)), (&b"VOXTRACE"[..], 3));
        let place = |index: u64| {
            let at = 64 + 32 * index as usize;
            let (start, size) = (number::<8>(&bytes, at + 8) as usize, number::<8>(&bytes, at + 16) as usize);
            (String::from_utf8(bytes[at..at + 4].to_vec()).unwrap(), (start, start + size))
        };
        let places = (0..number::<4>(&bytes, 12)).map(place).collect();
        Self { bytes, places }
    }

    fn section(&self, tag: &str) -> &[u8] {
        let (start, end) = self.places[tag];
        &self.bytes[start..end]
    }

    fn levels(&self) -> u32 {
        self.places.keys().filter(|tag| tag.starts_with("FR")).count() as u32
    }

    fn front(&self, level: u32) -> Vec<u8> {
        inflated(self.section(&format!("FR{level:02}")))
    }

    /// The chunks of a level, inflated, with their grids and places.
    fn chunks(&self, level: u32) -> Vec<(u32, IVec3, Vec<u8>)> {
        let (front, section) = (self.front(level), self.section(&format!("CH{level:02}")));
        let table = (0..number::<4>(&front, 12) as usize).map(|index| 64 + 32 * index);
        let index = table.into_iter().find(|&at| &front[at..at + 4] == b"INDX").unwrap();
        let (start, size) = (number::<8>(&front, index + 8) as usize, number::<8>(&front, index + 16) as usize);
        let mut at = 0;
        let chunk = |record: &[u8]| {
            let word = |index: usize| number::<4>(record, 4 * index) as u32;
            let stored = word(7) as usize;
            let bytes = inflated(&section[at..at + stored]);
            assert_eq!(bytes.len(), word(6) as usize);
            at += stored;
            (word(0), IVec3::new(word(1) as i32, word(2) as i32, word(3) as i32), bytes)
        };
        let chunks = front[start..start + size].chunks(40).map(chunk).collect();
        assert_eq!(at, section.len(), "chunks fill their section");
        chunks
    }
}

/// Places and materials of the voxels of each grid.
fn voxels_of(scene: &PackedScene) -> Vec<HashMap<IVec3, Material>> {
    let editable = scene.to_scene();
    let material = |index: u16| editable.materials[usize::from(index)];
    editable.grids.iter().map(|grid| grid.voxels().map(|(at, index)| (at, material(index))).collect()).collect()
}

fn streamed(packed: &PackedScene, path: &Path) -> File {
    packed.save_for_streaming(path, &mut |_| true).unwrap();
    File::read(path)
}

#[test]
fn a_file_for_streaming_is_the_scene_and_its_levels() {
    let folder = tempfile::tempdir().unwrap();
    let (path, other) = (folder.path().join("streamed.vxt"), folder.path().join("levels.vxt"));
    let packed = PackedScene::pack(&scene()).unwrap();
    let merged = PackedScene::pack_merged(&scene()).unwrap();
    let smooth = packed.with_normals(Normals::Smooth).unwrap();
    for scene in [&packed, &merged, &smooth, &PackedScene::empty()] {
        scene.save_for_streaming(&path, &mut |_| true).unwrap();
        let opened = PackedScene::open(&path).unwrap();
        opened.validate().unwrap();
        assert_eq!(opened.content_hash(), scene.content_hash());
        assert_eq!((opened.is_merged(), opened.normals()), (scene.is_merged(), scene.normals()));
        assert_eq!(opened.to_bytes().len(), scene.to_bytes().len());
    }
    let file = streamed(&packed, &path);
    assert!(file.bytes.len() < packed.to_bytes().len(), "{} bytes", file.bytes.len());
    packed.save_with_levels(&other, LevelCount::All, &mut |_| true).unwrap();
    let (levels, expected) = (Levels::open(&path).unwrap(), Levels::open(&other).unwrap());
    assert_eq!((levels.count(), file.levels()), (expected.count(), expected.count() + 1));
    for level in 1..=levels.count() {
        let (found, expected) = (levels.scene(level).unwrap(), expected.scene(level).unwrap());
        found.validate().unwrap();
        assert!(voxels_of(&found) == voxels_of(&expected), "level {level}");
        assert_eq!(found.instances(), expected.instances());
        assert_eq!(
            levels.summary(level).unwrap().voxels,
            found.grids().iter().map(|grid| u64::from(grid.voxels[0])).sum::<u64>()
        );
    }
    assert!(levels.scene(levels.count() + 1).is_err());
    // The coarser a level the earlier it lies in the file.
    let starts: Vec<usize> = (0..file.levels()).map(|level| file.places[&format!("FR{level:02}")].0).collect();
    assert!(starts.is_sorted_by(|a, b| a > b) && file.places["HEAD"].0 < starts[starts.len() - 1]);
    // A file that is written anew is the same.
    packed.save(&other).unwrap();
    rewrite_for_streaming(&other, &mut |_| true).unwrap();
    assert!(std::fs::read(&other).unwrap() == file.bytes);
}

#[test]
fn a_listener_hears_how_far_each_level_is_until_it_is_done() {
    let folder = tempfile::tempdir().unwrap();
    let city = voxtrace::scenes::generate("city", Some(2_000_000)).unwrap();
    let packed = PackedScene::pack(&city).unwrap();
    let path = folder.path().join("streamed.vxt");
    let mut heard: Vec<LevelProgress> = Vec::new();
    let mut listen = |progress| {
        heard.push(progress);
        true
    };
    packed.save_for_streaming(&path, &mut listen).unwrap();
    let steps: Vec<&[LevelProgress]> = heard.chunk_by(|a, b| (a.step, a.level) == (b.step, b.level)).collect();
    let levels = Levels::open(&path).unwrap().count();
    let made = (1..=levels).map(|level| (LevelStep::Make, level));
    let expected: Vec<_> = made.chain((0..=levels).rev().map(|level| (LevelStep::Compress, level))).collect();
    assert_eq!(steps.iter().map(|step| (step[0].step, step[0].level)).collect::<Vec<_>>(), expected);
    for step in &steps {
        assert!(step.is_sorted_by_key(|progress| progress.done), "{step:?}");
        assert!(step.iter().all(|progress| progress.total == step[0].total && progress.done <= progress.total));
        assert_eq!(step.iter().filter(|progress| progress.done == progress.total).count(), 1, "{step:?}");
        assert_eq!(step[step.len() - 1].done, step[0].total);
    }
    assert_eq!(steps[0][0].total, packed.voxel_count());
    assert!(steps[0].len() > 3, "{} words of the first level", steps[0].len());
}

#[test]
fn a_scene_of_parts_has_the_voxels_of_their_levels() {
    let folder = tempfile::tempdir().unwrap();
    let packed = PackedScene::pack(&scene()).unwrap();
    let file = streamed(&packed, &folder.path().join("streamed.vxt"));
    let head = StreamHead::read(&inflated(file.section("HEAD"))).unwrap();
    assert_eq!((head.content_hash(), head.voxels()), (packed.content_hash(), packed.statistics().voxels));
    let mut levels = StreamedLevels::new(&head);
    let chunks: Vec<_> = (0..2).map(|level| file.chunks(level)).collect();
    for level in (0..2).rev() {
        levels.add_front(level, &file.front(level)).unwrap();
        for (number, (.., bytes)) in (0..).zip(&chunks[level as usize]) {
            levels.add_chunk(level, number, bytes).unwrap();
        }
    }
    // One chunk of level 1 in eight finer ones, all others as they are.
    let fine = (0, IVec3::new(0, 0, 0));
    let parent = |at: IVec3| IVec3::new(at.x >> 1, at.y >> 1, at.z >> 1);
    let of_level_1 = (0..).zip(&chunks[1]).filter(|(_, (grid, at, _))| (*grid, *at) != fine).map(|(n, _)| (1, n));
    let of_level_0 =
        (0..).zip(&chunks[0]).filter(|(_, (grid, at, _))| (*grid, parent(*at)) == fine).map(|(n, _)| (0, n));
    let cut: Vec<(u32, u32)> = of_level_1.chain(of_level_0).collect();
    assert!(cut.iter().filter(|(level, _)| *level == 0).count() > 2 && cut.iter().any(|(level, _)| *level == 1));
    let mixed = levels.scene(&cut).unwrap();
    mixed.validate().unwrap();
    let expected: Vec<_> = (0..2)
        .map(|level| voxels_of(&Levels::open(&folder.path().join("streamed.vxt")).unwrap().scene(level).unwrap()))
        .collect();
    let found = voxels_of(&mixed);
    let mut seen: Vec<HashSet<(u32, IVec3)>> = vec![HashSet::new(); 2];
    for (&(level, number), voxels) in cut.iter().zip(&found) {
        let (grid, at, _) = &chunks[level as usize][number as usize];
        for (voxel, material) in voxels {
            assert_eq!(*voxel >> 7, *at, "within the chunk");
            assert_eq!(expected[level as usize][*grid as usize].get(voxel), Some(material));
            assert!(seen[level as usize].insert((*grid, *voxel)));
        }
    }
    // Every voxel of the level that is shown at its place, and no other.
    for level in 0..2 {
        let all = (0..).zip(&expected[level]).flat_map(|(grid, voxels)| voxels.keys().map(move |voxel| (grid, *voxel)));
        let is_fine = |(grid, voxel): &(u32, IVec3)| (*grid, *voxel >> (8 - level as i32)) == fine;
        assert_eq!(all.filter(|voxel| is_fine(voxel) == (level == 0)).count(), seen[level].len(), "level {level}");
    }
    // Instances stand where those of the scene do, in voxels of their own width.
    let twice = mixed.instances().iter().filter(|instance| {
        chunks[cut[instance.grid as usize].0 as usize][cut[instance.grid as usize].1 as usize].0 == 1
    });
    assert!(twice.clone().count() >= 2);
    for instance in mixed.instances() {
        let (level, number) = cut[instance.grid as usize];
        let grid = chunks[level as usize][number as usize].0;
        let own = packed.instances().iter().filter(|own| own.grid == grid).map(|own| own.world_from_grid);
        let wider = Mat3::from_diagonal(Vec3::splat((1 << level) as f32));
        assert!(own.into_iter().any(|own| own.translation == instance.world_from_grid.translation
            && own.linear * wider == instance.world_from_grid.linear));
    }
    assert!(!mixed.geometry().emitters().is_empty());
    // What is not there is said.
    levels.remove_chunk(cut[0].0, cut[0].1);
    assert!(levels.scene(&cut).unwrap_err().to_string().contains("a chunk is missing"));
}

#[test]
fn damage_of_a_part_is_an_error_that_names_it() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("streamed.vxt");
    let packed = PackedScene::pack(&scene()).unwrap();
    let file = streamed(&packed, &path);
    let head = StreamHead::read(&inflated(file.section("HEAD"))).unwrap();
    let (front, chunks) = (file.front(0), file.chunks(0));
    let mut whole = WholeLevel::new(&head, 0, &front, None).unwrap();
    let mut damaged = chunks[3].2.clone();
    damaged[40] ^= 4;
    let error = whole.add(3, &damaged).unwrap_err().to_string();
    assert!(error.contains("chunk 3 of level 0 is damaged: it has a wrong checksum"), "{error}");
    assert!(whole.add(4, &chunks[3].2).is_err() && whole.add(1 << 20, &chunks[3].2).is_err());
    assert!(WholeLevel::new(&head, 0, &front, None).unwrap().finish().unwrap_err().to_string().contains("missing"));
    for (number, (.., bytes)) in (0..).zip(&chunks) {
        whole.add(number, bytes).unwrap();
    }
    assert_eq!(whole.finish().unwrap().content_hash(), packed.content_hash());
    // Any byte of the file but those between sections.
    let within = |at: usize| file.places.values().any(|&(start, end)| (start..end).contains(&at));
    for at in (0..24).chain((64..file.bytes.len()).step_by(file.bytes.len() / 150)).filter(|&at| at < 24 || within(at))
    {
        let mut damaged = file.bytes.clone();
        damaged[at] ^= 0x41;
        let opened = PackedScene::from_bytes(&damaged);
        let levels = Levels::from_bytes(&damaged)
            .and_then(|levels| (1..=levels.count()).try_for_each(|level| levels.scene(level).map(drop)));
        assert!(opened.is_err() || levels.is_err(), "byte {at}");
    }
    for length in (0..file.bytes.len()).step_by(file.bytes.len() / 60) {
        assert!(PackedScene::from_bytes(&file.bytes[..length]).is_err(), "{length} bytes");
    }
}
