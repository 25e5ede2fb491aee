//! The result of a derivation: equations, jump rules, cells and proofs.

mod rolling;
mod stages;

use symbolica::atom::Atom;

use crate::cell::Cell;
use crate::expr::{Expr, Kind, number, set, speed_name, symbol};
use crate::jump::Jump;
use crate::lagrange::EquationsOfMotion;
use crate::model::{JUMP_TERMS, MOVING_PHASE, Model};
use crate::print::Style;
use crate::symbols::{Partials, Symbols, Variable};
use crate::{Home, file, markers, proof, text};
pub use stages::derive;
pub(crate) use stages::{Formulas, derive_with};

/// Everything that is derived from the energies of a model.
pub struct Derivation<'a> {
    pub(crate) model: &'a Model,
    pub(crate) symbols: Symbols,
    pub(crate) motion: EquationsOfMotion,
    /// Derivatives of the generalised forces F by the coordinates, the speeds, and the deflections and rates in which they are written.
    pub(crate) jacobian: Vec<Partials>,
    /// The partial derivatives of forces in which the Jacobian is written: name, effect, value.
    pub(crate) partials: Vec<(String, Option<String>, Atom)>,
    /// The matrices of a cell, and the terms that make it nonlinear.
    pub(crate) cell: Cell,
    /// One jump rule for each law of the model.
    pub(crate) jumps: Vec<Jump>,
    /// One line for each statement proved.
    pub(crate) proofs: Vec<String>,
}

impl Derivation<'_> {
    /// The generated files: the path of each and its text. The first is the Rust file; the others have the equations as plain text and in
    /// LaTeX.
    pub fn files(&self, home: Home<'_>) -> [(String, String); 3] {
        let [file, text, latex] = file::paths(&self.model.name);
        [(file, file::write(self, home)), (text, self.text()), (latex, self.latex())]
    }

    /// The text of the generated Rust file, for a model in the repository of gearsim.
    pub fn file(&self) -> String {
        file::write(self, Home::default())
    }

    /// The derived equations in readable form.
    pub fn text(&self) -> String {
        text::write(self, Style::Plain)
    }

    /// The derived equations in LaTeX.
    pub fn latex(&self) -> String {
        text::write(self, Style::Latex)
    }

    /// What was proved, one statement for each entry.
    pub fn proofs(&self) -> &[String] {
        &self.proofs
    }

    /// The acceleration of coordinate `i`, or its generalised force if M was not inverted or depends on coordinates. It is written in the
    /// model's parameters, without the terms of the effects and conditions in `absent`.
    pub fn equation(&self, i: usize, absent: &[&str]) -> Expr {
        let all = self.motion.acceleration.as_ref().unwrap_or(&self.motion.force);
        self.in_parameters(&all[i], absent)
    }

    /// The expression without the terms of the effects and conditions in `absent`: their markers are 0, the symbols of
    /// their switches have their neutral values, their laws are 0.
    fn without(&self, e: &Atom, absent: &[&str]) -> Atom {
        let without = absent.iter().fold(e.clone(), |e, name| set(&e, symbol(Kind::Marker, name), &number(0)));
        let switches = self.model.switches.iter().filter(|switch| absent.contains(&switch.effect.as_str()));
        let without = switches.fold(without, |e, switch| switch.neutral(&e));
        let laws =
            self.model.laws.iter().filter(|law| law.with.as_deref().is_some_and(|effect| absent.contains(&effect)));
        laws.fold(without, |e, law| set(&e, symbol(law.kind(), &law.name), &number(0)))
    }

    /// 2 G dV: the decrease of the square of the normal speed at a step `dk` of law `l`, without the terms of the effects in
    /// `absent`. `None` if M was not inverted.
    pub fn speed_lost(&self, l: usize, absent: &[&str]) -> Option<Expr> {
        let jump = &self.jumps[l];
        jump.compliance.as_ref().map(|g| self.in_parameters(&(number(2) * g * &jump.step), absent))
    }

    /// The change of the speed of coordinate `i` per change of the normal speed at a step of law `l`: entry i of M⁻¹n/G. `None`
    /// if M was not inverted.
    pub fn direction(&self, l: usize, i: usize) -> Option<Expr> {
        self.jumps[l].direction.as_ref().map(|d| self.in_parameters(&d[i], &[]))
    }

    /// The expression with forces, deflections and constants written out, all remaining effects present.
    fn in_parameters(&self, e: &Atom, absent: &[&str]) -> Expr {
        let s = &self.symbols;
        let written_out = s
            .deflections
            .iter()
            .fold(self.model.written_out(e), |e, d| set(&set(&e, d.symbol, &d.of(&s.q)), d.rate_symbol, &d.rate(&s.v)));
        Expr::new(markers::all_present(&proof::exact(&self.motion, &self.without(&written_out, absent))))
    }

    /// The terms that make a cell nonlinear in every scene, each with the energy or torque it comes from. Empty if the cell is linear.
    pub fn nonlinear_terms(&self) -> &[String] {
        &self.cell.nonlinear
    }

    /// The terms that make a cell nonlinear in scenes with some effects: these effects, and the term.
    pub fn nonlinear_with(&self) -> &[(Vec<String>, String)] {
        &self.cell.nonlinear_with
    }

    /// Effects and conditions in the order in which terms are printed.
    pub(crate) fn order(&self) -> Vec<String> {
        self.model.effects.iter().map(|e| e.name.clone()).chain([JUMP_TERMS, MOVING_PHASE].map(String::from)).collect()
    }

    /// Names of the coordinates.
    pub(crate) fn coordinates(&self) -> Vec<&str> {
        self.model.coordinates.iter().map(|c| c.name.as_str()).collect()
    }

    /// The name of a coordinate, a speed, a deflection or a rate.
    pub(crate) fn name(&self, place: Variable) -> String {
        match place {
            Variable::Coordinate(i) => self.model.coordinates[i].name.clone(),
            Variable::Speed(i) => self.model.speeds()[i].clone(),
            Variable::Deflection(d) => self.model.deflections[d].name.clone(),
            Variable::Rate(d) => speed_name(&self.model.deflections[d].name),
            _ => unreachable!("nothing is differentiated by it"),
        }
    }
}
