//! Values of Rust's constant expressions, as far as constants that shaders share need them.

use super::constants::Constant;
use syn::{BinOp, Expr, Lit, Path, UnOp};

/// The value of a constant. Floats are computed as the compiler does: each step in single precision.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// Of any integer type.
    Integer(i64),
    /// `f32`.
    Float(f32),
}

/// The value of an expression that may name the constants of `scope`, `None` where it is not of the simple kind that is known here.
pub fn value(expression: &Expr, scope: &[Constant]) -> Option<Value> {
    match expression {
        Expr::Lit(literal) => match &literal.lit {
            Lit::Int(number) => number.base10_parse().ok().map(Value::Integer),
            Lit::Float(number) => number.base10_parse().ok().map(Value::Float),
            _ => None,
        },
        Expr::Paren(inner) => value(&inner.expr, scope),
        Expr::Path(path) => named(&path.path, scope),
        Expr::Unary(negated) if matches!(negated.op, UnOp::Neg(_)) => match value(&negated.expr, scope)? {
            Value::Integer(number) => number.checked_neg().map(Value::Integer),
            Value::Float(number) => Some(Value::Float(-number)),
        },
        Expr::Binary(binary) => combined(&binary.op, value(&binary.left, scope)?, value(&binary.right, scope)?),
        _ => None,
    }
}

/// A constant by its name, or one of the standard library.
fn named(path: &Path, scope: &[Constant]) -> Option<Value> {
    let names: Vec<String> = path.segments.iter().map(|segment| segment.ident.to_string()).collect();
    match names.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["f32", "EPSILON"] => Some(Value::Float(f32::EPSILON)),
        ["u32", "MAX"] => Some(Value::Integer(u32::MAX.into())),
        [name] => {
            let constant = scope.iter().find(|constant| constant.name == name)?;
            value(constant.expression, scope)
        }
        _ => None,
    }
}

fn combined(operator: &BinOp, left: Value, right: Value) -> Option<Value> {
    match (left, right) {
        (Value::Integer(left), Value::Integer(right)) => {
            let number = match operator {
                BinOp::Add(_) => left.checked_add(right),
                BinOp::Sub(_) => left.checked_sub(right),
                BinOp::Mul(_) => left.checked_mul(right),
                BinOp::Div(_) => left.checked_div(right),
                BinOp::Shl(_) => u32::try_from(right).ok().and_then(|bits| left.checked_shl(bits)),
                _ => None,
            };
            number.map(Value::Integer)
        }
        (Value::Float(left), Value::Float(right)) => {
            let number = match operator {
                BinOp::Add(_) => left + right,
                BinOp::Sub(_) => left - right,
                BinOp::Mul(_) => left * right,
                BinOp::Div(_) => left / right,
                _ => return None,
            };
            Some(Value::Float(number))
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(text: &str) -> Option<Value> {
        let known: syn::ItemConst = syn::parse_str("const KNOWN: u32 = 7;").unwrap();
        value(&syn::parse_str(text).unwrap(), &[Constant::from(&known)])
    }

    #[test]
    fn values_are_those_of_the_compiler() {
        assert_eq!(of("1 << 31"), Some(Value::Integer(1 << 31)));
        assert_eq!(of("(KNOWN + 2) * 3 - 0xf / 2"), Some(Value::Integer(20)));
        assert_eq!(of("u32::MAX"), Some(Value::Integer(u32::MAX.into())));
        assert_eq!(of("-KNOWN"), Some(Value::Integer(-7)));
        assert_eq!(of("6.0 * 0.5 * f32::EPSILON"), Some(Value::Float(6.0 * 0.5 * f32::EPSILON)));
        assert_eq!(of("1.0 + 1e-6"), Some(Value::Float(1.0 + 1e-6)));
        assert_eq!(of("1.0 - f32::EPSILON / 2.0"), Some(Value::Float(1.0 - f32::EPSILON / 2.0)));
    }

    #[test]
    fn what_is_not_known_has_no_value() {
        for text in ["UNKNOWN", "f()", "1 + 1.0", "1 << -1", "1 % 2", "9223372036854775807 + 1", "1 / 0", "\"1\""] {
            assert_eq!(of(text), None, "{text}");
        }
    }
}
