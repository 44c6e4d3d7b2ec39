//! MTL, the materials of OBJ files. Phong's and illumination models are left out; of the physically based extension roughness
//! and metalness are read. The index of refraction is that of what lets light through.

use super::{Folder, Limits, linear_from_signal};
use crate::import::images::texture;
use glam::{Vec3, Vec4};
use std::collections::BTreeMap;
use voxtrace_voxelize::mesh::{Mesh, MeshMaterial, TextureUse, Wrap};

/// Materials by name, and pictures by file.
#[derive(Default)]
pub(super) struct Library {
    pub materials: BTreeMap<String, MeshMaterial>,
    /// Index of the texture, `None` where the file cannot be read.
    textures: BTreeMap<String, Option<u32>>,
    /// Bytes of all textures.
    taken: u64,
    files: usize,
    /// Textures that nothing comes of, by the statement that names them.
    pub unread_maps: BTreeMap<String, u64>,
}

impl Library {
    /// Reads a library. What is missing is noted and left out: a mesh without its colours is still a mesh.
    pub fn read(&mut self, names: &str, folder: &Folder, limits: &Limits, mesh: &mut Mesh) {
        // A line names several files, or one with spaces in it.
        let whole = read_near(folder, names);
        let files = match whole {
            Ok(bytes) => vec![(names.to_owned(), Ok(bytes))],
            Err(fault) if !names.contains(char::is_whitespace) => vec![(names.to_owned(), Err(fault))],
            Err(_) => names.split_whitespace().map(|name| (name.to_owned(), read_near(folder, name))).collect(),
        };
        for (name, bytes) in files {
            self.files += 1;
            match bytes {
                Ok(_) if self.files as u64 > limits.items.min(1024) => {
                    mesh.notes.push(format!("{name}: too many material libraries"));
                    return;
                }
                Ok(bytes) => self.parse(&String::from_utf8_lossy(&bytes), folder, limits, mesh),
                Err(fault) => mesh.notes.push(format!("materials are left out: {fault}")),
            }
        }
    }

    fn parse(&mut self, text: &str, folder: &Folder, limits: &Limits, mesh: &mut Mesh) {
        let mut name = None;
        let mut material = MeshMaterial::default();
        let mut has_dissolve = false;
        for line in text.trim_start_matches('\u{feff}').lines() {
            let line = line.trim();
            let (word, rest) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
            let rest = rest.trim();
            match word.to_ascii_lowercase().as_str() {
                "newmtl" => {
                    self.keep(name.replace(rest.to_owned()), std::mem::take(&mut material));
                    material.name = rest.into();
                    has_dissolve = false;
                    if self.materials.len() as u64 >= limits.items {
                        return;
                    }
                }
                "kd" => {
                    if let Some(color) = color(rest) {
                        material.base_color = color.extend(material.base_color.w);
                    }
                }
                "ke" => material.emission = color(rest).unwrap_or(Vec3::ZERO),
                "d" => {
                    // Files that say 0 mean something else: nobody models what is not there.
                    if let Some(alpha) = number(rest).filter(|&alpha| alpha > 0.0) {
                        material.base_color.w = alpha.min(1.0);
                    }
                    has_dissolve |= number(rest).is_some();
                }
                // The same turned round. Beside a `d` some programs write the same number here, so that one counts.
                "tr" if !has_dissolve => {
                    if let Some(alpha) =
                        number(rest).map(|transparency| 1.0 - transparency).filter(|&alpha| alpha > 0.0)
                    {
                        material.base_color.w = alpha.min(1.0);
                    }
                }
                // Without a number of its own, or with 1 as many programs write it by default, glass stays glass.
                "ni" => material.ior = number(rest).filter(|&ior| ior > 1.0 && ior <= 10.0).unwrap_or(material.ior),
                "pr" => material.roughness = number(rest).unwrap_or(1.0).clamp(0.0, 1.0),
                "pm" => material.metallic = number(rest).unwrap_or(0.0).clamp(0.0, 1.0),
                "map_kd" => material.base_texture = self.texture(rest, folder, limits, mesh),
                "map_d" => material.alpha_texture = self.texture(rest, folder, limits, mesh),
                "map_bump" | "bump" | "norm" | "disp" | "decal" | "refl" | "map_ka" | "map_ks" | "map_ns"
                | "map_pr" | "map_pm" => {
                    *self.unread_maps.entry(word.to_owned()).or_default() += 1;
                }
                "map_ke" => material.emission_texture = self.texture(rest, folder, limits, mesh),
                _ => {}
            }
        }
        self.keep(name, material);
    }

