//! Equations of motion of `planetary_4`: a planetary stage with 4 planets, torsional.
//!
//! Derived from the energies in `models/src/planetary.rs` by `cargo xtask derive planetary_4`.
//! Do not edit: change the energies and derive again.
//! For reading: `text/planetary_4.txt`, `latex/planetary_4.tex`. What is proved: at the end.

use gearsim::equations;

equations! {
    model planetary_4 "a planetary stage with 4 planets, torsional";
    source "Lin & Parker (1999), J. Vib. Acoust. 121(3), with centres held; phase on the sun";

    coordinates {
        theta "rad" start 0.0, "phase of the meshes, Z_s (theta_s - theta_c)";
        theta_c "rad" start static, "rotation of the carrier in excess of rigid rolling";
        theta_r "rad" start static, "rotation of the ring";
        u1 "m" start static, "rotation of planet 1 in excess of rigid rolling, times its base radius";
        u2 "m" start static, "rotation of planet 2 in excess of rigid rolling, times its base radius";
        u3 "m" start static, "rotation of planet 3 in excess of rigid rolling, times its base radius";
        u4 "m" start static, "rotation of planet 4 in excess of rigid rolling, times its base radius";
    }
    parameters {
        Z_s "1" required, open 0.0 to inf, "number of teeth of the sun";
        Z_r "1" required, open 0.0 to inf, "number of teeth of the ring";
        r_s "m" required, open 0.0 to inf, "base radius of the sun";
        alpha "rad" default 0.3490658503988659, open 0.0 to inf, "pressure angle";
        I_s "kg*m^2" required, open 0.0 to inf, "moment of inertia of the sun";
        I_c "kg*m^2" required, open 0.0 to inf, "moment of inertia of the carrier without planets";
        I_r "kg*m^2" required, open 0.0 to inf, "moment of inertia of the ring";
        k_r "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the ring's torsional support";
        k_s "N*m/rad" required with torsional_support_s, from 0.0 to inf, "torsional stiffness of the sun's torsional support";
        k_c "N*m/rad" required with torsional_support_c, from 0.0 to inf, "torsional stiffness of the carrier's torsional support";
        m_p "kg" required, open 0.0 to inf, "mass of a planet";
        I_p "kg*m^2" required, open 0.0 to inf, "moment of inertia of a planet";
        T_motor "N*m" required with torques, open -inf to inf, "driving torque of the sun";
        T_load "N*m" required with torques, open -inf to inf, "load torque of the carrier, against its rotation";
        alpha_M "1/s" default 0.0, from 0.0 to inf, "damping in proportion to inertia";
        beta_K "s" default 0.0, from 0.0 to inf, "damping in proportion to stiffness";
    }
    laws {
        k_s1 "N/m" phase theta period 6.283185307179586 rolling unless(torsional_support),
            "stiffness of the mesh of sun and planet 1 along the line of action";
        k_r1 "N/m" phase theta period 6.283185307179586 rolling unless(torsional_support),
            "stiffness of the mesh of ring and planet 1 along the line of action";
        k_s2 "N/m" phase theta period 6.283185307179586 rolling unless(torsional_support),
            "stiffness of the mesh of sun and planet 2 along the line of action";
        k_r2 "N/m" phase theta period 6.283185307179586 rolling unless(torsional_support),
            "stiffness of the mesh of ring and planet 2 along the line of action";
        k_s3 "N/m" phase theta period 6.283185307179586 rolling unless(torsional_support),
            "stiffness of the mesh of sun and planet 3 along the line of action";
        k_r3 "N/m" phase theta period 6.283185307179586 rolling unless(torsional_support),
            "stiffness of the mesh of ring and planet 3 along the line of action";
        k_s4 "N/m" phase theta period 6.283185307179586 rolling unless(torsional_support),
            "stiffness of the mesh of sun and planet 4 along the line of action";
        k_r4 "N/m" phase theta period 6.283185307179586 rolling unless(torsional_support),
            "stiffness of the mesh of ring and planet 4 along the line of action";
        e_s1 "m" phase theta period 6.283185307179586 rolling unless(torsional_support) with transmission_error_s1,
            "transmission error of the mesh of sun and planet 1 along the line of action";
        e_r1 "m" phase theta period 6.283185307179586 rolling unless(torsional_support) with transmission_error_r1,
            "transmission error of the mesh of ring and planet 1 along the line of action";
        e_s2 "m" phase theta period 6.283185307179586 rolling unless(torsional_support) with transmission_error_s2,
            "transmission error of the mesh of sun and planet 2 along the line of action";
        e_r2 "m" phase theta period 6.283185307179586 rolling unless(torsional_support) with transmission_error_r2,
            "transmission error of the mesh of ring and planet 2 along the line of action";
        e_s3 "m" phase theta period 6.283185307179586 rolling unless(torsional_support) with transmission_error_s3,
            "transmission error of the mesh of sun and planet 3 along the line of action";
        e_r3 "m" phase theta period 6.283185307179586 rolling unless(torsional_support) with transmission_error_r3,
            "transmission error of the mesh of ring and planet 3 along the line of action";
        e_s4 "m" phase theta period 6.283185307179586 rolling unless(torsional_support) with transmission_error_s4,
            "transmission error of the mesh of sun and planet 4 along the line of action";
        e_r4 "m" phase theta period 6.283185307179586 rolling unless(torsional_support) with transmission_error_r4,
            "transmission error of the mesh of ring and planet 4 along the line of action";
    }
    motions { speed "rad/s" { theta_dot = Z_r*Z_s/(Z_r + Z_s); }, "rotational speed of the sun, ring at rest"; }
    effects {
        torsional_support_s of torsional_support "a torsional spring to the ground: it holds what else turns";
        torsional_support_c of torsional_support "a torsional spring to the ground: it holds what else turns";
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
        transmission_error_s4 of transmission_error requires(stiffness_step)
            "flanks deviate from their ideal position: V = k (delta - e)^2/2, with the jump terms of e where it steps";
        transmission_error_r4 of transmission_error requires(stiffness_step)
            "flanks deviate from their ideal position: V = k (delta - e)^2/2, with the jump terms of e where it steps";
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
        torsional_support_s_and_damping = torsional_support_s, damping;
        torsional_support_c_and_damping = torsional_support_c, damping;
        transmission_error_s1_and_jump_terms = transmission_error_s1, stiffness_step, !rigid_kinematics, !frozen_phase;
        transmission_error_r1_and_jump_terms = transmission_error_r1, stiffness_step, !rigid_kinematics, !frozen_phase;
        transmission_error_s2_and_jump_terms = transmission_error_s2, stiffness_step, !rigid_kinematics, !frozen_phase;
        transmission_error_r2_and_jump_terms = transmission_error_r2, stiffness_step, !rigid_kinematics, !frozen_phase;
        transmission_error_s3_and_jump_terms = transmission_error_s3, stiffness_step, !rigid_kinematics, !frozen_phase;
        transmission_error_r3_and_jump_terms = transmission_error_r3, stiffness_step, !rigid_kinematics, !frozen_phase;
        transmission_error_s4_and_jump_terms = transmission_error_s4, stiffness_step, !rigid_kinematics, !frozen_phase;
        transmission_error_r4_and_jump_terms = transmission_error_r4, stiffness_step, !rigid_kinematics, !frozen_phase;
        transmission_error_r1_and_moving_phase = transmission_error_r1, stiffness_step, !frozen_phase;
        transmission_error_r2_and_moving_phase = transmission_error_r2, stiffness_step, !frozen_phase;
        transmission_error_r3_and_moving_phase = transmission_error_r3, stiffness_step, !frozen_phase;
        transmission_error_r4_and_moving_phase = transmission_error_r4, stiffness_step, !frozen_phase;
        transmission_error_s1_and_moving_phase = transmission_error_s1, stiffness_step, !frozen_phase;
        transmission_error_s2_and_moving_phase = transmission_error_s2, stiffness_step, !frozen_phase;
        transmission_error_s3_and_moving_phase = transmission_error_s3, stiffness_step, !frozen_phase;
        transmission_error_s4_and_moving_phase = transmission_error_s4, stiffness_step, !frozen_phase;
    }

    constants {
        cos_a = alpha.cos();
        sin_a = alpha.sin();
        h = r_s/Z_s;
        r_p = (h*Z_r - h*Z_s)/2.0;
        a = (h*Z_r/cos_a + h*Z_s/cos_a)/2.0;
    }
    deflections {
        twist_r = theta_r;
        twist_s = theta_c + theta/Z_r + theta/Z_s;
        twist_c = theta_c + theta/Z_r;
        delta_s1 = u1 - e_s1;
        delta_r1 = h*Z_r*theta_r - u1 - e_r1 - h*Z_r*theta_c;
        delta_s2 = u2 - e_s2;
        delta_r2 = h*Z_r*theta_r - u2 - e_r2 - h*Z_r*theta_c;
        delta_s3 = u3 - e_s3;
        delta_r3 = h*Z_r*theta_r - u3 - e_r3 - h*Z_r*theta_c;
        delta_s4 = u4 - e_s4;
        delta_r4 = h*Z_r*theta_r - u4 - e_r4 - h*Z_r*theta_c;
    }
    energies {
        kinetic {
            _ => I_c*(theta_c_dot + theta_dot/Z_r).powi(2)/2.0
                + I_p*(theta_c_dot + (u1_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)/2.0
                + I_p*(theta_c_dot + (u2_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)/2.0
                + I_p*(theta_c_dot + (u3_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)/2.0
                + I_p*(theta_c_dot + (u4_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)/2.0 + I_r*theta_r_dot.powi(2)/2.0
                + I_s*(theta_c_dot + theta_dot*(1.0/Z_r + 1.0/Z_s)).powi(2)/2.0 + 2.0*a.powi(2)*m_p*(theta_c_dot + theta_dot/Z_r).powi(2);
        }
        potential {
            _ => (k_r*twist_r.powi(2) + k_r1*delta_r1.powi(2) + k_r2*delta_r2.powi(2) + k_r3*delta_r3.powi(2) + k_r4*delta_r4.powi(2)
                + k_s1*delta_s1.powi(2) + k_s2*delta_s2.powi(2) + k_s3*delta_s3.powi(2) + k_s4*delta_s4.powi(2))/2.0;
            torsional_support_s => k_s*twist_s.powi(2)/2.0;
            torsional_support_c => k_c*twist_c.powi(2)/2.0;
        }
        dissipation {
            torsional_support_s_and_damping => beta_K*k_s*twist_s_dot.powi(2)/2.0;
            torsional_support_c_and_damping => beta_K*k_c*twist_c_dot.powi(2)/2.0;
            damping => I_c*alpha_M*(theta_c_dot + theta_dot/Z_r).powi(2)/2.0
                + I_p*alpha_M*(theta_c_dot + (u1_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)/2.0
                + I_p*alpha_M*(theta_c_dot + (u2_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)/2.0
                + I_p*alpha_M*(theta_c_dot + (u3_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)/2.0
                + I_p*alpha_M*(theta_c_dot + (u4_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)/2.0 + I_r*alpha_M*theta_r_dot.powi(2)/2.0
                + I_s*alpha_M*(theta_c_dot + theta_dot*(1.0/Z_r + 1.0/Z_s)).powi(2)/2.0 + beta_K*k_r*twist_r_dot.powi(2)/2.0
                + beta_K*k_r1_mid*delta_r1_dot.powi(2)/2.0 + beta_K*k_r2_mid*delta_r2_dot.powi(2)/2.0
                + beta_K*k_r3_mid*delta_r3_dot.powi(2)/2.0 + beta_K*k_r4_mid*delta_r4_dot.powi(2)/2.0
                + beta_K*k_s1_mid*delta_s1_dot.powi(2)/2.0 + beta_K*k_s2_mid*delta_s2_dot.powi(2)/2.0
                + beta_K*k_s3_mid*delta_s3_dot.powi(2)/2.0 + beta_K*k_s4_mid*delta_s4_dot.powi(2)/2.0
                + 2.0*a.powi(2)*alpha_M*m_p*(theta_c_dot + theta_dot/Z_r).powi(2);
        }
    }
    torques {
        motor "driving torque of the sun" { torques => T_motor*(theta_c + theta*(1.0/Z_r + 1.0/Z_s)); }
        load "load torque of the carrier, against its rotation" { torques => T_load*(-theta_c - theta/Z_r); }
    }
    work {
        theta { torques => T_motor/Z_r - T_load/Z_r + T_motor/Z_s; }
        theta_c { torques => T_motor - T_load; }
    }
    mass {
        theta theta {
            _ => I_c/Z_r.powi(2) - 8.0*h*I_p/(r_p*Z_r) + 4.0*I_p/Z_r.powi(2) + I_s/Z_r.powi(2) + 2.0*I_s/(Z_r*Z_s) + I_s/Z_s.powi(2)
                + 4.0*a.powi(2)*m_p/Z_r.powi(2) + 4.0*h.powi(2)*I_p/r_p.powi(2);
        }
        theta theta_c { _ => I_c/Z_r - 4.0*h*I_p/r_p + 4.0*I_p/Z_r + I_s/Z_r + I_s/Z_s + 4.0*a.powi(2)*m_p/Z_r; }
        theta u1 { _ => I_p/(r_p*Z_r) - h*I_p/r_p.powi(2); }
        theta u2 { _ => I_p/(r_p*Z_r) - h*I_p/r_p.powi(2); }
        theta u3 { _ => I_p/(r_p*Z_r) - h*I_p/r_p.powi(2); }
        theta u4 { _ => I_p/(r_p*Z_r) - h*I_p/r_p.powi(2); }
        theta_c theta_c { _ => I_c + 4.0*I_p + I_s + 4.0*a.powi(2)*m_p; }
        theta_c u1 { _ => I_p/r_p; }
        theta_c u2 { _ => I_p/r_p; }
        theta_c u3 { _ => I_p/r_p; }
        theta_c u4 { _ => I_p/r_p; }
        theta_r theta_r { _ => I_r; }
        u1 u1 { _ => I_p/r_p.powi(2); }
        u2 u2 { _ => I_p/r_p.powi(2); }
        u3 u3 { _ => I_p/r_p.powi(2); }
        u4 u4 { _ => I_p/r_p.powi(2); }
    }
    force {
        theta {
            torsional_support_s => -k_s*twist_s/Z_r - k_s*twist_s/Z_s;
            torsional_support_s_and_damping => -beta_K*k_s*twist_s_dot/Z_r - beta_K*k_s*twist_s_dot/Z_s;
            torsional_support_c => -k_c*twist_c/Z_r;
            torsional_support_c_and_damping => -beta_K*k_c*twist_c_dot/Z_r;
            transmission_error_s1_and_jump_terms => k_s1*de_s1*delta_s1;
            transmission_error_r1_and_jump_terms => k_r1*de_r1*delta_r1;
            transmission_error_s2_and_jump_terms => k_s2*de_s2*delta_s2;
            transmission_error_r2_and_jump_terms => k_r2*de_r2*delta_r2;
            transmission_error_s3_and_jump_terms => k_s3*de_s3*delta_s3;
            transmission_error_r3_and_jump_terms => k_r3*de_r3*delta_r3;
            transmission_error_s4_and_jump_terms => k_s4*de_s4*delta_s4;
            transmission_error_r4_and_jump_terms => k_r4*de_r4*delta_r4;
            torques => T_motor/Z_r - T_load/Z_r + T_motor/Z_s;
            damping => h*I_p*alpha_M*u1_dot/r_p.powi(2) + h*I_p*alpha_M*u2_dot/r_p.powi(2) + h*I_p*alpha_M*u3_dot/r_p.powi(2)
                + h*I_p*alpha_M*u4_dot/r_p.powi(2) + 4.0*h*I_p*alpha_M*theta_c_dot/r_p + 8.0*h*I_p*alpha_M*theta_dot/(r_p*Z_r)
                - I_c*alpha_M*theta_dot/Z_r.powi(2) - I_c*alpha_M*theta_c_dot/Z_r - 4.0*I_p*alpha_M*theta_dot/Z_r.powi(2)
                - 4.0*I_p*alpha_M*theta_c_dot/Z_r - I_s*alpha_M*theta_dot/Z_r.powi(2) - I_s*alpha_M*theta_c_dot/Z_r
                - 2.0*I_s*alpha_M*theta_dot/(Z_r*Z_s) - I_s*alpha_M*theta_dot/Z_s.powi(2) - I_s*alpha_M*theta_c_dot/Z_s
                - 4.0*a.powi(2)*alpha_M*m_p*theta_dot/Z_r.powi(2) - 4.0*a.powi(2)*alpha_M*m_p*theta_c_dot/Z_r
                - 4.0*h.powi(2)*I_p*alpha_M*theta_dot/r_p.powi(2) - I_p*alpha_M*u1_dot/(r_p*Z_r) - I_p*alpha_M*u2_dot/(r_p*Z_r)
                - I_p*alpha_M*u3_dot/(r_p*Z_r) - I_p*alpha_M*u4_dot/(r_p*Z_r);
            jump_terms => (-dk_r1*delta_r1.powi(2) - dk_r2*delta_r2.powi(2) - dk_r3*delta_r3.powi(2) - dk_r4*delta_r4.powi(2)
                - dk_s1*delta_s1.powi(2) - dk_s2*delta_s2.powi(2) - dk_s3*delta_s3.powi(2) - dk_s4*delta_s4.powi(2))/2.0;
        }
        theta_c {
            _ => h*Z_r*k_r1*delta_r1 + h*Z_r*k_r2*delta_r2 + h*Z_r*k_r3*delta_r3 + h*Z_r*k_r4*delta_r4;
            torsional_support_s => -k_s*twist_s;
            torsional_support_s_and_damping => -beta_K*k_s*twist_s_dot;
            torsional_support_c => -k_c*twist_c;
            torsional_support_c_and_damping => -beta_K*k_c*twist_c_dot;
            torques => T_motor - T_load;
            damping => h*Z_r*beta_K*k_r1_mid*delta_r1_dot + h*Z_r*beta_K*k_r2_mid*delta_r2_dot + h*Z_r*beta_K*k_r3_mid*delta_r3_dot
                + h*Z_r*beta_K*k_r4_mid*delta_r4_dot + 4.0*h*I_p*alpha_M*theta_dot/r_p - I_c*alpha_M*theta_c_dot
                - I_c*alpha_M*theta_dot/Z_r - 4.0*I_p*alpha_M*theta_c_dot - 4.0*I_p*alpha_M*theta_dot/Z_r - I_s*alpha_M*theta_c_dot
                - I_s*alpha_M*theta_dot/Z_r - I_s*alpha_M*theta_dot/Z_s - 4.0*a.powi(2)*alpha_M*m_p*theta_c_dot
                - 4.0*a.powi(2)*alpha_M*m_p*theta_dot/Z_r - I_p*alpha_M*u1_dot/r_p - I_p*alpha_M*u2_dot/r_p - I_p*alpha_M*u3_dot/r_p
                - I_p*alpha_M*u4_dot/r_p;
        }
        theta_r {
            _ => -h*Z_r*k_r1*delta_r1 - h*Z_r*k_r2*delta_r2 - h*Z_r*k_r3*delta_r3 - h*Z_r*k_r4*delta_r4 - k_r*twist_r;
            damping => -h*Z_r*beta_K*k_r1_mid*delta_r1_dot - h*Z_r*beta_K*k_r2_mid*delta_r2_dot - h*Z_r*beta_K*k_r3_mid*delta_r3_dot
                - h*Z_r*beta_K*k_r4_mid*delta_r4_dot - I_r*alpha_M*theta_r_dot - beta_K*k_r*twist_r_dot;
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
        u4 {
            _ => k_r4*delta_r4 - k_s4*delta_s4;
            damping => h*I_p*alpha_M*theta_dot/r_p.powi(2) + beta_K*k_r4_mid*delta_r4_dot - beta_K*k_s4_mid*delta_s4_dot
                - I_p*alpha_M*u4_dot/r_p.powi(2) - I_p*alpha_M*theta_c_dot/r_p - I_p*alpha_M*theta_dot/(r_p*Z_r);
        }
    }
    jacobian {
        theta theta {
            torsional_support_s => -k_s/Z_r.powi(2) - 2.0*k_s/(Z_r*Z_s) - k_s/Z_s.powi(2);
            torsional_support_c => -k_c/Z_r.powi(2);
            transmission_error_s1_and_jump_terms => k_s1*dde_s1*delta_s1 - k_s1*de_s1.powi(2) + 2.0*de_s1*dk_s1*delta_s1;
            transmission_error_r1_and_jump_terms => k_r1*dde_r1*delta_r1 - k_r1*de_r1.powi(2) + 2.0*de_r1*dk_r1*delta_r1;
            transmission_error_s2_and_jump_terms => k_s2*dde_s2*delta_s2 - k_s2*de_s2.powi(2) + 2.0*de_s2*dk_s2*delta_s2;
            transmission_error_r2_and_jump_terms => k_r2*dde_r2*delta_r2 - k_r2*de_r2.powi(2) + 2.0*de_r2*dk_r2*delta_r2;
            transmission_error_s3_and_jump_terms => k_s3*dde_s3*delta_s3 - k_s3*de_s3.powi(2) + 2.0*de_s3*dk_s3*delta_s3;
            transmission_error_r3_and_jump_terms => k_r3*dde_r3*delta_r3 - k_r3*de_r3.powi(2) + 2.0*de_r3*dk_r3*delta_r3;
            transmission_error_s4_and_jump_terms => k_s4*dde_s4*delta_s4 - k_s4*de_s4.powi(2) + 2.0*de_s4*dk_s4*delta_s4;
            transmission_error_r4_and_jump_terms => k_r4*dde_r4*delta_r4 - k_r4*de_r4.powi(2) + 2.0*de_r4*dk_r4*delta_r4;
            jump_terms => (-ddk_r1*delta_r1.powi(2) - ddk_r2*delta_r2.powi(2) - ddk_r3*delta_r3.powi(2) - ddk_r4*delta_r4.powi(2)
                - ddk_s1*delta_s1.powi(2) - ddk_s2*delta_s2.powi(2) - ddk_s3*delta_s3.powi(2) - ddk_s4*delta_s4.powi(2))/2.0;
        }
        theta theta_c {
            torsional_support_s => -k_s/Z_r - k_s/Z_s;
            torsional_support_c => -k_c/Z_r;
            transmission_error_r1_and_jump_terms => -h*Z_r*k_r1*de_r1;
            transmission_error_r2_and_jump_terms => -h*Z_r*k_r2*de_r2;
            transmission_error_r3_and_jump_terms => -h*Z_r*k_r3*de_r3;
            transmission_error_r4_and_jump_terms => -h*Z_r*k_r4*de_r4;
            jump_terms => h*Z_r*dk_r1*delta_r1 + h*Z_r*dk_r2*delta_r2 + h*Z_r*dk_r3*delta_r3 + h*Z_r*dk_r4*delta_r4;
        }
        theta theta_r {
            transmission_error_r1_and_jump_terms => h*Z_r*k_r1*de_r1;
            transmission_error_r2_and_jump_terms => h*Z_r*k_r2*de_r2;
            transmission_error_r3_and_jump_terms => h*Z_r*k_r3*de_r3;
            transmission_error_r4_and_jump_terms => h*Z_r*k_r4*de_r4;
            jump_terms => -h*Z_r*dk_r1*delta_r1 - h*Z_r*dk_r2*delta_r2 - h*Z_r*dk_r3*delta_r3 - h*Z_r*dk_r4*delta_r4;
        }
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
        theta u4 {
            transmission_error_s4_and_jump_terms => k_s4*de_s4;
            transmission_error_r4_and_jump_terms => -k_r4*de_r4;
            jump_terms => dk_r4*delta_r4 - dk_s4*delta_s4;
        }
        theta theta_dot {
            torsional_support_s_and_damping => -beta_K*k_s/Z_r.powi(2) - 2.0*beta_K*k_s/(Z_r*Z_s) - beta_K*k_s/Z_s.powi(2);
            torsional_support_c_and_damping => -beta_K*k_c/Z_r.powi(2);
            damping => 8.0*h*I_p*alpha_M/(r_p*Z_r) - I_c*alpha_M/Z_r.powi(2) - 4.0*I_p*alpha_M/Z_r.powi(2) - I_s*alpha_M/Z_r.powi(2)
                - 2.0*I_s*alpha_M/(Z_r*Z_s) - I_s*alpha_M/Z_s.powi(2) - 4.0*a.powi(2)*alpha_M*m_p/Z_r.powi(2)
                - 4.0*h.powi(2)*I_p*alpha_M/r_p.powi(2);
        }
        theta theta_c_dot {
            torsional_support_s_and_damping => -beta_K*k_s/Z_r - beta_K*k_s/Z_s;
            torsional_support_c_and_damping => -beta_K*k_c/Z_r;
            damping => 4.0*h*I_p*alpha_M/r_p - I_c*alpha_M/Z_r - 4.0*I_p*alpha_M/Z_r - I_s*alpha_M/Z_r - I_s*alpha_M/Z_s
                - 4.0*a.powi(2)*alpha_M*m_p/Z_r;
        }
        theta u1_dot { damping => h*I_p*alpha_M/r_p.powi(2) - I_p*alpha_M/(r_p*Z_r); }
        theta u2_dot { damping => h*I_p*alpha_M/r_p.powi(2) - I_p*alpha_M/(r_p*Z_r); }
        theta u3_dot { damping => h*I_p*alpha_M/r_p.powi(2) - I_p*alpha_M/(r_p*Z_r); }
        theta u4_dot { damping => h*I_p*alpha_M/r_p.powi(2) - I_p*alpha_M/(r_p*Z_r); }
        theta_c theta {
            torsional_support_s => -k_s/Z_r - k_s/Z_s;
            torsional_support_c => -k_c/Z_r;
            transmission_error_r1_and_moving_phase => -h*Z_r*k_r1*de_r1;
            transmission_error_r2_and_moving_phase => -h*Z_r*k_r2*de_r2;
            transmission_error_r3_and_moving_phase => -h*Z_r*k_r3*de_r3;
            transmission_error_r4_and_moving_phase => -h*Z_r*k_r4*de_r4;
            moving_phase => h*Z_r*dk_r1*delta_r1 + h*Z_r*dk_r2*delta_r2 + h*Z_r*dk_r3*delta_r3 + h*Z_r*dk_r4*delta_r4;
        }
        theta_c theta_c {
            _ => -h.powi(2)*Z_r.powi(2)*k_r1 - h.powi(2)*Z_r.powi(2)*k_r2 - h.powi(2)*Z_r.powi(2)*k_r3 - h.powi(2)*Z_r.powi(2)*k_r4;
            torsional_support_s => -k_s;
            torsional_support_c => -k_c;
        }
        theta_c theta_r {
            _ => h.powi(2)*Z_r.powi(2)*k_r1 + h.powi(2)*Z_r.powi(2)*k_r2 + h.powi(2)*Z_r.powi(2)*k_r3 + h.powi(2)*Z_r.powi(2)*k_r4;
        }
        theta_c u1 { _ => -h*Z_r*k_r1; }
        theta_c u2 { _ => -h*Z_r*k_r2; }
        theta_c u3 { _ => -h*Z_r*k_r3; }
        theta_c u4 { _ => -h*Z_r*k_r4; }
        theta_c theta_dot {
            torsional_support_s_and_damping => -beta_K*k_s/Z_r - beta_K*k_s/Z_s;
            torsional_support_c_and_damping => -beta_K*k_c/Z_r;
            damping => 4.0*h*I_p*alpha_M/r_p - I_c*alpha_M/Z_r - 4.0*I_p*alpha_M/Z_r - I_s*alpha_M/Z_r - I_s*alpha_M/Z_s
                - 4.0*a.powi(2)*alpha_M*m_p/Z_r;
        }
        theta_c theta_c_dot {
            torsional_support_s_and_damping => -beta_K*k_s;
            torsional_support_c_and_damping => -beta_K*k_c;
            damping => -I_c*alpha_M - 4.0*I_p*alpha_M - I_s*alpha_M - 4.0*a.powi(2)*alpha_M*m_p - h.powi(2)*Z_r.powi(2)*beta_K*k_r1_mid
                - h.powi(2)*Z_r.powi(2)*beta_K*k_r2_mid - h.powi(2)*Z_r.powi(2)*beta_K*k_r3_mid - h.powi(2)*Z_r.powi(2)*beta_K*k_r4_mid;
        }
        theta_c theta_r_dot {
            damping => h.powi(2)*Z_r.powi(2)*beta_K*k_r1_mid + h.powi(2)*Z_r.powi(2)*beta_K*k_r2_mid
                + h.powi(2)*Z_r.powi(2)*beta_K*k_r3_mid + h.powi(2)*Z_r.powi(2)*beta_K*k_r4_mid;
        }
        theta_c u1_dot { damping => -h*Z_r*beta_K*k_r1_mid - I_p*alpha_M/r_p; }
        theta_c u2_dot { damping => -h*Z_r*beta_K*k_r2_mid - I_p*alpha_M/r_p; }
        theta_c u3_dot { damping => -h*Z_r*beta_K*k_r3_mid - I_p*alpha_M/r_p; }
        theta_c u4_dot { damping => -h*Z_r*beta_K*k_r4_mid - I_p*alpha_M/r_p; }
        theta_r theta {
            transmission_error_r1_and_moving_phase => h*Z_r*k_r1*de_r1;
            transmission_error_r2_and_moving_phase => h*Z_r*k_r2*de_r2;
            transmission_error_r3_and_moving_phase => h*Z_r*k_r3*de_r3;
            transmission_error_r4_and_moving_phase => h*Z_r*k_r4*de_r4;
            moving_phase => -h*Z_r*dk_r1*delta_r1 - h*Z_r*dk_r2*delta_r2 - h*Z_r*dk_r3*delta_r3 - h*Z_r*dk_r4*delta_r4;
        }
        theta_r theta_c {
            _ => h.powi(2)*Z_r.powi(2)*k_r1 + h.powi(2)*Z_r.powi(2)*k_r2 + h.powi(2)*Z_r.powi(2)*k_r3 + h.powi(2)*Z_r.powi(2)*k_r4;
        }
        theta_r theta_r {
            _ => -k_r - h.powi(2)*Z_r.powi(2)*k_r1 - h.powi(2)*Z_r.powi(2)*k_r2 - h.powi(2)*Z_r.powi(2)*k_r3 - h.powi(2)*Z_r.powi(2)*k_r4;
        }
        theta_r u1 { _ => h*Z_r*k_r1; }
        theta_r u2 { _ => h*Z_r*k_r2; }
        theta_r u3 { _ => h*Z_r*k_r3; }
        theta_r u4 { _ => h*Z_r*k_r4; }
        theta_r theta_c_dot {
            damping => h.powi(2)*Z_r.powi(2)*beta_K*k_r1_mid + h.powi(2)*Z_r.powi(2)*beta_K*k_r2_mid
                + h.powi(2)*Z_r.powi(2)*beta_K*k_r3_mid + h.powi(2)*Z_r.powi(2)*beta_K*k_r4_mid;
        }
        theta_r theta_r_dot {
            damping => -I_r*alpha_M - beta_K*k_r - h.powi(2)*Z_r.powi(2)*beta_K*k_r1_mid - h.powi(2)*Z_r.powi(2)*beta_K*k_r2_mid
                - h.powi(2)*Z_r.powi(2)*beta_K*k_r3_mid - h.powi(2)*Z_r.powi(2)*beta_K*k_r4_mid;
        }
        theta_r u1_dot { damping => h*Z_r*beta_K*k_r1_mid; }
        theta_r u2_dot { damping => h*Z_r*beta_K*k_r2_mid; }
        theta_r u3_dot { damping => h*Z_r*beta_K*k_r3_mid; }
        theta_r u4_dot { damping => h*Z_r*beta_K*k_r4_mid; }
        u1 theta {
            transmission_error_s1_and_moving_phase => k_s1*de_s1;
            transmission_error_r1_and_moving_phase => -k_r1*de_r1;
            moving_phase => dk_r1*delta_r1 - dk_s1*delta_s1;
        }
        u1 theta_c { _ => -h*Z_r*k_r1; }
        u1 theta_r { _ => h*Z_r*k_r1; }
        u1 u1 { _ => -k_r1 - k_s1; }
        u1 theta_dot { damping => h*I_p*alpha_M/r_p.powi(2) - I_p*alpha_M/(r_p*Z_r); }
        u1 theta_c_dot { damping => -h*Z_r*beta_K*k_r1_mid - I_p*alpha_M/r_p; }
        u1 theta_r_dot { damping => h*Z_r*beta_K*k_r1_mid; }
        u1 u1_dot { damping => -beta_K*k_r1_mid - beta_K*k_s1_mid - I_p*alpha_M/r_p.powi(2); }
        u2 theta {
            transmission_error_s2_and_moving_phase => k_s2*de_s2;
            transmission_error_r2_and_moving_phase => -k_r2*de_r2;
            moving_phase => dk_r2*delta_r2 - dk_s2*delta_s2;
        }
        u2 theta_c { _ => -h*Z_r*k_r2; }
        u2 theta_r { _ => h*Z_r*k_r2; }
        u2 u2 { _ => -k_r2 - k_s2; }
        u2 theta_dot { damping => h*I_p*alpha_M/r_p.powi(2) - I_p*alpha_M/(r_p*Z_r); }
        u2 theta_c_dot { damping => -h*Z_r*beta_K*k_r2_mid - I_p*alpha_M/r_p; }
        u2 theta_r_dot { damping => h*Z_r*beta_K*k_r2_mid; }
        u2 u2_dot { damping => -beta_K*k_r2_mid - beta_K*k_s2_mid - I_p*alpha_M/r_p.powi(2); }
        u3 theta {
            transmission_error_s3_and_moving_phase => k_s3*de_s3;
            transmission_error_r3_and_moving_phase => -k_r3*de_r3;
            moving_phase => dk_r3*delta_r3 - dk_s3*delta_s3;
        }
        u3 theta_c { _ => -h*Z_r*k_r3; }
        u3 theta_r { _ => h*Z_r*k_r3; }
        u3 u3 { _ => -k_r3 - k_s3; }
        u3 theta_dot { damping => h*I_p*alpha_M/r_p.powi(2) - I_p*alpha_M/(r_p*Z_r); }
        u3 theta_c_dot { damping => -h*Z_r*beta_K*k_r3_mid - I_p*alpha_M/r_p; }
        u3 theta_r_dot { damping => h*Z_r*beta_K*k_r3_mid; }
        u3 u3_dot { damping => -beta_K*k_r3_mid - beta_K*k_s3_mid - I_p*alpha_M/r_p.powi(2); }
        u4 theta {
            transmission_error_s4_and_moving_phase => k_s4*de_s4;
            transmission_error_r4_and_moving_phase => -k_r4*de_r4;
            moving_phase => dk_r4*delta_r4 - dk_s4*delta_s4;
        }
        u4 theta_c { _ => -h*Z_r*k_r4; }
        u4 theta_r { _ => h*Z_r*k_r4; }
        u4 u4 { _ => -k_r4 - k_s4; }
        u4 theta_dot { damping => h*I_p*alpha_M/r_p.powi(2) - I_p*alpha_M/(r_p*Z_r); }
        u4 theta_c_dot { damping => -h*Z_r*beta_K*k_r4_mid - I_p*alpha_M/r_p; }
        u4 theta_r_dot { damping => h*Z_r*beta_K*k_r4_mid; }
        u4 u4_dot { damping => -beta_K*k_r4_mid - beta_K*k_s4_mid - I_p*alpha_M/r_p.powi(2); }
    }
    cell {
        stiffness {
            theta theta {
                torsional_support_s => k_s/Z_r.powi(2) + 2.0*k_s/(Z_r*Z_s) + k_s/Z_s.powi(2);
                torsional_support_c => k_c/Z_r.powi(2);
            }
            theta theta_c {
                torsional_support_s => k_s/Z_r + k_s/Z_s;
                torsional_support_c => k_c/Z_r;
            }
            theta_c theta_c {
                _ => h.powi(2)*Z_r.powi(2)*k_r1 + h.powi(2)*Z_r.powi(2)*k_r2 + h.powi(2)*Z_r.powi(2)*k_r3 + h.powi(2)*Z_r.powi(2)*k_r4;
                torsional_support_s => k_s;
                torsional_support_c => k_c;
            }
            theta_c theta_r {
                _ => -h.powi(2)*Z_r.powi(2)*k_r1 - h.powi(2)*Z_r.powi(2)*k_r2 - h.powi(2)*Z_r.powi(2)*k_r3 - h.powi(2)*Z_r.powi(2)*k_r4;
            }
            theta_c u1 { _ => h*Z_r*k_r1; }
            theta_c u2 { _ => h*Z_r*k_r2; }
            theta_c u3 { _ => h*Z_r*k_r3; }
            theta_c u4 { _ => h*Z_r*k_r4; }
            theta_r theta_r {
                _ => k_r + h.powi(2)*Z_r.powi(2)*k_r1 + h.powi(2)*Z_r.powi(2)*k_r2 + h.powi(2)*Z_r.powi(2)*k_r3
                    + h.powi(2)*Z_r.powi(2)*k_r4;
            }
            theta_r u1 { _ => -h*Z_r*k_r1; }
            theta_r u2 { _ => -h*Z_r*k_r2; }
            theta_r u3 { _ => -h*Z_r*k_r3; }
            theta_r u4 { _ => -h*Z_r*k_r4; }
            u1 u1 { _ => k_r1 + k_s1; }
            u2 u2 { _ => k_r2 + k_s2; }
            u3 u3 { _ => k_r3 + k_s3; }
            u4 u4 { _ => k_r4 + k_s4; }
        }
        damping {
            theta theta {
                torsional_support_s_and_damping => beta_K*k_s/Z_r.powi(2) + 2.0*beta_K*k_s/(Z_r*Z_s) + beta_K*k_s/Z_s.powi(2);
                torsional_support_c_and_damping => beta_K*k_c/Z_r.powi(2);
                damping => I_c*alpha_M/Z_r.powi(2) - 8.0*h*I_p*alpha_M/(r_p*Z_r) + 4.0*I_p*alpha_M/Z_r.powi(2) + I_s*alpha_M/Z_r.powi(2)
                    + 2.0*I_s*alpha_M/(Z_r*Z_s) + I_s*alpha_M/Z_s.powi(2) + 4.0*a.powi(2)*alpha_M*m_p/Z_r.powi(2)
                    + 4.0*h.powi(2)*I_p*alpha_M/r_p.powi(2);
            }
            theta theta_c {
                torsional_support_s_and_damping => beta_K*k_s/Z_r + beta_K*k_s/Z_s;
                torsional_support_c_and_damping => beta_K*k_c/Z_r;
                damping => I_c*alpha_M/Z_r - 4.0*h*I_p*alpha_M/r_p + 4.0*I_p*alpha_M/Z_r + I_s*alpha_M/Z_r + I_s*alpha_M/Z_s
                    + 4.0*a.powi(2)*alpha_M*m_p/Z_r;
            }
            theta u1 { damping => I_p*alpha_M/(r_p*Z_r) - h*I_p*alpha_M/r_p.powi(2); }
            theta u2 { damping => I_p*alpha_M/(r_p*Z_r) - h*I_p*alpha_M/r_p.powi(2); }
            theta u3 { damping => I_p*alpha_M/(r_p*Z_r) - h*I_p*alpha_M/r_p.powi(2); }
            theta u4 { damping => I_p*alpha_M/(r_p*Z_r) - h*I_p*alpha_M/r_p.powi(2); }
            theta_c theta_c {
                torsional_support_s_and_damping => beta_K*k_s;
                torsional_support_c_and_damping => beta_K*k_c;
                damping => I_c*alpha_M + 4.0*I_p*alpha_M + I_s*alpha_M + 4.0*a.powi(2)*alpha_M*m_p + h.powi(2)*Z_r.powi(2)*beta_K*k_r1_mid
                    + h.powi(2)*Z_r.powi(2)*beta_K*k_r2_mid + h.powi(2)*Z_r.powi(2)*beta_K*k_r3_mid + h.powi(2)*Z_r.powi(2)*beta_K*k_r4_mid;
            }
            theta_c theta_r {
                damping => -h.powi(2)*Z_r.powi(2)*beta_K*k_r1_mid - h.powi(2)*Z_r.powi(2)*beta_K*k_r2_mid
                    - h.powi(2)*Z_r.powi(2)*beta_K*k_r3_mid - h.powi(2)*Z_r.powi(2)*beta_K*k_r4_mid;
            }
            theta_c u1 { damping => h*Z_r*beta_K*k_r1_mid + I_p*alpha_M/r_p; }
            theta_c u2 { damping => h*Z_r*beta_K*k_r2_mid + I_p*alpha_M/r_p; }
            theta_c u3 { damping => h*Z_r*beta_K*k_r3_mid + I_p*alpha_M/r_p; }
            theta_c u4 { damping => h*Z_r*beta_K*k_r4_mid + I_p*alpha_M/r_p; }
            theta_r theta_r {
                damping => I_r*alpha_M + beta_K*k_r + h.powi(2)*Z_r.powi(2)*beta_K*k_r1_mid + h.powi(2)*Z_r.powi(2)*beta_K*k_r2_mid
                    + h.powi(2)*Z_r.powi(2)*beta_K*k_r3_mid + h.powi(2)*Z_r.powi(2)*beta_K*k_r4_mid;
            }
            theta_r u1 { damping => -h*Z_r*beta_K*k_r1_mid; }
            theta_r u2 { damping => -h*Z_r*beta_K*k_r2_mid; }
            theta_r u3 { damping => -h*Z_r*beta_K*k_r3_mid; }
            theta_r u4 { damping => -h*Z_r*beta_K*k_r4_mid; }
            u1 u1 { damping => beta_K*k_r1_mid + beta_K*k_s1_mid + I_p*alpha_M/r_p.powi(2); }
            u2 u2 { damping => beta_K*k_r2_mid + beta_K*k_s2_mid + I_p*alpha_M/r_p.powi(2); }
            u3 u3 { damping => beta_K*k_r3_mid + beta_K*k_s3_mid + I_p*alpha_M/r_p.powi(2); }
            u4 u4 { damping => beta_K*k_r4_mid + beta_K*k_s4_mid + I_p*alpha_M/r_p.powi(2); }
        }
        load {
            theta { torques => T_motor/Z_r - T_load/Z_r + T_motor/Z_s; }
            theta_c {
                _ => -h*Z_r*k_r1*e_r1 - h*Z_r*k_r2*e_r2 - h*Z_r*k_r3*e_r3 - h*Z_r*k_r4*e_r4;
                torques => T_motor - T_load;
            }
            theta_r { _ => h*Z_r*k_r1*e_r1 + h*Z_r*k_r2*e_r2 + h*Z_r*k_r3*e_r3 + h*Z_r*k_r4*e_r4; }
            u1 { _ => k_s1*e_s1 - k_r1*e_r1; }
            u2 { _ => k_s2*e_s2 - k_r2*e_r2; }
            u3 { _ => k_s3*e_s3 - k_r3*e_r3; }
            u4 { _ => k_s4*e_s4 - k_r4*e_r4; }
        }
    }
    jump k_s1 { step { _ => dk_s1*delta_s1.powi(2)/2.0; } }
    jump k_r1 { step { _ => dk_r1*delta_r1.powi(2)/2.0; } }
    jump k_s2 { step { _ => dk_s2*delta_s2.powi(2)/2.0; } }
    jump k_r2 { step { _ => dk_r2*delta_r2.powi(2)/2.0; } }
    jump k_s3 { step { _ => dk_s3*delta_s3.powi(2)/2.0; } }
    jump k_r3 { step { _ => dk_r3*delta_r3.powi(2)/2.0; } }
    jump k_s4 { step { _ => dk_s4*delta_s4.powi(2)/2.0; } }
    jump k_r4 { step { _ => dk_r4*delta_r4.powi(2)/2.0; } }
    jump e_s1 { step { _ => k_s1*de_s1.powi(2)/2.0 - k_s1*de_s1*delta_s1; } }
    jump e_r1 { step { _ => k_r1*de_r1.powi(2)/2.0 - k_r1*de_r1*delta_r1; } }
    jump e_s2 { step { _ => k_s2*de_s2.powi(2)/2.0 - k_s2*de_s2*delta_s2; } }
    jump e_r2 { step { _ => k_r2*de_r2.powi(2)/2.0 - k_r2*de_r2*delta_r2; } }
    jump e_s3 { step { _ => k_s3*de_s3.powi(2)/2.0 - k_s3*de_s3*delta_s3; } }
    jump e_r3 { step { _ => k_r3*de_r3.powi(2)/2.0 - k_r3*de_r3*delta_r3; } }
    jump e_s4 { step { _ => k_s4*de_s4.powi(2)/2.0 - k_s4*de_s4*delta_s4; } }
    jump e_r4 { step { _ => k_r4*de_r4.powi(2)/2.0 - k_r4*de_r4*delta_r4; } }
    outputs {
        rotor_speed_s "rad/s", "rotational speed of the sun" { _ => theta_c_dot + theta_dot*(1.0/Z_r + 1.0/Z_s); }
        rotor_speed_c "rad/s", "rotational speed of the carrier without planets" { _ => theta_c_dot + theta_dot/Z_r; }
        rotor_speed_r "rad/s", "rotational speed of the ring" { _ => theta_r_dot; }
        shaft_twist_r "rad", "twist of the ring's torsional support" { _ => twist_r; }
        shaft_torque_r "N*m", "torque in the ring's torsional support, damper included" {
            _ => k_r*twist_r;
            damping => beta_K*k_r*twist_r_dot;
        }
        shaft_power_r "W", "power that enters the ring's torsional support at its first end: torque times the speed of that end" {
            _ => theta_r_dot*shaft_torque_r;
        }
        shaft_loss_r "W", "power that the damper of the ring's torsional support takes" { damping => beta_K*k_r*twist_r_dot.powi(2); }
        shaft_twist_s "rad" with torsional_support_s, "twist of the sun's torsional support" { _ => twist_s; }
        shaft_torque_s "N*m" with torsional_support_s, "torque in the sun's torsional support, damper included" {
            torsional_support_s => k_s*twist_s;
            torsional_support_s_and_damping => beta_K*k_s*twist_s_dot;
        }
        shaft_power_s "W" with torsional_support_s,
            "power that enters the sun's torsional support at its first end: torque times the speed of that end" {
            _ => shaft_torque_s*(theta_c_dot + theta_dot*(1.0/Z_r + 1.0/Z_s));
        }
        shaft_loss_s "W" with torsional_support_s, "power that the damper of the sun's torsional support takes" {
            torsional_support_s_and_damping => beta_K*k_s*twist_s_dot.powi(2);
        }
        shaft_twist_c "rad" with torsional_support_c, "twist of the carrier's torsional support" { _ => twist_c; }
        shaft_torque_c "N*m" with torsional_support_c, "torque in the carrier's torsional support, damper included" {
            torsional_support_c => k_c*twist_c;
            torsional_support_c_and_damping => beta_K*k_c*twist_c_dot;
        }
        shaft_power_c "W" with torsional_support_c,
            "power that enters the carrier's torsional support at its first end: torque times the speed of that end" {
            _ => shaft_torque_c*(theta_c_dot + theta_dot/Z_r);
        }
        shaft_loss_c "W" with torsional_support_c, "power that the damper of the carrier's torsional support takes" {
            torsional_support_c_and_damping => beta_K*k_c*twist_c_dot.powi(2);
        }
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
        mesh_power_r1 "W", "power that the first gear gives to the mesh of ring and planet 1: force times the speed of its flank" {
            _ => h*Z_r*theta_r_dot*mesh_force_r1;
        }
        mesh_deflection_r1 "m", "deflection of the mesh of ring and planet 1 along the line of action, backlash not taken off" {
            _ => h*Z_r*theta_r - e_r1 - (u1 - h*theta + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0) - h*(Z_r + Z_s)*(theta_c + theta/Z_r)/2.0;
        }
        dte_r1 "m",
            "dynamic transmission error of the mesh of ring and planet 1 along the line of action: positive if the driving gear is ahead" {
            _ => h*Z_r*theta_r - (u1 - h*theta + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0) - h*(Z_r + Z_s)*(theta_c + theta/Z_r)/2.0;
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
        mesh_power_r2 "W", "power that the first gear gives to the mesh of ring and planet 2: force times the speed of its flank" {
            _ => h*Z_r*theta_r_dot*mesh_force_r2;
        }
        mesh_deflection_r2 "m", "deflection of the mesh of ring and planet 2 along the line of action, backlash not taken off" {
            _ => h*Z_r*theta_r - e_r2 - (u2 - h*theta + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0) - h*(Z_r + Z_s)*(theta_c + theta/Z_r)/2.0;
        }
        dte_r2 "m",
            "dynamic transmission error of the mesh of ring and planet 2 along the line of action: positive if the driving gear is ahead" {
            _ => h*Z_r*theta_r - (u2 - h*theta + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0) - h*(Z_r + Z_s)*(theta_c + theta/Z_r)/2.0;
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
        mesh_power_r3 "W", "power that the first gear gives to the mesh of ring and planet 3: force times the speed of its flank" {
            _ => h*Z_r*theta_r_dot*mesh_force_r3;
        }
        mesh_deflection_r3 "m", "deflection of the mesh of ring and planet 3 along the line of action, backlash not taken off" {
            _ => h*Z_r*theta_r - e_r3 - (u3 - h*theta + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0) - h*(Z_r + Z_s)*(theta_c + theta/Z_r)/2.0;
        }
        dte_r3 "m",
            "dynamic transmission error of the mesh of ring and planet 3 along the line of action: positive if the driving gear is ahead" {
            _ => h*Z_r*theta_r - (u3 - h*theta + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0) - h*(Z_r + Z_s)*(theta_c + theta/Z_r)/2.0;
        }
        mesh_loss_r3 "W", "power that the damper of the mesh of ring and planet 3 takes" {
            damping => beta_K*k_r3_mid*delta_r3_dot.powi(2);
        }
        mesh_force_s4 "N",
            "force of the mesh of sun and planet 4 along the line of action, damper included: positive if it presses the drive flanks" {
            _ => k_s4*delta_s4;
            damping => beta_K*k_s4_mid*delta_s4_dot;
        }
        mesh_power_s4 "W", "power that the first gear gives to the mesh of sun and planet 4: force times the speed of its flank" {
            _ => mesh_force_s4*(h*Z_s*theta_c_dot + h*Z_s*theta_dot*(1.0/Z_r + 1.0/Z_s));
        }
        mesh_deflection_s4 "m", "deflection of the mesh of sun and planet 4 along the line of action, backlash not taken off" {
            _ => u4 - e_s4 + h*Z_s*(theta_c + theta/Z_r + theta/Z_s) - h*theta - h*(Z_r + Z_s)*(theta_c + theta/Z_r)/2.0
                + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0;
        }
        dte_s4 "m",
            "dynamic transmission error of the mesh of sun and planet 4 along the line of action: positive if the driving gear is ahead" {
            _ => u4 + h*Z_s*(theta_c + theta/Z_r + theta/Z_s) - h*theta - h*(Z_r + Z_s)*(theta_c + theta/Z_r)/2.0
                + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0;
        }
        mesh_loss_s4 "W", "power that the damper of the mesh of sun and planet 4 takes" { damping => beta_K*k_s4_mid*delta_s4_dot.powi(2); }
        mesh_force_r4 "N",
            "force of the mesh of ring and planet 4 along the line of action, damper included: positive if it presses the drive flanks" {
            _ => k_r4*delta_r4;
            damping => beta_K*k_r4_mid*delta_r4_dot;
        }
        mesh_power_r4 "W", "power that the first gear gives to the mesh of ring and planet 4: force times the speed of its flank" {
            _ => h*Z_r*theta_r_dot*mesh_force_r4;
        }
        mesh_deflection_r4 "m", "deflection of the mesh of ring and planet 4 along the line of action, backlash not taken off" {
            _ => h*Z_r*theta_r - e_r4 - (u4 - h*theta + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0) - h*(Z_r + Z_s)*(theta_c + theta/Z_r)/2.0;
        }
        dte_r4 "m",
            "dynamic transmission error of the mesh of ring and planet 4 along the line of action: positive if the driving gear is ahead" {
            _ => h*Z_r*theta_r - (u4 - h*theta + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0) - h*(Z_r + Z_s)*(theta_c + theta/Z_r)/2.0;
        }
        mesh_loss_r4 "W", "power that the damper of the mesh of ring and planet 4 takes" {
            damping => beta_K*k_r4_mid*delta_r4_dot.powi(2);
        }
        power_motor "W" with torques, "power of the driving torque of the sun: positive if it drives" { _ => motor_power; }
        power_load "W" with torques, "power of the load torque of the carrier, against its rotation: positive if it drives" {
            _ => load_power;
        }
        inertia_damping_loss "W" with damping, "power that the damping in proportion to inertia takes" {
            _ => 2.0*alpha_M*(I_c*(theta_c_dot + theta_dot/Z_r).powi(2)/2.0
                + I_p*(theta_c_dot + (u1_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)/2.0
                + I_p*(theta_c_dot + (u2_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)/2.0
                + I_p*(theta_c_dot + (u3_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)/2.0
                + I_p*(theta_c_dot + (u4_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)/2.0 + I_r*theta_r_dot.powi(2)/2.0
                + I_s*(theta_c_dot + theta_dot*(1.0/Z_r + 1.0/Z_s)).powi(2)/2.0 + 2.0*a.powi(2)*m_p*(theta_c_dot + theta_dot/Z_r).powi(2));
        }
    }

    text "text/planetary_4.txt";
    latex "latex/planetary_4.tex";
}

// Proved of these equations, symbolically:
//
// - d/dt (q'.dT/dq' - T + V) = Q.q' - q'.dD/dq' along the motion, for every value and slope of every law, with any set of the additive
//   effects
// - M is symmetric
// - T = q'.M q'/2, with M as written
// - M is positive definite: T is a sum of squares that vanish together only at rest
// - at a step of k_s1, k_r1, k_s2, k_r2, k_s3, k_r3, k_s4, k_r4, e_s1, e_r1, e_s2, e_r2, e_s3, e_r3, e_s4, e_r4: T+ - T- = (v+² - v²)/(2 G)
//   for any v+, where M d = n/G; V+ - V- = dV as written; so T + V is unchanged in transmission (v+² = v² - 2 G dV) and in reflection (v+ =
//   -v, dV = 0)
// - every damper takes energy or none: each term of D has a power q'.dD/dq' that is never negative
// - every deflection equals the linear form by which the equations differentiate it
// - without the jump terms the balance fails: energy is created at the rate dk_r1*delta_r1^2*theta_dot/2 - k_r1*de_r1*delta_r1*theta_dot -
//   k_r2*de_r2*delta_r2*theta_dot - k_r3*de_r3*delta_r3*theta_dot - k_r4*de_r4*delta_r4*theta_dot - k_s1*de_s1*delta_s1*theta_dot -
//   k_s2*de_s2*delta_s2*theta_dot - k_s3*de_s3*delta_s3*theta_dot - k_s4*de_s4*delta_s4*theta_dot + dk_r2*delta_r2^2*theta_dot/2 +
//   dk_r3*delta_r3^2*theta_dot/2 + dk_r4*delta_r4^2*theta_dot/2 + dk_s1*delta_s1^2*theta_dot/2 + dk_s2*delta_s2^2*theta_dot/2 +
//   dk_s3*delta_s3^2*theta_dot/2 + dk_s4*delta_s4^2*theta_dot/2
//
// Operations, all effects present:
//
// | output | sums | products, quotients | functions, roots |
// | --- | --- | --- | --- |
// | constants (once a scene) | 2 | 11 | 2 |
// | force | 86 | 363 | 0 |
// | energy steps, all laws | 8 | 64 | 0 |
