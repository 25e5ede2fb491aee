"""A scene for all peers: the gear pair of Oh, Grosh & Barber (2005), its equations within a cell and its jump rule.

The state is y = [theta, theta', phi, phi']. theta is counted from the lower end of its cell, so that no peer loses digits because the
angle grows. Within a cell of stiffness k, Eqs. (2), (3) are

    phi''   = M2 (T0 - k phi - C phi')
    theta'' = M1 (T0 - k phi - C phi')

and at its ends the speeds jump by Eqs. (9), (11). All numbers come from `scenes.json`, which `cargo xtask peers` writes.
"""

from math import copysign, sqrt


class Scene:
    """The numbers of a scene, its equations within a cell and its jump rule."""

    def __init__(self, data):
        self.name = data["name"]
        self.m1, self.m2, self.c, self.t0 = (data[key] for key in ("m1", "m2", "c", "t0"))
        self.stiffness, self.widths = data["k"], data["width"]
        self.start, self.t_end, self.sizes = data["start"], data["t_end"], data["sizes"]

    def k(self, cell):
        """Stiffness of a cell [N m]. Cells are counted on over the pitches, two per pitch."""
        return self.stiffness[cell % 2]

    def width(self, cell):
        """Extent of a cell in theta [rad]."""
        return self.widths[cell % 2]

    def matrix(self, cell):
        """The Jacobian of y' within a cell, which is constant."""
        k, m1, m2, c = self.k(cell), self.m1, self.m2, self.c
        return [[0, 1, 0, 0], [0, 0, -m1 * k, -m1 * c], [0, 0, 0, 1], [0, 0, -m2 * k, -m2 * c]]

    def jump(self, cell, upwards, y):
        """Applies the jump rule at an end of a cell. Returns the kind of event, and the cell and the state after it.

        theta is set exactly on the boundary, whatever root the peer's event location found.
        """
        _, theta_dot, phi, phi_dot = y
        beyond = cell + 1 if upwards else cell - 1
        step = self.m2 * (self.k(beyond) - self.k(cell)) * phi * phi
        square = theta_dot * theta_dot - step
        ratio = self.m1 / self.m2
        if square < 0:
            theta = self.width(cell) if upwards else 0.0
            return "reflect", cell, [theta, -theta_dot, phi, phi_dot - 2 * ratio * theta_dot]
        after = copysign(sqrt(square), theta_dot)
        theta = 0.0 if upwards else self.width(beyond)
        total = after + theta_dot
        change = -step / total if total else 0.0
        return "transmit", beyond, [theta, after, phi, phi_dot + ratio * change]

    def atol(self, tolerance):
        """Absolute tolerances: `tolerance` of the size of each coordinate."""
        return [tolerance * size for size in self.sizes]


def restart(scene, fly):
    """Runs a scene with a solver that stops at the ends of a cell: `fly(t, cell, y)` returns time, state and whether it is the upper end.

    Instead of the last it returns None if the run ended first. This is the loop that a user of such a solver writes.
    """
    t, cell, y, events = 0.0, 0, list(scene.start), []
    while True:
        t, y, upwards = fly(t, cell, y)
        if upwards is None:
            return {"events": events, "cell": cell, "end": [float(x) for x in y]}
        kind, cell, y = scene.jump(cell, upwards, [float(x) for x in y])
        events.append([float(t), kind, cell])
