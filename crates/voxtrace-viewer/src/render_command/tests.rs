//! Lines are read back as the shell and `render` do, and compared with the view that they were made of.

use super::quoted;
use super::*;
#[cfg(unix)]
use std::process::Command;
use voxtrace::lines::{GridLines, Line};

/// The words that a shell makes of a line.
#[cfg(unix)]
fn shell_words(line: &str) -> Vec<String> {
    let output = Command::new("sh").args(["-c", &format!("printf '%s\\0' {line}")]).output().unwrap();
    assert!(output.status.success());
    let text = String::from_utf8(output.stdout).unwrap();
    text.strip_suffix('\0').unwrap().split('\0').map(str::to_owned).collect()
}

fn numbers(text: &str) -> Vec<f32> {
    text.split(',').map(|number| number.parse().unwrap()).collect()
}

fn vector_of(text: &str) -> Vec3 {
    Vec3::from_slice(&numbers(text))
}

/// The view that the words of a command ask for, in a scene whose own camera is `usual`.
fn parsed(words: &[String], usual: Option<Camera>) -> RenderCommand {
    assert_eq!(words[..2], ["voxtrace", "render"]);
    let scene = match scenes::NAMES.contains(&words[2].as_str()) {
        true => SceneArgument::BuiltIn { name: words[2].clone(), voxels: None },
        false => SceneArgument::File(words[2].clone().into()),
    };
    let camera = usual.clone().unwrap_or(Camera::look_at(Vec3::ZERO, Vec3::ZERO));
    let mut view = RenderCommand { usual_camera: usual, ..RenderCommand::new(scene, camera) };
    let mut has_bounces = false;
    let mut rest = words[3..].iter();
    while let Some(word) = rest.next() {
        let (option, glued) =
            word.split_once('=').map_or((word.as_str(), None), |(option, value)| (option, Some(value)));
        let mut value = || glued.map(str::to_owned).unwrap_or_else(|| rest.next().unwrap().clone());
        match option {
            "--voxels" => {
                let SceneArgument::BuiltIn { voxels, .. } = &mut view.scene else { panic!("a file has no size") };
                *voxels = Some(value().parse().unwrap());
            }
            "--output" => view.outputs.push(value().into()),
            "--eye" => view.camera.eye = vector_of(&value()),
            "--target" => view.camera.target = vector_of(&value()),
            "--up" => view.camera.up = vector_of(&value()),
            "--fov" => view.camera.fov_y = value().parse().unwrap(),
            "--size" => {
                let size = value();
                let (width, height) = size.split_once('x').unwrap();
                view.size = (width.parse().unwrap(), height.parse().unwrap());
            }
            "--spp" => view.samples = value().parse().unwrap(),
            "--seed" => view.seed = value().parse().unwrap(),
            "--integrator" => {
                assert_eq!(value(), "essay");
                view.integrator = Integrator::Essay;
            }
            "--max-bounces" => (view.max_bounces, has_bounces) = (value().parse().unwrap(), true),
            "--diffuse-bounces" => view.bounce_limits.diffuse = value().parse().unwrap(),
            "--glossy-bounces" => view.bounce_limits.glossy = value().parse().unwrap(),
            "--transmitted-bounces" => view.bounce_limits.transmitted = value().parse().unwrap(),
            "--volume-bounces" => view.bounce_limits.volume = value().parse().unwrap(),
            "--clamp-indirect" => view.clamp_indirect = Some(value().parse().unwrap()),
            "--transparent" => view.transparent = true,
            "--exposure" => view.tone_map.exposure = value().parse().unwrap(),
            "--tone-map" => {
                let name = value();
                let named = voxtrace::output::Operator::ALL.into_iter().find(|operator| operator.name() == name);
                view.tone_map.operator = named.unwrap();
            }
            "--sky-brightness" => view.sky_brightness = Some(value().parse().unwrap()),
            "--sky-color" => view.sky = Some(SkySetting::Color(vector_of(&value()))),
            "--sky" => {
                let sky = value();
                let is_physical = sky == "physical";
                view.sky = Some(if is_physical { SkySetting::Physical } else { SkySetting::Panorama(sky.into()) });
            }
            "--sky-rotation" => view.sky_rotation = Some(value().parse().unwrap()),
            "--sun" => {
                let sun = numbers(&value());
                let strength = sun.get(2).copied().unwrap_or(3.0);
                view.sun = Some(SunSetting { bearing: sun[0], height: sun[1], strength });
            }
            "--sun-disc" => view.sun_disc = Some(value() == "visible"),
            "--light-intensity" => view.light_intensity = Some(value().parse().unwrap()),
            "--clip-box" => {
                let box_ = numbers(&value());
                view.cutting.clip_box = Some([Vec3::from_slice(&box_[..3]), Vec3::from_slice(&box_[3..])]);
            }
            "--slice" => {
                let slice = value();
                let (axis, place) = slice.split_once('=').unwrap();
                let axis = ["x", "y", "z"].iter().position(|&name| name == axis).unwrap();
                let place = numbers(place);
                view.cutting.slice = Some(Slice { axis, from: place[0], thickness: place[1] });
            }
            "--clip-plane" => {
                let plane = numbers(&value());
                view.cutting.planes.push((Vec3::from_slice(&plane[..3]), plane[3]));
            }
            "--ground" => {
                let height = word.split_once('=').map(|(_, height)| height.parse().unwrap());
                view.surroundings.ground = Some(Ground { height, color: Vec3::ZERO });
            }
            "--ground-color" => {
                let ground = view.surroundings.ground.as_mut().unwrap();
                ground.color = vector_of(&value());
            }
            "--fog" => {
                let fog = numbers(&value());
                let (density, color, anisotropy) = (fog[0], Vec3::from_slice(&fog[1..4]), fog[4]);
                view.surroundings.fog = Some(Fog { density, color, anisotropy });
            }
            "--edges" => view.lines.edges = Some(line_of(&numbers(word.split_once('=').unwrap().1))),
            "--grid" => {
                let grid = numbers(word.split_once('=').unwrap().1);
                view.lines.grid = Some(GridLines { line: line_of(&grid), spacing: grid[4] as u32 });
            }
            "--clear-shadows" => view.clear_shadows = true,
            "--clip-shadows" => view.cutting.shadows = true,
            "--material" => view.materials.push(value().parse().unwrap()),
            "--hide" => view.hidden.push(value().parse().unwrap()),
            "--show" => view.shown.push(value().parse().unwrap()),
            "--traversal" => {
                let name = value();
                view.traversal = Traversal::ALL.into_iter().find(|traversal| traversal.name() == name);
            }
            "--primitive" => {
                let name = value();
                view.primitive = Primitive::ALL.into_iter().find(|primitive| primitive.name() == name);
            }
            "--device" => view.device = Some(value()),
            "--fast" => view.fast = true,
            "--resolution" => view.scene_options.extend([word.clone(), value()]),
            other => panic!("an unknown option {other}"),
        }
    }
    if !has_bounces {
        view.max_bounces = if view.integrator == Integrator::Essay { 3 } else { 8 };
    }
    view
}

