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
    }
    laws {
    }
    motions { speed "rad/s" { phi_dot = 1.0; }, "rotational speed"; }
    effects {
        backlash "play between the flanks: contact on the drive or coast flank, free motion between";
        damping "a damper parallel to the spring";
    }
    conditions {
    }

    deflections { over = phi - edge; }
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
        dissipation { damping => d*damp*over_dot.powi(2)/2.0; }
    }
    torques {
    }
    work {
    }
    mass { phi phi { _ => I; } }
    mobility { phi phi { _ => 1.0/I; } }
    force {
        phi {
            _ => -c*touch*over;
            backlash => -c*clip*touch*over;
            damping => -d*damp*over_dot;
        }
    }
    jacobian {
        phi phi {
            _ => -c*touch;
            backlash => -c*clip*touch;
        }
        phi phi_dot { damping => -d*damp; }
    }
    cell {
        stiffness {
            phi phi {
                _ => c*touch;
                backlash => c*clip*touch;
            }
        }
        damping { phi phi { damping => d*damp; } }
        load {
            phi {
                _ => c*touch*edge;
                backlash => c*clip*touch*edge;
            }
        }
    }
    outputs {
        rotor_speed "rad/s", "rotational speed of the rotor" { _ => phi_dot; }
        contact_loss "1" with backlash, "1 while no force passes the contact, else 0: its mean is the share of time without contact" {
            _ => 1.0 - touch*(1.0 + clip*(1.0 - clip)/2.0);
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
// | force | 0 | 7 | 0 |
// | acceleration | 0 | 10 | 0 |
