//! The camera of an animation's TOML.

use super::objects::{EASES, objects_of};
use super::table::Table;
use crate::camera_file;
use crate::failure::Failure;
use std::path::Path;
use voxtrace::Camera;
use voxtrace::animation::{CameraMotion, CameraTrack, LookAt};
use voxtrace::camera::{Flight, Handles, Lens};
use voxtrace::glam::Vec3;
use voxtrace::packed::Outline;

/// Keys of the camera.
const KEYS: [&str; 9] = ["name", "path", "ease", "start", "seconds", "orbit", "turns_per_second", "look_at", "focus"];
/// Keys that a camera has anywhere.
const CAMERA_KEYS: [&str; 18] = [
    "at",
    "camera",
    "bookmark",
    "eye",
    "target",
    "up",
    "fov_y",
    "lens",
    "aperture",
    "focus",
    "blades",
    "blade_rotation",
    "view_height",
    "fisheye_angle",
    "handle_in",
    "handle_out",
    "corner",
    "eye_distance",
];

/// What cameras are looked up in.
pub struct Surroundings<'s> {
    pub outline: &'s Outline,
    /// A camera by the name that `--camera` takes; the first one without a name.
    pub named: &'s dyn Fn(Option<&str>) -> Result<Camera, Failure>,
    /// What the options change about its lens.
    pub with_lens: &'s dyn Fn(Camera) -> Result<Camera, Failure>,
    /// The file of bookmarks.
    pub bookmarks: Option<&'s Path>,
    /// How long the clip lasts, seconds.
    pub seconds: f64,
    /// Time of the last frame, seconds.
    pub last: f64,
}

/// The camera that a table says.
pub fn track(table: &Table, around: &Surroundings) -> Result<CameraTrack, Failure> {
    table.only(&KEYS)?;
    let path = table.tables("path")?;
    let turns = (table.number("orbit")?.map(|turns| turns / around.seconds)).or(table.number("turns_per_second")?);
    let named = || {
        let name = table.words("name")?;
        let found = (around.named)(name).map_err(|failure| failure.retold(|reason| table.fault_at("name", reason)));
        found.and_then(around.with_lens)
    };
    let motion = match (path.is_empty(), turns) {
        (false, Some(_)) => return Err(table.fault_at("path", "the camera orbits already, and can do one of both")),
        (false, None) if table.has("name") => {
            return Err(table.fault_at("name", "the path says already which cameras there are"));
        }
        (false, None) => flight(table, &path, around)?,
        (true, Some(turns_per_second)) => CameraMotion::Orbit { camera: named()?, turns_per_second },
        (true, None) => CameraMotion::Still(named()?),
    };
    let look_at = if table.is_text("look_at") {
        let name = table.words("look_at")?.unwrap_or_default();
        Some(LookAt::Instances(objects_of(table, "look_at", name, around.outline)?, Vec3::ZERO))
    } else {
        table.vector("look_at")?.map(|point| LookAt::Point(point.as_vec3()))
    };
    let focuses_on_target = table.choice("focus", &[("target", true), ("camera", false)])?.unwrap_or(false);
    Ok(CameraTrack { motion, look_at, focuses_on_target })
}

/// The flight through the keys of a path: at their times, or at one speed where they have none.
fn flight(table: &Table, path: &[Table], around: &Surroundings) -> Result<CameraMotion, Failure> {
    let cameras =
        path.iter().map(|key| camera(key, around).and_then(around.with_lens)).collect::<Result<Vec<_>, _>>()?;
    let handles = path.iter().map(handles).collect::<Result<Vec<_>, _>>()?;
    let ease = table.choice("ease", &EASES)?.unwrap_or_default();
    if path.iter().any(|key| key.has("at")) {
        for key in ["seconds", "start"] {
            if table.has(key) {
                return Err(table.fault_at(key, "the keys of the path have times already"));
            }
        }
        let times = Table::times(path)?;
        let (start, end) = (times[0], times[times.len() - 1]);
        let keys: Vec<(f64, Camera)> = times.into_iter().zip(cameras).collect();
        let flight = Flight::timed_with(&keys, &handles).map_err(|reason| table.fault_at("path", reason))?;
        return Ok(CameraMotion::Flight { flight: flight.into(), start, seconds: end - start, ease });
    }
    let start = table.number("start")?.unwrap_or(0.0);
    let seconds = table.positive("seconds")?.unwrap_or((around.last - start).max(f64::MIN_POSITIVE));
    let flight = Flight::through_with(&cameras, &handles).map_err(|reason| table.fault_at("path", reason))?;
    Ok(CameraMotion::Flight { flight: flight.into(), start, seconds, ease })
}

