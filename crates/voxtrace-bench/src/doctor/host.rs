//! The machine without its GPUs: processor, threads, memory.

use serde_json::{Value, json};
use voxtrace::CpuTracer;

/// What there is.
pub struct Host {
    pub threads: usize,
    /// Instructions that the walk uses.
    pub simd: &'static str,
    /// Instruction sets of the processor that matter to us.
    pub features: Vec<&'static str>,
    /// All memory and what is free of it, bytes, where the system tells.
    pub memory: Option<(u64, u64)>,
}

impl Host {
    pub fn of_this_machine() -> Self {
        Self {
            threads: rayon::current_num_threads(),
            simd: CpuTracer::simd_name(),
            features: features(),
            memory: std::fs::read_to_string("/proc/meminfo").ok().and_then(|text| memory(&text)),
        }
    }

    pub fn to_json(&self) -> Value {
        json!({
            "os": std::env::consts::OS, "arch": std::env::consts::ARCH, "threads": self.threads, "simd": self.simd,
            "cpu_features": self.features,
            "memory_bytes": self.memory.map(|(total, _)| total), "memory_available_bytes": self.memory.map(|(_, free)| free),
        })
    }
}

#[cfg(target_arch = "x86_64")]
fn features() -> Vec<&'static str> {
    let all = [
        ("sse4.2", std::arch::is_x86_feature_detected!("sse4.2")),
        ("avx2", std::arch::is_x86_feature_detected!("avx2")),
        ("fma", std::arch::is_x86_feature_detected!("fma")),
        ("bmi2", std::arch::is_x86_feature_detected!("bmi2")),
        ("avx512f", std::arch::is_x86_feature_detected!("avx512f")),
        ("avx512bw", std::arch::is_x86_feature_detected!("avx512bw")),
        ("avx512dq", std::arch::is_x86_feature_detected!("avx512dq")),
        ("avx512vl", std::arch::is_x86_feature_detected!("avx512vl")),
    ];
    all.into_iter().filter(|(_, is_there)| *is_there).map(|(name, _)| name).collect()
}

#[cfg(not(target_arch = "x86_64"))]
fn features() -> Vec<&'static str> {
    Vec::new()
}

/// All memory and what is free of it, from Linux's `/proc/meminfo`, bytes.
fn memory(text: &str) -> Option<(u64, u64)> {
    let value = |name: &str| -> Option<u64> {
        let rest = text.lines().find_map(|line| line.strip_prefix(name)?.strip_prefix(':'))?;
        rest.trim().strip_suffix("kB")?.trim().parse::<u64>().ok()?.checked_mul(1024)
    };
    Some((value("MemTotal")?, value("MemAvailable")?))
}

#[cfg(test)]
mod tests {
    use super::memory;

    #[test]
    fn memory_is_read_in_bytes_and_nonsense_is_nothing() {
        let text = "MemTotal:       24576 kB\nMemFree: 1 kB\nMemAvailable:    8192 kB\n";
        assert_eq!(memory(text), Some((24576 << 10, 8192 << 10)));
        assert_eq!(memory("MemTotal: much kB\nMemAvailable: 1 kB"), None);
        assert_eq!(memory(""), None);
    }
}
