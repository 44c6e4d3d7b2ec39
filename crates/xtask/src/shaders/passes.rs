//! The table of shader passes: entry points and variants of each.

use std::collections::BTreeSet;
use std::path::Path;

/// A file `shaders/pass/NAME.slang`. All its entry points come in one SPIR-V module for each variant.
pub struct Pass {
    /// Name of the file, without extension.
    pub name: &'static str,
    /// Names of its entry points.
    pub entries: &'static [&'static str],
    /// The variants that are compiled.
    pub variants: &'static [Variant],
    /// Whether it is also compiled to WGSL: it needs only compute and storage buffers.
    pub has_wgsl: bool,
    /// Whether it reads `FrameParams` from a storage buffer: `docs/drivers/README.md` says why.
    pub has_frame_in_storage: bool,
}

/// A variant: how a pass is compiled.
pub struct Variant {
    /// Suffix of the module's name.
    pub suffix: &'static str,
    /// Whether paths know all materials: the macro `WITH_MATERIALS`.
    pub has_materials: bool,
    /// Whether paths are traced in waves: the macro `WITH_WAVES`.
    pub has_waves: bool,
    /// Whether they are those of real-time light: the macro `WITH_REAL_TIME`.
    pub has_real_time: bool,
}

/// Paths that know matte surfaces only.
const MATTE: Variant = Variant { suffix: "", has_materials: false, has_waves: false, has_real_time: false };
/// Paths that know all materials.
const MATERIALS: Variant =
    Variant { suffix: ".materials", has_materials: true, has_waves: false, has_real_time: false };
/// Both with paths in waves.
const WAVES: &[Variant] = &[Variant { has_waves: true, ..MATTE }, Variant { has_waves: true, ..MATERIALS }];
/// Both with paths of real-time light.
const REAL_TIME: &[Variant] = &[Variant { has_real_time: true, ..MATTE }, Variant { has_real_time: true, ..MATERIALS }];
/// Both with paths of real-time light in waves.
const REAL_TIME_WAVES: &[Variant] = &[
    Variant { has_waves: true, has_real_time: true, ..MATTE },
    Variant { has_waves: true, has_real_time: true, ..MATERIALS },
];
/// The variants of passes that render.
const RENDERING: &[Variant] = &[MATTE, MATERIALS];

/// The passes that `cargo xtask web` compiles, to WGSL alone, in the order in which pages have them: films, real-time light's paths, and its steps that trace no rays.
pub const OF_PAGES: &[Pass] = &[
    Pass {
        name: "page",
        entries: &["begin_paths", "choose_lights", "scatter_paths", "shade_paths", "walk_paths"],
        variants: WAVES,
        has_wgsl: true,
        has_frame_in_storage: false,
    },
    Pass {
        name: "page_realtime",
        entries: &[
            "begin_looks",
            "begin_paths",
            "choose_lights",
            "end_looks",
            "end_paths",
            "scatter_paths",
            "shade_paths",
            "walk_paths",
        ],
        variants: REAL_TIME_WAVES,
        has_wgsl: true,
        has_frame_in_storage: false,
    },
    Pass {
        name: "realtime_pixels",
        entries: &[
            "choose_cells",
            "end_cells",
            "filter_across",
            "filter_begin",
            "filter_compare",
            "filter_end",
            "filter_level_0",
            "filter_level_1",
            "filter_level_2",
            "filter_level_3",
            "filter_level_4",
            "filter_noise",
            "filter_picture",
            "filter_tolerance",
            "remember",
            "reproject",
            "show_picture",
        ],
        variants: &[Variant { has_waves: true, has_real_time: true, ..MATTE }],
        has_wgsl: true,
        has_frame_in_storage: false,
    },
];

