//! N5 (Saalfeld, "N5 — not HDF5", github.com/saalfeldlab/n5, version 4): `attributes.json` beside blocks, whose axes come fastest first, each
//! with a header of its own; and the pyramids of levels `s0`, `s1`, … that its tools write.

use super::codec::Codec;
use super::metadata::{Array, Fault, Key, sizes};
use super::multiscale::Level;
use super::{Store, join};
use crate::import::samples::Sample;
use serde_json::Value;
use voxtrace_scene::scene::Unit;
use voxtrace_voxelize::{ImportError, Limits};

/// The file of an array or a group.
pub(super) const ATTRIBUTES: &str = "attributes.json";
/// Most axes of a block.
const MOST_AXES: usize = 10;

/// The array in a folder, `None` where there is none.
pub(super) fn array(folder: &str, json: &Value) -> Option<Result<Array, Fault>> {
    json["dimensions"].is_array().then(|| of_attributes(folder, json))
}

fn of_attributes(folder: &str, json: &Value) -> Result<Array, Fault> {
    let (mut shape, mut chunk) = (sizes(&json["dimensions"])?, sizes(&json["blockSize"])?);
    // Ours come slowest first.
    shape.reverse();
    chunk.reverse();
    let kind = json["dataType"].as_str().unwrap_or_default();
    let sample = Sample::of_numpy(kind).ok_or_else(|| Fault::Foreign(format!("samples of type {kind:?}")))?;
    // Before version 2 the name of the compression stood alone.
    let compression = &json["compression"];
    let name = compression["type"].as_str().or(json["compressionType"].as_str()).unwrap_or("raw");
    let codecs = match name {
        "raw" => Vec::new(),
        "gzip" if compression["useZlib"] == true => vec![Codec::Zlib],
        "gzip" => vec![Codec::Gzip],
        "bzip2" => vec![Codec::Bzip2],
        "zstd" => vec![Codec::Zstd],
        "blosc" => vec![Codec::Blosc],
        "lz4" => vec![Codec::Lz4Blocks],
        other => return Err(Fault::Foreign(format!("blocks compressed by {other:?}"))),
    };
    let order = (0..shape.len()).collect();
    let names = json["axes"].as_array().into_iter().flatten().rev();
    let names = names.map(|name| name.as_str().unwrap_or_default().to_owned()).collect();
    let key = Key { prefix: "", separator: "/", is_backward: true };
    let (folder, fill, big_endian, sharding) = (folder.into(), 0.0, true, None);
    let (rescale, has_head) = ((1.0, 0.0), true);
    Array { folder, shape, chunk, sample, big_endian, fill, codecs, order, sharding, key, names, rescale, has_head }
        .checked()
}

/// What stands before the samples of a block: its size along the axes, slowest first, and the bytes behind.
pub(super) fn head(bytes: &[u8]) -> Result<(Vec<u64>, &[u8]), &'static str> {
    const SHORT: &str = "a block without its header";
    let word = |at: usize| bytes.get(at..)?.first_chunk().map(|word| u16::from_be_bytes(*word));
    let long = |at: usize| bytes.get(at..)?.first_chunk().map(|word| u32::from_be_bytes(*word));
    let (mode, axes) = (word(0).ok_or(SHORT)?, usize::from(word(2).ok_or(SHORT)?));
    if mode > 1 || axes > MOST_AXES {
        return Err("a block of another kind than numbers");
    }
    let sizes: Option<Vec<u64>> = (0..axes).rev().map(|axis| long(4 + 4 * axis).map(u64::from)).collect();
    // Of varying length, where the number of samples is said.
    let start = 4 + 4 * axes + 4 * usize::from(mode);
    Ok((sizes.ok_or(SHORT)?, bytes.get(start..).ok_or(SHORT)?))
}

