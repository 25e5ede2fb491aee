//! What the Taylor form of the gap shows of a piece of time: positive, monotone, convex, concave, or nothing yet.

/// gap, gap', gap'' at one time and bounds on their errors.
#[derive(Debug, Clone, Copy)]
pub(super) struct Local {
    pub(super) gap: [f64; 3],
    pub(super) error: [f64; 3],
}

/// What a piece was shown to be.
pub(super) enum Verdict {
    /// gap > 0 after its beginning
    Positive,
    /// gap' < 0
    Falling,
    /// gap'' > 0
    Convex,
    /// gap'' < 0
    Concave,
    /// none of these was shown
    Open,
}

/// What the Taylor form at the midpoint of a piece of half width `r` shows.
pub(super) fn judge(at: &Local, third: f64, r: f64) -> Verdict {
    let ([gap, slope, bend], [e0, e1, e2]) = (at.gap, at.error);
    let cubic = third * r * r * r / 6.0;
    // the least of the parabola over the piece
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
        // positive just after its beginning, and rising
        () if slope > spread => Verdict::Positive,
        () if slope < -spread => Verdict::Falling,
        () if bend > turn => Verdict::Convex,
        () if bend < -turn => Verdict::Concave,
        () => Verdict::Open,
    }
}
