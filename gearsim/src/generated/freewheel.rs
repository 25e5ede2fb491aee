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
        Tdrag "N*m" default 0.0, from 0.0 to inf, "drag torque of the clutch while it overruns";
        Tc2 "N*m" required with dry_friction_2, from 0.0 to inf,
            "Coulomb friction of the bearings of the driven rotor: constant, against the motion";
        rise2 "1" default 0.0, from 0.0 to inf,
            "excess of the breakaway torque of the bearings of the driven rotor over its Coulomb friction, relative to that";
        c2 "N*m*s/rad" required with viscous_friction_2, from 0.0 to inf, "viscous friction of the driven rotor: torque per speed";
        T_motor "N*m" required with torques, open -inf to inf, "driving torque of the motor";
        T_load "N*m" required with torques, open -inf to inf, "load torque of the driven rotor, against its rotation";
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
    }
    conditions {
    }

    deflections {
        lead = theta1 - theta2;
        slip2 = theta2;
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
        dissipation { viscous_friction_2 => c2*theta2_dot.powi(2)/2.0; }
    }
    torques {
        motor "driving torque of the motor" { torques => T_motor*theta1; }
        load "load torque of the driven rotor, against its rotation" { torques => -T_load*theta2; }
    }
    work {
        theta1 { torques => T_motor; }
        theta2 { torques => -T_load; }
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
        }
        theta2 {
            overrunning_clutch => Tdrag*drags + Tmax*slips;
            dry_friction_2 => -Tc2*dir2;
            viscous_friction_2 => -c2*theta2_dot;
            torques => -T_load;
        }
    }
    jacobian { theta2 theta2_dot { viscous_friction_2 => -c2; } }
    cell {
        stiffness {
        }
        damping { theta2 theta2 { viscous_friction_2 => c2; } }
        load {
            theta1 {
                overrunning_clutch => -Tdrag*drags - Tmax*slips;
                torques => T_motor;
            }
            theta2 {
                overrunning_clutch => Tdrag*drags + Tmax*slips;
                dry_friction_2 => -Tc2*dir2;
                torques => -T_load;
            }
        }
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
        power_load "W" with torques, "power of the load torque of the driven rotor, against its rotation: positive if it drives" {
            _ => load_power;
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
// | force | 2 | 6 | 0 |
// | acceleration | 2 | 14 | 0 |
