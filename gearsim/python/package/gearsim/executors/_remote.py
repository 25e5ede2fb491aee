"""What the executors of other packages have in common."""

from __future__ import annotations

import functools
from collections.abc import Callable
from concurrent import futures
from concurrent.futures import Executor, Future


class RemoteExecutor(Executor):
    """Sends tasks to another package. Every future ends: with a value, with an error, or cancelled."""

    def __init__(self):
        self._open = set()
        self._closed = False

    def _start(self, future: Future, call: Callable[[], object]) -> Callable[[], object]:
        """Send `call`, have `settle` called for `future` at its end, and return a function that cancels it."""
        raise NotImplementedError

    def submit(self, task, /, *arguments, **keywords):
        """Send `task(*arguments, **keywords)`, and return its future."""
        if self._closed:
            raise RuntimeError("this executor is shut down: make another one")
        future = Future()
        cancel = self._start(future, functools.partial(task, *arguments, **keywords))
        self._open.add(future)
        future.add_done_callback(self._open.discard)
        future.add_done_callback(lambda future: cancel() if future.cancelled() else None)
        return future

    def shutdown(self, wait=True, *, cancel_futures=False):
        """Take no more tasks. The cluster itself goes on."""
        self._closed = True
        if cancel_futures:
            for future in list(self._open):
                future.cancel()
        if wait:
            futures.wait(list(self._open))


def settle(future: Future, result: Callable[[], object]):
    """End a future by the value that `result` returns, or by the exception that it raises."""
    if not future.set_running_or_notify_cancel():
        return
    try:
        value = result()
    except BaseException as error:
        future.set_exception(error)
    else:
        future.set_result(value)
