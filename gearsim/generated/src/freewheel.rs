//! Equations of motion of `freewheel`: a motor, an overrunning clutch and a rotor with dry friction.
//!
//! Derived from the energies in `models/src/freewheel.rs` by `cargo xtask derive freewheel`.
//! Do not edit: change the energies and derive again.
//! For reading: `text/freewheel.txt`, `latex/freewheel.tex`. What is proved: at the end.

use gearsim::equations;

equations! {
    model freewheel "a motor, an overrunning clutch and a rotor with dry friction";
    source "compare Modelica.Mechanics.Rotational.Examples.OneWayClutch and .Friction";

    coordinates {
        theta1 "rad" start 0.0, "rotation of the motor";
        theta2 "rad" start 0.0, "rotation of the driven rotor";
    }
    parameters {
        I1 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the motor";
        I2 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the driven rotor";
        Tmax "N*m" required with overrunning_clutch, open 0.0 to inf, "capacity of the clutch: the largest torque that it transmits";
        Tdrag "N*m" default 0.0 with overrunning_clutch, from 0.0 to inf, "drag torque of the clutch while it overruns";
        Tc2 "N*m" required with dry_friction_2, from 0.0 to inf,
            "Coulomb friction of the bearings of the driven rotor: constant, against the motion";
        rise2 "1" default 0.0 with dry_friction_2, from 0.0 to inf,
            "excess of the breakaway torque of the bearings of the driven rotor over its Coulomb friction, relative to that";
        c2 "N*m*s/rad" required with viscous_friction_2, from 0.0 to inf, "viscous friction of the driven rotor: torque per speed";
        T_motor "N*m" required with torques, open -inf to inf, "driving torque of the motor";
        c_motor "N*m*s/rad" required with governor_motor, open 0.0 to inf,
            "gain of the governor of the motor: torque per difference of set point and speed";
        n_motor "rad/s" required with governor_motor, open -inf to inf, "set point of the speed governor of the motor";
        Ts_motor "N*m" required with dc_motor, open 0.0 to inf, "stall torque of the DC motor of the motor";
        n0_motor "rad/s" required with dc_motor, open 0.0 to inf, "no-load speed of the DC motor of the motor";
        Tb_motor "N*m" required with induction_motor, open 0.0 to inf,
            "breakdown torque of the induction motor of the motor, its largest torque";
        sb_motor "1" required with induction_motor, open 0.0 to inf,
            "slip at which the induction motor of the motor has its breakdown torque";
        ns_motor "rad/s" required with induction_motor, open 0.0 to inf, "synchronous speed of the induction motor of the motor";
        Tp_motor "N*m" required with traction_motor, open 0.0 to inf,
            "peak torque of the traction motor of the motor, up to its base speed";
        Pp_motor "W" required with traction_motor, open 0.0 to inf,
            "peak power of the traction motor of the motor, above its base speed Pp/Tp";
        d_motor "1" default 1.0 with traction_motor, open -inf to inf,
            "demand on the traction motor of the motor: 1 drives with its peak torque or power, -1 brakes with them";
        round_motor "1" default 0.01 with traction_motor, open 0.0 to inf,
            "rounding of the corner of the torque of the traction motor of the motor at its base speed, relative to that";
        cf_motor "N*m*s^2/rad^2" required with fan_motor, from 0.0 to inf,
            "torque of the fan of the motor divided by the square of its speed";
        w0_motor "rad/s" default 0.01 with fan_motor, open 0.0 to inf,
            "speed of the motor below which the torque of its fan is linear instead of quadratic in the speed";
        T_load "N*m" required with torques, open -inf to inf, "load torque of the driven rotor, against its rotation";
        c_load "N*m*s/rad" required with governor_load, open 0.0 to inf,
            "gain of the governor of the driven rotor: torque per difference of set point and speed";
        n_load "rad/s" required with governor_load, open -inf to inf, "set point of the speed governor of the driven rotor";
        Ts_load "N*m" required with dc_load, open 0.0 to inf, "stall torque of the DC motor of the driven rotor";
        n0_load "rad/s" required with dc_load, open 0.0 to inf, "no-load speed of the DC motor of the driven rotor";
        Tb_load "N*m" required with induction_load, open 0.0 to inf,
            "breakdown torque of the induction motor of the driven rotor, its largest torque";
        sb_load "1" required with induction_load, open 0.0 to inf,
            "slip at which the induction motor of the driven rotor has its breakdown torque";
        ns_load "rad/s" required with induction_load, open 0.0 to inf, "synchronous speed of the induction motor of the driven rotor";
        Tp_load "N*m" required with traction_load, open 0.0 to inf,
            "peak torque of the traction motor of the driven rotor, up to its base speed";
        Pp_load "W" required with traction_load, open 0.0 to inf,
            "peak power of the traction motor of the driven rotor, above its base speed Pp/Tp";
        d_load "1" default 1.0 with traction_load, open -inf to inf,
            "demand on the traction motor of the driven rotor: 1 drives with its peak torque or power, -1 brakes with them";
        round_load "1" default 0.01 with traction_load, open 0.0 to inf,
            "rounding of the corner of the torque of the traction motor of the driven rotor at its base speed, relative to that";
        cf_load "N*m*s^2/rad^2" required with fan_load, from 0.0 to inf,
            "torque of the fan of the driven rotor divided by the square of its speed";
        w0_load "rad/s" default 0.01 with fan_load, open 0.0 to inf,
            "speed of the driven rotor below which the torque of its fan is linear instead of quadratic in the speed";
    }
    laws {
    }
    motions { speed "rad/s" { theta1_dot = 1.0; theta2_dot = 1.0; }, "rotational speed of both rotors"; }
    effects {
        overrunning_clutch "a one-way clutch: locked while it drives, free while the driven side is faster; without it the clutch is open";
        dry_friction_2 of dry_friction
            "dry friction with sticking: a constant torque against the motion, and at rest up to the breakaway torque";
        viscous_friction_2 of viscous_friction "friction proportional to speed";
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
    }
    conditions {
    }

    constants {
        per_wb_motor = Tp_motor/Pp_motor;
        per_wb_load = Tp_load/Pp_load;
    }
    deflections {
        lead = theta1 - theta2;
        slip2 = theta2;
        theta_motor = theta1;
        theta_load = theta2;
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
        lead "rad" (slips 0.0, drags 0.0) with overrunning_clutch, "modes of the clutch" {
            locked (0.0, 0.0) holds rests counts "clutch locked" {
                until overrun {
                    reaction { _ => 1.0; }
                    one { _ => Tdrag; }
                }
                until slips {
                    reaction { _ => -1.0; }
                    one { _ => Tmax; }
                }
            }
            overrun (0.0, -1.0) { until locked { lead_dot { _ => -1.0; } } }
            slips (1.0, 0.0) { until locked { lead_dot { _ => 1.0; } } }
            loss { one { _ => Tdrag*drags + Tmax*slips; } }
        }
        slip2 "rad" (dir2 0.0) with dry_friction_2, "dry friction of the bearings of the driven rotor" {
            stuck (0.0) holds rests counts "stuck" {
                until forward {
                    reaction { _ => -1.0; }
                    one { _ => Tc2 + Tc2*rise2; }
                }
                until backward {
                    reaction { _ => 1.0; }
                    one { _ => Tc2 + Tc2*rise2; }
                }
            }
            forward (1.0) { until stuck { slip2_dot { _ => 1.0; } } }
            backward (-1.0) { until stuck { slip2_dot { _ => -1.0; } } }
            loss { one { _ => Tc2*dir2; } }
        }
    }
    energies {
        kinetic { _ => (I1*theta1_dot.powi(2) + I2*theta2_dot.powi(2))/2.0; }
        dissipation {
            viscous_friction_2 => c2*theta2_dot.powi(2)/2.0;
            governor_motor => c_motor*theta_motor_dot.powi(2)/2.0;
            dc_motor => Ts_motor*theta_motor_dot.powi(2)/(2.0*n0_motor);
            governor_load => c_load*theta_load_dot.powi(2)/2.0;
            dc_load => Ts_load*theta_load_dot.powi(2)/(2.0*n0_load);
        }
    }
    torques {
        motor "driving torque of the motor" { torques => T_motor*theta1; }
        governor_motor "torque c n of the governor of the motor; its part -c omega is in D" { governor_motor => c_motor*n_motor*theta1; }
        dc_motor "torque Ts of the DC motor of the motor; its part -Ts omega/n0 is in D" { dc_motor => Ts_motor*theta1; }
        induction_motor "torque of the induction motor of the motor" {}
        power { induction_motor => T_induction_motor*theta1_dot; }
        traction_motor "torque of the traction motor of the motor" {}
        power { traction_motor => T_traction_motor*theta1_dot; }
        fan_motor "torque of the fan of the motor, against the rotation" {}
        power { fan_motor => T_fan_motor*theta1_dot; }
        load "load torque of the driven rotor, against its rotation" { torques => -T_load*theta2; }
        governor_load "torque c n of the governor of the driven rotor; its part -c omega is in D" { governor_load => c_load*n_load*theta2; }
        dc_load "torque Ts of the DC motor of the driven rotor; its part -Ts omega/n0 is in D" { dc_load => Ts_load*theta2; }
        induction_load "torque of the induction motor of the driven rotor" {}
        power { induction_load => T_induction_load*theta2_dot; }
        traction_load "torque of the traction motor of the driven rotor" {}
        power { traction_load => T_traction_load*theta2_dot; }
        fan_load "torque of the fan of the driven rotor, against the rotation" {}
        power { fan_load => T_fan_load*theta2_dot; }
    }
    work {
        theta1 {
            torques => T_motor;
            governor_motor => c_motor*n_motor;
            dc_motor => Ts_motor;
        }
        theta2 {
            torques => -T_load;
            governor_load => c_load*n_load;
            dc_load => Ts_load;
        }
    }
    mass {
        theta1 theta1 { _ => I1; }
        theta2 theta2 { _ => I2; }
    }
    mobility {
        theta1 theta1 { _ => 1.0/I1; }
        theta2 theta2 { _ => 1.0/I2; }
    }
    force {
        theta1 {
            overrunning_clutch => -Tdrag*drags - Tmax*slips;
            torques => T_motor;
            governor_motor => c_motor*n_motor - c_motor*theta_motor_dot;
            dc_motor => Ts_motor - Ts_motor*theta_motor_dot/n0_motor;
            induction_motor => T_induction_motor;
            traction_motor => T_traction_motor;
            fan_motor => T_fan_motor;
        }
        theta2 {
            overrunning_clutch => Tdrag*drags + Tmax*slips;
            dry_friction_2 => -Tc2*dir2;
            viscous_friction_2 => -c2*theta2_dot;
            torques => -T_load;
            governor_load => c_load*n_load - c_load*theta_load_dot;
            dc_load => Ts_load - Ts_load*theta_load_dot/n0_load;
            induction_load => T_induction_load;
            traction_load => T_traction_load;
            fan_load => T_fan_load;
        }
    }
    jacobian {
        theta1 theta_motor_dot {
            governor_motor => -c_motor;
            dc_motor => -Ts_motor/n0_motor;
            induction_motor => T_induction_motor_by_theta_motor_dot;
            traction_motor => T_traction_motor_by_theta_motor_dot;
            fan_motor => T_fan_motor_by_theta_motor_dot;
        }
        theta2 theta2_dot { viscous_friction_2 => -c2; }
        theta2 theta_load_dot {
            governor_load => -c_load;
            dc_load => -Ts_load/n0_load;
            induction_load => T_induction_load_by_theta_load_dot;
            traction_load => T_traction_load_by_theta_load_dot;
            fan_load => T_fan_load_by_theta_load_dot;
        }
    }
    cell {
        stiffness {
        }
        damping {
            theta2 theta2 { viscous_friction_2 => c2; }
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
            theta1 {
                torques => T_motor;
                governor_motor => c_motor*n_motor;
                dc_motor => Ts_motor;
            }
            theta2 {
                torques => -T_load;
                governor_load => c_load*n_load;
                dc_load => Ts_load;
            }
            lead { overrunning_clutch => -Tdrag*drags - Tmax*slips; }
            slip2 { dry_friction_2 => -Tc2*dir2; }
        }
    }
    nonlinear_with {
        induction_motor "T_induction_motor in the torque `induction_motor`";
        traction_motor "T_traction_motor in the torque `traction_motor`";
        fan_motor "T_fan_motor in the torque `fan_motor`";
        induction_load "T_induction_load in the torque `induction_load`";
        traction_load "T_traction_load in the torque `traction_load`";
        fan_load "T_fan_load in the torque `fan_load`";
    }
    outputs {
        rotor_speed_1 "rad/s", "rotational speed of the motor" { _ => theta1_dot; }
        rotor_speed_2 "rad/s", "rotational speed of the driven rotor" { _ => theta2_dot; }
        clutch_torque "N*m" with overrunning_clutch, "torque that the clutch gives to its driven side, locked, slipping or overrunning" {
            _ => lead_reaction;
            overrunning_clutch => Tdrag*drags + Tmax*slips;
        }
        clutch_loss "W" with overrunning_clutch, "power that the clutch takes as it slips or drags" {
            overrunning_clutch => Tdrag*drags*lead_dot + Tmax*slips*lead_dot;
        }
        friction_torque_2 "N*m" with dry_friction_2,
            "dry friction of the bearings of the driven rotor, at rest too: positive against positive motion" {
            _ => slip2_reaction;
            dry_friction_2 => Tc2*dir2;
        }
        friction_loss_2 "W" with dry_friction_2, "power that the dry friction of the bearings of the driven rotor takes" {
            dry_friction_2 => Tc2*dir2*slip2_dot;
        }
        viscous_loss_2 "W" with viscous_friction_2, "power that the viscous friction of the driven rotor takes" {
            _ => c2*theta2_dot.powi(2);
        }
        power_motor "W" with torques, "power of the driving torque of the motor: positive if it drives" { _ => motor_power; }
        braking_governor_motor "W" with governor_motor,
            "power that the motor takes back: the part of its torque that is proportional to the speed, times the speed" {
            _ => c_motor*theta_motor_dot.powi(2);
        }
        power_governor_motor "W" with governor_motor,
            "power of the torque c n of the governor of the motor; its part -c omega is in D: positive if it drives" {
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
            "power of the torque Ts of the DC motor of the motor; its part -Ts omega/n0 is in D: positive if it drives" {
            _ => dc_motor_power;
        }
        net_power_dc_motor "W" with dc_motor, "power that the motor gives: its whole torque times its speed, negative if it brakes" {
            _ => dc_motor_power - braking_dc_motor;
        }
        power_induction_motor "W" with induction_motor, "power of the torque of the induction motor of the motor: positive if it drives" {
            _ => induction_motor_power;
        }
        power_traction_motor "W" with traction_motor, "power of the torque of the traction motor of the motor: positive if it drives" {
            _ => traction_motor_power;
        }
        power_fan_motor "W" with fan_motor, "power of the torque of the fan of the motor, against the rotation: positive if it drives" {
            _ => fan_motor_power;
        }
        power_load "W" with torques, "power of the load torque of the driven rotor, against its rotation: positive if it drives" {
            _ => load_power;
        }
        braking_governor_load "W" with governor_load,
            "power that the motor takes back: the part of its torque that is proportional to the speed, times the speed" {
            _ => c_load*theta_load_dot.powi(2);
        }
        power_governor_load "W" with governor_load,
            "power of the torque c n of the governor of the driven rotor; its part -c omega is in D: positive if it drives" {
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
            "power of the torque Ts of the DC motor of the driven rotor; its part -Ts omega/n0 is in D: positive if it drives" {
            _ => dc_load_power;
        }
        net_power_dc_load "W" with dc_load, "power that the motor gives: its whole torque times its speed, negative if it brakes" {
            _ => dc_load_power - braking_dc_load;
        }
        power_induction_load "W" with induction_load,
            "power of the torque of the induction motor of the driven rotor: positive if it drives" {
            _ => induction_load_power;
        }
        power_traction_load "W" with traction_load, "power of the torque of the traction motor of the driven rotor: positive if it drives" {
            _ => traction_load_power;
        }
        power_fan_load "W" with fan_load,
            "power of the torque of the fan of the driven rotor, against the rotation: positive if it drives" {
            _ => fan_load_power;
        }
    }

    text "text/freewheel.txt";
    latex "latex/freewheel.tex";
}

// Proved of these equations, symbolically:
//
// - d/dt (q'.dT/dq' - T + V) = Q.q' - q'.dD/dq' along the motion, for every value and slope of every law, with any set of the additive
//   effects; q'.dD/dq' includes the power that switches take
// - M is symmetric
// - T = q'.M q'/2, with M as written
// - M is positive definite: every leading minor is a sum of products of positive quantities
// - M M⁻¹ = 1, and M q'' = F, for M⁻¹ and the accelerations as written
// - V is the same on both sides of the exits of lead: no impulse there
// - the force of the switch lead takes energy or none: f lead_dot >= 0 in every mode, from the guards that hold in it
// - V is the same on both sides of the exits of slip2: no impulse there
// - the force of the switch slip2 takes energy or none: f slip2_dot >= 0 in every mode, from the guards that hold in it
// - every damper takes energy or none: each term of D has a power q'.dD/dq' that is never negative
// - every deflection equals the linear form by which the equations differentiate it
//
// Operations, all effects present:
//
// | output | sums | products, quotients | functions, roots |
// | --- | --- | --- | --- |
// | constants (once a scene) | 0 | 2 | 0 |
// | named forces | 30 | 78 | 6 |
// | force | 6 | 14 | 0 |
// | acceleration | 6 | 36 | 0 |
