//! Random numbers that are the same in every run and on every machine, and the settings of random work.

/// A deterministic sequence: a linear congruential generator with mixed output.
pub struct Noise(u64);

impl Noise {
    /// The sequence with this `seed`; the environment variable GEARSIM_SEED selects another sequence.
    pub fn new(seed: u64) -> Self {
        let mut noise = Noise(seed ^ setting("GEARSIM_SEED", 0).wrapping_mul(0x9e37_79b9_7f4a_7c15));
        noise.unit();
        noise
    }

    /// A number in 0..1.
    pub fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let mixed = (self.0 ^ (self.0 >> 33)).wrapping_mul(0xff51_afd7_ed55_8ccd);
        (mixed >> 11) as f64 / (1u64 << 53) as f64
    }

    /// A number in -1..1.
    pub fn even(&mut self) -> f64 {
        2.0 * self.unit() - 1.0
    }

    /// 10^x with x in `from`..`to`.
    pub fn power(&mut self, from: f64, to: f64) -> f64 {
        10f64.powf(from + (to - from) * self.unit())
    }

    /// One of 0..n.
    pub fn below(&mut self, n: usize) -> usize {
        (self.unit() * n as f64) as usize
    }
}

/// A whole number from the environment variable `name`, or `usual` if it is not set.
pub fn setting(name: &str, usual: u64) -> u64 {
    match std::env::var(name) {
        Ok(text) => text.parse().unwrap_or_else(|_| panic!("{name} must be a whole number, not {text}")),
        Err(_) => usual,
    }
}
