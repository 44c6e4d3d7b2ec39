//! Cameras from TOML: our own (`eye`, `target`, `up`, `fov_y`) and those of the study's program (`x`, `y`, `z`, `pitch`,
//! `yaw`, `fov`, `speed`, y up), which may also set the light.

use crate::failure::{Failure, reason};
use std::path::Path;
use voxtrace::Camera;
use voxtrace::camera::Lens;
use voxtrace::glam::{DVec3, Vec3};

/// What a camera file says.
#[derive(Debug, PartialEq)]
pub struct CameraFile {
    pub camera: Camera,
    pub sky_brightness: Option<f32>,
    pub light_intensity: Option<f32>,
}

/// Reads a camera file.
pub fn open(path: &Path) -> Result<CameraFile, Failure> {
    let failure = |message: String| {
        Failure::input(message).hint("it holds eye = [x, y, z], target = [x, y, z] and optionally up and fov_y")
    };
    voxtrace::import::opened::note(path);
    let text = std::fs::read_to_string(path)
        .map_err(|error| failure(format!("cannot read the camera file {}: {}", path.display(), reason(&error))))?;
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    parse(&text, &name).map_err(|reason| failure(format!("camera file {}: {reason}", path.display())))
}

fn parse(text: &str, name: &str) -> Result<CameraFile, String> {
    let file: toml::Table = text.parse().map_err(|error: toml::de::Error| error.message().to_owned())?;
    // The camera stands at the top, or in a table of its own; the study's program writes names of tables large.
    let table_of = |names: [&str; 2]| names.iter().find_map(|name| file.get(*name)?.as_table());
    let table = table_of(["camera", "Camera"]).unwrap_or(&file);
    let scene = table_of(["scene", "Scene"]).unwrap_or(&file);
    let camera = if table.contains_key("eye") { own_camera(table, name)? } else { study_camera(table, name)? };
    let light = |key| number(table, key).and_then(|own| own.map_or_else(|| number(scene, key), |own| Ok(Some(own))));
    let light = |key| match light(key)? {
        Some(value) if value < 0.0 => Err(format!("`{key}` is less than 0")),
        value => Ok(value.map(|value| value as f32)),
    };
    Ok(CameraFile { camera, sky_brightness: light("sky_brightness")?, light_intensity: light("light_intensity")? })
}

/// Reads the cameras of a flight: the tables `[bookmarks.N]` in the order of their numbers, each with the lines of a camera file.
pub fn open_all(path: &Path) -> Result<Vec<Camera>, Failure> {
    Ok(open_numbered(path)?.into_iter().map(|(_, camera)| camera).collect())
}

/// As [`open_all`], each with its number.
pub fn open_numbered(path: &Path) -> Result<Vec<(u32, Camera)>, Failure> {
    let failure = |message: String| Failure::input(message).hint(FLIGHT_HINT);
    voxtrace::import::opened::note(path);
    let text = std::fs::read_to_string(path)
        .map_err(|error| failure(format!("cannot read the cameras {}: {}", path.display(), reason(&error))))?;
    parse_all(&text).map_err(|reason| failure(format!("cameras {}: {reason}", path.display())))
}

/// Numbers that lenses have.
const LENS_SETTINGS: [&str; 7] =
    ["aperture", "focus", "blades", "blade_rotation", "view_height", "eye_distance", "fisheye_angle"];

/// What a file of cameras looks like.
const FLIGHT_HINT: &str =
    "each camera is a table [bookmarks.N] with eye = [x, y, z] and target = [x, y, z]; the window keeps such";

fn parse_all(text: &str) -> Result<Vec<(u32, Camera)>, String> {
    let file: toml::Table = text.parse().map_err(|error: toml::de::Error| error.message().to_owned())?;
    let table = file.get("bookmarks").and_then(toml::Value::as_table).ok_or("it has no [bookmarks.N]")?;
    let mut numbered: Vec<(u32, &toml::Value)> =
        table.iter().filter_map(|(number, value)| Some((number.parse().ok()?, value))).collect();
    numbered.sort_by_key(|(number, _)| *number);
    let camera = |(number, value): (u32, &toml::Value)| {
        let table = value.as_table().ok_or_else(|| format!("bookmark {number} is no table"))?;
        let camera = own_camera(table, &number.to_string()).map_err(|reason| format!("bookmark {number}: {reason}"));
        Ok((number, camera?))
    };
    numbered.into_iter().map(camera).collect()
}

