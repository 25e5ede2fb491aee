//! Equations of motion of `element_mesh`: a mesh.
//!
//! Derived from the energies in `models/src/element_mesh.rs` by `cargo xtask derive element_mesh`.
//! Do not edit: change the energies and derive again.
//! For reading: `text/element_mesh.txt`, `latex/element_mesh.tex`. What is proved: at the end.

use gearsim::equations;

equations! {
    model element_mesh "a mesh";
    source "an element of trains";

    coordinates {
        phase "rad" start 0.0, "phase of the mesh; one pitch is 2 pi";
        s "m" start static, "relative motion of the gears along the line of action";
    }
    parameters {
        J_phase "kg*m^2" required, open 0.0 to inf, "test inertia, 0 in trains";
        J_s "kg" required, open 0.0 to inf, "test inertia, 0 in trains";
        c_x "N*s/m" required with viscous_friction_x, from 0.0 to inf,
            "viscous damping of the mesh {} along the line of action: force per speed";
        b_x "m" required with backlash_x, open 0.0 to inf, "backlash of the mesh {}: no contact within b/2 to either side";
        beta_K "s" default 0.0, from 0.0 to inf, "damping in proportion to stiffness";
    }
    laws {
        k_x "N/m" phase phase period 6.283185307179586 rolling, "stiffness of the mesh {} along the line of action";
        e_x "m" phase phase period 6.283185307179586 rolling with transmission_error_x,
            "transmission error of the mesh {} along the line of action";
    }
    motions {
    }
    effects {
        viscous_friction_x of viscous_friction "friction proportional to speed";
        stiffness_step
            "the mesh stiffness steps as tooth pairs enter and leave, conserving energy by jump terms; else it has its mid value";
        rigid_kinematics requires(stiffness_step) excludes(frozen_phase)
            "drops the jump terms: speeds pass a step unchanged, and energy is not conserved";
        frozen_phase requires(stiffness_step) excludes(rigid_kinematics)
            "steps at the times of a steady rotation, k(Omega0 t) instead of k(theta): the classical equations";
        transmission_error_x of transmission_error requires(stiffness_step)
            "flanks deviate from their ideal position: V = k (delta - e)^2/2, with the jump terms of e where it steps";
        backlash_x of backlash "play between the flanks: contact on the drive or coast flank, free motion between";
        damping "Rayleigh damping, C = alpha_M M + beta_K K at the mid stiffness";
    }
    switching {
        stiffness_step => with_jump;
        rigid_kinematics => without_jump;
        frozen_phase => by_time;
    }
    conditions {
        jump_terms = stiffness_step, !rigid_kinematics, !frozen_phase;
        moving_phase = stiffness_step, !frozen_phase;
        transmission_error_x_and_jump_terms = transmission_error_x, stiffness_step, !rigid_kinematics, !frozen_phase;
        transmission_error_x_and_backlash_x_and_moving_phase = transmission_error_x, backlash_x, stiffness_step, !frozen_phase;
        transmission_error_x_and_moving_phase = transmission_error_x, stiffness_step, !frozen_phase;
        backlash_x_and_moving_phase = backlash_x, stiffness_step, !frozen_phase;
    }

    deflections {
        beside_x = s;
        overx = s - edgex - e_x;
    }
    switches {
        overx "m" (touchx 1.0, edgex 0.0, dampx 1.0, clipx 0.0) with backlash_x, "play of the mesh {}" {
            upper (1.0, b_x/2.0, 1.0, 0.0) rests counts "flanks met" {
                unless free { overx { _ => 1.0; } }
                until upper_loose {
                    overx { _ => k_x; }
                    overx_dot { damping => beta_K*k_x_mid; }
                }
                until upper_hit {
                    overx { _ => k_x; }
                    overx_dot { damping => -beta_K*k_x_mid; }
                }
            }
            lower (1.0, -b_x/2.0, 1.0, 0.0) rests counts "flanks met" {
                unless free { overx { _ => -1.0; } }
                until lower_loose {
                    overx { _ => -k_x; }
                    overx_dot { damping => -beta_K*k_x_mid; }
                }
                until lower_hit {
                    overx { _ => -k_x; }
                    overx_dot { damping => beta_K*k_x_mid; }
                }
            }
            free (0.0, 0.0, 0.0, 0.0) rests {
                until upper {
                    overx { _ => -1.0; }
                    one { _ => b_x/2.0; }
                }
                until lower {
                    overx { _ => 1.0; }
                    one { _ => b_x/2.0; }
                }
            }
            upper_hit (1.0, b_x/2.0, 0.0, 1.0) counts "flanks met" {
                unless free { overx { _ => 1.0; } }
                until upper {
                    overx { _ => -k_x; }
                    overx_dot { damping => beta_K*k_x_mid; }
                }
            }
            lower_hit (1.0, -b_x/2.0, 0.0, 1.0) counts "flanks met" {
                unless free { overx { _ => -1.0; } }
                until lower {
                    overx { _ => k_x; }
                    overx_dot { damping => -beta_K*k_x_mid; }
                }
            }
            upper_loose (1.0, b_x/2.0, 0.0, -1.0) counts "flanks met" {
                until free { overx { _ => 1.0; } }
                until upper {
                    overx { _ => -k_x; }
                    overx_dot { damping => -beta_K*k_x_mid; }
                }
            }
            lower_loose (1.0, -b_x/2.0, 0.0, -1.0) counts "flanks met" {
                until free { overx { _ => -1.0; } }
                until lower {
                    overx { _ => k_x; }
                    overx_dot { damping => beta_K*k_x_mid; }
                }
            }
            loss { overx { _ => k_x*clipx*touchx; } }
        }
    }
    energies {
        kinetic { _ => (J_phase*phase_dot.powi(2) + J_s*s_dot.powi(2))/2.0; }
        potential { _ => k_x*touchx*overx.powi(2)/2.0; }
        dissipation {
            viscous_friction_x => c_x*beside_x_dot.powi(2)/2.0;
            damping => beta_K*k_x_mid*dampx*overx_dot.powi(2)/2.0;
        }
    }
    torques {
    }
    work {
    }
    mass {
        phase phase { _ => J_phase; }
        s s { _ => J_s; }
    }
    mobility {
        phase phase { _ => 1.0/J_phase; }
        s s { _ => 1.0/J_s; }
    }
    force {
        phase {
            transmission_error_x_and_jump_terms => k_x*de_x*touchx*overx;
            jump_terms => -dk_x*touchx*overx.powi(2)/2.0;
        }
        s {
            _ => -k_x*touchx*overx;
            viscous_friction_x => -c_x*beside_x_dot;
            backlash_x => -k_x*clipx*touchx*overx;
            damping => -beta_K*k_x_mid*dampx*overx_dot;
        }
    }
    jacobian {
        phase phase {
            transmission_error_x_and_jump_terms => k_x*dde_x*touchx*overx - k_x*de_x.powi(2)*touchx + 2.0*de_x*dk_x*touchx*overx;
            jump_terms => -ddk_x*touchx*overx.powi(2)/2.0;
        }
        phase overx {
            transmission_error_x_and_jump_terms => k_x*de_x*touchx;
            jump_terms => -dk_x*touchx*overx;
        }
        s phase {
            transmission_error_x_and_backlash_x_and_moving_phase => k_x*de_x*clipx*touchx;
            transmission_error_x_and_moving_phase => k_x*de_x*touchx;
            backlash_x_and_moving_phase => -dk_x*clipx*touchx*overx;
            moving_phase => -dk_x*touchx*overx;
        }
        s overx {
            _ => -k_x*touchx;
            backlash_x => -k_x*clipx*touchx;
        }
        s beside_x_dot { viscous_friction_x => -c_x; }
        s overx_dot { damping => -beta_K*k_x_mid*dampx; }
    }
    cell {
        stiffness {
            overx overx {
                _ => k_x*touchx;
                backlash_x => k_x*clipx*touchx;
            }
        }
        damping {
            beside_x beside_x { viscous_friction_x => c_x; }
            overx overx { damping => beta_K*k_x_mid*dampx; }
        }
        load {
            overx {
                _ => k_x*touchx*edgex + k_x*touchx*e_x;
                backlash_x => k_x*clipx*touchx*edgex + k_x*clipx*touchx*e_x;
            }
        }
    }
    jump k_x {
        compliance { _ => 1.0/J_phase; }
        direction { phase { _ => 1.0; } }
        step { _ => dk_x*touchx*overx.powi(2)/2.0; }
    }
    jump e_x {
        compliance { _ => 1.0/J_phase; }
        direction { phase { _ => 1.0; } }
        step { _ => k_x*de_x.powi(2)*touchx/2.0 - k_x*de_x*touchx*overx; }
    }
    outputs {
        contact_loss_x "1" with backlash_x, "1 while no force passes the mesh {}, else 0: its mean is the share of time without contact" {
            _ => 1.0 - touchx*(1.0 + clipx*(1.0 - clipx)/2.0);
        }
        mesh_force_x "N", "force of the mesh {} along the line of action, damper included: positive if it presses the drive flanks" {
            _ => k_x*touchx*overx;
            viscous_friction_x => c_x*beside_x_dot;
            backlash_x => k_x*clipx*touchx*overx;
            damping => beta_K*k_x_mid*dampx*overx_dot;
        }
        mesh_deflection_x "m", "deflection of the mesh {} along the line of action, backlash not taken off" { _ => s - e_x; }
        dte_x "m", "dynamic transmission error of the mesh {} along the line of action: positive if the driving gear is ahead" { _ => s; }
        mesh_loss_x "W", "power that the damper of the mesh {} takes" {
            viscous_friction_x => c_x*beside_x_dot.powi(2);
            backlash_x => k_x*clipx*touchx*overx*overx_dot;
            damping => beta_K*k_x_mid*dampx*overx_dot.powi(2);
        }
    }

    text "text/element_mesh.txt";
    latex "latex/element_mesh.tex";
}

