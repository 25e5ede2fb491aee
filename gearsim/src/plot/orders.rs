//! Order spectra of the recorded transmission errors and forces, over orders of a shaft: peak amplitudes.

use super::figure::name_once;
use super::marks::{MOST, MarkedCurve, marks};
use super::outputs::{of_unit, sized};
use super::spectrum::reach;
use super::{Axis, Figure, Panel, Plot, PlotError, Run, Series, first_run, scene_names};
use crate::analysis::orders::{CLOSER, Orders, PROMINENCE, Turning, meshes, reference_shaft};
use crate::analysis::spectrum::SpectrumError;
use crate::model::Output;
use crate::output::number::short;

/// The entry in [`super::PLOTS`].
pub const PLOT: Plot = Plot { name: "orders", draw };

/// The units of the outputs that are drawn; the first output of each.
const UNITS: [&str; 4] = ["m", "rad", "N", "N*m"];
/// The axis reaches so far that less than this fraction of the power lies beyond it. Forces step where stiffnesses do, and their lines fall
/// slowly.
pub(crate) const CONTENT: f64 = 1e-2;
/// The axis of amplitudes begins at this part of the highest line.
pub(crate) const DECADES: f64 = 1e-6;

/// The samples of each run at the angles of a shaft.
pub(super) fn turnings(runs: &[Run<'_>], shaft: &'static Output) -> Result<Vec<Turning>, PlotError> {
    let turning =
        |run: &Run<'_>| Turning::of(run.trajectory, shaft.name, run.asked.spectrum.from).map_err(of(run, shaft.name));
    runs.iter().map(turning).collect()
}

/// Why an output of a run has no spectrum.
pub(super) fn of(run: &Run<'_>, signal: &'static str) -> impl Fn(SpectrumError) -> PlotError {
    move |source| PlotError::Spectrum { signal, run: run.label.to_owned(), source }
}

fn draw(runs: &[Run<'_>]) -> Result<Figure, PlotError> {
    let first = first_run(PLOT.name, runs)?.trajectory;
    let nothing = |why: String| PlotError::Nothing { plot: PLOT.name, why };
    let shaft = reference_shaft(first, runs[0].asked.spectrum.shaft)
        .ok_or_else(|| nothing("the run recorded no speed of a rotor".into()))?;
    let turning = turnings(runs, shaft)?;
    let from = runs[0].asked.spectrum.from;
    let meshes = meshes(first, from);
    let highest = meshes.iter().map(|mesh| mesh.frequency).fold(0.0, f64::max) / turning[0].frequency();
    let spectra = spectra(runs, &turning)?;
    let all = || spectra.iter().flat_map(|(_, all)| all.iter().flatten());
    let longest = all().filter_map(|orders| orders.order.last().copied()).fold(f64::INFINITY, f64::min);
    let end = reach(all().map(|orders| orders.highest(CONTENT)), highest, longest);
    let revolutions = all().last().map_or(0, |orders| orders.revolutions);
    let mut panels = vec![];
    for (output, all) in spectra {
        let (mut series, mut peak) = (vec![], 0.0_f64);
        for (n, (run, orders)) in runs.iter().zip(all).enumerate() {
            let Some(orders) = orders else { continue };
            peak = orders.amplitude.iter().skip(1).copied().fold(peak, f64::max);
            let label = if runs.len() > 1 { run.label } else { "" };
            series.push(Series::new(n, label, orders.order, orders.amplitude));
        }
        let (shown, factor) = sized(output.unit, peak);
        series.iter_mut().flat_map(|series| &mut series.y).for_each(|y| *y *= factor);
        peak *= factor;
        let range = (DECADES * peak, 2.0 * peak);
        let y = Axis::log10(output.name, shown).between(range.0, range.1);
        if peak > 0.0 {
            let curve = MarkedCurve { series: &series[0], closer: CLOSER, least: &|median| PROMINENCE * median };
            let marks = marks(&meshes, (turning[0].frequency(), end, MOST), range, curve);
            let (lines, symbols): (Vec<_>, Vec<_>) = marks.into_iter().partition(|mark| mark.style.width > 0.0);
            panels.push(Panel { y, series: lines.into_iter().chain(series).chain(symbols).collect() });
        }
    }
    name_once(&mut panels, |_| true);
    let orders = meshes.iter().map(|mesh| format!("{} {}", mesh.name, short(mesh.frequency / turning[0].frequency())));
    let orders = orders.collect::<Vec<_>>().join(", ");
    if panels.is_empty() {
        return Err(nothing("the run recorded no transmission error, force or torque that varies".into()));
    }
    let subtitle = format!(
        "{}; {revolutions} revolutions, Hann window, peak amplitudes; mesh orders {}",
        scene_names(runs),
        if meshes.is_empty() { "none" } else { &orders }
    );
    let x = Axis::linear(format!("order of {}", shaft.name), "").between(0.0, end);
    Ok(Figure { title: "Orders".into(), subtitle: Some(subtitle), x, panels })
}

/// The first output of each unit, with its spectrum in each run that recorded it.
type Spectra = Vec<(&'static Output, Vec<Option<Orders>>)>;

fn spectra(runs: &[Run<'_>], turning: &[Turning]) -> Result<Spectra, PlotError> {
    let mut all = vec![];
    for output in UNITS.iter().filter_map(|unit| of_unit(runs[0].trajectory, unit).first().copied()) {
        let orders = runs.iter().zip(turning).map(|(run, turning)| {
            let column = run.trajectory.output(output.name);
            column.map(|column| turning.orders(column).map_err(of(run, output.name))).transpose()
        });
        all.push((output, orders.collect::<Result<Vec<_>, _>>()?));
    }
    Ok(all)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::tests::{geared, run};

    /// The axis reaches beyond the line at 12 times the mesh order if this line has most of the power, otherwise to 4.5 times the mesh
    /// order.
    #[test]
    fn the_axis_reaches_as_far_as_the_content() {
        for (multiple, amplitude, end) in [(12.0, 2.0, 12.0 * 23.0 * 1.1), (12.0, 0.01, 4.5 * 23.0)] {
            let recorded = geared(&[(1.0, 1.0), (multiple, amplitude)]);
            let (_, found) = draw(&[run("exact", &recorded)]).unwrap().x.range.unwrap();
            assert!((found / end - 1.0).abs() < 0.02, "{found} {end}");
        }
    }

    /// Only sidebands that are separate lines are marked, here for a rotor that makes 20 revolutions. A place without a line is not marked,
    /// and neither is the skirt of a larger line beside a place.
    #[test]
    fn only_sidebands_that_are_lines_are_marked() {
        let lines = [(1.0, 1.0), (1.0 + 1.0 / 23.0, 0.1), (2.0 - 1.0 / 23.0 + 0.0022, 0.5)];
        let recorded = geared(&lines);
        let figure = draw(&[run("exact", &recorded)]).unwrap();
        let marked: Vec<f64> =
            figure.panels[0].series.iter().filter(|s| s.style.width == 0.0).flat_map(|s| s.x.clone()).collect();
        assert!(marked.iter().any(|x| (x - 24.0).abs() < 1e-6), "{marked:?}");
        assert!(!marked.iter().any(|x| (x - 45.0).abs() < 1e-6), "{marked:?}");
    }

    /// Noise has lines that are higher than their neighbours. Only a line that is clearly higher than the noise is marked.
    #[test]
    fn lines_of_the_noise_are_not_marked() {
        let mut recorded = geared(&[(1.0, 1.0), (1.0 + 1.0 / 23.0, 0.01)]);
        let mut state = 1_u64;
        for x in &mut recorded.outputs[1].1 {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            *x += 0.1 * ((state >> 33) as f64 / f64::from(1_u32 << 31) - 0.5);
        }
        let figure = draw(&[run("exact", &recorded)]).unwrap();
        let symbols: Vec<_> = figure.panels[0].series.iter().filter(|s| s.style.width == 0.0).collect();
        assert_eq!(symbols.len(), 1);
        assert!(symbols[0].label.ends_with("above 3 × the median about them"), "{}", symbols[0].label);
        assert!(symbols[0].x.len() == 1 && (symbols[0].x[0] - 24.0).abs() < 1e-6, "{:?}", symbols[0].x);
    }

    /// All multiples of the mesh order that the axis shows are marked.
    #[test]
    fn multiples_are_marked_as_far_as_the_axis_reaches() {
        let recorded = geared(&[(1.0, 1.0), (12.0, 2.0)]);
        let figure = draw(&[run("exact", &recorded)]).unwrap();
        assert_eq!(figure.panels[0].series[0].label, "1 to 13 × k");
        assert_eq!(figure.panels[0].series[0].x.len(), 3 * 13);
    }
}
