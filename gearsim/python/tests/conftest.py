"""A small sweep, and the bytes of its table from the command line."""

import pathlib
import subprocess
import sys

import gearsim
import pytest

SCENE = pathlib.Path(__file__).parents[3] / "models" / "scenes" / "oh2005" / "energy_300rpm.toml"
AXES = ["start.speed=100 rpm:900 rpm:9", "parameters.zeta=0.05,0.1"]
POINTS = 18


@pytest.fixture
def scene():
    return gearsim.load(SCENE).replace({"run.t_end": "20 ms"})


@pytest.fixture(scope="session")
def bytes_of_the_command_line(tmp_path_factory):
    out = tmp_path_factory.mktemp("cli")
    command = [sys.executable, "-m", "gearsim", "sweep", str(SCENE), "--quiet", "--set", "run.t_end=20 ms"]
    command += ["--record", "outputs", "--out", str(out)]
    subprocess.run(command + [part for axis in AXES for part in ("--vary", axis)], check=True)
    return (out / "sweep.parquet").read_bytes()


@pytest.fixture
def sweep(scene, tmp_path):
    """Runs the small sweep, and returns the bytes of its table."""

    def run(out=tmp_path / "here", **how):
        gearsim.sweep(scene, *AXES, record=["outputs"], out=out, **how)
        return (out / "sweep.parquet").read_bytes()

    return run


@pytest.fixture
def points_kept(scene, tmp_path):
    """Counts the points in the folder of a stopped sweep. An incomplete part is an error."""

    def count(out=tmp_path / "here"):
        job = scene.job(AXES, ["outputs"])
        gathering = job.gather(out)
        missing = job.missing(gathering, POINTS)
        gathering.close()
        return POINTS - sum(end - first for first, end in missing)

    return count
