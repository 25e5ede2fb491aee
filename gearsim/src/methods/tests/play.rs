//! Play by methods by steps: every change of mode, of flanks and of clipped dampers, is an event.

use super::{difference, run};

/// The paper's gear pair with play, whose flanks hit, slip off and part.
const PLAY: [&str; 5] = [
    "effects=[\"stiffness_step\", \"damping\", \"torques\", \"backlash\"]",
    "parameters.b=\"0.02 rad\"",
    "parameters.zeta=0.1",
    "start.phi=\"0.05 rad\"",
    "run.t_end=\"5 ms\"",
];

/// The error falls with the tolerance, through the kinks of the force where dampers begin and cease to be clipped. The events are
/// those of the exact solver: their rows are compared too.
#[test]
fn errors_follow_the_tolerance() {
    let exact = run(&PLAY);
    assert!(exact.counts.impacts >= 5, "{:?}", exact.counts);
    for method in ["dopri5", "dop853", "radau"] {
        for tolerance in [1e-7, 1e-8, 1e-9, 1e-10, 1e-11] {
            let own = [format!("run.method={method}"), format!("run.tolerance={tolerance:e}")];
            let own: Vec<&str> = own.iter().map(String::as_str).collect();
            let steps = run(&[&PLAY[..], &own].concat());
            assert_eq!(steps.counts.impacts, exact.counts.impacts, "{method} {tolerance:e}");
            let off = difference(&steps.trajectory, &exact.trajectory) / tolerance;
            println!("{method} {tolerance:e}: {off:.1} of the tolerance");
            assert!(off < 1000.0, "{method} {tolerance:e}: {off:e} of the tolerance");
        }
    }
}
