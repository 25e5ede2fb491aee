//! The cells of several simulations in lanes: the constants of the propagation, gathered from the cell of each lane.

use crate::engine::cell::Cell;
use crate::engine::crossing::Side;
use crate::engine::lanes::pack::{Mask, Pack};
use crate::engine::mode::Mode;
use crate::engine::simulate::Simulation;
use crate::engine::vector::Matrix;

/// One mode, in L cells.
#[derive(Debug, Clone, Copy)]
pub struct Modes<const L: usize> {
    /// Half the damping, sigma [1/s].
    pub sigma: Pack<L>,
    /// omega² [1/s²].
    pub omega2: Pack<L>,
    /// 1/omega² [s²], 0 for a rigid mode.
    pub per_omega2: Pack<L>,
    /// w, the damped angular frequency [1/s].
    pub w: Pack<L>,
    /// 1/w [s], 0 for a rigid mode.
    pub per_w: Pack<L>,
    /// 1/omega [s]: bound on S1.
    pub gain: Pack<L>,
    /// Coefficients of dt², ..., dt⁶ in the series of S1(dt).
    pub series: [Pack<L>; 5],
    /// n.X: the contribution of the mode to the phase.
    pub part: Pack<L>,
}

/// One cell, in L simulations. It is aligned like the vectors of the processor.
#[derive(Debug, Clone, Copy)]
#[repr(align(64))]
pub struct Cells<const N: usize, const L: usize> {
    /// Its modes.
    pub modes: [Modes<L>; N],
    /// X (N x N).
    pub shapes: [[Pack<L>; N]; N],
    /// Correction of the speeds given by X, see [`crate::engine::conserved`] (N x N).
    pub excess: [[Pack<L>; N]; N],
    /// XᵀM (N x N).
    pub momentum: [[Pack<L>; N]; N],
    /// XᵀK (N x N).
    pub springs: [[Pack<L>; N]; N],
    /// Xᵀf (N).
    pub load: [Pack<L>; N],
    /// Upper bound of the rates of its modes [1/s].
    pub rate: Pack<L>,
    /// Lower and upper boundary of the cell.
    pub bounds: [Pack<L>; 2],
    /// Phase after entering the cell beyond the lower and the upper boundary.
    pub entered: [Pack<L>; 2],
    /// Turns counted on entering the cell beyond the lower and the upper boundary.
    pub turns: [[i64; L]; 2],
    /// Half the difference of the stiffness matrices of the cell beyond each boundary and of this cell (N x N): dV = q.D q.
    pub step: [[[Pack<L>; N]; N]; 2],
}

impl<const N: usize, const L: usize> Cells<N, L> {
    /// A cell with zeros in every lane.
    pub fn empty() -> Self {
        let zero = Pack::all(0.0);
        let mode = Modes {
            sigma: zero,
            omega2: zero,
            per_omega2: zero,
            w: zero,
            per_w: zero,
            gain: zero,
            series: [zero; 5],
            part: zero,
        };
        Cells {
            modes: [mode; N],
            shapes: [[zero; N]; N],
            excess: [[zero; N]; N],
            momentum: [[zero; N]; N],
            springs: [[zero; N]; N],
            load: [zero; N],
            rate: zero,
            bounds: [zero; 2],
            entered: [zero; 2],
            turns: [[0; L]; 2],
            step: [[[zero; N]; N]; 2],
        }
    }

