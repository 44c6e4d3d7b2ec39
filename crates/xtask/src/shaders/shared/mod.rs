//! What shaders share with the host is written once, in Rust: the records, constants and bindings that `table` names become
//! `shaders/generated/shared.slang` (`docs/decisions/0041-one-table-of-records.md`).

mod by_hand;
mod constants;
mod records;
mod table;
mod text;
mod value;

pub use by_hand::check as check_by_hand;
use constants::{Constant, constants_of};
use syn::{File, ImplItem, Item, Type};
use table::TABLE;

/// The generated module, relative to the repository's root.
pub const FILE: &str = "shaders/generated/shared.slang";

/// First lines of the generated module.
const HEAD: &str = "// Records, constants and bindings that shaders share with the host. Written by `cargo xtask shaders` from the Rust items \
                    that\n// `crates/xtask/src/shaders/shared/table.rs` names: change those, not this file.\n";

/// Gives the text of a Rust file by its path relative to the folder `crates`.
pub type Read<'a> = &'a dyn Fn(&str) -> Result<String, String>;

/// The text of the generated module.
pub fn generate(read: Read) -> Result<String, String> {
    let mut parts = vec![HEAD.to_string()];
    for source in TABLE {
        let error = |error: String| format!("crates/{}: {error}", source.file);
        let file = syn::parse_file(&read(source.file)?).map_err(|fault| error(fault.to_string()))?;
        parts.push(format!("\n// From `crates/{}`.\n\n", source.file));
        for item in source.items {
            parts.push(declaration(&file, item).map_err(error)?);
        }
    }
    Ok(tidied(&parts.concat()))
}

/// The text with one blank line between blocks, and the shaders' names of constants of types.
fn tidied(text: &str) -> String {
    let mut text = text.trim_end().to_string() + "\n";
    while text.contains("\n\n\n") {
        text = text.replace("\n\n\n", "\n\n");
    }
    let items = TABLE.iter().flat_map(|source| source.items);
    items.filter(|item| item.rust.contains("::")).fold(text, |text, item| text.replace(item.rust, item.shader))
}

/// An item in Slang.
fn declaration(file: &File, item: &table::Item) -> Result<String, String> {
    let constants = constants_of(&file.items);
    let constant = match item.rust.split_once("::") {
        Some((owner, name)) => constant_of(file, owner, name),
        None => constants.iter().copied().find(|constant| constant.name == item.rust),
    };
    if let Some(constant) = constant {
        return constants::constant(item.shader, constant, &constants);
    }
    for other in &file.items {
        match other {
            Item::Enum(enumeration) if enumeration.ident == item.rust => {
                return constants::enumeration(item.shader, enumeration);
            }
            Item::Mod(module) if module.ident == item.rust => return constants::module(item.shader, module),
            Item::Struct(record) if record.ident == item.rust => {
                return records::record(item.shader, record, item.layout, &record_name);
            }
            _ => {}
        }
    }
    Err(format!("no item {}", item.rust))
}

/// The constant `OWNER::NAME` of a type.
fn constant_of<'a>(file: &'a File, owner: &str, name: &str) -> Option<Constant<'a>> {
    let members = file.items.iter().filter_map(|item| match item {
        Item::Impl(implementation) => match &*implementation.self_ty {
            Type::Path(path) if path.path.is_ident(owner) => Some(&implementation.items),
            _ => None,
        },
        _ => None,
    });
    members.flatten().find_map(|member| match member {
        ImplItem::Const(constant) if constant.ident == name => Some(constant.into()),
        _ => None,
    })
}

