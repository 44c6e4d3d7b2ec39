//! Pictures as planes of numbers: PNG by the crate `png`, all pages of a TIFF by `tiff`, with their sizes checked before
//! they are unpacked. Colours become brightness.

use crate::import::images::allowance::{self, Packing, Refused};
use crate::import::images::contiguous::Contiguous;
use crate::import::images::geotiff;
use crate::import::images::geotiff::GeoTiff;
use crate::import::images::hyperstack::Hyperstack;
use crate::import::images::imagej;
use crate::import::images::page::{bits_of, decoder_limits, plane};
use crate::import::images::unpacked::Unpacked;
use crate::import::samples::channels::chosen;
use crate::import::source::guard::guarded;
use std::io::{Cursor, Read, Seek};
use std::path::Path;
use tiff::TiffError;
use tiff::decoder::Decoder;
use tiff::tags::Tag;
use voxtrace_voxelize::{ImportError, ImportErrorKind, Limits};

/// One picture, row by row from the top.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Plane {
    pub width: usize,
    pub height: usize,
    pub values: Vec<f32>,
    /// Colours of the pixels, sRGB, where there are some that are not grey.
    pub colors: Vec<[u8; 3]>,
}

impl Plane {
    /// A picture of numbers, `channels` of which are a pixel; `full` is that of a channel's full brightness.
    pub fn new([width, height]: [usize; 2], numbers: &[f32], channels: usize, full: Option<f32>) -> Self {
        let mut colors = Vec::new();
        if let (3 | 4, Some(full)) = (channels, full) {
            let byte = |number: &f32| (number / full * 255.0).round() as u8;
            colors.extend(numbers.chunks_exact(channels).map(|pixel| [0, 1, 2].map(|at| byte(&pixel[at]))));
            if colors.iter().all(|[red, green, blue]| red == green && green == blue) {
                colors = Vec::new();
            }
        }
        Self { width, height, values: grey(numbers, channels), colors }
    }
}

/// The planes of a file, and how far apart its pixels and planes are where it says so.
#[derive(Default)]
pub(crate) struct Planes {
    pub planes: Vec<Plane>,
    /// Pages of another size than the first, which are left out.
    pub left_out: usize,
    pub spacing: Option<[f64; 3]>,
    /// What pages are that are more than slices, with the channel, slice and time point of each one that was read.
    pub stack: Option<Hyperstack>,
    pub places: Vec<[usize; 3]>,
    /// Where the first page lies on a map, and which of its values stands for none.
    pub map: Option<GeoTiff>,
    pub hole: Option<f32>,
}

/// Whether a file's name is that of a picture that is read here.
pub(crate) fn is_picture(path: &Path) -> bool {
    let extension = path.extension().unwrap_or_default().to_ascii_lowercase();
    ["png", "tif", "tiff"].iter().any(|known| extension == *known)
}

/// Which pages of a stack are wanted.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Choice {
    /// From 1 on, all where none is asked for.
    pub channel: Option<u32>,
    /// From 1 on, the first where none is asked for.
    pub time: Option<u32>,
}

/// Reads a PNG or TIFF, told by its first bytes.
pub(crate) fn read(bytes: &[u8], path: &Path, choice: Choice, limits: &Limits) -> Result<Planes, ImportError> {
    let at = |kind| ImportError::at(path, 0, kind);
    if bytes.starts_with(b"\x89PNG\r\n\x1a\n") {
        // What is too large is no fault of the decoder.
        let plane = guarded(|| match png(bytes, limits) {
            Err(Refused::Malformed(what)) => Err(what),
            other => Ok(other),
        });
        let plane = plane.map_err(Refused::Malformed).flatten().map_err(|refused| refused.into_import_error(path))?;
        return Ok(Planes { planes: vec![plane], ..Planes::default() });
    }
    if !is_tiff(bytes) {
        return Err(at(ImportErrorKind::Malformed("the picture is neither PNG nor TIFF".into())));
    }
    let (mut is_foreign, mut refused) = (false, None);
    let planes = guarded(|| {
        tiff(bytes, choice, limits, &mut refused).map_err(|error| {
            is_foreign = matches!(error, TiffError::UnsupportedError(_));
            error.to_string()
        })
    });
    planes.map_err(|what| match refused {
        Some(refused) => Refused::into_import_error(refused, path),
        None => at(if is_foreign { ImportErrorKind::Unsupported(what) } else { ImportErrorKind::Malformed(what) }),
    })
}

