//! Tests of the plots: the texts in them, their size, and errors on bad data.

use std::f64::consts::TAU;

use super::*;
use crate::model::{Law, Model, Role};
use crate::output::fixture::{MODEL, REFERENCE, oscillator};
use crate::output::lines::Lines;
use crate::scene::Spectrum;
use crate::sweep::row::{Row, Status};
use crate::sweep::spectra::NamedSpectrum;
use crate::sweep::{Manifest, Request, Sweep};
use crate::trajectory::Moment;

static ASKED: std::sync::LazyLock<Output> = std::sync::LazyLock::new(|| Output {
    rate: 2e4,
    events: true,
    plots: vec![],
    default_plots: false,
    record: vec![],
    spectrum: Spectrum::DEFAULT,
    rainflow: vec!["dte"],
    sound: None,
    csv: false,
    from: 0.0,
    most_rows: 1_000_000,
    most_time: None,
});

pub(super) fn run<'a>(label: &'a str, trajectory: &'a Trajectory) -> Run<'a> {
    Run { label, trajectory, reference_frequency: Some(REFERENCE), scene: "two_steps", asked: &ASKED, none_from: None }
}

/// A mesh of 23 teeth on a rotor that makes 20 turns. Its transmission error has `lines`, each with its multiple of the mesh order and its
/// amplitude.
pub(super) fn geared(lines: &[(f64, f64)]) -> Trajectory {
    static LAWS: [Law; 1] = [Law {
        name: "k",
        unit: "N/m",
        phase: "theta",
        period: TAU,
        rolling: true,
        held: &[],
        with: None,
        role: Role::Stiffness,
        doc: "",
    }];
    static GEARED: Model = Model { laws: &LAWS, ..MODEL };
    let n = 40_001;
    let mut run = Trajectory::new(&GEARED, &[0, 1], &[0, 1]);
    run.t = (0..n).map(|i| i as f64 / 20e3).collect();
    run.moment = vec![Moment::Sample; n];
    let phase = |t: &f64| TAU * 230.0 * t;
    run.q = vec![run.t.iter().map(phase).collect(), vec![0.0; n]];
    run.q_dot = vec![vec![TAU * 230.0; n], vec![0.0; n]];
    run.outputs[0].1 = vec![TAU * 10.0; n];
    let error = |t: &f64| lines.iter().map(|(m, a)| a * (m * phase(t)).sin()).sum();
    run.outputs[1].1 = run.t.iter().map(error).collect();
    for column in [&mut run.kinetic, &mut run.strain, &mut run.work, &mut run.dissipated, &mut run.residual] {
        *column = vec![0.0; n];
    }
    run.torque_work.iter_mut().for_each(|(_, column)| *column = vec![0.0; n]);
    run
}

#[test]
fn every_plot_has_its_labels_units_and_scene_name() {
    let recorded = oscillator(4000);
    let expected: [(&str, &[&str]); 3] = [
        ("energy", &["U = T + V − W", "dissipated", "residual [", "time t [s]"]),
        ("motion", &["φ [rad]", "dφ/dt [rad/s]", "dθ/dt [", "time t [s]"]),
        ("spectrum", &["PSD of φ [rad²/Hz]", "frequency f [Hz]", "10⁻"]),
    ];
    for (name, words) in expected {
        let figure = (find(name).unwrap().draw)(&[run("exact", &recorded)]).unwrap();
        let svg = figure.svg().unwrap();
        for word in words.iter().chain(&["two_steps"]) {
            assert!(svg.contains(word), "{name}: no `{word}`");
        }
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{name}");
        assert!(!svg.contains("<text x=\"84.0\" y=\"0"), "{name}");
        let png = figure.png().unwrap();
        assert_eq!(&png[1..4], b"PNG");
    }
}

/// Frequencies are in Hz; over the natural frequency where the scene asks for it and the run has one.
#[test]
fn frequencies_are_in_hertz_unless_the_scene_asks_for_the_natural_one() {
    let recorded = oscillator(4000);
    let asked = Output { spectrum: Spectrum { natural: true, ..Spectrum::DEFAULT }, ..ASKED.clone() };
    let natural = Run { asked: &asked, ..run("exact", &recorded) };
    let without = Run { reference_frequency: None, ..natural };
    for (run, label) in
        [(natural, "frequency ω/ω_{d}"), (without, "frequency f"), (run("exact", &recorded), "frequency f")]
    {
        assert_eq!((spectrum::PLOT.draw)(&[run]).unwrap().x.label, label);
    }
}

