//! A train: parts whose coordinates are linear forms of the rotations of rotors.
//!
//! Each part is an element: a derived model with a few coordinates x. Each x is a linear form of the rotations of the rotors and of their
//! axial motions. The factors of this form are products of powers of parameters. Examples: a base radius, a ratio of numbers of teeth.

use smallvec::SmallVec;

/// A product of powers of parameters.
#[derive(Debug, Clone, PartialEq)]
pub struct Factor {
    /// A number.
    pub number: f64,
    /// Parameters, by their index in the model, and their exponents.
    pub powers: SmallVec<[(usize, i32); 3]>,
}

/// A linear form of rotations: the terms, each with the index of its rotor and its factor.
pub type RotationForm = Vec<(usize, Factor)>;

/// A coordinate of a part, in terms of the train.
#[derive(Debug, Clone, PartialEq)]
pub enum Row {
    /// A coordinate of the train.
    Coordinate(usize),
    /// A linear form of the rotations.
    Form(RotationForm),
}

/// A part of a train. Its lists have one entry for each parameter, effect, law, torque and so on of the element: the index of this item in
/// the train.
#[derive(Debug, Clone, PartialEq)]
pub struct Part {
    /// Index of the element.
    pub element: usize,
    /// The coordinates of the element.
    pub rows: Vec<Row>,
    /// Parameters; `None` for those that are zero in the train: test inertias, and parameters of effects that it does not have.
    pub parameters: Vec<Option<usize>>,
    /// Effects; `None` for those that the train does not have.
    pub effects: Vec<Option<usize>>,
    /// Laws, then the symbols of switches: places in the vector of law values.
    pub values: Vec<usize>,
    /// Number of laws among `values`.
    pub laws: usize,
    /// Number of switches.
    pub switches: usize,
    /// Torques.
    pub torques: Vec<usize>,
    /// Outputs.
    pub outputs: Vec<usize>,
}

/// A train, from which the engine assembles the equations.
#[derive(Debug, Clone, PartialEq)]
pub struct Train {
    /// The linear forms that are the coordinates of the train: as many as there are rotors that move independently.
    pub coordinates: Vec<RotationForm>,
    /// The parts.
    pub parts: Vec<Part>,
    /// For each rigid motion of unit size: independent linear forms, each with its value in this motion.
    pub motions: Vec<Vec<(RotationForm, f64)>>,
    /// Outputs that are products: the index of the output, and its factors: another output, and the rate of a displacement.
    pub products: Vec<(usize, usize, RotationForm)>,
    /// Outputs that are multiples of another output: the index of the output, that of the other output, and the factor.
    pub multiples: Vec<(usize, usize, Factor)>,
    /// Numbers of laws, torques and outputs of the train.
    pub counts: [usize; 3],
}