/// The samples of a block at the end of its array as those of a whole one.
pub(super) fn whole(bytes: Vec<u8>, own: &[u64], chunk: &[u64], sample: usize) -> Vec<u8> {
    if own == chunk {
        return bytes;
    }
    let count: u64 = chunk.iter().product();
    let mut all = vec![0; count as usize * sample];
    let row = own.last().map_or(0, |&size| size as usize * sample);
    if row == 0 {
        return all;
    }
    for (number, bytes) in bytes.chunks_exact(row).enumerate() {
        let (mut rest, mut at, mut stride) = (number as u64, 0, *chunk.last().unwrap_or(&1));
        for axis in (0..own.len() - 1).rev() {
            at += rest % own[axis] * stride;
            rest /= own[axis];
            stride *= chunk[axis];
        }
        let at = at as usize * sample;
        all[at..at + row].copy_from_slice(bytes);
    }
    all
}

/// The levels `s0`, `s1`, … of a group, from fine to coarse, and their unit; `None` where it has none.
pub(super) fn levels(store: &Store, limits: &Limits) -> Result<Option<(Vec<Level>, Unit)>, ImportError> {
    let Some(group) = store.json(ATTRIBUTES)? else { return Ok(None) };
    let mut levels = Vec::new();
    let mut unit = Unit::Voxel;
    for number in 0..64 {
        let name = format!("s{number}");
        let Some(json) = store.json(&join(&name, ATTRIBUTES))? else { break };
        let Some(array) = Array::read(store, &name, limits)? else { break };
        let numbers = |json: &Value| {
            let all: Option<Vec<f64>> = json.as_array().and_then(|list| list.iter().map(Value::as_f64).collect());
            all.and_then(|all| <[f64; 3]>::try_from(all.get(..3)?).ok())
        };
        let own = json["downsamplingFactors"].as_array().is_some().then(|| numbers(&json["downsamplingFactors"]));
        let listed = || numbers(&group["downsamplingFactors"][number]).or_else(|| numbers(&group["scales"][number]));
        let factors = own.flatten().or_else(listed).unwrap_or([f64::from(1u32 << number.min(20)); 3]);
        let resolution = [&json, &group].into_iter().find_map(|json| {
            let pixel = &json["pixelResolution"];
            let of_pixel = numbers(&pixel["dimensions"]).map(|all| (all, pixel["unit"].as_str().unwrap_or_default()));
            of_pixel.or_else(|| Some((numbers(&json["resolution"])?, json["units"][0].as_str().unwrap_or_default())))
        });
        let (edges, name) = resolution.unwrap_or(([1.0; 3], ""));
        let (of_unit, millimetres) = match name {
            "nm" | "nanometer" => (Unit::Millimetre, 1e-6),
            "um" | "µm" | "micrometer" => (Unit::Millimetre, 1e-3),
            "mm" | "millimeter" => (Unit::Millimetre, 1.0),
            _ => (Unit::Voxel, 1.0),
        };
        unit = of_unit;
        let mut level = Level::alone(array);
        level.spacing = std::array::from_fn(|axis| factors[axis] * edges[axis] * millimetres);
        // The middle of as many samples as one of it stands for.
        level.origin = std::array::from_fn(|axis| (factors[axis] - 1.0) / 2.0 * edges[axis] * millimetres);
        levels.push(level);
    }
    Ok((!levels.is_empty()).then_some((levels, unit)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_block_at_the_end_is_laid_into_a_whole_one() {
        assert_eq!(
            whole(vec![1, 2, 3, 4, 5, 6], &[1, 3, 2], &[2, 3, 3], 1),
            [1, 2, 0, 3, 4, 0, 5, 6, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]
        );
        assert_eq!(whole(vec![1, 2, 3, 4], &[2, 1], &[2, 2], 2), [1, 2, 0, 0, 3, 4, 0, 0]);
    }

    #[test]
    fn heads_are_read_and_what_is_too_short_is_told() {
        let bytes = [0, 0, 0, 2, 0, 0, 0, 5, 0, 0, 1, 0, 9, 9];
        assert_eq!(head(&bytes), Ok((vec![256, 5], &[9, 9][..])));
        let varying = [0, 1, 0, 1, 0, 0, 0, 3, 0, 0, 0, 3, 7];
        assert_eq!(head(&varying), Ok((vec![3], &[7][..])));
        assert!((0..12).all(|length| head(&bytes[..length]).is_err()) && head(&[0, 2, 0, 0]).is_err());
    }
}
