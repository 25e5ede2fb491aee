//! Right-hand sides, generated and written by hand, evaluated many times at a state.

mod pair;
mod trains;

use gearsim::__private::equations::{Derived, Equations};
use gearsim::model::Model;
use gearsim::scene::Effects;

use crate::by_hand::ByHand;
use crate::paths::Job;

pub use pair::{exact, free, rigid, undamped, undeclared, with_error, with_friction, with_play};
pub use trains::{chain, idler, planetary};

/// One right-hand side, generated and written by hand, with the state at which both are evaluated.
pub struct Side<const N: usize> {
    pub generated: Box<dyn Equations>,
    pub by_hand: Box<dyn ByHand<N>>,
    q: [f64; N],
    q_dot: [f64; N],
    k: Vec<f64>,
    dk: Vec<f64>,
}

/// Number of evaluations that are counted.
const EVALUATIONS: u64 = 10_000;

impl<const N: usize> Side<N> {
    /// The job that evaluates the generated right-hand side.
    pub fn generated(self) -> Job {
        self.assert_agreement();
        let Side { generated, q, q_dot, k, dk, .. } = self;
        // As in [`ByHand`]: accelerations of a gear pair, but forces of a train.
        let mobility = generated.mobility(&vec![0.0; generated.coordinates()]);
        let force = move |q: &[f64; N], v: &[f64; N], k: &[f64], dk: &[f64]| {
            let mut force = [0.0; N];
            generated.write_force(q, v, k, dk, &mut force);
            force
        };
        match N {
            2 => evaluated(q, q_dot, k, dk, move |q, v, k, dk| {
                let force = force(q, v, k, dk);
                let mut acceleration = [0.0; N];
                for (i, a) in acceleration.iter_mut().enumerate() {
                    *a = mobility[(i, 0)] * force[0] + mobility[(i, 1)] * force[1];
                }
                acceleration
            }),
            _ => evaluated(q, q_dot, k, dk, force),
        }
    }

    /// The job that evaluates the right-hand side written by hand, through a pointer like the generated one.
    pub fn by_hand(self) -> Job {
        self.assert_agreement();
        let Side { by_hand, q, q_dot, k, dk, .. } = self;
        evaluated(q, q_dot, k, dk, move |q, v, k, dk| by_hand.evaluate(q, v, k, dk))
    }

    /// Panics if the two differ by more than 1e-12 of the largest component.
    fn assert_agreement(&self) {
        let Side { q, q_dot, k, dk, .. } = self;
        let by_hand = self.by_hand.evaluate(q, q_dot, k, dk);
        let generated = match N {
            2 => self.generated.acceleration(q, q_dot, k, dk),
            _ => self.generated.force(q, q_dot, k, dk),
        };
        let largest = by_hand.iter().fold(0.0f64, |largest, x| largest.max(x.abs()));
        let apart = by_hand.iter().zip(&*generated).fold(0.0f64, |apart, (a, b)| apart.max((a - b).abs()));
        assert!(apart <= 1e-12 * largest, "by hand {by_hand:?}, generated {generated:?}");
    }
}

/// The job that evaluates `f` repeatedly. Each state depends on the result before it, so that no evaluation can be left out.
fn evaluated<const N: usize>(
    mut q: [f64; N],
    mut q_dot: [f64; N],
    k: Vec<f64>,
    dk: Vec<f64>,
    f: impl Fn(&[f64; N], &[f64; N], &[f64], &[f64]) -> [f64; N] + 'static,
) -> Job {
    Box::new(move || {
        let (k, dk) = (std::hint::black_box(&k), std::hint::black_box(&dk));
        for _ in 0..EVALUATIONS {
            let a = f(&q, &q_dot, k, dk);
            (q[1], q_dot[1]) = (q[1] + 1e-12 * a[0], q_dot[1] + 1e-12 * a[1]);
        }
        std::hint::black_box((q, q_dot));
        EVALUATIONS
    })
}

/// The generated equations with `effects`, separated by spaces, and with parameters by name; others have their default or 1.
fn derived<D: Derived>(effects: &str, numbers: &[(&str, f64)], mids: &[f64]) -> Box<dyn Equations> {
    let model: &Model = &D::MODEL;
    let parameters = model.parameters.iter().map(|p| {
        let given = numbers.iter().find(|(name, _)| *name == p.name).map(|(_, x)| *x);
        given.or(p.default).unwrap_or(1.0)
    });
    let parameters: Vec<f64> = parameters.collect();
    let effects = Effects::from_names(effects.split_whitespace(), model).expect("effects of the model");
    D::equations(&effects, &parameters, mids).expect("effects that go together")
}
