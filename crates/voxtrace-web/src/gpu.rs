//! A scene as the shaders for pages read it (`shaders/pass/page.slang`): its large arrays, and all its records in one, in rows of 16 bytes, because WebGPU
//! promises a pass eight storage buffers. `shaders/scene.slang` has the other half.

use crate::error_of;
use crate::part::Part;
use bytemuck::{NoUninit, bytes_of, cast_slice};
use voxtrace_core::PackedScene;
use voxtrace_core::frame_params::{FrameParams, constant};
use voxtrace_core::normals::Normals;
use voxtrace_core::packed::DeviceCells;
use voxtrace_scene::Transform;
use wasm_bindgen::prelude::*;

/// Words of a row.
const ROW: usize = 4;
/// Rows before the first array: where each of the seven begins.
const HEADER: usize = 2;

/// A scene that devices trace.
#[wasm_bindgen]
pub struct GpuScene {
    scene: PackedScene,
}

/// The arrays of a scene, in words.
#[wasm_bindgen(getter_with_clone)]
pub struct GpuArrays {
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

/// Words for a buffer: none has no bytes.
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
impl GpuScene {
    /// Reads the bytes of a native file, as the workers that trace give them.
    ///
    /// # Errors
    /// The library's own line, where they are none.
    pub fn read(bytes: &[u8]) -> Result<Self, JsError> {
        Ok(Self { scene: PackedScene::from_bytes(bytes).map_err(error_of)? })
    }

    /// The arrays that a device reads; none where the scene has cuts or smooth normals, which the shaders of pages do not know.
    pub fn arrays(&self) -> Option<GpuArrays> {
        let scene = &self.scene;
        if !scene.cuts.is_none() || scene.normals() == Normals::Smooth {
            return None;
        }
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
        ];
        Some(GpuArrays {
            cells: words(&cells),
            bricks: words(geometry.bricks()),
            brick_materials: words(cast_slice(geometry.brick_materials())),
            records,
            environment: words(environment),
            constants: constants.iter().flat_map(|&(number, value)| [number, value]).collect(),
            is_matte: scene.is_matte(),
        })
    }

    /// What the device is told of a part of a picture, as words, and behind it the numbers of its lens and its sky.
    ///
    /// # Errors
    /// Where there is no such part of a picture.
    pub fn frame(&self, part: &Part) -> Result<Vec<u32>, JsError> {
        let params = FrameParams::of_frame(&self.scene, &part.frame(&self.scene)?);
        let mut words: Vec<u32> = cast_slice(bytes_of(&params)).to_vec();
        words.extend([constant::LENS, params.lens, constant::SKY, params.sky]);
        Ok(words)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use voxtrace_scene::glam::Vec3;

    #[test]
    fn records_begin_where_the_header_says() {
        let city = voxtrace_scenes::generate("city", Some(20_000)).unwrap();
        let packed = PackedScene::pack_merged(&city).unwrap();
        let scene = GpuScene::read(&packed.to_bytes()).unwrap();
        let gpu = scene.arrays().unwrap();
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
    #[test]
    fn what_the_shaders_do_not_know_is_left_to_the_processor() {
        let city = voxtrace_scenes::generate("city", Some(20_000)).unwrap();
        let mut scene = GpuScene { scene: PackedScene::pack_merged(&city).unwrap() };
        assert!(scene.arrays().is_some());
        let whole = scene.scene.cuts.clone();
        scene.scene.cuts = whole.clip_box(Vec3::ZERO, Vec3::ONE).unwrap();
        assert!(scene.arrays().is_none());
    }

    #[test]
    fn a_frame_is_its_record_and_the_constants_of_its_lens_and_sky() {
        let city = voxtrace_scenes::generate("city", Some(20_000)).unwrap();
        let scene = GpuScene { scene: PackedScene::pack_merged(&city).unwrap() };
        let camera = vec![0.0, -50.0, 20.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 40.0];
        let words = scene.frame(&Part { seed: 5, ..Part::new(camera, 64, 36) }).unwrap();
        assert_eq!(words.len() * 4, size_of::<FrameParams>() + 16);
        assert_eq!(words[words.len() - 4..], [constant::LENS, 0, constant::SKY, 0]);
        assert_eq!((words[3], words[7]), (64, 36), "the size of the picture");
    }
}