fn own_camera(table: &toml::Table, name: &str) -> Result<Camera, String> {
    let required = |key: &str| vector(table, key)?.ok_or_else(|| format!("`{key}` is missing"));
    let (eye, target) = (required("eye")?, required("target")?);
    let camera = Camera::look_at(eye, target);
    let up = vector(table, "up")?.unwrap_or(camera.up);
    if eye == target {
        return Err("the camera stands on its target".into());
    }
    if up == Vec3::ZERO {
        return Err("`up` has no length".into());
    }
    let fov_y = fov(number(table, "fov_y")?)?;
    let name = table.get("name").and_then(toml::Value::as_str).unwrap_or(name).to_owned();
    let lens = match table.get("lens") {
        None => Lens::Pinhole,
        Some(lens) => {
            let lens = lens.as_str().ok_or("`lens` is not a name in quotes")?;
            // What is no number is not taken for missing.
            LENS_SETTINGS.iter().try_for_each(|key| number(table, key).map(drop))?;
            Lens::from_settings(lens, |key| number(table, key).ok().flatten().map(|value| value as f32))?
        }
    };
    Ok(Camera { name, up, fov_y, lens, ..camera })
}

/// The study's camera: its world is ours turned by −90° about x, so its (x, y, z) is our (x, −z, y). It looks along −z
/// there (our +y); yaw turns it to its right, pitch downwards, in degrees.
fn study_camera(table: &toml::Table, name: &str) -> Result<Camera, String> {
    let required = |key: &str| number(table, key)?.ok_or_else(|| format!("neither `eye` nor `{key}` is there"));
    let eye = DVec3::new(required("x")?, -required("z")?, required("y")?);
    let angle = |key: &str| Ok::<f64, String>(number(table, key)?.unwrap_or(0.0).to_radians());
    let ((pitch_sin, pitch_cos), (yaw_sin, yaw_cos)) = (angle("pitch")?.sin_cos(), angle("yaw")?.sin_cos());
    let forward = DVec3::new(pitch_cos * yaw_sin, pitch_cos * yaw_cos, -pitch_sin);
    // The target only gives the direction: near enough for f32 to keep the eye's digits, far enough to keep its own.
    let target = eye + forward * 100.0;
    let fov_y = fov(number(table, "fov")?)?;
    Ok(Camera { name: name.to_owned(), fov_y, ..Camera::look_at(eye.as_vec3(), target.as_vec3()) })
}

fn fov(degrees: Option<f64>) -> Result<f32, String> {
    let degrees = degrees.unwrap_or(45.0) as f32;
    if degrees > 0.0 && degrees < 180.0 {
        Ok(degrees)
    } else {
        Err(format!("a field of view of {degrees} is not between 0 and 180 degrees"))
    }
}

fn number(table: &toml::Table, key: &str) -> Result<Option<f64>, String> {
    table.get(key).map(|value| to_number(value).ok_or_else(|| format!("`{key}` is not a finite number"))).transpose()
}

fn to_number(value: &toml::Value) -> Option<f64> {
    let value = value.as_float().or_else(|| value.as_integer().map(|value| value as f64))?;
    (value as f32).is_finite().then_some(value)
}

