//! Colours, light and surfaces of the voxels that meshes become.

use crate::meshes::{cuboid, indexed, sphere};
use crate::voxelized::{color_at, options, scene_of, textured_cube};
use voxtrace::Material;
use voxtrace::glam::{IVec3, Mat3, Vec3, Vec4};
use voxtrace::import::Limits;
use voxtrace::material::{linear_color, srgb_from_linear};
use voxtrace::mesh::{MeshMaterial, Texture, TextureUse};
use voxtrace::voxelize::{Scale, SurfaceRule, VoxelizeOptions, voxelize};

#[test]
fn a_textured_cube_has_its_texels_as_voxels() {
    let (mesh, texel) = textured_cube();
    let scene = scene_of(&mesh, SurfaceRule::Conservative);
    assert_eq!(scene.grids[0].bounds().unwrap().max, IVec3::splat(8));
    // Away from the edges, where faces mix, each voxel of a face is one texel.
    for i in 1..7u32 {
        for j in 1..7u32 {
            let [x, y] = [i as i32, j as i32];
            assert_eq!(color_at(&scene, [x, y, 7]), Some(texel(5, i, j)), "top {i} {j}");
            assert_eq!(color_at(&scene, [x, y, 0]), Some(texel(4, i, 7 - j)), "bottom {i} {j}");
            assert_eq!(color_at(&scene, [7, x, y]), Some(texel(1, i, j)), "+x {i} {j}");
            assert_eq!(color_at(&scene, [0, x, y]), Some(texel(0, 7 - i, j)), "-x {i} {j}");
            assert_eq!(color_at(&scene, [x, 0, y]), Some(texel(2, i, j)), "-y {i} {j}");
            assert_eq!(color_at(&scene, [x, 7, y]), Some(texel(3, 7 - i, j)), "+y {i} {j}");
        }
    }
    // An edge has the mean of its two faces in linear light.
    let mean = (linear_color(texel(2, 3, 7)) + linear_color(texel(5, 3, 0))) * 0.5;
    assert_eq!(color_at(&scene, [3, 0, 7]), Some(mean.to_array().map(srgb_from_linear)));
}

#[test]
fn colours_are_weighted_by_area() {
    // Two sheets through one layer of voxels: one covers a quarter of each voxel, the other all of it.
    let mut mesh = indexed(
        [[0., 0., 0.25], [0.25, 0., 0.25], [0.25, 9., 0.25], [0., 0., 0.5], [1., 0., 0.5], [1., 9., 0.5]]
            .map(Vec3::from_array)
            .to_vec(),
        vec![[0, 1, 2], [3, 4, 5]],
    );
    mesh.positions.extend([Vec3::new(0.0, 9.0, 0.25), Vec3::new(0.0, 9.0, 0.5)]);
    mesh.triangles.extend([[0, 2, 6], [3, 5, 7]]);
    mesh.material_of = vec![0, 1, 0, 1];
    let plain = |color: Vec3| MeshMaterial { base_color: color.extend(1.0), ..MeshMaterial::default() };
    mesh.materials = vec![plain(Vec3::X), plain(Vec3::Y)];
    let scene = scene_of(&mesh, SurfaceRule::Conservative);
    let expected = Vec3::new(0.2, 0.8, 0.0).to_array().map(srgb_from_linear);
    for y in 0..9 {
        assert_eq!(color_at(&scene, [0, y, 0]), Some(expected), "{y}");
    }
}

#[test]
fn vertex_colours_are_interpolated_in_linear_light() {
    let mut mesh = indexed(
        [[0., 0., 0.5], [16., 0., 0.5], [16., 4., 0.5], [0., 4., 0.5]].map(Vec3::from_array).to_vec(),
        vec![[0, 1, 2], [0, 2, 3]],
    );
    let (black, white) = (Vec4::new(0.0, 0.0, 0.0, 1.0), Vec4::ONE);
    mesh.colors = vec![black, white, white, black];
    mesh.materials[0].base_color = Vec4::ONE;
    let scene = scene_of(&mesh, SurfaceRule::Conservative);
    for x in 0..16 {
        let expected = srgb_from_linear((x as f32 + 0.5) / 16.0);
        assert_eq!(color_at(&scene, [x, 2, 0]), Some([expected; 3]), "{x}");
    }
}

