//! A derived model with a number for every parameter: its matrices, natural frequencies and energies.

use gearsim::__private::equations::{Derived, Equations};
use gearsim::model::Model;
use gearsim::scene::Effects;
use nalgebra::{DMatrix, DVector, SymmetricEigen};

/// The equations of a model, with a value for every law.
pub struct Train {
    pub model: Model,
    pub equations: Box<dyn Equations>,
    pub k: Vec<f64>,
}

/// The model `D` without effects, with `numbers`, given by name, for its parameters and laws; the other parameters have their defaults.
pub fn train<D: Derived>(numbers: &[(&str, f64)]) -> Train {
    train_with::<D>(&[], numbers)
}

/// The same with effects, each at all its parts.
pub fn train_with<D: Derived>(effects: &[&str], numbers: &[(&str, f64)]) -> Train {
    let model = D::MODEL;
    let given = |name: &str| numbers.iter().find(|n| n.0 == name).map(|n| n.1);
    let number = |name, default: Option<f64>| {
        given(name).or(default).unwrap_or_else(|| panic!("{}: no number for {name}", model.name))
    };
    let known =
        |name: &str| model.parameters.iter().any(|p| p.name == name) || model.laws.iter().any(|l| l.name == name);
    assert!(
        numbers.iter().all(|n| known(n.0)),
        "{}: a name in {numbers:?} is neither a parameter nor a law",
        model.name
    );
    let parameters: Vec<f64> =
        model.parameters.iter().map(|p| number(p.name, p.default.or(p.with.map(|_| f64::NAN)))).collect();
    let k = model.in_contact(model.laws.iter().map(|l| number(l.name, l.with.map(|_| 0.0))));
    let effects = Effects::from_names(effects.iter().copied(), &model).expect("effects of the model");
    let equations = D::equations(&effects, &parameters, &k).expect("effects that do not contradict");
    Train { model, equations, k }
}

impl Train {
    /// Natural frequencies [Hz], rising.
    pub fn frequencies(&self) -> Vec<f64> {
        frequencies(self.equations.mass(&vec![0.0; self.equations.coordinates()]), self.equations.stiffness(&self.k))
    }

    /// Kinetic energy with `x` as speeds, and strain energy with `x` as coordinates [J].
    pub fn energies(&self, x: &[f64]) -> [f64; 2] {
        [self.equations.kinetic(x, x), self.equations.potential(x, &self.k)]
    }
}

/// Natural frequencies [Hz] of M q'' + K q = 0, rising, by nalgebra's symmetric eigenvalues of L⁻¹ K L⁻ᵀ, M = L Lᵀ.
pub fn frequencies(mass: DMatrix<f64>, stiffness: DMatrix<f64>) -> Vec<f64> {
    let l = mass.cholesky().expect("M is positive definite").l();
    let half = l.solve_lower_triangular(&stiffness).expect("L is regular");
    let a = l.solve_lower_triangular(&half.transpose()).expect("L is regular");
    let values: DVector<f64> = SymmetricEigen::new((&a + a.transpose()) * 0.5).eigenvalues;
    let mut f: Vec<f64> = values.iter().map(|w| w.max(0.0).sqrt() / std::f64::consts::TAU).collect();
    f.sort_by(f64::total_cmp);
    f
}
