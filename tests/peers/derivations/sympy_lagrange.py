"""SymPy's LagrangesMethod.

Fair: constants and effects are symbols, and nothing is simplified, which would take longest. The Rayleigh function and the torques are
added as dD/dq' - Q, because LagrangesMethod takes only forces on points. "forces": M and the right-hand side, which is enough for a
numerical solution. "accelerations": additionally solved by LU.
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
        # Without this, a second run would profit from the cache of the first.
        clear_cache()
        lagrange = LagrangesMethod(kinetic - potential, q)
        lagrange.form_lagranges_equations()
        right = [f - dissipation.diff(rate) + g for f, rate, g in zip(lagrange.forcing, rates.values(), forces)]
        return lagrange.mass_matrix.LUsolve(sp.Matrix(right)) if method == "accelerations" else right

    took, right = least(derive)
    yield {"took": took}
    flat = {rate: sp.Symbol(name) for name, rate in rates.items()} | {x: sp.Symbol(name) for name, x in moving.items()}
    yield from counted([e.subs(flat) for e in right])
