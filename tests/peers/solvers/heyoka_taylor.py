"""heyoka's Taylor integrator, compiled once, with terminal events.

Fair: stiffness and width are runtime parameters, so one compiled integrator serves all cells. Both events have a direction, so a
restart on the boundary does not trigger them again; the cooldown is heyoka's own choice and is reset between runs. The callbacks
of the events do the jump, so a whole run is one call of propagate_until. Arrays are fetched once and written in place. The time of
compilation is shown separately. "default" is heyoka's tolerance of 2.2e-16.
"""

import heyoka as hy

from clock import measure

METHODS = ["Taylor"]
TOLERANCES = [1e-6, 1e-9, 1e-12, "default"]


def version():
    return f"heyoka {hy.__version__}"


class Run:
    """The integrator, and the events and the cell that its callbacks record."""

    def __init__(self, scene, tolerance):
        self.scene = scene
        theta, theta_dot, phi, phi_dot = hy.make_vars("theta", "theta_dot", "phi", "phi_dot")
        k, width = hy.par[0], hy.par[1]
        pull = scene.t0 - k * phi - scene.c * phi_dot
        system = [(theta, theta_dot), (theta_dot, scene.m1 * pull), (phi, phi_dot), (phi_dot, scene.m2 * pull)]
        upper = hy.t_event(theta - width, direction=hy.event_direction.positive, callback=self.upper)
        lower = hy.t_event(theta, direction=hy.event_direction.negative, callback=self.lower)
        options = {} if tolerance == "default" else {"tol": tolerance}
        self.taylor = hy.taylor_adaptive(system, list(scene.start), pars=[1.0, 1.0], t_events=[upper, lower], **options)
        self.events, self.cell = [], 0

    def upper(self, taylor, _sign):
        return self.jump(taylor, True)

    def lower(self, taylor, _sign):
        return self.jump(taylor, False)

    def __deepcopy__(self, _memo):
        # heyoka copies its callbacks and the object to which a method is bound. The callbacks must record in this object.
        return self

    def jump(self, taylor, upwards):
        state = taylor.state
        kind, self.cell, state[:] = self.scene.jump(self.cell, upwards, state.tolist())
        taylor.pars[:] = self.scene.k(self.cell), self.scene.width(self.cell)
        self.events.append([taylor.time, kind, self.cell])
        return True

    def solve(self):
        scene, taylor = self.scene, self.taylor
        self.events, self.cell = [], 0
        taylor.time = 0.0
        taylor.state[:] = scene.start
        taylor.pars[:] = scene.k(0), scene.width(0)
        taylor.reset_cooldowns()
        outcome = taylor.propagate_until(scene.t_end)[0]
        if outcome != hy.taylor_outcome.time_limit:
            raise RuntimeError(f"stopped: {outcome}")
        return {"events": self.events, "cell": self.cell, "end": taylor.state.tolist()}


def run(scene, _method, tolerance):
    return measure(lambda: Run(scene, tolerance), Run.solve)
