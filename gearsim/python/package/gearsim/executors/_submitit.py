"""Sweeps by submitit: Slurm jobs."""

from __future__ import annotations

import threading
import time

from gearsim.executors._remote import RemoteExecutor, settle


class SubmititExecutor(RemoteExecutor):
    """Runs tasks as jobs of Slurm. Tasks that are submitted together become one job array.

    executor: a `submitit.AutoExecutor(folder)`, with its parameters set. The jobs of submitit are no `concurrent.futures.Future`; this
    executor asks for their state.
    interval: time between two questions [s]. submitit itself asks Slurm once a minute.
    """

    def __init__(self, executor, interval=1.0):
        super().__init__()
        self._executor = executor
        self._interval = interval
        self._lock = threading.Lock()
        self._new = []
        self._jobs = {}
        self._thread = None

    def _start(self, future, call):
        with self._lock:
            self._new.append((future, call))
            if self._thread is None:
                self._thread = threading.Thread(target=self._watch, name="gearsim-submitit", daemon=True)
                self._thread.start()
        return lambda: self._cancel(future)

    def _cancel(self, future):
        with self._lock:
            job = self._jobs.get(future)
        if job is not None:
            job.cancel()

    def _watch(self):
        """Submit new tasks and settle finished ones, until there are none."""
        while True:
            time.sleep(self._interval)
            with self._lock:
                new, self._new = self._new, []
                if not new and not self._jobs:
                    self._thread = None
                    return
            self._submit([(future, call) for future, call in new if not future.cancelled()])
            for future, job in list(self._jobs.items()):
                if future.cancelled() or job.done():
                    with self._lock:
                        del self._jobs[future]
                    settle(future, job.result)

    def _submit(self, new):
        """Submit tasks as one array of jobs. If that fails, their futures have its error."""
        try:
            jobs = self._executor.submit_array([call for _, call in new]) if new else []
        except Exception as error:
            for future, _ in new:
                settle(future, lambda error=error: _raise(error))
            return
        with self._lock:
            self._jobs.update((future, job) for (future, _), job in zip(new, jobs))


def _raise(error):
    raise error
