//! Equations of motion of `element_mesh_with_friction`: a mesh with friction of the flanks.
//!
//! Derived from the energies in `models/src/element_mesh_with_friction.rs` by `cargo xtask derive element_mesh_with_friction`.
//! Do not edit: change the energies and derive again.
//! For reading: `text/element_mesh_with_friction.txt`, `latex/element_mesh_with_friction.tex`. What is proved: at the end.

use gearsim::equations;

equations! {
    model element_mesh_with_friction "a mesh with friction of the flanks";
    source "an element of trains";

    coordinates {
        phase "rad" start 0.0, "phase of the mesh; one pitch is 2 pi";
        s "m" start static, "relative motion of the gears along the line of action";
        psi "rad" start static, "rotation of the first gear relative to the second";
    }
    parameters {
        J_phase "kg*m^2" required, open 0.0 to inf, "test inertia, 0 in trains";
        J_s "kg" required, open 0.0 to inf, "test inertia, 0 in trains";
        J_psi "kg*m^2" required, open 0.0 to inf, "test inertia, 0 in trains";
        c_x "N*s/m" required with viscous_friction_x, from 0.0 to inf,
            "viscous damping of the mesh {} along the line of action: force per speed";
        b_x "m" required with backlash_x, open 0.0 to inf, "backlash of the mesh {}: no contact within b/2 to either side";
        alpha "rad" pressure_angle default 0.3490658503988659, open 0.0 to inf, "working pressure angle, for friction";
        mu_x "1" required with sliding_friction_x, from 0.0 to inf, "coefficient of friction of the mesh {}";
        w_mix_x "rad/s" default 0.1 with sliding_friction_x, open 0.0 to inf,
            "rolling speed omega1 + omega2 of the mesh {} below which friction decreases to zero (mixed film)";
        mu_rise_x "1" default 0.0 with flank_stiction_x, from 0.0 to inf,
            "excess of the static coefficient of friction of the mesh {} over that of sliding, relative to that";
        beta_K "s" default 0.0, from 0.0 to inf, "damping in proportion to stiffness";
    }
    laws {
        k_x "N/m" phase phase period 6.283185307179586 rolling, "stiffness of the mesh {} along the line of action";
        e_x "m" phase phase period 6.283185307179586 rolling with transmission_error_x,
            "transmission error of the mesh {} along the line of action";
        side_x "1" phase phase period 6.283185307179586 rolling with sliding_friction_x as side,
            "share of the force of the mesh {} on tooth pairs beyond the pitch point, minus that on pairs before it";
        arm_x "m" phase phase period 6.283185307179586 rolling with sliding_friction_x as arm,
            "mean distance of the force of the mesh {} from the pitch point along the line of action";
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
        sliding_friction_x of sliding_friction requires(stiffness_step)
            "Coulomb friction between the flanks, against their sliding, which turns as a tooth pair passes the pitch point";
        flank_stiction_x of flank_stiction requires(sliding_friction_x)
            "flanks at rest stick, up to their static friction; sliding, their friction has its full size at any speed";
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
        transmission_error_x_and_sliding_friction_x_and_moving_phase = transmission_error_x, sliding_friction_x, stiffness_step,
            !frozen_phase;
        transmission_error_x_and_moving_phase = transmission_error_x, stiffness_step, !frozen_phase;
        backlash_x_and_moving_phase = backlash_x, stiffness_step, !frozen_phase;
        sliding_friction_x_and_moving_phase = sliding_friction_x, stiffness_step, !frozen_phase;
    }

    constants {
        tan_a = alpha.sin()/alpha.cos();
        tiny_x = 1.0/1000000000000.0;
    }
    deflections {
        beside_x = s;
        overx = s - edgex - e_x;
        tau_x = tan_a*s;
        psi_x = psi;
    }
    forces {
        F_mu_x {
            sliding_friction_x => mu_x*k_x*touchx*psi_x_dot*(tiny_x.powi(2) + overx.powi(2)).sqrt()
                /(w_mix_x.powi(2) + psi_x_dot.powi(2)).sqrt();
            flank_stiction_x => mu_x*k_x*slide_dir_x*touchx*(tiny_x.powi(2) + overx.powi(2)).sqrt()
                - mu_x*k_x*touchx*psi_x_dot*(tiny_x.powi(2) + overx.powi(2)).sqrt()/(w_mix_x.powi(2) + psi_x_dot.powi(2)).sqrt();
        }
        F_tau_x { sliding_friction_x => F_mu_x*overx/(tiny_x.powi(2) + overx.powi(2)).sqrt(); }
    }
    partials {
        F_mu_x_by_overx {
            sliding_friction_x => mu_x*k_x*touchx*overx*psi_x_dot
                /((tiny_x.powi(2) + overx.powi(2)).sqrt()*(w_mix_x.powi(2) + psi_x_dot.powi(2)).sqrt());
            flank_stiction_x => mu_x*k_x*slide_dir_x*touchx*overx/(tiny_x.powi(2) + overx.powi(2)).sqrt()
                - mu_x*k_x*touchx*overx*psi_x_dot/((tiny_x.powi(2) + overx.powi(2)).sqrt()*(w_mix_x.powi(2) + psi_x_dot.powi(2)).sqrt());
        }
        F_mu_x_by_psi_x_dot {
            sliding_friction_x => mu_x*k_x*touchx*(tiny_x.powi(2) + overx.powi(2)).sqrt()/(w_mix_x.powi(2) + psi_x_dot.powi(2)).sqrt()
                - mu_x*k_x*touchx*psi_x_dot.powi(2)*(tiny_x.powi(2) + overx.powi(2)).sqrt()
                /(w_mix_x.powi(2) + psi_x_dot.powi(2)).powf(3.0/2.0);
            flank_stiction_x => mu_x*k_x*touchx*psi_x_dot.powi(2)*(tiny_x.powi(2) + overx.powi(2)).sqrt()
                /(w_mix_x.powi(2) + psi_x_dot.powi(2)).powf(3.0/2.0)
                - mu_x*k_x*touchx*(tiny_x.powi(2) + overx.powi(2)).sqrt()/(w_mix_x.powi(2) + psi_x_dot.powi(2)).sqrt();
        }
        F_mu_x_by_k_x {
            sliding_friction_x => mu_x*touchx*psi_x_dot*(tiny_x.powi(2) + overx.powi(2)).sqrt()
                /(w_mix_x.powi(2) + psi_x_dot.powi(2)).sqrt();
            flank_stiction_x => mu_x*slide_dir_x*touchx*(tiny_x.powi(2) + overx.powi(2)).sqrt()
                - mu_x*touchx*psi_x_dot*(tiny_x.powi(2) + overx.powi(2)).sqrt()/(w_mix_x.powi(2) + psi_x_dot.powi(2)).sqrt();
        }
        F_tau_x_by_overx {
            sliding_friction_x => F_mu_x/(tiny_x.powi(2) + overx.powi(2)).sqrt()
                - F_mu_x*overx.powi(2)/(tiny_x.powi(2) + overx.powi(2)).powf(3.0/2.0);
        }
        F_tau_x_by_F_mu_x { sliding_friction_x => overx/(tiny_x.powi(2) + overx.powi(2)).sqrt(); }
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
        psi_x "rad" (slide_dir_x 0.0) with flank_stiction_x, "whether the flanks of the mesh {} stick" {
            stuck (0.0) holds rests counts "stuck" {
                unless stuck_coast { overx { _ => 1.0; } }
                until forward {
                    overx { _ => mu_rise_x*mu_x*k_x*touchx + mu_x*k_x*touchx; }
                    reaction { _ => -1.0; }
                }
                until backward {
                    overx { _ => mu_rise_x*mu_x*k_x*touchx + mu_x*k_x*touchx; }
                    reaction { _ => 1.0; }
                }
            }
            stuck_coast (0.0) holds rests counts "stuck" {
                unless stuck { overx { _ => -1.0; } }
                until forward_coast {
                    overx { _ => -mu_rise_x*mu_x*k_x*touchx - mu_x*k_x*touchx; }
                    reaction { _ => -1.0; }
                }
                until backward_coast {
                    overx { _ => -mu_rise_x*mu_x*k_x*touchx - mu_x*k_x*touchx; }
                    reaction { _ => 1.0; }
                }
            }
            forward (1.0) {
                until forward_coast { overx { _ => 1.0; } }
                until stuck {
                    psi_x_dot { _ => arm_x; }
                    tau_x_dot { _ => side_x; }
                }
            }
            backward (-1.0) {
                until backward_coast { overx { _ => 1.0; } }
                until stuck {
                    psi_x_dot { _ => -arm_x; }
                    tau_x_dot { _ => -side_x; }
                }
            }
            forward_coast (1.0) {
                until forward { overx { _ => -1.0; } }
                until stuck_coast {
                    psi_x_dot { _ => arm_x; }
                    tau_x_dot { _ => -side_x; }
                }
            }
            backward_coast (-1.0) {
                until backward { overx { _ => -1.0; } }
                until stuck_coast {
                    psi_x_dot { _ => -arm_x; }
                    tau_x_dot { _ => side_x; }
                }
            }
        }
    }
    energies {
        kinetic { _ => (J_phase*phase_dot.powi(2) + J_psi*psi_dot.powi(2) + J_s*s_dot.powi(2))/2.0; }
        potential { _ => k_x*touchx*overx.powi(2)/2.0; }
        dissipation {
            viscous_friction_x => c_x*beside_x_dot.powi(2)/2.0;
            damping => beta_K*k_x_mid*dampx*overx_dot.powi(2)/2.0;
        }
    }
    torques {
        slide_x "friction of the mesh {}, through the sliding of the flanks at the pitch point" {}
        power { sliding_friction_x => -side_x*F_tau_x*tau_x_dot; }
        roll_x "friction of the mesh {}, through the rolling of the gears" {}
        power { sliding_friction_x => -arm_x*F_mu_x*psi_x_dot; }
    }
    work {
    }
    mass {
        phase phase { _ => J_phase; }
        s s { _ => J_s; }
        psi psi { _ => J_psi; }
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
            sliding_friction_x => -tan_a*side_x*F_tau_x;
            damping => -beta_K*k_x_mid*dampx*overx_dot;
        }
        psi { sliding_friction_x => -arm_x*F_mu_x; }
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
            transmission_error_x_and_sliding_friction_x_and_moving_phase => tan_a*de_x*side_x*F_mu_x_by_overx*F_tau_x_by_F_mu_x
                + tan_a*de_x*side_x*F_tau_x_by_overx;
            transmission_error_x_and_moving_phase => k_x*de_x*touchx;
            backlash_x_and_moving_phase => -dk_x*clipx*touchx*overx;
            sliding_friction_x_and_moving_phase => -tan_a*dk_x*side_x*F_mu_x_by_k_x*F_tau_x_by_F_mu_x - tan_a*dside_x*F_tau_x;
            moving_phase => -dk_x*touchx*overx;
        }
        s overx {
            _ => -k_x*touchx;
            backlash_x => -k_x*clipx*touchx;
            sliding_friction_x => -tan_a*side_x*F_mu_x_by_overx*F_tau_x_by_F_mu_x - tan_a*side_x*F_tau_x_by_overx;
        }
        s beside_x_dot { viscous_friction_x => -c_x; }
        s overx_dot { damping => -beta_K*k_x_mid*dampx; }
        s psi_x_dot { sliding_friction_x => -tan_a*side_x*F_mu_x_by_psi_x_dot*F_tau_x_by_F_mu_x; }
        psi phase {
            transmission_error_x_and_sliding_friction_x_and_moving_phase => de_x*arm_x*F_mu_x_by_overx;
            sliding_friction_x_and_moving_phase => -darm_x*F_mu_x - dk_x*arm_x*F_mu_x_by_k_x;
        }
        psi overx { sliding_friction_x => -arm_x*F_mu_x_by_overx; }
        psi psi_x_dot { sliding_friction_x => -arm_x*F_mu_x_by_psi_x_dot; }
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
    nonlinear_with {
        sliding_friction_x "-side_x*F_tau_x in the torque `slide_x`";
        sliding_friction_x "-arm_x*F_mu_x in the torque `roll_x`";
    }
    jump k_x { step { _ => dk_x*touchx*overx.powi(2)/2.0; } }
    jump e_x { step { _ => k_x*de_x.powi(2)*touchx/2.0 - k_x*de_x*touchx*overx; } }
    jump side_x { step {} }
    jump arm_x { step {} }
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
        power_slide_x "W" with sliding_friction_x,
            "power of the friction of the mesh {}, through the sliding of the flanks at the pitch point: positive if it drives" {
            _ => slide_x_power;
        }
        power_roll_x "W" with sliding_friction_x,
            "power of the friction of the mesh {}, through the rolling of the gears: positive if it drives" {
            _ => roll_x_power;
        }
    }

    text "text/element_mesh_with_friction.txt";
    latex "latex/element_mesh_with_friction.tex";
}

