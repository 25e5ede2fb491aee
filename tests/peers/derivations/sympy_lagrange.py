"""SymPy's LagrangesMethod.

Fair: constants and effects as symbols, no simplification (which is what takes longest); the Rayleigh function and the
torques are added as dD/dq' - Q, since LagrangesMethod takes forces on points only. "forces": M and the right-hand side, as far as
one goes for a numerical solve. "accelerations": solved by LU on top.
"""

import sympy as sp
from sympy.core.cache import clear_cache
from sympy.physics.mechanics import LagrangesMethod, dynamicsymbols

from clock import least

from .energies import names
from .operations import counted

METHODS = ["forces", "accelerations"]


def version():
    return f"SymPy {sp.__version__}"


def run(energies, method):
    texts = [energies.kinetic, energies.potential, energies.dissipation, *energies.forces]
    moving = {name: dynamicsymbols(name) for name in energies.q}
    rates = {f"{name}_dot": q.diff(dynamicsymbols._t) for name, q in moving.items()}
    known = {name: sp.Symbol(name) for name in names(*texts)} | moving | rates
    kinetic, potential, dissipation, *forces = (sp.parse_expr(text, local_dict=known) for text in texts)
    q = list(moving.values())

    def derive():
        # What a second run remembers of the first would not be its own time.
        clear_cache()
        lagrange = LagrangesMethod(kinetic - potential, q)
        lagrange.form_lagranges_equations()
        right = [f - dissipation.diff(rate) + g for f, rate, g in zip(lagrange.forcing, rates.values(), forces)]
        return lagrange.mass_matrix.LUsolve(sp.Matrix(right)) if method == "accelerations" else right

    took, right = least(derive)
    yield {"took": took}
    flat = {rate: sp.Symbol(name) for name, rate in rates.items()} | {x: sp.Symbol(name) for name, x in moving.items()}
    yield from counted([e.subs(flat) for e in right])
