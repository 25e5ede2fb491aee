//! The quadratic forms of the energies of a mode. A part of a drivetrain acts on few coordinates, so that its form has few elements.

use nalgebra::{Complex, DMatrix, DVector};

use super::Parts;

/// The elements of a symmetric matrix that are not zero.
pub(super) struct SymmetricForm(Vec<(usize, usize, f64)>);

impl SymmetricForm {
    pub fn of(matrix: &DMatrix<f64>) -> SymmetricForm {
        let (rows, columns) = matrix.shape();
        let elements = (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j)));
        SymmetricForm(elements.map(|(i, j)| (i, j, matrix[(i, j)])).filter(|(.., x)| *x != 0.0).collect())
    }

    /// phi* A phi.
    pub fn energy(&self, shape: &DVector<Complex<f64>>) -> f64 {
        self.0.iter().map(|&(i, j, a)| a * (shape[i].conj() * shape[j]).re).sum()
    }
}

/// The quadratic forms of the laws, springs and inertias that have shares in the energies of the modes.
pub(super) struct Forms {
    pub laws: Vec<SymmetricForm>,
    pub springs: Vec<SymmetricForm>,
    pub masses: Vec<SymmetricForm>,
}

impl Forms {
    /// The forms of `parts`, and of `laws`: the parts of K that come from the laws.
    pub fn of(laws: &[DMatrix<f64>], parts: &Parts) -> Forms {
        Forms {
            laws: laws.iter().map(SymmetricForm::of).collect(),
            springs: parts.springs.iter().map(|spring| SymmetricForm::of(&spring.stiffness)).collect(),
            masses: parts.masses.iter().map(|mass| SymmetricForm::of(&mass.inertia)).collect(),
        }
    }
}
