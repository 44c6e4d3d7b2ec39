//! Tiles of a scan on the command line: folders and several files as one cloud, parts of it by class and place, and what is said
//! where that cannot be.

use crate::common::{Folder, stderr};
use serde_json::Value;
use voxtrace_test_support::las_tile;

fn folder() -> Folder {
    let folder = Folder::new();
    std::fs::create_dir(folder.path("tiles")).unwrap();
    for (name, place) in [("tiles/west.las", [100, 50]), ("tiles/east.las", [108, 50])] {
        std::fs::write(folder.path(name), las_tile(place)).unwrap();
    }
    folder
}

fn voxels(folder: &Folder, arguments: &[&str]) -> u64 {
    let text = folder.succeed(&[&["info", "--json", "--voxel-size", "1m"], arguments].concat());
    serde_json::from_str::<Value>(&text).unwrap()["voxels"].as_u64().unwrap()
}

#[test]
fn a_folder_and_its_files_are_one_cloud_of_which_classes_and_boxes_choose() {
    let folder = folder();
    assert_eq!(voxels(&folder, &["tiles"]), 128);
    assert_eq!(voxels(&folder, &["tiles", "--classes", "ground,6"]), 32);
    assert_eq!(voxels(&folder, &["tiles", "--bounds", "106,-1e6,109,51"]), 8);
    assert_eq!(voxels(&folder, &["tiles", "--bounds", "106,50,-1,109,51,1", "--classes=2"]), 4);
    for budget in [&[][..], &["--memory-budget", "1kB"]] {
        let inputs = ["voxelize", "tiles/west.las", "tiles/east.las", "-o", "out.vxt", "--voxel-size", "1m"];
        folder.succeed(&[&inputs[..], &["--classes", "2"], budget].concat());
        assert_eq!(voxels(&folder, &["out.vxt"]), 16, "{budget:?}");
        std::fs::remove_file(folder.path("out.vxt")).unwrap();
    }
    folder.succeed(&["render", "tiles", "-o", "out.png", "--size", "32x18", "--spp", "1"]);
}

#[test]
fn several_tiles_are_one_scene_for_every_verb_that_reads_one() {
    let folder = folder();
    let both = ["tiles/west.las", "tiles/east.las"];
    assert_eq!((voxels(&folder, &both), voxels(&folder, &both[..1])), (128, 64));
    assert_eq!(voxels(&folder, &["tiles/west.las", "--classes", "2", "tiles/east.las"]), 16);
    folder.succeed(&[&["convert"], &both[..], &["both.vxt", "--voxel-size", "1m"]].concat());
    assert_eq!(voxels(&folder, &["both.vxt"]), 128);
    // The same picture as that of the folder, called after the first file.
    let options = ["--size", "32x18", "--spp", "1", "--voxel-size", "1m"];
    folder.succeed(&[&["render"], &both[..], &options].concat());
    folder.succeed(&[&["render", "tiles", "-o", "folder.png"], &options[..]].concat());
    folder.succeed(&[&["render", "tiles/west.las", "-o", "west_alone.png"], &options[..]].concat());
    let pixels = |name: &str| {
        let decoder = png::Decoder::new(std::io::BufReader::new(std::fs::File::open(folder.path(name)).unwrap()));
        let mut reader = decoder.read_info().unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut pixels).unwrap();
        pixels
    };
    assert_eq!(pixels("west.png"), pixels("folder.png"));
    assert_ne!(pixels("west.png"), pixels("west_alone.png"));
    // None of them is written over.
    let east = std::fs::read(folder.path(both[1])).unwrap();
    std::fs::rename(folder.path(both[1]), folder.path("east.png")).unwrap();
    let error = folder.fail(&["render", "tiles/west.las", "./east.png", "-o", "east.png"], 2);
    assert!(error.contains("hint: -o ./east.png names the picture"), "{error}");
    std::fs::rename(folder.path("east.png"), folder.path("out.vxt")).unwrap();
    folder.fail(&["convert", "tiles/west.las", "out.vxt", "out.vxt"], 4);
    assert_eq!(std::fs::read(folder.path("out.vxt")).unwrap(), east);
}

