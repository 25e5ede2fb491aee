"""Sweeps by submitit: Slurm jobs."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Future
from typing import Any

from gearsim.executors._remote import RemoteExecutor, check


class SubmititExecutor(RemoteExecutor):
    """Runs tasks as jobs of Slurm. Tasks that are submitted together become one job array.

    executor: a `submitit.AutoExecutor(folder)`, with its parameters set. The jobs of submitit are not `concurrent.futures.Future`: this
    executor asks for their state.
    interval: time between two questions [s]. submitit itself asks Slurm once a minute.
    """

    def __init__(self, executor: Any, interval: float = 1.0) -> None:
        check("executor", executor, "submit_array", "submitit.AutoExecutor")
        super().__init__(interval)
        self._executor = executor
        self._new: list[tuple[Future[Any], Callable[[], object]]] = []
        self._jobs: dict[Future[Any], Any] = {}

    def _start(self, future: Future[Any], call: Callable[[], object]) -> Callable[[], object]:
        with self._lock:
            self._new.append((future, call))
        return lambda: self._cancel(future)

    def _cancel(self, future: Future[Any]) -> None:
        with self._lock:
            job = self._jobs.get(future)
        if job is not None:
            job.cancel()

    def _look(self) -> None:
        with self._lock:
            new, self._new = self._new, []
        try:
            jobs = self._executor.submit_array([call for _, call in new]) if new else []
        except Exception as error:
            self._fail([future for future, _ in new], error)
            jobs = []
        with self._lock:
            self._jobs.update((future, job) for (future, _), job in zip(new, jobs))
        for future, job in list(self._jobs.items()):
            if future.cancelled():
                job.cancel()
            if job.done():
                with self._lock:
                    del self._jobs[future]
                self._settle(future, job.result)
