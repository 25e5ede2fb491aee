//! Energies written by hand in absolute rotations and displacements, against the derived ones: at random states, and by
//! the natural frequencies of the hand-written matrices.

use gearsim::engine::equations::Derived;
use gearsim::generated::*;
use nalgebra::DMatrix;

use crate::train::{frequencies, train};

/// Inertias of absolute coordinates, and springs: a stiffness and what it feels of them.
pub struct ByHand {
    inertia: Vec<f64>,
    springs: Vec<(f64, Vec<(usize, f64)>)>,
}

impl ByHand {
    fn energies(&self, x: &[f64]) -> [f64; 2] {
        let feels = |felt: &[(usize, f64)]| felt.iter().map(|(i, c)| c * x[*i]).sum::<f64>();
        let kinetic = self.inertia.iter().zip(x).map(|(m, v)| m * v * v / 2.0).sum();
        [kinetic, self.springs.iter().map(|(k, felt)| k * feels(felt).powi(2) / 2.0).sum()]
    }

    fn frequencies(&self) -> Vec<f64> {
        let n = self.inertia.len();
        let mut stiffness = DMatrix::zeros(n, n);
        for (k, felt) in &self.springs {
            felt.iter().for_each(|(i, a)| felt.iter().for_each(|(j, b)| stiffness[(*i, *j)] += k * a * b));
        }
        frequencies(DMatrix::from_fn(n, n, |i, j| if i == j { self.inertia[i] } else { 0.0 }), stiffness)
    }
}

/// A number for every parameter and law: none is alike, so that no two can be exchanged unseen.
type Numbers = &'static [(&'static str, f64)];

/// Compares the model `D` with a system by hand, whose coordinates `absolute` makes of the model's.
fn compare<D: Derived<N>, const N: usize>(
    numbers: &[(&str, f64)],
    by_hand: &ByHand,
    absolute: impl Fn(&dyn Fn(&str) -> f64) -> Vec<f64>,
) {
    let train = train::<D, N>(numbers);
    let name = train.model.name;
    let index = |c: &str| train.model.coordinates.iter().position(|q| q.name == c).unwrap_or_else(|| panic!("no {c}"));
    for draw in 0..100 {
        // Steps of the golden ratio fill the interval evenly and never repeat.
        let x: [f64; N] = std::array::from_fn(|i| ((draw * N + i + 1) as f64 * 0.618_033_988_749_895).fract() - 0.5);
        let found = train.energies(&x);
        let expected = by_hand.energies(&absolute(&|c| x[index(c)]));
        for ((found, expected), energy) in found.iter().zip(expected).zip(["T", "V"]) {
            // Sums of up to a hundred products of numbers near one: their roundings, with room.
            assert!((found - expected).abs() <= 1e-12 * expected, "{name}: {energy} = {found}, by hand {expected}");
        }
    }
    let (found, expected) = (train.frequencies(), by_hand.frequencies());
    assert_eq!(found.len(), expected.len(), "{name}");
    let highest = expected.last().copied().unwrap_or(0.0);
    for (f, e) in found.iter().zip(&expected) {
        // Squares of frequencies are right to eps of the largest; the root of that is what a rigid motion may show.
        let tolerance = 1e-10 * e + if *e < 1e-6 * highest { 1e-6 * highest } else { 0.0 };
        assert!((f - e).abs() <= tolerance, "{name}: {found:?}, by hand {expected:?}");
    }
    println!("{name}: {expected:.2?} Hz");
}

pub const TESTS: &[(&str, fn())] = &[
    ("gear_pair_shafts", gear_pair_shafts_by_hand),
    ("gear_pair_bearings", gear_pair_bearings_by_hand),
    ("geared_branches", geared_branches_by_hand),
    ("two_stage", two_stage_by_hand),
    ("idler", idler_by_hand),
    ("belt_drive", belt_drive_by_hand),
    ("planetaries_of_3_to_7", planetaries),
    ("planar_planetaries_of_3_4_and_5", planar_planetaries),
    ("wind_turbine", wind_turbine_by_hand),
    ("chains", chains),
];