/// The handles of a camera of a path.
fn handles(key: &Table) -> Result<Handles, Failure> {
    let handle = |name: &str| Ok::<_, Failure>(key.vector(name)?.map(|handle| handle.as_vec3()));
    let (arriving, leaving) = (handle("handle_in")?, handle("handle_out")?);
    let handles = Handles { arriving, leaving, is_corner: key.flag("corner")?.unwrap_or(false) };
    let at = if leaving.is_some() { "handle_out" } else { "handle_in" };
    handles.check().map_err(|reason| key.fault_at(at, reason))?;
    Ok(handles)
}

/// One camera of a path: by name, by the number of a bookmark, or by where it stands.
fn camera(key: &Table, around: &Surroundings) -> Result<Camera, Failure> {
    key.only(&CAMERA_KEYS)?;
    let mut camera = match (key.words("camera")?, key.count("bookmark")?) {
        (Some(name), None) => {
            (around.named)(Some(name)).map_err(|failure| failure.retold(|reason| key.fault_at("camera", reason)))?
        }
        (None, Some(number)) => bookmark(key, number, around.bookmarks)?,
        (None, None) if key.has("eye") && key.has("target") => Camera::look_at(Vec3::ZERO, Vec3::Y),
        _ => return Err(key.fault("`camera`, `bookmark`, or `eye` and `target` must say where it is")),
    };
    let vector = |name: &str, own: Vec3| Ok::<Vec3, Failure>(key.vector(name)?.map_or(own, |vector| vector.as_vec3()));
    (camera.eye, camera.target) = (vector("eye", camera.eye)?, vector("target", camera.target)?);
    camera.up = vector("up", camera.up)?;
    camera.fov_y = key.number("fov_y")?.map_or(camera.fov_y, |degrees| degrees as f32);
    if key.has("lens") || key.has("aperture") {
        let lens = key.words("lens")?.unwrap_or("thin-lens");
        let distance = camera.focus_on(camera.target);
        let setting = |name: &str| {
            let own = if CAMERA_KEYS.contains(&name) { key.number(name).ok().flatten() } else { None };
            own.map(|value| value as f32).or(if name == "focus" { Some(distance) } else { None })
        };
        camera.lens = Lens::from_settings(lens, setting).map_err(|reason| key.fault(reason))?;
    }
    camera.check().map_err(|reason| key.fault(reason))?;
    if camera.eye == camera.target || camera.up == Vec3::ZERO {
        return Err(key.fault("the camera stands on its target, or has no up"));
    }
    Ok(camera)
}

fn bookmark(key: &Table, number: u32, bookmarks: Option<&Path>) -> Result<Camera, Failure> {
    let Some(path) = bookmarks else {
        let failure = key.fault_at("bookmark", "a built-in scene has no file of bookmarks beside it");
        return Err(failure.hint("`bookmarks = \"FILE.cameras.toml\"` at the top names one"));
    };
    let cameras = camera_file::open_numbered(path)?;
    let found = cameras.iter().find(|(own, _)| *own == number).map(|(_, camera)| camera.clone());
    found.ok_or_else(|| {
        let numbers: Vec<String> = cameras.iter().map(|(number, _)| number.to_string()).collect();
        key.fault_at("bookmark", format!("{} has no bookmark {number}", path.display()))
            .hint(format!("it has {}", numbers.join(", ")))
    })
}
