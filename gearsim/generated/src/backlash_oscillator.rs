//! Equations of motion of `backlash_oscillator`: a rotor on a spring and damper with play.
//!
//! Derived from the energies in `models/src/backlash_oscillator.rs` by `cargo xtask derive backlash_oscillator`.
//! Do not edit: change the energies and derive again.
//! For reading: `text/backlash_oscillator.txt`, `latex/backlash_oscillator.tex`. What is proved: at the end.

use gearsim::equations;

equations! {
    model backlash_oscillator "a rotor on a spring and damper with play";
    source "Modelica Standard Library, Modelica.Mechanics.Rotational.Examples.Backlash";

    coordinates { phi "rad" start 0.0, "rotation"; }
    parameters {
        I "kg*m^2" required, open 0.0 to inf, "moment of inertia of the rotor";
        c "N*m/rad" required, from 0.0 to inf, "stiffness of the contact";
        b "rad" required with backlash, open 0.0 to inf, "backlash of the contact: no contact within b/2 to either side";
        d "N*m*s/rad" required with damping, from 0.0 to inf, "damping of the contact";
        T_motor "N*m" required with torques, open -inf to inf, "driving torque of the rotor";
        c_motor "N*m*s/rad" required with governor_motor, open 0.0 to inf,
            "gain of the governor of the rotor: torque per difference of set point and speed";
        n_motor "rad/s" required with governor_motor, open -inf to inf, "set point of the speed governor of the rotor";
        Ts_motor "N*m" required with dc_motor, open 0.0 to inf, "stall torque of the DC motor of the rotor";
        n0_motor "rad/s" required with dc_motor, open 0.0 to inf, "no-load speed of the DC motor of the rotor";
        Tb_motor "N*m" required with induction_motor, open 0.0 to inf,
            "breakdown torque of the induction motor of the rotor, its largest torque";
        sb_motor "1" required with induction_motor, open 0.0 to inf,
            "slip at which the induction motor of the rotor has its breakdown torque";
        ns_motor "rad/s" required with induction_motor, open 0.0 to inf, "synchronous speed of the induction motor of the rotor";
        Tp_motor "N*m" required with traction_motor, open 0.0 to inf,
            "peak torque of the traction motor of the rotor, up to its base speed";
        Pp_motor "W" required with traction_motor, open 0.0 to inf,
            "peak power of the traction motor of the rotor, above its base speed Pp/Tp";
        d_motor "1" default 1.0 with traction_motor, open -inf to inf,
            "demand on the traction motor of the rotor: 1 drives with its peak torque or power, -1 brakes with them";
        round_motor "1" default 0.01 with traction_motor, open 0.0 to inf,
            "rounding of the corner of the torque of the traction motor of the rotor at its base speed, relative to that";
        cf_motor "N*m*s^2/rad^2" required with fan_motor, from 0.0 to inf,
            "torque of the fan of the rotor divided by the square of its speed";
        w0_motor "rad/s" default 0.01 with fan_motor, open 0.0 to inf,
            "speed of the rotor below which the torque of its fan is linear instead of quadratic in the speed";
    }
    laws {
    }
    motions { speed "rad/s" { phi_dot = 1.0; }, "rotational speed"; }
    effects {
        backlash "play between the flanks: contact on the drive or coast flank, free motion between";
        damping "a damper parallel to the spring";
        torques "constant torques of motor and load";
        governor_motor of governor excludes(dc_motor, induction_motor, traction_motor)
            "a motor with a speed governor: its torque is proportional to the set point minus the speed";
        dc_motor of dc excludes(induction_motor, traction_motor)
            "a DC motor at constant voltage: its torque falls linearly from stall to no load";
        induction_motor of induction excludes(traction_motor) "an induction motor, its torque by the formula of Kloss";
        traction_motor of traction "a traction motor: its peak torque up to the base speed, constant power above it, times the demand";
        fan_motor of fan "a fan as load: torque proportional to the square of the speed, against the rotation";
    }
    conditions {
    }

    constants { per_wb_motor = Tp_motor/Pp_motor; }
    deflections {
        over = phi - edge;
        theta_motor = phi;
    }
    forces {
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
    }
    partials {
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
    }
    switches {
        over "rad" (touch 1.0, edge 0.0, damp 1.0, clip 0.0) with backlash, "play of the contact" {
            upper (1.0, b/2.0, 1.0, 0.0) rests counts "flanks met" {
                unless free { over { _ => 1.0; } }
                until upper_loose {
                    over { _ => c; }
                    over_dot { damping => d; }
                }
                until upper_hit {
                    over { _ => c; }
                    over_dot { damping => -d; }
                }
            }
            lower (1.0, -b/2.0, 1.0, 0.0) rests counts "flanks met" {
                unless free { over { _ => -1.0; } }
                until lower_loose {
                    over { _ => -c; }
                    over_dot { damping => -d; }
                }
                until lower_hit {
                    over { _ => -c; }
                    over_dot { damping => d; }
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
                    over { _ => -c; }
                    over_dot { damping => d; }
                }
            }
            lower_hit (1.0, -b/2.0, 0.0, 1.0) counts "flanks met" {
                unless free { over { _ => -1.0; } }
                until lower {
                    over { _ => c; }
                    over_dot { damping => -d; }
                }
            }
            upper_loose (1.0, b/2.0, 0.0, -1.0) counts "flanks met" {
                until free { over { _ => 1.0; } }
                until upper {
                    over { _ => -c; }
                    over_dot { damping => -d; }
                }
            }
            lower_loose (1.0, -b/2.0, 0.0, -1.0) counts "flanks met" {
                until free { over { _ => -1.0; } }
                until lower {
                    over { _ => c; }
                    over_dot { damping => d; }
                }
            }
            loss { over { _ => c*clip*touch; } }
        }
    }
    energies {
        kinetic { _ => I*phi_dot.powi(2)/2.0; }
        potential { _ => c*touch*over.powi(2)/2.0; }
        dissipation {
            damping => d*damp*over_dot.powi(2)/2.0;
            governor_motor => c_motor*theta_motor_dot.powi(2)/2.0;
            dc_motor => Ts_motor*theta_motor_dot.powi(2)/(2.0*n0_motor);
        }
    }
    torques {
        motor "driving torque of the rotor" { torques => T_motor*phi; }
        governor_motor "torque c n of the governor of the rotor; its part -c omega is in D" { governor_motor => c_motor*n_motor*phi; }
        dc_motor "torque Ts of the DC motor of the rotor; its part -Ts omega/n0 is in D" { dc_motor => Ts_motor*phi; }
        induction_motor "torque of the induction motor of the rotor" {}
        power { induction_motor => T_induction_motor*phi_dot; }
        traction_motor "torque of the traction motor of the rotor" {}
        power { traction_motor => T_traction_motor*phi_dot; }
        fan_motor "torque of the fan of the rotor, against the rotation" {}
        power { fan_motor => T_fan_motor*phi_dot; }
    }
    work {
        phi {
            torques => T_motor;
            governor_motor => c_motor*n_motor;
            dc_motor => Ts_motor;
        }
    }
    mass { phi phi { _ => I; } }
    mobility { phi phi { _ => 1.0/I; } }
    force {
        phi {
            _ => -c*touch*over;
            backlash => -c*clip*touch*over;
            damping => -d*damp*over_dot;
            torques => T_motor;
            governor_motor => c_motor*n_motor - c_motor*theta_motor_dot;
            dc_motor => Ts_motor - Ts_motor*theta_motor_dot/n0_motor;
            induction_motor => T_induction_motor;
            traction_motor => T_traction_motor;
            fan_motor => T_fan_motor;
        }
    }
    jacobian {
        phi over {
            _ => -c*touch;
            backlash => -c*clip*touch;
        }
        phi over_dot { damping => -d*damp; }
        phi theta_motor_dot {
            governor_motor => -c_motor;
            dc_motor => -Ts_motor/n0_motor;
            induction_motor => T_induction_motor_by_theta_motor_dot;
            traction_motor => T_traction_motor_by_theta_motor_dot;
            fan_motor => T_fan_motor_by_theta_motor_dot;
        }
    }
    cell {
        stiffness {
            over over {
                _ => c*touch;
                backlash => c*clip*touch;
            }
        }
        damping {
            over over { damping => d*damp; }
            theta_motor theta_motor {
                governor_motor => c_motor;
                dc_motor => Ts_motor/n0_motor;
            }
        }
        load {
            phi {
                torques => T_motor;
                governor_motor => c_motor*n_motor;
                dc_motor => Ts_motor;
            }
            over {
                _ => c*touch*edge;
                backlash => c*clip*touch*edge;
            }
        }
    }
    nonlinear_with {
        induction_motor "T_induction_motor in the torque `induction_motor`";
        traction_motor "T_traction_motor in the torque `traction_motor`";
        fan_motor "T_fan_motor in the torque `fan_motor`";
    }
    outputs {
        rotor_speed "rad/s", "rotational speed of the rotor" { _ => phi_dot; }
        contact_loss "1" with backlash, "1 while no force passes the contact, else 0: its mean is the share of time without contact" {
            _ => 1.0 - touch*(1.0 + clip*(1.0 - clip)/2.0);
        }
        power_motor "W" with torques, "power of the driving torque of the rotor: positive if it drives" { _ => motor_power; }
        braking_governor_motor "W" with governor_motor,
            "power that the motor takes back: the part of its torque that is proportional to the speed, times the speed" {
            _ => c_motor*theta_motor_dot.powi(2);
        }
        power_governor_motor "W" with governor_motor,
            "power of the torque c n of the governor of the rotor; its part -c omega is in D: positive if it drives" {
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
            "power of the torque Ts of the DC motor of the rotor; its part -Ts omega/n0 is in D: positive if it drives" {
            _ => dc_motor_power;
        }
        net_power_dc_motor "W" with dc_motor, "power that the motor gives: its whole torque times its speed, negative if it brakes" {
            _ => dc_motor_power - braking_dc_motor;
        }
        power_induction_motor "W" with induction_motor, "power of the torque of the induction motor of the rotor: positive if it drives" {
            _ => induction_motor_power;
        }
        power_traction_motor "W" with traction_motor, "power of the torque of the traction motor of the rotor: positive if it drives" {
            _ => traction_motor_power;
        }
        power_fan_motor "W" with fan_motor, "power of the torque of the fan of the rotor, against the rotation: positive if it drives" {
            _ => fan_motor_power;
        }
        contact_torque "N*m", "torque of the contact, damper included" {
            _ => c*touch*over;
            backlash => c*clip*touch*over;
            damping => d*damp*over_dot;
        }
        damper_loss "W", "power that the damper of the contact takes" {
            backlash => c*clip*touch*over*over_dot;
            damping => d*damp*over_dot.powi(2);
        }
    }

    text "text/backlash_oscillator.txt";
    latex "latex/backlash_oscillator.tex";
}

// Proved of these equations, symbolically:
//
// - d/dt (q'.dT/dq' - T + V) = Q.q' - q'.dD/dq' along the motion, for every value and slope of every law, with any set of the additive
//   effects; q'.dD/dq' includes the power that switches take
// - M is symmetric
// - T = q'.M q'/2, with M as written
// - M is positive definite: every leading minor is a sum of products of positive quantities
// - M M⁻¹ = 1, and M q'' = F, for M⁻¹ and the accelerations as written
// - V is the same on both sides of the exits of over: no impulse there
// - the force of the switch over takes energy or none: f over_dot >= 0 in every mode, from the guards that hold in it; of a damper that is
//   clipped to f = c F, where F = dV/dover and c = 1 or -1, since F over >= 0, over_dot dD/dover_dot >= 0 and c over dD/dover_dot >= F over
// - every damper takes energy or none: each term of D has a power q'.dD/dq' that is never negative
// - every deflection equals the linear form by which the equations differentiate it
//
// Operations, all effects present:
//
// | output | sums | products, quotients | functions, roots |
// | --- | --- | --- | --- |
// | constants (once a scene) | 0 | 1 | 0 |
// | named forces | 15 | 39 | 3 |
// | force | 2 | 11 | 0 |
// | acceleration | 2 | 22 | 0 |
