//! Equations of motion of `gear_pair`: two spur gears on rigid shafts.
//!
//! Derived from the energies in `models/src/gear_pair.rs` by `cargo xtask derive gear_pair`. Do not edit: change the
//! energies and derive again.
//! Source: Oh, Grosh & Barber (2005), J. Vib. Acoust. 127(2), doi:10.1115/1.1891815
//!
//! # Energies
//!
//! ```text
//! T = (I1*(phi_dot + theta_dot)^2/N1^2 + I2*(theta_dot - phi_dot)^2/N2^2)/2
//! V = k*touch*over^2
//! D = C*damp*over_dot^2 [damping]
//! Q_theta = -arm*F_mu/N1 - arm*F_mu/N2 [sliding friction]
//! Q_phi = 2*T0 [torques] + arm*F_mu/N2 - 2*tan_a*side*F_mu - arm*F_mu/N1 [sliding friction]
//! ```
//!
//! # Constants
//!
//! ```text
//! M1 = (N1^2/I1 - N2^2/I2)/2
//! M2 = (N1^2/I1 + N2^2/I2)/2
//! C = 2*zeta*sqrt(k_mid/M2)
//! tan_a = sin(alpha)/cos(alpha)
//! tiny = 1/1000000000000
//! ```
//!
//! # Deflections
//!
//! ```text
//! over = phi - edge - e
//! tau = 2*tan_a*phi
//! psi = phi/N1 + theta/N1 - phi/N2 + theta/N2
//! e = 0 without transmission error; the rates of deflections do not contain that of e
//! side = 0 without sliding friction
//! arm = 0 without sliding friction
//! touch = 1 in contact, beyond edge = b/2 or -b/2; touch = 0 between the edges; without backlash touch = 1 and edge = 0
//! damp = 1 and clip = 0 in contact while the damper force is less than the spring force, else damp = 0:
//!   clip = 1 if the damper would push more than the spring: its force is limited to the spring force
//!   clip = -1 if the damper would pull more than the spring pushes: the contact force is zero
//! ```
//!
//! # Forces
//!
//! ```text
//! F_mu = mu*k*touch*psi_dot*sqrt(tiny^2 + over^2)/sqrt(w_mix^2 + psi_dot^2) [sliding friction]
//! ```
//!
//! # Equations of motion
//!
//! ```text
//! theta'' = -M1*k*touch*over + M2*k*de*touch*over [transmission error, jump terms] - M1*k*touch*clip*over [backlash] - C*M1*damp*over_dot [damping] + M1*T0 [torques] + M1*arm*F_mu/(2*N2) - M1*tan_a*side*F_mu - M1*arm*F_mu/(2*N1) - M2*arm*F_mu/(2*N1) - M2*arm*F_mu/(2*N2) [sliding friction] - M2*dk*touch*over^2/2 [jump terms]
//! phi'' = -M2*k*touch*over + M1*k*de*touch*over [transmission error, jump terms] - M2*k*touch*clip*over [backlash] - C*M2*damp*over_dot [damping] + M2*T0 [torques] + M2*arm*F_mu/(2*N2) - M1*arm*F_mu/(2*N1) - M1*arm*F_mu/(2*N2) - M2*tan_a*side*F_mu - M2*arm*F_mu/(2*N1) [sliding friction] - M1*dk*touch*over^2/2 [jump terms]
//! ```
//!
//! # At a step of a stiffness or a transmission error
//!
//! ```text
//! at a step dk of k in theta, transmission if theta_dot+^2 >= 0:
//! theta_dot+^2 = theta_dot-^2 - M2*dk*touch*over^2
//! phi_dot+ - phi_dot- = (M1/M2)*(theta_dot+ - theta_dot-)
//! else reflection: theta_dot+ = -theta_dot-, and the stiffness does not step
//! at a step de of e in theta, transmission if theta_dot+^2 >= 0:
//! theta_dot+^2 = theta_dot-^2 - (M2*k*de^2*touch - 2*M2*k*de*touch*over)
//! phi_dot+ - phi_dot- = (M1/M2)*(theta_dot+ - theta_dot-)
//! else reflection: theta_dot+ = -theta_dot-, and e does not step
//! at a step of side: dV = 0, the speeds do not change
//! at a step of arm: dV = 0, the speeds do not change
//! ```
//!
//! # Between two steps
//!
//! ```text
//! M q'' + C q' + K q = f with constant M, C, K, f: linear, solved exactly
//! nonlinear with sliding_friction: -mu*k*side*touch*psi_dot*sqrt(tiny^2 + over^2)/sqrt(w_mix^2 + psi_dot^2) in the torque `slide`
//! nonlinear with sliding_friction: -mu*k*arm*touch*psi_dot*sqrt(tiny^2 + over^2)/sqrt(w_mix^2 + psi_dot^2) in the torque `roll`
//! ```
//!
//! # LaTeX
//!
//! ```latex
//! T = \frac{1}{2} (\frac{I_{1}\, \left(\dot{\varphi} + \dot{\theta}\right)^{2}}{N_{1}^{2}} + \frac{I_{2}\, \left(\dot{\theta} - \dot{\varphi}\right)^{2}}{N_{2}^{2}})
//! V = k\, \mathrm{touch}\, \mathrm{over}^{2}
//! D = C\, \mathrm{damp}\, \dot{\mathrm{over}}^{2}\ [\text{damping}]
//! Q_{\theta} = -\frac{\mathrm{arm}\, F_{mu}}{N_{1}} - \frac{\mathrm{arm}\, F_{mu}}{N_{2}}\ [\text{sliding friction}]
//! Q_{\varphi} = 2\, T_{0}\ [\text{torques}] + \frac{\mathrm{arm}\, F_{mu}}{N_{2}} - 2\, \mathrm{tan}_{a}\, \mathrm{side}\, F_{mu} - \frac{\mathrm{arm}\, F_{mu}}{N_{1}}\ [\text{sliding friction}]
//! M_{1} = \frac{1}{2} (\frac{N_{1}^{2}}{I_{1}} - \frac{N_{2}^{2}}{I_{2}})
//! M_{2} = \frac{1}{2} (\frac{N_{1}^{2}}{I_{1}} + \frac{N_{2}^{2}}{I_{2}})
//! C = 2\, \zeta\, \sqrt{\frac{\bar{k}}{M_{2}}}
//! \mathrm{tan}_{a} = \frac{\sin\left(\alpha\right)}{\cos\left(\alpha\right)}
//! \mathrm{tiny} = \frac{1}{1000000000000}
//! \mathrm{over} = \varphi - \mathrm{edge} - e
//! \tau = 2\, \mathrm{tan}_{a}\, \varphi
//! \psi = \frac{\varphi}{N_{1}} + \frac{\theta}{N_{1}} - \frac{\varphi}{N_{2}} + \frac{\theta}{N_{2}}
//! F_{mu} = \frac{\mu\, k\, \mathrm{touch}\, \dot{\psi}\, \sqrt{\mathrm{tiny}^{2} + \mathrm{over}^{2}}}{\sqrt{w_{mix}^{2} + \dot{\psi}^{2}}}
//! \ddot{\theta} = -M_{1}\, k\, \mathrm{touch}\, \mathrm{over} + M_{2}\, k\, e'\, \mathrm{touch}\, \mathrm{over}\ [\text{transmission error, jump terms}] - M_{1}\, k\, \mathrm{touch}\, \mathrm{clip}\, \mathrm{over}\ [\text{backlash}] - C\, M_{1}\, \mathrm{damp}\, \dot{\mathrm{over}}\ [\text{damping}] + M_{1}\, T_{0}\ [\text{torques}] + \frac{M_{1}\, \mathrm{arm}\, F_{mu}}{2\, N_{2}} - M_{1}\, \mathrm{tan}_{a}\, \mathrm{side}\, F_{mu} - \frac{M_{1}\, \mathrm{arm}\, F_{mu}}{2\, N_{1}} - \frac{M_{2}\, \mathrm{arm}\, F_{mu}}{2\, N_{1}} - \frac{M_{2}\, \mathrm{arm}\, F_{mu}}{2\, N_{2}}\ [\text{sliding friction}] - \frac{M_{2}\, k'\, \mathrm{touch}\, \mathrm{over}^{2}}{2}\ [\text{jump terms}]
//! \ddot{\varphi} = -M_{2}\, k\, \mathrm{touch}\, \mathrm{over} + M_{1}\, k\, e'\, \mathrm{touch}\, \mathrm{over}\ [\text{transmission error, jump terms}] - M_{2}\, k\, \mathrm{touch}\, \mathrm{clip}\, \mathrm{over}\ [\text{backlash}] - C\, M_{2}\, \mathrm{damp}\, \dot{\mathrm{over}}\ [\text{damping}] + M_{2}\, T_{0}\ [\text{torques}] + \frac{M_{2}\, \mathrm{arm}\, F_{mu}}{2\, N_{2}} - \frac{M_{1}\, \mathrm{arm}\, F_{mu}}{2\, N_{1}} - \frac{M_{1}\, \mathrm{arm}\, F_{mu}}{2\, N_{2}} - M_{2}\, \mathrm{tan}_{a}\, \mathrm{side}\, F_{mu} - \frac{M_{2}\, \mathrm{arm}\, F_{mu}}{2\, N_{1}}\ [\text{sliding friction}] - \frac{M_{1}\, k'\, \mathrm{touch}\, \mathrm{over}^{2}}{2}\ [\text{jump terms}]
//! \dot{\theta}_+^2 = \dot{\theta}_-^2 - M_{2}\, \Delta k\, \mathrm{touch}\, \mathrm{over}^{2}
//! \dot{\varphi}_+ - \dot{\varphi}_- = \frac{M_{1}}{M_{2}} \left(\dot{\theta}_+ - \dot{\theta}_-\right)
//! \dot{\theta}_+^2 = \dot{\theta}_-^2 - (M_{2}\, k\, \Delta e^{2}\, \mathrm{touch} - 2\, M_{2}\, k\, \Delta e\, \mathrm{touch}\, \mathrm{over})
//! \dot{\varphi}_+ - \dot{\varphi}_- = \frac{M_{1}}{M_{2}} \left(\dot{\theta}_+ - \dot{\theta}_-\right)
//! ```
//!
//! # Proved
//!
//! - d/dt (q'.dT/dq' - T + V) = Q.q' - q'.dD/dq' along the motion, for every value and slope of every law, with any set of the additive effects; q'.dD/dq' includes the power of clipped damper forces
//! - M is symmetric
//! - T = q'.M q'/2, with M as written
//! - M is positive definite: every leading minor is a sum of products of positive quantities
//! - M M⁻¹ = 1, and M q'' = F, for M⁻¹ and the accelerations as written
//! - at a step of k, e: T+ - T- = (v+² - v²)/(2 G) for any v+, where M d = n/G; V+ - V- = dV as written; so T + V is unchanged in transmission (v+² = v² - 2 G dV) and in reflection (v+ = -v, dV = 0)
//! - V is the same on both sides of a step of side, arm: no impulse there
//! - V is the same on both sides of the edges of over: no impulse there
//! - every damper takes energy or none: each term of D has a power q'.dD/dq' that is never negative
//! - the damper of over, clipped to the force F = dV/dover of its spring, takes energy or none: clip F over_dot >= 0, since F over >= 0, over_dot dD/dover_dot >= 0 and, where it is clipped, clip over dD/dover_dot >= F over
//! - the friction `roll` takes energy or none: its power is never positive
//! - the friction `slide` takes with `roll` energy or none where psi_dot and arm psi_dot + side tau_dot have one sign: where flanks slide as rolling makes them
//! - every deflection equals the linear form by which the equations differentiate it
//! - without the jump terms the balance fails: energy is created at the rate dk*touch*over^2*theta_dot - 2*k*de*touch*over*theta_dot
//!
//! # Operations, all effects present
//!
//! | output | sums | products, quotients | functions, roots |
//! | --- | --- | --- | --- |
//! | constants (once a scene) | 2 | 16 | 3 |
//! | named forces | 2 | 9 | 2 |
//! | force | 3 | 29 | 0 |
//! | acceleration | 8 | 78 | 0 |
//! | energy step of k | 0 | 3 | 0 |
//! | energy step of e | 1 | 7 | 0 |
//! | energy step of side | 0 | 0 | 0 |
//! | energy step of arm | 0 | 0 | 0 |

