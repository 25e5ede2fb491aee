"""A full disk: each part is complete or absent, the error names the file and the cause, and the sweep continues when there is space."""

import os
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

import gearsim
import pytest
from conftest import AXES, SCENE

resource = pytest.importorskip("resource")


@pytest.fixture
def limit():
    """Sets the size that a file of this process may have [byte]; None for no limit."""
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    yield lambda size: resource.setrlimit(resource.RLIMIT_FSIZE, (soft if size is None else size, hard))
    resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))


def test_a_part_that_cannot_be_written_is_not_there(limit, sweep, points_kept, tmp_path, bytes_of_the_command_line):
    with pytest.raises(gearsim.GearsimError, match=r"rows-\d{8}\.parquet: it would be larger than a file may be here"):
        sweep(executor=ThreadPoolExecutor(1), points_per_task=2, progress=lambda done: limit(2000) if done == 4 else None)
    limit(None)
    names = os.listdir(tmp_path / "here" / "parts")
    assert len([name for name in names if name.startswith("rows-")]) == 2
    assert not [name for name in names if name.startswith(".gearsim-")]
    assert points_kept() == 4
    assert sweep() == bytes_of_the_command_line


def test_parts_stay_if_the_table_cannot_be_written(limit, sweep, points_kept, tmp_path, bytes_of_the_command_line):
    too_small = len(bytes_of_the_command_line) - 1
    with pytest.raises(gearsim.GearsimError, match=r"sweep\.parquet: it would be larger than a file may be here"):
        sweep(executor=ThreadPoolExecutor(1), points_per_task=2, progress=lambda done: limit(too_small) if done == 18 else None)
    limit(None)
    assert not (tmp_path / "here" / "sweep.parquet").exists() and points_kept() == 18
    assert sweep() == bytes_of_the_command_line


#: Arguments: folder of a small file system, scene, file for the bytes of the table, axes.
FILLS_A_DISK = """
import pathlib, shutil, subprocess, sys
import gearsim
disk, scene, copy, *axes = sys.argv[1:]
out = pathlib.Path(disk) / "out"
scene = gearsim.load(scene).replace({"run.t_end": "20 ms"})
how = dict(record=["outputs"], out=out)
try:
    job = scene.job(axes, ["outputs"])
    gathering = job.gather(out)
    for first, end in job.missing(gathering, 1):
        job.keep(gathering, job.run(first, end))
    sys.exit("the disk was not full")
except gearsim.GearsimError as error:
    print(error)
finally:
    gathering.close()
print(sorted(path.name for path in (out / "parts").iterdir()))
subprocess.run(["mount", "-o", "remount,size=16m", disk], check=True)
gearsim.sweep(scene, *axes, **how)
shutil.copy(out / "sweep.parquet", copy)
"""
MOUNT = 'mount -t tmpfs -o size=100k gearsim "$1" && shift && exec "$@"'


def test_a_sweep_fills_a_small_file_system_and_goes_on(tmp_path, bytes_of_the_command_line):
    own = ["unshare", "--map-root-user", "--mount"]
    if not shutil.which("unshare") or subprocess.run([*own, "sh", "-c", MOUNT, "sh", tmp_path, "true"]).returncode:
        pytest.skip("this machine does not let tests mount a file system")

    disk, copy = tmp_path / "disk", tmp_path / "copy"
    disk.mkdir()
    command = [*own, "sh", "-c", MOUNT, "sh", disk, sys.executable, "-c", FILLS_A_DISK, disk, SCENE, copy, *AXES]
    said = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    error, kept = said.splitlines()
    assert "parts/rows-" in error and "no space left" in error
    assert kept.count("rows-") >= 3 and ".gearsim-" not in kept
    assert copy.read_bytes() == bytes_of_the_command_line
