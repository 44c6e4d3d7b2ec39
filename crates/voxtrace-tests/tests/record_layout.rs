//! The records that tracers on other devices read are laid out on the host as shaders expect them, whatever was generated:
//! `shaders/layout/records.txt` says where slangc puts each member, `offset_of!` where Rust does. So do the sizes of stacks agree.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::mem::offset_of;
use std::path::Path;
use voxtrace::film::Pixel;
use voxtrace::sky::EnvironmentTexel;
use voxtrace::{Hit, Ray, Transform};
use voxtrace_core::packed::{
    Emitter, InstanceNode, LightNode, MAX_INSTANCE_DEPTH, PackedGrid, PackedInstance, PackedMaterial,
};
use voxtrace_vulkan::PresentParams;
use voxtrace_vulkan::records::{BlendParams, Dispatch, FrameParams, ProbeAnswer, ProbeRay, RealTimeParams, WaveStep};

/// Size in bytes, and offset and size of each member by its name.
type Layout = (usize, Vec<(String, usize, usize)>);

/// What slangc says, by the shader's name of the record.
fn of_shaders(text: &str) -> BTreeMap<String, Layout> {
    let mut records: BTreeMap<String, Layout> = BTreeMap::new();
    let mut current = String::new();
    for line in text.lines() {
        match line.split_whitespace().collect::<Vec<_>>()[..] {
            [record, size] => {
                current = record.to_string();
                records.insert(current.clone(), (size.parse().unwrap(), Vec::new()));
            }
            [member, offset, size] => {
                let member = (member.to_string(), offset.parse().unwrap(), size.parse().unwrap());
                records.get_mut(&current).unwrap().1.push(member);
            }
            _ => panic!("unexpected line {line:?}"),
        }
    }
    records
}

/// The host's layout of the members named, in this order. `a.b` is called by its last name.
macro_rules! layout {
    ($record:ty: $($($member:ident).+),+) => {{
        fn size_of_member<M>(_: impl Fn(&$record) -> &M) -> usize {
            size_of::<M>()
        }
        let members = vec![$((
            stringify!($($member).+).rsplit('.').next().unwrap().trim().to_string(),
            offset_of!($record, $($member).+),
            size_of_member(|record| &record.$($member).+),
        )),+];
        (size_of::<$record>(), members)
    }};
}

/// The host's layouts, by the shader's name of the record.
fn of_host() -> BTreeMap<&'static str, Layout> {
    BTreeMap::from([
        ("EnvironmentTexel", layout!(EnvironmentTexel: radiance, pdf, threshold, alias)),
        ("RayRecord", layout!(Ray: origin, t_min, direction, t_max)),
        ("HitRecord", layout!(Hit: t, instance, voxel, face)),
        (
            "FrameParams",
            layout!(
                FrameParams: eye, width, corner, height, pixel_x, lens, pixel_y, sky, region, max_bounces,
                is_transparent, first_sample, seed, sky_nadir, sky_brightness, sky_zenith,
                light_intensity, sun_direction, sun_one_minus_cos_theta_max, sun_tangent, sun_sin_radius, sun_bitangent,
                sun_irradiance, sun_radiance, sun_pdf, lens_x, light_node_count, lens_y, blades, sky_turned, sky_edge, sky_irradiance,
                emitter_intensity, bounce_limits, clamp_indirect, instance_count, planes, plane_count, cuts_cast_shadows, clear_shadows,
                hides_sun_disc, ground_material, catcher_sun_share, catcher_cube_share, grid_spacing, edge_color, edge_width, grid_color,
                grid_width
            ),
        ),
        ("PresentParams", layout!(PresentParams: corner, size, width, height, exposure, curve)),
        ("Dispatch", layout!(Dispatch: first, count, samples, samples_target, padding, sequence)),
        ("BlendParams", layout!(BlendParams: width, height, under_width, under_height, film_weight)),
        (
            "RealTimeParams",
            layout!(
                RealTimeParams: eye, view_angle, before_eye, number, before_corner, candidates, before_pixel_x, flags, before_pixel_y,
                most_paths, before_lens_x, before_blades, before_lens_y, cell_samples, before_place, motions, before_rows, before_origin,
                pixels, slots, cells, squares, again, exposure, curve, share, padding
            ),
        ),
        ("WaveStep", layout!(WaveStep: round, counts, capacity, rounds, samples)),
        (
            "ProbeRay",
            layout!(ProbeRay: origin, t_min, direction, t_max, flags, mask, report, log_first, log_capacity, padding),
        ),
        (
            "ProbeAnswer",
            layout!(
                ProbeAnswer: candidates, is_hit, t, primitive, geometry, instance, attribute, attribute_t, kept,
                kept_t, accepted, accepted_t
            ),
        ),
        ("PixelRecord", layout!(Pixel: radiance, samples, covered)),
    ])
}

/// Names of the records that the two sides lay out differently or that only one has.
fn differences(shaders: &BTreeMap<String, Layout>) -> Vec<&str> {
    let host = of_host();
    let names: BTreeSet<&str> = host.keys().copied().chain(shaders.keys().map(String::as_str)).collect();
    names.into_iter().filter(|&name| shaders.get(name) != host.get(name)).collect()
}

