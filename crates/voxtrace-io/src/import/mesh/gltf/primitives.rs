//! The triangles of a primitive, placed by its node, appended to the mesh; of a document without any its points and lines.

use super::Fault;
use super::accessor::Accessors;
use super::document::Primitive;
use super::draco::Geometry;
use super::morphs;
use super::skins::{Bound, Pose};
use crate::import::mesh::lines::Lines;
use crate::import::reader::local_origin::LocalOrigin;
use glam::{DAffine3, DVec3, Vec2, Vec4};
use voxtrace_voxelize::mesh::Mesh;

const LINES: u32 = 1;
const LOOP: u32 = 2;
const LINE_STRIP: u32 = 3;
const TRIANGLES: u32 = 4;
const STRIP: u32 = 5;
const FAN: u32 = 6;

/// Where the attributes of a primitive come from.
pub(super) struct Source<'a> {
    pub accessors: &'a Accessors<'a>,
    pub packed: Option<&'a Geometry<'a>>,
}

impl Source<'_> {
    /// As [`Accessors::vectors`], from what is packed where it is there.
    pub fn vectors(
        &self,
        name: &str,
        index: usize,
        kinds: &[&str],
        missing: f32,
        mut each: impl FnMut([f32; 4]),
    ) -> Result<usize, Fault> {
        let accessor = self.accessors.of_kinds(index, kinds)?;
        let packed = self.packed.map(|packed| packed.vectors(name, accessor, missing, &mut each)).transpose()?;
        match packed.flatten() {
            Some(count) => Ok(count),
            None => self.accessors.vectors(index, kinds, missing, each),
        }
    }
}

/// What is packed of a primitive, if something is.
pub(super) fn packed<'a>(primitive: &'a Primitive, accessors: &Accessors) -> Result<Option<Geometry<'a>>, Fault> {
    let packed = primitive.extensions.draco.as_ref();
    packed.map(|draco| Geometry::read(draco, accessors.buffers, accessors.limits)).transpose()
}

/// Whether a primitive has triangles.
pub(super) fn has_triangles(primitive: &Primitive) -> bool {
    [TRIANGLES, STRIP, FAN].contains(&primitive.mode) && primitive.attributes.contains_key("POSITION")
}

/// How many triangles so many corners are.
pub(super) fn triangle_count(mode: u32, corners: u64) -> u64 {
    if mode == TRIANGLES { corners / 3 } else { corners.saturating_sub(2) }
}

/// Which corners a triangle has.
pub(super) fn triangle_at(mode: u32, at: u64) -> [u64; 3] {
    match mode {
        STRIP if at.is_multiple_of(2) => [at, at + 1, at + 2],
        STRIP => [at + 1, at, at + 2],
        FAN => [0, at + 1, at + 2],
        _ => [3 * at, 3 * at + 1, 3 * at + 2],
    }
}

/// A vertex in the world: up is y in the file and z with us.
pub(super) fn placed(world: &DAffine3, [x, y, z, _]: [f32; 4]) -> DVec3 {
    raised(world.transform_point3(DVec3::new(x.into(), y.into(), z.into())))
}

/// A point of the file's axes in ours.
pub(super) fn raised(point: DVec3) -> DVec3 {
    DVec3::new(point.x, -point.z, point.y)
}

/// Name and accessor of the texture coordinates that the material of a primitive needs.
pub(super) fn coordinates(
    primitive: &Primitive,
    material: usize,
    look: &Mesh,
    coordinate_sets: &[u32],
) -> Option<(String, usize)> {
    let looks = &look.materials[material];
    if [looks.base_texture, looks.emission_texture, looks.surface_texture].iter().all(Option::is_none) {
        return None;
    }
    let set = material.checked_sub(1).map_or(0, |material| coordinate_sets[material]);
    let name = format!("TEXCOORD_{set}");
    primitive.attributes.get(&name).map(|&index| (name, index))
}

/// The vertices that were appended last, and their material.
struct Vertices {
    first: usize,
    count: usize,
    material: usize,
}

/// What shapes the vertices of a primitive before it is placed.
#[derive(Clone, Copy, Default)]
pub(super) struct Form<'a> {
    /// Of its morph targets.
    pub weights: &'a [f32],
    /// Of the joints that its vertices follow.
    pub pose: Option<&'a Pose>,
}

/// Where primitives go.
pub(super) struct Target<'a> {
    pub mesh: &'a mut Mesh,
    pub local_origin: LocalOrigin,
    /// Coordinate set of each material of the document; material 0 of the mesh stands for none.
    pub coordinate_sets: &'a [u32],
}

