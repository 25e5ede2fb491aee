//! The names that expressions may use, and the code that each name stands for. Unknown names are refused.

use std::collections::BTreeMap;

use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use syn::{BinOp, Error, Expr, Ident, Lit, UnOp, parse_quote};

use crate::equations::gated;
use crate::equations::model::{Model, Sum};

/// Methods of f64 that are smooth, with the number of their arguments.
const METHODS: [(&str, usize); 11] = [
    ("powi", 1),
    ("powf", 1),
    ("atan2", 1),
    ("atan", 0),
    ("sqrt", 0),
    ("exp", 0),
    ("ln", 0),
    ("sin", 0),
    ("cos", 0),
    ("tan", 0),
    ("recip", 0),
];

const PIECEWISE: &str = "a piecewise function: equations must be smooth in every cell; only laws and switches do";

/// The names that expressions of one block may use, each with its code.
pub struct Scope {
    block: String,
    names: BTreeMap<String, TokenStream>,
    conditions: Vec<String>,
}

impl Scope {
    /// Parameters, constants and mid values, which every equation may use, as fields of `self`.
    pub fn of(model: &Model, block: &str) -> Self {
        let conditions = model.effects.iter().map(|e| &e.name).chain(model.conditions.iter().map(|c| &c.name));
        Self {
            block: block.to_string(),
            names: model.numbers().map(|n| (n.to_string(), quote!(self.#n))).collect(),
            conditions: conditions.map(Ident::to_string).collect(),
        }
    }

    /// The names that a constant may use: parameters and mid values; `declare` adds the constants before it. All are plain variables
    /// in the function that computes the constants.
    pub fn of_constants(model: &Model) -> Self {
        let mut scope = Self { block: "constants".to_string(), names: BTreeMap::new(), conditions: vec![] };
        model.parameters.iter().for_each(|p| scope.declare(&p.name));
        model.stiffnesses().for_each(|l| scope.declare(&l.mid()));
        scope
    }

    /// Adds a name that is a plain variable.
    pub fn declare(&mut self, name: &Ident) {
        self.names.insert(name.to_string(), quote!(#name));
    }

    /// Adds the coordinates, as entries of `vector`.
    pub fn coordinates(mut self, model: &Model, vector: &str) -> Self {
        self.add(model.coordinates.iter().map(|c| c.name.to_string()), vector);
        self
    }

    /// Adds the speeds, as entries of `q_dot`.
    pub fn speeds(mut self, model: &Model) -> Self {
        self.add(model.coordinates.iter().map(|c| speed(&c.name)), "q_dot");
        self
    }

    /// Adds the accelerations, as entries of `q_ddot`.
    pub fn accelerations(mut self, model: &Model) -> Self {
        self.add(model.coordinates.iter().map(|c| format!("{}_ddot", c.name)), "q_ddot");
        self
    }

    /// Adds the deflections, as plain variables that [`crate::equations::lets`] defines.
    pub fn deflections(mut self, model: &Model) -> Self {
        model.deflections.iter().for_each(|d| self.declare(&d.name));
        self
    }

    /// Adds the functions of positions, as plain variables too.
    pub fn functions(mut self, model: &Model) -> Self {
        model.functions.iter().for_each(|f| self.declare(&f.name));
        self
    }

    /// Adds the rates of deflections, as plain variables that [`crate::equations::lets`] defines.
    pub fn rates(mut self, model: &Model) -> Self {
        model.rates.iter().for_each(|d| self.declare(&d.name));
        self
    }

    /// Adds the laws and their derivatives up to `order`, as entries of `k`, `dk`, `ddk`.
    pub fn laws(mut self, model: &Model, order: usize) -> Self {
        for vector in &["k", "dk", "ddk"][..=order] {
            let d = &vector[..vector.len() - 1];
            self.add(model.laws.iter().map(|l| format!("{d}{}", l.name)), vector);
        }
        self
    }

    /// Adds the values that exist only with an effect, as plain variables that [`crate::equations::lets`] defines.
    pub fn gated(mut self, model: &Model) -> Self {
        gated::gated(model).for_each(|gated| self.declare(gated.name));
        self
    }

    /// Adds the named forces, as plain variables that [`crate::equations::lets`] defines.
    pub fn forces(mut self, model: &Model) -> Self {
        model.forces.iter().for_each(|force| self.declare(&force.name));
        self
    }

    /// Adds the partial derivatives of the forces, as plain variables too.
    pub fn partials(mut self, model: &Model) -> Self {
        model.partials.iter().for_each(|partial| self.declare(&partial.name));
        self
    }

    /// Adds the reactions of held deflections and the powers of torques, which the engine gives to outputs.
    pub fn known(mut self, model: &Model) -> Self {
        for (i, switch) in model.switches.iter().enumerate().filter(|(_, s)| s.modes.iter().any(|mode| mode.held)) {
            self.names.insert(format!("{}_reaction", switch.over), quote!(known.reaction(#i)));
        }
        for (i, torque) in model.torques.iter().enumerate() {
            self.names.insert(format!("{}_power", torque.name), quote!(known.power(#i)));
        }
        self
    }

    /// The same names for another block.
    pub fn within(&self, block: &str) -> Self {
        Self { block: block.to_string(), names: self.names.clone(), conditions: self.conditions.clone() }
    }

    /// Adds the step of the one law that jumps, as `dk`.
    pub fn step(mut self, law: &Ident) -> Self {
        self.names.insert(format!("d{law}"), quote!(dk));
        self
    }

    fn add(&mut self, names: impl Iterator<Item = String>, vector: &str) {
        let vector = format_ident!("{vector}");
        for (i, name) in names.enumerate() {
            let i = syn::Index::from(i);
            self.names.insert(name, quote!(#vector[#i]));
        }
    }

    /// Resolves the names in every term of a sum.
    pub fn sum(&self, sum: &mut Sum, errors: &mut Vec<Error>) {
        for term in sum {
            if let Some(c) = &term.condition
                && !self.conditions.iter().any(|known| c == known)
            {
                let message = format!("`{c}` is not an effect or condition; there are: {}", self.conditions.join(", "));
                errors.push(Error::new(c.span(), message));
            }
            self.expression(&mut term.value, errors);
        }
    }

    /// Resolves the names in one expression, and refuses everything that is not in the grammar: code that could branch or have side
    /// effects never reaches the engine.
    pub fn expression(&self, e: &mut Expr, errors: &mut Vec<Error>) {
        match e {
            Expr::Paren(e) => self.expression(&mut e.expr, errors),
            Expr::Group(e) => self.expression(&mut e.expr, errors),
            Expr::Unary(e) if matches!(e.op, UnOp::Neg(_)) => self.expression(&mut e.expr, errors),
            Expr::Binary(b) => match b.op {
                BinOp::Add(_) | BinOp::Sub(_) | BinOp::Mul(_) | BinOp::Div(_) => {
                    self.expression(&mut b.left, errors);
                    self.expression(&mut b.right, errors);
                }
                _ => errors.push(Error::new_spanned(e, PIECEWISE)),
            },
            Expr::MethodCall(call) => {
                self.expression(&mut call.receiver, errors);
                if !METHODS.iter().any(|(name, n)| call.method == name && call.args.len() == *n) {
                    errors.push(method_error(&call.method));
                } else if call.method != "powi" {
                    call.args.iter_mut().for_each(|e| self.expression(e, errors));
                } else if !is_integer(&call.args[0]) {
                    errors.push(Error::new_spanned(
                        &call.args[0],
                        "`powi` takes an integer; use `powf` for other powers",
                    ));
                }
            }
            Expr::Lit(lit) if matches!(lit.lit, Lit::Float(_)) => {}
            Expr::Lit(lit) if matches!(lit.lit, Lit::Int(_)) => {
                errors.push(Error::new_spanned(lit, "an integer; write it with a decimal point: `2.0`"));
            }
            Expr::If(_) | Expr::Match(_) => errors.push(Error::new_spanned(e, PIECEWISE)),
            Expr::Path(path) if path.path.get_ident().is_some() => {
                let name = path.path.require_ident().expect("just seen").clone();
                match self.names.get(&name.to_string()) {
                    Some(tokens) => *e = parse_quote!(#tokens),
                    None => errors.push(self.unknown(&name)),
                }
            }
            _ => errors.push(Error::new_spanned(
                e,
                "not in the grammar; allowed: numbers, names, + - * /, methods such as `sqrt`",
            )),
        }
    }

    fn unknown(&self, name: &Ident) -> Error {
        let allowed: Vec<_> = self.names.keys().map(String::as_str).collect();
        Error::new(name.span(), format!("`{name}` is unknown in {}; allowed: {}", self.block, allowed.join(", ")))
    }
}

/// `theta_dot` for `theta`.
pub fn speed(coordinate: &Ident) -> String {
    format!("{coordinate}_dot")
}

fn is_integer(e: &Expr) -> bool {
    match e {
        Expr::Lit(lit) => matches!(lit.lit, Lit::Int(_)),
        Expr::Unary(e) => matches!(e.op, UnOp::Neg(_)) && is_integer(&e.expr),
        _ => false,
    }
}

fn method_error(method: &Ident) -> Error {
    let message = match method.to_string().as_str() {
        "abs" | "signum" | "max" | "min" | "clamp" | "floor" | "ceil" | "round" => PIECEWISE.to_string(),
        _ => {
            let allowed = METHODS.map(|(name, _)| name).join(", ");
            format!("`{method}` with these arguments is not a method in the grammar; allowed: {allowed}")
        }
    };
    Error::new(method.span(), message)
}
