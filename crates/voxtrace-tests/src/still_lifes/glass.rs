//! A table before a window: bottles, a carafe and glasses with drinks, marbles clear and frosted, fruit, a candle in its lantern.

use super::{Builder, Vessel, one_of, tile};
use voxtrace::glam::{IVec3, Vec2, Vec3};
use voxtrace::{Camera, Material, Scene, Sky, Sun};

/// A linear colour of sRGB bytes.
fn color(srgb: [u8; 3]) -> Vec3 {
    Material::from_srgb(srgb).base_color
}

pub fn scene() -> Scene {
    let mut builder = Builder::default();
    table_and_wall(&mut builder);
    vessels(&mut builder);
    solids(&mut builder);
    let mut scene = builder.into_scene("glass");
    let direction = Vec3::new(-0.75, -0.35, 0.62).normalize();
    let sun = Sun { direction, angular_radius: 0.2, irradiance: Vec3::new(3.2, 2.9, 2.4) };
    scene.sky = Sky::gradient(Vec3::new(0.3, 0.3, 0.32), Vec3::new(0.55, 0.8, 1.25)).with_sun(sun);
    let (eye, target) = (Vec3::new(165.0, -190.0, 112.0), Vec3::new(163.0, 90.0, 38.0));
    scene.cameras.push(Camera { name: "table".into(), fov_y: 32.0, ..Camera::look_at(eye, target) });
    scene
}

fn table_and_wall(builder: &mut Builder) {
    let oak = builder.shades([150, 104, 62], |material| Material { specular: 0.5, roughness: 0.35, ..material });
    let tiles = builder.shades([226, 219, 200], |material| Material { specular: 1.0, roughness: 0.2, ..material });
    let blue = builder.material(Material::plastic(color([58, 92, 140]), 0.2));
    let grout = builder.material(Material::from_srgb([150, 145, 138]));
    let frame = builder.material(Material::from_srgb([236, 234, 228]));
    builder.fill(Vec3::new(-40.0, -20.0, -5.0), Vec3::new(370.0, 180.0, 0.0), |at| {
        let (plank, is_gap) = tile(Vec2::new(at.y, at.x), Vec2::new(22.0, 190.0), 1.0);
        let grain = IVec3::new(plank.x, (at.x / 23.0) as i32, (at.y / 3.0) as i32);
        (!is_gap || at.z < -2.0).then(|| one_of(oak, grain))
    });
    builder.fill(Vec3::new(-40.0, 180.0, -5.0), Vec3::new(370.0, 188.0, 210.0), |at| {
        let across = Vec2::new(at.x - 165.0, at.z - 112.0);
        let is_window = across.x.abs() < 66.0 && across.y.abs() < 60.0;
        let is_bar = across.x.abs() < 2.5 || across.y.abs() < 2.5;
        let is_frame = across.x.abs() < 72.0 && across.y.abs() < 66.0;
        let (cell, is_gap) = tile(Vec2::new(at.x, at.z), Vec2::splat(18.0), 1.0);
        match () {
            () if is_window => (is_bar && at.y > 183.0).then_some(frame),
            () if is_frame => Some(frame),
            () if is_gap => Some(grout),
            () if (cell.x + cell.y) % 5 == 0 => Some(blue),
            () => Some(one_of(tiles, cell)),
        }
    });
}

