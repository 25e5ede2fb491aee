//! Decides from the Taylor form whether the gap is positive, monotone, convex or concave in a piece of time.

/// gap, gap', gap'' at one time and bounds on their errors.
#[derive(Debug, Clone, Copy)]
pub(super) struct Local {
    pub(super) gap: [f64; 3],
    pub(super) error: [f64; 3],
}

/// What is known about the gap in a piece of time.
pub(super) enum Verdict {
    /// gap > 0 after the beginning of the piece
    Positive,
    /// gap' < 0
    Falling,
    /// gap'' > 0
    Convex,
    /// gap'' < 0
    Concave,
    /// none of these could be shown
    Open,
}

/// The verdict on a piece of half width `r` from the Taylor form at its midpoint. `third` is a bound on |gap'''|.
pub(super) fn judge(at: &Local, third: f64, r: f64) -> Verdict {
    let ([gap, slope, bend], [e0, e1, e2]) = (at.gap, at.error);
    let cubic = third * r * r * r / 6.0;
    // how far the parabola falls below `gap` in the piece, at most
    let dip = if bend > 0.0 {
        (slope.abs() * r).min(slope * slope / (2.0 * bend))
    } else {
        slope.abs() * r - bend * r * r / 2.0
    };
    if gap - dip - cubic - (e0 + e1 * r + e2 * r * r) > 0.0 {
        return Verdict::Positive;
    }
    let spread = (bend.abs() + e2) * r + third * r * r / 2.0 + e1;
    let turn = third * r + e2;
    match () {
        // the gap is positive just after the beginning and rises
        () if slope > spread => Verdict::Positive,
        () if slope < -spread => Verdict::Falling,
        () if bend > turn => Verdict::Convex,
        () if bend < -turn => Verdict::Concave,
        () => Verdict::Open,
    }
}
