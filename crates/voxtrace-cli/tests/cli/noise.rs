//! `--noise`: each part of a picture gets the samples that it needs, and the film stays exact.

use crate::common::Folder;
use serde_json::Value;
use voxtrace::output::FilmFile;
use voxtrace_test_support::{Need, skip_without};

/// 5 × 4 tiles.
const TILES: [&str; 4] = ["--size", "160x128", "--max-bounces", "2"];

impl Folder {
    fn sampled(&self, name: &str, options: &[&str]) -> FilmFile {
        self.succeed(&[&["render", "room.vox", "--checkpoint", name, "-q"], &TILES[..], options].concat());
        FilmFile::open(&self.path(name)).unwrap()
    }
}

/// The relative error of each tile against a film of many samples.
fn errors(film: &FilmFile, many: &FilmFile) -> Vec<f64> {
    let tile = |(column, row): (usize, usize)| {
        let (mut square, mut sum) = (0.0, 0.0);
        for index in (0..32 * 32).map(|i| (row * 32 + i / 32) * 160 + column * 32 + i % 32) {
            let luminance = |film: &FilmFile| {
                let mean = film.film.pixels[index].mean();
                f64::from(0.2126 * mean.x + 0.7152 * mean.y + 0.0722 * mean.z)
            };
            square += (luminance(film) - luminance(many)).powi(2);
            sum += luminance(many);
        }
        (square / 1024.0).sqrt() / (sum / 1024.0)
    };
    (0..4).flat_map(|row| (0..5).map(move |column| (column, row))).map(tile).collect()
}

/// Checks that at most a tenth of the tiles has more error than was asked for.
fn check(errors: &[f64], noise: f64) -> Result<(), String> {
    let above = errors.iter().filter(|&&error| error > noise).count();
    if above * 10 <= errors.len() { Ok(()) } else { Err(format!("{above} of {errors:?} are above {noise}")) }
}

#[test]
fn nine_of_ten_tiles_have_the_error_asked_for_or_less_and_no_pixel_more_samples_than_it_needs() {
    let folder = Folder::new();
    let film = folder.sampled("film.vxf", &["--noise", "0.05"]);
    let many = folder.sampled("many.vxf", &["--spp", "1024", "--seed", "1"]);
    check(&errors(&film, &many), 0.05).unwrap();
    check(&errors(&folder.sampled("few.vxf", &["--spp", "2"]), &many), 0.05).unwrap_err();
    let (least, most) = film.film.sample_range();
    assert!(least >= 12 && least < most && most == film.frame.samples, "{least} {most}");
    // What a pixel holds are the first samples of its sequence.
    let whole = folder.sampled("whole.vxf", &["--spp", &least.to_string()]);
    let pairs = || film.film.pixels.iter().zip(&whole.film.pixels);
    assert!(pairs().filter(|(ours, _)| ours.samples == least).all(|(ours, theirs)| ours == theirs));
    assert!(pairs().any(|(ours, _)| ours.samples == least));

    let json: Value = serde_json::from_str(&folder.succeed(&["info", "film.vxf", "--json"])).unwrap();
    assert_eq!((json["samples"]["least"].clone(), json["samples"]["most"].clone()), (least.into(), most.into()));
    assert!(json["error"]["worst_tile"].as_f64().unwrap() <= 0.05, "{json}");
    assert!(folder.succeed(&["info", "film.vxf"]).contains("worst of 20 tiles"));
    assert!(folder.succeed(&["info", "many.vxf"]).contains("not known"));
}

#[test]
fn interrupted_or_not_the_film_is_the_same() {
    let folder = Folder::new();
    let options = ["--noise", "0.06", "--spp", "400"];
    folder.sampled("whole.vxf", &options);
    for time in ["1ms", "60ms", "150ms"] {
        folder.sampled("part.vxf", &[&options[..], &["--time-limit", time]].concat());
        let resume = ["render", "room.vox", "--resume", "part.vxf", "--checkpoint", "rest.vxf"];
        folder.succeed(&[&resume[..], &options].concat());
        assert_eq!(folder.bytes("rest.vxf"), folder.bytes("whole.vxf"), "{time}");
    }
    let other = folder.sampled("other.vxf", &["--noise", "0.05", "--spp", "400"]);
    assert_ne!(other.to_bytes(), folder.bytes("whole.vxf"));
    // A film of less noise continues one of more, and merging takes the longer part of each pixel.
    folder.succeed(&["merge", "whole.vxf", "other.vxf", "-o", "both.vxf"]);
    assert_eq!(FilmFile::open(&folder.path("both.vxf")).unwrap().film.pixels, other.film.pixels);
    assert!(folder.fail(&["render", "room.vox", "--noise", "0"], 2).contains("above 0"));
}

#[test]
fn devices_stop_where_the_processor_does() {
    let folder = Folder::new();
    let options = ["--noise", "0.1", "--spp", "100"];
    let film = folder.sampled("cpu.vxf", &[&options[..], &["--traversal", "cpu"]].concat());
    let devices: Value = serde_json::from_str(&folder.succeed(&["devices", "--json"])).unwrap();
    if devices["devices"].as_array().is_none_or(|devices| devices.len() < 2) {
        return skip_without(Need::Vulkan, "there is no Vulkan device");
    }
    let other = folder.sampled("walk.vxf", &[&options[..], &["--traversal", "walk"]].concat());
    assert_eq!(film.film.pixels, other.film.pixels);
}
