"""gearsim's own derivation, `cargo xtask derive --check`. Its time is the smallest of three wall clock times and includes the proofs
and the writing of the file.

The derivation covers every set of effects at once, and the jump terms. Operations are counted in the printed equations with all
effects present. Jump terms (zero within a cell) are left out, because the other tools do not have them. Where M is not inverted,
the equations are forces, otherwise accelerations.
"""

import os
import re
import subprocess

import sympy as sp

from .energies import GENERATED, names, plain
from .operations import counted

METHODS = ["gearsim"]


def version():
    return "gearsim of this checkout"


def run(model):
    root = GENERATED.parents[2]
    best = None
    for _ in range(3):
        done = subprocess.run(
            [os.environ["CARGO"], "xtask", "derive", "--check", model], cwd=root, capture_output=True, text=True
        )
        found = re.search(rf"^{model}: .*\(([\d.]+) ms\)", done.stdout, re.M)
        if not found:
            raise RuntimeError((done.stderr.strip().splitlines() or ["no time printed"])[-1])
        took = float(found[1]) / 1e3
        best = took if best is None else min(best, took)
    yield {"took": best}
    text = (GENERATED / f"{model}.rs").read_text()
    equations, deflections = plain(text, "Equations of motion"), plain(text, "Deflections")
    texts = [*equations.values(), *deflections.values()]
    known = {name: sp.Symbol(name) for name in names(*texts)}
    parsed = [sp.parse_expr(text, local_dict=known) for text in texts]
    parsed = [e.subs({s: 0 for s in e.free_symbols if re.fullmatch(r"dk\w*", str(s))}) for e in parsed]
    yield from counted(parsed)
