//! Equations of motion of `double_pendulum`: a double pendulum.
//!
//! Derived from the energies in `models/src/double_pendulum.rs` by `cargo xtask derive double_pendulum`.
//! Do not edit: change the energies and derive again.
//! For reading: `text/double_pendulum.txt`, `latex/double_pendulum.tex`. What is proved: at the end.

use gearsim::equations;

equations! {
    model double_pendulum "a double pendulum";
    source "textbooks of mechanics";

    coordinates {
        a1 "rad" start 0.0, "angle from the vertical";
        a2 "rad" start 0.0, "angle from the vertical";
    }
    parameters {
        g "m/s^2" required, open 0.0 to inf, "gravity";
        m1 "kg" required, open 0.0 to inf, "mass";
        l1 "m" required, open 0.0 to inf, "length";
        m2 "kg" required, open 0.0 to inf, "mass";
        l2 "m" required, open 0.0 to inf, "length";
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
        kinetic {
            _ => (m2*(l1*a1_dot*a1.cos() + l2*a2_dot*a2.cos()).powi(2) + m2*(l1*a1_dot*a1.sin() + l2*a2_dot*a2.sin()).powi(2)
                + l1.powi(2)*m1*a1_dot.powi(2)*a1.cos().powi(2) + l1.powi(2)*m1*a1_dot.powi(2)*a1.sin().powi(2))/2.0;
        }
        potential { _ => g*m2*(-l1*a1.cos() - l2*a2.cos()) - g*l1*m1*a1.cos(); }
    }
    torques {
    }
    work {
    }
    mass {
        a1 a1 { _ => l1.powi(2)*m1 + l1.powi(2)*m2; }
        a1 a2 { _ => l1*l2*m2*a1.cos()*a2.cos() + l1*l2*m2*a1.sin()*a2.sin(); }
        a2 a2 { _ => l2.powi(2)*m2; }
    }
    mobility {
        a1 a1 {
            _ => l2.powi(2)*m2/(l1.powi(2)*l2.powi(2)*m1*m2 + l1.powi(2)*l2.powi(2)*m2.powi(2)
                - l1.powi(2)*l2.powi(2)*m2.powi(2)*a1.cos().powi(2)*a2.cos().powi(2)
                - l1.powi(2)*l2.powi(2)*m2.powi(2)*a1.sin().powi(2)*a2.sin().powi(2)
                - 2.0*l1.powi(2)*l2.powi(2)*m2.powi(2)*a1.cos()*a2.cos()*a1.sin()*a2.sin());
        }
        a1 a2 {
            _ => -(l1*l2*m2*a1.cos()*a2.cos() + l1*l2*m2*a1.sin()*a2.sin())
                /(l1.powi(2)*l2.powi(2)*m1*m2 + l1.powi(2)*l2.powi(2)*m2.powi(2)
                - l1.powi(2)*l2.powi(2)*m2.powi(2)*a1.cos().powi(2)*a2.cos().powi(2)
                - l1.powi(2)*l2.powi(2)*m2.powi(2)*a1.sin().powi(2)*a2.sin().powi(2)
                - 2.0*l1.powi(2)*l2.powi(2)*m2.powi(2)*a1.cos()*a2.cos()*a1.sin()*a2.sin());
        }
        a2 a2 {
            _ => (l1.powi(2)*m1 + l1.powi(2)*m2)
                /(l1.powi(2)*l2.powi(2)*m1*m2 + l1.powi(2)*l2.powi(2)*m2.powi(2)
                - l1.powi(2)*l2.powi(2)*m2.powi(2)*a1.cos().powi(2)*a2.cos().powi(2)
                - l1.powi(2)*l2.powi(2)*m2.powi(2)*a1.sin().powi(2)*a2.sin().powi(2)
                - 2.0*l1.powi(2)*l2.powi(2)*m2.powi(2)*a1.cos()*a2.cos()*a1.sin()*a2.sin());
        }
    }
    inertia {
        a1 a1 { _ => l1*l2*m2*a2_ddot*a1.cos()*a2.sin() - l1*l2*m2*a2_ddot*a2.cos()*a1.sin(); }
        a1 a2 { _ => l1*l2*m2*a2_ddot*a2.cos()*a1.sin() - l1*l2*m2*a2_ddot*a1.cos()*a2.sin(); }
        a2 a1 { _ => l1*l2*m2*a1_ddot*a1.cos()*a2.sin() - l1*l2*m2*a1_ddot*a2.cos()*a1.sin(); }
        a2 a2 { _ => l1*l2*m2*a1_ddot*a2.cos()*a1.sin() - l1*l2*m2*a1_ddot*a1.cos()*a2.sin(); }
    }
    force {
        a1 {
            _ => l1*l2*m2*a2_dot.powi(2)*a1.cos()*a2.sin() - g*l1*m1*a1.sin() - g*l1*m2*a1.sin()
                - l1*l2*m2*a2_dot.powi(2)*a2.cos()*a1.sin();
        }
        a2 { _ => l1*l2*m2*a1_dot.powi(2)*a2.cos()*a1.sin() - g*l2*m2*a2.sin() - l1*l2*m2*a1_dot.powi(2)*a1.cos()*a2.sin(); }
    }
    jacobian {
        a1 a1 {
            _ => -g*l1*m1*a1.cos() - g*l1*m2*a1.cos() - l1*l2*m2*a2_dot.powi(2)*a1.cos()*a2.cos()
                - l1*l2*m2*a2_dot.powi(2)*a1.sin()*a2.sin();
        }
        a1 a2 { _ => l1*l2*m2*a2_dot.powi(2)*a1.cos()*a2.cos() + l1*l2*m2*a2_dot.powi(2)*a1.sin()*a2.sin(); }
        a1 a2_dot { _ => 2.0*(l1*l2*m2*a2_dot*a1.cos()*a2.sin() - l1*l2*m2*a2_dot*a2.cos()*a1.sin()); }
        a2 a1 { _ => l1*l2*m2*a1_dot.powi(2)*a1.cos()*a2.cos() + l1*l2*m2*a1_dot.powi(2)*a1.sin()*a2.sin(); }
        a2 a2 { _ => -g*l2*m2*a2.cos() - l1*l2*m2*a1_dot.powi(2)*a1.cos()*a2.cos() - l1*l2*m2*a1_dot.powi(2)*a1.sin()*a2.sin(); }
        a2 a1_dot { _ => 2.0*(l1*l2*m2*a1_dot*a2.cos()*a1.sin() - l1*l2*m2*a1_dot*a1.cos()*a2.sin()); }
    }
    cell {
        stiffness {
        }
        damping {
        }
        load {
        }
    }
    nonlinear
        "M(a1, a2) in the kinetic energy; -g*l1*m1*cos(a1) in the potential energy; -g*l1*m2*cos(a1) in the potential energy; \
        -g*l2*m2*cos(a2) in the potential energy";

    text "text/double_pendulum.txt";
    latex "latex/double_pendulum.tex";
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
// | force | 5 | 33 | 11 |