/// An output that is always zero is not drawn: it belongs to an effect that the scene does not have.
#[test]
fn outputs_that_are_zero_throughout_are_not_drawn() {
    let mut recorded = oscillator(100);
    let names = |recorded: &Trajectory| {
        let figure = (outputs::PLOT.draw)(&[run("exact", recorded)])?;
        Ok::<_, PlotError>(figure.panels.into_iter().flat_map(|p| p.series).map(|s| s.label).collect::<Vec<_>>())
    };
    let all = names(&recorded).unwrap();
    recorded.outputs[1].1.iter_mut().for_each(|x| *x = 0.0);
    assert_eq!(names(&recorded).unwrap().len() + 1, all.len());
    recorded.outputs[0].1.iter_mut().for_each(|x| *x = 0.0);
    assert!(matches!(names(&recorded), Err(PlotError::Nothing { .. })));
}

/// The name of an axis that is longer than the axis has its unit in a second line, and no name is longer than its axis.
#[test]
fn names_of_axes_are_not_longer_than_the_axes() {
    let recorded = oscillator(100);
    let mut figure = (outputs::PLOT.draw)(&[run("exact", &recorded)]).unwrap();
    figure.panels = vec![figure.panels[0].clone(); 3];
    figure.panels[1].y = Axis::linear("PSD of mesh_deflection_12", "um^2/Hz");
    figure.panels[2].y = Axis::linear("a name that is longer than its axis even without the unit", "um");
    let svg = figure.svg().unwrap();
    let size = |words: &str| {
        let line =
            svg.lines().find(|line| line.contains(&format!(">{words}<"))).unwrap_or_else(|| panic!("no `{words}`"));
        line.split("font-size=\"").nth(1).and_then(|rest| rest.split('"').next()?.parse::<f64>().ok()).unwrap()
    };
    for words in ["PSD of mesh_deflection_12", "[um²/Hz]", "a name that is longer than its axis even without the unit"]
    {
        let length = size(words) * text::ems(words);
        assert!(length <= 190.0, "{words}: {length}");
    }
    assert!(size("speed [rpm]") == 13.0, "a name that fits has the usual size");
}

#[test]
fn the_legend_names_overlaid_runs_once() {
    let (a, b) = (oscillator(4000), oscillator(3000));
    for plot in PLOTS {
        let svg = (plot.draw)(&[run("exact", &a), run("classical", &b)]).unwrap().svg().unwrap();
        assert_eq!(svg.matches(">classical<").count(), 1, "{}", plot.name);
    }
}

#[test]
fn the_svg_of_a_long_run_is_small() {
    let recorded = oscillator(300_000);
    for plot in PLOTS {
        let svg = (plot.draw)(&[run("exact", &recorded)]).unwrap().svg().unwrap();
        assert!(svg.len() < 1_000_000, "{}: {} bytes", plot.name, svg.len());
    }
}

#[test]
fn a_plot_with_values_that_are_not_finite_has_no_nan_and_no_inf_in_its_svg() {
    let mut recorded = oscillator(1000);
    recorded.kinetic[300] = f64::NAN;
    recorded.residual[500] = f64::INFINITY;
    let svg = (energy::PLOT.draw)(&[run("exact", &recorded)]).unwrap().svg().unwrap();
    assert!(!svg.contains("NaN") && !svg.contains("inf"));
}

#[test]
fn drawing_empty_or_inconsistent_data_is_an_error() {
    let empty = Trajectory::new(&MODEL, &[], &[]);
    for plot in PLOTS {
        assert!((plot.draw)(&[]).is_err());
        assert!((plot.draw)(&[run("exact", &empty)]).is_err());
    }
    let mut ragged = oscillator(100);
    ragged.strain.pop();
    for plot in PLOTS {
        assert!((plot.draw)(&[run("exact", &ragged)]).is_err());
    }
    let short = oscillator(3);
    assert!(matches!((spectrum::PLOT.draw)(&[run("exact", &short)]), Err(PlotError::Spectrum { .. })));
    let message = find("spectra").unwrap_err().to_string();
    assert_eq!(
        message,
        "there is no plot `spectra`; there are `outputs`, `orders`, `energy`, `spectrum`, `motion`, \
         `order_cuts`, `order_waterfall`, `run_up`, `rainflow`, `load_duration`"
    );
    let series = Series::new(0, "odd", vec![0.0], vec![]);
    let panel = Panel { y: Axis::linear("y", "1"), series: vec![series] };
    let x = Axis::linear("x", "1");
    let figure = Figure { title: String::new(), subtitle: None, x, panels: vec![panel] };
    assert!(matches!(figure.svg(), Err(PlotError::Ragged { .. })));
}

