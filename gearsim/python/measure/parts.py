"""Processor time of a point, of a part and of joining parts: `python gearsim/python/measure/parts.py`.

There is no executor: one thread of this process makes the calls that `gearsim.sweep` makes in workers and in its own process. Other
programs change the processor time little. A line a + b N is fitted to the times of parts of N points: a is the cost of a part, b that of a
point. The shortest of the repetitions counts.
"""

import argparse
import pathlib
import resource
import subprocess
import sys
import tempfile
import time

import gearsim
import numpy as np
from cost import SCENE, T_END, axes

#: Points in a part, for the lines.
PARTS = (10, 500, 2000)


def shortest(call, repeat):
    """Shortest processor time of a call [s], and its last value."""
    times = []
    for _ in range(repeat):
        begin = time.process_time()
        value = call()
        times.append(time.process_time() - begin)
    return min(times), value


def per_part_and_point(times):
    """The line a + b N fitted to times by N, as text."""
    b, a = np.polyfit(list(times), list(times.values()), 1)
    return f"{1e3 * max(a, 0):.2f} ms a part, {1e6 * b:.2f} µs a point"


def join(points, per_part, record):
    """Processor time [s] of joining the parts of a sweep, most memory [MiB], and bytes a point, of a process of its own."""
    command = [sys.executable, __file__, "--join", str(points), "--per-part", str(per_part)]
    command += ["--outputs"] if record == ["outputs"] else []
    return map(float, subprocess.run(command, check=True, capture_output=True, text=True).stdout.split())


def scene_and_job(points, record, t_end=T_END):
    return gearsim.load(SCENE).replace({"run.t_end": t_end}).job(axes(points), record)


def whole(points, record):
    """Processor time of `gearsim sweep` on one thread, start included [s]."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    with tempfile.TemporaryDirectory() as out:
        command = [sys.executable, "-m", "gearsim", "sweep", SCENE, "--quiet", "--threads", "1", "--set", f"run.t_end={T_END}"]
        command += ["--record", *record, "--out", out, *(part for axis in axes(points) for part in ("--vary", axis))]
        subprocess.run(command, check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def joined(points, per_part, record):
    """Keeps the rows of all points, then joins them; prints time and memory."""
    job = scene_and_job(points, record, "0.1 ms")
    with tempfile.TemporaryDirectory() as out:
        gathering = job.gather(out)
        for first, end in job.missing(gathering, per_part):
            job.keep(gathering, job.run(first, end))
        before, begin = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss, time.process_time()
        table = gathering.finish()
        seconds = time.process_time() - begin
        most = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        bytes_of_table = (pathlib.Path(out) / "sweep.parquet").stat().st_size
    assert len(table) == points
    print(seconds, most / 1024, bytes_of_table / points, before / 1024)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--repeat", type=int, default=10)
    parser.add_argument("--points", type=int, nargs="+", default=[10_000, 100_000, 1_000_000], help="of the sweeps that are joined")
    parser.add_argument("--per-part", type=int, default=10_000)
    parser.add_argument("--outputs", action="store_true", help="record the outputs too, not the events alone")
    parser.add_argument("--join", type=int, help=argparse.SUPPRESS)
    given = parser.parse_args()
    record = ["outputs"] if given.outputs else ["events"]
    if given.join:
        return joined(given.join, given.per_part, record)
    job = scene_and_job(10 * max(PARTS), record)
    run, keep, size = {}, {}, {}
    for points in PARTS:
        repeat = given.repeat * (10 if points < 1000 else 1)
        run[points], rows = shortest(lambda: job.run(0, points, threads=1), repeat)
        size[points] = len(rows)
        with tempfile.TemporaryDirectory() as out:
            gathering = job.gather(out)
            keep[points], _ = shortest(lambda: job.keep(gathering, rows), repeat)
            gathering.close()
    print(f"{SCENE.stem} to {T_END}, {record[0]} recorded; parts of {', '.join(map(str, PARTS))} points; shortest of {given.repeat}")
    print(f"run and pack:      {per_part_and_point(run)}")
    print(f"check and keep:    {per_part_and_point(keep)}")
    print(f"bytes of a part:   {size[max(PARTS)] / max(PARTS):.1f} a point")
    few, many = 2000, 10_000
    times = {points: min(whole(points, record) for _ in range(given.repeat)) for points in (few, many)}
    print(f"`gearsim sweep`, one thread, parts and joining included: {1e6 * (times[many] - times[few]) / (many - few):.2f} µs a point")
    for points in given.points:
        # A large sweep is joined once.
        repeat = max(1, min(given.repeat, 200_000 // points))
        seconds, most, of_table, before = min(tuple(join(points, given.per_part, record)) for _ in range(repeat))
        print(
            f"join {points} points: {1e6 * seconds / points:.2f} µs a point, at most {most:.0f} MiB ({before:.0f} before), "
            f"{of_table:.1f} bytes a point"
        )


if __name__ == "__main__":
    main()
