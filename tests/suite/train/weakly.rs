//! Modes that a damper hardly reaches: the axial motion of a helical gear reaches the modes of a planet set by 1e-7 of its amplitude.

use gearsim::{Results, Scene};

use crate::random::Random;
use crate::same::difference;

fn run(text: &str) -> Results {
    Scene::from_toml("weakly", text).unwrap_or_else(|e| panic!("{e}\n{text}")).run().unwrap_or_else(|e| panic!("{e}"))
}

/// A helical pair with a damped thrust bearing drives the sun of a planet set through a shaft. `factor` gives a factor for each value.
fn scene(factor: &mut dyn FnMut() -> f64, precision: &str) -> String {
    let mut times = |value: f64| value * factor();
    let [a, b, s, c, r] = [0.004365, 0.01496, 0.3364, 0.002473, 0.003654].map(&mut times);
    let [mesh, pairs] = [33.93e6, 58.06e6].map(&mut times);
    let [mass, bearing, damping] = [9.855, 34.26e6, 9507.0].map(&mut times);
    let [shaft, support] = [182e3, 183.2e3].map(&mut times);
    let [planet, inertia] = [1.358, 0.0003478].map(&mut times);
    let [sun, suns, ring, rings] = [56.99e6, 222.9e6, 176.8e6, 157.2e6].map(&mut times);
    format!(
        "model = \"train\"\neffects = [\"stiffness_step\", \"torques\", \"viscous_friction\"]\n\
         [rotors]\na = \"{a} kg*m^2\"\nb = \"{b} kg*m^2\"\ns = \"{s} kg*m^2\"\nc = \"{c} kg*m^2\"\nr = \"{r} kg*m^2\"\n\
         [meshes.12]\nbetween = [\"a\", \"b\"]\nteeth = [19, 75]\nmodule = \"1.906 mm\"\nhelix_angle = \"19.93 deg\"\nhand = \"right\"\n\
         stiffness = {{ steps = [{{ value = \"{mesh} N/m\", width = \"1.38 rad\" }}, {{ value = \"{pairs} N/m\" }}] }}\n\
         [thrust_bearings.ta]\nrotor = \"a\"\nmass = \"{mass} kg\"\nstiffness = \"{bearing} N/m\"\ndamping = \"{damping} N*s/m\"\n\
         [shafts.o]\nbetween = [\"b\", \"s\"]\nstiffness = \"{shaft} N*m/rad\"\n[supports.r]\nrotor = \"r\"\nstiffness = \"{support} N*m/rad\"\n\
         [planets.p]\nsun = \"s\"\nring = \"r\"\ncarrier = \"c\"\nteeth = [35, 85]\nmodule = \"3.072 mm\"\ncount = 3\nmass = \"{planet} kg\"\n\
         inertia = \"{inertia} kg*m^2\"\n\
         sun_stiffness = {{ steps = [{{ value = \"{sun} N/m\", width = \"2.04 rad\" }}, {{ value = \"{suns} N/m\" }}] }}\n\
         ring_stiffness = {{ steps = [{{ value = \"{ring} N/m\", width = \"3.081 rad\" }}, {{ value = \"{rings} N/m\" }}] }}\n\
         [drives.m]\nrotor = \"a\"\ntorque = \"91.89 N*m\"\n[loads.l]\nrotor = \"c\"\ntorque = \"47.62 N*m\"\n\
         [start]\nspeed = \"335.3 rpm\"\n[run]\nt_end = \"6.172 ms\"\nprecision = \"{precision}\"\n[output]\nplots = []\nrate = \"3240.44 Hz\"\n"
    )
}

/// Each coordinate and speed agrees with compensated precision, in which these cells are computed by power series without modes.
#[test]
fn modes_that_a_damper_hardly_reaches_keep_their_digits() {
    let mut worst = 0.0f64;
    for seed in 0..12 {
        let of = |precision| {
            let mut random = Random::new(seed);
            let mut factor = || if seed == 0 { 1.0 } else { 3f64.powf(2.0 * random.unit() - 1.0) };
            run(&scene(&mut factor, precision))
        };
        let [plain, compensated] = ["plain", "compensated"].map(of);
        let (plain, compensated) = (plain.trajectory(), compensated.trajectory());
        assert_eq!(plain.len(), compensated.len());
        for (a, b) in plain.q.iter().chain(&plain.q_dot).zip(compensated.q.iter().chain(&compensated.q_dot)) {
            worst = worst.max(difference(a, b));
        }
        println!("seed {seed}: differences up to {worst:e}");
        assert!(worst < 1e-10, "seed {seed}: {worst:e}");
    }
}
