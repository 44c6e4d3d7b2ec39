//! Volumes on the command line: voxelized into files, and on the way in every verb that takes a scene.

use crate::common::{Folder, SMALL, stderr};

/// A block of 3 × 4 × 2 samples of 700 in a volume of 6 × 8 × 4, 2 mm apart.
fn write_block(folder: &Folder) {
    let header =
        "NDims = 3\nDimSize = 6 8 4\nElementType = MET_SHORT\nElementSpacing = 2 2 2\nElementDataFile = block.raw\n";
    std::fs::write(folder.path("block.mhd"), header).unwrap();
    let value = |n: usize| {
        let (x, y, z) = (n % 6, n / 6 % 8, n / 48);
        if (1..4).contains(&x) && (2..6).contains(&y) && (1..3).contains(&z) { 700i16 } else { -1000 }
    };
    let bytes: Vec<u8> = (0..6 * 8 * 4).flat_map(|n| value(n).to_le_bytes()).collect();
    std::fs::write(folder.path("block.raw"), bytes).unwrap();
}

#[test]
fn every_verb_that_takes_a_scene_takes_a_volume() {
    let folder = Folder::new();
    write_block(&folder);
    let text = folder.succeed(&["info", "block.mhd", "--transfer", "ct-bone"]);
    assert!(text.contains("3 x 4 x 2 voxels of 2 mm"), "{text}");
    folder.succeed(&[&["render", "block.mhd", "--transfer", "ct-skin", "-o", "block.png"], &SMALL[..]].concat());
    assert!(folder.path("block.png").is_file());
    folder.succeed(&["voxelize", "block.mhd", "-o", "block.vxt", "--transfer", "ct-bone"]);
    assert_eq!(folder.succeed(&["info", "block.vxt"]), text.replace("block.mhd", "block.vxt"));
    let output = folder.run(&["info", "block.mhd", "--transfer", "ct-bone", "--threshold", "900"]);
    assert!(stderr(&output).contains("no sample is to be seen"), "{}", stderr(&output));
}

/// Labels 3 (a corner of the block) and 5 (a lump beside it) on the lattice of [`write_block`], `shift` samples farther along x.
fn write_labels(folder: &Folder, name: &str, shift: i32) {
    let header = format!(
        "NDims = 3\nDimSize = 6 8 4\nOffset = {} 0 0\nElementType = MET_UCHAR\nElementSpacing = 2 2 2\nElementDataFile = {name}.raw\n",
        2 * shift
    );
    std::fs::write(folder.path(&format!("{name}.mhd")), header).unwrap();
    let value = |n: usize| match (n % 6, n / 6 % 8, n / 48) {
        (1, 2, 1 | 2) => 3,
        (5, 6 | 7, 3) => 5,
        _ => 0u8,
    };
    std::fs::write(folder.path(&format!("{name}.raw")), (0..6 * 8 * 4).map(value).collect::<Vec<_>>()).unwrap();
}

#[test]
fn labels_and_a_second_volume_lie_over_a_scan_in_colours_of_their_own() {
    let folder = Folder::new();
    write_block(&folder);
    write_labels(&folder, "labels", 0);
    std::fs::write(folder.path("lut.txt"), "#No. Label Name: R G B A\n3 corner 255 0 0 0\n5 lump 0 0 255 0\n").unwrap();
    std::fs::write(folder.path("some.csv"), "value,color,opacity\n5,#0000ff,0.5\n").unwrap();
    let scan = ["voxelize", "block.mhd", "-o", "a.vxt", "--transfer", "ct-bone"];
    let scene = |options: &[&str]| {
        let output = folder.run(&[&scan[..], options].concat());
        assert!(output.status.success(), "{}", stderr(&output));
        let scene = voxtrace::import::open(&folder.path("a.vxt"), &voxtrace::import::ImportOptions::default()).unwrap();
        let colors: Vec<_> = scene.grids[0].voxels().map(|(_, at)| scene.materials[usize::from(at)]).collect();
        let red = colors.iter().filter(|material| material.base_color == voxtrace::glam::Vec3::X).count();
        let blue: Vec<_> = colors.iter().filter(|material| material.base_color == voxtrace::glam::Vec3::Z).collect();
        let clear = blue.iter().filter(|material| material.transmission == 0.5).count();
        ([colors.len(), red, blue.len(), clear], stderr(&output))
    };
    let (bare, _) = scene(&[]);
    assert_eq!(bare[1..], [0; 3]);
    let (found, said) = scene(&["--labels", "labels.mhd", "--label-colors", "lut.txt"]);
    assert_eq!(found, [bare[0] + 2, 2, 2, 0], "{said}");
    assert!(said.contains("2 labels of labels in the colours of lut.txt"), "{said}");
    let (found, said) = scene(&["--labels", "labels.mhd", "--label-colors", "some.csv"]);
    assert_eq!(found, [bare[0] + 2, 0, 2, 2], "{said}");
    assert!(said.contains("1 without a colour are not shown"), "{said}");
    // Its own colours, and a second volume below the labels, which are mixed with it.
    let (found, said) = scene(&["--labels", "labels.mhd"]);
    assert_eq!(found, [bare[0] + 2, 0, 0, 0], "{said}");
    let second = ["--overlay", "block.mhd", "--overlay-transfer", "mri", "--labels", "labels.mhd"];
    let (found, said) = scene(&[&second[..], &["--label-colors", "lut.txt", "--label-opacity", "0.5"]].concat());
    assert_eq!((found[1], found[2], found[3]), (0, 2, 2), "the corner is mixed with what it lies over: {said}");
    // The label map alone, with the same table.
    let alone = folder.succeed(&["info", "labels.mhd", "--label-colors", "lut.txt"]);
    let says = |what: &str, count: &str| alone.lines().any(|line| line.starts_with(what) && line.ends_with(count));
    assert!(says("voxels  ", " 4") && says("materials  ", " 2"), "{alone}");
}

