//! Equations of motion of `belt_drive`: a belt drive with a sprung tensioner.
//!
//! Derived from the energies in `models/src/belt_drive.rs` by `cargo xtask derive belt_drive`.
//! Do not edit: change the energies and derive again.
//! For reading: `text/belt_drive.txt`, `latex/belt_drive.tex`. What is proved: at the end.

use gearsim::equations;

equations! {
    model belt_drive "a belt drive with a sprung tensioner";
    source "rotational model of Beikmann, Perkins & Ulsoy (1996), J. Vib. Acoust. 118(3), with one accessory";

    coordinates {
        theta "rad" start 0.0, "rotation of the crankshaft";
        s "m" start static, "stretch of the pulling span, relative to its tension at rest";
        psi "rad" start static, "rotation of the tensioner arm, relative to its position at rest";
    }
    parameters {
        r1 "m" required, open 0.0 to inf, "radius of the crankshaft pulley";
        r2 "m" required, open 0.0 to inf, "radius of the accessory pulley";
        a "m" required, open 0.0 to inf, "length that the slack span gains per radian of the arm";
        I1 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the crankshaft";
        I2 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the accessory";
        I_t "kg*m^2" required, open 0.0 to inf, "moment of inertia of the tensioner arm";
        k_p "N/m" required, open 0.0 to inf, "stiffness of the pulling span";
        k_s "N/m" required, open 0.0 to inf, "stiffness of the slack span";
        k_t "N*m/rad" support required, from 0.0 to inf, "torsional stiffness of the spring of the tensioner arm";
        hi_t "rad" required with end_stop_t, open -inf to inf, "place of the upper stop of the tensioner arm";
        lo_t "rad" required with end_stop_t, open -inf to inf, "place of the lower stop of the tensioner arm";
        ks_t "N*m/rad" required with end_stop_t, open 0.0 to inf, "stiffness of the stops of the tensioner arm";
        cs_t "N*m*s/rad" default 0.0 with end_stop_t, from 0.0 to inf, "damping of the stops of the tensioner arm";
        T_crank "N*m" required with torques, open -inf to inf, "driving torque of the crankshaft";
        c_crank "N*m*s/rad" required with governor_crank, open 0.0 to inf,
            "gain of the governor of the crankshaft: torque per difference of set point and speed";
        n_crank "rad/s" required with governor_crank, open -inf to inf, "set point of the speed governor of the crankshaft";
        Ts_crank "N*m" required with dc_crank, open 0.0 to inf, "stall torque of the DC motor of the crankshaft";
        n0_crank "rad/s" required with dc_crank, open 0.0 to inf, "no-load speed of the DC motor of the crankshaft";
        Tb_crank "N*m" required with induction_crank, open 0.0 to inf,
            "breakdown torque of the induction motor of the crankshaft, its largest torque";
        sb_crank "1" required with induction_crank, open 0.0 to inf,
            "slip at which the induction motor of the crankshaft has its breakdown torque";
        ns_crank "rad/s" required with induction_crank, open 0.0 to inf, "synchronous speed of the induction motor of the crankshaft";
        Tp_crank "N*m" required with traction_crank, open 0.0 to inf,
            "peak torque of the traction motor of the crankshaft, up to its base speed";
        Pp_crank "W" required with traction_crank, open 0.0 to inf,
            "peak power of the traction motor of the crankshaft, above its base speed Pp/Tp";
        d_crank "1" default 1.0 with traction_crank, open -inf to inf,
            "demand on the traction motor of the crankshaft: 1 drives with its peak torque or power, -1 brakes with them";
        round_crank "1" default 0.01 with traction_crank, open 0.0 to inf,
            "rounding of the corner of the torque of the traction motor of the crankshaft at its base speed, relative to that";
        cf_crank "N*m*s^2/rad^2" required with fan_crank, from 0.0 to inf,
            "torque of the fan of the crankshaft divided by the square of its speed";
        w0_crank "rad/s" default 0.01 with fan_crank, open 0.0 to inf,
            "speed of the crankshaft below which the torque of its fan is linear instead of quadratic in the speed";
        T_load "N*m" required with torques, open -inf to inf, "load torque of the accessory, against its rotation";
        c_load "N*m*s/rad" required with governor_load, open 0.0 to inf,
            "gain of the governor of the accessory: torque per difference of set point and speed";
        n_load "rad/s" required with governor_load, open -inf to inf, "set point of the speed governor of the accessory";
        Ts_load "N*m" required with dc_load, open 0.0 to inf, "stall torque of the DC motor of the accessory";
        n0_load "rad/s" required with dc_load, open 0.0 to inf, "no-load speed of the DC motor of the accessory";
        Tb_load "N*m" required with induction_load, open 0.0 to inf,
            "breakdown torque of the induction motor of the accessory, its largest torque";
        sb_load "1" required with induction_load, open 0.0 to inf,
            "slip at which the induction motor of the accessory has its breakdown torque";
        ns_load "rad/s" required with induction_load, open 0.0 to inf, "synchronous speed of the induction motor of the accessory";
        Tp_load "N*m" required with traction_load, open 0.0 to inf,
            "peak torque of the traction motor of the accessory, up to its base speed";
        Pp_load "W" required with traction_load, open 0.0 to inf,
            "peak power of the traction motor of the accessory, above its base speed Pp/Tp";
        d_load "1" default 1.0 with traction_load, open -inf to inf,
            "demand on the traction motor of the accessory: 1 drives with its peak torque or power, -1 brakes with them";
        round_load "1" default 0.01 with traction_load, open 0.0 to inf,
            "rounding of the corner of the torque of the traction motor of the accessory at its base speed, relative to that";
        cf_load "N*m*s^2/rad^2" required with fan_load, from 0.0 to inf,
            "torque of the fan of the accessory divided by the square of its speed";
        w0_load "rad/s" default 0.01 with fan_load, open 0.0 to inf,
            "speed of the accessory below which the torque of its fan is linear instead of quadratic in the speed";
        alpha_M "1/s" default 0.0, from 0.0 to inf, "damping in proportion to inertia";
        beta_K "s" default 0.0, from 0.0 to inf, "damping in proportion to stiffness";
    }
    laws {
    }
    motions { speed "rad/s" { theta_dot = 1.0; }, "rotational speed of the crankshaft"; }
    effects {
        end_stop_t of end_stop "end stops: elastic, with a damper that never pulls, beyond an upper and a lower limit of a displacement";
        torques "constant torques of motor and load";
        governor_crank of governor excludes(dc_crank, induction_crank, traction_crank)
            "a motor with a speed governor: its torque is proportional to the set point minus the speed";
        dc_crank of dc excludes(induction_crank, traction_crank)
            "a DC motor at constant voltage: its torque falls linearly from stall to no load";
        induction_crank of induction excludes(traction_crank) "an induction motor, its torque by the formula of Kloss";
        traction_crank of traction "a traction motor: its peak torque up to the base speed, constant power above it, times the demand";
        fan_crank of fan "a fan as load: torque proportional to the square of the speed, against the rotation";
        governor_load of governor excludes(dc_load, induction_load, traction_load)
            "a motor with a speed governor: its torque is proportional to the set point minus the speed";
        dc_load of dc excludes(induction_load, traction_load)
            "a DC motor at constant voltage: its torque falls linearly from stall to no load";
        induction_load of induction excludes(traction_load) "an induction motor, its torque by the formula of Kloss";
        traction_load of traction "a traction motor: its peak torque up to the base speed, constant power above it, times the demand";
        fan_load of fan "a fan as load: torque proportional to the square of the speed, against the rotation";
        damping "Rayleigh damping, C = alpha_M M + beta_K K at the mid stiffness";
    }
    conditions { end_stop_t_and_damping = end_stop_t, damping; }

    constants {
        per_wb_crank = Tp_crank/Pp_crank;
        per_wb_load = Tp_load/Pp_load;
    }
    deflections {
        s_p = s;
        s_s = a*psi - s;
        twist_t = psi;
        past_t = psi - stop_t;
        theta_crank = theta;
        theta_load = r1*theta/r2 - s/r2;
    }
    forces {
        T_induction_crank {
            induction_crank => 2.0*Tb_crank*sb_crank*(1.0 - theta_crank_dot/ns_crank)
                /(sb_crank.powi(2) + (1.0 - theta_crank_dot/ns_crank).powi(2));
        }
        T_traction_crank {
            traction_crank => 2.0*Tp_crank*d_crank
                /((round_crank.powi(2) + (1.0 - per_wb_crank*theta_crank_dot).powi(2)).sqrt()
                + (round_crank.powi(2) + (1.0 + per_wb_crank*theta_crank_dot).powi(2)).sqrt());
        }
        T_fan_crank { fan_crank => -cf_crank*theta_crank_dot*(w0_crank.powi(2) + theta_crank_dot.powi(2)).sqrt(); }
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
        T_induction_crank_by_theta_crank_dot {
            induction_crank => 4.0*Tb_crank*sb_crank*(1.0 - theta_crank_dot/ns_crank).powi(2)
                /(ns_crank*(sb_crank.powi(2) + (1.0 - theta_crank_dot/ns_crank).powi(2)).powi(2))
                - 2.0*Tb_crank*sb_crank/(ns_crank*(sb_crank.powi(2) + (1.0 - theta_crank_dot/ns_crank).powi(2)));
        }
        T_traction_crank_by_theta_crank_dot {
            traction_crank => -2.0*Tp_crank*d_crank
                *(per_wb_crank*(1.0 + per_wb_crank*theta_crank_dot)
                /(round_crank.powi(2) + (1.0 + per_wb_crank*theta_crank_dot).powi(2)).sqrt()
                - per_wb_crank*(1.0 - per_wb_crank*theta_crank_dot)
                /(round_crank.powi(2) + (1.0 - per_wb_crank*theta_crank_dot).powi(2)).sqrt())
                /((round_crank.powi(2) + (1.0 - per_wb_crank*theta_crank_dot).powi(2)).sqrt()
                + (round_crank.powi(2) + (1.0 + per_wb_crank*theta_crank_dot).powi(2)).sqrt()).powi(2);
        }
        T_fan_crank_by_theta_crank_dot {
            fan_crank => -cf_crank*theta_crank_dot.powi(2)/(w0_crank.powi(2) + theta_crank_dot.powi(2)).sqrt()
                - cf_crank*(w0_crank.powi(2) + theta_crank_dot.powi(2)).sqrt();
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
        past_t "rad" (at_stop_t 1.0, stop_t 0.0, stop_damp_t 1.0, stop_clip_t 0.0) with end_stop_t, "end stops of the tensioner arm" {
            free (0.0, 0.0, 0.0, 0.0) rests {
                until upper {
                    past_t { _ => -1.0; }
                    one { _ => hi_t; }
                }
                until lower {
                    past_t { _ => 1.0; }
                    one { _ => -lo_t; }
                }
            }
            upper (1.0, hi_t, 1.0, 0.0) rests counts "stop met" {
                unless free { past_t { _ => 1.0; } }
                until upper_loose {
                    past_t { end_stop_t => ks_t; }
                    past_t_dot {
                        end_stop_t => cs_t;
                        end_stop_t_and_damping => beta_K*ks_t;
                    }
                }
                until upper_hit {
                    past_t { end_stop_t => ks_t; }
                    past_t_dot {
                        end_stop_t => -cs_t;
                        end_stop_t_and_damping => -beta_K*ks_t;
                    }
                }
            }
            upper_hit (1.0, hi_t, 0.0, 1.0) counts "stop met" {
                unless free { past_t { _ => 1.0; } }
                until upper {
                    past_t { end_stop_t => -ks_t; }
                    past_t_dot {
                        end_stop_t => cs_t;
                        end_stop_t_and_damping => beta_K*ks_t;
                    }
                }
            }
            upper_loose (1.0, hi_t, 0.0, -1.0) counts "stop met" {
                until free { past_t { _ => 1.0; } }
                until upper {
                    past_t { end_stop_t => -ks_t; }
                    past_t_dot {
                        end_stop_t => -cs_t;
                        end_stop_t_and_damping => -beta_K*ks_t;
                    }
                }
            }
            lower (1.0, lo_t, 1.0, 0.0) rests counts "stop met" {
                unless free { past_t { _ => -1.0; } }
                until lower_loose {
                    past_t { end_stop_t => -ks_t; }
                    past_t_dot {
                        end_stop_t => -cs_t;
                        end_stop_t_and_damping => -beta_K*ks_t;
                    }
                }
                until lower_hit {
                    past_t { end_stop_t => -ks_t; }
                    past_t_dot {
                        end_stop_t => cs_t;
                        end_stop_t_and_damping => beta_K*ks_t;
                    }
                }
            }
            lower_hit (1.0, lo_t, 0.0, 1.0) counts "stop met" {
                unless free { past_t { _ => -1.0; } }
                until lower {
                    past_t { end_stop_t => ks_t; }
                    past_t_dot {
                        end_stop_t => -cs_t;
                        end_stop_t_and_damping => -beta_K*ks_t;
                    }
                }
            }
            lower_loose (1.0, lo_t, 0.0, -1.0) counts "stop met" {
                until free { past_t { _ => -1.0; } }
                until lower {
                    past_t { end_stop_t => ks_t; }
                    past_t_dot {
                        end_stop_t => cs_t;
                        end_stop_t_and_damping => beta_K*ks_t;
                    }
                }
            }
            loss { past_t { end_stop_t => ks_t*at_stop_t*stop_clip_t; } }
        }
    }
    energies {
        kinetic { _ => (I1*theta_dot.powi(2) + I2*(r1*theta_dot/r2 - s_dot/r2).powi(2) + I_t*psi_dot.powi(2))/2.0; }
        potential {
            _ => (k_p*s_p.powi(2) + k_s*s_s.powi(2) + k_t*twist_t.powi(2))/2.0;
            end_stop_t => ks_t*at_stop_t*past_t.powi(2)/2.0;
        }
        dissipation {
            end_stop_t => cs_t*stop_damp_t*past_t_dot.powi(2)/2.0;
            end_stop_t_and_damping => beta_K*ks_t*stop_damp_t*past_t_dot.powi(2)/2.0;
            governor_crank => c_crank*theta_crank_dot.powi(2)/2.0;
            dc_crank => Ts_crank*theta_crank_dot.powi(2)/(2.0*n0_crank);
            governor_load => c_load*theta_load_dot.powi(2)/2.0;
            dc_load => Ts_load*theta_load_dot.powi(2)/(2.0*n0_load);
            damping => (I1*alpha_M*theta_dot.powi(2) + I2*alpha_M*(r1*theta_dot/r2 - s_dot/r2).powi(2) + I_t*alpha_M*psi_dot.powi(2)
                + beta_K*k_p*s_p_dot.powi(2) + beta_K*k_s*s_s_dot.powi(2) + beta_K*k_t*twist_t_dot.powi(2))/2.0;
        }
    }
    torques {
        crank "driving torque of the crankshaft" { torques => T_crank*theta; }
        governor_crank "torque c n of the governor of the crankshaft; its part -c omega is in D" {
            governor_crank => c_crank*n_crank*theta;
        }
        dc_crank "torque Ts of the DC motor of the crankshaft; its part -Ts omega/n0 is in D" { dc_crank => Ts_crank*theta; }
        induction_crank "torque of the induction motor of the crankshaft" {}
        power { induction_crank => T_induction_crank*theta_dot; }
        traction_crank "torque of the traction motor of the crankshaft" {}
        power { traction_crank => T_traction_crank*theta_dot; }
        fan_crank "torque of the fan of the crankshaft, against the rotation" {}
        power { fan_crank => T_fan_crank*theta_dot; }
        load "load torque of the accessory, against its rotation" { torques => T_load*(s/r2 - r1*theta/r2); }
        governor_load "torque c n of the governor of the accessory; its part -c omega is in D" {
            governor_load => c_load*n_load*(r1*theta/r2 - s/r2);
        }
        dc_load "torque Ts of the DC motor of the accessory; its part -Ts omega/n0 is in D" { dc_load => Ts_load*(r1*theta/r2 - s/r2); }
        induction_load "torque of the induction motor of the accessory" {}
        power { induction_load => T_induction_load*(r1*theta_dot/r2 - s_dot/r2); }
        traction_load "torque of the traction motor of the accessory" {}
        power { traction_load => T_traction_load*(r1*theta_dot/r2 - s_dot/r2); }
        fan_load "torque of the fan of the accessory, against the rotation" {}
        power { fan_load => T_fan_load*(r1*theta_dot/r2 - s_dot/r2); }
    }
    work {
        theta {
            torques => T_crank - T_load*r1/r2;
            governor_crank => c_crank*n_crank;
            dc_crank => Ts_crank;
            governor_load => c_load*n_load*r1/r2;
            dc_load => Ts_load*r1/r2;
        }
        s {
            torques => T_load/r2;
            governor_load => -c_load*n_load/r2;
            dc_load => -Ts_load/r2;
        }
    }
    mass {
        theta theta { _ => I1 + I2*r1.powi(2)/r2.powi(2); }
        theta s { _ => -I2*r1/r2.powi(2); }
        s s { _ => I2/r2.powi(2); }
        psi psi { _ => I_t; }
    }
    force {
        theta {
            torques => T_crank - T_load*r1/r2;
            governor_crank => c_crank*n_crank - c_crank*theta_crank_dot;
            dc_crank => Ts_crank - Ts_crank*theta_crank_dot/n0_crank;
            induction_crank => T_induction_crank;
            traction_crank => T_traction_crank;
            fan_crank => T_fan_crank;
            governor_load => c_load*n_load*r1/r2 - c_load*r1*theta_load_dot/r2;
            dc_load => Ts_load*r1/r2 - Ts_load*r1*theta_load_dot/(n0_load*r2);
            induction_load => r1*T_induction_load/r2;
            traction_load => r1*T_traction_load/r2;
            fan_load => r1*T_fan_load/r2;
            damping => I2*alpha_M*r1*s_dot/r2.powi(2) - I1*alpha_M*theta_dot - I2*alpha_M*r1.powi(2)*theta_dot/r2.powi(2);
        }
        s {
            _ => k_s*s_s - k_p*s_p;
            torques => T_load/r2;
            governor_load => c_load*theta_load_dot/r2 - c_load*n_load/r2;
            dc_load => Ts_load*theta_load_dot/(n0_load*r2) - Ts_load/r2;
            induction_load => -T_induction_load/r2;
            traction_load => -T_traction_load/r2;
            fan_load => -T_fan_load/r2;
            damping => I2*alpha_M*r1*theta_dot/r2.powi(2) - I2*alpha_M*s_dot/r2.powi(2) - beta_K*k_p*s_p_dot + beta_K*k_s*s_s_dot;
        }
        psi {
            _ => -a*k_s*s_s - k_t*twist_t;
            end_stop_t => -cs_t*stop_damp_t*past_t_dot - ks_t*at_stop_t*stop_clip_t*past_t - ks_t*at_stop_t*past_t;
            end_stop_t_and_damping => -beta_K*ks_t*stop_damp_t*past_t_dot;
            damping => -I_t*alpha_M*psi_dot - a*beta_K*k_s*s_s_dot - beta_K*k_t*twist_t_dot;
        }
    }
    jacobian {
        theta theta_dot { damping => -I1*alpha_M - I2*alpha_M*r1.powi(2)/r2.powi(2); }
        theta s_dot { damping => I2*alpha_M*r1/r2.powi(2); }
        theta theta_crank_dot {
            governor_crank => -c_crank;
            dc_crank => -Ts_crank/n0_crank;
            induction_crank => T_induction_crank_by_theta_crank_dot;
            traction_crank => T_traction_crank_by_theta_crank_dot;
            fan_crank => T_fan_crank_by_theta_crank_dot;
        }
        theta theta_load_dot {
            governor_load => -c_load*r1/r2;
            dc_load => -Ts_load*r1/(n0_load*r2);
            induction_load => r1*T_induction_load_by_theta_load_dot/r2;
            traction_load => r1*T_traction_load_by_theta_load_dot/r2;
            fan_load => r1*T_fan_load_by_theta_load_dot/r2;
        }
        s theta_dot { damping => I2*alpha_M*r1/r2.powi(2); }
        s s_dot { damping => -I2*alpha_M/r2.powi(2); }
        s s_p { _ => -k_p; }
        s s_s { _ => k_s; }
        s s_p_dot { damping => -beta_K*k_p; }
        s s_s_dot { damping => beta_K*k_s; }
        s theta_load_dot {
            governor_load => c_load/r2;
            dc_load => Ts_load/(n0_load*r2);
            induction_load => -T_induction_load_by_theta_load_dot/r2;
            traction_load => -T_traction_load_by_theta_load_dot/r2;
            fan_load => -T_fan_load_by_theta_load_dot/r2;
        }
        psi psi_dot { damping => -I_t*alpha_M; }
        psi s_s { _ => -a*k_s; }
        psi twist_t { _ => -k_t; }
        psi past_t { end_stop_t => -ks_t*at_stop_t - ks_t*at_stop_t*stop_clip_t; }
        psi s_s_dot { damping => -a*beta_K*k_s; }
        psi twist_t_dot { damping => -beta_K*k_t; }
        psi past_t_dot {
            end_stop_t => -cs_t*stop_damp_t;
            end_stop_t_and_damping => -beta_K*ks_t*stop_damp_t;
        }
    }
    cell {
        stiffness {
            s_p s_p { _ => k_p; }
            s_s s_s { _ => k_s; }
            twist_t twist_t { _ => k_t; }
            past_t past_t { end_stop_t => ks_t*at_stop_t + ks_t*at_stop_t*stop_clip_t; }
        }
        damping {
            theta theta { damping => I1*alpha_M + I2*alpha_M*r1.powi(2)/r2.powi(2); }
            theta s { damping => -I2*alpha_M*r1/r2.powi(2); }
            s s { damping => I2*alpha_M/r2.powi(2); }
            psi psi { damping => I_t*alpha_M; }
            s_p s_p { damping => beta_K*k_p; }
            s_s s_s { damping => beta_K*k_s; }
            twist_t twist_t { damping => beta_K*k_t; }
            past_t past_t {
                end_stop_t => cs_t*stop_damp_t;
                end_stop_t_and_damping => beta_K*ks_t*stop_damp_t;
            }
            theta_crank theta_crank {
                governor_crank => c_crank;
                dc_crank => Ts_crank/n0_crank;
            }
            theta_load theta_load {
                governor_load => c_load;
                dc_load => Ts_load/n0_load;
            }
        }
        load {
            theta {
                torques => T_crank - T_load*r1/r2;
                governor_crank => c_crank*n_crank;
                dc_crank => Ts_crank;
                governor_load => c_load*n_load*r1/r2;
                dc_load => Ts_load*r1/r2;
            }
            s {
                torques => T_load/r2;
                governor_load => -c_load*n_load/r2;
                dc_load => -Ts_load/r2;
            }
            past_t { end_stop_t => ks_t*at_stop_t*stop_clip_t*stop_t + ks_t*at_stop_t*stop_t; }
        }
    }
    nonlinear_with {
        induction_crank "T_induction_crank in the torque `induction_crank`";
        traction_crank "T_traction_crank in the torque `traction_crank`";
        fan_crank "T_fan_crank in the torque `fan_crank`";
        induction_load "T_induction_load in the torque `induction_load`";
        traction_load "T_traction_load in the torque `traction_load`";
        fan_load "T_fan_load in the torque `fan_load`";
    }
    outputs {
        rotor_speed_1 "rad/s", "rotational speed of the crankshaft" { _ => theta_dot; }
        rotor_speed_2 "rad/s", "rotational speed of the accessory" { _ => r1*theta_dot/r2 - s_dot/r2; }
        rotor_speed_t "rad/s", "rotational speed of the tensioner arm" { _ => psi_dot; }
        span_force_p "N", "force in the pulling span beyond its tension at rest, damper included" {
            _ => k_p*s_p;
            damping => beta_K*k_p*s_p_dot;
        }
        span_loss_p "W", "power that the damper of the pulling span takes" { damping => beta_K*k_p*s_p_dot.powi(2); }
        span_force_s "N", "force in the slack span beyond its tension at rest, damper included" {
            _ => k_s*s_s;
            damping => beta_K*k_s*s_s_dot;
        }
        span_loss_s "W", "power that the damper of the slack span takes" { damping => beta_K*k_s*s_s_dot.powi(2); }
        shaft_twist_t "rad", "twist of the spring of the tensioner arm" { _ => twist_t; }
        shaft_torque_t "N*m", "torque in the spring of the tensioner arm, damper included" {
            _ => k_t*twist_t;
            damping => beta_K*k_t*twist_t_dot;
        }
        shaft_power_t "W", "power that enters the spring of the tensioner arm at its first end: torque times the speed of that end" {
            _ => psi_dot*shaft_torque_t;
        }
        shaft_loss_t "W", "power that the damper of the spring of the tensioner arm takes" { damping => beta_K*k_t*twist_t_dot.powi(2); }
        stop_force_t "N*m" with end_stop_t,
            "force of the stops on the tensioner arm, damper included: positive if it pushes back from the upper one" {
            end_stop_t => cs_t*stop_damp_t*past_t_dot + ks_t*at_stop_t*stop_clip_t*past_t + ks_t*at_stop_t*past_t;
            end_stop_t_and_damping => beta_K*ks_t*stop_damp_t*past_t_dot;
        }
        stop_loss_t "W" with end_stop_t, "power that the dampers of the stops of the tensioner arm take" {
            end_stop_t => cs_t*stop_damp_t*past_t_dot.powi(2) + ks_t*at_stop_t*stop_clip_t*past_t*past_t_dot;
            end_stop_t_and_damping => beta_K*ks_t*stop_damp_t*past_t_dot.powi(2);
        }
        power_crank "W" with torques, "power of the driving torque of the crankshaft: positive if it drives" { _ => crank_power; }
        braking_governor_crank "W" with governor_crank,
            "power that the motor takes back: the part of its torque that is proportional to the speed, times the speed" {
            _ => c_crank*theta_crank_dot.powi(2);
        }
        power_governor_crank "W" with governor_crank,
            "power of the torque c n of the governor of the crankshaft; its part -c omega is in D: positive if it drives" {
            _ => governor_crank_power;
        }
        net_power_governor_crank "W" with governor_crank,
            "power that the motor gives: its whole torque times its speed, negative if it brakes" {
            _ => governor_crank_power - braking_governor_crank;
        }
        braking_dc_crank "W" with dc_crank,
            "power that the motor takes back: the part of its torque that is proportional to the speed, times the speed" {
            _ => Ts_crank*theta_crank_dot.powi(2)/n0_crank;
        }
        power_dc_crank "W" with dc_crank,
            "power of the torque Ts of the DC motor of the crankshaft; its part -Ts omega/n0 is in D: positive if it drives" {
            _ => dc_crank_power;
        }
        net_power_dc_crank "W" with dc_crank, "power that the motor gives: its whole torque times its speed, negative if it brakes" {
            _ => dc_crank_power - braking_dc_crank;
        }
        power_induction_crank "W" with induction_crank,
            "power of the torque of the induction motor of the crankshaft: positive if it drives" {
            _ => induction_crank_power;
        }
        power_traction_crank "W" with traction_crank, "power of the torque of the traction motor of the crankshaft: positive if it drives" {
            _ => traction_crank_power;
        }
        power_fan_crank "W" with fan_crank,
            "power of the torque of the fan of the crankshaft, against the rotation: positive if it drives" {
            _ => fan_crank_power;
        }
        power_load "W" with torques, "power of the load torque of the accessory, against its rotation: positive if it drives" {
            _ => load_power;
        }
        braking_governor_load "W" with governor_load,
            "power that the motor takes back: the part of its torque that is proportional to the speed, times the speed" {
            _ => c_load*theta_load_dot.powi(2);
        }
        power_governor_load "W" with governor_load,
            "power of the torque c n of the governor of the accessory; its part -c omega is in D: positive if it drives" {
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
            "power of the torque Ts of the DC motor of the accessory; its part -Ts omega/n0 is in D: positive if it drives" {
            _ => dc_load_power;
        }
        net_power_dc_load "W" with dc_load, "power that the motor gives: its whole torque times its speed, negative if it brakes" {
            _ => dc_load_power - braking_dc_load;
        }
        power_induction_load "W" with induction_load, "power of the torque of the induction motor of the accessory: positive if it drives" {
            _ => induction_load_power;
        }
        power_traction_load "W" with traction_load, "power of the torque of the traction motor of the accessory: positive if it drives" {
            _ => traction_load_power;
        }
        power_fan_load "W" with fan_load, "power of the torque of the fan of the accessory, against the rotation: positive if it drives" {
            _ => fan_load_power;
        }
        inertia_damping_loss "W" with damping, "power that the damping in proportion to inertia takes" {
            _ => 2.0*alpha_M*((I1*theta_dot.powi(2) + I2*(r1*theta_dot/r2 - s_dot/r2).powi(2) + I_t*psi_dot.powi(2))/2.0);
        }
    }

    text "text/belt_drive.txt";
    latex "latex/belt_drive.tex";
}

// Proved of these equations, symbolically:
//
// - d/dt (q'.dT/dq' - T + V) = Q.q' - q'.dD/dq' along the motion, for every value and slope of every law, with any set of the additive
//   effects; q'.dD/dq' includes the power that switches take
// - M is symmetric
// - T = q'.M q'/2, with M as written
// - M is positive definite: every leading minor is a sum of products of positive quantities
// - V is the same on both sides of the exits of past_t: no impulse there
// - the force of the switch past_t takes energy or none: f past_t_dot >= 0 in every mode, from the guards that hold in it; of a damper that
//   is clipped to f = c F, where F = dV/dpast_t and c = 1 or -1, since F past_t >= 0, past_t_dot dD/dpast_t_dot >= 0 and c past_t
//   dD/dpast_t_dot >= F past_t
// - every damper takes energy or none: each term of D has a power q'.dD/dq' that is never negative
// - every deflection equals the linear form by which the equations differentiate it
//
// Operations, all effects present:
//
// | output | sums | products, quotients | functions, roots |
// | --- | --- | --- | --- |
// | constants (once a scene) | 0 | 2 | 0 |
// | named forces | 30 | 78 | 6 |
// | force | 18 | 84 | 0 |
