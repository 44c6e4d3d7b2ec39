//! The faces of voxels that no voxel covers, as quads that share their corners.

use super::cast::{Caster, Found};
use super::ffi;
use super::structure::Structure;
use crate::contender::Contender;
use crate::ray_sets::RaySet;
use std::ffi::CStr;
use voxtrace::grid::VoxelBox;
use voxtrace::ray::FACES;
use voxtrace::{Face, VoxelGrid, glam::IVec3};
use voxtrace_tests::reference::Bitmap;

/// Embree with a quad for each exposed face.
pub struct Quads {
    // Before the buffers, so that it is dropped first.
    structure: Structure,
    mesh: Mesh,
    caster: Caster,
    table_bytes: u64,
}

/// Corners, four of them for each quad, and a material for each quad.
#[derive(Default)]
struct Mesh {
    vertices: Vec<[f32; 3]>,
    quads: Vec<[u32; 4]>,
    materials: Vec<u16>,
}

impl Quads {
    /// Builds the quads of a grid. `table_bytes` is the size of the table of materials.
    pub fn build(grid: &VoxelGrid, table_bytes: u64, config: &CStr) -> Self {
        let mut mesh = Mesh::of(grid);
        let (vertices, quads) = (mesh.vertices.len(), mesh.quads.len());
        // Embree reads 16 bytes of each vertex of 12.
        mesh.vertices.push([0.0; 3]);
        mesh.vertices.shrink_to_fit();
        let (vertex, index) = (ffi::RTC_BUFFER_TYPE_VERTEX, ffi::RTC_BUFFER_TYPE_INDEX);
        // SAFETY: the geometry lives; the buffers hold what is said of them and outlive it.
        let structure = Structure::build(ffi::RTC_GEOMETRY_TYPE_QUAD, config, |geometry| unsafe {
            let data = mesh.vertices.as_ptr().cast();
            ffi::rtcSetSharedGeometryBuffer(geometry, vertex, 0, ffi::RTC_FORMAT_FLOAT3, data, 0, 12, vertices);
            let data = mesh.quads.as_ptr().cast();
            ffi::rtcSetSharedGeometryBuffer(geometry, index, 0, ffi::RTC_FORMAT_UINT4, data, 0, 16, quads);
        });
        Self { structure, mesh, caster: Caster::new(), table_bytes }
    }
}

impl Contender for Quads {
    fn name(&self) -> String {
        format!("Embree {}, exposed quads", self.structure.version())
    }

    fn tune(&mut self, rays: &RaySet) -> &'static str {
        self.caster.tune(&self.structure, rays)
    }

    fn cast(&mut self, rays: &RaySet) {
        self.caster.cast(&self.structure, rays);
    }

    fn found(&self, ray: usize) -> Option<(IVec3, f32)> {
        let found = self.caster.found[ray];
        (found.primitive != Found::NONE).then(|| (self.mesh.voxel(found.primitive), found.t))
    }

    fn memory(&self) -> Vec<(&'static str, u64)> {
        vec![
            ("Embree's hierarchy", self.structure.bytes()),
            ("corners", size_of_val(&*self.mesh.vertices) as u64),
            ("quads", size_of_val(&*self.mesh.quads) as u64),
            ("quad_materials", size_of_val(&*self.mesh.materials) as u64),
            ("materials", self.table_bytes),
        ]
    }

    fn build(&self) -> String {
        format!("{} quads, {}", self.mesh.quads.len(), self.structure.build_report())
    }
}

impl Mesh {
    fn of(grid: &VoxelGrid) -> Self {
        let bounds = grid.bounds().expect("the grid holds a voxel");
        let occupied = &Bitmap::of(grid);
        let mut voxels: Vec<(IVec3, u16)> = grid.voxels().collect();
        voxels.sort_by_key(|(voxel, _)| voxel.z);
        let exposed = |voxel: IVec3| FACES.into_iter().filter(move |face| !occupied.contains(voxel + face.normal()));
        let count = voxels.iter().map(|(voxel, _)| exposed(*voxel).count()).sum();
        let mut mesh =
            Self { quads: Vec::with_capacity(count), materials: Vec::with_capacity(count), ..Self::default() };
        let mut corners = Corners::new(bounds);
        for (voxel, material) in voxels {
            corners.climb_to(voxel.z);
            for face in exposed(voxel) {
                let quad = corners_of(voxel, face).map(|corner| corners.number(corner, &mut mesh.vertices));
                mesh.quads.push(quad);
                mesh.materials.push(material);
            }
        }
        mesh
    }

    /// The voxel that a quad belongs to.
    fn voxel(&self, quad: u32) -> IVec3 {
        let corner = self.quads[quad as usize].map(|vertex| {
            let [x, y, z] = self.vertices[vertex as usize];
            IVec3::new(x as i32, y as i32, z as i32)
        });
        let (along, across) = (corner[1] - corner[0], corner[3] - corner[0]);
        // The lowest corner of the quad is that of the voxel, or of its far face where the outward normal (the cross product) is positive.
        corner[0] - along.cross(across).max(IVec3::ZERO)
    }
}

/// The corners of a face, the lowest first, counter-clockwise as seen from outside.
fn corners_of(voxel: IVec3, face: Face) -> [IVec3; 4] {
    let axis = face.axis();
    let (along, across) = (IVec3::AXES[(axis + 1) % 3], IVec3::AXES[(axis + 2) % 3]);
    let low = voxel + face.normal().max(IVec3::ZERO);
    if face.normal()[axis] > 0 {
        [low, low + along, low + along + across, low + across]
    } else {
        [low, low + across, low + along + across, low + along]
    }
}

/// Numbers of the lattice points of the two planes z and z + 1 around a layer of voxels.
struct Corners {
    bounds: VoxelBox,
    z: i32,
    planes: [Vec<u32>; 2],
}

impl Corners {
    const NONE: u32 = u32::MAX;

    fn new(bounds: VoxelBox) -> Self {
        let size = bounds.size() + 1;
        let plane = vec![Self::NONE; size.x as usize * size.y as usize];
        Self { bounds, z: bounds.min.z, planes: [plane.clone(), plane] }
    }

    /// Advances to the layer `z`, which is not below the last one.
    fn climb_to(&mut self, z: i32) {
        for _ in self.z..z {
            self.planes.swap(0, 1);
            self.planes[1].fill(Self::NONE);
        }
        self.z = z;
    }

    /// The number of a corner, which becomes a new vertex where it has none.
    fn number(&mut self, corner: IVec3, vertices: &mut Vec<[f32; 3]>) -> u32 {
        let at = corner - self.bounds.min;
        let row = self.bounds.size().x as usize + 1;
        let number = &mut self.planes[(corner.z - self.z) as usize][at.y as usize * row + at.x as usize];
        if *number == Self::NONE {
            *number = vertices.len() as u32;
            vertices.push(corner.as_vec3().to_array());
        }
        *number
    }
}
