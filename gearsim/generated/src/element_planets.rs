//! Equations of motion of `element_planets`: the masses of planets on a carrier.
//!
//! Derived from the energies in `models/src/element_planets.rs` by `cargo xtask derive element_planets`.
//! Do not edit: change the energies and derive again.
//! For reading: `text/element_planets.txt`, `latex/element_planets.tex`. What is proved: at the end.

use gearsim::equations;

equations! {
    model element_planets "the masses of planets on a carrier";
    source "an element of trains";

    coordinates { theta "rad" start static, "rotation of the carrier"; }
    parameters {
        np_x "1" required, open 0.0 to inf, "number of planets of {}";
        mp_x "kg" required, open 0.0 to inf, "mass of a planet of {}";
        Zs_x "1" teeth required, open 0.0 to inf, "number of teeth of the sun of {}";
        Zr_x "1" teeth required, open 0.0 to inf, "number of teeth of the ring of {}";
        rs_x "m" base_radius required, open 0.0 to inf, "base radius of the sun of {}";
        alpha_x "rad" pressure_angle default 0.3490658503988659, open 0.0 to inf, "working pressure angle of {}";
        alpha_M "1/s" default 0.0, from 0.0 to inf, "damping in proportion to inertia";
    }
    laws {
    }
    motions {
    }
    effects { damping "Rayleigh damping, C = alpha_M M + beta_K K at the mid stiffness"; }
    conditions {
    }

    constants { a = (Zr_x*rs_x/(Zs_x*alpha_x.cos()) + rs_x/alpha_x.cos())/2.0; }
    energies {
        kinetic { _ => a.powi(2)*mp_x*np_x*theta_dot.powi(2)/2.0; }
        dissipation { damping => a.powi(2)*alpha_M*mp_x*np_x*theta_dot.powi(2)/2.0; }
    }
    torques {
    }
    work {
    }
    mass { theta theta { _ => a.powi(2)*mp_x*np_x; } }
    mobility { theta theta { _ => 1.0/(a.powi(2)*mp_x*np_x); } }
    force { theta { damping => -a.powi(2)*alpha_M*mp_x*np_x*theta_dot; } }
    jacobian { theta theta_dot { damping => -a.powi(2)*alpha_M*mp_x*np_x; } }
    cell {
        stiffness {
        }
        damping { theta theta { damping => a.powi(2)*alpha_M*mp_x*np_x; } }
        load {
        }
    }
    outputs {
        inertia_damping_loss "W" with damping, "power that the damping in proportion to inertia takes" {
            _ => a.powi(2)*alpha_M*mp_x*np_x*theta_dot.powi(2);
        }
    }

    text "text/element_planets.txt";
    latex "latex/element_planets.tex";
}

// Proved of these equations, symbolically:
//
// - d/dt (q'.dT/dq' - T + V) = Q.q' - q'.dD/dq' along the motion, for every value and slope of every law, with any set of the additive
//   effects
// - M is symmetric
// - T = q'.M q'/2, with M as written
// - M is positive definite: not decided symbolically; checked for the numbers of every scene
// - M M⁻¹ = 1, and M q'' = F, for M⁻¹ and the accelerations as written
// - every damper takes energy or none: each term of D has a power q'.dD/dq' that is never negative
//
// Operations, all effects present:
//
// | output | sums | products, quotients | functions, roots |
// | --- | --- | --- | --- |
// | constants (once a scene) | 1 | 6 | 2 |
// | force | 0 | 5 | 0 |
// | acceleration | 0 | 1 | 0 |
