//! The shaders, as `cargo xtask shaders` compiled them.

/// One module with all entry points of a pass.
#[derive(Clone, Copy)]
pub struct Module {
    /// Name of the pass.
    pub name: &'static str,
    bytes: &'static [u8],
    /// Whether the driver may fuse and reorder sums and products.
    is_fast: bool,
}

/// The walk, proved to the bit.
pub static WALK: Module = Module::new("walk", include_bytes!("../spirv/walk.spv"));
/// The walk of paths that know all materials.
pub static WALK_MATERIALS: Module = Module::new("walk (materials)", include_bytes!("../spirv/walk.materials.spv"));

/// The walk and the shading of paths in waves.
pub static WAVES: Module = Module::new("waves", include_bytes!("../spirv/waves.spv"));
/// Those of paths that know all materials.
pub static WAVES_MATERIALS: Module = Module::new("waves (materials)", include_bytes!("../spirv/waves.materials.spv"));

/// The steps of real-time light that trace rays.
pub static REALTIME: Module = Module::new("realtime", include_bytes!("../spirv/realtime.spv"));
/// Those of paths that know all materials.
pub static REALTIME_MATERIALS: Module =
    Module::new("realtime (materials)", include_bytes!("../spirv/realtime.materials.spv"));
/// Paths of real-time light in waves, among matte things.
pub static REALTIME_WAVES: Module = Module::new("realtime_waves", include_bytes!("../spirv/realtime_waves.spv"));
/// Those that left them, as they met other materials, in waves of their own.
pub static REALTIME_LEFT: Module = Module::new("realtime_left", include_bytes!("../spirv/realtime_left.spv"));
/// The other steps of real-time light.
pub static REALTIME_PIXELS: Module = Module::new("realtime_pixels", include_bytes!("../spirv/realtime_pixels.spv"));

/// What a window shows of a film.
pub static RESOLVE: Module = Module::new("resolve", include_bytes!("../spirv/resolve.spv"));
/// Lays that over another picture.
pub static BLEND: Module = Module::new("blend", include_bytes!("../spirv/blend.spv"));
/// Draws what a window shows.
pub static PRESENT: Module = Module::new("present", include_bytes!("../spirv/present.spv"));

/// The functions that shaders share with the library.
pub static SELFTEST: Module = Module::new("selftest", include_bytes!("../spirv/selftest.spv"));

/// Ray queries in a compute shader.
pub static QUERY: Module = Module::new("query", include_bytes!("../spirv/query.spv"));
/// Ray queries of paths that know all materials.
pub static QUERY_MATERIALS: Module = Module::new("query (materials)", include_bytes!("../spirv/query.materials.spv"));

/// Shaders of a ray tracing pipeline.
pub static PIPELINE: Module = Module::new("pipeline", include_bytes!("../spirv/pipeline.spv"));
/// Shaders of a ray tracing pipeline, of paths that know all materials.
pub static PIPELINE_MATERIALS: Module =
    Module::new("pipeline (materials)", include_bytes!("../spirv/pipeline.materials.spv"));

/// Driver probes through a ray tracing pipeline.
pub static PROBE_PIPELINE: Module = Module::new("probe_pipeline", include_bytes!("../spirv/probe_pipeline.spv"));
/// Driver probes through ray queries.
pub static PROBE_QUERY: Module = Module::new("probe_query", include_bytes!("../spirv/probe_query.spv"));

const OP_SOURCE: u32 = 3;
const OP_ENTRY_POINT: u32 = 15;
const OP_DECORATE: u32 = 71;
/// The decoration of results that are computed as written.
const NO_CONTRACTION: u32 = 42;
/// The decorations of what the device provides, and of what changes while a shader runs.
const BUILT_IN: u32 = 11;
const VOLATILE: u32 = 21;
/// The end of the ray, which each hit that is reported shortens.
const RAY_T_MAX: u32 = 5326;

impl Module {
    const fn new(name: &'static str, bytes: &'static [u8]) -> Self {
        Self { name, bytes, is_fast: false }
    }

    /// The module where the driver may fuse and reorder sums and products. What slangc makes of `-fp-mode fast` is the precise module without its
    /// decorations `NoContraction`, so it is made of that one.
    pub fn fast(self) -> Self {
        Self { is_fast: true, ..self }
    }

    /// The module's words. `OpSource`, which says in what language a module was written, is left out: validation layers
    /// older than Slang do not know its number. The end of the ray is volatile, as Vulkan wants it in intersection shaders
    /// (VUID-StandaloneSpirv-VulkanMemoryModel-04678); Slang does not say so.
    pub fn words(&self) -> Vec<u32> {
        let all: Vec<u32> = self.all_words();
        let mut words = all[..5].to_vec();
        let is_kept = |instruction: &&[u32]| match instruction[0] & 0xffff {
            OP_SOURCE => false,
            OP_DECORATE => !(self.is_fast && instruction[2] == NO_CONTRACTION),
            _ => true,
        };
        for instruction in instructions(&all).filter(is_kept) {
            words.extend_from_slice(instruction);
            if let [head, target, BUILT_IN, RAY_T_MAX] = *instruction
                && head & 0xffff == OP_DECORATE
            {
                words.extend([3 << 16 | OP_DECORATE, target, VOLATILE]);
            }
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
        // Thousands of sums and products are decorated, and nothing else is lost.
        let decorated = words.len() - WALK.fast().words().len();
        assert!(decorated > 3 * 100 && decorated.is_multiple_of(3), "{decorated} words");
        assert!(WALK.has_entry("cast_rays") && !WALK.has_entry("cast_ray"));
    }

    #[test]
    fn the_end_of_the_ray_is_volatile() {
        let count = |words: &[u32], wanted: &[u32]| {
            instructions(words).filter(|words| words[0] & 0xffff == OP_DECORATE && words[2..] == *wanted).count()
        };
        let (before, after) = (PIPELINE.all_words(), PIPELINE.words());
        let places = count(&before, &[BUILT_IN, RAY_T_MAX]);
        assert!(places > 0 && count(&before, &[VOLATILE]) == 0);
        assert_eq!(count(&after, &[VOLATILE]), places);
        assert_eq!(count(&WALK.words(), &[VOLATILE]), 0);
    }
}
