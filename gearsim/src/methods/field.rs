//! The right-hand side that methods integrate, smooth within a cell: q'' = M⁻¹F(q, q', k(s), dk/ds, t), and what damping takes.

use crate::engine::cells;
use crate::engine::dead_band::{DeadBand, Elastic};
use crate::engine::equations::{Equations, accelerated};
use crate::engine::forcing::Forcing;
use crate::engine::law::Law;
use crate::engine::vector::{Matrix, Vector};
use crate::methods::flow::Flow;
use crate::model::Model;

/// The equations of a scene with its laws where they stand.
pub struct Field<'a> {
    /// The equations.
    pub equations: &'a dyn Equations,
    /// Where the stiffnesses stand.
    pub laws: Vec<Law>,
    /// Where the dead bands stand; what their dampers do is asked of each state.
    pub bands: Vec<DeadBand>,
    elastic: Vec<Elastic>,
    /// What varies in time, if anything does.
    pub forcing: Option<Box<Forcing>>,
    /// M⁻¹ (N x N).
    mobility: Matrix,
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

impl<'a> Field<'a> {
    /// The field of `equations` with `laws`.
    pub fn new(
        model: &Model,
        equations: &'a dyn Equations,
        (laws, bands): (Vec<Law>, Vec<DeadBand>),
        forcing: Option<Forcing>,
    ) -> Self {
        let none = vec![0.0; laws.len()];
        let in_contact = model.in_contact(none.iter().copied());
        let steps_only = laws.iter().all(|law| law.pitch.steps_only());
        let (k, dk, ddk) = (in_contact, none.clone(), none);
        let mut field = Field {
            equations,
            laws,
            bands,
            elastic: vec![],
            forcing: forcing.map(Box::new),
            mobility: equations.mobility(),
            begins: 0.0,
            evaluations: 0,
            steps_only,
            k,
            dk,
            ddk,
        };
        field.enter();
        field
    }

    /// Takes note that laws and dead bands have gone on into other cells.
    pub fn enter(&mut self) {
        cells::write(&self.laws, &mut self.bands, &mut self.k);
        self.stretch();
    }

    /// The contacts of the dead bands with the present stiffnesses.
    fn stretch(&mut self) {
        let (equations, k) = (self.equations, &self.k);
        self.elastic.clear();
        self.elastic.extend(self.bands.iter().map(|band| band.elastic(equations, k)));
    }

    /// The law values where they were last evaluated.
    pub fn k(&self) -> &[f64] {
        &self.k
    }

    /// The laws' values at `y`, the time `t` after the step began.
    pub fn levels(&mut self, t: f64, y: &Flow) -> &[f64] {
        self.set(t, y);
        &self.k
    }

    /// y' at `y`, the time `t` after the step began.
    #[inline]
    pub fn rate(&mut self, t: f64, y: &Flow) -> Flow {
        self.evaluations += 1;
        self.set(t, y);
        let mut force = self.equations.force(&y.q, &y.v, &self.k, &self.dk);
        if let Some(forcing) = &self.forcing {
            force += &forcing.load(self.begins + t);
        }
        let a: Vector = &self.mobility * &force;
        let dissipation = self.equations.dissipation(&y.v, &self.k);
        Flow { q: y.v.clone(), v: a, lost: 2.0 * dissipation + self.clipped(y) }
    }

    /// Derivatives of the accelerations by q and by q' (N x N each, row = equation).
    pub fn jacobian(&mut self, t: f64, y: &Flow) -> [Matrix; 2] {
        self.set(t, y);
        let of_force = self.equations.jacobian(&y.q, &y.v, &self.k, &self.dk, &self.ddk);
        accelerated(&self.mobility, of_force)
    }

    #[inline]
    fn set(&mut self, t: f64, y: &Flow) {
        if !self.steps_only {
            for (i, law) in self.laws.iter().enumerate() {
                [self.k[i], self.dk[i], self.ddk[i]] = law.course(y.q[law.phase], self.begins + t);
            }
            self.stretch();
        }
        for (band, elastic) in self.bands.iter_mut().zip(&self.elastic) {
            if wanders(band, &self.laws) {
                band.follow(&self.k);
                band.regime = band.met(&y.q);
            }
            band.regime = band.gripped(*elastic, &y.q, &y.v);
            band.write(&mut self.k);
        }
    }

    /// Power that the clipped dampers take at `y`, where the field was last evaluated \[W\].
    #[inline]
    fn clipped(&self, y: &Flow) -> f64 {
        self.bands.iter().zip(&self.elastic).map(|(band, elastic)| band.clipped_power(*elastic, &y.q, &y.v)).sum()
    }
}

/// Whether the edges of a dead band move along curves. Flanks then part and meet within steps, where their force has a kink,
/// for the control of the step to deal with.
pub fn wanders(band: &DeadBand, laws: &[Law]) -> bool {
    band.errors.iter().any(|&(law, _)| laws.get(law).is_some_and(|law| !law.pitch.steps_only()))
}
