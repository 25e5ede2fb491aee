//! Damping that couples the modes: a train of three rotors with a damper on each shaft, compared with the matrix exponential.

use gearsim::__private::Inside;
use gearsim::scene::Scene;
use gearsim_tests::precise::exponential::Exponential;

use crate::common::{model, models};
use crate::digits::{apart, exact, in_both, judge, of};

/// All values are powers of two, so that every entry of the matrices is exact.
const TRAIN: &str = r#"
model = "train"
effects = ["viscous_friction", "torques"]
[rotors]
a = "0.5 kg*m^2"
b = "2 kg*m^2"
c = "0.25 kg*m^2"
[shafts]
ab = { between = ["a", "b"], stiffness = "4096 N*m/rad", damping = "8 N*m*s/rad" }
bc = { between = ["b", "c"], stiffness = "1024 N*m/rad", damping = "0.5 N*m*s/rad" }
[drives.motor]
rotor = "a"
torque = "64 N*m"
[loads.load]
rotor = "c"
torque = "64 N*m"
[run]
t_end = "0.5 s"
[output]
rate = "1 kHz"
"#;

#[test]
fn a_train_with_shaft_dampers_equals_the_matrix_exponential() {
    for t in ["3 ms", "0.5 s"] {
        let set = [format!("run.t_end=\"{t}\"")];
        let mut scene = Scene::parse("train", "train", TRAIN, &set, &models())
            .unwrap_or_else(|e| panic!("{}", e.render(100, false)));
        // Starts from the static equilibrium, with a different speed for each coordinate.
        scene.start.q_dot = vec![Some(1.0), Some(-2.0), Some(0.5)];
        let entry = model("train");
        let equations = entry.equations(&scene).unwrap();
        let start = entry.simulation(&scene, &*equations).unwrap().now.state.clone();
        let (m, c, k, f) =
            (equations.mass(&start.q), equations.damping(&[]), equations.stiffness(&[]), equations.load(&[]));
        let rows = |a: &nalgebra::DMatrix<f64>| std::array::from_fn(|i| std::array::from_fn(|j| a[(i, j)]));
        let load = std::array::from_fn(|i| f[i]);
        let [q, v] = of(&start);
        let system = Exponential::<192>::new::<3>(&rows(&m), &rows(&c), &rows(&k), &load);
        let (q, v) = system.over(&exact(scene.t_end)).of(&q, &v);
        let sizes = [&q, &v].map(|x| x.iter().map(|x| x.clone().pair().0.abs()).fold(0.0, f64::max));
        let errors = in_both(&scene, |now| {
            let [x, x_dot] = of(&now.state);
            (0..3).map(|i| apart(&x[i], &q[i], sizes[0]).max(apart(&x_dot[i], &v[i], sizes[1]))).fold(0.0, f64::max)
        });
        judge(&format!("coupled damping, {t}"), errors, 100.0);
    }
}
