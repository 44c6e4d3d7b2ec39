//! Meshes without textures stand out from the sky, and fill the picture that nobody placed a camera for.

use std::path::Path;
use std::sync::Arc;
use voxtrace::import::{self, ImportOptions};
use voxtrace::{CpuTracer, Film, Frame, PackedScene, Progress, Region, Scene, Sky, Tracer};

const SIZE: (u32, u32) = (96, 64);

/// Steps and a ball of a colour, as an OBJ file.
fn mesh(folder: &Path, color: &str) -> Scene {
    let mut text = String::from("mtllib a.mtl\nusemtl paint\n");
    let mut vertices = 0;
    for step in 0..5 {
        let (low, high) = (f64::from(step), f64::from(step + 1));
        for (x, y, z) in [(low, 0.0, 0.0), (high, 0.0, 0.0), (high, high, 0.0), (low, high, 0.0)] {
            text += &format!("v {x} {y} {z}\nv {x} {y} {}\n", z + 3.0);
        }
        let v = |corner: usize| vertices + corner;
        for [a, b, c, d] in [[1, 7, 5, 3], [2, 4, 6, 8], [1, 3, 4, 2], [3, 5, 6, 4], [5, 7, 8, 6], [7, 1, 2, 8]] {
            text += &format!("f {} {} {} {}\n", v(a), v(b), v(c), v(d));
        }
        vertices += 8;
    }
    std::fs::write(folder.join("a.obj"), text).unwrap();
    std::fs::write(folder.join("a.mtl"), format!("newmtl paint\nKd {color}\n")).unwrap();
    import::open(&folder.join("a.obj"), &ImportOptions::default()).unwrap()
}

/// Mean brightness where the scene is, and where nothing is.
fn contrast(scene: &Scene) -> (f32, f32) {
    let packed = Arc::new(PackedScene::pack(scene).unwrap());
    let camera = packed.portrait(SIZE.0 as f32 / SIZE.1 as f32);
    let frame = Frame::new(camera, SIZE.0, SIZE.1).samples(16);
    let mut tracer = CpuTracer::new(None);
    tracer.set_scene(&packed).unwrap();
    tracer.render(&frame, &Progress::default()).unwrap();
    let mut film = Film::new(SIZE.0, SIZE.1, Region::full(SIZE.0, SIZE.1), 0);
    tracer.read(&mut film).unwrap();
    let mean = |alpha: f32| {
        let pixels: Vec<f32> = (film.pixels.iter())
            .filter(|pixel| pixel.alpha() == alpha)
            .map(|pixel| pixel.mean().element_sum() / 3.0)
            .collect();
        assert!(pixels.len() > 500, "{}", pixels.len());
        pixels.iter().sum::<f32>() / pixels.len() as f32
    };
    (mean(1.0), mean(0.0))
}

#[test]
fn a_white_mesh_is_much_brighter_than_the_sky_behind_it() {
    let folder = tempfile::tempdir().unwrap();
    for color in ["1 1 1", "0.9 0.9 0.9", "0.78 0.76 0.74"] {
        let scene = mesh(folder.path(), color);
        let (mesh, sky) = contrast(&scene);
        assert!(mesh > 1.25 * sky, "{color}: {mesh} before {sky}");
        // Under the usual sky the two are much alike.
        let usual = Scene { sky: Sky::default(), ..scene };
        let (mesh, sky) = contrast(&usual);
        assert!(mesh < 1.1 * sky, "{color}: {mesh} before {sky}");
    }
}

#[test]
fn what_has_colours_keeps_the_usual_sky() {
    let folder = tempfile::tempdir().unwrap();
    for color in ["0.8 0.3 0.2", "0.2 0.2 0.2", "0.5 0.9 0.9"] {
        assert_eq!(mesh(folder.path(), color).sky, Sky::default(), "{color}");
    }
}