const TORQUES: [(&str, f64); 2] = [("T_motor", 0.0), ("T_load", 0.0)];

fn with(numbers: Numbers, more: &[(&'static str, f64)]) -> Vec<(&'static str, f64)> {
    [numbers, more].concat()
}

/// Looks numbers up by name.
fn of<'a>(numbers: &'a [(&str, f64)]) -> impl Fn(&str) -> f64 + 'a {
    |name| numbers.iter().find(|n| n.0 == name).unwrap_or_else(|| panic!("no {name}")).1
}

/// A shaft between two rotors.
fn twist(k: f64, i: usize, j: usize) -> (f64, Vec<(usize, f64)>) {
    (k, vec![(i, 1.0), (j, -1.0)])
}

fn gear_pair_shafts_by_hand() {
    let numbers = with(
        &[
            ("N1", 23.0),
            ("N2", 67.0),
            ("r1", 0.7),
            ("I_m", 0.9),
            ("I1", 0.4),
            ("I2", 1.7),
            ("I_l", 2.3),
            ("k_m", 3.1),
            ("k_l", 4.3),
            ("k12", 5.7),
        ],
        &TORQUES,
    );
    let p = of(&numbers);
    let r2 = p("r1") * p("N2") / p("N1");
    let by_hand = ByHand {
        inertia: vec![p("I_m"), p("I1"), p("I2"), p("I_l")],
        springs: vec![twist(p("k_m"), 0, 1), (p("k12"), vec![(1, p("r1")), (2, -r2)]), twist(p("k_l"), 2, 3)],
    };
    compare::<gear_pair_shafts::GearPairShafts>(&numbers, &by_hand, |q| {
        let (theta1, theta2) = pair(q("theta"), q("s"), p("N1"), p("N2"), p("r1"));
        vec![theta1 + q("psi_m"), theta1, theta2, theta2 - q("psi_l")]
    });
}

/// Rotations of two gears from N1 theta1 + N2 theta2 = 2 theta and r1 theta1 - r2 theta2 = s, by Cramer's rule.
fn pair(theta: f64, s: f64, n1: f64, n2: f64, r1: f64) -> (f64, f64) {
    let r2 = r1 * n2 / n1;
    let determinant = -n1 * r2 - n2 * r1;
    ((-2.0 * theta * r2 - n2 * s) / determinant, (n1 * s - 2.0 * theta * r1) / determinant)
}

fn gear_pair_bearings_by_hand() {
    let alpha = 0.41f64;
    let numbers = with(
        &[
            ("N1", 23.0),
            ("N2", 67.0),
            ("r1", 0.7),
            ("I1", 0.4),
            ("I2", 1.7),
            ("m1", 1.3),
            ("m2", 2.9),
            ("kb1", 3.7),
            ("kb2", 6.1),
            ("k12", 5.7),
            ("alpha", 0.41),
        ],
        &TORQUES,
    );
    let p = of(&numbers);
    let r2 = p("r1") * p("N2") / p("N1");
    let mesh = vec![(0, alpha.sin()), (1, alpha.cos()), (2, p("r1")), (3, -alpha.sin()), (4, -alpha.cos()), (5, -r2)];
    let by_hand = ByHand {
        inertia: vec![p("m1"), p("m1"), p("I1"), p("m2"), p("m2"), p("I2")],
        springs: [(p("k12"), mesh)]
            .into_iter()
            .chain([(0, "kb1"), (1, "kb1"), (3, "kb2"), (4, "kb2")].map(|(i, kb)| (p(kb), vec![(i, 1.0)])))
            .collect(),
    };
    compare::<gear_pair_bearings::GearPairBearings>(&numbers, &by_hand, |q| {
        let (theta1, theta2) = pair(q("theta"), q("s"), p("N1"), p("N2"), p("r1"));
        vec![q("x1"), q("y1"), theta1, q("x2"), q("y2"), theta2]
    });
}