fn vessels(builder: &mut Builder) {
    let clear = builder.material(Material::glass(1.5, 0.0));
    let green = builder.material(Material::glass(1.5, 0.0).tinted(color([60, 140, 70]), 5.0));
    let amber = builder.material(Material::glass(1.5, 0.0).tinted(color([210, 120, 30]), 6.0));
    let water = builder.material(Material::glass(1.33, 0.0).tinted(color([225, 242, 250]), 60.0));
    let wine = builder.material(Material::glass(1.34, 0.0).tinted(color([150, 12, 30]), 9.0));
    let whisky = builder.material(Material::glass(1.35, 0.0).tinted(color([214, 130, 40]), 16.0));
    let ice = builder.material(Material::glass(1.31, 0.0));
    let of = |glass, wall, bottom, drink| Vessel { glass, wall, bottom, drink };
    let bottle = [(0.0, 15.0), (55.0, 15.0), (70.0, 6.0), (92.0, 5.5), (93.0, 7.0), (97.0, 7.0), (98.0, 5.0)];
    builder.vessel(Vec3::new(70.0, 118.0, 0.0), &bottle, &of(green, 2.2, 4.0, Some((44.0, wine))));
    builder.vessel(Vec3::new(268.0, 128.0, 0.0), &bottle, &of(amber, 2.2, 4.0, None));
    let carafe = [(0.0, 18.0), (18.0, 25.0), (36.0, 19.0), (56.0, 9.0), (72.0, 14.0)];
    builder.vessel(Vec3::new(128.0, 78.0, 0.0), &carafe, &of(clear, 2.0, 3.0, Some((33.0, water))));
    let tumbler = [(0.0, 13.0), (34.0, 15.0)];
    builder.vessel(Vec3::new(192.0, 48.0, 0.0), &tumbler, &of(clear, 2.0, 5.0, Some((17.0, whisky))));
    builder.fill(Vec3::new(187.0, 44.0, 11.0), Vec3::new(197.0, 54.0, 21.0), |_| Some(ice));
    let cup =
        [(0.0, 13.0), (1.5, 13.0), (3.0, 2.5), (30.0, 2.0), (34.0, 8.0), (43.0, 15.5), (56.0, 17.0), (76.0, 13.0)];
    builder.vessel(Vec3::new(232.0, 88.0, 0.0), &cup, &of(clear, 1.6, 34.0, Some((53.0, wine))));
    builder.vessel(Vec3::new(180.0, 132.0, 0.0), &cup, &of(clear, 1.6, 34.0, None));
}

fn solids(builder: &mut Builder) {
    let blue = builder.material(Material::glass(1.5, 0.0).tinted(color([70, 120, 220]), 20.0));
    let frosted = builder.material(Material::glass(1.5, 0.3).tinted(color([240, 190, 200]), 20.0));
    let peel = builder.shades([236, 132, 28], |material| Material { specular: 0.6, roughness: 0.4, ..material });
    let lemon = builder.shades([238, 208, 60], |material| Material { specular: 0.6, roughness: 0.4, ..material });
    let brass = builder.material(Material::metal(color([220, 180, 100]), 0.25));
    let wax = builder.material(Material::from_srgb([240, 228, 200]));
    let flame = builder.material(Material::emissive(Vec3::new(60.0, 34.0, 12.0)));
    let pane = builder.material(Material::glass(1.5, 0.0));
    builder.ball(Vec3::new(88.0, 36.0, 17.0), 17.0, |_| blue);
    builder.ball(Vec3::new(258.0, 44.0, 15.0), 15.0, |_| frosted);
    builder.ball(Vec3::new(150.0, 26.0, 8.0), 8.0, |_| blue);
    builder.ball(Vec3::new(300.0, 84.0, 14.0), 14.0, |at| one_of(peel, (at / 2.0).floor().as_ivec3()));
    builder.ball(Vec3::new(318.0, 60.0, 11.0), 11.0, |at| one_of(lemon, (at / 2.0).floor().as_ivec3()));
    let foot = Vec3::new(28.0, 72.0, 0.0);
    builder.turned(foot, &[(0.0, 19.0), (4.0, 19.0)], |_| brass);
    let shade = Vessel { glass: pane, wall: 2.0, bottom: -1.0, drink: None };
    builder.vessel(foot + Vec3::Z * 4.0, &[(0.0, 17.0), (44.0, 17.0)], &shade);
    builder.turned(foot + Vec3::Z * 4.0, &[(0.0, 6.0), (20.0, 6.0)], |_| wax);
    builder.turned(foot + Vec3::Z * 24.0, &[(0.0, 1.5), (3.0, 3.0), (9.0, 0.5)], |_| flame);
    builder.turned(foot + Vec3::Z * 48.0, &[(0.0, 19.0), (4.0, 12.0), (10.0, 4.0)], |_| brass);
}
