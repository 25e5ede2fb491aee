//! Row 13: damping that couples the modes, compared with the matrix exponential in 50 digits.

mod draw;

use gearsim::__private::{Cell, Cost, Search, Side, Signal, Vector};
use gearsim::run::Refusal;
use gearsim_tests::precise::exponential::Exponential;
use gearsim_tests::precise::number::{Real, Scalar};

use crate::case::{Case, NONE, WRONG, largest};
use crate::linear::{Linear, diagonal};
use crate::noise::Noise;
use draw::Drawn;

pub const CASES: &[Case] = &[
    Case {
        row: "13",
        name: "random cells whose damping couples 2 to 8 coordinates",
        proves: "q and q' agree with the matrix exponential, for weak, strong and over-critical damping, and with rigid motions",
        tolerance: 100.0,
        unit: "eps cond (1 + rate t) of the speeds",
        reason: "cond is the effect of rounding the matrices, sqrt of the largest ratio of inertias times that of stiffnesses or the rate of the strongest damper over that of a vibration, times the squared condition number of the modes",
        measure: motions,
    },
    Case {
        row: "13",
        name: "equal parts around a hub with a damper of any strength",
        proves: "modes of equal frequencies that a damper does not reach are found beside modes that it damps by up to 1e6 times as much",
        tolerance: 100.0,
        unit: "eps cond (1 + rate t) of the speeds",
        reason: "cond is the rate of the damper over that of a vibration: rounding the damper disturbs the motions it does not reach",
        measure: wheels,
    },
    Case {
        row: "13",
        name: "energy that damping takes from random cells",
        proves: "the integral of the speeds equals the energy loss by the matrix exponential",
        tolerance: 100.0,
        unit: "eps cond (1 + rate t) of the largest energy",
        reason: "as for the motions",
        measure: losses,
    },
    Case {
        row: "13",
        name: "a free train that strong dampers hold together and that a damper of 1e-1 to 1e-9 slows",
        proves: "q and q' agree with the matrix exponential: the slow decay and the motion without end form one mode",
        tolerance: 100.0,
        unit: "eps cond (1 + rate t) of the speeds",
        reason: "cond is the rate of the strongest damper over that of a vibration",
        measure: slowed,
    },
    Case {
        row: "13",
        name: "first crossings of random cells with coupled damping",
        proves: "each is a root of the phase by the matrix exponential, and no earlier sample of it is beyond the boundary",
        tolerance: 0.0,
        unit: WRONG,
        reason: NONE,
        measure: crossings,
    },
    Case {
        row: "13",
        name: "relative damping between two modes of 1e-2 to 1e-16",
        proves: "the difference from the motion of uncoupled modes falls with the coupling",
        tolerance: 0.2,
        unit: "coupling + 16 eps",
        reason: "a tenth of the coupling acts as a force on motions of size one, off resonance; coupling below 1e-10 is ignored",
        measure: continuity,
    },
    Case {
        row: "13",
        name: "two vibrations that nearly coalesce, at a relative distance of 1e-1 to 1e-6",
        proves: "no more digits are lost than the conditioning takes",
        tolerance: 20.0,
        unit: "eps (1 + rate t)/distance",
        reason: "the condition number c of the pair is 1/sqrt(distance): c rounding errors shift the phase of each mode, and each is c times as large as the motion",
        measure: coalescing,
    },
    Case {
        row: "13",
        name: "defective vibrations, and coincident ones that are not defective",
        proves: "the first are refused with a named error, the second agree with the matrix exponential",
        tolerance: 100.0,
        unit: "eps (1 + rate t)",
        reason: "as for the random cells",
        measure: coincident,
    },
];

type Digits = Real<192>;

/// The exact motion of a cell.
fn exact<const N: usize>(system: &Linear<N>) -> Exponential<192> {
    Exponential::new(&system.mass, &system.damping, &system.stiffness, &system.load)
}

fn digits<const N: usize>(x: &[f64; N]) -> Vec<Digits> {
    x.iter().map(|x| Digits::exact(*x)).collect()
}

