//! Drivetrains, described by their energies.
//!
//! # How to add a model, in five minutes
//!
//! 1. Write `models/src/my_train.rs` with one function that describes the model to a [`Model`](gearsim_derive::Model) (`use gearsim_derive::{Model,
//!    Range, Start, half};`):
//!    - `m.title(text)`, `m.source(text)`: what the model is, in one line, and its source.
//!    - `m.coordinate(name, unit, start, doc)`: declares a coordinate and returns it as an expression. Expressions have
//!      `+ - * /`, `.sq()`, `.sqrt()`, `.sin()`, `.cos()`, and `.dot()` for the time derivative. Numbers are integers: write a half
//!      as `half(...)`, any other number as a parameter with a default.
//!      A coordinate without inertia, such as the node between two springs, is eliminated if springs of constant stiffness alone act on it:
//!      its value follows from the balance of their forces. It becomes an output.
//!    - [`components`] add bodies and their connections, with their parameters: `rotor`, `planar_rotor`, `shaft`, `ground`, `torsional_support`,
//!      `bearing`, `dry_friction`, `viscous`, `overrunning_clutch`, `mesh_with_play` (with transmission errors
//!      and backlash), `sliding_friction`, `pair` (two gears), `geared` (rigidly), `stage` (planets), `end_stop`, `driven` and `loaded` (a constant torque, and `machines`: `governor`, `dc_motor`, `induction_motor`, `traction_motor`, `fan`), and last `damping`. The
//!      names of parameters end in the name of the part: `rotor(m, "1", ...)` declares `I1`, `rotor(m, "t", ...)` declares `I_t`.
//!      Components take rotations and displacements as expressions, so that you choose the coordinates. The best coordinates are small
//!      elastic ones (twists, deflections), and one phase, which grows, for each mesh or group of meshes that roll together.
//!    - For everything else: `m.parameter(name, unit, default, range, doc)` and the energies themselves, `m.kinetic(T)`,
//!      `m.potential(V)`, `m.dissipation(D)`, `m.torque(name, value, displacement, doc)`, called once for each body, spring, damper
//!      and torque. T is proved positive definite if each call of `m.kinetic` adds one square.
//!    - `m.gear_data(GearData::Teeth, name, default, doc)`: a parameter that is a number of teeth; likewise `BaseRadius`, `PressureAngle`, and
//!      `Support`, the torsional stiffness of the support of a gear. Scenes check these parameters, and compare them with the tooth data of laws.
//!    - `mesh_stiffness(m, name, unit, phase, pitch, doc)`, a component: a stiffness that steps with a coordinate. The scene gives its levels, or
//!      tooth data for a stiffness in N/m with delta along the line of action, V = k delta^2/2 (or in N*m, as in `gear_pair`). Laws
//!      like this one and switches are the only piecewise functions, since the jump rule is derived from them. An `if`, `abs` or
//!      `max` on symbols is refused: its derivative would lose energy without any message.
//!    - `transmission_error(m, [name, part], unit, phase, pitch, doc)`, a component: the deviation of the flanks from their ideal position, given by
//!      the scene. Subtract it from a deflection, as the component `mesh_with_play` does.
//!    - Laws in general, periodic functions of a phase that the scene gives: `m.stiffness_law`; inside an effect `m.offset_law`, which is
//!      subtracted from deflections, and `m.factor_law`, a factor of torques. A torque may depend on deflections and stiffnesses only if it
//!      has such a factor, as in the component `sliding_friction`. `m.boundaries(effect, how)` says which effect makes laws switch, and
//!      how; the component `steps` does it.
//!    - `m.switch(over, unit, delta, effect, doc)`: a deflection with modes. The equations depend on the mode, and a mode lasts until a
//!      linear guard becomes zero. The components `play` and `dead_band` use it: a force acts only beyond the play. Write V in
//!      the symbols returned.
//!    - `m.effect(name, doc, |m| ...)`: what is added inside is in the equations only of scenes that name the effect; only they must
//!      give the parameters declared inside, which no other term may use. `m.part_effect(name, part, doc, |m| ...)` is an effect of one part: a scene names
//!      `backlash` for all parts, or `backlash_12` for one.
//!    - `m.constant(name, value)`, `m.deflection(name, value)`, `m.force(name, value)`: names for a recurring constant, for the
//!      deflection of a spring (a linear form of the coordinates, and functions of positions), or for a factor that torques share. The equations are written in
//!      these names.
//!    - `m.output(name, unit, value, doc)`: what a run can record besides the coordinates, for example `m.spring(x) + m.damper(x)`, the
//!      force along a named deflection. Components declare their own: forces, torques, transmission errors, speeds, losses.
//!    - `m.function(name, position, |u| ...)`: a name for a smooth function of one coordinate or deflection. A constraint is stated in
//!      this way, solved for one quantity: the place of a piston as a function of its crank's angle. T, V and the displacements of
//!      torques may contain it and its `.dot()`. T may depend on coordinates in any other way too; the equations are then integrated
//!      by a stepping method. The components `slider_crank` and `universal_joint` are of this kind.
//!    - `m.function_of(name, [x, y], |[x, y]| value, |[x, y]| gradient)`: a smooth function of several positions. Deflections may have it as
//!      an addend: they then bend, and springs, dampers, play and its modes follow them. D may depend on coordinates and functions too. The
//!      component `moving_centres` is of this kind.
//!    - `m.torque_along(name, value, speed, doc)`: a torque whose displacement has no closed form, but whose speed has.
//!    - `m.motion(name, unit, speeds, doc)`: a rigid motion by which a scene may state all speeds in one number.
//! 2. Declare the file below, `pub mod my_train;`, and add one line to [`MODELS`]. For a model with n equal parts write one function
//!    of n, and one line for each n: `("my_train_3", |m| my_train::my_train(m, 3))`.
//! 3. Run `cargo xtask derive my_train`. It derives the equations and jump rules, proves their energy balance and writes
//!    `gearsim/generated/src/my_train.rs`, and beside it the equations for reading, `text/my_train.txt`: read both. An error in the model is refused with the name of the symbol or term.
//!    Nonlinear cells are derived too; their nonlinear terms are listed, and they are integrated by a stepping method instead of in
//!    closed form.
//! 4. Add the line `my_train::MyTrain,` to the list in `gearsim/generated/src/lib.rs`.
//! 5. Write a scene under `models/scenes/`, starting from an existing one, and run it: `cargo run --release -- run
//!    models/scenes/my_train.toml`. `cargo run -- models my_train` shows what a scene can set.
//!
//! [`idler`](idler::idler) is a complete example made of components, [`gear_pair`](gear_pair::gear_pair) one written in energies.