#[test]
fn host_and_shaders_agree_on_every_offset() {
    let text = include_str!("../../../shaders/layout/records.txt");
    assert_eq!(differences(&of_shaders(text)), Vec::<&str>::new());

    let moved = text.replacen("  alias 20 4", "  alias 16 4", 1);
    assert_eq!(differences(&of_shaders(&moved)), ["EnvironmentTexel"]);
    let padded = text.replacen("PixelRecord 32", "PixelRecord 36", 1);
    assert_eq!(differences(&of_shaders(&padded)), ["PixelRecord"]);
    let forgotten = format!("{text}Unheard 4\n  of 0 4\n");
    assert_eq!(differences(&of_shaders(&forgotten)), ["Unheard"]);
    let renamed = text.replacen("  face 20 4", "  side 20 4", 1);
    assert_eq!(differences(&of_shaders(&renamed)), ["HitRecord"]);
}

/// The words of records that shaders read by rows of four words, as `shaders/scene.slang` reads them.
#[test]
fn records_that_shaders_read_by_rows_have_their_words_there() {
    let offsets = |layout: Layout| -> Vec<usize> {
        let (mut end, mut offsets) = (0, Vec::new());
        for (_, offset, size) in &layout.1 {
            assert_eq!(*offset, end, "no gaps");
            offsets.push(offset / 4);
            end = offset + size;
        }
        assert_eq!(end, layout.0);
        offsets
    };
    let material = layout!(
        PackedMaterial: base_color, roughness, emission, metallic, transmission, ior, specular, anisotropy, absorption,
        scattering
    );
    assert_eq!(offsets(material), [0, 3, 4, 7, 8, 9, 10, 11, 12, 15]);
    assert_eq!(offsets(layout!(Emitter: voxel, grid, faces, material, luminance, leaf)), [0, 3, 4, 5, 6, 7]);
    assert_eq!(offsets(layout!(LightNode: min, index, max, count, power, parent, root)), [0, 3, 4, 7, 8, 14, 15]);
    assert_eq!(offsets(layout!(InstanceNode: min, index, max, is_leaf)), [0, 3, 4, 7]);
    let transform = layout!(Transform: linear.x_axis, linear.y_axis, linear.z_axis, translation);
    assert_eq!(offsets(transform), [0, 3, 6, 9]);
    let instance = layout!(PackedInstance: grid_from_world, world_from_grid, grid, scene_instance, light_leaf);
    assert_eq!(offsets(instance), [0, 12, 24, 25, 26]);
    let grid = layout!(PackedGrid: origin, top_shift, top_size, top_offset, min, voxels, max, material_bits);
    assert_eq!(offsets(grid), [0, 3, 4, 7, 8, 11, 13, 16]);
    // Rows of those that do not fill them.
    let source = include_str!("../../../shaders/scene.slang");
    for (name, size) in [("GRID_ROWS", size_of::<PackedGrid>()), ("INSTANCE_ROWS", size_of::<PackedInstance>())] {
        let constant = format!("static const uint {name} = {};", size.div_ceil(16));
        assert!(source.lines().any(|line| line == constant), "{constant}");
    }
}

/// Where shaders keep a stack of another size than the host's walk over instances has, or say another depth than the one up to
/// which files are opened. Takes the shaders' sources by their names.
fn wrong_stacks(sources: &BTreeMap<String, String>) -> Vec<String> {
    let mut wrong = Vec::new();
    let constant = format!("static const uint MAX_INSTANCE_DEPTH = {MAX_INSTANCE_DEPTH};");
    if !sources["shared.slang"].lines().any(|line| line == constant) {
        wrong.push("shared.slang".to_string());
    }
    let mut stacks = 0;
    for (name, source) in sources {
        for line in source.lines().map(str::trim).filter(|line| line.starts_with("uint stack[")) {
            stacks += 1;
            if line != "uint stack[MAX_INSTANCE_DEPTH];" {
                wrong.push(format!("{name}: {line}"));
            }
        }
        // What is kept beside the nodes that wait.
        for line in source.lines().map(str::trim).filter(|line| line.starts_with("float entries[")) {
            if line != "float entries[MAX_INSTANCE_DEPTH];" {
                wrong.push(format!("{name}: {line}"));
            }
        }
    }
    if stacks != 3 {
        wrong.push(format!("{stacks} stacks"));
    }
    wrong
}

#[test]
fn stacks_of_shaders_are_as_deep_as_the_hierarchy_over_instances_may_be() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shaders");
    let folders = [folder.clone(), folder.join("generated"), folder.join("pass")];
    let files = folders.into_iter().flat_map(|folder| fs::read_dir(folder).unwrap());
    let paths = files.map(|entry| entry.unwrap().path());
    let sources: BTreeMap<String, String> = paths
        .filter(|path| path.extension().is_some_and(|extension| extension == "slang"))
        .map(|path| (path.file_name().unwrap().to_string_lossy().into_owned(), fs::read_to_string(&path).unwrap()))
        .collect();
    assert_eq!(wrong_stacks(&sources), Vec::<String>::new());

    let with = |name: &str, from: &str, to: &str| {
        let mut changed = sources.clone();
        let source = changed.get_mut(name).unwrap();
        assert!(source.contains(from), "{name} has {from}");
        *source = source.replacen(from, to, 1);
        wrong_stacks(&changed)
    };
    assert_eq!(with("shared.slang", "MAX_INSTANCE_DEPTH = 32", "MAX_INSTANCE_DEPTH = 31"), ["shared.slang"]);
    assert_eq!(with("instances.slang", "stack[MAX_INSTANCE_DEPTH]", "stack[24]"), ["instances.slang: uint stack[24];"]);
    assert_eq!(
        with("instances.slang", "entries[MAX_INSTANCE_DEPTH]", "entries[24]"),
        ["instances.slang: float entries[24];"]
    );
    assert_eq!(with("primitive.slang", "uint stack", "uint heap"), ["2 stacks"]);
}
