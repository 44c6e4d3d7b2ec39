//! Probability densities of light sampling: the density that sampling returns, the one computed for a ray that hits the light by
//! chance, and the observed frequency agree.

use glam::{IVec3, Mat3, Vec3};
use std::f32::consts::TAU;
use voxtrace::{Instance, Material, PackedScene, Ray, Scene, Sky, Sun, Transform, VoxelGrid};
use voxtrace_core::light::{LightSample, Lights, Receiver};
use voxtrace_core::math::normalize;
use voxtrace_core::walk;
use voxtrace_tests::random::Random;
use voxtrace_tests::rooms;

/// Hundreds of small lamps of different strength, some of them turned and enlarged.
fn many_lamps() -> Scene {
    let mut random = Random(5);
    let materials = (0..8).map(|step| Material::emissive(Vec3::new(1.0, 2.0, 0.5) * (step * step) as f32)).collect();
    let mut scene = Scene { sky: Sky::black(), ..Scene::from_grid("many lamps", VoxelGrid::new(), materials) };
    for lamp in 0..40 {
        let mut grid = VoxelGrid::new();
        for _ in 0..30 {
            grid.set(random.voxel(IVec3::splat(-3), IVec3::splat(3)), random.below(8) as u16);
        }
        let linear = match lamp % 2 {
            0 => Mat3::IDENTITY,
            _ => Mat3::from_axis_angle(random.direction(), random.unit() * TAU) * (0.5 + random.unit()),
        };
        let translation = random.point(Vec3::splat(-60.0), Vec3::splat(60.0));
        scene.add_instance(grid, Transform { linear, translation });
    }
    scene
}

/// Instances of two grids, all turned, mirrored or of another size: their lamps share one tree a grid.
fn shared_lamps() -> Scene {
    let mut random = Random(6);
    let materials = vec![Material::emissive(Vec3::new(1.0, 2.0, 0.5)), Material::emissive(Vec3::splat(20.0))];
    let mut scene = Scene { sky: Sky::black(), ..Scene::from_grid("shared lamps", VoxelGrid::new(), materials) };
    for kind in 0..2 {
        let mut grid = VoxelGrid::new();
        for _ in 0..60 {
            grid.set(random.voxel(IVec3::splat(-4), IVec3::splat(4 + 3 * kind)), random.below(2) as u16);
        }
        scene.grids.push(grid.into());
    }
    for lamp in 0..50 {
        let turned = Mat3::from_axis_angle(random.direction(), random.unit() * TAU) * (0.4 + random.unit());
        let linear = if lamp % 3 == 0 { turned * -1.0 } else { turned };
        let translation = random.point(Vec3::splat(-60.0), Vec3::splat(60.0));
        scene.instances.push(Instance::new(1 + lamp % 2, Transform { linear, translation }));
    }
    scene
}

fn receivers(count: usize) -> impl Iterator<Item = Receiver> {
    let mut random = Random(17);
    (0..count).map(move |_| {
        let point = random.point(Vec3::new(3.0, 3.0, 2.0), Vec3::new(21.0, 9.0, 12.0));
        Receiver::on_surface(point, random.direction())
    })
}

/// The hit of the ray towards a sampled light, if it hits that light.
fn meet(scene: &PackedScene, sample: &LightSample) -> Option<(Ray, voxtrace::Hit)> {
    let length = sample.ray.direction.length();
    let ray = Ray { t_max: f32::INFINITY, direction: normalize(sample.ray.direction), ..sample.ray };
    let hit = walk::cast(scene, &ray);
    if hit.is_miss() || walk::occluded(scene, &sample.ray) {
        return None;
    }
    let grid_from_world = &scene.instances()[hit.instance as usize].grid_from_world;
    let target = grid_from_world.point(sample.ray.at(1.0));
    let chosen = target - hit.face().normal().as_vec3() * 0.5;
    // A point before the edge of a face may belong to the neighbouring voxel's.
    let from_edge = (0..3).filter(|&axis| axis != hit.face().axis()).map(|axis| (target - target.round()).abs()[axis]);
    let is_on_one_face = from_edge.fold(1.0, f32::min) > 0.002;
    let is_chosen = length > 2.0 && is_on_one_face && chosen.floor().as_ivec3() == hit.voxel;
    is_chosen.then_some((ray, hit))
}

#[test]
fn the_density_of_a_chosen_emitter_is_that_of_meeting_it_by_chance() {
    for scene in [rooms::lamp_room(), many_lamps(), shared_lamps()] {
        let scene = PackedScene::pack(&scene).unwrap();
        let lights = Lights::new(&scene);
        let mut random = Random(2);
        let mut check = |factor: f32| {
            let mut met = 0;
            for receiver in receivers(3000) {
                let u = std::array::from_fn(|_| random.unit());
                let Some(sample) = lights.sample(&receiver, u) else { continue };
                let Some((ray, hit)) = meet(&scene, &sample) else { continue };
                let ratio = lights.emitter_pdf(&receiver, &ray, &hit) * factor / sample.pdf;
                // The point that was chosen lies 1/1024 voxel in front of the face; a grazing ray meets the face farther on.
                let normal = scene.instances()[hit.instance as usize].world_normal(hit.face());
                if normal.dot(ray.direction) < -0.1 && (ratio - 1.0).abs() > 0.02 {
                    return Err(format!("{receiver:?} {sample:?} {hit:?}: {ratio}"));
                }
                met += 1;
            }
            if met > 500 { Ok(()) } else { Err(format!("only {met} lights were met")) }
        };
        check(1.0).unwrap();
        check(1.05).unwrap_err();
    }
}

