"""The derivations: one file per tool, with its METHODS, `version()` and `run(energies, method)`, which yields each figure as soon
as it is known. The docstring of the file says what was done to be fair to the tool.

    python -m derivations MODEL TOOL METHOD     one derivation, as lines of JSON
"""

import sys

from apart import apart

MODELS = ["gear_pair", "planar_planetary_3", "planar_planetary_5", "chain_32"]
TOOLS = {
    "gearsim": "gearsim_derive",
    "SymPy": "sympy_lagrange",
    "heyoka": "heyoka_lagrangian",
}


def limit(quick):
    """The processor time [s] allowed for one derivation and the counting of its operations."""
    return 5 if quick else 60


def tool(name):
    """The module of a tool."""
    from importlib import import_module

    return import_module(f"derivations.{TOOLS[name]}")


def rows(quick):
    """All derivations (a quick run: only those of the first model), each in a process of its own."""
    from .energies import read

    for model in MODELS[:1] if quick else MODELS:
        known = read(model) is not None
        for name in TOOLS:
            for method in tool(name).METHODS:
                command = [sys.executable, "-m", "derivations", model, name, method]
                result = apart(command, limit(quick)) if known else {"failed": "not yet a model of gearsim"}
                print(model, name, method, result.get("failed", "done"), flush=True)
                yield {"model": model, "tool": name, "method": method, **result}
