//! The table of what shaders share with the host: which Rust items they see, and under which names.

use super::records::Layout;

/// A Rust file and what shaders see of it.
pub struct Source {
    /// Path relative to the folder `crates`.
    pub file: &'static str,
    /// What shaders see of it.
    pub items: &'static [Item],
}

/// A Rust item that shaders see.
pub struct Item {
    /// Its name in Rust: a struct, a constant, an enumeration or a module of constants, or a constant of a type (`Type::NAME`).
    pub rust: &'static str,
    /// Its name in shaders: for enumerations and modules what the names of their constants begin with.
    pub shader: &'static str,
    /// Where records of this type lie; other items have none.
    pub layout: Layout,
}

/// An item that has the same name on both sides.
const fn same(name: &'static str) -> Item {
    named(name, name)
}

/// An item with a name of its own in shaders.
const fn named(rust: &'static str, shader: &'static str) -> Item {
    Item { rust, shader, layout: Layout::Storage }
}

/// A record in a uniform buffer.
const fn uniform(name: &'static str) -> Item {
    Item { rust: name, shader: name, layout: Layout::Uniform }
}

/// All that shaders share with the host.
pub const TABLE: &[Source] = &[
    Source {
        file: "voxtrace-scene/src/ray.rs",
        items: &[
            named("Ray", "RayRecord"),
            named("Hit", "HitRecord"),
            named("Hit::NONE", "NO_INSTANCE"),
            named("Hit::FIRST_CUT", "FIRST_CUT"),
        ],
    },
    Source { file: "voxtrace-scene/src/transform.rs", items: &[same("Transform")] },
    Source { file: "voxtrace-scene/src/sky/environment.rs", items: &[same("EnvironmentTexel")] },
    Source {
        file: "voxtrace-core/src/packed/mod.rs",
        items: &[
            same("CELL_OCCUPIED"),
            same("PackedGrid"),
            same("PackedInstance"),
            same("InstanceNode"),
            same("PackedMaterial"),
            same("Emitter"),
            same("LightNode"),
            named("LightNode::NONE", "NO_NODE"),
        ],
    },
    Source { file: "voxtrace-core/src/packed/instances.rs", items: &[same("MAX_INSTANCE_DEPTH")] },
    Source { file: "voxtrace-core/src/packed/lookup.rs", items: &[same("HEADER_INDEX_BITS"), same("HEADER_PALETTE")] },
    Source { file: "voxtrace-core/src/packed/device_cells.rs", items: &[same("CELL_INDEX_BITS")] },
    Source { file: "voxtrace-core/src/packed/boxes.rs", items: &[same("EXTENT_BITS")] },
    Source {
        file: "voxtrace-core/src/walk/local_ray.rs",
        items: &[
            same("TOLERANCE_SCALE"),
            same("SPEED_MIN"),
            same("SPEED_MAX"),
            same("T_END_SCALE"),
            same("MAX_ORIGIN"),
        ],
    },
    Source {
        file: "voxtrace-core/src/surface.rs",
        items: &[same("MARGIN_SCALE"), same("MARGIN_MIN"), same("MARGIN_MAX")],
    },
    Source {
        file: "voxtrace-core/src/normals/code.rs",
        items: &[same("NORMAL_BITS"), same("NO_NORMAL"), same("EDGE_BITS"), same("REACH"), same("TWO_SIDED")],
    },
    Source {
        file: "voxtrace-core/src/normals/shade.rs",
        items: &[same("LEAST_COSINE"), same("BACK"), same("MOST_CROSSED")],
    },
    Source { file: "voxtrace-core/src/cuts/mod.rs", items: &[same("PLANE_MARGIN_SCALE")] },
    Source { file: "voxtrace-core/src/cuts/span.rs", items: &[same("NO_PLANE")] },
    Source { file: "voxtrace-core/src/shadow_catcher.rs", items: &[same("FACE_UP"), same("HEIGHT_STEPS")] },
    Source { file: "voxtrace-core/src/math.rs", items: &[same("LN_2_HIGH"), same("LN_2_LOW")] },
    Source { file: "voxtrace-core/src/bsdf/microfacets.rs", items: &[same("SMOOTH_ALPHA"), same("MIN_COS")] },
    Source { file: "voxtrace-core/src/medium/mod.rs", items: &[same("FEW")] },
    Source { file: "voxtrace-core/src/medium/phase.rs", items: &[same("ISOTROPIC")] },
    Source { file: "voxtrace-core/src/medium/shadow.rs", items: &[same("MAX_BOUNDARIES")] },
    Source {
        file: "voxtrace-core/src/light/emitters.rs",
        items: &[same("FAR_SQUARED"), same("NEAREST_SHARE"), same("BY_NEAREST")],
    },
    Source {
        file: "voxtrace-core/src/light/mod.rs",
        items: &[same("BELOW_ONE"), named("Receiver::ALL_AROUND", "ALL_AROUND")],
    },
    Source { file: "voxtrace-core/src/bounce_limits.rs", items: &[named("BounceKind", "BOUNCE")] },
    Source { file: "voxtrace-core/src/integrator/mod.rs", items: &[same("DIMENSION_CAMERA"), same("DIMENSION_MEDIA")] },
    Source { file: "voxtrace-core/src/integrator/essay.rs", items: &[same("T_MIN"), same("T_MAX")] },
    Source {
        file: "voxtrace-core/src/integrator/path.rs",
        items: &[same("SURE_BOUNCES"), same("MOST_LIKELY_SURVIVAL"), same("MAX_PASSED")],
    },
    Source {
        file: "voxtrace-core/src/film.rs",
        items: &[same("RADIANCE_BITS"), same("MAX_SAMPLE_RADIANCE"), named("Pixel", "PixelRecord")],
    },
    Source {
        file: "voxtrace-core/src/frame_params.rs",
        items: &[
            uniform("FrameParams"),
            same("SKY_GRADIENT"),
            same("SKY_ENVIRONMENT"),
            same("LENS_PINHOLE"),
            same("LENS_THIN"),
            same("LENS_ORTHOGRAPHIC"),
            same("LENS_PANORAMA"),
            same("LENS_FISHEYE"),
            named("constant", "CONSTANT"),
        ],
    },
    Source {
        file: "voxtrace-vulkan/src/records.rs",
        items: &[
            uniform("Dispatch"),
            uniform("WaveStep"),
            uniform("BlendParams"),
            same("WAVE_ROUND_WORDS"),
            same("WAVE_COUNTS_WORDS"),
            same("ProbeRay"),
            same("ProbeAnswer"),
            named("ProbeAnswer::NOTHING", "NOTHING"),
            same("COUNTERS"),
            same("COUNTER_SLOTS"),
            named("Counter", "COUNTER"),
            named("binding", "BINDING"),
        ],
    },
    Source {
        file: "voxtrace-vulkan/src/pages/mod.rs",
        items: &[
            same("PAGE_BITS"),
            same("PAGE_HEADER"),
            same("PAGES_HAVE_LIGHTS"),
            same("EMITTER_WORDS"),
            same("LIGHT_NODE_WORDS"),
        ],
    },
    Source { file: "voxtrace-vulkan/src/passes.rs", items: &[same("WORKGROUP")] },
    Source { file: "voxtrace-vulkan/src/method.rs", items: &[named("Primitive", "PRIMITIVE")] },
    Source {
        file: "voxtrace-vulkan/src/accel/primitives.rs",
        items: &[same("VOXEL_WORDS"), same("BRICK_WORDS"), same("RECTANGLE_WORDS")],
    },
    Source {
        file: "voxtrace-vulkan/src/picture.rs",
        items: &[
            same("HALF_MAX"),
            same("BLUE_LOWEST"),
            same("PICTURE_BINDING"),
            same("DISPLAY_BINDING"),
            uniform("PresentParams"),
        ],
    },
    Source { file: "voxtrace-vulkan/src/probe/shot.rs", items: &[named("Reports", "REPORT")] },
    Source {
        file: "voxtrace-core/src/denoise/filter.rs",
        items: &[named("MOST_STEP", "TRUST_MOST_STEP"), same("TRUST_REACH")],
    },
    Source {
        file: "voxtrace-realtime/src/path.rs",
        items: &[same("DIMENSION_CANDIDATES"), same("DIMENSION_LEVEL"), same("LOOK_TOLERANCE")],
    },
    Source {
        file: "voxtrace-realtime/src/real_time.rs",
        items: &[
            named("SEED", "PATH_SEED"),
            same("LOOK_SEED"),
            same("CACHE_SEED"),
            same("LEAST_LOOKS"),
            same("MOST_LOOKS"),
            same("MOST_PATHS_AT_REST"),
        ],
    },
    Source {
        file: "voxtrace-realtime/src/on_devices.rs",
        items: &[uniform("RealTimeParams"), named("flag", "REAL_TIME")],
    },
    Source {
        file: "voxtrace-realtime/src/visibility.rs",
        items: &[
            named("Visibility::PLACES", "VISIBILITY_PLACES"),
            named("WIDTH", "VISIBILITY_WIDTH"),
            named("DIRECTIONS", "VISIBILITY_DIRECTIONS"),
            named("DISTANT", "VISIBILITY_DISTANT"),
            named("LARGEST", "VISIBILITY_LARGEST"),
            named("MOST_CUBES", "VISIBILITY_MOST_CUBES"),
            named("MOST_RAYS", "VISIBILITY_MOST_RAYS"),
            named("MOST_LEARNING", "VISIBILITY_MOST_LEARNING"),
        ],
    },
    Source {
        file: "voxtrace-realtime/src/memory.rs",
        items: &[
            same("LEAST_ALBEDO"),
            same("LEAST_SUM"),
            same("MOST_BEYOND"),
            same("NORMAL_STEPS"),
            same("NORMAL_ROUNDING"),
        ],
    },
    Source {
        file: "voxtrace-realtime/src/antialiasing.rs",
        items: &[same("SHOWN_REACH"), same("KEPT_SHARE"), same("SHOWN_MOST")],
    },
    Source {
        file: "voxtrace-realtime/src/reprojection.rs",
        items: &[
            named("PLACE_TOLERANCE", "BEFORE_PLACE_TOLERANCE"),
            named("LEAST_COSINE", "BEFORE_LEAST_COSINE"),
            named("LEAST_WEIGHT", "BEFORE_LEAST_WEIGHT"),
            named("MOST_COVERAGE", "BEFORE_MOST_COVERAGE"),
            named("MOST_AT_EDGES", "BEFORE_MOST_AT_EDGES"),
            named("STILL", "BEFORE_STILL"),
            named("NEARER", "BEFORE_NEARER"),
        ],
    },
    Source {
        file: "voxtrace-realtime/src/confidence.rs",
        items: &[
            named("SEED", "FOUND_SEED"),
            named("STRIDE", "FOUND_STRIDE"),
            named("REACH", "FOUND_REACH"),
            named("MOSTLY", "FOUND_MOSTLY"),
            named("PLACE_TOLERANCE", "FOUND_PLACE_TOLERANCE"),
        ],
    },
    Source {
        file: "voxtrace-realtime/src/light_cache/mod.rs",
        items: &[
            named("LightCache::CAPACITY", "CACHE_CAPACITY"),
            named("LightCache::BUDGET", "CACHE_BUDGET"),
            named("LightCache::MOST_CHOSEN", "CACHE_MOST_CHOSEN"),
            named("PROBES", "CACHE_PROBES"),
            named("WIDTH", "CACHE_WIDTH"),
            named("LEAST_DISTANCE", "CACHE_LEAST_DISTANCE"),
            named("MOST_SAMPLES", "CACHE_MOST_SAMPLES"),
            named("LIFE", "CACHE_LIFE"),
        ],
    },
    Source {
        file: "voxtrace-realtime/src/light_cache/key.rs",
        items: &[
            named("MOST_LEVEL", "CACHE_MOST_LEVEL"),
            named("CODE_BITS", "CACHE_CODE_BITS"),
            named("SCRAMBLE", "CACHE_SCRAMBLE"),
        ],
    },
    Source {
        file: "voxtrace-realtime/src/filter/surfaces.rs",
        items: &[
            named("NORMAL_TOLERANCE", "ALIKE_NORMAL_TOLERANCE"),
            named("PLACE_TOLERANCE", "ALIKE_PLACE_TOLERANCE"),
            named("LEAST_ALIKE", "ALIKE_LEAST"),
            same("SPLINE"),
        ],
    },
    Source {
        file: "voxtrace-realtime/src/filter/variance.rs",
        items: &[
            same("ENOUGH_PATHS"),
            same("SEVERAL_PATHS"),
            named("TOLERANCE", "LIGHT_TOLERANCE"),
            same("PATHS_OF_TOLERANCE"),
            same("TOLERANCE_FALL"),
            same("MANY_PATHS"),
            same("TOLERANCE_REACH"),
            same("SPATIAL_REACH"),
        ],
    },
    Source {
        file: "voxtrace-realtime/src/filter/wavelet.rs",
        items: &[
            named("LEAST_VARIANCE", "WAVELET_LEAST_VARIANCE"),
            named("THRESHOLD", "WAVELET_THRESHOLD"),
            named("NEIGHBOURHOOD", "WAVELET_NEIGHBOURHOOD"),
            same("MIDDLE"),
            same("NARROW_PATHS"),
            same("OTHERS_NOISE"),
        ],
    },
];
