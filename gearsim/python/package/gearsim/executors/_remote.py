"""What the executors of other packages have in common."""

from __future__ import annotations

import functools
import threading
import time
from collections.abc import Callable, Iterable
from concurrent import futures
from concurrent.futures import Executor, Future
from numbers import Real
from typing import Any, ParamSpec, TypeVar

_P = ParamSpec("_P")
_T = TypeVar("_T")


def check(name: str, value: object, method: str, allowed: str) -> None:
    """Raise an error if the argument `name` is no object with a method: it would be found at the first task, in another thread."""
    if isinstance(value, type) or not callable(getattr(value, method, None)):
        raise TypeError(f"`{name}` is a {allowed}, not {value!r} ({type(value).__name__}): {name}={allowed}(...)")


class RemoteExecutor(Executor):
    """Sends tasks to another package. Every future ends: with a value, with an error, or cancelled.

    A derived class defines `_start`, and `_look` if it has to ask for the state of its tasks.
    interval: time between two calls of `_look` while tasks are open [s]; None for no calls.
    """

    def __init__(self, interval: float | None = None) -> None:
        # The thread that asks would end by it, and no future would.
        if interval is not None and not (isinstance(interval, Real) and interval >= 0):
            raise TypeError(f"`interval` is a time in s, not {interval!r} ({type(interval).__name__}): interval=1.0")
        self._interval = interval
        self._lock = threading.Lock()
        self._open: set[Future[Any]] = set()
        self._closed = False
        self._thread: threading.Thread | None = None

    def _start(self, future: Future[Any], call: Callable[[], object]) -> Callable[[], object]:
        """Send `call`, have `_settle` called for `future` at its end, and return a function that cancels it."""
        raise NotImplementedError

    def _look(self) -> None:
        """Ask for the state of the open tasks."""

    def submit(self, task: Callable[_P, _T], /, *arguments: _P.args, **keywords: _P.kwargs) -> Future[_T]:
        """Send `task(*arguments, **keywords)`, and return its future."""
        if self._closed:
            raise RuntimeError("this executor is shut down: make another one")
        future: Future[_T] = Future()
        with self._lock:
            self._open.add(future)
        try:
            cancel = self._start(future, functools.partial(task, *arguments, **keywords))
        except BaseException:
            with self._lock:
                self._open.discard(future)
            raise
        future.add_done_callback(lambda future: cancel() if future.cancelled() else None)
        with self._lock:
            if self._interval is not None and self._thread is None:
                self._thread = threading.Thread(target=self._watch, args=[self._interval], name="gearsim-executor", daemon=True)
                self._thread.start()
        return future

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        """Take no more tasks. The cluster itself goes on."""
        self._closed = True
        with self._lock:
            unfinished = list(self._open)
        if cancel_futures:
            for future in unfinished:
                future.cancel()
        if wait:
            futures.wait(unfinished)

    def _settle(self, future: Future[Any], result: Callable[[], object]) -> None:
        """End a future by the value that `result` returns, or by the exception that it raises. The first call for a future counts."""
        value: object = None
        error: BaseException | None = None
        try:
            value = result()
        except BaseException as raised:
            error = raised
        with self._lock:
            if future not in self._open:
                return
            self._open.remove(future)
        if not future.set_running_or_notify_cancel():
            return
        if error is None:
            future.set_result(value)
        else:
            future.set_exception(error)

    def _fail(self, unfinished: Iterable[Future[Any]], error: Exception) -> None:
        """End futures by an error."""

        def result() -> object:
            raise error

        for future in unfinished:
            self._settle(future, result)

    def _watch(self, interval: float) -> None:
        """Call `_look` until no task is open."""
        while True:
            time.sleep(interval)
            with self._lock:
                unfinished = list(self._open)
                if not unfinished:
                    self._thread = None
                    return
            try:
                self._look()
            except Exception as error:
                self._fail(unfinished, error)
