//! Internal dynamic factor K_v by ISO 6336-1:2006, method B (clause 6.5).
//!
//! N is the resonance ratio: the mesh frequency divided by the natural frequency of the gear pair with its mean mesh stiffness. The line
//! load is w = F_t K_A/b. eps is the total contact ratio: the sum of the transverse contact ratio and the overlap ratio.
//!
//! ```text
//! B_p = c' f_pb,eff/w        B_f = c' f_falpha,eff/w        B_k = |1 - c' C_a/w|
//! N <= N_S         K_v = N (C_v1 B_p + C_v2 B_f + C_v3 B_k) + 1                 subcritical
//! N_S < N <= 1.15  K_v = C_v1 B_p + C_v2 B_f + C_v4 B_k + 1                     main resonance
//! N >= 1.5         K_v = C_v5 B_p + C_v6 B_f + C_v7                             supercritical
//! 1.15 < N < 1.5   linear between the values at 1.15 and 1.5
//! N_S = 0.85 for w >= 100 N/mm, else 0.5 + 0.35 sqrt(w/(100 N/mm))
//! ```
//!
//! | eps | 1 to 2 | more than 2 |
//! | --- | --- | --- |
//! | C_v1 | 0.32 | 0.32 |
//! | C_v2 | 0.34 | 0.57/(eps - 0.3) |
//! | C_v3 | 0.23 | 0.096/(eps - 1.56) |
//! | C_v4 | 0.90 | (0.57 - 0.05 eps)/(eps - 1.44) |
//! | C_v5 | 0.47 | 0.47 |
//! | C_v6 | 0.47 | 0.12/(eps - 1.74) |
//! | C_v7 | 0.75 up to 1.5, then 0.125 sin(pi (eps - 2)) + 0.875 | the same up to 2.5, then 1 |

use std::f64::consts::PI;

/// Line load [N/m] at and above which the main resonance begins at N = 0.85.
const FULL_LOAD: f64 = 100e3;
/// N at the end of the main resonance, and at the beginning of the supercritical range.
const RESONANCE: [f64; 2] = [1.15, 1.5];

/// The quantities on which the factor K_v depends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InternalDynamics {
    /// Resonance ratio N \[1\].
    pub ratio: f64,
    /// Line load F_t K_A/b [N/m].
    pub line_load: f64,
    /// Stiffness of one tooth pair per face width, c' [Pa].
    pub single: f64,
    /// Total contact ratio eps \[1\].
    pub contact_ratio: f64,
    /// Effective base pitch deviation [m].
    pub pitch_deviation: f64,
    /// Effective profile form deviation [m].
    pub form_deviation: f64,
    /// Tip relief C_a [m].
    pub tip_relief: f64,
}

impl InternalDynamics {
    /// K_v \[1\].
    pub fn factor(&self) -> f64 {
        let [end, supercritical] = RESONANCE;
        let n = self.ratio;
        if n <= self.begin_of_resonance() {
            let [c1, c2, c3, ..] = self.coefficients();
            let [p, f, k] = self.parameters();
            n * (c1 * p + c2 * f + c3 * k) + 1.0
        } else if n <= end {
            self.in_resonance()
        } else if n < supercritical {
            let share = (supercritical - n) / (supercritical - end);
            share * self.in_resonance() + (1.0 - share) * self.above_resonance()
        } else {
            self.above_resonance()
        }
    }

    fn in_resonance(&self) -> f64 {
        let ([c1, c2, _, c4, ..], [p, f, k]) = (self.coefficients(), self.parameters());
        c1 * p + c2 * f + c4 * k + 1.0
    }

    fn above_resonance(&self) -> f64 {
        let ([.., c5, c6, c7], [p, f, _]) = (self.coefficients(), self.parameters());
        c5 * p + c6 * f + c7
    }

    /// N_S.
    fn begin_of_resonance(&self) -> f64 {
        if self.line_load >= FULL_LOAD { 0.85 } else { 0.5 + 0.35 * (self.line_load / FULL_LOAD).sqrt() }
    }

    /// B_p, B_f, B_k.
    fn parameters(&self) -> [f64; 3] {
        let of = |length: f64| self.single * length / self.line_load;
        [of(self.pitch_deviation), of(self.form_deviation), (1.0 - of(self.tip_relief)).abs()]
    }

    /// C_v1 to C_v7.
    fn coefficients(&self) -> [f64; 7] {
        let eps = self.contact_ratio;
        let c7 = match eps {
            _ if eps <= 1.5 => 0.75,
            _ if eps <= 2.5 => 0.125 * (PI * (eps - 2.0)).sin() + 0.875,
            _ => 1.0,
        };
        if eps <= 2.0 {
            return [0.32, 0.34, 0.23, 0.90, 0.47, 0.47, c7];
        }
        let c4 = (0.57 - 0.05 * eps) / (eps - 1.44);
        [0.32, 0.57 / (eps - 0.3), 0.096 / (eps - 1.56), c4, 0.47, 0.12 / (eps - 1.74), c7]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// c' = 14 N/(mm um), w = 200 N/mm, f_pb = 8 um, f_falpha = 6 um, C_a = 5 um: B_p = 0.56, B_f = 0.42, B_k = 0.65.
    const PAIR: InternalDynamics = InternalDynamics {
        ratio: 0.5,
        line_load: 200e3,
        single: 14e9,
        contact_ratio: 1.6,
        pitch_deviation: 8e-6,
        form_deviation: 6e-6,
        tip_relief: 5e-6,
    };

    fn is(pair: InternalDynamics, by_hand: f64) {
        assert!((pair.factor() - by_hand).abs() < 1e-4, "{pair:?}: {} instead of {by_hand}", pair.factor());
    }

    #[test]
    fn every_range_is_as_computed_by_hand() {
        // 0.5 (0.1792 + 0.1428 + 0.1495) + 1
        is(PAIR, 1.235_75);
        // 0.1792 + 0.1428 + 0.585 + 1
        is(InternalDynamics { ratio: 1.0, ..PAIR }, 1.907);
        // 0.2632 + 0.1974 + 0.125 sin(-0.4 pi) + 0.875 = 0.4606 - 0.118882 + 0.875
        is(InternalDynamics { ratio: 2.0, ..PAIR }, 1.216_718);
        // Half-way between 1.15 and 1.5.
        is(InternalDynamics { ratio: 1.325, ..PAIR }, 0.5 * (1.907 + 1.216_718));
        // eps = 2.2: C_v2 = 0.3, C_v3 = 0.15, so 0.5 (0.1792 + 0.126 + 0.0975) + 1
        is(InternalDynamics { contact_ratio: 2.2, ..PAIR }, 1.201_35);
        // C_v4 = 0.46/0.76 = 0.605263: 0.1792 + 0.126 + 0.393421 + 1
        is(InternalDynamics { contact_ratio: 2.2, ratio: 1.0, ..PAIR }, 1.698_621);
    }

    #[test]
    fn a_light_load_widens_the_resonance() {
        // w = 25 N/mm: N_S = 0.675.
        let light =
            InternalDynamics { line_load: 25e3, pitch_deviation: 0.0, form_deviation: 0.0, tip_relief: 0.0, ..PAIR };
        is(InternalDynamics { ratio: 0.67, ..light }, 1.0 + 0.67 * 0.23);
        is(InternalDynamics { ratio: 0.68, ..light }, 1.9);
    }
}