/// All other passes.
pub const PASSES: &[Pass] = &[
    Pass { name: "blend", entries: &["blend"], variants: &[MATTE], has_wgsl: false, has_frame_in_storage: false },
    Pass {
        name: "pipeline",
        entries: &[
            "any_hit_box",
            "any_hit_triangle",
            "cast_rays",
            "closest_hit_box",
            "closest_hit_triangle",
            "intersect",
            "missed",
            "render_essay",
            "render_path",
        ],
        variants: RENDERING,
        has_wgsl: false,
        has_frame_in_storage: true,
    },
    Pass {
        name: "present",
        entries: &["present_curve", "present_fragment", "present_vertex"],
        variants: &[MATTE],
        has_wgsl: false,
        has_frame_in_storage: false,
    },
    Pass {
        name: "probe_pipeline",
        entries: &["any_hit_box", "cast_rays", "closest_hit_box", "intersect", "missed"],
        variants: &[MATTE],
        has_wgsl: false,
        has_frame_in_storage: false,
    },
    Pass {
        name: "probe_query",
        entries: &["cast_rays"],
        variants: &[MATTE],
        has_wgsl: false,
        has_frame_in_storage: false,
    },
    Pass {
        name: "query",
        entries: &["cast_rays", "render_essay", "render_path"],
        variants: RENDERING,
        has_wgsl: false,
        has_frame_in_storage: false,
    },
    Pass {
        name: "realtime",
        entries: &["remember", "trace", "trace_before", "trace_left"],
        variants: REAL_TIME,
        has_wgsl: true,
        has_frame_in_storage: false,
    },
    Pass {
        name: "realtime_left",
        entries: &["begin_left", "finish_left", "shade_left", "walk_left"],
        variants: &[Variant { suffix: "", has_real_time: true, ..MATERIALS }],
        has_wgsl: false,
        has_frame_in_storage: false,
    },
    Pass {
        name: "realtime_pixels",
        entries: &[
            "choose_cells",
            "compare_found",
            "doubt",
            "end_cells",
            "filter_across",
            "filter_begin",
            "filter_compare",
            "filter_end",
            "filter_level_0",
            "filter_level_1",
            "filter_level_2",
            "filter_level_3",
            "filter_level_4",
            "filter_noise",
            "filter_picture",
            "filter_tolerance",
            "remember_others",
            "reproject",
            "show_picture",
        ],
        variants: &[MATTE],
        has_wgsl: true,
        has_frame_in_storage: false,
    },
    Pass {
        name: "realtime_waves",
        entries: &[
            "list_left",
            "trace_again",
            "trace_camera",
            "trace_ends",
            "trace_first",
            "trace_light",
            "trace_on",
            "trace_on_rays",
            "trace_rays",
            "trace_rest",
        ],
        variants: &[Variant { has_real_time: true, ..MATTE }],
        has_wgsl: true,
        has_frame_in_storage: false,
    },
    Pass { name: "resolve", entries: &["resolve"], variants: &[MATTE], has_wgsl: true, has_frame_in_storage: false },
    Pass {
        name: "selftest",
        entries: &[
            "check_brick",
            "check_bsdf",
            "check_camera",
            "check_distant_light",
            "check_equal_area",
            "check_exact",
            "check_film",
            "check_light",
            "check_local_ray",
            "check_material",
            "check_medium",
            "check_math",
            "check_rounding",
            "check_sampler",
            "check_surface",
        ],
        variants: &[Variant { suffix: "", ..MATERIALS }],
        has_wgsl: true,
        has_frame_in_storage: false,
    },
    Pass {
        name: "waves",
        entries: &["wave_begin", "wave_end", "wave_finish", "wave_lit", "wave_shade", "wave_walk"],
        variants: WAVES,
        has_wgsl: false,
        has_frame_in_storage: false,
    },
    Pass {
        name: "walk",
        entries: &["cast_rays", "render_essay", "render_path"],
        variants: RENDERING,
        has_wgsl: true,
        has_frame_in_storage: false,
    },
];

/// Checks that the table names every file of the folder and no other.
pub fn check_table(folder: &Path) -> Result<(), String> {
    let files: BTreeSet<String> = std::fs::read_dir(folder)
        .into_iter()
        .flatten()
        .flatten()
        .filter_map(|entry| entry.file_name().to_str()?.strip_suffix(".slang").map(str::to_string))
        .collect();
    let table: BTreeSet<String> = PASSES.iter().chain(OF_PAGES).map(|pass| pass.name.to_string()).collect();
    match files.symmetric_difference(&table).next() {
        Some(name) => Err(format!("shaders/pass and the table in xtask's passes.rs disagree about `{name}`")),
        None => Ok(()),
    }
}
