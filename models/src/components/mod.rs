//! The components of drivetrains: functions that declare parameters and add energies to a model.
//!
//! Each component has its own file. The model chooses the coordinates. It passes rotations \[rad\] and displacements \[m\] to the components as
//! expressions in these coordinates: `rotor(m, "1", "driving gear", (theta + s / h) / N1)`. The name of a parameter consists of the symbol of the
//! quantity and the name of the part: the inertia of part `1` is `I1`, that of part `motor` is `I_motor`.

pub mod bearing;
pub mod clutch;
pub mod constraint;
pub mod damping;
pub mod drive;
pub mod dry_friction;
pub mod end_stop;
pub mod fan;
pub mod friction;
pub mod gear;
pub mod governor;
pub mod mesh;
pub mod motor;
pub mod moving_centres;
pub mod observed;
pub mod pair;
pub mod planets;
pub mod play;
pub mod rotor;
pub mod shaft;
pub mod slider_crank;
pub mod steps;
pub mod stiction;
pub mod thrust_bearing;
pub mod traction_motor;
pub mod transmission_error;
pub mod universal_joint;
pub mod viscous;

pub use bearing::{bearing, bearing_damper};
pub use clutch::overrunning_clutch;
pub use constraint::geared;
pub use damping::damping;
pub use drive::{drive, driven, load, loaded, machines};
pub use dry_friction::dry_friction;
pub use end_stop::end_stop;
pub use fan::fan;
pub use friction::{Sliding, friction_effect, pressure_tangent, pressure_tangent_of, sliding_friction};
pub use gear::{Direction, Gear, external, external_sliding, internal, internal_sliding};
pub use governor::{dc_motor, governor};
pub use mesh::{Flanks, Mesh, damped_mesh, mesh_in_plane, mesh_stiffness, mesh_with_play};
pub use motor::induction_motor;
pub use moving_centres::{Bend, moving_centres};
pub use pair::{Pair, pair};
pub use planets::{Stage, stage};
pub use play::{Play, dead_band, play, play_in_plane};
pub use rotor::{planar_rotor, rotor};
pub use shaft::{ground, shaft, torsional_support};
pub use slider_crank::slider_crank;
pub use steps::steps;
pub use stiction::{FLANK_STICTION, Stiction, flank_stiction};
pub use thrust_bearing::thrust_bearing;
pub use traction_motor::traction_motor;
pub use transmission_error::transmission_error;
pub use universal_joint::universal_joint;
pub use viscous::{damper, viscous};

/// The name of a quantity of a part: `I1` for `I` of part `1`, `I_motor` for `I` of part `motor`.
pub fn named(quantity: &str, part: &str) -> String {
    let joint = if part.is_empty() || part.starts_with(|c: char| c.is_ascii_digit()) { "" } else { "_" };
    format!("{quantity}{joint}{part}")
}
