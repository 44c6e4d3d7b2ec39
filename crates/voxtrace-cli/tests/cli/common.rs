//! A folder with a small scene, the program run in it, and what it wrote read back.

use std::io::{BufRead, BufReader, Cursor, Lines};
use std::iter::Map;
use std::path::PathBuf;
use std::process::{Child, ChildStderr, Command, Output, Stdio};
use voxtrace::glam::{IVec3, Vec3};
use voxtrace::import::ImportOptions;
use voxtrace::{Camera, Material, Scene, VoxelGrid};

/// Options of a small and quick picture.
pub const SMALL: [&str; 4] = ["--size", "40x30", "--spp", "4"];

/// Lines of a program's stderr.
#[cfg_attr(not(unix), allow(dead_code, reason = "tests of signals alone use it"))]
pub type Messages = Map<Lines<BufReader<ChildStderr>>, fn(std::io::Result<String>) -> String>;

/// A folder of its own with `room.vox` and `room.vxt` in it.
pub struct Folder {
    folder: tempfile::TempDir,
}

/// A floor with a red block and a lamp, and two cameras.
pub fn room() -> Scene {
    let materials = vec![
        Material::diffuse(Vec3::splat(0.8)),
        Material::diffuse(Vec3::new(0.8, 0.05, 0.05)),
        Material::emissive(Vec3::new(8.0, 6.0, 3.0)),
    ];
    let mut grid = VoxelGrid::new();
    for x in 0..24 {
        for y in 0..24 {
            grid.set(IVec3::new(x, y, 0), 0);
        }
    }
    for i in 0..6 * 6 * 6 {
        grid.set(IVec3::new(9 + i % 6, 9 + i / 6 % 6, 1 + i / 36), 1);
    }
    for i in 0..2 * 2 * 2 {
        grid.set(IVec3::new(4 + i % 2, 4 + i / 2 % 2, 6 + i / 4), 2);
    }
    let mut scene = Scene::from_grid("room", grid, materials);
    let front = Camera::look_at(Vec3::new(12.0, -30.0, 18.0), Vec3::new(12.0, 12.0, 2.0));
    let side = Camera::look_at(Vec3::new(50.0, 12.0, 14.0), Vec3::new(12.0, 12.0, 2.0));
    scene.cameras = vec![Camera { name: "front".into(), ..front }, Camera { name: "side".into(), ..side }];
    scene
}

impl Folder {
    pub fn new() -> Self {
        let folder = Self { folder: tempfile::tempdir().unwrap() };
        voxtrace::export::vox::write(&folder.path("room.vox"), &room()).unwrap();
        // Read again: the file's colours are those of sRGB bytes.
        let scene = voxtrace::import::open(&folder.path("room.vox"), &ImportOptions::default()).unwrap();
        voxtrace::PackedScene::pack(&scene).unwrap().save(&folder.path("room.vxt")).unwrap();
        folder
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    pub fn bytes(&self, name: &str) -> Vec<u8> {
        std::fs::read(self.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    pub fn exists(&self, name: &str) -> bool {
        self.path(name).exists()
    }

    /// The program in this folder.
    pub fn command<S: AsRef<str>>(&self, arguments: &[S]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_voxtrace"));
        command.args(arguments.iter().map(AsRef::as_ref)).current_dir(self.folder.path());
        command.env("VOXTRACE_CACHE", self.path("cache"));
        command
    }

    /// Starts the program; returns the lines of its stderr as they come.
    #[cfg_attr(not(unix), allow(dead_code, reason = "tests of signals alone use it"))]
    pub fn watch<S: AsRef<str>>(&self, arguments: &[S]) -> (Child, Messages) {
        let mut child = self.command(arguments).stderr(Stdio::piped()).stdout(Stdio::null()).spawn().unwrap();
        let lines = BufReader::new(child.stderr.take().unwrap()).lines().map(Result::unwrap as fn(_) -> _);
        (child, lines)
    }

    /// Runs the program to its end.
    pub fn run<S: AsRef<str>>(&self, arguments: &[S]) -> Output {
        self.command(arguments).output().unwrap()
    }

    /// Runs the program, which must succeed. Returns its stdout.
    pub fn succeed<S: AsRef<str>>(&self, arguments: &[S]) -> String {
        let output = self.run(arguments);
        let shown: Vec<&str> = arguments.iter().map(AsRef::as_ref).collect();
        assert!(output.status.success(), "{shown:?}: {}", stderr(&output));
        stdout(&output)
    }

    /// Runs the program, which must end with this exit code and one line of error. Returns the line.
    pub fn fail<S: AsRef<str>>(&self, arguments: &[S], code: i32) -> String {
        let output = self.command(arguments).arg("--quiet").output().unwrap();
        let shown: Vec<&str> = arguments.iter().map(AsRef::as_ref).collect();
        assert_eq!(output.status.code(), Some(code), "{shown:?}: {}", stderr(&output));
        let text = stderr(&output);
        assert!(text.starts_with("error: ") && text.trim_end().lines().count() == 1, "{shown:?}: {text}");
        assert_eq!(stdout(&output), "", "{shown:?}");
        text
    }

    /// Renders `room.vox` small with these options into `name`, in a run of its own.
    pub fn render(&self, name: &str, options: &[&str]) -> Picture {
        self.succeed(&[&["render", "room.vox", "-o", name], &SMALL[..], options].concat());
        self.png(name)
    }

    pub fn png(&self, name: &str) -> Picture {
        Picture::decode(&self.bytes(name))
    }
}

pub fn stdout(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).unwrap()
}

pub fn stderr(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

/// A decoded PNG.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    pub width: usize,
    pub height: usize,
    pub channels: usize,
    pub bits: u8,
    /// Row by row, pixel by pixel.
    pub samples: Vec<u16>,
    pub texts: Vec<(String, String)>,
}

impl Picture {
    pub fn decode(bytes: &[u8]) -> Self {
        let mut reader = png::Decoder::new(Cursor::new(bytes)).read_info().unwrap();
        let mut buffer = vec![0; reader.output_buffer_size().unwrap()];
        let frame = reader.next_frame(&mut buffer).unwrap();
        let samples = match frame.bit_depth {
            png::BitDepth::Sixteen => {
                buffer.chunks_exact(2).map(|word| u16::from_be_bytes([word[0], word[1]])).collect()
            }
            _ => buffer.iter().map(|&byte| byte.into()).collect(),
        };
        let info = reader.info();
        let latin = info.uncompressed_latin1_text.iter().map(|text| (text.keyword.clone(), text.text.clone()));
        Self {
            width: frame.width as usize,
            height: frame.height as usize,
            channels: frame.color_type.samples(),
            bits: frame.bit_depth as u8,
            samples,
            texts: latin.collect(),
        }
    }

    pub fn pixel(&self, x: usize, y: usize) -> &[u16] {
        let start = (y * self.width + x) * self.channels;
        &self.samples[start..start + self.channels]
    }

    pub fn text(&self, keyword: &str) -> &str {
        let found = self.texts.iter().find(|(name, _)| name == keyword);
        &found.unwrap_or_else(|| panic!("no text {keyword}")).1
    }

    /// Mean of all samples.
    pub fn mean(&self) -> f64 {
        self.samples.iter().map(|&sample| f64::from(sample)).sum::<f64>() / self.samples.len() as f64
    }
}