fn line_of(numbers: &[f32]) -> Line {
    Line { width: numbers[0], color: Vec3::from_slice(&numbers[1..4]) }
}

fn camera() -> Camera {
    let camera = Camera::look_at(Vec3::new(-140.1, 0.1, 1e-7), Vec3::new(0.333_333_34, -0.0, 3e12));
    Camera { up: Vec3::new(0.1, -0.2, 0.7), fov_y: 33.3, ..camera }
}

fn everything() -> RenderCommand {
    RenderCommand {
        scene_options: vec!["--resolution".into(), "700".into()],
        size: (1980, 1080),
        samples: 4096,
        seed: 4_294_967_295,
        integrator: Integrator::Essay,
        max_bounces: 8,
        bounce_limits: BounceLimits { diffuse: 0, glossy: 3, transmitted: 254, volume: 7 },
        clamp_indirect: Some(0.3),
        clear_shadows: true,
        lines: Lines {
            edges: Some(Line { width: 0.3, color: Vec3::new(0.1, 0.2, 0.7) }),
            grid: Some(GridLines { line: Line { width: 1e-7, color: Vec3::new(0.3, 0.0, 1.0) }, spacing: 17 }),
        },
        transparent: true,
        tone_map: ToneMap { operator: voxtrace::output::Operator::Linear, exposure: -1.7 },
        traversal: Some(Traversal::Pipeline),
        primitive: Some(Primitive::VoxelApprox),
        device: Some("it's a `device` $HOME \"x\" \\".into()),
        fast: true,
        sky_brightness: Some(0.0),
        sky: Some(SkySetting::Panorama("-it's a/sky.hdr".into())),
        sky_rotation: Some(-12.3),
        sun: Some(SunSetting { bearing: -150.3, height: -0.1, strength: 2.7 }),
        sun_disc: Some(false),
        light_intensity: Some(40.0),
        cutting: Cutting {
            clip_box: Some([Vec3::new(-0.1, 0.0, 1e-7), Vec3::new(700.3, 5e9, 2.0)]),
            slice: Some(Slice { axis: 1, from: -3.3, thickness: 0.7 }),
            planes: vec![(Vec3::new(-0.6, 0.0, 0.8), -1e-7), (Vec3::X, 3.3)],
            shadows: true,
        },
        surroundings: Surroundings {
            ground: Some(Ground { height: Some(-0.7), color: Vec3::new(0.1, 0.2, 1.0) }),
            fog: Some(Fog { density: 1e-7, color: Vec3::new(0.3, 0.7, 0.9), anisotropy: -0.3 }),
        },
        materials: ["3=#ff8800,2.5", "65534=0.1,0.2,0.3", "0=0,0,0,1e-9,7,0"].map(|text| text.parse().unwrap()).into(),
        hidden: ["layer:it's a roof", "object:7"].map(|text| text.parse().unwrap()).into(),
        shown: vec!["group:-1 \"x\"".parse().unwrap()],
        outputs: vec!["a b.png".into(), "-c\n*?.exr".into()],
        ..RenderCommand::new(SceneArgument::File("/scenes/sömme r'/*.vox".into()), camera())
    }
}

