//! The notes at the ends of curves: each legible, in the colour of its curve.

use super::canvas::{SMALL, path};
use super::figure::{NotePlace, Series};
use super::picture::Drawing;
use super::text::{Anchor, ems};

/// Height of a row of notes.
const ROW: f64 = 14.0;
/// Length of the line from the end of a curve to a note that is moved away from others.
const LEADER: f64 = 12.0;

/// Draws the notes of curves. `ends` has the last point of each curve within the frame, whose left, top and right edges are `left`, `top`
/// and `right`, and its lower one `bottom`.
pub(super) fn draw(
    out: &mut Drawing,
    ends: &[((f64, f64), &Series)],
    left: f64,
    right: f64,
    (top, bottom): (f64, f64),
) {
    let placed = |place: NotePlace| {
        let mut all: Vec<_> = ends.iter().filter(|(_, series)| series.note.place == place).collect();
        let key = |(x, y): (f64, f64)| if place == NotePlace::Above { x } else { y };
        all.sort_by(|a, b| key(a.0).total_cmp(&key(b.0)));
        all
    };
    for ((x, y), series) in placed(NotePlace::Before) {
        let width = SMALL * ems(&series.note.text);
        // Above and to the left of the last point, but moved down or to the right as far as the frame requires.
        let at = ((x.min(right) - 5.0).max(left + 4.0 + width), (y - 4.0).max(top + 13.0));
        let (x, y) = (at.0 - width - 2.0, at.1 - SMALL + 1.0);
        // A white ground covers the curves that cross the note.
        let ground = format!("M{x:.1} {y:.1}h{:.1}v{SMALL}h-{:.1}Z", width + 4.0, width + 4.0);
        path(out, &ground, "style=\"fill:white\" opacity=\"0.85\"");
        note(out, at, Anchor::End, series);
    }
    let after = placed(NotePlace::After);
    let wanted: Vec<f64> = after.iter().map(|((_, y), _)| *y).collect();
    for (((x, y), series), row) in after.iter().zip(apart(&wanted, ROW, (top + 0.5 * ROW, bottom - 0.5 * ROW))) {
        leader(out, &format!("M{x:.1} {y:.1}L{:.1} {row:.1}", x + LEADER), series);
        note(out, (x + LEADER + 3.0, row + 4.3), Anchor::Start, series);
    }
    let above = placed(NotePlace::Above);
    let wanted: Vec<f64> = above.iter().map(|((x, _), _)| *x).collect();
    let width = above.iter().map(|(_, series)| SMALL * ems(&series.note.text)).fold(0.0, f64::max) + 8.0;
    for (((x, y), series), column) in above.iter().zip(apart(&wanted, width, (left + 0.5 * width, right))) {
        leader(out, &format!("M{x:.1} {y:.1}L{column:.1} {:.1}", y - LEADER), series);
        note(out, (column, y - LEADER - 4.0), Anchor::Middle, series);
    }
}

fn leader(out: &mut Drawing, d: &str, series: &Series) {
    path(out, d, &format!("stroke=\"{}\" stroke-width=\"0.7\"", series.style.colour));
}

fn note(out: &mut Drawing, at: (f64, f64), anchor: Anchor, series: &Series) {
    out.text(at, anchor, SMALL, &format!("fill=\"{}\"", series.style.colour), &series.note.text);
}

/// Places at least `gap` apart, near the `wanted` ones, which are in ascending order, and between `low` and `high` if they fit there.
fn apart(wanted: &[f64], gap: f64, (low, high): (f64, f64)) -> Vec<f64> {
    let mut places: Vec<f64> = vec![];
    for at in wanted {
        let least = places.last().map_or(low, |before| before + gap);
        places.push(at.max(least));
    }
    let mut most = high;
    for place in places.iter_mut().rev() {
        *place = place.min(most);
        most = *place - gap;
    }
    places
}

#[test]
fn notes_are_apart_and_near_their_curves() {
    assert_eq!(apart(&[1.0, 10.0, 11.0, 12.0], 3.0, (0.0, 20.0)), [1.0, 10.0, 13.0, 16.0]);
    // At the end of the frame they are moved to the other side.
    assert_eq!(apart(&[10.0, 18.0, 19.0], 3.0, (0.0, 19.0)), [10.0, 16.0, 19.0]);
    assert_eq!(apart(&[-5.0, -5.0], 3.0, (0.0, 20.0)), [0.0, 3.0]);
}