    fn keep(&mut self, name: Option<String>, mut material: MeshMaterial) {
        let Some(name) = name else { return };
        let base = material.base_color;
        if material.base_texture.is_some() && base.x == base.y && base.y == base.z {
            // Modelling programs write a default grey, or black, beside a picture and mean the picture alone.
            material.base_color = Vec4::new(1.0, 1.0, 1.0, base.w);
        }
        if material.emission_texture.is_some() && material.emission == Vec3::ZERO {
            material.emission = Vec3::ONE;
        }
        material.transmission = 1.0 - material.base_color.w;
        if material.transmission == 0.0 {
            material.ior = MeshMaterial::default().ior;
        }
        material.base_color.w = 1.0;
        let has_alpha = material.base_texture.is_some() || material.alpha_texture.is_some();
        material.alpha_cutoff = if has_alpha { 0.5 } else { 0.0 };
        self.materials.entry(name).or_insert(material);
    }

    /// A picture with its options.
    fn texture(&mut self, rest: &str, folder: &Folder, limits: &Limits, mesh: &mut Mesh) -> Option<TextureUse> {
        let (mut rest, mut placed) = (rest, TextureUse::new(0));
        while let Some((option, after)) = rest.strip_prefix('-').and_then(|rest| rest.split_once(char::is_whitespace)) {
            let words: Vec<&str> = after.split_whitespace().collect();
            let numbers: Vec<f32> = words.iter().map_while(|word| number(word)).take(3).collect();
            let used = match option {
                "clamp" => {
                    placed.wrap = [if words.first() == Some(&"on") { Wrap::Clamp } else { Wrap::Repeat }; 2];
                    1
                }
                "s" => {
                    placed.transform[0].x = numbers.first().copied().unwrap_or(1.0);
                    placed.transform[1].y = numbers.get(1).copied().unwrap_or(1.0);
                    numbers.len()
                }
                "o" => {
                    placed.transform[0].z = numbers.first().copied().unwrap_or(0.0);
                    // The file's v points up, ours down.
                    placed.transform[1].z = -numbers.get(1).copied().unwrap_or(0.0);
                    numbers.len()
                }
                "t" => numbers.len(),
                "mm" => 2,
                _ => 1,
            };
            rest = skip_words(after, used);
        }
        // v' = s·v + o counts from the bottom: in our coordinates the scale leaves the bottom edge in place.
        placed.transform[1].z += 1.0 - placed.transform[1].y;
        let known = self.textures.get(rest).copied();
        let texture = known.unwrap_or_else(|| {
            let mut decode = |bytes: Vec<u8>| texture::decode_another(&bytes, &mut self.taken, limits);
            let read =
                read_near(folder, rest).and_then(|bytes| decode(bytes).map_err(|fault| format!("{rest:?}: {fault}")));
            let index = match read {
                Ok(texture) => {
                    mesh.textures.push(texture);
                    Some((mesh.textures.len() - 1) as u32)
                }
                Err(fault) => {
                    mesh.notes.push(format!("a texture is left out: {fault}"));
                    None
                }
            };
            self.textures.insert(rest.into(), index);
            index
        })?;
        Some(TextureUse { texture, ..placed })
    }
}

/// Reads the file of that name in the folder. Files carry paths of the machine they were made on: where such a path leads
/// elsewhere, the name alone is looked for beside the mesh.
fn read_near(folder: &Folder, name: &str) -> Result<Vec<u8>, String> {
    use crate::import::source::folder::Refused;
    match folder.read(name) {
        Err(Refused::Outside(_)) if name.contains(['/', '\\']) => {
            let last = name.rsplit(['/', '\\']).next().unwrap_or_default();
            folder.read(last).map_err(|refused| refused.to_string())
        }
        read => read.map_err(|refused| refused.to_string()),
    }
}