#[cfg(unix)]
#[test]
fn the_line_that_a_shell_reads_back_asks_for_the_same_view_to_the_bit() {
    let view = everything();
    let words = shell_words(&view.line().unwrap());
    assert_eq!(words, view.words().unwrap());
    let read = parsed(&words, None);
    assert_eq!(format!("{read:?}"), format!("{view:?}"), "also the sign of zeros");

    let mut other = view.clone();
    other.camera.eye.x = f32::from_bits(view.camera.eye.x.to_bits() + 1);
    let other = parsed(&shell_words(&other.line().unwrap()), None);
    assert_ne!(format!("{other:?}"), format!("{view:?}"), "the comparison sees the last bit");
    let careless = shell_words(&view.words().unwrap().join(" ").replace(['\'', '`', '"', '\n'], ""));
    assert_ne!(careless, words, "the comparison sees words that are not quoted");
}

#[test]
fn random_numbers_are_read_as_the_same_bits() {
    let mut word = 99u32;
    for _ in 0..20_000 {
        word = word.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        let value = f32::from_bits(word);
        if value.is_finite() {
            assert_eq!(number(value).parse::<f32>().unwrap().to_bits(), word);
        }
    }
    assert_eq!([1.0, -0.0, 0.1, 1e-7, -2.5].map(number), ["1", "-0", "0.1", "1e-7", "-2.5"]);
}

