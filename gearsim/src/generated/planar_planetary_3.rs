//! Equations of motion of `planar_planetary_3`: a planetary stage with 3 planets, in the plane.
//!
//! Derived from the energies in `models/src/planar_planetary.rs` by `cargo xtask derive planar_planetary_3`.
//! Do not edit: change the energies and derive again.
//! For reading: `text/planar_planetary_3.txt`, `latex/planar_planetary_3.tex`. What is proved: at the end.

use gearsim::equations;

equations! {
    model planar_planetary_3 "a planetary stage with 3 planets, in the plane";
    source "Lin & Parker (1999), J. Vib. Acoust. 121(3), doi:10.1115/1.2893982, without gyroscopic terms; phase on the sun";

    coordinates {
        theta "rad" start 0.0, "phase of the meshes, Z_s (theta_s - theta_c)";
        theta_c "rad" start static, "rotation of the carrier in excess of rigid rolling";
        theta_r "rad" start static, "rotation of the ring";
        x_s "m" start static, "x of the centre of the sun";
        y_s "m" start static, "y of the centre of the sun";
        x_c "m" start static, "x of the centre of the carrier";
        y_c "m" start static, "y of the centre of the carrier";
        x_r "m" start static, "x of the centre of the ring";
        y_r "m" start static, "y of the centre of the ring";
        zeta1 "m" start static, "radial displacement of planet 1";
        eta1 "m" start static, "tangential displacement of planet 1 in excess of the rotation of the carrier";
        u1 "m" start static, "rotation of planet 1 in excess of rigid rolling, times its base radius";
        zeta2 "m" start static, "radial displacement of planet 2";
        eta2 "m" start static, "tangential displacement of planet 2 in excess of the rotation of the carrier";
        u2 "m" start static, "rotation of planet 2 in excess of rigid rolling, times its base radius";
        zeta3 "m" start static, "radial displacement of planet 3";
        eta3 "m" start static, "tangential displacement of planet 3 in excess of the rotation of the carrier";
        u3 "m" start static, "rotation of planet 3 in excess of rigid rolling, times its base radius";
    }
    parameters {
        Z_s "1" required, open 0.0 to inf, "number of teeth of the sun";
        Z_r "1" required, open 0.0 to inf, "number of teeth of the ring";
        r_s "m" required, open 0.0 to inf, "base radius of the sun";
        alpha "rad" default 0.3490658503988659, open 0.0 to inf, "pressure angle";
        I_s "kg*m^2" required, open 0.0 to inf, "moment of inertia of the sun";
        m_s "kg" required, open 0.0 to inf, "mass of the sun";
        kb_s "N/m" required, from 0.0 to inf, "radial stiffness of the bearing of the sun";
        cb_s "N*s/m" required with viscous_friction_s, from 0.0 to inf, "radial damping of the bearing of the sun: force per speed";
        I_c "kg*m^2" required, open 0.0 to inf, "moment of inertia of the carrier";
        m_c "kg" required, open 0.0 to inf, "mass of the carrier";
        kb_c "N/m" required, from 0.0 to inf, "radial stiffness of the bearing of the carrier";
        cb_c "N*s/m" required with viscous_friction_c, from 0.0 to inf, "radial damping of the bearing of the carrier: force per speed";
        I_r "kg*m^2" required, open 0.0 to inf, "moment of inertia of the ring";
        m_r "kg" required, open 0.0 to inf, "mass of the ring";
        kb_r "N/m" required, from 0.0 to inf, "radial stiffness of the bearing of the ring";
        cb_r "N*s/m" required with viscous_friction_r, from 0.0 to inf, "radial damping of the bearing of the ring: force per speed";
        k_r "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the ring's torsional support";
        k_s "N*m/rad" required with torsional_support_s, from 0.0 to inf, "torsional stiffness of the sun's torsional support";
        k_c "N*m/rad" required with torsional_support_c, from 0.0 to inf, "torsional stiffness of the carrier's torsional support";
        m_p "kg" required, open 0.0 to inf, "mass of a planet";
        I_p "kg*m^2" required, open 0.0 to inf, "moment of inertia of a planet";
        kb_p "N/m" required, from 0.0 to inf, "radial stiffness of a planet's bearing";
        psi1 "rad" default 0.0, open -inf to inf, "angular position of planet 1";
        psi2 "rad" default 2.0943951023931953, open -inf to inf, "angular position of planet 2";
        psi3 "rad" default 4.1887902047863905, open -inf to inf, "angular position of planet 3";
        cb_p "N*s/m" required with viscous_friction_p, from 0.0 to inf, "radial damping of the bearing of a planet: force per speed";
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
    }
    motions { speed "rad/s" { theta_dot = Z_r*Z_s/(Z_r + Z_s); }, "rotational speed of the sun, ring at rest"; }
    effects {
        viscous_friction_s of viscous_friction "friction proportional to speed";
        viscous_friction_c of viscous_friction "friction proportional to speed";
        viscous_friction_r of viscous_friction "friction proportional to speed";
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
        viscous_friction_p of viscous_friction "friction proportional to speed";
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
        transmission_error_r1_and_moving_phase = transmission_error_r1, stiffness_step, !frozen_phase;
        transmission_error_r2_and_moving_phase = transmission_error_r2, stiffness_step, !frozen_phase;
        transmission_error_r3_and_moving_phase = transmission_error_r3, stiffness_step, !frozen_phase;
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
        cos_c1 = psi1.cos();
        sin_c1 = psi1.sin();
        cos_s1 = (psi1 - alpha).cos();
        sin_s1 = (psi1 - alpha).sin();
        cos_r1 = (alpha + psi1).cos();
        sin_r1 = (alpha + psi1).sin();
        cos_c2 = psi2.cos();
        sin_c2 = psi2.sin();
        cos_s2 = (psi2 - alpha).cos();
        sin_s2 = (psi2 - alpha).sin();
        cos_r2 = (alpha + psi2).cos();
        sin_r2 = (alpha + psi2).sin();
        cos_c3 = psi3.cos();
        sin_c3 = psi3.sin();
        cos_s3 = (psi3 - alpha).cos();
        sin_s3 = (psi3 - alpha).sin();
        cos_r3 = (alpha + psi3).cos();
        sin_r3 = (alpha + psi3).sin();
    }
    deflections {
        bx_s = x_s;
        by_s = y_s;
        bx_c = x_c;
        by_c = y_c;
        bx_r = x_r;
        by_r = y_r;
        twist_r = theta_r;
        twist_s = theta_c + theta/Z_r + theta/Z_s;
        twist_c = theta_c + theta/Z_r;
        radial1 = cos_c1*x_c - zeta1 + sin_c1*y_c;
        tangential1 = cos_c1*y_c - eta1 - sin_c1*x_c;
        delta_s1 = u1 - e_s1 - cos_a*eta1 + cos_s1*y_s - sin_a*zeta1 - sin_s1*x_s;
        delta_r1 = cos_r1*y_r - u1 - e_r1 - cos_a*eta1 - h*Z_r*theta_c + h*Z_r*theta_r + sin_a*zeta1 - sin_r1*x_r;
        radial2 = cos_c2*x_c - zeta2 + sin_c2*y_c;
        tangential2 = cos_c2*y_c - eta2 - sin_c2*x_c;
        delta_s2 = u2 - e_s2 - cos_a*eta2 + cos_s2*y_s - sin_a*zeta2 - sin_s2*x_s;
        delta_r2 = cos_r2*y_r - u2 - e_r2 - cos_a*eta2 - h*Z_r*theta_c + h*Z_r*theta_r + sin_a*zeta2 - sin_r2*x_r;
        radial3 = cos_c3*x_c - zeta3 + sin_c3*y_c;
        tangential3 = cos_c3*y_c - eta3 - sin_c3*x_c;
        delta_s3 = u3 - e_s3 - cos_a*eta3 + cos_s3*y_s - sin_a*zeta3 - sin_s3*x_s;
        delta_r3 = cos_r3*y_r - u3 - e_r3 - cos_a*eta3 - h*Z_r*theta_c + h*Z_r*theta_r + sin_a*zeta3 - sin_r3*x_r;
    }
    energies {
        kinetic {
            _ => (I_c*(theta_c_dot + theta_dot/Z_r).powi(2) + I_p*(theta_c_dot + (u1_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)
                + I_p*(theta_c_dot + (u2_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)
                + I_p*(theta_c_dot + (u3_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2) + I_r*theta_r_dot.powi(2)
                + I_s*(theta_c_dot + theta_dot*(1.0/Z_r + 1.0/Z_s)).powi(2) + m_c*x_c_dot.powi(2) + m_c*y_c_dot.powi(2)
                + m_p*zeta1_dot.powi(2) + m_p*zeta2_dot.powi(2) + m_p*zeta3_dot.powi(2)
                + m_p*(eta1_dot + a*(theta_c_dot + theta_dot/Z_r)).powi(2) + m_p*(eta2_dot + a*(theta_c_dot + theta_dot/Z_r)).powi(2)
                + m_p*(eta3_dot + a*(theta_c_dot + theta_dot/Z_r)).powi(2) + m_r*x_r_dot.powi(2) + m_r*y_r_dot.powi(2)
                + m_s*x_s_dot.powi(2) + m_s*y_s_dot.powi(2))/2.0;
        }
        potential {
            _ => (k_r*twist_r.powi(2) + kb_c*bx_c.powi(2) + kb_c*by_c.powi(2) + kb_p*radial1.powi(2) + kb_p*radial2.powi(2)
                + kb_p*radial3.powi(2) + kb_p*tangential1.powi(2) + kb_p*tangential2.powi(2) + kb_p*tangential3.powi(2)
                + kb_r*bx_r.powi(2) + kb_r*by_r.powi(2) + kb_s*bx_s.powi(2) + kb_s*by_s.powi(2) + k_r1*delta_r1.powi(2)
                + k_r2*delta_r2.powi(2) + k_r3*delta_r3.powi(2) + k_s1*delta_s1.powi(2) + k_s2*delta_s2.powi(2)
                + k_s3*delta_s3.powi(2))/2.0;
            torsional_support_s => k_s*twist_s.powi(2)/2.0;
            torsional_support_c => k_c*twist_c.powi(2)/2.0;
        }
        dissipation {
            viscous_friction_s => (cb_s*bx_s_dot.powi(2) + cb_s*by_s_dot.powi(2))/2.0;
            viscous_friction_c => (cb_c*bx_c_dot.powi(2) + cb_c*by_c_dot.powi(2))/2.0;
            viscous_friction_r => (cb_r*bx_r_dot.powi(2) + cb_r*by_r_dot.powi(2))/2.0;
            torsional_support_s_and_damping => beta_K*k_s*twist_s_dot.powi(2)/2.0;
            torsional_support_c_and_damping => beta_K*k_c*twist_c_dot.powi(2)/2.0;
            viscous_friction_p => (cb_p*radial1_dot.powi(2) + cb_p*radial2_dot.powi(2) + cb_p*radial3_dot.powi(2)
                + cb_p*tangential1_dot.powi(2) + cb_p*tangential2_dot.powi(2) + cb_p*tangential3_dot.powi(2))/2.0;
            damping => (I_c*alpha_M*(theta_c_dot + theta_dot/Z_r).powi(2)
                + I_p*alpha_M*(theta_c_dot + (u1_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)
                + I_p*alpha_M*(theta_c_dot + (u2_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)
                + I_p*alpha_M*(theta_c_dot + (u3_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2) + I_r*alpha_M*theta_r_dot.powi(2)
                + I_s*alpha_M*(theta_c_dot + theta_dot*(1.0/Z_r + 1.0/Z_s)).powi(2) + alpha_M*m_c*x_c_dot.powi(2)
                + alpha_M*m_c*y_c_dot.powi(2) + alpha_M*m_p*zeta1_dot.powi(2) + alpha_M*m_p*zeta2_dot.powi(2)
                + alpha_M*m_p*zeta3_dot.powi(2) + alpha_M*m_p*(eta1_dot + a*(theta_c_dot + theta_dot/Z_r)).powi(2)
                + alpha_M*m_p*(eta2_dot + a*(theta_c_dot + theta_dot/Z_r)).powi(2)
                + alpha_M*m_p*(eta3_dot + a*(theta_c_dot + theta_dot/Z_r)).powi(2) + alpha_M*m_r*x_r_dot.powi(2)
                + alpha_M*m_r*y_r_dot.powi(2) + alpha_M*m_s*x_s_dot.powi(2) + alpha_M*m_s*y_s_dot.powi(2) + beta_K*k_r*twist_r_dot.powi(2)
                + beta_K*kb_c*bx_c_dot.powi(2) + beta_K*kb_c*by_c_dot.powi(2) + beta_K*kb_p*radial1_dot.powi(2)
                + beta_K*kb_p*radial2_dot.powi(2) + beta_K*kb_p*radial3_dot.powi(2) + beta_K*kb_p*tangential1_dot.powi(2)
                + beta_K*kb_p*tangential2_dot.powi(2) + beta_K*kb_p*tangential3_dot.powi(2) + beta_K*kb_r*bx_r_dot.powi(2)
                + beta_K*kb_r*by_r_dot.powi(2) + beta_K*kb_s*bx_s_dot.powi(2) + beta_K*kb_s*by_s_dot.powi(2)
                + beta_K*k_r1_mid*delta_r1_dot.powi(2) + beta_K*k_r2_mid*delta_r2_dot.powi(2) + beta_K*k_r3_mid*delta_r3_dot.powi(2)
                + beta_K*k_s1_mid*delta_s1_dot.powi(2) + beta_K*k_s2_mid*delta_s2_dot.powi(2) + beta_K*k_s3_mid*delta_s3_dot.powi(2))/2.0;
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
            _ => I_c/Z_r.powi(2) - 6.0*h*I_p/(r_p*Z_r) + 3.0*I_p/Z_r.powi(2) + I_s/Z_r.powi(2) + 2.0*I_s/(Z_r*Z_s) + I_s/Z_s.powi(2)
                + 3.0*a.powi(2)*m_p/Z_r.powi(2) + 3.0*h.powi(2)*I_p/r_p.powi(2);
        }
        theta theta_c { _ => I_c/Z_r - 3.0*h*I_p/r_p + 3.0*I_p/Z_r + I_s/Z_r + I_s/Z_s + 3.0*a.powi(2)*m_p/Z_r; }
        theta eta1 { _ => a*m_p/Z_r; }
        theta u1 { _ => I_p/(r_p*Z_r) - h*I_p/r_p.powi(2); }
        theta eta2 { _ => a*m_p/Z_r; }
        theta u2 { _ => I_p/(r_p*Z_r) - h*I_p/r_p.powi(2); }
        theta eta3 { _ => a*m_p/Z_r; }
        theta u3 { _ => I_p/(r_p*Z_r) - h*I_p/r_p.powi(2); }
        theta_c theta_c { _ => I_c + 3.0*I_p + I_s + 3.0*a.powi(2)*m_p; }
        theta_c eta1 { _ => a*m_p; }
        theta_c u1 { _ => I_p/r_p; }
        theta_c eta2 { _ => a*m_p; }
        theta_c u2 { _ => I_p/r_p; }
        theta_c eta3 { _ => a*m_p; }
        theta_c u3 { _ => I_p/r_p; }
        theta_r theta_r { _ => I_r; }
        x_s x_s { _ => m_s; }
        y_s y_s { _ => m_s; }
        x_c x_c { _ => m_c; }
        y_c y_c { _ => m_c; }
        x_r x_r { _ => m_r; }
        y_r y_r { _ => m_r; }
        zeta1 zeta1 { _ => m_p; }
        eta1 eta1 { _ => m_p; }
        u1 u1 { _ => I_p/r_p.powi(2); }
        zeta2 zeta2 { _ => m_p; }
        eta2 eta2 { _ => m_p; }
        u2 u2 { _ => I_p/r_p.powi(2); }
        zeta3 zeta3 { _ => m_p; }
        eta3 eta3 { _ => m_p; }
        u3 u3 { _ => I_p/r_p.powi(2); }
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
            torques => T_motor/Z_r - T_load/Z_r + T_motor/Z_s;
            damping => h*I_p*alpha_M*u1_dot/r_p.powi(2) - a*alpha_M*m_p*eta1_dot/Z_r - a*alpha_M*m_p*eta2_dot/Z_r
                - a*alpha_M*m_p*eta3_dot/Z_r + h*I_p*alpha_M*u2_dot/r_p.powi(2) + h*I_p*alpha_M*u3_dot/r_p.powi(2)
                + 3.0*h*I_p*alpha_M*theta_c_dot/r_p + 6.0*h*I_p*alpha_M*theta_dot/(r_p*Z_r) - I_c*alpha_M*theta_dot/Z_r.powi(2)
                - I_c*alpha_M*theta_c_dot/Z_r - 3.0*I_p*alpha_M*theta_dot/Z_r.powi(2) - 3.0*I_p*alpha_M*theta_c_dot/Z_r
                - I_s*alpha_M*theta_dot/Z_r.powi(2) - I_s*alpha_M*theta_c_dot/Z_r - 2.0*I_s*alpha_M*theta_dot/(Z_r*Z_s)
                - I_s*alpha_M*theta_dot/Z_s.powi(2) - I_s*alpha_M*theta_c_dot/Z_s - 3.0*a.powi(2)*alpha_M*m_p*theta_dot/Z_r.powi(2)
                - 3.0*a.powi(2)*alpha_M*m_p*theta_c_dot/Z_r - 3.0*h.powi(2)*I_p*alpha_M*theta_dot/r_p.powi(2)
                - I_p*alpha_M*u1_dot/(r_p*Z_r) - I_p*alpha_M*u2_dot/(r_p*Z_r) - I_p*alpha_M*u3_dot/(r_p*Z_r);
            jump_terms => (-dk_r1*delta_r1.powi(2) - dk_r2*delta_r2.powi(2) - dk_r3*delta_r3.powi(2) - dk_s1*delta_s1.powi(2)
                - dk_s2*delta_s2.powi(2) - dk_s3*delta_s3.powi(2))/2.0;
        }
        theta_c {
            _ => h*Z_r*k_r1*delta_r1 + h*Z_r*k_r2*delta_r2 + h*Z_r*k_r3*delta_r3;
            torsional_support_s => -k_s*twist_s;
            torsional_support_s_and_damping => -beta_K*k_s*twist_s_dot;
            torsional_support_c => -k_c*twist_c;
            torsional_support_c_and_damping => -beta_K*k_c*twist_c_dot;
            torques => T_motor - T_load;
            damping => h*Z_r*beta_K*k_r1_mid*delta_r1_dot - a*alpha_M*m_p*eta1_dot - a*alpha_M*m_p*eta2_dot - a*alpha_M*m_p*eta3_dot
                + h*Z_r*beta_K*k_r2_mid*delta_r2_dot + h*Z_r*beta_K*k_r3_mid*delta_r3_dot + 3.0*h*I_p*alpha_M*theta_dot/r_p
                - I_c*alpha_M*theta_c_dot - I_c*alpha_M*theta_dot/Z_r - 3.0*I_p*alpha_M*theta_c_dot - 3.0*I_p*alpha_M*theta_dot/Z_r
                - I_s*alpha_M*theta_c_dot - I_s*alpha_M*theta_dot/Z_r - I_s*alpha_M*theta_dot/Z_s - 3.0*a.powi(2)*alpha_M*m_p*theta_c_dot
                - 3.0*a.powi(2)*alpha_M*m_p*theta_dot/Z_r - I_p*alpha_M*u1_dot/r_p - I_p*alpha_M*u2_dot/r_p - I_p*alpha_M*u3_dot/r_p;
        }
        theta_r {
            _ => -h*Z_r*k_r1*delta_r1 - h*Z_r*k_r2*delta_r2 - h*Z_r*k_r3*delta_r3 - k_r*twist_r;
            damping => -h*Z_r*beta_K*k_r1_mid*delta_r1_dot - h*Z_r*beta_K*k_r2_mid*delta_r2_dot - h*Z_r*beta_K*k_r3_mid*delta_r3_dot
                - I_r*alpha_M*theta_r_dot - beta_K*k_r*twist_r_dot;
        }
        x_s {
            _ => sin_s1*k_s1*delta_s1 + sin_s2*k_s2*delta_s2 + sin_s3*k_s3*delta_s3 - kb_s*bx_s;
            viscous_friction_s => -cb_s*bx_s_dot;
            damping => sin_s1*beta_K*k_s1_mid*delta_s1_dot + sin_s2*beta_K*k_s2_mid*delta_s2_dot + sin_s3*beta_K*k_s3_mid*delta_s3_dot
                - alpha_M*m_s*x_s_dot - beta_K*kb_s*bx_s_dot;
        }
        y_s {
            _ => -cos_s1*k_s1*delta_s1 - cos_s2*k_s2*delta_s2 - cos_s3*k_s3*delta_s3 - kb_s*by_s;
            viscous_friction_s => -cb_s*by_s_dot;
            damping => -cos_s1*beta_K*k_s1_mid*delta_s1_dot - cos_s2*beta_K*k_s2_mid*delta_s2_dot - cos_s3*beta_K*k_s3_mid*delta_s3_dot
                - alpha_M*m_s*y_s_dot - beta_K*kb_s*by_s_dot;
        }
        x_c {
            _ => sin_c1*kb_p*tangential1 - cos_c1*kb_p*radial1 - cos_c2*kb_p*radial2 - cos_c3*kb_p*radial3 + sin_c2*kb_p*tangential2
                + sin_c3*kb_p*tangential3 - kb_c*bx_c;
            viscous_friction_c => -cb_c*bx_c_dot;
            viscous_friction_p => sin_c1*cb_p*tangential1_dot - cos_c1*cb_p*radial1_dot - cos_c2*cb_p*radial2_dot
                - cos_c3*cb_p*radial3_dot + sin_c2*cb_p*tangential2_dot + sin_c3*cb_p*tangential3_dot;
            damping => sin_c1*beta_K*kb_p*tangential1_dot - cos_c1*beta_K*kb_p*radial1_dot - cos_c2*beta_K*kb_p*radial2_dot
                - cos_c3*beta_K*kb_p*radial3_dot + sin_c2*beta_K*kb_p*tangential2_dot + sin_c3*beta_K*kb_p*tangential3_dot
                - alpha_M*m_c*x_c_dot - beta_K*kb_c*bx_c_dot;
        }
        y_c {
            _ => -cos_c1*kb_p*tangential1 - cos_c2*kb_p*tangential2 - cos_c3*kb_p*tangential3 - sin_c1*kb_p*radial1 - sin_c2*kb_p*radial2
                - sin_c3*kb_p*radial3 - kb_c*by_c;
            viscous_friction_c => -cb_c*by_c_dot;
            viscous_friction_p => -cos_c1*cb_p*tangential1_dot - cos_c2*cb_p*tangential2_dot - cos_c3*cb_p*tangential3_dot
                - sin_c1*cb_p*radial1_dot - sin_c2*cb_p*radial2_dot - sin_c3*cb_p*radial3_dot;
            damping => -cos_c1*beta_K*kb_p*tangential1_dot - cos_c2*beta_K*kb_p*tangential2_dot - cos_c3*beta_K*kb_p*tangential3_dot
                - sin_c1*beta_K*kb_p*radial1_dot - sin_c2*beta_K*kb_p*radial2_dot - sin_c3*beta_K*kb_p*radial3_dot - alpha_M*m_c*y_c_dot
                - beta_K*kb_c*by_c_dot;
        }
        x_r {
            _ => sin_r1*k_r1*delta_r1 + sin_r2*k_r2*delta_r2 + sin_r3*k_r3*delta_r3 - kb_r*bx_r;
            viscous_friction_r => -cb_r*bx_r_dot;
            damping => sin_r1*beta_K*k_r1_mid*delta_r1_dot + sin_r2*beta_K*k_r2_mid*delta_r2_dot + sin_r3*beta_K*k_r3_mid*delta_r3_dot
                - alpha_M*m_r*x_r_dot - beta_K*kb_r*bx_r_dot;
        }
        y_r {
            _ => -cos_r1*k_r1*delta_r1 - cos_r2*k_r2*delta_r2 - cos_r3*k_r3*delta_r3 - kb_r*by_r;
            viscous_friction_r => -cb_r*by_r_dot;
            damping => -cos_r1*beta_K*k_r1_mid*delta_r1_dot - cos_r2*beta_K*k_r2_mid*delta_r2_dot - cos_r3*beta_K*k_r3_mid*delta_r3_dot
                - alpha_M*m_r*y_r_dot - beta_K*kb_r*by_r_dot;
        }
        zeta1 {
            _ => sin_a*k_s1*delta_s1 - sin_a*k_r1*delta_r1 + kb_p*radial1;
            viscous_friction_p => cb_p*radial1_dot;
            damping => sin_a*beta_K*k_s1_mid*delta_s1_dot - sin_a*beta_K*k_r1_mid*delta_r1_dot - alpha_M*m_p*zeta1_dot
                + beta_K*kb_p*radial1_dot;
        }
        eta1 {
            _ => cos_a*k_r1*delta_r1 + cos_a*k_s1*delta_s1 + kb_p*tangential1;
            viscous_friction_p => cb_p*tangential1_dot;
            damping => cos_a*beta_K*k_r1_mid*delta_r1_dot - a*alpha_M*m_p*theta_c_dot - a*alpha_M*m_p*theta_dot/Z_r
                + cos_a*beta_K*k_s1_mid*delta_s1_dot - alpha_M*m_p*eta1_dot + beta_K*kb_p*tangential1_dot;
        }
        u1 {
            _ => k_r1*delta_r1 - k_s1*delta_s1;
            damping => h*I_p*alpha_M*theta_dot/r_p.powi(2) + beta_K*k_r1_mid*delta_r1_dot - beta_K*k_s1_mid*delta_s1_dot
                - I_p*alpha_M*u1_dot/r_p.powi(2) - I_p*alpha_M*theta_c_dot/r_p - I_p*alpha_M*theta_dot/(r_p*Z_r);
        }
        zeta2 {
            _ => sin_a*k_s2*delta_s2 - sin_a*k_r2*delta_r2 + kb_p*radial2;
            viscous_friction_p => cb_p*radial2_dot;
            damping => sin_a*beta_K*k_s2_mid*delta_s2_dot - sin_a*beta_K*k_r2_mid*delta_r2_dot - alpha_M*m_p*zeta2_dot
                + beta_K*kb_p*radial2_dot;
        }
        eta2 {
            _ => cos_a*k_r2*delta_r2 + cos_a*k_s2*delta_s2 + kb_p*tangential2;
            viscous_friction_p => cb_p*tangential2_dot;
            damping => cos_a*beta_K*k_r2_mid*delta_r2_dot - a*alpha_M*m_p*theta_c_dot - a*alpha_M*m_p*theta_dot/Z_r
                + cos_a*beta_K*k_s2_mid*delta_s2_dot - alpha_M*m_p*eta2_dot + beta_K*kb_p*tangential2_dot;
        }
        u2 {
            _ => k_r2*delta_r2 - k_s2*delta_s2;
            damping => h*I_p*alpha_M*theta_dot/r_p.powi(2) + beta_K*k_r2_mid*delta_r2_dot - beta_K*k_s2_mid*delta_s2_dot
                - I_p*alpha_M*u2_dot/r_p.powi(2) - I_p*alpha_M*theta_c_dot/r_p - I_p*alpha_M*theta_dot/(r_p*Z_r);
        }
        zeta3 {
            _ => sin_a*k_s3*delta_s3 - sin_a*k_r3*delta_r3 + kb_p*radial3;
            viscous_friction_p => cb_p*radial3_dot;
            damping => sin_a*beta_K*k_s3_mid*delta_s3_dot - sin_a*beta_K*k_r3_mid*delta_r3_dot - alpha_M*m_p*zeta3_dot
                + beta_K*kb_p*radial3_dot;
        }
        eta3 {
            _ => cos_a*k_r3*delta_r3 + cos_a*k_s3*delta_s3 + kb_p*tangential3;
            viscous_friction_p => cb_p*tangential3_dot;
            damping => cos_a*beta_K*k_r3_mid*delta_r3_dot - a*alpha_M*m_p*theta_c_dot - a*alpha_M*m_p*theta_dot/Z_r
                + cos_a*beta_K*k_s3_mid*delta_s3_dot - alpha_M*m_p*eta3_dot + beta_K*kb_p*tangential3_dot;
        }
        u3 {
            _ => k_r3*delta_r3 - k_s3*delta_s3;
            damping => h*I_p*alpha_M*theta_dot/r_p.powi(2) + beta_K*k_r3_mid*delta_r3_dot - beta_K*k_s3_mid*delta_s3_dot
                - I_p*alpha_M*u3_dot/r_p.powi(2) - I_p*alpha_M*theta_c_dot/r_p - I_p*alpha_M*theta_dot/(r_p*Z_r);
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
            jump_terms => (-ddk_r1*delta_r1.powi(2) - ddk_r2*delta_r2.powi(2) - ddk_r3*delta_r3.powi(2) - ddk_s1*delta_s1.powi(2)
                - ddk_s2*delta_s2.powi(2) - ddk_s3*delta_s3.powi(2))/2.0;
        }
        theta theta_c {
            torsional_support_s => -k_s/Z_r - k_s/Z_s;
            torsional_support_c => -k_c/Z_r;
            transmission_error_r1_and_jump_terms => -h*Z_r*k_r1*de_r1;
            transmission_error_r2_and_jump_terms => -h*Z_r*k_r2*de_r2;
            transmission_error_r3_and_jump_terms => -h*Z_r*k_r3*de_r3;
            jump_terms => h*Z_r*dk_r1*delta_r1 + h*Z_r*dk_r2*delta_r2 + h*Z_r*dk_r3*delta_r3;
        }
        theta theta_r {
            transmission_error_r1_and_jump_terms => h*Z_r*k_r1*de_r1;
            transmission_error_r2_and_jump_terms => h*Z_r*k_r2*de_r2;
            transmission_error_r3_and_jump_terms => h*Z_r*k_r3*de_r3;
            jump_terms => -h*Z_r*dk_r1*delta_r1 - h*Z_r*dk_r2*delta_r2 - h*Z_r*dk_r3*delta_r3;
        }
        theta x_s {
            transmission_error_s1_and_jump_terms => -sin_s1*k_s1*de_s1;
            transmission_error_s2_and_jump_terms => -sin_s2*k_s2*de_s2;
            transmission_error_s3_and_jump_terms => -sin_s3*k_s3*de_s3;
            jump_terms => sin_s1*dk_s1*delta_s1 + sin_s2*dk_s2*delta_s2 + sin_s3*dk_s3*delta_s3;
        }
        theta y_s {
            transmission_error_s1_and_jump_terms => cos_s1*k_s1*de_s1;
            transmission_error_s2_and_jump_terms => cos_s2*k_s2*de_s2;
            transmission_error_s3_and_jump_terms => cos_s3*k_s3*de_s3;
            jump_terms => -cos_s1*dk_s1*delta_s1 - cos_s2*dk_s2*delta_s2 - cos_s3*dk_s3*delta_s3;
        }
        theta x_r {
            transmission_error_r1_and_jump_terms => -sin_r1*k_r1*de_r1;
            transmission_error_r2_and_jump_terms => -sin_r2*k_r2*de_r2;
            transmission_error_r3_and_jump_terms => -sin_r3*k_r3*de_r3;
            jump_terms => sin_r1*dk_r1*delta_r1 + sin_r2*dk_r2*delta_r2 + sin_r3*dk_r3*delta_r3;
        }
        theta y_r {
            transmission_error_r1_and_jump_terms => cos_r1*k_r1*de_r1;
            transmission_error_r2_and_jump_terms => cos_r2*k_r2*de_r2;
            transmission_error_r3_and_jump_terms => cos_r3*k_r3*de_r3;
            jump_terms => -cos_r1*dk_r1*delta_r1 - cos_r2*dk_r2*delta_r2 - cos_r3*dk_r3*delta_r3;
        }
        theta zeta1 {
            transmission_error_s1_and_jump_terms => -sin_a*k_s1*de_s1;
            transmission_error_r1_and_jump_terms => sin_a*k_r1*de_r1;
            jump_terms => sin_a*dk_s1*delta_s1 - sin_a*dk_r1*delta_r1;
        }
        theta eta1 {
            transmission_error_s1_and_jump_terms => -cos_a*k_s1*de_s1;
            transmission_error_r1_and_jump_terms => -cos_a*k_r1*de_r1;
            jump_terms => cos_a*dk_r1*delta_r1 + cos_a*dk_s1*delta_s1;
        }
        theta u1 {
            transmission_error_s1_and_jump_terms => k_s1*de_s1;
            transmission_error_r1_and_jump_terms => -k_r1*de_r1;
            jump_terms => dk_r1*delta_r1 - dk_s1*delta_s1;
        }
        theta zeta2 {
            transmission_error_s2_and_jump_terms => -sin_a*k_s2*de_s2;
            transmission_error_r2_and_jump_terms => sin_a*k_r2*de_r2;
            jump_terms => sin_a*dk_s2*delta_s2 - sin_a*dk_r2*delta_r2;
        }
        theta eta2 {
            transmission_error_s2_and_jump_terms => -cos_a*k_s2*de_s2;
            transmission_error_r2_and_jump_terms => -cos_a*k_r2*de_r2;
            jump_terms => cos_a*dk_r2*delta_r2 + cos_a*dk_s2*delta_s2;
        }
        theta u2 {
            transmission_error_s2_and_jump_terms => k_s2*de_s2;
            transmission_error_r2_and_jump_terms => -k_r2*de_r2;
            jump_terms => dk_r2*delta_r2 - dk_s2*delta_s2;
        }
        theta zeta3 {
            transmission_error_s3_and_jump_terms => -sin_a*k_s3*de_s3;
            transmission_error_r3_and_jump_terms => sin_a*k_r3*de_r3;
            jump_terms => sin_a*dk_s3*delta_s3 - sin_a*dk_r3*delta_r3;
        }
        theta eta3 {
            transmission_error_s3_and_jump_terms => -cos_a*k_s3*de_s3;
            transmission_error_r3_and_jump_terms => -cos_a*k_r3*de_r3;
            jump_terms => cos_a*dk_r3*delta_r3 + cos_a*dk_s3*delta_s3;
        }
        theta u3 {
            transmission_error_s3_and_jump_terms => k_s3*de_s3;
            transmission_error_r3_and_jump_terms => -k_r3*de_r3;
            jump_terms => dk_r3*delta_r3 - dk_s3*delta_s3;
        }
        theta theta_dot {
            torsional_support_s_and_damping => -beta_K*k_s/Z_r.powi(2) - 2.0*beta_K*k_s/(Z_r*Z_s) - beta_K*k_s/Z_s.powi(2);
            torsional_support_c_and_damping => -beta_K*k_c/Z_r.powi(2);
            damping => 6.0*h*I_p*alpha_M/(r_p*Z_r) - I_c*alpha_M/Z_r.powi(2) - 3.0*I_p*alpha_M/Z_r.powi(2) - I_s*alpha_M/Z_r.powi(2)
                - 2.0*I_s*alpha_M/(Z_r*Z_s) - I_s*alpha_M/Z_s.powi(2) - 3.0*a.powi(2)*alpha_M*m_p/Z_r.powi(2)
                - 3.0*h.powi(2)*I_p*alpha_M/r_p.powi(2);
        }
        theta theta_c_dot {
            torsional_support_s_and_damping => -beta_K*k_s/Z_r - beta_K*k_s/Z_s;
            torsional_support_c_and_damping => -beta_K*k_c/Z_r;
            damping => 3.0*h*I_p*alpha_M/r_p - I_c*alpha_M/Z_r - 3.0*I_p*alpha_M/Z_r - I_s*alpha_M/Z_r - I_s*alpha_M/Z_s
                - 3.0*a.powi(2)*alpha_M*m_p/Z_r;
        }
        theta eta1_dot { damping => -a*alpha_M*m_p/Z_r; }
        theta u1_dot { damping => h*I_p*alpha_M/r_p.powi(2) - I_p*alpha_M/(r_p*Z_r); }
        theta eta2_dot { damping => -a*alpha_M*m_p/Z_r; }
        theta u2_dot { damping => h*I_p*alpha_M/r_p.powi(2) - I_p*alpha_M/(r_p*Z_r); }
        theta eta3_dot { damping => -a*alpha_M*m_p/Z_r; }
        theta u3_dot { damping => h*I_p*alpha_M/r_p.powi(2) - I_p*alpha_M/(r_p*Z_r); }
        theta_c theta {
            torsional_support_s => -k_s/Z_r - k_s/Z_s;
            torsional_support_c => -k_c/Z_r;
            transmission_error_r1_and_moving_phase => -h*Z_r*k_r1*de_r1;
            transmission_error_r2_and_moving_phase => -h*Z_r*k_r2*de_r2;
            transmission_error_r3_and_moving_phase => -h*Z_r*k_r3*de_r3;
            moving_phase => h*Z_r*dk_r1*delta_r1 + h*Z_r*dk_r2*delta_r2 + h*Z_r*dk_r3*delta_r3;
        }
        theta_c theta_c {
            _ => -h.powi(2)*Z_r.powi(2)*k_r1 - h.powi(2)*Z_r.powi(2)*k_r2 - h.powi(2)*Z_r.powi(2)*k_r3;
            torsional_support_s => -k_s;
            torsional_support_c => -k_c;
        }
        theta_c theta_r { _ => h.powi(2)*Z_r.powi(2)*k_r1 + h.powi(2)*Z_r.powi(2)*k_r2 + h.powi(2)*Z_r.powi(2)*k_r3; }
        theta_c x_r { _ => -h*sin_r1*Z_r*k_r1 - h*sin_r2*Z_r*k_r2 - h*sin_r3*Z_r*k_r3; }
        theta_c y_r { _ => cos_r1*h*Z_r*k_r1 + cos_r2*h*Z_r*k_r2 + cos_r3*h*Z_r*k_r3; }
        theta_c zeta1 { _ => h*sin_a*Z_r*k_r1; }
        theta_c eta1 { _ => -cos_a*h*Z_r*k_r1; }
        theta_c u1 { _ => -h*Z_r*k_r1; }
        theta_c zeta2 { _ => h*sin_a*Z_r*k_r2; }
        theta_c eta2 { _ => -cos_a*h*Z_r*k_r2; }
        theta_c u2 { _ => -h*Z_r*k_r2; }
        theta_c zeta3 { _ => h*sin_a*Z_r*k_r3; }
        theta_c eta3 { _ => -cos_a*h*Z_r*k_r3; }
        theta_c u3 { _ => -h*Z_r*k_r3; }
        theta_c theta_dot {
            torsional_support_s_and_damping => -beta_K*k_s/Z_r - beta_K*k_s/Z_s;
            torsional_support_c_and_damping => -beta_K*k_c/Z_r;
            damping => 3.0*h*I_p*alpha_M/r_p - I_c*alpha_M/Z_r - 3.0*I_p*alpha_M/Z_r - I_s*alpha_M/Z_r - I_s*alpha_M/Z_s
                - 3.0*a.powi(2)*alpha_M*m_p/Z_r;
        }
        theta_c theta_c_dot {
            torsional_support_s_and_damping => -beta_K*k_s;
            torsional_support_c_and_damping => -beta_K*k_c;
            damping => -I_c*alpha_M - 3.0*I_p*alpha_M - I_s*alpha_M - 3.0*a.powi(2)*alpha_M*m_p - h.powi(2)*Z_r.powi(2)*beta_K*k_r1_mid
                - h.powi(2)*Z_r.powi(2)*beta_K*k_r2_mid - h.powi(2)*Z_r.powi(2)*beta_K*k_r3_mid;
        }
        theta_c theta_r_dot {
            damping => h.powi(2)*Z_r.powi(2)*beta_K*k_r1_mid + h.powi(2)*Z_r.powi(2)*beta_K*k_r2_mid
                + h.powi(2)*Z_r.powi(2)*beta_K*k_r3_mid;
        }
        theta_c x_r_dot { damping => -h*sin_r1*Z_r*beta_K*k_r1_mid - h*sin_r2*Z_r*beta_K*k_r2_mid - h*sin_r3*Z_r*beta_K*k_r3_mid; }
        theta_c y_r_dot { damping => cos_r1*h*Z_r*beta_K*k_r1_mid + cos_r2*h*Z_r*beta_K*k_r2_mid + cos_r3*h*Z_r*beta_K*k_r3_mid; }
        theta_c zeta1_dot { damping => h*sin_a*Z_r*beta_K*k_r1_mid; }
        theta_c eta1_dot { damping => -a*alpha_M*m_p - cos_a*h*Z_r*beta_K*k_r1_mid; }
        theta_c u1_dot { damping => -h*Z_r*beta_K*k_r1_mid - I_p*alpha_M/r_p; }
        theta_c zeta2_dot { damping => h*sin_a*Z_r*beta_K*k_r2_mid; }
        theta_c eta2_dot { damping => -a*alpha_M*m_p - cos_a*h*Z_r*beta_K*k_r2_mid; }
        theta_c u2_dot { damping => -h*Z_r*beta_K*k_r2_mid - I_p*alpha_M/r_p; }
        theta_c zeta3_dot { damping => h*sin_a*Z_r*beta_K*k_r3_mid; }
        theta_c eta3_dot { damping => -a*alpha_M*m_p - cos_a*h*Z_r*beta_K*k_r3_mid; }
        theta_c u3_dot { damping => -h*Z_r*beta_K*k_r3_mid - I_p*alpha_M/r_p; }
        theta_r theta {
            transmission_error_r1_and_moving_phase => h*Z_r*k_r1*de_r1;
            transmission_error_r2_and_moving_phase => h*Z_r*k_r2*de_r2;
            transmission_error_r3_and_moving_phase => h*Z_r*k_r3*de_r3;
            moving_phase => -h*Z_r*dk_r1*delta_r1 - h*Z_r*dk_r2*delta_r2 - h*Z_r*dk_r3*delta_r3;
        }
        theta_r theta_c { _ => h.powi(2)*Z_r.powi(2)*k_r1 + h.powi(2)*Z_r.powi(2)*k_r2 + h.powi(2)*Z_r.powi(2)*k_r3; }
        theta_r theta_r { _ => -k_r - h.powi(2)*Z_r.powi(2)*k_r1 - h.powi(2)*Z_r.powi(2)*k_r2 - h.powi(2)*Z_r.powi(2)*k_r3; }
        theta_r x_r { _ => h*sin_r1*Z_r*k_r1 + h*sin_r2*Z_r*k_r2 + h*sin_r3*Z_r*k_r3; }
        theta_r y_r { _ => -cos_r1*h*Z_r*k_r1 - cos_r2*h*Z_r*k_r2 - cos_r3*h*Z_r*k_r3; }
        theta_r zeta1 { _ => -h*sin_a*Z_r*k_r1; }
        theta_r eta1 { _ => cos_a*h*Z_r*k_r1; }
        theta_r u1 { _ => h*Z_r*k_r1; }
        theta_r zeta2 { _ => -h*sin_a*Z_r*k_r2; }
        theta_r eta2 { _ => cos_a*h*Z_r*k_r2; }
        theta_r u2 { _ => h*Z_r*k_r2; }
        theta_r zeta3 { _ => -h*sin_a*Z_r*k_r3; }
        theta_r eta3 { _ => cos_a*h*Z_r*k_r3; }
        theta_r u3 { _ => h*Z_r*k_r3; }
        theta_r theta_c_dot {
            damping => h.powi(2)*Z_r.powi(2)*beta_K*k_r1_mid + h.powi(2)*Z_r.powi(2)*beta_K*k_r2_mid
                + h.powi(2)*Z_r.powi(2)*beta_K*k_r3_mid;
        }
        theta_r theta_r_dot {
            damping => -I_r*alpha_M - beta_K*k_r - h.powi(2)*Z_r.powi(2)*beta_K*k_r1_mid - h.powi(2)*Z_r.powi(2)*beta_K*k_r2_mid
                - h.powi(2)*Z_r.powi(2)*beta_K*k_r3_mid;
        }
        theta_r x_r_dot { damping => h*sin_r1*Z_r*beta_K*k_r1_mid + h*sin_r2*Z_r*beta_K*k_r2_mid + h*sin_r3*Z_r*beta_K*k_r3_mid; }
        theta_r y_r_dot { damping => -cos_r1*h*Z_r*beta_K*k_r1_mid - cos_r2*h*Z_r*beta_K*k_r2_mid - cos_r3*h*Z_r*beta_K*k_r3_mid; }
        theta_r zeta1_dot { damping => -h*sin_a*Z_r*beta_K*k_r1_mid; }
        theta_r eta1_dot { damping => cos_a*h*Z_r*beta_K*k_r1_mid; }
        theta_r u1_dot { damping => h*Z_r*beta_K*k_r1_mid; }
        theta_r zeta2_dot { damping => -h*sin_a*Z_r*beta_K*k_r2_mid; }
        theta_r eta2_dot { damping => cos_a*h*Z_r*beta_K*k_r2_mid; }
        theta_r u2_dot { damping => h*Z_r*beta_K*k_r2_mid; }
        theta_r zeta3_dot { damping => -h*sin_a*Z_r*beta_K*k_r3_mid; }
        theta_r eta3_dot { damping => cos_a*h*Z_r*beta_K*k_r3_mid; }
        theta_r u3_dot { damping => h*Z_r*beta_K*k_r3_mid; }
        x_s theta {
            transmission_error_s1_and_moving_phase => -sin_s1*k_s1*de_s1;
            transmission_error_s2_and_moving_phase => -sin_s2*k_s2*de_s2;
            transmission_error_s3_and_moving_phase => -sin_s3*k_s3*de_s3;
            moving_phase => sin_s1*dk_s1*delta_s1 + sin_s2*dk_s2*delta_s2 + sin_s3*dk_s3*delta_s3;
        }
        x_s x_s { _ => -kb_s - sin_s1.powi(2)*k_s1 - sin_s2.powi(2)*k_s2 - sin_s3.powi(2)*k_s3; }
        x_s y_s { _ => cos_s1*sin_s1*k_s1 + cos_s2*sin_s2*k_s2 + cos_s3*sin_s3*k_s3; }
        x_s zeta1 { _ => -sin_a*sin_s1*k_s1; }
        x_s eta1 { _ => -cos_a*sin_s1*k_s1; }
        x_s u1 { _ => sin_s1*k_s1; }
        x_s zeta2 { _ => -sin_a*sin_s2*k_s2; }
        x_s eta2 { _ => -cos_a*sin_s2*k_s2; }
        x_s u2 { _ => sin_s2*k_s2; }
        x_s zeta3 { _ => -sin_a*sin_s3*k_s3; }
        x_s eta3 { _ => -cos_a*sin_s3*k_s3; }
        x_s u3 { _ => sin_s3*k_s3; }
        x_s x_s_dot {
            viscous_friction_s => -cb_s;
            damping => -alpha_M*m_s - beta_K*kb_s - sin_s1.powi(2)*beta_K*k_s1_mid - sin_s2.powi(2)*beta_K*k_s2_mid
                - sin_s3.powi(2)*beta_K*k_s3_mid;
        }
        x_s y_s_dot { damping => cos_s1*sin_s1*beta_K*k_s1_mid + cos_s2*sin_s2*beta_K*k_s2_mid + cos_s3*sin_s3*beta_K*k_s3_mid; }
        x_s zeta1_dot { damping => -sin_a*sin_s1*beta_K*k_s1_mid; }
        x_s eta1_dot { damping => -cos_a*sin_s1*beta_K*k_s1_mid; }
        x_s u1_dot { damping => sin_s1*beta_K*k_s1_mid; }
        x_s zeta2_dot { damping => -sin_a*sin_s2*beta_K*k_s2_mid; }
        x_s eta2_dot { damping => -cos_a*sin_s2*beta_K*k_s2_mid; }
        x_s u2_dot { damping => sin_s2*beta_K*k_s2_mid; }
        x_s zeta3_dot { damping => -sin_a*sin_s3*beta_K*k_s3_mid; }
        x_s eta3_dot { damping => -cos_a*sin_s3*beta_K*k_s3_mid; }
        x_s u3_dot { damping => sin_s3*beta_K*k_s3_mid; }
        y_s theta {
            transmission_error_s1_and_moving_phase => cos_s1*k_s1*de_s1;
            transmission_error_s2_and_moving_phase => cos_s2*k_s2*de_s2;
            transmission_error_s3_and_moving_phase => cos_s3*k_s3*de_s3;
            moving_phase => -cos_s1*dk_s1*delta_s1 - cos_s2*dk_s2*delta_s2 - cos_s3*dk_s3*delta_s3;
        }
        y_s x_s { _ => cos_s1*sin_s1*k_s1 + cos_s2*sin_s2*k_s2 + cos_s3*sin_s3*k_s3; }
        y_s y_s { _ => -kb_s - cos_s1.powi(2)*k_s1 - cos_s2.powi(2)*k_s2 - cos_s3.powi(2)*k_s3; }
        y_s zeta1 { _ => cos_s1*sin_a*k_s1; }
        y_s eta1 { _ => cos_a*cos_s1*k_s1; }
        y_s u1 { _ => -cos_s1*k_s1; }
        y_s zeta2 { _ => cos_s2*sin_a*k_s2; }
        y_s eta2 { _ => cos_a*cos_s2*k_s2; }
        y_s u2 { _ => -cos_s2*k_s2; }
        y_s zeta3 { _ => cos_s3*sin_a*k_s3; }
        y_s eta3 { _ => cos_a*cos_s3*k_s3; }
        y_s u3 { _ => -cos_s3*k_s3; }
        y_s x_s_dot { damping => cos_s1*sin_s1*beta_K*k_s1_mid + cos_s2*sin_s2*beta_K*k_s2_mid + cos_s3*sin_s3*beta_K*k_s3_mid; }
        y_s y_s_dot {
            viscous_friction_s => -cb_s;
            damping => -alpha_M*m_s - beta_K*kb_s - cos_s1.powi(2)*beta_K*k_s1_mid - cos_s2.powi(2)*beta_K*k_s2_mid
                - cos_s3.powi(2)*beta_K*k_s3_mid;
        }
        y_s zeta1_dot { damping => cos_s1*sin_a*beta_K*k_s1_mid; }
        y_s eta1_dot { damping => cos_a*cos_s1*beta_K*k_s1_mid; }
        y_s u1_dot { damping => -cos_s1*beta_K*k_s1_mid; }
        y_s zeta2_dot { damping => cos_s2*sin_a*beta_K*k_s2_mid; }
        y_s eta2_dot { damping => cos_a*cos_s2*beta_K*k_s2_mid; }
        y_s u2_dot { damping => -cos_s2*beta_K*k_s2_mid; }
        y_s zeta3_dot { damping => cos_s3*sin_a*beta_K*k_s3_mid; }
        y_s eta3_dot { damping => cos_a*cos_s3*beta_K*k_s3_mid; }
        y_s u3_dot { damping => -cos_s3*beta_K*k_s3_mid; }
        x_c x_c {
            _ => -kb_c - cos_c1.powi(2)*kb_p - cos_c2.powi(2)*kb_p - cos_c3.powi(2)*kb_p - sin_c1.powi(2)*kb_p - sin_c2.powi(2)*kb_p
                - sin_c3.powi(2)*kb_p;
        }
        x_c zeta1 { _ => cos_c1*kb_p; }
        x_c eta1 { _ => -sin_c1*kb_p; }
        x_c zeta2 { _ => cos_c2*kb_p; }
        x_c eta2 { _ => -sin_c2*kb_p; }
        x_c zeta3 { _ => cos_c3*kb_p; }
        x_c eta3 { _ => -sin_c3*kb_p; }
        x_c x_c_dot {
            viscous_friction_c => -cb_c;
            viscous_friction_p => -cos_c1.powi(2)*cb_p - cos_c2.powi(2)*cb_p - cos_c3.powi(2)*cb_p - sin_c1.powi(2)*cb_p
                - sin_c2.powi(2)*cb_p - sin_c3.powi(2)*cb_p;
            damping => -alpha_M*m_c - beta_K*kb_c - cos_c1.powi(2)*beta_K*kb_p - cos_c2.powi(2)*beta_K*kb_p - cos_c3.powi(2)*beta_K*kb_p
                - sin_c1.powi(2)*beta_K*kb_p - sin_c2.powi(2)*beta_K*kb_p - sin_c3.powi(2)*beta_K*kb_p;
        }
        x_c zeta1_dot {
            viscous_friction_p => cos_c1*cb_p;
            damping => cos_c1*beta_K*kb_p;
        }
        x_c eta1_dot {
            viscous_friction_p => -sin_c1*cb_p;
            damping => -sin_c1*beta_K*kb_p;
        }
        x_c zeta2_dot {
            viscous_friction_p => cos_c2*cb_p;
            damping => cos_c2*beta_K*kb_p;
        }
        x_c eta2_dot {
            viscous_friction_p => -sin_c2*cb_p;
            damping => -sin_c2*beta_K*kb_p;
        }
        x_c zeta3_dot {
            viscous_friction_p => cos_c3*cb_p;
            damping => cos_c3*beta_K*kb_p;
        }
        x_c eta3_dot {
            viscous_friction_p => -sin_c3*cb_p;
            damping => -sin_c3*beta_K*kb_p;
        }
        y_c y_c {
            _ => -kb_c - cos_c1.powi(2)*kb_p - cos_c2.powi(2)*kb_p - cos_c3.powi(2)*kb_p - sin_c1.powi(2)*kb_p - sin_c2.powi(2)*kb_p
                - sin_c3.powi(2)*kb_p;
        }
        y_c zeta1 { _ => sin_c1*kb_p; }
        y_c eta1 { _ => cos_c1*kb_p; }
        y_c zeta2 { _ => sin_c2*kb_p; }
        y_c eta2 { _ => cos_c2*kb_p; }
        y_c zeta3 { _ => sin_c3*kb_p; }
        y_c eta3 { _ => cos_c3*kb_p; }
        y_c y_c_dot {
            viscous_friction_c => -cb_c;
            viscous_friction_p => -cos_c1.powi(2)*cb_p - cos_c2.powi(2)*cb_p - cos_c3.powi(2)*cb_p - sin_c1.powi(2)*cb_p
                - sin_c2.powi(2)*cb_p - sin_c3.powi(2)*cb_p;
            damping => -alpha_M*m_c - beta_K*kb_c - cos_c1.powi(2)*beta_K*kb_p - cos_c2.powi(2)*beta_K*kb_p - cos_c3.powi(2)*beta_K*kb_p
                - sin_c1.powi(2)*beta_K*kb_p - sin_c2.powi(2)*beta_K*kb_p - sin_c3.powi(2)*beta_K*kb_p;
        }
        y_c zeta1_dot {
            viscous_friction_p => sin_c1*cb_p;
            damping => sin_c1*beta_K*kb_p;
        }
        y_c eta1_dot {
            viscous_friction_p => cos_c1*cb_p;
            damping => cos_c1*beta_K*kb_p;
        }
        y_c zeta2_dot {
            viscous_friction_p => sin_c2*cb_p;
            damping => sin_c2*beta_K*kb_p;
        }
        y_c eta2_dot {
            viscous_friction_p => cos_c2*cb_p;
            damping => cos_c2*beta_K*kb_p;
        }
        y_c zeta3_dot {
            viscous_friction_p => sin_c3*cb_p;
            damping => sin_c3*beta_K*kb_p;
        }
        y_c eta3_dot {
            viscous_friction_p => cos_c3*cb_p;
            damping => cos_c3*beta_K*kb_p;
        }
        x_r theta {
            transmission_error_r1_and_moving_phase => -sin_r1*k_r1*de_r1;
            transmission_error_r2_and_moving_phase => -sin_r2*k_r2*de_r2;
            transmission_error_r3_and_moving_phase => -sin_r3*k_r3*de_r3;
            moving_phase => sin_r1*dk_r1*delta_r1 + sin_r2*dk_r2*delta_r2 + sin_r3*dk_r3*delta_r3;
        }
        x_r theta_c { _ => -h*sin_r1*Z_r*k_r1 - h*sin_r2*Z_r*k_r2 - h*sin_r3*Z_r*k_r3; }
        x_r theta_r { _ => h*sin_r1*Z_r*k_r1 + h*sin_r2*Z_r*k_r2 + h*sin_r3*Z_r*k_r3; }
        x_r x_r { _ => -kb_r - sin_r1.powi(2)*k_r1 - sin_r2.powi(2)*k_r2 - sin_r3.powi(2)*k_r3; }
        x_r y_r { _ => cos_r1*sin_r1*k_r1 + cos_r2*sin_r2*k_r2 + cos_r3*sin_r3*k_r3; }
        x_r zeta1 { _ => sin_a*sin_r1*k_r1; }
        x_r eta1 { _ => -cos_a*sin_r1*k_r1; }
        x_r u1 { _ => -sin_r1*k_r1; }
        x_r zeta2 { _ => sin_a*sin_r2*k_r2; }
        x_r eta2 { _ => -cos_a*sin_r2*k_r2; }
        x_r u2 { _ => -sin_r2*k_r2; }
        x_r zeta3 { _ => sin_a*sin_r3*k_r3; }
        x_r eta3 { _ => -cos_a*sin_r3*k_r3; }
        x_r u3 { _ => -sin_r3*k_r3; }
        x_r theta_c_dot { damping => -h*sin_r1*Z_r*beta_K*k_r1_mid - h*sin_r2*Z_r*beta_K*k_r2_mid - h*sin_r3*Z_r*beta_K*k_r3_mid; }
        x_r theta_r_dot { damping => h*sin_r1*Z_r*beta_K*k_r1_mid + h*sin_r2*Z_r*beta_K*k_r2_mid + h*sin_r3*Z_r*beta_K*k_r3_mid; }
        x_r x_r_dot {
            viscous_friction_r => -cb_r;
            damping => -alpha_M*m_r - beta_K*kb_r - sin_r1.powi(2)*beta_K*k_r1_mid - sin_r2.powi(2)*beta_K*k_r2_mid
                - sin_r3.powi(2)*beta_K*k_r3_mid;
        }
        x_r y_r_dot { damping => cos_r1*sin_r1*beta_K*k_r1_mid + cos_r2*sin_r2*beta_K*k_r2_mid + cos_r3*sin_r3*beta_K*k_r3_mid; }
        x_r zeta1_dot { damping => sin_a*sin_r1*beta_K*k_r1_mid; }
        x_r eta1_dot { damping => -cos_a*sin_r1*beta_K*k_r1_mid; }
        x_r u1_dot { damping => -sin_r1*beta_K*k_r1_mid; }
        x_r zeta2_dot { damping => sin_a*sin_r2*beta_K*k_r2_mid; }
        x_r eta2_dot { damping => -cos_a*sin_r2*beta_K*k_r2_mid; }
        x_r u2_dot { damping => -sin_r2*beta_K*k_r2_mid; }
        x_r zeta3_dot { damping => sin_a*sin_r3*beta_K*k_r3_mid; }
        x_r eta3_dot { damping => -cos_a*sin_r3*beta_K*k_r3_mid; }
        x_r u3_dot { damping => -sin_r3*beta_K*k_r3_mid; }
        y_r theta {
            transmission_error_r1_and_moving_phase => cos_r1*k_r1*de_r1;
            transmission_error_r2_and_moving_phase => cos_r2*k_r2*de_r2;
            transmission_error_r3_and_moving_phase => cos_r3*k_r3*de_r3;
            moving_phase => -cos_r1*dk_r1*delta_r1 - cos_r2*dk_r2*delta_r2 - cos_r3*dk_r3*delta_r3;
        }
        y_r theta_c { _ => cos_r1*h*Z_r*k_r1 + cos_r2*h*Z_r*k_r2 + cos_r3*h*Z_r*k_r3; }
        y_r theta_r { _ => -cos_r1*h*Z_r*k_r1 - cos_r2*h*Z_r*k_r2 - cos_r3*h*Z_r*k_r3; }
        y_r x_r { _ => cos_r1*sin_r1*k_r1 + cos_r2*sin_r2*k_r2 + cos_r3*sin_r3*k_r3; }
        y_r y_r { _ => -kb_r - cos_r1.powi(2)*k_r1 - cos_r2.powi(2)*k_r2 - cos_r3.powi(2)*k_r3; }
        y_r zeta1 { _ => -cos_r1*sin_a*k_r1; }
        y_r eta1 { _ => cos_a*cos_r1*k_r1; }
        y_r u1 { _ => cos_r1*k_r1; }
        y_r zeta2 { _ => -cos_r2*sin_a*k_r2; }
        y_r eta2 { _ => cos_a*cos_r2*k_r2; }
        y_r u2 { _ => cos_r2*k_r2; }
        y_r zeta3 { _ => -cos_r3*sin_a*k_r3; }
        y_r eta3 { _ => cos_a*cos_r3*k_r3; }
        y_r u3 { _ => cos_r3*k_r3; }
        y_r theta_c_dot { damping => cos_r1*h*Z_r*beta_K*k_r1_mid + cos_r2*h*Z_r*beta_K*k_r2_mid + cos_r3*h*Z_r*beta_K*k_r3_mid; }
        y_r theta_r_dot { damping => -cos_r1*h*Z_r*beta_K*k_r1_mid - cos_r2*h*Z_r*beta_K*k_r2_mid - cos_r3*h*Z_r*beta_K*k_r3_mid; }
        y_r x_r_dot { damping => cos_r1*sin_r1*beta_K*k_r1_mid + cos_r2*sin_r2*beta_K*k_r2_mid + cos_r3*sin_r3*beta_K*k_r3_mid; }
        y_r y_r_dot {
            viscous_friction_r => -cb_r;
            damping => -alpha_M*m_r - beta_K*kb_r - cos_r1.powi(2)*beta_K*k_r1_mid - cos_r2.powi(2)*beta_K*k_r2_mid
                - cos_r3.powi(2)*beta_K*k_r3_mid;
        }
        y_r zeta1_dot { damping => -cos_r1*sin_a*beta_K*k_r1_mid; }
        y_r eta1_dot { damping => cos_a*cos_r1*beta_K*k_r1_mid; }
        y_r u1_dot { damping => cos_r1*beta_K*k_r1_mid; }
        y_r zeta2_dot { damping => -cos_r2*sin_a*beta_K*k_r2_mid; }
        y_r eta2_dot { damping => cos_a*cos_r2*beta_K*k_r2_mid; }
        y_r u2_dot { damping => cos_r2*beta_K*k_r2_mid; }
        y_r zeta3_dot { damping => -cos_r3*sin_a*beta_K*k_r3_mid; }
        y_r eta3_dot { damping => cos_a*cos_r3*beta_K*k_r3_mid; }
        y_r u3_dot { damping => cos_r3*beta_K*k_r3_mid; }
        zeta1 theta {
            transmission_error_s1_and_moving_phase => -sin_a*k_s1*de_s1;
            transmission_error_r1_and_moving_phase => sin_a*k_r1*de_r1;
            moving_phase => sin_a*dk_s1*delta_s1 - sin_a*dk_r1*delta_r1;
        }
        zeta1 theta_c { _ => h*sin_a*Z_r*k_r1; }
        zeta1 theta_r { _ => -h*sin_a*Z_r*k_r1; }
        zeta1 x_s { _ => -sin_a*sin_s1*k_s1; }
        zeta1 y_s { _ => cos_s1*sin_a*k_s1; }
        zeta1 x_c { _ => cos_c1*kb_p; }
        zeta1 y_c { _ => sin_c1*kb_p; }
        zeta1 x_r { _ => sin_a*sin_r1*k_r1; }
        zeta1 y_r { _ => -cos_r1*sin_a*k_r1; }
        zeta1 zeta1 { _ => -kb_p - sin_a.powi(2)*k_r1 - sin_a.powi(2)*k_s1; }
        zeta1 eta1 { _ => cos_a*sin_a*k_r1 - cos_a*sin_a*k_s1; }
        zeta1 u1 { _ => sin_a*k_r1 + sin_a*k_s1; }
        zeta1 theta_c_dot { damping => h*sin_a*Z_r*beta_K*k_r1_mid; }
        zeta1 theta_r_dot { damping => -h*sin_a*Z_r*beta_K*k_r1_mid; }
        zeta1 x_s_dot { damping => -sin_a*sin_s1*beta_K*k_s1_mid; }
        zeta1 y_s_dot { damping => cos_s1*sin_a*beta_K*k_s1_mid; }
        zeta1 x_c_dot {
            viscous_friction_p => cos_c1*cb_p;
            damping => cos_c1*beta_K*kb_p;
        }
        zeta1 y_c_dot {
            viscous_friction_p => sin_c1*cb_p;
            damping => sin_c1*beta_K*kb_p;
        }
        zeta1 x_r_dot { damping => sin_a*sin_r1*beta_K*k_r1_mid; }
        zeta1 y_r_dot { damping => -cos_r1*sin_a*beta_K*k_r1_mid; }
        zeta1 zeta1_dot {
            viscous_friction_p => -cb_p;
            damping => -alpha_M*m_p - beta_K*kb_p - sin_a.powi(2)*beta_K*k_r1_mid - sin_a.powi(2)*beta_K*k_s1_mid;
        }
        zeta1 eta1_dot { damping => cos_a*sin_a*beta_K*k_r1_mid - cos_a*sin_a*beta_K*k_s1_mid; }
        zeta1 u1_dot { damping => sin_a*beta_K*k_r1_mid + sin_a*beta_K*k_s1_mid; }
        eta1 theta {
            transmission_error_s1_and_moving_phase => -cos_a*k_s1*de_s1;
            transmission_error_r1_and_moving_phase => -cos_a*k_r1*de_r1;
            moving_phase => cos_a*dk_r1*delta_r1 + cos_a*dk_s1*delta_s1;
        }
        eta1 theta_c { _ => -cos_a*h*Z_r*k_r1; }
        eta1 theta_r { _ => cos_a*h*Z_r*k_r1; }
        eta1 x_s { _ => -cos_a*sin_s1*k_s1; }
        eta1 y_s { _ => cos_a*cos_s1*k_s1; }
        eta1 x_c { _ => -sin_c1*kb_p; }
        eta1 y_c { _ => cos_c1*kb_p; }
        eta1 x_r { _ => -cos_a*sin_r1*k_r1; }
        eta1 y_r { _ => cos_a*cos_r1*k_r1; }
        eta1 zeta1 { _ => cos_a*sin_a*k_r1 - cos_a*sin_a*k_s1; }
        eta1 eta1 { _ => -kb_p - cos_a.powi(2)*k_r1 - cos_a.powi(2)*k_s1; }
        eta1 u1 { _ => cos_a*k_s1 - cos_a*k_r1; }
        eta1 theta_dot { damping => -a*alpha_M*m_p/Z_r; }
        eta1 theta_c_dot { damping => -a*alpha_M*m_p - cos_a*h*Z_r*beta_K*k_r1_mid; }
        eta1 theta_r_dot { damping => cos_a*h*Z_r*beta_K*k_r1_mid; }
        eta1 x_s_dot { damping => -cos_a*sin_s1*beta_K*k_s1_mid; }
        eta1 y_s_dot { damping => cos_a*cos_s1*beta_K*k_s1_mid; }
        eta1 x_c_dot {
            viscous_friction_p => -sin_c1*cb_p;
            damping => -sin_c1*beta_K*kb_p;
        }
        eta1 y_c_dot {
            viscous_friction_p => cos_c1*cb_p;
            damping => cos_c1*beta_K*kb_p;
        }
        eta1 x_r_dot { damping => -cos_a*sin_r1*beta_K*k_r1_mid; }
        eta1 y_r_dot { damping => cos_a*cos_r1*beta_K*k_r1_mid; }
        eta1 zeta1_dot { damping => cos_a*sin_a*beta_K*k_r1_mid - cos_a*sin_a*beta_K*k_s1_mid; }
        eta1 eta1_dot {
            viscous_friction_p => -cb_p;
            damping => -alpha_M*m_p - beta_K*kb_p - cos_a.powi(2)*beta_K*k_r1_mid - cos_a.powi(2)*beta_K*k_s1_mid;
        }
        eta1 u1_dot { damping => cos_a*beta_K*k_s1_mid - cos_a*beta_K*k_r1_mid; }
        u1 theta {
            transmission_error_s1_and_moving_phase => k_s1*de_s1;
            transmission_error_r1_and_moving_phase => -k_r1*de_r1;
            moving_phase => dk_r1*delta_r1 - dk_s1*delta_s1;
        }
        u1 theta_c { _ => -h*Z_r*k_r1; }
        u1 theta_r { _ => h*Z_r*k_r1; }
        u1 x_s { _ => sin_s1*k_s1; }
        u1 y_s { _ => -cos_s1*k_s1; }
        u1 x_r { _ => -sin_r1*k_r1; }
        u1 y_r { _ => cos_r1*k_r1; }
        u1 zeta1 { _ => sin_a*k_r1 + sin_a*k_s1; }
        u1 eta1 { _ => cos_a*k_s1 - cos_a*k_r1; }
        u1 u1 { _ => -k_r1 - k_s1; }
        u1 theta_dot { damping => h*I_p*alpha_M/r_p.powi(2) - I_p*alpha_M/(r_p*Z_r); }
        u1 theta_c_dot { damping => -h*Z_r*beta_K*k_r1_mid - I_p*alpha_M/r_p; }
        u1 theta_r_dot { damping => h*Z_r*beta_K*k_r1_mid; }
        u1 x_s_dot { damping => sin_s1*beta_K*k_s1_mid; }
        u1 y_s_dot { damping => -cos_s1*beta_K*k_s1_mid; }
        u1 x_r_dot { damping => -sin_r1*beta_K*k_r1_mid; }
        u1 y_r_dot { damping => cos_r1*beta_K*k_r1_mid; }
        u1 zeta1_dot { damping => sin_a*beta_K*k_r1_mid + sin_a*beta_K*k_s1_mid; }
        u1 eta1_dot { damping => cos_a*beta_K*k_s1_mid - cos_a*beta_K*k_r1_mid; }
        u1 u1_dot { damping => -beta_K*k_r1_mid - beta_K*k_s1_mid - I_p*alpha_M/r_p.powi(2); }
        zeta2 theta {
            transmission_error_s2_and_moving_phase => -sin_a*k_s2*de_s2;
            transmission_error_r2_and_moving_phase => sin_a*k_r2*de_r2;
            moving_phase => sin_a*dk_s2*delta_s2 - sin_a*dk_r2*delta_r2;
        }
        zeta2 theta_c { _ => h*sin_a*Z_r*k_r2; }
        zeta2 theta_r { _ => -h*sin_a*Z_r*k_r2; }
        zeta2 x_s { _ => -sin_a*sin_s2*k_s2; }
        zeta2 y_s { _ => cos_s2*sin_a*k_s2; }
        zeta2 x_c { _ => cos_c2*kb_p; }
        zeta2 y_c { _ => sin_c2*kb_p; }
        zeta2 x_r { _ => sin_a*sin_r2*k_r2; }
        zeta2 y_r { _ => -cos_r2*sin_a*k_r2; }
        zeta2 zeta2 { _ => -kb_p - sin_a.powi(2)*k_r2 - sin_a.powi(2)*k_s2; }
        zeta2 eta2 { _ => cos_a*sin_a*k_r2 - cos_a*sin_a*k_s2; }
        zeta2 u2 { _ => sin_a*k_r2 + sin_a*k_s2; }
        zeta2 theta_c_dot { damping => h*sin_a*Z_r*beta_K*k_r2_mid; }
        zeta2 theta_r_dot { damping => -h*sin_a*Z_r*beta_K*k_r2_mid; }
        zeta2 x_s_dot { damping => -sin_a*sin_s2*beta_K*k_s2_mid; }
        zeta2 y_s_dot { damping => cos_s2*sin_a*beta_K*k_s2_mid; }
        zeta2 x_c_dot {
            viscous_friction_p => cos_c2*cb_p;
            damping => cos_c2*beta_K*kb_p;
        }
        zeta2 y_c_dot {
            viscous_friction_p => sin_c2*cb_p;
            damping => sin_c2*beta_K*kb_p;
        }
        zeta2 x_r_dot { damping => sin_a*sin_r2*beta_K*k_r2_mid; }
        zeta2 y_r_dot { damping => -cos_r2*sin_a*beta_K*k_r2_mid; }
        zeta2 zeta2_dot {
            viscous_friction_p => -cb_p;
            damping => -alpha_M*m_p - beta_K*kb_p - sin_a.powi(2)*beta_K*k_r2_mid - sin_a.powi(2)*beta_K*k_s2_mid;
        }
        zeta2 eta2_dot { damping => cos_a*sin_a*beta_K*k_r2_mid - cos_a*sin_a*beta_K*k_s2_mid; }
        zeta2 u2_dot { damping => sin_a*beta_K*k_r2_mid + sin_a*beta_K*k_s2_mid; }
        eta2 theta {
            transmission_error_s2_and_moving_phase => -cos_a*k_s2*de_s2;
            transmission_error_r2_and_moving_phase => -cos_a*k_r2*de_r2;
            moving_phase => cos_a*dk_r2*delta_r2 + cos_a*dk_s2*delta_s2;
        }
        eta2 theta_c { _ => -cos_a*h*Z_r*k_r2; }
        eta2 theta_r { _ => cos_a*h*Z_r*k_r2; }
        eta2 x_s { _ => -cos_a*sin_s2*k_s2; }
        eta2 y_s { _ => cos_a*cos_s2*k_s2; }
        eta2 x_c { _ => -sin_c2*kb_p; }
        eta2 y_c { _ => cos_c2*kb_p; }
        eta2 x_r { _ => -cos_a*sin_r2*k_r2; }
        eta2 y_r { _ => cos_a*cos_r2*k_r2; }
        eta2 zeta2 { _ => cos_a*sin_a*k_r2 - cos_a*sin_a*k_s2; }
        eta2 eta2 { _ => -kb_p - cos_a.powi(2)*k_r2 - cos_a.powi(2)*k_s2; }
        eta2 u2 { _ => cos_a*k_s2 - cos_a*k_r2; }
        eta2 theta_dot { damping => -a*alpha_M*m_p/Z_r; }
        eta2 theta_c_dot { damping => -a*alpha_M*m_p - cos_a*h*Z_r*beta_K*k_r2_mid; }
        eta2 theta_r_dot { damping => cos_a*h*Z_r*beta_K*k_r2_mid; }
        eta2 x_s_dot { damping => -cos_a*sin_s2*beta_K*k_s2_mid; }
        eta2 y_s_dot { damping => cos_a*cos_s2*beta_K*k_s2_mid; }
        eta2 x_c_dot {
            viscous_friction_p => -sin_c2*cb_p;
            damping => -sin_c2*beta_K*kb_p;
        }
        eta2 y_c_dot {
            viscous_friction_p => cos_c2*cb_p;
            damping => cos_c2*beta_K*kb_p;
        }
        eta2 x_r_dot { damping => -cos_a*sin_r2*beta_K*k_r2_mid; }
        eta2 y_r_dot { damping => cos_a*cos_r2*beta_K*k_r2_mid; }
        eta2 zeta2_dot { damping => cos_a*sin_a*beta_K*k_r2_mid - cos_a*sin_a*beta_K*k_s2_mid; }
        eta2 eta2_dot {
            viscous_friction_p => -cb_p;
            damping => -alpha_M*m_p - beta_K*kb_p - cos_a.powi(2)*beta_K*k_r2_mid - cos_a.powi(2)*beta_K*k_s2_mid;
        }
        eta2 u2_dot { damping => cos_a*beta_K*k_s2_mid - cos_a*beta_K*k_r2_mid; }
        u2 theta {
            transmission_error_s2_and_moving_phase => k_s2*de_s2;
            transmission_error_r2_and_moving_phase => -k_r2*de_r2;
            moving_phase => dk_r2*delta_r2 - dk_s2*delta_s2;
        }
        u2 theta_c { _ => -h*Z_r*k_r2; }
        u2 theta_r { _ => h*Z_r*k_r2; }
        u2 x_s { _ => sin_s2*k_s2; }
        u2 y_s { _ => -cos_s2*k_s2; }
        u2 x_r { _ => -sin_r2*k_r2; }
        u2 y_r { _ => cos_r2*k_r2; }
        u2 zeta2 { _ => sin_a*k_r2 + sin_a*k_s2; }
        u2 eta2 { _ => cos_a*k_s2 - cos_a*k_r2; }
        u2 u2 { _ => -k_r2 - k_s2; }
        u2 theta_dot { damping => h*I_p*alpha_M/r_p.powi(2) - I_p*alpha_M/(r_p*Z_r); }
        u2 theta_c_dot { damping => -h*Z_r*beta_K*k_r2_mid - I_p*alpha_M/r_p; }
        u2 theta_r_dot { damping => h*Z_r*beta_K*k_r2_mid; }
        u2 x_s_dot { damping => sin_s2*beta_K*k_s2_mid; }
        u2 y_s_dot { damping => -cos_s2*beta_K*k_s2_mid; }
        u2 x_r_dot { damping => -sin_r2*beta_K*k_r2_mid; }
        u2 y_r_dot { damping => cos_r2*beta_K*k_r2_mid; }
        u2 zeta2_dot { damping => sin_a*beta_K*k_r2_mid + sin_a*beta_K*k_s2_mid; }
        u2 eta2_dot { damping => cos_a*beta_K*k_s2_mid - cos_a*beta_K*k_r2_mid; }
        u2 u2_dot { damping => -beta_K*k_r2_mid - beta_K*k_s2_mid - I_p*alpha_M/r_p.powi(2); }
        zeta3 theta {
            transmission_error_s3_and_moving_phase => -sin_a*k_s3*de_s3;
            transmission_error_r3_and_moving_phase => sin_a*k_r3*de_r3;
            moving_phase => sin_a*dk_s3*delta_s3 - sin_a*dk_r3*delta_r3;
        }
        zeta3 theta_c { _ => h*sin_a*Z_r*k_r3; }
        zeta3 theta_r { _ => -h*sin_a*Z_r*k_r3; }
        zeta3 x_s { _ => -sin_a*sin_s3*k_s3; }
        zeta3 y_s { _ => cos_s3*sin_a*k_s3; }
        zeta3 x_c { _ => cos_c3*kb_p; }
        zeta3 y_c { _ => sin_c3*kb_p; }
        zeta3 x_r { _ => sin_a*sin_r3*k_r3; }
        zeta3 y_r { _ => -cos_r3*sin_a*k_r3; }
        zeta3 zeta3 { _ => -kb_p - sin_a.powi(2)*k_r3 - sin_a.powi(2)*k_s3; }
        zeta3 eta3 { _ => cos_a*sin_a*k_r3 - cos_a*sin_a*k_s3; }
        zeta3 u3 { _ => sin_a*k_r3 + sin_a*k_s3; }
        zeta3 theta_c_dot { damping => h*sin_a*Z_r*beta_K*k_r3_mid; }
        zeta3 theta_r_dot { damping => -h*sin_a*Z_r*beta_K*k_r3_mid; }
        zeta3 x_s_dot { damping => -sin_a*sin_s3*beta_K*k_s3_mid; }
        zeta3 y_s_dot { damping => cos_s3*sin_a*beta_K*k_s3_mid; }
        zeta3 x_c_dot {
            viscous_friction_p => cos_c3*cb_p;
            damping => cos_c3*beta_K*kb_p;
        }
        zeta3 y_c_dot {
            viscous_friction_p => sin_c3*cb_p;
            damping => sin_c3*beta_K*kb_p;
        }
        zeta3 x_r_dot { damping => sin_a*sin_r3*beta_K*k_r3_mid; }
        zeta3 y_r_dot { damping => -cos_r3*sin_a*beta_K*k_r3_mid; }
        zeta3 zeta3_dot {
            viscous_friction_p => -cb_p;
            damping => -alpha_M*m_p - beta_K*kb_p - sin_a.powi(2)*beta_K*k_r3_mid - sin_a.powi(2)*beta_K*k_s3_mid;
        }
        zeta3 eta3_dot { damping => cos_a*sin_a*beta_K*k_r3_mid - cos_a*sin_a*beta_K*k_s3_mid; }
        zeta3 u3_dot { damping => sin_a*beta_K*k_r3_mid + sin_a*beta_K*k_s3_mid; }
        eta3 theta {
            transmission_error_s3_and_moving_phase => -cos_a*k_s3*de_s3;
            transmission_error_r3_and_moving_phase => -cos_a*k_r3*de_r3;
            moving_phase => cos_a*dk_r3*delta_r3 + cos_a*dk_s3*delta_s3;
        }
        eta3 theta_c { _ => -cos_a*h*Z_r*k_r3; }
        eta3 theta_r { _ => cos_a*h*Z_r*k_r3; }
        eta3 x_s { _ => -cos_a*sin_s3*k_s3; }
        eta3 y_s { _ => cos_a*cos_s3*k_s3; }
        eta3 x_c { _ => -sin_c3*kb_p; }
        eta3 y_c { _ => cos_c3*kb_p; }
        eta3 x_r { _ => -cos_a*sin_r3*k_r3; }
        eta3 y_r { _ => cos_a*cos_r3*k_r3; }
        eta3 zeta3 { _ => cos_a*sin_a*k_r3 - cos_a*sin_a*k_s3; }
        eta3 eta3 { _ => -kb_p - cos_a.powi(2)*k_r3 - cos_a.powi(2)*k_s3; }
        eta3 u3 { _ => cos_a*k_s3 - cos_a*k_r3; }
        eta3 theta_dot { damping => -a*alpha_M*m_p/Z_r; }
        eta3 theta_c_dot { damping => -a*alpha_M*m_p - cos_a*h*Z_r*beta_K*k_r3_mid; }
        eta3 theta_r_dot { damping => cos_a*h*Z_r*beta_K*k_r3_mid; }
        eta3 x_s_dot { damping => -cos_a*sin_s3*beta_K*k_s3_mid; }
        eta3 y_s_dot { damping => cos_a*cos_s3*beta_K*k_s3_mid; }
        eta3 x_c_dot {
            viscous_friction_p => -sin_c3*cb_p;
            damping => -sin_c3*beta_K*kb_p;
        }
        eta3 y_c_dot {
            viscous_friction_p => cos_c3*cb_p;
            damping => cos_c3*beta_K*kb_p;
        }
        eta3 x_r_dot { damping => -cos_a*sin_r3*beta_K*k_r3_mid; }
        eta3 y_r_dot { damping => cos_a*cos_r3*beta_K*k_r3_mid; }
        eta3 zeta3_dot { damping => cos_a*sin_a*beta_K*k_r3_mid - cos_a*sin_a*beta_K*k_s3_mid; }
        eta3 eta3_dot {
            viscous_friction_p => -cb_p;
            damping => -alpha_M*m_p - beta_K*kb_p - cos_a.powi(2)*beta_K*k_r3_mid - cos_a.powi(2)*beta_K*k_s3_mid;
        }
        eta3 u3_dot { damping => cos_a*beta_K*k_s3_mid - cos_a*beta_K*k_r3_mid; }
        u3 theta {
            transmission_error_s3_and_moving_phase => k_s3*de_s3;
            transmission_error_r3_and_moving_phase => -k_r3*de_r3;
            moving_phase => dk_r3*delta_r3 - dk_s3*delta_s3;
        }
        u3 theta_c { _ => -h*Z_r*k_r3; }
        u3 theta_r { _ => h*Z_r*k_r3; }
        u3 x_s { _ => sin_s3*k_s3; }
        u3 y_s { _ => -cos_s3*k_s3; }
        u3 x_r { _ => -sin_r3*k_r3; }
        u3 y_r { _ => cos_r3*k_r3; }
        u3 zeta3 { _ => sin_a*k_r3 + sin_a*k_s3; }
        u3 eta3 { _ => cos_a*k_s3 - cos_a*k_r3; }
        u3 u3 { _ => -k_r3 - k_s3; }
        u3 theta_dot { damping => h*I_p*alpha_M/r_p.powi(2) - I_p*alpha_M/(r_p*Z_r); }
        u3 theta_c_dot { damping => -h*Z_r*beta_K*k_r3_mid - I_p*alpha_M/r_p; }
        u3 theta_r_dot { damping => h*Z_r*beta_K*k_r3_mid; }
        u3 x_s_dot { damping => sin_s3*beta_K*k_s3_mid; }
        u3 y_s_dot { damping => -cos_s3*beta_K*k_s3_mid; }
        u3 x_r_dot { damping => -sin_r3*beta_K*k_r3_mid; }
        u3 y_r_dot { damping => cos_r3*beta_K*k_r3_mid; }
        u3 zeta3_dot { damping => sin_a*beta_K*k_r3_mid + sin_a*beta_K*k_s3_mid; }
        u3 eta3_dot { damping => cos_a*beta_K*k_s3_mid - cos_a*beta_K*k_r3_mid; }
        u3 u3_dot { damping => -beta_K*k_r3_mid - beta_K*k_s3_mid - I_p*alpha_M/r_p.powi(2); }
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
                _ => h.powi(2)*Z_r.powi(2)*k_r1 + h.powi(2)*Z_r.powi(2)*k_r2 + h.powi(2)*Z_r.powi(2)*k_r3;
                torsional_support_s => k_s;
                torsional_support_c => k_c;
            }
            theta_c theta_r { _ => -h.powi(2)*Z_r.powi(2)*k_r1 - h.powi(2)*Z_r.powi(2)*k_r2 - h.powi(2)*Z_r.powi(2)*k_r3; }
            theta_c x_r { _ => h*sin_r1*Z_r*k_r1 + h*sin_r2*Z_r*k_r2 + h*sin_r3*Z_r*k_r3; }
            theta_c y_r { _ => -cos_r1*h*Z_r*k_r1 - cos_r2*h*Z_r*k_r2 - cos_r3*h*Z_r*k_r3; }
            theta_c zeta1 { _ => -h*sin_a*Z_r*k_r1; }
            theta_c eta1 { _ => cos_a*h*Z_r*k_r1; }
            theta_c u1 { _ => h*Z_r*k_r1; }
            theta_c zeta2 { _ => -h*sin_a*Z_r*k_r2; }
            theta_c eta2 { _ => cos_a*h*Z_r*k_r2; }
            theta_c u2 { _ => h*Z_r*k_r2; }
            theta_c zeta3 { _ => -h*sin_a*Z_r*k_r3; }
            theta_c eta3 { _ => cos_a*h*Z_r*k_r3; }
            theta_c u3 { _ => h*Z_r*k_r3; }
            theta_r theta_r { _ => k_r + h.powi(2)*Z_r.powi(2)*k_r1 + h.powi(2)*Z_r.powi(2)*k_r2 + h.powi(2)*Z_r.powi(2)*k_r3; }
            theta_r x_r { _ => -h*sin_r1*Z_r*k_r1 - h*sin_r2*Z_r*k_r2 - h*sin_r3*Z_r*k_r3; }
            theta_r y_r { _ => cos_r1*h*Z_r*k_r1 + cos_r2*h*Z_r*k_r2 + cos_r3*h*Z_r*k_r3; }
            theta_r zeta1 { _ => h*sin_a*Z_r*k_r1; }
            theta_r eta1 { _ => -cos_a*h*Z_r*k_r1; }
            theta_r u1 { _ => -h*Z_r*k_r1; }
            theta_r zeta2 { _ => h*sin_a*Z_r*k_r2; }
            theta_r eta2 { _ => -cos_a*h*Z_r*k_r2; }
            theta_r u2 { _ => -h*Z_r*k_r2; }
            theta_r zeta3 { _ => h*sin_a*Z_r*k_r3; }
            theta_r eta3 { _ => -cos_a*h*Z_r*k_r3; }
            theta_r u3 { _ => -h*Z_r*k_r3; }
            x_s x_s { _ => kb_s + sin_s1.powi(2)*k_s1 + sin_s2.powi(2)*k_s2 + sin_s3.powi(2)*k_s3; }
            x_s y_s { _ => -cos_s1*sin_s1*k_s1 - cos_s2*sin_s2*k_s2 - cos_s3*sin_s3*k_s3; }
            x_s zeta1 { _ => sin_a*sin_s1*k_s1; }
            x_s eta1 { _ => cos_a*sin_s1*k_s1; }
            x_s u1 { _ => -sin_s1*k_s1; }
            x_s zeta2 { _ => sin_a*sin_s2*k_s2; }
            x_s eta2 { _ => cos_a*sin_s2*k_s2; }
            x_s u2 { _ => -sin_s2*k_s2; }
            x_s zeta3 { _ => sin_a*sin_s3*k_s3; }
            x_s eta3 { _ => cos_a*sin_s3*k_s3; }
            x_s u3 { _ => -sin_s3*k_s3; }
            y_s y_s { _ => kb_s + cos_s1.powi(2)*k_s1 + cos_s2.powi(2)*k_s2 + cos_s3.powi(2)*k_s3; }
            y_s zeta1 { _ => -cos_s1*sin_a*k_s1; }
            y_s eta1 { _ => -cos_a*cos_s1*k_s1; }
            y_s u1 { _ => cos_s1*k_s1; }
            y_s zeta2 { _ => -cos_s2*sin_a*k_s2; }
            y_s eta2 { _ => -cos_a*cos_s2*k_s2; }
            y_s u2 { _ => cos_s2*k_s2; }
            y_s zeta3 { _ => -cos_s3*sin_a*k_s3; }
            y_s eta3 { _ => -cos_a*cos_s3*k_s3; }
            y_s u3 { _ => cos_s3*k_s3; }
            x_c x_c {
                _ => kb_c + cos_c1.powi(2)*kb_p + cos_c2.powi(2)*kb_p + cos_c3.powi(2)*kb_p + sin_c1.powi(2)*kb_p + sin_c2.powi(2)*kb_p
                    + sin_c3.powi(2)*kb_p;
            }
            x_c zeta1 { _ => -cos_c1*kb_p; }
            x_c eta1 { _ => sin_c1*kb_p; }
            x_c zeta2 { _ => -cos_c2*kb_p; }
            x_c eta2 { _ => sin_c2*kb_p; }
            x_c zeta3 { _ => -cos_c3*kb_p; }
            x_c eta3 { _ => sin_c3*kb_p; }
            y_c y_c {
                _ => kb_c + cos_c1.powi(2)*kb_p + cos_c2.powi(2)*kb_p + cos_c3.powi(2)*kb_p + sin_c1.powi(2)*kb_p + sin_c2.powi(2)*kb_p
                    + sin_c3.powi(2)*kb_p;
            }
            y_c zeta1 { _ => -sin_c1*kb_p; }
            y_c eta1 { _ => -cos_c1*kb_p; }
            y_c zeta2 { _ => -sin_c2*kb_p; }
            y_c eta2 { _ => -cos_c2*kb_p; }
            y_c zeta3 { _ => -sin_c3*kb_p; }
            y_c eta3 { _ => -cos_c3*kb_p; }
            x_r x_r { _ => kb_r + sin_r1.powi(2)*k_r1 + sin_r2.powi(2)*k_r2 + sin_r3.powi(2)*k_r3; }
            x_r y_r { _ => -cos_r1*sin_r1*k_r1 - cos_r2*sin_r2*k_r2 - cos_r3*sin_r3*k_r3; }
            x_r zeta1 { _ => -sin_a*sin_r1*k_r1; }
            x_r eta1 { _ => cos_a*sin_r1*k_r1; }
            x_r u1 { _ => sin_r1*k_r1; }
            x_r zeta2 { _ => -sin_a*sin_r2*k_r2; }
            x_r eta2 { _ => cos_a*sin_r2*k_r2; }
            x_r u2 { _ => sin_r2*k_r2; }
            x_r zeta3 { _ => -sin_a*sin_r3*k_r3; }
            x_r eta3 { _ => cos_a*sin_r3*k_r3; }
            x_r u3 { _ => sin_r3*k_r3; }
            y_r y_r { _ => kb_r + cos_r1.powi(2)*k_r1 + cos_r2.powi(2)*k_r2 + cos_r3.powi(2)*k_r3; }
            y_r zeta1 { _ => cos_r1*sin_a*k_r1; }
            y_r eta1 { _ => -cos_a*cos_r1*k_r1; }
            y_r u1 { _ => -cos_r1*k_r1; }
            y_r zeta2 { _ => cos_r2*sin_a*k_r2; }
            y_r eta2 { _ => -cos_a*cos_r2*k_r2; }
            y_r u2 { _ => -cos_r2*k_r2; }
            y_r zeta3 { _ => cos_r3*sin_a*k_r3; }
            y_r eta3 { _ => -cos_a*cos_r3*k_r3; }
            y_r u3 { _ => -cos_r3*k_r3; }
            zeta1 zeta1 { _ => kb_p + sin_a.powi(2)*k_r1 + sin_a.powi(2)*k_s1; }
            zeta1 eta1 { _ => cos_a*sin_a*k_s1 - cos_a*sin_a*k_r1; }
            zeta1 u1 { _ => -sin_a*k_r1 - sin_a*k_s1; }
            eta1 eta1 { _ => kb_p + cos_a.powi(2)*k_r1 + cos_a.powi(2)*k_s1; }
            eta1 u1 { _ => cos_a*k_r1 - cos_a*k_s1; }
            u1 u1 { _ => k_r1 + k_s1; }
            zeta2 zeta2 { _ => kb_p + sin_a.powi(2)*k_r2 + sin_a.powi(2)*k_s2; }
            zeta2 eta2 { _ => cos_a*sin_a*k_s2 - cos_a*sin_a*k_r2; }
            zeta2 u2 { _ => -sin_a*k_r2 - sin_a*k_s2; }
            eta2 eta2 { _ => kb_p + cos_a.powi(2)*k_r2 + cos_a.powi(2)*k_s2; }
            eta2 u2 { _ => cos_a*k_r2 - cos_a*k_s2; }
            u2 u2 { _ => k_r2 + k_s2; }
            zeta3 zeta3 { _ => kb_p + sin_a.powi(2)*k_r3 + sin_a.powi(2)*k_s3; }
            zeta3 eta3 { _ => cos_a*sin_a*k_s3 - cos_a*sin_a*k_r3; }
            zeta3 u3 { _ => -sin_a*k_r3 - sin_a*k_s3; }
            eta3 eta3 { _ => kb_p + cos_a.powi(2)*k_r3 + cos_a.powi(2)*k_s3; }
            eta3 u3 { _ => cos_a*k_r3 - cos_a*k_s3; }
            u3 u3 { _ => k_r3 + k_s3; }
        }
        damping {
            theta theta {
                torsional_support_s_and_damping => beta_K*k_s/Z_r.powi(2) + 2.0*beta_K*k_s/(Z_r*Z_s) + beta_K*k_s/Z_s.powi(2);
                torsional_support_c_and_damping => beta_K*k_c/Z_r.powi(2);
                damping => I_c*alpha_M/Z_r.powi(2) - 6.0*h*I_p*alpha_M/(r_p*Z_r) + 3.0*I_p*alpha_M/Z_r.powi(2) + I_s*alpha_M/Z_r.powi(2)
                    + 2.0*I_s*alpha_M/(Z_r*Z_s) + I_s*alpha_M/Z_s.powi(2) + 3.0*a.powi(2)*alpha_M*m_p/Z_r.powi(2)
                    + 3.0*h.powi(2)*I_p*alpha_M/r_p.powi(2);
            }
            theta theta_c {
                torsional_support_s_and_damping => beta_K*k_s/Z_r + beta_K*k_s/Z_s;
                torsional_support_c_and_damping => beta_K*k_c/Z_r;
                damping => I_c*alpha_M/Z_r - 3.0*h*I_p*alpha_M/r_p + 3.0*I_p*alpha_M/Z_r + I_s*alpha_M/Z_r + I_s*alpha_M/Z_s
                    + 3.0*a.powi(2)*alpha_M*m_p/Z_r;
            }
            theta eta1 { damping => a*alpha_M*m_p/Z_r; }
            theta u1 { damping => I_p*alpha_M/(r_p*Z_r) - h*I_p*alpha_M/r_p.powi(2); }
            theta eta2 { damping => a*alpha_M*m_p/Z_r; }
            theta u2 { damping => I_p*alpha_M/(r_p*Z_r) - h*I_p*alpha_M/r_p.powi(2); }
            theta eta3 { damping => a*alpha_M*m_p/Z_r; }
            theta u3 { damping => I_p*alpha_M/(r_p*Z_r) - h*I_p*alpha_M/r_p.powi(2); }
            theta_c theta_c {
                torsional_support_s_and_damping => beta_K*k_s;
                torsional_support_c_and_damping => beta_K*k_c;
                damping => I_c*alpha_M + 3.0*I_p*alpha_M + I_s*alpha_M + 3.0*a.powi(2)*alpha_M*m_p + h.powi(2)*Z_r.powi(2)*beta_K*k_r1_mid
                    + h.powi(2)*Z_r.powi(2)*beta_K*k_r2_mid + h.powi(2)*Z_r.powi(2)*beta_K*k_r3_mid;
            }
            theta_c theta_r {
                damping => -h.powi(2)*Z_r.powi(2)*beta_K*k_r1_mid - h.powi(2)*Z_r.powi(2)*beta_K*k_r2_mid
                    - h.powi(2)*Z_r.powi(2)*beta_K*k_r3_mid;
            }
            theta_c x_r { damping => h*sin_r1*Z_r*beta_K*k_r1_mid + h*sin_r2*Z_r*beta_K*k_r2_mid + h*sin_r3*Z_r*beta_K*k_r3_mid; }
            theta_c y_r { damping => -cos_r1*h*Z_r*beta_K*k_r1_mid - cos_r2*h*Z_r*beta_K*k_r2_mid - cos_r3*h*Z_r*beta_K*k_r3_mid; }
            theta_c zeta1 { damping => -h*sin_a*Z_r*beta_K*k_r1_mid; }
            theta_c eta1 { damping => a*alpha_M*m_p + cos_a*h*Z_r*beta_K*k_r1_mid; }
            theta_c u1 { damping => h*Z_r*beta_K*k_r1_mid + I_p*alpha_M/r_p; }
            theta_c zeta2 { damping => -h*sin_a*Z_r*beta_K*k_r2_mid; }
            theta_c eta2 { damping => a*alpha_M*m_p + cos_a*h*Z_r*beta_K*k_r2_mid; }
            theta_c u2 { damping => h*Z_r*beta_K*k_r2_mid + I_p*alpha_M/r_p; }
            theta_c zeta3 { damping => -h*sin_a*Z_r*beta_K*k_r3_mid; }
            theta_c eta3 { damping => a*alpha_M*m_p + cos_a*h*Z_r*beta_K*k_r3_mid; }
            theta_c u3 { damping => h*Z_r*beta_K*k_r3_mid + I_p*alpha_M/r_p; }
            theta_r theta_r {
                damping => I_r*alpha_M + beta_K*k_r + h.powi(2)*Z_r.powi(2)*beta_K*k_r1_mid + h.powi(2)*Z_r.powi(2)*beta_K*k_r2_mid
                    + h.powi(2)*Z_r.powi(2)*beta_K*k_r3_mid;
            }
            theta_r x_r { damping => -h*sin_r1*Z_r*beta_K*k_r1_mid - h*sin_r2*Z_r*beta_K*k_r2_mid - h*sin_r3*Z_r*beta_K*k_r3_mid; }
            theta_r y_r { damping => cos_r1*h*Z_r*beta_K*k_r1_mid + cos_r2*h*Z_r*beta_K*k_r2_mid + cos_r3*h*Z_r*beta_K*k_r3_mid; }
            theta_r zeta1 { damping => h*sin_a*Z_r*beta_K*k_r1_mid; }
            theta_r eta1 { damping => -cos_a*h*Z_r*beta_K*k_r1_mid; }
            theta_r u1 { damping => -h*Z_r*beta_K*k_r1_mid; }
            theta_r zeta2 { damping => h*sin_a*Z_r*beta_K*k_r2_mid; }
            theta_r eta2 { damping => -cos_a*h*Z_r*beta_K*k_r2_mid; }
            theta_r u2 { damping => -h*Z_r*beta_K*k_r2_mid; }
            theta_r zeta3 { damping => h*sin_a*Z_r*beta_K*k_r3_mid; }
            theta_r eta3 { damping => -cos_a*h*Z_r*beta_K*k_r3_mid; }
            theta_r u3 { damping => -h*Z_r*beta_K*k_r3_mid; }
            x_s x_s {
                viscous_friction_s => cb_s;
                damping => alpha_M*m_s + beta_K*kb_s + sin_s1.powi(2)*beta_K*k_s1_mid + sin_s2.powi(2)*beta_K*k_s2_mid
                    + sin_s3.powi(2)*beta_K*k_s3_mid;
            }
            x_s y_s { damping => -cos_s1*sin_s1*beta_K*k_s1_mid - cos_s2*sin_s2*beta_K*k_s2_mid - cos_s3*sin_s3*beta_K*k_s3_mid; }
            x_s zeta1 { damping => sin_a*sin_s1*beta_K*k_s1_mid; }
            x_s eta1 { damping => cos_a*sin_s1*beta_K*k_s1_mid; }
            x_s u1 { damping => -sin_s1*beta_K*k_s1_mid; }
            x_s zeta2 { damping => sin_a*sin_s2*beta_K*k_s2_mid; }
            x_s eta2 { damping => cos_a*sin_s2*beta_K*k_s2_mid; }
            x_s u2 { damping => -sin_s2*beta_K*k_s2_mid; }
            x_s zeta3 { damping => sin_a*sin_s3*beta_K*k_s3_mid; }
            x_s eta3 { damping => cos_a*sin_s3*beta_K*k_s3_mid; }
            x_s u3 { damping => -sin_s3*beta_K*k_s3_mid; }
            y_s y_s {
                viscous_friction_s => cb_s;
                damping => alpha_M*m_s + beta_K*kb_s + cos_s1.powi(2)*beta_K*k_s1_mid + cos_s2.powi(2)*beta_K*k_s2_mid
                    + cos_s3.powi(2)*beta_K*k_s3_mid;
            }
            y_s zeta1 { damping => -cos_s1*sin_a*beta_K*k_s1_mid; }
            y_s eta1 { damping => -cos_a*cos_s1*beta_K*k_s1_mid; }
            y_s u1 { damping => cos_s1*beta_K*k_s1_mid; }
            y_s zeta2 { damping => -cos_s2*sin_a*beta_K*k_s2_mid; }
            y_s eta2 { damping => -cos_a*cos_s2*beta_K*k_s2_mid; }
            y_s u2 { damping => cos_s2*beta_K*k_s2_mid; }
            y_s zeta3 { damping => -cos_s3*sin_a*beta_K*k_s3_mid; }
            y_s eta3 { damping => -cos_a*cos_s3*beta_K*k_s3_mid; }
            y_s u3 { damping => cos_s3*beta_K*k_s3_mid; }
            x_c x_c {
                viscous_friction_c => cb_c;
                viscous_friction_p => cos_c1.powi(2)*cb_p + cos_c2.powi(2)*cb_p + cos_c3.powi(2)*cb_p + sin_c1.powi(2)*cb_p
                    + sin_c2.powi(2)*cb_p + sin_c3.powi(2)*cb_p;
                damping => alpha_M*m_c + beta_K*kb_c + cos_c1.powi(2)*beta_K*kb_p + cos_c2.powi(2)*beta_K*kb_p
                    + cos_c3.powi(2)*beta_K*kb_p + sin_c1.powi(2)*beta_K*kb_p + sin_c2.powi(2)*beta_K*kb_p + sin_c3.powi(2)*beta_K*kb_p;
            }
            x_c zeta1 {
                viscous_friction_p => -cos_c1*cb_p;
                damping => -cos_c1*beta_K*kb_p;
            }
            x_c eta1 {
                viscous_friction_p => sin_c1*cb_p;
                damping => sin_c1*beta_K*kb_p;
            }
            x_c zeta2 {
                viscous_friction_p => -cos_c2*cb_p;
                damping => -cos_c2*beta_K*kb_p;
            }
            x_c eta2 {
                viscous_friction_p => sin_c2*cb_p;
                damping => sin_c2*beta_K*kb_p;
            }
            x_c zeta3 {
                viscous_friction_p => -cos_c3*cb_p;
                damping => -cos_c3*beta_K*kb_p;
            }
            x_c eta3 {
                viscous_friction_p => sin_c3*cb_p;
                damping => sin_c3*beta_K*kb_p;
            }
            y_c y_c {
                viscous_friction_c => cb_c;
                viscous_friction_p => cos_c1.powi(2)*cb_p + cos_c2.powi(2)*cb_p + cos_c3.powi(2)*cb_p + sin_c1.powi(2)*cb_p
                    + sin_c2.powi(2)*cb_p + sin_c3.powi(2)*cb_p;
                damping => alpha_M*m_c + beta_K*kb_c + cos_c1.powi(2)*beta_K*kb_p + cos_c2.powi(2)*beta_K*kb_p
                    + cos_c3.powi(2)*beta_K*kb_p + sin_c1.powi(2)*beta_K*kb_p + sin_c2.powi(2)*beta_K*kb_p + sin_c3.powi(2)*beta_K*kb_p;
            }
            y_c zeta1 {
                viscous_friction_p => -sin_c1*cb_p;
                damping => -sin_c1*beta_K*kb_p;
            }
            y_c eta1 {
                viscous_friction_p => -cos_c1*cb_p;
                damping => -cos_c1*beta_K*kb_p;
            }
            y_c zeta2 {
                viscous_friction_p => -sin_c2*cb_p;
                damping => -sin_c2*beta_K*kb_p;
            }
            y_c eta2 {
                viscous_friction_p => -cos_c2*cb_p;
                damping => -cos_c2*beta_K*kb_p;
            }
            y_c zeta3 {
                viscous_friction_p => -sin_c3*cb_p;
                damping => -sin_c3*beta_K*kb_p;
            }
            y_c eta3 {
                viscous_friction_p => -cos_c3*cb_p;
                damping => -cos_c3*beta_K*kb_p;
            }
            x_r x_r {
                viscous_friction_r => cb_r;
                damping => alpha_M*m_r + beta_K*kb_r + sin_r1.powi(2)*beta_K*k_r1_mid + sin_r2.powi(2)*beta_K*k_r2_mid
                    + sin_r3.powi(2)*beta_K*k_r3_mid;
            }
            x_r y_r { damping => -cos_r1*sin_r1*beta_K*k_r1_mid - cos_r2*sin_r2*beta_K*k_r2_mid - cos_r3*sin_r3*beta_K*k_r3_mid; }
            x_r zeta1 { damping => -sin_a*sin_r1*beta_K*k_r1_mid; }
            x_r eta1 { damping => cos_a*sin_r1*beta_K*k_r1_mid; }
            x_r u1 { damping => sin_r1*beta_K*k_r1_mid; }
            x_r zeta2 { damping => -sin_a*sin_r2*beta_K*k_r2_mid; }
            x_r eta2 { damping => cos_a*sin_r2*beta_K*k_r2_mid; }
            x_r u2 { damping => sin_r2*beta_K*k_r2_mid; }
            x_r zeta3 { damping => -sin_a*sin_r3*beta_K*k_r3_mid; }
            x_r eta3 { damping => cos_a*sin_r3*beta_K*k_r3_mid; }
            x_r u3 { damping => sin_r3*beta_K*k_r3_mid; }
            y_r y_r {
                viscous_friction_r => cb_r;
                damping => alpha_M*m_r + beta_K*kb_r + cos_r1.powi(2)*beta_K*k_r1_mid + cos_r2.powi(2)*beta_K*k_r2_mid
                    + cos_r3.powi(2)*beta_K*k_r3_mid;
            }
            y_r zeta1 { damping => cos_r1*sin_a*beta_K*k_r1_mid; }
            y_r eta1 { damping => -cos_a*cos_r1*beta_K*k_r1_mid; }
            y_r u1 { damping => -cos_r1*beta_K*k_r1_mid; }
            y_r zeta2 { damping => cos_r2*sin_a*beta_K*k_r2_mid; }
            y_r eta2 { damping => -cos_a*cos_r2*beta_K*k_r2_mid; }
            y_r u2 { damping => -cos_r2*beta_K*k_r2_mid; }
            y_r zeta3 { damping => cos_r3*sin_a*beta_K*k_r3_mid; }
            y_r eta3 { damping => -cos_a*cos_r3*beta_K*k_r3_mid; }
            y_r u3 { damping => -cos_r3*beta_K*k_r3_mid; }
            zeta1 zeta1 {
                viscous_friction_p => cb_p;
                damping => alpha_M*m_p + beta_K*kb_p + sin_a.powi(2)*beta_K*k_r1_mid + sin_a.powi(2)*beta_K*k_s1_mid;
            }
            zeta1 eta1 { damping => cos_a*sin_a*beta_K*k_s1_mid - cos_a*sin_a*beta_K*k_r1_mid; }
            zeta1 u1 { damping => -sin_a*beta_K*k_r1_mid - sin_a*beta_K*k_s1_mid; }
            eta1 eta1 {
                viscous_friction_p => cb_p;
                damping => alpha_M*m_p + beta_K*kb_p + cos_a.powi(2)*beta_K*k_r1_mid + cos_a.powi(2)*beta_K*k_s1_mid;
            }
            eta1 u1 { damping => cos_a*beta_K*k_r1_mid - cos_a*beta_K*k_s1_mid; }
            u1 u1 { damping => beta_K*k_r1_mid + beta_K*k_s1_mid + I_p*alpha_M/r_p.powi(2); }
            zeta2 zeta2 {
                viscous_friction_p => cb_p;
                damping => alpha_M*m_p + beta_K*kb_p + sin_a.powi(2)*beta_K*k_r2_mid + sin_a.powi(2)*beta_K*k_s2_mid;
            }
            zeta2 eta2 { damping => cos_a*sin_a*beta_K*k_s2_mid - cos_a*sin_a*beta_K*k_r2_mid; }
            zeta2 u2 { damping => -sin_a*beta_K*k_r2_mid - sin_a*beta_K*k_s2_mid; }
            eta2 eta2 {
                viscous_friction_p => cb_p;
                damping => alpha_M*m_p + beta_K*kb_p + cos_a.powi(2)*beta_K*k_r2_mid + cos_a.powi(2)*beta_K*k_s2_mid;
            }
            eta2 u2 { damping => cos_a*beta_K*k_r2_mid - cos_a*beta_K*k_s2_mid; }
            u2 u2 { damping => beta_K*k_r2_mid + beta_K*k_s2_mid + I_p*alpha_M/r_p.powi(2); }
            zeta3 zeta3 {
                viscous_friction_p => cb_p;
                damping => alpha_M*m_p + beta_K*kb_p + sin_a.powi(2)*beta_K*k_r3_mid + sin_a.powi(2)*beta_K*k_s3_mid;
            }
            zeta3 eta3 { damping => cos_a*sin_a*beta_K*k_s3_mid - cos_a*sin_a*beta_K*k_r3_mid; }
            zeta3 u3 { damping => -sin_a*beta_K*k_r3_mid - sin_a*beta_K*k_s3_mid; }
            eta3 eta3 {
                viscous_friction_p => cb_p;
                damping => alpha_M*m_p + beta_K*kb_p + cos_a.powi(2)*beta_K*k_r3_mid + cos_a.powi(2)*beta_K*k_s3_mid;
            }
            eta3 u3 { damping => cos_a*beta_K*k_r3_mid - cos_a*beta_K*k_s3_mid; }
            u3 u3 { damping => beta_K*k_r3_mid + beta_K*k_s3_mid + I_p*alpha_M/r_p.powi(2); }
        }
        load {
            theta { torques => T_motor/Z_r - T_load/Z_r + T_motor/Z_s; }
            theta_c {
                _ => -h*Z_r*k_r1*e_r1 - h*Z_r*k_r2*e_r2 - h*Z_r*k_r3*e_r3;
                torques => T_motor - T_load;
            }
            theta_r { _ => h*Z_r*k_r1*e_r1 + h*Z_r*k_r2*e_r2 + h*Z_r*k_r3*e_r3; }
            x_s { _ => -sin_s1*k_s1*e_s1 - sin_s2*k_s2*e_s2 - sin_s3*k_s3*e_s3; }
            y_s { _ => cos_s1*k_s1*e_s1 + cos_s2*k_s2*e_s2 + cos_s3*k_s3*e_s3; }
            x_r { _ => -sin_r1*k_r1*e_r1 - sin_r2*k_r2*e_r2 - sin_r3*k_r3*e_r3; }
            y_r { _ => cos_r1*k_r1*e_r1 + cos_r2*k_r2*e_r2 + cos_r3*k_r3*e_r3; }
            zeta1 { _ => sin_a*k_r1*e_r1 - sin_a*k_s1*e_s1; }
            eta1 { _ => -cos_a*k_r1*e_r1 - cos_a*k_s1*e_s1; }
            u1 { _ => k_s1*e_s1 - k_r1*e_r1; }
            zeta2 { _ => sin_a*k_r2*e_r2 - sin_a*k_s2*e_s2; }
            eta2 { _ => -cos_a*k_r2*e_r2 - cos_a*k_s2*e_s2; }
            u2 { _ => k_s2*e_s2 - k_r2*e_r2; }
            zeta3 { _ => sin_a*k_r3*e_r3 - sin_a*k_s3*e_s3; }
            eta3 { _ => -cos_a*k_r3*e_r3 - cos_a*k_s3*e_s3; }
            u3 { _ => k_s3*e_s3 - k_r3*e_r3; }
        }
    }
    jump k_s1 { step { _ => dk_s1*delta_s1.powi(2)/2.0; } }
    jump k_r1 { step { _ => dk_r1*delta_r1.powi(2)/2.0; } }
    jump k_s2 { step { _ => dk_s2*delta_s2.powi(2)/2.0; } }
    jump k_r2 { step { _ => dk_r2*delta_r2.powi(2)/2.0; } }
    jump k_s3 { step { _ => dk_s3*delta_s3.powi(2)/2.0; } }
    jump k_r3 { step { _ => dk_r3*delta_r3.powi(2)/2.0; } }
    jump e_s1 { step { _ => k_s1*de_s1.powi(2)/2.0 - k_s1*de_s1*delta_s1; } }
    jump e_r1 { step { _ => k_r1*de_r1.powi(2)/2.0 - k_r1*de_r1*delta_r1; } }
    jump e_s2 { step { _ => k_s2*de_s2.powi(2)/2.0 - k_s2*de_s2*delta_s2; } }
    jump e_r2 { step { _ => k_r2*de_r2.powi(2)/2.0 - k_r2*de_r2*delta_r2; } }
    jump e_s3 { step { _ => k_s3*de_s3.powi(2)/2.0 - k_s3*de_s3*delta_s3; } }
    jump e_r3 { step { _ => k_r3*de_r3.powi(2)/2.0 - k_r3*de_r3*delta_r3; } }
    outputs {
        rotor_speed_s "rad/s", "rotational speed of the sun" { _ => theta_c_dot + theta_dot*(1.0/Z_r + 1.0/Z_s); }
        bearing_force_s_x "N", "force on the bearing of the sun along x" {
            _ => kb_s*bx_s;
            viscous_friction_s => cb_s*bx_s_dot;
            damping => beta_K*kb_s*bx_s_dot;
        }
        bearing_force_s_y "N", "force on the bearing of the sun along y" {
            _ => kb_s*by_s;
            viscous_friction_s => cb_s*by_s_dot;
            damping => beta_K*kb_s*by_s_dot;
        }
        bearing_force_s "N", "magnitude of the force on the bearing of the sun" {
            _ => (bearing_force_s_x.powi(2) + bearing_force_s_y.powi(2)).sqrt();
        }
        bearing_loss_s "W", "power that the damper of the bearing of the sun takes" {
            viscous_friction_s => cb_s*bx_s_dot.powi(2) + cb_s*by_s_dot.powi(2);
            damping => beta_K*kb_s*bx_s_dot.powi(2) + beta_K*kb_s*by_s_dot.powi(2);
        }
        rotor_speed_c "rad/s", "rotational speed of the carrier" { _ => theta_c_dot + theta_dot/Z_r; }
        bearing_force_c_x "N", "force on the bearing of the carrier along x" {
            _ => kb_c*bx_c;
            viscous_friction_c => cb_c*bx_c_dot;
            damping => beta_K*kb_c*bx_c_dot;
        }
        bearing_force_c_y "N", "force on the bearing of the carrier along y" {
            _ => kb_c*by_c;
            viscous_friction_c => cb_c*by_c_dot;
            damping => beta_K*kb_c*by_c_dot;
        }
        bearing_force_c "N", "magnitude of the force on the bearing of the carrier" {
            _ => (bearing_force_c_x.powi(2) + bearing_force_c_y.powi(2)).sqrt();
        }
        bearing_loss_c "W", "power that the damper of the bearing of the carrier takes" {
            viscous_friction_c => cb_c*bx_c_dot.powi(2) + cb_c*by_c_dot.powi(2);
            damping => beta_K*kb_c*bx_c_dot.powi(2) + beta_K*kb_c*by_c_dot.powi(2);
        }
        rotor_speed_r "rad/s", "rotational speed of the ring" { _ => theta_r_dot; }
        bearing_force_r_x "N", "force on the bearing of the ring along x" {
            _ => kb_r*bx_r;
            viscous_friction_r => cb_r*bx_r_dot;
            damping => beta_K*kb_r*bx_r_dot;
        }
        bearing_force_r_y "N", "force on the bearing of the ring along y" {
            _ => kb_r*by_r;
            viscous_friction_r => cb_r*by_r_dot;
            damping => beta_K*kb_r*by_r_dot;
        }
        bearing_force_r "N", "magnitude of the force on the bearing of the ring" {
            _ => (bearing_force_r_x.powi(2) + bearing_force_r_y.powi(2)).sqrt();
        }
        bearing_loss_r "W", "power that the damper of the bearing of the ring takes" {
            viscous_friction_r => cb_r*bx_r_dot.powi(2) + cb_r*by_r_dot.powi(2);
            damping => beta_K*kb_r*bx_r_dot.powi(2) + beta_K*kb_r*by_r_dot.powi(2);
        }
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
        planet_bearing_force_1_radial "N", "radial force on the bearing of planet 1" {
            _ => kb_p*radial1;
            viscous_friction_p => cb_p*radial1_dot;
            damping => beta_K*kb_p*radial1_dot;
        }
        planet_bearing_force_1_tangential "N", "tangential force on the bearing of planet 1" {
            _ => kb_p*tangential1;
            viscous_friction_p => cb_p*tangential1_dot;
            damping => beta_K*kb_p*tangential1_dot;
        }
        planet_bearing_force_1 "N", "magnitude of the force on the bearing of planet 1" {
            _ => (planet_bearing_force_1_radial.powi(2) + planet_bearing_force_1_tangential.powi(2)).sqrt();
        }
        planet_bearing_loss_1 "W", "power that the damper of the bearing of planet 1 takes" {
            viscous_friction_p => cb_p*radial1_dot.powi(2) + cb_p*tangential1_dot.powi(2);
            damping => beta_K*kb_p*radial1_dot.powi(2) + beta_K*kb_p*tangential1_dot.powi(2);
        }
        mesh_force_s1 "N",
            "force of the mesh of sun and planet 1 along the line of action, damper included: positive if it presses the drive flanks" {
            _ => k_s1*delta_s1;
            damping => beta_K*k_s1_mid*delta_s1_dot;
        }
        mesh_power_s1 "W", "power that the first gear gives to the mesh of sun and planet 1: force times the speed of its flank" {
            _ => mesh_force_s1*(cos_s1*y_s_dot + h*Z_s*theta_c_dot + h*Z_s*theta_dot*(1.0/Z_r + 1.0/Z_s) - sin_s1*x_s_dot);
        }
        mesh_deflection_s1 "m", "deflection of the mesh of sun and planet 1 along the line of action, backlash not taken off" {
            _ => u1 - e_s1 - (cos_a*(eta1 + h*(Z_r + Z_s)*(theta_c + theta/Z_r)/(2.0*cos_a)) + sin_a*zeta1) + cos_s1*y_s
                + h*Z_s*(theta_c + theta/Z_r + theta/Z_s) - h*theta + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0 - sin_s1*x_s;
        }
        dte_s1 "m",
            "dynamic transmission error of the mesh of sun and planet 1 along the line of action: positive if the driving gear is ahead" {
            _ => u1 - (cos_a*(eta1 + h*(Z_r + Z_s)*(theta_c + theta/Z_r)/(2.0*cos_a)) + sin_a*zeta1) + cos_s1*y_s
                + h*Z_s*(theta_c + theta/Z_r + theta/Z_s) - h*theta + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0 - sin_s1*x_s;
        }
        mesh_loss_s1 "W", "power that the damper of the mesh of sun and planet 1 takes" { damping => beta_K*k_s1_mid*delta_s1_dot.powi(2); }
        mesh_force_r1 "N",
            "force of the mesh of ring and planet 1 along the line of action, damper included: positive if it presses the drive flanks" {
            _ => k_r1*delta_r1;
            damping => beta_K*k_r1_mid*delta_r1_dot;
        }
        mesh_power_r1 "W", "power that the first gear gives to the mesh of ring and planet 1: force times the speed of its flank" {
            _ => mesh_force_r1*(cos_r1*y_r_dot + h*Z_r*theta_r_dot - sin_r1*x_r_dot);
        }
        mesh_deflection_r1 "m", "deflection of the mesh of ring and planet 1 along the line of action, backlash not taken off" {
            _ => cos_r1*y_r - e_r1 - (u1 - h*theta + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0)
                - (cos_a*(eta1 + h*(Z_r + Z_s)*(theta_c + theta/Z_r)/(2.0*cos_a)) - sin_a*zeta1) + h*Z_r*theta_r - sin_r1*x_r;
        }
        dte_r1 "m",
            "dynamic transmission error of the mesh of ring and planet 1 along the line of action: positive if the driving gear is ahead" {
            _ => cos_r1*y_r - (u1 - h*theta + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0)
                - (cos_a*(eta1 + h*(Z_r + Z_s)*(theta_c + theta/Z_r)/(2.0*cos_a)) - sin_a*zeta1) + h*Z_r*theta_r - sin_r1*x_r;
        }
        mesh_loss_r1 "W", "power that the damper of the mesh of ring and planet 1 takes" {
            damping => beta_K*k_r1_mid*delta_r1_dot.powi(2);
        }
        planet_bearing_force_2_radial "N", "radial force on the bearing of planet 2" {
            _ => kb_p*radial2;
            viscous_friction_p => cb_p*radial2_dot;
            damping => beta_K*kb_p*radial2_dot;
        }
        planet_bearing_force_2_tangential "N", "tangential force on the bearing of planet 2" {
            _ => kb_p*tangential2;
            viscous_friction_p => cb_p*tangential2_dot;
            damping => beta_K*kb_p*tangential2_dot;
        }
        planet_bearing_force_2 "N", "magnitude of the force on the bearing of planet 2" {
            _ => (planet_bearing_force_2_radial.powi(2) + planet_bearing_force_2_tangential.powi(2)).sqrt();
        }
        planet_bearing_loss_2 "W", "power that the damper of the bearing of planet 2 takes" {
            viscous_friction_p => cb_p*radial2_dot.powi(2) + cb_p*tangential2_dot.powi(2);
            damping => beta_K*kb_p*radial2_dot.powi(2) + beta_K*kb_p*tangential2_dot.powi(2);
        }
        mesh_force_s2 "N",
            "force of the mesh of sun and planet 2 along the line of action, damper included: positive if it presses the drive flanks" {
            _ => k_s2*delta_s2;
            damping => beta_K*k_s2_mid*delta_s2_dot;
        }
        mesh_power_s2 "W", "power that the first gear gives to the mesh of sun and planet 2: force times the speed of its flank" {
            _ => mesh_force_s2*(cos_s2*y_s_dot + h*Z_s*theta_c_dot + h*Z_s*theta_dot*(1.0/Z_r + 1.0/Z_s) - sin_s2*x_s_dot);
        }
        mesh_deflection_s2 "m", "deflection of the mesh of sun and planet 2 along the line of action, backlash not taken off" {
            _ => u2 - e_s2 - (cos_a*(eta2 + h*(Z_r + Z_s)*(theta_c + theta/Z_r)/(2.0*cos_a)) + sin_a*zeta2) + cos_s2*y_s
                + h*Z_s*(theta_c + theta/Z_r + theta/Z_s) - h*theta + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0 - sin_s2*x_s;
        }
        dte_s2 "m",
            "dynamic transmission error of the mesh of sun and planet 2 along the line of action: positive if the driving gear is ahead" {
            _ => u2 - (cos_a*(eta2 + h*(Z_r + Z_s)*(theta_c + theta/Z_r)/(2.0*cos_a)) + sin_a*zeta2) + cos_s2*y_s
                + h*Z_s*(theta_c + theta/Z_r + theta/Z_s) - h*theta + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0 - sin_s2*x_s;
        }
        mesh_loss_s2 "W", "power that the damper of the mesh of sun and planet 2 takes" { damping => beta_K*k_s2_mid*delta_s2_dot.powi(2); }
        mesh_force_r2 "N",
            "force of the mesh of ring and planet 2 along the line of action, damper included: positive if it presses the drive flanks" {
            _ => k_r2*delta_r2;
            damping => beta_K*k_r2_mid*delta_r2_dot;
        }
        mesh_power_r2 "W", "power that the first gear gives to the mesh of ring and planet 2: force times the speed of its flank" {
            _ => mesh_force_r2*(cos_r2*y_r_dot + h*Z_r*theta_r_dot - sin_r2*x_r_dot);
        }
        mesh_deflection_r2 "m", "deflection of the mesh of ring and planet 2 along the line of action, backlash not taken off" {
            _ => cos_r2*y_r - e_r2 - (u2 - h*theta + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0)
                - (cos_a*(eta2 + h*(Z_r + Z_s)*(theta_c + theta/Z_r)/(2.0*cos_a)) - sin_a*zeta2) + h*Z_r*theta_r - sin_r2*x_r;
        }
        dte_r2 "m",
            "dynamic transmission error of the mesh of ring and planet 2 along the line of action: positive if the driving gear is ahead" {
            _ => cos_r2*y_r - (u2 - h*theta + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0)
                - (cos_a*(eta2 + h*(Z_r + Z_s)*(theta_c + theta/Z_r)/(2.0*cos_a)) - sin_a*zeta2) + h*Z_r*theta_r - sin_r2*x_r;
        }
        mesh_loss_r2 "W", "power that the damper of the mesh of ring and planet 2 takes" {
            damping => beta_K*k_r2_mid*delta_r2_dot.powi(2);
        }
        planet_bearing_force_3_radial "N", "radial force on the bearing of planet 3" {
            _ => kb_p*radial3;
            viscous_friction_p => cb_p*radial3_dot;
            damping => beta_K*kb_p*radial3_dot;
        }
        planet_bearing_force_3_tangential "N", "tangential force on the bearing of planet 3" {
            _ => kb_p*tangential3;
            viscous_friction_p => cb_p*tangential3_dot;
            damping => beta_K*kb_p*tangential3_dot;
        }
        planet_bearing_force_3 "N", "magnitude of the force on the bearing of planet 3" {
            _ => (planet_bearing_force_3_radial.powi(2) + planet_bearing_force_3_tangential.powi(2)).sqrt();
        }
        planet_bearing_loss_3 "W", "power that the damper of the bearing of planet 3 takes" {
            viscous_friction_p => cb_p*radial3_dot.powi(2) + cb_p*tangential3_dot.powi(2);
            damping => beta_K*kb_p*radial3_dot.powi(2) + beta_K*kb_p*tangential3_dot.powi(2);
        }
        mesh_force_s3 "N",
            "force of the mesh of sun and planet 3 along the line of action, damper included: positive if it presses the drive flanks" {
            _ => k_s3*delta_s3;
            damping => beta_K*k_s3_mid*delta_s3_dot;
        }
        mesh_power_s3 "W", "power that the first gear gives to the mesh of sun and planet 3: force times the speed of its flank" {
            _ => mesh_force_s3*(cos_s3*y_s_dot + h*Z_s*theta_c_dot + h*Z_s*theta_dot*(1.0/Z_r + 1.0/Z_s) - sin_s3*x_s_dot);
        }
        mesh_deflection_s3 "m", "deflection of the mesh of sun and planet 3 along the line of action, backlash not taken off" {
            _ => u3 - e_s3 - (cos_a*(eta3 + h*(Z_r + Z_s)*(theta_c + theta/Z_r)/(2.0*cos_a)) + sin_a*zeta3) + cos_s3*y_s
                + h*Z_s*(theta_c + theta/Z_r + theta/Z_s) - h*theta + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0 - sin_s3*x_s;
        }
        dte_s3 "m",
            "dynamic transmission error of the mesh of sun and planet 3 along the line of action: positive if the driving gear is ahead" {
            _ => u3 - (cos_a*(eta3 + h*(Z_r + Z_s)*(theta_c + theta/Z_r)/(2.0*cos_a)) + sin_a*zeta3) + cos_s3*y_s
                + h*Z_s*(theta_c + theta/Z_r + theta/Z_s) - h*theta + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0 - sin_s3*x_s;
        }
        mesh_loss_s3 "W", "power that the damper of the mesh of sun and planet 3 takes" { damping => beta_K*k_s3_mid*delta_s3_dot.powi(2); }
        mesh_force_r3 "N",
            "force of the mesh of ring and planet 3 along the line of action, damper included: positive if it presses the drive flanks" {
            _ => k_r3*delta_r3;
            damping => beta_K*k_r3_mid*delta_r3_dot;
        }
        mesh_power_r3 "W", "power that the first gear gives to the mesh of ring and planet 3: force times the speed of its flank" {
            _ => mesh_force_r3*(cos_r3*y_r_dot + h*Z_r*theta_r_dot - sin_r3*x_r_dot);
        }
        mesh_deflection_r3 "m", "deflection of the mesh of ring and planet 3 along the line of action, backlash not taken off" {
            _ => cos_r3*y_r - e_r3 - (u3 - h*theta + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0)
                - (cos_a*(eta3 + h*(Z_r + Z_s)*(theta_c + theta/Z_r)/(2.0*cos_a)) - sin_a*zeta3) + h*Z_r*theta_r - sin_r3*x_r;
        }
        dte_r3 "m",
            "dynamic transmission error of the mesh of ring and planet 3 along the line of action: positive if the driving gear is ahead" {
            _ => cos_r3*y_r - (u3 - h*theta + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0)
                - (cos_a*(eta3 + h*(Z_r + Z_s)*(theta_c + theta/Z_r)/(2.0*cos_a)) - sin_a*zeta3) + h*Z_r*theta_r - sin_r3*x_r;
        }
        mesh_loss_r3 "W", "power that the damper of the mesh of ring and planet 3 takes" {
            damping => beta_K*k_r3_mid*delta_r3_dot.powi(2);
        }
        power_motor "W" with torques, "power of the driving torque of the sun: positive if it drives" { _ => motor_power; }
        power_load "W" with torques, "power of the load torque of the carrier, against its rotation: positive if it drives" {
            _ => load_power;
        }
        inertia_damping_loss "W" with damping, "power that the damping in proportion to inertia takes" {
            _ => 2.0*alpha_M*((I_c*(theta_c_dot + theta_dot/Z_r).powi(2)
                + I_p*(theta_c_dot + (u1_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)
                + I_p*(theta_c_dot + (u2_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)
                + I_p*(theta_c_dot + (u3_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2) + I_r*theta_r_dot.powi(2)
                + I_s*(theta_c_dot + theta_dot*(1.0/Z_r + 1.0/Z_s)).powi(2) + m_c*x_c_dot.powi(2) + m_c*y_c_dot.powi(2)
                + m_p*zeta1_dot.powi(2) + m_p*zeta2_dot.powi(2) + m_p*zeta3_dot.powi(2)
                + m_p*(eta1_dot + a*(theta_c_dot + theta_dot/Z_r)).powi(2) + m_p*(eta2_dot + a*(theta_c_dot + theta_dot/Z_r)).powi(2)
                + m_p*(eta3_dot + a*(theta_c_dot + theta_dot/Z_r)).powi(2) + m_r*x_r_dot.powi(2) + m_r*y_r_dot.powi(2)
                + m_s*x_s_dot.powi(2) + m_s*y_s_dot.powi(2))/2.0);
        }
    }

    text "text/planar_planetary_3.txt";
    latex "latex/planar_planetary_3.tex";
}

// Proved of these equations, symbolically:
//
// - d/dt (q'.dT/dq' - T + V) = Q.q' - q'.dD/dq' along the motion, for every value and slope of every law, with any set of the additive
//   effects
// - M is symmetric
// - T = q'.M q'/2, with M as written
// - M is positive definite: T is a sum of squares that vanish together only at rest
// - at a step of k_s1, k_r1, k_s2, k_r2, k_s3, k_r3, e_s1, e_r1, e_s2, e_r2, e_s3, e_r3: T+ - T- = (v+² - v²)/(2 G) for any v+, where M d =
//   n/G; V+ - V- = dV as written; so T + V is unchanged in transmission (v+² = v² - 2 G dV) and in reflection (v+ = -v, dV = 0)
// - every damper takes energy or none: each term of D has a power q'.dD/dq' that is never negative
// - every deflection equals the linear form by which the equations differentiate it
// - without the jump terms the balance fails: energy is created at the rate dk_r1*delta_r1^2*theta_dot/2 - k_r1*de_r1*delta_r1*theta_dot -
//   k_r2*de_r2*delta_r2*theta_dot - k_r3*de_r3*delta_r3*theta_dot - k_s1*de_s1*delta_s1*theta_dot - k_s2*de_s2*delta_s2*theta_dot -
//   k_s3*de_s3*delta_s3*theta_dot + dk_r2*delta_r2^2*theta_dot/2 + dk_r3*delta_r3^2*theta_dot/2 + dk_s1*delta_s1^2*theta_dot/2 +
//   dk_s2*delta_s2^2*theta_dot/2 + dk_s3*delta_s3^2*theta_dot/2
//
// Operations, all effects present:
//
// | output | sums | products, quotients | functions, roots |
// | --- | --- | --- | --- |
// | constants (once a scene) | 14 | 11 | 20 |
// | force | 177 | 623 | 0 |
// | energy steps, all laws | 6 | 48 | 0 |
