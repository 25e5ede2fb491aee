//! The gear pair as derived from energies that declare stiffness steps and torques only. Its right-hand side must cost as much
//! as that of `gear_pair` in a scene without the other effects.
//!
//! There are two versions: one without outputs, and one with those of a gear pair. Outputs that a scene does not record must cost nothing.

macro_rules! pair {
    ($name:ident $(, $outputs:ident)?) => {
        gearsim::equations! {
            model $name "two spur gears on rigid shafts, never damped";

            coordinates {
                theta "rad" start 0.0, "mean rotation";
                phi "rad" start static, "relative deflection";
            }
            parameters {
                N1 "1" default 24.0, open 0.0 to inf, "teeth";
                N2 "1" default 96.0, open 0.0 to inf, "teeth";
                I1 "kg*m^2" required, open 0.0 to inf, "inertia";
                I2 "kg*m^2" required, open 0.0 to inf, "inertia";
                T0 "N*m" required, open -inf to inf, "torque";
            }
            laws {
                k "N*m" phase theta period 6.283185307179586 rolling, "mesh stiffness";
            }
            effects {
                stiffness_step "the stiffness steps";
                torques "constant torques";
            }
            switching { stiffness_step => with_jump; }
            conditions {
                jump_terms = stiffness_step;
                moving_phase = stiffness_step;
            }
            constants {
                M1 = (N1.powi(2)/I1 - N2.powi(2)/I2)/2.0;
                M2 = (N1.powi(2)/I1 + N2.powi(2)/I2)/2.0;
            }
            energies {
                kinetic {
                    _ => (I1*(phi_dot + theta_dot).powi(2)/N1.powi(2) + I2*(theta_dot - phi_dot).powi(2)/N2.powi(2))/2.0;
                }
                potential { _ => k*phi.powi(2); }
            }
            work { phi { torques => 2.0*T0; } }
            mass {
                theta theta { _ => I1/N1.powi(2) + I2/N2.powi(2); }
                theta phi { _ => I1/N1.powi(2) - I2/N2.powi(2); }
                phi phi { _ => I1/N1.powi(2) + I2/N2.powi(2); }
            }
            mobility {
                theta theta { _ => M2/2.0; }
                theta phi { _ => M1/2.0; }
                phi phi { _ => M2/2.0; }
            }
            force {
                theta { jump_terms => -dk*phi.powi(2); }
                phi { _ => -2.0*k*phi; torques => 2.0*T0; }
            }
            jacobian {
                theta phi { jump_terms => -2.0*dk*phi; }
                phi phi { _ => -2.0*k; }
            }
            cell {
                stiffness { phi phi { _ => 2.0*k; } }
                load { phi { torques => 2.0*T0; } }
            }
            jump k {
                normal { theta { _ => 1.0; } }
                compliance { _ => M2/2.0; }
                direction { theta { _ => 1.0; } phi { _ => M1/M2; } }
                step { _ => dk*phi.powi(2); }
            }
            $($outputs {
                dte "rad", "dynamic transmission error as a rotation of the driving gear" { _ => 2.0*phi/N1; }
                mesh_torque "N*m", "torque of the mesh on the driving gear" { _ => N1*k*phi; }
                mesh_power "W", "power that the driving gear gives to the mesh" { _ => mesh_torque*(phi_dot/N1 + theta_dot/N1); }
                rotor_speed_1 "rad/s", "rotational speed of the driving gear" { _ => phi_dot/N1 + theta_dot/N1; }
                rotor_speed_2 "rad/s", "rotational speed of the driven gear" { _ => theta_dot/N2 - phi_dot/N2; }
            })?
        }
    };
}

mod without {
    pair!(bare_pair);
}

mod with {
    pair!(watched_pair, outputs);
}

pub use with::WatchedPair;
pub use without::BarePair;
