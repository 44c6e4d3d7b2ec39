//! Why things cannot be placed.

/// Things cannot be placed so.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum PlacementError {
    /// An instance names a grid that the geometry lacks.
    #[error("instance {instance} shows grid {grid}, but the geometry has {count}")]
    MissingGrid {
        /// Index of the instance.
        instance: usize,
        /// Index of the grid.
        grid: usize,
        /// Grids there are.
        count: usize,
    },
    /// A visible instance shows a grid of the scene that was not packed, because nothing that was visible showed it then.
    #[error("instance {instance} shows grid {grid} of the scene, which was not packed")]
    NotPacked {
        /// Index of the instance.
        instance: usize,
        /// Index of the grid in the scene.
        grid: usize,
    },
    /// An instance is sheared, scaled unevenly, flattened or not finite.
    #[error("the transform of instance {0} is not a rotation, mirror, uniform scale and translation")]
    BadTransform(usize),
    /// The placement was made for another geometry.
    #[error("the placement belongs to another geometry")]
    OtherGeometry,
    /// Instances became one grid when the scene was packed.
    #[error(
        "instances of the scene were merged when it was packed; to move them, pack it with instances kept, or split it"
    )]
    Merged,
}