// Proved of these equations, symbolically:
//
// - d/dt (q'.dT/dq' - T + V) = Q.q' - q'.dD/dq' along the motion, for every value and slope of every law, with any set of the additive
//   effects; q'.dD/dq' includes the power that switches take
// - M is symmetric
// - T = q'.M q'/2, with M as written
// - M is positive definite: every leading minor is a sum of products of positive quantities
// - M M⁻¹ = 1, and M q'' = F, for M⁻¹ and the accelerations as written
// - at a step of k_x, e_x: T+ - T- = (v+² - v²)/(2 G) for any v+, where M d = n/G; V+ - V- = dV as written; so T + V is unchanged in
//   transmission (v+² = v² - 2 G dV) and in reflection (v+ = -v, dV = 0)
// - V is the same on both sides of the exits of overx: no impulse there
// - the force of the switch overx takes energy or none: f overx_dot >= 0 in every mode, from the guards that hold in it; of a damper that
//   is clipped to f = c F, where F = dV/doverx and c = 1 or -1, since F overx >= 0, overx_dot dD/doverx_dot >= 0 and c overx dD/doverx_dot
//   >= F overx
// - every damper takes energy or none: each term of D has a power q'.dD/dq' that is never negative
// - every deflection equals the linear form by which the equations differentiate it
// - without the jump terms the balance fails: energy is created at the rate dk_x*touchx*overx^2*phase_dot/2 -
//   k_x*de_x*touchx*overx*phase_dot
//
// Operations, all effects present:
//
// | output | sums | products, quotients | functions, roots |
// | --- | --- | --- | --- |
// | force | 0 | 16 | 0 |
// | acceleration | 0 | 22 | 0 |
// | energy steps, all laws | 1 | 11 | 0 |
