//! Deflections that no drivetrain has: teeth that bend by a share of their module, shafts that twist by more than a turn. The equations are
//! linear in them and do not notice. Most often a stiffness or a torque has a wrong unit.

use std::f64::consts::TAU;

use super::orders::force;
use crate::model::{Output, Role};
use crate::scene::Scene;
use crate::tolerance::analysis::TOOTH_DEFLECTION;
use crate::trajectory::Trajectory;

/// Begin of the names of outputs that are twists of shafts.
const TWIST: &str = "shaft_twist";

/// An absurd deflection of a run.
#[derive(Debug, Clone, Copy)]
pub enum Absurd {
    /// The mesh with this force bends its teeth by so many modules \[1\].
    Teeth(&'static Output, f64),
    /// This output is a twist of so many turns \[1\].
    Twist(&'static Output, f64),
}

/// The absurd deflections of a run from the time `from` \[s\] on, among the forces and twists that it recorded.
pub fn of(scene: &Scene, run: &Trajectory, from: f64) -> Vec<Absurd> {
    let largest = |name: &str| {
        let column = &run.output(name)?[run.row_from(from)..];
        Some(column.iter().fold(0.0, |m: f64, x| m.max(x.abs())))
    };
    let laws = scene.present().zip(&scene.modules).filter(|((law, _), _)| law.role == Role::Stiffness);
    let teeth = laws.filter_map(|((law, profile), module)| {
        let force = force(scene.model, law.name)?;
        // The torque of `gear_pair` on the driving gear is k phi N_1, and phi about the deflection in modules.
        let module = if law.unit == "N/m" { (*module)? } else { scene.parameter("N1")? };
        let modules = largest(force.name)? / profile.extremes().1 / module;
        (modules > TOOTH_DEFLECTION).then_some(Absurd::Teeth(force, modules))
    });
    let twists = run.outputs.iter().map(|(output, _)| *output).filter(|output| output.name.starts_with(TWIST));
    let twists = twists.filter_map(|output| {
        let turns = largest(output.name)? / TAU;
        (turns > 1.0).then_some(Absurd::Twist(output, turns))
    });
    teeth.chain(twists).collect()
}
