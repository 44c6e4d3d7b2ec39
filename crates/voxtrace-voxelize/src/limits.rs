//! Bounds on what an untrusted file may ask for. Importers check every number of a file against them, and against the
//! bytes that are really there, before they allocate.

/// What a file may at most ask for. The default suits files from strangers; raise it for your own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Bytes of input, after decompression.
    pub bytes: u64,
    /// Voxels stored in all grids together.
    pub voxels: u64,
    /// Corners, triangles and points.
    pub points: u64,
    /// Items of any other kind: models, nodes, instances, layers, materials.
    pub items: u64,
    /// Depth of nesting.
    pub depth: u32,
    /// Bytes that may come out of each compressed byte, where it is more than some megabytes in all.
    pub ratio: u64,
}

impl Default for Limits {
    fn default() -> Self {
        Self { bytes: 8 << 30, voxels: 2_000_000_000, points: 1 << 28, items: 1 << 20, depth: 64, ratio: 200 }
    }
}
