//! Pictures of OME-Zarr: which arrays are levels of one, what their axes are, and how far apart their samples lie.

use super::metadata::Array;
use super::{Store, join};
use crate::import::samples::channels::Channel;
use serde_json::Value;
use voxtrace_scene::scene::Unit;
use voxtrace_voxelize::{ImportError, Limits};

/// What axes of time and of channels are called.
const TIME: [&str; 2] = ["t", "time"];
const CHANNEL: [&str; 2] = ["c", "channel"];

/// An array of a picture, and where it lies.
pub(super) struct Level {
    pub array: Array,
    /// The array's axes along x, y and z; an array may lack the later ones.
    pub axes: [Option<usize>; 3],
    /// Between samples along x, y and z.
    pub spacing: [f64; 3],
    /// Of the first sample.
    pub origin: [f64; 3],
    /// The array's axes of time and of channels, where they are called so.
    pub time: Option<usize>,
    pub channel: Option<usize>,
    /// What is said about channels.
    pub channels: Vec<Channel>,
}

impl Level {
    /// An array by itself: its last axes, or those that are called so, are z, y and x.
    pub fn alone(array: Array) -> Self {
        let axes = axes(&array, &array.names);
        let find = |names: &[&str]| array.names.iter().position(|own| names.contains(&&*own.to_ascii_lowercase()));
        // Names may be more than axes.
        let [time, channel] = [find(&TIME), find(&CHANNEL)].map(|axis| axis.filter(|&axis| axis < array.shape.len()));
        Self { array, axes, spacing: [1.0; 3], origin: [0.0; 3], time, channel, channels: Vec::new() }
    }

    /// Samples along x, y and z.
    pub fn size(&self) -> [u64; 3] {
        self.axes.map(|axis| axis.map_or(1, |axis| self.array.shape[axis]))
    }
}

/// The axes called x, y and z, or the last three that are called neither time nor channel.
fn axes(array: &Array, names: &[String]) -> [Option<usize>; 3] {
    let find = |name: &str| names.iter().position(|other| other.eq_ignore_ascii_case(name));
    let count = array.shape.len();
    if names.len() == count && find("x").is_some() && find("y").is_some() {
        return [find("x"), find("y"), find("z")];
    }
    let is_space = |axis: &usize| {
        let name = names.get(*axis).map(|name| name.to_ascii_lowercase()).unwrap_or_default();
        !TIME.contains(&&*name) && !CHANNEL.contains(&&*name)
    };
    let mut last = (0..count).rev().filter(is_space);
    [(); 3].map(|()| last.next())
}