fn geared_branches_by_hand() {
    let numbers = with(
        &[
            ("N1", 23.0),
            ("N2", 67.0),
            ("I_m", 0.9),
            ("I1", 0.4),
            ("I2", 1.7),
            ("I_a", 2.3),
            ("I_b", 1.1),
            ("k_m", 3.1),
            ("k_a", 4.3),
            ("k_b", 5.7),
        ],
        &TORQUES,
    );
    let p = of(&numbers);
    // Reduced to the first shaft: the second gear's inertia by the square of the ratio.
    let ratio = p("N1") / p("N2");
    let by_hand = ByHand {
        inertia: vec![p("I_m"), p("I1") + p("I2") * ratio * ratio, p("I_a"), p("I_b")],
        springs: vec![twist(p("k_m"), 0, 1), twist(p("k_a"), 1, 2), (p("k_b"), vec![(1, ratio), (3, -1.0)])],
    };
    compare::<geared_branches::GearedBranches>(&numbers, &by_hand, |q| {
        ["theta_m", "theta1", "theta_a", "theta_b"].map(q).to_vec()
    });
}

fn two_stage_by_hand() {
    let numbers = with(
        &[
            ("N1", 23.0),
            ("N2", 67.0),
            ("r1", 0.7),
            ("N3", 19.0),
            ("N4", 71.0),
            ("r3", 0.9),
            ("I_m", 0.9),
            ("I1", 0.4),
            ("I2", 1.7),
            ("I3", 0.6),
            ("I4", 2.1),
            ("I_l", 2.3),
            ("k_m", 3.1),
            ("k_c", 7.3),
            ("k_l", 4.3),
            ("k12", 5.7),
            ("k34", 6.7),
        ],
        &TORQUES,
    );
    let p = of(&numbers);
    let (r2, r4) = (p("r1") * p("N2") / p("N1"), p("r3") * p("N4") / p("N3"));
    let by_hand = ByHand {
        inertia: ["I_m", "I1", "I2", "I3", "I4", "I_l"].map(&p).to_vec(),
        springs: vec![
            twist(p("k_m"), 0, 1),
            (p("k12"), vec![(1, p("r1")), (2, -r2)]),
            twist(p("k_c"), 2, 3),
            (p("k34"), vec![(3, p("r3")), (4, -r4)]),
            twist(p("k_l"), 4, 5),
        ],
    };
    compare::<two_stage::TwoStage>(&numbers, &by_hand, |q| {
        let (theta1, theta2) = pair(q("theta1"), q("s1"), p("N1"), p("N2"), p("r1"));
        let (theta3, theta4) = pair(q("theta2"), q("s2"), p("N3"), p("N4"), p("r3"));
        vec![theta1 + q("psi_m"), theta1, theta2, theta3, theta4, theta4 - q("psi_l")]
    });
}

fn idler_by_hand() {
    let numbers = with(
        &[
            ("N1", 23.0),
            ("N2", 31.0),
            ("N3", 67.0),
            ("r2", 0.7),
            ("I1", 0.4),
            ("I2", 0.8),
            ("I3", 1.7),
            ("k12", 5.7),
            ("k23", 4.9),
        ],
        &TORQUES,
    );
    let p = of(&numbers);
    let r = ["N1", "N2", "N3"].map(|teeth| p("r2") * p(teeth) / p("N2"));
    let by_hand = ByHand {
        inertia: ["I1", "I2", "I3"].map(&p).to_vec(),
        springs: vec![(p("k12"), vec![(0, r[0]), (1, -r[1])]), (p("k23"), vec![(1, r[1]), (2, -r[2])])],
    };
    compare::<idler::Idler>(&numbers, &by_hand, |q| {
        let theta2 = q("theta") / p("N2");
        vec![(r[1] * theta2 + q("delta1")) / r[0], theta2, (r[1] * theta2 - q("delta2")) / r[2]]
    });
}

