//! A small room, and a session that shows it.

// Each test takes what it needs.
#![allow(dead_code)]

pub mod hand;
pub mod headless;
pub mod panel;

use std::sync::Arc;
use voxtrace::glam::{IVec3, Vec3};
use voxtrace::scene::{Group, Layer};
use voxtrace::{Camera, CpuTracer, Film, Frame, Material, PackedScene, Progress, Scene, Tracer, Transform, VoxelGrid};
use voxtrace_viewer::session::Session;
use voxtrace_vulkan::Traversal;

/// Size of the picture.
pub const SIZE: (u32, u32) = (640, 480);

/// A floor with a red block, and three cameras, two of one name.
pub fn room() -> Scene {
    let materials = vec![Material::diffuse(Vec3::splat(0.8)), Material::diffuse(Vec3::new(0.8, 0.05, 0.05))];
    let mut grid = VoxelGrid::new();
    for i in 0..24 * 24 {
        grid.set(IVec3::new(i % 24, i / 24, 0), 0);
    }
    for i in 0..6 * 6 * 6 {
        grid.set(IVec3::new(9 + i % 6, 9 + i / 6 % 6, 1 + i / 36), 1);
    }
    let mut scene = Scene::from_grid("room", grid, materials);
    let camera = |name: &str, eye| Camera { name: name.into(), ..Camera::look_at(eye, Vec3::new(12.0, 12.0, 3.0)) };
    scene.cameras = vec![
        camera("front", Vec3::new(12.0, -30.0, 18.0)),
        camera("side", Vec3::new(50.0, 12.0, 14.0)),
        camera("side", Vec3::new(12.0, 60.0, 14.0)),
    ];
    scene
}

/// The room, packed.
pub fn packed() -> Arc<PackedScene> {
    Arc::new(PackedScene::pack(&room()).unwrap())
}

/// The room twice and a lamp, in two layers, the second of which the file hides, and a group.
#[allow(dead_code, reason = "not every test needs it")]
pub fn house() -> Scene {
    let mut scene = room();
    scene.name = "house".into();
    scene.materials.push(Material::emissive(Vec3::new(4.0, 2.0, 1.0)));
    let mut lamp = VoxelGrid::new();
    lamp.set(IVec3::new(12, 12, 20), 2);
    scene.add_instance((*scene.grids[0]).clone(), Transform::from_translation(Vec3::new(30.0, 0.0, 0.0)));
    scene.add_instance(lamp, Transform::IDENTITY);
    scene.layers = vec![
        Layer { name: "rooms".into(), ..Layer::default() },
        Layer { name: "lamps".into(), hidden: true, ..Layer::default() },
    ];
    scene.groups = vec![Group { name: "pair".into(), parent: None }];
    for (index, instance) in scene.instances.iter_mut().enumerate() {
        (instance.layer, instance.group) = (Some(index / 2), (index < 2).then_some(0));
    }
    scene.instances[0].name = "kitchen".into();
    scene
}

/// A session that shows the room from its first camera, with nothing left to do.
pub fn in_room(source: &str) -> Session {
    let mut session = Session::new(Traversal::Cpu);
    session.traversals = vec![Traversal::Cpu, Traversal::Walk, Traversal::Query];
    session.resize(SIZE.0, SIZE.1);
    session.show(source.into(), packed());
    session.take_commands();
    session
}

/// What is said to whoever looks.
pub fn said(session: &mut Session) -> Vec<String> {
    session.messages().map(|message| message.text.clone()).collect()
}

/// What `render` makes of a frame.
pub fn rendered(scene: &Arc<PackedScene>, frame: &Frame) -> Film {
    let mut tracer = CpuTracer::new(None);
    tracer.set_scene(scene).unwrap();
    tracer.render(frame, &Progress::default()).unwrap();
    let mut film = Film::new(0, 0, frame.region, 0);
    tracer.read(&mut film).unwrap();
    film
}

/// What `render` makes of what a session shows: a small film of `scene`.
pub fn film(scene: &Arc<PackedScene>, session: &Session) -> Film {
    rendered(scene, &session.view().frame().size(40, 30).samples(2))
}

/// The scene that a session traces.
pub fn lit(session: &Session) -> Arc<PackedScene> {
    Arc::clone(&session.open.as_ref().unwrap().lit)
}

/// The command line that makes the session's picture.
pub fn words(session: &Session) -> String {
    session.render_command().unwrap().line().unwrap()
}
