//! Evaluates an expression with numbers for its symbols. If the value is not zero, the expression is not identically zero. This takes a few
//! microseconds; algebra needs a millisecond to find no proof. Only algebra decides that an expression is zero.

use symbolica::atom::{Atom, AtomView, Symbol};
use symbolica::coefficient::CoefficientView;

/// A value, and a measure of its rounding error: the sum of the sizes of the numbers that it was computed from.
#[derive(Clone, Copy)]
struct Value {
    value: f64,
    size: f64,
}

/// A value that is larger than this fraction of its size is not a rounding error, after up to some 1e4 operations.
const ROUNDING: f64 = 1e-9;

/// Whether the expression has a value other than zero for one choice of the numbers for its symbols. `false` does not mean that the
/// expression is zero.
pub(crate) fn is_somewhere_nonzero(e: &Atom) -> bool {
    value(e.as_view()).is_some_and(|v| v.size.is_finite() && v.value.abs() > ROUNDING * v.size)
}

/// `None` for a function other than sine and cosine, and if a power has no finite real value.
fn value(e: AtomView) -> Option<Value> {
    match e {
        AtomView::Num(n) => match n.get_coeff_view() {
            CoefficientView::Natural(n, d, 0, _) => Some(exact(n as f64 / d as f64)),
            _ => None,
        },
        AtomView::Var(x) => Some(exact(number_of(x.get_symbol()))),
        AtomView::Fun(f) => {
            let arguments: Vec<Value> = f.iter().map(value).collect::<Option<_>>()?;
            let [x] = arguments[..] else { return None };
            let value = match f.get_symbol() {
                sin if sin == Symbol::SIN => x.value.sin(),
                cos if cos == Symbol::COS => x.value.cos(),
                _ => return None,
            };
            Some(Value { value, size: 1.0 + x.size })
        }
        AtomView::Pow(p) => {
            let (base, exponent) = p.get_base_exp();
            let (x, n) = (value(base)?, value(exponent)?.value);
            let power = if n.fract() == 0.0 { x.value.powi(n as i32) } else { x.value.powf(n) };
            // The relative error of the base, times the exponent.
            let size = power.abs() * (x.size / x.value.abs()) * n.abs().max(1.0);
            power.is_finite().then_some(Value { value: power, size })
        }
        AtomView::Mul(m) => m.iter().try_fold(exact(1.0), |product, factor| {
            let x = value(factor)?;
            Some(Value { value: product.value * x.value, size: product.size * x.size })
        }),
        AtomView::Add(a) => a.iter().try_fold(exact(0.0), |sum, term| {
            let x = value(term)?;
            Some(Value { value: sum.value + x.value, size: sum.size + x.size })
        }),
    }
}

fn exact(value: f64) -> Value {
    Value { value, size: value.abs() }
}

/// A number between 1 and 2 that differs from symbol to symbol.
fn number_of(symbol: Symbol) -> f64 {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    1.0 + (f64::from(symbol.get_id()) * GOLDEN).fract()
}

#[cfg(test)]
mod tests {
    use symbolica::atom::AtomCore;

    use super::*;
    use crate::expr::{Kind, number, symbol};
    use crate::mobility::is_zero;

    #[test]
    fn only_a_value_above_the_rounding_error_refutes_a_zero() {
        let [x, y] = ["x", "y"].map(|name| Atom::var(symbol(Kind::Parameter, name)));
        let root = |e: &Atom| e.pow(number(1) / number(2));
        let square = (&x + &y) * (&x + &y);
        let zeros = [
            &square - (&x * &x + number(2) * &x * &y + &y * &y),
            number(1) / &x - &y / (&x * &y),
            root(&square) * root(&square) - &square,
        ];
        for zero in &zeros {
            assert!(is_zero(zero), "{zero}");
            assert!(!is_somewhere_nonzero(zero), "{zero}");
            assert!(is_somewhere_nonzero(&(zero + &x / number(1_000_000))), "{zero}");
        }
    }
}