#[test]
fn a_heightmap_that_is_called_like_a_picture_is_said_to_be_none() {
    let folder = folder();
    let output = folder.run(&["convert", "tiles", "out.png", "--voxel-size", "1m"]);
    let said = stderr(&output);
    let lines = said.lines().filter(|line| line.contains("a heightmap")).count();
    assert!(output.status.success() && lines == 1 && said.contains("`voxtrace render SCENE -o PICTURE.png`"), "{said}");
    let said = stderr(&folder.run(&["convert", "tiles", "out.vxt", "--voxel-size", "1m"]));
    assert!(!said.contains("heightmap"), "{said}");
}

#[test]
fn what_cannot_be_chosen_or_joined_is_one_line_that_says_why() {
    let folder = folder();
    std::fs::write(folder.path("box.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
    for (arguments, code, wanted) in [
        (&["info", "tiles", "--bounds", "0,0,1,1"][..], 3, "they lie in the box 100,50,0,115,57,0"),
        (&["info", "tiles", "--classes", "30"], 3, "are of the classes 1, 2, 3, 4, 5, 6, 7, 8"),
        (&["info", "box.obj", "--classes", "2"], 2, "--classes chooses among points"),
        (&["info", "city", "--bounds", "0,0,1,1"], 2, "--bounds chooses among points"),
        (&["info", "tiles", "city"], 3, "cannot read city"),
        (
            &["info", "tiles", "box.obj"],
            3,
            "box.obj: several files are read as one only where all are meshes or all are LAS",
        ),
        (&["render", "tiles", "picture.png"], 2, "hint: -o picture.png names the picture"),
        (&["info", "tiles", "--classes", "house"], 2, "is no class: classes are numbers from 0 to 255, or"),
        (&["info", "tiles", "--bounds", "0,0,0,1"], 2, "is empty"),
        (
            &["voxelize", "tiles", "box.obj", "-o", "a.vxt"],
            3,
            "box.obj: several files are read as one only where all are meshes or all are LAS",
        ),
    ] {
        let error = folder.fail(arguments, code);
        assert!(error.contains(wanted) && error.trim().lines().count() <= 3, "{arguments:?}: {error}");
    }
}

#[test]
fn the_commands_of_a_plan_voxelize_tiles_to_the_bytes_of_one_process() {
    let folder = folder();
    for (name, place) in [("tiles/north.las", [102, 56]), ("tiles/over.las", [104, 52])] {
        std::fs::write(folder.path(name), las_tile(place)).unwrap();
    }
    let options = ["--voxel-size=2m", "--min-points", "2", "--classes", "1,2,3,4"];
    folder.succeed(&[&["voxelize", "tiles", "-o", "alone.vxt", "--levels", "1"], &options[..]].concat());
    let plan = [&["tiles", "plan", "tiles", "--parts", "3", "-o", "out.vxt", "--levels", "1"], &options[..]].concat();
    let plan = folder.succeed(&plan);
    let lines: Vec<Value> = plan.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let commands: Vec<Vec<&str>> = lines
        .iter()
        .map(|line| line["command"].as_array().unwrap().iter().map(|word| word.as_str().unwrap()).collect())
        .collect();
    // Points have no colours, so that heights may colour them, for which all are looked through a second time.
    let kinds: Vec<&str> = lines.iter().map(|line| line["kind"].as_str().unwrap()).collect();
    let expected = ["survey", "join", "survey", "join", "voxelize", "merge"];
    assert_eq!(kinds.chunk_by(|a, b| a == b).map(|run| run[0]).collect::<Vec<_>>(), expected);
    assert_eq!(lines.iter().filter(|line| line["stage"] == 4).count(), 3);
    for (command, line) in commands.iter().zip(&lines) {
        assert_eq!(command[0], "voxtrace");
        if line["kind"] == "merge" {
            // One part is missing.
            let at = command.iter().position(|word| word.ends_with("out.1.part")).unwrap();
            let missing = [&command[1..at - 1], &command[at + 1..]].concat();
            let missing: Vec<&str> = missing.into_iter().filter(|word| *word != "--").collect();
            assert!(folder.fail(&missing, 3).contains("are in no part"));
        }
        folder.succeed(&command[1..]);
        assert!(folder.exists(line["output"].as_str().unwrap()));
    }
    assert_eq!(folder.bytes("out.vxt"), folder.bytes("alone.vxt"));
    // Classes that are asked for are known when all points were seen.
    let once = [&["tiles", "plan", "tiles", "--parts", "3", "-o", "out.vxt", "--read-once"], &options[..]].concat();
    assert!(folder.fail(&once, 3).contains("hint: make the plan without --read-once"));
    let wrong = ["tiles", "survey", "tiles", "-o", "a.found"];
    assert!(folder.fail(&wrong, 2).contains("--files"));
    folder.fail(&[&wrong[..], &["--files", "3..9"]].concat(), 3);
    folder.fail(&[&wrong[..], &["--files", "3"]].concat(), 2);
}

#[test]
fn a_plan_that_reads_once_makes_the_same_bytes_and_is_stopped_by_a_wrong_header() {
    let folder = folder();
    let options = ["--voxel-size=0.5m", "--color-by", "classification"];
    folder.succeed(&[&["voxelize", "tiles", "-o", "alone.vxt", "--levels", "1"], &options[..]].concat());
    let plan = ["tiles", "plan", "tiles", "--parts", "2", "--read-once", "-o", "out.vxt", "--levels", "1"];
    let plan = folder.succeed(&[&plan[..], &options].concat());
    let lines: Vec<Value> = plan.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let kinds: Vec<&str> = lines.iter().map(|line| line["kind"].as_str().unwrap()).collect();
    assert_eq!(kinds, ["expect", "voxelize", "voxelize", "join", "merge"]);
    let run = |line: &Value| {
        let words: Vec<&str> = line["command"].as_array().unwrap().iter().map(|word| word.as_str().unwrap()).collect();
        folder.run(&words[1..])
    };
    for line in &lines {
        let output = run(line);
        assert!(output.status.success(), "{line}: {}", stderr(&output));
        assert!(folder.exists(line["output"].as_str().unwrap()));
    }
    assert_eq!(folder.bytes("out.vxt"), folder.bytes("alone.vxt"));
    // A header whose points are said to reach farther than they do.
    let mut bytes = folder.bytes("tiles/west.las");
    let lowest = f64::from_le_bytes(bytes[187..195].try_into().unwrap()) - 30.0;
    bytes[187..195].copy_from_slice(&lowest.to_le_bytes());
    std::fs::write(folder.path("tiles/west.las"), bytes).unwrap();
    let (merge, others) = lines.split_last().unwrap();
    assert!(others.iter().all(|line| run(line).status.success()));
    let output = run(merge);
    assert_eq!(output.status.code(), Some(3));
    assert!(stderr(&output).contains("points are not as the headers"), "{}", stderr(&output));
}

/// Four tiles of a hilly ground, in two formats, with and without colours; each ends where the next one begins.
fn ground(folder: &Folder) -> [&'static str; 4] {
    let names = ["a.obj", "b.ply", "c.obj", "d.stl"];
    let height = |x: i32, y: i32| 2.0 * (f64::from(x) * 0.7).sin() + f64::from(y) * 0.25;
    for (number, name) in names.into_iter().enumerate() {
        let (left, front) = (10 * (number as i32 % 2), 10 * (number as i32 / 2));
        let corners = |x: i32, y: i32| [(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)];
        let places = (0..100).flat_map(|at| corners(left + at % 10, front + at / 10));
        let places: Vec<(i32, i32, f64)> = places.map(|(x, y)| (x, y, height(x, y))).collect();
        let text = match name.rsplit_once('.') {
            Some((_, "obj")) => {
                let material = format!("newmtl ground\nKd 0.{} 0.5 0.2\n", number + 1);
                std::fs::write(folder.path(name).with_extension("mtl"), material).unwrap();
                let vertices: String = places.iter().map(|(x, y, z)| format!("v {x} {y} {z}\n")).collect();
                let faces = (0..100).map(|at| 4 * at + 1);
                let faces: String = faces.map(|at| format!("f {at} {} {} {}\n", at + 1, at + 2, at + 3)).collect();
                format!("mtllib {}\nusemtl ground\n{vertices}{faces}", name.replace("obj", "mtl"))
            }
            Some((_, "ply")) => {
                let colors = ["red", "green", "blue"].map(|channel| format!("property uchar {channel}\n")).concat();
                let axes = ["x", "y", "z"].map(|axis| format!("property float {axis}\n")).concat();
                let head = format!("ply\nformat ascii 1.0\nelement vertex 400\n{axes}{colors}");
                let list = "element face 100\nproperty list uchar int vertex_indices\nend_header\n";
                let vertices: String =
                    places.iter().map(|(x, y, z)| format!("{x} {y} {z} {} 90 {}\n", x * 9, y * 9)).collect();
                let faces = (0..100).map(|at| 4 * at);
                let faces: String = faces.map(|at| format!("4 {at} {} {} {}\n", at + 1, at + 2, at + 3)).collect();
                format!("{head}{list}{vertices}{faces}")
            }
            _ => {
                let facets = places.as_chunks::<4>().0.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]);
                let facet = |corners: [(i32, i32, f64); 3]| {
                    let vertices = corners.map(|(x, y, z)| format!("vertex {x} {y} {z}\n")).concat();
                    format!("facet normal 0 0 1\nouter loop\n{vertices}endloop\nendfacet\n")
                };
                format!("solid ground\n{}endsolid ground\n", facets.map(facet).collect::<String>())
            }
        };
        std::fs::write(folder.path(name), text).unwrap();
    }
    names
}

