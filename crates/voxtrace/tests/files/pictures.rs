//! Pictures and film files are read back, by other code than ours where there is any, and hold what the film held.

use std::io::Cursor;
use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};
use voxtrace::camera::Lens;
use voxtrace::cuts::Cuts;
use voxtrace::film::{AovPixel, Pixel};
use voxtrace::glam::{IVec3, Vec3};
use voxtrace::lines::{GridLines, Line, Lines};
use voxtrace::material::encode_srgb;
use voxtrace::output::{
    ExrOptions, FilmFile, FilmFileError, Metadata, Operator, PngDepth, PngOptions, SceneStamp, ToneMap, write_exr,
    write_png,
};
use voxtrace::sky::{Background, Environment, EnvironmentMap};
use voxtrace::{
    Camera, CpuTracer, Film, Frame, Integrator, PackedScene, Picture, Progress, Region, Sky, Sun, Tracer, scenes,
};

const SAMPLES: u32 = 4;

/// A film of 6 × 4 pixels of a picture of 10 × 8, every pixel different, half of the last row uncovered.
fn example() -> FilmFile {
    let region = Region { x0: 2, y0: 3, x1: 8, y1: 7 };
    let camera = Camera { name: "Kanzel ü".into(), ..Camera::look_at(Vec3::new(1.0, 2.0, 3.5), Vec3::ZERO) };
    let frame = Frame::new(camera, 10, 8)
        .region(region)
        .first_sample(16)
        .samples(SAMPLES)
        .seed(7)
        .max_bounces(8)
        .integrator(Integrator::Path)
        .transparent(true)
        .aovs(true);
    let sun = Sun { direction: Vec3::Z, angular_radius: 0.01, irradiance: Vec3::new(3.0, 2.0, 1.0) };
    let sky = Sky::study(0.5).with_sun(sun);
    let (name, cuts) = ("a church".into(), Cuts::default());
    let scene = SceneStamp { name, content_hash: 0x0123_4567_89ab_cdef, sky, light_intensity: 2.5, cuts };
    let mut film = Film::new(10, 8, region, 16);
    let mut aovs = Vec::new();
    for (index, pixel) in film.pixels.iter_mut().enumerate() {
        let covered = if index == 20 {
            1
        } else if index > 20 {
            0
        } else {
            SAMPLES
        };
        for sample in 0..SAMPLES {
            let is_covered = sample < covered;
            let radiance = if is_covered { Vec3::new(index as f32 / 24.0, 0.25, 1.5) } else { Vec3::ZERO };
            pixel.add(radiance, is_covered);
        }
        aovs.push(match covered {
            0 => AovPixel::MISS,
            _ => AovPixel {
                albedo: Vec3::new(0.5, 0.25, index as f32 / 32.0),
                normal: Vec3::NEG_Y,
                depth: 100.0 + index as f32,
                instance: 70_000 + index as u32,
                voxel: IVec3::new(-(index as i32), 524_287, -524_288),
            },
        });
    }
    film.aovs = Some(aovs);
    FilmFile { frame, scene, film }
}

fn metadata(file: &FilmFile) -> Metadata {
    Metadata::new(&file.frame, &file.scene, &file.film)
}

fn png_of(file: &FilmFile, options: &PngOptions) -> Vec<u8> {
    let mut bytes = Vec::new();
    write_png(&mut bytes, &file.film, options, &metadata(file)).unwrap();
    bytes
}

fn exr_of(file: &FilmFile, options: &ExrOptions) -> Vec<u8> {
    let mut bytes = Vec::new();
    write_exr(&mut bytes, &file.film, options, &metadata(file)).unwrap();
    bytes
}

/// Width, height and samples of a PNG, each scaled to [0, 1].
fn decode_png(bytes: &[u8]) -> (u32, u32, Vec<f64>) {
    let mut reader = png::Decoder::new(Cursor::new(bytes)).read_info().unwrap();
    let mut samples = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut samples).unwrap();
    let values = match info.bit_depth {
        png::BitDepth::Sixteen => {
            samples.chunks_exact(2).map(|word| f64::from(u16::from_be_bytes([word[0], word[1]])) / 65_535.0).collect()
        }
        _ => samples.iter().map(|&byte| f64::from(byte) / 255.0).collect(),
    };
    (info.width, info.height, values)
}

