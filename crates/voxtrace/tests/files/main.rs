//! What becomes of files: every format read and written, whole and damaged, and what the library makes of grids. One program, so that its code is
//! linked once and tests of all modules run side by side. `cargo test -p voxtrace --test files native::` runs one module.

mod bending;
#[path = "../../../../fuzz/check/volume.rs"]
mod check_volume;
#[path = "../../../../fuzz/check/voxels.rs"]
mod check_voxels;
mod compressed_points;
mod corpus;
mod damage;
mod edits;
mod flat_files;
mod formats;
mod heightmaps;
mod large;
mod large_gltf;
mod malformed;
mod mesh_files;
mod mesh_samples;
mod meshes;
mod minecraft_blocks;
mod native;
mod panorama_damage;
mod pictures;
mod point_samples;
mod points;
mod points_damage;
mod points_streamed;
mod shared_tiles;
mod skins;
mod slices;
mod tiff_segments;
mod tiles;
mod vdb_files;
mod vdb_samples;
mod volume_files;
mod volume_samples;
mod vox_damage;
mod vox_files;
mod vox_kept;
mod vox_light;
mod vox_samples;
mod vox_write;
mod voxel_colors;
mod voxel_files;
mod voxel_samples;
mod voxelize;
mod voxelized;
mod white_meshes;
mod written_scenes;
mod zipped;
