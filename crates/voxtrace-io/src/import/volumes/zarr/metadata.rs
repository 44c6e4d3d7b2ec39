//! What an array says about itself: `.zarray` of version 2, `zarr.json` of version 3.

use super::codec::Codec;
use super::shard::Sharding;
use super::{Store, join, n5};
use crate::import::samples::Sample;
use serde_json::Value;
use voxtrace_voxelize::{ImportError, Limits};

/// Most axes of an array.
const MOST_AXES: usize = 10;

/// An array of numbers in chunks.
#[derive(Clone, Debug)]
pub(super) struct Array {
    /// Its folder in the store.
    pub folder: String,
    pub shape: Vec<u64>,
    pub chunk: Vec<u64>,
    pub sample: Sample,
    pub big_endian: bool,
    pub fill: f32,
    /// From what is stored to samples: the last is undone first.
    pub codecs: Vec<Codec>,
    /// The axes of a chunk in the order in which they are stored, the last fastest.
    pub order: Vec<usize>,
    /// How chunks share files, where they do.
    pub sharding: Option<Sharding>,
    pub(super) key: Key,
    pub names: Vec<String>,
    /// Slope and intercept from stored to real values.
    pub rescale: (f64, f64),
    /// Whether chunks begin with their size, as those of N5.
    pub has_head: bool,
}

/// How a chunk's file is called.
#[derive(Clone, Debug)]
pub(super) struct Key {
    pub prefix: &'static str,
    pub separator: &'static str,
    /// Whether the fastest axis comes first.
    pub is_backward: bool,
}

impl Array {
    /// The array in a folder of the store, `None` where there is no array.
    pub fn read(store: &Store, folder: &str, limits: &Limits) -> Result<Option<Self>, ImportError> {
        let name = join(folder, ".zarray");
        let (name, found) = match store.json(&name)? {
            Some(json) => (name, Self::of_second(folder, &json)),
            None => {
                let name = join(folder, "zarr.json");
                match store.json(&name)? {
                    Some(json) if json["node_type"] == "array" => (name, Self::of_third(folder, &json)),
                    Some(_) => return Ok(None),
                    None => {
                        let name = join(folder, n5::ATTRIBUTES);
                        let found = store.json(&name)?.and_then(|json| n5::array(folder, &json));
                        let Some(found) = found else { return Ok(None) };
                        (name, found)
                    }
                }
            }
        };
        let mut array = found.map_err(|fault| match fault {
            Fault::Broken(what) => store.malformed(&name, what),
            Fault::Foreign(what) => store.unsupported(&name, what),
        })?;
        let attributes = if name.ends_with(".zarray") {
            // Samples can be read without.
            store.json(&join(folder, ".zattrs")).unwrap_or_default()
        } else {
            store.json(&name)?.map(|json| json["attributes"].clone())
        };
        array.describe(&attributes.unwrap_or_default());
        let bytes = array.chunk_samples().saturating_mul(array.sample.size() as u64);
        let most = limits.bytes.min(isize::MAX as u64 / 2);
        if bytes > most {
            return Err(ImportError::limit(&store.path.join(name), None, "bytes of a chunk", bytes, most));
        }
        Ok(Some(array))
    }

    /// Takes what attributes say by the conventions of netCDF (CF 1.11, section 8.1), and of xarray the names of the axes.
    fn describe(&mut self, attributes: &Value) {
        // Of several numbers none is that of all samples.
        let only = |all: &Vec<Value>| if let [one] = &all[..] { one.as_f64() } else { None };
        let number = |name: &str| attributes[name].as_f64().or_else(|| attributes[name].as_array().and_then(only));
        let slope = number("scale_factor").filter(|&slope| slope != 0.0).unwrap_or(1.0);
        self.rescale = (slope, number("add_offset").unwrap_or(0.0));
        self.fill = (f64::from(self.fill) * slope + self.rescale.1) as f32;
        if let (true, Some(names)) = (self.names.is_empty(), attributes["_ARRAY_DIMENSIONS"].as_array()) {
            self.names = names.iter().map(|name| name.as_str().unwrap_or_default().to_owned()).collect();
        }
    }

    /// Samples of a chunk.
    pub fn chunk_samples(&self) -> u64 {
        self.chunk.iter().try_fold(1u64, |count, &size| count.checked_mul(size)).unwrap_or(u64::MAX)
    }

    /// The name of a chunk's file.
    pub fn chunk_name(&self, at: &[u64]) -> String {
        let mut numbers: Vec<String> = at.iter().map(u64::to_string).collect();
        if self.key.is_backward {
            numbers.reverse();
        }
        let name = match (numbers.is_empty(), self.key.prefix) {
            (true, "") => "0".into(),
            (true, _) => "c".into(),
            (false, prefix) => format!("{prefix}{}", numbers.join(self.key.separator)),
        };
        join(&self.folder, &name)
    }

