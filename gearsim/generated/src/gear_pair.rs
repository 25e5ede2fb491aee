//! Equations of motion of `gear_pair`: two spur gears on rigid shafts.
//!
//! Derived from the energies in `models/src/gear_pair.rs` by `cargo xtask derive gear_pair`.
//! Do not edit: change the energies and derive again.
//! For reading: `text/gear_pair.txt`, `latex/gear_pair.tex`. What is proved: at the end.

use gearsim::equations;

equations! {
    model gear_pair "two spur gears on rigid shafts";
    source "Oh, Grosh & Barber (2005), J. Vib. Acoust. 127(2), doi:10.1115/1.1891815";

    coordinates {
        theta "rad" start 0.0, "mean rotation, (N1 theta1 + N2 theta2)/2";
        phi "rad" start static, "relative deflection, (N1 theta1 - N2 theta2)/2";
    }
    parameters {
        N1 "1" teeth default 24.0, open 0.0 to inf, "number of teeth of the driving gear";
        N2 "1" teeth default 96.0, open 0.0 to inf, "number of teeth of the driven gear";
        I1 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the driving gear";
        I2 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the driven gear";
        zeta "1" default 0.0, from 0.0 to inf, "damping factor of phi at the mid stiffness";
        T0 "N*m" required, open -inf to inf, "torque per tooth: T0 N1 drives the driving gear, T0 N2 loads the driven gear";
        b "rad" required with backlash, open 0.0 to inf,
            "backlash of the mesh in phi, bt N1/(2 rb1) with bt along the line of action: no contact within b/2 to either side";
        alpha "rad" pressure_angle default 0.3490658503988659, open 0.0 to inf, "working pressure angle, for friction";
        mu "1" required with sliding_friction, from 0.0 to inf, "coefficient of friction of the mesh";
        w_mix "rad/s" default 0.1 with sliding_friction, open 0.0 to inf,
            "rolling speed omega1 + omega2 of the mesh below which friction decreases to zero (mixed film)";
        mu_rise "1" default 0.0 with flank_stiction, from 0.0 to inf,
            "excess of the static coefficient of friction of the mesh over that of sliding, relative to that";
        c_motor "N*m*s/rad" required with governor_motor, open 0.0 to inf,
            "gain of the governor of the driving gear: torque per difference of set point and speed";
        n_motor "rad/s" required with governor_motor, open -inf to inf, "set point of the speed governor of the driving gear";
        Ts_motor "N*m" required with dc_motor, open 0.0 to inf, "stall torque of the DC motor of the driving gear";
        n0_motor "rad/s" required with dc_motor, open 0.0 to inf, "no-load speed of the DC motor of the driving gear";
        Tb_motor "N*m" required with induction_motor, open 0.0 to inf,
            "breakdown torque of the induction motor of the driving gear, its largest torque";
        sb_motor "1" required with induction_motor, open 0.0 to inf,
            "slip at which the induction motor of the driving gear has its breakdown torque";
        ns_motor "rad/s" required with induction_motor, open 0.0 to inf, "synchronous speed of the induction motor of the driving gear";
        Tp_motor "N*m" required with traction_motor, open 0.0 to inf,
            "peak torque of the traction motor of the driving gear, up to its base speed";
        Pp_motor "W" required with traction_motor, open 0.0 to inf,
            "peak power of the traction motor of the driving gear, above its base speed Pp/Tp";
        d_motor "1" default 1.0 with traction_motor, open -inf to inf,
            "demand on the traction motor of the driving gear: 1 drives with its peak torque or power, -1 brakes with them";
        round_motor "1" default 0.01 with traction_motor, open 0.0 to inf,
            "rounding of the corner of the torque of the traction motor of the driving gear at its base speed, relative to that";
        cf_motor "N*m*s^2/rad^2" required with fan_motor, from 0.0 to inf,
            "torque of the fan of the driving gear divided by the square of its speed";
        w0_motor "rad/s" default 0.01 with fan_motor, open 0.0 to inf,
            "speed of the driving gear below which the torque of its fan is linear instead of quadratic in the speed";
        c_load "N*m*s/rad" required with governor_load, open 0.0 to inf,
            "gain of the governor of the driven gear: torque per difference of set point and speed";
        n_load "rad/s" required with governor_load, open -inf to inf, "set point of the speed governor of the driven gear";
        Ts_load "N*m" required with dc_load, open 0.0 to inf, "stall torque of the DC motor of the driven gear";
        n0_load "rad/s" required with dc_load, open 0.0 to inf, "no-load speed of the DC motor of the driven gear";
        Tb_load "N*m" required with induction_load, open 0.0 to inf,
            "breakdown torque of the induction motor of the driven gear, its largest torque";
        sb_load "1" required with induction_load, open 0.0 to inf,
            "slip at which the induction motor of the driven gear has its breakdown torque";
        ns_load "rad/s" required with induction_load, open 0.0 to inf, "synchronous speed of the induction motor of the driven gear";
        Tp_load "N*m" required with traction_load, open 0.0 to inf,
            "peak torque of the traction motor of the driven gear, up to its base speed";
        Pp_load "W" required with traction_load, open 0.0 to inf,
            "peak power of the traction motor of the driven gear, above its base speed Pp/Tp";
        d_load "1" default 1.0 with traction_load, open -inf to inf,
            "demand on the traction motor of the driven gear: 1 drives with its peak torque or power, -1 brakes with them";
        round_load "1" default 0.01 with traction_load, open 0.0 to inf,
            "rounding of the corner of the torque of the traction motor of the driven gear at its base speed, relative to that";
        cf_load "N*m*s^2/rad^2" required with fan_load, from 0.0 to inf,
            "torque of the fan of the driven gear divided by the square of its speed";
        w0_load "rad/s" default 0.01 with fan_load, open 0.0 to inf,
            "speed of the driven gear below which the torque of its fan is linear instead of quadratic in the speed";
    }
    laws {
        k "N*m" phase theta period 6.283185307179586 rolling,
            "mesh stiffness, 2 kt (rb1/N1)^2 with kt along the line of action, rb1 the base radius";
        e "rad" phase theta period 6.283185307179586 rolling with transmission_error,
            "transmission error in phi, et N1/(2 rb1) with et along the line of action";
        side "1" phase theta period 6.283185307179586 rolling with sliding_friction as side,
            "share of the force of the mesh on tooth pairs beyond the pitch point, minus that on pairs before it";
        arm "rad" phase theta period 6.283185307179586 rolling with sliding_friction as arm,
            "mean distance of the force of the mesh from the pitch point along the line of action";
    }
    motions { speed "rad/s" { theta_dot = N1; }, "rotational speed of the driving gear"; }
    effects {
        stiffness_step
            "the mesh stiffness steps as tooth pairs enter and leave, conserving energy by jump terms; else it has its mid value";
        rigid_kinematics requires(stiffness_step) excludes(frozen_phase)
            "drops the jump terms: speeds pass a step unchanged, and energy is not conserved";
        frozen_phase requires(stiffness_step) excludes(rigid_kinematics)
            "steps at the times of a steady rotation, k(Omega0 t) instead of k(theta): the classical equations";
        transmission_error requires(stiffness_step)
            "flanks deviate from their ideal position: V = k (delta - e)^2/2, with the jump terms of e where it steps";
        backlash "play between the flanks: contact on the drive or coast flank, free motion between";
        damping "Rayleigh damping of the relative motion, with the damping factor zeta";
        torques "constant driving and load torque in balance";
        sliding_friction requires(stiffness_step)
            "Coulomb friction between the flanks, against their sliding, which turns as a tooth pair passes the pitch point";
        flank_stiction requires(sliding_friction)
            "flanks at rest stick, up to their static friction; sliding, their friction has its full size at any speed";
        governor_motor of governor excludes(dc_motor, induction_motor, traction_motor)
            "a motor with a speed governor: its torque is proportional to the set point minus the speed";
        dc_motor of dc excludes(induction_motor, traction_motor)
            "a DC motor at constant voltage: its torque falls linearly from stall to no load";
        induction_motor of induction excludes(traction_motor) "an induction motor, its torque by the formula of Kloss";
        traction_motor of traction "a traction motor: its peak torque up to the base speed, constant power above it, times the demand";
        fan_motor of fan "a fan as load: torque proportional to the square of the speed, against the rotation";
        governor_load of governor excludes(dc_load, induction_load, traction_load)
            "a motor with a speed governor: its torque is proportional to the set point minus the speed";
        dc_load of dc excludes(induction_load, traction_load)
            "a DC motor at constant voltage: its torque falls linearly from stall to no load";
        induction_load of induction excludes(traction_load) "an induction motor, its torque by the formula of Kloss";
        traction_load of traction "a traction motor: its peak torque up to the base speed, constant power above it, times the demand";
        fan_load of fan "a fan as load: torque proportional to the square of the speed, against the rotation";
    }
    switching {
        stiffness_step => with_jump;
        rigid_kinematics => without_jump;
        frozen_phase => by_time;
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
        per_wb_motor = Tp_motor/Pp_motor;
        per_wb_load = Tp_load/Pp_load;
    }
    deflections {
        over = phi - edge - e;
        tau = 2.0*tan_a*phi;
        psi = phi/N1 + theta/N1 - phi/N2 + theta/N2;
        theta_motor = phi/N1 + theta/N1;
        theta_load = theta/N2 - phi/N2;
    }
    forces {
        F_mu {
            sliding_friction => mu*k*touch*psi_dot*(tiny.powi(2) + over.powi(2)).sqrt()/(w_mix.powi(2) + psi_dot.powi(2)).sqrt();
            flank_stiction => mu*k*slide_dir*touch*(tiny.powi(2) + over.powi(2)).sqrt()
                - mu*k*touch*psi_dot*(tiny.powi(2) + over.powi(2)).sqrt()/(w_mix.powi(2) + psi_dot.powi(2)).sqrt();
        }
        F_tau { sliding_friction => F_mu*over/(tiny.powi(2) + over.powi(2)).sqrt(); }
        T_induction_motor {
            induction_motor => 2.0*Tb_motor*sb_motor*(1.0 - theta_motor_dot/ns_motor)
                /(sb_motor.powi(2) + (1.0 - theta_motor_dot/ns_motor).powi(2));
        }
        T_traction_motor {
            traction_motor => 2.0*Tp_motor*d_motor
                /((round_motor.powi(2) + (1.0 - per_wb_motor*theta_motor_dot).powi(2)).sqrt()
                + (round_motor.powi(2) + (1.0 + per_wb_motor*theta_motor_dot).powi(2)).sqrt());
        }
        T_fan_motor { fan_motor => -cf_motor*theta_motor_dot*(w0_motor.powi(2) + theta_motor_dot.powi(2)).sqrt(); }
        T_induction_load {
            induction_load => 2.0*Tb_load*sb_load*(1.0 - theta_load_dot/ns_load)/(sb_load.powi(2) + (1.0 - theta_load_dot/ns_load).powi(2));
        }
        T_traction_load {
            traction_load => 2.0*Tp_load*d_load
                /((round_load.powi(2) + (1.0 - per_wb_load*theta_load_dot).powi(2)).sqrt()
                + (round_load.powi(2) + (1.0 + per_wb_load*theta_load_dot).powi(2)).sqrt());
        }
        T_fan_load { fan_load => -cf_load*theta_load_dot*(w0_load.powi(2) + theta_load_dot.powi(2)).sqrt(); }
    }
    partials {
        F_mu_by_over {
            sliding_friction => mu*k*touch*over*psi_dot/((tiny.powi(2) + over.powi(2)).sqrt()*(w_mix.powi(2) + psi_dot.powi(2)).sqrt());
            flank_stiction => mu*k*slide_dir*touch*over/(tiny.powi(2) + over.powi(2)).sqrt()
                - mu*k*touch*over*psi_dot/((tiny.powi(2) + over.powi(2)).sqrt()*(w_mix.powi(2) + psi_dot.powi(2)).sqrt());
        }
        F_mu_by_psi_dot {
            sliding_friction => mu*k*touch*(tiny.powi(2) + over.powi(2)).sqrt()/(w_mix.powi(2) + psi_dot.powi(2)).sqrt()
                - mu*k*touch*psi_dot.powi(2)*(tiny.powi(2) + over.powi(2)).sqrt()/(w_mix.powi(2) + psi_dot.powi(2)).powf(3.0/2.0);
            flank_stiction => mu*k*touch*psi_dot.powi(2)*(tiny.powi(2) + over.powi(2)).sqrt()
                /(w_mix.powi(2) + psi_dot.powi(2)).powf(3.0/2.0)
                - mu*k*touch*(tiny.powi(2) + over.powi(2)).sqrt()/(w_mix.powi(2) + psi_dot.powi(2)).sqrt();
        }
        F_mu_by_k {
            sliding_friction => mu*touch*psi_dot*(tiny.powi(2) + over.powi(2)).sqrt()/(w_mix.powi(2) + psi_dot.powi(2)).sqrt();
            flank_stiction => mu*slide_dir*touch*(tiny.powi(2) + over.powi(2)).sqrt()
                - mu*touch*psi_dot*(tiny.powi(2) + over.powi(2)).sqrt()/(w_mix.powi(2) + psi_dot.powi(2)).sqrt();
        }
        F_tau_by_over {
            sliding_friction => F_mu/(tiny.powi(2) + over.powi(2)).sqrt() - F_mu*over.powi(2)/(tiny.powi(2) + over.powi(2)).powf(3.0/2.0);
        }
        F_tau_by_F_mu { sliding_friction => over/(tiny.powi(2) + over.powi(2)).sqrt(); }
        T_induction_motor_by_theta_motor_dot {
            induction_motor => 4.0*Tb_motor*sb_motor*(1.0 - theta_motor_dot/ns_motor).powi(2)
                /(ns_motor*(sb_motor.powi(2) + (1.0 - theta_motor_dot/ns_motor).powi(2)).powi(2))
                - 2.0*Tb_motor*sb_motor/(ns_motor*(sb_motor.powi(2) + (1.0 - theta_motor_dot/ns_motor).powi(2)));
        }
        T_traction_motor_by_theta_motor_dot {
            traction_motor => -2.0*Tp_motor*d_motor
                *(per_wb_motor*(1.0 + per_wb_motor*theta_motor_dot)
                /(round_motor.powi(2) + (1.0 + per_wb_motor*theta_motor_dot).powi(2)).sqrt()
                - per_wb_motor*(1.0 - per_wb_motor*theta_motor_dot)
                /(round_motor.powi(2) + (1.0 - per_wb_motor*theta_motor_dot).powi(2)).sqrt())
                /((round_motor.powi(2) + (1.0 - per_wb_motor*theta_motor_dot).powi(2)).sqrt()
                + (round_motor.powi(2) + (1.0 + per_wb_motor*theta_motor_dot).powi(2)).sqrt()).powi(2);
        }
        T_fan_motor_by_theta_motor_dot {
            fan_motor => -cf_motor*theta_motor_dot.powi(2)/(w0_motor.powi(2) + theta_motor_dot.powi(2)).sqrt()
                - cf_motor*(w0_motor.powi(2) + theta_motor_dot.powi(2)).sqrt();
        }
        T_induction_load_by_theta_load_dot {
            induction_load => 4.0*Tb_load*sb_load*(1.0 - theta_load_dot/ns_load).powi(2)
                /(ns_load*(sb_load.powi(2) + (1.0 - theta_load_dot/ns_load).powi(2)).powi(2))
                - 2.0*Tb_load*sb_load/(ns_load*(sb_load.powi(2) + (1.0 - theta_load_dot/ns_load).powi(2)));
        }
        T_traction_load_by_theta_load_dot {
            traction_load => -2.0*Tp_load*d_load
                *(per_wb_load*(1.0 + per_wb_load*theta_load_dot)/(round_load.powi(2) + (1.0 + per_wb_load*theta_load_dot).powi(2)).sqrt()
                - per_wb_load*(1.0 - per_wb_load*theta_load_dot)/(round_load.powi(2) + (1.0 - per_wb_load*theta_load_dot).powi(2)).sqrt())
                /((round_load.powi(2) + (1.0 - per_wb_load*theta_load_dot).powi(2)).sqrt()
                + (round_load.powi(2) + (1.0 + per_wb_load*theta_load_dot).powi(2)).sqrt()).powi(2);
        }
        T_fan_load_by_theta_load_dot {
            fan_load => -cf_load*theta_load_dot.powi(2)/(w0_load.powi(2) + theta_load_dot.powi(2)).sqrt()
                - cf_load*(w0_load.powi(2) + theta_load_dot.powi(2)).sqrt();
        }
    }
    switches {
        over "rad" (touch 1.0, edge 0.0, damp 1.0, clip 0.0) with backlash,
            "play of the mesh in phi, bt N1/(2 rb1) with bt along the line of action" {
            upper (1.0, b/2.0, 1.0, 0.0) rests counts "flanks met" {
                unless free { over { _ => 1.0; } }
                until upper_loose {
                    over { _ => 2.0*k; }
                    over_dot { damping => 2.0*C; }
                }
                until upper_hit {
                    over { _ => 2.0*k; }
                    over_dot { damping => -2.0*C; }
                }
            }
            lower (1.0, -b/2.0, 1.0, 0.0) rests counts "flanks met" {
                unless free { over { _ => -1.0; } }
                until lower_loose {
                    over { _ => -2.0*k; }
                    over_dot { damping => -2.0*C; }
                }
                until lower_hit {
                    over { _ => -2.0*k; }
                    over_dot { damping => 2.0*C; }
                }
            }
            free (0.0, 0.0, 0.0, 0.0) rests {
                until upper {
                    over { _ => -1.0; }
                    one { _ => b/2.0; }
                }
                until lower {
                    over { _ => 1.0; }
                    one { _ => b/2.0; }
                }
            }
            upper_hit (1.0, b/2.0, 0.0, 1.0) counts "flanks met" {
                unless free { over { _ => 1.0; } }
                until upper {
                    over { _ => -2.0*k; }
                    over_dot { damping => 2.0*C; }
                }
            }
            lower_hit (1.0, -b/2.0, 0.0, 1.0) counts "flanks met" {
                unless free { over { _ => -1.0; } }
                until lower {
                    over { _ => 2.0*k; }
                    over_dot { damping => -2.0*C; }
                }
            }
            upper_loose (1.0, b/2.0, 0.0, -1.0) counts "flanks met" {
                until free { over { _ => 1.0; } }
                until upper {
                    over { _ => -2.0*k; }
                    over_dot { damping => -2.0*C; }
                }
            }
            lower_loose (1.0, -b/2.0, 0.0, -1.0) counts "flanks met" {
                until free { over { _ => -1.0; } }
                until lower {
                    over { _ => 2.0*k; }
                    over_dot { damping => 2.0*C; }
                }
            }
            loss { over { _ => 2.0*k*clip*touch; } }
        }
        psi "rad" (slide_dir 0.0) with flank_stiction, "whether the flanks of the mesh stick" {
            stuck (0.0) holds rests counts "stuck" {
                unless stuck_coast { over { _ => 1.0; } }
                until forward {
                    over { _ => mu*mu_rise*k*touch + mu*k*touch; }
                    reaction { _ => -1.0; }
                }
                until backward {
                    over { _ => mu*mu_rise*k*touch + mu*k*touch; }
                    reaction { _ => 1.0; }
                }
            }
            stuck_coast (0.0) holds rests counts "stuck" {
                unless stuck { over { _ => -1.0; } }
                until forward_coast {
                    over { _ => -mu*mu_rise*k*touch - mu*k*touch; }
                    reaction { _ => -1.0; }
                }
                until backward_coast {
                    over { _ => -mu*mu_rise*k*touch - mu*k*touch; }
                    reaction { _ => 1.0; }
                }
            }
            forward (1.0) {
                until forward_coast { over { _ => 1.0; } }
                until stuck {
                    psi_dot { _ => arm; }
                    tau_dot { _ => side; }
                }
            }
            backward (-1.0) {
                until backward_coast { over { _ => 1.0; } }
                until stuck {
                    psi_dot { _ => -arm; }
                    tau_dot { _ => -side; }
                }
            }
            forward_coast (1.0) {
                until forward { over { _ => -1.0; } }
                until stuck_coast {
                    psi_dot { _ => arm; }
                    tau_dot { _ => -side; }
                }
            }
            backward_coast (-1.0) {
                until backward { over { _ => -1.0; } }
                until stuck_coast {
                    psi_dot { _ => -arm; }
                    tau_dot { _ => side; }
                }
            }
        }
    }
    energies {
        kinetic { _ => (I1*(phi_dot + theta_dot).powi(2)/N1.powi(2) + I2*(theta_dot - phi_dot).powi(2)/N2.powi(2))/2.0; }
        potential { _ => k*touch*over.powi(2); }
        dissipation {
            damping => C*damp*over_dot.powi(2);
            governor_motor => c_motor*theta_motor_dot.powi(2)/2.0;
            dc_motor => Ts_motor*theta_motor_dot.powi(2)/(2.0*n0_motor);
            governor_load => c_load*theta_load_dot.powi(2)/2.0;
            dc_load => Ts_load*theta_load_dot.powi(2)/(2.0*n0_load);
        }
    }
    torques {
        drive "torque T0 N1 on the driving gear" { torques => T0*(phi + theta); }
        load "torque -T0 N2 on the driven gear" { torques => -T0*(theta - phi); }
        slide "friction of the mesh, through the sliding of the flanks at the pitch point" {}
        power { sliding_friction => -side*F_tau*tau_dot; }
        roll "friction of the mesh, through the rolling of the gears" {}
        power { sliding_friction => -arm*F_mu*psi_dot; }
        governor_motor "torque c n of the governor of the driving gear; its part -c omega is in D" {
            governor_motor => c_motor*n_motor*(phi/N1 + theta/N1);
        }
        dc_motor "torque Ts of the DC motor of the driving gear; its part -Ts omega/n0 is in D" {
            dc_motor => Ts_motor*(phi/N1 + theta/N1);
        }
        induction_motor "torque of the induction motor of the driving gear" {}
        power { induction_motor => T_induction_motor*(phi_dot/N1 + theta_dot/N1); }
        traction_motor "torque of the traction motor of the driving gear" {}
        power { traction_motor => T_traction_motor*(phi_dot/N1 + theta_dot/N1); }
        fan_motor "torque of the fan of the driving gear, against the rotation" {}
        power { fan_motor => T_fan_motor*(phi_dot/N1 + theta_dot/N1); }
        governor_load "torque c n of the governor of the driven gear; its part -c omega is in D" {
            governor_load => c_load*n_load*(theta/N2 - phi/N2);
        }
        dc_load "torque Ts of the DC motor of the driven gear; its part -Ts omega/n0 is in D" { dc_load => Ts_load*(theta/N2 - phi/N2); }
        induction_load "torque of the induction motor of the driven gear" {}
        power { induction_load => T_induction_load*(theta_dot/N2 - phi_dot/N2); }
        traction_load "torque of the traction motor of the driven gear" {}
        power { traction_load => T_traction_load*(theta_dot/N2 - phi_dot/N2); }
        fan_load "torque of the fan of the driven gear, against the rotation" {}
        power { fan_load => T_fan_load*(theta_dot/N2 - phi_dot/N2); }
    }
    work {
        theta {
            governor_motor => c_motor*n_motor/N1;
            dc_motor => Ts_motor/N1;
            governor_load => c_load*n_load/N2;
            dc_load => Ts_load/N2;
        }
        phi {
            torques => 2.0*T0;
            governor_motor => c_motor*n_motor/N1;
            dc_motor => Ts_motor/N1;
            governor_load => -c_load*n_load/N2;
            dc_load => -Ts_load/N2;
        }
    }
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
        theta {
            transmission_error_and_jump_terms => 2.0*k*de*touch*over;
            sliding_friction => -arm*F_mu/N1 - arm*F_mu/N2;
            governor_motor => c_motor*n_motor/N1 - c_motor*theta_motor_dot/N1;
            dc_motor => Ts_motor/N1 - Ts_motor*theta_motor_dot/(N1*n0_motor);
            induction_motor => T_induction_motor/N1;
            traction_motor => T_traction_motor/N1;
            fan_motor => T_fan_motor/N1;
            governor_load => c_load*n_load/N2 - c_load*theta_load_dot/N2;
            dc_load => Ts_load/N2 - Ts_load*theta_load_dot/(N2*n0_load);
            induction_load => T_induction_load/N2;
            traction_load => T_traction_load/N2;
            fan_load => T_fan_load/N2;
            jump_terms => -dk*touch*over.powi(2);
        }
        phi {
            _ => -2.0*k*touch*over;
            backlash => -2.0*k*clip*touch*over;
            damping => -2.0*C*damp*over_dot;
            torques => 2.0*T0;
            sliding_friction => arm*F_mu/N2 - 2.0*tan_a*side*F_tau - arm*F_mu/N1;
            governor_motor => c_motor*n_motor/N1 - c_motor*theta_motor_dot/N1;
            dc_motor => Ts_motor/N1 - Ts_motor*theta_motor_dot/(N1*n0_motor);
            induction_motor => T_induction_motor/N1;
            traction_motor => T_traction_motor/N1;
            fan_motor => T_fan_motor/N1;
            governor_load => c_load*theta_load_dot/N2 - c_load*n_load/N2;
            dc_load => Ts_load*theta_load_dot/(N2*n0_load) - Ts_load/N2;
            induction_load => -T_induction_load/N2;
            traction_load => -T_traction_load/N2;
            fan_load => -T_fan_load/N2;
        }
    }
    jacobian {
        theta theta {
            transmission_error_and_sliding_friction_and_moving_phase => de*arm*F_mu_by_over/N1 + de*arm*F_mu_by_over/N2;
            transmission_error_and_jump_terms => 2.0*k*dde*touch*over - 2.0*k*de.powi(2)*touch + 4.0*de*dk*touch*over;
            sliding_friction_and_moving_phase => -darm*F_mu/N1 - dk*arm*F_mu_by_k/N1 - darm*F_mu/N2 - dk*arm*F_mu_by_k/N2;
            jump_terms => -ddk*touch*over.powi(2);
        }
        theta over {
            transmission_error_and_jump_terms => 2.0*k*de*touch;
            sliding_friction => -arm*F_mu_by_over/N1 - arm*F_mu_by_over/N2;
            jump_terms => -2.0*dk*touch*over;
        }
        theta psi_dot { sliding_friction => -arm*F_mu_by_psi_dot/N1 - arm*F_mu_by_psi_dot/N2; }
        theta theta_motor_dot {
            governor_motor => -c_motor/N1;
            dc_motor => -Ts_motor/(N1*n0_motor);
            induction_motor => T_induction_motor_by_theta_motor_dot/N1;
            traction_motor => T_traction_motor_by_theta_motor_dot/N1;
            fan_motor => T_fan_motor_by_theta_motor_dot/N1;
        }
        theta theta_load_dot {
            governor_load => -c_load/N2;
            dc_load => -Ts_load/(N2*n0_load);
            induction_load => T_induction_load_by_theta_load_dot/N2;
            traction_load => T_traction_load_by_theta_load_dot/N2;
            fan_load => T_fan_load_by_theta_load_dot/N2;
        }
        phi theta {
            transmission_error_and_backlash_and_moving_phase => 2.0*k*de*clip*touch;
            transmission_error_and_sliding_friction_and_moving_phase => 2.0*tan_a*de*side*F_mu_by_over*F_tau_by_F_mu
                + 2.0*tan_a*de*side*F_tau_by_over + de*arm*F_mu_by_over/N1 - de*arm*F_mu_by_over/N2;
            transmission_error_and_moving_phase => 2.0*k*de*touch;
            backlash_and_moving_phase => -2.0*dk*clip*touch*over;
            sliding_friction_and_moving_phase => darm*F_mu/N2 - 2.0*tan_a*dk*side*F_mu_by_k*F_tau_by_F_mu - 2.0*tan_a*dside*F_tau
                - darm*F_mu/N1 - dk*arm*F_mu_by_k/N1 + dk*arm*F_mu_by_k/N2;
            moving_phase => -2.0*dk*touch*over;
        }
        phi over {
            _ => -2.0*k*touch;
            backlash => -2.0*k*clip*touch;
            sliding_friction => arm*F_mu_by_over/N2 - 2.0*tan_a*side*F_mu_by_over*F_tau_by_F_mu - 2.0*tan_a*side*F_tau_by_over
                - arm*F_mu_by_over/N1;
        }
        phi over_dot { damping => -2.0*C*damp; }
        phi psi_dot { sliding_friction => arm*F_mu_by_psi_dot/N2 - 2.0*tan_a*side*F_mu_by_psi_dot*F_tau_by_F_mu - arm*F_mu_by_psi_dot/N1; }
        phi theta_motor_dot {
            governor_motor => -c_motor/N1;
            dc_motor => -Ts_motor/(N1*n0_motor);
            induction_motor => T_induction_motor_by_theta_motor_dot/N1;
            traction_motor => T_traction_motor_by_theta_motor_dot/N1;
            fan_motor => T_fan_motor_by_theta_motor_dot/N1;
        }
        phi theta_load_dot {
            governor_load => c_load/N2;
            dc_load => Ts_load/(N2*n0_load);
            induction_load => -T_induction_load_by_theta_load_dot/N2;
            traction_load => -T_traction_load_by_theta_load_dot/N2;
            fan_load => -T_fan_load_by_theta_load_dot/N2;
        }
    }
    cell {
        stiffness {
            over over {
                _ => 2.0*k*touch;
                backlash => 2.0*k*clip*touch;
            }
        }
        damping {
            over over { damping => 2.0*C*damp; }
            theta_motor theta_motor {
                governor_motor => c_motor;
                dc_motor => Ts_motor/n0_motor;
            }
            theta_load theta_load {
                governor_load => c_load;
                dc_load => Ts_load/n0_load;
            }
        }
        load {
            theta {
                governor_motor => c_motor*n_motor/N1;
                dc_motor => Ts_motor/N1;
                governor_load => c_load*n_load/N2;
                dc_load => Ts_load/N2;
            }
            phi {
                torques => 2.0*T0;
                governor_motor => c_motor*n_motor/N1;
                dc_motor => Ts_motor/N1;
                governor_load => -c_load*n_load/N2;
                dc_load => -Ts_load/N2;
            }
            over {
                _ => 2.0*(k*touch*edge + k*touch*e);
                backlash => 2.0*(k*clip*touch*edge + k*clip*touch*e);
            }
        }
    }
    nonlinear_with {
        sliding_friction "-side*F_tau in the torque `slide`";
        sliding_friction "-arm*F_mu in the torque `roll`";
        induction_motor "T_induction_motor in the torque `induction_motor`";
        traction_motor "T_traction_motor in the torque `traction_motor`";
        fan_motor "T_fan_motor in the torque `fan_motor`";
        induction_load "T_induction_load in the torque `induction_load`";
        traction_load "T_traction_load in the torque `traction_load`";
        fan_load "T_fan_load in the torque `fan_load`";
    }
    jump k {
        compliance { _ => M2/2.0; }
        direction {
            theta { _ => 1.0; }
            phi { _ => M1/M2; }
        }
        step { _ => dk*touch*over.powi(2); }
    }
    jump e {
        compliance { _ => M2/2.0; }
        direction {
            theta { _ => 1.0; }
            phi { _ => M1/M2; }
        }
        step { _ => k*de.powi(2)*touch - 2.0*k*de*touch*over; }
    }
    jump side { step {} }
    jump arm { step {} }
    outputs {
        contact_loss "1" with backlash, "1 while no force passes the mesh in phi, else 0: its mean is the share of time without contact" {
            _ => 1.0 - touch*(1.0 + clip*(1.0 - clip)/2.0);
        }
        power_drive "W" with torques, "power of the torque T0 N1 on the driving gear: positive if it drives" { _ => drive_power; }
        power_load "W" with torques, "power of the torque -T0 N2 on the driven gear: positive if it drives" { _ => load_power; }
        dte "rad", "dynamic transmission error as a rotation of the driving gear, theta1 - N2/N1 theta2" { _ => 2.0*phi/N1; }
        mesh_torque "N*m", "torque of the mesh on the driving gear, damper included" {
            _ => N1*k*touch*over;
            backlash => N1*k*clip*touch*over;
            damping => C*N1*damp*over_dot;
        }
        mesh_power "W", "power that the driving gear gives to the mesh: torque times its speed" {
            _ => mesh_torque*(phi_dot/N1 + theta_dot/N1);
        }
        mesh_deflection "rad", "deflection of the mesh as a rotation of the driving gear, backlash not taken off" { _ => 2.0*(phi - e)/N1; }
        mesh_loss "W", "power that the damper of the mesh takes" {
            backlash => 2.0*k*clip*touch*over*over_dot;
            damping => 2.0*C*damp*over_dot.powi(2);
        }
        rotor_speed_1 "rad/s", "rotational speed of the driving gear" { _ => phi_dot/N1 + theta_dot/N1; }
        rotor_speed_2 "rad/s", "rotational speed of the driven gear" { _ => theta_dot/N2 - phi_dot/N2; }
        power_slide "W" with sliding_friction,
            "power of the friction of the mesh, through the sliding of the flanks at the pitch point: positive if it drives" {
            _ => slide_power;
        }
        power_roll "W" with sliding_friction, "power of the friction of the mesh, through the rolling of the gears: positive if it drives" {
            _ => roll_power;
        }
        braking_governor_motor "W" with governor_motor,
            "power that the motor takes back: the part of its torque that is proportional to the speed, times the speed" {
            _ => c_motor*theta_motor_dot.powi(2);
        }
        power_governor_motor "W" with governor_motor,
            "power of the torque c n of the governor of the driving gear; its part -c omega is in D: positive if it drives" {
            _ => governor_motor_power;
        }
        net_power_governor_motor "W" with governor_motor,
            "power that the motor gives: its whole torque times its speed, negative if it brakes" {
            _ => governor_motor_power - braking_governor_motor;
        }
        braking_dc_motor "W" with dc_motor,
            "power that the motor takes back: the part of its torque that is proportional to the speed, times the speed" {
            _ => Ts_motor*theta_motor_dot.powi(2)/n0_motor;
        }
        power_dc_motor "W" with dc_motor,
            "power of the torque Ts of the DC motor of the driving gear; its part -Ts omega/n0 is in D: positive if it drives" {
            _ => dc_motor_power;
        }
        net_power_dc_motor "W" with dc_motor, "power that the motor gives: its whole torque times its speed, negative if it brakes" {
            _ => dc_motor_power - braking_dc_motor;
        }
        power_induction_motor "W" with induction_motor,
            "power of the torque of the induction motor of the driving gear: positive if it drives" {
            _ => induction_motor_power;
        }
        power_traction_motor "W" with traction_motor,
            "power of the torque of the traction motor of the driving gear: positive if it drives" {
            _ => traction_motor_power;
        }
        power_fan_motor "W" with fan_motor,
            "power of the torque of the fan of the driving gear, against the rotation: positive if it drives" {
            _ => fan_motor_power;
        }
        braking_governor_load "W" with governor_load,
            "power that the motor takes back: the part of its torque that is proportional to the speed, times the speed" {
            _ => c_load*theta_load_dot.powi(2);
        }
        power_governor_load "W" with governor_load,
            "power of the torque c n of the governor of the driven gear; its part -c omega is in D: positive if it drives" {
            _ => governor_load_power;
        }
        net_power_governor_load "W" with governor_load,
            "power that the motor gives: its whole torque times its speed, negative if it brakes" {
            _ => governor_load_power - braking_governor_load;
        }
        braking_dc_load "W" with dc_load,
            "power that the motor takes back: the part of its torque that is proportional to the speed, times the speed" {
            _ => Ts_load*theta_load_dot.powi(2)/n0_load;
        }
        power_dc_load "W" with dc_load,
            "power of the torque Ts of the DC motor of the driven gear; its part -Ts omega/n0 is in D: positive if it drives" {
            _ => dc_load_power;
        }
        net_power_dc_load "W" with dc_load, "power that the motor gives: its whole torque times its speed, negative if it brakes" {
            _ => dc_load_power - braking_dc_load;
        }
        power_induction_load "W" with induction_load,
            "power of the torque of the induction motor of the driven gear: positive if it drives" {
            _ => induction_load_power;
        }
        power_traction_load "W" with traction_load, "power of the torque of the traction motor of the driven gear: positive if it drives" {
            _ => traction_load_power;
        }
        power_fan_load "W" with fan_load, "power of the torque of the fan of the driven gear, against the rotation: positive if it drives" {
            _ => fan_load_power;
        }
    }

    text "text/gear_pair.txt";
    latex "latex/gear_pair.tex";
}

