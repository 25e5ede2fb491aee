//! Equations of motion of `gear_pair_shafts`: a gear pair between motor and load, on torsional shafts.
//!
//! Derived from the energies in `models/src/gear_pair_shafts.rs` by `cargo xtask derive gear_pair_shafts`. Do not edit: change the
//! energies and derive again.
//! Source: standard torsional model, e.g. Kahraman & Singh (1991), J. Sound Vib. 146(1); phase as Oh, Grosh & Barber (2005)
//!
//! # Energies
//!
//! ```text
//! T = (I1*(s_dot/(2*h*N1) + theta_dot/N1)^2 + I2*(theta_dot/N2 - s_dot/(2*h*N2))^2 + I_l*(theta_dot/N2 - psi_l_dot - s_dot/(2*h*N2))^2 + I_m*(psi_m_dot + s_dot/(2*h*N1) + theta_dot/N1)^2)/2
//! V = (k_l*psi_l^2 + k_m*psi_m^2 + k12*s^2)/2
//! D = (I1*alpha_M*(s_dot/(2*h*N1) + theta_dot/N1)^2 + I2*alpha_M*(theta_dot/N2 - s_dot/(2*h*N2))^2 + I_l*alpha_M*(theta_dot/N2 - psi_l_dot - s_dot/(2*h*N2))^2 + I_m*alpha_M*(psi_m_dot + s_dot/(2*h*N1) + theta_dot/N1)^2 + beta_K*k_l*psi_l_dot^2 + beta_K*k_m*psi_m_dot^2 + beta_K*k12_mid*s_dot^2)/2 [damping]
//! Q_theta = T_motor/N1 - T_load/N2 [torques]
//! Q_s = (T_motor/(h*N1) + T_load/(h*N2))/2 [torques]
//! Q_psi_m = T_motor [torques]
//! Q_psi_l = T_load [torques]
//! ```
//!
//! # Constants
//!
//! ```text
//! h = r1/N1
//! ```
//!
//! # Equations of motion
//!
//! ```text
//! (I1/N1^2 + I2/N2^2 + I_l/N2^2 + I_m/N1^2) theta'' + ((I1/(h*N1^2) - I2/(h*N2^2) - I_l/(h*N2^2) + I_m/(h*N1^2))/2) s'' + (I_m/N1) psi_m'' + (-I_l/N2) psi_l'' = T_motor/N1 - T_load/N2 [torques] + I_l*alpha_M*psi_l_dot/N2 - I1*alpha_M*theta_dot/N1^2 - I2*alpha_M*theta_dot/N2^2 - I_l*alpha_M*theta_dot/N2^2 - I_m*alpha_M*theta_dot/N1^2 - I_m*alpha_M*psi_m_dot/N1 - I1*alpha_M*s_dot/(2*h*N1^2) + I2*alpha_M*s_dot/(2*h*N2^2) + I_l*alpha_M*s_dot/(2*h*N2^2) - I_m*alpha_M*s_dot/(2*h*N1^2) [damping] - dk12*s^2/2 [jump terms]
//! ((I1/(h*N1^2) - I2/(h*N2^2) - I_l/(h*N2^2) + I_m/(h*N1^2))/2) theta'' + ((I1/(h^2*N1^2) + I2/(h^2*N2^2) + I_l/(h^2*N2^2) + I_m/(h^2*N1^2))/4) s'' + (I_m/(2*h*N1)) psi_m'' + (I_l/(2*h*N2)) psi_l'' = -k12*s + (T_motor/(h*N1) + T_load/(h*N2))/2 [torques] + I2*alpha_M*theta_dot/(2*h*N2^2) - beta_K*k12_mid*s_dot - I1*alpha_M*s_dot/(4*h^2*N1^2) - I2*alpha_M*s_dot/(4*h^2*N2^2) - I_l*alpha_M*s_dot/(4*h^2*N2^2) - I_m*alpha_M*s_dot/(4*h^2*N1^2) - I1*alpha_M*theta_dot/(2*h*N1^2) + I_l*alpha_M*theta_dot/(2*h*N2^2) - I_l*alpha_M*psi_l_dot/(2*h*N2) - I_m*alpha_M*theta_dot/(2*h*N1^2) - I_m*alpha_M*psi_m_dot/(2*h*N1) [damping]
//! (I_m/N1) theta'' + (I_m/(2*h*N1)) s'' + (I_m) psi_m'' = -k_m*psi_m + T_motor [torques] - I_m*alpha_M*psi_m_dot - I_m*alpha_M*theta_dot/N1 - beta_K*k_m*psi_m_dot - I_m*alpha_M*s_dot/(2*h*N1) [damping]
//! (-I_l/N2) theta'' + (I_l/(2*h*N2)) s'' + (I_l) psi_l'' = -k_l*psi_l + T_load [torques] + I_l*alpha_M*theta_dot/N2 - I_l*alpha_M*psi_l_dot - beta_K*k_l*psi_l_dot - I_l*alpha_M*s_dot/(2*h*N2) [damping]
//! ```
//!
//! # At a step of a stiffness
//!
//! ```text
//! at a step dk12 of k12 in theta: v+^2 = v-^2 - 2*G*(dk12*s^2/2)
//! ```
//!
//! # Between two steps
//!
//! ```text
//! M q'' + C q' + K q = f with constant M, C, K, f: linear, solved exactly
//! ```
//!
//! # LaTeX
//!
//! ```latex
//! T = \frac{1}{2} (I_{1}\, \left(\frac{\dot{s}}{2\, h\, N_{1}} + \frac{\dot{\theta}}{N_{1}}\right)^{2} + I_{2}\, \left(\frac{\dot{\theta}}{N_{2}} - \frac{\dot{s}}{2\, h\, N_{2}}\right)^{2} + I_{l}\, \left(\frac{\dot{\theta}}{N_{2}} - \dot{\psi_{l}} - \frac{\dot{s}}{2\, h\, N_{2}}\right)^{2} + I_{m}\, \left(\dot{\psi_{m}} + \frac{\dot{s}}{2\, h\, N_{1}} + \frac{\dot{\theta}}{N_{1}}\right)^{2})
//! V = \frac{1}{2} (k_{l}\, \psi_{l}^{2} + k_{m}\, \psi_{m}^{2} + k_{12}\, s^{2})
//! D = \frac{1}{2} (I_{1}\, \alpha_{M}\, \left(\frac{\dot{s}}{2\, h\, N_{1}} + \frac{\dot{\theta}}{N_{1}}\right)^{2} + I_{2}\, \alpha_{M}\, \left(\frac{\dot{\theta}}{N_{2}} - \frac{\dot{s}}{2\, h\, N_{2}}\right)^{2} + I_{l}\, \alpha_{M}\, \left(\frac{\dot{\theta}}{N_{2}} - \dot{\psi_{l}} - \frac{\dot{s}}{2\, h\, N_{2}}\right)^{2} + I_{m}\, \alpha_{M}\, \left(\dot{\psi_{m}} + \frac{\dot{s}}{2\, h\, N_{1}} + \frac{\dot{\theta}}{N_{1}}\right)^{2} + \beta_{K}\, k_{l}\, \dot{\psi_{l}}^{2} + \beta_{K}\, k_{m}\, \dot{\psi_{m}}^{2} + \beta_{K}\, \bar{k_{12}}\, \dot{s}^{2})\ [\text{damping}]
//! Q_{\theta} = \frac{T_{motor}}{N_{1}} - \frac{T_{load}}{N_{2}}\ [\text{torques}]
//! Q_{s} = \frac{1}{2} (\frac{T_{motor}}{h\, N_{1}} + \frac{T_{load}}{h\, N_{2}})\ [\text{torques}]
//! Q_{\psi_{m}} = T_{motor}\ [\text{torques}]
//! Q_{\psi_{l}} = T_{load}\ [\text{torques}]
//! h = \frac{r_{1}}{N_{1}}
//! (\frac{I_{1}}{N_{1}^{2}} + \frac{I_{2}}{N_{2}^{2}} + \frac{I_{l}}{N_{2}^{2}} + \frac{I_{m}}{N_{1}^{2}}) \ddot{\theta} + (\frac{1}{2} (\frac{I_{1}}{h\, N_{1}^{2}} - \frac{I_{2}}{h\, N_{2}^{2}} - \frac{I_{l}}{h\, N_{2}^{2}} + \frac{I_{m}}{h\, N_{1}^{2}})) \ddot{s} + (\frac{I_{m}}{N_{1}}) \ddot{\psi_{m}} + (-\frac{I_{l}}{N_{2}}) \ddot{\psi_{l}} = \frac{T_{motor}}{N_{1}} - \frac{T_{load}}{N_{2}}\ [\text{torques}] + \frac{I_{l}\, \alpha_{M}\, \dot{\psi_{l}}}{N_{2}} - \frac{I_{1}\, \alpha_{M}\, \dot{\theta}}{N_{1}^{2}} - \frac{I_{2}\, \alpha_{M}\, \dot{\theta}}{N_{2}^{2}} - \frac{I_{l}\, \alpha_{M}\, \dot{\theta}}{N_{2}^{2}} - \frac{I_{m}\, \alpha_{M}\, \dot{\theta}}{N_{1}^{2}} - \frac{I_{m}\, \alpha_{M}\, \dot{\psi_{m}}}{N_{1}} - \frac{I_{1}\, \alpha_{M}\, \dot{s}}{2\, h\, N_{1}^{2}} + \frac{I_{2}\, \alpha_{M}\, \dot{s}}{2\, h\, N_{2}^{2}} + \frac{I_{l}\, \alpha_{M}\, \dot{s}}{2\, h\, N_{2}^{2}} - \frac{I_{m}\, \alpha_{M}\, \dot{s}}{2\, h\, N_{1}^{2}}\ [\text{damping}] - \frac{k_{12}'\, s^{2}}{2}\ [\text{jump terms}]
//! (\frac{1}{2} (\frac{I_{1}}{h\, N_{1}^{2}} - \frac{I_{2}}{h\, N_{2}^{2}} - \frac{I_{l}}{h\, N_{2}^{2}} + \frac{I_{m}}{h\, N_{1}^{2}})) \ddot{\theta} + (\frac{1}{4} (\frac{I_{1}}{h^{2}\, N_{1}^{2}} + \frac{I_{2}}{h^{2}\, N_{2}^{2}} + \frac{I_{l}}{h^{2}\, N_{2}^{2}} + \frac{I_{m}}{h^{2}\, N_{1}^{2}})) \ddot{s} + (\frac{I_{m}}{2\, h\, N_{1}}) \ddot{\psi_{m}} + (\frac{I_{l}}{2\, h\, N_{2}}) \ddot{\psi_{l}} = -k_{12}\, s + \frac{1}{2} (\frac{T_{motor}}{h\, N_{1}} + \frac{T_{load}}{h\, N_{2}})\ [\text{torques}] + \frac{I_{2}\, \alpha_{M}\, \dot{\theta}}{2\, h\, N_{2}^{2}} - \beta_{K}\, \bar{k_{12}}\, \dot{s} - \frac{I_{1}\, \alpha_{M}\, \dot{s}}{4\, h^{2}\, N_{1}^{2}} - \frac{I_{2}\, \alpha_{M}\, \dot{s}}{4\, h^{2}\, N_{2}^{2}} - \frac{I_{l}\, \alpha_{M}\, \dot{s}}{4\, h^{2}\, N_{2}^{2}} - \frac{I_{m}\, \alpha_{M}\, \dot{s}}{4\, h^{2}\, N_{1}^{2}} - \frac{I_{1}\, \alpha_{M}\, \dot{\theta}}{2\, h\, N_{1}^{2}} + \frac{I_{l}\, \alpha_{M}\, \dot{\theta}}{2\, h\, N_{2}^{2}} - \frac{I_{l}\, \alpha_{M}\, \dot{\psi_{l}}}{2\, h\, N_{2}} - \frac{I_{m}\, \alpha_{M}\, \dot{\theta}}{2\, h\, N_{1}^{2}} - \frac{I_{m}\, \alpha_{M}\, \dot{\psi_{m}}}{2\, h\, N_{1}}\ [\text{damping}]
//! (\frac{I_{m}}{N_{1}}) \ddot{\theta} + (\frac{I_{m}}{2\, h\, N_{1}}) \ddot{s} + (I_{m}) \ddot{\psi_{m}} = -k_{m}\, \psi_{m} + T_{motor}\ [\text{torques}] - I_{m}\, \alpha_{M}\, \dot{\psi_{m}} - \frac{I_{m}\, \alpha_{M}\, \dot{\theta}}{N_{1}} - \beta_{K}\, k_{m}\, \dot{\psi_{m}} - \frac{I_{m}\, \alpha_{M}\, \dot{s}}{2\, h\, N_{1}}\ [\text{damping}]
//! (-\frac{I_{l}}{N_{2}}) \ddot{\theta} + (\frac{I_{l}}{2\, h\, N_{2}}) \ddot{s} + (I_{l}) \ddot{\psi_{l}} = -k_{l}\, \psi_{l} + T_{load}\ [\text{torques}] + \frac{I_{l}\, \alpha_{M}\, \dot{\theta}}{N_{2}} - I_{l}\, \alpha_{M}\, \dot{\psi_{l}} - \beta_{K}\, k_{l}\, \dot{\psi_{l}} - \frac{I_{l}\, \alpha_{M}\, \dot{s}}{2\, h\, N_{2}}\ [\text{damping}]
//! ```
//!
//! # Proved
//!
//! - d/dt (q'.dT/dq' - T + V) = Q.q' - q'.dD/dq' along the motion, for every value and slope of every law, with any set of the additive effects
//! - M is symmetric
//! - M is positive definite: every leading minor is a sum of products of positive quantities
//! - without the jump terms the balance fails: energy is created at the rate dk12*s^2*theta_dot/2
//!
//! # Operations, all effects present
//!
//! | output | sums | products, quotients | functions, roots |
//! | --- | --- | --- | --- |
//! | constants (once a scene) | 0 | 1 | 0 |
//! | force | 27 | 148 | 0 |
//! | energy step of k12 | 0 | 3 | 0 |