#[test]
fn what_alpha_cuts_out_is_not_there_and_what_emits_shines() {
    let (mut mesh, _) = textured_cube();
    let texels = (0..64).map(|i| [255, 255, 255, if i % 8 < 4 { 0 } else { 255 }]).collect();
    mesh.textures[5] = Texture::new(8, 8, texels).unwrap();
    mesh.materials[5].base_texture = Some(TextureUse { nearest: true, ..TextureUse::new(5) });
    mesh.materials[5].alpha_cutoff = 0.5;
    mesh.materials[1].emission = Vec3::new(4.0, 2.0, 1.0);
    let scene = scene_of(&mesh, SurfaceRule::Conservative);
    for i in 1..7 {
        assert_eq!(color_at(&scene, [i, 3, 7]).is_some(), i >= 4, "{i}");
        let material = scene.materials[usize::from(scene.grids[0].get(IVec3::new(7, i, 3)).unwrap())];
        assert!((material.emission - Vec3::new(4.0, 2.0, 1.0)).abs().max_element() < 0.02, "{}", material.emission);
        let other = scene.materials[usize::from(scene.grids[0].get(IVec3::new(0, i, 3)).unwrap())];
        assert!(!other.is_emissive());
    }
}

#[test]
fn surfaces_keep_their_roughness_and_the_largest_in_a_voxel_wins() {
    let mut mesh = cuboid(Vec3::ZERO, Vec3::splat(8.0), Mat3::IDENTITY);
    mesh.materials = vec![
        MeshMaterial { roughness: 0.25, ..MeshMaterial::default() },
        MeshMaterial { metallic: 1.0, roughness: 0.5, ..MeshMaterial::default() },
    ];
    mesh.material_of = vec![0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0];
    let scene = scene_of(&mesh, SurfaceRule::Conservative);
    let at = |voxel: [i32; 3]| -> Material { scene.materials[usize::from(scene.grids[0].get(voxel.into()).unwrap())] };
    assert_eq!((at([7, 3, 3]).metallic, at([7, 3, 3]).roughness), (1.0, 0.5));
    assert_eq!((at([0, 3, 3]).metallic, at([0, 3, 3]).roughness), (0.0, 0.25));
    assert_eq!(scene.materials.len(), 2);
}

#[test]
fn a_texture_says_where_a_surface_is_rough_and_where_it_is_metal() {
    let (mut mesh, _) = textured_cube();
    // Columns of the top: rough paint, smooth metal, half of both, and what a filter leaves between levels.
    let bytes = [[255, 0], [0, 255], [128, 128], [70, 5]];
    let texels = (0..64).map(|i| [99, bytes[i % 8 / 2][0], bytes[i % 8 / 2][1], 255]).collect();
    mesh.textures.push(Texture::new(8, 8, texels).unwrap());
    let texture = TextureUse { nearest: true, ..TextureUse::new(mesh.textures.len() as u32 - 1) };
    let top = MeshMaterial { surface_texture: Some(texture), metallic: 1.0, ..mesh.materials[5].clone() };
    mesh.materials[5] = top.clone();
    let surface = |mesh: &voxtrace::Mesh, x: i32| {
        let scene = scene_of(mesh, SurfaceRule::Conservative);
        let material = scene.materials[usize::from(scene.grids[0].get(IVec3::new(x, 3, 7)).unwrap())];
        (material.roughness, material.metallic)
    };
    assert_eq!([1, 3, 5].map(|x| surface(&mesh, x)), [(1.0, 0.0), (0.0, 1.0), (0.5, 0.5)]);
    assert_eq!(surface(&mesh, 6), (0.25, 0.0), "the nearest levels");
    // Factors multiply the texture; without it they hold everywhere, as on the other faces.
    mesh.materials[5] = MeshMaterial { roughness: 0.5, metallic: 0.0, ..top.clone() };
    assert_eq!([1, 3].map(|x| surface(&mesh, x)), [(0.5, 0.0), (0.0, 0.0)]);
    mesh.materials[5] = MeshMaterial { surface_texture: None, ..top };
    assert_eq!([1, 3].map(|x| surface(&mesh, x)), [(1.0, 1.0); 2], "the comparison sees a texture that is not read");
    let side = scene_of(&mesh, SurfaceRule::Conservative);
    let side = side.materials[usize::from(side.grids[0].get(IVec3::new(0, 3, 3)).unwrap())];
    assert_eq!((side.roughness, side.metallic), (1.0, 0.0));
}

#[test]
fn a_palette_has_at_most_the_colours_asked_for() {
    let mut mesh = sphere(Vec3::splat(20.5), 20.0, 60);
    mesh.colors = mesh.positions.iter().map(|&position| (position / 41.0).extend(1.0)).collect();
    mesh.materials[0].base_color = Vec4::ONE;
    let count = |max_materials: usize| {
        let options = VoxelizeOptions { max_materials, ..options(Scale::Resolution(120)) };
        let scene = voxelize(&mesh, &options, &Limits::default()).unwrap();
        let largest = scene.grids[0].voxels().map(|(_, material)| material).max().unwrap();
        assert!(usize::from(largest) < scene.materials.len());
        scene.materials.len()
    };
    assert!(count(65_535) > 5_000);
    assert!((200..=255).contains(&count(255)));
    assert!((6..=7).contains(&count(7)));
    assert_eq!(count(1), 1);
}
