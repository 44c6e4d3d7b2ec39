//! A glTF file whose nodes move, held against scipy, another program's library: at many times each vertex lies in a voxel of its part. Skipped where no
//! Python has scipy.

mod written;

use serde_json::Value;
use std::path::PathBuf;
use voxtrace::animation::{Animation, CameraMotion, CameraTrack, Playback};
use voxtrace::glam::{DVec3, Vec3};
use voxtrace::import::{self, ClipChoice, ImportOptions};
use voxtrace::voxelize::{Scale, VoxelizeOptions};
use voxtrace::{PackedScene, Scene};
use written::Written;

static WRITTEN: Written = Written::by("animations.py", "scipy");
/// Voxels along the longest side.
const RESOLUTION: u32 = 240;

fn open(animation: ClipChoice) -> Option<(Scene, Value)> {
    let folder = WRITTEN.folder()?;
    let voxelize = VoxelizeOptions { scale: Scale::Resolution(RESOLUTION), ..VoxelizeOptions::default() };
    let options = ImportOptions { animation, voxelize, ..ImportOptions::default() };
    let path: PathBuf = folder.join("moving.gltf");
    let answers = serde_json::from_str(&std::fs::read_to_string(folder.join("moving.json")).unwrap()).unwrap();
    Some((import::open(&path, &options).unwrap(), answers))
}

/// A vector of the file in our axes.
fn turned(value: &Value) -> DVec3 {
    let [x, y, z] = [0, 1, 2].map(|axis| value[axis].as_f64().unwrap());
    DVec3::new(x, -z, y)
}

/// From the file to voxels.
struct Lattice {
    corner: DVec3,
    voxel: f64,
}

impl Lattice {
    fn of(answers: &Value) -> Self {
        let (one, other) = (turned(&answers["min"]), turned(&answers["max"]));
        let voxel = (one - other).abs().max_element() / f64::from(RESOLUTION);
        Self { corner: one.min(other), voxel }
    }

    fn voxels(&self, point: &Value) -> Vec3 {
        ((turned(point) - self.corner) / self.voxel).as_vec3()
    }
}

/// Of the vertices of all parts at one time, how many lie in no voxel of their part, and how many there are.
fn missed(scene: &Scene, lattice: &Lattice, answer: &Value) -> (usize, usize) {
    let (mut missed, mut all) = (0, 0);
    for (name, corners) in answer["parts"].as_object().unwrap() {
        let instance = scene.instances.iter().find(|instance| instance.name == *name).unwrap();
        assert!(!instance.hidden, "{name}");
        let (grid, inverse) = (&scene.grids[instance.grid], instance.world_from_grid.inverse());
        for corner in corners.as_array().unwrap() {
            let place = inverse.point(lattice.voxels(corner));
            // Rounding may put a vertex beside the voxel that it sets.
            let near = |edge: f32| {
                let corners = (0..8).map(|bits| {
                    Vec3::from_array([0, 1, 2].map(|axis| if bits >> axis & 1 == 1 { edge } else { -edge }))
                });
                corners.into_iter().any(|offset| grid.get((place + offset).floor().as_ivec3()).is_some())
            };
            missed += usize::from(!near(0.05));
            all += 1;
        }
    }
    (missed, all)
}

fn list(value: &Value) -> impl Iterator<Item = (f64, &Value)> {
    value["times"].as_array().unwrap().iter().map(|time| time.as_f64().unwrap()).zip(value["right"].as_array().unwrap())
}

