"""Executors of Ray, Dask and submitit: the same bytes as on one machine, even if workers and schedulers are lost."""

import os
import pathlib
import socket
import subprocess
import sys
import time
from concurrent.futures import Executor

import gearsim
import pytest
from gearsim.executors import DaskExecutor, RayExecutor, SubmititExecutor


class Through(Executor):
    """Sends tasks by another executor. In the worker, a function is called with the task."""

    def __init__(self, executor, function, *arguments):
        self.executor, self.function, self.arguments = executor, function, arguments
        self.count = 0

    def submit(self, task, *arguments):
        self.count += 1
        return self.executor.submit(self.function, *self.arguments, task, *arguments)


def die_once(marker: pathlib.Path, task, *arguments):
    """Run a task. The first worker that has run one dies before it can send the rows."""
    rows = task(*arguments)
    try:
        marker.touch(exist_ok=False)
    except FileExistsError:
        return rows
    os.kill(os.getpid(), 9)


def die(task, *arguments):
    os.kill(os.getpid(), 9)


def slowly(task, *arguments):
    """Run a task slowly (0.3 s), so that the scheduler can be killed during it."""
    time.sleep(0.3)
    return task(*arguments)


@pytest.fixture(scope="module", autouse=True)
def functions_for_workers():
    """Lets the processes of workers import this file."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("PYTHONPATH", os.path.dirname(__file__))
        yield


@pytest.fixture(scope="module")
def ray():
    ray = pytest.importorskip("ray")
    ray.init(num_cpus=2, include_dashboard=False, log_to_driver=False, logging_level="error")
    yield ray
    ray.shutdown()


def test_ray_runs_the_range_of_a_killed_worker_again(ray, sweep, tmp_path, bytes_of_the_command_line):
    executor = Through(RayExecutor(), die_once, tmp_path / "died")
    assert sweep(executor=executor, points_per_task=4) == bytes_of_the_command_line
    assert (tmp_path / "died").exists() and executor.count == 5 + 1


def test_a_sweep_whose_workers_always_die_ends_and_can_go_on(ray, sweep, points_kept, bytes_of_the_command_line):
    executor = Through(RayExecutor(), die)
    with pytest.raises(gearsim.GearsimError, match="(?s)points 0 to 17 did not run, tried 3 times: WorkerCrashedError.*continues"):
        sweep(executor=executor, points_per_task=100)
    assert executor.count == 3 and points_kept() == 0
    assert sweep(executor=RayExecutor(), points_per_task=5) == bytes_of_the_command_line


def test_cancelled_tasks_of_ray_end(ray):
    executor = RayExecutor()
    futures = [executor.submit(time.sleep, 60) for _ in range(4)]
    executor.shutdown(cancel_futures=True)
    assert all(future.cancelled() for future in futures)
    with pytest.raises(RuntimeError, match="shut down"):
        executor.submit(time.sleep, 0)


class Cluster:
    """A scheduler and two workers of Dask, each a process, at an address that stays the same."""

    def __init__(self):
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        self.address = f"tcp://127.0.0.1:{port}"
        self.processes = []

    def start(self):
        scheduler = ["dask_scheduler", "--host", "127.0.0.1", "--port", self.address.rpartition(":")[2], "--no-dashboard"]
        worker = ["dask_worker", self.address, "--nthreads", "1", "--no-nanny", "--no-dashboard"]
        for program, *arguments in (scheduler, worker, worker):
            command = [sys.executable, "-m", f"distributed.cli.{program}", *arguments]
            self.processes.append(subprocess.Popen(command, stderr=subprocess.DEVNULL))

    def kill_scheduler(self):
        self.processes[0].kill()

    def kill(self):
        for process in self.processes:
            process.kill()
            process.wait()
        self.processes = []


@pytest.fixture
def cluster():
    cluster = Cluster()
    cluster.start()
    yield cluster
    cluster.kill()


@pytest.fixture
def client(cluster):
    distributed = pytest.importorskip("distributed")
    with distributed.Client(cluster.address, timeout="30s") as client:
        client.wait_for_workers(2, timeout=30)
        yield client


def test_a_sweep_outlives_the_scheduler_of_dask(cluster, client, sweep, bytes_of_the_command_line):
    executor, before = Through(DaskExecutor(client), slowly), []

    def restart(done):
        if not before:
            before.append(executor.count)
            cluster.kill()
            cluster.start()

    assert sweep(executor=executor, points_per_task=2, progress=restart) == bytes_of_the_command_line
    # The tasks that were sent to the lost scheduler were sent again.
    assert before == [9] and executor.count > 9


def test_a_sweep_ends_if_the_scheduler_of_dask_stays_away(cluster, client, sweep, points_kept, bytes_of_the_command_line):
    # How long the client looks for its scheduler.
    client._timeout = 2
    executor = Through(DaskExecutor(client), slowly)
    with pytest.raises(gearsim.GearsimError, match="(?s)did not run.*continues with the points that are missing"):
        sweep(executor=executor, points_per_task=2, progress=lambda done: cluster.kill_scheduler())
    assert 2 <= points_kept() < 18
    assert sweep() == bytes_of_the_command_line


def test_submitit_runs_the_range_of_a_killed_job_again(sweep, tmp_path, bytes_of_the_command_line):
    submitit = pytest.importorskip("submitit")
    jobs = SubmititExecutor(submitit.LocalExecutor(tmp_path / "jobs"), interval=0.1)
    executor = Through(jobs, die_once, tmp_path / "died")
    assert sweep(executor=executor, points_per_task=9) == bytes_of_the_command_line
    assert (tmp_path / "died").exists() and executor.count == 2 + 1
