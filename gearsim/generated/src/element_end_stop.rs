//! Equations of motion of `element_end_stop`: end stops.
//!
//! Derived from the energies in `models/src/element_end_stop.rs` by `cargo xtask derive element_end_stop`.
//! Do not edit: change the energies and derive again.
//! For reading: `text/element_end_stop.txt`, `latex/element_end_stop.tex`. What is proved: at the end.

use gearsim::equations;

equations! {
    model element_end_stop "end stops";
    source "an element of trains";

    coordinates { theta "rad" start static, "rotation of the first rotor relative to the second"; }
    parameters {
        J_theta "kg*m^2" required, open 0.0 to inf, "test inertia, 0 in trains";
        hi_x "rad" required with end_stop_x, open -inf to inf, "place of the upper stop of the rotation {}";
        lo_x "rad" required with end_stop_x, open -inf to inf, "place of the lower stop of the rotation {}";
        ks_x "N*m/rad" required with end_stop_x, open 0.0 to inf, "stiffness of the stops of the rotation {}";
        cs_x "N*m*s/rad" default 0.0 with end_stop_x, from 0.0 to inf, "damping of the stops of the rotation {}";
    }
    laws {
    }
    motions {
    }
    effects {
        end_stop_x of end_stop "end stops: elastic, with a damper that never pulls, beyond an upper and a lower limit of a displacement";
    }
    conditions {
    }

    deflections { past_x = theta - stop_x; }
    switches {
        past_x "rad" (at_stop_x 1.0, stop_x 0.0, stop_damp_x 1.0, stop_clip_x 0.0) with end_stop_x, "end stops of the rotation {}" {
            free (0.0, 0.0, 0.0, 0.0) rests {
                until upper {
                    past_x { _ => -1.0; }
                    one { _ => hi_x; }
                }
                until lower {
                    past_x { _ => 1.0; }
                    one { _ => -lo_x; }
                }
            }
            upper (1.0, hi_x, 1.0, 0.0) rests counts "stop met" {
                unless free { past_x { _ => 1.0; } }
                until upper_loose {
                    past_x { end_stop_x => ks_x; }
                    past_x_dot { end_stop_x => cs_x; }
                }
                until upper_hit {
                    past_x { end_stop_x => ks_x; }
                    past_x_dot { end_stop_x => -cs_x; }
                }
            }
            upper_hit (1.0, hi_x, 0.0, 1.0) counts "stop met" {
                unless free { past_x { _ => 1.0; } }
                until upper {
                    past_x { end_stop_x => -ks_x; }
                    past_x_dot { end_stop_x => cs_x; }
                }
            }
            upper_loose (1.0, hi_x, 0.0, -1.0) counts "stop met" {
                until free { past_x { _ => 1.0; } }
                until upper {
                    past_x { end_stop_x => -ks_x; }
                    past_x_dot { end_stop_x => -cs_x; }
                }
            }
            lower (1.0, lo_x, 1.0, 0.0) rests counts "stop met" {
                unless free { past_x { _ => -1.0; } }
                until lower_loose {
                    past_x { end_stop_x => -ks_x; }
                    past_x_dot { end_stop_x => -cs_x; }
                }
                until lower_hit {
                    past_x { end_stop_x => -ks_x; }
                    past_x_dot { end_stop_x => cs_x; }
                }
            }
            lower_hit (1.0, lo_x, 0.0, 1.0) counts "stop met" {
                unless free { past_x { _ => -1.0; } }
                until lower {
                    past_x { end_stop_x => ks_x; }
                    past_x_dot { end_stop_x => -cs_x; }
                }
            }
            lower_loose (1.0, lo_x, 0.0, -1.0) counts "stop met" {
                until free { past_x { _ => -1.0; } }
                until lower {
                    past_x { end_stop_x => ks_x; }
                    past_x_dot { end_stop_x => cs_x; }
                }
            }
            loss { past_x { end_stop_x => ks_x*at_stop_x*stop_clip_x; } }
        }
    }
    energies {
        kinetic { _ => J_theta*theta_dot.powi(2)/2.0; }
        potential { end_stop_x => ks_x*at_stop_x*past_x.powi(2)/2.0; }
        dissipation { end_stop_x => cs_x*stop_damp_x*past_x_dot.powi(2)/2.0; }
    }
    torques {
    }
    work {
    }
    mass { theta theta { _ => J_theta; } }
    mobility { theta theta { _ => 1.0/J_theta; } }
    force { theta { end_stop_x => -cs_x*stop_damp_x*past_x_dot - ks_x*at_stop_x*stop_clip_x*past_x - ks_x*at_stop_x*past_x; } }
    jacobian {
        theta past_x { end_stop_x => -ks_x*at_stop_x - ks_x*at_stop_x*stop_clip_x; }
        theta past_x_dot { end_stop_x => -cs_x*stop_damp_x; }
    }
    cell {
        stiffness { past_x past_x { end_stop_x => ks_x*at_stop_x + ks_x*at_stop_x*stop_clip_x; } }
        damping { past_x past_x { end_stop_x => cs_x*stop_damp_x; } }
        load { past_x { end_stop_x => ks_x*at_stop_x*stop_clip_x*stop_x + ks_x*at_stop_x*stop_x; } }
    }
    outputs {
        stop_force_x "N*m" with end_stop_x,
            "force of the stops on the rotation {}, damper included: positive if it pushes back from the upper one" {
            end_stop_x => cs_x*stop_damp_x*past_x_dot + ks_x*at_stop_x*stop_clip_x*past_x + ks_x*at_stop_x*past_x;
        }
        stop_loss_x "W" with end_stop_x, "power that the dampers of the stops of the rotation {} take" {
            end_stop_x => cs_x*stop_damp_x*past_x_dot.powi(2) + ks_x*at_stop_x*stop_clip_x*past_x*past_x_dot;
        }
    }

    text "text/element_end_stop.txt";
    latex "latex/element_end_stop.tex";
}

// Proved of these equations, symbolically:
//
// - d/dt (q'.dT/dq' - T + V) = Q.q' - q'.dD/dq' along the motion, for every value and slope of every law, with any set of the additive
//   effects; q'.dD/dq' includes the power that switches take
// - M is symmetric
// - T = q'.M q'/2, with M as written
// - M is positive definite: every leading minor is a sum of products of positive quantities
// - M M⁻¹ = 1, and M q'' = F, for M⁻¹ and the accelerations as written
// - V is the same on both sides of the exits of past_x: no impulse there
// - the force of the switch past_x takes energy or none: f past_x_dot >= 0 in every mode, from the guards that hold in it; of a damper that
//   is clipped to f = c F, where F = dV/dpast_x and c = 1 or -1, since F past_x >= 0, past_x_dot dD/dpast_x_dot >= 0 and c past_x
//   dD/dpast_x_dot >= F past_x
// - every damper takes energy or none: each term of D has a power q'.dD/dq' that is never negative
// - every deflection equals the linear form by which the equations differentiate it
//
// Operations, all effects present:
//
// | output | sums | products, quotients | functions, roots |
// | --- | --- | --- | --- |
// | force | 2 | 7 | 0 |
// | acceleration | 2 | 10 | 0 |
