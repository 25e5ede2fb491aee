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
    /// x, x' and the values of each part from its place on; x is NaN until an output of the part is computed. After them the outputs,
    /// NaN until they are computed.
    numbers: Vec<f64>,
    /// Where the outputs begin.
    first_output: usize,
}

impl<'a> Observer<'a> {
    pub fn new(assembly: &'a Assembly, state: [&'a [f64]; 3], known: &'a Known) -> Self {
        let first_output = assembly.parts.last().map_or(0, |last| last.place + last.numbers());
        let numbers = vec![f64::NAN; first_output + assembly.outputs.len()];
        Observer { assembly, state, known, nothing: Known::default(), numbers, first_output }
    }

    /// The output `i`.
    pub fn output(&mut self, i: usize) -> f64 {
        let value = match &self.assembly.outputs[i] {
            Observed::One(of) => self.of_part(of),
            Observed::Sum(parts) => parts.iter().map(|of| self.of_part(of)).sum(),
            Observed::Product(of, speed) => self.computed(*of) * speed.dot(self.state[1]),
            Observed::Multiple(of, factor) => factor * self.computed(*of),
        };
        self.numbers[self.first_output + i] = value;
        value
    }

    /// The output `i`, which may be computed already.
    fn computed(&mut self, i: usize) -> f64 {
        let value = self.numbers[self.first_output + i];
        if value.is_nan() { self.output(i) } else { value }
    }

    // Inlined into `output`, because a part has many outputs: a separate call takes a fifth more instructions.
    #[inline(always)]
    fn of_part(&mut self, of: &OfPart) -> f64 {
        let p = &self.assembly.parts[of.part];
        let numbers = &mut self.numbers[p.place..p.place + p.numbers()];
        if numbers[0].is_nan() {
            p.localise(self.state, numbers);
        }
        let [x, x_dot, values] = p.split(numbers);
        if of.known {
            return self.assembly.known_output(of, [x, x_dot, values], self.known);
        }
        p.equations.output(of.output, x, x_dot, values, &self.nothing)
    }
}

impl Assembly {
    /// An output that depends on the reactions of switches and the powers of torques of its part. It is not inlined, because such outputs
    /// are few and the copies of these numbers would need stack space for every output.
    #[inline(never)]
    fn known_output(&self, of: &OfPart, [x, x_dot, values]: [&[f64]; 3], known: &Known) -> f64 {
        let p = &self.parts[of.part];
        let first = self.switches.partition_point(|switch| switch[0] < of.part);
        let mut own = Known::default();
        (first..first + p.part.switches).for_each(|switch| own.reactions.push(known.reaction(switch)));
        p.part.torques.iter().for_each(|&torque| own.powers.push(known.power(torque)));
        p.equations.output(of.output, x, x_dot, values, &own)
    }
}
