use super::*;
use crate::packed::Object;
use glam::{IVec3, Vec3};
use voxtrace_scene::grid::VoxelGrid;
use voxtrace_scene::material::Material;
use voxtrace_scene::scene::{Group, Instance, Layer};
use voxtrace_scene::transform::Transform;

/// Two grids of three materials, the last of which glows: four objects in two layers and a group.
fn example() -> Scene {
    let materials = vec![Material::default(), Material::diffuse(Vec3::X), Material::emissive(Vec3::splat(3.0))];
    let mut scene = Scene { materials, ..Scene::new("example") };
    for grid in 0..2 {
        let mut voxels = VoxelGrid::new();
        for index in 0..900 {
            let at = IVec3::new(index % 30 - 5, index / 30, index * 7 % 11 + grid);
            voxels.set(at, (index * 5 % 13 % 3) as u16);
        }
        scene.grids.push(voxels.into());
    }
    scene.layers = ["ground", "roof"].map(|name| Layer { name: name.into(), ..Layer::default() }).into();
    scene.groups = vec![Group { name: "house".into(), parent: None }, Group { name: "tower".into(), parent: Some(0) }];
    let parts = [("floor", 0, None), ("wall", 0, Some(0)), ("tiles", 1, Some(1)), ("tiles", 1, None)];
    for (index, (name, layer, group)) in parts.into_iter().enumerate() {
        let place = Transform::from_translation(Vec3::new(40.0 * index as f32, 3.0, 0.0));
        let instance = Instance::new(index % 2, place);
        scene.instances.push(Instance { name: name.into(), layer: Some(layer), group, ..instance });
    }
    scene
}

fn part(text: &str) -> PartName {
    text.parse().unwrap()
}

#[test]
fn a_material_that_is_changed_is_as_if_the_scene_had_been_packed_with_it() {
    let scene = example();
    let packed = PackedScene::pack(&scene).unwrap();
    // One begins to glow, one stops, one only changes its colour, one glows more.
    for text in ["0=#808080,4", "2=#ffffff,0", "1=0.25,0.5,0.75", "2=0,0,0,9,1,0.5"] {
        let change: MaterialChange = text.parse().unwrap();
        let changes = SceneChanges { materials: vec![change], ..SceneChanges::default() };
        let changed = changes.apply(&packed).unwrap();
        let mut edited = scene.clone();
        let material = &mut edited.materials[change.number];
        material.base_color = change.base_color;
        material.emission = change.emission.unwrap_or(material.emission);
        let expected = PackedScene::pack(&edited).unwrap();
        assert_eq!(changed.content_hash(), expected.content_hash(), "{text}");
        assert_eq!(changed.placement().light_nodes(), expected.placement().light_nodes(), "{text}");
        changed.validate().unwrap();
        assert_ne!(changed.content_hash(), packed.content_hash(), "the comparison sees a change");
    }
}

#[test]
fn what_is_hidden_is_seen_no_more_and_what_is_shown_is_packed() {
    let mut scene = example();
    let packed = PackedScene::pack(&scene).unwrap();
    let left = |text: &str| {
        let changes = SceneChanges { hidden: vec![part(text)], ..SceneChanges::default() };
        let changed = changes.apply(&packed).unwrap();
        changed.validate().unwrap();
        changed.instances().iter().map(|instance| instance.scene_instance).collect::<Vec<_>>()
    };
    assert_eq!(left("floor"), [1, 2, 3]);
    assert_eq!(left("layer:roof"), [0, 1]);
    assert_eq!(left("layer:0"), [2, 3]);
    assert_eq!(left("house"), [0, 3], "with the tower in it");
    assert_eq!(left("tiles"), [0, 1], "all of that name");
    assert_eq!((left("2"), left("object:3")), (vec![0, 1, 3], vec![0, 1, 2]));
    scene.layers[1].hidden = true;
    scene.instances[0].hidden = true;
    show_parts(&mut scene, &[part("tower")]).unwrap();
    let shown = PackedScene::pack(&scene).unwrap();
    let numbers: Vec<u32> = shown.instances().iter().map(|instance| instance.scene_instance).collect();
    assert_eq!(numbers, [1, 2], "the rest of the layer stays hidden");
}

