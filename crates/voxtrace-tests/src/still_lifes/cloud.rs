//! A village by a lake under clouds: mist on the water, smoke over a chimney, a lighthouse.

use super::{Builder, one_of};
use voxtrace::glam::{IVec3, Vec2, Vec3};
use voxtrace::scenes::kit::noise::{fractal_noise, hash3, smooth_step, unit};
use voxtrace::{Camera, Material, Scene, Sky, Sun};

/// Edge of the land, and where the water stands.
const EDGE: f32 = 420.0;
const WATER: f32 = 14.0;

/// Height of the land.
fn land(at: Vec2) -> f32 {
    let hills = 34.0 * fractal_noise(Vec3::new(at.x / 110.0, at.y / 110.0, 0.5), 4, 7);
    let basin = smooth_step(60.0, 170.0, at.distance(Vec2::new(230.0, 130.0)));
    6.0 + basin * (26.0 + hills) + smooth_step(250.0, 420.0, at.y) * 46.0
}

pub fn scene() -> Scene {
    let mut builder = Builder::default();
    ground(&mut builder);
    trees(&mut builder);
    village(&mut builder);
    air(&mut builder);
    let mut scene = builder.into_scene("cloud");
    let direction = Vec3::new(-0.7, -0.25, 0.5).normalize();
    let sun = Sun { direction, angular_radius: 0.02, irradiance: Vec3::new(4.2, 3.6, 2.8) };
    scene.sky = Sky::gradient(Vec3::new(0.5, 0.52, 0.55), Vec3::new(0.35, 0.6, 1.1)).with_sun(sun);
    let (eye, target) = (Vec3::new(220.0, -150.0, 108.0), Vec3::new(208.0, 210.0, 66.0));
    scene.cameras.push(Camera { name: "lake".into(), fov_y: 40.0, ..Camera::look_at(eye, target) });
    scene
}

fn ground(builder: &mut Builder) {
    let grass = builder.shades([104, 134, 62], |material| material);
    let rock = builder.shades([126, 120, 112], |material| material);
    let sand = builder.shades([204, 186, 140], |material| material);
    let water = builder.material(Material { specular: 1.0, roughness: 0.03, ..Material::from_srgb([28, 62, 78]) });
    for column in 0..(EDGE * EDGE) as i32 {
        let (x, y) = (column % EDGE as i32, column / EDGE as i32);
        let at = Vec2::new(x as f32, y as f32);
        let top = land(at);
        let slope = (land(at + Vec2::X) - top).abs() + (land(at + Vec2::Y) - top).abs();
        let cell = IVec3::new(x / 2, y / 2, 0);
        let material = match () {
            () if top < WATER + 2.0 => one_of(sand, cell),
            () if slope > 1.1 || top > 74.0 => one_of(rock, cell),
            () => one_of(grass, cell),
        };
        let bottom = (top as i32 - 5).max(0);
        (bottom..=top as i32).for_each(|z| _ = builder.grid.set(IVec3::new(x, y, z), material));
        if top + 1.0 < WATER {
            builder.grid.set(IVec3::new(x, y, WATER as i32), water);
        }
    }
}

fn trees(builder: &mut Builder) {
    let leaves = [[58, 96, 44], [82, 112, 48], [150, 110, 44]].map(|color| builder.shades(color, |material| material));
    let bark = builder.material(Material::from_srgb([86, 64, 46]));
    for number in 0..420 {
        let random = |dimension: i32| unit(hash3(IVec3::new(number, dimension, 3), 11));
        let at = Vec2::new(random(0), random(1)) * (EDGE - 30.0) + 15.0;
        let z = land(at);
        if !(WATER + 6.0..=80.0).contains(&z) || at.distance(Vec2::new(120.0, 210.0)) < 62.0 {
            continue;
        }
        let (height, shades) = (12.0 + 12.0 * random(2), leaves[(random(3) * 2.3) as usize]);
        let foot = at.extend(z.floor());
        builder.turned(foot, &[(0.0, 1.6), (height * 0.4, 1.2)], |_| bark);
        let crown =
            [(0.0, height * 0.36), (height * 0.3, height * 0.24), (height * 0.3 + 0.1, height * 0.3), (height, 0.4)];
        let shade = |at: Vec3| one_of(shades, at.floor().as_ivec3() + IVec3::splat(number));
        if random(4) < 0.6 {
            builder.turned(foot + Vec3::Z * (height * 0.3).floor(), &crown, shade);
        } else {
            builder.ball(foot + Vec3::Z * height * 0.75, height * 0.42, shade);
        }
    }
}

