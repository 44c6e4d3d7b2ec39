//! The animations of a glTF document (glTF 2.0, section 3.11): their names, how long they last, and the keys of nodes and of the weights of morph
//! targets. What extensions move is left out.

use super::Fault;
use super::accessor::Accessors;
use super::document::{Animation, AnimationSampler, Document};
use crate::import::reader::ClipChoice;
use std::collections::HashMap;
use voxtrace_scene::animation::{Channel, Clip, KeyKind, KeyTrack};

/// The index of the animation that is asked for: by its name, or by its number from 1 on.
pub(super) fn chosen(document: &Document, choice: &ClipChoice) -> Option<usize> {
    let count = document.animations.len();
    match choice {
        ClipChoice::None | ClipChoice::Later => None,
        ClipChoice::First => (count > 0).then_some(0),
        ClipChoice::Named(name) => {
            let by_name = document.animations.iter().position(|animation| animation.name == *name);
            by_name.or_else(|| name.parse::<usize>().ok()?.checked_sub(1).filter(|&index| index < count))
        }
    }
}

/// The animations without their motions. One whose keys cannot be read lasts no time.
pub(super) fn clips(document: &Document, accessors: &Accessors) -> Vec<Clip> {
    let mut ends: HashMap<usize, f32> = HashMap::new();
    let mut end_of = |input: usize| {
        *ends.entry(input).or_insert_with(|| {
            let mut last = 0.0f32;
            let read = accessors.vectors(input, &["SCALAR"], 0.0, |[time, ..]| last = last.max(time));
            if read.is_ok() && last.is_finite() { last } else { 0.0 }
        })
    };
    let clip = |animation: &Animation| {
        let inputs = animation.samplers.iter().filter_map(|sampler| sampler.input);
        let seconds = inputs.map(&mut end_of).fold(0.0, f32::max);
        Clip { name: animation.name.clone(), seconds: seconds.into(), motion: None }
    };
    document.animations.iter().map(clip).collect()
}

/// The keys of each node in an animation.
pub(super) struct Channels {
    /// What moves a node.
    pub of_nodes: HashMap<usize, Vec<Channel>>,
    /// The weights of the morph targets of a node's mesh, one after the other.
    pub weights: HashMap<usize, Vec<KeyTrack<1>>>,
}

/// The channels of an animation.
pub(super) fn channels(animation: &Animation, accessors: &Accessors) -> Result<Channels, Fault> {
    let mut of_nodes: HashMap<usize, Vec<Channel>> = HashMap::new();
    let mut weights = HashMap::new();
    let mut numbers = 0u64;
    for (index, channel) in animation.channels.iter().enumerate() {
        let Some(node) = channel.target.node else { continue };
        let sampler = || {
            let sampler = animation.samplers.get(channel.sampler);
            sampler.ok_or_else(|| fault(animation, index, "has a sampler that is missing"))
        };
        let path = channel.target.path.as_str();
        if !["translation", "scale", "rotation", "weights"].contains(&path) {
            continue;
        }
        if node >= accessors.document.nodes.len() {
            return Err(fault(animation, index, "moves a node that is missing"));
        }
        let channel = match path {
            "translation" => Channel::Translation(keys(sampler()?, "VEC3", accessors, &mut numbers)?),
            "scale" => Channel::Scale(keys(sampler()?, "VEC3", accessors, &mut numbers)?),
            "rotation" => Channel::Rotation(keys(sampler()?, "VEC4", accessors, &mut numbers)?),
            _ => {
                let targets = target_count(node, accessors.document);
                if targets > 0 {
                    let own = weights_of_targets(sampler()?, targets, accessors, &mut numbers)?;
                    if weights.insert(node, own).is_some() {
                        return Err(fault(animation, index, "moves what another one moves"));
                    }
                }
                continue;
            }
        };
        let channels = of_nodes.entry(node).or_default();
        if channels.iter().any(|own| std::mem::discriminant(own) == std::mem::discriminant(&channel)) {
            return Err(fault(animation, index, "moves what another one moves"));
        }
        channels.push(channel);
    }
    Ok(Channels { of_nodes, weights })
}

