//! A packed scene on the device: its geometry, with the cells as devices walk them, and its placement, which alone is
//! written where things move.

use crate::bindings::Bindings;
use crate::buffer::Buffer;
use crate::commands::Submitter;
use crate::device::Device;
use crate::pages::Pages;
use crate::records::binding;
use crate::transfer::{Transfer, Write};
use bytemuck::{NoUninit, Pod, cast_slice};
use std::borrow::Cow;
use std::ops::Range;
use std::sync::Arc;
use voxtrace_core::dynamic::{ArrayPatch, Patch};
use voxtrace_core::packed::{DeviceCells, Geometry, Placement};
use voxtrace_core::{PackedScene, TraceError};

/// Where an array is bound, its name in the memory report, and its records.
type Array<'a> = (u32, &'static str, Records<'a>);

/// An array of the host as devices have it.
#[derive(Clone, Copy, PartialEq)]
struct Records<'a> {
    bytes: &'a [u8],
    /// Bytes of a record on the host.
    size: usize,
    /// Bytes from one record to the next on the device.
    stride: usize,
}

impl<'a> Records<'a> {
    /// Bytes on the device.
    fn len(&self) -> usize {
        self.bytes.len() / self.size * self.stride
    }

    /// What is written there.
    fn padded(&self) -> Cow<'a, [u8]> {
        if self.size == self.stride {
            return self.bytes.into();
        }
        let mut padded = Vec::with_capacity(self.len());
        for record in self.bytes.chunks_exact(self.size) {
            padded.extend_from_slice(record);
            padded.resize(padded.len() + self.stride - self.size, 0);
        }
        padded.into()
    }
}

/// The buffers of a scene.
pub struct SceneBuffers {
    pub scene: Arc<PackedScene>,
    /// The `top_shift` of all grids, 0 where they differ.
    pub top_shift: u32,
    /// The cells of bricks also say which of their blocks hold a voxel.
    pub cells_have_blocks: bool,
    /// Where cells, bricks and materials of voxels lie, if not whole.
    pub pages: Option<Pages>,
    /// Whether cells are those of the processor and arrays have room for edits.
    pub is_edited: bool,
    geometry: Vec<(u32, Buffer)>,
    placement: Vec<(u32, Buffer)>,
    environment: Buffer,
    /// Behind the texels of the environment map are the columns of its light from above.
    has_light_from_above: bool,
}

impl SceneBuffers {
    /// Uploads a scene. What of it does not fit `room` bytes, where there is such a limit, comes page by page.
    pub fn new(
        device: &Arc<Device>,
        submitter: &mut Submitter,
        transfer: &mut Transfer,
        scene: &Arc<PackedScene>,
        room: Option<u64>,
    ) -> Result<Self, TraceError> {
        let geometry = scene.geometry();
        let materials: Array = (binding::MATERIALS, "materials", in_rows(geometry.materials()));
        let pages = match room {
            Some(room) => {
                let placement = placement_arrays(scene.placement());
                let whole: u64 = placement.iter().map(|(.., bytes)| bytes.len() as u64).sum();
                let whole = whole + (materials.2.len() + in_rows(geometry.grids()).len()) as u64 + ROUNDED;
                let budget = room.saturating_sub(whole);
                Some(Pages::new(device, submitter, transfer, geometry, budget).map_err(|error| match error {
                    TraceError::OutOfMemory { needed, .. } => {
                        TraceError::OutOfMemory { needed: whole + needed, available: room }
                    }
                    error => error,
                })?)
            }
            None => None,
        };
        let cells = match pages {
            Some(_) => geometry.tree_cells(),
            None => geometry.device_cells(),
        };
        let DeviceCells { cells, grids, top_shift, have_blocks } = cells;
        let mut arrays: Vec<Array> = vec![(binding::GRIDS, "grids", in_rows(&grids)), materials];
        if pages.is_none() {
            arrays.extend([
                (binding::CELLS, "cells", in_words(&cells)),
                (binding::BRICKS, "bricks", in_words(geometry.bricks())),
                (binding::BRICK_MATERIALS, "voxel materials", in_words(geometry.brick_materials())),
            ]);
        }
        if pages.as_ref().is_none_or(|pages| !pages.has_lights) {
            arrays.extend([
                (binding::EMITTERS, "emitters", in_rows(geometry.emitters())),
                (binding::LIGHT_NODES, "light nodes", in_rows(geometry.light_nodes())),
            ]);
        }
        let mut write = |array: &Array| {
            let (binding, name, records) = *array;
            written(device, submitter, transfer, name, &records.padded()).map(|buffer| (binding, buffer))
        };
        let geometry = arrays.iter().map(&mut write).collect::<Result<_, _>>()?;
        let placement = placement_arrays(scene.placement()).iter().map(&mut write).collect::<Result<_, _>>()?;
        let environment = written(device, submitter, transfer, ENVIRONMENT, texels_of(scene))?;
        let (scene, cells_have_blocks) = (Arc::clone(scene), have_blocks);
        Ok(Self {
            scene,
            top_shift,
            cells_have_blocks,
            pages,
            is_edited: false,
            geometry,
            placement,
            environment,
            has_light_from_above: false,
        })
    }