/// The error of q and q' after `t`, relative to the largest speed, in units of eps (1 + rate t). Coordinates and speeds are multiplied by
/// sqrt(M).
fn error<const N: usize>(system: &Linear<N>, q: &[f64; N], v: &[f64; N], t: f64) -> f64 {
    let cell = system.cell();
    let flight = cell.flight(&Vector::from(*q), &Vector::from(*v));
    let (dq, dv) = flight.increments(&flight.at(t));
    let exact = exact(system);
    let (x, y) = exact.over(&Digits::exact(t)).of(&digits(q), &digits(v));
    let apart = |i: usize, from: f64, d: f64, to: &Digits| {
        system.mass[i][i].sqrt() * (to.clone() - Digits::exact(from) - Digits::exact(d)).approx().abs()
    };
    let place = largest((0..N).map(|i| apart(i, q[i], dq[i], &x[i])));
    let speed = largest((0..N).map(|i| apart(i, v[i], dv[i], &y[i])));
    let size = |v: &dyn Fn(usize) -> f64| largest((0..N).map(|i| system.mass[i][i].sqrt() * v(i).abs()));
    // The largest speed, from the two ends and two times between.
    let middle = |part: f64| {
        let (_, y) = exact.over(&Digits::exact(part * t)).of(&digits(q), &digits(v));
        size(&|i| y[i].approx())
    };
    let fastest = size(&|i| v[i]).max(size(&|i| y[i].approx())).max(middle(0.1)).max(middle(0.45));
    place.max(speed / cell.rate).max(speed * t.min(1.0 / cell.rate)) / fastest * cell.rate.max(1.0 / t)
        / (f64::EPSILON * (1.0 + cell.rate * t))
}

/// The largest value of an expression over 40 random cells each of 2, 3, 4, 6 and 8 coordinates.
macro_rules! of_all {
    ($noise:expr, $drawn:ident => $what:expr) => {
        largest(
            (0..40)
                .flat_map(|_| {
                    [
                        {
                            let $drawn = Drawn::<2>::new($noise);
                            $what
                        },
                        {
                            let $drawn = Drawn::<3>::new($noise);
                            $what
                        },
                        {
                            let $drawn = Drawn::<4>::new($noise);
                            $what
                        },
                        {
                            let $drawn = Drawn::<6>::new($noise);
                            $what
                        },
                        {
                            let $drawn = Drawn::<8>::new($noise);
                            $what
                        },
                    ]
                })
                .collect::<Vec<f64>>(),
        )
    };
}

fn motions(note: &mut String) -> f64 {
    let (mut noise, mut coupled, mut all) = (Noise::new(1301), 0, 0);
    let worst = of_all!(&mut noise, drawn => {
        (all, coupled) = (all + 1, coupled + usize::from(drawn.system.cell().coupling.is_some()));
        drawn.judged(error(&drawn.system, &drawn.q, &drawn.v, drawn.t))
    });
    *note = format!("{coupled} of {all} cells coupled");
    worst
}

fn wheels(note: &mut String) -> f64 {
    let (mut noise, mut coupled, mut all) = (Noise::new(1306), 0, 0);
    let worst = largest((0..100).map(|_| {
        let (of_three, of_five) = (Drawn::<4>::wheel(&mut noise), Drawn::<6>::wheel(&mut noise));
        (all, coupled) = (all + 2, coupled + usize::from(of_three.system.cell().coupling.is_some()));
        coupled += usize::from(of_five.system.cell().coupling.is_some());
        let of_three = of_three.judged(error(&of_three.system, &of_three.q, &of_three.v, of_three.t));
        of_three.max(of_five.judged(error(&of_five.system, &of_five.q, &of_five.v, of_five.t)))
    }));
    *note = format!("{coupled} of {all} cells coupled");
    worst
}

fn losses(note: &mut String) -> f64 {
    let (mut noise, mut most) = (Noise::new(1302), 0f64);
    let worst = of_all!(&mut noise, drawn => {
        let system = &drawn.system;
        let cell = system.cell();
        let flight = cell.flight(&Vector::from(drawn.q), &Vector::from(drawn.v));
        let lost = flight.dissipated(&flight.at(drawn.t));
        let (q, v) = exact(system).over(&Digits::exact(drawn.t)).of(&digits(&drawn.q), &digits(&drawn.v));
        let [before, after] = [(digits(&drawn.q), digits(&drawn.v)), (q.clone(), v)].map(|(q, v)| {
            quadratic(&system.mass, &v) + quadratic(&system.stiffness, &q)
        });
        let work = (0..q.len()).fold(Digits::exact(0.0), |sum, i| {
            sum + Digits::exact(system.load[i]) * (q[i].clone() - Digits::exact(drawn.q[i]))
        });
        let want = (before.clone() - after.clone() + work.clone()).approx();
        let passes = before.approx().max(after.approx()).max(want);
        most = most.max(want / passes);
        drawn.judged((lost - want).abs() / (passes * f64::EPSILON * (1.0 + cell.rate * drawn.t)))
    });
    *note = format!("up to {:.0} % of the energy", 100.0 * most);
    worst
}