fn belt_drive_by_hand() {
    let numbers = with(
        &[
            ("r1", 0.9),
            ("r2", 0.4),
            ("a", 1.3),
            ("I1", 0.4),
            ("I2", 0.8),
            ("I_t", 0.3),
            ("k_p", 5.7),
            ("k_s", 4.9),
            ("k_t", 1.9),
        ],
        &[("T_crank", 0.0), ("T_load", 0.0)],
    );
    let p = of(&numbers);
    let by_hand = ByHand {
        inertia: ["I1", "I2", "I_t"].map(&p).to_vec(),
        springs: vec![
            (p("k_p"), vec![(0, p("r1")), (1, -p("r2"))]),
            (p("k_s"), vec![(0, -p("r1")), (1, p("r2")), (2, p("a"))]),
            (p("k_t"), vec![(2, 1.0)]),
        ],
    };
    compare::<belt_drive::BeltDrive>(&numbers, &by_hand, |q| {
        vec![q("theta"), (p("r1") * q("theta") - q("s")) / p("r2"), q("psi")]
    });
}

const STAGE: Numbers = &[
    ("Z_s", 27.0),
    ("Z_r", 99.0),
    ("r_s", 0.7),
    ("alpha", 0.41),
    ("I_s", 0.4),
    ("I_c", 2.7),
    ("I_r", 3.7),
    ("I_p", 0.3),
    ("m_p", 0.8),
    ("k_r", 9.1),
    ("k_s1", 5.1),
    ("k_r1", 6.1),
    ("k_s2", 5.2),
    ("k_r2", 6.2),
    ("k_s3", 5.3),
    ("k_r3", 6.3),
];
/// The further planets, one after another.
const FURTHER: [(&str, f64); 8] = [
    ("k_s4", 5.4),
    ("k_r4", 6.4),
    ("k_s5", 5.5),
    ("k_r5", 6.5),
    ("k_s6", 5.6),
    ("k_r6", 6.6),
    ("k_s7", 5.7),
    ("k_r7", 6.7),
];
const PLANE: [(&str, f64); 7] =
    [("m_s", 1.3), ("m_c", 4.1), ("m_r", 3.3), ("kb_s", 7.1), ("kb_c", 7.3), ("kb_r", 7.7), ("kb_p", 8.3)];

/// Base radii of sun, planet and ring, and radius of the planets' circle.
fn radii(p: &impl Fn(&str) -> f64) -> [f64; 4] {
    let [r_s, r_r] = [p("r_s"), p("r_s") * p("Z_r") / p("Z_s")];
    [r_s, (r_r - r_s) / 2.0, r_r, (r_r + r_s) / 2.0 / p("alpha").cos()]
}

/// Absolute rotations of sun and carrier, and of a planet that is `beyond` rolling.
fn rotations(p: &impl Fn(&str) -> f64, theta: f64, theta_c: f64) -> (f64, f64, impl Fn(f64) -> f64) {
    let [_, r_p, ..] = radii(p);
    let carrier = theta / p("Z_r") + theta_c;
    let (z_s, z_p) = (p("Z_s"), (p("Z_r") - p("Z_s")) / 2.0);
    (carrier + theta / z_s, carrier, move |beyond| carrier - theta / z_p + beyond / r_p)
}

