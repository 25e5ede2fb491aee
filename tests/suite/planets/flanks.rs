//! Friction of the flanks of planets.

use gearsim::scene::Scene;

use crate::{common, meshes, run, unaccounted};

const EFFECTS: &str = "effects=[\"stiffness_step\",\"torques\",\"damping\",\"sliding_friction\"]";

/// From each recorded row to the next, rolling friction at each mesh takes energy or none. The energy account closes.
#[test]
fn rolling_takes_energy_at_every_mesh() {
    for model in ["planetary_3", "planar_planetary_3"] {
        let each = [
            "parameters.mu_{}=0.08",
            "laws.side_{}={steps=[{value=-1,width=\"3 rad\"},{value=1}]}",
            "laws.arm_{}={steps=[{value=\"2 mm\",width=\"3 rad\"},{value=\"3 mm\"}]}",
        ];
        let outcome =
            run(model, 3, &[EFFECTS, "run.t_end=\"4 ms\"", "run.tolerance=1e-11", "output.rate=\"50 kHz\""], &each);
        let t = &outcome.trajectory;
        for mesh in meshes(3) {
            let roll = t.work_of(&format!("roll_{mesh}")).expect("a torque of the scene");
            assert!(roll.windows(2).all(|w| w[1] <= w[0]) && roll[roll.len() - 1] < 0.0, "{model}, {mesh}");
        }
        println!("{model}: unaccounted for {:.1e}", unaccounted(&outcome));
        assert!(unaccounted(&outcome) < 1e-9, "{model}: {:e}", unaccounted(&outcome));
    }
}

type Vector = [f64; 2];

fn plus(a: Vector, b: Vector, factor: f64) -> Vector {
    [a[0] + factor * b[0], a[1] + factor * b[1]]
}

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// The direction at an angle.
fn at(angle: f64) -> Vector {
    [angle.cos(), angle.sin()]
}

/// The vector turned by 90 degrees counterclockwise.
fn turned(a: Vector) -> Vector {
    [-a[1], a[0]]
}

/// A body in the plane: place of its centre, and what accelerates it.
#[derive(Clone, Copy)]
struct Body {
    centre: Vector,
    /// Rotational speed, counterclockwise.
    speed: f64,
    force: Vector,
    moment: f64,
}

impl Body {
    /// Velocity of a point that turns with the body, by rotation alone.
    fn velocity(&self, point: Vector) -> Vector {
        let arm = turned(plus(point, self.centre, -1.0));
        [self.speed * arm[0], self.speed * arm[1]]
    }

    fn push(&mut self, point: Vector, force: Vector) {
        let arm = plus(point, self.centre, -1.0);
        self.force = plus(self.force, force, 1.0);
        self.moment += arm[0] * force[1] - arm[1] * force[0];
    }
}

