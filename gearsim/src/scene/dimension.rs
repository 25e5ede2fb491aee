//! Dimensions: powers of metre, kilogram, second and radian.

use std::fmt;

/// The physical dimension of a quantity: powers of the base units.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Dimension {
    /// Power of the metre.
    pub m: i32,
    /// Power of the kilogram.
    pub kg: i32,
    /// Power of the second.
    pub s: i32,
    /// Power of the radian. SI treats it as 1; here it distinguishes an angular speed from a frequency.
    pub rad: i32,
}

const NAMES: [(Dimension, &str); 18] = [
    (Dimension::NONE, "a plain number"),
    (Dimension::new(1, 0, 0, 0), "a length"),
    (Dimension::new(0, 1, 0, 0), "a mass"),
    (Dimension::new(0, 0, 1, 0), "a time"),
    (Dimension::new(0, 0, 0, 1), "an angle"),
    (Dimension::new(0, 0, -1, 0), "a frequency"),
    (Dimension::new(0, 0, -1, 1), "an angular speed"),
    (Dimension::new(0, 0, -2, 1), "an angular acceleration"),
    (Dimension::new(1, 0, -1, 0), "a speed"),
    (Dimension::new(1, 0, -2, 0), "an acceleration"),
    (Dimension::new(1, 1, -2, 0), "a force"),
    (Dimension::new(2, 1, -2, 0), "a torque or energy"),
    (Dimension::new(2, 1, -3, 0), "a power"),
    (Dimension::new(2, 1, 0, 0), "a moment of inertia"),
    (Dimension::new(2, 1, -1, 0), "a torsional damping"),
    (Dimension::new(0, 1, -2, 0), "a linear stiffness"),
    (Dimension::new(0, 1, -1, 0), "a linear damping"),
    (Dimension::new(-1, 1, -2, 0), "a pressure"),
];

impl Dimension {
    /// The dimension of a plain number.
    pub const NONE: Dimension = Dimension::new(0, 0, 0, 0);

    /// The dimension m^`m` kg^`kg` s^`s` rad^`rad`.
    pub const fn new(m: i32, kg: i32, s: i32, rad: i32) -> Dimension {
        Dimension { m, kg, s, rad }
    }

    /// This dimension times `factor`^`power`.
    pub fn times(self, factor: Dimension, power: i32) -> Dimension {
        Dimension {
            m: self.m + power * factor.m,
            kg: self.kg + power * factor.kg,
            s: self.s + power * factor.s,
            rad: self.rad + power * factor.rad,
        }
    }

    /// Whether a quantity of this dimension is accepted where `expected` is required.
    ///
    /// If mass or length is involved, the power of the radian is ignored, because both ways of writing are common (`N*m/rad` or `N*m` for a
    /// torsional stiffness). In dimensions of angle and time alone it must match: 1/s is not rad/s.
    pub fn fits(self, expected: Dimension) -> bool {
        let alone = self.m == 0 && self.kg == 0;
        (self.m, self.kg, self.s) == (expected.m, expected.kg, expected.s) && (!alone || self.rad == expected.rad)
    }

    /// Its name, e.g. "a torque or energy"; "measured in" its base units if it has no name.
    pub fn describe(self) -> String {
        match NAMES.iter().find(|(named, _)| self.fits(*named)) {
            Some((_, name)) => name.to_string(),
            None => format!("measured in {self}"),
        }
    }
}

impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let powers = [("kg", self.kg), ("m", self.m), ("s", self.s), ("rad", self.rad)];
        let term = |(name, power): (&str, i32)| match power {
            1 => name.to_string(),
            _ => format!("{name}^{power}"),
        };
        let above: Vec<_> = powers.into_iter().filter(|(_, power)| *power > 0).map(term).collect();
        write!(f, "{}", if above.is_empty() { "1".to_string() } else { above.join("*") })?;
        powers
            .into_iter()
            .filter(|(_, power)| *power < 0)
            .try_for_each(|(name, power)| write!(f, "/{}", term((name, -power))))
    }
}