const LINEAR: ToneMap = ToneMap { operator: Operator::Linear, exposure: 0.0 };

#[test]
fn a_png_holds_the_srgb_signal_of_the_mean_of_every_pixel() {
    let file = example();
    for (depth, tolerance) in [(PngDepth::Eight, 0.5 / 255.0), (PngDepth::Sixteen, 0.5 / 65_535.0)] {
        let options = PngOptions { tone_map: LINEAR, depth, alpha: false };
        let (width, height, values) = decode_png(&png_of(&file, &options));
        assert_eq!((width, height, values.len()), (6, 4, 6 * 4 * 3));
        let deviation = |pixels: &[Pixel]| {
            let expected = pixels.iter().flat_map(|pixel| pixel.mean().to_array().map(|v| encode_srgb(v.into())));
            values.iter().zip(expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
        };
        assert!(deviation(&file.film.pixels) < tolerance * 1.01);
        // The comparison sees two pixels in each other's place.
        let mut swapped = file.film.pixels.clone();
        swapped.swap(3, 4);
        assert!(deviation(&swapped) > tolerance * 2.0);
    }
}

#[test]
fn a_transparent_png_has_straight_alpha_and_colours_as_bright_as_what_covers_the_pixel() {
    let options = PngOptions { tone_map: LINEAR, depth: PngDepth::Sixteen, alpha: true };
    let (_, _, values) = decode_png(&png_of(&example(), &options));
    let pixel = |index: usize| &values[index * 4..index * 4 + 4];
    assert_eq!(pixel(19)[3], 1.0);
    assert!((pixel(20)[3] - 0.25).abs() < 1e-4);
    assert_eq!(pixel(21), [0.0; 4]);
    // A quarter covered, and yet as green as its covered neighbour.
    assert!((pixel(20)[1] - encode_srgb(0.25)).abs() < 1e-4);
    assert_eq!(pixel(20)[1], pixel(19)[1]);
}

#[test]
fn a_png_says_how_it_was_made() {
    let reader = png::Decoder::new(Cursor::new(png_of(&example(), &PngOptions::default()))).read_info().unwrap();
    let info = reader.info();
    assert!(info.srgb.is_some());
    let find = |keyword: &str| {
        let text = info.uncompressed_latin1_text.iter().find(|chunk| chunk.keyword == keyword);
        text.map(|chunk| chunk.text.clone()).or_else(|| {
            let text = info.utf8_text.iter().find(|chunk| chunk.keyword == keyword)?;
            text.get_text().ok()
        })
    };
    assert_eq!(find("Software").unwrap(), concat!("voxtrace ", env!("CARGO_PKG_VERSION")));
    assert_eq!(find("voxtrace.scene").unwrap(), "a church");
    assert_eq!(find("voxtrace.scene_hash").unwrap(), "0123456789abcdef");
    assert_eq!(find("voxtrace.seed").unwrap(), "7");
    assert_eq!(find("voxtrace.first_sample").unwrap(), "16");
    assert_eq!(find("voxtrace.samples").unwrap(), "4");
    assert_eq!(find("voxtrace.integrator").unwrap(), "path");
    assert_eq!(find("voxtrace.camera").unwrap(), "Kanzel ü");
    assert_eq!(find("voxtrace.camera.eye").unwrap(), "1,2,3.5");
    assert_eq!(find("voxtrace.tone_map").unwrap(), "agx");
    assert_eq!(find("voxtrace.nothing"), None);
}

#[test]
fn the_samples_of_an_interrupted_film_are_given_as_a_range() {
    let mut file = example();
    file.film.pixels[0] = Pixel::default();
    let entries = metadata(&file);
    assert!(entries.entries().contains(&("voxtrace.samples", "0..4".into())));
}

/// Channels of an EXR by name, as floats or ids.
fn decode_exr(bytes: &[u8]) -> exr::prelude::FlatImage {
    use exr::prelude::{ReadChannels, ReadLayers};
    exr::prelude::read()
        .no_deep_data()
        .largest_resolution_level()
        .all_channels()
        .all_layers()
        .all_attributes()
        .from_buffered(Cursor::new(bytes))
        .unwrap()
}

fn channel(image: &exr::prelude::FlatImage, name: &str) -> Vec<f32> {
    let found = image.layer_data[0].channel_data.list.iter().find(|channel| channel.name.to_string() == name);
    found.unwrap_or_else(|| panic!("no channel {name}")).sample_data.values_as_f32().collect()
}

#[test]
fn an_exr_holds_the_linear_means_and_every_aov_under_the_expected_names() {
    let file = example();
    let image = decode_exr(&exr_of(&file, &ExrOptions { half: false, alpha: true }));
    let aovs = file.film.aovs.as_ref().unwrap();
    let of_pixels = |f: &dyn Fn(&Pixel) -> f32| file.film.pixels.iter().map(f).collect::<Vec<_>>();
    let of_aovs = |f: &dyn Fn(&AovPixel) -> f32| aovs.iter().map(f).collect::<Vec<_>>();
    for (axis, name) in ["R", "G", "B"].into_iter().enumerate() {
        assert_eq!(channel(&image, name), of_pixels(&|pixel| pixel.mean()[axis]));
        assert_eq!(channel(&image, &format!("albedo.{name}")), of_aovs(&|pixel| pixel.albedo[axis]));
    }
    for (axis, name) in ["X", "Y", "Z"].into_iter().enumerate() {
        assert_eq!(channel(&image, &format!("normal.{name}")), of_aovs(&|pixel| pixel.normal[axis]));
        assert_eq!(channel(&image, &format!("voxel.{name}")), of_aovs(&|pixel| pixel.voxel[axis] as f32));
    }
    assert_eq!(channel(&image, "A"), of_pixels(&Pixel::alpha));
    assert_eq!(channel(&image, "depth.Z"), of_aovs(&|pixel| pixel.depth));
    assert_eq!(channel(&image, "id.instance"), of_aovs(&|pixel| pixel.instance as f32));
    // The comparison sees a wrong pixel.
    assert_ne!(channel(&image, "depth.Z"), of_aovs(&|pixel| pixel.depth + f32::from(pixel.depth == 103.0)));
}

#[test]
fn an_exr_without_aovs_or_transparency_is_opaque_rgba() {
    let mut file = example();
    file.film.aovs = None;
    let image = decode_exr(&exr_of(&file, &ExrOptions { half: true, alpha: false }));
    let names: Vec<_> = image.layer_data[0].channel_data.list.iter().map(|channel| channel.name.to_string()).collect();
    assert_eq!(names, ["A", "B", "G", "R"]);
    assert_eq!(channel(&image, "A"), [1.0; 24]);
    let mut channels = image.layer_data[0].channel_data.list.iter();
    assert!(channels.all(|channel| matches!(channel.sample_data, exr::prelude::FlatSamples::F16(_))));
}

#[test]
fn an_exr_knows_its_place_in_the_picture_and_how_it_was_made() {
    let image = decode_exr(&exr_of(&example(), &ExrOptions::default()));
    let layer = &image.layer_data[0];
    assert_eq!((layer.size.0, layer.size.1), (6, 4));
    assert_eq!((layer.attributes.layer_position.0, layer.attributes.layer_position.1), (2, 3));
    assert_eq!((image.attributes.display_window.size.0, image.attributes.display_window.size.1), (10, 8));
    let text = |name: &str| match layer.attributes.other.get(&exr::prelude::Text::from(name)) {
        Some(exr::prelude::AttributeValue::Text(text)) => text.to_string(),
        other => panic!("{name}: {other:?}"),
    };
    assert_eq!(text("voxtrace.scene_hash"), "0123456789abcdef");
    assert_eq!(text("voxtrace.samples"), "4");
    assert_eq!(text("voxtrace.camera.eye"), "1,2,3.5");
    let software = layer.attributes.software_name.as_ref().unwrap().to_string();
    assert_eq!(software, concat!("voxtrace ", env!("CARGO_PKG_VERSION")));
}

#[test]
fn writing_twice_gives_the_same_bytes() {
    let file = example();
    for _ in 0..4 {
        assert_eq!(exr_of(&file, &ExrOptions::default()), exr_of(&file, &ExrOptions::default()));
        assert_eq!(png_of(&file, &PngOptions::default()), png_of(&file, &PngOptions::default()));
    }
    let mut other = file.clone();
    other.film.pixels[5].radiance[1] *= 2;
    assert_ne!(exr_of(&file, &ExrOptions::default()), exr_of(&other, &ExrOptions::default()));
    assert_ne!(png_of(&file, &PngOptions::default()), png_of(&other, &PngOptions::default()));
}

#[test]
fn a_picture_that_nobody_waits_for_any_more_leaves_the_old_file() {
    let picture = Picture::of_film(example());
    for extension in ["png", "exr", "vxf"] {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a").with_extension(extension);
        let asked = AtomicU32::new(0);
        let until = |most: u32| {
            asked.store(0, Ordering::Relaxed);
            let asked = &asked;
            move || asked.fetch_add(1, Ordering::Relaxed) < most
        };
        picture.save_while(&path, &until(u32::MAX)).unwrap();
        let (whole, questions) = (std::fs::read(&path).unwrap(), asked.load(Ordering::Relaxed));
        for answered in 0..questions {
            std::fs::write(&path, "old").unwrap();
            let saved = picture.save_while(&path, &until(answered));
            assert!(saved.is_err(), "{extension} after {answered} of {questions}");
            assert_eq!(std::fs::read(&path).unwrap(), b"old");
            assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1, "nothing is left behind");
        }
        // One answer more, and it is written.
        picture.save_while(&path, &until(questions)).unwrap();
        assert_eq!(std::fs::read(&path).unwrap(), whole);
    }
}

