//! A scene as the shaders for pages read it (`shaders/pass/page.slang`): its large arrays, and all its records in one, in rows of 16 bytes, because WebGPU
//! promises a pass eight storage buffers. `shaders/scene.slang` has the other half.

use crate::error_of;
use crate::render::Part;
use crate::scene::WebScene;
use bytemuck::{NoUninit, bytes_of, cast_slice};
use voxtrace_core::frame_params::{FrameParams, constant};
use voxtrace_core::normals::Normals;
use voxtrace_core::packed::DeviceCells;
use voxtrace_core::{Frame, PackedScene};
use voxtrace_scene::Transform;
use wasm_bindgen::prelude::*;

/// Words of a row.
const ROW: usize = 4;
/// Rows before the first array: where each of the seven begins.
const HEADER: usize = 2;

/// The arrays of a scene, in words.
#[wasm_bindgen(getter_with_clone)]
pub struct GpuScene {
    /// Top arrays and nodes, as devices walk them.
    pub cells: Vec<u32>,
    /// Brick records.
    pub bricks: Vec<u32>,
    /// Materials of the voxels.
    pub brick_materials: Vec<u32>,
    /// Grids, instances, the nodes over them, materials, emitters, and both trees over lights.
    pub records: Vec<u32>,
    /// Texels of the environment map; none where the sky has none.
    pub environment: Vec<u32>,
    /// Constants that its shaders are specialized with: number, value, number, value.
    pub constants: Vec<u32>,
    /// Whether the shaders that know matte paths alone will do.
    pub is_matte: bool,
}

/// Words for a buffer: WebGPU has none without bytes.
fn words(values: &[u32]) -> Vec<u32> {
    if values.is_empty() { vec![0; ROW] } else { values.to_vec() }
}

/// Appends records, each from a row on; returns the row at which they begin.
fn append<T: NoUninit>(records: &mut Vec<u32>, array: &[T]) -> u32 {
    let first = records.len() / ROW;
    for record in array {
        records.extend_from_slice(cast_slice(bytes_of(record)));
        records.resize(records.len().next_multiple_of(ROW), 0);
    }
    first as u32
}

#[wasm_bindgen]
impl WebScene {
    /// The arrays that a device reads.
    pub fn gpu_scene(&self) -> GpuScene {
        let scene = self.packed();
        let (geometry, placement) = (scene.geometry(), scene.placement());
        let DeviceCells { cells, grids, top_shift, have_blocks } = geometry.device_cells();
        let mut records = vec![0; HEADER * ROW];
        let firsts = [
            append(&mut records, &grids),
            append(&mut records, placement.instances()),
            append(&mut records, placement.instance_nodes()),
            append(&mut records, geometry.materials()),
            append(&mut records, geometry.emitters()),
            append(&mut records, geometry.light_nodes()),
            append(&mut records, placement.light_nodes()),
        ];
        records[..firsts.len()].copy_from_slice(&firsts);
        let environment = scene.sky.background().environment();
        let environment = environment.map_or(&[][..], |environment| cast_slice(environment.map().texels()));
        let is_single = matches!(placement.instances(), [only] if only.grid_from_world == Transform::IDENTITY);
        let constants = [
            (constant::IS_SINGLE, is_single.into()),
            (constant::TOP_SHIFT, top_shift),
            (constant::CELLS_HAVE_BLOCKS, have_blocks.into()),
            (constant::CUTS, (!scene.cuts.is_none()).into()),
            (constant::NORMALS, (scene.normals() == Normals::Smooth).into()),
        ];
        GpuScene {
            cells: words(&cells),
            bricks: words(geometry.bricks()),
            brick_materials: words(cast_slice(geometry.brick_materials())),
            records,
            environment: words(environment),
            constants: constants.iter().flat_map(|&(number, value)| [number, value]).collect(),
            is_matte: scene.is_matte() && scene.cuts.is_none() && scene.normals() != Normals::Smooth,
        }
    }

    /// What the device is told of a part of a picture, as words, and behind it the numbers of its lens and its sky.
    ///
    /// # Errors
    /// Where there is no such part of a picture.
    pub fn gpu_frame(&self, part: &Part) -> Result<Vec<u32>, JsError> {
        let frame = part.frame(self).ok_or_else(|| JsError::new("a camera has ten numbers"))?;
        frame.check().map_err(error_of)?;
        Ok(frame_words(self.packed(), &frame))
    }
}

fn frame_words(scene: &PackedScene, frame: &Frame) -> Vec<u32> {
    let params = FrameParams::of_frame(scene, frame);
    let mut words: Vec<u32> = cast_slice(bytes_of(&params)).to_vec();
    words.extend([constant::LENS, params.lens, constant::SKY, params.sky]);
    words
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn records_begin_where_the_header_says() {
        let scene = WebScene::built_in("city", Some(20_000.0)).unwrap();
        let (gpu, packed) = (scene.gpu_scene(), scene.packed());
        let row = |row: u32, count: usize| &gpu.records[row as usize * ROW..][..count];
        let firsts: [u32; 7] = gpu.records[..7].try_into().unwrap();
        assert_eq!(firsts[0] as usize, HEADER);
        let emitter = packed.geometry().emitters()[1];
        assert_eq!(row(firsts[4] + 2, 8), cast_slice::<u8, u32>(bytes_of(&emitter)));
        let instance = packed.placement().instances()[0];
        assert_eq!(row(firsts[1], 27), cast_slice::<u8, u32>(bytes_of(&instance)));
        let last = packed.placement().light_nodes().last().unwrap();
        let end = gpu.records.len() - 16;
        assert_eq!(&gpu.records[end..], cast_slice::<u8, u32>(bytes_of(last)));
        assert_eq!(gpu.cells.len() % 64, 0);
    }
}
