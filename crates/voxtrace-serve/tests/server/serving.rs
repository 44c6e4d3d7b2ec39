//! What the server gives.

use crate::client::{exchange, get, get_with, head};
use crate::{Running, city, files_below};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::SystemTime;
use voxtrace::PackedScene;

#[test]
fn a_folder_is_listed_with_its_scenes_and_nothing_else() {
    let running = Running::start(|_| ());
    let list: serde_json::Value = serde_json::from_slice(&get(running.address, "/api/list").body).unwrap();
    let names = |of: &str| {
        let mut names: Vec<&str> =
            list[of].as_array().unwrap().iter().map(|entry| entry["name"].as_str().unwrap()).collect();
        names.sort_unstable();
        names
    };
    // Links that lead out are not listed.
    assert_eq!(names("scenes"), ["damaged.vox", "scene.vxt"]);
    assert_eq!(names("folders"), ["inner"]);
}

#[cfg(unix)]
#[test]
fn links_are_listed_where_they_lead_to_what_is_given() {
    use std::os::unix::fs::symlink;
    let running = Running::start(|_| ());
    let folder = running.folder();
    fs::write(folder.join("inner/data"), "no scene").unwrap();
    symlink(folder.join("scene.vxt"), folder.join("inner/link.vxt")).unwrap();
    symlink("..", folder.join("inner/up")).unwrap();
    symlink("../..", folder.join("inner/out")).unwrap();
    symlink("../.hidden/secret.vox", folder.join("inner/shown.vox")).unwrap();
    symlink("../.hidden", folder.join("inner/shown")).unwrap();
    symlink("data", folder.join("inner/data.vox")).unwrap();
    symlink("none.vox", folder.join("inner/dangling.vox")).unwrap();
    let list: serde_json::Value = serde_json::from_slice(&get(running.address, "/api/list/inner").body).unwrap();
    for (kind, expected) in [("scenes", vec!["copy of it.vxt", "link.vxt"]), ("folders", vec!["up"])] {
        let mut names: Vec<&str> =
            list[kind].as_array().unwrap().iter().map(|entry| entry["name"].as_str().unwrap()).collect();
        names.sort_unstable();
        assert_eq!(names, expected);
    }
    assert_eq!(get(running.address, "/api/info/inner/link.vxt").status, 200);
    assert_eq!(get(running.address, "/api/list/inner/up").status, 200);
}

#[test]
fn facts_of_a_scene_are_those_of_its_file_and_a_damaged_one_says_why() {
    let running = Running::start(|_| ());
    let info: serde_json::Value = serde_json::from_slice(&get(running.address, "/api/info/scene.vxt").body).unwrap();
    let scene = PackedScene::open(&running.folder().join("scene.vxt")).unwrap();
    assert_eq!(info["voxels"], scene.statistics().voxels);
    assert_eq!(info["content_hash"], format!("{:016x}", scene.content_hash()));
    assert_eq!(info["fits_pages"], true);
    let damaged = get(running.address, "/api/info/damaged.vox");
    assert_eq!(damaged.status, 422);
    let text = damaged.text();
    assert!(text.contains("damaged.vox") && !text.contains(running.folder().to_str().unwrap()), "{text}");
    // Once it is mended it is read again.
    fs::remove_file(running.folder().join("damaged.vox")).unwrap();
    assert_eq!(get(running.address, "/api/info/damaged.vox").status, 404);
    city(9000).save(&running.folder().join("damaged.vxt")).unwrap();
    fs::rename(running.folder().join("damaged.vxt"), running.folder().join("damaged.vox")).unwrap();
    assert_eq!(get(running.address, "/api/info/damaged.vox").status, 200);
}

/// The thumbnails that are kept.
fn pictures(running: &Running) -> Vec<PathBuf> {
    let mut files = files_below(&running.cache().join("thumbnails"));
    files.retain(|path| path.extension().is_some_and(|extension| extension == "jpg"));
    files
}

#[test]
fn thumbnails_are_pictures_of_scenes_and_kept_by_what_files_hold() {
    let running = Running::start(|_| ());
    let first = get(running.address, "/api/thumbnail/scene.vxt");
    assert_eq!((first.status, first.header("content-type")), (200, Some("image/jpeg")));
    assert!(first.body.starts_with(&[0xFF, 0xD8]) && first.body.len() > 4000, "{} bytes", first.body.len());
    let kept = pictures(&running);
    assert_eq!(kept.len(), 1);
    // The copy has the same one; another scene has another.
    assert_eq!(get(running.address, "/api/thumbnail/inner/copy%20of%20it.vxt").body, first.body);
    assert_eq!(pictures(&running), kept);
    city(9000).save(&running.folder().join("other.vxt")).unwrap();
    assert_ne!(get(running.address, "/api/thumbnail/other.vxt").body, first.body);
    assert_eq!(pictures(&running).len(), 2);
    let damaged = get(running.address, "/api/thumbnail/damaged.vox");
    assert!(damaged.status == 422 && damaged.text().contains("damaged.vox"), "{}", damaged.text());
}

