"""Sweeps by Ray."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Future
from typing import Any

from gearsim.executors._remote import RemoteExecutor


class RayExecutor(RemoteExecutor):
    """Runs tasks on a Ray cluster: the one that `ray.init` has connected to, or that of the variable `RAY_ADDRESS`, or this machine.

    options: those of `ray.remote`, e.g. `num_cpus=4` for `threads_per_task=4`, `resources={...}`. Ray does not run lost tasks again by
    itself (`max_retries=0`), since `gearsim.sweep` does.
    """

    def __init__(self, **options: Any) -> None:
        super().__init__()
        import ray

        if not ray.is_initialized():
            ray.init()
        self._ray = ray
        self._remote = ray.remote(**{"max_retries": 0, **options})(_call)

    def _start(self, future: Future[Any], call: Callable[[], object]) -> Callable[[], object]:
        reference = self._remote.remote(call)
        reference.future().add_done_callback(lambda done: self._settle(future, done.result))
        # Its worker process ends, so that the cores are free at once.
        return lambda: self._ray.cancel(reference, force=True)


def _call(call: Callable[[], object]) -> object:
    return call()