impl Target<'_> {
    /// Appends a primitive, which `world` takes to the world from its own space, or from that of the pose whose joints place its vertices. False where
    /// it has no triangles.
    pub fn push(
        &mut self,
        primitive: &Primitive,
        accessors: &Accessors,
        world: &DAffine3,
        form: Form,
    ) -> Result<bool, Fault> {
        let position = primitive.attributes.get("POSITION").filter(|_| has_triangles(primitive));
        let Some(&position) = position else { return Ok(false) };
        let packed = packed(primitive, accessors)?;
        let source = Source { accessors, packed: packed.as_ref() };
        let Vertices { first, count, material } = self.push_vertices(primitive, position, &source, (world, form))?;
        let is_mirrored = (world.matrix3.determinant() < 0.0) != form.pose.is_some_and(Pose::is_mirrored);
        self.push_triangles(primitive, &source, [first, count], is_mirrored)?;
        self.mesh.material_of.resize(self.mesh.triangles.len(), material as u16);
        Ok(true)
    }

    /// Appends the vertices of a primitive of points or lines, in the colour of its material, and the lines. False where it is
    /// something else.
    pub fn push_loose(
        &mut self,
        primitive: &Primitive,
        accessors: &Accessors,
        world: &DAffine3,
        form: Form,
        lines: &mut Lines,
    ) -> Result<bool, Fault> {
        let position = primitive.attributes.get("POSITION").filter(|_| primitive.mode < TRIANGLES);
        let Some(&position) = position else { return Ok(false) };
        let source = Source { accessors, packed: None };
        let Vertices { first, count, material } = self.push_vertices(primitive, position, &source, (world, form))?;
        let base_color = self.mesh.materials[material].base_color;
        if material > 0 {
            self.mesh.colors.resize(first + count, Vec4::ONE);
            self.mesh.colors[first..].iter_mut().for_each(|color| *color *= base_color);
        }
        let ends = match primitive.indices {
            Some(indices) => accessors.indices(indices)?,
            None => (0..count as u32).collect(),
        };
        if let Some(end) = ends.iter().find(|&&end| end as usize >= count) {
            return Err(Fault::malformed(format!("a line names vertex {end} of {count}")));
        }
        let mut join = |from: u32, to: u32| lines.join(from + first as u32, to + first as u32);
        match primitive.mode {
            LINES => ends.as_chunks().0.iter().for_each(|&[from, to]| join(from, to)),
            LOOP | LINE_STRIP => ends.windows(2).for_each(|pair| join(pair[0], pair[1])),
            _ => {}
        }
        if let (LOOP, [start, .., end]) = (primitive.mode, &ends[..]) {
            join(*end, *start);
        }
        Ok(true)
    }

    /// Appends the vertices of a primitive, and says which they are.
    fn push_vertices(
        &mut self,
        primitive: &Primitive,
        position: usize,
        source: &Source,
        (world, form): (&DAffine3, Form),
    ) -> Result<Vertices, Fault> {
        let accessors = source.accessors;
        let accessor = accessors.document.accessors.get(position);
        if let Some(name) = primitive.extensions.others.keys().find(|name| name.contains("compression"))
            && accessor.is_some_and(|accessor| accessor.buffer_view.is_none())
        {
            return Err(Fault::unsupported(format!("a mesh compressed with the glTF extension {name}")));
        }
        let limit = accessors.limits.points;
        let first = self.mesh.positions.len();
        let own = accessor.map_or(0, |accessor| accessor.count);
        let announced = first as u64 + own as u64;
        if announced > limit {
            return Err(Fault::limit("vertices", announced, limit));
        }
        if announced > u64::from(u32::MAX) {
            return Err(Fault::unsupported(format!(
                "vertices: {announced} is more than the fixed limit of {}",
                u32::MAX
            )));
        }
        let bound = form.pose.map(|pose| Ok::<_, Fault>((Bound::read(pose, primitive, source)?, pose))).transpose()?;
        let offsets = morphs::offsets(primitive, form.weights, own, source)?;
        let mut vertex = 0;
        let push = |[x, y, z, _]: [f32; 4]| {
            let mut point = DVec3::new(x.into(), y.into(), z.into());
            if let Some(offset) = offsets.get(vertex) {
                point += *offset;
            }
            if let Some((bound, pose)) = &bound {
                point = bound.placed(vertex, point, pose.joints());
            }
            vertex += 1;
            self.mesh.positions.push(self.local_origin.localized(raised(world.transform_point3(point))));
        };
        let count = source.vectors("POSITION", position, &["VEC3"], 0.0, push)?;
        bound.map_or(Ok(()), |(bound, _)| check_count(bound.count(), count))?;
        if !offsets.is_empty() {
            check_count(offsets.len(), count)?;
        }
        if self.mesh.positions.len() as u64 > limit {
            return Err(Fault::limit("vertices", self.mesh.positions.len() as u64, limit));
        }
        if self.mesh.positions[first..].iter().any(|position| !position.is_finite()) {
            return Err(Fault::malformed("a vertex that is not finite"));
        }
        let material = primitive.material.map_or(0, |material| material + 1);
        if material >= self.mesh.materials.len() {
            return Err(Fault::malformed(format!("material {} is missing", material - 1)));
        }
        self.push_attributes(primitive, source, first, count, material)?;
        Ok(Vertices { first, count, material })
    }

    fn push_attributes(
        &mut self,
        primitive: &Primitive,
        source: &Source,
        first: usize,
        count: usize,
        material: usize,
    ) -> Result<(), Fault> {
        if let Some((name, uvs)) = coordinates(primitive, material, self.mesh, self.coordinate_sets) {
            self.mesh.uvs.resize(first, Vec2::ZERO);
            let read = source.vectors(&name, uvs, &["VEC2"], 0.0, |[u, v, ..]| self.mesh.uvs.push(Vec2::new(u, v)))?;
            check_count(read, count)?;
        } else if !self.mesh.uvs.is_empty() {
            self.mesh.uvs.resize(first + count, Vec2::ZERO);
        }
        if let Some(&colors) = primitive.attributes.get("COLOR_0") {
            self.mesh.colors.resize(first, Vec4::ONE);
            let push = |color| self.mesh.colors.push(Vec4::from_array(color).clamp(Vec4::ZERO, Vec4::ONE));
            let read = source.vectors("COLOR_0", colors, &["VEC3", "VEC4"], 1.0, push)?;
            check_count(read, count)?;
        } else if !self.mesh.colors.is_empty() {
            self.mesh.colors.resize(first + count, Vec4::ONE);
        }
        Ok(())
    }

    fn push_triangles(
        &mut self,
        primitive: &Primitive,
        source: &Source,
        [first, count]: [usize; 2],
        is_mirrored: bool,
    ) -> Result<(), Fault> {
        let base = first as u32;
        let triangles = &mut self.mesh.triangles;
        let mut push = |[a, b, c]: [u32; 3]| {
            let (b, c) = if is_mirrored { (c, b) } else { (b, c) };
            triangles.push([a + base, b + base, c + base]);
        };
        let check = |corner: u32| match (corner as usize) < count {
            true => Ok(corner),
            false => Err(Fault::malformed(format!("a triangle names vertex {corner} of {count}"))),
        };
        // What is packed are triangles, whatever they were.
        match (source.packed, primitive.indices) {
            (None, Some(indices)) if primitive.mode == TRIANGLES => {
                let (mut corners, mut known) = ([0; 3], 0);
                source.accessors.each_index(indices, |corner| {
                    corners[known] = check(corner)?;
                    known = (known + 1) % 3;
                    if known == 0 {
                        push(corners);
                    }
                    Ok(())
                })?;
            }
            (packed, indices) => {
                let corners = match (packed, indices) {
                    (Some(packed), _) => packed.corners(),
                    (None, Some(indices)) => source.accessors.indices(indices)?,
                    (None, None) => (0..count as u32).collect(),
                };
                corners.iter().try_for_each(|&corner| check(corner).map(drop))?;
                let mode = if packed.is_some() { TRIANGLES } else { primitive.mode };
                let places = (0..triangle_count(mode, corners.len() as u64)).map(|at| triangle_at(mode, at));
                places.for_each(|places| push(places.map(|place| corners[place as usize])));
            }
        }
        let triangles = self.mesh.triangles.len() as u64;
        if triangles > source.accessors.limits.points {
            return Err(Fault::limit("triangles", triangles, source.accessors.limits.points));
        }
        Ok(())
    }
}

pub(super) fn check_count(read: usize, count: usize) -> Result<(), Fault> {
    if read == count { Ok(()) } else { Err(Fault::malformed(format!("{read} attributes for {count} vertices"))) }
}