#[test]
fn a_film_file_comes_back_as_it_was() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.vxf");
    let mut file = example();
    file.save(&path).unwrap();
    assert_eq!(FilmFile::open(&path).unwrap(), file);

    // Without AOVs, without a sun, and interrupted.
    file.film.aovs = None;
    file.scene.sky.set_sun(None);
    file.film.pixels[3] = Pixel::default();
    assert_ne!(FilmFile::open(&path).unwrap(), file);
    file.save(&path).unwrap();
    assert_eq!(FilmFile::open(&path).unwrap(), file);
}

#[test]
fn a_film_under_an_environment_map_holds_it() {
    let mut file = example();
    let texels: Vec<Vec3> = (0..16).map(|index| Vec3::splat(index as f32)).collect();
    let map = Arc::new(EnvironmentMap::new(4, &texels).unwrap());
    let set = |file: &mut FilmFile, rotation| {
        file.scene.sky.set_background(Background::Environment(Environment::new(map.clone(), rotation)));
    };
    set(&mut file, 20.0);
    let bytes = file.to_bytes();
    assert_eq!(bytes[8], 3, "the version says it");
    assert_eq!(FilmFile::from_bytes(&bytes).unwrap(), file);
    let mut hidden = file.clone();
    hidden.scene.sky.set_sun_disc_visible(false);
    assert_eq!(FilmFile::from_bytes(&hidden.to_bytes()).unwrap(), hidden);
    assert_ne!(FilmFile::from_bytes(&bytes).unwrap(), hidden, "the comparison sees whether the sun's disc is visible");
    let difference = file.difference(&file.frame, &hidden.scene).unwrap();
    assert!(difference.starts_with("sky"), "{difference}");
    let mut turned = file.clone();
    set(&mut turned, 21.0);
    assert_ne!(FilmFile::from_bytes(&bytes).unwrap(), turned);
    let difference = file.difference(&file.frame, &turned.scene).unwrap();
    assert!(difference.starts_with("sky") && difference.len() < 1000, "{difference}");
    for at in 0..bytes.len() {
        let mut damaged = bytes.clone();
        damaged[at] ^= 1 << (at % 8);
        assert!(FilmFile::from_bytes(&damaged).is_err(), "bit flipped in byte {at}");
        assert!(FilmFile::from_bytes(&bytes[..at]).is_err(), "cut at byte {at}");
    }
}

