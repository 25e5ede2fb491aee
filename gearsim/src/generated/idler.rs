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
//! Q_theta = -arm12*F_mu12/N1 - arm12*F_mu12/N2 - arm23*F_mu23/N2 - arm23*F_mu23/N3 [sliding friction] + T_motor/N1 - T_load/N3 [torques]
//! Q_delta1 = -tan_a*side12*F_mu12 - arm12*F_mu12/(h*N1) [sliding friction] + T_motor/(h*N1) [torques]
//! Q_delta2 = arm23*F_mu23/(h*N3) - tan_a*side23*F_mu23 [sliding friction] + T_load/(h*N3) [torques]
//! ```
//!
//! # Constants
//!
//! ```text
//! h = r2/N2
//! tan_a = sin(alpha)/cos(alpha)
//! tiny12 = 1/1000000000000
//! tiny23 = 1/1000000000000
//! ```
//!
//! # Deflections
//!
//! ```text
//! delta12 = delta1 - e12
//! delta23 = delta2 - e23
//! tau12 = tan_a*delta1
//! psi12 = delta1/(h*N1) + theta/N1 + theta/N2
//! tau23 = tan_a*delta2
//! psi23 = theta/N2 - delta2/(h*N3) + theta/N3
//! e12 = 0 without transmission error; the rates of deflections do not contain that of e12
//! e23 = 0 without transmission error; the rates of deflections do not contain that of e23
//! side12 = 0 without sliding friction
//! arm12 = 0 without sliding friction
//! side23 = 0 without sliding friction
//! arm23 = 0 without sliding friction
//! ```
//!
//! # Forces
//!
//! ```text
//! F_mu12 = mu12*k12*psi12_dot*sqrt(tiny12^2 + delta12^2)/sqrt(w_mix12^2 + psi12_dot^2) [sliding friction]
//! F_mu23 = mu23*k23*psi23_dot*sqrt(tiny23^2 + delta23^2)/sqrt(w_mix23^2 + psi23_dot^2) [sliding friction]
//! ```
//!
//! # Equations of motion
//!
//! ```text
//! (I1/N1^2 + I2/N2^2 + I3/N3^2) theta'' + (I1/(h*N1^2)) delta1'' + (-I3/(h*N3^2)) delta2'' = k12*de12*delta12 + k23*de23*delta23 [transmission error, jump terms] - arm12*F_mu12/N1 - arm12*F_mu12/N2 - arm23*F_mu23/N2 - arm23*F_mu23/N3 [sliding friction] + T_motor/N1 - T_load/N3 [torques] + I3*alpha_M*delta2_dot/(h*N3^2) - I1*alpha_M*theta_dot/N1^2 - I2*alpha_M*theta_dot/N2^2 - I3*alpha_M*theta_dot/N3^2 - I1*alpha_M*delta1_dot/(h*N1^2) [damping] + (-dk12*delta12^2 - dk23*delta23^2)/2 [jump terms]
//! (I1/(h*N1^2)) theta'' + (I1/(h^2*N1^2)) delta1'' = -k12*delta12 - tan_a*side12*F_mu12 - arm12*F_mu12/(h*N1) [sliding friction] + T_motor/(h*N1) [torques] - beta_K*k12_mid*delta12_dot - I1*alpha_M*delta1_dot/(h^2*N1^2) - I1*alpha_M*theta_dot/(h*N1^2) [damping]
//! (-I3/(h*N3^2)) theta'' + (I3/(h^2*N3^2)) delta2'' = -k23*delta23 + arm23*F_mu23/(h*N3) - tan_a*side23*F_mu23 [sliding friction] + T_load/(h*N3) [torques] + I3*alpha_M*theta_dot/(h*N3^2) - beta_K*k23_mid*delta23_dot - I3*alpha_M*delta2_dot/(h^2*N3^2) [damping]
//! ```
//!
//! # At a step of a stiffness or a transmission error
//!
//! ```text
//! at a step dk12 of k12 in theta: v+^2 = v-^2 - 2*G*(dk12*delta12^2/2)
//! at a step dk23 of k23 in theta: v+^2 = v-^2 - 2*G*(dk23*delta23^2/2)
//! at a step de12 of e12 in theta: v+^2 = v-^2 - 2*G*(k12*de12^2/2 - k12*de12*delta12)
//! at a step de23 of e23 in theta: v+^2 = v-^2 - 2*G*(k23*de23^2/2 - k23*de23*delta23)
//! at a step of side12: dV = 0, the speeds do not change
//! at a step of arm12: dV = 0, the speeds do not change
//! at a step of side23: dV = 0, the speeds do not change
//! at a step of arm23: dV = 0, the speeds do not change
//! ```
//!
//! # Between two steps
//!
//! ```text
//! M q'' + C q' + K q = f with constant M, C, K, f: linear, solved exactly
//! nonlinear with sliding_friction: -mu12*k12*side12*psi12_dot*sqrt(tiny12^2 + delta12^2)/sqrt(w_mix12^2 + psi12_dot^2) in the torque `slide12`
//! nonlinear with sliding_friction: -mu12*k12*arm12*psi12_dot*sqrt(tiny12^2 + delta12^2)/sqrt(w_mix12^2 + psi12_dot^2) in the torque `roll12`
//! nonlinear with sliding_friction: -mu23*k23*side23*psi23_dot*sqrt(tiny23^2 + delta23^2)/sqrt(w_mix23^2 + psi23_dot^2) in the torque `slide23`
//! nonlinear with sliding_friction: -mu23*k23*arm23*psi23_dot*sqrt(tiny23^2 + delta23^2)/sqrt(w_mix23^2 + psi23_dot^2) in the torque `roll23`
//! ```
//!
//! # LaTeX
//!
//! ```latex
//! T = \frac{1}{2} (I_{1}\, \left(\frac{\dot{\delta_{1}}}{h\, N_{1}} + \frac{\dot{\theta}}{N_{1}}\right)^{2} + \frac{I_{2}\, \dot{\theta}^{2}}{N_{2}^{2}} + I_{3}\, \left(\frac{\dot{\theta}}{N_{3}} - \frac{\dot{\delta_{2}}}{h\, N_{3}}\right)^{2})
//! V = \frac{1}{2} (k_{12}\, \delta_{12}^{2} + k_{23}\, \delta_{23}^{2})
//! D = \frac{1}{2} (I_{1}\, \alpha_{M}\, \left(\frac{\dot{\delta_{1}}}{h\, N_{1}} + \frac{\dot{\theta}}{N_{1}}\right)^{2} + \frac{I_{2}\, \alpha_{M}\, \dot{\theta}^{2}}{N_{2}^{2}} + I_{3}\, \alpha_{M}\, \left(\frac{\dot{\theta}}{N_{3}} - \frac{\dot{\delta_{2}}}{h\, N_{3}}\right)^{2} + \beta_{K}\, \bar{k_{12}}\, \dot{\delta_{12}}^{2} + \beta_{K}\, \bar{k_{23}}\, \dot{\delta_{23}}^{2})\ [\text{damping}]
//! Q_{\theta} = -\frac{\mathrm{arm}_{12}\, F_{mu12}}{N_{1}} - \frac{\mathrm{arm}_{12}\, F_{mu12}}{N_{2}} - \frac{\mathrm{arm}_{23}\, F_{mu23}}{N_{2}} - \frac{\mathrm{arm}_{23}\, F_{mu23}}{N_{3}}\ [\text{sliding friction}] + \frac{T_{motor}}{N_{1}} - \frac{T_{load}}{N_{3}}\ [\text{torques}]
//! Q_{\delta_{1}} = -\mathrm{tan}_{a}\, \mathrm{side}_{12}\, F_{mu12} - \frac{\mathrm{arm}_{12}\, F_{mu12}}{h\, N_{1}}\ [\text{sliding friction}] + \frac{T_{motor}}{h\, N_{1}}\ [\text{torques}]
//! Q_{\delta_{2}} = \frac{\mathrm{arm}_{23}\, F_{mu23}}{h\, N_{3}} - \mathrm{tan}_{a}\, \mathrm{side}_{23}\, F_{mu23}\ [\text{sliding friction}] + \frac{T_{load}}{h\, N_{3}}\ [\text{torques}]
//! h = \frac{r_{2}}{N_{2}}
//! \mathrm{tan}_{a} = \frac{\sin\left(\alpha\right)}{\cos\left(\alpha\right)}
//! \mathrm{tiny}_{12} = \frac{1}{1000000000000}
//! \mathrm{tiny}_{23} = \frac{1}{1000000000000}
//! \delta_{12} = \delta_{1} - e_{12}
//! \delta_{23} = \delta_{2} - e_{23}
//! \tau_{12} = \mathrm{tan}_{a}\, \delta_{1}
//! \psi_{12} = \frac{\delta_{1}}{h\, N_{1}} + \frac{\theta}{N_{1}} + \frac{\theta}{N_{2}}
//! \tau_{23} = \mathrm{tan}_{a}\, \delta_{2}
//! \psi_{23} = \frac{\theta}{N_{2}} - \frac{\delta_{2}}{h\, N_{3}} + \frac{\theta}{N_{3}}
//! F_{mu12} = \frac{\mu_{12}\, k_{12}\, \dot{\psi_{12}}\, \sqrt{\mathrm{tiny}_{12}^{2} + \delta_{12}^{2}}}{\sqrt{w_{mix12}^{2} + \dot{\psi_{12}}^{2}}}
//! F_{mu23} = \frac{\mu_{23}\, k_{23}\, \dot{\psi_{23}}\, \sqrt{\mathrm{tiny}_{23}^{2} + \delta_{23}^{2}}}{\sqrt{w_{mix23}^{2} + \dot{\psi_{23}}^{2}}}
//! (\frac{I_{1}}{N_{1}^{2}} + \frac{I_{2}}{N_{2}^{2}} + \frac{I_{3}}{N_{3}^{2}}) \ddot{\theta} + (\frac{I_{1}}{h\, N_{1}^{2}}) \ddot{\delta_{1}} + (-\frac{I_{3}}{h\, N_{3}^{2}}) \ddot{\delta_{2}} = k_{12}\, e_{12}'\, \delta_{12} + k_{23}\, e_{23}'\, \delta_{23}\ [\text{transmission error, jump terms}] - \frac{\mathrm{arm}_{12}\, F_{mu12}}{N_{1}} - \frac{\mathrm{arm}_{12}\, F_{mu12}}{N_{2}} - \frac{\mathrm{arm}_{23}\, F_{mu23}}{N_{2}} - \frac{\mathrm{arm}_{23}\, F_{mu23}}{N_{3}}\ [\text{sliding friction}] + \frac{T_{motor}}{N_{1}} - \frac{T_{load}}{N_{3}}\ [\text{torques}] + \frac{I_{3}\, \alpha_{M}\, \dot{\delta_{2}}}{h\, N_{3}^{2}} - \frac{I_{1}\, \alpha_{M}\, \dot{\theta}}{N_{1}^{2}} - \frac{I_{2}\, \alpha_{M}\, \dot{\theta}}{N_{2}^{2}} - \frac{I_{3}\, \alpha_{M}\, \dot{\theta}}{N_{3}^{2}} - \frac{I_{1}\, \alpha_{M}\, \dot{\delta_{1}}}{h\, N_{1}^{2}}\ [\text{damping}] + \frac{1}{2} (-k_{12}'\, \delta_{12}^{2} - k_{23}'\, \delta_{23}^{2})\ [\text{jump terms}]
//! (\frac{I_{1}}{h\, N_{1}^{2}}) \ddot{\theta} + (\frac{I_{1}}{h^{2}\, N_{1}^{2}}) \ddot{\delta_{1}} = -k_{12}\, \delta_{12} - \mathrm{tan}_{a}\, \mathrm{side}_{12}\, F_{mu12} - \frac{\mathrm{arm}_{12}\, F_{mu12}}{h\, N_{1}}\ [\text{sliding friction}] + \frac{T_{motor}}{h\, N_{1}}\ [\text{torques}] - \beta_{K}\, \bar{k_{12}}\, \dot{\delta_{12}} - \frac{I_{1}\, \alpha_{M}\, \dot{\delta_{1}}}{h^{2}\, N_{1}^{2}} - \frac{I_{1}\, \alpha_{M}\, \dot{\theta}}{h\, N_{1}^{2}}\ [\text{damping}]
//! (-\frac{I_{3}}{h\, N_{3}^{2}}) \ddot{\theta} + (\frac{I_{3}}{h^{2}\, N_{3}^{2}}) \ddot{\delta_{2}} = -k_{23}\, \delta_{23} + \frac{\mathrm{arm}_{23}\, F_{mu23}}{h\, N_{3}} - \mathrm{tan}_{a}\, \mathrm{side}_{23}\, F_{mu23}\ [\text{sliding friction}] + \frac{T_{load}}{h\, N_{3}}\ [\text{torques}] + \frac{I_{3}\, \alpha_{M}\, \dot{\theta}}{h\, N_{3}^{2}} - \beta_{K}\, \bar{k_{23}}\, \dot{\delta_{23}} - \frac{I_{3}\, \alpha_{M}\, \dot{\delta_{2}}}{h^{2}\, N_{3}^{2}}\ [\text{damping}]
//! ```
//!
//! # Proved
//!
//! - d/dt (q'.dT/dq' - T + V) = Q.q' - q'.dD/dq' along the motion, for every value and slope of every law, with any set of the additive effects
//! - M is symmetric
//! - T = q'.M q'/2, with M as written
//! - M is positive definite: every leading minor is a sum of products of positive quantities
//! - at a step of k12, k23, e12, e23: T+ - T- = (v+² - v²)/(2 G) for any v+, where M d = n/G; V+ - V- = dV as written; so T + V is unchanged in transmission (v+² = v² - 2 G dV) and in reflection (v+ = -v, dV = 0)
//! - V is the same on both sides of a step of side12, arm12, side23, arm23: no impulse there
//! - every damper takes energy or none: each term of D has a power q'.dD/dq' that is never negative
//! - the friction `roll12` takes energy or none: its power is never positive
//! - the friction `roll23` takes energy or none: its power is never positive
//! - the friction `slide12` takes with `roll12` energy or none where psi12_dot and arm12 psi12_dot + side12 tau12_dot have one sign: where flanks slide as rolling makes them
//! - the friction `slide23` takes with `roll23` energy or none where psi23_dot and arm23 psi23_dot + side23 tau23_dot have one sign: where flanks slide as rolling makes them
//! - every deflection equals the linear form by which the equations differentiate it
//! - without the jump terms the balance fails: energy is created at the rate dk12*delta12^2*theta_dot/2 - k12*de12*delta12*theta_dot - k23*de23*delta23*theta_dot + dk23*delta23^2*theta_dot/2
//!
//! # Operations, all effects present
//!
//! | output | sums | products, quotients | functions, roots |
//! | --- | --- | --- | --- |
//! | constants (once a scene) | 0 | 2 | 2 |
//! | named forces | 4 | 16 | 4 |
//! | force | 16 | 84 | 0 |
//! | energy step of k12 | 0 | 3 | 0 |
//! | energy step of k23 | 0 | 3 | 0 |
//! | energy step of e12 | 1 | 5 | 0 |
//! | energy step of e23 | 1 | 5 | 0 |
//! | energy step of side12 | 0 | 0 | 0 |
//! | energy step of arm12 | 0 | 0 | 0 |
//! | energy step of side23 | 0 | 0 | 0 |
//! | energy step of arm23 | 0 | 0 | 0 |

