//! Tolerances and limits of the numbers in a scene, of gear geometry, and of sweeps. Numbers beyond a limit are refused.

/// Shortest end time of a run [s]. For a smaller one the sampling rate would not be finite.
pub(crate) const SHORTEST_RUN: f64 = 1e-300;
/// Memory for the rows of a run if the scene states no limit [bytes]. A run stops when its rows need more. With its files and plots a run
/// takes about twice as much. `compare` keeps three runs in memory, a sweep one per thread.
pub(crate) const ROW_MEMORY: f64 = 1e9;
/// Largest memory for the rows of a run that a scene may ask for by `output.most_rows` [bytes].
pub(crate) const MOST_ROW_MEMORY: f64 = 16e9;
/// If all widths of a law are given, their sum may differ from the pitch by this [relative to the pitch], because written widths
/// are rounded. Larger: mistakes in widths pass. Smaller: widths with nine digits are refused.
pub(crate) const WIDTHS: f64 = 1e-9;
/// A mesh phase within this distance of a fraction of a pitch is replaced by the fraction [pitches]. Written phases have about
/// eleven digits. Smaller: planets that should be in phase differ by a rounding error. Larger: no effect below the digits of written
/// phases.
pub(crate) const PHASE_FRACTION: f64 = 1e-11;
/// Largest denominator of the fractions above [1]: one degree of a turn.
pub(crate) const PHASE_DENOMINATOR: i32 = 360;
/// Highest order of a harmonic of a smooth law [1]: its wavelength is then a thousandth of the period.
pub(crate) const HARMONIC_ORDER: f64 = 1000.0;
/// Largest number of points of a table [points].
pub(crate) const TABLE_POINTS: usize = 1000;
/// Largest number of entries in a list of a time history [entries].
pub(crate) const HISTORY_ENTRIES: usize = 1_000_000;
/// Largest number of pitches in one period of a law [pitches].
pub(crate) const LAW_PITCHES: f64 = 10_000.0;
/// Largest number of cells of a law with damaged teeth [cells].
pub(crate) const DAMAGED_CELLS: usize = 20_000;
/// Largest number of teeth of a gear [teeth].
pub(crate) const TEETH: f64 = 10_000.0;

/// Modules of gears [m]; others are refused. Watches have 0.05 mm, mills 50 mm. Wider: a wrong unit passes.
pub(crate) const MODULES: std::ops::RangeInclusive<f64> = 1e-5..=0.1;
/// Modules that are not rare [m]: those of ISO 54, widened. Others give a warning.
pub(crate) const USUAL_MODULES: std::ops::RangeInclusive<f64> = 0.999e-4..=0.0501;
/// Largest play of a mesh that is not rare [modules]: gears are made with 0.02 to 0.1. More gives a warning. Larger: a wrong unit passes.
pub(crate) const USUAL_PLAY: f64 = 0.5;
/// Pressure angles of gears [deg]; others are refused.
pub(crate) const PRESSURE_ANGLES: std::ops::RangeInclusive<f64> = 5.0..=45.0;
/// Pressure angles that are not rare [deg], as working angles. Others give a warning.
pub(crate) const USUAL_ANGLES: std::ops::RangeInclusive<f64> = 13.0..=32.0;
/// A given base radius may differ from that of the tooth data by this [relative]: written radii have three digits. Larger: the radius of
/// another gear is accepted.
pub(crate) const BASE_RADIUS: f64 = 5e-3;
/// Two radii on a rotor count as equal if they differ by less than this [relative]: the radii of one gear in two meshes differ by rounding
/// errors.
pub(crate) const SAME_RADIUS: f64 = 1e-9;
/// Difference of a pressure angle from the working angle of the teeth [deg]: above the first there is a warning, above the second the scene
/// is refused. Differences between the two occur if a model has one angle for several meshes, and the teeth are shifted.
pub(crate) const WORKING_ANGLE: [f64; 2] = [0.1, 5.0];
/// Face widths, and moduli of elasticity, that gears can have [m, Pa]; others are refused.
pub(crate) const FACE_WIDTHS: std::ops::RangeInclusive<f64> = 1e-5..=10.0;
pub(crate) const YOUNG: std::ops::RangeInclusive<f64> = 1e6..=2e12;
/// Largest size of the text of a scene [bytes].
pub(crate) const SCENE_BYTES: u64 = 16 << 20;
/// Largest number of mistakes in a scene that are shown [1].
pub(crate) const SHOWN_MISTAKES: usize = 100;
/// Length of a quoted line above which only the part round the mistake is shown [bytes].
pub(crate) const QUOTED: usize = 300;
/// Largest number of threads of a sweep [1].
pub(crate) const THREADS: i64 = 1024;

