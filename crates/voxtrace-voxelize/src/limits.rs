//! Resource limits for untrusted files. Importers check every size in a file against them, and against the bytes that are really
//! there, before they allocate.

/// The most that reading one file may use. The defaults suit untrusted files; raise them for your own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Bytes of input, after decompression.
    pub bytes: u64,
    /// Voxels stored in all grids together.
    pub voxels: u64,
    /// Vertices, triangles and points.
    pub points: u64,
    /// Items of any other kind: models, nodes, instances, layers, materials.
    pub items: u64,
    /// Nesting depth.
    pub depth: u32,
    /// Compression ratio: output bytes per compressed byte, checked once the output exceeds some megabytes, where a format's own compression has
    /// no bound. Where it has one, as Deflate, what it can make of the file is allowed.
    pub ratio: u64,
}

impl Default for Limits {
    fn default() -> Self {
        Self { bytes: 8 << 30, voxels: 2_000_000_000, points: 1 << 28, items: 1 << 20, depth: 64, ratio: 200 }
    }
}
