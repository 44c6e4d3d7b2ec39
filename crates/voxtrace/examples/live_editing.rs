//! A scene that is edited while it is traced: a tower gets a hole with a lamp in it, and all of that is undone. Three pictures in the folder that
//! is named: `cargo run --release --example live_editing -- FOLDER`

use std::path::Path;
use std::sync::Arc;
use std::time::Instant;
use voxtrace::dynamic::{DynamicScene, Edit};
use voxtrace::glam::{DVec3, Vec2};
use voxtrace::{Material, PackedScene, Picture, Renderer, Shape, scenes};
use voxtrace_vulkan::{Request, choose};

const SIZE: (u32, u32) = (320, 180);
/// The pixel whose voxel the hole begins at, from the upper left corner.
const PIXEL: Vec2 = Vec2::new(152.0, 60.0);

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = std::env::args().nth(1).unwrap_or("live_editing".into());
    std::fs::create_dir_all(&folder)?;
    let packed = PackedScene::pack(&scenes::generate("city", Some(600_000))?)?;
    let mut renderer = Renderer::of_packed(Arc::new(packed.clone())).tracer(choose(&Request::default())?.tracer);
    renderer = renderer.size(SIZE.0, SIZE.1).samples(24);
    let save = |renderer: &mut Renderer, name: &str| -> Result<_, Box<dyn std::error::Error>> {
        let path = Path::new(&folder).join(name);
        let picture = renderer.render()?;
        picture.save(&path)?;
        println!("{}", path.display());
        Ok(picture)
    };
    let before = save(&mut renderer, "before.png")?;

    let ray = packed.cameras[0].frame(SIZE.0, SIZE.1).central_ray(PIXEL);
    let hit = packed.cast(&ray).ok_or("the pixel shows the sky")?;
    let grid = packed.instances()[hit.instance as usize].grid;
    let center = hit.voxel.as_dvec3() + DVec3::splat(0.5);
    let mut scene = DynamicScene::new(packed)?;
    let lamp = scene.add_material(&Material::from_srgb([255, 70, 20]).glowing(3.0))?;
    let start = Instant::now();
    scene.edit(grid, &Edit::Fill { shape: Shape::Sphere { center, radius: 20.0 }, material: None })?;
    scene.edit(grid, &Edit::Fill { shape: Shape::Sphere { center, radius: 8.0 }, material: Some(lamp) })?;
    renderer.patch(&scene.take_patch())?;
    println!(
        "two edits and the first patch, which copies the scene, took {:.2} ms",
        start.elapsed().as_secs_f64() * 1e3
    );
    let edited = save(&mut renderer, "edited.png")?;

    scene.undo()?;
    scene.undo()?;
    renderer.patch(&scene.take_patch())?;
    let undone = save(&mut renderer, "undone.png")?;
    let is_that_from_before = |picture: &Picture| picture.film().pixels == before.film().pixels;
    let which = |picture| if is_that_from_before(picture) { "the picture from before" } else { "another one" };
    println!("undone, it is {}; edited, it is {}", which(&undone), which(&edited));
    Ok(())
}