use gearsim_macros::equations;

equations! {
    model gear_pair_shafts "a gear pair between motor and load, on torsional shafts";
    source "standard torsional model, e.g. Kahraman & Singh (1991), J. Sound Vib. 146(1); phase as Oh, Grosh & Barber (2005)";

    coordinates {
        theta "rad" start 0.0, "mean rotation of gears 1 and 2, one pitch 2 pi";
        s "m" start static, "rotation of gear 1 beyond that of gear 2, along the line of action";
        psi_m "rad" start static, "twist of the motor's shaft";
        psi_l "rad" start static, "twist of the load's shaft";
    }
    parameters {
        N1 "1" required, open 0.0 to inf, "number of teeth of gear 1";
        N2 "1" required, open 0.0 to inf, "number of teeth of gear 2";
        r1 "m" required, open 0.0 to inf, "base radius of gear 1";
        I_m "kg*m^2" required, open 0.0 to inf, "moment of inertia of the motor";
        I1 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the driving gear";
        I2 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the driven gear";
        I_l "kg*m^2" required, open 0.0 to inf, "moment of inertia of the load";
        k_m "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the motor's shaft";
        k_l "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the load's shaft";
        T_motor "N*m" required, open -inf to inf, "driving torque of the motor";
        T_load "N*m" required, open -inf to inf, "load torque of the load, against its rotation";
        alpha_M "1/s" default 0.0, from 0.0 to inf, "damping in proportion to inertia";
        beta_K "s" default 0.0, from 0.0 to inf, "damping in proportion to stiffness";
    }
    laws {
        k12 "N/m" phase theta period 6.283185307179586 rolling, "stiffness of the mesh along the line of action";
    }
    motions {
        speed "rad/s" { theta_dot = N1; }, "rotational speed of the driving gear";
    }
    effects {
        stiffness_step "the mesh stiffness steps as tooth pairs enter and leave, with the jump terms that conserve energy; without it the stiffness is constant at its mid value";
        rigid_kinematics requires(stiffness_step) excludes(frozen_phase) "drops the jump terms: speeds pass a step unchanged, and energy is not conserved";
        frozen_phase requires(stiffness_step) excludes(rigid_kinematics) "steps at the times of a steady rotation, k(Omega0 t) for k(theta): the classical equations";
        torques "constant torques of motor and load";
        damping "Rayleigh damping, C = alpha_M M + beta_K K at the mid stiffness";
    }
    conditions {
        jump_terms = stiffness_step, !rigid_kinematics, !frozen_phase;
        moving_phase = stiffness_step, !frozen_phase;
    }

    constants {
        h = r1/N1;
    }
    energies {
        kinetic {
            _ => (I1*(s_dot/(2.0*h*N1) + theta_dot/N1).powi(2) + I2*(theta_dot/N2 - s_dot/(2.0*h*N2)).powi(2) + I_l*(theta_dot/N2 - psi_l_dot - s_dot/(2.0*h*N2)).powi(2) + I_m*(psi_m_dot + s_dot/(2.0*h*N1) + theta_dot/N1).powi(2))/2.0;
        }
        potential {
            _ => (k_l*psi_l.powi(2) + k_m*psi_m.powi(2) + k12*s.powi(2))/2.0;
        }
        dissipation {
            damping => (I1*alpha_M*(s_dot/(2.0*h*N1) + theta_dot/N1).powi(2) + I2*alpha_M*(theta_dot/N2 - s_dot/(2.0*h*N2)).powi(2) + I_l*alpha_M*(theta_dot/N2 - psi_l_dot - s_dot/(2.0*h*N2)).powi(2) + I_m*alpha_M*(psi_m_dot + s_dot/(2.0*h*N1) + theta_dot/N1).powi(2) + beta_K*k_l*psi_l_dot.powi(2) + beta_K*k_m*psi_m_dot.powi(2) + beta_K*k12_mid*s_dot.powi(2))/2.0;
        }
    }
    torques {
        motor "driving torque of the motor" {
            torques => T_motor*(psi_m + s/(2.0*h*N1) + theta/N1);
        }
        load "load torque of the load, against its rotation" {
            torques => T_load*(psi_l + s/(2.0*h*N2) - theta/N2);
        }
    }
    work {
        theta {
            torques => T_motor/N1 - T_load/N2;
        }
        s {
            torques => (T_motor/(h*N1) + T_load/(h*N2))/2.0;
        }
        psi_m {
            torques => T_motor;
        }
        psi_l {
            torques => T_load;
        }
    }
    mass {
        theta theta {
            _ => I1/N1.powi(2) + I2/N2.powi(2) + I_l/N2.powi(2) + I_m/N1.powi(2);
        }
        theta s {
            _ => (I1/(h*N1.powi(2)) - I2/(h*N2.powi(2)) - I_l/(h*N2.powi(2)) + I_m/(h*N1.powi(2)))/2.0;
        }
        theta psi_m {
            _ => I_m/N1;
        }
        theta psi_l {
            _ => -I_l/N2;
        }
        s s {
            _ => (I1/(h.powi(2)*N1.powi(2)) + I2/(h.powi(2)*N2.powi(2)) + I_l/(h.powi(2)*N2.powi(2)) + I_m/(h.powi(2)*N1.powi(2)))/4.0;
        }
        s psi_m {
            _ => I_m/(2.0*h*N1);
        }
        s psi_l {
            _ => I_l/(2.0*h*N2);
        }
        psi_m psi_m {
            _ => I_m;
        }
        psi_l psi_l {
            _ => I_l;
        }
    }
    force {
        theta {
            torques => T_motor/N1 - T_load/N2;
            damping => I_l*alpha_M*psi_l_dot/N2 - I1*alpha_M*theta_dot/N1.powi(2) - I2*alpha_M*theta_dot/N2.powi(2) - I_l*alpha_M*theta_dot/N2.powi(2) - I_m*alpha_M*theta_dot/N1.powi(2) - I_m*alpha_M*psi_m_dot/N1 - I1*alpha_M*s_dot/(2.0*h*N1.powi(2)) + I2*alpha_M*s_dot/(2.0*h*N2.powi(2)) + I_l*alpha_M*s_dot/(2.0*h*N2.powi(2)) - I_m*alpha_M*s_dot/(2.0*h*N1.powi(2));
            jump_terms => -dk12*s.powi(2)/2.0;
        }
        s {
            _ => -k12*s;
            torques => (T_motor/(h*N1) + T_load/(h*N2))/2.0;
            damping => I2*alpha_M*theta_dot/(2.0*h*N2.powi(2)) - beta_K*k12_mid*s_dot - I1*alpha_M*s_dot/(4.0*h.powi(2)*N1.powi(2)) - I2*alpha_M*s_dot/(4.0*h.powi(2)*N2.powi(2)) - I_l*alpha_M*s_dot/(4.0*h.powi(2)*N2.powi(2)) - I_m*alpha_M*s_dot/(4.0*h.powi(2)*N1.powi(2)) - I1*alpha_M*theta_dot/(2.0*h*N1.powi(2)) + I_l*alpha_M*theta_dot/(2.0*h*N2.powi(2)) - I_l*alpha_M*psi_l_dot/(2.0*h*N2) - I_m*alpha_M*theta_dot/(2.0*h*N1.powi(2)) - I_m*alpha_M*psi_m_dot/(2.0*h*N1);
        }
        psi_m {
            _ => -k_m*psi_m;
            torques => T_motor;
            damping => -I_m*alpha_M*psi_m_dot - I_m*alpha_M*theta_dot/N1 - beta_K*k_m*psi_m_dot - I_m*alpha_M*s_dot/(2.0*h*N1);
        }
        psi_l {
            _ => -k_l*psi_l;
            torques => T_load;
            damping => I_l*alpha_M*theta_dot/N2 - I_l*alpha_M*psi_l_dot - beta_K*k_l*psi_l_dot - I_l*alpha_M*s_dot/(2.0*h*N2);
        }
    }
    jacobian {
        theta theta {
            jump_terms => -ddk12*s.powi(2)/2.0;
        }
        theta s {
            jump_terms => -dk12*s;
        }
        theta theta_dot {
            damping => -I1*alpha_M/N1.powi(2) - I2*alpha_M/N2.powi(2) - I_l*alpha_M/N2.powi(2) - I_m*alpha_M/N1.powi(2);
        }
        theta s_dot {
            damping => (I2*alpha_M/(h*N2.powi(2)) - I1*alpha_M/(h*N1.powi(2)) + I_l*alpha_M/(h*N2.powi(2)) - I_m*alpha_M/(h*N1.powi(2)))/2.0;
        }
        theta psi_m_dot {
            damping => -I_m*alpha_M/N1;
        }
        theta psi_l_dot {
            damping => I_l*alpha_M/N2;
        }
        s theta {
            moving_phase => -dk12*s;
        }
        s s {
            _ => -k12;
        }
        s theta_dot {
            damping => (I2*alpha_M/(h*N2.powi(2)) - I1*alpha_M/(h*N1.powi(2)) + I_l*alpha_M/(h*N2.powi(2)) - I_m*alpha_M/(h*N1.powi(2)))/2.0;
        }
        s s_dot {
            damping => -beta_K*k12_mid - I1*alpha_M/(4.0*h.powi(2)*N1.powi(2)) - I2*alpha_M/(4.0*h.powi(2)*N2.powi(2)) - I_l*alpha_M/(4.0*h.powi(2)*N2.powi(2)) - I_m*alpha_M/(4.0*h.powi(2)*N1.powi(2));
        }
        s psi_m_dot {
            damping => -I_m*alpha_M/(2.0*h*N1);
        }
        s psi_l_dot {
            damping => -I_l*alpha_M/(2.0*h*N2);
        }
        psi_m psi_m {
            _ => -k_m;
        }
        psi_m theta_dot {
            damping => -I_m*alpha_M/N1;
        }
        psi_m s_dot {
            damping => -I_m*alpha_M/(2.0*h*N1);
        }
        psi_m psi_m_dot {
            damping => -I_m*alpha_M - beta_K*k_m;
        }
        psi_l psi_l {
            _ => -k_l;
        }
        psi_l theta_dot {
            damping => I_l*alpha_M/N2;
        }
        psi_l s_dot {
            damping => -I_l*alpha_M/(2.0*h*N2);
        }
        psi_l psi_l_dot {
            damping => -I_l*alpha_M - beta_K*k_l;
        }
    }
    cell {
        stiffness {
            s s {
                _ => k12;
            }
            psi_m psi_m {
                _ => k_m;
            }
            psi_l psi_l {
                _ => k_l;
            }
        }
        damping {
            theta theta {
                damping => I1*alpha_M/N1.powi(2) + I2*alpha_M/N2.powi(2) + I_l*alpha_M/N2.powi(2) + I_m*alpha_M/N1.powi(2);
            }
            theta s {
                damping => (I1*alpha_M/(h*N1.powi(2)) - I2*alpha_M/(h*N2.powi(2)) - I_l*alpha_M/(h*N2.powi(2)) + I_m*alpha_M/(h*N1.powi(2)))/2.0;
            }
            theta psi_m {
                damping => I_m*alpha_M/N1;
            }
            theta psi_l {
                damping => -I_l*alpha_M/N2;
            }
            s s {
                damping => beta_K*k12_mid + I1*alpha_M/(4.0*h.powi(2)*N1.powi(2)) + I2*alpha_M/(4.0*h.powi(2)*N2.powi(2)) + I_l*alpha_M/(4.0*h.powi(2)*N2.powi(2)) + I_m*alpha_M/(4.0*h.powi(2)*N1.powi(2));
            }
            s psi_m {
                damping => I_m*alpha_M/(2.0*h*N1);
            }
            s psi_l {
                damping => I_l*alpha_M/(2.0*h*N2);
            }
            psi_m psi_m {
                damping => I_m*alpha_M + beta_K*k_m;
            }
            psi_l psi_l {
                damping => I_l*alpha_M + beta_K*k_l;
            }
        }
        load {
            theta {
                torques => T_motor/N1 - T_load/N2;
            }
            s {
                torques => (T_motor/(h*N1) + T_load/(h*N2))/2.0;
            }
            psi_m {
                torques => T_motor;
            }
            psi_l {
                torques => T_load;
            }
        }
    }
    jump k12 {
        normal {
            theta {
                _ => 1.0;
            }
        }
        step {
            _ => dk12*s.powi(2)/2.0;
        }
    }

    text {
        "T = (I1*(s_dot/(2*h*N1) + theta_dot/N1)^2 + I2*(theta_dot/N2 - s_dot/(2*h*N2))^2 + I_l*(theta_dot/N2 - psi_l_dot - s_dot/(2*h*N2))^2 + I_m*(psi_m_dot + s_dot/(2*h*N1) + theta_dot/N1)^2)/2";
        "V = (k_l*psi_l^2 + k_m*psi_m^2 + k12*s^2)/2";
        "D = (I1*alpha_M*(s_dot/(2*h*N1) + theta_dot/N1)^2 + I2*alpha_M*(theta_dot/N2 - s_dot/(2*h*N2))^2 + I_l*alpha_M*(theta_dot/N2 - psi_l_dot - s_dot/(2*h*N2))^2 + I_m*alpha_M*(psi_m_dot + s_dot/(2*h*N1) + theta_dot/N1)^2 + beta_K*k_l*psi_l_dot^2 + beta_K*k_m*psi_m_dot^2 + beta_K*k12_mid*s_dot^2)/2 [damping]";
        "Q_theta = T_motor/N1 - T_load/N2 [torques]";
        "Q_s = (T_motor/(h*N1) + T_load/(h*N2))/2 [torques]";
        "Q_psi_m = T_motor [torques]";
        "Q_psi_l = T_load [torques]";
        "h = r1/N1";
        "(I1/N1^2 + I2/N2^2 + I_l/N2^2 + I_m/N1^2) theta'' + ((I1/(h*N1^2) - I2/(h*N2^2) - I_l/(h*N2^2) + I_m/(h*N1^2))/2) s'' + (I_m/N1) psi_m'' + (-I_l/N2) psi_l'' = T_motor/N1 - T_load/N2 [torques] + I_l*alpha_M*psi_l_dot/N2 - I1*alpha_M*theta_dot/N1^2 - I2*alpha_M*theta_dot/N2^2 - I_l*alpha_M*theta_dot/N2^2 - I_m*alpha_M*theta_dot/N1^2 - I_m*alpha_M*psi_m_dot/N1 - I1*alpha_M*s_dot/(2*h*N1^2) + I2*alpha_M*s_dot/(2*h*N2^2) + I_l*alpha_M*s_dot/(2*h*N2^2) - I_m*alpha_M*s_dot/(2*h*N1^2) [damping] - dk12*s^2/2 [jump terms]";
        "((I1/(h*N1^2) - I2/(h*N2^2) - I_l/(h*N2^2) + I_m/(h*N1^2))/2) theta'' + ((I1/(h^2*N1^2) + I2/(h^2*N2^2) + I_l/(h^2*N2^2) + I_m/(h^2*N1^2))/4) s'' + (I_m/(2*h*N1)) psi_m'' + (I_l/(2*h*N2)) psi_l'' = -k12*s + (T_motor/(h*N1) + T_load/(h*N2))/2 [torques] + I2*alpha_M*theta_dot/(2*h*N2^2) - beta_K*k12_mid*s_dot - I1*alpha_M*s_dot/(4*h^2*N1^2) - I2*alpha_M*s_dot/(4*h^2*N2^2) - I_l*alpha_M*s_dot/(4*h^2*N2^2) - I_m*alpha_M*s_dot/(4*h^2*N1^2) - I1*alpha_M*theta_dot/(2*h*N1^2) + I_l*alpha_M*theta_dot/(2*h*N2^2) - I_l*alpha_M*psi_l_dot/(2*h*N2) - I_m*alpha_M*theta_dot/(2*h*N1^2) - I_m*alpha_M*psi_m_dot/(2*h*N1) [damping]";
        "(I_m/N1) theta'' + (I_m/(2*h*N1)) s'' + (I_m) psi_m'' = -k_m*psi_m + T_motor [torques] - I_m*alpha_M*psi_m_dot - I_m*alpha_M*theta_dot/N1 - beta_K*k_m*psi_m_dot - I_m*alpha_M*s_dot/(2*h*N1) [damping]";
        "(-I_l/N2) theta'' + (I_l/(2*h*N2)) s'' + (I_l) psi_l'' = -k_l*psi_l + T_load [torques] + I_l*alpha_M*theta_dot/N2 - I_l*alpha_M*psi_l_dot - beta_K*k_l*psi_l_dot - I_l*alpha_M*s_dot/(2*h*N2) [damping]";
        "at a step dk12 of k12 in theta: v+^2 = v-^2 - 2*G*(dk12*s^2/2)";
        "M q'' + C q' + K q = f with constant M, C, K, f: linear, solved exactly";
    }
    latex {
        "T = \\frac{1}{2} (I_{1}\\, \\left(\\frac{\\dot{s}}{2\\, h\\, N_{1}} + \\frac{\\dot{\\theta}}{N_{1}}\\right)^{2} + I_{2}\\, \\left(\\frac{\\dot{\\theta}}{N_{2}} - \\frac{\\dot{s}}{2\\, h\\, N_{2}}\\right)^{2} + I_{l}\\, \\left(\\frac{\\dot{\\theta}}{N_{2}} - \\dot{\\psi_{l}} - \\frac{\\dot{s}}{2\\, h\\, N_{2}}\\right)^{2} + I_{m}\\, \\left(\\dot{\\psi_{m}} + \\frac{\\dot{s}}{2\\, h\\, N_{1}} + \\frac{\\dot{\\theta}}{N_{1}}\\right)^{2})";
        "V = \\frac{1}{2} (k_{l}\\, \\psi_{l}^{2} + k_{m}\\, \\psi_{m}^{2} + k_{12}\\, s^{2})";
        "D = \\frac{1}{2} (I_{1}\\, \\alpha_{M}\\, \\left(\\frac{\\dot{s}}{2\\, h\\, N_{1}} + \\frac{\\dot{\\theta}}{N_{1}}\\right)^{2} + I_{2}\\, \\alpha_{M}\\, \\left(\\frac{\\dot{\\theta}}{N_{2}} - \\frac{\\dot{s}}{2\\, h\\, N_{2}}\\right)^{2} + I_{l}\\, \\alpha_{M}\\, \\left(\\frac{\\dot{\\theta}}{N_{2}} - \\dot{\\psi_{l}} - \\frac{\\dot{s}}{2\\, h\\, N_{2}}\\right)^{2} + I_{m}\\, \\alpha_{M}\\, \\left(\\dot{\\psi_{m}} + \\frac{\\dot{s}}{2\\, h\\, N_{1}} + \\frac{\\dot{\\theta}}{N_{1}}\\right)^{2} + \\beta_{K}\\, k_{l}\\, \\dot{\\psi_{l}}^{2} + \\beta_{K}\\, k_{m}\\, \\dot{\\psi_{m}}^{2} + \\beta_{K}\\, \\bar{k_{12}}\\, \\dot{s}^{2})\\ [\\text{damping}]";
        "Q_{\\theta} = \\frac{T_{motor}}{N_{1}} - \\frac{T_{load}}{N_{2}}\\ [\\text{torques}]";
        "Q_{s} = \\frac{1}{2} (\\frac{T_{motor}}{h\\, N_{1}} + \\frac{T_{load}}{h\\, N_{2}})\\ [\\text{torques}]";
        "Q_{\\psi_{m}} = T_{motor}\\ [\\text{torques}]";
        "Q_{\\psi_{l}} = T_{load}\\ [\\text{torques}]";
        "h = \\frac{r_{1}}{N_{1}}";
        "(\\frac{I_{1}}{N_{1}^{2}} + \\frac{I_{2}}{N_{2}^{2}} + \\frac{I_{l}}{N_{2}^{2}} + \\frac{I_{m}}{N_{1}^{2}}) \\ddot{\\theta} + (\\frac{1}{2} (\\frac{I_{1}}{h\\, N_{1}^{2}} - \\frac{I_{2}}{h\\, N_{2}^{2}} - \\frac{I_{l}}{h\\, N_{2}^{2}} + \\frac{I_{m}}{h\\, N_{1}^{2}})) \\ddot{s} + (\\frac{I_{m}}{N_{1}}) \\ddot{\\psi_{m}} + (-\\frac{I_{l}}{N_{2}}) \\ddot{\\psi_{l}} = \\frac{T_{motor}}{N_{1}} - \\frac{T_{load}}{N_{2}}\\ [\\text{torques}] + \\frac{I_{l}\\, \\alpha_{M}\\, \\dot{\\psi_{l}}}{N_{2}} - \\frac{I_{1}\\, \\alpha_{M}\\, \\dot{\\theta}}{N_{1}^{2}} - \\frac{I_{2}\\, \\alpha_{M}\\, \\dot{\\theta}}{N_{2}^{2}} - \\frac{I_{l}\\, \\alpha_{M}\\, \\dot{\\theta}}{N_{2}^{2}} - \\frac{I_{m}\\, \\alpha_{M}\\, \\dot{\\theta}}{N_{1}^{2}} - \\frac{I_{m}\\, \\alpha_{M}\\, \\dot{\\psi_{m}}}{N_{1}} - \\frac{I_{1}\\, \\alpha_{M}\\, \\dot{s}}{2\\, h\\, N_{1}^{2}} + \\frac{I_{2}\\, \\alpha_{M}\\, \\dot{s}}{2\\, h\\, N_{2}^{2}} + \\frac{I_{l}\\, \\alpha_{M}\\, \\dot{s}}{2\\, h\\, N_{2}^{2}} - \\frac{I_{m}\\, \\alpha_{M}\\, \\dot{s}}{2\\, h\\, N_{1}^{2}}\\ [\\text{damping}] - \\frac{k_{12}'\\, s^{2}}{2}\\ [\\text{jump terms}]";
        "(\\frac{1}{2} (\\frac{I_{1}}{h\\, N_{1}^{2}} - \\frac{I_{2}}{h\\, N_{2}^{2}} - \\frac{I_{l}}{h\\, N_{2}^{2}} + \\frac{I_{m}}{h\\, N_{1}^{2}})) \\ddot{\\theta} + (\\frac{1}{4} (\\frac{I_{1}}{h^{2}\\, N_{1}^{2}} + \\frac{I_{2}}{h^{2}\\, N_{2}^{2}} + \\frac{I_{l}}{h^{2}\\, N_{2}^{2}} + \\frac{I_{m}}{h^{2}\\, N_{1}^{2}})) \\ddot{s} + (\\frac{I_{m}}{2\\, h\\, N_{1}}) \\ddot{\\psi_{m}} + (\\frac{I_{l}}{2\\, h\\, N_{2}}) \\ddot{\\psi_{l}} = -k_{12}\\, s + \\frac{1}{2} (\\frac{T_{motor}}{h\\, N_{1}} + \\frac{T_{load}}{h\\, N_{2}})\\ [\\text{torques}] + \\frac{I_{2}\\, \\alpha_{M}\\, \\dot{\\theta}}{2\\, h\\, N_{2}^{2}} - \\beta_{K}\\, \\bar{k_{12}}\\, \\dot{s} - \\frac{I_{1}\\, \\alpha_{M}\\, \\dot{s}}{4\\, h^{2}\\, N_{1}^{2}} - \\frac{I_{2}\\, \\alpha_{M}\\, \\dot{s}}{4\\, h^{2}\\, N_{2}^{2}} - \\frac{I_{l}\\, \\alpha_{M}\\, \\dot{s}}{4\\, h^{2}\\, N_{2}^{2}} - \\frac{I_{m}\\, \\alpha_{M}\\, \\dot{s}}{4\\, h^{2}\\, N_{1}^{2}} - \\frac{I_{1}\\, \\alpha_{M}\\, \\dot{\\theta}}{2\\, h\\, N_{1}^{2}} + \\frac{I_{l}\\, \\alpha_{M}\\, \\dot{\\theta}}{2\\, h\\, N_{2}^{2}} - \\frac{I_{l}\\, \\alpha_{M}\\, \\dot{\\psi_{l}}}{2\\, h\\, N_{2}} - \\frac{I_{m}\\, \\alpha_{M}\\, \\dot{\\theta}}{2\\, h\\, N_{1}^{2}} - \\frac{I_{m}\\, \\alpha_{M}\\, \\dot{\\psi_{m}}}{2\\, h\\, N_{1}}\\ [\\text{damping}]";
        "(\\frac{I_{m}}{N_{1}}) \\ddot{\\theta} + (\\frac{I_{m}}{2\\, h\\, N_{1}}) \\ddot{s} + (I_{m}) \\ddot{\\psi_{m}} = -k_{m}\\, \\psi_{m} + T_{motor}\\ [\\text{torques}] - I_{m}\\, \\alpha_{M}\\, \\dot{\\psi_{m}} - \\frac{I_{m}\\, \\alpha_{M}\\, \\dot{\\theta}}{N_{1}} - \\beta_{K}\\, k_{m}\\, \\dot{\\psi_{m}} - \\frac{I_{m}\\, \\alpha_{M}\\, \\dot{s}}{2\\, h\\, N_{1}}\\ [\\text{damping}]";
        "(-\\frac{I_{l}}{N_{2}}) \\ddot{\\theta} + (\\frac{I_{l}}{2\\, h\\, N_{2}}) \\ddot{s} + (I_{l}) \\ddot{\\psi_{l}} = -k_{l}\\, \\psi_{l} + T_{load}\\ [\\text{torques}] + \\frac{I_{l}\\, \\alpha_{M}\\, \\dot{\\theta}}{N_{2}} - I_{l}\\, \\alpha_{M}\\, \\dot{\\psi_{l}} - \\beta_{K}\\, k_{l}\\, \\dot{\\psi_{l}} - \\frac{I_{l}\\, \\alpha_{M}\\, \\dot{s}}{2\\, h\\, N_{2}}\\ [\\text{damping}]";
    }
}
