"""Sweeps by Dask."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Future
from typing import Any

from gearsim.executors._remote import RemoteExecutor, check


class DaskExecutor(RemoteExecutor):
    """Runs tasks on a Dask cluster.

    The executor of Dask itself, `client.get_executor()`, has futures that never end if the scheduler is lost while a result is fetched.
    Here they end with an error. `gearsim.sweep` then runs the points again once the scheduler is back, or ends if the client is closed.

    client: a `distributed.Client`.
    options: those of `client.submit`, e.g. `resources={...}`.
    """

    def __init__(self, client: Any, **options: Any) -> None:
        check("client", client, "submit", "distributed.Client")
        super().__init__(interval=1.0)
        self._client = client
        # A task with the key of a lost one would get its error.
        self._options = {"pure": False, **options}

    def _start(self, future: Future[Any], call: Callable[[], object]) -> Callable[[], object]:
        remote = self._client.submit(call, **self._options)
        remote.add_done_callback(lambda done: self._settle(future, done.result))
        cancel: Callable[[], object] = remote.cancel
        return cancel

    def _look(self) -> None:
        # The client closes if it does not find its scheduler again. Tasks that were submitted just before never end by themselves.
        if self._client.status == "closed":
            raise ConnectionError("the Dask client is closed: it has lost its scheduler")