fn planetaries() {
    fn check<D: Derived<N>, const N: usize>(n: usize) {
        let numbers = with(STAGE, &[&TORQUES, &FURTHER[..2 * (n - 3)]].concat());
        let p = of(&numbers);
        let [r_s, r_p, r_r, a] = radii(&p);
        // Sun, carrier, ring, planets. The planets' masses ride on the carrier; r_s + r_p = r_r - r_p = a cos(alpha).
        let mut by_hand = ByHand {
            inertia: vec![p("I_s"), p("I_c") + n as f64 * p("m_p") * a * a, p("I_r")],
            springs: vec![(p("k_r"), vec![(2, 1.0)])],
        };
        for i in 0..n {
            by_hand.inertia.push(p("I_p"));
            let (sun, ring) = (p(&format!("k_s{}", i + 1)), p(&format!("k_r{}", i + 1)));
            by_hand.springs.push((sun, vec![(0, r_s), (3 + i, r_p), (1, -(r_s + r_p))]));
            by_hand.springs.push((ring, vec![(2, r_r), (3 + i, -r_p), (1, -(r_r - r_p))]));
        }
        compare::<D, N>(&numbers, &by_hand, |q| {
            let (sun, carrier, planet) = rotations(&p, q("theta"), q("theta_c"));
            let planets = (1..=n).map(|i| planet(q(&format!("u{i}"))));
            [sun, carrier, q("theta_r")].into_iter().chain(planets).collect()
        });
    }
    check::<planetary_3::Planetary3, 6>(3);
    check::<planetary_4::Planetary4, 7>(4);
    check::<planetary_5::Planetary5, 8>(5);
    check::<planetary_6::Planetary6, 9>(6);
    check::<planetary_7::Planetary7, 10>(7);
}

/// Lin & Parker's Eqs. (1)-(5) as printed, in absolute coordinates (x, y, u of sun, carrier and ring; zeta, eta, u of
/// each planet) with u = r theta, each mesh and bearing a spring.
fn planar_planetaries() {
    fn check<D: Derived<N>, const N: usize>(n: usize) {
        // Not evenly spaced.
        let places = [("psi1", 0.0), ("psi2", 1.1), ("psi3", 2.9), ("psi4", 4.4), ("psi5", 5.2)];
        let numbers = with(STAGE, &[&TORQUES, &PLANE[..], &places[..n], &FURTHER[..2 * (n - 3)]].concat());
        let p = of(&numbers);
        let [r_s, r_p, r_r, a] = radii(&p);
        let (sin, cos) = p("alpha").sin_cos();
        let (s, c, r) = (0, 3, 6);
        let bodies = [("m_s", "I_s", r_s), ("m_c", "I_c", a), ("m_r", "I_r", r_r)];
        let mut by_hand = ByHand {
            inertia: bodies.iter().flat_map(|(m, i, r)| [p(m), p(m), p(i) / (r * r)]).collect(),
            springs: vec![(p("k_r") / (r_r * r_r), vec![(r + 2, 1.0)])],
        };
        for (body, kb) in [(s, "kb_s"), (c, "kb_c"), (r, "kb_r")] {
            by_hand.springs.extend([(p(kb), vec![(body, 1.0)]), (p(kb), vec![(body + 1, 1.0)])]);
        }
        for (i, &(_, psi)) in places.iter().take(n).enumerate() {
            let at = 9 + 3 * i;
            let (psi_s, psi_r) = (psi - p("alpha"), psi + p("alpha"));
            by_hand.inertia.extend([p("m_p"), p("m_p"), p("I_p") / (r_p * r_p)]);
            let planet = |zeta, eta, u| [(at, zeta), (at + 1, eta), (at + 2, u)];
            let central = |body, psi: f64, u| [(body, -psi.sin()), (body + 1, psi.cos()), (body + 2, u)];
            let sun = [central(s, psi_s, 1.0), planet(-sin, -cos, 1.0)].concat();
            let ring = [central(r, psi_r, 1.0), planet(sin, -cos, -1.0)].concat();
            let tangential = [central(c, psi, 1.0), planet(0.0, -1.0, 0.0)].concat();
            let radial = vec![(c, psi.cos()), (c + 1, psi.sin()), (at, -1.0)];
            let (k_s, k_r) = (p(&format!("k_s{}", i + 1)), p(&format!("k_r{}", i + 1)));
            by_hand.springs.extend([(k_s, sun), (k_r, ring), (p("kb_p"), radial), (p("kb_p"), tangential)]);
        }
        compare::<D, N>(&numbers, &by_hand, |q| {
            let (sun, carrier, planet) = rotations(&p, q("theta"), q("theta_c"));
            let mut x = vec![q("x_s"), q("y_s"), r_s * sun, q("x_c"), q("y_c"), a * carrier];
            x.extend([q("x_r"), q("y_r"), r_r * q("theta_r")]);
            for i in 1..=n {
                let [zeta, eta, u] = ["zeta", "eta", "u"].map(|name| q(&format!("{name}{i}")));
                x.extend([zeta, a * carrier + eta, r_p * planet(u)]);
            }
            x
        });
    }
    check::<planar_planetary_3::PlanarPlanetary3, 18>(3);
    check::<planar_planetary_4::PlanarPlanetary4, 21>(4);
    check::<planar_planetary_5::PlanarPlanetary5, 24>(5);
}

