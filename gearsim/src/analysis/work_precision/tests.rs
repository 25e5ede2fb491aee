//! Prices and words, from curves made by hand.

use super::ladder::Kind;
use super::table::{self, Price};
use super::{Curve, Errors, Point, WorkPrecision};

fn point(error: f64, seconds: f64, right_events: bool) -> Point {
    let errors = Errors { end: error, path: error, times: None, events: i64::from(!right_events), energy: error };
    Point {
        setting: "s".into(),
        seconds: (seconds, seconds),
        evaluations: 1,
        steps: 1,
        events: 1,
        errors: Ok(errors),
        right_events,
    }
}

fn curve(label: &'static str, kind: Kind, points: &[(f64, f64, bool)]) -> Curve {
    Curve { label, kind, points: points.iter().map(|&(e, t, right)| point(e, t, right)).collect() }
}

/// Between 1e-4 at 1 ms and 1e-8 at 100 ms, 1e-6 costs 10 ms.
#[test]
fn prices_are_interpolated_in_logarithms() {
    let c = curve("m", Kind::Method, &[(1e-4, 1e-3, true), (1e-8, 0.1, true)]);
    let Price::Seconds(seconds) = c.price(1e-6, 1e-13) else { panic!("a price") };
    assert!((seconds - 0.01).abs() < 1e-12);
    assert_eq!(c.price(1e-3, 1e-13), Price::Seconds(1e-3));
    assert_eq!(c.price(1e-9, 1e-13), Price::Never);
    assert_eq!(c.price(1e-14, 1e-13), Price::Unknown);
    // A setting that lost events is no bargain.
    let c = curve("m", Kind::Method, &[(1e-4, 1e-5, false), (1e-8, 0.1, true)]);
    assert_eq!((c.price(1e-3, 0.0), c.failures()), (Price::Seconds(0.1), 1));
}

#[test]
fn words_say_what_is_measured() {
    let curves = vec![
        curve("exact cells", Kind::Method, &[(0.0, 3e-4, true)]),
        curve("steps", Kind::Method, &[(1e-4, 1e-3, true), (1e-8, 0.1, true)]),
        curve("classical equations", Kind::Equations, &[(0.04, 1e-4, true)]),
    ];
    let measured = WorkPrecision { scene: "x".into(), events: 9, floor: 1e-12, curves };
    let words = table::words(&measured);
    assert_eq!(
        words,
        "Exact cells cost 300 µs for an error of 1e-12. By steps, 1e-6 costs 10 ms at least (steps). No method by steps \
         reaches 1e-9. The classical equations cost 100 µs and are wrong by 4.0 %."
    );
    let text = table::markdown(&measured);
    assert!(text.contains("never"), "{text}");
    assert_eq!(table::csv(&measured).lines().count(), 5);
}
