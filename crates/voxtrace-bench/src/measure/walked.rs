//! Which walk traced the rays of a cell on the processor: what ran, not what the processor could do.

use serde_json::{Value, json};
use voxtrace::RayCounts;

/// The walks of a cell.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Walked {
    /// The vector instructions that were to be used.
    pub instructions: String,
    /// Rays that they traced in packets, as streams, and those that were traced one after the other.
    pub packets: u64,
    pub streams: u64,
    pub scalar: u64,
    /// Rays within media, which go from voxel to voxel.
    pub in_media: u64,
}

impl Walked {
    /// Adds the rays of a frame.
    pub fn add(&mut self, counts: &RayCounts) {
        self.packets += counts.walks.packets;
        self.streams += counts.walks.streams;
        self.scalar += counts.walks.scalar;
        self.in_media += counts.total().saturating_sub(counts.walks.total());
    }

    /// In words: the instructions that ran, and the shares of the walks.
    pub fn text(&self) -> String {
        let vectors = self.packets + self.streams;
        let all = (vectors + self.scalar + self.in_media).max(1) as f64;
        let instructions = if vectors > 0 { self.instructions.as_str() } else { "ray after ray" };
        let parts = [
            (self.packets, "in packets"),
            (self.streams, "in streams"),
            (self.scalar, "ray after ray"),
            (self.in_media, "in media"),
        ];
        let parts: Vec<_> = parts.into_iter().filter(|(count, _)| *count > 0).collect();
        match parts[..] {
            [] => "no ray".into(),
            [(_, "ray after ray")] => instructions.into(),
            [(_, name)] => format!("{instructions} {name}"),
            _ => {
                let shares = parts.iter().map(|(count, name)| format!("{:.0} % {name}", 100.0 * *count as f64 / all));
                format!("{instructions}: {}", shares.collect::<Vec<_>>().join(", "))
            }
        }
    }

    /// As a cell of `results.json` has it.
    pub fn json(&self) -> Value {
        json!({
            "instructions": self.instructions, "packets": self.packets, "streams": self.streams, "scalar": self.scalar,
            "in_media": self.in_media,
        })
    }

    /// Reads what [`Self::json`] wrote.
    pub fn from_json(json: &Value) -> Option<Self> {
        let number = |name: &str| json[name].as_u64();
        Some(Self {
            instructions: json["instructions"].as_str()?.to_owned(),
            packets: number("packets")?,
            streams: number("streams")?,
            scalar: number("scalar")?,
            in_media: number("in_media")?,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn instructions_are_named_only_where_they_ran() {
        let walked = |packets, streams, scalar, in_media| {
            Walked { instructions: "AVX-512".into(), packets, streams, scalar, in_media }.text()
        };
        assert_eq!(walked(0, 0, 9, 0), "ray after ray");
        assert_eq!(walked(0, 9, 0, 0), "AVX-512 in streams");
        assert_eq!(walked(25, 75, 0, 0), "AVX-512: 25 % in packets, 75 % in streams");
        assert_eq!(walked(0, 0, 5, 5), "ray after ray: 50 % ray after ray, 50 % in media");
        assert_eq!(walked(0, 0, 0, 0), "no ray");
        let some = Walked { instructions: "AVX2".into(), packets: 1, streams: 2, scalar: 3, in_media: 4 };
        assert_eq!(Walked::from_json(&some.json()), Some(some));
    }
}
