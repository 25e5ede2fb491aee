"""The cost of executors, compared with the threads of the command line: `python gearsim/python/measure/cost.py 10000 100000`.

Every number of points is swept by every executor, one after the other and with the same number of workers, in several rounds. The tables
must have the same bytes. A cluster is started and used once before its measurement, and runs alone. Two times are measured: that on the clock, and the
processor time of this process and all its descendants, the cluster's included. Ratios are those to the threads of the same round: median,
least and largest. On a machine that others also use, the processor time is more reliable.

With `--side-by-side` the command line runs on one thread beside each executor, which has one worker, at the same time: the speed of a machine may
drift in the minutes that a long sweep takes, and then it drifts for both. Only processor times are compared.

With `--idle` the processor time of a cluster that waits is measured: schedulers, monitors and heartbeats take it whether points run or not.
"""

import argparse
import contextlib
import filecmp
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ProcessPoolExecutor

import gearsim
import psutil

SCENE = pathlib.Path(__file__).parents[3] / "models" / "scenes" / "oh2005" / "energy_300rpm.toml"
T_END = "1 ms"
#: Time for which a cluster waits [s].
IDLE = 20.0


def axes(points):
    return [f"start.speed=100 rpm:900 rpm:{points // 10}", "parameters.zeta=0.01:0.1:10"]


class Plan:
    """The sweep: scene, end time, recorded quantities, workers, points of a task."""

    def __init__(self, given):
        self.t_end, self.record = given.t_end, given.record
        self.workers, self.per_task = given.workers, given.per_task

    def command(self, points, out):
        command = [sys.executable, "-m", "gearsim", "sweep", SCENE, "--quiet", "--set", f"run.t_end={self.t_end}", "--record", self.record]
        command += ["--threads", self.workers, "--out", out, *(part for axis in axes(points) for part in ("--vary", axis))]
        return [str(word) for word in command]

    def command_line(self, points, out):
        subprocess.run(self.command(points, out), check=True)

    def by(self, executor):
        def sweep(points, out):
            scene = gearsim.load(SCENE).replace({"run.t_end": self.t_end})
            gearsim.sweep(scene, *axes(points), record=[self.record], out=out, executor=executor, points_per_task=self.per_task)

        return sweep


@contextlib.contextmanager
def threads(plan):
    """The threads of the command line."""
    yield plan.command_line


@contextlib.contextmanager
def processes(plan):
    with ProcessPoolExecutor(plan.workers) as pool:
        yield plan.by(pool)


@contextlib.contextmanager
def dask(plan):
    import distributed

    cluster = distributed.LocalCluster(n_workers=plan.workers, threads_per_worker=1, dashboard_address=None)
    with cluster, distributed.Client(cluster) as client:
        yield plan.by(gearsim.executors.DaskExecutor(client))


@contextlib.contextmanager
def by_ray(plan):
    import ray

    ray.init(num_cpus=plan.workers, include_dashboard=False, log_to_driver=False, logging_level="error")
    try:
        yield plan.by(gearsim.executors.RayExecutor())
    finally:
        ray.shutdown()


WAYS = {"threads": threads, "processes": processes, "Dask": dask, "Ray": by_ray}


@contextlib.contextmanager
def started(plan, name):
    """A way of running, started and used once. No other cluster runs, since the processes of a cluster take time while they wait."""
    with WAYS[name](plan) as way:
        measured(way, 100)
        yield way


def processor_time():
    """Processor time of this process and of all its descendants, ended ones included [s]."""
    here = psutil.Process()
    total = 0.0
    for process in [here, *here.children(recursive=True)]:
        with contextlib.suppress(psutil.NoSuchProcess):
            times = process.cpu_times()
            total += times.user + times.system + times.children_user + times.children_system
    return total


def measured(way, points):
    """Time on the clock [s], processor time [s], and table of a sweep."""
    with tempfile.TemporaryDirectory() as out:
        clock, processor = time.perf_counter(), processor_time()
        way(points, out)
        times = time.perf_counter() - clock, processor_time() - processor
        return *times, (pathlib.Path(out) / "sweep.parquet").read_bytes()


