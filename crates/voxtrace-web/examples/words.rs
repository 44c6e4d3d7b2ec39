//! What this machine gives where pages ask the module of WebAssembly, for tests that compare: `words selftest EDGE` prints the checksums of
//! functions, `words rays SCENE RAYS` the hits in a scene's file of the rays in another (eight little-endian floats each), a line of words each.

use voxtrace_web::{WebScene, selftest};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let given: Vec<String> = std::env::args().skip(1).collect();
    match given.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["selftest", edge] => selftest(edge.parse()?).iter().for_each(|line| println!("{line}")),
        ["rays", scene, rays] => {
            let rays = std::fs::read(rays)?;
            let rays: Vec<f32> = rays.chunks_exact(4).map(bytemuck::pod_read_unaligned).collect();
            let scene = WebScene::read(std::fs::read(scene)?, scene).map_err(|_| "the scene cannot be read")?;
            let words = scene.cast(&rays, &[]).map_err(|_| "the rays are not whole")?;
            for hit in words.chunks_exact(6) {
                println!("{}", hit.iter().map(|word| format!("{word:08x}")).collect::<Vec<_>>().join(" "));
            }
        }
        _ => return Err("usage: words selftest EDGE | rays SCENE RAYS".into()),
    }
    Ok(())
}