// Proved of these equations, symbolically:
//
// - d/dt (q'.dT/dq' - T + V) = Q.q' - q'.dD/dq' along the motion, for every value and slope of every law, with any set of the additive
//   effects; q'.dD/dq' includes the power that switches take
// - M is symmetric
// - T = q'.M q'/2, with M as written
// - M is positive definite: every leading minor is a sum of products of positive quantities
// - M M⁻¹ = 1, and M q'' = F, for M⁻¹ and the accelerations as written
// - at a step of k, e: T+ - T- = (v+² - v²)/(2 G) for any v+, where M d = n/G; V+ - V- = dV as written; so T + V is unchanged in
//   transmission (v+² = v² - 2 G dV) and in reflection (v+ = -v, dV = 0)
// - V is the same on both sides of a step of side, arm: no impulse there
// - V is the same on both sides of the exits of over: no impulse there
// - the force of the switch over takes energy or none: f over_dot >= 0 in every mode, from the guards that hold in it; of a damper that is
//   clipped to f = c F, where F = dV/dover and c = 1 or -1, since F over >= 0, over_dot dD/dover_dot >= 0 and c over dD/dover_dot >= F over
// - V is the same on both sides of the exits of psi: no impulse there
// - every damper takes energy or none: each term of D has a power q'.dD/dq' that is never negative
// - the friction `roll` takes energy or none: its power is never positive
// - the friction `slide` is the force of `roll` times at most 1, along its sign or against it
// - the friction `slide` takes with `roll` energy or none where psi_dot and arm psi_dot + side tau_dot have one sign, on the coast flank
//   with -side: where flanks slide as rolling makes them
// - the friction `slide` takes with `roll` energy or none in every mode of psi, in scenes with flank_stiction: from the guards that hold in
//   the mode
// - every deflection equals the linear form by which the equations differentiate it
// - without the jump terms the balance fails: energy is created at the rate dk*touch*over^2*theta_dot - 2*k*de*touch*over*theta_dot
//
// Operations, all effects present:
//
// | output | sums | products, quotients | functions, roots |
// | --- | --- | --- | --- |
// | constants (once a scene) | 2 | 18 | 3 |
// | named forces | 37 | 106 | 12 |
// | force | 11 | 73 | 0 |
// | acceleration | 44 | 278 | 0 |
// | energy steps, all laws | 1 | 10 | 0 |
