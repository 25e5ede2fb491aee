"""SUNDIALS CVODE through scikit-sundae, restarted at terminal events (CVODE's own root finding).

Fair: Adams and BDF; the constant Jacobian of the cell is given; arrays are filled in place; one solver object per kind of cell; no
limit on steps; an absolute tolerance for each coordinate by its size. The functions are Python, because scikit-sundae takes no
compiled ones. CasADi uses CVODES with compiled expressions.
"""

import sksundae
from sksundae.cvode import CVODE

from clock import measure
from scene import restart

METHODS = ["Adams", "BDF"]
TOLERANCES = ["default", 1e-6, 1e-9, 1e-12]
ROOT = 2
"""Status of a stop at an event."""


def version():
    return f"scikit-sundae {sksundae.__version__} (SUNDIALS {sksundae.SUNDIALS_VERSION})"


def solver(scene, cell, options):
    k, width, m1, m2, c, t0 = scene.k(cell), scene.width(cell), scene.m1, scene.m2, scene.c, scene.t0
    matrix = scene.matrix(cell)

    def slope(_, y, out):
        _, theta_dot, phi, phi_dot = y.tolist()
        pull = t0 - k * phi - c * phi_dot
        out[:] = (theta_dot, m1 * pull, phi_dot, m2 * pull)

    def jacobian(_, _y, _slope, out):
        out[:] = matrix

    def ends(_, y, out):
        theta = y[0]
        out[:] = (theta - width, theta)

    ends.terminal, ends.direction = [True, True], [1, -1]
    return CVODE(slope, eventsfn=ends, num_events=2, jacfn=jacobian, max_num_steps=1_000_000, **options)


def run(scene, method, tolerance):
    options = {"method": method}
    if tolerance != "default":
        options.update(rtol=tolerance, atol=scene.atol(tolerance))

    def fly_with(solvers):
        def fly(t, cell, y):
            solver = solvers[cell % 2]
            solver.init_step(t, y)
            found = solver.step(scene.t_end, method="normal", tstop=scene.t_end)
            if found.status < 0:
                raise RuntimeError(found.message)
            return found.t, found.y, None if found.status != ROOT else bool(found.i_events[-1][0])

        return fly

    # A solver object collects its events over all restarts, so every run needs new objects.
    return measure(
        lambda: None,
        lambda _: restart(scene, fly_with([solver(scene, cell, options) for cell in (0, 1)])),
    )