#[test]
fn each_vertex_is_where_scipy_says_at_every_time_and_not_where_evaluators_with_a_fault_say() {
    let Some((scene, answers)) = open(ClipChoice::First) else { return };
    let lattice = Lattice::of(&answers);
    let animation = Animation { clip: Playback::Once, ..Animation::default() };
    assert!(animation.moves_objects(&scene));
    let mut now = scene.clone();
    for (time, answer) in list(&answers) {
        animation.apply(&scene, &mut now, time);
        let (missed, all) = missed(&now, &lattice, answer);
        assert!(missed == 0 && all == 36, "{time}: {missed} of {all}");
    }
    let faults = answers["wrong"].as_object().unwrap().iter();
    for (fault, wrong) in faults.chain([(&"late".to_owned(), &answers["late"])]) {
        let found = list(&answers).zip(wrong.as_array().unwrap()).map(|((time, _), wrong)| {
            animation.apply(&scene, &mut now, time);
            missed(&now, &lattice, wrong).0
        });
        assert!(found.sum::<usize>() > 8, "{fault}");
    }
}

#[test]
fn a_camera_is_where_scipy_says_at_every_time() {
    let Some((scene, answers)) = open(ClipChoice::Named("work".into())) else { return };
    let lattice = Lattice::of(&answers);
    let clip = scene.clips[0].clone();
    let own = clip.motion.as_ref().unwrap().cameras[0];
    let camera = scene.cameras[own.index].clone();
    let track = CameraTrack::new(CameraMotion::OnNode { camera: camera.clone(), clip, playback: Playback::Once, own });
    for (time, answer) in list(&answers) {
        let seen = track.at(&scene, time);
        assert!(seen.eye.abs_diff_eq(lattice.voxels(&answer["eye"]), 0.01), "{time}: {}", seen.eye);
        let (ahead, up) = (turned(&answer["ahead"]).as_vec3(), turned(&answer["up"]).as_vec3());
        assert!(
            (seen.target - seen.eye).normalize().abs_diff_eq(ahead, 1e-5) && seen.up.abs_diff_eq(up, 1e-5),
            "{time}"
        );
        assert_eq!((&seen.name, seen.fov_y), (&camera.name, camera.fov_y));
    }
    // A tenth of a second later it is elsewhere.
    assert!(!track.at(&scene, 0.1).eye.abs_diff_eq(lattice.voxels(&answers["right"][0]["eye"]), 1.0));
}

#[test]
fn what_moves_is_a_grid_of_its_own_and_all_else_is_that_of_the_still() {
    let Some((scene, _)) = open(ClipChoice::First) else { return };
    let names: Vec<&str> = scene.instances.iter().map(|instance| instance.name.as_str()).collect();
    assert_eq!(names, ["", "arm", "wheel", "jumper", "twin 1", "twin 2", "mirrored"]);
    // Twins share a grid.
    assert_eq!((scene.grids.len(), scene.instances[4].grid), (6, scene.instances[5].grid));
    let (still, _) = open(ClipChoice::None).unwrap();
    assert_eq!((still.grids.len(), still.instances.len()), (1, 1));
    let clips = |scene: &Scene| -> Vec<(String, f64)> {
        scene.clips.iter().map(|clip| (clip.name.clone(), clip.seconds)).collect()
    };
    assert_eq!(clips(&scene), [("work".to_owned(), 2.5), ("other".to_owned(), 2.5)]);
    assert!(clips(&scene) == clips(&still) && still.clips.iter().all(|clip| clip.motion.is_none()));
    // The voxels of what stands still are voxels of the still.
    let corner = scene.instances[0].world_from_grid.translation.as_ivec3();
    assert!(scene.grids[0].voxels().all(|(voxel, _)| still.grids[0].get(voxel + corner).is_some()));
    assert!(scene.grids[0].count() * 10 > still.grids[0].count() * 6, "the ground is the larger part");
    assert!(PackedScene::pack(&scene).is_ok());
    // The other animation moves another node alone.
    let (other, _) = open(ClipChoice::Named("2".into())).unwrap();
    let moved = other.clips[1].motion.as_ref().unwrap();
    assert_eq!((moved.nodes.len(), other.instances.last().unwrap().name.as_str()), (1, "still"));
    assert!(other.clips[0].motion.is_none());
}