#[test]
fn meshes_of_several_files_are_one_in_memory_beyond_it_and_by_the_commands_of_a_plan() {
    let folder = Folder::new();
    let names = ground(&folder);
    let with = |words: &[&'static str], rest: &[&'static str]| [words, &names[..], rest].concat();
    // A size with a unit makes the files metres, whoever reads them.
    let options = ["--voxel-size", "11cm", "--surface", "thin", "--palette", "300"];
    let voxelize = |out: &'static str, budget: &[&'static str]| {
        folder.succeed(&[&with(&["voxelize"], &["-o", out, "--levels", "1"])[..], &options, budget].concat());
        folder.bytes(out)
    };
    let alone = voxelize("alone.vxt", &[]);
    assert_eq!(voxelize("large.vxt", &["--memory-budget", "20kB"]), alone);
    let info = |words: &[&'static str]| -> Value { serde_json::from_str(&folder.succeed(words)).unwrap() };
    let all = info(&["info", "--json", "alone.vxt"]);
    assert!(all["voxels"].as_u64().unwrap() > 30_000 && all["materials"].as_u64().unwrap() > 20, "{all}");

    let plan = with(&["tiles", "plan"], &["--parts", "3", "-o", "out.vxt", "--levels", "1"]);
    let plan = folder.succeed(&[&plan[..], &options].concat());
    let lines: Vec<Value> = plan.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let kinds: Vec<&str> = lines.iter().map(|line| line["kind"].as_str().unwrap()).collect();
    let expected = ["survey", "join", "voxelize", "merge"];
    assert_eq!(kinds.chunk_by(|a, b| a == b).map(|run| run[0]).collect::<Vec<_>>(), expected);
    assert_eq!(kinds.iter().filter(|kind| **kind == "voxelize").count(), 3);
    for line in &lines {
        let command: Vec<&str> =
            line["command"].as_array().unwrap().iter().map(|word| word.as_str().unwrap()).collect();
        if line["kind"] == "merge" {
            // Of two parts a mesh of two shares would come: these are of three.
            let at = command.iter().position(|word| word.ends_with("out.1.part")).unwrap();
            let missing = [&command[1..at - 1], &command[at + 1..]].concat();
            let missing: Vec<&str> = missing.into_iter().filter(|word| *word != "--").collect();
            let error = folder.fail(&missing, 3);
            assert!(error.contains("no part of these parts of the grid with these options"), "{error}");
        }
        folder.succeed(&command[1..]);
        assert!(folder.exists(line["output"].as_str().unwrap()));
    }
    assert_eq!(folder.bytes("out.vxt"), alone);
    let fewer = with(&["voxelize"], &["-o", "fewer.vxt", "--voxel-size", "11cm"]);
    folder.succeed(&fewer);
    assert_ne!(folder.bytes("fewer.vxt"), alone, "the comparison sees another rule");

    // What other stages are told changes nothing.
    let join = ["tiles", "join", "out.survey", "-o", "again.survey", "--files", "0..1", "--part", "x.part"];
    let said = stderr(&folder.run(&join));
    assert!(said.contains("warning: --files, --part change nothing: `tiles join` has no use for that"), "{said}");
    let survey = with(&["tiles", "survey"], &["-o", "x", "--files", "0..1", "--min-points", "2"]);
    let said = stderr(&folder.run(&survey));
    assert!(said.contains("--min-points changes nothing: a.obj is a mesh") && !said.contains("--files"), "{said}");

    // They are one scene for every verb, and what cannot be is one line.
    let counted = info(&with(&["info", "--json", "--voxel-size", "11cm"], &["--surface", "thin"]));
    assert_eq!(counted["voxels"], all["voxels"]);
    std::fs::write(folder.path("points.obj"), "v 0 0 0\nv 1 0 0\n").unwrap();
    std::fs::write(folder.path("scan.las"), las_tile([0, 0])).unwrap();
    for (arguments, code, wanted) in [
        (&["info", "a.obj", "points.obj"][..], 3, "points.obj: there is no mesh in it"),
        (&["info", "a.obj", "scan.las"], 3, "scan.las: it is no mesh"),
        (&["info", "a.obj", "none.obj"], 3, "none.obj"),
        (&["tiles", "survey", "a.obj", "b.ply", "-o", "x", "--files", "1..3"], 3, "there are no files 1..3 among 2"),
        (&["tiles", "voxelize", "a.obj", "-o", "x", "--survey", "out.survey"], 2, "--share K/N is missing"),
        (&["tiles", "voxelize", "a.obj", "-o", "x", "--survey", "out.survey", "--share", "0/2"], 3, "of other files"),
        (&["tiles", "plan", "a.obj", "-o", "x.vxt", "--parts", "2", "--fill"], 2, "--fill wants the whole mesh"),
        (&["tiles", "plan", "a.obj", "-o", "x.vxt", "--parts", "2", "--read-once"], 2, "about scans"),
        (&["tiles", "plan", "a.obj", "-o", "x.vxt", "--parts", "2", "--classes", "2"], 2, "chooses among points"),
        (&["tiles", "voxelize", "scan.las", "-o", "x", "--share", "0/2"], 2, "--share is about meshes"),
        (&["tiles", "voxelize", "a.obj", "-o", "x", "--share", "2/2"], 2, "is no share like 0/16"),
    ] {
        let error = folder.fail(arguments, code);
        assert!(error.contains(wanted) && error.trim().lines().count() <= 4, "{arguments:?}: {error}");
    }
}
