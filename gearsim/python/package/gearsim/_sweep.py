"""Sweeps, on this machine or by any executor."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Callable, Sequence
from concurrent.futures import FIRST_COMPLETED, Executor, Future, wait
from typing import TYPE_CHECKING, Any

from gearsim._gearsim import Gathering, GearsimError, Job, Scene, Table, _check_arguments, _texts

if TYPE_CHECKING:
    from gearsim._gearsim import _Axis, _Design

#: How often a range of points is tried if its worker is lost.
TRIES = 3


#: The numbers of the first point of a part, and of the point after its last.
_Part = tuple[int, int]


def _part(scene: Scene, definition: dict[str, Any], first: int, end: int, threads: int | None) -> bytes:
    """Run points in a worker, and return their rows as bytes."""
    return scene.job(**definition).run(first, end, threads=threads)


def sweep(
    scene: Scene,
    *axes: _Axis,
    record: str | Sequence[str] = (),
    start: float | None = None,
    samples: int | None = None,
    seed: int = 0,
    design: _Design = "random",
    out: str | os.PathLike[str] | None = None,
    executor: Executor | None = None,
    points_per_task: int = 10_000,
    threads_per_task: int | None = 1,
    progress: Callable[[int], object] | None = None,
) -> Table:
    """Run a scene at many values, and return a table with one row a point.

    The columns of outputs and extremes end with what they give: `_min`, `_max`, `_mean`, and `_rms`, the root mean square about the mean.

    scene: a Scene.
    axes: texts as for the option `--vary`, e.g. "start.speed=100 rpm:6000 rpm:200", "parameters.b=normal:100 um:10 um"; and dicts of keys
        and values, e.g. {"parameters.T0": [1, 2, 3], "start.speed": numpy.linspace(10, 600, 200)}: lists and arrays of numbers in SI
        units and of texts with units. The points are all combinations of all axes; the last axis varies fastest.
    record: groups of quantities, e.g. ["outputs"], or one.
    start: start of the time over which extremes and means are taken [s]; by default output.from of the scene.
    samples, seed: number of samples for random axes.
    design: how samples are chosen: "random", "latin-hypercube", "sobol", or "saltelli" for `sensitivity`.
    out: folder for the results. Finished points in it do not run again; its file `sweep.parquet` has the bytes of `gearsim sweep`.
    executor: any concurrent.futures.Executor, for example of processes, Dask or MPI; without it, the threads of this machine.
    points_per_task: the largest number of points that a worker gets at once; they are stored together. Small tasks are mostly overhead.
    threads_per_task: threads of a worker; None for all cores of its machine.
    progress: called with the number of finished points.
    """
    job, definition = _job(scene, axes, record, start, samples, seed, design)
    return _run(scene, job, definition, out, executor, points_per_task, threads_per_task, progress)


def sensitivity(
    scene: Scene,
    *axes: _Axis,
    samples: int,
    record: str | Sequence[str] = (),
    start: float | None = None,
    seed: int = 0,
    out: str | os.PathLike[str] | None = None,
    executor: Executor | None = None,
    points_per_task: int = 10_000,
    threads_per_task: int | None = 1,
    progress: Callable[[int], object] | None = None,
) -> Table:
    """Find which random axis causes which share of the variance of each recorded quantity.

    Runs samples * (number of random axes + 2) points, and returns a table with one row an axis and quantity: `first_order` is the share
    that the axis causes alone, `total` that with interactions, each with half the width of its 95 % interval (Saltelli et al., 2010).

    The arguments are those of `sweep`.
    """
    job, definition = _job(scene, axes, record, start, samples, seed, "saltelli")
    return job.sensitivity(_run(scene, job, definition, out, executor, points_per_task, threads_per_task, progress))


def limits(
    scene: Scene,
    *axes: _Axis,
    limits: str | Sequence[str],
    samples: int | None = None,
    record: str | Sequence[str] = (),
    start: float | None = None,
    seed: int = 0,
    design: _Design = "random",
    out: str | os.PathLike[str] | None = None,
    executor: Executor | None = None,
    points_per_task: int = 10_000,
    threads_per_task: int | None = 1,
    progress: Callable[[int], object] | None = None,
) -> Table:
    """Find how probable it is that limits are broken, e.g. limits=["mesh_force_12_max <= 5 kN"], record=["outputs"].

    Runs a sweep, and returns a table with one row a limit at each point of the axes that are not random: how many points break it, its
    `probability`, and the ends of the 95 % interval, `low_95` and `high_95`. Without random axes points are counted and have no probability.

    The arguments are those of `sweep`. For the table of the points too: `job = scene.job(axes, ...)`, `sweep(...)`, `job.limits(table, limits)`.
    """
    limits = _texts(limits, "limits", True)
    job, definition = _job(scene, axes, record, start, samples, seed, design)
    table = _run(scene, job, definition, out, executor, points_per_task, threads_per_task, progress)
    return job.limits(table, limits)


def _job(
    scene: Scene,
    axes: Sequence[_Axis],
    record: str | Sequence[str],
    start: float | None,
    samples: int | None,
    seed: int,
    design: _Design,
) -> tuple[Job, dict[str, Any]]:
    """The sweep, and its definition for workers."""
    _check_arguments(scene)
    record = _texts(record, "record", True)
    definition: dict[str, Any] = dict(axes=axes, record=record, start=start, samples=samples, seed=seed, design=design)
    job = scene.job(**definition)
    # Workers get the axes as texts, whatever the values are made of.
    return job, {**definition, "axes": job.axes}


def _run(
    scene: Scene,
    job: Job,
    definition: dict[str, Any],
    out: str | os.PathLike[str] | None,
    executor: Executor | None,
    points_per_task: int,
    threads_per_task: int | None,
    progress: Callable[[int], object] | None,
) -> Table:
    """Run the points of a job, and return their table."""
    _check_arguments(scene, out, points_per_task, threads_per_task, progress)
    _check(executor)
    with tempfile.TemporaryDirectory() as temporary:
        gathering = job.gather(out if out is not None else temporary)
        try:
            missing = job.missing(gathering, points_per_task)
            done = len(job) - sum(end - first for first, end in missing)
            if executor is None:
                for first, end in missing:
                    job.keep(gathering, job.run(first, end, _after(done, progress)))
                    done += end - first
            else:

                def submit(part: _Part) -> Future[bytes]:
                    future = executor.submit(_part, scene, definition, *part, threads_per_task)
                    if not isinstance(future, Future):
                        raise _unfit(type(executor), f"its `submit` returns {type(future).__name__}")
                    return future

                _gather(submit, job, gathering, missing, done, progress)
            return gathering.finish()
        finally:
            # A stored exception keeps this frame, and would keep the folder in use.
            gathering.close()


#: Packages whose own objects are no executors, and what to pass instead.
_ADAPTERS = {
    "submitit": "gearsim.executors.SubmititExecutor(executor)",
    "distributed": "gearsim.executors.DaskExecutor(client)",
    "dask": "gearsim.executors.DaskExecutor(client)",
    "ray": "gearsim.executors.RayExecutor()",
}


def _check(executor: object) -> None:
    """Raise an error if `executor` is none, before a task is sent to it."""
    kind = executor if isinstance(executor, type) else type(executor)
    if executor is None or isinstance(executor, Executor):
        return
    if kind is executor:
        raise _unfit(kind, f"{kind.__name__} is a class")
    if kind.__module__.partition(".")[0] in _ADAPTERS or not callable(getattr(executor, "submit", None)):
        raise _unfit(kind, f"{kind.__name__} is none")


def _unfit(kind: type, why: str) -> TypeError:
    """The error that says what an executor must be, and what to pass instead of one of the type `kind`."""
    adapter = _ADAPTERS.get(kind.__module__.partition(".")[0])
    adapters = [adapter] if adapter else dict.fromkeys(_ADAPTERS.values())
    return TypeError(
        f"`executor` must be a concurrent.futures.Executor, whose `submit` returns a concurrent.futures.Future; {why}\n"
        f"  help: pass {' or '.join(adapters)}"
    )


def _after(done: int, progress: Callable[[int], object] | None) -> Callable[[float], object] | None:
    """The progress function for one part: adds the `done` points that the sweep had before."""
    return None if progress is None else lambda count: progress(done + int(count))


def _gather(
    submit: Callable[[_Part], Future[bytes]],
    job: Job,
    gathering: Gathering,
    missing: list[_Part],
    done: int,
    progress: Callable[[int], object] | None,
) -> None:
    """Let the executor run ranges of points, and keep their rows as they come. The range of a lost worker runs again."""
    running = {submit(part): (part, 1) for part in missing}
    try:
        while running:
            finished, _ = wait(running, return_when=FIRST_COMPLETED)
            # `finished` is a set. Sorted by points, the same part ends a sweep each time.
            for future in sorted(finished, key=lambda future: running[future]):
                part, tries = running.pop(future)
                try:
                    rows = future.result()
                except Exception as error:
                    # Mistakes of the scene were found before the sweep, so that the worker was lost or its machine has a fault.
                    running[_again(submit, part, tries, error)] = (part, tries + 1)
                    continue
                job.keep(gathering, rows)
                done += part[1] - part[0]
                if progress:
                    progress(done)
    finally:
        for future in running:
            future.cancel()


def _again(
    submit: Callable[[_Part], Future[bytes]], part: _Part, tries: int, error: Exception
) -> Future[bytes]:
    """Submit a range of points once more, and return its future. Raise an error if all tries are used or the executor refuses it."""
    try:
        if tries < TRIES:
            return submit(part)
    except Exception as refusal:
        error = refusal
    first, end = part
    raise GearsimError(
        f"points {first} to {end - 1} did not run, tried {tries} times: {type(error).__name__}: {error}\n"
        "  help: look for the cause at the executor; the same sweep, started again with the same folder `out`, continues with the "
        "points that are missing"
    ) from error