/// Whether bytes begin as a TIFF does.
pub(crate) fn is_tiff(head: &[u8]) -> bool {
    [&b"II*\0"[..], b"MM\0*", b"II+\0", b"MM\0+"].iter().any(|mark| head.starts_with(mark))
}

fn png(bytes: &[u8], limits: &Limits) -> Result<Plane, Refused> {
    let text = |error: png::DecodingError| Refused::Malformed(format!("PNG: {error}"));
    let mut decoder = png::Decoder::new_with_limits(Cursor::new(bytes), png::Limits { bytes: 1 << 30 });
    decoder.set_transformations(png::Transformations::EXPAND);
    let mut reader = decoder.read_info().map_err(text)?;
    let (width, height) = reader.info().size();
    let pixels = u64::from(width) * u64::from(height);
    if pixels > limits.points {
        return Err(Refused::TooLarge { width, height, bytes: pixels, limit: limits.points });
    }
    let info = reader.info();
    let bits = info.color_type.samples() as u64 * info.bit_depth as u64;
    allowance::check((width, height, pixels), bits, bytes.len() as u64, Packing::Deflate, limits)?;
    let size = reader.output_buffer_size().ok_or_else(|| "PNG: too large".to_owned())?;
    let mut data = vec![0; size];
    let frame = reader.next_frame(&mut data).map_err(text)?;
    let channels = frame.color_type.samples();
    let data = &data[..frame.buffer_size()];
    let numbers: Vec<f32> = match frame.bit_depth {
        png::BitDepth::Sixteen => {
            data.as_chunks().0.iter().map(|&bytes| f32::from(u16::from_be_bytes(bytes))).collect()
        }
        _ => data.iter().map(|&byte| f32::from(byte)).collect(),
    };
    let full = if frame.bit_depth == png::BitDepth::Sixteen { 65_535.0 } else { 255.0 };
    Ok(Plane::new([width as usize, height as usize], &numbers, channels, Some(full)))
}

/// The brightness of each pixel; of two channels the second is opacity.
fn grey(numbers: &[f32], channels: usize) -> Vec<f32> {
    if channels == 1 {
        return numbers.to_vec();
    }
    let pixel = |pixel: &[f32]| match pixel {
        [r, g, b, ..] => 0.299 * r + 0.587 * g + 0.114 * b,
        [value, ..] => *value,
        [] => 0.0,
    };
    numbers.chunks_exact(channels).map(pixel).collect()
}

