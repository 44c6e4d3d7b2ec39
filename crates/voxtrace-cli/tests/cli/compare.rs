//! Pictures side by side: `compare` tells pictures from reports, and says how much they differ and where.

use crate::common::Folder;
use serde_json::Value;

impl Folder {
    /// What `compare` says of two pictures, as JSON.
    fn compared(&self, a: &str, b: &str, options: &[&str]) -> Value {
        serde_json::from_str(&self.succeed(&[&["compare", a, b, "--json"], options].concat())).unwrap()
    }
}

#[test]
fn pictures_differ_the_less_the_more_samples_they_have_and_from_themselves_by_nothing() {
    let folder = Folder::new();
    for (name, samples, seed) in [("few.png", "2", "0"), ("more.png", "32", "0"), ("many.png", "512", "1")] {
        folder.succeed(&["render", "room.vox", "-o", name, "--size", "40x30", "--spp", samples, "--seed", seed]);
    }
    let [few, more] = ["few.png", "more.png"].map(|name| folder.compared(name, "many.png", &[]));
    let number = |json: &Value, key: &str| json[key].as_f64().unwrap();
    assert!(number(&few, "psnr_db") + 6.0 < number(&more, "psnr_db"), "{few} {more}");
    assert!(number(&few, "rmse") > 2.0 * number(&more, "rmse"), "{few} {more}");
    assert!(number(&few["flip"], "mean") > number(&more["flip"], "mean"), "{few} {more}");
    let same = folder.compared("few.png", "few.png", &[]);
    assert_eq!((same["psnr_db"].clone(), number(&same, "rmse"), number(&same["flip"], "max")), (Value::Null, 0.0, 0.0));
    assert!(folder.succeed(&["compare", "few.png", "few.png"]).contains("infinite"));
}

#[test]
fn png_exr_and_film_of_one_render_look_the_same() {
    let folder = Folder::new();
    let outputs = ["-o", "a.png", "-o", "a.exr", "-o", "a.vxf", "--exposure", "1", "--tone-map", "neutral"];
    folder.render("b.png", &outputs);
    let shown = ["--exposure", "1", "--tone-map", "neutral"];
    for other in ["a.exr", "a.vxf"] {
        // All that is left is the rounding to 8 bits.
        let psnr = folder.compared("a.png", other, &shown)["psnr_db"].as_f64().unwrap();
        assert!((55.0..65.0).contains(&psnr), "{other}: {psnr}");
        let otherwise = folder.compared("a.png", other, &[])["psnr_db"].as_f64().unwrap();
        assert!(otherwise < 40.0, "{other}: {otherwise}");
    }
    assert!(folder.compared("a.exr", "a.vxf", &[])["rmse"].as_f64().unwrap() < 1e-6);
}

#[test]
fn transparent_pictures_of_one_render_look_the_same_in_every_format() {
    let folder = Folder::new();
    // Along edges some samples of a pixel meet a voxel and some nothing; shadows on a caught ground are transparent everywhere.
    for (name, options) in [("cut", &["--transparent"][..]), ("shadow", &["--ground", "--shadow-catcher"])] {
        let [png, exr, half, film] = ["png", "exr", "half.exr", "vxf"].map(|kind| format!("{name}.{kind}"));
        folder.render(&png, &[&["-o", &film, "--bit-depth", "16"], options].concat());
        folder.succeed(&["merge", &film, "-o", &half, "--bit-depth", "16"]);
        folder.succeed(&["merge", &film, "-o", &exr]);
        assert_eq!(folder.png(&png).channels, 4);
        for other in [&exr, &half, &film] {
            let psnr = folder.compared(&png, other, &[])["psnr_db"].as_f64().unwrap();
            assert!(psnr > 55.0, "{other}: {psnr}");
        }
        assert!(folder.compared(&exr, &film, &[])["rmse"].as_f64().unwrap() < 1e-6, "{name}");
    }
}

#[test]
fn the_map_shows_where_one_changed_pixel_is() {
    let folder = Folder::new();
    let picture = folder.render("a.png", &[]);
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, 40, 30);
    encoder.set_color(png::ColorType::Rgb);
    let mut samples: Vec<u8> = picture.samples.iter().map(|&sample| sample as u8).collect();
    let changed = (12 * 40 + 25) * 3;
    let other = if samples[changed] > 127 { 0 } else { 255 };
    samples[changed..changed + 3].fill(other);
    let mut writer = encoder.write_header().unwrap();
    writer.write_image_data(&samples).unwrap();
    writer.finish().unwrap();
    std::fs::write(folder.path("b.png"), bytes).unwrap();

    assert!(folder.succeed(&["compare", "a.png", "b.png", "-o", "map.png"]).starts_with("map.png\n"));
    assert_eq!(folder.compared("a.png", "b.png", &["-o", "map.png"])["map"], "map.png");
    assert_eq!(folder.compared("a.png", "b.png", &[])["map"], Value::Null);
    let map = folder.png("map.png");
    let light = |index: usize| map.samples[3 * index..3 * index + 3].iter().sum::<u16>();
    let brightest = (0..40 * 30).max_by_key(|&index| light(index)).unwrap();
    let (x, y) = (brightest % 40, brightest / 40);
    assert!(x.abs_diff(25) <= 1 && y.abs_diff(12) <= 1, "{x}, {y}");
    assert!(light(0) < 10);
}

#[test]
fn what_cannot_be_compared_is_refused_in_one_line() {
    let folder = Folder::new();
    folder.render("a.png", &["-o", "a.vxf"]);
    folder.succeed(&["render", "room.vox", "-o", "small.png", "--size", "20x30", "--spp", "1"]);
    assert!(folder.fail(&["compare", "a.png", "small.png"], 5).contains("40x30 and 20x30"));
    assert!(folder.fail(&["compare", "a.png", "room.vox"], 3).contains("room.vox: this is no PNG, EXR or film"));
    assert!(folder.fail(&["compare", "room.vox", "a.png"], 3).contains("room.vox"));
    for pair in [["a.png", "none.png"], ["none.png", "a.png"]] {
        let line = folder.fail(&[&["compare"], &pair[..]].concat(), 3);
        assert!(line.contains("cannot read none.png: no such file or directory"), "{line}");
    }
    assert!(folder.fail(&["compare", "a.png", "a.png", "-o", "map.exr"], 2).contains(".png"));
    assert!(folder.fail(&["compare", "a.png", "a.vxf", "-o", "a.png"], 4).contains("a.png"));
    let whole = folder.bytes("a.png");
    std::fs::write(folder.path("cut.png"), &whole[..whole.len() / 2]).unwrap();
    assert!(folder.fail(&["compare", "a.png", "cut.png"], 3).contains("cut.png"));
    let film = folder.bytes("a.vxf");
    std::fs::write(folder.path("cut.vxf"), &film[..film.len() - 9]).unwrap();
    assert!(folder.fail(&["compare", "a.png", "cut.vxf"], 3).contains("cut.vxf"));
}