#[test]
fn what_is_the_default_is_left_out() {
    let built_in = SceneArgument::BuiltIn { name: "church".into(), voxels: None };
    let usual = RenderCommand { usual_camera: Some(camera()), ..RenderCommand::new(built_in.clone(), camera()) };
    assert_eq!(usual.line().unwrap(), "voxtrace render church");
    let moved = Camera { eye: Vec3::new(1.0, 2.5, -3.0), fov_y: 90.0, ..camera() };
    let scene = SceneArgument::BuiltIn { name: "church".into(), voxels: Some(500_000) };
    let moved = RenderCommand { scene, camera: moved, ..usual.clone() };
    assert_eq!(moved.line().unwrap(), "voxtrace render church --voxels 500000 --eye 1,2.5,-3 --fov 90");
    let words = moved.words().unwrap();
    assert_eq!(format!("{:?}", parsed(&words, Some(camera()))), format!("{moved:?}"));

    let essay = RenderCommand { integrator: Integrator::Essay, max_bounces: 3, ..usual.clone() };
    assert_eq!(essay.line().unwrap(), "voxtrace render church --integrator essay");
    let sun = SunSetting { bearing: 150.0, height: 40.0, strength: 3.0 };
    assert_eq!(
        RenderCommand { sun: Some(sun), ..usual.clone() }.line().unwrap(),
        "voxtrace render church --sun 150,40"
    );
    let under = |sky| RenderCommand { sky: Some(sky), ..usual.clone() }.line().unwrap();
    assert_eq!(under(SkySetting::Physical), "voxtrace render church --sky physical");
    assert_eq!(under(SkySetting::Panorama("physical".into())), "voxtrace render church --sky ./physical");
    assert_eq!(under(SkySetting::Color(Vec3::ONE)), "voxtrace render church --sky-color 1,1,1");
}

#[test]
fn an_animation_of_a_built_in_scene_has_the_size_that_is_shown() {
    let built_in = SceneArgument::BuiltIn { name: "city".into(), voxels: Some(500_000) };
    let file = PathBuf::from("/x/city.animation.toml");
    let sequence = Some(Sequence::Animation { file, keeps: false });
    let view = RenderCommand { sequence, ..RenderCommand::new(built_in, camera()) };
    assert_eq!(view.line().unwrap(), "voxtrace animate /x/city.animation.toml --voxels 500000");
}

#[test]
fn files_whose_names_mean_something_else_are_called_with_their_folder() {
    let word = |path: &str| RenderCommand::new(SceneArgument::File(path.into()), camera()).words().unwrap()[2].clone();
    assert_eq!(["church", "-a.vox", "a.vox", "/x/church"].map(word), ["./church", "./-a.vox", "a.vox", "/x/church"]);
    assert_eq!(["", "=a", "~", "a=b", "$x"].map(quoted), ["''", "'=a'", "'~'", "a=b", "'$x'"]);
}

#[test]
fn every_option_and_default_is_one_of_the_page_of_the_command_line() {
    let page = include_str!("../../../../docs/command-line.md");
    let unknown = |words: &[String]| -> Vec<String> {
        let options = words.iter().filter(|word| word.starts_with("--"));
        let options = options.map(|word| word.split('=').next().unwrap().to_owned());
        let stands = |option: &String| page.contains(&format!("`{option}`")) || page.contains(&format!("`{option} "));
        options.filter(|option| !stands(option)).collect()
    };
    let mut words = everything().words().unwrap();
    assert_eq!(unknown(&words), Vec::<String>::new());
    words.push("--nonesuch=3".into());
    assert_eq!(unknown(&words), ["--nonesuch"]);
    assert!(page.contains(&format!("| `--size WxH` | {}x{} |", SIZE.0, SIZE.1)));
    assert!(page.contains(&format!("| `--spp N` | {} |", SAMPLES.0)));
    assert!(page.contains("| `--max-bounces N` | 8, 3 |") && page.contains("| `--seed N` | 0 |"));
    assert!(page.contains("irradiance (3; 0 is no sun)") && page.contains("| `--exposure STOPS` | 0 |"));
}

