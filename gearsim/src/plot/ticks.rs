//! Layout of one axis: it maps data to positions between 0 and 1, and chooses the ticks and their numbers.

use super::figure::{Axis, Scale};

/// An axis with its limits and ticks chosen.
#[derive(Debug, Clone, PartialEq)]
pub struct Ruler {
    scale: Scale,
    /// Limits: in data units on a linear axis, log10 of the data on a logarithmic one.
    low: f64,
    high: f64,
    /// Distance between ticks, in the same unit as the limits.
    step: f64,
    /// The number shown at a tick is (value - offset) / 10^exponent.
    offset: f64,
    exponent: i32,
    /// Decimals of the numbers at the ticks.
    decimals: usize,
    /// Names shown at 0, 1, 2, ... instead of numbers; empty: numbers.
    names: Vec<String>,
}

impl Ruler {
    /// A ruler for `axis` over data between `extremes`, with about `count` ticks. If the axis has no range of its own,
    /// `margin`, a fraction of its length, is left free at both ends.
    pub fn new(axis: &Axis, extremes: (f64, f64), count: usize, margin: f64) -> Self {
        let scale = axis.scale;
        let ends = axis.range.unwrap_or(extremes);
        let (mut low, mut high) = (scaled(scale, ends.0), scaled(scale, ends.1));
        if !(low.is_finite() && high.is_finite()) {
            (low, high) = (0.0, 1.0);
        }
        let size = low.abs().max(high.abs());
        // A single value, or a range as narrow as rounding errors: show it in the middle.
        if high - low <= 1e-14 * size || high <= low {
            let half = if size > 0.0 { 0.05 * size } else { 1.0 };
            (low, high) = (low - half, high + half);
        } else if axis.range.is_none() {
            let free = margin * (high - low);
            (low, high) = (low - free, high + free);
        }

        let mut step = nice((high - low) / count as f64);
        if scale == Scale::Log10 {
            step = step.ceil();
        }
        let mut ruler =
            Ruler { scale, low, high, step, offset: 0.0, exponent: 0, decimals: 0, names: axis.names.clone() };
        if scale == Scale::Linear {
            ruler.shorten();
        }
        ruler
    }

    /// Chooses offset, exponent and decimals so that the tick numbers have few digits.
    fn shorten(&mut self) {
        let mut size = self.low.abs().max(self.high.abs());
        if size > 1e4 * self.step {
            self.offset = round_to(self.low, 10.0 * self.step);
            size = (self.low - self.offset).abs().max((self.high - self.offset).abs());
        }
        let magnitude = size.log10().floor() as i32;
        if !(-2..5).contains(&magnitude) {
            self.exponent = magnitude;
        }
        // A step of 2.5 needs one decimal more than its order of magnitude.
        let digits = self.step / 10f64.powi(self.exponent);
        self.decimals = (0..9)
            .find(|&d| {
                let scaled = digits * 10f64.powi(d);
                (scaled - scaled.round()).abs() < 1e-6
            })
            .unwrap_or(9) as usize;
    }

    /// Position of `x` on the axis: 0 at the low end, 1 at the high end. NaN where `x` has no logarithm.
    pub fn place(&self, x: f64) -> f64 {
        self.fraction(scaled(self.scale, x))
    }

    /// Positions of the ticks between 0 and 1, and the texts at them.
    pub fn ticks(&self) -> Vec<(f64, String)> {
        if !self.names.is_empty() {
            return self.names.iter().enumerate().map(|(i, name)| (self.fraction(i as f64), name.clone())).collect();
        }
        self.multiples(self.step).map(|x| (self.fraction(x), self.number(x))).collect()
    }

    /// Whether it shows names instead of numbers.
    pub fn is_named(&self) -> bool {
        !self.names.is_empty()
    }

    /// Positions of the minor ticks: whole decades on a logarithmic axis, a fifth of the tick distance on a linear one.
    pub fn minor(&self) -> Vec<f64> {
        if !self.names.is_empty() {
            return vec![];
        }
        let step = match self.scale {
            Scale::Log10 => 1.0,
            Scale::Linear => self.step / 5.0,
        };
        self.multiples(step).map(|x| self.fraction(x)).collect()
    }

    /// The axis label with offset, power of ten and unit: `energy U − 24 J [10⁻³ J]`.
    pub fn label(&self, axis: &Axis) -> String {
        let mut label = axis.label.clone();
        let unit = pretty_unit(&axis.unit);
        if self.offset != 0.0 {
            let sign = if self.offset < 0.0 { '+' } else { '−' };
            label += format!(" {sign} {} {unit}", self.offset.abs()).trim_end();
        }
        let power = if self.exponent == 0 { String::new() } else { power_of_ten(self.exponent) };
        match (power.is_empty(), unit.is_empty()) {
            (true, true) => label,
            (false, true) => format!("{label} / {power}"),
            _ => format!("{label} [{}]", format!("{power} {unit}").trim()),
        }
    }

    /// Length of one decade of a logarithmic axis, as a fraction of the axis.
    pub fn decade(&self) -> f64 {
        1.0 / (self.high - self.low)
    }

