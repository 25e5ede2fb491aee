//! Equations of motion of `idler`: two gears with an idler between them.
//!
//! Derived from the energies in `models/src/idler.rs` by `cargo xtask derive idler`. Do not edit: change the
//! energies and derive again.
//! Source: standard torsional model; phase as Oh, Grosh & Barber (2005), on the idler
//!
//! # Energies
//!
//! ```text
//! T = (I1*(delta1_dot/(h*N1) + theta_dot/N1)^2 + I2*theta_dot^2/N2^2 + I3*(theta_dot/N3 - delta2_dot/(h*N3))^2)/2
//! V = (k12*delta12^2 + k23*delta23^2)/2
//! D = (I1*alpha_M*(delta1_dot/(h*N1) + theta_dot/N1)^2 + I2*alpha_M*theta_dot^2/N2^2 + I3*alpha_M*(theta_dot/N3 - delta2_dot/(h*N3))^2 + beta_K*k12_mid*delta12_dot^2 + beta_K*k23_mid*delta23_dot^2)/2 [damping]
//! Q_theta = T_motor/N1 - T_load/N3 [torques]
//! Q_delta1 = T_motor/(h*N1) [torques]
//! Q_delta2 = T_load/(h*N3) [torques]
//! ```
//!
//! # Constants
//!
//! ```text
//! h = r2/N2
//! ```
//!
//! # Deflections
//!
//! ```text
//! delta12 = delta1 - e12
//! delta23 = delta2 - e23
//! e12 = 0 without transmission error; the rates are those of the coordinates, without that of e12
//! e23 = 0 without transmission error; the rates are those of the coordinates, without that of e23
//! ```
//!
//! # Equations of motion
//!
//! ```text
//! (I1/N1^2 + I2/N2^2 + I3/N3^2) theta'' + (I1/(h*N1^2)) delta1'' + (-I3/(h*N3^2)) delta2'' = k12*de12*delta12 + k23*de23*delta23 [transmission error, jump terms] + T_motor/N1 - T_load/N3 [torques] + I3*alpha_M*delta2_dot/(h*N3^2) - I1*alpha_M*theta_dot/N1^2 - I2*alpha_M*theta_dot/N2^2 - I3*alpha_M*theta_dot/N3^2 - I1*alpha_M*delta1_dot/(h*N1^2) [damping] + (-dk12*delta12^2 - dk23*delta23^2)/2 [jump terms]
//! (I1/(h*N1^2)) theta'' + (I1/(h^2*N1^2)) delta1'' = -k12*delta12 + T_motor/(h*N1) [torques] - beta_K*k12_mid*delta12_dot - I1*alpha_M*delta1_dot/(h^2*N1^2) - I1*alpha_M*theta_dot/(h*N1^2) [damping]
//! (-I3/(h*N3^2)) theta'' + (I3/(h^2*N3^2)) delta2'' = -k23*delta23 + T_load/(h*N3) [torques] + I3*alpha_M*theta_dot/(h*N3^2) - beta_K*k23_mid*delta23_dot - I3*alpha_M*delta2_dot/(h^2*N3^2) [damping]
//! ```
//!
//! # At a step of a stiffness or a transmission error
//!
//! ```text
//! at a step dk12 of k12 in theta: v+^2 = v-^2 - 2*G*(dk12*delta12^2/2)
//! at a step dk23 of k23 in theta: v+^2 = v-^2 - 2*G*(dk23*delta23^2/2)
//! at a step de12 of e12 in theta: v+^2 = v-^2 - 2*G*(k12*de12^2/2 - k12*de12*delta12)
//! at a step de23 of e23 in theta: v+^2 = v-^2 - 2*G*(k23*de23^2/2 - k23*de23*delta23)
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
//! T = \frac{1}{2} (I_{1}\, \left(\frac{\dot{\delta_{1}}}{h\, N_{1}} + \frac{\dot{\theta}}{N_{1}}\right)^{2} + \frac{I_{2}\, \dot{\theta}^{2}}{N_{2}^{2}} + I_{3}\, \left(\frac{\dot{\theta}}{N_{3}} - \frac{\dot{\delta_{2}}}{h\, N_{3}}\right)^{2})
//! V = \frac{1}{2} (k_{12}\, \delta_{12}^{2} + k_{23}\, \delta_{23}^{2})
//! D = \frac{1}{2} (I_{1}\, \alpha_{M}\, \left(\frac{\dot{\delta_{1}}}{h\, N_{1}} + \frac{\dot{\theta}}{N_{1}}\right)^{2} + \frac{I_{2}\, \alpha_{M}\, \dot{\theta}^{2}}{N_{2}^{2}} + I_{3}\, \alpha_{M}\, \left(\frac{\dot{\theta}}{N_{3}} - \frac{\dot{\delta_{2}}}{h\, N_{3}}\right)^{2} + \beta_{K}\, \bar{k_{12}}\, \dot{\delta_{12}}^{2} + \beta_{K}\, \bar{k_{23}}\, \dot{\delta_{23}}^{2})\ [\text{damping}]
//! Q_{\theta} = \frac{T_{motor}}{N_{1}} - \frac{T_{load}}{N_{3}}\ [\text{torques}]
//! Q_{\delta_{1}} = \frac{T_{motor}}{h\, N_{1}}\ [\text{torques}]
//! Q_{\delta_{2}} = \frac{T_{load}}{h\, N_{3}}\ [\text{torques}]
//! h = \frac{r_{2}}{N_{2}}
//! \delta_{12} = \delta_{1} - e_{12}
//! \delta_{23} = \delta_{2} - e_{23}
//! (\frac{I_{1}}{N_{1}^{2}} + \frac{I_{2}}{N_{2}^{2}} + \frac{I_{3}}{N_{3}^{2}}) \ddot{\theta} + (\frac{I_{1}}{h\, N_{1}^{2}}) \ddot{\delta_{1}} + (-\frac{I_{3}}{h\, N_{3}^{2}}) \ddot{\delta_{2}} = k_{12}\, e_{12}'\, \delta_{12} + k_{23}\, e_{23}'\, \delta_{23}\ [\text{transmission error, jump terms}] + \frac{T_{motor}}{N_{1}} - \frac{T_{load}}{N_{3}}\ [\text{torques}] + \frac{I_{3}\, \alpha_{M}\, \dot{\delta_{2}}}{h\, N_{3}^{2}} - \frac{I_{1}\, \alpha_{M}\, \dot{\theta}}{N_{1}^{2}} - \frac{I_{2}\, \alpha_{M}\, \dot{\theta}}{N_{2}^{2}} - \frac{I_{3}\, \alpha_{M}\, \dot{\theta}}{N_{3}^{2}} - \frac{I_{1}\, \alpha_{M}\, \dot{\delta_{1}}}{h\, N_{1}^{2}}\ [\text{damping}] + \frac{1}{2} (-k_{12}'\, \delta_{12}^{2} - k_{23}'\, \delta_{23}^{2})\ [\text{jump terms}]
//! (\frac{I_{1}}{h\, N_{1}^{2}}) \ddot{\theta} + (\frac{I_{1}}{h^{2}\, N_{1}^{2}}) \ddot{\delta_{1}} = -k_{12}\, \delta_{12} + \frac{T_{motor}}{h\, N_{1}}\ [\text{torques}] - \beta_{K}\, \bar{k_{12}}\, \dot{\delta_{12}} - \frac{I_{1}\, \alpha_{M}\, \dot{\delta_{1}}}{h^{2}\, N_{1}^{2}} - \frac{I_{1}\, \alpha_{M}\, \dot{\theta}}{h\, N_{1}^{2}}\ [\text{damping}]
//! (-\frac{I_{3}}{h\, N_{3}^{2}}) \ddot{\theta} + (\frac{I_{3}}{h^{2}\, N_{3}^{2}}) \ddot{\delta_{2}} = -k_{23}\, \delta_{23} + \frac{T_{load}}{h\, N_{3}}\ [\text{torques}] + \frac{I_{3}\, \alpha_{M}\, \dot{\theta}}{h\, N_{3}^{2}} - \beta_{K}\, \bar{k_{23}}\, \dot{\delta_{23}} - \frac{I_{3}\, \alpha_{M}\, \dot{\delta_{2}}}{h^{2}\, N_{3}^{2}}\ [\text{damping}]
//! ```
//!
//! # Proved
//!
//! - d/dt (q'.dT/dq' - T + V) = Q.q' - q'.dD/dq' along the motion, for every value and slope of every law, with any set of the additive effects
//! - M is symmetric
//! - every deflection is the sum of the coordinates by which the equations differentiate it
//! - M is positive definite: every leading minor is a sum of products of positive quantities
//! - without the jump terms the balance fails: energy is created at the rate dk12*delta12^2*theta_dot/2 - k12*de12*delta12*theta_dot - k23*de23*delta23*theta_dot + dk23*delta23^2*theta_dot/2
//!
//! # Operations, all effects present
//!
//! | output | sums | products, quotients | functions, roots |
//! | --- | --- | --- | --- |
//! | constants (once a scene) | 0 | 1 | 0 |
//! | force | 11 | 66 | 0 |
//! | energy step of k12 | 0 | 3 | 0 |
//! | energy step of k23 | 0 | 3 | 0 |
//! | energy step of e12 | 1 | 5 | 0 |
//! | energy step of e23 | 1 | 5 | 0 |

