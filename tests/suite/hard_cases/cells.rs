//! Random cells of 1 to 8 modes, a third of them grazing: first crossings compared with those of the engine in 50 digits.
//!
//! GEARSIM_CELLS sets their number, GEARSIM_SEED selects others.

mod draw;
mod judge;
mod phase;

use std::sync::OnceLock;

use draw::Drawn;
use judge::{Verdict, judge};

use crate::case::{Case, NONE, WRONG};
use crate::noise::{Noise, setting};

pub const CASES: &[Case] = &[
    Case {
        row: "random",
        name: "first crossings of random cells: found or not",
        proves: "none missed, no false one, down to the depth at which rounding decides",
        tolerance: 0.0,
        unit: WRONG,
        reason: NONE,
        measure: |note| {
            let Sum { cells, grazing, crossed, shallow, wrong, .. } = sum();
            *note = format!("{cells} cells, {grazing} made to graze, {crossed} crossed, {shallow} too shallow to tell");
            *wrong as f64
        },
    },
    Case {
        row: "random",
        name: "first crossings of random cells: their times",
        proves: "as accurate as the conditioning allows",
        tolerance: judge::MULTIPLE,
        unit: "(4 eps (up + down) + rounding of the phase)/slope + eps t",
        reason: "the depth of a touch and the rounding error of each mode, eps amplitude (1 + turns)",
        measure: |note| {
            *note = format!("{} crossings", sum().crossed);
            sum().error
        },
    },
];

/// Number of cells, unless GEARSIM_CELLS is set.
const CELLS: u64 = 30_000;

/// The results of all cells.
#[derive(Default)]
struct Sum {
    cells: u64,
    grazing: u64,
    crossed: u64,
    shallow: u64,
    wrong: u64,
    error: f64,
}

fn sum() -> &'static Sum {
    static SUM: OnceLock<Sum> = OnceLock::new();
    SUM.get_or_init(|| {
        let mut sum = Sum { cells: setting("GEARSIM_CELLS", CELLS), ..Sum::default() };
        for i in 0..sum.cells {
            sum.add(i);
        }
        sum
    })
}

impl Sum {
    /// Adds cell `i`, which does not depend on the other cells.
    fn add(&mut self, i: u64) {
        let noise = Noise::new(i.wrapping_mul(0x2545_f491_4f6c_dd1d));
        match i % 8 {
            0 => self.one::<1>(i, noise),
            1 => self.one::<2>(i, noise),
            2 => self.one::<3>(i, noise),
            3 => self.one::<4>(i, noise),
            4 => self.one::<5>(i, noise),
            5 => self.one::<6>(i, noise),
            6 => self.one::<7>(i, noise),
            _ => self.one::<8>(i, noise),
        }
    }

    fn one<const N: usize>(&mut self, i: u64, mut noise: Noise) {
        let drawn = Drawn::<N>::new(&mut noise, !i.is_multiple_of(3));
        self.grazing += u64::from(drawn.grazing);
        match judge(&drawn) {
            Verdict::Crossed(error) => {
                self.crossed += 1;
                if error > self.error {
                    println!("cell {i}: error {error:.2} of what conditioning explains, {drawn:?}");
                    self.error = error;
                }
            }
            Verdict::Passed => {}
            Verdict::Shallow => self.shallow += 1,
            Verdict::Wrong(what) => {
                self.wrong += 1;
                println!("cell {i}: {what}: {drawn:?}");
            }
        }
    }
}