    fn multiples(&self, step: f64) -> impl Iterator<Item = f64> {
        let slack = 1e-9 * (self.high - self.low) / step;
        let (first, last) = ((self.low / step - slack).ceil(), (self.high / step + slack).floor());
        // At most 1000 ticks, even where the step is too small to change the value.
        let count = (last - first + 1.0).clamp(0.0, 1000.0) as usize;
        (0..count).map(move |i| (first + i as f64) * step)
    }

    /// Position of an already scaled value `x` on the axis, 0 to 1.
    fn fraction(&self, x: f64) -> f64 {
        (x - self.low) / (self.high - self.low)
    }

    fn number(&self, x: f64) -> String {
        if self.scale == Scale::Log10 {
            return power_of_ten(x.round() as i32);
        }
        let shown = (x - self.offset) / 10f64.powi(self.exponent);
        let number = format!("{shown:.*}", self.decimals);
        match number.strip_prefix('-') {
            Some(zero) if zero.chars().all(|c| "0.".contains(c)) => zero.to_owned(),
            Some(digits) => format!("−{digits}"),
            None => number,
        }
    }
}

/// `x` on a linear scale, log10(x) on a logarithmic one; NaN where there is no logarithm.
fn scaled(scale: Scale, x: f64) -> f64 {
    match scale {
        Scale::Linear => x,
        Scale::Log10 if x > 0.0 => x.log10(),
        Scale::Log10 => f64::NAN,
    }
}

/// The smallest of 1, 2, 2.5, 5, 10 times a power of ten that is at least `x`.
fn nice(x: f64) -> f64 {
    let power = 10f64.powi(x.log10().floor() as i32);
    let factor = [1.0, 2.0, 2.5, 5.0].into_iter().find(|f| f * power >= x * (1.0 - 1e-9));
    factor.unwrap_or(10.0) * power
}

/// The largest multiple of `unit` that is at most `x`, without trailing digits from rounding errors.
fn round_to(x: f64, unit: f64) -> f64 {
    let multiple = (x / unit).floor() * unit;
    let decimals = (1.0 - unit.log10().floor()).clamp(0.0, 300.0) as usize;
    format!("{multiple:.decimals$}").parse().unwrap_or(multiple)
}

fn power_of_ten(exponent: i32) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let raised = exponent
        .to_string()
        .chars()
        .map(|c| match c.to_digit(10) {
            Some(d) => DIGITS[d as usize],
            None => '⁻',
        })
        .collect::<String>();
    format!("10{raised}")
}

/// A unit as printed: `kg*m^2` becomes `kg m²`.
fn pretty_unit(unit: &str) -> String {
    if unit == "1" {
        return String::new();
    }
    unit.replace("^2", "²").replace("^3", "³").replace('*', " ")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn numbers(axis: &Axis, extremes: (f64, f64)) -> (Vec<String>, String) {
        let ruler = Ruler::new(axis, extremes, 5, 0.0);
        (ruler.ticks().into_iter().map(|t| t.1).collect(), ruler.label(axis))
    }

    #[test]
    fn ticks_are_round_and_short() {
        let t = Axis::linear("time t", "s");
        assert_eq!(numbers(&t, (0.0, 0.1)).0, ["0.00", "0.02", "0.04", "0.06", "0.08", "0.10"]);
        assert_eq!(numbers(&t, (-1.0, 1.0)).0, ["−1.0", "−0.5", "0.0", "0.5", "1.0"]);
    }

    #[test]
    fn small_numbers_get_a_power_of_ten_and_nearly_equal_numbers_get_an_offset() {
        let u = Axis::linear("U", "J");
        let (ticks, label) = numbers(&u, (-2e-14, 1e-14));
        assert_eq!(label, "U [10⁻¹⁴ J]");
        assert_eq!(ticks[0], "−2");
        let (ticks, label) = numbers(&u, (24.0, 24.00005));
        assert_eq!(label, "U − 24 J [10⁻⁵ J]");
        assert_eq!(ticks, ["0", "1", "2", "3", "4", "5"]);
    }

    #[test]
    fn ticks_of_logarithmic_axes_are_whole_decades() {
        let p = Axis::log10("PSD", "rad^2/Hz");
        let (ticks, label) = numbers(&p, (1e-20, 1e-5));
        assert_eq!(ticks, ["10⁻²⁰", "10⁻¹⁵", "10⁻¹⁰", "10⁻⁵"]);
        assert_eq!(label, "PSD [rad²/Hz]");
        assert!(Ruler::new(&p, (1e-20, 1.0), 5, 0.0).place(0.0).is_nan());
    }

    #[test]
    fn an_axis_has_ticks_for_equal_infinite_and_huge_limits() {
        let u = Axis::linear("U", "J");
        for extremes in [(0.0, 0.0), (7.0, 7.0), (f64::INFINITY, f64::NEG_INFINITY), (1e300, 1e300)] {
            let ruler = Ruler::new(&u, extremes, 5, 0.05);
            assert!((2..20).contains(&ruler.ticks().len()), "{ruler:?}");
        }
    }
}
