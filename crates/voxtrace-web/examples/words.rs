//! What this machine gives where pages ask the module of WebAssembly, for tests that compare: `words selftest EDGE` prints the checksums of
//! functions, `words rays SCENE RAYS` the hits in a scene's file of the rays in another (eight little-endian floats each), a line of words each.
//! `words real-time SCENE SIZE SEED OUT CAMERA...` writes pictures in real-time light of a native file one after the other, as a screen shows them, red, green and blue;
//! each camera is ten numbers with commas between. `words gpu SCENE SIZE FOLDER CAMERA...` writes what a page gives its GPU, for `web/measure/on_gpu.py`; there a
//! camera may be `own`, the scene's, and `own+X` that moved along x, world units.

use std::fs;
use std::path::Path;
use voxtrace_core::{Frame, PackedScene};
use voxtrace_io::output::{Operator, ToneBytes, ToneMap};
use voxtrace_realtime::{Parts, RealTime};
use voxtrace_scene::{Camera, glam::Vec3};
use voxtrace_web::{GpuScene, Part, WebScene, selftest};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let given: Vec<String> = std::env::args().skip(1).collect();
    match given.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["selftest", edge] => selftest(edge.parse()?).iter().for_each(|line| println!("{line}")),
        ["rays", scene, rays] => {
            let rays = fs::read(rays)?;
            let rays: Vec<f32> = rays.chunks_exact(4).map(bytemuck::pod_read_unaligned).collect();
            let scene = WebScene::read(fs::read(scene)?, scene).map_err(|_| "the scene cannot be read")?;
            let words = scene.cast(&rays, &[]).map_err(|_| "the rays are not whole")?;
            for hit in words.chunks_exact(6) {
                println!("{}", hit.iter().map(|word| format!("{word:08x}")).collect::<Vec<_>>().join(" "));
            }
        }
        ["real-time", scene, size, seed, out, ref cameras @ ..] => {
            let (width, height) = size_of_picture(size)?;
            let scene = PackedScene::from_bytes(&fs::read(scene)?)?;
            let tone = ToneBytes::new(ToneMap { operator: Operator::Agx, exposure: 0.0 });
            let mut real_time = RealTime::new(Parts { visibility: false, ..Parts::ALL });
            let mut bytes = Vec::new();
            for camera in cameras {
                let frame = Frame::new(camera_of(camera)?, width, height).seed(seed.parse()?);
                bytes.extend(real_time.frame(&scene, &frame).into_iter().flat_map(|radiance| tone.of(radiance)));
            }
            fs::write(out, bytes)?;
        }
        ["gpu", scene, size, folder, ref cameras @ ..] => write_for_gpu(&fs::read(scene)?, size, Path::new(folder), cameras)?,
        _ => return Err("usage: words selftest EDGE | rays SCENE RAYS | real-time SCENE SIZE SEED OUT CAMERA... | gpu SCENE SIZE FOLDER CAMERA...".into()),
    }
    Ok(())
}

/// Width and height of `WIDTHxHEIGHT`, pixels.
fn size_of_picture(text: &str) -> Result<(u32, u32), Box<dyn std::error::Error>> {
    let (width, height) = text.split_once('x').ok_or("a size is WIDTHxHEIGHT")?;
    Ok((width.parse()?, height.parse()?))
}

/// The ten numbers of a camera, with commas between.
fn numbers_of(text: &str) -> Result<Vec<f32>, std::num::ParseFloatError> {
    text.split(',').map(str::parse).collect()
}

/// A pinhole camera of its numbers: eye, target, up, and the vertical field of view in degrees.
fn camera_of(text: &str) -> Result<Camera, Box<dyn std::error::Error>> {
    let numbers = <[f32; 10]>::try_from(numbers_of(text)?).map_err(|_| "a camera has ten numbers")?;
    let vector = |at: usize| Vec3::from_slice(&numbers[at..]);
    Ok(Camera { up: vector(6), fov_y: numbers[9], ..Camera::look_at(vector(0), vector(3)) })
}

/// Writes the arrays of a scene and the input of pictures of it, a film's and those in real-time light, as words in files of their own, and what else there is to know in `input.txt`.
fn write_for_gpu(bytes: &[u8], size: &str, folder: &Path, cameras: &[&str]) -> Result<(), Box<dyn std::error::Error>> {
    let refused = |what: &'static str| move |_| what;
    let mut scene = GpuScene::read(bytes).map_err(refused("the scene cannot be read"))?;
    let arrays = scene.arrays().ok_or("the shaders of pages do not know all of the scene")?;
    fs::create_dir_all(folder)?;
    let write = |name: &str, words: &[u32]| fs::write(folder.join(name), bytemuck::cast_slice(words));
    write("cells", &arrays.cells)?;
    write("bricks", &arrays.bricks)?;
    write("brickMaterials", &arrays.brick_materials)?;
    write("records", &arrays.records)?;
    write("environment", &arrays.environment)?;
    let (width, height) = size_of_picture(size)?;
    let own = WebScene::read(bytes.to_vec(), "scene.vxt").map_err(refused("the scene cannot be read"))?;
    let own = own.camera(0, width as f32 / height as f32);
    let camera_numbers = |camera: &str| -> Result<Vec<f32>, std::num::ParseFloatError> {
        let Some(by) = camera.strip_prefix("own") else { return numbers_of(camera) };
        let by: f32 = if by.is_empty() { 0.0 } else { by.parse()? };
        let moved = own.iter().enumerate().map(|(at, number)| if at == 0 || at == 3 { number + by } else { *number });
        Ok(moved.collect())
    };
    let mut lines = vec![
        format!("size {width} {height}"),
        format!("matte {}", u32::from(arrays.is_matte)),
        format!("constants {}", arrays.constants.iter().map(u32::to_string).collect::<Vec<_>>().join(" ")),
    ];
    for (number, camera) in cameras.iter().enumerate() {
        let part = Part::new(camera_numbers(camera)?, width, height);
        let made = scene.real_time(&part, 1.0, 0).map_err(refused("a camera has ten numbers"))?;
        write(&format!("frame-{number}"), &made.frame)?;
        write(&format!("frames-{number}"), &made.frames)?;
        let of_frame = |(reprojects, looks): (&u8, &[u32])| format!(" {reprojects} {} {}", looks[0], looks[1]);
        let frames: String = made.reprojects.iter().zip(made.looks.chunks_exact(2)).map(of_frame).collect();
        lines.push(format!("picture {} {} {}{frames}", made.words, made.cells, made.tracing_cells));
    }
    fs::write(folder.join("input.txt"), lines.join("\n"))?;
    Ok(())
}
