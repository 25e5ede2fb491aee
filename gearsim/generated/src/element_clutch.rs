//! Equations of motion of `element_clutch`: an overrunning clutch.
//!
//! Derived from the energies in `models/src/element_clutch.rs` by `cargo xtask derive element_clutch`.
//! Do not edit: change the energies and derive again.
//! For reading: `text/element_clutch.txt`, `latex/element_clutch.tex`. What is proved: at the end.

use gearsim::equations;

equations! {
    model element_clutch "an overrunning clutch";
    source "an element of trains";

    coordinates { theta "rad" start static, "rotation of the driving side relative to the driven one"; }
    parameters {
        J_theta "kg*m^2" required, open 0.0 to inf, "test inertia, 0 in trains";
        Tmax_x "N*m" required with overrunning_clutch_x, open 0.0 to inf, "capacity of the clutch {}: the largest torque that it transmits";
        Tdrag_x "N*m" default 0.0 with overrunning_clutch_x, from 0.0 to inf, "drag torque of the clutch {} while it overruns";
    }
    laws {
    }
    motions {
    }
    effects {
        overrunning_clutch_x of overrunning_clutch
            "a one-way clutch: locked while it drives, free while the driven side is faster; without it the clutch is open";
    }
    conditions {
    }

    deflections { lead_x = theta; }
    switches {
        lead_x "rad" (slips_x 0.0, drags_x 0.0) with overrunning_clutch_x, "modes of the clutch {}" {
            locked (0.0, 0.0) holds rests counts "clutch locked" {
                until overrun {
                    reaction { _ => 1.0; }
                    one { _ => Tdrag_x; }
                }
                until slips {
                    reaction { _ => -1.0; }
                    one { _ => Tmax_x; }
                }
            }
            overrun (0.0, -1.0) { until locked { lead_x_dot { _ => -1.0; } } }
            slips (1.0, 0.0) { until locked { lead_x_dot { _ => 1.0; } } }
            loss { one { _ => Tdrag_x*drags_x + Tmax_x*slips_x; } }
        }
    }
    energies { kinetic { _ => J_theta*theta_dot.powi(2)/2.0; } }
    torques {
    }
    work {
    }
    mass { theta theta { _ => J_theta; } }
    mobility { theta theta { _ => 1.0/J_theta; } }
    force { theta { overrunning_clutch_x => -Tdrag_x*drags_x - Tmax_x*slips_x; } }
    jacobian {
    }
    cell {
        stiffness {
        }
        damping {
        }
        load { lead_x { overrunning_clutch_x => -Tdrag_x*drags_x - Tmax_x*slips_x; } }
    }
    outputs {
        clutch_torque_x "N*m" with overrunning_clutch_x,
            "torque that the clutch {} gives to its driven side, locked, slipping or overrunning" {
            _ => lead_x_reaction;
            overrunning_clutch_x => Tdrag_x*drags_x + Tmax_x*slips_x;
        }
        clutch_loss_x "W" with overrunning_clutch_x, "power that the clutch {} takes as it slips or drags" {
            overrunning_clutch_x => Tdrag_x*drags_x*lead_x_dot + Tmax_x*slips_x*lead_x_dot;
        }
    }

    text "text/element_clutch.txt";
    latex "latex/element_clutch.tex";
}

// Proved of these equations, symbolically:
//
// - d/dt (q'.dT/dq' - T + V) = Q.q' - q'.dD/dq' along the motion, for every value and slope of every law, with any set of the additive
//   effects; q'.dD/dq' includes the power that switches take
// - M is symmetric
// - T = q'.M q'/2, with M as written
// - M is positive definite: every leading minor is a sum of products of positive quantities
// - M M⁻¹ = 1, and M q'' = F, for M⁻¹ and the accelerations as written
// - V is the same on both sides of the exits of lead_x: no impulse there
// - the force of the switch lead_x takes energy or none: f lead_x_dot >= 0 in every mode, from the guards that hold in it
// - every deflection equals the linear form by which the equations differentiate it
//
// Operations, all effects present:
//
// | output | sums | products, quotients | functions, roots |
// | --- | --- | --- | --- |
// | force | 1 | 2 | 0 |
// | acceleration | 1 | 4 | 0 |
