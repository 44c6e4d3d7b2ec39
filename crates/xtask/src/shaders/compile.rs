//! Compiles one pass by slangc and validates the result.

use super::passes::{Pass, Variant};
use super::roundings;
use super::tools::Tools;
use naga::Module;
use naga::front::wgsl;
use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};
use std::collections::BTreeSet;
use std::ffi::OsStr;
use std::fs;

/// Defines the macro of modules that know all materials.
const WITH_MATERIALS: &str = "-DWITH_MATERIALS";
/// Defines the macro of modules that trace paths in waves.
const WITH_WAVES: &str = "-DWITH_WAVES";
/// Defines the macro of those of pages, which choose lights and scatter paths in shaders of their own.
const FOR_PAGES: &str = "-DFOR_PAGES";
/// Defines the macro of modules that trace paths of real-time light.
const WITH_REAL_TIME: &str = "-DWITH_REAL_TIME";
/// Defines the macro of what is compiled to WGSL.
const FOR_WGSL: &str = "-DFOR_WGSL";
/// Makes all modules read the frame's parameters from a storage buffer.
const FRAME_IN_STORAGE: [&str; 2] = ["-DFRAME_IN_STORAGE", "-Dparams=frames[0]"];

/// A pass compiled for Vulkan.
pub struct Spirv {
    /// The module.
    pub words: Vec<u8>,
    /// Slang's reflection of its parameters, JSON.
    pub reflection: String,
}

/// Compiles a pass to one valid SPIR-V module with all its entry points.
pub fn spirv(tools: &Tools, pass: &Pass, variant: &Variant) -> Result<Spirv, String> {
    let (folder, source) = prepare(pass)?;
    let (output, json) = (folder.path().join("module.spv"), folder.path().join("reflection.json"));
    // IEEE arithmetic as written, which the tests of exactness rely on: the library makes the fast modules of these. No spirv-opt: it made every
    // module slower.
    let options =
        "-I . -target spirv -profile spirv_1_5 -emit-spirv-directly -fvk-use-entrypoint-name -O0 -fp-mode precise";
    let mut arguments = vec![OsStr::new(&source)];
    arguments.extend(options.split(' ').chain(["-o"]).map(OsStr::new));
    arguments.extend([output.as_os_str(), OsStr::new("-reflection-json"), json.as_os_str()]);
    arguments.extend(variant.has_materials.then_some(OsStr::new(WITH_MATERIALS)));
    arguments.extend(variant.has_waves.then_some(OsStr::new(WITH_WAVES)));
    arguments.extend(variant.has_real_time.then_some(OsStr::new(WITH_REAL_TIME)));
    if pass.has_frame_in_storage {
        arguments.extend(FRAME_IN_STORAGE.map(OsStr::new));
    }
    tools.slangc(&arguments)?;
    tools.validate_spirv(&output)?;
    let read = |path| fs::read(path).map_err(|error| format!("slangc left no file for {}: {error}", pass.name));
    let words = read(&output)?;
    check_entries(pass, spirv_entries(&words))?;
    Ok(Spirv { words, reflection: String::from_utf8_lossy(&read(&json)?).into_owned() })
}

/// Compiles a pass in one of its variants to valid WGSL.
pub fn wgsl(tools: &Tools, pass: &Pass, variant: &Variant) -> Result<String, String> {
    let (folder, source) = prepare(pass)?;
    let output = folder.path().join("module.wgsl");
    let mut arguments = vec![OsStr::new(&source)];
    arguments.extend(["-I", ".", "-target", "wgsl", "-o"].map(OsStr::new));
    arguments.extend([output.as_os_str(), OsStr::new(FOR_WGSL)]);
    arguments.extend(variant.has_materials.then_some(OsStr::new(WITH_MATERIALS)));
    arguments.extend(variant.has_real_time.then_some(OsStr::new(WITH_REAL_TIME)));
    if variant.has_waves {
        arguments.extend([WITH_WAVES, FOR_PAGES].map(OsStr::new));
    }
    tools.slangc(&arguments)?;
    let text = fs::read_to_string(&output).map_err(|error| format!("slangc left no WGSL of {}: {error}", pass.name))?;
    let mut text = with_infinity(&text);
    if variant.has_waves && !variant.has_real_time {
        text = roundings::round_all(&text).map_err(|error| format!("WGSL of {}: {error}", pass.name))?;
    }
    let entries = wgsl_entries(&text).map_err(|error| format!("WGSL of {}: {error}", pass.name))?;
    check_entries(pass, entries)?;
    Ok(text)
}

