"""gearsim: energy-conserving simulation of gear systems.

>>> import gearsim
>>> scene = gearsim.Scene(
...     "chain_2",
...     parameters={"I1": 0.5, "I2": 0.25, "k1": "10 kN*m/rad"},
...     start={"theta1_dot": 2.0},
...     run={"t_end": "0.1 s"},
... )
>>> results = scene.run()
>>> len(results["t"]) > 100
True
"""

from __future__ import annotations

import os
import signal
import sys

from gearsim import executors
from gearsim._gearsim import (
    Comparison,
    Figure,
    GearsimError,
    Gathering,
    Job,
    Results,
    Scene,
    SceneError,
    Table,
    __version__,
    command_line,
    models,
)
from gearsim._compare import compare
from gearsim._display import install
from gearsim._sweep import limits, sensitivity, sweep

__all__ = [
    "Comparison",
    "Figure",
    "Gathering",
    "GearsimError",
    "Job",
    "Results",
    "Scene",
    "SceneError",
    "Table",
    "__version__",
    "compare",
    "executors",
    "limits",
    "load",
    "models",
    "sensitivity",
    "sweep",
]

install()


def load(path: str | os.PathLike[str]) -> Scene:
    """Read a scene file."""
    return Scene.load(path)


def _command_line() -> None:
    """The program `gearsim`."""
    # Ctrl-C ends the program at once, as without Python.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    sys.exit(command_line(sys.argv))
