//! The right-hand side that methods integrate, smooth within a cell: q'' = M⁻¹F(q, q', k(s), dk/ds), and what damping takes.

use crate::engine::equations::Equations;
use crate::engine::law::Law;
use crate::methods::flow::Flow;

/// The equations of a scene with its laws where they stand.
pub struct Field<'a, const N: usize> {
    /// The equations.
    pub equations: &'a dyn Equations<N>,
    /// Where the stiffnesses stand.
    pub laws: Vec<Law<N>>,
    /// Time at which the present step begins \[s\].
    pub begins: f64,
    /// Evaluations of the right-hand side so far.
    pub evaluations: u64,
    /// Whether no law is curved: then k changes at events only.
    steps_only: bool,
    k: Vec<f64>,
    dk: Vec<f64>,
    ddk: Vec<f64>,
}

impl<'a, const N: usize> Field<'a, N> {
    /// The field of `equations` with `laws`.
    pub fn new(equations: &'a dyn Equations<N>, laws: Vec<Law<N>>) -> Self {
        let none = vec![0.0; laws.len()];
        let steps_only = laws.iter().all(|law| law.pitch.steps_only());
        let (k, dk, ddk) = (none.clone(), none.clone(), none);
        let mut field = Field { equations, laws, begins: 0.0, evaluations: 0, steps_only, k, dk, ddk };
        field.enter();
        field
    }

    /// Takes note that laws have gone on into other cells.
    pub fn enter(&mut self) {
        for (k, law) in self.k.iter_mut().zip(&self.laws) {
            *k = law.level();
        }
    }

    /// The laws' values at `y`, the time `t` after the step began.
    pub fn levels(&mut self, t: f64, y: &Flow<N>) -> &[f64] {
        self.set(t, y);
        &self.k
    }

    /// y' at `y`, the time `t` after the step began.
    #[inline]
    pub fn rate(&mut self, t: f64, y: &Flow<N>) -> Flow<N> {
        self.evaluations += 1;
        self.set(t, y);
        let a = self.equations.acceleration(&y.q.data.0[0], &y.v.data.0[0], &self.k, &self.dk);
        Flow { q: y.v, v: a.into(), lost: 2.0 * self.equations.dissipation(&y.v.data.0[0]) }
    }

    /// Derivatives of the accelerations by q and by q' (N x N each, row = equation).
    pub fn jacobian(&mut self, t: f64, y: &Flow<N>) -> [[[f64; N]; N]; 2] {
        self.set(t, y);
        self.equations.jacobian(&y.q.data.0[0], &y.v.data.0[0], &self.k, &self.dk, &self.ddk)
    }

    #[inline]
    fn set(&mut self, t: f64, y: &Flow<N>) {
        if self.steps_only {
            return;
        }
        for (i, law) in self.laws.iter().enumerate() {
            [self.k[i], self.dk[i], self.ddk[i]] = law.course(y.q[law.phase], self.begins + t);
        }
    }
}