/// The same WGSL with infinity from a variable: browsers refuse expressions of constants that are not finite (WGSL, "Floating Point Evaluation").
fn with_infinity(text: &str) -> String {
    const CONSTANT: &str = "bitcast<f32>((u32(2139095040)))";
    if !text.contains(CONSTANT) {
        return text.to_owned();
    }
    let variable = "var<private> infinity_bits_0 : u32 = 2139095040u;\n";
    format!("{variable}{}", text.replace(CONSTANT, "bitcast<f32>(infinity_bits_0)"))
}

/// A folder for outputs, and the path of the source relative to `shaders`.
fn prepare(pass: &Pass) -> Result<(tempfile::TempDir, String), String> {
    let folder = tempfile::tempdir().map_err(|error| format!("no temporary folder: {error}"))?;
    Ok((folder, format!("pass/{}.slang", pass.name)))
}

/// Refuses a module that has other entry points than the table says.
pub fn check_entries(pass: &Pass, entries: BTreeSet<String>) -> Result<(), String> {
    let table: BTreeSet<String> = pass.entries.iter().map(ToString::to_string).collect();
    if entries == table {
        return Ok(());
    }
    Err(format!("pass {} has the entry points {entries:?}, xtask's table says {table:?}", pass.name))
}

/// Names of the entry points of a valid module (SPIR-V specification 1.5, sections 2.3 and 3.32.4).
fn spirv_entries(bytes: &[u8]) -> BTreeSet<String> {
    const ENTRY_POINT: u32 = 15;
    let words: Vec<u32> =
        bytes.chunks_exact(4).map(|word| u32::from_le_bytes([word[0], word[1], word[2], word[3]])).collect();
    let (mut names, mut at) = (BTreeSet::new(), 5);
    while at < words.len() {
        let length = (words[at] >> 16).max(1) as usize;
        if words[at] & 0xffff == ENTRY_POINT {
            let name = bytes[4 * (at + 3)..].split(|&byte| byte == 0).next().unwrap_or_default();
            names.insert(String::from_utf8_lossy(name).into_owned());
        }
        at += length;
    }
    names
}

/// The module of WGSL that is valid without extensions, and what is known of it.
pub fn validated(text: &str) -> Result<(Module, ModuleInfo), String> {
    let module = wgsl::parse_str(text).map_err(|error| error.emit_to_string(text))?;
    // WGSL has packed half floats without extensions (section "Data Packing Built-in Functions").
    let mut validator = Validator::new(ValidationFlags::all(), Capabilities::SHADER_FLOAT16_IN_FLOAT32);
    let info = validator.validate(&module).map_err(|error| error.emit_to_string(text))?;
    Ok((module, info))
}

/// Names of the entry points of WGSL that is valid without extensions.
pub fn wgsl_entries(text: &str) -> Result<BTreeSet<String>, String> {
    Ok(validated(text)?.0.entry_points.into_iter().map(|entry| entry.name).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wgsl_without_bindings_is_refused() {
        let good = "@group(0) @binding(0) var<storage, read_write> data: array<f32>;
            @compute @workgroup_size(64) fn halve(@builtin(global_invocation_id) id: vec3<u32>) { data[id.x] *= 0.5; }";
        assert_eq!(wgsl_entries(good).unwrap(), BTreeSet::from(["halve".to_string()]));
        wgsl_entries(&good.replace("@group(0) @binding(0)", "")).unwrap_err();
    }
}
