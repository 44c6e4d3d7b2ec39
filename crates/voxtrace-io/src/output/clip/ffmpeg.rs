//! H.264 in MP4 by [ffmpeg](https://ffmpeg.org), where that is installed: more players know it than AV1. BT.709, 4:2:0, eight bits, by libx264.

use super::{ClipOptions, Frames, over_black};
use std::io::{self, Write};
use std::path::Path;
use std::process::{Command, Stdio};

/// The program.
const PROGRAM: &str = "ffmpeg";

/// Why there is no clip.
#[derive(Debug, thiserror::Error)]
pub enum FfmpegError {
    /// A frame that could not be had, or a program that could not be started.
    #[error(transparent)]
    Io(#[from] io::Error),
    /// What it says itself.
    #[error("ffmpeg: {0}")]
    Failed(String),
}

/// Whether there is one on the path.
pub fn is_installed() -> bool {
    let quiet = Command::new(PROGRAM).arg("-version").stdout(Stdio::null()).stderr(Stdio::null()).status();
    quiet.is_ok_and(|status| status.success())
}

/// Writes a clip over what the file has; frames are asked for in their order.
///
/// # Errors
/// [`FfmpegError`]: what `frames` reports, what ffmpeg does, or that there is none.
pub fn encode(path: &Path, options: &ClipOptions, frames: Frames) -> Result<(), FfmpegError> {
    let ClipOptions { width, height, fps, quality, .. } = *options;
    let crf = (f64::from(100 - quality.min(100)) * 0.8).round().min(51.0);
    let mut child = Command::new(PROGRAM)
        .args(["-hide_banner", "-loglevel", "error", "-y", "-f", "rawvideo", "-pix_fmt", "rgb24"])
        .args(["-s", &format!("{width}x{height}"), "-r", &fps.to_string(), "-i", "-"])
        // Sizes are made even first: what follows rounds those of the colours. Newer versions take what the colours are from the frames.
        .args([
            "-vf",
            "pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv,format=yuv420p,\
             setparams=color_primaries=bt709:color_trc=bt709:colorspace=bt709",
        ])
        .args(["-c:v", "libx264", "-crf", &crf.to_string(), "-pix_fmt", "yuv420p", "-movflags", "+faststart"])
        .args(["-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "bt709", "-f", "mp4"])
        .arg(path)
        .stdin(Stdio::piped())
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()?;
    let mut input = child.stdin.take();
    let mut send = || -> io::Result<()> {
        let Some(input) = &mut input else { return Ok(()) };
        for frame in 0..options.frames {
            let bytes: Vec<u8> = frames(frame)?.into_iter().flat_map(over_black).collect();
            input.write_all(&bytes)?;
        }
        Ok(())
    };
    let sent = send();
    drop(input);
    let output = child.wait_with_output()?;
    // Where it went away, it says why; else it is a frame that could not be read.
    match sent {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => return Err(error.into()),
        Ok(()) if output.status.success() => return Ok(()),
        _ => {}
    }
    let said = String::from_utf8_lossy(&output.stderr);
    Err(FfmpegError::Failed(said.lines().last().unwrap_or("it ended early").trim().to_owned()))
}