/// The shaders' name of a record of the host.
fn record_name(rust: &str) -> Option<&'static str> {
    TABLE.iter().flat_map(|source| source.items).find(|item| item.rust == rust).map(|item| item.shader)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;
    use std::path::Path;

    fn read(file: &str) -> Result<String, String> {
        let crates = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        fs::read_to_string(crates.join(file)).map_err(|error| error.to_string())
    }

    /// What is generated where a Rust file says something else in one place.
    fn with(file: &str, from: &str, to: &str) -> Result<String, String> {
        let text = read(file)?;
        assert!(text.contains(from), "{file} has {from}");
        generate(&|other| if other == file { Ok(text.replacen(from, to, 1)) } else { read(other) })
    }

    /// Whether the committed module is the one that the Rust files give.
    fn is_committed(generated: &str) -> bool {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(FILE);
        fs::read_to_string(path).unwrap().replace("\r\n", "\n") == generated
    }

    #[test]
    fn the_committed_module_is_what_the_rust_files_give() {
        let generated = generate(&read).unwrap();
        assert!(is_committed(&generated), "run `cargo xtask shaders` and commit");
        assert!(!is_committed(&generated.replacen("uint grid;", "uint model;", 1)), "an edit by hand");

        for (file, from, to) in [
            ("voxtrace-core/src/packed/mod.rs", "CELL_OCCUPIED: u32 = 1 << 31", "CELL_OCCUPIED: u32 = 1 << 30"),
            ("voxtrace-core/src/packed/mod.rs", "pub top_size: IVec3", "pub top_size: Vec3"),
            ("voxtrace-core/src/packed/mod.rs", "pub leaf: u32", "pub branch: u32"),
            ("voxtrace-core/src/packed/mod.rs", "power: [f32; 6]", "power: [f32; 5]"),
            (
                "voxtrace-core/src/packed/mod.rs",
                "/// Voxel at the lowest corner of the top array.",
                "/// Highest corner.",
            ),
            ("voxtrace-core/src/walk/local_ray.rs", "6.0 * 0.5 * f32::EPSILON", "5.0 * 0.5 * f32::EPSILON"),
            ("voxtrace-vulkan/src/records.rs", "GRIDS: u32 = 3", "GRIDS: u32 = 4"),
            ("voxtrace-vulkan/src/records.rs", "CameraRays = 1", "CameraRays = 2"),
            ("voxtrace-core/src/frame_params.rs", "region: [u32; 4]", "region: [u32; 2]"),
        ] {
            assert!(!is_committed(&with(file, from, to).unwrap()), "{file}: {to}");
        }
    }

    #[test]
    fn what_shaders_cannot_have_is_refused() {
        let packed = "voxtrace-core/src/packed/mod.rs";
        let records = "voxtrace-vulkan/src/records.rs";
        for (file, from, to, fault) in [
            (packed, "#[repr(C)]\npub struct PackedGrid", "pub struct PackedGrid", "PackedGrid: not #[repr(C)]"),
            (packed, "pub ior: f32", "pub ior: f64", "PackedMaterial: shaders have no type for the member `ior`"),
            (packed, "pub struct Emitter", "pub struct Lamp", "no item Emitter"),
            (packed, "u32 = 1 << 31", "u32 = 1 << 32", "CELL_OCCUPIED: shaders have no u32 with the value"),
            (packed, "u32 = 1 << 31", "u32 = occupied()", "CELL_OCCUPIED: too difficult an expression"),
            (packed, "pub const NONE: u32", "pub const NO: u32", "no item LightNode::NONE"),
            (records, "Sequence = 0", "Sequence", "COUNTER_SEQUENCE: no number"),
            (
                "voxtrace-core/src/frame_params.rs",
                "region: [u32; 4]",
                "region: [u32; 5]",
                "shaders have no type for the member `region`",
            ),
            (records, "pub struct Dispatch {", "pub struct Dispatch", "records.rs: "),
        ] {
            let error = with(file, from, to).unwrap_err();
            assert!(error.starts_with(&format!("crates/{file}: ")) && error.contains(fault), "{to}: {error}");
        }
    }

    #[test]
    fn what_rust_says_is_what_slang_says() {
        let generated = generate(&read).unwrap();
        for expected in [
            "// One placed grid.\nstruct PackedInstance\n{\n    // From world to grid space.\n    Transform grid_from_world;\n",
            "    float x_axis[3];\n    float y_axis[3];\n    float z_axis[3];\n",
            "    uint radiance[6];\n",
            "    // Ray origin, world space.\n    float3 eye;\n",
            "    uint4 region;\n",
            "    float4 planes[12];\n",
            "static const uint CELL_OCCUPIED = 0x80000000u;\n",
            "static const float BELOW_ONE = 0.99999994;\n",
            "static const uint PRIMITIVE_VOXEL_APPROX = 1;\n",
            "// `FrameParams`.\nstatic const uint BINDING_FRAME = 9;\n",
            "`NO_NODE` where its grid emits nothing",
        ] {
            assert!(generated.contains(expected), "{expected}");
        }
    }
}