#[test]
fn what_there_is_not_is_said_with_what_there_is() {
    let packed = PackedScene::pack(&example()).unwrap();
    let error = |materials: &[&str], hidden: &[&str]| {
        let materials = materials.iter().map(|text| text.parse().unwrap()).collect();
        let hidden = hidden.iter().map(|text| part(text)).collect();
        SceneChanges { materials, hidden }.apply(&packed).unwrap_err().to_string()
    };
    assert_eq!(error(&["3=#000000"], &[]), "there is no material 3: it has 3 materials, numbers 0 to 2");
    let text = error(&[], &["cellar"]);
    assert!(text.contains("\"cellar\"") && text.contains("layer:roof") && text.contains("group:house"), "{text}");
    assert!(error(&[], &["layer:tiles"]).contains("2 layers"), "a name of another kind is none");
    assert!(error(&[], &["object:4"]).contains("numbers 0 to 3"));
    for wrong in
        ["", "3", "x=#ffffff", "3=#fff", "3=1,2", "3=#ffffff,1,2", "3=0,0,0,1,2,3,4", "3=#ffffff,nan", "-1=#ffffff"]
    {
        assert!(matches!(wrong.parse::<MaterialChange>(), Err(ChangeError::NoMaterial(_))), "{wrong}");
    }
    for wrong in ["3=1.1,0,0", "3=-0.1,0,0", "3=#ffffff,-1"] {
        assert!(matches!(wrong.parse::<MaterialChange>(), Err(ChangeError::OutOfRange(_))), "{wrong}");
    }
}

#[test]
fn changes_that_are_printed_are_read_as_the_same_bits() {
    let mut word = 1u32;
    let mut random = || {
        word = word.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
        (word >> 8) as f32 / (1 << 24) as f32
    };
    for number in 0..200 {
        let base_color = Vec3::new(random(), random(), random());
        let emission = (number % 2 == 0).then(|| Vec3::new(random() * 1e4, random() * 1e-6, 0.0));
        let change = MaterialChange { number, base_color, emission };
        assert_eq!(change.to_string().parse(), Ok(change));
    }
    let grey: MaterialChange = "7=#808080,2".parse().unwrap();
    assert!(grey.to_string().starts_with("7=#808080,"), "{grey}");
    assert_eq!(grey.emission, Some(grey.base_color * 2.0));
    assert_eq!(grey.to_string().parse(), Ok(grey));
    for text in ["layer:roof", "group:1", "object:wall", "roof", "a:b"] {
        assert_eq!(part(text).to_string(), text);
    }
}

#[test]
fn the_parts_that_are_named_give_back_which_objects_are_seen() {
    let mut scene = example();
    scene.instances[3].hidden = true;
    let packed = PackedScene::pack(&scene).unwrap();
    for seen in 0..16u32 {
        let is_visible: Vec<bool> = (0..4).map(|object| seen >> object & 1 == 1).collect();
        let (hidden, shown) = visible_parts(&packed.outline, &is_visible);
        let mut again = scene.clone();
        show_parts(&mut again, &shown).unwrap();
        let changes = SceneChanges { hidden, ..SceneChanges::default() };
        let changed = changes.apply(&PackedScene::pack(&again).unwrap()).unwrap();
        let found = changed.instances().iter().fold(0, |seen, instance| seen | 1 << instance.scene_instance);
        assert_eq!(found, seen, "{changes:?} {shown:?}");
    }
    let names = |is_visible: [bool; 4]| visible_parts(&packed.outline, &is_visible).0;
    assert_eq!(names([false, false, true, false]), [part("layer:ground")]);
    assert_eq!(names([true, false, false, false]), [part("layer:roof"), part("group:house")]);
    assert_eq!(names([true, false, true, false]), [part("object:wall")]);
}

#[test]
fn a_file_without_names_has_its_objects_by_number() {
    let mut scene = example();
    scene.instances[1].hidden = true;
    let packed = PackedScene::pack(&scene).unwrap();
    let outline = Outline::of_instances(packed.instances());
    let is_hidden: Vec<bool> = outline.objects.iter().map(|object| object.is_hidden).collect();
    assert_eq!(is_hidden, [false, true, false, false]);
    assert_eq!(outline.objects[0], Object::default());
    assert!(part("floor").objects(&outline).is_err());
}