fn slowed(_: &mut String) -> f64 {
    let chain = |a: f64, b: f64| [[a, -a, 0.0], [-a, a + b, -b], [0.0, -b, b]];
    largest((1..=9).map(|power| {
        let mut damping = chain(4.0, 6.0);
        damping[2][2] += 0.5f64.powi(3 * power);
        let stiffness = chain(0.03125, 0.046875);
        let load = [0.0, 0.01, 0.02];
        let system = Linear { mass: diagonal([1.0, 2.0, 1.5]), damping, stiffness, load, normal: [1.0; 3] };
        let condition = 10.0 / (0.03125f64 * 2.0).sqrt();
        error(&system, &[0.1, -0.2, 0.3], &[0.02, 0.01, -0.01], 10.0) / condition
    }))
}

/// xᵀA x/2.
fn quadratic<const N: usize>(a: &[[f64; N]; N], x: &[Digits]) -> Digits {
    let entries = (0..N).flat_map(|i| (0..N).map(move |j| (i, j)));
    entries
        .fold(Digits::exact(0.0), |sum, (i, j)| sum + Digits::exact(a[i][j]) * x[i].clone() * x[j].clone())
        .scaled(-1)
}

fn crossings(note: &mut String) -> f64 {
    let (mut noise, mut met, mut all) = (Noise::new(1303), 0, 0);
    let mut wrong = 0.0;
    for _ in 0..60 {
        wrong += crossing(&Drawn::<2>::new(&mut noise), &mut noise, &mut met);
        wrong += crossing(&Drawn::<3>::new(&mut noise), &mut noise, &mut met);
        wrong += crossing(&Drawn::<5>::new(&mut noise), &mut noise, &mut met);
        all += 3;
    }
    *note = format!("{met} of {all} met a boundary");
    wrong
}

/// Number of samples of the exact motion.
const SAMPLES: usize = 400;

/// 1 if the first crossing of a boundary by n.q disagrees with samples of the exact motion, otherwise 0. The boundaries are drawn
/// relative to the range of n.q.
fn crossing<const N: usize>(drawn: &Drawn<N>, noise: &mut Noise, met: &mut usize) -> f64 {
    let system = Linear { normal: [(); N].map(|()| noise.even()), ..drawn.system };
    let propagator = exact(&system);
    let step = propagator.over(&(Digits::exact(drawn.t).over(SAMPLES as u32)));
    let phase = |q: &[Digits]| {
        (0..N).fold(Digits::exact(0.0), |sum, i| {
            sum + Digits::exact(system.normal[i]) * (q[i].clone() - Digits::exact(drawn.q[i]))
        })
    };
    let (mut q, mut v, mut way) = (digits(&drawn.q), digits(&drawn.v), vec![0.0]);
    for _ in 0..SAMPLES {
        (q, v) = step.of(&q, &v);
        way.push(phase(&q).approx());
    }
    let high = largest(way.iter().copied());
    let low = largest(way.iter().map(|x| -x));
    let (up, down) = ((0.2 + 0.9 * noise.unit()) * high, (0.2 + 0.9 * noise.unit()) * low);
    let (up, down) = (if up > 0.0 { up } else { low }, if down > 0.0 { down } else { high });
    let cell = system.cell();
    let flight = cell.flight(&Vector::from(drawn.q), &Vector::from(drawn.v));
    let (on_moved, on_speed) = cell.follow(&Vector::from(system.normal), None);
    let signal = Signal { flight: &flight, on_moved: &on_moved, on_speed: on_speed.as_deref(), direct: None };
    let mut point = flight.begin();
    let rate = Vector::from(system.normal).dot(&Vector::from(drawn.v));
    let found = Search { signal, rate, down, up, horizon: drawn.t }.first(&mut point, &mut Cost::default());
    let Ok(side) = found else { return 1.0 };
    let end = if side.is_some() { point.t } else { drawn.t };
    // The accuracy to which the phase is known.
    let slack = drawn.slack() * (high + low);
    let beyond = |x: f64| x > up + slack || x < -down - slack;
    let first = way.iter().position(|x| beyond(*x)).map_or(f64::INFINITY, |i| i as f64 * drawn.t / SAMPLES as f64);
    let Some(side) = side else { return f64::from(u8::from(first < drawn.t)) };
    *met += 1;
    let (q, _) = propagator.over(&Digits::exact(end)).of(&digits(&drawn.q), &digits(&drawn.v));
    let level = if side == Side::Upper { up } else { -down };
    let wrong = (phase(&q).approx() - level).abs() > slack || first < end;
    if wrong {
        println!("t = {end:e} at {level:e}, first sample beyond {first:e}: {drawn:?}");
    }
    f64::from(u8::from(wrong))
}

