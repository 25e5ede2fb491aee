//! Time without accumulated rounding errors: the sum of many short flights is a double-double number.

use xprec::Df64;

/// A time \[s\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Clock(pub Df64);

impl Default for Clock {
    fn default() -> Self {
        Clock(Df64::from(0.0))
    }
}

impl Clock {
    /// Advances by `dt` [s].
    #[inline]
    pub fn advance(&mut self, dt: impl Into<Df64>) {
        self.0 += dt.into();
    }

    /// Sets the clock to exactly `t` [s].
    pub fn set(&mut self, t: f64) {
        self.0 = Df64::from(t);
    }

    /// The time, rounded to f64 [s].
    #[inline]
    pub fn now(&self) -> f64 {
        self.0.hi()
    }

    /// Time from now until `t`, rounded to f64 [s]; infinite if `t` is.
    #[inline]
    pub fn until(&self, t: impl Into<Df64>) -> f64 {
        let t = t.into();
        if t.hi().is_finite() { self.exactly_until(t).hi() } else { t.hi() }
    }

    /// The same, with an error of two roundings, in two operations.
    #[inline]
    pub fn until_about(&self, t: f64) -> f64 {
        (t - self.0.hi()) - self.0.lo()
    }

    /// Time from now until `t`, in double-double precision [s].
    #[inline]
    pub fn exactly_until(&self, t: impl Into<Df64>) -> Df64 {
        t.into() - self.0
    }
}
