"""Sweeps: the same bytes for threads, processes, lost workers, interruptions, and the command line."""

import os
from concurrent.futures import Executor, Future, ProcessPoolExecutor

import gearsim
import numpy as np
import pytest
from conftest import AXES, SCENE

def test_threads_give_the_bytes_of_the_command_line(scene, tmp_path, bytes_of_the_command_line):
    told = []
    table = gearsim.sweep(scene, *AXES, record=["outputs"], out=tmp_path / "here", progress=told.append)
    assert len(table) == 18 and set(table["status"]) == {"done"}
    assert (tmp_path / "here" / "sweep.parquet").read_bytes() == bytes_of_the_command_line
    assert told == sorted(told)


def test_processes_give_the_same_bytes(scene, tmp_path, bytes_of_the_command_line):
    with ProcessPoolExecutor(2) as executor:
        gearsim.sweep(scene, *AXES, record=["outputs"], out=tmp_path / "here", executor=executor, points_per_task=4)
    assert (tmp_path / "here" / "sweep.parquet").read_bytes() == bytes_of_the_command_line


class Unreliable(Executor):
    """Runs tasks at once, and loses every third."""

    def __init__(self):
        self.count = 0

    def submit(self, task, *arguments):
        self.count += 1
        future = Future()
        if self.count % 3 == 0:
            future.set_exception(OSError("the worker was lost"))
        else:
            future.set_result(task(*arguments))
        return future


def test_the_points_of_a_lost_worker_run_again(scene, tmp_path, bytes_of_the_command_line):
    executor = Unreliable()
    gearsim.sweep(scene, *AXES, record=["outputs"], out=tmp_path / "here", executor=executor, points_per_task=2)
    assert executor.count > 9
    assert (tmp_path / "here" / "sweep.parquet").read_bytes() == bytes_of_the_command_line


class Broken(Unreliable):
    """Loses every task after the second."""

    def submit(self, task, *arguments):
        self.count = 2 if self.count >= 2 else self.count
        return super().submit(task, *arguments)


def test_what_was_finished_is_kept(scene, tmp_path, bytes_of_the_command_line):
    with pytest.raises(gearsim.GearsimError, match="points 6 to 8 did not run, tried 3 times: OSError: the worker was lost"):
        gearsim.sweep(scene, *AXES, record=["outputs"], out=tmp_path / "here", executor=Broken(), points_per_task=3)
    parts = [name for name in os.listdir(tmp_path / "here" / "parts") if name.startswith("rows-")]
    assert len(parts) == 2
    executor = Unreliable()
    gearsim.sweep(scene, *AXES, record=["outputs"], out=tmp_path / "here", executor=executor, points_per_task=100)
    assert executor.count == 1
    assert (tmp_path / "here" / "sweep.parquet").read_bytes() == bytes_of_the_command_line


