"""The solvers: one file each, with its METHODS, its TOLERANCES, `version()` and `run(scene, method, tolerance)`.

The docstring of the file says what was done to be fair to the tool. The tolerance "default" is the tool's own default.
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
    """The module of one solver; only this one is loaded, because some take seconds to load."""
    return import_module(f"solvers.{SOLVERS[name]}")
