//! Equations of motion of `wind_turbine`: a wind turbine's train: rotor, planetary stage, parallel stage, generator.
//!
//! Derived from the energies in `models/src/wind_turbine.rs` by `cargo xtask derive wind_turbine`.
//! Do not edit: change the energies and derive again.
//! For reading: `text/wind_turbine.txt`, `latex/wind_turbine.tex`. What is proved: at the end.

use gearsim::equations;

equations! {
    model wind_turbine "a wind turbine's train: rotor, planetary stage, parallel stage, generator";
    source "standard torsional model, e.g. Peeters, Vandepitte & Sas (2006), Wind Energy 9(1-2)";

    coordinates {
        theta "rad" start 0.0, "phase of the meshes, Z_s (theta_s - theta_c)";
        theta_c "rad" start static, "rotation of the carrier in excess of rigid rolling";
        theta2 "rad" start static, "mean rotation of gears 1 and 2; one pitch is 2 pi";
        s2 "m" start static, "motion of gear 1 relative to gear 2 along the line of action";
        psi_l "rad" start static, "twist of the low-speed shaft";
        psi_h "rad" start static, "twist of the high-speed shaft";
        u1 "m" start static, "rotation of planet 1 in excess of rigid rolling, times its base radius";
        u2 "m" start static, "rotation of planet 2 in excess of rigid rolling, times its base radius";
        u3 "m" start static, "rotation of planet 3 in excess of rigid rolling, times its base radius";
    }
    parameters {
        Z_s "1" required, open 0.0 to inf, "number of teeth of the sun";
        Z_r "1" required, open 0.0 to inf, "number of teeth of the ring";
        r_s "m" required, open 0.0 to inf, "base radius of the sun";
        alpha "rad" default 0.3490658503988659, open 0.0 to inf, "pressure angle";
        N1 "1" required, open 0.0 to inf, "number of teeth of gear 1";
        N2 "1" required, open 0.0 to inf, "number of teeth of gear 2";
        r1 "m" required, open 0.0 to inf, "base radius of gear 1";
        I_b "kg*m^2" required, open 0.0 to inf, "moment of inertia of the rotor with its blades";
        I_c "kg*m^2" required, open 0.0 to inf, "moment of inertia of the carrier without planets";
        I_s "kg*m^2" required, open 0.0 to inf, "moment of inertia of the sun";
        I1 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the wheel of the parallel stage";
        I2 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the pinion of the parallel stage";
        I_g "kg*m^2" required, open 0.0 to inf, "moment of inertia of the generator";
        k_l "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the low-speed shaft";
        k_i "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the intermediate shaft";
        k_h "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the high-speed shaft";
        m_p "kg" required, open 0.0 to inf, "mass of a planet";
        I_p "kg*m^2" required, open 0.0 to inf, "moment of inertia of a planet";
        b12 "m" required with backlash_12, open 0.0 to inf,
            "backlash of the mesh of the parallel stage: no contact within b/2 to either side";
        T_wind "N*m" required with torques, open -inf to inf, "driving torque of the rotor";
        T_generator "N*m" required with torques, open -inf to inf, "load torque of the generator, against its rotation";
        alpha_M "1/s" default 0.0, from 0.0 to inf, "damping in proportion to inertia";
        beta_K "s" default 0.0, from 0.0 to inf, "damping in proportion to stiffness";
    }
    laws {
        k_s1 "N/m" phase theta period 6.283185307179586, "stiffness of the mesh of sun and planet 1 along the line of action";
        k_r1 "N/m" phase theta period 6.283185307179586, "stiffness of the mesh of ring and planet 1 along the line of action";
        k_s2 "N/m" phase theta period 6.283185307179586, "stiffness of the mesh of sun and planet 2 along the line of action";
        k_r2 "N/m" phase theta period 6.283185307179586, "stiffness of the mesh of ring and planet 2 along the line of action";
        k_s3 "N/m" phase theta period 6.283185307179586, "stiffness of the mesh of sun and planet 3 along the line of action";
        k_r3 "N/m" phase theta period 6.283185307179586, "stiffness of the mesh of ring and planet 3 along the line of action";
        k12 "N/m" phase theta2 period 6.283185307179586, "stiffness of the mesh of the parallel stage along the line of action";
        e_s1 "m" phase theta period 6.283185307179586 with transmission_error_s1,
            "transmission error of the mesh of sun and planet 1 along the line of action";
        e_r1 "m" phase theta period 6.283185307179586 with transmission_error_r1,
            "transmission error of the mesh of ring and planet 1 along the line of action";
        e_s2 "m" phase theta period 6.283185307179586 with transmission_error_s2,
            "transmission error of the mesh of sun and planet 2 along the line of action";
        e_r2 "m" phase theta period 6.283185307179586 with transmission_error_r2,
            "transmission error of the mesh of ring and planet 2 along the line of action";
        e_s3 "m" phase theta period 6.283185307179586 with transmission_error_s3,
            "transmission error of the mesh of sun and planet 3 along the line of action";
        e_r3 "m" phase theta period 6.283185307179586 with transmission_error_r3,
            "transmission error of the mesh of ring and planet 3 along the line of action";
        e12 "m" phase theta2 period 6.283185307179586 with transmission_error_12,
            "transmission error of the mesh of the parallel stage along the line of action";
    }
    motions { speed "rad/s" { theta_dot = Z_r*Z_s/(Z_r + Z_s); theta2_dot = N1; }, "rotational speed of the sun"; }
    effects {
        stiffness_step
            "the mesh stiffness steps as tooth pairs enter and leave, conserving energy by jump terms; else it has its mid value";
        rigid_kinematics requires(stiffness_step) excludes(frozen_phase)
            "drops the jump terms: speeds pass a step unchanged, and energy is not conserved";
        frozen_phase requires(stiffness_step) excludes(rigid_kinematics)
            "steps at the times of a steady rotation, k(Omega0 t) instead of k(theta): the classical equations";
        transmission_error_s1 of transmission_error requires(stiffness_step)
            "flanks deviate from their ideal position: V = k (delta - e)^2/2, with the jump terms of e where it steps";
        transmission_error_r1 of transmission_error requires(stiffness_step)
            "flanks deviate from their ideal position: V = k (delta - e)^2/2, with the jump terms of e where it steps";
        transmission_error_s2 of transmission_error requires(stiffness_step)
            "flanks deviate from their ideal position: V = k (delta - e)^2/2, with the jump terms of e where it steps";
        transmission_error_r2 of transmission_error requires(stiffness_step)
            "flanks deviate from their ideal position: V = k (delta - e)^2/2, with the jump terms of e where it steps";
        transmission_error_s3 of transmission_error requires(stiffness_step)
            "flanks deviate from their ideal position: V = k (delta - e)^2/2, with the jump terms of e where it steps";
        transmission_error_r3 of transmission_error requires(stiffness_step)
            "flanks deviate from their ideal position: V = k (delta - e)^2/2, with the jump terms of e where it steps";
        transmission_error_12 of transmission_error requires(stiffness_step)
            "flanks deviate from their ideal position: V = k (delta - e)^2/2, with the jump terms of e where it steps";
        backlash_12 of backlash "play between the flanks: contact on the drive or coast flank, free motion between";
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
        transmission_error_s1_and_jump_terms = transmission_error_s1, stiffness_step, !rigid_kinematics, !frozen_phase;
        transmission_error_r1_and_jump_terms = transmission_error_r1, stiffness_step, !rigid_kinematics, !frozen_phase;
        transmission_error_s2_and_jump_terms = transmission_error_s2, stiffness_step, !rigid_kinematics, !frozen_phase;
        transmission_error_r2_and_jump_terms = transmission_error_r2, stiffness_step, !rigid_kinematics, !frozen_phase;
        transmission_error_s3_and_jump_terms = transmission_error_s3, stiffness_step, !rigid_kinematics, !frozen_phase;
        transmission_error_r3_and_jump_terms = transmission_error_r3, stiffness_step, !rigid_kinematics, !frozen_phase;
        transmission_error_12_and_jump_terms = transmission_error_12, stiffness_step, !rigid_kinematics, !frozen_phase;
        transmission_error_r1_and_moving_phase = transmission_error_r1, stiffness_step, !frozen_phase;
        transmission_error_r2_and_moving_phase = transmission_error_r2, stiffness_step, !frozen_phase;
        transmission_error_r3_and_moving_phase = transmission_error_r3, stiffness_step, !frozen_phase;
        transmission_error_12_and_backlash_12_and_moving_phase = transmission_error_12, backlash_12, stiffness_step, !frozen_phase;
        transmission_error_12_and_moving_phase = transmission_error_12, stiffness_step, !frozen_phase;
        backlash_12_and_moving_phase = backlash_12, stiffness_step, !frozen_phase;
        transmission_error_s1_and_moving_phase = transmission_error_s1, stiffness_step, !frozen_phase;
        transmission_error_s2_and_moving_phase = transmission_error_s2, stiffness_step, !frozen_phase;
        transmission_error_s3_and_moving_phase = transmission_error_s3, stiffness_step, !frozen_phase;
    }

    constants {
        cos_a = alpha.cos();
        sin_a = alpha.sin();
        h = r_s/Z_s;
        r_p = (h*Z_r - h*Z_s)/2.0;
        a = (h*Z_r/cos_a + h*Z_s/cos_a)/2.0;
        h2 = r1/N1;
    }
    deflections {
        twist_l = psi_l;
        twist_i = theta_c - s2/(2.0*h2*N1) - theta2/N1 + theta/Z_r + theta/Z_s;
        twist_h = psi_h;
        delta_s1 = u1 - e_s1;
        delta_r1 = -u1 - e_r1 - h*Z_r*theta_c;
        delta_s2 = u2 - e_s2;
        delta_r2 = -u2 - e_r2 - h*Z_r*theta_c;
        delta_s3 = u3 - e_s3;
        delta_r3 = -u3 - e_r3 - h*Z_r*theta_c;
        over12 = s2 - edge12 - e12;
    }
    switches {
        over12 "m" (touch12 1.0, edge12 0.0, damp12 1.0, clip12 0.0) with backlash_12, "play of the mesh of the parallel stage" {
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
    }
    energies {
        kinetic {
            _ => I1*(s2_dot/(2.0*h2*N1) + theta2_dot/N1).powi(2)/2.0 + I2*(theta2_dot/N2 - s2_dot/(2.0*h2*N2)).powi(2)/2.0
                + I_b*(psi_l_dot + theta_c_dot + theta_dot/Z_r).powi(2)/2.0 + I_c*(theta_c_dot + theta_dot/Z_r).powi(2)/2.0
                + I_g*(theta2_dot/N2 - psi_h_dot - s2_dot/(2.0*h2*N2)).powi(2)/2.0
                + I_p*(theta_c_dot + (u1_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)/2.0
                + I_p*(theta_c_dot + (u2_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)/2.0
                + I_p*(theta_c_dot + (u3_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)/2.0
                + I_s*(theta_c_dot + theta_dot*(1.0/Z_r + 1.0/Z_s)).powi(2)/2.0
                + 3.0*a.powi(2)*m_p*(theta_c_dot + theta_dot/Z_r).powi(2)/2.0;
        }
        potential {
            _ => (k_h*twist_h.powi(2) + k_i*twist_i.powi(2) + k_l*twist_l.powi(2) + k12*touch12*over12.powi(2) + k_r1*delta_r1.powi(2)
                + k_r2*delta_r2.powi(2) + k_r3*delta_r3.powi(2) + k_s1*delta_s1.powi(2) + k_s2*delta_s2.powi(2)
                + k_s3*delta_s3.powi(2))/2.0;
        }
        dissipation {
            damping => I1*alpha_M*(s2_dot/(2.0*h2*N1) + theta2_dot/N1).powi(2)/2.0
                + I2*alpha_M*(theta2_dot/N2 - s2_dot/(2.0*h2*N2)).powi(2)/2.0
                + I_b*alpha_M*(psi_l_dot + theta_c_dot + theta_dot/Z_r).powi(2)/2.0
                + I_c*alpha_M*(theta_c_dot + theta_dot/Z_r).powi(2)/2.0
                + I_g*alpha_M*(theta2_dot/N2 - psi_h_dot - s2_dot/(2.0*h2*N2)).powi(2)/2.0
                + I_p*alpha_M*(theta_c_dot + (u1_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)/2.0
                + I_p*alpha_M*(theta_c_dot + (u2_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)/2.0
                + I_p*alpha_M*(theta_c_dot + (u3_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)/2.0
                + I_s*alpha_M*(theta_c_dot + theta_dot*(1.0/Z_r + 1.0/Z_s)).powi(2)/2.0 + beta_K*k_h*twist_h_dot.powi(2)/2.0
                + beta_K*k_i*twist_i_dot.powi(2)/2.0 + beta_K*k_l*twist_l_dot.powi(2)/2.0 + beta_K*k12_mid*damp12*over12_dot.powi(2)/2.0
                + beta_K*k_r1_mid*delta_r1_dot.powi(2)/2.0 + beta_K*k_r2_mid*delta_r2_dot.powi(2)/2.0
                + beta_K*k_r3_mid*delta_r3_dot.powi(2)/2.0 + beta_K*k_s1_mid*delta_s1_dot.powi(2)/2.0
                + beta_K*k_s2_mid*delta_s2_dot.powi(2)/2.0 + beta_K*k_s3_mid*delta_s3_dot.powi(2)/2.0
                + 3.0*a.powi(2)*alpha_M*m_p*(theta_c_dot + theta_dot/Z_r).powi(2)/2.0;
        }
    }
    torques {
        wind "driving torque of the rotor" { torques => T_wind*(psi_l + theta_c + theta/Z_r); }
        generator "load torque of the generator, against its rotation" { torques => T_generator*(psi_h + s2/(2.0*h2*N2) - theta2/N2); }
    }
    work {
        theta { torques => T_wind/Z_r; }
        theta_c { torques => T_wind; }
        theta2 { torques => -T_generator/N2; }
        s2 { torques => T_generator/(2.0*h2*N2); }
        psi_l { torques => T_wind; }
        psi_h { torques => T_generator; }
    }
    mass {
        theta theta {
            _ => I_b/Z_r.powi(2) - 6.0*h*I_p/(r_p*Z_r) + I_c/Z_r.powi(2) + 3.0*I_p/Z_r.powi(2) + I_s/Z_r.powi(2) + 2.0*I_s/(Z_r*Z_s)
                + I_s/Z_s.powi(2) + 3.0*a.powi(2)*m_p/Z_r.powi(2) + 3.0*h.powi(2)*I_p/r_p.powi(2);
        }
        theta theta_c { _ => I_b/Z_r - 3.0*h*I_p/r_p + I_c/Z_r + 3.0*I_p/Z_r + I_s/Z_r + I_s/Z_s + 3.0*a.powi(2)*m_p/Z_r; }
        theta psi_l { _ => I_b/Z_r; }
        theta u1 { _ => I_p/(r_p*Z_r) - h*I_p/r_p.powi(2); }
        theta u2 { _ => I_p/(r_p*Z_r) - h*I_p/r_p.powi(2); }
        theta u3 { _ => I_p/(r_p*Z_r) - h*I_p/r_p.powi(2); }
        theta_c theta_c { _ => I_b + I_c + 3.0*I_p + I_s + 3.0*a.powi(2)*m_p; }
        theta_c psi_l { _ => I_b; }
        theta_c u1 { _ => I_p/r_p; }
        theta_c u2 { _ => I_p/r_p; }
        theta_c u3 { _ => I_p/r_p; }
        theta2 theta2 { _ => I1/N1.powi(2) + I2/N2.powi(2) + I_g/N2.powi(2); }
        theta2 s2 { _ => (I1/(h2*N1.powi(2)) - I2/(h2*N2.powi(2)) - I_g/(h2*N2.powi(2)))/2.0; }
        theta2 psi_h { _ => -I_g/N2; }
        s2 s2 { _ => (I1/(h2.powi(2)*N1.powi(2)) + I2/(h2.powi(2)*N2.powi(2)) + I_g/(h2.powi(2)*N2.powi(2)))/4.0; }
        s2 psi_h { _ => I_g/(2.0*h2*N2); }
        psi_l psi_l { _ => I_b; }
        psi_h psi_h { _ => I_g; }
        u1 u1 { _ => I_p/r_p.powi(2); }
        u2 u2 { _ => I_p/r_p.powi(2); }
        u3 u3 { _ => I_p/r_p.powi(2); }
    }
    force {
        theta {
            _ => -k_i*twist_i/Z_r - k_i*twist_i/Z_s;
            transmission_error_s1_and_jump_terms => k_s1*de_s1*delta_s1;
            transmission_error_r1_and_jump_terms => k_r1*de_r1*delta_r1;
            transmission_error_s2_and_jump_terms => k_s2*de_s2*delta_s2;
            transmission_error_r2_and_jump_terms => k_r2*de_r2*delta_r2;
            transmission_error_s3_and_jump_terms => k_s3*de_s3*delta_s3;
            transmission_error_r3_and_jump_terms => k_r3*de_r3*delta_r3;
            torques => T_wind/Z_r;
            damping => h*I_p*alpha_M*u1_dot/r_p.powi(2) + h*I_p*alpha_M*u2_dot/r_p.powi(2) + h*I_p*alpha_M*u3_dot/r_p.powi(2)
                + 3.0*h*I_p*alpha_M*theta_c_dot/r_p + 6.0*h*I_p*alpha_M*theta_dot/(r_p*Z_r) - I_b*alpha_M*theta_dot/Z_r.powi(2)
                - I_b*alpha_M*psi_l_dot/Z_r - I_b*alpha_M*theta_c_dot/Z_r - I_c*alpha_M*theta_dot/Z_r.powi(2)
                - I_c*alpha_M*theta_c_dot/Z_r - 3.0*I_p*alpha_M*theta_dot/Z_r.powi(2) - 3.0*I_p*alpha_M*theta_c_dot/Z_r
                - I_s*alpha_M*theta_dot/Z_r.powi(2) - I_s*alpha_M*theta_c_dot/Z_r - 2.0*I_s*alpha_M*theta_dot/(Z_r*Z_s)
                - I_s*alpha_M*theta_dot/Z_s.powi(2) - I_s*alpha_M*theta_c_dot/Z_s - 3.0*a.powi(2)*alpha_M*m_p*theta_dot/Z_r.powi(2)
                - 3.0*a.powi(2)*alpha_M*m_p*theta_c_dot/Z_r - 3.0*h.powi(2)*I_p*alpha_M*theta_dot/r_p.powi(2)
                - I_p*alpha_M*u1_dot/(r_p*Z_r) - I_p*alpha_M*u2_dot/(r_p*Z_r) - I_p*alpha_M*u3_dot/(r_p*Z_r) - beta_K*k_i*twist_i_dot/Z_r
                - beta_K*k_i*twist_i_dot/Z_s;
            jump_terms => (-dk_r1*delta_r1.powi(2) - dk_r2*delta_r2.powi(2) - dk_r3*delta_r3.powi(2) - dk_s1*delta_s1.powi(2)
                - dk_s2*delta_s2.powi(2) - dk_s3*delta_s3.powi(2))/2.0;
        }
        theta_c {
            _ => h*Z_r*k_r1*delta_r1 + h*Z_r*k_r2*delta_r2 + h*Z_r*k_r3*delta_r3 - k_i*twist_i;
            torques => T_wind;
            damping => h*Z_r*beta_K*k_r1_mid*delta_r1_dot + h*Z_r*beta_K*k_r2_mid*delta_r2_dot + h*Z_r*beta_K*k_r3_mid*delta_r3_dot
                + 3.0*h*I_p*alpha_M*theta_dot/r_p - I_b*alpha_M*psi_l_dot - I_b*alpha_M*theta_c_dot - I_b*alpha_M*theta_dot/Z_r
                - I_c*alpha_M*theta_c_dot - I_c*alpha_M*theta_dot/Z_r - 3.0*I_p*alpha_M*theta_c_dot - 3.0*I_p*alpha_M*theta_dot/Z_r
                - I_s*alpha_M*theta_c_dot - I_s*alpha_M*theta_dot/Z_r - I_s*alpha_M*theta_dot/Z_s - beta_K*k_i*twist_i_dot
                - 3.0*a.powi(2)*alpha_M*m_p*theta_c_dot - 3.0*a.powi(2)*alpha_M*m_p*theta_dot/Z_r - I_p*alpha_M*u1_dot/r_p
                - I_p*alpha_M*u2_dot/r_p - I_p*alpha_M*u3_dot/r_p;
        }
        theta2 {
            _ => k_i*twist_i/N1;
            transmission_error_12_and_jump_terms => k12*de12*touch12*over12;
            torques => -T_generator/N2;
            damping => I_g*alpha_M*psi_h_dot/N2 - I1*alpha_M*theta2_dot/N1.powi(2) - I2*alpha_M*theta2_dot/N2.powi(2)
                - I_g*alpha_M*theta2_dot/N2.powi(2) - I1*alpha_M*s2_dot/(2.0*h2*N1.powi(2)) + I2*alpha_M*s2_dot/(2.0*h2*N2.powi(2))
                + I_g*alpha_M*s2_dot/(2.0*h2*N2.powi(2)) + beta_K*k_i*twist_i_dot/N1;
            jump_terms => -dk12*touch12*over12.powi(2)/2.0;
        }
        s2 {
            _ => k_i*twist_i/(2.0*h2*N1) - k12*touch12*over12;
            backlash_12 => -k12*clip12*touch12*over12;
            torques => T_generator/(2.0*h2*N2);
            damping => I2*alpha_M*theta2_dot/(2.0*h2*N2.powi(2)) - beta_K*k12_mid*damp12*over12_dot
                - I1*alpha_M*s2_dot/(4.0*h2.powi(2)*N1.powi(2)) - I2*alpha_M*s2_dot/(4.0*h2.powi(2)*N2.powi(2))
                - I_g*alpha_M*s2_dot/(4.0*h2.powi(2)*N2.powi(2)) - I1*alpha_M*theta2_dot/(2.0*h2*N1.powi(2))
                + I_g*alpha_M*theta2_dot/(2.0*h2*N2.powi(2)) - I_g*alpha_M*psi_h_dot/(2.0*h2*N2) + beta_K*k_i*twist_i_dot/(2.0*h2*N1);
        }
        psi_l {
            _ => -k_l*twist_l;
            torques => T_wind;
            damping => -I_b*alpha_M*psi_l_dot - I_b*alpha_M*theta_c_dot - I_b*alpha_M*theta_dot/Z_r - beta_K*k_l*twist_l_dot;
        }
        psi_h {
            _ => -k_h*twist_h;
            torques => T_generator;
            damping => I_g*alpha_M*theta2_dot/N2 - I_g*alpha_M*psi_h_dot - beta_K*k_h*twist_h_dot - I_g*alpha_M*s2_dot/(2.0*h2*N2);
        }
        u1 {
            _ => k_r1*delta_r1 - k_s1*delta_s1;
            damping => h*I_p*alpha_M*theta_dot/r_p.powi(2) + beta_K*k_r1_mid*delta_r1_dot - beta_K*k_s1_mid*delta_s1_dot
                - I_p*alpha_M*u1_dot/r_p.powi(2) - I_p*alpha_M*theta_c_dot/r_p - I_p*alpha_M*theta_dot/(r_p*Z_r);
        }
        u2 {
            _ => k_r2*delta_r2 - k_s2*delta_s2;
            damping => h*I_p*alpha_M*theta_dot/r_p.powi(2) + beta_K*k_r2_mid*delta_r2_dot - beta_K*k_s2_mid*delta_s2_dot
                - I_p*alpha_M*u2_dot/r_p.powi(2) - I_p*alpha_M*theta_c_dot/r_p - I_p*alpha_M*theta_dot/(r_p*Z_r);
        }
        u3 {
            _ => k_r3*delta_r3 - k_s3*delta_s3;
            damping => h*I_p*alpha_M*theta_dot/r_p.powi(2) + beta_K*k_r3_mid*delta_r3_dot - beta_K*k_s3_mid*delta_s3_dot
                - I_p*alpha_M*u3_dot/r_p.powi(2) - I_p*alpha_M*theta_c_dot/r_p - I_p*alpha_M*theta_dot/(r_p*Z_r);
        }
    }
    jacobian {
        theta theta {
            _ => -k_i/Z_r.powi(2) - 2.0*k_i/(Z_r*Z_s) - k_i/Z_s.powi(2);
            transmission_error_s1_and_jump_terms => k_s1*dde_s1*delta_s1 - k_s1*de_s1.powi(2) + 2.0*de_s1*dk_s1*delta_s1;
            transmission_error_r1_and_jump_terms => k_r1*dde_r1*delta_r1 - k_r1*de_r1.powi(2) + 2.0*de_r1*dk_r1*delta_r1;
            transmission_error_s2_and_jump_terms => k_s2*dde_s2*delta_s2 - k_s2*de_s2.powi(2) + 2.0*de_s2*dk_s2*delta_s2;
            transmission_error_r2_and_jump_terms => k_r2*dde_r2*delta_r2 - k_r2*de_r2.powi(2) + 2.0*de_r2*dk_r2*delta_r2;
            transmission_error_s3_and_jump_terms => k_s3*dde_s3*delta_s3 - k_s3*de_s3.powi(2) + 2.0*de_s3*dk_s3*delta_s3;
            transmission_error_r3_and_jump_terms => k_r3*dde_r3*delta_r3 - k_r3*de_r3.powi(2) + 2.0*de_r3*dk_r3*delta_r3;
            jump_terms => (-ddk_r1*delta_r1.powi(2) - ddk_r2*delta_r2.powi(2) - ddk_r3*delta_r3.powi(2) - ddk_s1*delta_s1.powi(2)
                - ddk_s2*delta_s2.powi(2) - ddk_s3*delta_s3.powi(2))/2.0;
        }
        theta theta_c {
            _ => -k_i/Z_r - k_i/Z_s;
            transmission_error_r1_and_jump_terms => -h*Z_r*k_r1*de_r1;
            transmission_error_r2_and_jump_terms => -h*Z_r*k_r2*de_r2;
            transmission_error_r3_and_jump_terms => -h*Z_r*k_r3*de_r3;
            jump_terms => h*Z_r*dk_r1*delta_r1 + h*Z_r*dk_r2*delta_r2 + h*Z_r*dk_r3*delta_r3;
        }
        theta theta2 { _ => k_i/(N1*Z_r) + k_i/(N1*Z_s); }
        theta s2 { _ => (k_i/(h2*N1*Z_r) + k_i/(h2*N1*Z_s))/2.0; }
        theta u1 {
            transmission_error_s1_and_jump_terms => k_s1*de_s1;
            transmission_error_r1_and_jump_terms => -k_r1*de_r1;
            jump_terms => dk_r1*delta_r1 - dk_s1*delta_s1;
        }
        theta u2 {
            transmission_error_s2_and_jump_terms => k_s2*de_s2;
            transmission_error_r2_and_jump_terms => -k_r2*de_r2;
            jump_terms => dk_r2*delta_r2 - dk_s2*delta_s2;
        }
        theta u3 {
            transmission_error_s3_and_jump_terms => k_s3*de_s3;
            transmission_error_r3_and_jump_terms => -k_r3*de_r3;
            jump_terms => dk_r3*delta_r3 - dk_s3*delta_s3;
        }
        theta theta_dot {
            damping => 6.0*h*I_p*alpha_M/(r_p*Z_r) - I_b*alpha_M/Z_r.powi(2) - I_c*alpha_M/Z_r.powi(2) - 3.0*I_p*alpha_M/Z_r.powi(2)
                - I_s*alpha_M/Z_r.powi(2) - 2.0*I_s*alpha_M/(Z_r*Z_s) - I_s*alpha_M/Z_s.powi(2) - 3.0*a.powi(2)*alpha_M*m_p/Z_r.powi(2)
                - 3.0*h.powi(2)*I_p*alpha_M/r_p.powi(2) - beta_K*k_i/Z_r.powi(2) - 2.0*beta_K*k_i/(Z_r*Z_s) - beta_K*k_i/Z_s.powi(2);
        }
        theta theta_c_dot {
            damping => 3.0*h*I_p*alpha_M/r_p - I_b*alpha_M/Z_r - I_c*alpha_M/Z_r - 3.0*I_p*alpha_M/Z_r - I_s*alpha_M/Z_r - I_s*alpha_M/Z_s
                - 3.0*a.powi(2)*alpha_M*m_p/Z_r - beta_K*k_i/Z_r - beta_K*k_i/Z_s;
        }
        theta theta2_dot { damping => beta_K*k_i/(N1*Z_r) + beta_K*k_i/(N1*Z_s); }
        theta s2_dot { damping => (beta_K*k_i/(h2*N1*Z_r) + beta_K*k_i/(h2*N1*Z_s))/2.0; }
        theta psi_l_dot { damping => -I_b*alpha_M/Z_r; }
        theta u1_dot { damping => h*I_p*alpha_M/r_p.powi(2) - I_p*alpha_M/(r_p*Z_r); }
        theta u2_dot { damping => h*I_p*alpha_M/r_p.powi(2) - I_p*alpha_M/(r_p*Z_r); }
        theta u3_dot { damping => h*I_p*alpha_M/r_p.powi(2) - I_p*alpha_M/(r_p*Z_r); }
        theta_c theta {
            _ => -k_i/Z_r - k_i/Z_s;
            transmission_error_r1_and_moving_phase => -h*Z_r*k_r1*de_r1;
            transmission_error_r2_and_moving_phase => -h*Z_r*k_r2*de_r2;
            transmission_error_r3_and_moving_phase => -h*Z_r*k_r3*de_r3;
            moving_phase => h*Z_r*dk_r1*delta_r1 + h*Z_r*dk_r2*delta_r2 + h*Z_r*dk_r3*delta_r3;
        }
        theta_c theta_c { _ => -k_i - h.powi(2)*Z_r.powi(2)*k_r1 - h.powi(2)*Z_r.powi(2)*k_r2 - h.powi(2)*Z_r.powi(2)*k_r3; }
        theta_c theta2 { _ => k_i/N1; }
        theta_c s2 { _ => k_i/(2.0*h2*N1); }
        theta_c u1 { _ => -h*Z_r*k_r1; }
        theta_c u2 { _ => -h*Z_r*k_r2; }
        theta_c u3 { _ => -h*Z_r*k_r3; }
        theta_c theta_dot {
            damping => 3.0*h*I_p*alpha_M/r_p - I_b*alpha_M/Z_r - I_c*alpha_M/Z_r - 3.0*I_p*alpha_M/Z_r - I_s*alpha_M/Z_r - I_s*alpha_M/Z_s
                - 3.0*a.powi(2)*alpha_M*m_p/Z_r - beta_K*k_i/Z_r - beta_K*k_i/Z_s;
        }
        theta_c theta_c_dot {
            damping => -I_b*alpha_M - I_c*alpha_M - 3.0*I_p*alpha_M - I_s*alpha_M - beta_K*k_i - 3.0*a.powi(2)*alpha_M*m_p
                - h.powi(2)*Z_r.powi(2)*beta_K*k_r1_mid - h.powi(2)*Z_r.powi(2)*beta_K*k_r2_mid - h.powi(2)*Z_r.powi(2)*beta_K*k_r3_mid;
        }
        theta_c theta2_dot { damping => beta_K*k_i/N1; }
        theta_c s2_dot { damping => beta_K*k_i/(2.0*h2*N1); }
        theta_c psi_l_dot { damping => -I_b*alpha_M; }
        theta_c u1_dot { damping => -h*Z_r*beta_K*k_r1_mid - I_p*alpha_M/r_p; }
        theta_c u2_dot { damping => -h*Z_r*beta_K*k_r2_mid - I_p*alpha_M/r_p; }
        theta_c u3_dot { damping => -h*Z_r*beta_K*k_r3_mid - I_p*alpha_M/r_p; }
        theta2 theta { _ => k_i/(N1*Z_r) + k_i/(N1*Z_s); }
        theta2 theta_c { _ => k_i/N1; }
        theta2 theta2 {
            _ => -k_i/N1.powi(2);
            transmission_error_12_and_jump_terms => k12*dde12*touch12*over12 - k12*de12.powi(2)*touch12 + 2.0*de12*dk12*touch12*over12;
            jump_terms => -ddk12*touch12*over12.powi(2)/2.0;
        }
        theta2 s2 {
            _ => -k_i/(2.0*h2*N1.powi(2));
            transmission_error_12_and_jump_terms => k12*de12*touch12;
            jump_terms => -dk12*touch12*over12;
        }
        theta2 theta_dot { damping => beta_K*k_i/(N1*Z_r) + beta_K*k_i/(N1*Z_s); }
        theta2 theta_c_dot { damping => beta_K*k_i/N1; }
        theta2 theta2_dot { damping => -I1*alpha_M/N1.powi(2) - I2*alpha_M/N2.powi(2) - I_g*alpha_M/N2.powi(2) - beta_K*k_i/N1.powi(2); }
        theta2 s2_dot {
            damping => (I2*alpha_M/(h2*N2.powi(2)) - I1*alpha_M/(h2*N1.powi(2)) + I_g*alpha_M/(h2*N2.powi(2))
                - beta_K*k_i/(h2*N1.powi(2)))/2.0;
        }
        theta2 psi_h_dot { damping => I_g*alpha_M/N2; }
        s2 theta { _ => (k_i/(h2*N1*Z_r) + k_i/(h2*N1*Z_s))/2.0; }
        s2 theta_c { _ => k_i/(2.0*h2*N1); }
        s2 theta2 {
            _ => -k_i/(2.0*h2*N1.powi(2));
            transmission_error_12_and_backlash_12_and_moving_phase => k12*de12*clip12*touch12;
            transmission_error_12_and_moving_phase => k12*de12*touch12;
            backlash_12_and_moving_phase => -dk12*clip12*touch12*over12;
            moving_phase => -dk12*touch12*over12;
        }
        s2 s2 {
            _ => -k12*touch12 - k_i/(4.0*h2.powi(2)*N1.powi(2));
            backlash_12 => -k12*clip12*touch12;
        }
        s2 theta_dot { damping => (beta_K*k_i/(h2*N1*Z_r) + beta_K*k_i/(h2*N1*Z_s))/2.0; }
        s2 theta_c_dot { damping => beta_K*k_i/(2.0*h2*N1); }
        s2 theta2_dot {
            damping => (I2*alpha_M/(h2*N2.powi(2)) - I1*alpha_M/(h2*N1.powi(2)) + I_g*alpha_M/(h2*N2.powi(2))
                - beta_K*k_i/(h2*N1.powi(2)))/2.0;
        }
        s2 s2_dot {
            damping => -beta_K*k12_mid*damp12 - I1*alpha_M/(4.0*h2.powi(2)*N1.powi(2)) - I2*alpha_M/(4.0*h2.powi(2)*N2.powi(2))
                - I_g*alpha_M/(4.0*h2.powi(2)*N2.powi(2)) - beta_K*k_i/(4.0*h2.powi(2)*N1.powi(2));
        }
        s2 psi_h_dot { damping => -I_g*alpha_M/(2.0*h2*N2); }
        psi_l psi_l { _ => -k_l; }
        psi_l theta_dot { damping => -I_b*alpha_M/Z_r; }
        psi_l theta_c_dot { damping => -I_b*alpha_M; }
        psi_l psi_l_dot { damping => -I_b*alpha_M - beta_K*k_l; }
        psi_h psi_h { _ => -k_h; }
        psi_h theta2_dot { damping => I_g*alpha_M/N2; }
        psi_h s2_dot { damping => -I_g*alpha_M/(2.0*h2*N2); }
        psi_h psi_h_dot { damping => -I_g*alpha_M - beta_K*k_h; }
        u1 theta {
            transmission_error_s1_and_moving_phase => k_s1*de_s1;
            transmission_error_r1_and_moving_phase => -k_r1*de_r1;
            moving_phase => dk_r1*delta_r1 - dk_s1*delta_s1;
        }
        u1 theta_c { _ => -h*Z_r*k_r1; }
        u1 u1 { _ => -k_r1 - k_s1; }
        u1 theta_dot { damping => h*I_p*alpha_M/r_p.powi(2) - I_p*alpha_M/(r_p*Z_r); }
        u1 theta_c_dot { damping => -h*Z_r*beta_K*k_r1_mid - I_p*alpha_M/r_p; }
        u1 u1_dot { damping => -beta_K*k_r1_mid - beta_K*k_s1_mid - I_p*alpha_M/r_p.powi(2); }
        u2 theta {
            transmission_error_s2_and_moving_phase => k_s2*de_s2;
            transmission_error_r2_and_moving_phase => -k_r2*de_r2;
            moving_phase => dk_r2*delta_r2 - dk_s2*delta_s2;
        }
        u2 theta_c { _ => -h*Z_r*k_r2; }
        u2 u2 { _ => -k_r2 - k_s2; }
        u2 theta_dot { damping => h*I_p*alpha_M/r_p.powi(2) - I_p*alpha_M/(r_p*Z_r); }
        u2 theta_c_dot { damping => -h*Z_r*beta_K*k_r2_mid - I_p*alpha_M/r_p; }
        u2 u2_dot { damping => -beta_K*k_r2_mid - beta_K*k_s2_mid - I_p*alpha_M/r_p.powi(2); }
        u3 theta {
            transmission_error_s3_and_moving_phase => k_s3*de_s3;
            transmission_error_r3_and_moving_phase => -k_r3*de_r3;
            moving_phase => dk_r3*delta_r3 - dk_s3*delta_s3;
        }
        u3 theta_c { _ => -h*Z_r*k_r3; }
        u3 u3 { _ => -k_r3 - k_s3; }
        u3 theta_dot { damping => h*I_p*alpha_M/r_p.powi(2) - I_p*alpha_M/(r_p*Z_r); }
        u3 theta_c_dot { damping => -h*Z_r*beta_K*k_r3_mid - I_p*alpha_M/r_p; }
        u3 u3_dot { damping => -beta_K*k_r3_mid - beta_K*k_s3_mid - I_p*alpha_M/r_p.powi(2); }
    }
    cell {
        stiffness {
            theta theta { _ => k_i/Z_r.powi(2) + 2.0*k_i/(Z_r*Z_s) + k_i/Z_s.powi(2); }
            theta theta_c { _ => k_i/Z_r + k_i/Z_s; }
            theta theta2 { _ => -k_i/(N1*Z_r) - k_i/(N1*Z_s); }
            theta s2 { _ => (-k_i/(h2*N1*Z_r) - k_i/(h2*N1*Z_s))/2.0; }
            theta_c theta_c { _ => k_i + h.powi(2)*Z_r.powi(2)*k_r1 + h.powi(2)*Z_r.powi(2)*k_r2 + h.powi(2)*Z_r.powi(2)*k_r3; }
            theta_c theta2 { _ => -k_i/N1; }
            theta_c s2 { _ => -k_i/(2.0*h2*N1); }
            theta_c u1 { _ => h*Z_r*k_r1; }
            theta_c u2 { _ => h*Z_r*k_r2; }
            theta_c u3 { _ => h*Z_r*k_r3; }
            theta2 theta2 { _ => k_i/N1.powi(2); }
            theta2 s2 { _ => k_i/(2.0*h2*N1.powi(2)); }
            s2 s2 {
                _ => k12*touch12 + k_i/(4.0*h2.powi(2)*N1.powi(2));
                backlash_12 => k12*clip12*touch12;
            }
            psi_l psi_l { _ => k_l; }
            psi_h psi_h { _ => k_h; }
            u1 u1 { _ => k_r1 + k_s1; }
            u2 u2 { _ => k_r2 + k_s2; }
            u3 u3 { _ => k_r3 + k_s3; }
        }
        damping {
            theta theta {
                damping => I_b*alpha_M/Z_r.powi(2) - 6.0*h*I_p*alpha_M/(r_p*Z_r) + I_c*alpha_M/Z_r.powi(2) + 3.0*I_p*alpha_M/Z_r.powi(2)
                    + I_s*alpha_M/Z_r.powi(2) + 2.0*I_s*alpha_M/(Z_r*Z_s) + I_s*alpha_M/Z_s.powi(2)
                    + 3.0*a.powi(2)*alpha_M*m_p/Z_r.powi(2) + 3.0*h.powi(2)*I_p*alpha_M/r_p.powi(2) + beta_K*k_i/Z_r.powi(2)
                    + 2.0*beta_K*k_i/(Z_r*Z_s) + beta_K*k_i/Z_s.powi(2);
            }
            theta theta_c {
                damping => I_b*alpha_M/Z_r - 3.0*h*I_p*alpha_M/r_p + I_c*alpha_M/Z_r + 3.0*I_p*alpha_M/Z_r + I_s*alpha_M/Z_r
                    + I_s*alpha_M/Z_s + 3.0*a.powi(2)*alpha_M*m_p/Z_r + beta_K*k_i/Z_r + beta_K*k_i/Z_s;
            }
            theta theta2 { damping => -beta_K*k_i/(N1*Z_r) - beta_K*k_i/(N1*Z_s); }
            theta s2 { damping => (-beta_K*k_i/(h2*N1*Z_r) - beta_K*k_i/(h2*N1*Z_s))/2.0; }
            theta psi_l { damping => I_b*alpha_M/Z_r; }
            theta u1 { damping => I_p*alpha_M/(r_p*Z_r) - h*I_p*alpha_M/r_p.powi(2); }
            theta u2 { damping => I_p*alpha_M/(r_p*Z_r) - h*I_p*alpha_M/r_p.powi(2); }
            theta u3 { damping => I_p*alpha_M/(r_p*Z_r) - h*I_p*alpha_M/r_p.powi(2); }
            theta_c theta_c {
                damping => I_b*alpha_M + I_c*alpha_M + 3.0*I_p*alpha_M + I_s*alpha_M + beta_K*k_i + 3.0*a.powi(2)*alpha_M*m_p
                    + h.powi(2)*Z_r.powi(2)*beta_K*k_r1_mid + h.powi(2)*Z_r.powi(2)*beta_K*k_r2_mid + h.powi(2)*Z_r.powi(2)*beta_K*k_r3_mid;
            }
            theta_c theta2 { damping => -beta_K*k_i/N1; }
            theta_c s2 { damping => -beta_K*k_i/(2.0*h2*N1); }
            theta_c psi_l { damping => I_b*alpha_M; }
            theta_c u1 { damping => h*Z_r*beta_K*k_r1_mid + I_p*alpha_M/r_p; }
            theta_c u2 { damping => h*Z_r*beta_K*k_r2_mid + I_p*alpha_M/r_p; }
            theta_c u3 { damping => h*Z_r*beta_K*k_r3_mid + I_p*alpha_M/r_p; }
            theta2 theta2 { damping => I1*alpha_M/N1.powi(2) + I2*alpha_M/N2.powi(2) + I_g*alpha_M/N2.powi(2) + beta_K*k_i/N1.powi(2); }
            theta2 s2 {
                damping => (I1*alpha_M/(h2*N1.powi(2)) - I2*alpha_M/(h2*N2.powi(2)) - I_g*alpha_M/(h2*N2.powi(2))
                    + beta_K*k_i/(h2*N1.powi(2)))/2.0;
            }
            theta2 psi_h { damping => -I_g*alpha_M/N2; }
            s2 s2 {
                damping => beta_K*k12_mid*damp12 + I1*alpha_M/(4.0*h2.powi(2)*N1.powi(2)) + I2*alpha_M/(4.0*h2.powi(2)*N2.powi(2))
                    + I_g*alpha_M/(4.0*h2.powi(2)*N2.powi(2)) + beta_K*k_i/(4.0*h2.powi(2)*N1.powi(2));
            }
            s2 psi_h { damping => I_g*alpha_M/(2.0*h2*N2); }
            psi_l psi_l { damping => I_b*alpha_M + beta_K*k_l; }
            psi_h psi_h { damping => I_g*alpha_M + beta_K*k_h; }
            u1 u1 { damping => beta_K*k_r1_mid + beta_K*k_s1_mid + I_p*alpha_M/r_p.powi(2); }
            u2 u2 { damping => beta_K*k_r2_mid + beta_K*k_s2_mid + I_p*alpha_M/r_p.powi(2); }
            u3 u3 { damping => beta_K*k_r3_mid + beta_K*k_s3_mid + I_p*alpha_M/r_p.powi(2); }
        }
        load {
            theta { torques => T_wind/Z_r; }
            theta_c {
                _ => -h*Z_r*k_r1*e_r1 - h*Z_r*k_r2*e_r2 - h*Z_r*k_r3*e_r3;
                torques => T_wind;
            }
            theta2 { torques => -T_generator/N2; }
            s2 {
                _ => k12*touch12*edge12 + k12*touch12*e12;
                backlash_12 => k12*clip12*touch12*edge12 + k12*clip12*touch12*e12;
                torques => T_generator/(2.0*h2*N2);
            }
            psi_l { torques => T_wind; }
            psi_h { torques => T_generator; }
            u1 { _ => k_s1*e_s1 - k_r1*e_r1; }
            u2 { _ => k_s2*e_s2 - k_r2*e_r2; }
            u3 { _ => k_s3*e_s3 - k_r3*e_r3; }
        }
    }
    jump k_s1 { step { _ => dk_s1*delta_s1.powi(2)/2.0; } }
    jump k_r1 { step { _ => dk_r1*delta_r1.powi(2)/2.0; } }
    jump k_s2 { step { _ => dk_s2*delta_s2.powi(2)/2.0; } }
    jump k_r2 { step { _ => dk_r2*delta_r2.powi(2)/2.0; } }
    jump k_s3 { step { _ => dk_s3*delta_s3.powi(2)/2.0; } }
    jump k_r3 { step { _ => dk_r3*delta_r3.powi(2)/2.0; } }
    jump k12 { step { _ => dk12*touch12*over12.powi(2)/2.0; } }
    jump e_s1 { step { _ => k_s1*de_s1.powi(2)/2.0 - k_s1*de_s1*delta_s1; } }
    jump e_r1 { step { _ => k_r1*de_r1.powi(2)/2.0 - k_r1*de_r1*delta_r1; } }
    jump e_s2 { step { _ => k_s2*de_s2.powi(2)/2.0 - k_s2*de_s2*delta_s2; } }
    jump e_r2 { step { _ => k_r2*de_r2.powi(2)/2.0 - k_r2*de_r2*delta_r2; } }
    jump e_s3 { step { _ => k_s3*de_s3.powi(2)/2.0 - k_s3*de_s3*delta_s3; } }
    jump e_r3 { step { _ => k_r3*de_r3.powi(2)/2.0 - k_r3*de_r3*delta_r3; } }
    jump e12 { step { _ => k12*de12.powi(2)*touch12/2.0 - k12*de12*touch12*over12; } }
    outputs {
        rotor_speed_b "rad/s", "rotational speed of the rotor with its blades" { _ => psi_l_dot + theta_c_dot + theta_dot/Z_r; }
        rotor_speed_c "rad/s", "rotational speed of the carrier without planets" { _ => theta_c_dot + theta_dot/Z_r; }
        rotor_speed_s "rad/s", "rotational speed of the sun" { _ => theta_c_dot + theta_dot*(1.0/Z_r + 1.0/Z_s); }
        rotor_speed_1 "rad/s", "rotational speed of the wheel of the parallel stage" { _ => s2_dot/(2.0*h2*N1) + theta2_dot/N1; }
        rotor_speed_2 "rad/s", "rotational speed of the pinion of the parallel stage" { _ => theta2_dot/N2 - s2_dot/(2.0*h2*N2); }
        rotor_speed_g "rad/s", "rotational speed of the generator" { _ => theta2_dot/N2 - psi_h_dot - s2_dot/(2.0*h2*N2); }
        shaft_twist_l "rad", "twist of the low-speed shaft" { _ => twist_l; }
        shaft_torque_l "N*m", "torque in the low-speed shaft, damper included" {
            _ => k_l*twist_l;
            damping => beta_K*k_l*twist_l_dot;
        }
        shaft_power_l "W", "power that enters the low-speed shaft at its first end: torque times the speed of that end" {
            _ => shaft_torque_l*(psi_l_dot + theta_c_dot + theta_dot/Z_r);
        }
        shaft_loss_l "W", "power that the damper of the low-speed shaft takes" { damping => beta_K*k_l*twist_l_dot.powi(2); }
        shaft_twist_i "rad", "twist of the intermediate shaft" { _ => twist_i; }
        shaft_torque_i "N*m", "torque in the intermediate shaft, damper included" {
            _ => k_i*twist_i;
            damping => beta_K*k_i*twist_i_dot;
        }
        shaft_power_i "W", "power that enters the intermediate shaft at its first end: torque times the speed of that end" {
            _ => shaft_torque_i*(theta_c_dot + theta_dot*(1.0/Z_r + 1.0/Z_s));
        }
        shaft_loss_i "W", "power that the damper of the intermediate shaft takes" { damping => beta_K*k_i*twist_i_dot.powi(2); }
        shaft_twist_h "rad", "twist of the high-speed shaft" { _ => twist_h; }
        shaft_torque_h "N*m", "torque in the high-speed shaft, damper included" {
            _ => k_h*twist_h;
            damping => beta_K*k_h*twist_h_dot;
        }
        shaft_power_h "W", "power that enters the high-speed shaft at its first end: torque times the speed of that end" {
            _ => shaft_torque_h*(theta2_dot/N2 - s2_dot/(2.0*h2*N2));
        }
        shaft_loss_h "W", "power that the damper of the high-speed shaft takes" { damping => beta_K*k_h*twist_h_dot.powi(2); }
        mesh_force_s1 "N",
            "force of the mesh of sun and planet 1 along the line of action, damper included: positive if it presses the drive flanks" {
            _ => k_s1*delta_s1;
            damping => beta_K*k_s1_mid*delta_s1_dot;
        }
        mesh_power_s1 "W", "power that the first gear gives to the mesh of sun and planet 1: force times the speed of its flank" {
            _ => mesh_force_s1*(h*Z_s*theta_c_dot + h*Z_s*theta_dot*(1.0/Z_r + 1.0/Z_s));
        }
        mesh_deflection_s1 "m", "deflection of the mesh of sun and planet 1 along the line of action, backlash not taken off" {
            _ => u1 - e_s1 + h*Z_s*(theta_c + theta/Z_r + theta/Z_s) - h*theta - h*(Z_r + Z_s)*(theta_c + theta/Z_r)/2.0
                + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0;
        }
        dte_s1 "m",
            "dynamic transmission error of the mesh of sun and planet 1 along the line of action: positive if the driving gear is ahead" {
            _ => u1 + h*Z_s*(theta_c + theta/Z_r + theta/Z_s) - h*theta - h*(Z_r + Z_s)*(theta_c + theta/Z_r)/2.0
                + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0;
        }
        mesh_loss_s1 "W", "power that the damper of the mesh of sun and planet 1 takes" { damping => beta_K*k_s1_mid*delta_s1_dot.powi(2); }
        mesh_force_r1 "N",
            "force of the mesh of ring and planet 1 along the line of action, damper included: positive if it presses the drive flanks" {
            _ => k_r1*delta_r1;
            damping => beta_K*k_r1_mid*delta_r1_dot;
        }
        mesh_power_r1 "W", "power that the first gear gives to the mesh of ring and planet 1: force times the speed of its flank" {}
        mesh_deflection_r1 "m", "deflection of the mesh of ring and planet 1 along the line of action, backlash not taken off" {
            _ => -e_r1 - (u1 - h*theta + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0) - h*(Z_r + Z_s)*(theta_c + theta/Z_r)/2.0;
        }
        dte_r1 "m",
            "dynamic transmission error of the mesh of ring and planet 1 along the line of action: positive if the driving gear is ahead" {
            _ => -(u1 - h*theta + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0) - h*(Z_r + Z_s)*(theta_c + theta/Z_r)/2.0;
        }
        mesh_loss_r1 "W", "power that the damper of the mesh of ring and planet 1 takes" {
            damping => beta_K*k_r1_mid*delta_r1_dot.powi(2);
        }
        mesh_force_s2 "N",
            "force of the mesh of sun and planet 2 along the line of action, damper included: positive if it presses the drive flanks" {
            _ => k_s2*delta_s2;
            damping => beta_K*k_s2_mid*delta_s2_dot;
        }
        mesh_power_s2 "W", "power that the first gear gives to the mesh of sun and planet 2: force times the speed of its flank" {
            _ => mesh_force_s2*(h*Z_s*theta_c_dot + h*Z_s*theta_dot*(1.0/Z_r + 1.0/Z_s));
        }
        mesh_deflection_s2 "m", "deflection of the mesh of sun and planet 2 along the line of action, backlash not taken off" {
            _ => u2 - e_s2 + h*Z_s*(theta_c + theta/Z_r + theta/Z_s) - h*theta - h*(Z_r + Z_s)*(theta_c + theta/Z_r)/2.0
                + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0;
        }
        dte_s2 "m",
            "dynamic transmission error of the mesh of sun and planet 2 along the line of action: positive if the driving gear is ahead" {
            _ => u2 + h*Z_s*(theta_c + theta/Z_r + theta/Z_s) - h*theta - h*(Z_r + Z_s)*(theta_c + theta/Z_r)/2.0
                + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0;
        }
        mesh_loss_s2 "W", "power that the damper of the mesh of sun and planet 2 takes" { damping => beta_K*k_s2_mid*delta_s2_dot.powi(2); }
        mesh_force_r2 "N",
            "force of the mesh of ring and planet 2 along the line of action, damper included: positive if it presses the drive flanks" {
            _ => k_r2*delta_r2;
            damping => beta_K*k_r2_mid*delta_r2_dot;
        }
        mesh_power_r2 "W", "power that the first gear gives to the mesh of ring and planet 2: force times the speed of its flank" {}
        mesh_deflection_r2 "m", "deflection of the mesh of ring and planet 2 along the line of action, backlash not taken off" {
            _ => -e_r2 - (u2 - h*theta + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0) - h*(Z_r + Z_s)*(theta_c + theta/Z_r)/2.0;
        }
        dte_r2 "m",
            "dynamic transmission error of the mesh of ring and planet 2 along the line of action: positive if the driving gear is ahead" {
            _ => -(u2 - h*theta + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0) - h*(Z_r + Z_s)*(theta_c + theta/Z_r)/2.0;
        }
        mesh_loss_r2 "W", "power that the damper of the mesh of ring and planet 2 takes" {
            damping => beta_K*k_r2_mid*delta_r2_dot.powi(2);
        }
        mesh_force_s3 "N",
            "force of the mesh of sun and planet 3 along the line of action, damper included: positive if it presses the drive flanks" {
            _ => k_s3*delta_s3;
            damping => beta_K*k_s3_mid*delta_s3_dot;
        }
        mesh_power_s3 "W", "power that the first gear gives to the mesh of sun and planet 3: force times the speed of its flank" {
            _ => mesh_force_s3*(h*Z_s*theta_c_dot + h*Z_s*theta_dot*(1.0/Z_r + 1.0/Z_s));
        }
        mesh_deflection_s3 "m", "deflection of the mesh of sun and planet 3 along the line of action, backlash not taken off" {
            _ => u3 - e_s3 + h*Z_s*(theta_c + theta/Z_r + theta/Z_s) - h*theta - h*(Z_r + Z_s)*(theta_c + theta/Z_r)/2.0
                + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0;
        }
        dte_s3 "m",
            "dynamic transmission error of the mesh of sun and planet 3 along the line of action: positive if the driving gear is ahead" {
            _ => u3 + h*Z_s*(theta_c + theta/Z_r + theta/Z_s) - h*theta - h*(Z_r + Z_s)*(theta_c + theta/Z_r)/2.0
                + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0;
        }
        mesh_loss_s3 "W", "power that the damper of the mesh of sun and planet 3 takes" { damping => beta_K*k_s3_mid*delta_s3_dot.powi(2); }
        mesh_force_r3 "N",
            "force of the mesh of ring and planet 3 along the line of action, damper included: positive if it presses the drive flanks" {
            _ => k_r3*delta_r3;
            damping => beta_K*k_r3_mid*delta_r3_dot;
        }
        mesh_power_r3 "W", "power that the first gear gives to the mesh of ring and planet 3: force times the speed of its flank" {}
        mesh_deflection_r3 "m", "deflection of the mesh of ring and planet 3 along the line of action, backlash not taken off" {
            _ => -e_r3 - (u3 - h*theta + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0) - h*(Z_r + Z_s)*(theta_c + theta/Z_r)/2.0;
        }
        dte_r3 "m",
            "dynamic transmission error of the mesh of ring and planet 3 along the line of action: positive if the driving gear is ahead" {
            _ => -(u3 - h*theta + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0) - h*(Z_r + Z_s)*(theta_c + theta/Z_r)/2.0;
        }
        mesh_loss_r3 "W", "power that the damper of the mesh of ring and planet 3 takes" {
            damping => beta_K*k_r3_mid*delta_r3_dot.powi(2);
        }
        contact_loss_12 "1" with backlash_12,
            "1 while no force passes the mesh of the parallel stage, else 0: its mean is the share of time without contact" {
            _ => 1.0 - touch12*(1.0 + clip12*(1.0 - clip12)/2.0);
        }
        mesh_force_12 "N",
            "force of the mesh of the parallel stage along the line of action, damper included: positive if it presses the drive flanks" {
            _ => k12*touch12*over12;
            backlash_12 => k12*clip12*touch12*over12;
            damping => beta_K*k12_mid*damp12*over12_dot;
        }
        mesh_power_12 "W", "power that the first gear gives to the mesh of the parallel stage: force times the speed of its flank" {
            _ => mesh_force_12*(s2_dot/2.0 + h2*theta2_dot);
        }
        mesh_deflection_12 "m", "deflection of the mesh of the parallel stage along the line of action, backlash not taken off" {
            _ => s2 - e12;
        }
        dte_12 "m",
            "dynamic transmission error of the mesh of the parallel stage along the line of action: positive if the driving gear is ahead" {
            _ => s2;
        }
        mesh_loss_12 "W", "power that the damper of the mesh of the parallel stage takes" {
            backlash_12 => k12*clip12*touch12*over12*over12_dot;
            damping => beta_K*k12_mid*damp12*over12_dot.powi(2);
        }
        power_wind "W" with torques, "power of the driving torque of the rotor: positive if it drives" { _ => wind_power; }
        power_generator "W" with torques, "power of the load torque of the generator, against its rotation: positive if it drives" {
            _ => generator_power;
        }
        inertia_damping_loss "W" with damping, "power that the damping in proportion to inertia takes" {
            _ => 2.0*alpha_M*(I1*(s2_dot/(2.0*h2*N1) + theta2_dot/N1).powi(2)/2.0 + I2*(theta2_dot/N2 - s2_dot/(2.0*h2*N2)).powi(2)/2.0
                + I_b*(psi_l_dot + theta_c_dot + theta_dot/Z_r).powi(2)/2.0 + I_c*(theta_c_dot + theta_dot/Z_r).powi(2)/2.0
                + I_g*(theta2_dot/N2 - psi_h_dot - s2_dot/(2.0*h2*N2)).powi(2)/2.0
                + I_p*(theta_c_dot + (u1_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)/2.0
                + I_p*(theta_c_dot + (u2_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)/2.0
                + I_p*(theta_c_dot + (u3_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)/2.0
                + I_s*(theta_c_dot + theta_dot*(1.0/Z_r + 1.0/Z_s)).powi(2)/2.0
                + 3.0*a.powi(2)*m_p*(theta_c_dot + theta_dot/Z_r).powi(2)/2.0);
        }
    }

    text "text/wind_turbine.txt";
    latex "latex/wind_turbine.tex";
}

// Proved of these equations, symbolically:
//
// - d/dt (q'.dT/dq' - T + V) = Q.q' - q'.dD/dq' along the motion, for every value and slope of every law, with any set of the additive
//   effects; q'.dD/dq' includes the power that switches take
// - M is symmetric
// - T = q'.M q'/2, with M as written
// - M is positive definite: T is a sum of squares that vanish together only at rest
// - at a step of k_s1, k_r1, k_s2, k_r2, k_s3, k_r3, k12, e_s1, e_r1, e_s2, e_r2, e_s3, e_r3, e12: T+ - T- = (v+² - v²)/(2 G) for any v+,
//   where M d = n/G; V+ - V- = dV as written; so T + V is unchanged in transmission (v+² = v² - 2 G dV) and in reflection (v+ = -v, dV = 0)
// - V is the same on both sides of the exits of over12: no impulse there
// - the force of the switch over12 takes energy or none: f over12_dot >= 0 in every mode, from the guards that hold in it; of a damper that
//   is clipped to f = c F, where F = dV/dover12 and c = 1 or -1, since F over12 >= 0, over12_dot dD/dover12_dot >= 0 and c over12
//   dD/dover12_dot >= F over12
// - every damper takes energy or none: each term of D has a power q'.dD/dq' that is never negative
// - every deflection equals the linear form by which the equations differentiate it
// - without the jump terms the balance fails: energy is created at the rate dk12*touch12*over12^2*theta2_dot/2 -
//   k12*de12*touch12*over12*theta2_dot - k_r1*de_r1*delta_r1*theta_dot - k_r2*de_r2*delta_r2*theta_dot - k_r3*de_r3*delta_r3*theta_dot -
//   k_s1*de_s1*delta_s1*theta_dot - k_s2*de_s2*delta_s2*theta_dot - k_s3*de_s3*delta_s3*theta_dot + dk_r1*delta_r1^2*theta_dot/2 +
//   dk_r2*delta_r2^2*theta_dot/2 + dk_r3*delta_r3^2*theta_dot/2 + dk_s1*delta_s1^2*theta_dot/2 + dk_s2*delta_s2^2*theta_dot/2 +
//   dk_s3*delta_s3^2*theta_dot/2
//
// Operations, all effects present:
//
// | output | sums | products, quotients | functions, roots |
// | --- | --- | --- | --- |
// | constants (once a scene) | 2 | 12 | 2 |
// | force | 92 | 419 | 0 |
// | energy steps, all laws | 7 | 59 | 0 |
