//! Equations of motion of `friction_oscillator`: a rotor on a spring with dry friction.
//!
//! Derived from the energies in `models/src/friction_oscillator.rs` by `cargo xtask derive friction_oscillator`.
//! Do not edit: change the energies and derive again.
//! For reading: `text/friction_oscillator.txt`, `latex/friction_oscillator.tex`. What is proved: at the end.

use gearsim::equations;

equations! {
    model friction_oscillator "a rotor on a spring with dry friction";
    source "J. P. Den Hartog, Trans. ASME 53 (1931), 107-115";

    coordinates { phi "rad" start 0.0, "rotation"; }
    parameters {
        I "kg*m^2" required, open 0.0 to inf, "moment of inertia of the rotor";
        k "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the spring";
        Tc "N*m" required with dry_friction, from 0.0 to inf, "Coulomb friction of the bearing: constant, against the motion";
        rise "1" default 0.0 with dry_friction, from 0.0 to inf,
            "excess of the breakaway torque of the bearing over its Coulomb friction, relative to that";
        hi "rad" required with end_stop, open -inf to inf, "place of the upper stop of the rotor";
        lo "rad" required with end_stop, open -inf to inf, "place of the lower stop of the rotor";
        ks "N*m/rad" required with end_stop, open 0.0 to inf, "stiffness of the stops of the rotor";
        cs "N*m*s/rad" default 0.0 with end_stop, from 0.0 to inf, "damping of the stops of the rotor";
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
        dry_friction "dry friction with sticking: a constant torque against the motion, and at rest up to the breakaway torque";
        end_stop "end stops: elastic, with a damper that never pulls, beyond an upper and a lower limit of a displacement";
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
        twist = phi;
        slip = phi;
        past = phi - stop;
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
        slip "rad" (dir 0.0) with dry_friction, "dry friction of the bearing" {
            stuck (0.0) holds rests counts "stuck" {
                until forward {
                    reaction { _ => -1.0; }
                    one { _ => Tc + Tc*rise; }
                }
                until backward {
                    reaction { _ => 1.0; }
                    one { _ => Tc + Tc*rise; }
                }
            }
            forward (1.0) { until stuck { slip_dot { _ => 1.0; } } }
            backward (-1.0) { until stuck { slip_dot { _ => -1.0; } } }
            loss { one { _ => Tc*dir; } }
        }
        past "rad" (at_stop 1.0, stop 0.0, stop_damp 1.0, stop_clip 0.0) with end_stop, "end stops of the rotor" {
            free (0.0, 0.0, 0.0, 0.0) rests {
                until upper {
                    past { _ => -1.0; }
                    one { _ => hi; }
                }
                until lower {
                    past { _ => 1.0; }
                    one { _ => -lo; }
                }
            }
            upper (1.0, hi, 1.0, 0.0) rests counts "stop met" {
                unless free { past { _ => 1.0; } }
                until upper_loose {
                    past { end_stop => ks; }
                    past_dot { end_stop => cs; }
                }
                until upper_hit {
                    past { end_stop => ks; }
                    past_dot { end_stop => -cs; }
                }
            }
            upper_hit (1.0, hi, 0.0, 1.0) counts "stop met" {
                unless free { past { _ => 1.0; } }
                until upper {
                    past { end_stop => -ks; }
                    past_dot { end_stop => cs; }
                }
            }
            upper_loose (1.0, hi, 0.0, -1.0) counts "stop met" {
                until free { past { _ => 1.0; } }
                until upper {
                    past { end_stop => -ks; }
                    past_dot { end_stop => -cs; }
                }
            }
            lower (1.0, lo, 1.0, 0.0) rests counts "stop met" {
                unless free { past { _ => -1.0; } }
                until lower_loose {
                    past { end_stop => -ks; }
                    past_dot { end_stop => -cs; }
                }
                until lower_hit {
                    past { end_stop => -ks; }
                    past_dot { end_stop => cs; }
                }
            }
            lower_hit (1.0, lo, 0.0, 1.0) counts "stop met" {
                unless free { past { _ => -1.0; } }
                until lower {
                    past { end_stop => ks; }
                    past_dot { end_stop => -cs; }
                }
            }
            lower_loose (1.0, lo, 0.0, -1.0) counts "stop met" {
                until free { past { _ => -1.0; } }
                until lower {
                    past { end_stop => ks; }
                    past_dot { end_stop => cs; }
                }
            }
            loss { past { end_stop => ks*at_stop*stop_clip; } }
        }
    }
    energies {
        kinetic { _ => I*phi_dot.powi(2)/2.0; }
        potential {
            _ => k*twist.powi(2)/2.0;
            end_stop => ks*at_stop*past.powi(2)/2.0;
        }
        dissipation {
            end_stop => cs*stop_damp*past_dot.powi(2)/2.0;
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
            _ => -k*twist;
            dry_friction => -Tc*dir;
            end_stop => -cs*stop_damp*past_dot - ks*at_stop*stop_clip*past - ks*at_stop*past;
            torques => T_motor;
            governor_motor => c_motor*n_motor - c_motor*theta_motor_dot;
            dc_motor => Ts_motor - Ts_motor*theta_motor_dot/n0_motor;
            induction_motor => T_induction_motor;
            traction_motor => T_traction_motor;
            fan_motor => T_fan_motor;
        }
    }
    jacobian {
        phi twist { _ => -k; }
        phi past { end_stop => -ks*at_stop - ks*at_stop*stop_clip; }
        phi past_dot { end_stop => -cs*stop_damp; }
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
            twist twist { _ => k; }
            past past { end_stop => ks*at_stop + ks*at_stop*stop_clip; }
        }
        damping {
            past past { end_stop => cs*stop_damp; }
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
            slip { dry_friction => -Tc*dir; }
            past { end_stop => ks*at_stop*stop_clip*stop + ks*at_stop*stop; }
        }
    }
    nonlinear_with {
        induction_motor "T_induction_motor in the torque `induction_motor`";
        traction_motor "T_traction_motor in the torque `traction_motor`";
        fan_motor "T_fan_motor in the torque `fan_motor`";
    }
    outputs {
        rotor_speed "rad/s", "rotational speed of the rotor" { _ => phi_dot; }
        shaft_twist "rad", "twist of the spring" { _ => twist; }
        shaft_torque "N*m", "torque in the spring, damper included" { _ => k*twist; }
        shaft_power "W", "power that enters the spring at its first end: torque times the speed of that end" { _ => phi_dot*shaft_torque; }
        shaft_loss "W", "power that the damper of the spring takes" {}
        friction_torque "N*m" with dry_friction, "dry friction of the bearing, at rest too: positive against positive motion" {
            _ => slip_reaction;
            dry_friction => Tc*dir;
        }
        friction_loss "W" with dry_friction, "power that the dry friction of the bearing takes" { dry_friction => Tc*dir*slip_dot; }
        stop_force "N*m" with end_stop, "force of the stops on the rotor, damper included: positive if it pushes back from the upper one" {
            end_stop => cs*stop_damp*past_dot + ks*at_stop*stop_clip*past + ks*at_stop*past;
        }
        stop_loss "W" with end_stop, "power that the dampers of the stops of the rotor take" {
            end_stop => cs*stop_damp*past_dot.powi(2) + ks*at_stop*stop_clip*past*past_dot;
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
    }

    text "text/friction_oscillator.txt";
    latex "latex/friction_oscillator.tex";
}

