//! Small MagicaVoxel files made by voxtrace's own writer, which between them have every kind of chunk.
// Each test file that includes this module uses its own part of it.
#![allow(dead_code)]

use std::borrow::Cow;
use voxtrace::{
    Camera, Instance, Material, Scene, Sky, Sun, Transform, VoxelGrid, export,
    glam::{IVec3, Mat3, Vec3},
    import::vox::{Body, Chunk, Dict, GroupNode, Numbered, OldMaterial, ShapeNode, TransformNode, VoxFile},
    material::linear_color,
    scene::{Keyframe, Layer},
};

/// Name and bytes of each sample.
pub fn samples() -> Vec<(&'static str, Vec<u8>)> {
    vec![
        ("scene.vox", export::vox::document_of(&scene()).unwrap().to_bytes().unwrap()),
        ("old.vox", old().to_bytes().unwrap()),
        ("animation.vox", old_animation().to_bytes().unwrap()),
        ("graph.vox", graph().to_bytes().unwrap()),
        ("empty.vox", VoxFile { version: 200, ..VoxFile::default() }.to_bytes().unwrap()),
    ]
}

/// A grid of a few voxels with an odd size.
pub fn small_grid(seed: i32) -> VoxelGrid {
    let mut grid = VoxelGrid::new();
    for i in 0..9 {
        grid.set(IVec3::new(i * seed % 3, i / 2, i * i % 7), (i * seed % 5) as u16);
    }
    grid
}

/// A scene with something of everything that voxtrace writes.
pub fn scene() -> Scene {
    let colors = [[255, 0, 0], [0, 128, 255], [10, 20, 30], [250, 240, 230], [1, 2, 3]];
    let mut materials: Vec<Material> = colors.into_iter().map(|color| Material::diffuse(linear_color(color))).collect();
    materials[1].emission = materials[1].base_color * 37.5;
    materials[2] = Material { metallic: 0.75, roughness: 0.25, ior: 2.5, ..materials[2] };
    materials[3] = Material { transmission: 0.5, roughness: 0.125, ior: 1.3, ..materials[3] };
    materials[4] = Material { roughness: 0.5, ..materials[4] };
    let mut scene = Scene { materials, ..Scene::new("scene") };
    scene.layers = vec![
        Layer { name: "walls".into(), hidden: false, color: Some([255, 204, 153]) },
        Layer { name: String::new(), hidden: true, color: None },
    ];
    let turned = Mat3::from_cols(Vec3::Y, Vec3::NEG_X, Vec3::NEG_Z);
    scene.add_instance(small_grid(1), Transform::from_translation(Vec3::new(1.0, -20.0, 3.0)));
    scene.add_instance(small_grid(2), Transform { linear: turned, translation: Vec3::new(-7.0, 0.0, 9.0) });
    scene.instances[0].name = "Säule".into();
    scene.instances[0].layer = Some(0);
    scene.instances[1].layer = Some(1);
    scene.instances[1].hidden = true;
    let key = |frame, grid, x: f32| {
        let world_from_grid = Transform { linear: turned, translation: Vec3::new(x, 1.0, 0.0) };
        Keyframe::still(frame, grid, world_from_grid)
    };
    let mut keyframes = vec![key(0, 1, 4.0), key(7, 0, 8.0), key(8, 1, 9.0)];
    // The file moves the middles of models, evenly from one key frame to the next.
    let middle = |grid: usize| {
        let bounds = scene.grids[grid].bounds().unwrap();
        turned * (bounds.min + (bounds.max - bounds.min) / 2).as_vec3()
    };
    for index in 0..2 {
        let (shown, next) = (keyframes[index].grid, keyframes[index + 1].clone());
        keyframes[index].end.translation = next.world_from_grid.translation + middle(next.grid) - middle(shown);
    }
    scene.instances.push(Instance { keyframes, ..Instance::new(1, key(0, 1, 4.0).world_from_grid) });
    scene.cameras = vec![
        Camera { name: "front".into(), fov_y: 60.0, ..Camera::look_at(Vec3::new(10.5, -40.0, 22.25), Vec3::ZERO) },
        Camera {
            name: "top".into(),
            up: Vec3::Y,
            ..Camera::look_at(Vec3::new(3.0, 2.0, 50.0), Vec3::new(3.0, 2.0, 0.0))
        },
    ];
    let sun = Sun { direction: Vec3::Z, angular_radius: 0.07, irradiance: Vec3::splat(2.0) };
    scene.sky = Sky::uniform(Vec3::splat(0.5)).with_sun(sun);
    scene
}

