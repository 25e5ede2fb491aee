"""CasADi's interface to CVODES with its own (experimental) events, so that a whole run is one call.

Fair: expressions are SX, evaluated in CasADi's virtual machine without Python. Stiffness and width are constant states, so the jump is
the transition function of the event and nothing switches within a step. Coordinates are divided by their sizes, because CasADi
takes one absolute tolerance.
CasADi 3.8.2 finds at most one event in an interval of the output grid, passes a second one without a message, and fails if it must
go back by more than one step of CVODES. The grid has two points in the shortest cell at the speed of the start, and twenty per
oscillation; with this grid CasADi gets farthest. States hold the cell and the time of the last event; the events are read from
these states on the grid.
A reflection stops it nevertheless. If theta were moved 1e-6 rad off the boundary, CVODES Adams would continue, with an error of
1e-3; this is not done.
"""

from math import ceil, pi, sqrt

import casadi as ca
import numpy as np

from clock import measure

METHODS = ["CVODES Adams", "CVODES BDF"]
TOLERANCES = ["default", 1e-6, 1e-9, 1e-12]


def version():
    return f"CasADi {ca.__version__}"


def integrator(scene, method, tolerance):
    x = ca.SX.sym("x", 8)
    size = ca.DM([*scene.sizes, 1, 1, 1, 1])
    theta, theta_dot, phi, phi_dot, k, width, cell, _last = ca.vertsplit(x * size)
    pull = scene.t0 - k * phi - scene.c * phi_dot
    slope = ca.vertcat(theta_dot, scene.m1 * pull, phi_dot, scene.m2 * pull, 0, 0, 0, 0) / size
    # CasADi's event is an indicator that falls below zero.
    ends = ca.vertcat(width - theta, theta) / scene.sizes[0]

    index, t = ca.SX.sym("index"), ca.SX.sym("t")
    upwards = index == 0
    other = lambda now, pair: ca.if_else(now == pair[0], pair[1], pair[0])
    k_beyond, width_beyond = other(k, scene.stiffness), other(width, scene.widths)
    step = scene.m2 * (k_beyond - k) * phi**2
    square = theta_dot**2 - step
    passes = square >= 0
    after = ca.if_else(passes, ca.sign(theta_dot) * ca.sqrt(ca.fmax(square, 0)), -theta_dot)
    width_after = ca.if_else(passes, width_beyond, width)
    # After a transmission upwards or a reflection at the lower end, theta is at the lower end of its cell, otherwise at the upper end.
    at_lower = ca.if_else(passes, upwards, ca.logic_not(upwards))
    theta_after = ca.if_else(at_lower, 0, width_after)
    phi_dot_after = phi_dot + scene.m1 / scene.m2 * (after - theta_dot)
    cell_after = cell + ca.if_else(passes, ca.if_else(upwards, 1, -1), 0)
    k_after = ca.if_else(passes, k_beyond, k)
    post = ca.vertcat(theta_after, after, phi, phi_dot_after, k_after, width_after, cell_after, t) / size
    transition = ca.Function(
        "jump", [index, t, x, ca.SX(0, 1), ca.SX(0, 1), ca.SX(0, 1)], [post, ca.SX(0, 1)], ca.event_in(), ca.event_out()
    )
    options = {
        "transition": transition,
        "max_events": 1_000_000,
        "max_num_steps": 1_000_000,
        "linear_multistep_method": method.split()[1].lower(),
    }
    if tolerance != "default":
        options.update(reltol=tolerance, abstol=tolerance, event_tol=tolerance)
    start = [*scene.start, scene.k(0), scene.width(0), 0, 0]
    period = 2 * pi / sqrt(scene.m2 * max(scene.stiffness))
    intervals = ceil(scene.t_end / min(min(scene.widths) / scene.start[1] / 2, period / 20))
    grid = [scene.t_end * (i + 1) / intervals for i in range(intervals)]
    dae = {"t": t, "x": x, "ode": slope, "zero": ends}
    return ca.integrator("run", "cvodes", dae, 0.0, grid, options), ca.DM(start) / size, size.full()


def events_of(columns):
    """The events between the points of the grid: the time of the last event changes there."""
    cell, last = np.append(0, np.rint(columns[6])), np.append(0, columns[7])
    at = np.flatnonzero(np.diff(last)) + 1
    kinds = ["reflect" if same else "transmit" for same in cell[at] == cell[at - 1]]
    return [list(event) for event in zip(last[at].tolist(), kinds, cell[at].astype(int).tolist())]


def run(scene, method, tolerance):
    def solve(prepared):
        integrate, start, size = prepared
        columns = integrate(x0=start)["xf"].full() * size
        end = columns[:, -1].tolist()
        return {"events": events_of(columns), "cell": round(end[6]), "end": end[:4]}

    return measure(lambda: integrator(scene, method, tolerance), solve)