    /// Fills a lane with cell number `place` of the only law of a simulation. `stiffness` has the matrices K of all its cells.
    pub fn fill(&mut self, lane: usize, simulation: &Simulation<'_>, place: usize, stiffness: &[Matrix]) {
        let (law, cells) = (&simulation.now.laws[0], simulation.cells());
        let prepared = &cells.and_then(|cells| cells.all()).expect("a plain simulation has few cells")[place];
        let cell: &Cell = &prepared.cell;
        let n = cell.modes.len();
        let matrix = |to: &mut [[Pack<L>; N]; N], of: &dyn Fn(usize, usize) -> f64| {
            (0..n).for_each(|i| (0..n).for_each(|j| to[i][j].0[lane] = of(i, j)));
        };
        matrix(&mut self.shapes, &|i, j| cell.shapes[(i, j)]);
        let excess = |i, j| cell.conserved.iter().map(|c| c.motion[i] * c.on_gained[j]).sum();
        matrix(&mut self.excess, &excess);
        matrix(&mut self.momentum, &|i, j| cell.momentum[(i, j)]);
        matrix(&mut self.springs, &|i, j| cell.springs[(i, j)]);
        for (i, mode) in cell.modes.iter().enumerate() {
            self.modes[i].fill(lane, mode, prepared.participation[0][i]);
            self.load[i].0[lane] = cell.load[i];
        }
        self.rate.0[lane] = cell.rate;
        let (lower, upper) = law.pitch.bounds(place);
        for (i, (side, bound)) in [(Side::Lower, lower), (Side::Upper, upper)].into_iter().enumerate() {
            let (beyond, entered, turns) = law.pitch.beyond(place, side);
            self.turns[i][lane] = turns;
            self.bounds[i].0[lane] = bound;
            self.entered[i].0[lane] = entered;
            let (there, here) = (&stiffness[beyond], &stiffness[place]);
            matrix(&mut self.step[i], &|i, j| 0.5 * (there[(i, j)] - here[(i, j)]));
        }
    }

    /// Gathers one cell: for each lane, the cell with the index in `at`.
    #[inline(always)]
    pub fn gather(tables: &[Cells<N, L>], at: &[usize; L]) -> Cells<N, L> {
        let mut gathered = tables[0];
        for (place, table) in tables.iter().enumerate().skip(1) {
            let here = Mask::of(|lane| at[lane] == place);
            gathered.each(table, |mine, theirs| *mine = theirs.or(here, *mine));
        }
        gathered
    }

    /// Applies `f` to every number of this cell and the corresponding number of the other cell.
    #[inline(always)]
    fn each(&mut self, other: &Self, mut f: impl FnMut(&mut Pack<L>, &Pack<L>)) {
        for i in 0..N {
            let (m, o) = (&mut self.modes[i], &other.modes[i]);
            f(&mut m.sigma, &o.sigma);
            f(&mut m.omega2, &o.omega2);
            f(&mut m.per_omega2, &o.per_omega2);
            f(&mut m.w, &o.w);
            f(&mut m.per_w, &o.per_w);
            f(&mut m.gain, &o.gain);
            (0..5).for_each(|k| f(&mut m.series[k], &o.series[k]));
            f(&mut m.part, &o.part);
            f(&mut self.load[i], &other.load[i]);
            for j in 0..N {
                f(&mut self.shapes[i][j], &other.shapes[i][j]);
                f(&mut self.excess[i][j], &other.excess[i][j]);
                f(&mut self.momentum[i][j], &other.momentum[i][j]);
                f(&mut self.springs[i][j], &other.springs[i][j]);
                (0..2).for_each(|side| f(&mut self.step[side][i][j], &other.step[side][i][j]));
            }
        }
        f(&mut self.rate, &other.rate);
        (0..2).for_each(|side| {
            f(&mut self.bounds[side], &other.bounds[side]);
            f(&mut self.entered[side], &other.entered[side]);
        });
    }
}

impl<const L: usize> Modes<L> {
    fn fill(&mut self, lane: usize, mode: &Mode, part: f64) {
        let w = mode.damped_frequency();
        let inverse = |x: f64| if x > 0.0 { 1.0 / x } else { 0.0 };
        self.sigma.0[lane] = mode.sigma;
        self.omega2.0[lane] = mode.omega2;
        self.per_omega2.0[lane] = inverse(mode.omega2);
        self.w.0[lane] = w;
        self.per_w.0[lane] = inverse(w);
        self.gain.0[lane] = inverse(mode.omega2.sqrt());
        mode.series().iter().enumerate().for_each(|(k, c)| self.series[k].0[lane] = *c);
        self.part.0[lane] = part;
    }
}
