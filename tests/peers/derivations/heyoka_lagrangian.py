"""heyoka's lagrangian(), which gives accelerations.

Fair: parameters are runtime parameters, as heyoka recommends (numbers would be folded, which is another problem). heyoka takes D but
no other forces, so constant torques enter as the potential -Q q. Operations as written are translated to SymPy and counted as for
all other tools. After common subexpressions, the count is the length of heyoka's own decomposition into elementary operations.
"""

import heyoka as hy

from clock import least

from .energies import names
from .operations import operations

METHODS = ["accelerations"]


def version():
    return f"heyoka {hy.__version__}"


def run(energies, method):
    texts = [energies.kinetic, energies.potential, energies.dissipation, *energies.forces]
    moving = {name for q in energies.q for name in (q, f"{q}_dot")}
    constants = [name for name in names(*texts) if name not in moving]
    known = {name: hy.make_vars(name) for name in moving}
    known |= {name: hy.par[i] for i, name in enumerate(constants)}
    known |= {"__builtins__": {}}
    kinetic, potential, dissipation, *forces = (eval(text, known) + hy.expression(0.0) for text in texts)
    q, rates = [known[name] for name in energies.q], [known[f"{name}_dot"] for name in energies.q]

    def derive():
        work = sum((force * x for force, x in zip(forces, q)), hy.expression(0.0))
        return hy.lagrangian(kinetic - potential + work, q, rates, dissipation)

    took, system = least(derive)
    yield {"took": took}
    accelerations = [e for variable, e in system if str(variable).endswith("_dot")]
    shared = hy.cfunc(accelerations, vars=q + rates).dc
    yield {"after": len(shared) - 2 * len(q) - len(accelerations)}
    yield {"before": operations([hy.to_sympy(e) for e in accelerations])}
