//! WGSL whose sums and roundings are all rounded, each by itself. WGSL lets implementations round a · b + c once instead of twice, and take (a + b) − a for b (WGSL, "Reassociation and
//! Fusion"), and drivers do; films of pages would then have other words than those of the processor. The bits of each sum and product go through an or with a word that is 0,
//! which compilers do not know. An exclusive or would not do: of two in a row, where there was a factor of 1 between them, drivers make none.

use super::compile::validated;
use naga::{BinaryOperator, Expression, Handle, ScalarKind, TypeInner};
use std::collections::BTreeSet;
use std::fmt::Write;

/// The word that is 0: pages leave it so.
const ZERO: &str = "dispatch_0.sequence_0";

/// The module with all its sums and roundings of floats rounded.
///
/// # Errors
/// Where it is not valid, has no [`ZERO`], or multiplies by a matrix.
pub fn round_all(text: &str) -> Result<String, String> {
    if !text.contains("var<uniform> dispatch_0") || !text.contains("sequence_0") {
        return Err(format!("a module of films has no {ZERO}"));
    }
    let (module, info) = validated(text)?;
    let functions = module.functions.iter().map(|(handle, function)| (function, &info[handle]));
    let entries = module.entry_points.iter().enumerate();
    let entries = entries.map(|(index, entry)| (&entry.function, info.get_entry_point(index)));
    // Where sums and roundings begin and end, and how many components they have.
    let mut roundings: BTreeSet<(usize, usize, usize)> = BTreeSet::new();
    for (function, info) in functions.chain(entries) {
        for (handle, expression) in function.expressions.iter() {
            let Expression::Binary { op, left, right } = *expression else { continue };
            if !matches!(op, BinaryOperator::Multiply | BinaryOperator::Add | BinaryOperator::Subtract) {
                continue;
            }
            let inner = |handle: Handle<Expression>| info[handle].ty.inner_with(&module.types);
            if [left, right].iter().any(|&factor| matches!(inner(factor), TypeInner::Matrix { .. })) {
                return Err("a product of a matrix has sums of its own".into());
            }
            let components = match inner(handle) {
                TypeInner::Scalar(scalar) if scalar.kind == ScalarKind::Float => 1,
                TypeInner::Vector { size, scalar } if scalar.kind == ScalarKind::Float => *size as usize,
                _ => continue,
            };
            let range = function.expressions.get_span(handle).to_range().ok_or("an expression has no place")?;
            roundings.insert((range.start, range.end, components));
        }
    }
    let mut out = String::with_capacity(text.len() * 5 / 4);
    let mut open: Vec<usize> = Vec::new();
    let mut starts = roundings.iter().copied().collect::<Vec<_>>();
    // Of those that begin at one place the longest first.
    starts.sort_by_key(|&(start, end, _)| (start, std::cmp::Reverse(end)));
    let mut starts = starts.into_iter().peekable();
    for (at, letter) in text.char_indices() {
        while open.last() == Some(&at) {
            open.pop();
            out.push(')');
        }
        while let Some((_, end, components)) = starts.next_if(|&(start, ..)| start == at) {
            write!(out, "exact_{components}(").expect("text grows");
            open.push(end);
        }
        out.push(letter);
    }
    out.push_str(&")".repeat(open.len()));
    for components in BTreeSet::from_iter(roundings.iter().map(|&(.., components)| components)) {
        let of = |scalar: &str| match components {
            1 => scalar.to_string(),
            _ => format!("vec{components}<{scalar}>"),
        };
        let (float, word) = (of("f32"), of("u32"));
        write!(
            out,
            "\nfn exact_{components}(x_0 : {float}) -> {float}\n{{\n    return bitcast<{float}>(bitcast<{word}>(x_0) | {word}({ZERO}));\n}}\n"
        )
        .expect("text grows");
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    const MODULE: &str = "struct Dispatch_0 { first_0 : u32, sequence_0 : u32, };\n\
        @binding(0) @group(0) var<uniform> dispatch_0 : Dispatch_0;\n\
        @binding(1) @group(0) var<storage, read_write> words_0 : array<vec4<f32>>;\n\
        @compute @workgroup_size(64, 1, 1)\nfn run(@builtin(global_invocation_id) id_0 : vec3<u32>)\n{\n\
        let at_0 : u32 = id_0.x * dispatch_0.first_0;\n    let row_0 : vec4<f32> = words_0[at_0];\n\
        words_0[at_0] = row_0 * 2.0f + vec4<f32>((row_0.x * row_0.y * (row_0.z - 1.0f * row_0.w)) - row_0.y);\n}\n";

    #[test]
    fn sums_and_products_of_floats_are_rounded_and_those_of_words_stay() {
        let text = round_all(MODULE).unwrap();
        assert!(text.contains("= exact_4(exact_4(row_0 * 2.0f) + vec4"), "{text}");
        let inner =
            "(exact_1((exact_1(exact_1(row_0.x * row_0.y) * (exact_1(row_0.z - exact_1(1.0f * row_0.w))))) - row_0.y))";
        assert!(text.contains(inner), "{text}");
        assert!(text.contains("id_0.x * dispatch_0.first_0;"), "{text}");
        validated(&text).unwrap();
    }

    #[test]
    fn what_cannot_be_rounded_is_refused() {
        round_all(&MODULE.replace("sequence_0", "other_0")).unwrap_err();
        let matrix = "mat2x2<f32>(1.0f, 0.0f, 0.0f, 1.0f) * row_0.xy";
        let error = round_all(&MODULE.replace("row_0.x * row_0.y", &format!("({matrix}).x"))).unwrap_err();
        assert!(error.contains("matrix"), "{error}");
    }
}
