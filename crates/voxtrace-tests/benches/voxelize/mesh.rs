//! Voxelizes a mesh of a million triangles: plain, with vertex colours and with a texture; and from a file, compared with trimesh.

use crate::Options;
use std::error::Error;
use std::path::Path;
use std::process::Command;
use std::time::Instant;
use voxtrace::glam::{Vec2, Vec3, Vec4};
use voxtrace::import::{self, ImportOptions, Limits};
use voxtrace::mesh::{Mesh, Texture, TextureUse};
use voxtrace::voxelize::{Scale, SurfaceRule, VoxelizeOptions, VoxelizeProgress, voxelize_to_file};

/// Measures and prints.
pub fn measure(options: &Options, folder: &Path) -> Result<(), Box<dyn Error>> {
    let plain = bumpy_sphere(options.triangles);
    println!("{} triangles", plain.triangle_count());

    let mut colored = plain.clone();
    colored.colors = plain.positions.iter().map(|position| (*position * 0.4 + 0.5).extend(1.0)).collect();
    colored.materials[0].base_color = Vec4::ONE;
    let mut textured = plain.clone();
    textured.uvs = plain.positions.iter().map(|p| Vec2::new(p.y.atan2(p.x) / 3.0, p.z * 2.0)).collect();
    textured.textures = vec![picture()?];
    textured.materials[0].base_texture = Some(TextureUse::new(0));
    textured.materials[0].base_color = Vec4::ONE;

    let out = folder.join("out.vxt");
    for (name, mesh) in [("plain", &plain), ("vertex colours", &colored), ("textured", &textured)] {
        for (rule, surface) in [(SurfaceRule::Conservative, "conservative"), (SurfaceRule::Thin, "thin")] {
            let (seconds, voxels) = time(mesh, options.resolution, rule, options.rounds, &out)?;
            println!(
                "{name:<15} {surface:<13} {:>5}^3 {seconds:>8.3} s {:>7.1} M voxels {:>7.2} M voxels/s",
                options.resolution,
                voxels as f64 / 1e6,
                voxels as f64 / 1e6 / seconds
            );
        }
    }
    beside_trimesh(options, &plain, folder)
}

/// Median time of voxelizing a mesh into a file, and the voxels.
fn time(
    mesh: &Mesh,
    resolution: u32,
    rule: SurfaceRule,
    rounds: usize,
    out: &Path,
) -> Result<(f64, u64), Box<dyn Error>> {
    let options = VoxelizeOptions { scale: Scale::Resolution(resolution), rule, ..VoxelizeOptions::default() };
    let (mut seconds, mut voxels) = (Vec::new(), 0);
    for _ in 0..rounds.max(1) {
        let mesh = mesh.clone();
        let start = Instant::now();
        voxels = voxelize_to_file(mesh, &options, &Limits::default(), out, &VoxelizeProgress::default())?.voxels;
        seconds.push(start.elapsed().as_secs_f64());
    }
    seconds.sort_by(f64::total_cmp);
    Ok((seconds[seconds.len() / 2], voxels))
}

/// Both programs on a file of the mesh, reading included.
fn beside_trimesh(options: &Options, mesh: &Mesh, folder: &Path) -> Result<(), Box<dyn Error>> {
    let (file, out) = (folder.join("mesh.ply"), folder.join("out.vxt"));
    std::fs::write(&file, ply_of(mesh))?;
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("benches/voxelize/trimesh_time.py");
    for resolution in options.trimesh_resolutions.split(',') {
        let start = Instant::now();
        let read = import::read_mesh(&file, &ImportOptions::default())?;
        let size: u32 = resolution.trim().parse()?;
        let own_options = VoxelizeOptions { scale: Scale::Resolution(size), ..VoxelizeOptions::default() };
        voxelize_to_file(read, &own_options, &Limits::default(), &out, &VoxelizeProgress::default())?;
        let own = start.elapsed().as_secs_f64();
        let output = Command::new(&options.python).arg(&script).arg(&file).arg(resolution.trim()).output();
        let text = output.map(|output| String::from_utf8_lossy(&output.stdout).trim().to_owned()).unwrap_or_default();
        match text.parse::<f64>() {
            Ok(other) => {
                println!("{size:>5}^3 from file: {own:.3} s, trimesh {other:.3} s: {:.0} times as fast", other / own)
            }
            Err(_) if text.is_empty() => println!("{size:>5}^3 from file: {own:.3} s; no Python with trimesh"),
            Err(_) => println!("{size:>5}^3 from file: {own:.3} s; trimesh: {text}"),
        }
    }
    Ok(())
}

fn bumpy_sphere(triangles: u32) -> Mesh {
    let rows = ((triangles as f64 / 4.0).sqrt()) as u32;
    let columns = 2 * rows;
    let point = |i: u32, j: u32| {
        let (longitude, latitude) =
            (i as f32 / columns as f32 * std::f32::consts::TAU, (j as f32 / rows as f32 - 0.5) * std::f32::consts::PI);
        let radius = 1.0 + 0.06 * (9.0 * longitude).sin() * (11.0 * latitude).cos() * latitude.cos();
        let circle = latitude.cos();
        radius * Vec3::new(circle * longitude.cos(), circle * longitude.sin(), latitude.sin())
    };
    let positions = (0..=rows).flat_map(|j| (0..columns).map(move |i| point(i, j))).collect();
    let triangles = (0..rows).flat_map(|j| (0..columns).map(move |i| (i, j))).flat_map(|(i, j)| {
        let index = |i: u32, j: u32| j * columns + i % columns;
        let [a, b, c, d] = [index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)];
        [[a, b, c], [a, c, d]]
    });
    let triangles = triangles.collect();
    Mesh { positions, triangles, ..Mesh::new("bumpy sphere") }
}

fn picture() -> Result<Texture, Box<dyn Error>> {
    let texels = (0..1024 * 1024u32)
        .map(|at| [(at >> 2) as u8, (at >> 12) as u8, (at.wrapping_mul(2_654_435_761) >> 26) as u8, 255]);
    Texture::new(1024, 1024, texels.collect()).ok_or_else(|| "no picture".into())
}

fn ply_of(mesh: &Mesh) -> Vec<u8> {
    let mut bytes = format!(
        "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n\
         element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        mesh.positions.len(),
        mesh.triangles.len()
    )
    .into_bytes();
    bytes.extend(mesh.positions.iter().flat_map(|position| position.to_array()).flat_map(f32::to_le_bytes));
    for triangle in &mesh.triangles {
        bytes.push(3);
        bytes.extend(triangle.map(u32::to_le_bytes).as_flattened());
    }
    bytes
}
