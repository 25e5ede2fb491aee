//! Equations of motion of `crank_drive`: a gear pair that turns a slider-crank.
//!
//! Derived from the energies in `models/src/crank_drive.rs` by `cargo xtask derive crank_drive`.
//! Do not edit: change the energies and derive again.
//! For reading: `text/crank_drive.txt`, `latex/crank_drive.tex`. What is proved: at the end.

use gearsim::equations;

equations! {
    model crank_drive "a gear pair that turns a slider-crank";
    source "gears as Oh, Grosh & Barber (2005); slider-crank of textbooks, e.g. Shigley & Uicker, Ch. 14";

    coordinates {
        theta "rad" start 0.0, "mean rotation of gears 1 and 2; one pitch is 2 pi";
        s "m" start static, "motion of gear 1 relative to gear 2 along the line of action";
    }
    parameters {
        N1 "1" teeth required, open 0.0 to inf, "number of teeth of gear 1";
        N2 "1" teeth required, open 0.0 to inf, "number of teeth of gear 2";
        r1 "m" base_radius required, open 0.0 to inf, "base radius of gear 1";
        I1 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the driving gear";
        I2 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the driven gear with the crank";
        r_p "m" required, open 0.0 to inf, "radius of the crank of the piston";
        l_p "m" required, open 0.0 to inf above r_p, "length of the connecting rod of the piston, longer than the radius of the crank";
        m_p "kg" required, open 0.0 to inf, "moving mass of the piston, with a part of its rod";
        g_p "m/s^2" default 9.81 with gravity, open -inf to inf,
            "gravity along the path of the piston, towards the crank; negative if the piston is below it";
        alpha "rad" pressure_angle default 0.3490658503988659, open 0.0 to inf, "working pressure angle, for friction";
        b12 "m" required with backlash_12, open 0.0 to inf, "backlash of the mesh: no contact within b/2 to either side";
        mu12 "1" required with sliding_friction_12, from 0.0 to inf, "coefficient of friction of the mesh";
        w_mix12 "rad/s" default 0.1 with sliding_friction_12, open 0.0 to inf,
            "rolling speed omega1 + omega2 of the mesh below which friction decreases to zero (mixed film)";
        mu_rise12 "1" default 0.0 with flank_stiction_12, from 0.0 to inf,
            "excess of the static coefficient of friction of the mesh over that of sliding, relative to that";
        T_motor "N*m" required with torques, open -inf to inf, "driving torque of the driving gear";
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
        T_load "N*m" required with torques, open -inf to inf, "load torque of the driven gear, against its rotation";
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
        F_p "N" default 0.0 with torques, open -inf to inf, "force on the piston, towards the crank";
        alpha_M "1/s" default 0.0, from 0.0 to inf, "damping in proportion to inertia";
        beta_K "s" default 0.0, from 0.0 to inf, "damping in proportion to stiffness";
    }
    laws {
        k12 "N/m" phase theta period 6.283185307179586, "stiffness of the mesh along the line of action";
        e12 "m" phase theta period 6.283185307179586 with transmission_error_12, "transmission error of the mesh along the line of action";
        side12 "1" phase theta period 6.283185307179586 with sliding_friction_12 as side,
            "share of the force of the mesh on tooth pairs beyond the pitch point, minus that on pairs before it";
        arm12 "m" phase theta period 6.283185307179586 with sliding_friction_12 as arm,
            "mean distance of the force of the mesh from the pitch point along the line of action";
    }
    motions { speed "rad/s" { theta_dot = N1; }, "rotational speed of the driving gear"; }
    effects {
        gravity "weight of bodies whose height varies";
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
        per_wb_motor = Tp_motor/Pp_motor;
        per_wb_load = Tp_load/Pp_load;
    }
    deflections {
        crank_p = theta/N2 - s/(2.0*h*N2);
        over12 = s - edge12 - e12;
        tau12 = tan_a*s;
        psi12 = s/(2.0*h*N1) - s/(2.0*h*N2) + theta/N1 + theta/N2;
        theta_motor = s/(2.0*h*N1) + theta/N1;
        theta_load = theta/N2 - s/(2.0*h*N2);
    }
    functions {
        x_p = (l_p.powi(2) - r_p.powi(2)*crank_p.sin().powi(2)).sqrt() + r_p*crank_p.cos();
        dx_p = -r_p*crank_p.sin() - r_p.powi(2)*crank_p.cos()*crank_p.sin()/(l_p.powi(2) - r_p.powi(2)*crank_p.sin().powi(2)).sqrt();
        ddx_p = r_p.powi(2)*crank_p.sin().powi(2)/(l_p.powi(2) - r_p.powi(2)*crank_p.sin().powi(2)).sqrt() - r_p*crank_p.cos()
            - r_p.powi(2)*crank_p.cos().powi(2)/(l_p.powi(2) - r_p.powi(2)*crank_p.sin().powi(2)).sqrt()
            - r_p.powi(4)*crank_p.cos().powi(2)*crank_p.sin().powi(2)/(l_p.powi(2) - r_p.powi(2)*crank_p.sin().powi(2)).powf(3.0/2.0);
        dddx_p = r_p*crank_p.sin() + 4.0*r_p.powi(2)*crank_p.cos()*crank_p.sin()/(l_p.powi(2) - r_p.powi(2)*crank_p.sin().powi(2)).sqrt()
            - 3.0*r_p.powi(4)*crank_p.cos().powi(3)*crank_p.sin()/(l_p.powi(2) - r_p.powi(2)*crank_p.sin().powi(2)).powf(3.0/2.0)
            + 3.0*r_p.powi(4)*crank_p.sin().powi(3)*crank_p.cos()/(l_p.powi(2) - r_p.powi(2)*crank_p.sin().powi(2)).powf(3.0/2.0)
            - 3.0*r_p.powi(6)*crank_p.cos().powi(3)*crank_p.sin().powi(3)/(l_p.powi(2) - r_p.powi(2)*crank_p.sin().powi(2)).powf(5.0/2.0);
    }
    forces {
        F_mu12 {
            sliding_friction_12 => mu12*k12*touch12*psi12_dot*(tiny12.powi(2) + over12.powi(2)).sqrt()
                /(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt();
            flank_stiction_12 => mu12*k12*slide_dir12*touch12*(tiny12.powi(2) + over12.powi(2)).sqrt()
                - mu12*k12*touch12*psi12_dot*(tiny12.powi(2) + over12.powi(2)).sqrt()/(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt();
        }
        F_tau12 { sliding_friction_12 => F_mu12*over12/(tiny12.powi(2) + over12.powi(2)).sqrt(); }
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
                + m_p*dx_p.powi(2)*(theta_dot/N2 - s_dot/(2.0*h*N2)).powi(2))/2.0;
        }
        potential {
            _ => k12*touch12*over12.powi(2)/2.0;
            gravity => g_p*m_p*x_p;
        }
        dissipation {
            governor_motor => c_motor*theta_motor_dot.powi(2)/2.0;
            dc_motor => Ts_motor*theta_motor_dot.powi(2)/(2.0*n0_motor);
            governor_load => c_load*theta_load_dot.powi(2)/2.0;
            dc_load => Ts_load*theta_load_dot.powi(2)/(2.0*n0_load);
            damping => (I1*alpha_M*(s_dot/(2.0*h*N1) + theta_dot/N1).powi(2) + I2*alpha_M*(theta_dot/N2 - s_dot/(2.0*h*N2)).powi(2)
                + beta_K*k12_mid*damp12*over12_dot.powi(2))/2.0;
        }
    }
    torques {
        slide12 "friction of the mesh, through the sliding of the flanks at the pitch point" {}
        power { sliding_friction_12 => -side12*F_tau12*tau12_dot; }
        roll12 "friction of the mesh, through the rolling of the gears" {}
        power { sliding_friction_12 => -arm12*F_mu12*psi12_dot; }
        motor "driving torque of the driving gear" { torques => T_motor*(s/(2.0*h*N1) + theta/N1); }
        governor_motor "torque c n of the governor of the driving gear; its part -c omega is in D" {
            governor_motor => c_motor*n_motor*(s/(2.0*h*N1) + theta/N1);
        }
        dc_motor "torque Ts of the DC motor of the driving gear; its part -Ts omega/n0 is in D" {
            dc_motor => Ts_motor*(s/(2.0*h*N1) + theta/N1);
        }
        induction_motor "torque of the induction motor of the driving gear" {}
        power { induction_motor => T_induction_motor*(s_dot/(2.0*h*N1) + theta_dot/N1); }
        traction_motor "torque of the traction motor of the driving gear" {}
        power { traction_motor => T_traction_motor*(s_dot/(2.0*h*N1) + theta_dot/N1); }
        fan_motor "torque of the fan of the driving gear, against the rotation" {}
        power { fan_motor => T_fan_motor*(s_dot/(2.0*h*N1) + theta_dot/N1); }
        load "load torque of the driven gear, against its rotation" { torques => T_load*(s/(2.0*h*N2) - theta/N2); }
        governor_load "torque c n of the governor of the driven gear; its part -c omega is in D" {
            governor_load => c_load*n_load*(theta/N2 - s/(2.0*h*N2));
        }
        dc_load "torque Ts of the DC motor of the driven gear; its part -Ts omega/n0 is in D" {
            dc_load => Ts_load*(theta/N2 - s/(2.0*h*N2));
        }
        induction_load "torque of the induction motor of the driven gear" {}
        power { induction_load => T_induction_load*(theta_dot/N2 - s_dot/(2.0*h*N2)); }
        traction_load "torque of the traction motor of the driven gear" {}
        power { traction_load => T_traction_load*(theta_dot/N2 - s_dot/(2.0*h*N2)); }
        fan_load "torque of the fan of the driven gear, against the rotation" {}
        power { fan_load => T_fan_load*(theta_dot/N2 - s_dot/(2.0*h*N2)); }
        piston "force on the piston, towards the crank" {}
        power { torques => -F_p*dx_p*(theta_dot/N2 - s_dot/(2.0*h*N2)); }
    }
    work {
        theta {
            torques => T_motor/N1 - T_load/N2;
            governor_motor => c_motor*n_motor/N1;
            dc_motor => Ts_motor/N1;
            governor_load => c_load*n_load/N2;
            dc_load => Ts_load/N2;
        }
        s {
            torques => (T_motor/(h*N1) + T_load/(h*N2))/2.0;
            governor_motor => c_motor*n_motor/(2.0*h*N1);
            dc_motor => Ts_motor/(2.0*h*N1);
            governor_load => -c_load*n_load/(2.0*h*N2);
            dc_load => -Ts_load/(2.0*h*N2);
        }
    }
    mass {
        theta theta { _ => I1/N1.powi(2) + I2/N2.powi(2) + m_p*dx_p.powi(2)/N2.powi(2); }
        theta s { _ => (I1/(h*N1.powi(2)) - I2/(h*N2.powi(2)) - m_p*dx_p.powi(2)/(h*N2.powi(2)))/2.0; }
        s s { _ => (I1/(h.powi(2)*N1.powi(2)) + I2/(h.powi(2)*N2.powi(2)) + m_p*dx_p.powi(2)/(h.powi(2)*N2.powi(2)))/4.0; }
    }
    mobility {
        theta theta {
            _ => ((I1/(h.powi(2)*N1.powi(2)) + I2/(h.powi(2)*N2.powi(2)) + m_p*dx_p.powi(2)/(h.powi(2)*N2.powi(2)))/4.0)
                /(I1*I2/(h.powi(2)*N1.powi(2)*N2.powi(2)) + I1*m_p*dx_p.powi(2)/(h.powi(2)*N1.powi(2)*N2.powi(2)));
        }
        theta s {
            _ => -((I1/(h*N1.powi(2)) - I2/(h*N2.powi(2)) - m_p*dx_p.powi(2)/(h*N2.powi(2)))/2.0)
                /(I1*I2/(h.powi(2)*N1.powi(2)*N2.powi(2)) + I1*m_p*dx_p.powi(2)/(h.powi(2)*N1.powi(2)*N2.powi(2)));
        }
        s s {
            _ => (I1/N1.powi(2) + I2/N2.powi(2) + m_p*dx_p.powi(2)/N2.powi(2))
                /(I1*I2/(h.powi(2)*N1.powi(2)*N2.powi(2)) + I1*m_p*dx_p.powi(2)/(h.powi(2)*N1.powi(2)*N2.powi(2)));
        }
    }
    inertia {
        theta theta { _ => 2.0*m_p*ddx_p*dx_p*theta_ddot/N2.powi(3) - m_p*ddx_p*dx_p*s_ddot/(h*N2.powi(3)); }
        theta s { _ => m_p*ddx_p*dx_p*s_ddot/(2.0*h.powi(2)*N2.powi(3)) - m_p*ddx_p*dx_p*theta_ddot/(h*N2.powi(3)); }
        s theta { _ => m_p*ddx_p*dx_p*s_ddot/(2.0*h.powi(2)*N2.powi(3)) - m_p*ddx_p*dx_p*theta_ddot/(h*N2.powi(3)); }
        s s { _ => m_p*ddx_p*dx_p*theta_ddot/(2.0*h.powi(2)*N2.powi(3)) - m_p*ddx_p*dx_p*s_ddot/(4.0*h.powi(3)*N2.powi(3)); }
    }
    force {
        theta {
            _ => m_p*ddx_p*dx_p*s_dot*theta_dot/(h*N2.powi(3)) - m_p*ddx_p*dx_p*s_dot.powi(2)/(4.0*h.powi(2)*N2.powi(3))
                - m_p*ddx_p*dx_p*theta_dot.powi(2)/N2.powi(3);
            gravity => -g_p*m_p*dx_p/N2;
            transmission_error_12_and_jump_terms => k12*de12*touch12*over12;
            sliding_friction_12 => -arm12*F_mu12/N1 - arm12*F_mu12/N2;
            torques => T_motor/N1 - F_p*dx_p/N2 - T_load/N2;
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
            damping => I2*alpha_M*s_dot/(2.0*h*N2.powi(2)) - I1*alpha_M*theta_dot/N1.powi(2) - I2*alpha_M*theta_dot/N2.powi(2)
                - I1*alpha_M*s_dot/(2.0*h*N1.powi(2));
            jump_terms => -dk12*touch12*over12.powi(2)/2.0;
        }
        s {
            _ => m_p*ddx_p*dx_p*s_dot.powi(2)/(8.0*h.powi(3)*N2.powi(3)) - k12*touch12*over12
                - m_p*ddx_p*dx_p*s_dot*theta_dot/(2.0*h.powi(2)*N2.powi(3)) + m_p*ddx_p*dx_p*theta_dot.powi(2)/(2.0*h*N2.powi(3));
            gravity => g_p*m_p*dx_p/(2.0*h*N2);
            backlash_12 => -k12*clip12*touch12*over12;
            sliding_friction_12 => arm12*F_mu12/(2.0*h*N2) - tan_a*side12*F_tau12 - arm12*F_mu12/(2.0*h*N1);
            torques => (F_p*dx_p/(h*N2) + T_motor/(h*N1) + T_load/(h*N2))/2.0;
            governor_motor => (c_motor*n_motor/(h*N1) - c_motor*theta_motor_dot/(h*N1))/2.0;
            dc_motor => (Ts_motor/(h*N1) - Ts_motor*theta_motor_dot/(h*N1*n0_motor))/2.0;
            induction_motor => T_induction_motor/(2.0*h*N1);
            traction_motor => T_traction_motor/(2.0*h*N1);
            fan_motor => T_fan_motor/(2.0*h*N1);
            governor_load => (c_load*theta_load_dot/(h*N2) - c_load*n_load/(h*N2))/2.0;
            dc_load => (Ts_load*theta_load_dot/(h*N2*n0_load) - Ts_load/(h*N2))/2.0;
            induction_load => -T_induction_load/(2.0*h*N2);
            traction_load => -T_traction_load/(2.0*h*N2);
            fan_load => -T_fan_load/(2.0*h*N2);
            damping => I2*alpha_M*theta_dot/(2.0*h*N2.powi(2)) - beta_K*k12_mid*damp12*over12_dot
                - I1*alpha_M*s_dot/(4.0*h.powi(2)*N1.powi(2)) - I2*alpha_M*s_dot/(4.0*h.powi(2)*N2.powi(2))
                - I1*alpha_M*theta_dot/(2.0*h*N1.powi(2));
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
        theta theta_dot {
            _ => m_p*ddx_p*dx_p*s_dot/(h*N2.powi(3)) - 2.0*m_p*ddx_p*dx_p*theta_dot/N2.powi(3);
            damping => -I1*alpha_M/N1.powi(2) - I2*alpha_M/N2.powi(2);
        }
        theta s_dot {
            _ => m_p*ddx_p*dx_p*theta_dot/(h*N2.powi(3)) - m_p*ddx_p*dx_p*s_dot/(2.0*h.powi(2)*N2.powi(3));
            damping => (I2*alpha_M/(h*N2.powi(2)) - I1*alpha_M/(h*N1.powi(2)))/2.0;
        }
        theta crank_p {
            _ => m_p*dddx_p*dx_p*s_dot*theta_dot/(h*N2.powi(3)) - m_p*dddx_p*dx_p*s_dot.powi(2)/(4.0*h.powi(2)*N2.powi(3))
                - m_p*ddx_p.powi(2)*s_dot.powi(2)/(4.0*h.powi(2)*N2.powi(3)) + m_p*ddx_p.powi(2)*s_dot*theta_dot/(h*N2.powi(3))
                - m_p*dddx_p*dx_p*theta_dot.powi(2)/N2.powi(3) - m_p*ddx_p.powi(2)*theta_dot.powi(2)/N2.powi(3);
            gravity => -g_p*m_p*ddx_p/N2;
            torques => -F_p*ddx_p/N2;
        }
        theta over12 {
            transmission_error_12_and_jump_terms => k12*de12*touch12;
            sliding_friction_12 => -arm12*F_mu12_by_over12/N1 - arm12*F_mu12_by_over12/N2;
            jump_terms => -dk12*touch12*over12;
        }
        theta psi12_dot { sliding_friction_12 => -arm12*F_mu12_by_psi12_dot/N1 - arm12*F_mu12_by_psi12_dot/N2; }
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
        s theta_dot {
            _ => m_p*ddx_p*dx_p*theta_dot/(h*N2.powi(3)) - m_p*ddx_p*dx_p*s_dot/(2.0*h.powi(2)*N2.powi(3));
            damping => (I2*alpha_M/(h*N2.powi(2)) - I1*alpha_M/(h*N1.powi(2)))/2.0;
        }
        s s_dot {
            _ => m_p*ddx_p*dx_p*s_dot/(4.0*h.powi(3)*N2.powi(3)) - m_p*ddx_p*dx_p*theta_dot/(2.0*h.powi(2)*N2.powi(3));
            damping => (-I1*alpha_M/(h.powi(2)*N1.powi(2)) - I2*alpha_M/(h.powi(2)*N2.powi(2)))/4.0;
        }
        s crank_p {
            _ => m_p*dddx_p*dx_p*s_dot.powi(2)/(8.0*h.powi(3)*N2.powi(3)) + m_p*ddx_p.powi(2)*s_dot.powi(2)/(8.0*h.powi(3)*N2.powi(3))
                - m_p*dddx_p*dx_p*s_dot*theta_dot/(2.0*h.powi(2)*N2.powi(3))
                - m_p*ddx_p.powi(2)*s_dot*theta_dot/(2.0*h.powi(2)*N2.powi(3)) + m_p*dddx_p*dx_p*theta_dot.powi(2)/(2.0*h*N2.powi(3))
                + m_p*ddx_p.powi(2)*theta_dot.powi(2)/(2.0*h*N2.powi(3));
            gravity => g_p*m_p*ddx_p/(2.0*h*N2);
            torques => F_p*ddx_p/(2.0*h*N2);
        }
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
        s theta_motor_dot {
            governor_motor => -c_motor/(2.0*h*N1);
            dc_motor => -Ts_motor/(2.0*h*N1*n0_motor);
            induction_motor => T_induction_motor_by_theta_motor_dot/(2.0*h*N1);
            traction_motor => T_traction_motor_by_theta_motor_dot/(2.0*h*N1);
            fan_motor => T_fan_motor_by_theta_motor_dot/(2.0*h*N1);
        }
        s theta_load_dot {
            governor_load => c_load/(2.0*h*N2);
            dc_load => Ts_load/(2.0*h*N2*n0_load);
            induction_load => -T_induction_load_by_theta_load_dot/(2.0*h*N2);
            traction_load => -T_traction_load_by_theta_load_dot/(2.0*h*N2);
            fan_load => -T_fan_load_by_theta_load_dot/(2.0*h*N2);
        }
    }
    cell {
        stiffness {
            over12 over12 {
                _ => k12*touch12;
                backlash_12 => k12*clip12*touch12;
            }
        }
        damping {
            theta theta { damping => I1*alpha_M/N1.powi(2) + I2*alpha_M/N2.powi(2); }
            theta s { damping => (I1*alpha_M/(h*N1.powi(2)) - I2*alpha_M/(h*N2.powi(2)))/2.0; }
            s s { damping => (I1*alpha_M/(h.powi(2)*N1.powi(2)) + I2*alpha_M/(h.powi(2)*N2.powi(2)))/4.0; }
            over12 over12 { damping => beta_K*k12_mid*damp12; }
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
                torques => T_motor/N1 - T_load/N2;
                governor_motor => c_motor*n_motor/N1;
                dc_motor => Ts_motor/N1;
                governor_load => c_load*n_load/N2;
                dc_load => Ts_load/N2;
            }
            s {
                torques => (T_motor/(h*N1) + T_load/(h*N2))/2.0;
                governor_motor => c_motor*n_motor/(2.0*h*N1);
                dc_motor => Ts_motor/(2.0*h*N1);
                governor_load => -c_load*n_load/(2.0*h*N2);
                dc_load => -Ts_load/(2.0*h*N2);
            }
            over12 {
                _ => k12*touch12*edge12 + k12*touch12*e12;
                backlash_12 => k12*clip12*touch12*edge12 + k12*clip12*touch12*e12;
            }
        }
    }
    nonlinear "M(theta, s) in the kinetic energy";
    nonlinear_with {
        gravity "g_p*m_p*x_p in the potential energy";
        sliding_friction_12 "-side12*F_tau12 in the torque `slide12`";
        sliding_friction_12 "-arm12*F_mu12 in the torque `roll12`";
        induction_motor "T_induction_motor in the torque `induction_motor`";
        traction_motor "T_traction_motor in the torque `traction_motor`";
        fan_motor "T_fan_motor in the torque `fan_motor`";
        induction_load "T_induction_load in the torque `induction_load`";
        traction_load "T_traction_load in the torque `traction_load`";
        fan_load "T_fan_load in the torque `fan_load`";
        torques "F_p in the torque `piston`, whose displacement is not linear";
    }
    jump k12 { step { _ => dk12*touch12*over12.powi(2)/2.0; } }
    jump e12 { step { _ => k12*de12.powi(2)*touch12/2.0 - k12*de12*touch12*over12; } }
    jump side12 { step {} }
    jump arm12 { step {} }
    outputs {
        rotor_speed_1 "rad/s", "rotational speed of the driving gear" { _ => s_dot/(2.0*h*N1) + theta_dot/N1; }
        rotor_speed_2 "rad/s", "rotational speed of the driven gear with the crank" { _ => theta_dot/N2 - s_dot/(2.0*h*N2); }
        slider_place_p "m", "distance of the piston from the crank's axis" { _ => x_p; }
        slider_speed_p "m/s", "speed of the piston, away from the crank's axis" { _ => dx_p*(theta_dot/N2 - s_dot/(2.0*h*N2)); }
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
        power_motor "W" with torques, "power of the driving torque of the driving gear: positive if it drives" { _ => motor_power; }
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
        power_load "W" with torques, "power of the load torque of the driven gear, against its rotation: positive if it drives" {
            _ => load_power;
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
        power_piston "W" with torques, "power of the force on the piston, towards the crank: positive if it drives" { _ => piston_power; }
        inertia_damping_loss "W" with damping, "power that the damping in proportion to inertia takes" {
            _ => 2.0*alpha_M*((I1*(s_dot/(2.0*h*N1) + theta_dot/N1).powi(2) + I2*(theta_dot/N2 - s_dot/(2.0*h*N2)).powi(2))/2.0);
        }
    }

    text "text/crank_drive.txt";
    latex "latex/crank_drive.tex";
}

// Proved of these equations, symbolically:
//
// - d/dt (q'.dT/dq' - T + V) = Q.q' - q'.dD/dq' along the motion, for every value and slope of every law, with any set of the additive
//   effects; q'.dD/dq' includes the power that switches take
// - M is symmetric
// - T = q'.M q'/2, with M as written
// - M is positive definite: T is a sum of squares that vanish together only at rest
// - d/dt dT/dq' - dT/dq = M q'' + c, where F has -c_i = -sum (dM_ij/dq_k + dM_ik/dq_j - dM_jk/dq_i)/2 q'_j q'_k
// - M M⁻¹ = 1 for M⁻¹ as written, at every q
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
// | constants (once a scene) | 0 | 4 | 2 |
// | named forces | 37 | 106 | 12 |
// | force | 27 | 224 | 0 |
// | energy steps, all laws | 1 | 11 | 0 |