/// Writes a mesh of one triangle, and beside it its colour, both at the same time of the clock.
fn write_triangle(folder: &Path, color: &str) {
    fs::create_dir_all(folder).unwrap();
    let mesh = "mtllib colours.mtl\nusemtl it\nv 0 0 0\nv 1 0 0\nv 0 1 0.5\nf 1 2 3\n";
    for (name, text) in [("mesh.obj", mesh), ("colours.mtl", &format!("newmtl it\nKd {color}\n"))] {
        fs::write(folder.join(name), text).unwrap();
        let file = fs::File::options().write(true).open(folder.join(name)).unwrap();
        file.set_modified(SystemTime::UNIX_EPOCH).unwrap();
    }
}

#[test]
fn thumbnails_show_also_what_lies_beside_a_file() {
    let running = Running::start(|_| ());
    write_triangle(&running.folder().join("red"), "1 0 0");
    write_triangle(&running.folder().join("blue"), "0 0 1");
    let [red, blue] = ["red", "blue"].map(|name| get(running.address, &format!("/api/thumbnail/{name}/mesh.obj")));
    assert_eq!((red.status, blue.status), (200, 200));
    assert!(red.body != blue.body, "the files of the same name are the same, those beside them are not");
    fs::write(running.folder().join("red/colours.mtl"), "newmtl it\nKd 0 1 0\n").unwrap();
    let green = get(running.address, "/api/thumbnail/red/mesh.obj");
    assert!(green.body != red.body && green.body != blue.body, "another colour");
    write_triangle(&running.folder().join("red"), "1 0 0");
    fs::write(running.folder().join("red/notes.txt"), "none of the scene's").unwrap();
    assert!(get(running.address, "/api/thumbnail/red/mesh.obj").body == red.body);
    assert_eq!(pictures(&running).len(), 3, "a picture for each scene");
}

fn content_hash(running: &Running, name: &str) -> String {
    let answer = get(running.address, &format!("/api/info/{name}"));
    assert_eq!(answer.status, 200, "{name}: {}", answer.text());
    let info: serde_json::Value = serde_json::from_slice(&answer.body).unwrap();
    info["content_hash"].as_str().unwrap().to_owned()
}

#[test]
fn scenes_are_read_again_when_files_change_that_lie_beside_theirs() {
    let running = Running::start(|_| ());
    let folder = running.folder();
    write_triangle(&folder, "1 0 0");
    let red = content_hash(&running, "mesh.obj");
    assert_eq!(content_hash(&running, "mesh.obj"), red);
    fs::write(folder.join("colours.mtl"), "newmtl it\nKd 0 0 1\n").unwrap();
    assert_ne!(content_hash(&running, "mesh.obj"), red);
    fs::remove_file(folder.join("colours.mtl")).unwrap();
    let plain = content_hash(&running, "mesh.obj");
    write_triangle(&folder, "1 0 0");
    assert!(plain != red && content_hash(&running, "mesh.obj") == red);
}

#[test]
fn what_lacked_a_file_is_read_once_it_is_there() {
    let running = Running::start(|_| ());
    let folder = running.folder();
    let header = "NDims = 3\nDimSize = 4 4 4\nElementType = MET_UCHAR\nElementDataFile = scan.raw\n";
    fs::write(folder.join("scan.mhd"), header).unwrap();
    let lacking = get(running.address, "/api/info/scan.mhd");
    assert!(lacking.status == 422 && lacking.text().contains("scan.raw"), "{}", lacking.text());
    assert_eq!(get(running.address, "/api/thumbnail/scan.mhd").status, 422);
    let samples: Vec<u8> = (0..64).map(|at| if at % 4 < 2 { 0 } else { 200 }).collect();
    fs::write(folder.join("scan.raw"), samples).unwrap();
    content_hash(&running, "scan.mhd");
    assert_eq!(get(running.address, "/api/thumbnail/scan.mhd").status, 200);
}

#[test]
fn a_folder_of_slices_is_read_again_when_one_of_them_changes() {
    let running = Running::start(|_| ());
    let write_slice = |number: u8, first: u8| {
        let file = fs::File::create(running.folder().join(format!("inner/slice{number}.png"))).unwrap();
        let mut encoder = png::Encoder::new(file, 4, 4);
        encoder.set_color(png::ColorType::Grayscale);
        let samples: Vec<u8> = (0..16).map(|at| if at % 4 < 2 { first } else { 200 }).collect();
        encoder.write_header().unwrap().write_image_data(&samples).unwrap();
    };
    for number in 0..4 {
        write_slice(number, 0);
        // The clock of files may stand for a while.
        let file = fs::File::options().write(true).open(running.folder().join(format!("inner/slice{number}.png")));
        file.unwrap().set_modified(SystemTime::UNIX_EPOCH).unwrap();
    }
    let before = content_hash(&running, "inner");
    write_slice(2, 200);
    let changed = content_hash(&running, "inner");
    write_slice(4, 0);
    let longer = content_hash(&running, "inner");
    assert!(before != changed && changed != longer);
}

