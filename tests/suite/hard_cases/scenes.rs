//! Whole scenes of random gear pairs, compared with the engine in 50 digits: the same events in the same order, and the same end.
//!
//! GEARSIM_SCENES sets their number, GEARSIM_SEED selects others.

pub mod compare;

use std::sync::OnceLock;

use compare::{Compared, compare};
use gearsim_tests::oh2005::{GearPair, PITCH, State};

use crate::case::{Case, NONE, WRONG};
use crate::noise::{Noise, setting};

pub const CASES: &[Case] = &[
    Case {
        row: "random",
        name: "events of random gear pairs",
        proves: "the same events in the same order, as long as disturbances stay small",
        tolerance: 0.0,
        unit: WRONG,
        reason: NONE,
        measure: |note| {
            let Sum { scenes, whole, events, reflections, wrong, .. } = sum();
            *note = format!("{scenes} scenes, {whole} of them to the end, {events} events, {reflections} reflections");
            *wrong as f64
        },
    },
    Case {
        row: "random",
        name: "event times and ends of random gear pairs",
        proves: "as accurate as the conditioning allows",
        tolerance: MULTIPLE,
        unit: "eps (growth of disturbances + 1) per event",
        reason: "each event adds some rounding errors, which grow as disturbances do",
        measure: |note| {
            *note = format!("{} scenes", sum().scenes);
            sum().error
        },
    },
];

/// Number of rounding errors that an event may add, each counted as at the start.
pub const MULTIPLE: f64 = 32.0;
/// Number of scenes, unless GEARSIM_SCENES is set.
const SCENES: u64 = 1000;

#[derive(Default)]
struct Sum {
    scenes: u64,
    whole: u64,
    events: u64,
    reflections: u64,
    wrong: u64,
    error: f64,
}

fn sum() -> &'static Sum {
    static SUM: OnceLock<Sum> = OnceLock::new();
    SUM.get_or_init(|| {
        let mut sum = Sum { scenes: setting("GEARSIM_SCENES", SCENES), ..Sum::default() };
        for i in 0..sum.scenes {
            let (pair, start, t_end) = draw(i);
            let Compared { events, reflections, error, whole, wrong } = compare(&pair, &start, t_end);
            sum.events += events;
            sum.reflections += reflections;
            sum.whole += u64::from(whole);
            if let Some(what) = wrong {
                sum.wrong += 1;
                println!("scene {i}: {what}; {pair:?} {start:?} until {t_end:e}");
            }
            if error > sum.error || error.is_nan() {
                println!("scene {i}: {error:.1} units; {pair:?} {start:?} until {t_end:e}");
                sum.error = error;
            }
        }
        sum
    })
}

/// Draws scene `i`: low and high speeds in both directions, small and large torques, any damping.
pub fn draw(i: u64) -> (GearPair, State, f64) {
    let noise = &mut Noise::new(!i.wrapping_mul(0x2545_f491_4f6c_dd1d));
    let zeta = match noise.below(4) {
        0 => 0.0,
        1 => noise.power(-4.0, -1.0),
        2 => noise.unit(),
        _ => noise.power(0.0, 1.5),
    };
    let pair = GearPair::paper(zeta, noise.power(0.0, 2.7));
    let rpm = noise.power(0.5, 3.7).copysign(noise.even());
    let standard = pair.start(rpm);
    let start = State {
        theta: 2.0 * PITCH * noise.even(),
        phi: standard.phi * (1.0 + 0.5 * noise.even()),
        phi_dot: standard.phi * pair.w0() * noise.even(),
        ..standard
    };
    // About thirty pitches, but in slow rotation only a time of a few oscillations.
    (pair, start, (30.0 * PITCH / start.theta_dot.abs()).min(noise.power(-2.5, -1.3)))
}