#[test]
fn the_density_integrates_to_the_share_of_choices_that_are_seen() {
    for scene in [rooms::lamp_room(), many_lamps(), shared_lamps()] {
        let scene = PackedScene::pack(&scene).unwrap();
        let lights = Lights::new(&scene);
        let mut random = Random(9);
        for receiver in receivers(12) {
            let choices = 20_000;
            let seen = (0..choices)
                .filter_map(|_| lights.sample(&receiver, std::array::from_fn(|_| random.unit())))
                .filter(|sample| !walk::occluded(&scene, &sample.ray))
                .count();
            let share = seen as f64 / f64::from(choices);

            let steps = 500;
            let (tangent, bitangent) = receiver.normal.any_orthonormal_pair();
            let mut integral = 0.0;
            for index in 0..steps * steps {
                let (u, v) = ((index / steps) as f32 + random.unit(), (index % steps) as f32 + random.unit());
                let (height, turn) = (u / steps as f32, v / steps as f32 * TAU);
                let aside = tangent * turn.cos() + bitangent * turn.sin();
                let direction = receiver.normal * height + aside * (1.0 - height * height).sqrt();
                let ray = Ray::new(receiver.point, direction);
                let hit = walk::cast(&scene, &ray);
                if !hit.is_miss() {
                    integral += f64::from(lights.emitter_pdf(&receiver, &ray, &hit));
                }
            }
            integral *= f64::from(TAU) / f64::from(steps * steps);
            let check = |integral: f64| (integral - share).abs() < 0.02 * share + 0.01;
            assert!(check(integral), "{receiver:?}: {integral}, {share}");
            assert!(share < 0.4 || !check(integral * 1.1), "ten per cent too much is noticed");
        }
    }
}

#[test]
fn every_light_that_shines_on_a_place_can_be_chosen() {
    [many_lamps(), shared_lamps()].iter().for_each(check_that_all_can_be_chosen);
}

fn check_that_all_can_be_chosen(scene: &Scene) {
    let packed = PackedScene::pack(scene).unwrap();
    let check = |lights: &Lights| {
        let mut random = Random(3);
        for receiver in receivers(4000) {
            let ray = Ray::new(receiver.point, random.direction());
            let hit = walk::cast(&packed, &ray);
            let is_lit = !hit.is_miss()
                && hit.t > 0.01
                && ray.direction.dot(receiver.normal) > 1e-3
                && packed.material(&hit).emission.max_element() > 0.0;
            if is_lit && lights.emitter_pdf(&receiver, &ray, &hit) <= 0.0 {
                return Err(format!("{receiver:?} {hit:?}"));
            }
        }
        Ok(())
    };
    check(&Lights::new(&packed)).unwrap();
    let mut nodes = packed.geometry().light_nodes().to_vec();
    nodes.iter_mut().for_each(|node| node.power[1..].fill(0.0));
    let mut blind = packed.clone();
    blind.set_light_nodes(nodes).unwrap();
    check(&Lights::new(&blind)).unwrap_err();
}

#[test]
fn the_sun_is_chosen_with_its_density_beside_emitters() {
    let direction = Vec3::new(0.0, 0.6, 0.8);
    let sun = Sun { direction, angular_radius: 0.1, irradiance: Vec3::splat(50.0) };
    let scene = Scene { sky: Sky::study(1.0).with_sun(sun), ..many_lamps() };
    let scene = PackedScene::pack(&scene).unwrap();
    let lights = Lights::new(&scene);
    let mut random = Random(4);
    let mut shares = Vec::new();
    for receiver in receivers(200) {
        let choices = 2000;
        let to_sun = (0..choices)
            .filter_map(|_| lights.sample(&receiver, std::array::from_fn(|_| random.unit())))
            .filter(|sample| sample.ray.t_max.is_infinite())
            .inspect(|sample| {
                assert!(
                    lights.sun.unwrap().contains(normalize(sample.ray.direction))
                        || sample.ray.direction.dot(direction) < 0.996
                );
                assert!((sample.pdf / lights.sun_pdf(&receiver, direction) - 1.0).abs() < 1e-5);
            })
            .count();
        if receiver.normal.dot(direction) > 0.1 {
            // The disc's solid angle times its density is the probability of choosing the sun.
            let expected =
                f64::from(lights.sun_pdf(&receiver, direction)) * std::f64::consts::TAU * (1.0 - 0.1_f64.cos());
            let share = to_sun as f64 / f64::from(choices);
            assert!((share - expected).abs() < 0.06, "{share} {expected}");
            shares.push(share);
        } else if receiver.normal.dot(direction) < -0.1 {
            assert_eq!(to_sun, 0);
        }
    }
    assert!(shares.iter().any(|&share| share < 0.4) && shares.iter().any(|&share| share > 0.6), "{shares:?}");
}
