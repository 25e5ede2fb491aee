//! Numerical methods on play: every change of mode, of flanks and of clipped dampers, is an event.

use super::{difference, run};

/// The paper's gear pair with play, whose flanks hit, slip off and part.
const PLAY: [&str; 5] = [
    "effects=[\"stiffness_step\", \"damping\", \"torques\", \"backlash\"]",
    "parameters.b=\"0.02 rad\"",
    "parameters.zeta=0.1",
    "start.phi=\"0.05 rad\"",
    "run.t_end=\"5 ms\"",
];

/// The error falls with the tolerance, although the force has kinks where clipping of the dampers begins and ends. The events are those of
/// the exact solver: their rows are compared too.
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

/// A flank that rests at its edge without load separates and meets again by rounding errors. These contacts do not count as impacts.
#[test]
fn a_flank_that_rests_at_its_edge_has_no_impacts() {
    // A step of the transmission error moves the edge away from the flank, and another step moves it back. There are no torques.
    let rests = [
        "effects=[\"stiffness_step\", \"backlash\", \"transmission_error\"]",
        "parameters.b=\"0.0014082247039156367 rad\"",
        "parameters.I1=\"0.002415559114498941 kg*m^2\"",
        "start.speed=\"-471.238898038469 rad/s\"",
        "start.theta=\"-11.371696024151538 rad\"",
    ];
    // Here a step of the transmission error moves the edge back until the flank touches it.
    let touches = [
        "effects=[\"damping\", \"backlash\", \"transmission_error\", \"stiffness_step\"]",
        "parameters.b=\"1e-3 rad\"",
        "parameters.I1=\"2890 kg*mm^2\"",
        "start.speed=\"942.477796076938 rad/s\"",
        "start.theta=\"-2.2561193629346716 rad\"",
    ];
    let both = [
        "laws.e.steps=[{ value = \"1e-4 rad\", width = \"3.7699 rad\" }, { value = \"-1e-4 rad\" }]",
        "run.t_end=\"0.5 ms\"",
    ];
    for (own, least_cell_changes) in [(rests, 2), (touches, 4)] {
        for method in ["exact", "dop853", "radau"] {
            let outcome = run(&[&own[..], &both, &[&format!("run.method={method}")]].concat());
            assert_eq!(outcome.counts.impacts, 0, "{method}: {:?}", outcome.counts);
            assert!(outcome.counts.cell_changes >= least_cell_changes, "{method}: {:?}", outcome.counts);
        }
    }
}
