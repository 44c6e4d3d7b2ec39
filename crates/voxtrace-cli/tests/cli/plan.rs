//! `plan`: commands whose films add up to the picture of one run.

use crate::common::{Folder, stderr};
use serde_json::Value;

fn lines(text: &str) -> Vec<Value> {
    text.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
}

fn words(line: &Value) -> Vec<String> {
    line["command"].as_array().unwrap().iter().map(|word| word.as_str().unwrap().to_owned()).collect()
}

#[test]
fn the_commands_of_a_plan_make_the_picture_of_one_run() {
    let folder = Folder::new();
    let options =
        ["-q", "--size=24x14", "--traversal", "cpu", "--eye", "-20,-30,25", "--exposure", "-1", "--seed", "3"];
    let whole = [&["render", "room.vox"], &options[..], &["--samples", "10", "-o", "whole.png", "-o", "whole.vxf"]];
    folder.succeed(&whole.concat());
    let planned = [&["plan", "--parts", "4", "room.vox"], &options[..], &["--samples", "10", "-oa.png", "-o", "a.vxf"]];
    let plan = lines(&folder.succeed(&planned.concat()));
    assert_eq!(plan.len(), 5);
    let mut next = 0;
    for part in &plan[..4] {
        assert_eq!((part["kind"].as_str(), part["first_sample"].as_u64()), (Some("part"), Some(next)));
        next += part["samples"].as_u64().unwrap();
        let command = words(part);
        // A film knows no exposure.
        assert!(!command.iter().any(|word| word == "--exposure" || word == "-1"), "{command:?}");
        assert_eq!(
            (&command[..2], command.last().unwrap().as_str()),
            (&["voxtrace".into(), "render".into()][..], "room.vox")
        );
        folder.succeed(&command[1..].iter().map(String::as_str).collect::<Vec<_>>());
        assert!(folder.exists(part["film"].as_str().unwrap()));
    }
    assert_eq!((next, plan[3]["film"].as_str()), (10, Some("a-part-3.vxf")));
    let merge = words(&plan[4]);
    let merge: Vec<&str> = merge[1..].iter().map(String::as_str).collect();
    assert!(merge.windows(2).any(|pair| pair == ["--exposure", "-1"]), "{merge:?}");
    // Without one part it is no picture.
    assert!(merge.contains(&"a-part-1.vxf"));
    let missing: Vec<&str> = merge.iter().copied().filter(|word| *word != "a-part-1.vxf").collect();
    folder.fail(&missing, 5);
    folder.succeed(&merge);
    for kind in ["png", "vxf"] {
        assert_eq!(folder.bytes(&format!("a.{kind}")), folder.bytes(&format!("whole.{kind}")), "{kind}");
    }
}

#[test]
fn what_cannot_be_made_in_parts_is_said() {
    let folder = Folder::new();
    for option in [&["--denoise"][..], &["--noise", "0.1"], &["--time-limit", "3s"], &["--checkpoint", "c.vxf"]] {
        let said = folder.fail(&[&["plan", "room.vox", "--parts", "3"], option].concat(), 2);
        assert!(said.contains(option[0]) && said.contains("hint"), "{said}");
    }
    assert!(folder.fail(&["plan", "room.vox", "--parts", "3", "--turntable=8"], 2).contains("one picture"));
    assert_eq!(lines(&folder.succeed(&["plan", "room.vox", "--parts", "64", "--spp", "3"])).len(), 4, "three parts");
    let one = stderr(&folder.run(&["plan", "room.vox", "--parts", "64", "--spp", "1"]));
    assert!(one.contains("warning: 1 part: there are no more samples"), "{one}");
}
