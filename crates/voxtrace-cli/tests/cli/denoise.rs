//! Pictures without noise: what they look like, and that films stay as they were.

use crate::common::Folder;
use voxtrace::output::FilmFile;
use voxtrace_test_support::skip;

/// Options of a picture with much noise.
const NOISY: [&str; 6] = ["--size", "96x72", "--spp", "8", "--max-bounces", "4"];

impl Folder {
    fn psnr(&self, a: &str, b: &str) -> f64 {
        let json: serde_json::Value = serde_json::from_str(&self.succeed(&["compare", a, b, "--json"])).unwrap();
        json["psnr_db"].as_f64().unwrap()
    }
}

#[test]
fn a_denoised_picture_is_nearer_to_one_of_many_samples() {
    let folder = Folder::new();
    let size = ["--size", "96x72", "--max-bounces", "4"];
    folder.succeed(&[&["render", "room.vox", "-o", "many.png", "--spp", "1024", "--seed", "1"], &size[..]].concat());
    folder.succeed(&[&["render", "room.vox", "-o", "raw.png"], &NOISY[..]].concat());
    folder.succeed(&[&["render", "room.vox", "-o", "clean.png", "--denoise"], &NOISY[..]].concat());
    let (raw, clean) = (folder.psnr("raw.png", "many.png"), folder.psnr("clean.png", "many.png"));
    assert!(clean > raw + 2.0, "{raw} {clean}");
    assert_eq!(folder.png("clean.png").text("voxtrace.denoise"), "voxtrace");
    assert!(folder.png("raw.png").texts.iter().all(|(name, _)| name != "voxtrace.denoise"));
}

#[test]
fn exr_keeps_the_noisy_picture_and_the_film_its_sums() {
    use exr::prelude::{FlatSamples, read_first_flat_layer_from_file};
    let folder = Folder::new();
    folder.succeed(&[&["render", "room.vox", "-o", "raw.exr", "-o", "raw.vxf"], &NOISY[..]].concat());
    folder.succeed(&[&["render", "room.vox", "-o", "a.exr", "-o", "a.vxf", "--denoise=voxtrace"], &NOISY[..]].concat());
    let channel = |file: &str, name: &str| {
        let image = read_first_flat_layer_from_file(folder.path(file)).unwrap();
        let channels = image.layer_data.channel_data.list.into_iter();
        let found = channels.into_iter().find(|channel| channel.name == *name)?;
        let FlatSamples::F32(samples) = found.sample_data else { panic!("{name} has other samples") };
        Some(samples)
    };
    for name in ["R", "G", "B"] {
        assert_eq!(channel("a.exr", &format!("noisy.{name}")), channel("raw.exr", name));
        assert_ne!(channel("a.exr", name), channel("raw.exr", name));
        assert_eq!(channel("raw.exr", &format!("noisy.{name}")), None);
    }
    let [raw, clean] = ["raw.vxf", "a.vxf"].map(|name| FilmFile::open(&folder.path(name)).unwrap());
    assert_eq!(raw.film.pixels, clean.film.pixels);
    assert_eq!(raw.film.earlier, None);
    assert!(clean.film.earlier.unwrap().iter().all(|pixel| pixel.samples == 4));
}

#[test]
fn a_film_can_be_denoised_later_with_the_same_bytes() {
    let folder = Folder::new();
    let denoise = ["--denoise", "-q"];
    folder.succeed(&[&["render", "room.vox", "-o", "at-once.png", "-o", "film.vxf"], &NOISY[..], &denoise].concat());
    folder.succeed(&[&["render", "room.vox", "--resume", "film.vxf", "-o", "later.png"], &denoise[..]].concat());
    assert_eq!(folder.bytes("later.png"), folder.bytes("at-once.png"));
    folder.succeed(&[&["render", "room.vox", "-o", "one.png", "--denoise", "--threads", "1"], &NOISY[..]].concat());
    assert_eq!(folder.bytes("one.png"), folder.bytes("at-once.png"));
}

#[test]
fn lenses_crops_and_empty_backgrounds_are_denoised_too() {
    let folder = Folder::new();
    for (name, options) in [
        ("thin.png", &["--aperture", "2", "--focus", "40"][..]),
        ("crop.png", &["--crop", "10,60,20,50"][..]),
        ("alpha.png", &["--transparent", "--integrator", "essay"][..]),
        ("one.png", &["--spp", "1"][..]),
    ] {
        let base = ["render", "room.vox", "-o", name, "--size", "96x72", "--denoise"];
        let spp = if name == "one.png" { &[][..] } else { &["--spp", "8"][..] };
        folder.succeed(&[&base[..], spp, options].concat());
        let mean = folder.png(name).mean();
        assert!((5.0..250.0).contains(&mean), "{name}: {mean}");
    }
    let alpha = folder.png("alpha.png");
    assert_eq!((alpha.channels, alpha.pixel(0, 0)), (4, &[0, 0, 0, 0][..]));
}

#[test]
fn without_its_library_open_image_denoise_is_refused_before_the_work() {
    let folder = Folder::new();
    let mut command = folder.command(&["render", "room.vox", "-o", "a.png", "--denoise", "oidn", "-q"]);
    let output = command.env("VOXTRACE_OIDN", folder.path("nowhere")).output().unwrap();
    let text = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(1), "{text}");
    assert!(text.contains("nowhere") && text.contains("hint: ") && text.lines().count() == 1, "{text}");
    assert!(!folder.exists("a.png"));
    // A library that is another.
    std::fs::write(folder.path("libOpenImageDenoise.so.2"), "no library").unwrap();
    let mut command = folder.command(&["render", "room.vox", "-o", "a.png", "--denoise", "oidn", "-q"]);
    assert_eq!(command.env("VOXTRACE_OIDN", folder.path(".")).output().unwrap().status.code(), Some(1));
}

#[test]
fn open_image_denoise_filters_where_it_is_installed() {
    let python = std::env::var("VOXTRACE_PYTHON").unwrap_or_else(|_| "python3".into());
    let ask = "import importlib.util as u; print(u.find_spec('pyoidn').submodule_search_locations[0])";
    let found = std::process::Command::new(&python).args(["-c", ask]).output();
    let named = std::env::var("VOXTRACE_OIDN").ok().filter(|named| !named.is_empty());
    let library = match (named, found) {
        (Some(named), _) => named,
        (None, Ok(output)) if output.status.success() => {
            format!("{}/oidn/lib", String::from_utf8(output.stdout).unwrap().trim())
        }
        _ => return skip(&format!("{python} has no pyoidn")),
    };
    let folder = Folder::new();
    let size = ["--size", "96x72", "--max-bounces", "4"];
    folder.succeed(&[&["render", "room.vox", "-o", "many.png", "--spp", "1024", "--seed", "1"], &size[..]].concat());
    folder.succeed(&[&["render", "room.vox", "-o", "raw.png"], &NOISY[..]].concat());
    let arguments = [&["render", "room.vox", "-o", "clean.png", "--denoise", "oidn"], &NOISY[..]].concat();
    let output = folder.command(&arguments).env("VOXTRACE_OIDN", library).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let (raw, clean) = (folder.psnr("raw.png", "many.png"), folder.psnr("clean.png", "many.png"));
    assert!(clean > raw + 2.0, "{raw} {clean}");
    assert_eq!(folder.png("clean.png").text("voxtrace.denoise"), "oidn");
}