/// If a tooth pair passes the pitch point this close to a boundary of a cell, no further boundary is added [base pitches].
/// Smaller: a cell as short as a rounding error. Larger: the sign of the friction changes late.
pub(crate) const PITCH_POINT: f64 = 1e-9;
/// The limits of the pressure angle in ISO 6336-1 are widened by this [deg]: the rounding error of the conversion to degrees.
pub(crate) const PRESSURE_ANGLE: f64 = 1e-9;
/// Contact that extends up to this far into the fillet is accepted [modules]; the end of the flank is then used instead. Above this, the
/// teeth are refused.
pub(crate) const FILLET_CONTACT: f64 = 1e-3;
/// Overlap of tip and root circles above which gears are refused [modules]: the rounding error of a written centre distance.
pub(crate) const OVERLAP: f64 = 1e-9;
/// Largest undercut that is accepted [modules]: the standard pinion of 17 teeth has 0.006.
pub(crate) const UNDERCUT: f64 = 0.02;
/// Steps of a law whose distance is below this count as one step [periods of the law]. It covers the rounding errors of the sums of widths.
pub(crate) const SAME_STEP: f64 = 1e-12;
/// Half the distance of the two points of a central difference [relative to the length of a curve]. The error of the slope, 1e-8,
/// is far below that of the curve, 1e-4.
pub(crate) const SLOPE_STEP: f64 = 1e-4;

/// Largest number of points of a sweep, and of values on one axis [1]. The rows of more would not fit in memory.
pub(crate) const SWEEP_POINTS: usize = 10_000_000;

/// A planet fits if its angle is within this distance of an angle at which its teeth mesh with sun and ring [pitches]: written angles have
/// four digits. Larger: planets that cannot be assembled are accepted.
pub(crate) const PLANET_FIT: f64 = 0.01;

/// Two planets count as being at the same position if the distance of their centres is below this [relative to the pitch diameter of a
/// planet]. Larger: planets in different planes are refused. Smaller: angles that differ by rounding errors count as two positions.
pub(crate) const ONE_PLACE: f64 = 1e-3;

/// Largest number of planets of a set \[1\]: more do not fit between a sun and a ring of usual gears. A larger number is refused.
pub const PLANETS: f64 = 24.0;

/// Largest number of rotors of a train \[1\]: the cost of a cell grows with its cube. A larger number is refused.
pub const ROTORS: usize = 512;

/// A coordinate of a train is independent of others if its remainder, orthogonal to them, is larger than this part of it \[1\]. A smaller
/// remainder is taken as a rounding error of radii and ratios.
pub const INDEPENDENT: f64 = 1e-9;

/// The factor of a coordinate in a deflection of a train is a sum of terms. It counts as zero if it is less than this part of their
/// absolute values \[1\]. This is some hundred rounding errors, because the second run that estimates the digits changes radii by a few
/// rounding errors.
pub const CANCELLED: f64 = 1e-13;

/// Constant forces along a coordinate of a train count as balanced if their sum is below this part of the sum of their absolute values
/// \[1\]. It is some twenty rounding errors: those of the gear ratios. The phase of a mesh then has no acceleration, as in a derived model.
pub const BALANCED: f64 = 5e-15;