fn tiff(bytes: &[u8], choice: Choice, limits: &Limits, refused: &mut Option<Refused>) -> Result<Planes, TiffError> {
    let wrong = |what: &str| TiffError::IoError(std::io::Error::other(format!("TIFF: {what}")));
    let unpacked = Unpacked::of(Cursor::new(bytes), limits)?;
    let packing = unpacked.allowance();
    let mut decoder = Decoder::new(unpacked)?;
    let mut found = Planes::default();
    let (mut count, mut page, mut wanted) = (0u64, 0, None);
    loop {
        let (width, height) = decoder.dimensions()?;
        let pixels = u64::from(width) * u64::from(height);
        if page == 0 {
            let contiguous = Contiguous::of(&mut decoder).filter(|_| packing == Packing::Tiff);
            found.stack = stack(&mut decoder, bytes.starts_with(b"M"), contiguous.is_some());
            if let Some(what) = found.stack.as_ref().and_then(Hyperstack::scattered) {
                *refused = Some(Refused::Foreign(what));
                return Err(wrong("pages in several files"));
            }
            // Of slices alone all are read, however many are announced.
            if let Some(stack) = found.stack.as_ref().filter(|stack| !stack.is_plain()) {
                wanted = Some(Wanted::of(stack, choice).map_err(|what| wrong(&what))?);
            }
            found.spacing = tiff_spacing(&mut decoder);
            found.map = GeoTiff::of(&mut decoder);
            found.hole = geotiff::hole(&mut decoder);
            if let Some(contiguous) = contiguous {
                let pages = contiguous.layout.size[2] as u64;
                if pixels.saturating_mul(pages) > limits.points {
                    let count = pixels.saturating_mul(pages);
                    *refused = Some(Refused::TooLarge { width, height, bytes: count, limit: limits.points });
                    return Err(wrong("pages that are more than allowed"));
                }
                for page in 0..pages as usize {
                    let place = found.stack.as_ref().and_then(|stack| stack.place(page));
                    if wanted.as_ref().is_none_or(|wanted| place.is_some_and(|place| wanted.has(place))) {
                        found.places.extend(place);
                        let plane = contiguous.plane(bytes, page).ok_or_else(|| wrong("a page that is not whole"))?;
                        found.planes.push(plane);
                    }
                }
                return Ok(found);
            }
        }
        let is_like_first = found
            .planes
            .first()
            .is_none_or(|first| (first.width as u64, first.height as u64) == (width.into(), height.into()));
        let place = found.stack.as_ref().and_then(|stack| stack.place(page));
        if page > 0 && is_about_another(&mut decoder, is_like_first) {
            // An overview or a mask.
        } else if wanted.as_ref().is_some_and(|wanted| !place.is_some_and(|place| wanted.has(place))) {
            // Another time point or channel.
        } else if is_like_first {
            found.places.extend(place);
            count = count.saturating_add(pixels);
            let bits = u64::from(bits_of(decoder.colortype()?));
            let allowed = allowance::check((width, height, count), bits, bytes.len() as u64, packing, limits);
            let points = Refused::TooLarge { width, height, bytes: count, limit: limits.points };
            if let Err(too_large) = allowed.and(if count > limits.points { Err(points) } else { Ok(()) }) {
                *refused = Some(too_large);
                return Err(wrong("pages that are more than allowed"));
            }
            if pixels == 0 {
                return Err(wrong("a page without pixels"));
            }
            decoder = decoder.with_limits(decoder_limits(pixels, limits));
            let plane = plane(&mut decoder, width as usize, height as usize);
            found.planes.push(plane.map_err(|error| of_page(error, page))?);
        } else {
            found.left_out += 1;
        }
        if !decoder.more_images() {
            return Ok(found);
        }
        page += 1;
        if page as u64 >= limits.items {
            return Err(wrong("more pages than allowed"));
        }
        decoder.next_image()?;
    }
}

/// Whether a page behind the first is no picture of its own (TIFF 6.0, `NewSubfileType`): another one in a coarser resolution, as cloud-optimized
/// GeoTIFFs have them, or which of its pixels count.
pub(super) fn is_about_another<R: Read + Seek>(decoder: &mut Decoder<R>, is_like_first: bool) -> bool {
    const COARSER: u32 = 1;
    const MASK: u32 = 4;
    let kind = decoder.get_tag_u32(Tag::NewSubfileType).unwrap_or(0);
    kind & MASK != 0 || kind & COARSER != 0 && !is_like_first
}

/// What is wrong with a page.
fn of_page(error: TiffError, page: usize) -> TiffError {
    match error {
        TiffError::IoError(error) => TiffError::IoError(std::io::Error::other(format!("page {page}: {error}"))),
        other => other,
    }
}

/// The pages of a stack that are read.
pub(super) struct Wanted {
    pub channel: Option<usize>,
    time: usize,
}

impl Wanted {
    pub fn of(stack: &Hyperstack, choice: Choice) -> Result<Self, String> {
        let [channels, _, times] = stack.sizes;
        let channel = chosen(choice.channel, channels, "channel")?;
        Ok(Self { channel, time: chosen(choice.time, times, "time point")?.unwrap_or(0) })
    }

    pub fn has(&self, [channel, _, time]: [usize; 3]) -> bool {
        time == self.time && self.channel.is_none_or(|own| own == channel)
    }
}

