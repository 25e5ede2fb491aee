//! The work of torques that vary, within a step.
//!
//! The power P of a torque is evaluated at the nodes s_i of Gauss's rule with six points, weights w_i, from the start of the step to an
//! end T. The polynomial through these values is sum c_j L_j(u) with Legendre polynomials L_j, u = 2 t/T - 1 and
//! c_j = (2j + 1)/2 sum w_i P(s_i) L_j(u_i). Its integral is known at every time of the step, so the power need not be evaluated again for
//! samples:
//!
//! ```text
//! W(t) = T/2 (d_0 (1 + u) + sum_{j > 0} d_j (L_{j+1}(u) - L_{j-1}(u))),     d_j = c_j/(2j + 1)
//! ```
//!
//! At T the integral equals Gauss's rule, which is exact for polynomials up to degree 11. Its error is far below that of the step: the
//! motion has at most order 8. Before T it is the integral of a polynomial of degree 5 in t.

use std::array::from_fn;
use std::sync::LazyLock;

use smallvec::SmallVec;

/// Nodes and weights of Gauss's rule with six points on [-1, 1], positive half (Abramowitz & Stegun, Table 25.4).
const GAUSS_6: [(f64, f64); 3] = [
    (0.238_619_186_083_196_9, 0.467_913_934_572_691),
    (0.661_209_386_466_264_5, 0.360_761_573_048_138_6),
    (0.932_469_514_203_152, 0.171_324_492_379_170_36),
];
/// Number of nodes.
const NODES: usize = 6;

/// For each node: u_i, and w_i L_j(u_i)/2.
static RULE: LazyLock<[(f64, [f64; NODES]); NODES]> = LazyLock::new(|| {
    from_fn(|i| {
        let (node, weight) = GAUSS_6[i / 2];
        let node = if i % 2 == 0 { -node } else { node };
        let legendre = legendre(node);
        (node, from_fn(|j| 0.5 * weight * legendre[j]))
    })
});

/// The work of each torque along a part of a step.
#[derive(Debug, Clone)]
pub struct Work {
    /// Length T of the part \[s\].
    length: f64,
    /// d_j of each torque \[W\] (n_torques).
    series: SmallVec<[[f64; NODES]; 4]>,
}

impl Work {
    /// The work of `torques` torques up to the time `length` \[s\]; `write_power` writes their powers at a time \[W\] (n_torques).
    pub fn new(length: f64, torques: usize, mut write_power: impl FnMut(f64, &mut [f64])) -> Self {
        let mut series: SmallVec<[[f64; NODES]; 4]> = SmallVec::from_elem([0.0; NODES], torques);
        let mut powers: SmallVec<[f64; 12]> = SmallVec::from_elem(0.0, torques);
        if torques > 0 && length > 0.0 {
            for (node, factors) in &*RULE {
                write_power(0.5 * length * (1.0 + node), &mut powers);
                let (series, powers) = (&mut series[..], &powers[..torques]);
                for i in (0..torques).filter(|i| powers[*i] != 0.0) {
                    for j in 0..NODES {
                        series[i][j] += powers[i] * factors[j];
                    }
                }
            }
        }
        Work { length, series }
    }

    /// The work of each torque until the time `t` \[J\] (n_torques).
    pub fn until(&self, t: f64) -> Vec<f64> {
        if self.series.is_empty() || self.length <= 0.0 {
            return vec![0.0; self.series.len()];
        }
        let u = 2.0 * t / self.length - 1.0;
        let legendre = legendre(u);
        let rises: [f64; NODES] = from_fn(|j| if j == 0 { 1.0 + u } else { legendre[j + 1] - legendre[j - 1] });
        let sum = |series: &[f64; NODES]| series.iter().zip(rises).map(|(d, rise)| d * rise).sum::<f64>();
        self.series.iter().map(|series| 0.5 * self.length * sum(series)).collect()
    }
}

/// L_0 to L_6 at `u`, by their recurrence.
fn legendre(u: f64) -> [f64; NODES + 1] {
    let mut l = [1.0; NODES + 1];
    l[1] = u;
    for j in 1..NODES {
        let n = j as f64;
        l[j + 1] = ((2.0 * n + 1.0) * u * l[j] - n * l[j - 1]) / (n + 1.0);
    }
    l
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The work is exact at every time if the power is a polynomial of degree 5, and at the end if its degree is 11.
    #[test]
    fn work_is_exact_to_the_degree_of_the_rule() {
        let length = 0.3;
        let [fifth, last] = [5, 11].map(|degree| {
            let power = move |t: f64| (t / length).powi(degree);
            (degree, Work::new(length, 2, |t, powers| powers.copy_from_slice(&[1.0, power(t)])))
        });
        let exact = |degree: i32, t: f64| length * (t / length).powi(degree + 1) / f64::from(degree + 1);
        for t in [0.0, 0.05, 0.1, 0.2, 0.3] {
            let [constant, work] = fifth.1.until(t)[..] else { panic!("two torques") };
            assert!((constant - t).abs() < 2e-16 && (work - exact(fifth.0, t)).abs() < 2e-16, "{t}: {work:e}");
        }
        assert!((last.1.until(length)[1] - exact(last.0, length)).abs() < 2e-16);
        assert!((last.1.until(0.15)[1] - exact(last.0, 0.15)).abs() > 1e-9, "degree 11 is beyond the polynomial");
    }

    /// Without varying torques, and in a step of length zero, the power is not evaluated.
    #[test]
    fn without_torques_nothing_is_evaluated() {
        let work = Work::new(1.0, 0, |_, _| panic!("there is no torque"));
        assert!(work.until(0.5).is_empty());
        assert_eq!(Work::new(0.0, 1, |_, _| panic!("the step has no length")).until(0.0), [0.0]);
    }
}
