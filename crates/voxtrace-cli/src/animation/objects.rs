//! Objects of an animation's TOML: which they are, and how they move.

use super::table::Table;
use crate::failure::Failure;
use voxtrace::Scene;
use voxtrace::animation::{Ease, Interpolation, Motion, ObjectTrack, PoseKey, SmoothPath, bounds_of, rotation};
use voxtrace::changes::PartName;
use voxtrace::glam::{DQuat, DVec3};
use voxtrace::packed::Outline;

/// Keys of an object.
const KEYS: [&str; 9] = ["name", "names", "spin", "path", "keys", "interpolation", "pivot", "visible", "each"];
/// How things speed up and slow down.
pub const EASES: [(&str, Ease); 4] =
    [("none", Ease::None), ("in", Ease::In), ("out", Ease::Out), ("in-out", Ease::InOut)];
/// How keys go on to the next.
pub const INTERPOLATIONS: [(&str, Interpolation); 3] =
    [("smooth", Interpolation::Smooth), ("linear", Interpolation::Linear), ("step", Interpolation::Step)];
/// Sides of an object.
const SIDES: [(&str, DVec3); 4] = [("+x", DVec3::X), ("-x", DVec3::NEG_X), ("+y", DVec3::Y), ("-y", DVec3::NEG_Y)];

/// The objects of a part's name.
pub fn objects_of(table: &Table, key: &str, name: &str, outline: &Outline) -> Result<Vec<usize>, Failure> {
    let part: PartName = name.parse().map_err(|error| table.fault_at(key, error))?;
    part.objects(outline)
        .map_err(|error| table.fault_at(key, error).hint("`voxtrace info` lists layers, groups and objects"))
}

/// Numbers of objects, first to last: `1..200`.
fn range_of(name: &str) -> Option<(usize, usize)> {
    let (first, last) = name.split_once("..")?;
    Some((first.trim().parse().ok()?, last.trim().parse().ok()?))
}

/// The point about which objects turn and grow: one that is said, their middle, or that of their underside.
fn pivot_of(table: &Table, instances: &[usize], scene: &Scene) -> Result<DVec3, Failure> {
    let (min, max) = bounds_of(scene, instances).unwrap_or_default();
    let middle = ((min + max) * 0.5).as_dvec3();
    if !table.is_text("pivot") {
        return Ok(table.vector("pivot")?.unwrap_or(middle));
    }
    let foot = middle.with_z(min.z.into());
    Ok(table.choice("pivot", &[("middle", middle), ("foot", foot)])?.unwrap_or(middle))
}

/// The tracks of an `[[object]]`: one for all of it, or with `each` one for each object.
pub fn tracks(table: &Table, scene: &Scene, outline: &Outline) -> Result<Vec<ObjectTrack>, Failure> {
    table.only(&KEYS)?;
    let names = match (table.words("name")?, table.texts("names")?) {
        (Some(name), None) => vec![("name", name)],
        (None, Some(names)) => names.into_iter().map(|name| ("names", name)).collect(),
        _ => return Err(table.fault("`name` or `names` must say which object it is")),
    };
    let mut instances = Vec::new();
    for (key, name) in names {
        match range_of(name) {
            Some((first, last)) if first <= last && last < outline.objects.len() => instances.extend(first..=last),
            Some(_) => {
                let message = format!("there are objects 0 to {}", outline.objects.len().saturating_sub(1));
                return Err(table.fault_at(key, message));
            }
            None => instances.extend(objects_of(table, key, name, outline)?),
        }
    }
    instances.sort_unstable();
    instances.dedup();
    let groups = match table.flag("each")? {
        Some(true) => instances.into_iter().map(|instance| vec![instance]).collect(),
        _ => vec![instances],
    };
    groups.into_iter().map(|instances| track(table, instances, scene)).collect()
}

fn track(table: &Table, instances: Vec<usize>, scene: &Scene) -> Result<ObjectTrack, Failure> {
    let pivot = pivot_of(table, &instances, scene)?;
    let mut motions = Vec::new();
    if let Some(spin) = table.table("spin")? {
        spin.only(&["axis", "turns_per_second", "pivot"])?;
        let axis = spin.vector("axis")?.unwrap_or(DVec3::Z);
        if axis == DVec3::ZERO {
            return Err(spin.fault_at("axis", "it has no direction"));
        }
        let turns_per_second = spin.number("turns_per_second")?;
        let turns_per_second = turns_per_second.ok_or_else(|| spin.fault("`turns_per_second` is missing"))?;
        motions.push(Motion::Spin { pivot: spin.vector("pivot")?.unwrap_or(pivot), axis, turns_per_second });
    }
    let keys = table.tables("keys")?;
    if !keys.is_empty() {
        let interpolation = table.choice("interpolation", &INTERPOLATIONS)?.unwrap_or_default();
        motions.push(Motion::keys(pivot, poses(&keys)?, interpolation));
    }
    if let Some(path) = table.table("path")? {
        motions.push(along(&path, pivot)?);
    }
    let visible = table.tables("visible")?;
    let times = Table::times(&visible)?;
    let mut seen = Vec::new();
    for (key, time) in visible.iter().zip(times) {
        key.only(&["at", "value"])?;
        seen.push((time, key.flag("value")?.ok_or_else(|| key.fault("`value` is missing, true or false"))?));
    }
    if motions.is_empty() && seen.is_empty() {
        return Err(table.fault("it does nothing").hint("spin, path, keys or visible say what"));
    }
    Ok(ObjectTrack { instances, motions, visible: seen, ..ObjectTrack::default() })
}

/// Keys of a pose: what one does not say is as in the key before.
fn poses(keys: &[Table]) -> Result<Vec<PoseKey>, Failure> {
    let mut last = PoseKey { time: 0.0, offset: DVec3::ZERO, turn: DQuat::IDENTITY, scale: 1.0 };
    let mut poses = Vec::with_capacity(keys.len());
    for (key, time) in keys.iter().zip(Table::times(keys)?) {
        key.only(&["at", "offset", "axis", "degrees", "scale"])?;
        let turn = match (key.vector("axis")?, key.number("degrees")?) {
            (Some(DVec3::ZERO), _) => return Err(key.fault_at("axis", "it has no direction")),
            (Some(_), None) => return Err(key.fault_at("axis", "`degrees` says how far it turns, and is missing")),
            (axis, Some(degrees)) => rotation(axis.unwrap_or(DVec3::Z), degrees / 360.0),
            (None, None) => last.turn,
        };
        let (offset, scale) =
            (key.vector("offset")?.unwrap_or(last.offset), key.positive("scale")?.unwrap_or(last.scale));
        last = PoseKey { time, offset, turn, scale };
        poses.push(last);
    }
    Ok(poses)
}

fn along(table: &Table, pivot: DVec3) -> Result<Motion, Failure> {
    table.only(&["points", "seconds", "start", "ease", "closed", "repeats", "front", "pivot"])?;
    let points = table.vectors("points")?.ok_or_else(|| table.fault("`points` is missing"))?;
    let path = SmoothPath::through(&points, table.flag("closed")?.unwrap_or(false));
    Ok(Motion::Path {
        pivot: table.vector("pivot")?.unwrap_or(pivot),
        path: path.map_err(|reason| table.fault_at("points", reason))?,
        start: table.number("start")?.unwrap_or(0.0),
        seconds: table.positive("seconds")?.ok_or_else(|| table.fault("`seconds` is missing, the time of the way"))?,
        ease: table.choice("ease", &EASES)?.unwrap_or_default(),
        repeats: table.flag("repeats")?.unwrap_or(false),
        front: table.choice("front", &SIDES)?,
    })
}
