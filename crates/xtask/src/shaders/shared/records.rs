//! Records in Slang. Where they lie in storage buffers, vectors become arrays of scalars, so that every target gives records the layout
//! that they have on the host. Uniform buffers have rows of 16 bytes and vectors; that the members keep to the rows, the test of offsets
//! sees (`voxtrace-tests/tests/record_layout.rs`).

use super::text::comment;
use syn::{Expr, Fields, ItemStruct, Lit, Meta, Type, TypeArray};

/// The kind of buffer that records lie in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Layout {
    /// A storage buffer.
    Storage,
    /// A uniform buffer.
    Uniform,
}

/// A record. `shader_name` gives the names of other records.
pub fn record(
    name: &str,
    record: &ItemStruct,
    layout: Layout,
    shader_name: &dyn Fn(&str) -> Option<&'static str>,
) -> Result<String, String> {
    let is_c =
        |meta: &Meta| matches!(meta, Meta::List(list) if list.path.is_ident("repr") && list.tokens.to_string() == "C");
    if !record.attrs.iter().any(|attribute| is_c(&attribute.meta)) {
        return Err(format!("{name}: not #[repr(C)]"));
    }
    let Fields::Named(fields) = &record.fields else { return Err(format!("{name}: members have no names")) };
    let mut text = format!("\n{}struct {name}\n{{\n", comment("", &record.attrs));
    for field in &fields.named {
        let member = field.ident.as_ref().map(ToString::to_string).unwrap_or_default();
        text += &comment("    ", &field.attrs);
        let unknown = || format!("{name}: shaders have no type for the member `{member}`");
        for (member, kind) in members(&member, &field.ty, shader_name).ok_or_else(unknown)? {
            text += &format!("    {}\n", kind.declaration(&member, layout).ok_or_else(unknown)?);
        }
    }
    Ok(text + "}\n\n")
}

/// The type of a member in Slang.
enum Kind {
    /// So many scalars one after the other.
    Scalars(&'static str, usize),
    /// So many vectors of four of them.
    Rows(&'static str, usize),
    /// Another record.
    Record(&'static str),
}

impl Kind {
    fn declaration(&self, member: &str, layout: Layout) -> Option<String> {
        match (self, layout) {
            (Self::Record(kind), _) | (Self::Scalars(kind, 1), _) => Some(format!("{kind} {member};")),
            (Self::Scalars(kind, count), Layout::Storage) => Some(format!("{kind} {member}[{count}];")),
            (Self::Scalars(kind, count @ 2..=4), Layout::Uniform) => Some(format!("{kind}{count} {member};")),
            (Self::Rows(kind, count), Layout::Uniform) => Some(format!("{kind}4 {member}[{count}];")),
            (Self::Scalars(..), Layout::Uniform) | (Self::Rows(..), Layout::Storage) => None,
        }
    }
}

/// The members in Slang of one in Rust: a matrix becomes its columns.
fn members(
    member: &str,
    rust: &Type,
    shader_name: &dyn Fn(&str) -> Option<&'static str>,
) -> Option<Vec<(String, Kind)>> {
    let one = |kind| Some(vec![(member.to_string(), kind)]);
    match rust {
        Type::Path(path) if path.path.is_ident("Mat3") => {
            let column = |axis| (format!("{axis}_axis"), Kind::Scalars("float", 3));
            Some(["x", "y", "z"].map(column).into())
        }
        Type::Path(path) => {
            let rust = path.path.get_ident()?.to_string();
            match scalars(&rust) {
                Some((kind, count)) => one(Kind::Scalars(kind, count)),
                None => one(Kind::Record(shader_name(&rust)?)),
            }
        }
        Type::Array(array) => {
            let length = length_of(array)?;
            match &*array.elem {
                Type::Array(row) if length_of(row)? == 4 => one(Kind::Rows(element(row)?.0, length)),
                _ => element(array).and_then(|(kind, count)| one(Kind::Scalars(kind, count * length))),
            }
        }
        _ => None,
    }
}

/// Type and number of the scalars of an array's element.
fn element(array: &TypeArray) -> Option<(&'static str, usize)> {
    let Type::Path(element) = &*array.elem else { return None };
    scalars(&element.path.get_ident()?.to_string())
}

fn length_of(array: &TypeArray) -> Option<usize> {
    let Expr::Lit(length) = &array.len else { return None };
    let Lit::Int(length) = &length.lit else { return None };
    length.base10_parse().ok()
}

/// Type and number of the scalars of a Rust type. A word of 64 bits is its low and its high half.
fn scalars(rust: &str) -> Option<(&'static str, usize)> {
    match rust {
        "f32" => Some(("float", 1)),
        "i32" => Some(("int", 1)),
        "u32" => Some(("uint", 1)),
        "u64" => Some(("uint", 2)),
        "Vec3" => Some(("float", 3)),
        "IVec3" => Some(("int", 3)),
        _ => None,
    }
}
