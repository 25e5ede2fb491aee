//! Time that loses no digits: the sum of many short flights, compensated.

/// A time as the unevaluated sum of two numbers [s].
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Clock {
    high: f64,
    low: f64,
}

impl Clock {
    /// Advances by `dt`. Knuth's two-sum (The Art of Computer Programming, vol. 2, 4.2.2).
    #[inline]
    pub fn advance(&mut self, dt: f64) {
        let dt = dt + self.low;
        let sum = self.high + dt;
        let part = sum - self.high;
        self.low = (self.high - (sum - part)) + (dt - part);
        self.high = sum;
    }

    /// Sets the clock to a time exactly.
    pub fn set(&mut self, t: f64) {
        *self = Clock { high: t, low: 0.0 };
    }

    /// The time, rounded [s].
    #[inline]
    pub fn now(&self) -> f64 {
        self.high
    }

    /// Time from now until `t` [s].
    #[inline]
    pub fn until(&self, t: f64) -> f64 {
        (t - self.high) - self.low
    }
}
