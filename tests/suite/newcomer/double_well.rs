//! Equations of motion of `double_well`: a mass in a potential with two wells.
//!
//! Derived from the energies in `models/src/double_well.rs` by `cargo xtask derive double_well`.
//! Do not edit: change the energies and derive again.
//! For reading: `text/double_well.txt`, `latex/double_well.tex`. What is proved: at the end.

use gearsim::equations;

equations! {
    model double_well "a mass in a potential with two wells";
    source "Duffing's oscillator, e.g. Guckenheimer & Holmes (1983), Section 2.2";

    coordinates { x "m" start static, "place of the mass"; }
    parameters {
        m_p "kg" default 1.0, open 0.0 to inf, "mass";
        a "m" default 0.1, open 0.0 to inf, "place of a well";
        k_w "N/m" default 1000.0, open 0.0 to inf, "stiffness in a well";
        F "N" default 0.0, open -inf to inf, "constant force";
    }
    laws {
    }
    motions {
    }
    effects {
    }
    conditions {
    }

    energies {
        kinetic { _ => m_p*x_dot.powi(2)/2.0; }
        potential { _ => k_w*(x.powi(2) - a.powi(2)).powi(2)/(8.0*a.powi(2)); }
    }
    torques { push "constant force on the mass" { _ => F*x; } }
    work { x { _ => F; } }
    mass { x x { _ => m_p; } }
    mobility { x x { _ => 1.0/m_p; } }
    force { x { _ => F + k_w*x/2.0 - k_w*x.powi(3)/(2.0*a.powi(2)); } }
    jacobian { x x { _ => k_w/2.0 - 3.0*k_w*x.powi(2)/(2.0*a.powi(2)); } }
    cell {
        stiffness {
        }
        damping {
        }
        load { x { _ => F; } }
    }
    nonlinear "k_w*x^4/(8*a^2) in the potential energy";
    outputs { power_push "W", "power of the constant force on the mass: positive if it drives" { _ => push_power; } }

    text "text/double_well.txt";
    latex "latex/double_well.tex";
}

// Proved of these equations, symbolically:
//
// - d/dt (q'.dT/dq' - T + V) = Q.q' - q'.dD/dq' along the motion, for every value and slope of every law, with any set of the additive
//   effects
// - M is symmetric
// - T = q'.M q'/2, with M as written
// - M is positive definite: every leading minor is a sum of products of positive quantities
// - M M⁻¹ = 1, and M q'' = F, for M⁻¹ and the accelerations as written
//
// Operations, all effects present:
//
// | output | sums | products, quotients | functions, roots |
// | --- | --- | --- | --- |
// | force | 2 | 8 | 0 |
// | acceleration | 2 | 11 | 0 |