use gearsim_macros::equations;

equations! {
    model idler "two gears with an idler between them";
    source "standard torsional model; phase as Oh, Grosh & Barber (2005), on the idler";

    coordinates {
        theta "rad" start 0.0, "rotation of the idler times N2; one pitch is 2 pi";
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
        alpha "rad" default 0.3490658503988659, open 0.0 to inf, "working pressure angle, for friction";
        mu12 "1" required with sliding_friction, from 0.0 to inf, "coefficient of friction of the mesh of gears 1 and 2";
        w_mix12 "rad/s" default 0.1, open 0.0 to inf, "rolling speed omega1 + omega2 of the mesh of gears 1 and 2 below which friction decreases to zero (mixed film)";
        mu23 "1" required with sliding_friction, from 0.0 to inf, "coefficient of friction of the mesh of gears 2 and 3";
        w_mix23 "rad/s" default 0.1, open 0.0 to inf, "rolling speed omega1 + omega2 of the mesh of gears 2 and 3 below which friction decreases to zero (mixed film)";
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
        side12 "1" phase theta period 6.283185307179586 rolling with sliding_friction as side, "share of the force of the mesh of gears 1 and 2 on tooth pairs beyond the pitch point, minus that on pairs before it";
        arm12 "m" phase theta period 6.283185307179586 rolling with sliding_friction as arm, "mean distance of the force of the mesh of gears 1 and 2 from the pitch point along the line of action";
        side23 "1" phase theta period 6.283185307179586 rolling with sliding_friction as side, "share of the force of the mesh of gears 2 and 3 on tooth pairs beyond the pitch point, minus that on pairs before it";
        arm23 "m" phase theta period 6.283185307179586 rolling with sliding_friction as arm, "mean distance of the force of the mesh of gears 2 and 3 from the pitch point along the line of action";
    }
    motions {
        speed "rad/s" { theta_dot = N1; }, "rotational speed of the driving gear";
    }
    effects {
        stiffness_step "the mesh stiffness steps as tooth pairs enter and leave, with the jump terms that conserve energy; without it the stiffness is constant at its mid value";
        rigid_kinematics requires(stiffness_step) excludes(frozen_phase) "drops the jump terms: speeds pass a step unchanged, and energy is not conserved";
        frozen_phase requires(stiffness_step) excludes(rigid_kinematics) "steps at the times of a steady rotation, k(Omega0 t) instead of k(theta): the classical equations";
        transmission_error requires(stiffness_step) "flanks deviate from their ideal position: V = k (delta - e)^2/2, with the jump terms of e where it steps";
        sliding_friction requires(stiffness_step) excludes(rigid_kinematics, frozen_phase) "Coulomb friction between the flanks, against their sliding, which changes its direction when a tooth pair passes the pitch point";
        torques "constant torques of motor and load";
        damping "Rayleigh damping, C = alpha_M M + beta_K K at the mid stiffness";
    }
    conditions {
        jump_terms = stiffness_step, !rigid_kinematics, !frozen_phase;
        moving_phase = stiffness_step, !frozen_phase;
        transmission_error_and_jump_terms = transmission_error, stiffness_step, !rigid_kinematics, !frozen_phase;
        transmission_error_and_sliding_friction_and_moving_phase = transmission_error, sliding_friction, stiffness_step, !frozen_phase;
        sliding_friction_and_moving_phase = sliding_friction, stiffness_step, !frozen_phase;
        transmission_error_and_moving_phase = transmission_error, stiffness_step, !frozen_phase;
    }

    constants {
        h = r2/N2;
        tan_a = alpha.sin()/alpha.cos();
        tiny12 = 1.0/1000000000000.0;
        tiny23 = 1.0/1000000000000.0;
    }
    deflections {
        delta12 = delta1 - e12;
        delta23 = delta2 - e23;
        tau12 = tan_a*delta1;
        psi12 = delta1/(h*N1) + theta/N1 + theta/N2;
        tau23 = tan_a*delta2;
        psi23 = theta/N2 - delta2/(h*N3) + theta/N3;
    }
    forces {
        F_mu12 { sliding_friction => mu12*k12*psi12_dot*(tiny12.powi(2) + delta12.powi(2)).sqrt()/(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt(); }
        F_mu23 { sliding_friction => mu23*k23*psi23_dot*(tiny23.powi(2) + delta23.powi(2)).sqrt()/(w_mix23.powi(2) + psi23_dot.powi(2)).sqrt(); }
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
        slide12 "friction of the mesh of gears 1 and 2, through the sliding of the flanks at the pitch point" {}
        power {
            sliding_friction => -side12*F_mu12*tau12_dot;
        }
        roll12 "friction of the mesh of gears 1 and 2, through the rolling of the gears" {}
        power {
            sliding_friction => -arm12*F_mu12*psi12_dot;
        }
        slide23 "friction of the mesh of gears 2 and 3, through the sliding of the flanks at the pitch point" {}
        power {
            sliding_friction => -side23*F_mu23*tau23_dot;
        }
        roll23 "friction of the mesh of gears 2 and 3, through the rolling of the gears" {}
        power {
            sliding_friction => -arm23*F_mu23*psi23_dot;
        }
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
            sliding_friction => -arm12*F_mu12/N1 - arm12*F_mu12/N2 - arm23*F_mu23/N2 - arm23*F_mu23/N3;
            torques => T_motor/N1 - T_load/N3;
            damping => I3*alpha_M*delta2_dot/(h*N3.powi(2)) - I1*alpha_M*theta_dot/N1.powi(2) - I2*alpha_M*theta_dot/N2.powi(2) - I3*alpha_M*theta_dot/N3.powi(2) - I1*alpha_M*delta1_dot/(h*N1.powi(2));
            jump_terms => (-dk12*delta12.powi(2) - dk23*delta23.powi(2))/2.0;
        }
        delta1 {
            _ => -k12*delta12;
            sliding_friction => -tan_a*side12*F_mu12 - arm12*F_mu12/(h*N1);
            torques => T_motor/(h*N1);
            damping => -beta_K*k12_mid*delta12_dot - I1*alpha_M*delta1_dot/(h.powi(2)*N1.powi(2)) - I1*alpha_M*theta_dot/(h*N1.powi(2));
        }
        delta2 {
            _ => -k23*delta23;
            sliding_friction => arm23*F_mu23/(h*N3) - tan_a*side23*F_mu23;
            torques => T_load/(h*N3);
            damping => I3*alpha_M*theta_dot/(h*N3.powi(2)) - beta_K*k23_mid*delta23_dot - I3*alpha_M*delta2_dot/(h.powi(2)*N3.powi(2));
        }
    }
    jacobian {
        theta theta {
            transmission_error_and_sliding_friction_and_moving_phase => mu12*k12*de12*arm12*delta12*psi12_dot/(N1*(tiny12.powi(2) + delta12.powi(2)).sqrt()*(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt()) + mu12*k12*de12*arm12*delta12*psi12_dot/(N2*(tiny12.powi(2) + delta12.powi(2)).sqrt()*(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt()) + mu23*k23*de23*arm23*delta23*psi23_dot/(N2*(tiny23.powi(2) + delta23.powi(2)).sqrt()*(w_mix23.powi(2) + psi23_dot.powi(2)).sqrt()) + mu23*k23*de23*arm23*delta23*psi23_dot/(N3*(tiny23.powi(2) + delta23.powi(2)).sqrt()*(w_mix23.powi(2) + psi23_dot.powi(2)).sqrt());
            transmission_error_and_jump_terms => k12*dde12*delta12 - k12*de12.powi(2) + k23*dde23*delta23 - k23*de23.powi(2) + 2.0*de12*dk12*delta12 + 2.0*de23*dk23*delta23;
            sliding_friction_and_moving_phase => -mu12*k12*darm12*psi12_dot*(tiny12.powi(2) + delta12.powi(2)).sqrt()/(N1*(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt()) - mu12*dk12*arm12*psi12_dot*(tiny12.powi(2) + delta12.powi(2)).sqrt()/(N1*(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt()) - mu12*k12*darm12*psi12_dot*(tiny12.powi(2) + delta12.powi(2)).sqrt()/(N2*(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt()) - mu12*dk12*arm12*psi12_dot*(tiny12.powi(2) + delta12.powi(2)).sqrt()/(N2*(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt()) - mu23*k23*darm23*psi23_dot*(tiny23.powi(2) + delta23.powi(2)).sqrt()/(N2*(w_mix23.powi(2) + psi23_dot.powi(2)).sqrt()) - mu23*dk23*arm23*psi23_dot*(tiny23.powi(2) + delta23.powi(2)).sqrt()/(N2*(w_mix23.powi(2) + psi23_dot.powi(2)).sqrt()) - mu23*k23*darm23*psi23_dot*(tiny23.powi(2) + delta23.powi(2)).sqrt()/(N3*(w_mix23.powi(2) + psi23_dot.powi(2)).sqrt()) - mu23*dk23*arm23*psi23_dot*(tiny23.powi(2) + delta23.powi(2)).sqrt()/(N3*(w_mix23.powi(2) + psi23_dot.powi(2)).sqrt());
            jump_terms => (-ddk12*delta12.powi(2) - ddk23*delta23.powi(2))/2.0;
        }
        theta delta1 {
            transmission_error_and_jump_terms => k12*de12;
            sliding_friction => -mu12*k12*arm12*delta12*psi12_dot/(N1*(tiny12.powi(2) + delta12.powi(2)).sqrt()*(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt()) - mu12*k12*arm12*delta12*psi12_dot/(N2*(tiny12.powi(2) + delta12.powi(2)).sqrt()*(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt());
            jump_terms => -dk12*delta12;
        }
        theta delta2 {
            transmission_error_and_jump_terms => k23*de23;
            sliding_friction => -mu23*k23*arm23*delta23*psi23_dot/(N2*(tiny23.powi(2) + delta23.powi(2)).sqrt()*(w_mix23.powi(2) + psi23_dot.powi(2)).sqrt()) - mu23*k23*arm23*delta23*psi23_dot/(N3*(tiny23.powi(2) + delta23.powi(2)).sqrt()*(w_mix23.powi(2) + psi23_dot.powi(2)).sqrt());
            jump_terms => -dk23*delta23;
        }
        theta theta_dot {
            sliding_friction => mu12*k12*arm12*psi12_dot.powi(2)*(tiny12.powi(2) + delta12.powi(2)).sqrt()/(N1.powi(2)*(w_mix12.powi(2) + psi12_dot.powi(2)).powf(3.0/2.0)) - mu12*k12*arm12*(tiny12.powi(2) + delta12.powi(2)).sqrt()/(N1.powi(2)*(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt()) + 2.0*mu12*k12*arm12*psi12_dot.powi(2)*(tiny12.powi(2) + delta12.powi(2)).sqrt()/(N1*N2*(w_mix12.powi(2) + psi12_dot.powi(2)).powf(3.0/2.0)) - 2.0*mu12*k12*arm12*(tiny12.powi(2) + delta12.powi(2)).sqrt()/(N1*N2*(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt()) + mu12*k12*arm12*psi12_dot.powi(2)*(tiny12.powi(2) + delta12.powi(2)).sqrt()/(N2.powi(2)*(w_mix12.powi(2) + psi12_dot.powi(2)).powf(3.0/2.0)) - mu12*k12*arm12*(tiny12.powi(2) + delta12.powi(2)).sqrt()/(N2.powi(2)*(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt()) + mu23*k23*arm23*psi23_dot.powi(2)*(tiny23.powi(2) + delta23.powi(2)).sqrt()/(N2.powi(2)*(w_mix23.powi(2) + psi23_dot.powi(2)).powf(3.0/2.0)) - mu23*k23*arm23*(tiny23.powi(2) + delta23.powi(2)).sqrt()/(N2.powi(2)*(w_mix23.powi(2) + psi23_dot.powi(2)).sqrt()) + 2.0*mu23*k23*arm23*psi23_dot.powi(2)*(tiny23.powi(2) + delta23.powi(2)).sqrt()/(N2*N3*(w_mix23.powi(2) + psi23_dot.powi(2)).powf(3.0/2.0)) - 2.0*mu23*k23*arm23*(tiny23.powi(2) + delta23.powi(2)).sqrt()/(N2*N3*(w_mix23.powi(2) + psi23_dot.powi(2)).sqrt()) + mu23*k23*arm23*psi23_dot.powi(2)*(tiny23.powi(2) + delta23.powi(2)).sqrt()/(N3.powi(2)*(w_mix23.powi(2) + psi23_dot.powi(2)).powf(3.0/2.0)) - mu23*k23*arm23*(tiny23.powi(2) + delta23.powi(2)).sqrt()/(N3.powi(2)*(w_mix23.powi(2) + psi23_dot.powi(2)).sqrt());
            damping => -I1*alpha_M/N1.powi(2) - I2*alpha_M/N2.powi(2) - I3*alpha_M/N3.powi(2);
        }
        theta delta1_dot {
            sliding_friction => mu12*k12*arm12*psi12_dot.powi(2)*(tiny12.powi(2) + delta12.powi(2)).sqrt()/(h*N1.powi(2)*(w_mix12.powi(2) + psi12_dot.powi(2)).powf(3.0/2.0)) - mu12*k12*arm12*(tiny12.powi(2) + delta12.powi(2)).sqrt()/(h*N1.powi(2)*(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt()) + mu12*k12*arm12*psi12_dot.powi(2)*(tiny12.powi(2) + delta12.powi(2)).sqrt()/(h*N1*N2*(w_mix12.powi(2) + psi12_dot.powi(2)).powf(3.0/2.0)) - mu12*k12*arm12*(tiny12.powi(2) + delta12.powi(2)).sqrt()/(h*N1*N2*(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt());
            damping => -I1*alpha_M/(h*N1.powi(2));
        }
        theta delta2_dot {
            sliding_friction => mu23*k23*arm23*(tiny23.powi(2) + delta23.powi(2)).sqrt()/(h*N2*N3*(w_mix23.powi(2) + psi23_dot.powi(2)).sqrt()) - mu23*k23*arm23*psi23_dot.powi(2)*(tiny23.powi(2) + delta23.powi(2)).sqrt()/(h*N2*N3*(w_mix23.powi(2) + psi23_dot.powi(2)).powf(3.0/2.0)) - mu23*k23*arm23*psi23_dot.powi(2)*(tiny23.powi(2) + delta23.powi(2)).sqrt()/(h*N3.powi(2)*(w_mix23.powi(2) + psi23_dot.powi(2)).powf(3.0/2.0)) + mu23*k23*arm23*(tiny23.powi(2) + delta23.powi(2)).sqrt()/(h*N3.powi(2)*(w_mix23.powi(2) + psi23_dot.powi(2)).sqrt());
            damping => I3*alpha_M/(h*N3.powi(2));
        }
        delta1 theta {
            transmission_error_and_sliding_friction_and_moving_phase => tan_a*mu12*k12*de12*side12*delta12*psi12_dot/((tiny12.powi(2) + delta12.powi(2)).sqrt()*(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt()) + mu12*k12*de12*arm12*delta12*psi12_dot/(h*N1*(tiny12.powi(2) + delta12.powi(2)).sqrt()*(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt());
            transmission_error_and_moving_phase => k12*de12;
            sliding_friction_and_moving_phase => -tan_a*mu12*k12*dside12*psi12_dot*(tiny12.powi(2) + delta12.powi(2)).sqrt()/(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt() - tan_a*mu12*dk12*side12*psi12_dot*(tiny12.powi(2) + delta12.powi(2)).sqrt()/(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt() - mu12*k12*darm12*psi12_dot*(tiny12.powi(2) + delta12.powi(2)).sqrt()/(h*N1*(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt()) - mu12*dk12*arm12*psi12_dot*(tiny12.powi(2) + delta12.powi(2)).sqrt()/(h*N1*(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt());
            moving_phase => -dk12*delta12;
        }
        delta1 delta1 {
            _ => -k12;
            sliding_friction => -tan_a*mu12*k12*side12*delta12*psi12_dot/((tiny12.powi(2) + delta12.powi(2)).sqrt()*(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt()) - mu12*k12*arm12*delta12*psi12_dot/(h*N1*(tiny12.powi(2) + delta12.powi(2)).sqrt()*(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt());
        }
        delta1 theta_dot {
            sliding_friction => tan_a*mu12*k12*side12*psi12_dot.powi(2)*(tiny12.powi(2) + delta12.powi(2)).sqrt()/(N1*(w_mix12.powi(2) + psi12_dot.powi(2)).powf(3.0/2.0)) - tan_a*mu12*k12*side12*(tiny12.powi(2) + delta12.powi(2)).sqrt()/(N1*(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt()) + tan_a*mu12*k12*side12*psi12_dot.powi(2)*(tiny12.powi(2) + delta12.powi(2)).sqrt()/(N2*(w_mix12.powi(2) + psi12_dot.powi(2)).powf(3.0/2.0)) - tan_a*mu12*k12*side12*(tiny12.powi(2) + delta12.powi(2)).sqrt()/(N2*(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt()) + mu12*k12*arm12*psi12_dot.powi(2)*(tiny12.powi(2) + delta12.powi(2)).sqrt()/(h*N1.powi(2)*(w_mix12.powi(2) + psi12_dot.powi(2)).powf(3.0/2.0)) - mu12*k12*arm12*(tiny12.powi(2) + delta12.powi(2)).sqrt()/(h*N1.powi(2)*(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt()) + mu12*k12*arm12*psi12_dot.powi(2)*(tiny12.powi(2) + delta12.powi(2)).sqrt()/(h*N1*N2*(w_mix12.powi(2) + psi12_dot.powi(2)).powf(3.0/2.0)) - mu12*k12*arm12*(tiny12.powi(2) + delta12.powi(2)).sqrt()/(h*N1*N2*(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt());
            damping => -I1*alpha_M/(h*N1.powi(2));
        }
        delta1 delta1_dot {
            sliding_friction => mu12*k12*arm12*psi12_dot.powi(2)*(tiny12.powi(2) + delta12.powi(2)).sqrt()/(h.powi(2)*N1.powi(2)*(w_mix12.powi(2) + psi12_dot.powi(2)).powf(3.0/2.0)) - mu12*k12*arm12*(tiny12.powi(2) + delta12.powi(2)).sqrt()/(h.powi(2)*N1.powi(2)*(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt()) + tan_a*mu12*k12*side12*psi12_dot.powi(2)*(tiny12.powi(2) + delta12.powi(2)).sqrt()/(h*N1*(w_mix12.powi(2) + psi12_dot.powi(2)).powf(3.0/2.0)) - tan_a*mu12*k12*side12*(tiny12.powi(2) + delta12.powi(2)).sqrt()/(h*N1*(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt());
            damping => -beta_K*k12_mid - I1*alpha_M/(h.powi(2)*N1.powi(2));
        }
        delta2 theta {
            transmission_error_and_sliding_friction_and_moving_phase => tan_a*mu23*k23*de23*side23*delta23*psi23_dot/((tiny23.powi(2) + delta23.powi(2)).sqrt()*(w_mix23.powi(2) + psi23_dot.powi(2)).sqrt()) - mu23*k23*de23*arm23*delta23*psi23_dot/(h*N3*(tiny23.powi(2) + delta23.powi(2)).sqrt()*(w_mix23.powi(2) + psi23_dot.powi(2)).sqrt());
            transmission_error_and_moving_phase => k23*de23;
            sliding_friction_and_moving_phase => mu23*k23*darm23*psi23_dot*(tiny23.powi(2) + delta23.powi(2)).sqrt()/(h*N3*(w_mix23.powi(2) + psi23_dot.powi(2)).sqrt()) - tan_a*mu23*k23*dside23*psi23_dot*(tiny23.powi(2) + delta23.powi(2)).sqrt()/(w_mix23.powi(2) + psi23_dot.powi(2)).sqrt() - tan_a*mu23*dk23*side23*psi23_dot*(tiny23.powi(2) + delta23.powi(2)).sqrt()/(w_mix23.powi(2) + psi23_dot.powi(2)).sqrt() + mu23*dk23*arm23*psi23_dot*(tiny23.powi(2) + delta23.powi(2)).sqrt()/(h*N3*(w_mix23.powi(2) + psi23_dot.powi(2)).sqrt());
            moving_phase => -dk23*delta23;
        }
        delta2 delta2 {
            _ => -k23;
            sliding_friction => mu23*k23*arm23*delta23*psi23_dot/(h*N3*(tiny23.powi(2) + delta23.powi(2)).sqrt()*(w_mix23.powi(2) + psi23_dot.powi(2)).sqrt()) - tan_a*mu23*k23*side23*delta23*psi23_dot/((tiny23.powi(2) + delta23.powi(2)).sqrt()*(w_mix23.powi(2) + psi23_dot.powi(2)).sqrt());
        }
        delta2 theta_dot {
            sliding_friction => tan_a*mu23*k23*side23*psi23_dot.powi(2)*(tiny23.powi(2) + delta23.powi(2)).sqrt()/(N2*(w_mix23.powi(2) + psi23_dot.powi(2)).powf(3.0/2.0)) - tan_a*mu23*k23*side23*(tiny23.powi(2) + delta23.powi(2)).sqrt()/(N2*(w_mix23.powi(2) + psi23_dot.powi(2)).sqrt()) + tan_a*mu23*k23*side23*psi23_dot.powi(2)*(tiny23.powi(2) + delta23.powi(2)).sqrt()/(N3*(w_mix23.powi(2) + psi23_dot.powi(2)).powf(3.0/2.0)) - tan_a*mu23*k23*side23*(tiny23.powi(2) + delta23.powi(2)).sqrt()/(N3*(w_mix23.powi(2) + psi23_dot.powi(2)).sqrt()) - mu23*k23*arm23*psi23_dot.powi(2)*(tiny23.powi(2) + delta23.powi(2)).sqrt()/(h*N2*N3*(w_mix23.powi(2) + psi23_dot.powi(2)).powf(3.0/2.0)) + mu23*k23*arm23*(tiny23.powi(2) + delta23.powi(2)).sqrt()/(h*N2*N3*(w_mix23.powi(2) + psi23_dot.powi(2)).sqrt()) - mu23*k23*arm23*psi23_dot.powi(2)*(tiny23.powi(2) + delta23.powi(2)).sqrt()/(h*N3.powi(2)*(w_mix23.powi(2) + psi23_dot.powi(2)).powf(3.0/2.0)) + mu23*k23*arm23*(tiny23.powi(2) + delta23.powi(2)).sqrt()/(h*N3.powi(2)*(w_mix23.powi(2) + psi23_dot.powi(2)).sqrt());
            damping => I3*alpha_M/(h*N3.powi(2));
        }
        delta2 delta2_dot {
            sliding_friction => mu23*k23*arm23*psi23_dot.powi(2)*(tiny23.powi(2) + delta23.powi(2)).sqrt()/(h.powi(2)*N3.powi(2)*(w_mix23.powi(2) + psi23_dot.powi(2)).powf(3.0/2.0)) - mu23*k23*arm23*(tiny23.powi(2) + delta23.powi(2)).sqrt()/(h.powi(2)*N3.powi(2)*(w_mix23.powi(2) + psi23_dot.powi(2)).sqrt()) - tan_a*mu23*k23*side23*psi23_dot.powi(2)*(tiny23.powi(2) + delta23.powi(2)).sqrt()/(h*N3*(w_mix23.powi(2) + psi23_dot.powi(2)).powf(3.0/2.0)) + tan_a*mu23*k23*side23*(tiny23.powi(2) + delta23.powi(2)).sqrt()/(h*N3*(w_mix23.powi(2) + psi23_dot.powi(2)).sqrt());
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
    nonlinear_with {
        sliding_friction "-mu12*k12*side12*psi12_dot*sqrt(tiny12^2 + delta12^2)/sqrt(w_mix12^2 + psi12_dot^2) in the torque `slide12`";
        sliding_friction "-mu12*k12*arm12*psi12_dot*sqrt(tiny12^2 + delta12^2)/sqrt(w_mix12^2 + psi12_dot^2) in the torque `roll12`";
        sliding_friction "-mu23*k23*side23*psi23_dot*sqrt(tiny23^2 + delta23^2)/sqrt(w_mix23^2 + psi23_dot^2) in the torque `slide23`";
        sliding_friction "-mu23*k23*arm23*psi23_dot*sqrt(tiny23^2 + delta23^2)/sqrt(w_mix23^2 + psi23_dot^2) in the torque `roll23`";
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
    jump side12 {
        normal {
            theta {
                _ => 1.0;
            }
        }
        step {}
    }
    jump arm12 {
        normal {
            theta {
                _ => 1.0;
            }
        }
        step {}
    }
    jump side23 {
        normal {
            theta {
                _ => 1.0;
            }
        }
        step {}
    }
    jump arm23 {
        normal {
            theta {
                _ => 1.0;
            }
        }
        step {}
    }

    text {
        "T = (I1*(delta1_dot/(h*N1) + theta_dot/N1)^2 + I2*theta_dot^2/N2^2 + I3*(theta_dot/N3 - delta2_dot/(h*N3))^2)/2";
        "V = (k12*delta12^2 + k23*delta23^2)/2";
        "D = (I1*alpha_M*(delta1_dot/(h*N1) + theta_dot/N1)^2 + I2*alpha_M*theta_dot^2/N2^2 + I3*alpha_M*(theta_dot/N3 - delta2_dot/(h*N3))^2 + beta_K*k12_mid*delta12_dot^2 + beta_K*k23_mid*delta23_dot^2)/2 [damping]";
        "Q_theta = -arm12*F_mu12/N1 - arm12*F_mu12/N2 - arm23*F_mu23/N2 - arm23*F_mu23/N3 [sliding friction] + T_motor/N1 - T_load/N3 [torques]";
        "Q_delta1 = -tan_a*side12*F_mu12 - arm12*F_mu12/(h*N1) [sliding friction] + T_motor/(h*N1) [torques]";
        "Q_delta2 = arm23*F_mu23/(h*N3) - tan_a*side23*F_mu23 [sliding friction] + T_load/(h*N3) [torques]";
        "h = r2/N2";
        "tan_a = sin(alpha)/cos(alpha)";
        "tiny12 = 1/1000000000000";
        "tiny23 = 1/1000000000000";
        "delta12 = delta1 - e12";
        "delta23 = delta2 - e23";
        "tau12 = tan_a*delta1";
        "psi12 = delta1/(h*N1) + theta/N1 + theta/N2";
        "tau23 = tan_a*delta2";
        "psi23 = theta/N2 - delta2/(h*N3) + theta/N3";
        "e12 = 0 without transmission error; the rates of deflections do not contain that of e12";
        "e23 = 0 without transmission error; the rates of deflections do not contain that of e23";
        "side12 = 0 without sliding friction";
        "arm12 = 0 without sliding friction";
        "side23 = 0 without sliding friction";
        "arm23 = 0 without sliding friction";
        "F_mu12 = mu12*k12*psi12_dot*sqrt(tiny12^2 + delta12^2)/sqrt(w_mix12^2 + psi12_dot^2) [sliding friction]";
        "F_mu23 = mu23*k23*psi23_dot*sqrt(tiny23^2 + delta23^2)/sqrt(w_mix23^2 + psi23_dot^2) [sliding friction]";
        "(I1/N1^2 + I2/N2^2 + I3/N3^2) theta'' + (I1/(h*N1^2)) delta1'' + (-I3/(h*N3^2)) delta2'' = k12*de12*delta12 + k23*de23*delta23 [transmission error, jump terms] - arm12*F_mu12/N1 - arm12*F_mu12/N2 - arm23*F_mu23/N2 - arm23*F_mu23/N3 [sliding friction] + T_motor/N1 - T_load/N3 [torques] + I3*alpha_M*delta2_dot/(h*N3^2) - I1*alpha_M*theta_dot/N1^2 - I2*alpha_M*theta_dot/N2^2 - I3*alpha_M*theta_dot/N3^2 - I1*alpha_M*delta1_dot/(h*N1^2) [damping] + (-dk12*delta12^2 - dk23*delta23^2)/2 [jump terms]";
        "(I1/(h*N1^2)) theta'' + (I1/(h^2*N1^2)) delta1'' = -k12*delta12 - tan_a*side12*F_mu12 - arm12*F_mu12/(h*N1) [sliding friction] + T_motor/(h*N1) [torques] - beta_K*k12_mid*delta12_dot - I1*alpha_M*delta1_dot/(h^2*N1^2) - I1*alpha_M*theta_dot/(h*N1^2) [damping]";
        "(-I3/(h*N3^2)) theta'' + (I3/(h^2*N3^2)) delta2'' = -k23*delta23 + arm23*F_mu23/(h*N3) - tan_a*side23*F_mu23 [sliding friction] + T_load/(h*N3) [torques] + I3*alpha_M*theta_dot/(h*N3^2) - beta_K*k23_mid*delta23_dot - I3*alpha_M*delta2_dot/(h^2*N3^2) [damping]";
        "at a step dk12 of k12 in theta: v+^2 = v-^2 - 2*G*(dk12*delta12^2/2)";
        "at a step dk23 of k23 in theta: v+^2 = v-^2 - 2*G*(dk23*delta23^2/2)";
        "at a step de12 of e12 in theta: v+^2 = v-^2 - 2*G*(k12*de12^2/2 - k12*de12*delta12)";
        "at a step de23 of e23 in theta: v+^2 = v-^2 - 2*G*(k23*de23^2/2 - k23*de23*delta23)";
        "at a step of side12: dV = 0, the speeds do not change";
        "at a step of arm12: dV = 0, the speeds do not change";
        "at a step of side23: dV = 0, the speeds do not change";
        "at a step of arm23: dV = 0, the speeds do not change";
        "M q'' + C q' + K q = f with constant M, C, K, f: linear, solved exactly";
        "nonlinear with sliding_friction: -mu12*k12*side12*psi12_dot*sqrt(tiny12^2 + delta12^2)/sqrt(w_mix12^2 + psi12_dot^2) in the torque `slide12`";
        "nonlinear with sliding_friction: -mu12*k12*arm12*psi12_dot*sqrt(tiny12^2 + delta12^2)/sqrt(w_mix12^2 + psi12_dot^2) in the torque `roll12`";
        "nonlinear with sliding_friction: -mu23*k23*side23*psi23_dot*sqrt(tiny23^2 + delta23^2)/sqrt(w_mix23^2 + psi23_dot^2) in the torque `slide23`";
        "nonlinear with sliding_friction: -mu23*k23*arm23*psi23_dot*sqrt(tiny23^2 + delta23^2)/sqrt(w_mix23^2 + psi23_dot^2) in the torque `roll23`";
    }
    latex {
        "T = \\frac{1}{2} (I_{1}\\, \\left(\\frac{\\dot{\\delta_{1}}}{h\\, N_{1}} + \\frac{\\dot{\\theta}}{N_{1}}\\right)^{2} + \\frac{I_{2}\\, \\dot{\\theta}^{2}}{N_{2}^{2}} + I_{3}\\, \\left(\\frac{\\dot{\\theta}}{N_{3}} - \\frac{\\dot{\\delta_{2}}}{h\\, N_{3}}\\right)^{2})";
        "V = \\frac{1}{2} (k_{12}\\, \\delta_{12}^{2} + k_{23}\\, \\delta_{23}^{2})";
        "D = \\frac{1}{2} (I_{1}\\, \\alpha_{M}\\, \\left(\\frac{\\dot{\\delta_{1}}}{h\\, N_{1}} + \\frac{\\dot{\\theta}}{N_{1}}\\right)^{2} + \\frac{I_{2}\\, \\alpha_{M}\\, \\dot{\\theta}^{2}}{N_{2}^{2}} + I_{3}\\, \\alpha_{M}\\, \\left(\\frac{\\dot{\\theta}}{N_{3}} - \\frac{\\dot{\\delta_{2}}}{h\\, N_{3}}\\right)^{2} + \\beta_{K}\\, \\bar{k_{12}}\\, \\dot{\\delta_{12}}^{2} + \\beta_{K}\\, \\bar{k_{23}}\\, \\dot{\\delta_{23}}^{2})\\ [\\text{damping}]";
        "Q_{\\theta} = -\\frac{\\mathrm{arm}_{12}\\, F_{mu12}}{N_{1}} - \\frac{\\mathrm{arm}_{12}\\, F_{mu12}}{N_{2}} - \\frac{\\mathrm{arm}_{23}\\, F_{mu23}}{N_{2}} - \\frac{\\mathrm{arm}_{23}\\, F_{mu23}}{N_{3}}\\ [\\text{sliding friction}] + \\frac{T_{motor}}{N_{1}} - \\frac{T_{load}}{N_{3}}\\ [\\text{torques}]";
        "Q_{\\delta_{1}} = -\\mathrm{tan}_{a}\\, \\mathrm{side}_{12}\\, F_{mu12} - \\frac{\\mathrm{arm}_{12}\\, F_{mu12}}{h\\, N_{1}}\\ [\\text{sliding friction}] + \\frac{T_{motor}}{h\\, N_{1}}\\ [\\text{torques}]";
        "Q_{\\delta_{2}} = \\frac{\\mathrm{arm}_{23}\\, F_{mu23}}{h\\, N_{3}} - \\mathrm{tan}_{a}\\, \\mathrm{side}_{23}\\, F_{mu23}\\ [\\text{sliding friction}] + \\frac{T_{load}}{h\\, N_{3}}\\ [\\text{torques}]";
        "h = \\frac{r_{2}}{N_{2}}";
        "\\mathrm{tan}_{a} = \\frac{\\sin\\left(\\alpha\\right)}{\\cos\\left(\\alpha\\right)}";
        "\\mathrm{tiny}_{12} = \\frac{1}{1000000000000}";
        "\\mathrm{tiny}_{23} = \\frac{1}{1000000000000}";
        "\\delta_{12} = \\delta_{1} - e_{12}";
        "\\delta_{23} = \\delta_{2} - e_{23}";
        "\\tau_{12} = \\mathrm{tan}_{a}\\, \\delta_{1}";
        "\\psi_{12} = \\frac{\\delta_{1}}{h\\, N_{1}} + \\frac{\\theta}{N_{1}} + \\frac{\\theta}{N_{2}}";
        "\\tau_{23} = \\mathrm{tan}_{a}\\, \\delta_{2}";
        "\\psi_{23} = \\frac{\\theta}{N_{2}} - \\frac{\\delta_{2}}{h\\, N_{3}} + \\frac{\\theta}{N_{3}}";
        "F_{mu12} = \\frac{\\mu_{12}\\, k_{12}\\, \\dot{\\psi_{12}}\\, \\sqrt{\\mathrm{tiny}_{12}^{2} + \\delta_{12}^{2}}}{\\sqrt{w_{mix12}^{2} + \\dot{\\psi_{12}}^{2}}}";
        "F_{mu23} = \\frac{\\mu_{23}\\, k_{23}\\, \\dot{\\psi_{23}}\\, \\sqrt{\\mathrm{tiny}_{23}^{2} + \\delta_{23}^{2}}}{\\sqrt{w_{mix23}^{2} + \\dot{\\psi_{23}}^{2}}}";
        "(\\frac{I_{1}}{N_{1}^{2}} + \\frac{I_{2}}{N_{2}^{2}} + \\frac{I_{3}}{N_{3}^{2}}) \\ddot{\\theta} + (\\frac{I_{1}}{h\\, N_{1}^{2}}) \\ddot{\\delta_{1}} + (-\\frac{I_{3}}{h\\, N_{3}^{2}}) \\ddot{\\delta_{2}} = k_{12}\\, e_{12}'\\, \\delta_{12} + k_{23}\\, e_{23}'\\, \\delta_{23}\\ [\\text{transmission error, jump terms}] - \\frac{\\mathrm{arm}_{12}\\, F_{mu12}}{N_{1}} - \\frac{\\mathrm{arm}_{12}\\, F_{mu12}}{N_{2}} - \\frac{\\mathrm{arm}_{23}\\, F_{mu23}}{N_{2}} - \\frac{\\mathrm{arm}_{23}\\, F_{mu23}}{N_{3}}\\ [\\text{sliding friction}] + \\frac{T_{motor}}{N_{1}} - \\frac{T_{load}}{N_{3}}\\ [\\text{torques}] + \\frac{I_{3}\\, \\alpha_{M}\\, \\dot{\\delta_{2}}}{h\\, N_{3}^{2}} - \\frac{I_{1}\\, \\alpha_{M}\\, \\dot{\\theta}}{N_{1}^{2}} - \\frac{I_{2}\\, \\alpha_{M}\\, \\dot{\\theta}}{N_{2}^{2}} - \\frac{I_{3}\\, \\alpha_{M}\\, \\dot{\\theta}}{N_{3}^{2}} - \\frac{I_{1}\\, \\alpha_{M}\\, \\dot{\\delta_{1}}}{h\\, N_{1}^{2}}\\ [\\text{damping}] + \\frac{1}{2} (-k_{12}'\\, \\delta_{12}^{2} - k_{23}'\\, \\delta_{23}^{2})\\ [\\text{jump terms}]";
        "(\\frac{I_{1}}{h\\, N_{1}^{2}}) \\ddot{\\theta} + (\\frac{I_{1}}{h^{2}\\, N_{1}^{2}}) \\ddot{\\delta_{1}} = -k_{12}\\, \\delta_{12} - \\mathrm{tan}_{a}\\, \\mathrm{side}_{12}\\, F_{mu12} - \\frac{\\mathrm{arm}_{12}\\, F_{mu12}}{h\\, N_{1}}\\ [\\text{sliding friction}] + \\frac{T_{motor}}{h\\, N_{1}}\\ [\\text{torques}] - \\beta_{K}\\, \\bar{k_{12}}\\, \\dot{\\delta_{12}} - \\frac{I_{1}\\, \\alpha_{M}\\, \\dot{\\delta_{1}}}{h^{2}\\, N_{1}^{2}} - \\frac{I_{1}\\, \\alpha_{M}\\, \\dot{\\theta}}{h\\, N_{1}^{2}}\\ [\\text{damping}]";
        "(-\\frac{I_{3}}{h\\, N_{3}^{2}}) \\ddot{\\theta} + (\\frac{I_{3}}{h^{2}\\, N_{3}^{2}}) \\ddot{\\delta_{2}} = -k_{23}\\, \\delta_{23} + \\frac{\\mathrm{arm}_{23}\\, F_{mu23}}{h\\, N_{3}} - \\mathrm{tan}_{a}\\, \\mathrm{side}_{23}\\, F_{mu23}\\ [\\text{sliding friction}] + \\frac{T_{load}}{h\\, N_{3}}\\ [\\text{torques}] + \\frac{I_{3}\\, \\alpha_{M}\\, \\dot{\\theta}}{h\\, N_{3}^{2}} - \\beta_{K}\\, \\bar{k_{23}}\\, \\dot{\\delta_{23}} - \\frac{I_{3}\\, \\alpha_{M}\\, \\dot{\\delta_{2}}}{h^{2}\\, N_{3}^{2}}\\ [\\text{damping}]";
    }
}
