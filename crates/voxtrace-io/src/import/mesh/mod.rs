//! Meshes: glTF, OBJ, PLY and STL. OBJ and PLY files without faces are points.

pub(crate) mod gltf;
pub(crate) mod obj;
pub(crate) mod ply;
pub(crate) mod stl;
