//! Random numbers that depend on a seed alone.

#![allow(dead_code)] // each test binary uses only some of these

/// Random numbers by Steele, Lea & Flood (2014), "splitmix". A fuzzer chooses the first ones, two bytes each.
pub struct Random(pub u64, Vec<u8>);

impl Random {
    /// The numbers of a seed.
    pub fn new(seed: u64) -> Random {
        Random(seed, vec![])
    }

    /// The numbers in `bytes`, and those of seed 0 after them.
    pub fn of_bytes(bytes: &[u8]) -> Random {
        Random(0, bytes.iter().rev().copied().collect())
    }

    pub fn next(&mut self) -> u64 {
        if let (Some(high), Some(low)) = (self.1.pop(), self.1.pop()) {
            // The two bytes are repeated in all digits, because `below` uses the low digits and `unit` the high ones.
            return 0x0001_0001_0001_0001 * u64::from(u16::from_be_bytes([high, low]));
        }
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let x = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        x ^ (x >> 31)
    }

    /// A number below `n`; 0 if `n` is 0.
    pub fn below(&mut self, n: usize) -> usize {
        (self.next() % n.max(1) as u64) as usize
    }

    /// A number in [0, 1).
    pub fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1u64 << 53) as f64
    }
}