#[test]
fn every_flipped_bit_and_every_truncation_of_a_film_file_is_noticed() {
    let bytes = example().to_bytes();
    for at in 0..bytes.len() {
        let mut damaged = bytes.clone();
        damaged[at] ^= 1 << (at % 8);
        assert!(FilmFile::from_bytes(&damaged).is_err(), "bit flipped in byte {at}");
        assert!(FilmFile::from_bytes(&bytes[..at]).is_err(), "cut at byte {at}");
    }
    assert!(FilmFile::from_bytes(&[bytes.as_slice(), &[0]].concat()).is_err());
}

/// Why a film with other bytes in one place is refused, under a checksum that is right.
fn refused(bytes: &[u8], at: usize, value: [u8; 4]) -> FilmFileError {
    let mut forged = bytes[..bytes.len() - 8].to_vec();
    forged[at..at + 4].copy_from_slice(&value);
    forged.extend_from_slice(&xxhash_rust::xxh3::xxh3_64(&forged).to_le_bytes());
    FilmFile::from_bytes(&forged).unwrap_err()
}

#[test]
fn films_of_cuts_hold_them_and_refuse_what_is_none() {
    let tilted = Cuts::default().plane(Vec3::new(0.3, -0.2, 1.0), 5.2).unwrap();
    let mut file = example();
    let without = file.to_bytes();
    for shadows in [false, true] {
        file.scene.cuts = tilted.clone().clip_box(Vec3::NEG_ONE, Vec3::ONE).unwrap().shadows(shadows);
        assert_eq!(FilmFile::from_bytes(&file.to_bytes()).unwrap(), file);
    }
    let with_lens = file.frame.camera.clone().with_lens(Lens::Orthographic { view_height: 30.0 });
    file.frame.camera = with_lens;
    let edge = 4;
    let map = EnvironmentMap::new(edge, &vec![Vec3::new(0.5, 0.25, 1.0); (edge * edge) as usize]).unwrap();
    file.scene.sky.set_background(Background::Environment(Environment::new(map.into(), 30.0)));
    let bytes = file.to_bytes();
    assert_eq!((bytes[8], without[8]), (4, 1), "films without cuts are as they were");
    assert_eq!(FilmFile::from_bytes(&bytes).unwrap(), file);
    // A normal that is none, under a checksum that is right.
    let x = file.scene.cuts.planes()[0].normal().x.to_le_bytes();
    let at = bytes.windows(4).position(|window| window == x).unwrap();
    let error = refused(&bytes, at, 7.0f32.to_le_bytes());
    assert!(matches!(error, FilmFileError::Damaged { what: "what cuts the scene is no plane", .. }), "{error}");
}

