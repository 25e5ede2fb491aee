//! The arithmetic of the precise engine, compared with dashu's floats.

use dashu_float::{FBig, round::mode};

use super::number::{Real, Scalar};
use super::tests::Noise;

type Dashu = FBig<mode::HalfAway, 2>;

#[test]
fn elementary_functions_agree_with_dashu() {
    let mut noise = Noise(1);
    for exponent in [-60, -20, -3, 0, 2, 5, 9] {
        for _ in 0..20 {
            let x = (noise.next() - 0.5) * 2f64.powi(exponent);
            let real = Real::<256>::exact(x);
            let dashu = Dashu::try_from(x).unwrap().with_precision(300).value();
            let (sin, cos) = real.sine_cosine();
            let square_root = real.abs().root();
            let pairs = [
                (real.exponential(), dashu.exp()),
                (sin, dashu.sin()),
                (cos, dashu.cos()),
                (square_root.clone(), Dashu::try_from(x.abs()).unwrap().with_precision(300).value().sqrt()),
                (Real::exact(1.0) / real.clone(), Dashu::try_from(1.0).unwrap().with_precision(300).value() / &dashu),
                (square_root * real.clone() - real, {
                    let root = Dashu::try_from(x.abs()).unwrap().with_precision(300).value().sqrt();
                    root * &dashu - dashu
                }),
            ];
            for (i, (ours, theirs)) in pairs.into_iter().enumerate() {
                let relative = relative_difference(&ours, &theirs);
                assert!(relative < 1e-70, "{i} at {x}: {relative}");
            }
        }
    }
}

fn relative_difference(ours: &Real<256>, theirs: &Dashu) -> f64 {
    // subtracts parts of 53 bits from both, six times, so that the rest is below the last digit
    let (mut rest, mut other) = (ours.clone(), theirs.clone());
    for _ in 0..6 {
        let part = rest.approx();
        rest = rest - Real::exact(part);
        other -= Dashu::try_from(part).unwrap();
    }
    let left = (other.to_f64().value() - rest.approx()).abs();
    left / ours.approx().abs()
}