    /// Uploads a scene that is going to be edited: with the cells of the processor, so that edits are the same there and here, and with room for more.
    pub fn to_edit(
        device: &Arc<Device>,
        submitter: &mut Submitter,
        transfer: &mut Transfer,
        scene: &Arc<PackedScene>,
    ) -> Result<Self, TraceError> {
        let geometry = scene.geometry();
        let write = |array: &Array| {
            let (binding, name, records) = *array;
            let buffer = Buffer::storage(device, name, with_room(records.len()))?;
            transfer.upload(submitter, &buffer, &records.padded())?;
            Ok::<_, TraceError>((binding, buffer))
        };
        let buffers = geometry_arrays(geometry).iter().map(write).collect::<Result<_, _>>()?;
        let mut write = |array: &Array| {
            let (binding, name, records) = *array;
            written(device, submitter, transfer, name, &records.padded()).map(|buffer| (binding, buffer))
        };
        let placement = placement_arrays(scene.placement()).iter().map(&mut write).collect::<Result<_, _>>()?;
        let environment = written(device, submitter, transfer, ENVIRONMENT, texels_of(scene))?;
        Ok(Self {
            scene: Arc::clone(scene),
            top_shift: geometry.tree_cells().top_shift,
            cells_have_blocks: false,
            pages: None,
            is_edited: true,
            geometry: buffers,
            placement,
            environment,
            has_light_from_above: false,
        })
    }

    /// Makes room for what `scene`, the one that is here after a patch, has more of. Returns what of it is to be written, and whether an array is in
    /// another buffer now.
    pub fn patched(
        &mut self,
        device: &Arc<Device>,
        scene: &Arc<PackedScene>,
        patch: &Patch,
    ) -> Result<(Vec<PatchWrite>, bool), TraceError> {
        self.scene = Arc::clone(scene);
        self.top_shift = scene.geometry().tree_cells().top_shift;
        let (mut writes, mut has_moved) = (Vec::new(), false);
        for (array, (binding, name, bytes)) in geometry_arrays(scene.geometry()).into_iter().enumerate() {
            let (own, buffer) = &mut self.geometry[array];
            debug_assert_eq!(*own, binding, "arrays are in one order");
            if buffer.size < bytes.len() as u64 {
                *buffer = Buffer::storage(device, name, with_room(bytes.len()))?;
                writes.push(PatchWrite { array, range: 0..bytes.len() });
                has_moved = true;
                continue;
            }
            let ranges = match binding {
                binding::CELLS => ranges_of(&patch.cells),
                binding::BRICKS => ranges_of(&patch.bricks),
                binding::BRICK_MATERIALS => ranges_of(&patch.brick_materials),
                binding::EMITTERS => ranges_of(&patch.emitters),
                binding::LIGHT_NODES => ranges_of(&patch.light_nodes),
                binding::GRIDS => std::iter::once(0..bytes.len()).collect(),
                binding::MATERIALS => ranges_of(&patch.materials),
                _ => Vec::new(),
            };
            writes.extend(ranges.into_iter().map(|range| PatchWrite { array, range }));
        }
        Ok((writes, has_moved))
    }