fn skip_words(text: &str, count: usize) -> &str {
    let mut rest = text.trim_start();
    for _ in 0..count {
        rest = rest.split_once(char::is_whitespace).map_or("", |(_, after)| after.trim_start());
    }
    rest
}

fn number(text: &str) -> Option<f32> {
    text.split_whitespace().next()?.parse().ok().filter(|value: &f32| value.is_finite())
}

/// A colour as sRGB signals; values above 1, as emission has them, are linear factors of white.
fn color(text: &str) -> Option<Vec3> {
    let numbers: Vec<f32> = text.split_whitespace().map_while(number).collect();
    let linear = |value: f32| if value > 1.0 { value } else { linear_from_signal(value) };
    match numbers[..] {
        [r, g, b, ..] => Some(Vec3::new(linear(r), linear(g), linear(b))),
        [value] => Some(Vec3::splat(linear(value))),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parsed(text: &str) -> (Library, Mesh) {
        let (mut library, mut mesh) = (Library::default(), Mesh::new(""));
        library.parse(text, &Folder::none(), &Limits::default(), &mut mesh);
        (library, mesh)
    }

    #[test]
    fn colours_light_and_opacity_are_read() {
        let (library, _) = parsed("newmtl glass\nKd 1 0.5 0\nd 0.25\n\nnewmtl lamp\n  KE 5 0 0\nPr 0.3\nd 0");
        let glass = &library.materials["glass"];
        assert!((glass.base_color - Vec4::new(1.0, 0.2158, 0.0, 1.0)).abs().max_element() < 1e-3);
        assert_eq!((glass.transmission, glass.emission), (0.75, Vec3::ZERO));
        let lamp = &library.materials["lamp"];
        assert_eq!((lamp.emission, lamp.roughness, lamp.transmission), (Vec3::new(5.0, 0.0, 0.0), 0.3, 0.0));
    }

    #[test]
    fn transparency_is_opacity_turned_round_and_gives_way_to_it() {
        let text = ["Tr 0.75", "d 1\nTr 1", "Tr 0.25\nd 0.25", "Tr 1", "Tr 0"];
        let names = ["a", "b", "c", "e", "f"];
        let (library, _) =
            parsed(&names.iter().zip(text).map(|(name, text)| format!("newmtl {name}\n{text}\n")).collect::<String>());
        let transmission = |name: &str| library.materials[name].transmission;
        assert_eq!(names.map(transmission), [0.75, 0.0, 0.75, 0.0, 0.0]);
    }

    #[test]
    fn what_lets_light_through_has_its_index_of_refraction() {
        let usual = MeshMaterial::default().ior;
        let text = ["Ni 1.33\nd 0.1", "d 0.1\nNi 1", "d 0.1", "Ni 1.33"];
        let (library, _) =
            parsed(&text.iter().enumerate().map(|(at, text)| format!("newmtl {at}\n{text}\n")).collect::<String>());
        assert_eq!(["0", "1", "2", "3"].map(|name| library.materials[name].ior), [1.33, usual, usual, usual]);
    }

    #[test]
    fn a_picture_is_found_behind_its_options_and_its_absence_is_noted() {
        let (library, mesh) = parsed("newmtl a\nmap_Kd -s 2 3 1 -clamp on -bm 0.5 my picture.png\nmap_Ke missing.png");
        assert!(library.materials["a"].base_texture.is_none());
        assert_eq!(library.textures.keys().collect::<Vec<_>>(), ["missing.png", "my picture.png"]);
        assert_eq!(mesh.notes.len(), 2);
    }

    #[test]
    fn a_path_of_another_machine_is_looked_for_beside_the_mesh() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("wood.png"), "picture").unwrap();
        let beside = Folder::of(&folder.path().join("a.obj"), &Limits::default());
        assert_eq!(read_near(&beside, "C:\\textures\\wood.png").unwrap(), b"picture");
        assert_eq!(read_near(&beside, "../elsewhere/wood.png").unwrap(), b"picture");
        assert!(read_near(&beside, "/etc/passwd").is_err());
    }
}