fn wind_turbine_by_hand() {
    let of_stage: Vec<_> = STAGE.iter().copied().filter(|n| !["I_r", "k_r"].contains(&n.0)).collect();
    let more = [
        ("N1", 83.0),
        ("N2", 19.0),
        ("r1", 1.1),
        ("I_b", 9.7),
        ("I1", 1.9),
        ("I2", 0.5),
        ("I_g", 1.3),
        ("k_l", 8.7),
        ("k_i", 7.9),
        ("k_h", 4.7),
        ("k12", 5.9),
        ("T_wind", 0.0),
        ("T_generator", 0.0),
    ];
    let numbers = [&of_stage[..], &more].concat();
    let p = of(&numbers);
    let [r_s, r_p, r_r, a] = radii(&p);
    let r2 = p("r1") * p("N2") / p("N1");
    // Blades, carrier, sun, wheel, pinion, generator, planets.
    let mut by_hand = ByHand {
        inertia: vec![p("I_b"), p("I_c") + 3.0 * p("m_p") * a * a, p("I_s"), p("I1"), p("I2"), p("I_g")],
        springs: vec![
            twist(p("k_l"), 0, 1),
            twist(p("k_i"), 2, 3),
            (p("k12"), vec![(3, p("r1")), (4, -r2)]),
            twist(p("k_h"), 4, 5),
        ],
    };
    for i in 0..3 {
        by_hand.inertia.push(p("I_p"));
        let (sun, ring) = (p(&format!("k_s{}", i + 1)), p(&format!("k_r{}", i + 1)));
        by_hand.springs.push((sun, vec![(2, r_s), (6 + i, r_p), (1, -(r_s + r_p))]));
        by_hand.springs.push((ring, vec![(6 + i, -r_p), (1, -(r_r - r_p))]));
    }
    compare::<wind_turbine::WindTurbine>(&numbers, &by_hand, |q| {
        let (sun, carrier, planet) = rotations(&p, q("theta"), q("theta_c"));
        let (wheel, pinion) = pair(q("theta2"), q("s2"), p("N1"), p("N2"), p("r1"));
        let x = [carrier + q("psi_l"), carrier, sun, wheel, pinion, pinion - q("psi_h")];
        x.into_iter().chain((1..=3).map(|i| planet(q(&format!("u{i}"))))).collect()
    });
}

fn chains() {
    fn check<D: Derived<N>, const N: usize>() {
        let number = |name: &str, i: usize| (&*format!("{name}{i}").leak(), 1.0 + 0.1 * (i % 7) as f64);
        let mut numbers: Vec<(&'static str, f64)> = (1..=N).map(|i| number("I", i)).collect();
        numbers.extend((1..N).map(|i| number("k", i)));
        numbers.extend(TORQUES);
        let p = of(&numbers);
        let by_hand = ByHand {
            inertia: (1..=N).map(|i| p(&format!("I{i}"))).collect(),
            springs: (1..N).map(|i| twist(p(&format!("k{i}")), i - 1, i)).collect(),
        };
        compare::<D, N>(&numbers, &by_hand, |q| (1..=N).map(|i| q(&format!("theta{i}"))).collect());
    }
    check::<chain_2::Chain2, 2>();
    check::<chain_5::Chain5, 5>();
    check::<chain_32::Chain32, 32>();
}