fn vector(table: &toml::Table, key: &str) -> Result<Option<Vec3>, String> {
    let to_vector = |value: &toml::Value| {
        let numbers: Vec<f64> = value.as_array()?.iter().map(to_number).collect::<Option<_>>()?;
        <[f64; 3]>::try_from(numbers).ok().map(|numbers| DVec3::from_array(numbers).as_vec3())
    };
    table.get(key).map(|value| to_vector(value).ok_or_else(|| format!("`{key}` is not [x, y, z]"))).transpose()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn our_own_camera_is_read_at_the_top_or_in_a_table() {
        let expected = Camera {
            name: "porch".into(),
            eye: Vec3::new(1.0, 2.0, 3.5),
            target: Vec3::ZERO,
            up: Vec3::Y,
            fov_y: 60.0,
            lens: Lens::Pinhole,
        };
        let text = "eye = [1, 2, 3.5]\ntarget = [0, 0, 0]\nup = [0, 1, 0]\nfov_y = 60";
        assert_eq!(parse(text, "porch").unwrap().camera, expected);
        let in_table = format!("[camera]\n{text}");
        assert_eq!(parse(&in_table, "porch").unwrap().camera, expected);
        let wide = format!("{text}\nlens = \"fisheye\"\nfisheye_angle = 200");
        assert_eq!(parse(&wide, "porch").unwrap().camera.lens, Lens::Fisheye { fisheye_angle: 200.0 });
        assert!(parse(&format!("{text}\nlens = \"thin-lens\""), "porch").unwrap_err().contains("`aperture`"));
        // A number in quotes is none, and does not become the default.
        for wrong in ["lens = \"fisheye\"\nfisheye_angle = \"200\"", "lens = \"panorama\"\neye_distance = nan"] {
            let told = parse(&format!("{text}\n{wrong}"), "porch").unwrap_err();
            assert!(told.ends_with("is not a finite number"), "{told}");
        }
        let named = format!("name = \"door\"\n{text}");
        assert_eq!(parse(&named, "porch").unwrap().camera.name, "door");
    }

    #[test]
    fn the_study_s_church_camera_stands_low_and_looks_up_along_our_y() {
        let text = "sky_brightness = 0.0\nlight_intensity = 40.0\n[camera]\nx = -140.0\ny = 20.0\nz = 290.0\n\
                    pitch = -20.0\nyaw = 0.0\nfov = 90.0\nspeed = 50.0";
        let file = parse(text, "church").unwrap();
        let as_written = text.replace("sky_b", "[Scene]\nsky_b").replace("[camera]", "[Camera]");
        assert_eq!(parse(&as_written, "church").unwrap(), file);
        let camera = file.camera.clone();
        assert_eq!((file.sky_brightness, file.light_intensity, camera.fov_y), (Some(0.0), Some(40.0), 90.0));
        assert_eq!(camera.eye, Vec3::new(-140.0, -290.0, 20.0));
        let forward = (camera.target - camera.eye).normalize();
        let expected = Vec3::new(0.0, 20_f32.to_radians().cos(), 20_f32.to_radians().sin());
        assert!(forward.abs_diff_eq(expected, 1e-5), "{forward}");
        assert_eq!(camera.up, Vec3::Z);
    }

    #[test]
    fn the_study_s_other_cameras_look_down_at_the_middle_of_their_scenes() {
        for (x, y, z, pitch, yaw) in [(405.0, 85.0, 334.0, 23.0, -53.0), (340.0, 433.0, -301.0, 20.0, 225.0)] {
            let text = format!("x = {x}\ny = {y}\nz = {z}\npitch = {pitch}\nyaw = {yaw}");
            let camera = parse(&text, "a").unwrap().camera;
            let forward = (camera.target - camera.eye).normalize();
            let to_middle = (Vec3::ZERO - camera.eye).with_z(0.0).normalize();
            assert!(forward.with_z(0.0).normalize().dot(to_middle) > 0.95, "{forward} {to_middle}");
            assert!(forward.z < -0.3);
            assert_eq!(camera.fov_y, 45.0);
        }
    }

    #[test]
    fn the_cameras_of_a_flight_are_bookmarks_in_the_order_of_their_numbers() {
        let text = "mood = 1\n[bookmarks.10]\neye = [10, 0, 0]\ntarget = [0, 0, 0]\n[bookmarks.2]\neye = [2, 0, 0]\n\
                    target = [0, 0, 0]\nname = \"door\"\n[bookmarks.note]\ntext = 1";
        let cameras = parse_all(text).unwrap();
        let found: Vec<(u32, f32, &str)> =
            cameras.iter().map(|(number, camera)| (*number, camera.eye.x, camera.name.as_str())).collect();
        assert_eq!(found, [(2, 2.0, "door"), (10, 10.0, "10")]);
        assert!(parse_all("[bookmarks.1]\neye = [1, 2, 3]").unwrap_err().contains("bookmark 1: `target`"));
        assert!(parse_all("[bookmarks]\n1 = 2").unwrap_err().contains("no table"));
        assert!(parse_all("eye = [1, 2, 3]").unwrap_err().contains("[bookmarks.N]"));
    }

    #[test]
    fn what_is_missing_or_no_number_is_named() {
        let fails = |text: &str| parse(text, "a").unwrap_err();
        assert!(fails("eye = [1, 2, 3]").contains("`target`"));
        assert!(fails("eye = [1, 2]\ntarget = [0, 0, 0]").contains("`eye`"));
        assert!(fails("eye = [1, 2, nan]\ntarget = [0, 0, 0]").contains("`eye`"));
        assert!(fails("eye = [1, 2, 3]\ntarget = [1, 2, 3]").contains("on its target"));
        assert!(fails("eye = [1, 2, 3]\ntarget = [0, 0, 0]\nup = [0, 0, 0]").contains("`up`"));
        assert!(fails("x = 1\ny = 2").contains("`z`"));
        assert!(fails("x = 1\ny = 2\nz = inf").contains("`z`"));
        assert!(fails("x = 1\ny = 2\nz = 3\nfov = 180").contains("field of view"));
        assert!(fails("x = 1\ny = 2\nz = 3\nlight_intensity = -1").contains("`light_intensity`"));
        assert!(!fails("eye = [").is_empty());
    }
}
