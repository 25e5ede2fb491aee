"""gearsim itself through its library, and the two solvers written by hand for this system.

Warm, in one process, without files, as the others; gearsim with its guarantee of crossings and its energy account.
There is no tolerance to choose. The program is xtask/chores/src/bin/peers.
"""

from .binary import run_binary

METHODS = ["gearsim", "hand-written", "hand-written, fast"]
TOLERANCES = ["exact"]


def version():
    return "gearsim of this checkout"


def run(scene, method, tolerance):
    return run_binary("PEERS_OWN", "run", *scene.flags, method, scene.name)