use gearsim_macros::equations;

equations! {
    model gear_pair "two spur gears on rigid shafts";
    source "Oh, Grosh & Barber (2005), J. Vib. Acoust. 127(2), doi:10.1115/1.1891815";

    coordinates {
        theta "rad" start 0.0, "mean rotation, (N1 theta1 + N2 theta2)/2";
        phi "rad" start static, "relative deflection, (N1 theta1 - N2 theta2)/2";
    }
    parameters {
        N1 "1" default 24.0, open 0.0 to inf, "number of teeth of the driving gear";
        N2 "1" default 96.0, open 0.0 to inf, "number of teeth of the driven gear";
        I1 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the driving gear";
        I2 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the driven gear";
        zeta "1" default 0.0, from 0.0 to inf, "damping factor of phi at the mid stiffness";
        T0 "N*m" required, open -inf to inf, "balanced torque: T0 N1 drives, T0 N2 loads";
        b "rad" required with backlash, open 0.0 to inf, "backlash of the mesh, in phi: no contact within b/2 to either side";
        alpha "rad" default 0.3490658503988659, open 0.0 to inf, "working pressure angle, for friction";
        mu "1" required with sliding_friction, from 0.0 to inf, "coefficient of friction of the mesh";
        w_mix "rad/s" default 0.1, open 0.0 to inf, "rolling speed omega1 + omega2 of the mesh below which friction decreases to zero (mixed film)";
    }
    laws {
        k "N*m" phase theta period 6.283185307179586 rolling, "mesh stiffness, 2 kt (r1/N1)^2 with kt along the line of action";
        e "rad" phase theta period 6.283185307179586 rolling with transmission_error, "transmission error in phi, et N1/(2 r1) with et along the line of action";
        side "1" phase theta period 6.283185307179586 rolling with sliding_friction as side, "share of the force of the mesh on tooth pairs beyond the pitch point, minus that on pairs before it";
        arm "rad" phase theta period 6.283185307179586 rolling with sliding_friction as arm, "mean distance of the force of the mesh from the pitch point along the line of action";
    }
    motions {
        speed "rad/s" { theta_dot = N1; }, "rotational speed of the driving gear";
    }
    effects {
        stiffness_step "the mesh stiffness steps as tooth pairs enter and leave, with the jump terms that conserve energy; without it the stiffness is constant at its mid value";
        rigid_kinematics requires(stiffness_step) excludes(frozen_phase) "drops the jump terms: speeds pass a step unchanged, and energy is not conserved";
        frozen_phase requires(stiffness_step) excludes(rigid_kinematics) "steps at the times of a steady rotation, k(Omega0 t) instead of k(theta): the classical equations";
        transmission_error requires(stiffness_step) "flanks deviate from their ideal position: V = k (delta - e)^2/2, with the jump terms of e where it steps";
        backlash "play between the flanks: contact on the drive or coast flank, free motion between";
        damping "Rayleigh damping of the relative motion, with the damping factor zeta";
        torques "constant driving and load torque in balance";
        sliding_friction requires(stiffness_step) excludes(rigid_kinematics, frozen_phase) "Coulomb friction between the flanks, against their sliding, which changes its direction when a tooth pair passes the pitch point";
    }
    conditions {
        jump_terms = stiffness_step, !rigid_kinematics, !frozen_phase;
        moving_phase = stiffness_step, !frozen_phase;
        transmission_error_and_jump_terms = transmission_error, stiffness_step, !rigid_kinematics, !frozen_phase;
        transmission_error_and_sliding_friction_and_moving_phase = transmission_error, sliding_friction, stiffness_step, !frozen_phase;
        sliding_friction_and_moving_phase = sliding_friction, stiffness_step, !frozen_phase;
        transmission_error_and_backlash_and_moving_phase = transmission_error, backlash, stiffness_step, !frozen_phase;
        transmission_error_and_moving_phase = transmission_error, stiffness_step, !frozen_phase;
        backlash_and_moving_phase = backlash, stiffness_step, !frozen_phase;
    }

    constants {
        M1 = (N1.powi(2)/I1 - N2.powi(2)/I2)/2.0;
        M2 = (N1.powi(2)/I1 + N2.powi(2)/I2)/2.0;
        C = 2.0*zeta*(k_mid/M2).sqrt();
        tan_a = alpha.sin()/alpha.cos();
        tiny = 1.0/1000000000000.0;
    }
    deflections {
        over = phi - edge - e;
        tau = 2.0*tan_a*phi;
        psi = phi/N1 + theta/N1 - phi/N2 + theta/N2;
    }
    forces {
        F_mu { sliding_friction => mu*k*touch*psi_dot*(tiny.powi(2) + over.powi(2)).sqrt()/(w_mix.powi(2) + psi_dot.powi(2)).sqrt(); }
    }
    dead_bands {
        over "rad" (touch, edge, damp, clip) half b/2.0 with backlash, "play of the mesh, in phi";
    }
    energies {
        kinetic {
            _ => (I1*(phi_dot + theta_dot).powi(2)/N1.powi(2) + I2*(theta_dot - phi_dot).powi(2)/N2.powi(2))/2.0;
        }
        potential {
            _ => k*touch*over.powi(2);
        }
        dissipation {
            damping => C*damp*over_dot.powi(2);
        }
    }
    torques {
        drive "torque T0 N1 on the driving gear" {
            torques => T0*(phi + theta);
        }
        load "torque -T0 N2 on the driven gear" {
            torques => -T0*(theta - phi);
        }
        slide "friction of the mesh, through the sliding of the flanks at the pitch point" {}
        power {
            sliding_friction => -side*F_mu*tau_dot;
        }
        roll "friction of the mesh, through the rolling of the gears" {}
        power {
            sliding_friction => -arm*F_mu*psi_dot;
        }
    }
    work {
        theta {}
        phi {
            torques => 2.0*T0;
        }
    }
    mass {
        theta theta {
            _ => I1/N1.powi(2) + I2/N2.powi(2);
        }
        theta phi {
            _ => I1/N1.powi(2) - I2/N2.powi(2);
        }
        phi phi {
            _ => I1/N1.powi(2) + I2/N2.powi(2);
        }
    }
    mobility {
        theta theta {
            _ => M2/2.0;
        }
        theta phi {
            _ => M1/2.0;
        }
        phi phi {
            _ => M2/2.0;
        }
    }
    force {
        theta {
            transmission_error_and_jump_terms => 2.0*k*de*touch*over;
            sliding_friction => -arm*F_mu/N1 - arm*F_mu/N2;
            jump_terms => -dk*touch*over.powi(2);
        }
        phi {
            _ => -2.0*k*touch*over;
            backlash => -2.0*k*touch*clip*over;
            damping => -2.0*C*damp*over_dot;
            torques => 2.0*T0;
            sliding_friction => arm*F_mu/N2 - 2.0*tan_a*side*F_mu - arm*F_mu/N1;
        }
    }
    jacobian {
        theta theta {
            transmission_error_and_sliding_friction_and_moving_phase => mu*k*de*arm*touch*over*psi_dot/(N1*(tiny.powi(2) + over.powi(2)).sqrt()*(w_mix.powi(2) + psi_dot.powi(2)).sqrt()) + mu*k*de*arm*touch*over*psi_dot/(N2*(tiny.powi(2) + over.powi(2)).sqrt()*(w_mix.powi(2) + psi_dot.powi(2)).sqrt());
            transmission_error_and_jump_terms => 2.0*k*dde*touch*over - 2.0*k*de.powi(2)*touch + 4.0*de*dk*touch*over;
            sliding_friction_and_moving_phase => -mu*k*darm*touch*psi_dot*(tiny.powi(2) + over.powi(2)).sqrt()/(N1*(w_mix.powi(2) + psi_dot.powi(2)).sqrt()) - mu*dk*arm*touch*psi_dot*(tiny.powi(2) + over.powi(2)).sqrt()/(N1*(w_mix.powi(2) + psi_dot.powi(2)).sqrt()) - mu*k*darm*touch*psi_dot*(tiny.powi(2) + over.powi(2)).sqrt()/(N2*(w_mix.powi(2) + psi_dot.powi(2)).sqrt()) - mu*dk*arm*touch*psi_dot*(tiny.powi(2) + over.powi(2)).sqrt()/(N2*(w_mix.powi(2) + psi_dot.powi(2)).sqrt());
            jump_terms => -ddk*touch*over.powi(2);
        }
        theta phi {
            transmission_error_and_jump_terms => 2.0*k*de*touch;
            sliding_friction => -mu*k*arm*touch*over*psi_dot/(N1*(tiny.powi(2) + over.powi(2)).sqrt()*(w_mix.powi(2) + psi_dot.powi(2)).sqrt()) - mu*k*arm*touch*over*psi_dot/(N2*(tiny.powi(2) + over.powi(2)).sqrt()*(w_mix.powi(2) + psi_dot.powi(2)).sqrt());
            jump_terms => -2.0*dk*touch*over;
        }
        theta theta_dot {
            sliding_friction => mu*k*arm*touch*psi_dot.powi(2)*(tiny.powi(2) + over.powi(2)).sqrt()/(N1.powi(2)*(w_mix.powi(2) + psi_dot.powi(2)).powf(3.0/2.0)) - mu*k*arm*touch*(tiny.powi(2) + over.powi(2)).sqrt()/(N1.powi(2)*(w_mix.powi(2) + psi_dot.powi(2)).sqrt()) + 2.0*mu*k*arm*touch*psi_dot.powi(2)*(tiny.powi(2) + over.powi(2)).sqrt()/(N1*N2*(w_mix.powi(2) + psi_dot.powi(2)).powf(3.0/2.0)) - 2.0*mu*k*arm*touch*(tiny.powi(2) + over.powi(2)).sqrt()/(N1*N2*(w_mix.powi(2) + psi_dot.powi(2)).sqrt()) + mu*k*arm*touch*psi_dot.powi(2)*(tiny.powi(2) + over.powi(2)).sqrt()/(N2.powi(2)*(w_mix.powi(2) + psi_dot.powi(2)).powf(3.0/2.0)) - mu*k*arm*touch*(tiny.powi(2) + over.powi(2)).sqrt()/(N2.powi(2)*(w_mix.powi(2) + psi_dot.powi(2)).sqrt());
        }
        theta phi_dot {
            sliding_friction => mu*k*arm*touch*psi_dot.powi(2)*(tiny.powi(2) + over.powi(2)).sqrt()/(N1.powi(2)*(w_mix.powi(2) + psi_dot.powi(2)).powf(3.0/2.0)) - mu*k*arm*touch*(tiny.powi(2) + over.powi(2)).sqrt()/(N1.powi(2)*(w_mix.powi(2) + psi_dot.powi(2)).sqrt()) - mu*k*arm*touch*psi_dot.powi(2)*(tiny.powi(2) + over.powi(2)).sqrt()/(N2.powi(2)*(w_mix.powi(2) + psi_dot.powi(2)).powf(3.0/2.0)) + mu*k*arm*touch*(tiny.powi(2) + over.powi(2)).sqrt()/(N2.powi(2)*(w_mix.powi(2) + psi_dot.powi(2)).sqrt());
        }
        phi theta {
            transmission_error_and_backlash_and_moving_phase => 2.0*k*de*touch*clip;
            transmission_error_and_sliding_friction_and_moving_phase => 2.0*tan_a*mu*k*de*side*touch*over*psi_dot/((tiny.powi(2) + over.powi(2)).sqrt()*(w_mix.powi(2) + psi_dot.powi(2)).sqrt()) + mu*k*de*arm*touch*over*psi_dot/(N1*(tiny.powi(2) + over.powi(2)).sqrt()*(w_mix.powi(2) + psi_dot.powi(2)).sqrt()) - mu*k*de*arm*touch*over*psi_dot/(N2*(tiny.powi(2) + over.powi(2)).sqrt()*(w_mix.powi(2) + psi_dot.powi(2)).sqrt());
            transmission_error_and_moving_phase => 2.0*k*de*touch;
            backlash_and_moving_phase => -2.0*dk*touch*clip*over;
            sliding_friction_and_moving_phase => mu*k*darm*touch*psi_dot*(tiny.powi(2) + over.powi(2)).sqrt()/(N2*(w_mix.powi(2) + psi_dot.powi(2)).sqrt()) - 2.0*tan_a*mu*k*dside*touch*psi_dot*(tiny.powi(2) + over.powi(2)).sqrt()/(w_mix.powi(2) + psi_dot.powi(2)).sqrt() - 2.0*tan_a*mu*dk*side*touch*psi_dot*(tiny.powi(2) + over.powi(2)).sqrt()/(w_mix.powi(2) + psi_dot.powi(2)).sqrt() - mu*k*darm*touch*psi_dot*(tiny.powi(2) + over.powi(2)).sqrt()/(N1*(w_mix.powi(2) + psi_dot.powi(2)).sqrt()) - mu*dk*arm*touch*psi_dot*(tiny.powi(2) + over.powi(2)).sqrt()/(N1*(w_mix.powi(2) + psi_dot.powi(2)).sqrt()) + mu*dk*arm*touch*psi_dot*(tiny.powi(2) + over.powi(2)).sqrt()/(N2*(w_mix.powi(2) + psi_dot.powi(2)).sqrt());
            moving_phase => -2.0*dk*touch*over;
        }
        phi phi {
            _ => -2.0*k*touch;
            backlash => -2.0*k*touch*clip;
            sliding_friction => mu*k*arm*touch*over*psi_dot/(N2*(tiny.powi(2) + over.powi(2)).sqrt()*(w_mix.powi(2) + psi_dot.powi(2)).sqrt()) - 2.0*tan_a*mu*k*side*touch*over*psi_dot/((tiny.powi(2) + over.powi(2)).sqrt()*(w_mix.powi(2) + psi_dot.powi(2)).sqrt()) - mu*k*arm*touch*over*psi_dot/(N1*(tiny.powi(2) + over.powi(2)).sqrt()*(w_mix.powi(2) + psi_dot.powi(2)).sqrt());
        }
        phi theta_dot {
            sliding_friction => 2.0*tan_a*mu*k*side*touch*psi_dot.powi(2)*(tiny.powi(2) + over.powi(2)).sqrt()/(N1*(w_mix.powi(2) + psi_dot.powi(2)).powf(3.0/2.0)) - 2.0*tan_a*mu*k*side*touch*(tiny.powi(2) + over.powi(2)).sqrt()/(N1*(w_mix.powi(2) + psi_dot.powi(2)).sqrt()) + 2.0*tan_a*mu*k*side*touch*psi_dot.powi(2)*(tiny.powi(2) + over.powi(2)).sqrt()/(N2*(w_mix.powi(2) + psi_dot.powi(2)).powf(3.0/2.0)) - 2.0*tan_a*mu*k*side*touch*(tiny.powi(2) + over.powi(2)).sqrt()/(N2*(w_mix.powi(2) + psi_dot.powi(2)).sqrt()) + mu*k*arm*touch*psi_dot.powi(2)*(tiny.powi(2) + over.powi(2)).sqrt()/(N1.powi(2)*(w_mix.powi(2) + psi_dot.powi(2)).powf(3.0/2.0)) - mu*k*arm*touch*(tiny.powi(2) + over.powi(2)).sqrt()/(N1.powi(2)*(w_mix.powi(2) + psi_dot.powi(2)).sqrt()) - mu*k*arm*touch*psi_dot.powi(2)*(tiny.powi(2) + over.powi(2)).sqrt()/(N2.powi(2)*(w_mix.powi(2) + psi_dot.powi(2)).powf(3.0/2.0)) + mu*k*arm*touch*(tiny.powi(2) + over.powi(2)).sqrt()/(N2.powi(2)*(w_mix.powi(2) + psi_dot.powi(2)).sqrt());
        }
        phi phi_dot {
            damping => -2.0*C*damp;
            sliding_friction => 2.0*tan_a*mu*k*side*touch*psi_dot.powi(2)*(tiny.powi(2) + over.powi(2)).sqrt()/(N1*(w_mix.powi(2) + psi_dot.powi(2)).powf(3.0/2.0)) - 2.0*tan_a*mu*k*side*touch*(tiny.powi(2) + over.powi(2)).sqrt()/(N1*(w_mix.powi(2) + psi_dot.powi(2)).sqrt()) - 2.0*tan_a*mu*k*side*touch*psi_dot.powi(2)*(tiny.powi(2) + over.powi(2)).sqrt()/(N2*(w_mix.powi(2) + psi_dot.powi(2)).powf(3.0/2.0)) + 2.0*tan_a*mu*k*side*touch*(tiny.powi(2) + over.powi(2)).sqrt()/(N2*(w_mix.powi(2) + psi_dot.powi(2)).sqrt()) + mu*k*arm*touch*psi_dot.powi(2)*(tiny.powi(2) + over.powi(2)).sqrt()/(N1.powi(2)*(w_mix.powi(2) + psi_dot.powi(2)).powf(3.0/2.0)) - mu*k*arm*touch*(tiny.powi(2) + over.powi(2)).sqrt()/(N1.powi(2)*(w_mix.powi(2) + psi_dot.powi(2)).sqrt()) - 2.0*mu*k*arm*touch*psi_dot.powi(2)*(tiny.powi(2) + over.powi(2)).sqrt()/(N1*N2*(w_mix.powi(2) + psi_dot.powi(2)).powf(3.0/2.0)) + 2.0*mu*k*arm*touch*(tiny.powi(2) + over.powi(2)).sqrt()/(N1*N2*(w_mix.powi(2) + psi_dot.powi(2)).sqrt()) + mu*k*arm*touch*psi_dot.powi(2)*(tiny.powi(2) + over.powi(2)).sqrt()/(N2.powi(2)*(w_mix.powi(2) + psi_dot.powi(2)).powf(3.0/2.0)) - mu*k*arm*touch*(tiny.powi(2) + over.powi(2)).sqrt()/(N2.powi(2)*(w_mix.powi(2) + psi_dot.powi(2)).sqrt());
        }
    }
    cell {
        stiffness {
            phi phi {
                _ => 2.0*k*touch;
                backlash => 2.0*k*touch*clip;
            }
        }
        damping {
            phi phi {
                damping => 2.0*C*damp;
            }
        }
        load {
            phi {
                _ => 2.0*(k*touch*edge + k*touch*e);
                backlash => 2.0*(k*touch*clip*edge + k*touch*clip*e);
                torques => 2.0*T0;
            }
        }
    }
    nonlinear_with {
        sliding_friction "-mu*k*side*touch*psi_dot*sqrt(tiny^2 + over^2)/sqrt(w_mix^2 + psi_dot^2) in the torque `slide`";
        sliding_friction "-mu*k*arm*touch*psi_dot*sqrt(tiny^2 + over^2)/sqrt(w_mix^2 + psi_dot^2) in the torque `roll`";
    }
    jump k {
        normal {
            theta {
                _ => 1.0;
            }
        }
        compliance {
            _ => M2/2.0;
        }
        direction {
            theta {
                _ => 1.0;
            }
            phi {
                _ => M1/M2;
            }
        }
        step {
            _ => dk*touch*over.powi(2);
        }
    }
    jump e {
        normal {
            theta {
                _ => 1.0;
            }
        }
        compliance {
            _ => M2/2.0;
        }
        direction {
            theta {
                _ => 1.0;
            }
            phi {
                _ => M1/M2;
            }
        }
        step {
            _ => k*de.powi(2)*touch - 2.0*k*de*touch*over;
        }
    }
    jump side {
        normal {
            theta {
                _ => 1.0;
            }
        }
        compliance {
            _ => M2/2.0;
        }
        direction {
            theta {
                _ => 1.0;
            }
            phi {
                _ => M1/M2;
            }
        }
        step {}
    }
    jump arm {
        normal {
            theta {
                _ => 1.0;
            }
        }
        compliance {
            _ => M2/2.0;
        }
        direction {
            theta {
                _ => 1.0;
            }
            phi {
                _ => M1/M2;
            }
        }
        step {}
    }

    text {
        "T = (I1*(phi_dot + theta_dot)^2/N1^2 + I2*(theta_dot - phi_dot)^2/N2^2)/2";
        "V = k*touch*over^2";
        "D = C*damp*over_dot^2 [damping]";
        "Q_theta = -arm*F_mu/N1 - arm*F_mu/N2 [sliding friction]";
        "Q_phi = 2*T0 [torques] + arm*F_mu/N2 - 2*tan_a*side*F_mu - arm*F_mu/N1 [sliding friction]";
        "M1 = (N1^2/I1 - N2^2/I2)/2";
        "M2 = (N1^2/I1 + N2^2/I2)/2";
        "C = 2*zeta*sqrt(k_mid/M2)";
        "tan_a = sin(alpha)/cos(alpha)";
        "tiny = 1/1000000000000";
        "over = phi - edge - e";
        "tau = 2*tan_a*phi";
        "psi = phi/N1 + theta/N1 - phi/N2 + theta/N2";
        "e = 0 without transmission error; the rates of deflections do not contain that of e";
        "side = 0 without sliding friction";
        "arm = 0 without sliding friction";
        "touch = 1 in contact, beyond edge = b/2 or -b/2; touch = 0 between the edges; without backlash touch = 1 and edge = 0";
        "damp = 1 and clip = 0 in contact while the damper force is less than the spring force, else damp = 0:";
        "  clip = 1 if the damper would push more than the spring: its force is limited to the spring force";
        "  clip = -1 if the damper would pull more than the spring pushes: the contact force is zero";
        "F_mu = mu*k*touch*psi_dot*sqrt(tiny^2 + over^2)/sqrt(w_mix^2 + psi_dot^2) [sliding friction]";
        "theta'' = -M1*k*touch*over + M2*k*de*touch*over [transmission error, jump terms] - M1*k*touch*clip*over [backlash] - C*M1*damp*over_dot [damping] + M1*T0 [torques] + M1*arm*F_mu/(2*N2) - M1*tan_a*side*F_mu - M1*arm*F_mu/(2*N1) - M2*arm*F_mu/(2*N1) - M2*arm*F_mu/(2*N2) [sliding friction] - M2*dk*touch*over^2/2 [jump terms]";
        "phi'' = -M2*k*touch*over + M1*k*de*touch*over [transmission error, jump terms] - M2*k*touch*clip*over [backlash] - C*M2*damp*over_dot [damping] + M2*T0 [torques] + M2*arm*F_mu/(2*N2) - M1*arm*F_mu/(2*N1) - M1*arm*F_mu/(2*N2) - M2*tan_a*side*F_mu - M2*arm*F_mu/(2*N1) [sliding friction] - M1*dk*touch*over^2/2 [jump terms]";
        "at a step dk of k in theta, transmission if theta_dot+^2 >= 0:";
        "theta_dot+^2 = theta_dot-^2 - M2*dk*touch*over^2";
        "phi_dot+ - phi_dot- = (M1/M2)*(theta_dot+ - theta_dot-)";
        "else reflection: theta_dot+ = -theta_dot-, and the stiffness does not step";
        "at a step de of e in theta, transmission if theta_dot+^2 >= 0:";
        "theta_dot+^2 = theta_dot-^2 - (M2*k*de^2*touch - 2*M2*k*de*touch*over)";
        "phi_dot+ - phi_dot- = (M1/M2)*(theta_dot+ - theta_dot-)";
        "else reflection: theta_dot+ = -theta_dot-, and e does not step";
        "at a step of side: dV = 0, the speeds do not change";
        "at a step of arm: dV = 0, the speeds do not change";
        "M q'' + C q' + K q = f with constant M, C, K, f: linear, solved exactly";
        "nonlinear with sliding_friction: -mu*k*side*touch*psi_dot*sqrt(tiny^2 + over^2)/sqrt(w_mix^2 + psi_dot^2) in the torque `slide`";
        "nonlinear with sliding_friction: -mu*k*arm*touch*psi_dot*sqrt(tiny^2 + over^2)/sqrt(w_mix^2 + psi_dot^2) in the torque `roll`";
    }
    latex {
        "T = \\frac{1}{2} (\\frac{I_{1}\\, \\left(\\dot{\\varphi} + \\dot{\\theta}\\right)^{2}}{N_{1}^{2}} + \\frac{I_{2}\\, \\left(\\dot{\\theta} - \\dot{\\varphi}\\right)^{2}}{N_{2}^{2}})";
        "V = k\\, \\mathrm{touch}\\, \\mathrm{over}^{2}";
        "D = C\\, \\mathrm{damp}\\, \\dot{\\mathrm{over}}^{2}\\ [\\text{damping}]";
        "Q_{\\theta} = -\\frac{\\mathrm{arm}\\, F_{mu}}{N_{1}} - \\frac{\\mathrm{arm}\\, F_{mu}}{N_{2}}\\ [\\text{sliding friction}]";
        "Q_{\\varphi} = 2\\, T_{0}\\ [\\text{torques}] + \\frac{\\mathrm{arm}\\, F_{mu}}{N_{2}} - 2\\, \\mathrm{tan}_{a}\\, \\mathrm{side}\\, F_{mu} - \\frac{\\mathrm{arm}\\, F_{mu}}{N_{1}}\\ [\\text{sliding friction}]";
        "M_{1} = \\frac{1}{2} (\\frac{N_{1}^{2}}{I_{1}} - \\frac{N_{2}^{2}}{I_{2}})";
        "M_{2} = \\frac{1}{2} (\\frac{N_{1}^{2}}{I_{1}} + \\frac{N_{2}^{2}}{I_{2}})";
        "C = 2\\, \\zeta\\, \\sqrt{\\frac{\\bar{k}}{M_{2}}}";
        "\\mathrm{tan}_{a} = \\frac{\\sin\\left(\\alpha\\right)}{\\cos\\left(\\alpha\\right)}";
        "\\mathrm{tiny} = \\frac{1}{1000000000000}";
        "\\mathrm{over} = \\varphi - \\mathrm{edge} - e";
        "\\tau = 2\\, \\mathrm{tan}_{a}\\, \\varphi";
        "\\psi = \\frac{\\varphi}{N_{1}} + \\frac{\\theta}{N_{1}} - \\frac{\\varphi}{N_{2}} + \\frac{\\theta}{N_{2}}";
        "F_{mu} = \\frac{\\mu\\, k\\, \\mathrm{touch}\\, \\dot{\\psi}\\, \\sqrt{\\mathrm{tiny}^{2} + \\mathrm{over}^{2}}}{\\sqrt{w_{mix}^{2} + \\dot{\\psi}^{2}}}";
        "\\ddot{\\theta} = -M_{1}\\, k\\, \\mathrm{touch}\\, \\mathrm{over} + M_{2}\\, k\\, e'\\, \\mathrm{touch}\\, \\mathrm{over}\\ [\\text{transmission error, jump terms}] - M_{1}\\, k\\, \\mathrm{touch}\\, \\mathrm{clip}\\, \\mathrm{over}\\ [\\text{backlash}] - C\\, M_{1}\\, \\mathrm{damp}\\, \\dot{\\mathrm{over}}\\ [\\text{damping}] + M_{1}\\, T_{0}\\ [\\text{torques}] + \\frac{M_{1}\\, \\mathrm{arm}\\, F_{mu}}{2\\, N_{2}} - M_{1}\\, \\mathrm{tan}_{a}\\, \\mathrm{side}\\, F_{mu} - \\frac{M_{1}\\, \\mathrm{arm}\\, F_{mu}}{2\\, N_{1}} - \\frac{M_{2}\\, \\mathrm{arm}\\, F_{mu}}{2\\, N_{1}} - \\frac{M_{2}\\, \\mathrm{arm}\\, F_{mu}}{2\\, N_{2}}\\ [\\text{sliding friction}] - \\frac{M_{2}\\, k'\\, \\mathrm{touch}\\, \\mathrm{over}^{2}}{2}\\ [\\text{jump terms}]";
        "\\ddot{\\varphi} = -M_{2}\\, k\\, \\mathrm{touch}\\, \\mathrm{over} + M_{1}\\, k\\, e'\\, \\mathrm{touch}\\, \\mathrm{over}\\ [\\text{transmission error, jump terms}] - M_{2}\\, k\\, \\mathrm{touch}\\, \\mathrm{clip}\\, \\mathrm{over}\\ [\\text{backlash}] - C\\, M_{2}\\, \\mathrm{damp}\\, \\dot{\\mathrm{over}}\\ [\\text{damping}] + M_{2}\\, T_{0}\\ [\\text{torques}] + \\frac{M_{2}\\, \\mathrm{arm}\\, F_{mu}}{2\\, N_{2}} - \\frac{M_{1}\\, \\mathrm{arm}\\, F_{mu}}{2\\, N_{1}} - \\frac{M_{1}\\, \\mathrm{arm}\\, F_{mu}}{2\\, N_{2}} - M_{2}\\, \\mathrm{tan}_{a}\\, \\mathrm{side}\\, F_{mu} - \\frac{M_{2}\\, \\mathrm{arm}\\, F_{mu}}{2\\, N_{1}}\\ [\\text{sliding friction}] - \\frac{M_{1}\\, k'\\, \\mathrm{touch}\\, \\mathrm{over}^{2}}{2}\\ [\\text{jump terms}]";
        "\\dot{\\theta}_+^2 = \\dot{\\theta}_-^2 - M_{2}\\, \\Delta k\\, \\mathrm{touch}\\, \\mathrm{over}^{2}";
        "\\dot{\\varphi}_+ - \\dot{\\varphi}_- = \\frac{M_{1}}{M_{2}} \\left(\\dot{\\theta}_+ - \\dot{\\theta}_-\\right)";
        "\\dot{\\theta}_+^2 = \\dot{\\theta}_-^2 - (M_{2}\\, k\\, \\Delta e^{2}\\, \\mathrm{touch} - 2\\, M_{2}\\, k\\, \\Delta e\\, \\mathrm{touch}\\, \\mathrm{over})";
        "\\dot{\\varphi}_+ - \\dot{\\varphi}_- = \\frac{M_{1}}{M_{2}} \\left(\\dot{\\theta}_+ - \\dot{\\theta}_-\\right)";
    }
}
