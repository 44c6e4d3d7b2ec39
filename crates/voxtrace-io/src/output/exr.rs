//! OpenEXR pictures: linear scene radiance and, where the film has them, the AOVs that compositors and denoisers ask
//! for, as the channels of one part with the names they expect (`R`, `albedo.R`, `normal.X`, `depth.Z`, …).

use super::Metadata;
use exr::meta::attribute::{AttributeValue, Text};
use exr::prelude::{
    AnyChannel, AnyChannels, Blocks, Compression, Encoding, FlatSamples, Image, IntegerBounds, Layer, LayerAttributes,
    LineOrder, Vec2, WritableImage, f16,
};
use glam::Vec3;
use rayon::prelude::*;
use std::io::{self, Cursor, Seek, SeekFrom, Write};
use voxtrace_core::film::{AovPixel, Film, Pixel};

/// How a film becomes an EXR.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ExrOptions {
    /// Whether colours and normals are stored as 16-bit floats. Depth and ids stay whole.
    pub half: bool,
    /// Whether to write the film's coverage as alpha; otherwise alpha is 1. The film must then come from a transparent
    /// [`voxtrace_core::Frame`], whose colours are already multiplied by alpha, as EXR wants them.
    pub alpha: bool,
}

/// Writes a film as a ZIP-compressed EXR, AOVs included where the film has them. The display window is the whole
/// picture, the data window the film's region.
///
/// # Errors
/// What the writer or the encoder reports.
pub fn write_exr(writer: impl Write, film: &Film, options: &ExrOptions, metadata: &Metadata) -> io::Result<()> {
    write(writer, film, None, options, metadata, &|| true)
}

/// As [`write_exr`], as long as it is `wanted`. Where there is a `denoised` radiance, it is the picture, and the film's own is in the layer `noisy`.
pub fn write(
    mut writer: impl Write,
    film: &Film,
    denoised: Option<&[Vec3]>,
    options: &ExrOptions,
    metadata: &Metadata,
    wanted: &dyn Fn() -> bool,
) -> io::Result<()> {
    let size = Vec2(film.region.width() as usize, film.region.height() as usize);
    let mut attributes = LayerAttributes {
        layer_position: Vec2(film.region.x0 as i32, film.region.y0 as i32),
        ..LayerAttributes::default()
    };
    for (name, text) in metadata.entries() {
        match *name {
            "Software" => attributes.software_name = Some(text_of(text)),
            name => {
                attributes.other.insert(Text::from(name), AttributeValue::Text(text_of(text)));
            }
        }
    }
    let encoding =
        Encoding { compression: Compression::ZIP16, blocks: Blocks::ScanLines, line_order: LineOrder::Increasing };
    let channels = channels(film, denoised, *options, wanted)?;
    let layer = Layer::new(size, attributes, encoding, AnyChannels::sort(channels.into()));
    let mut image = Image::from_layer(layer);
    image.attributes.display_window = IntegerBounds::new(Vec2(0, 0), Vec2(film.width as usize, film.height as usize));

    let mut bytes = Encoded { bytes: Cursor::new(Vec::new()), wanted };
    image.write().to_buffered(&mut bytes).map_err(io::Error::other)?;
    let mut bytes = bytes.bytes.into_inner();
    sort_attributes(&mut bytes).ok_or_else(|| io::Error::other("unexpected EXR header"))?;
    writer.write_all(&bytes)
}

/// What the encoder has written so far, block by block as they are compressed, as long as it is wanted.
struct Encoded<'a> {
    bytes: Cursor<Vec<u8>>,
    wanted: &'a dyn Fn() -> bool,
}

impl Write for Encoded<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        still(self.wanted)?;
        self.bytes.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl Seek for Encoded<'_> {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.bytes.seek(to)
    }
}

/// Fails once nothing more is wanted.
fn still(wanted: &dyn Fn() -> bool) -> io::Result<()> {
    if wanted() { Ok(()) } else { Err(io::Error::other("stopped")) }
}