#[test]
fn what_cannot_lie_over_a_scan_is_one_clear_error() {
    let folder = Folder::new();
    write_block(&folder);
    write_labels(&folder, "labels", 0);
    write_labels(&folder, "away", 6);
    std::fs::write(folder.path("lut.txt"), "9 other 255 0 0 0\n").unwrap();
    std::fs::write(folder.path("broken.csv"), "3,#ff0000\n5,blue\n").unwrap();
    std::fs::write(folder.path("stops.toml"), "[[stop]]\nvalue = 1\ncolor = \"#ffffff\"\n").unwrap();
    for (code, options, said) in [
        (3, &["--labels", "away.mhd"][..], "away lies beside block"),
        (2, &["--label-colors", "lut.txt"], "--label-colors and --transfer both say"),
        (3, &["--labels", "missing.nrrd"], "cannot read missing.nrrd"),
        (3, &["--labels", "room.vox"], "room.vox holds no volume"),
        (3, &["--labels", "labels.mhd", "--label-colors", "lut.txt"], "has none of the labels of labels: 3, 5"),
        (3, &["--labels", "labels.mhd", "--label-colors", "broken.csv"], "expected value,#rrggbb"),
        (3, &["--labels", "labels.mhd", "--label-colors", "stops.toml"], "stops, but no labels"),
        (3, &["--labels", "labels.mhd", "--label-colors", "none.csv"], "cannot read none.csv"),
        (2, &["--labels", "labels.mhd", "--label-opacity", "1.5"], "not from 0 to 1"),
        (3, &["--overlay", "labels.mhd", "--overlay-threshold", "9"], "nothing of labels is to be seen"),
        (3, &["--overlay", "labels.mhd", "--overlay-transfer", "cold"], "cold"),
        (2, &["--overlay-opacity", "0.5"], "--overlay"),
    ] {
        let output = folder.run(&[&["info", "block.mhd", "--transfer", "ct-bone"][..], options].concat());
        let text = stderr(&output);
        assert!(output.status.code() == Some(code) && text.contains(said), "{options:?}: {text}");
        assert!(text.lines().filter(|line| line.starts_with("error")).count() == 1, "{text}");
    }
    for scene in ["room.vox", "room.vxt", "church"] {
        let output = folder.run(&["info", scene, "--labels", "labels.mhd"]);
        assert!(output.status.code() == Some(2) && stderr(&output).contains("--labels needs a volume"), "{scene}");
    }
}

/// A NumPy array of bytes or words.
fn write_array(folder: &Folder, name: &str, kind: &str, shape: &str, bytes: &[u8]) {
    let mut header = format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': ({shape}), }}");
    header += &" ".repeat(117 - header.len());
    let head = [&b"\x93NUMPY\x01\0"[..], &118u16.to_le_bytes(), header.as_bytes(), b"\n"].concat();
    std::fs::write(folder.path(name), [&head, bytes].concat()).unwrap();
}