fn continuity(_: &mut String) -> f64 {
    let at = |coupling: f64| {
        let off = coupling * 0.1;
        let damping = [[0.1, off, 0.0], [off, 0.2, -off], [0.0, -off, 0.1]];
        let system = Linear {
            mass: diagonal([1.0; 3]),
            damping,
            stiffness: diagonal([1.0, 2.0, 5.0]),
            load: [0.3, 0.0, 0.1],
            normal: [1.0; 3],
        };
        let cell = system.cell();
        let flight = cell.flight(&Vector::from([0.1, -0.2, 0.3]), &Vector::from([0.5, 0.4, -0.3]));
        let point = flight.at(20.0);
        let (dq, dv) = flight.increments(&point);
        (dq, dv, flight.dissipated(&point))
    };
    let none = at(0.0);
    largest((4..=32).map(|half| {
        let coupling = 10f64.powf(-0.5 * f64::from(half));
        let with = at(coupling);
        let apart = (&with.0 - &none.0).amax().max((&with.1 - &none.1).amax()).max((with.2 - none.2).abs());
        apart / (coupling + 16.0 * f64::EPSILON)
    }))
}

/// Two oscillators whose vibrations coalesce at distance = 0: the determinant of the pencil is then (lambda² + s lambda + b)².
fn nearly_defective(distance: f64) -> Linear<2> {
    let (s, b): (f64, f64) = (0.1, 1.0);
    Linear {
        mass: diagonal([1.0; 2]),
        damping: diagonal([2.0 * s * (1.0 + distance), 0.0]),
        stiffness: [[s * s + b, s * b.sqrt()], [s * b.sqrt(), b]],
        load: [0.0; 2],
        normal: [1.0, 0.0],
    }
}

fn coalescing(_: &mut String) -> f64 {
    largest((1..=6).flat_map(|power| {
        let size = 10f64.powi(-power);
        [size, -size].map(|distance| error(&nearly_defective(distance), &[0.2, -0.1], &[1.0, 0.5], 30.0) * size)
    }))
}

fn coincident(note: &mut String) -> f64 {
    let refused = |distance: f64| matches!(Cell::new(&nearly_defective(distance), &[]), Err(Refusal::Defective { .. }));
    if !refused(0.0) || refused(1e-6) {
        return f64::INFINITY;
    }
    // Two equal pairs of oscillators with equal damping: all eigenvalues are double.
    let mut worst = 0f64;
    for (c, k) in [
        ([0.2, 0.0, 0.05], [1.0, 3.0]),
        ([5.0, 0.0, 1.0], [1.0, 3.0]),
        ([2.0, 0.3, 0.9], [1.0, 1.0]),
        ([9.0, 7.0, 2.0], [2.0, 0.0]),
    ] {
        let block = |a: [[f64; 2]; 2]| -> [[f64; 4]; 4] {
            std::array::from_fn(|i| std::array::from_fn(|j| if i % 2 == j % 2 { a[i / 2][j / 2] } else { 0.0 }))
        };
        let system = Linear {
            mass: diagonal([1.0; 4]),
            damping: block([[c[0], c[2]], [c[2], c[0] + c[1]]]),
            stiffness: block([[k[0], -0.0], [-0.0, k[1]]]),
            load: [0.1, 0.2, 0.0, -0.1],
            normal: [1.0; 4],
        };
        // A critically damped mode and two coupled modes.
        let critical = Linear {
            mass: diagonal([1.0; 3]),
            damping: [[0.4, 0.3, 0.0], [0.3, 0.6, 0.0], [0.0, 0.0, 6.0]],
            stiffness: diagonal([1.0, 4.0, 9.0]),
            load: [0.0; 3],
            normal: [1.0; 3],
        };
        worst = worst.max(error(&system, &[0.1, 0.2, -0.1, 0.3], &[1.0, -0.5, 0.2, 0.7], 9.0)).max(error(
            &critical,
            &[0.1, 0.2, -0.1],
            &[1.0, -0.5, 0.2],
            9.0,
        ));
    }
    *note = "4 double spectra, and one critical mode".to_string();
    worst
}