def test_damaged_rows_are_refused(scene, tmp_path, bytes_of_the_command_line):
    job = scene.job(AXES, ["outputs"])
    gathering = job.gather(tmp_path / "here")
    whole = job.run(0, len(job))
    for place in [*range(100), *range(100, len(whole), len(whole) // 50)]:
        rows = bytearray(whole)
        rows[place] ^= 8
        with pytest.raises(gearsim.GearsimError, match="these rows are damaged"):
            job.keep(gathering, bytes(rows))
    other = scene.replace({"run.t_end": "10 ms"}).job(AXES, ["outputs"])
    with pytest.raises(gearsim.GearsimError, match="another sweep"):
        job.keep(gathering, other.run(0, 2))
    job.keep(gathering, whole)
    gathering.finish()
    assert (tmp_path / "here" / "sweep.parquet").read_bytes() == bytes_of_the_command_line


def test_one_group_is_a_list_of_one(scene):
    one, many = (gearsim.sweep(scene, AXES[1], record=record) for record in ("outputs", ["outputs"]))
    assert one.columns == many.columns and len(one.columns) > 5
    assert len(scene.job(AXES[1], record="outputs")) == 2


class OfSubmitit:
    """As submitit's executor: its jobs are no futures."""

    __module__ = "submitit.core"

    def submit(self, task, *arguments):
        pytest.fail("a task was sent")


class WithoutFutures:
    def submit(self, task, *arguments):
        return object()


@pytest.mark.parametrize(
    "executor, said",
    [
        (OfSubmitit(), r"pass gearsim.executors.SubmititExecutor\(executor\)"),
        (type("Client", (), {"__module__": "distributed.client", "submit": print})(), r"pass gearsim.executors.DaskExecutor\(client\)"),
        ("dask", "str is none\n.* gearsim.executors.DaskExecutor"),
        (ProcessPoolExecutor, "ProcessPoolExecutor is a class"),
        (WithoutFutures(), "its `submit` returns object"),
    ],
)
def test_what_is_no_executor_is_refused(scene, executor, said):
    with pytest.raises(TypeError, match=said) as error:
        gearsim.sweep(scene, AXES[1], record=["outputs"], executor=executor)
    assert "concurrent.futures.Executor" in str(error.value)


def test_mistakes_are_found_before_a_point_runs(scene):
    with pytest.raises(gearsim.SceneError, match="start.spead"):
        gearsim.sweep(scene, "start.spead=1 rpm:2 rpm:2")
    with pytest.raises(ValueError, match="nothing is varied"):
        gearsim.sweep(scene)


def written(table):
    """All values with all digits; NaN is equal to NaN."""
    return {name: [repr(value) for value in table[name]] for name in table.columns}


def test_axes_may_be_values(scene, tmp_path):
    """The columns have the same bits as the values, and the table is that of the texts."""
    speeds, torques = np.linspace(10, 90, 4), [1 / 3, 2, np.float32(0.1), "0.004 kN*m"]
    table = gearsim.sweep(scene, {"start.speed": speeds, "parameters.T0": torques}, record=["outputs"])
    assert table["start.speed"].reshape(4, 4)[:, 0].tolist() == speeds.tolist()
    assert table["parameters.T0"][:4].tolist() == [1 / 3, 2.0, float(np.float32(0.1)), 4.0]
    texts = ["start.speed=" + ",".join(f"{speed!r} rad/s" for speed in speeds.tolist()), "parameters.zeta=0.05:0.1:2"]
    mixed = gearsim.sweep(scene, {"start": {"speed": speeds}}, texts[1], record=["outputs"], out=tmp_path / "mixed")
    assert len(mixed) == 8
    gearsim.sweep(scene, *texts, record=["outputs"], out=tmp_path / "texts")
    assert (tmp_path / "mixed" / "sweep.parquet").read_bytes() == (tmp_path / "texts" / "sweep.parquet").read_bytes()


def test_axes_may_be_values_for_workers(scene):
    axes = {"run.method": ["dop853", "radau"], "parameters.zeta": np.array([0.05, 0.1])}
    here = gearsim.sweep(scene, axes, record=["outputs"])
    with ProcessPoolExecutor(1) as executor:
        there = gearsim.sweep(scene, axes, record=["outputs"], executor=executor)
    assert here["run.method"] == ["dop853", "dop853", "radau", "radau"] and set(here["status"]) == {"done"}
    assert written(here) == written(there)


def test_axes_of_jobs_and_of_other_forms(scene):
    assert scene.job("parameters.zeta=0.05,0.1").axes == scene.job({"parameters.zeta": [0.05, 0.1]}).axes
    assert scene.job([{"parameters.zeta": "0.05:0.1:3"}, {"parameters.T0": 3}]).axes == [
        "parameters.zeta=0.05:0.1:3",
        "parameters.T0=3.0 N*m",
    ]
    with pytest.raises(ValueError, match="`parameters.T0` has no values"):
        scene.job({"parameters.T0": []})
    with pytest.raises(TypeError, match="an axis is a text"):
        scene.job([3])
    with pytest.raises(gearsim.SceneError, match="parameters.T0"):
        scene.job({"parameters.T0": ["1 rpm", 2]})


def test_an_axis_wins_over_a_value_that_was_set(scene):
    built = gearsim.Scene("chain_2", parameters={"I1": 0.5, "I2": 0.25, "k1": 1e4}, start={"theta1_dot": 1}, run={"t_end": 0.01})
    table = gearsim.sweep(built, {"parameters.k1": [2e4, 3e4]})
    assert table["parameters.k1"].tolist() == [2e4, 3e4] and set(table["status"]) == {"done"}
    axis = {"parameters.zeta": [0.05, 0.1]}
    changed = gearsim.sweep(scene.replace({"parameters.zeta": 0.2}), axis, record=["outputs"])
    same = gearsim.sweep(scene, axis, record=["outputs"])
    assert written(changed) == written(same)


def test_a_response_takes_values():
    scene = gearsim.load(SCENE.parents[1] / "response.toml")
    speeds = np.linspace(523.6, 534.0, 3)
    table = scene.response({"start.speed": speeds}, start=0.05)
    assert table["start.speed"].tolist() == [*speeds, *speeds[::-1]]
    with pytest.raises(ValueError, match="one axis"):
        scene.response({"start.speed": speeds, "parameters.zeta": [0.1, 0.2]})


def test_a_response_goes_up_and_down():
    scene = gearsim.load(SCENE.parents[1] / "response.toml")
    table = scene.response("start.speed=5000 rpm:5100 rpm:3", start=0.05)
    assert len(table) == 6


def test_a_response_holds_the_speed_as_it_is_told():
    scene = gearsim.load(SCENE.parents[1] / "response.toml")
    means = {}
    for hold in (None, "nothing"):
        means[hold] = scene.response("start.speed=5000 rpm:5100 rpm:2", start=0.05, hold=hold)["mean_speed"]
    assert len(means[None]) == len(means["nothing"]) == 4
    with pytest.raises(gearsim.GearsimError, match="no_such"):
        scene.response("start.speed=5000 rpm:5100 rpm:2", start=0.05, hold="no_such")


def test_limits_are_broken_as_often_as_points_say():
    scene = gearsim.load(SCENE)
    axis = "run.t_end=uniform:4 ms:5 ms"
    broken = gearsim.limits(scene, axis, samples=200, record="events", limits=["t_end <= 4.25 ms", "t_end > 1 ms"])
    assert broken["limit"] == ["t_end <= 4.25 ms", "t_end > 1 ms"]
    assert broken["points"].tolist() == [200, 200] and broken["broken"][1] == 0
    assert broken["low_95"][0] < 0.75 < broken["high_95"][0]
    job = scene.job(axis, record="events", samples=200)
    table = gearsim.sweep(scene, axis, record="events", samples=200)
    assert job.limits(table, "t_end <= 4.25 ms")["broken"][0] == (table["t_end"] > 4.25e-3).sum() == broken["broken"][0]
    with pytest.raises(gearsim.GearsimError, match="is not a limit"):
        job.limits(table, "t_end = 3")


def test_dask_gives_the_same_bytes_though_a_worker_is_killed(scene, tmp_path, bytes_of_the_command_line):
    distributed = pytest.importorskip("distributed")
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster:
        with distributed.Client(cluster) as client:
            pids = list(client.run(os.getpid).values())
            killed = []

            def kill(_):
                if not killed:
                    killed.append(pids[0])
                    os.kill(pids[0], 9)

            gearsim.sweep(
                scene,
                *AXES,
                record=["outputs"],
                out=tmp_path / "here",
                executor=client.get_executor(),
                points_per_task=1,
                progress=kill,
            )
    assert killed
    assert (tmp_path / "here" / "sweep.parquet").read_bytes() == bytes_of_the_command_line


def test_statistics_and_sensitivity_name_the_axis_that_matters():
    scene = gearsim.load(SCENE)
    axes = ["run.t_end=normal:4 ms:0.2 ms", "parameters.zeta=uniform:0.05:0.1"]
    indices = gearsim.sensitivity(scene, *axes, samples=64, record=["events"])
    of = {
        key: (first, total)
        for quantity, key, first, total in zip(*(indices[c] for c in ("quantity", "key", "first_order", "total")))
        if quantity == "t_end"
    }
    assert of["parameters.zeta"] == (0.0, 0.0)
    assert of["run.t_end"] == pytest.approx((1.0, 1.0), abs=0.1)
    job = scene.job(axes[:1], record=["events"], samples=100, design="latin-hypercube")
    table = gearsim.sweep(scene, axes[0], record=["events"], samples=100, design="latin-hypercube")
    spread = job.statistics(table)
    row = spread["quantity"].index("t_end")
    # One point in each hundredth of the distribution.
    assert spread["mean"][row] == pytest.approx(4e-3, rel=1e-3) and spread["deviation"][row] == pytest.approx(0.2e-3, rel=0.05)
    with pytest.raises(gearsim.GearsimError, match="design"):
        job.sensitivity(table)
    other = scene.job(axes[:1], record=["events"], samples=100, seed=1, design="latin-hypercube")
    with pytest.raises(gearsim.GearsimError, match="another sweep: its values of `run.t_end` differ"):
        other.statistics(table)
    for how, said in [({"samples": 50}, "100 points, not all 50"), ({"record": ["outputs"]}, "which has the columns")]:
        definition = {"record": ["events"], "samples": 100, "design": "latin-hypercube"} | how
        with pytest.raises(gearsim.GearsimError, match=said):
            scene.job(axes[:1], **definition).statistics(table)
    with pytest.raises(gearsim.GearsimError, match="another sweep"):
        scene.job(axes[1:], record=["events"], samples=100, design="latin-hypercube").statistics(table)
    with pytest.raises(ValueError, match="latin-hypercube"):
        scene.job(axes, samples=4, design="latin")
