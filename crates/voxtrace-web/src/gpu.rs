//! A scene as the shaders for pages read it (`shaders/pass/page.slang`): its large arrays, and all its records in one, in rows of 16 bytes, because WebGPU
//! promises a pass eight storage buffers. `shaders/scene.slang` has the other half.

use crate::error_of;
use crate::part::Part;
use bytemuck::{NoUninit, bytes_of, cast_slice};
use voxtrace_core::PackedScene;
use voxtrace_core::frame_params::{FrameParams, constant};
use voxtrace_core::normals::Normals;
use voxtrace_core::packed::DeviceCells;
use voxtrace_realtime::{FramesOnDevice, LightCache, Parts, Rate, RealTimeParams, flag, looks_of};
use voxtrace_scene::Transform;
use wasm_bindgen::prelude::*;

/// Words of a row.
const ROW: usize = 4;
/// Rows before the first array: where each of the seven begins.
const HEADER: usize = 2;

/// What real-time light does in pages: all but what their shaders have no room for.
const PARTS: Parts = Parts { visibility: false, ..Parts::ALL };

/// A scene that devices trace.
#[wasm_bindgen]
pub struct GpuScene {
    scene: PackedScene,
    frames: FramesOnDevice,
    /// Pixels of the last picture in real-time light.
    size: (u32, u32),
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

/// A picture in real-time light, as devices are told of it: the paths of one frame, or of several where it is the first one of a view.
#[wasm_bindgen(getter_with_clone)]
pub struct GpuRealTime {
    /// The record of the frame, in words, and behind it the numbers of its lens and its sky.
    pub frame: Vec<u32>,
    /// The records of real-time light, in words, one after the other.
    pub frames: Vec<u32>,
    /// Words of one of them.
    pub words: usize,
    /// For each of them, whether light is found again where the camera moved.
    pub reprojects: Vec<u8>,
    /// For each of them, how many rays of a pixel only look, at most, and the number before that of the first one.
    pub looks: Vec<u32>,
    /// Cells of the light cache, and how many of them may trace.
    pub cells: u32,
    /// The same.
    pub tracing_cells: u32,
}

/// The record of a frame in words, and behind it the numbers of its lens and its sky.
fn frame_words(params: &FrameParams) -> Vec<u32> {
    let mut words: Vec<u32> = cast_slice(bytes_of(params)).to_vec();
    words.extend([constant::LENS, params.lens, constant::SKY, params.sky]);
    words
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
        Ok(Self::of(PackedScene::from_bytes(bytes).map_err(error_of)?))
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
        Ok(frame_words(&FrameParams::of_frame(&self.scene, &part.frame(&self.scene)?)))
    }

    /// What the device is told of the next picture in real-time light, of which a part names the view; `exposure` and `curve` are how it is shown. Whoever asks
    /// has it traced: it is what the next one goes on from.
    ///
    /// # Errors
    /// Where there is no such part of a picture.
    pub fn real_time(&mut self, part: &Part, exposure: f32, curve: u32) -> Result<GpuRealTime, JsError> {
        let frame = part.frame(&self.scene)?;
        let params = FrameParams::of_frame(&self.scene, &frame);
        if self.size != (frame.width, frame.height) {
            self.frames.forget_pixels();
            self.size = (frame.width, frame.height);
        }
        let count = self.frames.frames_of_picture(&frame);
        let (mut frames, mut reprojects, mut looks) = (Vec::new(), Vec::new(), Vec::new());
        for _ in 0..count {
            let of_frame = self.frames.params(&self.scene, &frame, Rate::Full, (false, false));
            let of_frame = RealTimeParams { exposure, curve, ..of_frame };
            frames.extend_from_slice(cast_slice(bytes_of(&of_frame)));
            reprojects.push(u8::from(of_frame.flags & (flag::KNOWS | flag::SAME_VIEW) == flag::KNOWS));
            looks.extend(<[u32; 2]>::from(looks_of(&of_frame)));
            self.frames.end(&frame);
        }
        Ok(GpuRealTime {
            frame: frame_words(&params),
            frames,
            words: size_of::<RealTimeParams>() / 4,
            reprojects,
            looks,
            cells: LightCache::CAPACITY as u32,
            tracing_cells: LightCache::MOST_CHOSEN as u32,
        })
    }
}

impl GpuScene {
    fn of(scene: PackedScene) -> Self {
        Self { scene, frames: FramesOnDevice::new(PARTS), size: (0, 0) }
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
        let mut scene = GpuScene::of(PackedScene::pack_merged(&city).unwrap());
        assert!(scene.arrays().is_some());
        let whole = scene.scene.cuts.clone();
        scene.scene.cuts = whole.clip_box(Vec3::ZERO, Vec3::ONE).unwrap();
        assert!(scene.arrays().is_none());
    }

    #[test]
    fn a_frame_is_its_record_and_the_constants_of_its_lens_and_sky() {
        let city = voxtrace_scenes::generate("city", Some(20_000)).unwrap();
        let scene = GpuScene::of(PackedScene::pack_merged(&city).unwrap());
        let camera = vec![0.0, -50.0, 20.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 40.0];
        let words = scene.frame(&Part { seed: 5, ..Part::new(camera, 64, 36) }).unwrap();
        assert_eq!(words.len() * 4, size_of::<FrameParams>() + 16);
        assert_eq!(words[words.len() - 4..], [constant::LENS, 0, constant::SKY, 0]);
        assert_eq!((words[3], words[7]), (64, 36), "the size of the picture");
    }

    #[test]
    fn real_time_light_goes_on_from_the_picture_before() {
        let city = voxtrace_scenes::generate("city", Some(20_000)).unwrap();
        let mut scene = GpuScene::of(PackedScene::pack_merged(&city).unwrap());
        let part = |x: f32, width| Part::new(vec![x, -50.0, 20.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 40.0], width, 36);
        let mut next = |x, width| {
            let made = scene.real_time(&part(x, width), 2.0, 1).unwrap();
            assert_eq!(made.frames.len(), made.words * made.reprojects.len());
            assert_eq!(made.frame.len() * 4, size_of::<FrameParams>() + 16);
            let last: RealTimeParams =
                *bytemuck::from_bytes(cast_slice(&made.frames[made.frames.len() - made.words..]));
            assert_eq!((last.exposure, last.curve, last.pixels, last.squares), (2.0, 1, width * 36, 0));
            (made.reprojects, made.looks, last.number)
        };
        // The paths of four frames, of which the first one looks at what pixels show.
        assert_eq!(next(0.0, 64), (vec![0; 4], vec![15, 0, 0, 16, 0, 32, 0, 48], 3));
        assert_eq!(next(0.0, 64), (vec![0], vec![0, 64], 4));
        assert_eq!(next(0.5, 64), (vec![1], vec![3, 80], 5));
        let (reprojects, looks, number) = next(0.5, 32);
        assert_eq!((reprojects.len(), looks[0], number), (4, 15, 9), "pictures of another size know nothing");
        assert_eq!(next(0.5, 32).0.len(), 1);
    }
}
