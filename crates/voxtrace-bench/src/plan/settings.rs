//! The settings of a benchmark: the same for all of its cells, written into its results, and asked again of a benchmark that
//! goes on.

use super::cell::Cell;
use serde_json::{Value, json};
use voxtrace::{Integrator, scenes};
use voxtrace_vulkan::{Primitive, Traversal};

/// Size of the study's pictures (sic).
pub const STUDY_SIZE: (u32, u32) = (1980, 1080);
/// Frames that a quick benchmark has of each cell.
pub const LEAST_FRAMES: u32 = 64;
/// Sizes of the sweep where none are asked for, voxels.
const SWEEP_SIZES: [u64; 6] = [500_000, 1_000_000, 2_000_000, 4_000_000, 8_000_000, 16_000_000];
/// The largest of them on the CPU and devices in software.
const MOST_IN_SOFTWARE: u64 = 4_000_000;

/// What was asked for, the same for all cells.
#[derive(Clone, Debug)]
pub struct Plan {
    /// Scenes as they were named.
    pub scenes: Vec<String>,
    pub cells: Vec<Cell>,
    /// Voxels of the built-in scenes, `None` for the study's.
    pub voxels: Option<u64>,
    /// Trees, rocks and lamps of the scene `forest`, `None` for its own.
    pub instances: Option<u32>,
    /// Sizes of the sweep.
    pub sweep: Vec<u64>,
    pub frames: u32,
    pub warm_up: u32,
    pub time_limit_s: Option<f64>,
    pub width: u32,
    pub height: u32,
    pub max_bounces: u32,
    pub integrator: Integrator,
    pub seed: u32,
    pub is_exact: bool,
    /// What tells the host's options about scenes from others; `None` for none.
    pub scene_options: Option<String>,
}

impl Plan {
    /// Scenes of the sweep: the built-in ones, once each.
    pub fn sweep_scenes(&self) -> Vec<String> {
        let names = scenes::STUDY_NAMES.iter().filter(|name| self.scenes.iter().any(|scene| scene == *name));
        names.map(ToString::to_string).collect()
    }

    /// Cells of the sweep: the study's method, the best of ours in a pipeline and outside, and the CPU where there is
    /// nothing else.
    pub fn sweep_cells(&self) -> Vec<Cell> {
        let is_chosen = |cell: &Cell| match cell.traversal {
            Traversal::Cpu => false,
            Traversal::Walk => true,
            _ => matches!(cell.primitive, Some(Primitive::VoxelExact | Primitive::Grid)),
        };
        let chosen: Vec<Cell> = self.cells.iter().copied().filter(is_chosen).collect();
        if chosen.is_empty() { self.cells.iter().copied().take(1).collect() } else { chosen }
    }

    pub fn json(&self) -> Value {
        json!({
            "scenes": self.scenes, "cells": self.cells.iter().map(|cell| cell.name()).collect::<Vec<_>>(),
            "voxels": self.voxels, "instances": self.instances, "sweep": self.sweep,
            "width": self.width, "height": self.height, "frames": self.frames, "warm_up": self.warm_up,
            "time_limit_s": self.time_limit_s, "max_bounces": self.max_bounces, "integrator": self.integrator.name(),
            "seed": self.seed, "shaders": if self.is_exact { "precise" } else { "fast" },
            "scene_options": self.scene_options,
        })
    }
}

/// The sizes of the sweep where none are asked for.
pub fn usual_sweep(is_hardware: bool) -> impl Iterator<Item = u64> {
    let most = if is_hardware { u64::MAX } else { MOST_IN_SOFTWARE };
    SWEEP_SIZES.into_iter().filter(move |&size| size <= most)
}
