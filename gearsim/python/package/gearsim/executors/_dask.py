"""Sweeps by Dask."""

from __future__ import annotations

from gearsim.executors._remote import RemoteExecutor, settle


class DaskExecutor(RemoteExecutor):
    """Runs tasks on a Dask cluster.

    The executor of Dask itself, `client.get_executor()`, has futures that never end if the scheduler is lost while a result is fetched.
    Here they end with an error, so that `gearsim.sweep` runs the points again once the scheduler is back.

    client: a `distributed.Client`.
    options: those of `client.submit`, e.g. `resources={...}`.
    """

    def __init__(self, client, **options):
        super().__init__()
        self._client = client
        # A task with the key of a lost one would get its error.
        self._options = {"pure": False, **options}

    def _start(self, future, call):
        remote = self._client.submit(call, **self._options)
        remote.add_done_callback(lambda done: settle(future, done.result))
        return remote.cancel
