//! Equations of motion of `element_dry_friction`: dry friction.
//!
//! Derived from the energies in `models/src/element_dry_friction.rs` by `cargo xtask derive element_dry_friction`.
//! Do not edit: change the energies and derive again.
//! For reading: `text/element_dry_friction.txt`, `latex/element_dry_friction.tex`. What is proved: at the end.

use gearsim::equations;

equations! {
    model element_dry_friction "dry friction";
    source "an element of trains";

    coordinates { theta "rad" start static, "rotation"; }
    parameters {
        J_theta "kg*m^2" required, open 0.0 to inf, "test inertia, 0 in trains";
        Tc_x "N*m" required with dry_friction_x, from 0.0 to inf, "Coulomb friction of the bearing {}: constant, against the motion";
        rise_x "1" default 0.0 with dry_friction_x, from 0.0 to inf,
            "excess of the breakaway torque of the bearing {} over its Coulomb friction, relative to that";
    }
    laws {
    }
    motions {
    }
    effects {
        dry_friction_x of dry_friction
            "dry friction with sticking: a constant torque against the motion, and at rest up to the breakaway torque";
    }
    conditions {
    }

    deflections { slip_x = theta; }
    switches {
        slip_x "rad" (dir_x 0.0) with dry_friction_x, "dry friction of the bearing {}" {
            stuck (0.0) holds rests counts "stuck" {
                until forward {
                    reaction { _ => -1.0; }
                    one { _ => Tc_x + Tc_x*rise_x; }
                }
                until backward {
                    reaction { _ => 1.0; }
                    one { _ => Tc_x + Tc_x*rise_x; }
                }
            }
            forward (1.0) { until stuck { slip_x_dot { _ => 1.0; } } }
            backward (-1.0) { until stuck { slip_x_dot { _ => -1.0; } } }
            loss { one { _ => Tc_x*dir_x; } }
        }
    }
    energies { kinetic { _ => J_theta*theta_dot.powi(2)/2.0; } }
    torques {
    }
    work {
    }
    mass { theta theta { _ => J_theta; } }
    mobility { theta theta { _ => 1.0/J_theta; } }
    force { theta { dry_friction_x => -Tc_x*dir_x; } }
    jacobian {
    }
    cell {
        stiffness {
        }
        damping {
        }
        load { slip_x { dry_friction_x => -Tc_x*dir_x; } }
    }
    outputs {
        friction_torque_x "N*m" with dry_friction_x, "dry friction of the bearing {}, at rest too: positive against positive motion" {
            _ => slip_x_reaction;
            dry_friction_x => Tc_x*dir_x;
        }
        friction_loss_x "W" with dry_friction_x, "power that the dry friction of the bearing {} takes" {
            dry_friction_x => Tc_x*dir_x*slip_x_dot;
        }
    }

    text "text/element_dry_friction.txt";
    latex "latex/element_dry_friction.tex";
}

// Proved of these equations, symbolically:
//
// - d/dt (q'.dT/dq' - T + V) = Q.q' - q'.dD/dq' along the motion, for every value and slope of every law, with any set of the additive
//   effects; q'.dD/dq' includes the power that switches take
// - M is symmetric
// - T = q'.M q'/2, with M as written
// - M is positive definite: every leading minor is a sum of products of positive quantities
// - M M⁻¹ = 1, and M q'' = F, for M⁻¹ and the accelerations as written
// - V is the same on both sides of the exits of slip_x: no impulse there
// - the force of the switch slip_x takes energy or none: f slip_x_dot >= 0 in every mode, from the guards that hold in it
// - every deflection equals the linear form by which the equations differentiate it
//
// Operations, all effects present:
//
// | output | sums | products, quotients | functions, roots |
// | --- | --- | --- | --- |
// | force | 0 | 1 | 0 |
// | acceleration | 0 | 2 | 0 |