/// How many morph targets the mesh of a node has.
fn target_count(node: usize, document: &Document) -> usize {
    let mesh = document.nodes.get(node).and_then(|node| document.meshes.get(node.mesh?));
    mesh.map_or(0, |mesh| mesh.primitives.iter().map(|primitive| primitive.targets.len()).max().unwrap_or(0))
}

fn fault(animation: &Animation, channel: usize, what: &str) -> Fault {
    Fault::malformed(format!("channel {channel} of the animation {:?} {what}", animation.name))
}

/// The keys of a sampler; `numbers` counts those of all.
fn keys<const N: usize>(
    sampler: &AnimationSampler,
    kind: &str,
    accessors: &Accessors,
    numbers: &mut u64,
) -> Result<KeyTrack<N>, Fault> {
    let mut values = Vec::new();
    let (times, interpolation) =
        read_keys(sampler, kind, accessors, numbers, |vector| values.push(std::array::from_fn(|n| vector[n])))?;
    KeyTrack::new(times, values, interpolation).ok_or_else(bad_keys)
}

/// The keys of so many weights: each key has one of each target, of splines the tangents that come in, the values, and the tangents that go out.
fn weights_of_targets(
    sampler: &AnimationSampler,
    targets: usize,
    accessors: &Accessors,
    numbers: &mut u64,
) -> Result<Vec<KeyTrack<1>>, Fault> {
    let mut values = Vec::new();
    let (times, interpolation) = read_keys(sampler, "SCALAR", accessors, numbers, |[value, ..]| values.push([value]))?;
    // The times are those of each target.
    *numbers = numbers.saturating_add((times.len() as u64).saturating_mul(targets as u64));
    if *numbers > accessors.limits.points {
        return Err(Fault::limit("keys of an animation", *numbers, accessors.limits.points));
    }
    if !values.len().is_multiple_of(targets) {
        return Err(bad_keys());
    }
    let track = |target: usize| {
        let own = values.iter().skip(target).step_by(targets).copied().collect();
        KeyTrack::new(times.clone(), own, interpolation).ok_or_else(bad_keys)
    };
    (0..targets).map(track).collect()
}

fn bad_keys() -> Fault {
    Fault::malformed(
        "keys of an animation whose times fall, that are not finite, or not as many as their times ask for",
    )
}

/// The times and the interpolation of a sampler, whose numbers `each` is called with.
fn read_keys(
    sampler: &AnimationSampler,
    kind: &str,
    accessors: &Accessors,
    numbers: &mut u64,
    each: impl FnMut([f32; 4]),
) -> Result<(Vec<f32>, KeyKind), Fault> {
    let (Some(input), Some(output)) = (sampler.input, sampler.output) else {
        return Err(Fault::malformed("a sampler of an animation without times or values"));
    };
    let counts = [accessors.of_kinds(input, &["SCALAR"])?.count, accessors.of_kinds(output, &[kind])?.count];
    *numbers = numbers.saturating_add(counts[0] as u64).saturating_add(counts[1] as u64);
    if *numbers > accessors.limits.points {
        return Err(Fault::limit("keys of an animation", *numbers, accessors.limits.points));
    }
    let mut times = Vec::with_capacity(counts[0]);
    accessors.vectors(input, &["SCALAR"], 0.0, |[time, ..]| times.push(time))?;
    accessors.vectors(output, &[kind], 0.0, each)?;
    let interpolation = match sampler.interpolation.as_deref() {
        None | Some("LINEAR") => KeyKind::Linear,
        Some("STEP") => KeyKind::Step,
        Some("CUBICSPLINE") => KeyKind::Cubic,
        Some(other) => return Err(Fault::malformed(format!("the interpolation {other:.40} is unknown"))),
    };
    Ok((times, interpolation))
}
