//! Documentation of Rust items as comments of Slang.

use syn::{Attribute, Expr, Lit, Meta};

/// The comment that says what the documentation says, each line after `indent`. Links become plain names.
pub fn comment(indent: &str, attributes: &[Attribute]) -> String {
    let mut text = String::new();
    for attribute in attributes.iter().filter(|attribute| attribute.path().is_ident("doc")) {
        let Meta::NameValue(documentation) = &attribute.meta else { continue };
        let Expr::Lit(line) = &documentation.value else { continue };
        let Lit::Str(line) = &line.lit else { continue };
        let line = line.value().replace("[`", "`").replace("`]", "`").replace("`super::", "`").replace("`Self::", "`");
        let line = format!("{indent}//{line}");
        text += &format!("{}\n", line.trim_end());
    }
    text
}
