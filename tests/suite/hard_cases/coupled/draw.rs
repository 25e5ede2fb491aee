//! A random cell whose damping couples its coordinates: inertias with springs and dampers between them and to the ground.

use crate::linear::Linear;
use crate::noise::Noise;

/// A cell and its start.
#[derive(Debug, Clone)]
pub struct Drawn<const N: usize> {
    pub system: Linear<N>,
    pub q: [f64; N],
    pub v: [f64; N],
    /// Length of the flight [s].
    pub t: f64,
    /// How much the cell amplifies the rounding errors of its matrices. It is the larger of two factors. The first is the square root of a
    /// product: the largest ratio of inertias times the largest ratio of stiffnesses. The second is the rate of the strongest damper over the
    /// rate of a vibration.
    condition: f64,
}

impl<const N: usize> Drawn<N> {
    /// Draws a cell.
    pub fn new(noise: &mut Noise) -> Self {
        let unit = noise.power(-2.0, 2.0);
        let spread = 3.0 * noise.unit();
        let inertias = [(); N].map(|()| noise.power(-0.5 * spread, 0.5 * spread));
        let mut mass = [[0.0; N]; N];
        (0..N).for_each(|i| mass[i][i] = inertias[i]);
        // Springs in a chain, and some between other coordinates. A third of all cells have no spring to the ground.
        let mut stiffness = [[0.0; N]; N];
        let (mut stiffest, mut softest) = (0f64, f64::INFINITY);
        let grounded = noise.below(3) > 0;
        for i in 0..N {
            for j in i + 1..N {
                if j == i + 1 || noise.below(3) == 0 {
                    let k = unit * unit * noise.power(-0.5 * spread, 0.5 * spread);
                    (stiffest, softest) = (stiffest.max(k), softest.min(k));
                    between(&mut stiffness, i, j, k);
                }
            }
            if grounded && (i == 0 || noise.below(2) == 0) {
                let k = unit * unit * noise.power(-0.5 * spread, 0.5 * spread);
                (stiffest, softest) = (stiffest.max(k), softest.min(k));
                stiffness[i][i] += k;
            }
        }
        // Dampers: only weak ones, or any strength up to far above critical.
        let strength = [(-4.0, -2.0), (-2.0, 0.0), (-1.0, 1.0), (-3.0, 2.0)][noise.below(4)];
        let mut damping = [[0.0; N]; N];
        for _ in 0..1 + noise.below(N) {
            let (i, j) = (noise.below(N), noise.below(N));
            let c = unit * noise.power(strength.0, strength.1);
            if i == j || noise.below(4) == 0 {
                damping[i][i] += c;
            } else {
                between(&mut damping, i, j, c);
            }
        }
        let load = [(); N].map(|()| if noise.below(3) == 0 { unit * unit * noise.even() } else { 0.0 });
        let heaviest = inertias.iter().copied().fold(0.0, f64::max);
        let damper = (0..N).map(|i| damping[i][i] / mass[i][i]).fold(0.0, f64::max);
        Drawn {
            system: Linear { mass, damping, stiffness, load, normal: [1.0; N] },
            q: [(); N].map(|()| noise.even()),
            v: [(); N].map(|()| unit * noise.even()),
            t: noise.power(-2.0, 2.0) / unit,
            condition: (10f64.powf(spread) * stiffest / softest).sqrt().max(damper * (heaviest / softest).sqrt()),
        }
    }

    /// Draws a wheel of N - 1 equal masses on a hub, with equal springs to the hub and the ground and dampers beside them. A damper of any
    /// strength acts on the hub. The motions in which the hub rests have equal frequencies, and the damper does not act on them.
    pub fn wheel(noise: &mut Noise) -> Self {
        let (mut mass, mut stiffness, mut damping) = ([[0.0; N]; N], [[0.0; N]; N], [[0.0; N]; N]);
        let [rim, spoke, ground] = [(); 3].map(|()| noise.power(-1.0, 1.0));
        let ground = if noise.below(2) == 0 { 0.0 } else { ground };
        let per_stiffness = noise.power(-4.0, -1.0);
        mass[0][0] = noise.power(-1.0, 1.0);
        damping[0][0] = noise.power(-4.0, 6.0);
        for i in 1..N {
            mass[i][i] = rim;
            between(&mut stiffness, 0, i, spoke);
            stiffness[i][i] += ground;
            between(&mut damping, 0, i, per_stiffness * spoke);
            damping[i][i] += per_stiffness * ground;
        }
        Drawn {
            system: Linear { mass, damping, stiffness, load: [(); N].map(|()| noise.even()), normal: [1.0; N] },
            q: [(); N].map(|()| noise.even()),
            v: [(); N].map(|()| noise.even()),
            t: noise.power(-1.0, 1.0),
            condition: 1.0 + damping[0][0] / mass[0][0] * (rim / spoke).sqrt(),
        }
    }

    /// The error divided by the factor by which rounding errors are amplified.
    pub fn judged(&self, error: f64) -> f64 {
        let judged = error / self.amplified();
        if judged.is_nan() || judged >= 1e3 {
            println!("{judged:e}: {self:?}");
        }
        judged
    }

    /// How much the motion amplifies rounding errors. Let c be the condition number of the modes. The phase of a mode has an error of c
    /// roundings, and a mode can be c times as large as the motion: together c².
    fn amplified(&self) -> f64 {
        self.condition * self.system.cell().coupling.map_or(1.0, |coupling| coupling.condition).powi(2)
    }

    /// A bound on the relative error of the motion.
    pub fn slack(&self) -> f64 {
        let rate = self.system.cell().rate;
        1e3 * f64::EPSILON * self.amplified() * (1.0 + rate * self.t)
    }
}

/// Adds a spring or damper between two coordinates. Its last 26 bits are zero, so that the sum of each row is exact. Otherwise rounding errors
/// would act as springs on rigid motions.
fn between<const N: usize>(a: &mut [[f64; N]; N], i: usize, j: usize, k: f64) {
    let k = f64::from_bits(k.to_bits() >> 26 << 26);
    a[i][i] += k;
    a[j][j] += k;
    a[i][j] -= k;
    a[j][i] -= k;
}
