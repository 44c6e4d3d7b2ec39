//! Meshes: glTF, OBJ, PLY and STL. OBJ and PLY files without faces are points.

pub(crate) mod gltf;
mod lines;
pub(crate) mod obj;
pub(crate) mod ply;
pub(crate) mod stl;
