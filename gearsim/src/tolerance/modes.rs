//! Tolerances of modes: from the matrices of a cell to its modes, and the motion of one mode.

/// Below this product of rate and time [1] a mode's response is computed by its Taylor series. The closed forms lose about one digit to
/// cancellation at 0.5. Smaller: they lose more digits. Larger: the series becomes long. The kernel of plain events has no series, and
/// leaves such short flights to the general loop.
pub(crate) const SERIES_SPAN: f64 = 0.5;
/// The same for double-double numbers [1]: above 0.01 the closed forms lose up to four of 32 digits.
pub(crate) const COMPENSATED_SERIES_SPAN: f64 = 1e-2;
/// Below this product of the fastest rate and time [1] the response to a load that varies in time is computed by its power series: 32 terms
/// leave 2³²/32! = 2e-26. The closed forms of a ramp lose a digit to cancellation there. Smaller: they lose more. Larger: more terms.
pub(crate) const DRIVEN_SERIES_SPAN: f64 = 2.0;
/// Largest product of rate and time in the kernel of plain events [1]: its reduction of the arguments of sine and cosine is exact
/// to rounding up to it. Longer flights are left to the general loop. Larger: sine and cosine lose digits.
pub(crate) const KERNEL_ANGLE: f64 = 1e5;
/// A Taylor series ends at the first two terms whose sum is below this [relative to the first term]: 1/2000 of a rounding.
/// Larger: the sum of the omitted terms becomes visible.
pub(crate) const SERIES_TERM: f64 = 1e-19;
/// The same for double-double numbers [relative], whose rounding is 1e-32.
pub(crate) const COMPENSATED_SERIES_TERM: f64 = 1e-36;
/// Longest shift of a motion by six terms of its series [1]: rate times time. The seventh term is then below 8e-3⁶/7! = 5e-17 of
/// the first. Larger: the shifted motion loses digits. Smaller: the motion is evaluated in full more often.
pub(crate) const SHIFT_SPAN: f64 = 8e-3;
/// The same with eight terms [1]: the ninth is then below 0.045⁸/9! = 5e-17 of the first. The kernel of plain events shifts the motion this
/// far from the predicted time of an event.
pub(crate) const FAR_SHIFT_SPAN: f64 = 0.045;
/// A mode is critically damped if omega² - sigma² is below this [relative to omega²]. The expansion about critical damping omits
/// terms of the order of its square, 1e-20. Larger: the expansion loses digits over long times. Smaller: the square root of the difference
/// loses digits.
pub(crate) const CRITICAL_DAMPING: f64 = 1e-10;
/// Ratio of kappa = sqrt(sigma² - omega²) to sigma [1] above which S2 of an overdamped mode is the difference of its two
/// exponentials' integrals. Below, this difference cancels digits, and S2 follows from S1. At 0.5 both forms lose about one digit
/// at most.
pub(crate) const OVERDAMPED: f64 = 0.5;
/// Smallest distance of a mode's two eigenvalues [relative to their size] for which its dissipated energy is computed in closed
/// form. For a smaller distance, the closed form divides by it twice and would lose more than two digits, so quadrature is used.
pub(crate) const EIGENVALUES_APART: f64 = 0.1;
/// Sum of the sizes of the terms of which the speeds of a driven flight consist, relative to the speeds \[1\], up to which its energy account
/// is computed from them. Their squares lose twice as many digits, relative to the energy of the flight. Larger: the account loses digits.
/// Smaller: quadrature, at a higher cost.
pub(crate) const CANCELLING_TERMS: f64 = 30.0;
/// Product of rate and time \[1\] below which the speed of a mode is a power series in the energy account of a driven flight. Its
/// [`SLOW_TERMS`] terms leave 0.1¹⁰/10! = 3e-17. Larger: they leave more. Smaller: the exponentials of slow modes cancel.
pub(crate) const SLOW_SPAN: f64 = 0.1;
/// Number of these terms.
pub(crate) const SLOW_TERMS: usize = 10;
/// Decay times after which a motion no longer contributes to the dissipated energy [1]: the power has fallen to e⁻⁸⁰ = 2e-35.
pub(crate) const DECAYED: f64 = 40.0;
/// Length of a panel of the quadrature of dissipated energy [rad]: the fastest rate times the time. The error of the 16-point
/// Gauss-Legendre rule is then below rounding. Larger: it is above. Smaller: more panels.
pub(crate) const QUADRATURE_PANEL: f64 = 2.0;

