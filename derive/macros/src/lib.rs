//! The `equations!` macro: from a file of derived equations to code.
//!
//! A generated file says what was derived, in the symbols of its source; the macro gives each set of effects code of
//! its own, in which the terms of absent effects do not exist. One invocation fills one module: it defines the model
//! (`GearPair` for `gear_pair`), which implements `gearsim::engine::equations::Derived`.
//!
//! # Grammar
//!
//! Blocks come in any order, each at most once (`jump` once a law). `model`, `coordinates`, `mass`, `force` and
//! `jacobian` are needed, and a `jump` for every law of a model whose effects include `stiffness_step`; the rest may
//! be left out. An oscillator whose spring k(x) steps, with a damper that may be absent:
//!
//! ```text
//! model oscillator "A mass on a stepping spring";
//! source "nobody (0000)";
//!
//! coordinates {                       // `start static`: where the forces balance
//!     x "m" start 0.0, "deflection";
//! }
//! parameters {                        // `default X`, `required` or `required with EFFECT`; `from 0.0`: 0 is admissible, `open 0.0`: it is not;
//!     m "kg" required, open 0.0 to inf, "mass";                  // `-inf` and `inf` are numbers, too
//!     b "m" required with backlash, open 0.0 to inf, "play";
//!     zeta "1" default 0.0, from 0.0 to included 1.0, "damping"; // `included`: the upper end is admissible
//! }
//! laws {                              // gives k, its slopes dk and ddk along the phase, and k_mid = (max + min)/2
//!     k "N/m" phase x period 1.0, "stiffness";                   // `period 1.0 rolling`: whole pitches of x change nothing
// e "m" phase x period 1.0 with transmission_error, "error"; // an offset of deflections: 0 without the effect; these come last
// side "1" phase x period 1.0 with friction as side, "side"; // a factor of torques; `as arm`: one that is never negative
//! }
//! motions {                           // speeds of the motion of unit size; others are zero
//!     speed "m/s" { x_dot = 1.0; }, "speed of the mass";
//! }
//! effects {
//!     stiffness_step "k steps with x";
//!     rigid_kinematics requires(stiffness_step) "without the impulse";
//!     backlash "play";
//!     damping "viscous damper";       // also: excludes(a, b)
//!     weight "a constant force of 1 N";
//! }
//! conditions {                        // conjunctions of effects present or absent
//!     jump_terms = stiffness_step, !rigid_kinematics;
//! }
//! constants {                         // of parameters, mid values and the constants before
//!     C = 2.0*zeta*(k_mid*m).sqrt();
//! }
//! deflections {                       // linear in the coordinates: also gives the rates, as `over_dot`
//!     over = x - edge;                // for potential, force, jacobian, step; the rates for D and the latter
//! }
//! dead_bands {                        // play: `over` is what is beyond it, the others constants of a cell
//!     over "m" (touch, edge, damp, clip) half b/2.0 with backlash, "play";   // 1, 0, 1, 0 without `backlash`
//! }
//! // forces { F { friction => c*k*x_dot; } }  // names for what rows of force, and powers, have in common
//! energies {                          // sums of terms `COND => EXPR;`, COND an effect, a condition, or `_` for always
//!     kinetic { _ => m*x_dot.powi(2)/2.0; }
//!     potential { _ => k*x.powi(2)/2.0; }
//!     dissipation { damping => C*x_dot.powi(2)/2.0; }
//! }
//! torques { weight "the weight" { weight => 1.0*x; } }   // work of each over the displacement x
//! // torques { fan "a fan" {} power { fan_load => -c*x_dot.powi(3); } }  // power of one that is not constant
//! work { x { weight => 1.0; } }                          // net generalised forces
//! mass { x x { _ => m; } }                               // `x y` stands for `y x`, too
//! mobility { x x { _ => 1.0/m; } }    // M⁻¹, entries as in `mass`; without it M is inverted numerically
//! force { x { _ => -k*x; weight => 1.0; damping => -C*x_dot; jump_terms => -dk*x.powi(2)/2.0; } }
//! jacobian {                          // of the force, by coordinates and by speeds; others are zero
//!     x x { _ => -k/m; jump_terms => -2.0*dk*x/m - ddk*x.powi(2)/(2.0*m); }
//!     x x_dot { damping => -C/m; }
//! }
//! cell {                              // M q'' + C q' + K q = f while the laws are constant
//!     stiffness { x x { _ => k; } }
//!     damping { x x { damping => C; } }
//!     load { x { weight => 1.0; } }
//! }
//! // nonlinear "k*x^3 in the potential energy";                // instead of `cell`, where there is none
//! // nonlinear_with { fan_load "-c*x_dot^2 in the torque `fan`"; }       // beside `cell`, which is without it
//! jump k {                            // dk: the step; only `step` is needed, the rest follows from M and the phase
//!     normal { x { _ => 1.0; } }
//!     compliance { _ => 1.0/m; }
//!     direction { x { _ => 1.0; } }
//!     step { _ => dk*x.powi(2)/2.0; }
//! }
//! text { "m x'' = ..."; }
//! latex { r"m \ddot x = ..."; }
//! ```
//!
//! Expressions are made of numbers with a point, names, `+ - * /`, parentheses and smooth methods of `f64`
//! (`powi`, `sqrt`, `sin`, ..). Nothing piecewise is let through: what switches is a law.
//!
//! How a law switches is for the effects `stiffness_step`, `rigid_kinematics` and `frozen_phase` to say, which mean
//! the same in every model; a model without one of them lacks that case.
//!
//! # Stages
//!
//! | stage | files |
//! | --- | --- |
//! | tokens to structs | `parse`, `items`, `tokens` to `model` |
//! | all errors at once, names resolved in place | `check`, `effects`, `resolve`, `scope` |
//! | constant factors, once a scene | `hoist` |
//! | structs to code | `emit`, `describe`, `varies`, `functions`, `share`, `cold`, `cells`, `jumps`, `gated`, `dead_bands`, `forces`, `sums` |

mod cells;
mod check;
mod cold;
mod dead_bands;
mod describe;
mod effects;
mod emit;
mod expand;
mod forces;
mod functions;
mod gated;
mod hoist;
mod items;
mod jumps;
mod model;
mod parse;
mod resolve;
mod scope;
mod share;
mod sums;
#[cfg(test)]
mod tests;
mod tokens;
mod varies;

use proc_macro::TokenStream;

/// Derived equations: defines a model and implements `Derived` for it, with `Equations` for each set of effects.
///
/// The grammar is at the head of this crate; the files under `gearsim/src/generated` are written in it. It refuses,
/// all at once and each at its place: unknown names, names that a block is not given, anything piecewise, names used
/// twice, missing rows and blocks, empty ranges, and more than 1024 sets of effects.
#[proc_macro]
pub fn equations(input: TokenStream) -> TokenStream {
    expand::expand(input.into()).into()
}
