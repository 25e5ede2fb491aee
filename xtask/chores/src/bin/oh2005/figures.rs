//! The plots: Figs. 3 and 4 in the paper's form, the loss of speed, and the scan for the peak at 3.2 wd.

use gearsim::plot::{Axis, Figure, Panel, Series, Style};

use crate::measure::Bands;
use crate::paper::{self, RATE, Set, T0};
use crate::spectra::ZETA;

/// The stem of the file names of a figure, and the figure.
pub type Named = (&'static str, Figure);

/// All figures.
pub fn all() -> anyhow::Result<Vec<Named>> {
    Ok(vec![
        ("fig3", energy()?),
        ("fig4_600rpm", spectra(600)?),
        ("fig4_4500rpm", spectra(4500)?),
        ("speed", speed()?),
        ("scan", scan()?),
    ])
}

fn energy() -> anyhow::Result<Figure> {
    let mut series = vec![];
    for (index, set) in [Set::Exact, Set::Rigid].into_iter().enumerate() {
        let run = paper::energy(set, T0)?.trajectory;
        let u = (0..run.len()).map(|i| run.energy(i)).collect();
        series.push(Series::new(index, set.label(), run.t, u));
    }
    Ok(Figure {
        title: "Fig. 3: energy at 300 rpm".into(),
        subtitle: Some(format!("ζ = 0.1, T₀ = {T0} N m")),
        x: Axis::linear("time t", "s"),
        panels: vec![Panel { y: Axis::linear("U = T + V − W", "J"), series }],
    })
}

fn spectra(rpm: u32) -> anyhow::Result<Figure> {
    let letters = if rpm == 600 { ["a", "b", "c"] } else { ["d", "e", "f"] };
    let wd = paper::pair(ZETA, T0).wd();
    let mut panels = vec![];
    for (set, letter) in Set::ALL.into_iter().zip(letters) {
        let run = paper::spectrum(set, rpm, ZETA, T0, 0.5)?.trajectory;
        let bands = Bands::averaged(&run.q[1], RATE, wd)?;
        let label = format!("({letter}) {}", set.label());
        let curve = Series { style: Style::PLAIN, ..Series::new(0, label, bands.frequency(), bands.spectrum.density) };
        panels.push(Panel { y: Axis::log10("PSD of φ", "rad^2/Hz").between(1e-16, 1e-5), series: vec![curve] });
    }
    Ok(Figure {
        title: format!("Fig. 4: power spectral density of φ at {rpm} rpm"),
        subtitle: Some(format!("ζ = {ZETA}, T₀ = {T0} N m; 0.5 s, Welch, Hann window, mean of 4 segments")),
        x: Axis::linear("frequency ω/ω_{d}", "").between(0.0, 5.0),
        panels,
    })
}

/// Mean speed over 10 ms against time, from 600 rpm.
fn speed() -> anyhow::Result<Figure> {
    let start = paper::pair(ZETA, T0).start(600.0).theta_dot;
    let mut series = vec![];
    for (index, t0) in [5.0, 10.0, 15.0, 20.0].into_iter().enumerate() {
        let run = paper::spectrum(Set::Exact, 600, ZETA, t0, 4.0)?.trajectory;
        let step = (0.01 * RATE) as usize;
        let pairs = (0..run.len() - step).step_by(step).map(|i| (i, i + step));
        let mean = |(a, b): (usize, usize)| (run.q[0][b] - run.q[0][a]) / (run.t[b] - run.t[a]) / start;
        let (x, y) = pairs.map(|p| (0.5 * (run.t[p.0] + run.t[p.1]), mean(p))).unzip();
        series.push(Series::new(index, format!("T₀ = {t0} N m"), x, y));
    }
    Ok(Figure {
        title: "Exact equations, from 600 rpm: the gear pair loses speed".into(),
        subtitle: Some(format!("ζ = {ZETA}; mean over 10 ms")),
        x: Axis::linear("time t", "s").between(0.0, 4.0),
        panels: vec![Panel { y: Axis::linear("speed / speed at the start", "").between(-0.1, 1.05), series }],
    })
}

/// Power of the exact spectrum over that of the classical one, in bands of four mesh orders, against frequency.
fn scan() -> anyhow::Result<Figure> {
    let wd = paper::pair(ZETA, T0).wd();
    let window = 0.1;
    let half = 2.0 * crate::spectra::mesh(600);
    let centres: Vec<f64> = (0..=200).map(|i| 0.26 + 0.0237 * f64::from(i)).collect();
    let mut series = vec![];
    for (index, t0) in [10.0, 30.0, 50.0, 100.0, 150.0, 300.0].into_iter().enumerate() {
        let bands = |set| Bands::of(&paper::spectrum(set, 600, ZETA, t0, window)?.trajectory.q[1], RATE, window, wd);
        let (exact, classical) = (bands(Set::Exact)?, bands(Set::Classical)?);
        let ratio = |w: &f64| exact.power((w - half, w + half)) / classical.power((w - half, w + half));
        series.push(Series::new(index, format!("T₀ = {t0} N m"), centres.clone(), centres.iter().map(ratio).collect()));
    }
    let reported = Series {
        style: Style::PLAIN,
        ..Series::new(0, "reported: 400 near 3.2 ω_{d}", vec![3.1, 3.3], vec![400.0; 2])
    };
    series.push(reported);
    Ok(Figure {
        title: "Power of φ at 600 rpm, exact over classical".into(),
        subtitle: Some(format!("ζ = {ZETA}, Rayleigh damping, window of {window} s, bands of four mesh orders")),
        x: Axis::linear("frequency ω/ω_{d}", "").between(0.0, 5.0),
        panels: vec![Panel { y: Axis::log10("power ratio", "").between(1e-2, 1e3), series }],
    })
}
