"""CasADi: its interface to CVODES with its own (experimental) events, so that a whole run is one call.

Fair: expressions are SX, evaluated in CasADi's machine without Python; stiffness and width are states without motion, so
that the jump is the event's transition function and nothing is switched within a step; coordinates are divided by
their sizes, since CasADi takes one absolute tolerance. It finds one event in an interval of the output grid at most
(3.8.2), runs on without a word past a second, and fails where it must go back by more than a step of CVODES: the grid has two
points in the shortest cell at the speed of the start and twenty in an oscillation, with which it gets farthest. From the
states that carry cell and time of the last event, the events are read off the grid.
A reflection stops it all the same. Putting theta 1e-6 rad off the boundary would carry CVODES Adams through, at an error
of 1e-3; that is not done.
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
    # An event is an indicator that falls below zero.
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
    # Passed upwards or thrown back downwards: at the lower end of the cell, else at the upper one.
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
    """The events between the points of the grid: where the time of the last changes."""
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