/// Draws all plots into the folder `GEARSIM_LOOK`, for inspection by eye.
#[test]
#[ignore = "writes pictures to look at: GEARSIM_LOOK=folder cargo test -p gearsim look -- --ignored"]
fn look() {
    let folder = std::path::PathBuf::from(std::env::var_os("GEARSIM_LOOK").unwrap());
    std::fs::create_dir_all(&folder).unwrap();
    let exact = oscillator(2000);
    let mut other = oscillator(2000);
    for i in 0..other.len() {
        let drift = 2e-2 * (other.t[i] / 8e-3).floor();
        other.kinetic[i] += drift;
        other.residual[i] += drift;
        other.q[1][i] *= 1.2;
    }
    let (exact, other) = (run("exact", &exact), run("rigid kinematic, Eqs. (4), (5)", &other));
    let third = Run { label: "classical, Eq. (6)", ..exact };
    let long = oscillator(200_000);
    let long = run("exact", &long);
    let plain = Run { reference_frequency: None, ..exact };
    for plot in PLOTS {
        let cases: [(&str, &[Run<'_>]); 4] =
            [("long", &[long]), ("one", &[exact]), ("three", &[exact, other, third]), ("plain", &[plain])];
        for (case, runs) in cases {
            let figure = (plot.draw)(runs).unwrap();
            let file = |end: &str| folder.join(format!("{}_{case}.{end}", plot.name));
            std::fs::write(file("svg"), figure.svg().unwrap()).unwrap();
            std::fs::write(file("png"), figure.png().unwrap()).unwrap();
        }
    }
}

/// Maps and waterfalls of a small sweep: axes in the units in which they were varied, and gaps where a value is NaN.
#[test]
fn plots_of_sweeps_have_their_labels_and_units() {
    let drawn = |vary: &[&str], samples, quantity: &str, plot: &SweepPlot| {
        let manifest = sweep_of(vary, samples);
        let layout = manifest.layout(crate::known::MODELS).unwrap();
        let numbers = |point: usize| {
            let gap = |i: usize| if point == 1 { f64::NAN } else { 10f64.powi(point as i32 % 7) * (i + 1) as f64 };
            (0..layout.columns.len()).map(gap).collect()
        };
        let spectrum = |point: usize| NamedSpectrum {
            coordinate: "phi".into(),
            frequency: vec![0.0, 10.0, 20.0, 30.0],
            density: vec![1e-3, 1e-6 * (point + 1) as f64, 1e-9, 1e-30],
        };
        let row = |point| Row {
            point,
            status: Status::Done,
            reason: String::new(),
            remarks: vec![],
            numbers: numbers(point),
            spectra: vec![spectrum(point)],
        };
        let rows: Rows = (0..manifest.points).map(|point| (point, row(point))).collect();
        let drawn = (plot.draw)(&SweepResults { scene: "case", layout: &layout, rows: &rows, quantity });
        let picture = drawn.and_then(|drawn| drawn.picture());
        picture.inspect(|picture| assert!(!picture.svg().contains("NaN") && !picture.svg().contains("inf")))
    };
    let (torque, speed) = ("parameters.T0=log:1 N*m:1000 N*m:4", "start.speed=100 rpm:300 rpm:3");
    /// The varied keys, number of samples, quantity drawn, plot, and the texts that must occur in the SVG.
    type Case<'a> = (&'a [&'a str], Option<usize>, &'a str, &'a SweepPlot, &'a [&'a str]);
    let cases: [Case<'_>; 5] = [
        (
            &[torque, speed],
            None,
            "phi_max",
            &map::PLOT,
            &["Maximum of φ", "T0 [N m]", "speed at the start [rpm]", ">none<", ">10³<"],
        ),
        (
            &[speed],
            None,
            "first_reflection",
            &map::PLOT,
            &["Time of the first reflection", "first reflection [s]", "[rpm]"],
        ),
        (
            &["parameters.T0=uniform:1 N*m:9 N*m", speed],
            Some(4),
            "theta_dot",
            &map::PLOT,
            &[">dθ/dt at the end<", "12 points"],
        ),
        (&[speed], None, "phi", &waterfall::PLOT, &["PSD of φ [rad²/Hz]", "frequency f [Hz]", "[rpm]"]),
        (&["parameters.zeta=0.1,0.2,0.4"], None, "residual", &map::PLOT, &["zeta", "Energy unaccounted for"]),
    ];
    for (vary, samples, quantity, plot, words) in cases {
        let picture = drawn(vary, samples, quantity, plot).unwrap();
        for word in words {
            assert!(picture.svg().contains(word), "{vary:?} {quantity}: no `{word}`");
        }
        assert_eq!(&picture.png().unwrap()[1..4], b"PNG");
    }
    for (vary, quantity, plot) in [(&[torque, speed], "phi", &waterfall::PLOT), (&[torque, speed], "chi", &map::PLOT)] {
        assert!(matches!(drawn(vary, None, quantity, plot), Err(PlotError::Nothing { .. })), "{quantity}");
    }
}

fn sweep_of(vary: &[&str], samples: Option<usize>) -> Manifest {
    let scene = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/scenes/oh2005/energy_300rpm.toml");
    let request = Request {
        vary: vary.iter().map(|axis| axis.to_string()).collect(),
        samples,
        record: ["events", "state", "energy", "extremes"].map(Into::into).into(),
        spectra: true,
        ..Request::default()
    };
    Manifest::new(&Sweep::load(&scene, crate::known::MODELS, &request).unwrap(), &request, None)
}

/// The same mesh while its speed rises to three times the first value.
fn run_up() -> Trajectory {
    let mut up = geared(&[(1.0, 1.0)]);
    up.q[0] = up.t.iter().map(|t| TAU * 230.0 * t * (0.5 + 0.25 * t)).collect();
    up.q_dot[0] = up.t.iter().map(|t| TAU * 230.0 * (0.5 + 0.5 * t)).collect();
    up.outputs[0].1 = up.t.iter().map(|t| TAU * 10.0 * (0.5 + 0.5 * t)).collect();
    up
}

/// Lines of a run-up have orders, but no frequency; those at constant speed have both.
#[test]
fn lines_have_a_frequency_where_the_speed_is_constant() {
    for (run, steady) in [(geared(&[(1.0, 1.0)]), true), (run_up(), false)] {
        let lines = Lines::of(&run, &Spectrum::DEFAULT).unwrap().unwrap();
        let table = lines.table(&Spectrum::DEFAULT).unwrap();
        let all = |name: &str| table.numbers(name).unwrap().iter().all(|x| x.is_finite());
        assert!(all("order_of_rotor_speed") && all("frequency") == steady, "{steady}");
    }
}

/// Outputs that differ by less than a line width are one curve with all their names.
#[test]
fn equal_outputs_are_one_curve() {
    static TWICE: std::sync::LazyLock<[crate::model::Output; 3]> = std::sync::LazyLock::new(|| {
        ["mesh_deflection", "dte", "other"].map(|name| crate::model::Output { name, ..MODEL.outputs[1] })
    });
    let mut recorded = oscillator(200);
    let column = recorded.outputs[1].1.clone();
    let scaled = |factor: f64| column.iter().map(|x| factor * x).collect();
    recorded.outputs = vec![(&TWICE[0], column.clone()), (&TWICE[1], scaled(1.0005)), (&TWICE[2], scaled(1.1))];
    let figure = (outputs::PLOT.draw)(&[run("exact", &recorded)]).unwrap();
    let names: Vec<_> = figure.panels[0].series.iter().map(|series| &*series.label).collect();
    assert_eq!(names, ["mesh_deflection = dte", "other"]);
}

/// A run-up has order cuts in place of a spectrum by default, a run at constant speed a spectrum; plots that a scene names stay.
#[test]
fn a_run_up_has_order_cuts_by_default() {
    let named = Output { plots: vec!["orders".into(), "spectrum".into()], ..ASKED.clone() };
    let asked = Output { default_plots: true, ..named.clone() };
    let steady = geared(&[(1.0, 1.0)]);
    let up = run_up();
    let chosen = |trajectory, asked| chosen(&[Run { asked, ..run("exact", trajectory) }]);
    assert_eq!(chosen(&up, &asked), ["orders", "order_cuts"]);
    assert_eq!(chosen(&steady, &asked), ["orders", "spectrum"]);
    assert_eq!(chosen(&up, &named), ["orders", "spectrum"]);
}

#[test]
fn compared_runs_show_their_outputs_first_and_speeds_after_errors() {
    let recorded = oscillator(400);
    let asked = Output { plots: vec!["energy".into(), "motion".into()], ..ASKED.clone() };
    let runs = ["exact", "classical"].map(|label| Run { asked: &asked, ..run(label, &recorded) });
    assert_eq!(compared(&runs), ["outputs", "energy", "motion"]);
    let figure = (outputs::PLOT.draw)(&runs).unwrap();
    let labels: Vec<_> = figure.panels.iter().map(|panel| (&*panel.y.label, panel.series.len())).collect();
    assert_eq!(labels, [("dte", 2), ("rotor_speed", 2)]);
}
