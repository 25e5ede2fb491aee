"""What joining the parts of a sweep costs, in time and memory: `python gearsim/python/measure/merge.py 100000`."""

import pathlib
import resource
import subprocess
import sys
import tempfile
import time

from cost import SCENE, T_END, axes

#: Shards of the sweep.
SHARDS = 4


def command_line(*words):
    """Run the command line; return its time [s]."""
    begin = time.perf_counter()
    subprocess.run([sys.executable, "-m", "gearsim", *map(str, words), "--quiet"], check=True)
    return time.perf_counter() - begin


def main():
    points = int(sys.argv[1])
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        shards = [folder / str(shard) for shard in range(1, SHARDS + 1)]
        axis_words = [part for axis in axes(points) for part in ("--vary", axis)]
        what = ["sweep", SCENE, "--set", f"run.t_end={T_END}", "--record", "outputs", *axis_words]
        run = sum(command_line(*what, "--shard", f"{shard.name}/{SHARDS}", "--out", shard) for shard in shards)
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
        merge = command_line("merge", *shards, "--out", folder / "whole")
        after = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
        bytes_of_table = (folder / "whole" / "sweep.parquet").stat().st_size
    print(f"{points} points, outputs recorded, {SHARDS} shards, all on this machine")
    print(f"sweep: {run:.1f} s, {1e6 * run / points:.0f} µs a point, at most {before / 1024:.0f} MiB")
    print(f"merge: {merge:.2f} s, {1e6 * merge / points:.1f} µs a point, at most {after / 1024:.0f} MiB")
    print(f"sweep.parquet: {bytes_of_table / points:.1f} bytes a point")


if __name__ == "__main__":
    main()