/// The levels of the first picture of a group, from fine to coarse, and their unit; `None` where the group has none.
pub(super) fn levels(store: &Store, limits: &Limits) -> Result<Option<(Vec<Level>, Unit)>, ImportError> {
    let attributes = match store.json(".zattrs")? {
        Some(attributes) => attributes,
        None => store.json("zarr.json")?.map(|json| json["attributes"].clone()).unwrap_or_default(),
    };
    let pictures =
        if attributes["ome"].is_object() { &attributes["ome"]["multiscales"] } else { &attributes["multiscales"] };
    let Some(picture) = pictures.get(0) else { return Ok(None) };
    // From version 0.6 on axes belong to systems of coordinates, into one of which the levels are transformed.
    let systems = picture["coordinateSystems"].as_array();
    let described = match systems {
        Some(systems) => {
            let output = &picture["datasets"][0]["coordinateTransformations"][0]["output"];
            let output = output["name"].as_str().or(output.as_str()).unwrap_or_default();
            let system = systems.iter().find(|system| system["name"] == output).or(systems.first());
            system.map_or(&Value::Null, |system| &system["axes"])
        }
        None => &picture["axes"],
    };
    let described = described.as_array().cloned().unwrap_or_default();
    // Older files have names alone.
    let name = |axis: &Value| axis["name"].as_str().or(axis.as_str()).unwrap_or_default().to_owned();
    let names: Vec<String> = described.iter().map(name).collect();
    let datasets = picture["datasets"].as_array().cloned().unwrap_or_default();
    if datasets.len() as u64 > limits.items {
        return Err(ImportError::limit(&store.path, None, "levels", datasets.len() as u64, limits.items));
    }
    let find = |kind: &str, names: [&str; 2]| {
        let is_such = |axis: &Value| axis["type"] == kind || names.contains(&name(axis).to_ascii_lowercase().as_str());
        described.iter().position(is_such)
    };
    let (time, channel) = (find("time", TIME), find("channel", CHANNEL));
    let looks = if attributes["ome"].is_object() { &attributes["ome"]["omero"] } else { &attributes["omero"] };
    let channels: Vec<Channel> = looks["channels"].as_array().into_iter().flatten().map(look).collect();
    let mut levels = Vec::new();
    for dataset in &datasets {
        let path = dataset["path"].as_str().unwrap_or_default();
        let Some(array) = Array::read(store, path, limits)? else {
            return Err(store.malformed(&join(path, ".zarray"), "a level of the picture is missing"));
        };
        let own = axes(&array, &names);
        let (mut scale, mut shift) = (vec![1.0; array.shape.len()], vec![0.0; array.shape.len()]);
        // In later versions those of the picture lead to other systems.
        let of_picture = picture["coordinateTransformations"].as_array().filter(|_| systems.is_none());
        let own_steps = dataset["coordinateTransformations"].as_array();
        let steps = own_steps.into_iter().chain(of_picture).flatten();
        // A sequence is its steps.
        let steps =
            steps.flat_map(|step| step["transformations"].as_array().map_or(std::slice::from_ref(step), Vec::as_slice));
        for step in steps {
            for axis in 0..array.shape.len() {
                if let Some(factor) = step["scale"][axis].as_f64() {
                    scale[axis] *= factor;
                    shift[axis] *= factor;
                }
                shift[axis] += step["translation"][axis].as_f64().unwrap_or(0.0);
            }
        }
        let pick = |all: &[f64], otherwise: f64| own.map(|axis| axis.map_or(otherwise, |axis| all[axis]));
        let (spacing, origin) = (pick(&scale, 1.0), pick(&shift, 0.0));
        let [time, channel] = [time, channel].map(|axis| axis.filter(|&axis| axis < array.shape.len()));
        levels.push(Level { array, axes: own, spacing, origin, time, channel, channels: channels.clone() });
    }
    let own = levels.first().map_or([None; 3], |level| level.axes);
    let (unit, factors) = lengths(own.map(|axis| described.get(axis?)?["unit"].as_str()));
    for level in &mut levels {
        for (axis, factor) in factors.iter().enumerate() {
            level.spacing[axis] *= factor;
            level.origin[axis] *= factor;
        }
    }
    Ok((!levels.is_empty()).then_some((levels, unit)))
}

/// The unit of a picture whose axes x, y and z have these, and what lengths along each are to be multiplied with.
fn lengths(units: [Option<&str>; 3]) -> (Unit, [f64; 3]) {
    let millimetres = |unit| {
        Some(match unit {
            "angstrom" => 1e-7,
            "nanometer" => 1e-6,
            "micrometer" => 1e-3,
            "millimeter" => 1.0,
            "centimeter" => 10.0,
            "meter" => 1e3,
            _ => return None,
        })
    };
    // Everything that is not a metre becomes millimetres.
    let Some(x) = units[0].and_then(millimetres) else { return (Unit::Voxel, [1.0; 3]) };
    let (unit, least) = if units[0] == Some("meter") { (Unit::Metre, 1e3) } else { (Unit::Millimetre, 1.0) };
    // An axis that says nothing is as x.
    (unit, units.map(|own| own.and_then(millimetres).unwrap_or(x) / least))
}

/// A channel as its metadata of OMERO says: six digits of a colour, and where it is black and bright.
fn look(channel: &Value) -> Channel {
    let digits = channel["color"].as_str().map(|digits| digits.trim_start_matches('#'));
    let color = digits.and_then(|digits| u32::from_str_radix(digits.get(..6)?, 16).ok());
    let window = channel["window"]["start"].as_f64().zip(channel["window"]["end"].as_f64());
    Channel {
        color: color.map(|color| {
            let [_, rgb @ ..] = color.to_be_bytes();
            rgb
        }),
        window: window.map(|(start, end)| (start as f32, end as f32)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_axis_has_its_own_unit() {
        let um = Some("micrometer");
        assert_eq!(lengths([um, um, um]), (Unit::Millimetre, [1e-3; 3]));
        assert_eq!(lengths([Some("nanometer"), Some("nanometer"), um]), (Unit::Millimetre, [1e-6, 1e-6, 1e-3]));
        assert_eq!(lengths([um, um, None]), (Unit::Millimetre, [1e-3; 3]));
        assert_eq!(lengths([Some("meter"), Some("meter"), Some("centimeter")]), (Unit::Metre, [1.0, 1.0, 0.01]));
        assert_eq!(lengths([Some("pixel"), um, um]), (Unit::Voxel, [1.0; 3]));
    }
}
