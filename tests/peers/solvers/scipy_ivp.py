"""SciPy's solve_ivp, restarted at terminal events.

Fair: plain floats in a function without array overhead; two events with directions; no dense output, no t_eval; Radau and LSODA get
the constant Jacobian of the cell; an absolute tolerance for each coordinate by its size.
"""

import scipy
from scipy.integrate import solve_ivp

from clock import measure
from scene import restart

METHODS = ["RK45", "DOP853", "Radau", "LSODA"]
TOLERANCES = ["default", 1e-6, 1e-9, 1e-12]


def version():
    return f"SciPy {scipy.__version__}"


class Cell:
    """The functions and options of solve_ivp for one kind of cell."""

    def __init__(self, scene, cell, options):
        k, width, m1, m2, c, t0 = scene.k(cell), scene.width(cell), scene.m1, scene.m2, scene.c, scene.t0

        def slope(_, y):
            _, theta_dot, phi, phi_dot = y.tolist()
            pull = t0 - k * phi - c * phi_dot
            return (theta_dot, m1 * pull, phi_dot, m2 * pull)

        def upper(_, y):
            return y[0] - width

        def lower(_, y):
            return y[0]

        upper.terminal, upper.direction = True, 1
        lower.terminal, lower.direction = True, -1
        self.slope, self.events, self.options = slope, (upper, lower), dict(options)
        matrix = scene.matrix(cell)
        if options["method"] == "Radau":
            self.options["jac"] = matrix
        if options["method"] == "LSODA":
            self.options["jac"] = lambda _t, _y: matrix


def run(scene, method, tolerance):
    options = {"method": method}
    if tolerance != "default":
        options.update(rtol=tolerance, atol=scene.atol(tolerance))

    def fly_with(cells):
        def fly(t, cell, y):
            here = cells[cell % 2]
            found = solve_ivp(here.slope, (t, scene.t_end), y, events=here.events, **here.options)
            if found.status < 0:
                raise RuntimeError(found.message)
            if found.status == 0:
                return found.t[-1], found.y[:, -1], None
            upwards = len(found.t_events[0]) > 0
            at = 0 if upwards else 1
            return found.t_events[at][0], found.y_events[at][0], upwards

        return fly

    cells = lambda: [Cell(scene, cell, options) for cell in (0, 1)]
    return measure(cells, lambda cells: restart(scene, fly_with(cells)))
