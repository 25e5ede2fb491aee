//! The table of tolerances: every number that decides whether a value counts as zero, whether two values count as equal, whether an
//! iteration has converged, or whether a scene or a run is refused.
//!
//! Each tolerance is one constant with one meaning. Its comment gives its unit, the origin of its value, and the effect of a
//! larger or a smaller one. [1] means a pure number, [relative] a fraction of the quantity that the comment names. `eps` is the spacing of
//! the numbers next to 1, [`f64::EPSILON`] = 2.2e-16. One rounding is an error of that relative size.
//!
//! The table does not contain limits on the number of iterations that always converge. They are beside their loops.

pub(crate) mod analysis;
pub(crate) mod events;
pub(crate) mod methods;
pub(crate) mod modes;
pub(crate) mod phases;
pub(crate) mod scene;
pub(crate) mod start;
