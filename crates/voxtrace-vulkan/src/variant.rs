//! What a pipeline is made for: its entry point, and the constants that it is specialized with.

use crate::method::Primitive;
use ash::vk;
use voxtrace_core::Integrator;

/// What a pass does.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Entry {
    /// Finds the first hit of rays.
    Cast,
    /// Adds samples, the study's way.
    RenderEssay,
    /// Adds samples, looking for light.
    RenderPath,
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
            Self::SelfTest(name) => name,
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
}

/// Number of specialization constants.
const CONSTANTS: usize = 5;

/// Values of the specialization constants of `shaders/variant.slang` and `shaders/primitive.slang`. Modules that lack one
/// ignore it.
pub struct Specialization {
    data: [u32; CONSTANTS],
    entries: [vk::SpecializationMapEntry; CONSTANTS],
}

impl Specialization {
    pub fn new(variant: &Variant) -> Self {
        let Variant { is_exact, is_single, top_shift, cells_have_blocks, primitive, .. } = *variant;
        let entry = |id: u32| vk::SpecializationMapEntry { constant_id: id, offset: 4 * id, size: 4 };
        Self {
            data: [is_exact.into(), is_single.into(), primitive as u32, top_shift, cells_have_blocks.into()],
            entries: std::array::from_fn(|id| entry(id as u32)),
        }
    }

    pub fn info(&self) -> vk::SpecializationInfo<'_> {
        vk::SpecializationInfo::default().map_entries(&self.entries).data(bytemuck::bytes_of(&self.data))
    }
}
