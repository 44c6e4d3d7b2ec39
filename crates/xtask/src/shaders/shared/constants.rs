//! Constants, enumerations and modules of constants in Slang.

use super::text::comment;
use super::value::{Value, value};
use syn::{Attribute, Expr, Ident, ImplItemConst, Item, ItemConst, ItemEnum, ItemMod, Type};

/// A constant in Rust, of a module or of a type.
#[derive(Clone, Copy)]
pub struct Constant<'a> {
    /// Its name.
    pub name: &'a Ident,
    /// What it is computed from.
    pub expression: &'a Expr,
    kind: &'a Type,
    attributes: &'a [Attribute],
}

impl<'a> From<&'a ItemConst> for Constant<'a> {
    fn from(item: &'a ItemConst) -> Self {
        Self { name: &item.ident, expression: &item.expr, kind: &item.ty, attributes: &item.attrs }
    }
}

impl<'a> From<&'a ImplItemConst> for Constant<'a> {
    fn from(item: &'a ImplItemConst) -> Self {
        Self { name: &item.ident, expression: &item.expr, kind: &item.ty, attributes: &item.attrs }
    }
}

/// The constants among some items.
pub fn constants_of(items: &[Item]) -> Vec<Constant<'_>> {
    items.iter().filter_map(|item| if let Item::Const(item) = item { Some(item.into()) } else { None }).collect()
}

/// A constant. Its expression may name those of `scope`.
pub fn constant(name: &str, constant: Constant, scope: &[Constant]) -> Result<String, String> {
    if let (Type::Array(array), Expr::Array(elements)) = (constant.kind, constant.expression) {
        let of = |element| of_type(name, &array.elem, element, scope);
        let elements = elements.elems.iter().map(of).collect::<Result<Vec<_>, String>>()?;
        let kind = elements.first().ok_or_else(|| format!("{name}: an empty array"))?.0;
        let texts: Vec<&str> = elements.iter().map(|(_, text)| text.as_str()).collect();
        let (place, values) = (format!("{name}[{}]", texts.len()), format!("{{ {} }}", texts.join(", ")));
        return Ok(declaration(&place, constant.attributes, (kind, values)));
    }
    Ok(declaration(name, constant.attributes, of_type(name, constant.kind, constant.expression, scope)?))
}

/// Type and text of the value of an expression of a type in Slang.
fn of_type(name: &str, kind: &Type, expression: &Expr, scope: &[Constant]) -> Result<(&'static str, String), String> {
    let number = value(expression, scope).ok_or_else(|| format!("{name}: too difficult an expression"))?;
    let Type::Path(kind) = kind else { return Err(format!("{name}: shaders have no such type")) };
    let kind = kind.path.get_ident().map(ToString::to_string).unwrap_or_default();
    literal(name, &kind, number)
}

/// The constants `PREFIX_NAME` of a module of constants.
pub fn module(prefix: &str, module: &ItemMod) -> Result<String, String> {
    let constants = constants_of(module.content.as_ref().map_or(&[], |(_, items)| items));
    let constants = constants.iter().map(|&item| constant(&format!("{prefix}_{}", item.name), item, &constants));
    Ok(block(constants.collect::<Result<_, String>>()?))
}

/// The constants `PREFIX_NAME` of the numbers of an enumeration.
pub fn enumeration(prefix: &str, enumeration: &ItemEnum) -> Result<String, String> {
    let constants = enumeration.variants.iter().map(|variant| {
        let name = format!("{prefix}_{}", upper_case(&variant.ident.to_string()));
        let number = |(_, expression): &(_, Expr)| value(expression, &[]);
        let number = variant.discriminant.as_ref().and_then(number).ok_or_else(|| format!("{name}: no number"))?;
        literal(&name, "u32", number).map(|literal| declaration(&name, &variant.attrs, literal))
    });
    Ok(block(constants.collect::<Result<_, String>>()?))
}

/// Constants that belong together.
fn block(constants: String) -> String {
    format!("\n{constants}\n")
}

fn declaration(name: &str, attributes: &[Attribute], (kind, number): (&str, String)) -> String {
    format!("{}static const {kind} {name} = {number};\n", comment("", attributes))
}

/// Type and text of a number in Slang.
fn literal(name: &str, rust: &str, number: Value) -> Result<(&'static str, String), String> {
    let literal = match (rust, number) {
        ("u32" | "usize", Value::Integer(number)) => {
            u32::try_from(number).ok().map(|number| ("uint", unsigned(number)))
        }
        ("i32", Value::Integer(number)) => i32::try_from(number).ok().map(|number| ("int", number.to_string())),
        ("f32", Value::Float(number)) if number.is_finite() => {
            let text = format!("{number:?}");
            // Slang reads numbers in double precision and rounds them again.
            text.parse::<f64>().is_ok_and(|read| read as f32 == number).then_some(("float", text))
        }
        _ => None,
    };
    literal.ok_or_else(|| format!("{name}: shaders have no {rust} with the value {number:?}"))
}

/// Large numbers are bits rather than counts.
fn unsigned(number: u32) -> String {
    if number < 1 << 16 { number.to_string() } else { format!("{number:#x}u") }
}

/// `UPPER_CASE` of `UpperCase`.
fn upper_case(name: &str) -> String {
    let mut text = String::new();
    for letter in name.chars() {
        if letter.is_uppercase() && !text.is_empty() {
            text.push('_');
        }
        text.extend(letter.to_uppercase());
    }
    text
}
