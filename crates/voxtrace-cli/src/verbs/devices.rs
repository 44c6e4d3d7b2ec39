//! `voxtrace devices`: what this build can trace on, here.

use crate::failure::Failure;
use serde_json::json;
use voxtrace::walk::simd_name;

/// List what this machine can render on
#[derive(clap::Args, Clone, Debug)]
pub struct DevicesArgs {
    /// As JSON
    #[arg(long)]
    json: bool,
}

impl DevicesArgs {
    pub fn run(self) -> Result<(), Failure> {
        let (threads, simd) = (rayon::current_num_threads(), simd_name());
        if self.json {
            let value = json!({ "devices": [{ "name": "cpu", "kind": "cpu", "threads": threads, "simd": simd }] });
            crate::print(&format!("{value:#}\n"));
        } else {
            crate::print(&format!("cpu  {threads} threads, instructions in use: {simd}\n"));
            crate::print("GPU tracers are not in this build.\n");
        }
        Ok(())
    }
}