#[test]
fn a_folder_that_is_called_like_a_file_is_a_folder() {
    let running = Running::start(|_| ());
    let folder = running.folder().join("slices.vox");
    fs::create_dir(&folder).unwrap();
    for number in 0..3 {
        let file = fs::File::create(folder.join(format!("{number}.png"))).unwrap();
        let mut encoder = png::Encoder::new(file, 4, 4);
        encoder.set_color(png::ColorType::Grayscale);
        encoder.write_header().unwrap().write_image_data(&[200; 16]).unwrap();
    }
    let answer = get(running.address, "/api/info/slices.vox");
    let info: serde_json::Value = serde_json::from_slice(&answer.body).unwrap();
    assert_eq!((info["format"].as_str(), &info["file_bytes"]), (Some("folder"), &serde_json::Value::Null));
    let scene = get(running.address, "/api/packed/slices.vox");
    assert_eq!((scene.status, get(running.address, "/files/slices.vox").status), (200, 404));
}

#[test]
fn a_scene_for_pages_is_the_file_packed_whatever_its_format() {
    let running = Running::start(|_| ());
    let triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0.5\nf 1 2 3\n";
    fs::write(running.folder().join("triangle.obj"), triangle).unwrap();
    let answer = get(running.address, "/api/packed/triangle.obj");
    assert_eq!(answer.status, 200, "{}", answer.text());
    let scene = PackedScene::from_bytes(&answer.body).unwrap();
    assert!(scene.statistics().voxels > 1000);
    let again = PackedScene::from_bytes(&get(running.address, "/api/packed/scene.vxt").body).unwrap();
    assert_eq!(again.content_hash(), PackedScene::open(&running.folder().join("scene.vxt")).unwrap().content_hash());
}

#[test]
fn files_come_in_parts_of_one_version() {
    let running = Running::start(|_| ());
    let address = running.address;
    let path = running.folder().join("scene.vxt");
    let bytes = fs::read(&path).unwrap();
    let whole = get(address, "/files/scene.vxt");
    assert!(whole.body == bytes);
    assert_eq!(whole.header("accept-ranges"), Some("bytes"));
    let tag = whole.header("etag").unwrap().to_owned();
    let part = get_with(address, "/files/scene.vxt", &["range: bytes=100-199", &format!("if-range: {tag}")]);
    assert_eq!((part.status, part.body.as_slice()), (206, &bytes[100..200]));
    assert_eq!(part.header("content-range"), Some(&*format!("bytes 100-199/{}", bytes.len())));
    let last = get_with(address, "/files/scene.vxt", &["range: bytes=-10"]);
    assert_eq!((last.status, last.body.as_slice()), (206, &bytes[bytes.len() - 10..]));
    assert_eq!(get_with(address, "/files/scene.vxt", &["range: bytes=99999999-"]).status, 416);
    assert_eq!(get_with(address, "/files/scene.vxt", &[&format!("if-none-match: {tag}")]).status, 304);
    // Of a part only GET knows (RFC 9110, section 14.2).
    let asked = exchange(address, head("HEAD", "/files/scene.vxt", address, &["range: bytes=100-199"]).as_bytes());
    assert_eq!((asked.status, asked.header("content-range"), asked.body.len()), (200, None, 0));
    assert_eq!(asked.header("content-length"), Some(&*bytes.len().to_string()));
    // Another version comes whole, whatever part of the old one is asked for.
    city(9000).save(&path).unwrap();
    let other = get_with(address, "/files/scene.vxt", &["range: bytes=100-199", &format!("if-range: {tag}")]);
    assert!(other.status == 200 && other.body == fs::read(&path).unwrap());
    assert_ne!(other.header("etag").unwrap(), tag);
}

#[test]
fn scenes_are_read_once_and_forgotten_when_there_is_no_room() {
    let folder = tempfile::tempdir().unwrap();
    let scene = city(20_000);
    let bytes = scene.statistics().total_bytes();
    let running = Running::start(|settings| {
        for number in 0..6 {
            scene.save(&settings.folder.join(format!("{number}.vxt"))).unwrap();
        }
        settings.limits.memory = bytes * 2;
    });
    drop(folder);
    for round in 0..2 {
        for number in 0..6 {
            assert_eq!(get(running.address, &format!("/api/info/{number}.vxt")).status, 200, "round {round}");
        }
    }
    let scene = Arc::new(scene);
    assert_eq!(Arc::strong_count(&scene), 1);
}