/// Lines of a frame, those of a grid so many voxels apart.
fn lines(spacing: u32) -> Lines {
    let line = |width: f32| Line { width, color: Vec3::new(0.5, width, 0.125) };
    Lines { edges: Some(line(0.3125)), grid: Some(GridLines { line: line(0.0625), spacing }) }
}

#[test]
fn films_of_frames_with_lines_hold_them_and_refuse_what_is_none() {
    let (mut file, without) = (example(), example().to_bytes());
    file.frame.lines = lines(7);
    let bytes = file.to_bytes();
    assert_eq!((FilmFile::from_bytes(&bytes).unwrap(), bytes.len()), (file.clone(), without.len() + 36));
    for kept in [Lines { grid: None, ..lines(7) }, Lines { edges: None, ..lines(7) }, Lines::default()] {
        file.frame.lines = kept;
        assert_eq!(FilmFile::from_bytes(&file.to_bytes()).unwrap(), file);
    }
    assert_eq!(file.to_bytes(), without, "films without lines are as they were");
    let width = bytes.windows(4).position(|window| window == 0.3125f32.to_le_bytes()).unwrap();
    for (at, value) in [(width, 1.5f32.to_le_bytes()), (width, f32::NAN.to_le_bytes()), (width + 32, [0; 4])] {
        let error = refused(&bytes, at, value).to_string();
        assert!(error.contains("lines are"), "{error}");
    }
}

