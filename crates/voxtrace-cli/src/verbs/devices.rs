//! `voxtrace devices`: what this build can trace on, here.

use crate::failure::Failure;
use serde_json::json;

/// List what this machine can render on
#[derive(clap::Args, Clone, Debug)]
pub struct DevicesArgs {
    /// As JSON
    #[arg(long)]
    json: bool,
}

impl DevicesArgs {
    pub fn run(self) -> Result<(), Failure> {
        let threads = rayon::current_num_threads();
        let simd = simd();
        if self.json {
            let value = json!({ "devices": [{ "name": "cpu", "kind": "cpu", "threads": threads, "simd": simd }] });
            crate::print(&format!("{value:#}\n"));
        } else {
            let simd = if simd.is_empty() { "none".into() } else { simd.join(", ") };
            crate::print(&format!(
                "cpu  {threads} threads; vector instructions there: {simd}\nGPU tracers are not in this build.\n"
            ));
        }
        Ok(())
    }
}

/// Vector instruction sets of this processor, the narrowest first.
fn simd() -> Vec<&'static str> {
    let mut found = Vec::new();
    #[cfg(target_arch = "x86_64")]
    {
        found.push("sse2");
        for (name, is_there) in [
            ("sse4.1", std::arch::is_x86_feature_detected!("sse4.1")),
            ("avx2", std::arch::is_x86_feature_detected!("avx2")),
            ("avx512f", std::arch::is_x86_feature_detected!("avx512f")),
        ] {
            if is_there {
                found.push(name);
            }
        }
    }
    #[cfg(target_arch = "aarch64")]
    found.push("neon");
    found
}
