//! Equations of motion of `linkage`: a flywheel that turns a slider-crank and a universal joint.
//!
//! Derived from the energies in `models/src/linkage.rs` by `cargo xtask derive linkage`.
//! Do not edit: change the energies and derive again.
//! For reading: `text/linkage.txt`, `latex/linkage.tex`. What is proved: at the end.

use gearsim::equations;

equations! {
    model linkage "a flywheel that turns a slider-crank and a universal joint";
    source "textbooks of mechanics";

    coordinates {
        theta "rad" start 0.0, "rotation of the flywheel";
        psi "rad" start 0.0, "rotation of a wheel on a spring";
    }
    parameters {
        I_f "kg*m^2" required, open 0.0 to inf, "moment of inertia of the flywheel";
        I_w "kg*m^2" required, open 0.0 to inf, "moment of inertia of the wheel on a spring";
        r_p "m" required with crank, open 0.0 to inf, "radius of the crank of the piston";
        l_p "m" required with crank, open 0.0 to inf above r_p,
            "length of the connecting rod of the piston, longer than the radius of the crank";
        m_p "kg" required with crank, open 0.0 to inf, "moving mass of the piston, with a part of its rod";
        g_p "m/s^2" default 9.81 with gravity, open -inf to inf,
            "gravity along the path of the piston, towards the crank; negative if the piston is below it";
        beta "rad" required with joint, from 0.0 to inf, "angle between the shafts of the universal joint, less than a quarter turn";
        I_o "kg*m^2" required with joint, open 0.0 to inf, "moment of inertia behind the joint";
    }
    laws { k "N*m/rad" phase theta period 1.0 rolling unless(crank, gravity, joint), "stiffness of the spring of the wheel"; }
    motions { speed "rad/s" { theta_dot = 1.0; }, "rotational speed of the flywheel"; }
    effects {
        stiffness_step
            "the mesh stiffness steps as tooth pairs enter and leave, conserving energy by jump terms; else it has its mid value";
        rigid_kinematics requires(stiffness_step) excludes(frozen_phase)
            "drops the jump terms: speeds pass a step unchanged, and energy is not conserved";
        frozen_phase requires(stiffness_step) excludes(rigid_kinematics)
            "steps at the times of a steady rotation, k(Omega0 t) instead of k(theta): the classical equations";
        crank "a slider-crank on the flywheel";
        gravity "weight of bodies whose height varies";
        joint "a rotor behind a universal joint";
    }
    switching {
        stiffness_step => with_jump;
        rigid_kinematics => without_jump;
        frozen_phase => by_time;
    }
    conditions {
        jump_terms = stiffness_step, !rigid_kinematics, !frozen_phase;
        moving_phase = stiffness_step, !frozen_phase;
        crank_and_gravity = crank, gravity;
    }

    deflections {
        crank_p = theta;
        fork = theta;
    }
    functions {
        x_p = (l_p.powi(2) - r_p.powi(2)*crank_p.sin().powi(2)).sqrt() + r_p*crank_p.cos();
        dx_p = -r_p*crank_p.sin() - r_p.powi(2)*crank_p.cos()*crank_p.sin()/(l_p.powi(2) - r_p.powi(2)*crank_p.sin().powi(2)).sqrt();
        ddx_p = r_p.powi(2)*crank_p.sin().powi(2)/(l_p.powi(2) - r_p.powi(2)*crank_p.sin().powi(2)).sqrt() - r_p*crank_p.cos()
            - r_p.powi(2)*crank_p.cos().powi(2)/(l_p.powi(2) - r_p.powi(2)*crank_p.sin().powi(2)).sqrt()
            - r_p.powi(4)*crank_p.cos().powi(2)*crank_p.sin().powi(2)/(l_p.powi(2) - r_p.powi(2)*crank_p.sin().powi(2)).powf(3.0/2.0);
        dddx_p = r_p*crank_p.sin() + 4.0*r_p.powi(2)*crank_p.cos()*crank_p.sin()/(l_p.powi(2) - r_p.powi(2)*crank_p.sin().powi(2)).sqrt()
            - 3.0*r_p.powi(4)*crank_p.cos().powi(3)*crank_p.sin()/(l_p.powi(2) - r_p.powi(2)*crank_p.sin().powi(2)).powf(3.0/2.0)
            + 3.0*r_p.powi(4)*crank_p.sin().powi(3)*crank_p.cos()/(l_p.powi(2) - r_p.powi(2)*crank_p.sin().powi(2)).powf(3.0/2.0)
            - 3.0*r_p.powi(6)*crank_p.cos().powi(3)*crank_p.sin().powi(3)/(l_p.powi(2) - r_p.powi(2)*crank_p.sin().powi(2)).powf(5.0/2.0);
        ratio = beta.cos()/(1.0 - fork.cos().powi(2)*beta.sin().powi(2));
        dratio = -2.0*beta.sin().powi(2)*beta.cos()*fork.cos()*fork.sin()/(1.0 - fork.cos().powi(2)*beta.sin().powi(2)).powi(2);
        ddratio = 8.0*fork.cos().powi(2)*beta.sin().powi(4)*fork.sin().powi(2)*beta.cos()
            /(1.0 - fork.cos().powi(2)*beta.sin().powi(2)).powi(3)
            - 2.0*fork.cos().powi(2)*beta.sin().powi(2)*beta.cos()/(1.0 - fork.cos().powi(2)*beta.sin().powi(2)).powi(2)
            + 2.0*beta.sin().powi(2)*fork.sin().powi(2)*beta.cos()/(1.0 - fork.cos().powi(2)*beta.sin().powi(2)).powi(2);
        dddratio = 24.0*fork.cos().powi(3)*beta.sin().powi(4)*beta.cos()*fork.sin()/(1.0 - fork.cos().powi(2)*beta.sin().powi(2)).powi(3)
            - 48.0*fork.cos().powi(3)*beta.sin().powi(6)*fork.sin().powi(3)*beta.cos()
            /(1.0 - fork.cos().powi(2)*beta.sin().powi(2)).powi(4)
            + 8.0*beta.sin().powi(2)*beta.cos()*fork.cos()*fork.sin()/(1.0 - fork.cos().powi(2)*beta.sin().powi(2)).powi(2)
            - 24.0*beta.sin().powi(4)*fork.sin().powi(3)*beta.cos()*fork.cos()/(1.0 - fork.cos().powi(2)*beta.sin().powi(2)).powi(3);
    }
    energies {
        kinetic {
            _ => (I_f*theta_dot.powi(2) + I_w*psi_dot.powi(2))/2.0;
            crank => m_p*dx_p.powi(2)*theta_dot.powi(2)/2.0;
            joint => I_o*ratio.powi(2)*theta_dot.powi(2)/2.0;
        }
        potential {
            _ => k*psi.powi(2)/2.0;
            crank_and_gravity => g_p*m_p*x_p;
        }
    }
    torques {
    }
    work {
    }
    mass {
        theta theta {
            _ => I_f;
            crank => m_p*dx_p.powi(2);
            joint => I_o*ratio.powi(2);
        }
        psi psi { _ => I_w; }
    }
    inertia {
        theta theta {
            crank => 2.0*m_p*ddx_p*dx_p*theta_ddot;
            joint => 2.0*I_o*dratio*ratio*theta_ddot;
        }
    }
    force {
        theta {
            crank => -m_p*ddx_p*dx_p*theta_dot.powi(2);
            crank_and_gravity => -g_p*m_p*dx_p;
            joint => -I_o*dratio*ratio*theta_dot.powi(2);
            jump_terms => -dk*psi.powi(2)/2.0;
        }
        psi { _ => -k*psi; }
    }
    jacobian {
        theta theta { jump_terms => -ddk*psi.powi(2)/2.0; }
        theta psi { jump_terms => -dk*psi; }
        theta theta_dot {
            crank => -2.0*m_p*ddx_p*dx_p*theta_dot;
            joint => -2.0*I_o*dratio*ratio*theta_dot;
        }
        theta crank_p {
            crank => -m_p*dddx_p*dx_p*theta_dot.powi(2) - m_p*ddx_p.powi(2)*theta_dot.powi(2);
            crank_and_gravity => -g_p*m_p*ddx_p;
        }
        theta fork { joint => -I_o*ddratio*ratio*theta_dot.powi(2) - I_o*dratio.powi(2)*theta_dot.powi(2); }
        psi theta { moving_phase => -dk*psi; }
        psi psi { _ => -k; }
    }
    cell {
        stiffness { psi psi { _ => k; } }
        damping {
        }
        load {
        }
    }
    nonlinear_with {
        crank "M(theta) in the kinetic energy";
        joint "M(theta) in the kinetic energy";
        crank, gravity "g_p*m_p*x_p in the potential energy";
    }
    jump k { step { _ => dk*psi.powi(2)/2.0; } }
    outputs {
        rotor_speed_f "rad/s", "rotational speed of the flywheel" { _ => theta_dot; }
        rotor_speed_w "rad/s", "rotational speed of the wheel on a spring" { _ => psi_dot; }
        slider_place_p "m" with crank, "distance of the piston from the crank's axis" { _ => x_p; }
        slider_speed_p "m/s" with crank, "speed of the piston, away from the crank's axis" { _ => dx_p*theta_dot; }
        joint_speed "rad/s" with joint, "rotational speed behind the universal joint" { _ => ratio*theta_dot; }
    }

    text "text/linkage.txt";
    latex "latex/linkage.tex";
}

// Proved of these equations, symbolically:
//
// - d/dt (q'.dT/dq' - T + V) = Q.q' - q'.dD/dq' along the motion, for every value and slope of every law, with any set of the additive
//   effects
// - M is symmetric
// - T = q'.M q'/2, with M as written
// - M is positive definite: T is a sum of squares that vanish together only at rest
// - d/dt dT/dq' - dT/dq = M q'' + c, where F has -c_i = -sum (dM_ij/dq_k + dM_ik/dq_j - dM_jk/dq_i)/2 q'_j q'_k
// - at a step of k: T+ - T- = (v+² - v²)/(2 G) for any v+, where M d = n/G; V+ - V- = dV as written; so T + V is unchanged in transmission
//   (v+² = v² - 2 G dV) and in reflection (v+ = -v, dV = 0)
// - every deflection equals the linear form by which the equations differentiate it
// - without the jump terms the balance fails: energy is created at the rate dk*psi^2*theta_dot/2
//
// Operations, all effects present:
//
// | output | sums | products, quotients | functions, roots |
// | --- | --- | --- | --- |
// | force | 0 | 14 | 0 |
// | energy steps, all laws | 0 | 3 | 0 |
