"""The solvers: one file each, with its METHODS, its TOLERANCES, `version()` and `run(scene, method, tolerance)`.

A file's head says what was done to be fair to it. "default" among the tolerances leaves the tool its own.
"""

from importlib import import_module

SOLVERS = {
    "gearsim": "gearsim",
    "heyoka": "heyoka_taylor",
    "Rust crates": "rust_crates",
    "SUNDIALS CVODE": "cvode",
    "CasADi": "casadi_events",
    "SciPy": "scipy_ivp",
}


def solver(name):
    """The module of a solver: of one alone, since some take seconds to load."""
    return import_module(f"solvers.{SOLVERS[name]}")
