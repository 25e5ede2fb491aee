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
        rise "1" default 0.0, from 0.0 to inf, "excess of the breakaway torque of the bearing over its Coulomb friction, relative to that";
        T_motor "N*m" required with torques, open -inf to inf, "driving torque of the rotor";
    }
    laws {
    }
    motions { speed "rad/s" { phi_dot = 1.0; }, "rotational speed"; }
    effects {
        dry_friction "dry friction with sticking: a constant torque against the motion, and at rest up to the breakaway torque";
        torques "constant torques of motor and load";
    }
    conditions {
    }

    deflections {
        twist = phi;
        slip = phi;
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
    }
    energies {
        kinetic { _ => I*phi_dot.powi(2)/2.0; }
        potential { _ => k*twist.powi(2)/2.0; }
    }
    torques { motor "driving torque of the rotor" { torques => T_motor*phi; } }
    work { phi { torques => T_motor; } }
    mass { phi phi { _ => I; } }
    mobility { phi phi { _ => 1.0/I; } }
    force {
        phi {
            _ => -k*twist;
            dry_friction => -Tc*dir;
            torques => T_motor;
        }
    }
    jacobian { phi phi { _ => -k; } }
    cell {
        stiffness { phi phi { _ => k; } }
        damping {
        }
        load {
            phi {
                dry_friction => -Tc*dir;
                torques => T_motor;
            }
        }
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
        power_motor "W" with torques, "power of the driving torque of the rotor: positive if it drives" { _ => motor_power; }
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
// - every deflection equals the linear form by which the equations differentiate it
//
// Operations, all effects present:
//
// | output | sums | products, quotients | functions, roots |
// | --- | --- | --- | --- |
// | force | 0 | 2 | 0 |
// | acceleration | 0 | 5 | 0 |