// Proved of these equations, symbolically:
//
// - d/dt (q'.dT/dq' - T + V) = Q.q' - q'.dD/dq' along the motion, for every value and slope of every law, with any set of the additive
//   effects; q'.dD/dq' includes the power that switches take
// - M is symmetric
// - T = q'.M q'/2, with M as written
// - M is positive definite: every leading minor is a sum of products of positive quantities
// - at a step of k_x, e_x: T+ - T- = (v+² - v²)/(2 G) for any v+, where M d = n/G; V+ - V- = dV as written; so T + V is unchanged in
//   transmission (v+² = v² - 2 G dV) and in reflection (v+ = -v, dV = 0)
// - V is the same on both sides of a step of side_x, arm_x: no impulse there
// - V is the same on both sides of the exits of overx: no impulse there
// - the force of the switch overx takes energy or none: f overx_dot >= 0 in every mode, from the guards that hold in it; of a damper that
//   is clipped to f = c F, where F = dV/doverx and c = 1 or -1, since F overx >= 0, overx_dot dD/doverx_dot >= 0 and c overx dD/doverx_dot
//   >= F overx
// - V is the same on both sides of the exits of psi_x: no impulse there
// - every damper takes energy or none: each term of D has a power q'.dD/dq' that is never negative
// - the friction `roll_x` takes energy or none: its power is never positive
// - the friction `slide_x` is the force of `roll_x` times at most 1, along its sign or against it
// - the friction `slide_x` takes with `roll_x` energy or none where psi_x_dot and arm_x psi_x_dot + side_x tau_x_dot have one sign, on the
//   coast flank with -side_x: where flanks slide as rolling makes them
// - the friction `slide_x` takes with `roll_x` energy or none in every mode of psi_x, in scenes with flank_stiction_x: from the guards that
//   hold in the mode
// - every deflection equals the linear form by which the equations differentiate it
// - without the jump terms the balance fails: energy is created at the rate dk_x*touchx*overx^2*phase_dot/2 -
//   k_x*de_x*touchx*overx*phase_dot
//
// Operations, all effects present:
//
// | output | sums | products, quotients | functions, roots |
// | --- | --- | --- | --- |
// | constants (once a scene) | 0 | 1 | 2 |
// | named forces | 7 | 28 | 6 |
// | force | 0 | 19 | 0 |
// | energy steps, all laws | 1 | 11 | 0 |
