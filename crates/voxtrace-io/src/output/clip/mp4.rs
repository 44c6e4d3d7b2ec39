//! AV1 in MP4, which every current browser plays: encoded by rav1e, in the container by muxide. BT.709, 4:2:0, eight bits.

use super::{ClipOptions, Frames, fraction};
use muxide::api::{MuxerBuilder, MuxerError, VideoCodec};
use rav1e::prelude::{
    ChromaSampling, ColorDescription, ColorPrimaries, Config, Context, EncoderConfig, EncoderStatus, FrameType,
    MatrixCoefficients, PixelRange, Rational, SpeedSettings, TransferCharacteristics,
};
use std::io::{self, Write};

/// rav1e's preset: larger is faster. Beyond 9 files grow quicker than time shrinks.
const SPEED: u8 = 9;
/// Most frames from one that stands alone to the next, in seconds: how exactly players can jump.
const SECONDS_OF_A_GROUP: f64 = 4.0;

/// Writes an MP4.
pub fn encode(out: impl Write, options: &ClipOptions, frames: Frames) -> io::Result<()> {
    let even = |length: u32| length.next_multiple_of(2) as usize;
    let (width, height) = (even(options.width), even(options.height));
    let mut context = context(options, (width, height))?;
    let rate = fraction(options.fps);
    let fps = f64::from(rate.0) / f64::from(rate.1);
    let muxer = MuxerBuilder::new(out).video(VideoCodec::Av1, width as u32, height as u32, fps);
    let mut muxer = muxer.with_fast_start(true).build().map_err(into_io)?;
    let mut written = 0u32;
    let mut drain = |context: &mut Context<u8>| loop {
        match context.receive_packet() {
            Ok(packet) => {
                let time = f64::from(written) * f64::from(rate.1) / f64::from(rate.0);
                written += 1;
                let is_key = packet.frame_type == FrameType::KEY;
                muxer.write_video(time, &packet.data, is_key).map_err(into_io)?;
            }
            Err(EncoderStatus::Encoded) => {}
            Err(EncoderStatus::NeedMoreData | EncoderStatus::LimitReached) => return Ok(()),
            Err(status) => return Err(io::Error::other(status)),
        }
    };
    for number in 0..options.frames {
        let pixels = frames(number)?;
        let planes = to_yuv(&pixels, (options.width as usize, options.height as usize), (width, height));
        let mut frame = context.new_frame();
        for (plane, (data, stride)) in frame.planes.iter_mut().zip(planes.iter().zip([width, width / 2, width / 2])) {
            plane.copy_from_raw_u8(data, stride, 1);
        }
        context.send_frame(frame).map_err(io::Error::other)?;
        drain(&mut context)?;
    }
    context.flush();
    drain(&mut context)?;
    muxer.finish().map_err(into_io)
}

/// The error of the operating system as it is, so that whoever reads its kind is told of a full disk.
fn into_io(error: MuxerError) -> io::Error {
    match error {
        MuxerError::Io(error) => error,
        other => io::Error::other(other),
    }
}

fn context(options: &ClipOptions, (width, height): (usize, usize)) -> io::Result<Context<u8>> {
    let (numerator, denominator) = fraction(options.fps);
    let quality = f64::from(options.quality.min(100)) / 100.0;
    let encoder = EncoderConfig {
        width,
        height,
        time_base: Rational { num: denominator.into(), den: numerator.into() },
        chroma_sampling: ChromaSampling::Cs420,
        pixel_range: PixelRange::Limited,
        color_description: Some(ColorDescription {
            color_primaries: ColorPrimaries::BT709,
            transfer_characteristics: TransferCharacteristics::BT709,
            matrix_coefficients: MatrixCoefficients::BT709,
        }),
        // rav1e's quantizers go from 0, all but lossless, to 255.
        quantizer: (255.0 * (1.0 - quality)).round() as usize,
        max_key_frame_interval: (options.fps * SECONDS_OF_A_GROUP).round().max(1.0) as u64,
        tiles: (width * height / (640 * 360)).clamp(1, 16),
        speed_settings: SpeedSettings::from_preset(SPEED),
        ..EncoderConfig::default()
    };
    Config::new().with_encoder_config(encoder).new_context().map_err(io::Error::other)
}

/// Planes of Y, Cb and Cr of BT.709 in limited range, the latter two of half the size; what is added to make sizes even repeats the edge.
fn to_yuv(
    pixels: &[[u8; 4]],
    (from_width, from_height): (usize, usize),
    (width, height): (usize, usize),
) -> [Vec<u8>; 3] {
    let pixel = |x: usize, y: usize| pixels[y.min(from_height - 1) * from_width + x.min(from_width - 1)].map(f32::from);
    let luma = |[red, green, blue, _]: [f32; 4]| 0.2126 * red + 0.7152 * green + 0.0722 * blue;
    let mut planes = [Vec::with_capacity(width * height), Vec::new(), Vec::new()];
    for y in 0..height {
        planes[0].extend((0..width).map(|x| (16.0 + luma(pixel(x, y)) * (219.0 / 255.0)).round() as u8));
    }
    for y in (0..height).step_by(2) {
        for x in (0..width).step_by(2) {
            let four = [pixel(x, y), pixel(x + 1, y), pixel(x, y + 1), pixel(x + 1, y + 1)];
            let mean: [f32; 4] =
                std::array::from_fn(|channel| four.iter().map(|pixel| pixel[channel]).sum::<f32>() * 0.25);
            let bright = luma(mean);
            let chroma =
                |channel: f32, range: f32| (128.0 + (channel - bright) / range * (224.0 / 255.0)).round() as u8;
            planes[1].push(chroma(mean[2], 1.8556));
            planes[2].push(chroma(mean[0], 1.5748));
        }
    }
    planes
}