fn channels(
    film: &Film,
    denoised: Option<&[Vec3]>,
    options: ExrOptions,
    wanted: &dyn Fn() -> bool,
) -> io::Result<Vec<AnyChannel<FlatSamples>>> {
    let mut channels = Vec::new();
    let mut float = |name: &str, half: bool, values: Vec<f32>| {
        still(wanted)?;
        let samples = if half && options.half {
            // What is brighter than the largest number of 16 bits, such as the disc of a strong sun, must not become infinite: a blur of that
            // is infinite far around.
            let most = f16::MAX.to_f32();
            FlatSamples::F16(values.into_par_iter().map(|value| f16::from_f32(value.clamp(-most, most))).collect())
        } else {
            FlatSamples::F32(values)
        };
        channels.push(AnyChannel::new(name, samples));
        io::Result::Ok(())
    };
    let noisy = if denoised.is_some() { ["noisy.R", "noisy.G", "noisy.B"] } else { ["R", "G", "B"] };
    for (channel, name) in noisy.into_iter().enumerate() {
        float(name, true, film.pixels.par_iter().map(|pixel| pixel.mean()[channel]).collect())?;
    }
    if let Some(denoised) = denoised {
        for (channel, name) in ["R", "G", "B"].into_iter().enumerate() {
            float(name, true, denoised.par_iter().map(|radiance| radiance[channel]).collect())?;
        }
    }
    let alpha = |pixel: &Pixel| if options.alpha { pixel.alpha() } else { 1.0 };
    float("A", true, film.pixels.par_iter().map(alpha).collect())?;
    for (group, pixels) in &film.groups {
        for (channel, name) in ["R", "G", "B"].into_iter().enumerate() {
            let values = pixels.par_iter().map(|pixel| pixel.mean()[channel]).collect();
            float(&format!("{}.{name}", group.name()), true, values)?;
        }
    }
    let Some(aovs) = &film.aovs else { return Ok(channels) };
    let mut aov = |name: &str, half: bool, value: &(dyn Fn(&AovPixel) -> f32 + Sync)| {
        float(name, half, aovs.par_iter().map(value).collect())
    };
    for axis in 0..3 {
        aov(["albedo.R", "albedo.G", "albedo.B"][axis], true, &|pixel| pixel.albedo[axis])?;
        aov(["normal.X", "normal.Y", "normal.Z"][axis], true, &|pixel| pixel.normal[axis])?;
        // Coordinates are below 2²⁴, so that a float holds them exactly; many compositors read no integers.
        aov(["voxel.X", "voxel.Y", "voxel.Z"][axis], false, &|pixel| pixel.voxel[axis] as f32)?;
    }
    aov("depth.Z", false, &|pixel| pixel.depth)?;
    let instances = aovs.par_iter().map(|pixel| pixel.instance).collect();
    channels.push(AnyChannel::new("id.instance", FlatSamples::U32(instances)));
    Ok(channels)
}

/// Texts of an EXR are UTF-8. The encoder by itself writes Latin-1, which OpenEXR's readers refuse, and nothing beyond it.
fn text_of(text: &str) -> Text {
    Text::from_slice_unchecked(text.as_bytes())
}

/// Sorts the attributes of a one-part EXR by name, in place: the encoder writes them in the order of a randomly seeded
/// hash map. Their order means nothing in the format. `None` if the header is not as the specification says.
fn sort_attributes(file: &mut [u8]) -> Option<()> {
    const START: usize = 8; // after magic number and version
    let mut at = START;
    let mut attributes = Vec::new();
    while *file.get(at)? != 0 {
        let string_end = |from: usize| Some(from + file.get(from..)?.iter().position(|&byte| byte == 0)? + 1);
        let value = string_end(string_end(at)?)?;
        let size = u32::from_le_bytes(file.get(value..value + 4)?.try_into().ok()?);
        let end = value.checked_add(4 + size as usize)?;
        attributes.push(file.get(at..end)?.to_vec());
        at = end;
    }
    attributes.sort();
    file.get_mut(START..at)?.copy_from_slice(&attributes.concat());
    Some(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::SceneStamp;
    use exr::prelude::{ReadChannels, ReadLayers};
    use voxtrace_core::{Frame, PackedScene, Region};
    use voxtrace_scene::{Camera, Scene};

    #[test]
    fn texts_are_utf_8_and_light_beyond_16_bits_stays_finite() {
        let mut film = Film::new(1, 1, Region::full(1, 1), 0);
        // The disc of a strong sun.
        film.pixels[0].add(Vec3::splat(262_144.0), true);
        let camera = Camera { name: "Kanzel ü".into(), ..Camera::look_at(Vec3::ZERO, Vec3::X) };
        let name = "教会".into();
        let scene = SceneStamp { name, ..SceneStamp::of(&PackedScene::pack(&Scene::default()).unwrap()) };
        let metadata = Metadata::new(&Frame::new(camera, 1, 1), &scene, &film);
        for (half, most) in [(true, 65_504.0), (false, 262_144.0)] {
            let mut bytes = Vec::new();
            write_exr(&mut bytes, &film, &ExrOptions { half, alpha: false }, &metadata).unwrap();
            let reader = exr::prelude::read().no_deep_data().largest_resolution_level();
            let image = reader.all_channels().all_layers().all_attributes().from_buffered(Cursor::new(bytes)).unwrap();
            let layer = &image.layer_data[0];
            let values = layer.channel_data.list.iter().map(|channel| channel.sample_data.values_as_f32().next());
            assert_eq!(values.collect::<Vec<_>>(), [1.0, most, most, most].map(Some), "A, B, G, R");
            let text = |name: &str| match layer.attributes.other.get(&Text::from(name)) {
                Some(AttributeValue::Text(text)) => text.as_slice().to_vec(),
                other => panic!("{name}: {other:?}"),
            };
            assert_eq!(text("voxtrace.camera"), "Kanzel ü".as_bytes());
            assert_eq!(text("voxtrace.scene"), "教会".as_bytes());
        }
    }
}