/// An entry of K below this counts as zero [relative to its terms from switches]. These terms can cancel those of springs. It is 18 eps:
/// each term has a few roundings. Smaller: the rounding errors become very soft springs. Larger: soft springs beside stiff ones vanish.
pub(crate) const CANCELLED_STIFFNESS: f64 = 4e-15;
/// An eigenvalue of K, scaled to a unit diagonal, below this [1] is zero: a rigid motion. It is 450 eps; rounding errors of K
/// grow with the number of coordinates. A value below minus this makes the cell unstable, and the scene is refused. Larger: soft
/// springs beside stiff ones vanish. Smaller: a rigid motion becomes a slow vibration, or the scene is refused.
pub(crate) const RIGID: f64 = 1e-13;
/// Rounding error of the momentum of a rigid motion along a coordinate [relative to the sum of the absolute values of its terms]: a few
/// roundings. Larger: light parts beside heavy ones have no momentum. Smaller: by rounding errors, turning gears move flanks that are at
/// rest.
pub(crate) const RIGID_MOMENTUM: f64 = 8.0 * f64::EPSILON;
/// Two natural frequencies are equal if their squares differ by less than this [relative]. Their mode shapes are then rotated so
/// that damping does not couple them. Jacobi's method gives the squares to some hundred eps. Smaller: rounding errors choose the
/// shapes of equal frequencies. Larger: the rotation mixes different modes.
pub(crate) const EQUAL_FREQUENCIES: f64 = 1e-12;
/// Modal damping below this [relative to the strongest modal damping] is zero. It is 4.5 eps. An undamped mode must keep its
/// energy, so rounding errors must not damp it. Larger: weak damping is lost.
pub(crate) const UNDAMPED: f64 = 1e-15;
/// Two modes are coupled if the damping between them exceeds this [relative to the geometric mean of their own dampings].
/// Rounding errors in the mode shapes of neighbouring frequencies cause couplings up to this size. Smaller: rounding errors couple modes,
/// which costs time. Larger: weak couplings are ignored; the motion changes by about this fraction.
pub(crate) const COUPLED_MODES: f64 = 1e-10;
/// Rounding errors in the damping between two modes [eps, times the sum of the absolute values of its terms]. Each entry of the
/// mode shapes has some tens of them. Smaller: rounding errors couple modes. Larger: weak couplings are ignored.
pub(crate) const MODAL_DAMPING_ROUNDINGS: f64 = 64.0;
/// The same in the rate of a damper along a mode [eps, times the sum of the absolute values of its terms].
pub(crate) const RATE_ROUNDINGS: f64 = 64.0;
/// An eigenvalue of C, scaled to a unit diagonal, below this [relative to the largest] is a rounding error and no damper. It is 45 eps.
/// Smaller: rounding errors of C become weak dampers. Larger: weak dampers beside strong ones at the same coordinates vanish.
pub(crate) const DAMPER: f64 = 1e-14;
/// Jacobi's method ends if every off-diagonal entry is below this [relative to the geometric mean of the two diagonal entries]. A
/// tenth of a rounding keeps the relative accuracy of small eigenvalues (Demmel & Veselić, SIAM J. Matrix Anal. Appl. 13, 1992).
pub(crate) const JACOBI: f64 = 0.1 * f64::EPSILON;

