//! The shaders, as `cargo xtask shaders` compiled them.

/// One module with all entry points of a pass.
#[derive(Clone, Copy)]
pub struct Module {
    /// Name of the pass.
    pub name: &'static str,
    bytes: &'static [u8],
}

/// The walk, proved to the bit.
pub static WALK: Module = Module { name: "walk", bytes: include_bytes!("../spirv/walk.spv") };
/// The walk where the driver may fuse and reorder sums and products.
pub static WALK_FAST: Module = Module { name: "walk (fast)", bytes: include_bytes!("../spirv/walk.fast.spv") };
/// The walk of paths that know all materials.
pub static WALK_MATERIALS: Module =
    Module { name: "walk (materials)", bytes: include_bytes!("../spirv/walk.materials.spv") };
/// The same where the driver may fuse and reorder sums and products.
pub static WALK_MATERIALS_FAST: Module =
    Module { name: "walk (materials, fast)", bytes: include_bytes!("../spirv/walk.materials.fast.spv") };

/// What a window shows of a film.
pub static RESOLVE: Module = Module { name: "resolve", bytes: include_bytes!("../spirv/resolve.spv") };
/// Draws what a window shows.
pub static PRESENT: Module = Module { name: "present", bytes: include_bytes!("../spirv/present.spv") };

/// The functions that shaders share with the library.
pub static SELFTEST: Module = Module { name: "selftest", bytes: include_bytes!("../spirv/selftest.spv") };

/// Ray queries in a compute shader.
pub static QUERY: Module = Module { name: "query", bytes: include_bytes!("../spirv/query.spv") };
/// Ray queries where the driver may fuse and reorder sums and products.
pub static QUERY_FAST: Module = Module { name: "query (fast)", bytes: include_bytes!("../spirv/query.fast.spv") };
/// Ray queries of paths that know all materials.
pub static QUERY_MATERIALS: Module =
    Module { name: "query (materials)", bytes: include_bytes!("../spirv/query.materials.spv") };
/// The same where the driver may fuse and reorder sums and products.
pub static QUERY_MATERIALS_FAST: Module =
    Module { name: "query (materials, fast)", bytes: include_bytes!("../spirv/query.materials.fast.spv") };

/// Shaders of a ray tracing pipeline.
pub static PIPELINE: Module = Module { name: "pipeline", bytes: include_bytes!("../spirv/pipeline.spv") };
/// Shaders of a ray tracing pipeline where the driver may fuse and reorder sums and products.
pub static PIPELINE_FAST: Module =
    Module { name: "pipeline (fast)", bytes: include_bytes!("../spirv/pipeline.fast.spv") };
/// Shaders of a ray tracing pipeline, of paths that know all materials.
pub static PIPELINE_MATERIALS: Module =
    Module { name: "pipeline (materials)", bytes: include_bytes!("../spirv/pipeline.materials.spv") };
/// The same where the driver may fuse and reorder sums and products.
pub static PIPELINE_MATERIALS_FAST: Module =
    Module { name: "pipeline (materials, fast)", bytes: include_bytes!("../spirv/pipeline.materials.fast.spv") };

/// Driver probes through a ray tracing pipeline.
pub static PROBE_PIPELINE: Module =
    Module { name: "probe_pipeline", bytes: include_bytes!("../spirv/probe_pipeline.spv") };
/// Driver probes through ray queries.
pub static PROBE_QUERY: Module = Module { name: "probe_query", bytes: include_bytes!("../spirv/probe_query.spv") };

const OP_SOURCE: u32 = 3;
const OP_ENTRY_POINT: u32 = 15;

impl Module {
    /// The module's words. `OpSource`, which says in what language a module was written, is left out: validation layers
    /// older than Slang do not know its number.
    pub fn words(&self) -> Vec<u32> {
        let all: Vec<u32> = self.all_words();
        let mut words = all[..5].to_vec();
        for instruction in instructions(&all).filter(|instruction| instruction[0] & 0xffff != OP_SOURCE) {
            words.extend_from_slice(instruction);
        }
        words
    }

    /// Whether the module has an entry point of this name.
    pub fn has_entry(&self, name: &str) -> bool {
        let all = self.all_words();
        instructions(&all).filter(|instruction| instruction[0] & 0xffff == OP_ENTRY_POINT).any(|instruction| {
            let text: Vec<u8> = instruction[3..].iter().flat_map(|word| word.to_le_bytes()).collect();
            text.split(|&byte| byte == 0).next() == Some(name.as_bytes())
        })
    }

    fn all_words(&self) -> Vec<u32> {
        self.bytes.chunks_exact(4).map(|word| u32::from_le_bytes([word[0], word[1], word[2], word[3]])).collect()
    }
}

/// The instructions after the header (SPIR-V specification, section 2.3).
fn instructions(words: &[u32]) -> impl Iterator<Item = &[u32]> {
    let mut at = 5;
    std::iter::from_fn(move || {
        let length = (words.get(at)? >> 16).max(1) as usize;
        let instruction = words.get(at..at + length)?;
        at += length;
        Some(instruction)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn modules_keep_everything_but_the_source_language() {
        let (all, words) = (WALK.all_words(), WALK.words());
        let is_source = |instruction: &&[u32]| instruction[0] & 0xffff == OP_SOURCE;
        let dropped: usize = instructions(&all).filter(is_source).map(<[u32]>::len).sum();
        assert_eq!(all.len(), words.len() + dropped);
        assert_eq!(instructions(&words).filter(is_source).count(), 0);
        assert!(WALK.has_entry("cast_rays") && !WALK.has_entry("cast_ray"));
    }
}
