//! One table of what each set of instructions gives: ray after ray, AVX2 and AVX-512, each on the same rays and in the same rounds as Embree, held to
//! the same instructions.

use crate::contender::{Contender, Walk};
use crate::ray_sets::RaySet;
use crate::rounds::{self, Measured, spread};
use std::time::Duration;
use voxtrace::{PackedScene, Scene};
use voxtrace_core::walk::Instructions;

/// The sets of the table.
pub const SETS: [Instructions; 3] = [Instructions::Scalar, Instructions::Avx2, Instructions::Avx512];

/// The first lines of the table.
pub fn head() -> String {
    let mut text =
        "| scene | rays | scalar | AVX2 | × Embree with AVX2 | AVX-512 | × Embree with AVX-512 |\n".to_owned();
    text += "|---|---|---:|---:|---:|---:|---:|";
    text
}

/// The lines of one scene, and the same for programs.
pub fn rows(
    name: &str,
    scene: &Scene,
    packed: &PackedScene,
    sets: &[RaySet],
    rounds: usize,
) -> (String, serde_json::Value) {
    let mut cells: Vec<Vec<String>> = sets.iter().map(|set| vec![name.to_owned(), set.name.to_owned()]).collect();
    let mut all = Vec::new();
    for instructions in SETS {
        let available = instructions.is_available();
        let mut contenders = contenders(instructions, scene, packed, available);
        let names: Vec<String> = contenders.iter().map(|contender| contender.name()).collect();
        for (set, cells) in sets.iter().zip(&mut cells) {
            let measured = rounds::measure(&mut contenders, set, if available { rounds } else { 0 });
            if !available {
                cells.extend(["–".to_owned(), "–".to_owned()]);
                continue;
            }
            let ours = &measured[1];
            cells.push(format!("{:.2}", spread(ours.mrays.iter().copied())[0]));
            if instructions != Instructions::Scalar {
                cells.push(advantage(&names, ours, &measured[2..]));
            }
            for (name, measured) in names.iter().zip(&measured) {
                let Measured { way, mrays, mismatches } = measured;
                let (instructions, rays) = (instructions.name(), set.name);
                all.push(serde_json::json!({
                    "instructions": instructions, "rays": rays, "contender": name, "cast_by": way,
                    "mrays_per_s_by_round": mrays, "other_voxel": mismatches,
                }));
            }
        }
    }
    let lines: Vec<String> = cells.into_iter().map(|cells| format!("| {} |", cells.join(" | "))).collect();
    (lines.join("\n"), serde_json::json!({ "scene": name, "measured": all }))
}

/// Ray after ray, which hits are compared with; then ours and Embree's ways by some instructions.
fn contenders<'a>(
    instructions: Instructions,
    scene: &Scene,
    packed: &'a PackedScene,
    available: bool,
) -> Vec<Box<dyn Contender + 'a>> {
    let contenders: Vec<Box<dyn Contender>> = vec![
        Box::new(Walk::reference(packed, Duration::ZERO)),
        Box::new(Walk::by(packed, Duration::ZERO, instructions)),
    ];
    if instructions == Instructions::Scalar || !available {
        return contenders;
    }
    #[cfg(feature = "embree")]
    if let [grid] = &scene.grids[..] {
        let config = if instructions == Instructions::Avx2 { c"isa=avx2" } else { c"" };
        let table_bytes = size_of_val(packed.materials()) as u64;
        contenders.push(Box::new(crate::embree::Boxes::build(grid, table_bytes, config)));
        contenders.push(Box::new(crate::embree::Quads::build(grid, table_bytes, config)));
    }
    #[cfg(not(feature = "embree"))]
    let _ = scene;
    contenders
}

/// How many times as fast as the faster of Embree's ways we are: median, least and most of the rounds, and which way that is.
fn advantage(names: &[String], ours: &Measured, embree: &[Measured]) -> String {
    let median = |measured: &Measured| spread(measured.mrays.iter().copied())[0];
    let faster = embree.iter().enumerate().max_by(|(_, a), (_, b)| median(a).total_cmp(&median(b)));
    let Some((index, theirs)) = faster else { return "–".to_owned() };
    let [ratio, least, most] = spread(ours.mrays.iter().zip(&theirs.mrays).map(|(ours, theirs)| ours / theirs));
    let shape = names[2 + index].rsplit(", ").next().unwrap_or_default();
    format!("{ratio:.2} ({least:.2} to {most:.2}; {shape}, {}, {:.2})", theirs.way, median(theirs))
}
