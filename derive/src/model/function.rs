//! Named functions of positions, and their derivatives.
//!
//! A function f of one position has the derivatives `df`, `ddf`, `dddf`. A function of several positions x, y, .. has `f_by_x` and
//! `f_by_x_by_y`. Its author gives the first derivatives, so that they are short, and the derivation proves them.

use symbolica::atom::{Atom, AtomCore};

use super::Model;
use crate::expr::{Expr, Kind, number, symbol, symbols, total};

/// A named function of one position, or of several.
pub(crate) struct Function {
    pub name: String,
    /// The positions: coordinates or named deflections that are linear.
    pub of: Vec<Expr>,
    /// The function, in the symbols of the positions.
    pub value: Expr,
    /// Its derivatives by the positions, if there are several.
    pub gradient: Vec<Expr>,
    /// The effect without which it is zero.
    pub with: Option<String>,
}

/// A named function, or a derivative of it.
pub(crate) struct Derivative {
    pub name: String,
    /// In the symbols of the positions.
    pub value: Atom,
    /// Its own derivatives by the positions: indices in the list of all; empty for those of the highest order.
    pub next: Vec<usize>,
}

impl Function {
    /// Number of derivatives of a function of one position, the function itself included. The Jacobian of the forces needs the third
    /// derivative of a function in T.
    const ORDERS: usize = 4;

    /// Whether it is one of several positions: V and D may contain it, T may not.
    pub fn is_of_several(&self) -> bool {
        self.of.len() > 1
    }

    /// The function and its derivatives: of one position up to the third, of several up to the second.
    pub fn derivatives(&self) -> Vec<Derivative> {
        let positions: Vec<_> = self.of.iter().filter_map(|of| symbols(&of.atom()).into_iter().next()).collect();
        if self.is_of_several() { self.of_several(&positions) } else { self.of_one(positions.first()) }
    }

    fn of_one(&self, by: Option<&(Kind, String)>) -> Vec<Derivative> {
        let mut values = vec![self.value.atom()];
        for _ in 1..Function::ORDERS {
            let last = values.last().cloned().unwrap_or_default();
            let slope = by.map_or_else(Atom::default, |(kind, name)| last.derivative(symbol(*kind, name)));
            values.push(crate::trigonometry::shorter(&slope));
        }
        let name = |order: usize| format!("{}{}", "d".repeat(order), self.name);
        let next = |order: usize| if order + 1 < Function::ORDERS { vec![order + 1] } else { vec![] };
        let each = values.into_iter().enumerate();
        each.map(|(order, value)| Derivative { name: name(order), value, next: next(order) }).collect()
    }

    fn of_several(&self, positions: &[(Kind, String)]) -> Vec<Derivative> {
        let n = self.of.len();
        let pairs: Vec<(usize, usize)> = (0..n).flat_map(|i| (i..n).map(move |j| (i, j))).collect();
        let second = |i: usize, j: usize| 1 + n + pairs.iter().position(|p| *p == (i.min(j), i.max(j))).unwrap_or(0);
        let name = |by: &[usize]| {
            let by = by.iter().filter_map(|i| positions.get(*i)).map(|(_, name)| format!("_by_{name}"));
            format!("{}{}", self.name, by.collect::<String>())
        };
        let mut all = vec![Derivative { name: name(&[]), value: self.value.atom(), next: (1..=n).collect() }];
        for (i, slope) in self.gradient.iter().enumerate() {
            let next = (0..n).map(|j| second(i, j)).collect();
            all.push(Derivative { name: name(&[i]), value: slope.atom(), next });
        }
        for &(i, j) in &pairs {
            let slope = self.gradient.get(i).map(|slope| slope.atom()).unwrap_or_default();
            let value =
                positions.get(j).map_or_else(Atom::default, |(kind, name)| slope.derivative(symbol(*kind, name)));
            all.push(Derivative { name: name(&[i, j]), value, next: vec![] });
        }
        all
    }
}

impl Model {
    /// Names a smooth function of one position, for example the place of a piston as a function of the angle of its crank. The position
    /// `of` is a coordinate or a named deflection without transmission errors; `value` computes the function from it. T, V and the
    /// displacements of torques may be written in the function and its `.dot()`. The equations then contain the function and its
    /// derivatives as `name`, `dname`, `ddname` and `dddname`; they are not multiplied out. A holonomic constraint is stated in this way:
    /// solved for one quantity.
    pub fn function(&mut self, name: &str, of: Expr, value: impl FnOnce(Expr) -> Expr) -> Expr {
        let (name, of, value) = (name.into(), vec![of], value(of));
        self.declare_function(Function { name, of, value, gradient: vec![], with: None })
    }

    /// Names a smooth function of several positions, for example the angle by which a line of action turns as the centres of gears move.
    /// The positions `of` are coordinates or named deflections without transmission errors. `value` and `gradient` compute from them the
    /// function and its derivatives by them; the derivation proves that both agree. A function that is named inside the closure of an
    /// effect is zero in scenes without the effect. V may be written in it, and so may deflections: these then bend, which means that they
    /// are not linear in the coordinates. The equations are written in the function and its derivatives `name_by_x`, `name_by_x_by_y`.
    pub fn function_of<const N: usize>(
        &mut self,
        name: &str,
        of: [Expr; N],
        value: impl FnOnce([Expr; N]) -> Expr,
        gradient: impl FnOnce([Expr; N]) -> [Expr; N],
    ) -> Expr {
        let (value, gradient, with) = (value(of), gradient(of).to_vec(), self.innermost());
        self.declare_function(Function { name: name.into(), of: of.to_vec(), value, gradient, with })
    }

    fn declare_function(&mut self, function: Function) -> Expr {
        let name = function.name.clone();
        Expr::set_rate(&name, Expr::new(self.function_rate(&function, 0)));
        self.functions.push(function);
        Expr::var(Kind::Function, &name)
    }

    /// The rate of a function, or of one of its derivatives, in the speeds: the sum of its derivatives times the rates of the positions, with
    /// the marker of its effect.
    pub(crate) fn function_rate(&self, function: &Function, derivative: usize) -> Atom {
        let all = function.derivatives();
        let next = all.get(derivative).map(|d| d.next.clone()).unwrap_or_default();
        let parts = next.into_iter().zip(&function.of).filter_map(|(next, of)| {
            Some(Atom::var(symbol(Kind::Function, &all.get(next)?.name)) * self.position(*of).dot().atom())
        });
        let marker = function.with.as_ref().map_or(number(1), |effect| Atom::var(symbol(Kind::Marker, effect)));
        marker * total(parts.collect())
    }

    /// A coordinate, or a named deflection written in the coordinates.
    pub(crate) fn position(&self, of: Expr) -> Expr {
        let named = self.deflections.iter().find(|d| of.atom() == Expr::var(Kind::Deflection, &d.name).atom());
        named.map_or(of, |d| d.value)
    }
}
