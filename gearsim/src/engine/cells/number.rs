//! The number of a cell. A train with many effects has more cells than a machine word has values.

use std::fmt;

use smallvec::{SmallVec, smallvec};

use crate::engine::law::LawState;
use crate::engine::switch::Switch;

/// The number of a cell, in a mixed radix. The digits are the cell indices of the laws, then the modes of the switches; the first digit
/// varies fastest. The number is stored in words, each with as many digits as fit.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Number(SmallVec<[u64; 2]>);

impl Number {
    /// The number of the cell of these laws and switches.
    #[inline]
    pub fn of(laws: &[LawState], switches: &[Switch]) -> Self {
        Self::with(laws, switches, |law| laws[law].cell)
    }

    /// The same with the laws in the given cells.
    #[inline]
    pub fn with(laws: &[LawState], switches: &[Switch], cell: impl Fn(usize) -> usize) -> Self {
        let of_laws = laws.iter().enumerate().map(|(i, law)| (cell(i), law.pitch.cells()));
        Self::from_digits(of_laws.chain(switches.iter().map(|switch| (switch.mode, switch.modes()))))
    }

    /// The number with these digits. Each digit comes with the number of values that it can have.
    #[inline]
    fn from_digits(digits: impl Iterator<Item = (usize, usize)>) -> Self {
        let (mut words, mut last, mut scale) = (SmallVec::new(), 0, 1u64);
        for (digit, values) in digits {
            let (digit, values) = (digit as u64, values as u64);
            let (place, next) = match scale.checked_mul(values) {
                Some(next) => (scale, next),
                None => {
                    words.push(std::mem::take(&mut last));
                    (1, values)
                }
            };
            last += digit * place;
            scale = next;
        }
        words.push(last);
        Number(words)
    }

    /// The number as an index into the list of all cells. It must fit into one word.
    #[inline]
    pub fn index(&self) -> usize {
        self.0[0] as usize
    }
}

impl From<u64> for Number {
    fn from(number: u64) -> Self {
        Number(smallvec![number])
    }
}

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let words: Vec<_> = self.0.iter().map(u64::to_string).collect();
        f.write_str(&words.join("."))
    }
}

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use super::Number;

    #[test]
    fn the_first_digit_varies_fastest() {
        assert_eq!(Number::from_digits([(1, 2), (2, 3), (4, 5)].into_iter()), Number::from(1 + 2 * (2 + 3 * 4)));
        assert_eq!(Number::from_digits(std::iter::empty()).index(), 0);
    }

    /// Seven to the power of 40 is about 2^112.
    #[test]
    fn numbers_larger_than_one_word_differ() {
        let alone = |place: usize, digit: usize| {
            Number::from_digits((0..40).map(move |i| (if i == place { digit } else { 0 }, 7)))
        };
        let numbers: HashSet<_> = (0..40).flat_map(|place| (1..7).map(move |digit| alone(place, digit))).collect();
        assert_eq!(numbers.len(), 40 * 6);
        let last = Number::from_digits((0..40).map(|_| (6, 7)));
        assert_eq!(last.to_string(), format!("{}.{}", 7u64.pow(22) - 1, 7u64.pow(18) - 1));
    }
}