pub mod backlash_oscillator;
pub mod belt_drive;
pub mod cardan_drive;
pub mod chain;
pub mod components;
pub mod crank_drive;
pub mod electric_axle;
pub mod elements;
pub mod freewheel;
pub mod friction_oscillator;
pub mod gear_pair;
pub mod gear_pair_bearings;
pub mod gear_pair_shafts;
pub mod geared_branches;
pub mod idler;
pub mod planar_planetary;
pub mod planetary;
pub mod two_stage;
pub mod wind_turbine;

pub use elements::ELEMENTS;
pub use gearsim_derive::Entry;

/// All models, one line each.
pub const MODELS: &[Entry] = &[
    ("gear_pair", gear_pair::gear_pair),
    ("backlash_oscillator", backlash_oscillator::backlash_oscillator),
    ("friction_oscillator", friction_oscillator::friction_oscillator),
    ("freewheel", freewheel::freewheel),
    ("electric_axle", electric_axle::electric_axle),
    ("gear_pair_shafts", gear_pair_shafts::gear_pair_shafts),
    ("gear_pair_bearings", gear_pair_bearings::gear_pair_bearings),
    ("geared_branches", geared_branches::geared_branches),
    ("two_stage", two_stage::two_stage),
    ("idler", idler::idler),
    ("belt_drive", belt_drive::belt_drive),
    ("crank_drive", crank_drive::crank_drive),
    ("cardan_drive", cardan_drive::cardan_drive),
    ("planetary_3", |m| planetary::planetary(m, 3)),
    ("planar_planetary_3", |m| planar_planetary::planar_planetary(m, 3)),
    ("planar_planetary_4", |m| planar_planetary::planar_planetary(m, 4)),
    ("planar_planetary_5", |m| planar_planetary::planar_planetary(m, 5)),
    ("wind_turbine", wind_turbine::wind_turbine),
    ("chain_2", |m| chain::chain(m, 2)),
    ("chain_5", |m| chain::chain(m, 5)),
    ("chain_32", |m| chain::chain(m, 32)),
];
