//! Pitches with any origin.

use std::f64::consts::TAU;

use super::*;
use crate::profile::Step;

fn pitch(origin: f64) -> Pitch {
    let steps = [(1.0, 2.0), (2.0, 1.0), (3.0, TAU - 3.0)].map(|(value, width)| Step { value, width });
    Pitch::new(&Profile::stepping(steps.to_vec()).with_origin(origin), TAU)
}

/// The level at a phase, from the definition of the law.
fn level(phase: f64, origin: f64) -> f64 {
    match (phase - origin).rem_euclid(TAU) {
        x if x < 2.0 => 1.0,
        x if x < 3.0 => 2.0,
        _ => 3.0,
    }
}

#[test]
fn the_cell_of_a_phase_is_found_for_any_origin() {
    for i in 0..200 {
        let origin = -7.0 + 0.0731 * f64::from(i);
        let pitch = pitch(origin);
        for j in 0..200 {
            let phase = -20.0 + 0.2017 * f64::from(j);
            let (count, rest, cell) = pitch.locate(phase, 1.0);
            let (lower, upper) = pitch.bounds(cell);
            assert!(lower <= rest && rest < upper, "{origin} {phase}: {rest} not in {lower} {upper}");
            assert!((count as f64 * TAU + rest - phase).abs() < 1e-14, "{origin} {phase}");
            assert_eq!(pitch.level(cell), level(phase, origin), "{origin} {phase}");
        }
    }
}

/// On a boundary the direction of the motion decides, also at the end of the pitch, and the way back leads to the same cell.
#[test]
fn boundaries_are_passed_in_both_directions() {
    for origin in [0.0, -1.0, 2.5, TAU, -TAU] {
        let pitch = pitch(origin);
        let (first, last) = (pitch.bounds(0).0, pitch.bounds(2).1);
        assert!(first > -TAU && first <= 0.0 && (last - first - TAU).abs() < 1e-15);
        assert_eq!(pitch.locate(first, 1.0), (0, first, 0));
        assert_eq!(pitch.locate(first, -1.0), (-1, last, 2));
        assert_eq!(pitch.beyond(2, Side::Upper), (0, first, 1));
        assert_eq!(pitch.beyond(0, Side::Lower), (2, last, -1));
    }
}

/// A shift by whole pitches does not change the law; a billion pitches cost no digits.
#[test]
fn a_shift_by_whole_pitches_does_not_change_the_law() {
    assert_eq!(pitch(0.0), pitch(TAU));
    assert_eq!(pitch(0.0), pitch(-3.0 * TAU));
    let (count, rest, cell) = pitch(-1.0).locate(1e9 * TAU, 1.0);
    assert_eq!((count, cell), (1_000_000_000, 0));
    assert!(rest.abs() < 1e-6);
}

/// With several pitches in a period, boundaries have the digits of one pitch, and a full period leads back to the same cell.
#[test]
fn a_period_of_several_pitches() {
    let steps: Vec<_> = (0..24).map(|i| Step { value: f64::from(i), width: TAU }).collect();
    let pitch = Pitch::new(&Profile::stepping(steps).with_origin(-1.3).with_pitches(24), TAU);
    for (teeth, tooth) in [(0.0, 0), (5.0, 5), (23.0, 23), (24.0, 0), (-1.0, 23), (-25.0, 23)] {
        let (count, rest, cell) = pitch.locate(teeth * TAU, 1.0);
        assert_eq!(cell, tooth);
        assert!((count as f64 * TAU + rest - teeth * TAU).abs() < 1e-13, "{teeth}: {count} {rest}");
    }
    for side in [Side::Upper, Side::Lower] {
        let (mut cell, mut count) = (7, 0);
        for _ in 0..24 {
            let (next, entered, turn) = pitch.beyond(cell, side);
            // A boundary has the same place from both sides, with the digits of a pitch.
            let left = if side == Side::Upper { pitch.bounds(cell).1 } else { pitch.bounds(cell).0 };
            assert!((turn as f64 * TAU + entered - left).abs() < 2e-15, "{cell}: {left} {entered}");
            (cell, count) = (next, count + turn);
        }
        assert_eq!((cell, count), (7, if side == Side::Upper { 24 } else { -24 }));
    }
    for cell in 0..24 {
        let (lower, upper) = pitch.bounds(cell);
        let at = if cell == 0 { -1.3 } else { TAU - 1.3 };
        assert!(((lower - at) / TAU).fract().abs() < 1e-15 && (upper - lower - TAU).abs() < 2e-15, "{lower} {upper}");
    }
}

/// For any count of turns and remainder, a law is in the same cell as for the whole phase. On a boundary it is in the cell into
/// which it moves.
#[test]
fn the_cell_of_a_law_is_found_from_counted_turns() {
    for (pitches, origin) in [(1, -0.86), (1, 0.0), (3, -1.3), (24, -100.0)] {
        let widths: Vec<f64> = (0..2 * pitches).map(|i| if i % 2 == 0 { 1.7 } else { TAU - 1.7 }).collect();
        let steps = widths.iter().enumerate().map(|(i, width)| Step { value: i as f64, width: *width }).collect();
        let pitch = Pitch::new(&Profile::stepping(steps).with_origin(origin).with_pitches(pitches), TAU);
        for i in 0..500 {
            let (turns, rest) = (i % 60 - 30, 0.013 + (0.618 * i as f64) % TAU);
            let (count, _, cell) = pitch.locate(turns as f64 * TAU + rest, 1.0);
            assert_eq!(pitch.locate_from(turns, rest, 1.0), (count - turns, cell), "{turns} turns and {rest}");
        }
        let (lower, _) = pitch.bounds(1);
        let at = |x: f64, speed: f64| pitch.locate_from(pitch.spans[1].before, x, speed).1;
        for off in [-2e-16, 0.0, 2e-16] {
            assert_eq!((at(lower + off, 1.0), at(lower + off, -1.0)), (1, 0));
        }
        assert_eq!((at(lower + 1e-12, -1.0), at(lower - 1e-12, 1.0)), (1, 0));
    }
}