/// What friction adds to the accelerations of the planar stage, by Newton's and Euler's equations. At points of the lines of action, forces
/// mu N act as vectors against the sliding of the flanks. The line of action of sun and planet touches the base circle of the sun at the
/// angle psi - alpha. That of ring and planet touches the base circle of the ring at psi + alpha.
#[test]
fn friction_in_the_plane_is_that_of_forces_as_vectors() {
    let places = [0.0, 1.9, 4.4];
    let (mu, w_mix) = (0.13, 1e-6);
    let scene = |mu: f64| -> Scene {
        let mut set = vec!["effects=[\"stiffness_step\",\"torques\",\"sliding_friction\"]".to_string()];
        for mesh in meshes(3) {
            set.push(format!("parameters.mu_{mesh}={mu}"));
            set.push(format!("parameters.w_mix_{mesh}=\"{w_mix} rad/s\""));
            set.push(format!("laws.side_{mesh}={{steps=[{{value=1}}]}}"));
            set.push(format!("laws.arm_{mesh}={{steps=[{{value=\"1 mm\"}}]}}"));
        }
        set.extend(places.iter().enumerate().map(|(i, psi)| format!("parameters.psi{}=\"{psi} rad\"", i + 1)));
        common::scene("planar_planetary_3", &set)
    };
    let (with, without) = (scene(mu), scene(0.0));
    let of = |name: &str| with.parameter(name).unwrap_or_else(|| panic!("no {name}"));
    let model = with.model;
    let place =
        |name: &str| model.coordinates.iter().position(|c| c.name == name).unwrap_or_else(|| panic!("no {name}"));
    let [z_s, z_r, r_s, alpha] = ["Z_s", "Z_r", "r_s", "alpha"].map(of);
    let h = r_s / z_s;
    let (r_r, r_p) = (h * z_r, h * (z_r - z_s) / 2.0);
    let a = (r_s + r_p) / alpha.cos();
    let mut random = 0.371;
    let mut next = |size: f64| {
        random = (random * 997.0_f64 + 0.123_456_7).fract();
        size * (2.0 * random - 1.0)
    };
    for draw in 0..20 {
        let n = model.coordinates.len();
        let mut q: Vec<f64> = (0..n).map(|_| next(1e-5)).collect();
        let mut v: Vec<f64> = (0..n).map(|_| next(1e-3)).collect();
        (q[place("theta")], v[place("theta")]) =
            (next(1.0), next(100.0) + 2000.0 * if draw % 2 == 0 { 1.0 } else { -1.0 });
        // Each mesh has one pair of teeth in contact, at the distance xi from the pitch point, positive in recess.
        let xi: Vec<f64> = (0..6).map(|_| next(8e-3)).collect();
        let laws: Vec<f64> = (model.laws.iter())
            .map(|law| {
                let Some((quantity, mesh)) = law.name.split_once('_') else { return 0.0 };
                let at = meshes(3).iter().position(|of| of == mesh).expect("a mesh");
                match quantity {
                    "k" => 3e8 + 1e7 * at as f64,
                    "side" => xi[at].signum(),
                    "arm" => xi[at].abs(),
                    _ => 0.0,
                }
            })
            .collect();
        let accelerations = |scene: &Scene| scene.acceleration(&q, &v, &laws).unwrap_or_else(|e| panic!("{e}"));
        let (rough, smooth) = (accelerations(&with), accelerations(&without));
        let added = |name: &str| rough[place(name)] - smooth[place(name)];

        // Rotations of the bodies, counterclockwise.
        let carrier = |x: &dyn Fn(&str) -> f64| x("theta") / z_r + x("theta_c");
        let sun = |x: &dyn Fn(&str) -> f64| carrier(x) + x("theta") / z_s;
        let planet = |x: &dyn Fn(&str) -> f64, i: usize| carrier(x) + (x(&format!("u{i}")) - h * x("theta")) / r_p;
        let [here, rate]: [&dyn Fn(&str) -> f64; 2] = [&|name| q[place(name)], &|name| v[place(name)]];
        let body = |centre: Vector, speed: f64| Body { centre, speed, force: [0.0; 2], moment: 0.0 };
        let (mut of_sun, mut of_ring) = (body([0.0; 2], sun(rate)), body([0.0; 2], rate("theta_r")));
        let mut of_planets = vec![];
        for (i, psi) in places.into_iter().enumerate() {
            let centre = at(psi).map(|x| a * x);
            let mut of_planet = body(centre, planet(rate, i + 1));
            let [zeta, eta] = ["zeta", "eta"].map(|name| here(&format!("{name}{}", i + 1)));
            let moved = plus(at(psi).map(|x| zeta * x), turned(at(psi)), a * carrier(here) + eta);
            for (j, ring) in [false, true].into_iter().enumerate() {
                let line = at(if ring { psi + alpha } else { psi - alpha });
                let along = turned(line);
                let (r, gear, shift, turn) = match ring {
                    false => (r_s, &mut of_sun, [here("x_s"), here("y_s")], sun(here)),
                    true => (r_r, &mut of_ring, [here("x_r"), here("y_r")], here("theta_r")),
                };
                // The contact of sun and planet moves along the line of action in the direction of the sun's rotation. The contact of ring
                // and planet moves against it, because the planet turns backwards.
                let (pitch, recess) = if ring { (-r_r * alpha.tan(), -1.0) } else { (r_s * alpha.tan(), 1.0) };
                let point = plus(line.map(|x| r * x), along, pitch + recess * xi[2 * i + j]);
                let other = planet(here, i + 1) * r_p * if ring { -1.0 } else { 1.0 };
                let depth = dot(plus(shift, moved, -1.0), along) + r * turn + other;
                let normal = laws
                    [model.laws.iter().position(|law| law.name == format!("k_{}", meshes(3)[2 * i + j])).unwrap()]
                    * depth.abs();
                // The sliding speed is that of rigid gears: from the rotations alone, minus its value at the pitch point, where gears that
                // roll do not slide.
                let pitch_point = plus(line.map(|x| r * x), along, pitch);
                let sliding = |p: Vector| dot(plus(gear.velocity(p), of_planet.velocity(p), -1.0), line);
                let against = -mu * normal * (sliding(point) - sliding(pitch_point)).signum();
                gear.push(point, line.map(|x| against * x));
                of_planet.push(point, line.map(|x| -against * x));
            }
            of_planets.push(of_planet);
        }
        let scale = 1e-9 * ["x_s", "y_s"].map(|name| added(name).abs()).into_iter().fold(1e3, f64::max);
        let check = |what: &str, found: f64, expected: f64| {
            let size = expected.abs().max(found.abs());
            assert!((found - expected).abs() < 1e-6 * size + scale, "{draw}, {what}: {found}, not {expected}");
        };
        for (part, body) in [("s", of_sun), ("r", of_ring)] {
            check(&format!("x_{part}"), added(&format!("x_{part}")), body.force[0] / of(&format!("m_{part}")));
            check(&format!("y_{part}"), added(&format!("y_{part}")), body.force[1] / of(&format!("m_{part}")));
        }
        check("sun", sun(&added), of_sun.moment / of("I_s"));
        check("ring", added("theta_r"), of_ring.moment / of("I_r"));
        check("carrier", carrier(&added), 0.0);
        for (i, (psi, body)) in places.into_iter().zip(of_planets).enumerate() {
            let i = i + 1;
            check(&format!("zeta{i}"), added(&format!("zeta{i}")), dot(body.force, at(psi)) / of("m_p"));
            let tangential = a * carrier(&added) + added(&format!("eta{i}"));
            check(&format!("eta{i}"), tangential, dot(body.force, turned(at(psi))) / of("m_p"));
            check(&format!("planet {i}"), planet(&added, i), body.moment / of("I_p"));
        }
    }
}
