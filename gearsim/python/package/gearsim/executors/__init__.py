"""Executors of other packages, for `gearsim.sweep(..., executor=...)`.

Each is one file of this folder: a class derived from `RemoteExecutor`, and one line here. The packages are imported when an executor is
made, not before.
"""

from gearsim.executors._dask import DaskExecutor
from gearsim.executors._ray import RayExecutor
from gearsim.executors._submitit import SubmititExecutor

__all__ = ["DaskExecutor", "RayExecutor", "SubmititExecutor"]
