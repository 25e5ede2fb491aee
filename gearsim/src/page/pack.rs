//! Packs counts into few bits. Neighbouring counts of a smooth curve differ little, and neighbouring differences even less.
//!
//! Counts are packed in groups of [`GROUP`]. A group begins with a byte: its two highest bits hold the order of the differences, the others
//! the number of bits of an entry. The entries follow: for order 0 the counts c\[i\], for order 1 c\[i\] - c\[i-1\], for order 2 c\[i\] - 2
//! c\[i-1\] + c\[i-2\]. The counts before the first one are 0. A difference d is stored as 2 d, or as -2 d - 1 if it is negative. The
//! lowest bits come first; the last byte of a group is filled with zeros. `assets/data.js` has the inverse.

/// Counts in a group.
pub const GROUP: usize = 64;

/// Bits of an entry at most.
const MOST: u32 = 32;

/// Appends the packed counts to `bytes`.
pub fn pack(counts: &[u32], bytes: &mut Vec<u8>) {
    let [mut last, mut last_but_one] = [0, 0];
    for group in counts.chunks(GROUP) {
        let mut entries = [[0; GROUP]; 3];
        let mut all = [0; 3];
        for (i, &count) in group.iter().enumerate() {
            let count = i64::from(count);
            let of_orders = [count as u64, unsigned(count - last), unsigned(count - 2 * last + last_but_one)];
            [last, last_but_one] = [count, last];
            for (order, entry) in of_orders.into_iter().enumerate() {
                entries[order][i] = entry;
                all[order] |= entry;
            }
        }
        let widths = all.map(|all: u64| u64::BITS - all.leading_zeros());
        // Differences may need more bits than the counts, which always fit.
        let order = (0..3).filter(|&order| widths[order] <= MOST).min_by_key(|&order| widths[order]).unwrap_or(0);
        bytes.push((order as u8) << 6 | widths[order] as u8);
        write(&entries[order][..group.len()], widths[order], bytes);
    }
}

/// A difference d as a number without a sign: 2 d, or -2 d - 1 if it is negative.
fn unsigned(difference: i64) -> u64 {
    (difference << 1 ^ difference >> 63) as u64
}

fn write(entries: &[u64], width: u32, bytes: &mut Vec<u8>) {
    let (mut open, mut length) = (0_u64, 0);
    for entry in entries {
        open |= entry << length;
        length += width;
        while length >= 8 {
            bytes.push(open as u8);
            open >>= 8;
            length -= 8;
        }
    }
    if length > 0 {
        bytes.push(open as u8);
    }
}

/// The inverse of [`pack`], as `assets/data.js` has it: `length` counts.
#[cfg(test)]
pub fn unpack(mut bytes: &[u8], length: usize) -> Vec<u32> {
    let mut counts: Vec<u32> = vec![];
    while counts.len() < length {
        let (order, width) = (bytes[0] >> 6, usize::from(bytes[0] & 63));
        bytes = &bytes[1..];
        let in_group = GROUP.min(length - counts.len());
        let bit = |i: usize| u64::from(bytes[i / 8] >> (i % 8) & 1);
        for i in 0..in_group {
            let entry = (0..width).fold(0, |entry, b| entry | bit(i * width + b) << b);
            let difference = (entry >> 1) as i64 ^ -((entry & 1) as i64);
            let before = |n: usize| counts.len().checked_sub(n).map_or(0, |i| i64::from(counts[i]));
            counts.push(match order {
                0 => entry as u32,
                1 => (before(1) + difference) as u32,
                _ => (2 * before(1) - before(2) + difference) as u32,
            });
        }
        bytes = &bytes[(in_group * width).div_ceil(8)..];
    }
    assert!(bytes.is_empty());
    counts
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bits(counts: &[u32]) -> f64 {
        let mut bytes = vec![];
        pack(counts, &mut bytes);
        assert_eq!(unpack(&bytes, counts.len()), counts);
        8.0 * bytes.len() as f64 / counts.len().max(1) as f64
    }

    #[test]
    fn all_counts_come_back() {
        assert_eq!(bits(&[]), 0.0);
        for counts in [vec![0], vec![u32::MAX], vec![0, u32::MAX, 0, 1, u32::MAX - 1], (0..200).collect::<Vec<_>>()] {
            bits(&counts);
        }
        // Lengths near multiples of a group. The differences of random counts need more bits than the counts: only order 0 can store them.
        for length in [1, 63, 64, 65, 127, 128, 129] {
            let mut x = 1_u32;
            let random = |_| {
                x = x.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                x
            };
            let counts: Vec<u32> = (0..length).map(random).collect();
            for shift in [0, 1, 8, 16, 31] {
                bits(&counts.iter().map(|x| x >> shift).collect::<Vec<_>>());
            }
        }
    }

    #[test]
    fn smooth_counts_need_few_bits() {
        let wave = |i: u32| (32_767.0 * (1.0 + (0.01 * f64::from(i)).sin())) as u32;
        assert!(bits(&(0..100_000).map(wave).collect::<Vec<_>>()) < 5.0);
        let times = |i: u32| 42_949 * i;
        assert!(bits(&(0..100_000).map(times).collect::<Vec<_>>()) < 0.2);
        assert!(bits(&[7; 10_000]) < 0.2);
    }
}
