//! The native file: what is saved is what is opened, and a damaged file is an error, never a panic.

use std::sync::Arc;
use voxtrace::glam::{IVec3, Mat3, Vec3};
use voxtrace::packed::{PackedGrid, Section};
use voxtrace::{Camera, Hit, Material, PackedScene, Ray, Scene, Sun, Transform, walk};
use voxtrace_tests::random::Random;
use voxtrace_tests::rays::mixed;
use voxtrace_tests::scenes::{dust, noise};

fn scene() -> Scene {
    let mut scene = Scene::from_grid("two grids", noise(IVec3::new(3, -7, 0), 20, 0.1, 30, 1), vec![]);
    let turned = Transform { linear: Mat3::from_cols(Vec3::Y, Vec3::NEG_X, Vec3::Z), translation: Vec3::splat(40.0) };
    scene.add_instance(dust(200, 10, 2), turned);
    scene.materials = (0..500).map(|i| Material::diffuse(Vec3::splat(i as f32 / 500.0))).collect();
    scene.cameras = vec![Camera::look_at(Vec3::new(1.0, 2.0, 3.0), Vec3::ZERO)];
    scene.sky.sun = Some(Sun { direction: Vec3::Z, angular_radius: 0.01, irradiance: Vec3::ONE });
    scene
}

fn bytes_of(scene: &PackedScene) -> Vec<u8> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.vxt");
    scene.save(&path).unwrap();
    std::fs::read(path).unwrap()
}

/// Bytes whose first one is aligned to 8, as a mapped file's is.
struct Aligned(Vec<u64>, usize);

impl Aligned {
    fn new(bytes: &[u8]) -> Arc<Self> {
        let words = bytes.chunks(8).map(|chunk| {
            let mut word = [0; 8];
            word[..chunk.len()].copy_from_slice(chunk);
            u64::from_ne_bytes(word)
        });
        Arc::new(Self(words.collect(), bytes.len()))
    }
}

impl AsRef<[u8]> for Aligned {
    fn as_ref(&self) -> &[u8] {
        &bytemuck::cast_slice(&self.0)[..self.1]
    }
}

#[test]
fn saved_and_opened_scene_is_the_same() {
    let source = scene();
    let packed = PackedScene::pack(&source).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.vxt");
    packed.save(&path).unwrap();
    let opened = PackedScene::open(&path).unwrap();
    assert_eq!(opened.content_hash(), packed.content_hash());
    assert_eq!(opened.to_scene(), source);
    let rays = mixed(&source.grids[0], 2000, 3);
    let cast = |scene: &PackedScene| rays.iter().map(|ray| walk::cast(scene, ray)).collect::<Vec<Hit>>();
    assert_eq!(cast(&opened), cast(&packed));
}

#[test]
fn hash_notices_any_change() {
    let packed = PackedScene::pack(&scene()).unwrap();
    let hash = packed.content_hash();
    let brighter = PackedScene { light_intensity: 2.0, ..packed.clone() };
    assert_ne!(brighter.content_hash(), hash);
    let mut changed = scene();
    Arc::make_mut(&mut changed.grids[0]).set(IVec3::new(3, -7, 0), 29);
    assert_ne!(PackedScene::pack(&changed).unwrap().content_hash(), hash);
}

#[test]
fn every_cut_and_every_flipped_byte_is_an_error() {
    let bytes = bytes_of(&PackedScene::pack(&scene()).unwrap());
    let opens = |bytes: &[u8]| PackedScene::from_bytes(Aligned::new(bytes)).map(|scene| scene.content_hash());
    let hash = opens(&bytes).unwrap();
    for length in (0..bytes.len()).step_by(61) {
        assert!(opens(&bytes[..length]).is_err(), "cut to {length} bytes");
    }
    let mut random = Random(5);
    for _ in 0..400 {
        let mut damaged = bytes.clone();
        let at = random.below(bytes.len());
        damaged[at] ^= 1 << random.below(8);
        // Padding between sections and reserved words mean nothing.
        let is_unharmed = opens(&damaged).is_ok_and(|found| found == hash);
        assert!(is_unharmed || opens(&damaged).is_err(), "byte {at}");
    }
}

#[test]
fn contradictory_scene_is_refused_or_harmless() {
    let packed = PackedScene::pack(&scene()).unwrap();
    let rays: Vec<Ray> = mixed(&scene().grids[0], 300, 8);
    let mut random = Random(9);
    let mut refused = 0;
    for round in 0..600 {
        let mut scene = packed.clone();
        let word = random.bits() as u32 >> random.below(32);
        let change = |section: &Section<u32>, random: &mut Random| {
            let mut words = section.to_vec();
            let at = random.below(words.len());
            words[at] = word;
            Section::from(words)
        };
        match round % 4 {
            0 => scene.cells = change(&scene.cells, &mut random),
            1 => scene.bricks = change(&scene.bricks, &mut random),
            2 => scene.brick_materials = change(&scene.brick_materials, &mut random),
            _ => {
                let mut words: Vec<u32> = bytemuck::cast_slice(&scene.grids).to_vec();
                let at = random.below(words.len());
                words[at] = word;
                scene.grids = bytemuck::cast_slice::<u32, PackedGrid>(&words).to_vec().into();
            }
        }
        match PackedScene::from_bytes(Aligned::new(&bytes_of(&scene))) {
            Err(_) => refused += 1,
            Ok(scene) => {
                for hit in rays.iter().map(|ray| walk::cast(&scene, ray)).filter(|hit| !hit.is_miss()) {
                    assert!(scene.material_index(&hit) < 500);
                }
            }
        }
    }
    assert!(refused > 100, "only {refused} of 600 were refused");
}
