"""The solvers: one file each, with its METHODS, its TOLERANCES, `version()` and `run(scene, method, tolerance)`.

A file's head says what was done to be fair to it. "default" among the tolerances leaves the tool its own.
"""

from . import casadi_events, cvode, gearsim, heyoka_taylor, rust_crates, scipy_ivp

SOLVERS = {
    "gearsim": gearsim,
    "heyoka": heyoka_taylor,
    "SUNDIALS CVODE": cvode,
    "CasADi": casadi_events,
    "SciPy": scipy_ivp,
    "Rust crates": rust_crates,
}
