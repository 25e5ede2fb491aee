"""Time and memory for joining the parts of a sweep: `python gearsim/python/measure/merge.py 100000`."""

import os
import pathlib
import subprocess
import sys
import tempfile
import time

from cost import SCENE, T_END, axes

#: Shards of the sweep.
SHARDS = 4


def command_line(*words):
    """Run the command line; return its time [s] and the most memory that it had [MiB]."""
    begin = time.perf_counter()
    process = subprocess.Popen([sys.executable, "-m", "gearsim", *map(str, words), "--quiet"])
    _, status, usage = os.wait4(process.pid, 0)
    if status:
        sys.exit(f"gearsim {words[0]} failed")
    return time.perf_counter() - begin, usage.ru_maxrss / 1024


def main():
    points = int(sys.argv[1])
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        shards = [folder / str(shard) for shard in range(1, SHARDS + 1)]
        axis_words = [part for axis in axes(points) for part in ("--vary", axis)]
        what = ["sweep", SCENE, "--set", f"run.t_end={T_END}", "--record", "outputs", *axis_words]
        runs = [command_line(*what, "--shard", f"{shard.name}/{SHARDS}", "--out", shard) for shard in shards]
        merge, memory = command_line("merge", *shards, "--out", folder / "whole")
        bytes_of_table = (folder / "whole" / "sweep.parquet").stat().st_size
    print(f"{points} points, outputs recorded, {SHARDS} shards, all on this machine")
    run = sum(seconds for seconds, _ in runs)
    print(f"sweep: {run:.1f} s, {1e6 * run / points:.0f} µs a point, at most {max(most for _, most in runs):.0f} MiB")
    print(f"merge: {merge:.2f} s, {1e6 * merge / points:.1f} µs a point, at most {memory:.0f} MiB")
    print(f"sweep.parquet: {bytes_of_table / points:.1f} bytes a point")


if __name__ == "__main__":
    main()
