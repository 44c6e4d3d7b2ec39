//! What tracers make of rays, light and materials, and of faults. One program: the device's shaders, which a software device compiles for most of the
//! time, are compiled side by side over all tests, and its code is linked once. `cargo test -p voxtrace-tests --test tracers lines::` runs one module.

mod approximation;
mod bounce_limits;
mod clear_shadows;
mod cuts;
mod edits;
mod environments;
mod exactness;
mod fast_tracers;
mod lenses;
mod light_changes;
mod light_groups;
mod light_sampling;
mod lines;
mod materials;
mod merged;
mod merged_pictures;
mod mirrors;
mod motion_blur;
mod normals;
mod pages;
mod physics;
mod placement;
mod placement_faults;
mod ray_counts;
mod sampling;
mod scene_pictures;
mod selftest;
mod shadow_catcher;
mod slab;
mod sun_disc;
mod surroundings;
mod volume_emission;
mod voxel_glass;
mod vulkan;
mod vulkan_faults;