def side_by_side(plan, way, points):
    """Processor times of the command line and of an executor that run at the same time [s]; their tables must have the same bytes."""
    with tempfile.TemporaryDirectory() as ours, tempfile.TemporaryDirectory() as theirs:
        before = processor_time()
        command_line = subprocess.Popen(plan.command(points, theirs))
        way(points, ours)
        _, status, used = os.wait4(command_line.pid, 0)
        command_line.returncode = os.waitstatus_to_exitcode(status)
        assert command_line.returncode == 0, "the command line failed"
        by_command = used.ru_utime + used.ru_stime
        # The ended command line is a descendant too.
        by_executor = processor_time() - before - by_command
        one, other = (pathlib.Path(out) / "sweep.parquet" for out in (ours, theirs))
        assert filecmp.cmp(one, other, shallow=False), "the tables differ"
    return by_command, by_executor


def compare_side_by_side(plan, given):
    print("| points | executor | µs a point by threads | by the executor | ratio |")
    for points in given.points:
        for name in given.executors:
            with started(plan, name) as way:
                times = [side_by_side(plan, way, points) for _ in range(given.repeat)]
            by_threads, by_executor = (statistics.median(column) for column in zip(*times))
            of = sorted(theirs / ours for ours, theirs in times)
            each = f"{1e6 * by_threads / points:.1f} | {1e6 * by_executor / points:.1f}"
            print(f"| {points} | {name} | {each} | {statistics.median(of):.3f} ({of[0]:.3f} to {of[-1]:.3f}) |", flush=True)


def idle(plan, given):
    print("| executor | workers | processor time while it waits, of one core |")
    for name in given.executors:
        with started(plan, name):
            before = processor_time()
            time.sleep(IDLE)
            print(f"| {name} | {plan.workers} | {100 * (processor_time() - before) / IDLE:.1f} % |", flush=True)


def compare_in_turn(plan, given):
    print("| points | way | clock, ratio | processor time, ratio | processor time a point |")
    names = list(dict.fromkeys(["threads", *given.executors]))
    for points in given.points:
        clock, processor, tables = {name: [] for name in names}, {name: [] for name in names}, set()
        for _ in range(given.repeat):
            for name in names:
                with started(plan, name) as way:
                    on_clock, on_processor, table = measured(way, points)
                clock[name].append(on_clock)
                processor[name].append(on_processor)
                tables.add(table)
        assert len(tables) == 1, "the tables differ"
        for name in names:
            a_point = 1e6 * statistics.median(processor[name]) / points
            both = f"{ratios(clock[name], clock['threads'])} | {ratios(processor[name], processor['threads'])}"
            print(f"| {points} | {name} | {both} | {a_point:.1f} µs |", flush=True)


def ratios(times, base):
    """Median of the times, and median, least and largest of their ratios to `base` in the same round."""
    of = sorted(time_taken / other for time_taken, other in zip(times, base))
    return f"{statistics.median(times):.2f} s, {statistics.median(of):.2f} ({of[0]:.2f} to {of[-1]:.2f})"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("points", nargs="*", type=int, help="numbers of points, multiples of 10")
    parser.add_argument("--workers", type=int, default=os.cpu_count())
    parser.add_argument("--per-task", type=int, default=10_000)
    parser.add_argument("--t-end", default=T_END, help="end of each run: the cost of a point grows with it")
    parser.add_argument("--record", default="events", choices=["events", "outputs"])
    parser.add_argument("--repeat", type=int, default=5)
    parser.add_argument("--side-by-side", action="store_true", help="one worker, and the command line beside it")
    parser.add_argument("--idle", action="store_true", help="only the processor time of clusters that wait")
    parser.add_argument("--executors", nargs="+", choices=WAYS, default=["processes", "Dask", "Ray"], help="the executors to measure")
    given = parser.parse_args()
    given.workers = 1 if given.side_by_side else given.workers
    plan = Plan(given)
    print(f"{SCENE.stem} to {plan.t_end}, {plan.record} recorded; {plan.workers} workers, {plan.per_task} points a task; {given.repeat} rounds")
    print(f"load of the machine before: {os.getloadavg()[0]:.1f}")
    if given.idle:
        return idle(plan, given)
    compare = compare_side_by_side if given.side_by_side else compare_in_turn
    compare(plan, given)


if __name__ == "__main__":
    main()