#[test]
fn a_film_file_of_another_version_or_kind_says_so() {
    let mut bytes = example().to_bytes();
    bytes[8] = 9;
    let error = FilmFile::from_bytes(&bytes).unwrap_err();
    assert!(matches!(&error, FilmFileError::Format(text) if text.contains("version 9")), "{error}");
    assert!(matches!(FilmFile::from_bytes(b"VOX \x96"), Err(FilmFileError::Format(_))));
}

#[test]
fn a_film_of_another_scene_or_other_settings_is_told_apart() {
    let file = example();
    assert_eq!(file.difference(&file.frame, &file.scene), None);
    // More samples, other AOVs and another name are no difference.
    let more = file.frame.clone().samples(64).aovs(false);
    let renamed = SceneStamp { name: "b".into(), ..file.scene.clone() };
    assert_eq!(file.difference(&more, &renamed), None);

    let differs = |change: &dyn Fn(&mut Frame, &mut SceneStamp)| {
        let (mut frame, mut scene) = (file.frame.clone(), file.scene.clone());
        change(&mut frame, &mut scene);
        file.difference(&frame, &scene).unwrap()
    };
    assert_eq!(differs(&|frame, _| frame.seed = 8), "seed 7 in the film, 8 asked for");
    assert!(differs(&|_, scene| scene.content_hash = 1).starts_with("scene 0123456789abcdef"));
    assert!(differs(&|_, scene| scene.sky.set_brightness(1.0)).starts_with("sky"));
    assert!(differs(&|_, scene| scene.light_intensity = 1.0).starts_with("light intensity"));
    let cut = |_: &mut Frame, scene: &mut SceneStamp| scene.cuts = Cuts::default().plane(Vec3::Y, 2.5).unwrap();
    assert_eq!(differs(&cut), "cuts none in the film, 0,1,0,2.5 asked for");
    assert!(differs(&|frame, _| frame.camera.eye.x = 9.0).starts_with("camera"));
    assert!(differs(&|frame, _| frame.camera.fov_y = 90.0).starts_with("camera"));
    assert!(differs(&|frame, _| frame.region.x0 = 1).starts_with("crop"));
    assert!(differs(&|frame, _| frame.height = 9).starts_with("size"));
    assert!(differs(&|frame, _| frame.first_sample = 0).starts_with("first sample"));
    assert!(differs(&|frame, _| frame.max_bounces = 1).starts_with("maximum of bounces"));
    assert!(differs(&|frame, _| frame.integrator = Integrator::Essay).starts_with("integrator"));
    assert!(differs(&|frame, _| frame.transparent = false).starts_with("transparency"));
    assert!(differs(&|frame, _| frame.lines = lines(7)).starts_with("lines none in the film, edges 0.3125,0.5,0.31"));
}

#[test]
fn noise_is_removed_as_long_as_somebody_waits() {
    let scene = Arc::new(PackedScene::pack(&scenes::generate("church", Some(20_000)).unwrap()).unwrap());
    let frame = Frame::new(scene.cameras[0].clone(), 96, 54).samples(4);
    let mut tracer = CpuTracer::new(None);
    tracer.set_scene(&scene).unwrap();
    let picture = Picture::trace(&mut tracer, &scene, frame, false, &Progress::default()).unwrap().unwrap();
    let asked = AtomicU32::new(0);
    let without_noise = |most: u32| {
        asked.store(0, Ordering::Relaxed);
        let wanted = || asked.fetch_add(1, Ordering::Relaxed) < most;
        picture.clone().without_noise_while(&scene, &wanted)
    };
    let whole = without_noise(u32::MAX).unwrap();
    assert_eq!(whole.denoised(), picture.clone().without_noise(&scene).denoised());
    let times = asked.load(Ordering::Relaxed);
    // In each row of the rays that are cast anew, and of the levels of the filter.
    assert!(times > 5 * 54, "{times}");
    for most in [0, 54, times / 2, times - 1] {
        assert!(without_noise(most).is_none(), "{most} of {times}");
    }
}
