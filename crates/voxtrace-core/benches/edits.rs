//! `cargo bench -p voxtrace-core --bench edits -- church 100000`: what edits of a built-in scene cost until the CPU tracer has them, what repairing
//! skip distances costs then and after they are undone, and how much memory many random ones take. Medians, milliseconds, and the bytes of a patch. A third argument is a part of the names of rows to be measured
//! alone.

use std::error::Error;
use std::sync::Arc;
use std::time::Instant;
use voxtrace_core::{CpuTracer, DynamicScene, Edit, PackedScene, Tracer};
use voxtrace_scene::glam::{DVec3, IVec3};
use voxtrace_scene::{Shape, grid::VoxelBox};

const TIMES: usize = 40;

struct Random(u64);

impl Random {
    fn below(&mut self, most: u32) -> u32 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) as u32) % most.max(1)
    }

    fn within(&mut self, min: IVec3, max: IVec3) -> IVec3 {
        let size = (max - min).as_uvec3();
        min + IVec3::new(self.below(size.x) as i32, self.below(size.y) as i32, self.below(size.z) as i32)
    }
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

fn timed<T>(work: impl FnOnce() -> T) -> (f64, T) {
    let start = Instant::now();
    let result = work();
    (start.elapsed().as_secs_f64() * 1e3, result)
}

fn voxel(at: IVec3) -> Shape {
    Shape::Box(VoxelBox { min: at, max: at + 1 })
}

fn sphere(at: IVec3, radius: f64) -> Shape {
    Shape::Sphere { center: at.as_dvec3() + DVec3::splat(0.5), radius }
}

/// Edits, patch and the tracer that follows; then undone. Skip distances are repaired each time, after the tracer has the patch.
fn measure(
    name: &str,
    scene: &mut DynamicScene,
    tracer: &mut CpuTracer,
    mut next: impl FnMut() -> Edit,
) -> Result<(), Box<dyn Error>> {
    let (mut edits, mut patches, mut undos, mut bytes) = (vec![], vec![], vec![], vec![]);
    let (mut repairs, mut repairs_of_undos) = (vec![], vec![]);
    for _ in 0..TIMES {
        let edit = next();
        let (time, edited) = timed(|| scene.edit(0, &edit));
        if edited?.bricks == 0 {
            continue;
        }
        edits.push(time);
        let (time, patch) = timed(|| {
            let patch = scene.take_patch();
            tracer.patch(&patch).map(|()| patch)
        });
        patches.push(time);
        bytes.push(patch?.size_bytes() as f64);
        repairs.push(timed(|| scene.repair(usize::MAX)).0);
        let (time, undone) = timed(|| scene.undo());
        undone?;
        undos.push(time);
        repairs_of_undos.push(timed(|| scene.repair(usize::MAX)).0);
        tracer.patch(&scene.take_patch())?;
    }
    let (edit, patch, undo, bytes) = (median(edits), median(patches), median(undos), median(bytes));
    let (repair, after_undo) = (median(repairs), median(repairs_of_undos));
    println!(
        "{name:<34} {edit:>9.3} {patch:>9.3} {:>9.3} {undo:>9.3} {repair:>9.3} {after_undo:>9.3} {bytes:>11.0}",
        edit + patch
    );
    Ok(())
}

fn grow(scene: &mut DynamicScene, random: &mut Random, count: u32, materials: u32) -> Result<(), Box<dyn Error>> {
    let grid = scene.scene().grids()[0];
    scene.set_undo_limit(1 << 20);
    let (time, result) = timed(|| {
        for number in 0..count {
            let at = random.within(grid.min, grid.max);
            let material = (random.below(2) == 0).then(|| random.below(materials) as u16);
            let shape = match random.below(20) {
                0 => sphere(at, f64::from(random.below(64)) / 8.0),
                _ => voxel(at),
            };
            scene.edit(0, &Edit::Fill { shape, material })?;
            if number % 1000 == 999 {
                scene.take_patch();
                scene.repair(64);
            }
        }
        Ok::<(), Box<dyn Error>>(())
    });
    result?;
    let bytes = |scene: &PackedScene| scene.statistics().total_bytes();
    let (own, compact) = (bytes(scene.scene()), bytes(&scene.compact()));
    println!(
        "{count} random edits: {:.3} ms each; {own} bytes, compact {compact}: {:.3} times",
        time / f64::from(count),
        own as f64 / compact as f64
    );
    let (time, ()) = timed(|| scene.settle());
    println!("settling then {time:.1} ms");
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1).filter(|argument| !argument.starts_with('-'));
    let name = arguments.next().unwrap_or_else(|| "church".into());
    let count: u32 = arguments.next().and_then(|count| count.parse().ok()).unwrap_or(100_000);
    let only = arguments.next().unwrap_or_default();
    let made = voxtrace_scenes::generate(&name, None)?;
    let (time, packed) = timed(|| PackedScene::pack(&made));
    let packed = packed?;
    println!("{name}: packing anew {time:.0} ms");
    drop(made);
    let (min, max, materials) = (packed.grids()[0].min, packed.grids()[0].max, packed.materials().len() as u32);
    let lamp = packed.geometry().emitters().first().map_or(0, |emitter| emitter.material as u16);
    let mut tracer = CpuTracer::new(None);
    tracer.set_scene(&Arc::new(packed.clone()))?;
    let (time, scene) = timed(|| DynamicScene::new(packed));
    let mut scene = scene?;
    println!("taking the scene {time:.1} ms");
    let columns = ["edit", "patch", "both", "undo", "repair", "after undo"].map(|name| format!("{name:>9}"));
    println!("{:<34} {} {:>11}", "", columns.join(" "), "bytes");
    let mut random = Random(7);
    for (radius, which) in [(0.0, "one voxel"), (16.0, "sphere, r = 16"), (64.0, "sphere, r = 64")] {
        for (what, material) in [("filled", Some(0)), ("filled with light", Some(lamp)), ("cleared", None)] {
            let places: Vec<IVec3> = std::iter::repeat_with(|| random.within(min, max))
                .filter(|&at| radius > 0.0 || material.is_some() || scene.voxel(0, at).is_some())
                .take(TIMES)
                .collect();
            let (mut places, name) = (places.into_iter().cycle(), format!("{which}, {what}"));
            if !name.contains(&only) {
                continue;
            }
            measure(&name, &mut scene, &mut tracer, || Edit::Fill {
                shape: sphere(places.next().unwrap_or(min), radius),
                material,
            })?;
        }
    }
    let hole = Edit::Fill { shape: sphere((min + max) / 2, 64.0), material: None };
    scene.settle();
    scene.edit(0, &hole)?;
    let (time, ()) = timed(|| scene.settle());
    println!("settling after a hole of r = 64: {time:.2} ms");
    grow(&mut scene, &mut random, count, materials)
}