    /// What is written, and where it goes.
    pub fn patch_writes(&self, writes: &[PatchWrite]) -> Vec<Write<'_>> {
        let arrays = geometry_arrays(self.scene.geometry());
        let write = |PatchWrite { array, range }: &PatchWrite| Write {
            buffer: &self.geometry[*array].1,
            at: range.start as u64,
            bytes: match arrays[*array].2.padded() {
                Cow::Borrowed(bytes) => Cow::Borrowed(&bytes[range.clone()]),
                Cow::Owned(bytes) => bytes[range.clone()].to_vec().into(),
            },
        };
        writes.iter().map(write).collect()
    }

    /// The same geometry with memory for the placement of `scene`, whose geometry it is; [`Self::placement_writes`] must be written.
    pub fn placed(self, device: &Arc<Device>, scene: &Arc<PackedScene>) -> Result<Self, TraceError> {
        let mut placement = Vec::with_capacity(self.placement.len());
        for ((binding, name, records), (_, kept)) in placement_arrays(scene.placement()).into_iter().zip(self.placement)
        {
            placement.push((binding, buffer_for(device, name, records.len(), Some(kept))?));
        }
        Ok(Self { scene: Arc::clone(scene), placement, ..self })
    }

    /// The arrays of the placement, where they go.
    pub fn placement_writes(&self) -> Vec<Write<'_>> {
        let arrays = placement_arrays(self.scene.placement()).into_iter().zip(&self.placement);
        arrays.map(|((.., records), (_, buffer))| Write { buffer, at: 0, bytes: records.padded() }).collect()
    }

    /// Takes the light of a scene that [`Self::holds`]. Returns whether its environment map is another one, which was uploaded.
    pub fn light(
        &mut self,
        device: &Arc<Device>,
        submitter: &mut Submitter,
        transfer: &mut Transfer,
        scene: &Arc<PackedScene>,
    ) -> Result<bool, TraceError> {
        let is_other = !std::ptr::eq(texels_of(&self.scene), texels_of(scene));
        if is_other {
            self.environment = written(device, submitter, transfer, ENVIRONMENT, texels_of(scene))?;
            self.has_light_from_above = false;
        }
        self.scene = Arc::clone(scene);
        Ok(is_other)
    }

    /// Puts the columns of the light that the environment map sends from above behind its texels. Returns whether they were not there.
    pub fn light_from_above(
        &mut self,
        device: &Arc<Device>,
        submitter: &mut Submitter,
        transfer: &mut Transfer,
    ) -> Result<bool, TraceError> {
        let Some(environment) = self.scene.sky.background().environment().filter(|_| !self.has_light_from_above) else {
            return Ok(false);
        };
        let map = environment.map();
        let bytes = [cast_slice(map.texels()), cast_slice(&map.from_above().columns)].concat();
        self.environment = written(device, submitter, transfer, ENVIRONMENT, &bytes)?;
        self.has_light_from_above = true;
        Ok(true)
    }

    /// Whether a scene has the same arrays: then it differs in its light from outside, in the strength of its emission or in its
    /// cameras, which devices are told with each frame ([`crate::records::FrameParams`]).
    pub fn holds(&self, scene: &PackedScene) -> bool {
        let (ours, theirs) = (placement_arrays(self.scene.placement()), placement_arrays(scene.placement()));
        Arc::ptr_eq(self.scene.geometry(), scene.geometry()) && ours == theirs
    }

    /// Binds all arrays.
    pub fn bind(&self, bindings: &Bindings) {
        for (binding, buffer) in self.geometry.iter().chain(&self.placement) {
            bindings.bind(*binding, buffer);
        }
        bindings.bind(binding::ENVIRONMENT, &self.environment);
        // Without pages nobody reads a table, but that of a scene before, which is gone, must not stay bound.
        bindings.bind(binding::PAGES, self.pages.as_ref().map_or(&self.environment, |pages| &pages.table));
        if let Some(pages) = &self.pages {
            for binding in [binding::CELLS, binding::BRICKS, binding::BRICK_MATERIALS] {
                bindings.bind(binding, &pages.pool);
            }
            if pages.has_lights {
                bindings.bind(binding::EMITTERS, &pages.pool);
                bindings.bind(binding::LIGHT_NODES, &pages.pool);
            }
        }
    }

    /// Bytes of the scene where it lies there whole.
    pub fn bytes_of(scene: &PackedScene) -> u64 {
        let geometry = scene.geometry();
        let placement = placement_arrays(scene.placement());
        Pages::bytes_of(geometry) + placement.iter().map(|(.., bytes)| bytes.len() as u64).sum::<u64>()
    }
}