#[test]
fn a_time_point_a_channel_or_all_colours_are_read_as_options_say() {
    let folder = Folder::new();
    // Two time points of 5 x 5 x 5: the first has one place, the second two.
    let mut bytes = [0u8; 250];
    (bytes[21], bytes[125 + 21], bytes[125 + 42]) = (200, 200, 200);
    write_array(&folder, "series.npy", "|u1", "2, 5, 5, 5", &bytes);
    let voxels = |options: &[&str]| {
        let output = folder
            .run(&[&["info", "series.npy", "--json", "--transfer", "surface", "--threshold", "100"], options].concat());
        let json: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        (json["voxels"].as_u64().unwrap(), stderr(&output).contains("the first of 2 time points"))
    };
    assert_eq!((voxels(&[]), voxels(&["--time", "1"]), voxels(&["--time", "2"])), ((1, true), (1, false), (2, false)));
    assert_eq!(voxels(&["--channel", "2"]), (2, false));
    let message = folder.fail(&["info", "series.npy", "--time", "3"], 3);
    assert!(message.contains("no time point 3: there are 2, counted from 1 on"), "{message}");
    // Colours are those of the file, or those of the transfer function that is named.
    let pixel = [250u8, 20, 10];
    write_array(&folder, "colors.npy", "|u1", "4, 4, 4, 3", &pixel.repeat(64));
    let colors = |options: &[&str]| {
        folder.succeed(&[&["voxelize", "colors.npy", "-o", "colors.vxt", "--threshold", "1"], options].concat());
        let scene = voxtrace::import::open(&folder.path("colors.vxt"), &Default::default()).unwrap();
        let material = scene.grids[0].voxels().next().unwrap().1;
        scene.materials[usize::from(material)].base_color.to_array().map(voxtrace::material::srgb_from_linear)
    };
    assert_eq!(colors(&[]), pixel);
    assert_ne!(colors(&["--transfer", "mri"]), pixel);
}

#[test]
fn a_ct_that_is_not_in_hounsfield_units_is_told_before_it_is_a_box() {
    let folder = Folder::new();
    let value = |n: usize| if (n % 16).abs_diff(8) < 4 && (n / 16 % 16).abs_diff(8) < 4 { 1064u16 } else { 24 };
    let bytes: Vec<u8> = (0..4096).flat_map(|n| value(n).to_le_bytes()).collect();
    write_array(&folder, "ct.npy", "<u2", "16, 16, 16", &bytes);
    let said =
        |options: &[&str]| stderr(&folder.run(&[&["info", "ct.npy", "--transfer", "ct-skin"], options].concat()));
    let text = said(&[]);
    assert!(text.contains("hardly Hounsfield units") && text.contains("--threshold 724"), "{text}");
    assert!(!said(&["--threshold", "724"]).contains("Hounsfield"));
}

#[test]
fn options_about_something_of_another_kind_are_told_to_change_nothing() {
    let folder = Folder::new();
    write_block(&folder);
    std::fs::write(folder.path("a.obj"), "v 0 0 0\nv 4 0 0\nv 0 4 1\nf 1 2 3\n").unwrap();
    std::fs::write(folder.path("a.xyz"), "0 0 0\n10 0 0\n0 10 0\n").unwrap();
    let nrrd = b"NRRD0004\ntype: uchar\ndimension: 3\nsizes: 3 2 2\nencoding: raw\n\n\x09\x09\x09\x09\x09\x09\x09\x09\x09\x09\x09\x09";
    std::fs::write(folder.path("a.nrrd"), nrrd).unwrap();
    let told = |options: &[&str]| stderr(&folder.run(&[&["info"], options].concat()));
    let small = ["--resolution", "8"];
    for (name, options, expected) in [
        ("a.obj", &["--transfer", "ct-bone"][..], "--transfer changes nothing: a.obj is a mesh"),
        ("a.obj", &["--shell", "false"], "--shell changes nothing: a.obj is a mesh"),
        ("a.obj", &["--series", "2", "--min-points", "3"], "--min-points, --series change nothing: a.obj is a mesh"),
        ("a.xyz", &["--threshold", "5", "--fill"], "--fill, --threshold change nothing: a.xyz holds points"),
        ("a.nrrd", &["--series", "2"], "--series changes nothing: a.nrrd (NRRD) has none to choose from"),
        (
            "block.mhd",
            &["--surface", "thin", "--color-by", "rgb"],
            "--surface, --color-by change nothing: block.mhd is a volume",
        ),
    ] {
        let said = told(&[&[name], &small[..], options].concat());
        assert!(said.lines().any(|line| line == format!("warning: {expected}")), "{name} {options:?}: {said}");
        assert!(!told(&[&[name], &small[..]].concat()).contains("nothing"), "{name}");
    }
    // Those that choose something are not among them, also where there is only one.
    assert!(!told(&["a.nrrd", "--channel", "1", "--time", "1", "--shell", "true"]).contains("nothing"));
    // What stays in its file says the same.
    let large = ["voxelize", "block.mhd", "-o", "block.vxt", "--memory-budget", "1", "--series", "4", "--fill"];
    let said = stderr(&folder.run(&large));
    assert!(said.contains("--series changes nothing: block.mhd (MetaImage)"), "{said}");
}
