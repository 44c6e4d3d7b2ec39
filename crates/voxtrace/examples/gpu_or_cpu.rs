//! The best device that there is: a GPU where one is found, else the processor. The picture is the same.
//! `cargo run --release --example gpu_or_cpu -- city.png`

use voxtrace::{Renderer, scenes};
use voxtrace_vulkan::{Request, choose};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args().nth(1).unwrap_or("gpu_or_cpu.png".into());
    let choice = choose(&Request::default())?;
    println!("{}", choice.reason);
    let scene = scenes::generate("city", Some(500_000))?;
    Renderer::new(&scene)?.tracer(choice.tracer).camera("roofs").size(400, 225).samples(32).render()?.save(&path)?;
    println!("{path}");
    Ok(())
}