/// Bytes that drivers add to buffers where they round their sizes, at most.
const ROUNDED: u64 = 1 << 16;
/// Bytes between two ranges of a patch that are sooner copied than begun anew.
const GAP: usize = 2048;

/// Bytes of one of the arrays of a geometry that are to be written.
pub struct PatchWrite {
    array: usize,
    range: Range<usize>,
}

/// The bytes of an array that a patch writes; what lies between ranges that are near each other is the same there and here.
fn ranges_of<T: Pod>(patch: &ArrayPatch<T>) -> Vec<Range<usize>> {
    let mut joined: Vec<Range<usize>> = Vec::new();
    for &(start, length) in &patch.ranges {
        let (start, end) = (start * size_of::<T>(), (start + length) * size_of::<T>());
        match joined.last_mut() {
            Some(last) if start <= last.end + GAP => last.end = end,
            _ => joined.push(start..end),
        }
    }
    joined
}

/// Bytes for an array of so many that is going to grow.
fn with_room(bytes: usize) -> u64 {
    (bytes + bytes / 4 + (1 << 16)) as u64
}

/// Bytes of a row: shaders load records by rows.
const ROW: usize = 16;

/// Records, each from a row on.
fn in_rows<T: NoUninit>(records: &[T]) -> Records<'_> {
    let size = size_of::<T>();
    Records { bytes: cast_slice(records), size, stride: size.next_multiple_of(ROW) }
}

/// An array that is loaded by words.
fn in_words<T: NoUninit>(words: &[T]) -> Records<'_> {
    let size = size_of::<T>();
    Records { bytes: cast_slice(words), size, stride: size }
}

/// The arrays of a geometry as processors walk it.
fn geometry_arrays(geometry: &Geometry) -> [Array<'_>; 7] {
    [
        (binding::CELLS, "cells", in_words(geometry.cells())),
        (binding::BRICKS, "bricks", in_words(geometry.bricks())),
        (binding::BRICK_MATERIALS, "voxel materials", in_words(geometry.brick_materials())),
        (binding::GRIDS, "grids", in_rows(geometry.grids())),
        (binding::MATERIALS, "materials", in_rows(geometry.materials())),
        (binding::EMITTERS, "emitters", in_rows(geometry.emitters())),
        (binding::LIGHT_NODES, "light nodes", in_rows(geometry.light_nodes())),
    ]
}

/// Name of the environment map's buffer in the memory report.
const ENVIRONMENT: &str = "environment";

/// The texels of a scene's environment map, none where it has none.
fn texels_of(scene: &PackedScene) -> &[u8] {
    scene.sky.background().environment().map_or(&[], |environment| cast_slice(environment.map().texels()))
}

fn placement_arrays(placement: &Placement) -> [Array<'_>; 3] {
    [
        (binding::INSTANCES, "instances", in_rows(placement.instances())),
        (binding::INSTANCE_NODES, "instance nodes", in_rows(placement.instance_nodes())),
        (binding::TOP_LIGHT_NODES, "top light nodes", in_rows(placement.light_nodes())),
    ]
}

/// A storage buffer of so many bytes: the one that there is, where it has the right size.
fn buffer_for(device: &Arc<Device>, name: &str, bytes: usize, kept: Option<Buffer>) -> Result<Buffer, TraceError> {
    let size = bytes as u64;
    match kept.filter(|buffer| buffer.size == Buffer::rounded(size)) {
        Some(buffer) => Ok(buffer),
        None => Buffer::storage(device, name, size),
    }
}

/// A storage buffer that holds `bytes`.
pub fn written(
    device: &Arc<Device>,
    submitter: &mut Submitter,
    transfer: &mut Transfer,
    name: &str,
    bytes: &[u8],
) -> Result<Buffer, TraceError> {
    let buffer = buffer_for(device, name, bytes.len(), None)?;
    transfer.upload(submitter, &buffer, bytes)?;
    Ok(buffer)
}
