//! Equations of motion of `my_axle`: a motor that drives a wheel through a gear pair and a shaft.
//!
//! Derived from the energies in `energies/src/my_axle.rs` by `cargo derive my_axle`.
//! Do not edit: change the energies and derive again.
//! For reading: `text/my_axle.txt`, `latex/my_axle.tex`. What is proved: at the end.

use gearsim::equations;

equations! {
    model my_axle "a motor that drives a wheel through a gear pair and a shaft";
    source "the tutorial of gearsim";

    coordinates {
        theta "rad" start 0.0, "mean rotation of gears 1 and 2; one pitch is 2 pi";
        s "m" start static, "motion of gear 1 relative to gear 2 along the line of action";
        psi "rad" start static, "twist of the shaft";
    }
    parameters {
        N1 "1" teeth required, open 0.0 to inf, "number of teeth of gear 1";
        N2 "1" teeth required, open 0.0 to inf, "number of teeth of gear 2";
        r1 "m" base_radius required, open 0.0 to inf, "base radius of gear 1";
        I1 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the motor with the driving gear";
        I2 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the driven gear";
        I_w "kg*m^2" required, open 0.0 to inf, "moment of inertia of the wheel";
        k_s "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft";
        alpha "rad" pressure_angle default 0.3490658503988659, open 0.0 to inf, "working pressure angle, for friction";
        b12 "m" required with backlash_12, open 0.0 to inf, "backlash of the mesh: no contact within b/2 to either side";
        mu12 "1" required with sliding_friction_12, from 0.0 to inf, "coefficient of friction of the mesh";
        w_mix12 "rad/s" default 0.1 with sliding_friction_12, open 0.0 to inf,
            "rolling speed omega1 + omega2 of the mesh below which friction decreases to zero (mixed film)";
        mu_rise12 "1" default 0.0 with flank_stiction_12, from 0.0 to inf,
            "excess of the static coefficient of friction of the mesh over that of sliding, relative to that";
        T_motor "N*m" required with torques, open -inf to inf, "driving torque of the motor";
        T_wheel "N*m" required with torques, open -inf to inf, "load torque of the wheel, against its rotation";
        alpha_M "1/s" default 0.0, from 0.0 to inf, "damping in proportion to inertia";
        beta_K "s" default 0.0, from 0.0 to inf, "damping in proportion to stiffness";
    }
    laws {
        k12 "N/m" phase theta period 6.283185307179586 rolling, "stiffness of the mesh along the line of action";
        e12 "m" phase theta period 6.283185307179586 rolling with transmission_error_12,
            "transmission error of the mesh along the line of action";
        side12 "1" phase theta period 6.283185307179586 rolling with sliding_friction_12 as side,
            "share of the force of the mesh on tooth pairs beyond the pitch point, minus that on pairs before it";
        arm12 "m" phase theta period 6.283185307179586 rolling with sliding_friction_12 as arm,
            "mean distance of the force of the mesh from the pitch point along the line of action";
    }
    motions { speed "rad/s" { theta_dot = N1; }, "rotational speed of the motor"; }
    effects {
        stiffness_step
            "the mesh stiffness steps as tooth pairs enter and leave, conserving energy by jump terms; else it has its mid value";
        rigid_kinematics requires(stiffness_step) excludes(frozen_phase)
            "drops the jump terms: speeds pass a step unchanged, and energy is not conserved";
        frozen_phase requires(stiffness_step) excludes(rigid_kinematics)
            "steps at the times of a steady rotation, k(Omega0 t) instead of k(theta): the classical equations";
        transmission_error_12 of transmission_error requires(stiffness_step)
            "flanks deviate from their ideal position: V = k (delta - e)^2/2, with the jump terms of e where it steps";
        backlash_12 of backlash "play between the flanks: contact on the drive or coast flank, free motion between";
        sliding_friction_12 of sliding_friction requires(stiffness_step)
            "Coulomb friction between the flanks, against their sliding, which turns as a tooth pair passes the pitch point";
        flank_stiction_12 of flank_stiction requires(sliding_friction_12)
            "flanks at rest stick, up to their static friction; sliding, their friction has its full size at any speed";
        torques "constant torques of motor and load";
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
        transmission_error_12_and_jump_terms = transmission_error_12, stiffness_step, !rigid_kinematics, !frozen_phase;
        transmission_error_12_and_sliding_friction_12_and_moving_phase = transmission_error_12, sliding_friction_12, stiffness_step,
            !frozen_phase;
        sliding_friction_12_and_moving_phase = sliding_friction_12, stiffness_step, !frozen_phase;
        transmission_error_12_and_backlash_12_and_moving_phase = transmission_error_12, backlash_12, stiffness_step, !frozen_phase;
        transmission_error_12_and_moving_phase = transmission_error_12, stiffness_step, !frozen_phase;
        backlash_12_and_moving_phase = backlash_12, stiffness_step, !frozen_phase;
    }

    constants {
        h = r1/N1;
        tan_a = alpha.sin()/alpha.cos();
        tiny12 = 1.0/1000000000000.0;
    }
    deflections {
        twist_s = psi;
        over12 = s - edge12 - e12;
        tau12 = tan_a*s;
        psi12 = s/(2.0*h*N1) - s/(2.0*h*N2) + theta/N1 + theta/N2;
    }
    forces {
        F_mu12 {
            sliding_friction_12 => mu12*k12*touch12*psi12_dot*(tiny12.powi(2) + over12.powi(2)).sqrt()
                /(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt();
            flank_stiction_12 => mu12*k12*slide_dir12*touch12*(tiny12.powi(2) + over12.powi(2)).sqrt()
                - mu12*k12*touch12*psi12_dot*(tiny12.powi(2) + over12.powi(2)).sqrt()/(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt();
        }
        F_tau12 { sliding_friction_12 => F_mu12*over12/(tiny12.powi(2) + over12.powi(2)).sqrt(); }
    }
    partials {
        F_mu12_by_over12 {
            sliding_friction_12 => mu12*k12*touch12*over12*psi12_dot
                /((tiny12.powi(2) + over12.powi(2)).sqrt()*(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt());
            flank_stiction_12 => mu12*k12*slide_dir12*touch12*over12/(tiny12.powi(2) + over12.powi(2)).sqrt()
                - mu12*k12*touch12*over12*psi12_dot/((tiny12.powi(2) + over12.powi(2)).sqrt()*(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt());
        }
        F_mu12_by_psi12_dot {
            sliding_friction_12 => mu12*k12*touch12*(tiny12.powi(2) + over12.powi(2)).sqrt()/(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt()
                - mu12*k12*touch12*psi12_dot.powi(2)*(tiny12.powi(2) + over12.powi(2)).sqrt()
                /(w_mix12.powi(2) + psi12_dot.powi(2)).powf(3.0/2.0);
            flank_stiction_12 => mu12*k12*touch12*psi12_dot.powi(2)*(tiny12.powi(2) + over12.powi(2)).sqrt()
                /(w_mix12.powi(2) + psi12_dot.powi(2)).powf(3.0/2.0)
                - mu12*k12*touch12*(tiny12.powi(2) + over12.powi(2)).sqrt()/(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt();
        }
        F_mu12_by_k12 {
            sliding_friction_12 => mu12*touch12*psi12_dot*(tiny12.powi(2) + over12.powi(2)).sqrt()
                /(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt();
            flank_stiction_12 => mu12*slide_dir12*touch12*(tiny12.powi(2) + over12.powi(2)).sqrt()
                - mu12*touch12*psi12_dot*(tiny12.powi(2) + over12.powi(2)).sqrt()/(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt();
        }
        F_tau12_by_over12 {
            sliding_friction_12 => F_mu12/(tiny12.powi(2) + over12.powi(2)).sqrt()
                - F_mu12*over12.powi(2)/(tiny12.powi(2) + over12.powi(2)).powf(3.0/2.0);
        }
        F_tau12_by_F_mu12 { sliding_friction_12 => over12/(tiny12.powi(2) + over12.powi(2)).sqrt(); }
    }
    switches {
        over12 "m" (touch12 1.0, edge12 0.0, damp12 1.0, clip12 0.0) with backlash_12, "play of the mesh" {
            upper (1.0, b12/2.0, 1.0, 0.0) rests counts "flanks met" {
                unless free { over12 { _ => 1.0; } }
                until upper_loose {
                    over12 { _ => k12; }
                    over12_dot { damping => beta_K*k12_mid; }
                }
                until upper_hit {
                    over12 { _ => k12; }
                    over12_dot { damping => -beta_K*k12_mid; }
                }
            }
            lower (1.0, -b12/2.0, 1.0, 0.0) rests counts "flanks met" {
                unless free { over12 { _ => -1.0; } }
                until lower_loose {
                    over12 { _ => -k12; }
                    over12_dot { damping => -beta_K*k12_mid; }
                }
                until lower_hit {
                    over12 { _ => -k12; }
                    over12_dot { damping => beta_K*k12_mid; }
                }
            }
            free (0.0, 0.0, 0.0, 0.0) rests {
                until upper {
                    over12 { _ => -1.0; }
                    one { _ => b12/2.0; }
                }
                until lower {
                    over12 { _ => 1.0; }
                    one { _ => b12/2.0; }
                }
            }
            upper_hit (1.0, b12/2.0, 0.0, 1.0) counts "flanks met" {
                unless free { over12 { _ => 1.0; } }
                until upper {
                    over12 { _ => -k12; }
                    over12_dot { damping => beta_K*k12_mid; }
                }
            }
            lower_hit (1.0, -b12/2.0, 0.0, 1.0) counts "flanks met" {
                unless free { over12 { _ => -1.0; } }
                until lower {
                    over12 { _ => k12; }
                    over12_dot { damping => -beta_K*k12_mid; }
                }
            }
            upper_loose (1.0, b12/2.0, 0.0, -1.0) counts "flanks met" {
                until free { over12 { _ => 1.0; } }
                until upper {
                    over12 { _ => -k12; }
                    over12_dot { damping => -beta_K*k12_mid; }
                }
            }
            lower_loose (1.0, -b12/2.0, 0.0, -1.0) counts "flanks met" {
                until free { over12 { _ => -1.0; } }
                until lower {
                    over12 { _ => k12; }
                    over12_dot { damping => beta_K*k12_mid; }
                }
            }
            loss { over12 { _ => k12*clip12*touch12; } }
        }
        psi12 "rad" (slide_dir12 0.0) with flank_stiction_12, "whether the flanks of the mesh stick" {
            stuck (0.0) holds rests counts "stuck" {
                unless stuck_coast { over12 { _ => 1.0; } }
                until forward {
                    over12 { _ => mu12*mu_rise12*k12*touch12 + mu12*k12*touch12; }
                    reaction { _ => -1.0; }
                }
                until backward {
                    over12 { _ => mu12*mu_rise12*k12*touch12 + mu12*k12*touch12; }
                    reaction { _ => 1.0; }
                }
            }
            stuck_coast (0.0) holds rests counts "stuck" {
                unless stuck { over12 { _ => -1.0; } }
                until forward_coast {
                    over12 { _ => -mu12*mu_rise12*k12*touch12 - mu12*k12*touch12; }
                    reaction { _ => -1.0; }
                }
                until backward_coast {
                    over12 { _ => -mu12*mu_rise12*k12*touch12 - mu12*k12*touch12; }
                    reaction { _ => 1.0; }
                }
            }
            forward (1.0) {
                until forward_coast { over12 { _ => 1.0; } }
                until stuck {
                    psi12_dot { _ => arm12; }
                    tau12_dot { _ => side12; }
                }
            }
            backward (-1.0) {
                until backward_coast { over12 { _ => 1.0; } }
                until stuck {
                    psi12_dot { _ => -arm12; }
                    tau12_dot { _ => -side12; }
                }
            }
            forward_coast (1.0) {
                until forward { over12 { _ => -1.0; } }
                until stuck_coast {
                    psi12_dot { _ => arm12; }
                    tau12_dot { _ => -side12; }
                }
            }
            backward_coast (-1.0) {
                until backward { over12 { _ => -1.0; } }
                until stuck_coast {
                    psi12_dot { _ => -arm12; }
                    tau12_dot { _ => side12; }
                }
            }
        }
    }
    energies {
        kinetic {
            _ => (I1*(s_dot/(2.0*h*N1) + theta_dot/N1).powi(2) + I2*(theta_dot/N2 - s_dot/(2.0*h*N2)).powi(2)
                + I_w*(theta_dot/N2 - psi_dot - s_dot/(2.0*h*N2)).powi(2))/2.0;
        }
        potential { _ => (k_s*twist_s.powi(2) + k12*touch12*over12.powi(2))/2.0; }
        dissipation {
            damping => (I1*alpha_M*(s_dot/(2.0*h*N1) + theta_dot/N1).powi(2) + I2*alpha_M*(theta_dot/N2 - s_dot/(2.0*h*N2)).powi(2)
                + I_w*alpha_M*(theta_dot/N2 - psi_dot - s_dot/(2.0*h*N2)).powi(2) + beta_K*k_s*twist_s_dot.powi(2)
                + beta_K*k12_mid*damp12*over12_dot.powi(2))/2.0;
        }
    }
    torques {
        slide12 "friction of the mesh, through the sliding of the flanks at the pitch point" {}
        power { sliding_friction_12 => -side12*F_tau12*tau12_dot; }
        roll12 "friction of the mesh, through the rolling of the gears" {}
        power { sliding_friction_12 => -arm12*F_mu12*psi12_dot; }
        motor "driving torque of the motor" { torques => T_motor*(s/(2.0*h*N1) + theta/N1); }
        wheel "load torque of the wheel, against its rotation" { torques => T_wheel*(psi + s/(2.0*h*N2) - theta/N2); }
    }
    work {
        theta { torques => T_motor/N1 - T_wheel/N2; }
        s { torques => (T_motor/(h*N1) + T_wheel/(h*N2))/2.0; }
        psi { torques => T_wheel; }
    }
    mass {
        theta theta { _ => I1/N1.powi(2) + I2/N2.powi(2) + I_w/N2.powi(2); }
        theta s { _ => (I1/(h*N1.powi(2)) - I2/(h*N2.powi(2)) - I_w/(h*N2.powi(2)))/2.0; }
        theta psi { _ => -I_w/N2; }
        s s { _ => (I1/(h.powi(2)*N1.powi(2)) + I2/(h.powi(2)*N2.powi(2)) + I_w/(h.powi(2)*N2.powi(2)))/4.0; }
        s psi { _ => I_w/(2.0*h*N2); }
        psi psi { _ => I_w; }
    }
    force {
        theta {
            transmission_error_12_and_jump_terms => k12*de12*touch12*over12;
            sliding_friction_12 => -arm12*F_mu12/N1 - arm12*F_mu12/N2;
            torques => T_motor/N1 - T_wheel/N2;
            damping => I_w*alpha_M*psi_dot/N2 - I1*alpha_M*theta_dot/N1.powi(2) - I2*alpha_M*theta_dot/N2.powi(2)
                - I_w*alpha_M*theta_dot/N2.powi(2) - I1*alpha_M*s_dot/(2.0*h*N1.powi(2)) + I2*alpha_M*s_dot/(2.0*h*N2.powi(2))
                + I_w*alpha_M*s_dot/(2.0*h*N2.powi(2));
            jump_terms => -dk12*touch12*over12.powi(2)/2.0;
        }
        s {
            _ => -k12*touch12*over12;
            backlash_12 => -k12*clip12*touch12*over12;
            sliding_friction_12 => arm12*F_mu12/(2.0*h*N2) - tan_a*side12*F_tau12 - arm12*F_mu12/(2.0*h*N1);
            torques => (T_motor/(h*N1) + T_wheel/(h*N2))/2.0;
            damping => I2*alpha_M*theta_dot/(2.0*h*N2.powi(2)) - beta_K*k12_mid*damp12*over12_dot
                - I1*alpha_M*s_dot/(4.0*h.powi(2)*N1.powi(2)) - I2*alpha_M*s_dot/(4.0*h.powi(2)*N2.powi(2))
                - I_w*alpha_M*s_dot/(4.0*h.powi(2)*N2.powi(2)) - I1*alpha_M*theta_dot/(2.0*h*N1.powi(2))
                + I_w*alpha_M*theta_dot/(2.0*h*N2.powi(2)) - I_w*alpha_M*psi_dot/(2.0*h*N2);
        }
        psi {
            _ => -k_s*twist_s;
            torques => T_wheel;
            damping => I_w*alpha_M*theta_dot/N2 - I_w*alpha_M*psi_dot - beta_K*k_s*twist_s_dot - I_w*alpha_M*s_dot/(2.0*h*N2);
        }
    }
    jacobian {
        theta theta {
            transmission_error_12_and_sliding_friction_12_and_moving_phase => de12*arm12*F_mu12_by_over12/N1
                + de12*arm12*F_mu12_by_over12/N2;
            transmission_error_12_and_jump_terms => k12*dde12*touch12*over12 - k12*de12.powi(2)*touch12 + 2.0*de12*dk12*touch12*over12;
            sliding_friction_12_and_moving_phase => -darm12*F_mu12/N1 - dk12*arm12*F_mu12_by_k12/N1 - darm12*F_mu12/N2
                - dk12*arm12*F_mu12_by_k12/N2;
            jump_terms => -ddk12*touch12*over12.powi(2)/2.0;
        }
        theta theta_dot { damping => -I1*alpha_M/N1.powi(2) - I2*alpha_M/N2.powi(2) - I_w*alpha_M/N2.powi(2); }
        theta s_dot { damping => (I2*alpha_M/(h*N2.powi(2)) - I1*alpha_M/(h*N1.powi(2)) + I_w*alpha_M/(h*N2.powi(2)))/2.0; }
        theta psi_dot { damping => I_w*alpha_M/N2; }
        theta over12 {
            transmission_error_12_and_jump_terms => k12*de12*touch12;
            sliding_friction_12 => -arm12*F_mu12_by_over12/N1 - arm12*F_mu12_by_over12/N2;
            jump_terms => -dk12*touch12*over12;
        }
        theta psi12_dot { sliding_friction_12 => -arm12*F_mu12_by_psi12_dot/N1 - arm12*F_mu12_by_psi12_dot/N2; }
        s theta {
            transmission_error_12_and_backlash_12_and_moving_phase => k12*de12*clip12*touch12;
            transmission_error_12_and_sliding_friction_12_and_moving_phase => tan_a*de12*side12*F_mu12_by_over12*F_tau12_by_F_mu12
                + tan_a*de12*side12*F_tau12_by_over12 + de12*arm12*F_mu12_by_over12/(2.0*h*N1) - de12*arm12*F_mu12_by_over12/(2.0*h*N2);
            transmission_error_12_and_moving_phase => k12*de12*touch12;
            backlash_12_and_moving_phase => -dk12*clip12*touch12*over12;
            sliding_friction_12_and_moving_phase => darm12*F_mu12/(2.0*h*N2) - tan_a*dk12*side12*F_mu12_by_k12*F_tau12_by_F_mu12
                - tan_a*dside12*F_tau12 - darm12*F_mu12/(2.0*h*N1) - dk12*arm12*F_mu12_by_k12/(2.0*h*N1)
                + dk12*arm12*F_mu12_by_k12/(2.0*h*N2);
            moving_phase => -dk12*touch12*over12;
        }
        s theta_dot { damping => (I2*alpha_M/(h*N2.powi(2)) - I1*alpha_M/(h*N1.powi(2)) + I_w*alpha_M/(h*N2.powi(2)))/2.0; }
        s s_dot {
            damping => (-I1*alpha_M/(h.powi(2)*N1.powi(2)) - I2*alpha_M/(h.powi(2)*N2.powi(2)) - I_w*alpha_M/(h.powi(2)*N2.powi(2)))/4.0;
        }
        s psi_dot { damping => -I_w*alpha_M/(2.0*h*N2); }
        s over12 {
            _ => -k12*touch12;
            backlash_12 => -k12*clip12*touch12;
            sliding_friction_12 => arm12*F_mu12_by_over12/(2.0*h*N2) - tan_a*side12*F_mu12_by_over12*F_tau12_by_F_mu12
                - tan_a*side12*F_tau12_by_over12 - arm12*F_mu12_by_over12/(2.0*h*N1);
        }
        s over12_dot { damping => -beta_K*k12_mid*damp12; }
        s psi12_dot {
            sliding_friction_12 => arm12*F_mu12_by_psi12_dot/(2.0*h*N2) - tan_a*side12*F_mu12_by_psi12_dot*F_tau12_by_F_mu12
                - arm12*F_mu12_by_psi12_dot/(2.0*h*N1);
        }
        psi theta_dot { damping => I_w*alpha_M/N2; }
        psi s_dot { damping => -I_w*alpha_M/(2.0*h*N2); }
        psi psi_dot { damping => -I_w*alpha_M; }
        psi twist_s { _ => -k_s; }
        psi twist_s_dot { damping => -beta_K*k_s; }
    }
    cell {
        stiffness {
            twist_s twist_s { _ => k_s; }
            over12 over12 {
                _ => k12*touch12;
                backlash_12 => k12*clip12*touch12;
            }
        }
        damping {
            theta theta { damping => I1*alpha_M/N1.powi(2) + I2*alpha_M/N2.powi(2) + I_w*alpha_M/N2.powi(2); }
            theta s { damping => (I1*alpha_M/(h*N1.powi(2)) - I2*alpha_M/(h*N2.powi(2)) - I_w*alpha_M/(h*N2.powi(2)))/2.0; }
            theta psi { damping => -I_w*alpha_M/N2; }
            s s {
                damping => (I1*alpha_M/(h.powi(2)*N1.powi(2)) + I2*alpha_M/(h.powi(2)*N2.powi(2)) + I_w*alpha_M/(h.powi(2)*N2.powi(2)))/4.0;
            }
            s psi { damping => I_w*alpha_M/(2.0*h*N2); }
            psi psi { damping => I_w*alpha_M; }
            twist_s twist_s { damping => beta_K*k_s; }
            over12 over12 { damping => beta_K*k12_mid*damp12; }
        }
        load {
            theta { torques => T_motor/N1 - T_wheel/N2; }
            s { torques => (T_motor/(h*N1) + T_wheel/(h*N2))/2.0; }
            psi { torques => T_wheel; }
            over12 {
                _ => k12*touch12*edge12 + k12*touch12*e12;
                backlash_12 => k12*clip12*touch12*edge12 + k12*clip12*touch12*e12;
            }
        }
    }
    nonlinear_with {
        sliding_friction_12 "-side12*F_tau12 in the torque `slide12`";
        sliding_friction_12 "-arm12*F_mu12 in the torque `roll12`";
    }
    jump k12 { step { _ => dk12*touch12*over12.powi(2)/2.0; } }
    jump e12 { step { _ => k12*de12.powi(2)*touch12/2.0 - k12*de12*touch12*over12; } }
    jump side12 { step {} }
    jump arm12 { step {} }
    outputs {
        rotor_speed_1 "rad/s", "rotational speed of the motor with the driving gear" { _ => s_dot/(2.0*h*N1) + theta_dot/N1; }
        rotor_speed_2 "rad/s", "rotational speed of the driven gear" { _ => theta_dot/N2 - s_dot/(2.0*h*N2); }
        rotor_speed_w "rad/s", "rotational speed of the wheel" { _ => theta_dot/N2 - psi_dot - s_dot/(2.0*h*N2); }
        shaft_twist_s "rad", "twist of the shaft" { _ => twist_s; }
        shaft_torque_s "N*m", "torque in the shaft, damper included" {
            _ => k_s*twist_s;
            damping => beta_K*k_s*twist_s_dot;
        }
        shaft_power_s "W", "power that enters the shaft at its first end: torque times the speed of that end" {
            _ => shaft_torque_s*(theta_dot/N2 - s_dot/(2.0*h*N2));
        }
        shaft_loss_s "W", "power that the damper of the shaft takes" { damping => beta_K*k_s*twist_s_dot.powi(2); }
        contact_loss_12 "1" with backlash_12, "1 while no force passes the mesh, else 0: its mean is the share of time without contact" {
            _ => 1.0 - touch12*(1.0 + clip12*(1.0 - clip12)/2.0);
        }
        mesh_force_12 "N", "force of the mesh along the line of action, damper included: positive if it presses the drive flanks" {
            _ => k12*touch12*over12;
            backlash_12 => k12*clip12*touch12*over12;
            damping => beta_K*k12_mid*damp12*over12_dot;
        }
        mesh_power_12 "W", "power that the first gear gives to the mesh: force times the speed of its flank" {
            _ => mesh_force_12*(s_dot/2.0 + h*theta_dot);
        }
        mesh_deflection_12 "m", "deflection of the mesh along the line of action, backlash not taken off" { _ => s - e12; }
        dte_12 "m", "dynamic transmission error of the mesh along the line of action: positive if the driving gear is ahead" { _ => s; }
        mesh_loss_12 "W", "power that the damper of the mesh takes" {
            backlash_12 => k12*clip12*touch12*over12*over12_dot;
            damping => beta_K*k12_mid*damp12*over12_dot.powi(2);
        }
        power_slide12 "W" with sliding_friction_12,
            "power of the friction of the mesh, through the sliding of the flanks at the pitch point: positive if it drives" {
            _ => slide12_power;
        }
        power_roll12 "W" with sliding_friction_12,
            "power of the friction of the mesh, through the rolling of the gears: positive if it drives" {
            _ => roll12_power;
        }
        power_motor "W" with torques, "power of the driving torque of the motor: positive if it drives" { _ => motor_power; }
        power_wheel "W" with torques, "power of the load torque of the wheel, against its rotation: positive if it drives" {
            _ => wheel_power;
        }
        inertia_damping_loss "W" with damping, "power that the damping in proportion to inertia takes" {
            _ => 2.0*alpha_M*((I1*(s_dot/(2.0*h*N1) + theta_dot/N1).powi(2) + I2*(theta_dot/N2 - s_dot/(2.0*h*N2)).powi(2)
                + I_w*(theta_dot/N2 - psi_dot - s_dot/(2.0*h*N2)).powi(2))/2.0);
        }
    }

    text "text/my_axle.txt";
    latex "latex/my_axle.tex";
}

// Proved of these equations, symbolically:
//
// - d/dt (q'.dT/dq' - T + V) = Q.q' - q'.dD/dq' along the motion, for every value and slope of every law, with any set of the additive
//   effects; q'.dD/dq' includes the power that switches take
// - M is symmetric
// - T = q'.M q'/2, with M as written
// - M is positive definite: every leading minor is a sum of products of positive quantities
// - at a step of k12, e12: T+ - T- = (v+² - v²)/(2 G) for any v+, where M d = n/G; V+ - V- = dV as written; so T + V is unchanged in
//   transmission (v+² = v² - 2 G dV) and in reflection (v+ = -v, dV = 0)
// - V is the same on both sides of a step of side12, arm12: no impulse there
// - V is the same on both sides of the exits of over12: no impulse there
// - the force of the switch over12 takes energy or none: f over12_dot >= 0 in every mode, from the guards that hold in it; of a damper that
//   is clipped to f = c F, where F = dV/dover12 and c = 1 or -1, since F over12 >= 0, over12_dot dD/dover12_dot >= 0 and c over12
//   dD/dover12_dot >= F over12
// - V is the same on both sides of the exits of psi12: no impulse there
// - every damper takes energy or none: each term of D has a power q'.dD/dq' that is never negative
// - the friction `roll12` takes energy or none: its power is never positive
// - the friction `slide12` is the force of `roll12` times at most 1, along its sign or against it
// - the friction `slide12` takes with `roll12` energy or none where psi12_dot and arm12 psi12_dot + side12 tau12_dot have one sign, on the
//   coast flank with -side12: where flanks slide as rolling makes them
// - the friction `slide12` takes with `roll12` energy or none in every mode of psi12, in scenes with flank_stiction_12: from the guards
//   that hold in the mode
// - every deflection equals the linear form by which the equations differentiate it
// - without the jump terms the balance fails: energy is created at the rate dk12*touch12*over12^2*theta_dot/2 -
//   k12*de12*touch12*over12*theta_dot
//
// Operations, all effects present:
//
// | output | sums | products, quotients | functions, roots |
// | --- | --- | --- | --- |
// | constants (once a scene) | 0 | 2 | 2 |
// | named forces | 7 | 28 | 6 |
// | force | 21 | 127 | 0 |
// | energy steps, all laws | 1 | 11 | 0 |