    fn of_second(folder: &str, json: &Value) -> Result<Self, Fault> {
        let (shape, chunk) = (sizes(&json["shape"])?, sizes(&json["chunks"])?);
        let kind = json["dtype"].as_str().ok_or(Fault::Foreign("samples of several parts".into()))?;
        let sample = kind.get(1..).and_then(Sample::of_letters);
        let sample = sample.ok_or_else(|| Fault::Foreign(format!("samples of type {kind:?}")))?;
        if json["filters"].as_array().is_some_and(|filters| !filters.is_empty()) {
            return Err(Fault::Foreign(format!("the filters {}", json["filters"])));
        }
        let codecs = match &json["compressor"] {
            Value::Null => Vec::new(),
            compressor => vec![Codec::of_second(compressor)?],
        };
        let mut order: Vec<usize> = (0..shape.len()).collect();
        match json["order"].as_str() {
            Some("C") => {}
            Some("F") => order.reverse(),
            _ => return Err(Fault::Broken("an order that is neither C nor F")),
        }
        let separator = if json["dimension_separator"] == "/" { "/" } else { "." };
        let fill = fill(&json["fill_value"]);
        let (folder, key) = (folder.into(), Key { prefix: "", separator, is_backward: false });
        let (big_endian, sharding, names) = (kind.starts_with('>'), None, Vec::new());
        let (rescale, has_head) = ((1.0, 0.0), false);
        Self { folder, shape, chunk, sample, big_endian, fill, codecs, order, sharding, key, names, rescale, has_head }
            .checked()
    }

    fn of_third(folder: &str, json: &Value) -> Result<Self, Fault> {
        let shape = sizes(&json["shape"])?;
        if json["chunk_grid"]["name"] != "regular" {
            return Err(Fault::Foreign(format!("chunks in the grid {}", json["chunk_grid"]["name"])));
        }
        let chunk = sizes(&json["chunk_grid"]["configuration"]["chunk_shape"])?;
        let kind = json["data_type"].as_str().ok_or(Fault::Foreign("samples of several parts".into()))?;
        let sample = Sample::of_numpy(kind).ok_or_else(|| Fault::Foreign(format!("samples of type {kind:?}")))?;
        let (mut chunk, mut sharding) = (chunk, None);
        let mut packing = &json["codecs"];
        if let Some([only]) = packing.as_array().map(Vec::as_slice)
            && only["name"] == "sharding_indexed"
        {
            let configuration = &only["configuration"];
            let inner = sizes(&configuration["chunk_shape"])?;
            let index = Packing::of_third(&configuration["index_codecs"], 1)?;
            let location = configuration["index_location"].as_str().unwrap_or("end");
            sharding = Some(Sharding::new(&chunk, &inner, location, index.big_endian, &index.codecs)?);
            (chunk, packing) = (inner, &configuration["codecs"]);
        }
        let Packing { codecs, big_endian, order } = Packing::of_third(packing, shape.len())?;
        let encoding = &json["chunk_key_encoding"];
        let is_default = encoding["name"] != "v2";
        let separator = match encoding["configuration"]["separator"].as_str() {
            Some("/") => "/",
            Some(".") => ".",
            _ if is_default => "/",
            _ => ".",
        };
        // Default keys begin with `c`.
        let prefix = match (is_default, separator) {
            (true, "/") => "c/",
            (true, _) => "c.",
            _ => "",
        };
        let names = json["dimension_names"].as_array().into_iter().flatten();
        let names = names.map(|name| name.as_str().unwrap_or_default().to_owned()).collect();
        let (folder, fill) = (folder.into(), fill(&json["fill_value"]));
        let key = Key { prefix, separator, is_backward: false };
        let (rescale, has_head) = ((1.0, 0.0), false);
        Self { folder, shape, chunk, sample, big_endian, fill, codecs, order, sharding, key, names, rescale, has_head }
            .checked()
    }

    pub(super) fn checked(self) -> Result<Self, Fault> {
        if self.shape.len() != self.chunk.len() || self.shape.is_empty() || self.shape.len() > MOST_AXES {
            return Err(Fault::Broken("shape and chunks of different or too many axes"));
        }
        if self.shape.contains(&0) || self.chunk.contains(&0) {
            return Err(Fault::Broken("an array without samples"));
        }
        Ok(self)
    }
}

/// What the samples of a chunk of version 3 go through.
struct Packing {
    codecs: Vec<Codec>,
    big_endian: bool,
    order: Vec<usize>,
}

impl Packing {
    fn of_third(json: &Value, axes: usize) -> Result<Self, Fault> {
        let mut order: Vec<usize> = (0..axes).collect();
        let (mut codecs, mut big_endian) = (Vec::new(), false);
        for codec in json.as_array().ok_or(Fault::Broken("an array without codecs"))? {
            let configuration = &codec["configuration"];
            match codec["name"].as_str().unwrap_or_default() {
                "bytes" => big_endian = configuration["endian"] == "big",
                "transpose" if codecs.is_empty() => {
                    let turned = sizes(&configuration["order"])?;
                    let mut sorted = turned.clone();
                    sorted.sort_unstable();
                    if sorted.into_iter().ne(0..axes as u64) {
                        return Err(Fault::Broken("an order of axes that is none"));
                    }
                    order = turned.into_iter().map(|axis| order[axis as usize]).collect();
                }
                _ => codecs.push(Codec::of_third(codec)?),
            }
        }
        Ok(Self { codecs, big_endian, order })
    }
}

/// Why an array is not read.
pub(super) enum Fault {
    Broken(&'static str),
    Foreign(String),
}

pub(super) fn sizes(json: &Value) -> Result<Vec<u64>, Fault> {
    let sizes: Option<Vec<u64>> = json.as_array().and_then(|list| list.iter().map(Value::as_u64).collect());
    sizes.ok_or(Fault::Broken("sizes that are no list of whole numbers"))
}

/// What stands where no chunk is.
fn fill(json: &Value) -> f32 {
    match json {
        Value::Bool(value) => f32::from(u8::from(*value)),
        Value::String(text) => text.parse().unwrap_or(f32::NAN),
        value => value.as_f64().unwrap_or(0.0) as f32,
    }
}