fn text(dict: &[(&'static str, &str)]) -> Dict<'static> {
    let mut made = Dict::default();
    dict.iter().for_each(|(key, value)| made.push(key, *value));
    made
}

fn model(size: [u32; 3], voxels: &[[u8; 4]]) -> [Body<'static>; 2] {
    [Body::Size(size), Body::Voxels(Cow::Owned(voxels.to_vec()))]
}

fn file(version: u32, bodies: Vec<Body<'static>>) -> VoxFile<'static> {
    VoxFile { version, chunks: bodies.into_iter().map(Chunk::new).collect(), ..VoxFile::default() }
}

/// A file from before the scene graph: a palette, an old material, a model.
fn old() -> VoxFile<'static> {
    let mut bodies = vec![Body::Pack(1)];
    bodies.extend(model([3, 4, 5], &[[0, 0, 0, 1], [2, 3, 4, 255], [1, 1, 1, 0], [2, 3, 4, 7]]));
    let mut palette = Box::new([[200, 100, 50, 255]; 256]);
    palette[6] = [255, 255, 200, 255];
    bodies.push(Body::Palette(palette));
    let (properties, values) = (0b1010_1110, vec![0.1, 0.5, 0.3, 0.25]);
    bodies.push(Body::OldMaterial(OldMaterial { id: 7, kind: 3, weight: 0.5, properties, values }));
    let (properties, values) = (0b0000_1010, vec![0.4, 0.3]);
    bodies.push(Body::OldMaterial(OldMaterial { id: 1, kind: 2, weight: 0.9, properties, values }));
    file(150, bodies)
}

/// A file from before the scene graph whose models are the frames of an animation.
fn old_animation() -> VoxFile<'static> {
    let mut bodies = vec![Body::Pack(2)];
    bodies.extend(model([2, 2, 2], &[[0, 0, 0, 1], [1, 1, 1, 2]]));
    bodies.extend(model([3, 3, 3], &[[0, 0, 2, 1]]));
    file(150, bodies)
}

/// A scene graph with nested groups, hidden ones, animation at two levels and every chunk that the writer has no use for.
fn graph() -> VoxFile<'static> {
    let transform = |id, child, layer, attributes: &[_], frames: Vec<Dict<'static>>| {
        Body::Transform(TransformNode { id, attributes: text(attributes), child, reserved: -1, layer, frames })
    };
    let group =
        |id, children: &[i32]| Body::Group(GroupNode { id, attributes: Dict::default(), children: children.to_vec() });
    let shape = |id, models| Body::Shape(ShapeNode { id, attributes: text(&[("_loop", "1")]), models });
    let mut bodies = vec![Body::Unknown(*b"META", Cow::Borrowed(b"\x01\0\0\0"))];
    bodies.extend(model([5, 3, 1], &[[4, 2, 0, 9], [0, 0, 0, 10]]));
    bodies.extend(model([1, 2, 256], &[[0, 1, 255, 11]]));
    bodies.extend([
        transform(0, 1, -1, &[], vec![Dict::default()]),
        group(1, &[2, 6]),
        transform(2, 3, 0, &[("_name", "outer")], vec![text(&[("_r", "40"), ("_t", "0 41 1")])]),
        group(3, &[4]),
        transform(
            4,
            5,
            2,
            &[],
            vec![text(&[("_f", "3"), ("_t", "1 0 0")]), text(&[("_f", "9"), ("_t", "-1 0 0"), ("_r", "82")])],
        ),
        shape(5, vec![(0, text(&[("_f", "0")])), (1, text(&[("_f", "5")]))]),
        transform(6, 7, 1, &[("_hidden", "1")], vec![text(&[("_t", "0 0 -5")])]),
        group(7, &[8, 8]),
        transform(8, 5, -1, &[("_name", "twice")], vec![text(&[("_r", "20")])]),
        Body::Layer(Numbered { id: 0, properties: text(&[("_name", "a"), ("_color", "1 2 3")]) }, -1),
        Body::Layer(Numbered { id: 2, properties: text(&[("_hidden", "1")]) }, -1),
        Body::IndexMap(Box::new([7; 256])),
        Body::Material(Numbered { id: 9, properties: text(&[("_type", "_emit"), ("_emit", "0.42"), ("_flux", "3")]) }),
        Body::Material(Numbered {
            id: 10,
            properties: text(&[("_type", "_glass"), ("_alpha", "0.5"), ("_ior", "0.3")]),
        }),
        Body::Material(Numbered {
            id: 11,
            properties: text(&[("_type", "_metal"), ("_weight", "0.7"), ("_rough", "0.1")]),
        }),
        Body::Material(Numbered { id: 256, properties: text(&[("_type", "_blend"), ("_metal", "0.5")]) }),
        Body::RenderObject(text(&[
            ("_type", "_inf"),
            ("_i", "0.7"),
            ("_k", "255 250 240"),
            ("_angle", "50 50"),
            ("_area", "0.07"),
        ])),
        Body::RenderObject(text(&[("_type", "_uni"), ("_i", "0.42"), ("_k", "91 178 255")])),
        Body::Camera(Numbered { id: 0, properties: text(&[("_mode", "pers"), ("_radius", "1"), ("_fov", "45")]) }),
        Body::Camera(Numbered {
            id: 1,
            properties: text(&[
                ("_focus", "1.5 -2 30"),
                ("_angle", "33.3 -120.7 12.5"),
                ("_radius", "80.25"),
                ("_fov", "51"),
            ]),
        }),
        Body::Notes(vec![Cow::Borrowed(b"row"), Cow::Borrowed(b"\xff\xfe")]),
    ]);
    let mut file = file(200, bodies);
    file.chunks[3].extra = Cow::Borrowed(b"more");
    file.chunks[0].children = Cow::Borrowed(b"NONE\0\0\0\0\0\0\0\0");
    file.trailing = Cow::Borrowed(b"after the end");
    file
}