/// An eigenvalue with an imaginary part below this [relative to its real part] counts as real. A double real eigenvalue splits by
/// sqrt(eps) = 1.5e-8 into a complex pair by rounding. Smaller: such a pair is not recognised. Larger: strongly damped vibrations
/// count as aperiodic motions; Newton's method corrects both afterwards.
pub(crate) const NEARLY_REAL: f64 = 1e-6;
/// Two pairs of eigenvalues form a cluster if their distance is below this [relative to these eigenvalues, in further attempts partly or
/// wholly to the fastest eigenvalue]. It is 45 000 eps, above the errors of the QR method. Smaller: the mode shapes of equal pairs are
/// rounding errors. Larger: different pairs get common mode shapes before the refinement.
pub(crate) const EQUAL_PAIRS: f64 = 1e-11;
/// Accuracy asked of the QR method for the eigenvalues [relative to the largest entry]: one rounding.
pub(crate) const QR: f64 = f64::EPSILON;
/// Iterations after which the QR method gives up and the cell is refused [1]. It needs about two for each eigenvalue.
pub(crate) const QR_ITERATIONS: usize = 100_000;
/// Damping of a pair of eigenvalues below this [relative to the terms whose sum it is] is zero: 45 eps. Smaller: rounding errors
/// damp or drive an undamped motion. Larger: weak damping is lost.
pub(crate) const UNDAMPED_PAIR: f64 = 1e-14;
/// Largest condition number of a pair of eigenvalues [1]; the cell is refused above it. The modal parts of the motion are up to this many
/// times larger than the motion, and their phases have errors of up to this many roundings: eight digits are left after 1e4 rad. Larger:
/// results with fewer digits. Smaller: usable scenes are refused.
pub(crate) const CONDITION: f64 = 1e4;
/// Largest part of a motion that the modes may fail to represent [relative]; the cell is refused above it. With condition numbers up to
/// [`CONDITION`], rounding errors stay far below it. Larger: motions with fewer digits. Smaller: usable scenes are refused.
pub(crate) const MISSED: f64 = 1e-8;
/// Rounding errors in the products of biorthogonal vectors [relative to the sum of the absolute values of their terms]. Smaller:
/// rounding errors are corrected as if they were couplings, which has no effect on the digits.
pub(crate) const BIORTHOGONAL: f64 = 64.0 * f64::EPSILON;
/// Largest singular value of the scaled matrix of a pair that counts as zero [1]; above, the eigenvalues are defective and the
/// cell is refused. The eigenvalues have errors of sqrt(eps) = 1.5e-8 at worst, which leave singular values of this size. Larger:
/// defective eigenvalues pass as regular. Smaller: close eigenvalues are refused.
pub(crate) const NULL_SPACE: f64 = 1e-7;

/// Damping between two modes in double-double numbers above this [relative to the strongest] couples them, and the motion is computed
/// by power series. Rounding errors are 1e-32 times the condition of the matrices. Larger: an ignored coupling would limit the digits of
/// the result. Smaller: rounding errors would cost time.
pub(crate) const COMPENSATED_COUPLED: f64 = 1e-18;
/// Damping of a mode in double-double numbers below this [relative to the strongest] counts as zero: rounding errors are 1e4 times smaller.
/// Larger: weak damping is lost. Smaller: rounding errors damp rigid motions, whose closed form then loses its digits.
pub(crate) const COMPENSATED_UNDAMPED: f64 = 1e-28;
/// Jacobi's method in double-double numbers ends below this [relative to the larger diagonal entry]: ten roundings.
pub(crate) const COMPENSATED_JACOBI: f64 = 1e-31;

/// Rounding error of a force on a rigid motion [relative to the sum of the absolute values of its terms]: a larger force means
/// that springs or dampers act on the motion, and its momentum is not conserved. Smaller: momentum that is conserved is not
/// corrected.
pub(crate) const NO_FORCE: f64 = 16.0 * f64::EPSILON;