fn village(builder: &mut Builder) {
    let walls =
        [[232, 224, 206], [214, 190, 150], [196, 204, 210]].map(|color| builder.material(Material::from_srgb(color)));
    let roofs = builder.shades([158, 70, 48], |material| material);
    let [timber, door] = [[78, 56, 40], [60, 80, 96]].map(|color| builder.material(Material::from_srgb(color)));
    let lit = builder.material(Material::from_srgb([255, 206, 130]).glowing(4.0));
    for number in 0..16 {
        let random = |dimension: i32| unit(hash3(IVec3::new(number, dimension, 5), 23));
        let middle = Vec2::new(84.0 + (number % 4) as f32 * 27.0 + 6.0 * random(0), 168.0 + (number / 4) as f32 * 26.0);
        let (half, height) = (Vec2::new(7.0 + 3.0 * random(1), 9.0), 11.0 + 3.0 * random(2));
        let (foot, wall) = (land(middle).floor(), walls[number as usize % 3]);
        let low = (middle - half - 2.0).extend(foot - 8.0);
        builder.fill(low, (middle + half + 2.0).extend(foot + height + 12.0), |at| {
            let off = (at.truncate() - middle).abs() - half;
            let (z, ridge) = (at.z - foot, (at.x - middle.x).abs());
            if z > height {
                let is_roof = off.y < 2.0 && (z - height) < (half.x + 2.0 - ridge);
                return is_roof.then(|| one_of(roofs, (at / 2.0).floor().as_ivec3()));
            }
            let is_window = (4.0..8.0).contains(&z) && (at.x - middle.x + 40.0) % 6.0 < 2.5 && ridge < half.x - 2.0;
            let is_door = z < 6.0 && ridge < 1.6;
            let is_beam = z > height - 1.0 || off.x > -1.0 && off.y > -1.0;
            let material = match () {
                () if is_beam => timber,
                () if is_door => door,
                () if is_window && off.y > -1.0 => {
                    if number % 3 == 0 {
                        lit
                    } else {
                        door
                    }
                }
                () => wall,
            };
            (off.max_element() < 0.0).then_some(material)
        });
    }
    let foot = Vec3::new(330.0, 150.0, land(Vec2::new(330.0, 150.0)).floor() - 2.0);
    let red = builder.material(Material::from_srgb([190, 48, 40]));
    let tower = [(0.0, 12.0), (62.0, 8.0), (62.1, 10.0), (65.0, 10.0)];
    builder.turned(foot, &tower, |at| if (at.z / 13.0) as i32 % 2 == 0 { walls[0] } else { red });
    let lamp = builder.material(Material::emissive(Vec3::new(30.0, 26.0, 16.0)));
    builder.turned(foot + Vec3::Z * 65.0, &[(0.0, 4.0), (8.0, 4.0)], |_| lamp);
    builder.turned(foot + Vec3::Z * 73.0, &[(0.0, 9.0), (9.0, 0.5)], |_| red);
}

/// Clouds, mist and smoke.
fn air(builder: &mut Builder) {
    let cloud = builder.material(Material::cloud(Vec3::splat(0.995), 0.12, 0.5));
    let mist = builder.material(Material::cloud(Vec3::splat(0.99), 0.012, 0.3));
    let smoke = builder.material(Material::cloud(Vec3::splat(0.7), 0.15, 0.2));
    let rough = |at: Vec3| fractal_noise(at / 22.0, 4, 31);
    for (middle, radius) in [
        (Vec3::new(96.0, 300.0, 158.0), Vec3::new(72.0, 44.0, 22.0)),
        (Vec3::new(140.0, 290.0, 172.0), Vec3::new(44.0, 36.0, 24.0)),
        (Vec3::new(318.0, 250.0, 152.0), Vec3::new(66.0, 40.0, 20.0)),
        (Vec3::new(290.0, 258.0, 164.0), Vec3::new(36.0, 30.0, 20.0)),
        (Vec3::new(222.0, 110.0, 128.0), Vec3::new(34.0, 24.0, 10.0)),
    ] {
        builder.fill(middle - radius * 1.3, middle + radius * 1.3, |at| {
            let distance = ((at - middle) / radius).length();
            (distance + 0.55 * rough(at) < 0.9).then_some(cloud)
        });
    }
    let above = WATER + 1.0;
    builder.fill(Vec3::new(120.0, 30.0, above), Vec3::new(340.0, 240.0, above + 22.0), |at| {
        let thickness = 9.0 + 12.0 * fractal_noise(Vec3::new(at.x / 40.0, at.y / 40.0, 3.0), 3, 5);
        let is_over_water = land(at.truncate()) + 1.0 < WATER;
        (is_over_water && at.z - above < thickness).then_some(mist)
    });
    // Never a voxel of what stands there.
    let grid = builder.grid.clone();
    for puff in 0..14 {
        let rise = puff as f32;
        let middle = Vec3::new(92.0 + 2.2 * rise, 172.0 + 0.3 * rise * rise, 70.0 + 6.0 * rise);
        let radius = 3.5 + 0.55 * rise;
        builder.fill(middle - radius, middle + radius, |at| {
            let is_in = at.distance(middle) + 4.0 * rough(at * 2.0) < radius;
            (is_in && grid.get(at.floor().as_ivec3()).is_none()).then_some(smoke)
        });
    }
}