fn still(id: i32, child: i32) -> Body<'static> {
    let frames = vec![Dict::default()];
    Body::Transform(TransformNode { id, attributes: Dict::default(), child, reserved: -1, layer: -1, frames })
}

/// Groups that each show the next one twice: 2 to the power of `levels` instances.
pub fn doubling_graph(levels: i32) -> Vec<u8> {
    let mut bodies = model([1, 1, 1], &[[0, 0, 0, 1]]).to_vec();
    for level in 0..levels {
        let children = vec![level + 1; 2];
        bodies.push(Body::Group(GroupNode { id: level, attributes: Dict::default(), children }));
    }
    bodies.push(Body::Shape(ShapeNode { id: levels, attributes: Dict::default(), models: vec![(0, Dict::default())] }));
    file(200, bodies).to_bytes().unwrap()
}

/// A chain of transforms with a shape at its end.
pub fn deep_graph(depth: i32) -> Vec<u8> {
    let mut bodies = model([1, 1, 1], &[[0, 0, 0, 1]]).to_vec();
    bodies.extend((0..depth).map(|id| still(id, id + 1)));
    bodies.push(Body::Shape(ShapeNode { id: depth, attributes: Dict::default(), models: vec![(0, Dict::default())] }));
    file(200, bodies).to_bytes().unwrap()
}
