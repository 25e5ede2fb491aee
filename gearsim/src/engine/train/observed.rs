//! The outputs of a train.

use super::Assembly;
use super::linear::Sparse;
use crate::engine::equations::Known;

/// How an output is computed.
pub(super) enum Observed {
    /// An output of a part.
    One(OfPart),
    /// The sum of outputs of parts.
    Sum(Vec<OfPart>),
    /// Another output, times a speed.
    Product(usize, Sparse),
    /// Another output, times a factor.
    Multiple(usize, f64),
}

/// An output of a part.
pub(super) struct OfPart {
    pub part: usize,
    /// Its number among the outputs of the part.
    pub output: usize,
    /// Whether it depends on reactions and powers.
    pub known: bool,
}

/// A state of a train, at which outputs are computed.
pub(super) struct Observer<'a> {
    assembly: &'a Assembly,
    /// q, q' and the values of laws and symbols.
    state: [&'a [f64]; 3],
    known: &'a Known,
    /// For outputs that need no reactions and powers.
    nothing: Known,
    /// x, x' and the values of each part from its place on; x is NaN until an output of the part is computed.
    numbers: Vec<f64>,
}

impl<'a> Observer<'a> {
    pub fn new(assembly: &'a Assembly, state: [&'a [f64]; 3], known: &'a Known) -> Self {
        let numbers = assembly.parts.last().map_or(0, |last| last.place + last.numbers());
        Observer { assembly, state, known, nothing: Known::default(), numbers: vec![f64::NAN; numbers] }
    }

    /// The output `i`.
    pub fn output(&mut self, i: usize) -> f64 {
        match &self.assembly.outputs[i] {
            Observed::One(of) => self.of_part(of),
            Observed::Sum(parts) => parts.iter().map(|of| self.of_part(of)).sum(),
            Observed::Product(of, speed) => self.output(*of) * speed.dot(self.state[1]),
            Observed::Multiple(of, factor) => factor * self.output(*of),
        }
    }

    fn of_part(&mut self, of: &OfPart) -> f64 {
        let p = &self.assembly.parts[of.part];
        let numbers = &mut self.numbers[p.place..p.place + p.numbers()];
        if numbers[0].is_nan() {
            p.localise(self.state, numbers);
        }
        let [x, x_dot, values] = p.split(numbers);
        let known = if of.known { &self.assembly.known_to(of.part, self.known) } else { &self.nothing };
        p.equations.output(of.output, x, x_dot, values, known)
    }
}

impl Assembly {
    /// What is known of the switches and the torques of a part.
    fn known_to(&self, part: usize, known: &Known) -> Known {
        let p = &self.parts[part];
        let first = self.switches.partition_point(|of| of[0] < part);
        Known {
            reactions: (first..first + p.part.switches).map(|switch| known.reaction(switch)).collect(),
            powers: p.part.torques.iter().map(|&torque| known.power(torque)).collect(),
        }
    }
}
