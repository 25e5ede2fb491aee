"""What executors cost, beside the threads of the command line: `python gearsim/python/measure/cost.py 10000 100000`.

Every number of points is swept by every executor, all with the same number of workers, one after the other; the shortest of the
repetitions counts. Clusters are started and used once before. The tables must have the same bytes. A line cost = a + b N is put through
the differences to the command line: a is the cost of a sweep, b that of a point with its share of a task.
"""

import argparse
import contextlib
import os
import pathlib
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ProcessPoolExecutor

import gearsim
import numpy as np

SCENE = pathlib.Path(__file__).parents[3] / "models" / "scenes" / "oh2005" / "energy_300rpm.toml"
T_END = "1 ms"


def axes(points):
    return [f"start.speed=100 rpm:900 rpm:{points // 10}", "parameters.zeta=0.01:0.1:10"]


def command_line(points, workers, _, out):
    command = [sys.executable, "-m", "gearsim", "sweep", SCENE, "--quiet", "--set", f"run.t_end={T_END}", "--record", "events"]
    command += ["--threads", workers, "--out", out, *(part for axis in axes(points) for part in ("--vary", axis))]
    subprocess.run([str(word) for word in command], check=True)


def by(executor):
    def sweep(points, workers, per_task, out):
        scene = gearsim.load(SCENE).replace({"run.t_end": T_END})
        gearsim.sweep(scene, *axes(points), record=["events"], out=out, executor=executor, points_per_task=per_task)

    return sweep


@contextlib.contextmanager
def all_ways(workers):
    """The command line, and one executor of each kind."""
    import distributed
    import ray

    ray.init(num_cpus=workers, include_dashboard=False, log_to_driver=False, logging_level="error")
    cluster = distributed.LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address=None)
    with cluster, distributed.Client(cluster) as client, ProcessPoolExecutor(workers) as processes:
        dask, by_ray = gearsim.executors.DaskExecutor(client), gearsim.executors.RayExecutor()
        yield {"threads": command_line, "processes": by(processes), "Dask": by(dask), "Ray": by(by_ray)}
    ray.shutdown()


def seconds(way, points, workers, per_task):
    """Time of a sweep [s], and its table."""
    with tempfile.TemporaryDirectory() as out:
        begin = time.perf_counter()
        way(points, workers, per_task, out)
        return time.perf_counter() - begin, (pathlib.Path(out) / "sweep.parquet").read_bytes()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("points", nargs="+", type=int, help="numbers of points, multiples of 10")
    parser.add_argument("--workers", type=int, default=os.cpu_count())
    parser.add_argument("--per-task", type=int, default=10_000)
    parser.add_argument("--repeat", type=int, default=3)
    given = parser.parse_args()
    print(f"{given.workers} workers, {given.per_task} points a task, shortest of {given.repeat}; load {os.getloadavg()[0]:.1f}")
    print("| points | bytes a point |", *(f"{name} [s] |" for name in ("threads", "processes", "Dask", "Ray")), flush=True)
    shortest = {}
    with all_ways(given.workers) as ways:
        for way in ways.values():
            seconds(way, 100, given.workers, 10)
        for points in given.points:
            times, tables = {name: [] for name in ways}, set()
            for _ in range(given.repeat):
                for name, way in ways.items():
                    time_taken, table = seconds(way, points, given.workers, given.per_task)
                    times[name].append(time_taken)
                    tables.add(table)
            assert len(tables) == 1, "the tables differ"
            best = shortest[points] = {name: min(all_times) for name, all_times in times.items()}
            ratios = (f"{time_taken:.2f}, {time_taken / best['threads']:.2f} x |" for time_taken in best.values())
            print(f"| {points} | {len(tables.pop()) / points:.1f} |", *ratios, flush=True)
    if len(shortest) > 1:
        for name in ("processes", "Dask", "Ray"):
            b, a = np.polyfit(list(shortest), [best[name] - best["threads"] for best in shortest.values()], 1)
            print(f"{name}: {a:.3f} s a sweep + {1e6 * b:.2f} µs a point more than threads")


if __name__ == "__main__":
    main()
