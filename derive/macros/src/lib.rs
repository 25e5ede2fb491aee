//! The `equations!` macro: Rust code from a file of derived equations.
//!
//! A generated file states the derived equations in the symbols of their source. The macro generates code that does
//! not execute the terms of absent effects. One invocation fills one module: it defines the model (`GearPair` for
//! `gear_pair`), which implements `gearsim::__private::equations::Derived`.
//!
//! # Grammar
//!
//! After `model`, the blocks may be in any order, each at most once (`jump` once for each law). The blocks `coordinates`, `mass`, `force`
//! and `jacobian` are required, and a `jump` for every law if `switching` says that laws step. Example: an oscillator whose spring k(x)
//! steps, with a damper as an effect:
//!
//! ```text
//! model oscillator "A mass on a stepping spring";
//! source "nobody (0000)";
//!
//! coordinates {                       // `start static`: at the static equilibrium
//!     x "m" start 0.0, "deflection";
//! }
//! parameters {                        // `default X` or `required`, `with EFFECT` if only this effect uses it; the range: `from 0.0` includes 0, `open 0.0` does not
//!     m "kg" required, open 0.0 to inf, "mass";                  // `-inf` and `inf` are allowed as limits
//!     l "m" required, open 0.0 to inf above b, "length";         // greater than the parameter b
//!     b "m" required with backlash, open 0.0 to inf, "play";
//!     zeta "1" default 0.0, from 0.0 to included 1.0, "damping"; // `included`: the upper limit is admissible
//! }
//! laws {                              // declares k, its derivatives dk and ddk by the phase, and k_mid = (max + min)/2
//!     k "N/m" phase x period 1.0, "stiffness";                   // `period 1.0 rolling`: a move of x by whole pitches changes only k
//!                                                                // `rolling unless(support)`: not in scenes with this effect
//! // e "m" phase x period 1.0 with uneven, "error"; // `with`: zero without the effect; an offset of deflections; such laws come last
//! // side "1" phase x period 1.0 with rubbing as side, "side"; // a factor of torques, of any sign; `as arm`: never negative
//! }
//! motions {                           // speeds of the motion of size 1; speeds not given are zero
//!     speed "m/s" { x_dot = 1.0; }, "speed of the mass";
//! }
//! effects {
//!     steps "k steps with x";
//!     rigid requires(steps) "without the impulse";
//!     backlash "play";
//!     damping "viscous damper";       // also: excludes(a, b); `of NAME`: the effect NAME at one part
//!     weight "a constant force of 1 N";
//! }
//! switching {                         // which effect makes laws switch, which ones change how; `by_time`: at times of a steady rotation
//!     steps => with_jump;             // at the boundaries of the phase, with the impulse; without this effect laws are constant
//!     rigid => without_jump;          // speeds pass a boundary unchanged
//! }
//! conditions {                        // all of these effects present or, with `!`, absent
//!     jump_terms = steps, !rigid;
//! }
//! constants {                         // in parameters, mid values and the constants before
//!     C = 2.0*zeta*(k_mid*m).sqrt();
//! }
//! deflections {                       // linear in the coordinates; each also declares its rate, here `over_dot`
//!     over = x - edge;                // may be used in potential, force, jacobian, step; the rate in dissipation, force, jacobian
//! }
//! // functions { x = r*phi.cos(); dx = -r*phi.sin(); }   // smooth functions of coordinates or deflections, and their derivatives
//! // functions { turn with centres = (y/a).atan(); }     // zero without the effect; deflections with such functions in them bend
//! // rates { over_dot = x_dot - turn_by_y*y_dot; }       // the rates of deflections that bend; those of others follow from them
//! switches {                          // modes of a deflection; the symbols in parentheses are constant in each, here without `backlash`
//!     over "m" (edge 0.0, touch 1.0) with backlash, "play" {
//!         upper (b/2.0, 1.0) rests counts "flanks met" {     // `rests`: a static start may be in it; `counts`: what is counted
//!             until free { over { _ => 1.0; } }              // lasts while the guard 1.0*over + .. >= 0, then `free` follows
//!         }
//!         free (0.0, 0.0) rests {                            // `holds`: over_dot = 0; guards may contain the `reaction`
//!             until upper { over { _ => -1.0; } one { _ => b/2.0; } }   // `one`: the constant; `unless`: only a sudden change ends it
//!         }
//!         // loss { one { _ => 2.0; } }                      // the dissipative force against `over`; linear in it
//!     }
//! }
//! // forces { F { friction => c*k*x_dot; } }  // named forces, for rows of `force` and for powers
//! // partials { F_by_x_dot { friction => c*k; } }   // partial derivatives of forces, for entries of `jacobian`
//! energies {                          // sums of terms `COND => EXPR;`, where COND is an effect, a condition, or `_` for always
//!     kinetic { _ => m*x_dot.powi(2)/2.0; }
//!     potential { _ => k*x.powi(2)/2.0; }
//!     dissipation { damping => C*x_dot.powi(2)/2.0; }
//! }
//! torques { weight "the weight" { weight => 1.0*x; } }   // the work of each constant torque for a change x of the coordinate
//! // torques { fan "a fan" {} power { fan_load => -c*x_dot.powi(3); } }  // the power of one that is not constant
//! work { x { weight => 1.0; } }                          // generalised forces of all constant torques
//! mass { x x { _ => m; } }                               // symmetric: `x y` is `y x` too
//! mobility { x x { _ => 1.0/m; } }    // M⁻¹, entries as in `mass`; without this block M is inverted numerically
//! // inertia { x x { _ => m*x*x_ddot; } } // if M depends on coordinates: derivatives of M q'' (rows) by them (columns), not symmetric
//! force { x { _ => -k*x; weight => 1.0; damping => -C*x_dot; jump_terms => -dk*x.powi(2)/2.0; } }
//! jacobian {                          // derivatives of the force by coordinates, speeds, deflections and rates; those not given are zero
//!     x x { _ => -k/m; jump_terms => -2.0*dk*x/m - ddk*x.powi(2)/(2.0*m); }
//!     x x_dot { damping => -C/m; }
//! }
//! cell {                              // M q'' + C q' + K q = f while the laws are constant
//!     stiffness { over over { _ => k; } }     // coordinates and deflections: k g gᵀ with the gradient g of `over`
//!     damping { x x { damping => C; } }
//!     load { x { weight => 1.0; } }
//! }
//! // nonlinear "k*x^3 in the potential energy";                // if the cell is not linear; `cell` is without this term
//! // nonlinear_with { fan_load "-c*x_dot^2 in the torque `fan`"; }       // besides `cell`, which does not contain this torque
//! jump k {                            // dk is the step; only `step` is required, the rest can be computed from M and the phase
//!     normal { x { _ => 1.0; } }
//!     compliance { _ => 1.0/m; }
//!     direction { x { _ => 1.0; } }
//!     step { _ => dk*x.powi(2)/2.0; }
//! }
//! outputs {                           // what a run can record; `with EFFECT`: only scenes with the effect have it
//!     force "N", "force of the spring" { _ => k*over; damping => C*x_dot; }     // may be used in the outputs after it
//! }
//! text "text/oscillator.txt";         // files with the equations for reading, beside this one
//! latex "latex/oscillator.tex";
//! ```
//!
//! Expressions consist of numbers with a decimal point, names, `+ - * /`, parentheses and smooth methods of `f64` (`powi`, `sqrt`,
//! `sin`, ..). Piecewise functions are refused: only laws and switches switch.
//!
//! The macro knows no effect by its name. The file states what each effect does.
//!
//! # Stages
//!
//! All of them are in the folder `equations`.
//!
//! | stage | files |
//! | --- | --- |
//! | parse tokens into the structs of `model` | `parse`, `items`, `tokens` |
//! | check the model, report all errors at once; resolve names | `check`, `effects`, `resolve`, `scope` |
//! | replace constant factors by coefficients, computed once for each scene | `hoist` |
//! | write the code | `emit`, `describe`, `varies`, `terms`, `cold`, `cells`, `jumps`, `lets`, `deflections`, `gated`, `switches`, `sums` |

mod equations;
#[cfg(test)]
mod tests;

use proc_macro::TokenStream;

/// Defines a model from its derived equations and implements `Derived` for it, with `Equations` for any set of effects.
///
/// The grammar is at the head of this crate; the files under `gearsim/generated/src` are written in it.
///
/// # Errors
/// Compile errors, all at once and each at its place: unknown names, names that are not allowed in a block, piecewise functions,
/// duplicate names, missing rows and blocks, and empty ranges.
#[proc_macro]
pub fn equations(input: TokenStream) -> TokenStream {
    equations::expand(input.into()).into()
}