// Proved of these equations, symbolically:
//
// - d/dt (q'.dT/dq' - T + V) = Q.q' - q'.dD/dq' along the motion, for every value and slope of every law, with any set of the additive
//   effects; q'.dD/dq' includes the power that switches take
// - M is symmetric
// - T = q'.M q'/2, with M as written
// - M is positive definite: every leading minor is a sum of products of positive quantities
// - M M⁻¹ = 1, and M q'' = F, for M⁻¹ and the accelerations as written
// - V is the same on both sides of the exits of slip: no impulse there
// - the force of the switch slip takes energy or none: f slip_dot >= 0 in every mode, from the guards that hold in it
// - V is the same on both sides of the exits of past: no impulse there
// - the force of the switch past takes energy or none: f past_dot >= 0 in every mode, from the guards that hold in it; of a damper that is
//   clipped to f = c F, where F = dV/dpast and c = 1 or -1, since F past >= 0, past_dot dD/dpast_dot >= 0 and c past dD/dpast_dot >= F past
// - every damper takes energy or none: each term of D has a power q'.dD/dq' that is never negative
// - every deflection equals the linear form by which the equations differentiate it
//
// Operations, all effects present:
//
// | output | sums | products, quotients | functions, roots |
// | --- | --- | --- | --- |
// | constants (once a scene) | 0 | 1 | 0 |
// | named forces | 15 | 39 | 3 |
// | force | 4 | 13 | 0 |
// | acceleration | 4 | 26 | 0 |
