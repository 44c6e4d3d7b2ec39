//! What a pipeline is made for: its entry point, and the constants that it is specialized with.

use crate::method::Primitive;
use ash::vk;
use voxtrace_core::Integrator;
use voxtrace_core::frame_params::constant;

/// What a pass does.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Entry {
    /// Finds the first hit of rays.
    Cast,
    /// Adds samples, the study's way.
    RenderEssay,
    /// Adds samples, looking for light.
    RenderPath,
    /// A step of paths in waves.
    Wave(&'static str),
    /// A step of real-time light.
    RealTime(&'static str),
    /// Writes the mean of each pixel's samples for a window.
    Resolve,
    /// Lays that over another picture.
    Blend,
    /// A group of functions of the self-test.
    SelfTest(&'static str),
}

impl Entry {
    /// The entry that renders with an integrator.
    pub fn of(integrator: Integrator) -> Self {
        match integrator {
            Integrator::Essay => Self::RenderEssay,
            Integrator::Path => Self::RenderPath,
        }
    }

    /// Name of the entry point.
    pub fn name(self) -> &'static str {
        match self {
            Self::Cast => "cast_rays",
            Self::RenderEssay => "render_essay",
            Self::RenderPath => "render_path",
            Self::Resolve => "resolve",
            Self::Blend => "blend",
            Self::Wave(name) | Self::RealTime(name) | Self::SelfTest(name) => name,
        }
    }
}

/// What a pipeline is made for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Variant {
    pub entry: Entry,
    pub is_exact: bool,
    /// One instance that stands where its grid is.
    pub is_single: bool,
    /// The `top_shift` of all grids, 0 where they differ.
    pub top_shift: u32,
    /// The cells of bricks say which of their blocks hold a voxel.
    pub cells_have_blocks: bool,
    pub primitive: Primitive,
    /// The lens of camera rays, one of `LENS_`: choosing it while the shader runs costs `essay` a twentieth on an H200.
    pub lens: u32,
    /// The module that knows all materials.
    pub has_materials: bool,
    /// Cuts, which only that module knows.
    pub has_cuts: bool,
    /// A ground that shows shadows alone, which only that module knows, too.
    pub has_catcher: bool,
    /// Lines on the faces of voxels, likewise.
    pub has_lines: bool,
    /// Normals of voxels, likewise.
    pub has_normals: bool,
    /// Empty cells say how many cells a ray may skip, as those of the processor do.
    pub cells_skip: bool,
    /// Cells, bricks and materials lie in pages.
    pub has_pages: bool,
    /// The sky, one of `SKY_`: choosing it while the shader runs would cost scenes under a gradient.
    pub sky: u32,
}

/// Number of specialization constants.
const CONSTANTS: usize = 13;

/// Values of the specialization constants of `shaders/variant.slang` and `shaders/primitive.slang`. Modules that lack one
/// ignore it.
pub struct Specialization {
    data: [u32; CONSTANTS],
    entries: [vk::SpecializationMapEntry; CONSTANTS],
}

impl Specialization {
    pub fn new(variant: &Variant) -> Self {
        let Variant { is_exact, is_single, top_shift, cells_have_blocks, primitive, lens, sky, .. } = *variant;
        let constants: [(u32, u32); CONSTANTS] = [
            (constant::EXACT, is_exact.into()),
            (constant::IS_SINGLE, is_single.into()),
            (constant::PRIMITIVE, primitive as u32),
            (constant::TOP_SHIFT, top_shift),
            (constant::CELLS_HAVE_BLOCKS, cells_have_blocks.into()),
            (constant::LENS, lens),
            (constant::SKY, sky),
            (constant::CUTS, variant.has_cuts.into()),
            (constant::CATCHER, variant.has_catcher.into()),
            (constant::LINES, variant.has_lines.into()),
            (constant::NORMALS, variant.has_normals.into()),
            (constant::SKIPS, variant.cells_skip.into()),
            (constant::PAGES, variant.has_pages.into()),
        ];
        let entry =
            |at: usize| vk::SpecializationMapEntry { constant_id: constants[at].0, offset: 4 * at as u32, size: 4 };
        Self { data: constants.map(|(_, value)| value), entries: std::array::from_fn(entry) }
    }

    pub fn info(&self) -> vk::SpecializationInfo<'_> {
        vk::SpecializationInfo::default().map_entries(&self.entries).data(bytemuck::bytes_of(&self.data))
    }
}
