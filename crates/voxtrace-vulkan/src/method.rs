//! The ways to find what a ray meets: their names, and settings that choose one.

/// How rays find voxels.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Traversal {
    /// The walk on the processor.
    Cpu,
    /// The walk in a compute shader: any GPU with Vulkan 1.2.
    Walk,
    /// The device's acceleration structure, asked by a compute shader: VK_KHR_ray_query.
    Query,
    /// The device's acceleration structure, asked by intersection and hit shaders: VK_KHR_ray_tracing_pipeline.
    Pipeline,
}

impl Traversal {
    /// All of them, simplest first.
    pub const ALL: [Self; 4] = [Self::Cpu, Self::Walk, Self::Query, Self::Pipeline];

    /// Name on the command line and in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Cpu => "cpu",
            Self::Walk => "walk",
            Self::Query => "query",
            Self::Pipeline => "pipeline",
        }
    }

    /// Whether it uses acceleration structures, and so primitives.
    pub fn uses_primitives(self) -> bool {
        matches!(self, Self::Query | Self::Pipeline)
    }
}

/// What the primitives of an acceleration structure are. Shaders know them by their numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[repr(u32)]
pub enum Primitive {
    /// A box around each voxel, hit where the ray really enters it.
    VoxelExact = 0,
    /// A box around each voxel, hit at the distance of its centre, as the study does: quick, and sometimes wrong.
    VoxelApprox = 1,
    /// A box around each brick of 8×8×8 voxels, walked inside.
    #[default]
    Brick = 2,
    /// A box around each instance, walked inside.
    Grid = 3,
    /// The faces of voxels that no other voxel covers, merged to rectangles of two triangles.
    Triangle = 4,
}

impl Primitive {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::VoxelExact, Self::VoxelApprox, Self::Brick, Self::Grid, Self::Triangle];

    /// Name on the command line and in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::VoxelExact => "voxel-exact",
            Self::VoxelApprox => "voxel-approx",
            Self::Brick => "brick",
            Self::Grid => "grid",
            Self::Triangle => "triangle",
        }
    }
}

/// How to trace.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Settings {
    /// How rays find voxels; not [`Traversal::Cpu`].
    pub traversal: Traversal,
    /// What acceleration structures are made of.
    pub primitive: Primitive,
    /// Whether pictures and hits are those of the CPU to the bit. Otherwise the driver may round as it likes, and rays that
    /// pass within about 1e-4 voxels of an edge may take either side of it: quicker by 5 to 10 %.
    pub is_exact: bool,
}

impl Default for Settings {
    fn default() -> Self {
        Self { traversal: Traversal::Walk, primitive: Primitive::default(), is_exact: true }
    }
}
