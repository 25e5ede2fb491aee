"""The types that editors and type checkers see: the package has types throughout, and its stub agrees with the extension module."""

import subprocess
import sys

import pytest

pytest.importorskip("mypy")

#: Uses the public names of the package. The comment on a line is its expected type or error.
USE = """
from fractions import Fraction

import gearsim
import numpy as np
scene = gearsim.load("scene.toml").replace({"run.t_end": "1 s"}, parameters={"zeta": 0.1})
reveal_type(scene)  # gearsim._gearsim.Scene
reveal_type(scene.run(progress=print).summary)  # dict[str, Any]
reveal_type(gearsim.sweep(scene, "run.t_end=1 s,2 s"))  # gearsim._gearsim.Table
reveal_type(gearsim.executors.RayExecutor(num_cpus=1).submit(len, "abc"))  # Future[int]
reveal_type(np.mean(scene.run()["t"]))  # numpy.floating
reveal_type(scene.run().table["t"][1:] * 2)  # float64
reveal_type(gearsim.sweep(scene, "run.t_end=1 s,2 s")["status"])  # list[str]
gearsim.sweep(scene, {"run.t_end": [1, 2], "start.speed": np.linspace(1, 2)}, "parameters.zeta=0.1", record="outputs")
scene.job({"run": {"t_end": [1, 2]}}).run(0, 1)
scene.response({"start.speed": np.linspace(1, 2)})
scene.replace({"run.t_end": np.int64(1), "parameters.zeta": np.float32(0.1), "parameters.T0": Fraction(1, 3)})
reveal_type(scene.to_toml())  # str
reveal_type(gearsim.compare(scene, scene, names=["a", "b"]).runs)  # dict[str, gearsim._gearsim.Results]
reveal_type(gearsim.limits(scene, "run.t_end=1 s,2 s", limits="t_end <= 1 s"))  # gearsim._gearsim.Table
scene.response({"start.speed": np.linspace(1, 2)}, hold="T0")
gearsim.sweep(scene, 3)  # incompatible type
scene.run(progress=1)  # incompatible type
gearsim.sweep(scene, "run.t_end=1 s,2 s", design="latin")  # incompatible type
"""


@pytest.fixture(scope="module")
def mypy(tmp_path_factory):
    """Runs a module of mypy in a folder of its own, which keeps its cache of NumPy."""
    folder = tmp_path_factory.mktemp("mypy")
    (folder / "use.py").write_text(USE)

    def run(*words):
        return subprocess.run([sys.executable, "-m", *words], cwd=folder, capture_output=True, text=True)

    return run


def test_the_package_has_types_throughout(mypy):
    ended = mypy("mypy", "--strict", "-p", "gearsim")
    assert ended.returncode == 0, ended.stdout + ended.stderr


def test_the_stub_is_that_of_the_extension_module(mypy):
    ended = mypy("mypy.stubtest", "gearsim._gearsim")
    assert ended.returncode == 0, ended.stdout + ended.stderr


def test_a_program_that_uses_the_package_is_checked(mypy):
    said = mypy("mypy", "--strict", "use.py").stdout.splitlines()
    expected = [(number, line.split("  # ")[1]) for number, line in enumerate(USE.splitlines(), 1) if "  # " in line]
    for number, what in expected:
        assert any(line.startswith(f"use.py:{number}: ") and what in line for line in said), f"{number}: {what} in {said}"
    messages = [line for line in said if line.startswith("use.py:") and "help" not in line]
    assert {int(line.split(":")[1]) for line in messages} == {number for number, _ in expected}, said
