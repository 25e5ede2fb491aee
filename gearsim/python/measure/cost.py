"""The cost of executors, compared with the threads of the command line: `python gearsim/python/measure/cost.py 10000 100000`.

Every number of points is swept by every executor, one after the other and with the same number of workers, in several rounds. The tables
must have the same bytes. Clusters are started and used once before the measurement. Two times are measured: that on the clock, and the
processor time of this process and all its descendants, the cluster's included. Ratios are those to the threads of the same round: median,
least and largest. On a machine that others also use, the processor time is more reliable.
"""

import argparse
import contextlib
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


def axes(points):
    return [f"start.speed=100 rpm:900 rpm:{points // 10}", "parameters.zeta=0.01:0.1:10"]


class Plan:
    """The sweep: scene, end time, recorded quantities, workers, points of a task."""

    def __init__(self, given):
        self.t_end, self.record = given.t_end, given.record
        self.workers, self.per_task = given.workers, given.per_task

    def command_line(self, points, out):
        command = [sys.executable, "-m", "gearsim", "sweep", SCENE, "--quiet", "--set", f"run.t_end={self.t_end}", "--record", self.record]
        command += ["--threads", self.workers, "--out", out, *(part for axis in axes(points) for part in ("--vary", axis))]
        subprocess.run([str(word) for word in command], check=True)

    def by(self, executor):
        def sweep(points, out):
            scene = gearsim.load(SCENE).replace({"run.t_end": self.t_end})
            gearsim.sweep(scene, *axes(points), record=[self.record], out=out, executor=executor, points_per_task=self.per_task)

        return sweep


@contextlib.contextmanager
def all_ways(plan):
    """The command line, and one executor of each kind."""
    import distributed
    import ray

    ray.init(num_cpus=plan.workers, include_dashboard=False, log_to_driver=False, logging_level="error")
    cluster = distributed.LocalCluster(n_workers=plan.workers, threads_per_worker=1, dashboard_address=None)
    with cluster, distributed.Client(cluster) as client, ProcessPoolExecutor(plan.workers) as processes:
        dask, by_ray = gearsim.executors.DaskExecutor(client), gearsim.executors.RayExecutor()
        yield {"threads": plan.command_line, "processes": plan.by(processes), "Dask": plan.by(dask), "Ray": plan.by(by_ray)}
    ray.shutdown()


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


def ratios(times, base):
    """Median of the times, and median, least and largest of their ratios to `base` in the same round."""
    of = sorted(time_taken / other for time_taken, other in zip(times, base))
    return f"{statistics.median(times):.2f} s, {statistics.median(of):.2f} ({of[0]:.2f} to {of[-1]:.2f})"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("points", nargs="+", type=int, help="numbers of points, multiples of 10")
    parser.add_argument("--workers", type=int, default=os.cpu_count())
    parser.add_argument("--per-task", type=int, default=10_000)
    parser.add_argument("--t-end", default=T_END, help="end of each run: the cost of a point grows with it")
    parser.add_argument("--record", default="events", choices=["events", "outputs"])
    parser.add_argument("--repeat", type=int, default=5)
    given = parser.parse_args()
    plan = Plan(given)
    print(f"{SCENE.stem} to {plan.t_end}, {plan.record} recorded; {plan.workers} workers, {plan.per_task} points a task; {given.repeat} rounds")
    print(f"load of the machine before: {os.getloadavg()[0]:.1f}")
    print("| points | way | clock, ratio | processor time, ratio | processor time a point |")
    with all_ways(plan) as ways:
        for way in ways.values():
            measured(way, 100)
        for points in given.points:
            clock, processor, tables = {name: [] for name in ways}, {name: [] for name in ways}, set()
            for _ in range(given.repeat):
                for name, way in ways.items():
                    on_clock, on_processor, table = measured(way, points)
                    clock[name].append(on_clock)
                    processor[name].append(on_processor)
                    tables.add(table)
            assert len(tables) == 1, "the tables differ"
            for name in ways:
                a_point = 1e6 * statistics.median(processor[name]) / points
                both = f"{ratios(clock[name], clock['threads'])} | {ratios(processor[name], processor['threads'])}"
                print(f"| {points} | {name} | {both} | {a_point:.1f} µs |", flush=True)


if __name__ == "__main__":
    main()
