//! A train: parts along linear forms of the rotations of rotors.
//!
//! Each part is an element, a model of its own with a few coordinates x. Its equations are derived. Each x is a linear form of the rotations
//! of the rotors, and of motions along their axes, whose factors are products of powers of parameters: a base radius, a ratio of numbers of teeth.

use smallvec::SmallVec;

/// A product of powers of parameters.
#[derive(Debug, Clone, PartialEq)]
pub struct Factor {
    /// A number.
    pub number: f64,
    /// Parameters, by their index in the model, and their exponents.
    pub powers: SmallVec<[(usize, i32); 3]>,
}

/// A linear form of rotations: rotor and factor.
pub type RotationForm = Vec<(usize, Factor)>;

/// What a coordinate of a part is.
#[derive(Debug, Clone, PartialEq)]
pub enum Row {
    /// A coordinate of the train.
    Coordinate(usize),
    /// A linear form.
    Form(RotationForm),
}

/// A part of a train. Each list has, for everything that the element has, its index in the train.
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

/// What the engine puts together.
#[derive(Debug, Clone, PartialEq)]
pub struct Train {
    /// The linear forms that are the coordinates; as many as there are rotors that move independently.
    pub coordinates: Vec<RotationForm>,
    /// The parts.
    pub parts: Vec<Part>,
    /// For each rigid motion of unit size, independent forms and their values.
    pub motions: Vec<Vec<(RotationForm, f64)>>,
    /// Outputs that are products: the output, another output, and the displacement with whose rate that is multiplied.
    pub products: Vec<(usize, usize, RotationForm)>,
    /// Outputs that are multiples: the output, another output, and the factor.
    pub multiples: Vec<(usize, usize, Factor)>,
    /// Numbers of laws, torques and outputs of the train.
    pub counts: [usize; 3],
}
