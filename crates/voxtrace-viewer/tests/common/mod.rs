//! A small room, and a session that shows it.

use std::sync::Arc;
use voxtrace::glam::{IVec3, Vec3};
use voxtrace::{Camera, Material, PackedScene, Scene, VoxelGrid};
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
