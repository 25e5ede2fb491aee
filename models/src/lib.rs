//! Drivetrains, stated by their energies.
//!
//! # How to add a model, in five minutes
//!
//! 1. Write `models/src/my_train.rs` with one function that describes it to a [`Model`] (`use gearsim_derive::{Model,
//!    Range, Start, half};`):
//!    - `m.title(text)`, `m.source(text)`: what it is, in one line, and where it comes from.
//!    - `m.coordinate(name, unit, start, doc)`: declares a symbol. It comes back as an expression to calculate with:
//!      `+ - * /`, `.sq()`, `.sqrt()`, `.sin()`, `.cos()`, `.dot()` for the time derivative. Numbers are integers: a half
//!      is `half(...)`, any other quantity a parameter with a default.
//!    - [`components`] add bodies and what is between them, with their parameters: `rotor`, `planar_rotor`, `shaft`,
//!      `ground`, `bearing`, `mesh` (with backlash: `mesh_with_play`), `transmission_error`, `sliding_friction`, `pair` (two gears), `geared` (rigidly), `stage` (planets), `drive`, `load`, `governor`,
//!      `dc_motor`, `induction_motor`, `fan`, and last `damping`. Each names its parameters by its part: `rotor(m, "1", ...)`
//!      declares `I1`, `rotor(m, "t", ...)` `I_t`. They take rotations and displacements as expressions, so coordinates are yours to choose: best what is
//!      small and elastic (a twist, a deflection), and one phase for each mesh that rolls on.
//!    - For what no component says: `m.parameter(name, unit, default, range, doc)` and the energies themselves,
//!      `m.kinetic(T)`, `m.potential(V)`, `m.dissipation(D)`, `m.torque(name, value, displacement, doc)`, called as often
//!      as there are bodies, springs, dampers, torques. T is proved positive definite if each call adds one square.
//!    - `m.mesh_stiffness(name, unit, phase, pitch, doc)`: a stiffness that steps with a coordinate; its levels are the
//!      scene's, which may state one in N/m by its teeth: along the line of action, V = k delta^2/2. This is the only way to be piecewise: the jump rule is derived from it. An `if`, `abs` or `max` on
//!      symbols is refused, since its derivative would lose energy without a word.
//!    - `m.transmission_error(name, unit, phase, pitch, doc)`, or the component of that name: what the scene's flanks are beyond their
//!      ideal places, to be taken from a deflection: `mesh(m, "12", "mesh", theta, delta - e.value)`.
//!    - `m.sliding_friction(|m| ...)`: that effect, and in it `m.friction_law(...)`, the only factor with which a torque may depend on
//!      deflections and stiffnesses; the component of that name has both, for meshes of any kind.
//!    - `m.dead_band(part, unit, delta, half, effect, doc)`, or the component `play`: what is felt only beyond its play. V is
//!      written in what comes back.
//!    - `m.effect(name, doc, |m| ...)`: what is added inside is in the equations only of scenes that name the effect;
//!      a parameter declared inside is asked only of them.
//!    - `m.constant(name, value)`, `m.deflection(name, value)`, `m.force(name, value)`: a name for a recurring constant, for a sum of
//!      coordinates that a spring feels, or for what torques have in common, where you want to see it in the equations.
//!    - `m.motion(name, unit, speeds, doc)`: how a scene may state its speed in one number.
//! 2. Declare it below, `pub mod my_train;`, and add it to [`MODELS`]: one line. A model with a number of equal parts is one
//!    function of that number, and one line a number: `("my_train_3", |m| my_train::my_train(m, 3))`.
//! 3. Run `cargo xtask derive my_train`. It derives the equations and jump rules, proves their energy balance and
//!    writes `gearsim/src/generated/my_train.rs`; read its head. A slip is refused with the name of the culprit.
//!    Cells that are not linear are derived and named, and integrated by steps instead of in closed form.
//! 4. Declare the file in `gearsim/src/generated/mod.rs`, `#[rustfmt::skip] pub mod my_train;`, and add it to the list
//!    there: `Entry::new::<my_train::MyTrain, 2>()` for two coordinates.
//! 5. Write a scene under `models/scenes/`, starting from an existing one, and run it:
//!    `cargo run --release -- run models/scenes/my_train.toml`. `cargo run -- models my_train` shows what a scene
//!    can set.
//!
//! [`idler`](idler::idler) is a complete example made of components, [`gear_pair`](gear_pair::gear_pair) one of bare energies.

pub mod backlash_oscillator;
pub mod belt_drive;
pub mod chain;
pub mod components;
pub mod gear_pair;
pub mod gear_pair_bearings;
pub mod gear_pair_shafts;
pub mod geared_branches;
pub mod idler;
pub mod planar_planetary;
pub mod planetary;
pub mod two_stage;
pub mod wind_turbine;

use gearsim_derive::Model;

/// A model's name and the function that describes it.
pub type Entry = (&'static str, fn(&mut Model));

/// Every model: one line each.
pub const MODELS: &[Entry] = &[
    ("gear_pair", gear_pair::gear_pair),
    ("backlash_oscillator", backlash_oscillator::backlash_oscillator),
    ("gear_pair_shafts", gear_pair_shafts::gear_pair_shafts),
    ("gear_pair_bearings", gear_pair_bearings::gear_pair_bearings),
    ("geared_branches", geared_branches::geared_branches),
    ("two_stage", two_stage::two_stage),
    ("idler", idler::idler),
    ("belt_drive", belt_drive::belt_drive),
    ("planetary_3", |m| planetary::planetary(m, 3)),
    ("planetary_4", |m| planetary::planetary(m, 4)),
    ("planetary_5", |m| planetary::planetary(m, 5)),
    ("planetary_6", |m| planetary::planetary(m, 6)),
    ("planetary_7", |m| planetary::planetary(m, 7)),
    ("planar_planetary_3", |m| planar_planetary::planar_planetary(m, 3)),
    ("planar_planetary_4", |m| planar_planetary::planar_planetary(m, 4)),
    ("planar_planetary_5", |m| planar_planetary::planar_planetary(m, 5)),
    ("wind_turbine", wind_turbine::wind_turbine),
    ("chain_2", |m| chain::chain(m, 2)),
    ("chain_5", |m| chain::chain(m, 5)),
    ("chain_32", |m| chain::chain(m, 32)),
];