#[test]
fn what_render_refuses_has_no_command() {
    let view = || RenderCommand::new(SceneArgument::BuiltIn { name: "city".into(), voxels: None }, camera());
    assert!(view().line().is_ok());
    let sun = SunSetting { bearing: 0.0, height: 91.0, strength: 1.0 };
    let wrong = [
        RenderCommand { samples: 0, ..view() },
        RenderCommand { size: (0, 1), ..view() },
        RenderCommand { camera: Camera { fov_y: 180.0, ..camera() }, ..view() },
        RenderCommand { camera: Camera { eye: camera().target, ..camera() }, ..view() },
        RenderCommand { camera: Camera { up: Vec3::ZERO, ..camera() }, ..view() },
        RenderCommand { sky_brightness: Some(f32::NAN), ..view() },
        RenderCommand { light_intensity: Some(-1.0), ..view() },
        RenderCommand { sky: Some(SkySetting::Color(Vec3::new(0.0, -1.0, 0.0))), ..view() },
        RenderCommand { sky: Some(SkySetting::Physical), sky_rotation: Some(1.0), ..view() },
        RenderCommand { sky: Some(SkySetting::Physical), sun: Some(SunSetting { strength: 0.0, ..sun }), ..view() },
        RenderCommand { sky_rotation: Some(f32::INFINITY), ..view() },
        RenderCommand { sun: Some(sun), ..view() },
        RenderCommand { tone_map: ToneMap { exposure: 65.0, ..ToneMap::default() }, ..view() },
    ];
    for view in wrong {
        assert!(matches!(view.line(), Err(CommandError::Refused(_))), "{view:?}");
    }
    #[cfg(unix)]
    {
        use std::os::unix::ffi::OsStringExt;
        let path = PathBuf::from(std::ffi::OsString::from_vec(vec![b'a', 0xff]));
        let view = RenderCommand { scene: SceneArgument::File(path.clone()), ..view() };
        assert_eq!(view.line(), Err(CommandError::NotUnicode(path)));
    }
}

#[test]
fn the_command_that_measures_says_the_view_and_what_was_changed() {
    let built_in = SceneArgument::BuiltIn { name: "city".into(), voxels: None };
    let view = RenderCommand {
        usual_camera: Some(camera()),
        materials: vec!["1=#ffffff".parse().unwrap()],
        hidden: vec!["layer:roof".parse().unwrap()],
        fast: true,
        ..RenderCommand::new(built_in, camera())
    };
    let cells = ["cpu".to_owned(), "pipeline:brick".to_owned()];
    let expected = "voxtrace bench city --material 1=#ffffff --hide layer:roof --size 1280x720 --max-bounces 8 \
                    --integrator path --cells cpu,pipeline:brick --frames 64 --warm-up 4 --sweep none";
    let line = view.bench_line(&cells, 64, 4).unwrap();
    assert_eq!(line, expected.replace("1=#ffffff", "'1=#ffffff'"));
    let precise = RenderCommand { fast: false, ..view };
    assert_eq!(precise.bench_line(&cells, 64, 4).unwrap(), format!("{line} --precise"));
    let essay = RenderCommand { integrator: Integrator::Essay, ..precise.clone() };
    assert!(essay.bench_line(&cells, 64, 4).unwrap().contains(" --integrator essay "));
    // The picture of what is cut open has a command, its benchmark has none.
    let slice = Some(Slice { axis: 2, from: 4.0, thickness: 1.0 });
    let planes = vec![(Vec3::Z, 4.0)];
    let ground = Some(Ground { height: None, color: Vec3::ONE });
    let whole = RenderCommand { scene_options: vec!["--resolution".into(), "9".into()], ..precise.clone() };
    for (view, is_whole) in [
        (RenderCommand { cutting: Cutting { slice, ..Cutting::default() }, ..precise.clone() }, false),
        (RenderCommand { cutting: Cutting { planes, ..Cutting::default() }, ..precise.clone() }, false),
        (RenderCommand { surroundings: Surroundings { ground, fog: None }, ..precise }, false),
        (whole, true),
    ] {
        assert!(view.line().is_ok());
        assert_eq!(!matches!(view.bench_line(&cells, 64, 4), Err(CommandError::Refused(_))), is_whole);
    }
}
