//! Equations of motion of `pendulum`: a pendulum in its horizontal displacement.
//!
//! Derived from the energies in `models/src/pendulum.rs` by `cargo xtask derive pendulum`.
//! Do not edit: change the energies and derive again.
//! For reading: `text/pendulum.txt`, `latex/pendulum.tex`. What is proved: at the end.

use gearsim::equations;

equations! {
    model pendulum "a pendulum in its horizontal displacement";
    source "textbooks of mechanics";

    coordinates { x "m" start 0.0, "horizontal displacement"; }
    parameters {
        m "kg" required, open 0.0 to inf, "of the pendulum";
        l "m" required, open 0.0 to inf, "of the pendulum";
        g "m/s^2" required, open 0.0 to inf, "of the pendulum";
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
        kinetic { _ => m*(x_dot.powi(2) + x.powi(2)*x_dot.powi(2)/(l.powi(2) - x.powi(2)))/2.0; }
        potential { _ => g*m*(l - (l.powi(2) - x.powi(2)).sqrt()); }
    }
    torques {
    }
    work {
    }
    mass { x x { _ => m + m*x.powi(2)/(l.powi(2) - x.powi(2)); } }
    mobility { x x { _ => 1.0/(m + m*x.powi(2)/(l.powi(2) - x.powi(2))); } }
    inertia {
        x x { _ => 2.0*(m*x*x_ddot/(l.powi(2) - x.powi(2)) + m*x.powi(3)*x_ddot/(l.powi(4) + x.powi(4) - 2.0*l.powi(2)*x.powi(2))); }
    }
    force {
        x {
            _ => -g*m*x/(l.powi(2) - x.powi(2)).sqrt() - m*x*x_dot.powi(2)/(l.powi(2) - x.powi(2))
                - m*x.powi(3)*x_dot.powi(2)/(l.powi(4) + x.powi(4) - 2.0*l.powi(2)*x.powi(2));
        }
    }
    jacobian {
        x x {
            _ => 4.0*m*x.powi(6)*x_dot.powi(2)
                /(l.powi(8) + x.powi(8) - 4.0*l.powi(2)*x.powi(6) + 6.0*l.powi(4)*x.powi(4) - 4.0*l.powi(6)*x.powi(2))
                - g*m*x.powi(2)/(l.powi(2) - x.powi(2)).powf(3.0/2.0) - g*m/(l.powi(2) - x.powi(2)).sqrt()
                - 5.0*m*x.powi(2)*x_dot.powi(2)/(l.powi(4) + x.powi(4) - 2.0*l.powi(2)*x.powi(2))
                - m*x_dot.powi(2)/(l.powi(2) - x.powi(2))
                - 4.0*l.powi(2)*m*x.powi(4)*x_dot.powi(2)
                /(l.powi(8) + x.powi(8) - 4.0*l.powi(2)*x.powi(6) + 6.0*l.powi(4)*x.powi(4) - 4.0*l.powi(6)*x.powi(2));
        }
        x x_dot { _ => 2.0*(-m*x*x_dot/(l.powi(2) - x.powi(2)) - m*x.powi(3)*x_dot/(l.powi(4) + x.powi(4) - 2.0*l.powi(2)*x.powi(2))); }
    }
    cell {
        stiffness {
        }
        damping {
        }
        load {
        }
    }
    nonlinear "M(x) in the kinetic energy; -g*m*sqrt(l^2 - x^2) in the potential energy";

    text "text/pendulum.txt";
    latex "latex/pendulum.tex";
}

// Proved of these equations, symbolically:
//
// - d/dt (q'.dT/dq' - T + V) = Q.q' - q'.dD/dq' along the motion, for every value and slope of every law, with any set of the additive
//   effects
// - M is symmetric
// - T = q'.M q'/2, with M as written
// - M is positive definite: not decided symbolically; checked for the numbers of every scene
// - d/dt dT/dq' - dT/dq = M q'' + c, where F has -c_i = -sum (dM_ij/dq_k + dM_ik/dq_j - dM_jk/dq_i)/2 q'_j q'_k
// - M M⁻¹ = 1 for M⁻¹ as written, at every q
//
// Operations, all effects present:
//
// | output | sums | products, quotients | functions, roots |
// | --- | --- | --- | --- |
// | force | 6 | 27 | 1 |
