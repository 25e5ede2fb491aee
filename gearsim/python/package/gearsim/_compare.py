"""Runs side by side."""

from __future__ import annotations

from collections.abc import Callable

from gearsim._gearsim import Comparison, Scene, _check_arguments, _texts


def compare(
    *scenes: Scene, names: list[str] | None = None, progress: Callable[[float], object] | None = None
) -> Comparison:
    """Run scenes side by side; a single one under the exact, the rigid kinematic and the classical equations, as `gearsim compare`.

    scenes: one scene, or several.
    names: the names of several scenes in legends; by default their own names, numbered where they are equal.
    progress: called from time to time with the time [s] that the present run has reached.

    `runs` of the comparison has the results by these names; `plot` draws all runs into one figure.
    """
    if not scenes:
        raise ValueError("nothing is compared: give one scene, or several")
    for scene in scenes:
        _check_arguments(scene, progress=progress)
    names = None if names is None else _texts(names, "names", False)
    if len(scenes) == 1 and names is None:
        return Comparison(list(scenes[0].equation_sets().items()), progress)
    own = [scene.name for scene in scenes]
    if names is None:
        names = [f"{name} {i}" if own.count(name) > 1 else name for i, name in enumerate(own, 1)]
    if len(names) != len(scenes) or len(set(names)) != len(names):
        raise ValueError(f"{len(scenes)} scenes need as many different names, not {names}")
    return Comparison(list(zip(names, scenes)), progress)
