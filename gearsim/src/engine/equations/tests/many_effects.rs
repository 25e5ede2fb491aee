//! A model of 24 independent effects. Each of the 2^24 sets of effects is admissible, and no set has separate code.

use super::set;
use crate::engine::equations::Derived;

/// Effect i is a spring of 2^i N/m. The springs of the set `effects`, whose bits are the effects, have the total stiffness `effects` [N/m].
mod springs {
    gearsim::equations! {
        model springs "A mass on 24 springs, each an effect";
        coordinates { x "m" start 0.0, "displacement"; }
        parameters { m "kg" required, open 0.0 to inf, "mass"; }
        effects {
            s0 "a spring of 1 N/m";
            s1 "a spring of 2 N/m";
            s2 "a spring of 4 N/m";
            s3 "a spring of 8 N/m";
            s4 "a spring of 16 N/m";
            s5 "a spring of 32 N/m";
            s6 "a spring of 64 N/m";
            s7 "a spring of 128 N/m";
            s8 "a spring of 256 N/m";
            s9 "a spring of 512 N/m";
            s10 "a spring of 1024 N/m";
            s11 "a spring of 2048 N/m";
            s12 "a spring of 4096 N/m";
            s13 "a spring of 8192 N/m";
            s14 "a spring of 16384 N/m";
            s15 "a spring of 32768 N/m";
            s16 "a spring of 65536 N/m";
            s17 "a spring of 131072 N/m";
            s18 "a spring of 262144 N/m";
            s19 "a spring of 524288 N/m";
            s20 "a spring of 1048576 N/m";
            s21 "a spring of 2097152 N/m";
            s22 "a spring of 4194304 N/m";
            s23 "a spring of 8388608 N/m";
        }
        energies {
            kinetic { _ => m*x_dot.powi(2)/2.0; }
            potential {
                s0 => 1.0*x.powi(2)/2.0; s1 => 2.0*x.powi(2)/2.0; s2 => 4.0*x.powi(2)/2.0; s3 => 8.0*x.powi(2)/2.0;
                s4 => 16.0*x.powi(2)/2.0; s5 => 32.0*x.powi(2)/2.0; s6 => 64.0*x.powi(2)/2.0; s7 => 128.0*x.powi(2)/2.0;
                s8 => 256.0*x.powi(2)/2.0; s9 => 512.0*x.powi(2)/2.0; s10 => 1024.0*x.powi(2)/2.0; s11 => 2048.0*x.powi(2)/2.0;
                s12 => 4096.0*x.powi(2)/2.0; s13 => 8192.0*x.powi(2)/2.0; s14 => 16384.0*x.powi(2)/2.0;
                s15 => 32768.0*x.powi(2)/2.0; s16 => 65536.0*x.powi(2)/2.0; s17 => 131072.0*x.powi(2)/2.0;
                s18 => 262144.0*x.powi(2)/2.0; s19 => 524288.0*x.powi(2)/2.0; s20 => 1048576.0*x.powi(2)/2.0;
                s21 => 2097152.0*x.powi(2)/2.0; s22 => 4194304.0*x.powi(2)/2.0; s23 => 8388608.0*x.powi(2)/2.0;
            }
        }
        mass { x x { _ => m; } }
        force {
            x {
                s0 => -1.0*x; s1 => -2.0*x; s2 => -4.0*x; s3 => -8.0*x; s4 => -16.0*x; s5 => -32.0*x; s6 => -64.0*x;
                s7 => -128.0*x; s8 => -256.0*x; s9 => -512.0*x; s10 => -1024.0*x; s11 => -2048.0*x; s12 => -4096.0*x;
                s13 => -8192.0*x; s14 => -16384.0*x; s15 => -32768.0*x; s16 => -65536.0*x; s17 => -131072.0*x;
                s18 => -262144.0*x; s19 => -524288.0*x; s20 => -1048576.0*x; s21 => -2097152.0*x; s22 => -4194304.0*x;
                s23 => -8388608.0*x;
            }
        }
        jacobian {}
        cell {
            stiffness {
                x x {
                    s0 => 1.0; s1 => 2.0; s2 => 4.0; s3 => 8.0; s4 => 16.0; s5 => 32.0; s6 => 64.0; s7 => 128.0; s8 => 256.0;
                    s9 => 512.0; s10 => 1024.0; s11 => 2048.0; s12 => 4096.0; s13 => 8192.0; s14 => 16384.0; s15 => 32768.0;
                    s16 => 65536.0; s17 => 131072.0; s18 => 262144.0; s19 => 524288.0; s20 => 1048576.0; s21 => 2097152.0;
                    s22 => 4194304.0; s23 => 8388608.0;
                }
            }
        }
    }
}

#[test]
fn every_set_of_many_effects_has_its_terms() {
    let x = 0.5;
    for effects in [0, 1, 1 << 11, 1 << 23, 0xa5_5aa5, 0x5a_a55a, 0x00_0fff, 0xff_f000, 0xff_ffff] {
        let equations = springs::Springs::equations(&set::<springs::Springs>(effects), &[2.0], &[]).unwrap();
        let stiffness = effects as f64;
        assert_eq!(equations.force(&[x], &[0.0], &[], &[]), [-stiffness * x]);
        assert_eq!(equations.potential(&[x], &[]), stiffness * x * x / 2.0);
        assert_eq!(equations.stiffness(&[])[(0, 0)], stiffness);
    }
}