/// What the first page says about all, if there are more.
pub(super) fn stack<R: Read + Seek>(
    decoder: &mut Decoder<R>,
    big_endian: bool,
    is_contiguous: bool,
) -> Option<Hyperstack> {
    let is_alone = !decoder.more_images() && !is_contiguous;
    let description = description(decoder)?;
    let mut stack = Hyperstack::of(&description)?;
    if is_alone && stack.files.is_empty() {
        return None;
    }
    if description.starts_with("ImageJ=") {
        if let Some([x, y]) = pixel_size(decoder) {
            stack.set_pixels(&description, [x, y]);
        }
        imagej::add_looks(decoder, big_endian, &mut stack);
    }
    (stack.count() > 1).then_some(stack)
}

/// The description of a page, whatever its bytes are.
pub(super) fn description<R: Read + Seek>(decoder: &mut Decoder<R>) -> Option<String> {
    if let Ok(text) = decoder.get_tag_ascii_string(Tag::ImageDescription) {
        return Some(text);
    }
    let bytes = decoder.get_tag_u8_vec(Tag::ImageDescription).ok()?;
    Some(String::from_utf8_lossy(&bytes).into_owned())
}

/// How far apart pixels are, in the unit that another tag says.
fn pixel_size<R: Read + Seek>(decoder: &mut Decoder<R>) -> Option<[f64; 2]> {
    let mut edge = |tag| {
        let tiff::decoder::ifd::Value::Rational(above, below) = decoder.get_tag(tag).ok()? else { return None };
        Some(f64::from(below) / f64::from(above)).filter(|edge| (1e-9..1e9).contains(edge))
    };
    Some([edge(Tag::XResolution)?, edge(Tag::YResolution)?])
}

/// What ImageJ writes into its first page: pixels to a unit, and `spacing=` between pages in that unit.
pub(super) fn tiff_spacing<R: Read + Seek>(decoder: &mut Decoder<R>) -> Option<[f64; 3]> {
    let spacing = description(decoder)?;
    let spacing = spacing.lines().find_map(|line| line.strip_prefix("spacing="))?.trim().parse::<f64>().ok()?;
    let [x, y] = pixel_size(decoder)?;
    let is_distance = |value: &f64| value.is_finite() && (1e-9..1e9).contains(value);
    [x, y, spacing.abs()].iter().all(is_distance).then_some([x, y, spacing.abs()])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_png_of_sixteen_bits_or_colours_becomes_numbers() {
        let encode = |color, depth, data: &[u8]| {
            let mut bytes = Vec::new();
            let mut encoder = ::png::Encoder::new(&mut bytes, 2, 1);
            encoder.set_color(color);
            encoder.set_depth(depth);
            encoder.write_header().unwrap().write_image_data(data).unwrap();
            bytes
        };
        let values = |bytes: &[u8]| {
            read(bytes, Path::new("a.png"), Choice::default(), &Limits::default()).unwrap().planes[0].values.clone()
        };
        let deep = encode(::png::ColorType::Grayscale, ::png::BitDepth::Sixteen, &[1, 2, 255, 255]);
        assert_eq!(values(&deep), [258.0, 65_535.0]);
        let colored = encode(::png::ColorType::Rgb, ::png::BitDepth::Eight, &[10, 10, 10, 0, 100, 0]);
        assert!(values(&colored).iter().zip([10.0, 58.7]).all(|(a, b)| (a - b).abs() < 1e-4));
        let clear = encode(::png::ColorType::GrayscaleAlpha, ::png::BitDepth::Eight, &[7, 0, 9, 255]);
        assert_eq!(values(&clear), [7.0, 9.0]);
        assert!(read(&deep[..40], Path::new("a.png"), Choice::default(), &Limits::default()).is_err());
        assert!(read(b"GIF89a", Path::new("a.png"), Choice::default(), &Limits::default()).is_err());
        let few = Limits { points: 1, ..Limits::default() };
        assert!(read(&deep, Path::new("a.png"), Choice::default(), &few).is_err());
    }
}