use gearsim_macros::equations;

equations! {
    model idler "two gears with an idler between them";
    source "standard torsional model; phase as Oh, Grosh & Barber (2005), on the idler";

    coordinates {
        theta "rad" start 0.0, "rotation of the idler in teeth, one pitch 2 pi";
        delta1 "m" start static, "deflection of the mesh of gears 1 and 2";
        delta2 "m" start static, "deflection of the mesh of gears 2 and 3";
    }
    parameters {
        N1 "1" required, open 0.0 to inf, "number of teeth of gear 1";
        N2 "1" required, open 0.0 to inf, "number of teeth of gear 2";
        N3 "1" required, open 0.0 to inf, "number of teeth of gear 3";
        r2 "m" required, open 0.0 to inf, "base radius of the idler";
        I1 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the driving gear";
        I2 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the idler";
        I3 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the driven gear";
        T_motor "N*m" required, open -inf to inf, "driving torque of the driving gear";
        T_load "N*m" required, open -inf to inf, "load torque of the driven gear, against its rotation";
        alpha_M "1/s" default 0.0, from 0.0 to inf, "damping in proportion to inertia";
        beta_K "s" default 0.0, from 0.0 to inf, "damping in proportion to stiffness";
    }
    laws {
        k12 "N/m" phase theta period 6.283185307179586 rolling, "stiffness of the mesh of gears 1 and 2 along the line of action";
        k23 "N/m" phase theta period 6.283185307179586 rolling, "stiffness of the mesh of gears 2 and 3 along the line of action";
        e12 "m" phase theta period 6.283185307179586 rolling with transmission_error, "transmission error of the mesh of gears 1 and 2 along the line of action";
        e23 "m" phase theta period 6.283185307179586 rolling with transmission_error, "transmission error of the mesh of gears 2 and 3 along the line of action";
    }
    motions {
        speed "rad/s" { theta_dot = N1; }, "rotational speed of the driving gear";
    }
    effects {
        stiffness_step "the mesh stiffness steps as tooth pairs enter and leave, with the jump terms that conserve energy; without it the stiffness is constant at its mid value";
        rigid_kinematics requires(stiffness_step) excludes(frozen_phase) "drops the jump terms: speeds pass a step unchanged, and energy is not conserved";
        frozen_phase requires(stiffness_step) excludes(rigid_kinematics) "steps at the times of a steady rotation, k(Omega0 t) for k(theta): the classical equations";
        transmission_error requires(stiffness_step) "flanks deviate from their ideal places: V = k (delta - e)^2/2, with the jump terms of e where it steps";
        torques "constant torques of motor and load";
        damping "Rayleigh damping, C = alpha_M M + beta_K K at the mid stiffness";
    }
    conditions {
        jump_terms = stiffness_step, !rigid_kinematics, !frozen_phase;
        moving_phase = stiffness_step, !frozen_phase;
        transmission_error_and_jump_terms = transmission_error, stiffness_step, !rigid_kinematics, !frozen_phase;
        transmission_error_and_moving_phase = transmission_error, stiffness_step, !frozen_phase;
    }

    constants {
        h = r2/N2;
    }
    deflections {
        delta12 = delta1 - e12;
        delta23 = delta2 - e23;
    }
    energies {
        kinetic {
            _ => (I1*(delta1_dot/(h*N1) + theta_dot/N1).powi(2) + I2*theta_dot.powi(2)/N2.powi(2) + I3*(theta_dot/N3 - delta2_dot/(h*N3)).powi(2))/2.0;
        }
        potential {
            _ => (k12*delta12.powi(2) + k23*delta23.powi(2))/2.0;
        }
        dissipation {
            damping => (I1*alpha_M*(delta1_dot/(h*N1) + theta_dot/N1).powi(2) + I2*alpha_M*theta_dot.powi(2)/N2.powi(2) + I3*alpha_M*(theta_dot/N3 - delta2_dot/(h*N3)).powi(2) + beta_K*k12_mid*delta12_dot.powi(2) + beta_K*k23_mid*delta23_dot.powi(2))/2.0;
        }
    }
    torques {
        motor "driving torque of the driving gear" {
            torques => T_motor*(delta1/(h*N1) + theta/N1);
        }
        load "load torque of the driven gear, against its rotation" {
            torques => T_load*(delta2/(h*N3) - theta/N3);
        }
    }
    work {
        theta {
            torques => T_motor/N1 - T_load/N3;
        }
        delta1 {
            torques => T_motor/(h*N1);
        }
        delta2 {
            torques => T_load/(h*N3);
        }
    }
    mass {
        theta theta {
            _ => I1/N1.powi(2) + I2/N2.powi(2) + I3/N3.powi(2);
        }
        theta delta1 {
            _ => I1/(h*N1.powi(2));
        }
        theta delta2 {
            _ => -I3/(h*N3.powi(2));
        }
        delta1 delta1 {
            _ => I1/(h.powi(2)*N1.powi(2));
        }
        delta2 delta2 {
            _ => I3/(h.powi(2)*N3.powi(2));
        }
    }
    force {
        theta {
            transmission_error_and_jump_terms => k12*de12*delta12 + k23*de23*delta23;
            torques => T_motor/N1 - T_load/N3;
            damping => I3*alpha_M*delta2_dot/(h*N3.powi(2)) - I1*alpha_M*theta_dot/N1.powi(2) - I2*alpha_M*theta_dot/N2.powi(2) - I3*alpha_M*theta_dot/N3.powi(2) - I1*alpha_M*delta1_dot/(h*N1.powi(2));
            jump_terms => (-dk12*delta12.powi(2) - dk23*delta23.powi(2))/2.0;
        }
        delta1 {
            _ => -k12*delta12;
            torques => T_motor/(h*N1);
            damping => -beta_K*k12_mid*delta12_dot - I1*alpha_M*delta1_dot/(h.powi(2)*N1.powi(2)) - I1*alpha_M*theta_dot/(h*N1.powi(2));
        }
        delta2 {
            _ => -k23*delta23;
            torques => T_load/(h*N3);
            damping => I3*alpha_M*theta_dot/(h*N3.powi(2)) - beta_K*k23_mid*delta23_dot - I3*alpha_M*delta2_dot/(h.powi(2)*N3.powi(2));
        }
    }
    jacobian {
        theta theta {
            transmission_error_and_jump_terms => k12*dde12*delta12 - k12*de12.powi(2) + k23*dde23*delta23 - k23*de23.powi(2) + 2.0*de12*dk12*delta12 + 2.0*de23*dk23*delta23;
            jump_terms => (-ddk12*delta12.powi(2) - ddk23*delta23.powi(2))/2.0;
        }
        theta delta1 {
            transmission_error_and_jump_terms => k12*de12;
            jump_terms => -dk12*delta12;
        }
        theta delta2 {
            transmission_error_and_jump_terms => k23*de23;
            jump_terms => -dk23*delta23;
        }
        theta theta_dot {
            damping => -I1*alpha_M/N1.powi(2) - I2*alpha_M/N2.powi(2) - I3*alpha_M/N3.powi(2);
        }
        theta delta1_dot {
            damping => -I1*alpha_M/(h*N1.powi(2));
        }
        theta delta2_dot {
            damping => I3*alpha_M/(h*N3.powi(2));
        }
        delta1 theta {
            transmission_error_and_moving_phase => k12*de12;
            moving_phase => -dk12*delta12;
        }
        delta1 delta1 {
            _ => -k12;
        }
        delta1 theta_dot {
            damping => -I1*alpha_M/(h*N1.powi(2));
        }
        delta1 delta1_dot {
            damping => -beta_K*k12_mid - I1*alpha_M/(h.powi(2)*N1.powi(2));
        }
        delta2 theta {
            transmission_error_and_moving_phase => k23*de23;
            moving_phase => -dk23*delta23;
        }
        delta2 delta2 {
            _ => -k23;
        }
        delta2 theta_dot {
            damping => I3*alpha_M/(h*N3.powi(2));
        }
        delta2 delta2_dot {
            damping => -beta_K*k23_mid - I3*alpha_M/(h.powi(2)*N3.powi(2));
        }
    }
    cell {
        stiffness {
            delta1 delta1 {
                _ => k12;
            }
            delta2 delta2 {
                _ => k23;
            }
        }
        damping {
            theta theta {
                damping => I1*alpha_M/N1.powi(2) + I2*alpha_M/N2.powi(2) + I3*alpha_M/N3.powi(2);
            }
            theta delta1 {
                damping => I1*alpha_M/(h*N1.powi(2));
            }
            theta delta2 {
                damping => -I3*alpha_M/(h*N3.powi(2));
            }
            delta1 delta1 {
                damping => beta_K*k12_mid + I1*alpha_M/(h.powi(2)*N1.powi(2));
            }
            delta2 delta2 {
                damping => beta_K*k23_mid + I3*alpha_M/(h.powi(2)*N3.powi(2));
            }
        }
        load {
            theta {
                torques => T_motor/N1 - T_load/N3;
            }
            delta1 {
                _ => k12*e12;
                torques => T_motor/(h*N1);
            }
            delta2 {
                _ => k23*e23;
                torques => T_load/(h*N3);
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
            _ => dk12*delta12.powi(2)/2.0;
        }
    }
    jump k23 {
        normal {
            theta {
                _ => 1.0;
            }
        }
        step {
            _ => dk23*delta23.powi(2)/2.0;
        }
    }
    jump e12 {
        normal {
            theta {
                _ => 1.0;
            }
        }
        step {
            _ => k12*de12.powi(2)/2.0 - k12*de12*delta12;
        }
    }
    jump e23 {
        normal {
            theta {
                _ => 1.0;
            }
        }
        step {
            _ => k23*de23.powi(2)/2.0 - k23*de23*delta23;
        }
    }

    text {
        "T = (I1*(delta1_dot/(h*N1) + theta_dot/N1)^2 + I2*theta_dot^2/N2^2 + I3*(theta_dot/N3 - delta2_dot/(h*N3))^2)/2";
        "V = (k12*delta12^2 + k23*delta23^2)/2";
        "D = (I1*alpha_M*(delta1_dot/(h*N1) + theta_dot/N1)^2 + I2*alpha_M*theta_dot^2/N2^2 + I3*alpha_M*(theta_dot/N3 - delta2_dot/(h*N3))^2 + beta_K*k12_mid*delta12_dot^2 + beta_K*k23_mid*delta23_dot^2)/2 [damping]";
        "Q_theta = T_motor/N1 - T_load/N3 [torques]";
        "Q_delta1 = T_motor/(h*N1) [torques]";
        "Q_delta2 = T_load/(h*N3) [torques]";
        "h = r2/N2";
        "delta12 = delta1 - e12";
        "delta23 = delta2 - e23";
        "e12 = 0 without transmission error; the rates are those of the coordinates, without that of e12";
        "e23 = 0 without transmission error; the rates are those of the coordinates, without that of e23";
        "(I1/N1^2 + I2/N2^2 + I3/N3^2) theta'' + (I1/(h*N1^2)) delta1'' + (-I3/(h*N3^2)) delta2'' = k12*de12*delta12 + k23*de23*delta23 [transmission error, jump terms] + T_motor/N1 - T_load/N3 [torques] + I3*alpha_M*delta2_dot/(h*N3^2) - I1*alpha_M*theta_dot/N1^2 - I2*alpha_M*theta_dot/N2^2 - I3*alpha_M*theta_dot/N3^2 - I1*alpha_M*delta1_dot/(h*N1^2) [damping] + (-dk12*delta12^2 - dk23*delta23^2)/2 [jump terms]";
        "(I1/(h*N1^2)) theta'' + (I1/(h^2*N1^2)) delta1'' = -k12*delta12 + T_motor/(h*N1) [torques] - beta_K*k12_mid*delta12_dot - I1*alpha_M*delta1_dot/(h^2*N1^2) - I1*alpha_M*theta_dot/(h*N1^2) [damping]";
        "(-I3/(h*N3^2)) theta'' + (I3/(h^2*N3^2)) delta2'' = -k23*delta23 + T_load/(h*N3) [torques] + I3*alpha_M*theta_dot/(h*N3^2) - beta_K*k23_mid*delta23_dot - I3*alpha_M*delta2_dot/(h^2*N3^2) [damping]";
        "at a step dk12 of k12 in theta: v+^2 = v-^2 - 2*G*(dk12*delta12^2/2)";
        "at a step dk23 of k23 in theta: v+^2 = v-^2 - 2*G*(dk23*delta23^2/2)";
        "at a step de12 of e12 in theta: v+^2 = v-^2 - 2*G*(k12*de12^2/2 - k12*de12*delta12)";
        "at a step de23 of e23 in theta: v+^2 = v-^2 - 2*G*(k23*de23^2/2 - k23*de23*delta23)";
        "M q'' + C q' + K q = f with constant M, C, K, f: linear, solved exactly";
    }
    latex {
        "T = \\frac{1}{2} (I_{1}\\, \\left(\\frac{\\dot{\\delta_{1}}}{h\\, N_{1}} + \\frac{\\dot{\\theta}}{N_{1}}\\right)^{2} + \\frac{I_{2}\\, \\dot{\\theta}^{2}}{N_{2}^{2}} + I_{3}\\, \\left(\\frac{\\dot{\\theta}}{N_{3}} - \\frac{\\dot{\\delta_{2}}}{h\\, N_{3}}\\right)^{2})";
        "V = \\frac{1}{2} (k_{12}\\, \\delta_{12}^{2} + k_{23}\\, \\delta_{23}^{2})";
        "D = \\frac{1}{2} (I_{1}\\, \\alpha_{M}\\, \\left(\\frac{\\dot{\\delta_{1}}}{h\\, N_{1}} + \\frac{\\dot{\\theta}}{N_{1}}\\right)^{2} + \\frac{I_{2}\\, \\alpha_{M}\\, \\dot{\\theta}^{2}}{N_{2}^{2}} + I_{3}\\, \\alpha_{M}\\, \\left(\\frac{\\dot{\\theta}}{N_{3}} - \\frac{\\dot{\\delta_{2}}}{h\\, N_{3}}\\right)^{2} + \\beta_{K}\\, \\bar{k_{12}}\\, \\dot{\\delta_{12}}^{2} + \\beta_{K}\\, \\bar{k_{23}}\\, \\dot{\\delta_{23}}^{2})\\ [\\text{damping}]";
        "Q_{\\theta} = \\frac{T_{motor}}{N_{1}} - \\frac{T_{load}}{N_{3}}\\ [\\text{torques}]";
        "Q_{\\delta_{1}} = \\frac{T_{motor}}{h\\, N_{1}}\\ [\\text{torques}]";
        "Q_{\\delta_{2}} = \\frac{T_{load}}{h\\, N_{3}}\\ [\\text{torques}]";
        "h = \\frac{r_{2}}{N_{2}}";
        "\\delta_{12} = \\delta_{1} - e_{12}";
        "\\delta_{23} = \\delta_{2} - e_{23}";
        "(\\frac{I_{1}}{N_{1}^{2}} + \\frac{I_{2}}{N_{2}^{2}} + \\frac{I_{3}}{N_{3}^{2}}) \\ddot{\\theta} + (\\frac{I_{1}}{h\\, N_{1}^{2}}) \\ddot{\\delta_{1}} + (-\\frac{I_{3}}{h\\, N_{3}^{2}}) \\ddot{\\delta_{2}} = k_{12}\\, e_{12}'\\, \\delta_{12} + k_{23}\\, e_{23}'\\, \\delta_{23}\\ [\\text{transmission error, jump terms}] + \\frac{T_{motor}}{N_{1}} - \\frac{T_{load}}{N_{3}}\\ [\\text{torques}] + \\frac{I_{3}\\, \\alpha_{M}\\, \\dot{\\delta_{2}}}{h\\, N_{3}^{2}} - \\frac{I_{1}\\, \\alpha_{M}\\, \\dot{\\theta}}{N_{1}^{2}} - \\frac{I_{2}\\, \\alpha_{M}\\, \\dot{\\theta}}{N_{2}^{2}} - \\frac{I_{3}\\, \\alpha_{M}\\, \\dot{\\theta}}{N_{3}^{2}} - \\frac{I_{1}\\, \\alpha_{M}\\, \\dot{\\delta_{1}}}{h\\, N_{1}^{2}}\\ [\\text{damping}] + \\frac{1}{2} (-k_{12}'\\, \\delta_{12}^{2} - k_{23}'\\, \\delta_{23}^{2})\\ [\\text{jump terms}]";
        "(\\frac{I_{1}}{h\\, N_{1}^{2}}) \\ddot{\\theta} + (\\frac{I_{1}}{h^{2}\\, N_{1}^{2}}) \\ddot{\\delta_{1}} = -k_{12}\\, \\delta_{12} + \\frac{T_{motor}}{h\\, N_{1}}\\ [\\text{torques}] - \\beta_{K}\\, \\bar{k_{12}}\\, \\dot{\\delta_{12}} - \\frac{I_{1}\\, \\alpha_{M}\\, \\dot{\\delta_{1}}}{h^{2}\\, N_{1}^{2}} - \\frac{I_{1}\\, \\alpha_{M}\\, \\dot{\\theta}}{h\\, N_{1}^{2}}\\ [\\text{damping}]";
        "(-\\frac{I_{3}}{h\\, N_{3}^{2}}) \\ddot{\\theta} + (\\frac{I_{3}}{h^{2}\\, N_{3}^{2}}) \\ddot{\\delta_{2}} = -k_{23}\\, \\delta_{23} + \\frac{T_{load}}{h\\, N_{3}}\\ [\\text{torques}] + \\frac{I_{3}\\, \\alpha_{M}\\, \\dot{\\theta}}{h\\, N_{3}^{2}} - \\beta_{K}\\, \\bar{k_{23}}\\, \\dot{\\delta_{23}} - \\frac{I_{3}\\, \\alpha_{M}\\, \\dot{\\delta_{2}}}{h^{2}\\, N_{3}^{2}}\\ [\\text{damping}]";
    }
}
