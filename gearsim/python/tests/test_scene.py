"""Scenes and runs: closed forms, errors, and the same numbers as the command line."""

import json
import math
import pathlib
import pickle
import signal
import subprocess
import sys
import threading
import time

import gearsim
import numpy as np
import pytest

SCENES = pathlib.Path(__file__).parents[3] / "models" / "scenes"


def struck(**run):
    return gearsim.Scene(
        "chain_2",
        name="struck",
        parameters={"I1": 0.5, "I2": np.float64(0.25), "k1": "10 kN*m/rad"},
        start={"theta1_dot": 2, "theta2": 0},
        run={"t_end": "0.1 s"} | run,
    )


def test_two_discs_swing_as_their_closed_form():
    results = struck().run()
    omega = math.sqrt(1e4 * (1 / 0.5 + 1 / 0.25))
    expected = 2 / omega * np.sin(omega * results["t"])
    assert np.abs(results["shaft_twist_1"] - expected).max() < 1e-12
    rigid, elastic = struck().modes()
    assert rigid["natural_frequency"] == 0 and rigid["strain_energy"] == {}
    assert abs(elastic["natural_frequency"] * 2 * math.pi / omega - 1) < 1e-12
    # The discs have opposite momenta, so that the lighter one has the larger share.
    assert elastic["strain_energy"] == pytest.approx({"k1": 1})
    assert elastic["kinetic_energy"] == pytest.approx({"I1": 1 / 3, "I2": 2 / 3})


def test_columns_have_names_and_units():
    results = struck().run()
    assert results.table.units["theta1_dot"] == "rad/s"
    assert set(results["moment"]) == {"sample"}
    with pytest.raises(KeyError, match="there is no column `twist`"):
        results["twist"]


def test_tables_and_results_are_mappings_of_columns():
    results = struck().run()
    assert list(results) == list(results.table) == results.keys() == results.table.columns
    for columns in (dict(results), dict(results.table)):
        assert list(columns) == results.table.columns and columns["t"][-1] == results["t"][-1] == 0.1
    assert "t" in results and "twist" not in results


def test_rms_is_about_the_mean_as_its_descriptions_say():
    """The discs vibrate about their common speed 2 I1/(I1 + I2); a vibration of amplitude a has the root mean square a/sqrt(2)."""
    table = gearsim.sweep(struck(), {"start.theta1_dot": [2.0]}, record="extremes")
    assert table["theta1_dot_mean"][0] == pytest.approx(2 * 0.5 / 0.75, rel=0.02)
    assert table["theta1_dot_rms"][0] == pytest.approx(2 * 0.25 / 0.75 / math.sqrt(2), rel=0.05)
    for described in (gearsim.sweep, gearsim.Scene.response, gearsim.Results.summary):
        assert "root mean square about the mean" in " ".join(described.__doc__.split())


def test_one_text_is_no_list_of_effects():
    with pytest.raises(TypeError, match=r'`effects` is a list of texts: effects=\["damping"\]'):
        gearsim.Scene("chain_2", effects="damping")
    with pytest.raises(gearsim.SceneError, match="damp"):
        gearsim.Scene("chain_2", effects=("damp",), parameters={"I1": 1})


def test_columns_have_one_place_in_memory():
    """NumPy, pyarrow, polars and pandas read the same bytes, without a copy."""
    table = struck().run().table
    pyarrow, polars, pandas = (pytest.importorskip(name) for name in ("pyarrow", "polars", "pandas"))
    address = lambda array: array.__array_interface__["data"][0]
    arrow = pyarrow.table(table)
    assert arrow.schema.field("t").metadata == {b"unit": b"s"}
    arrays = {
        "pyarrow": arrow.column("t").chunk(0).to_numpy(zero_copy_only=True),
        "polars": polars.DataFrame(table)["t"].to_numpy(allow_copy=False),
        "pandas, of Arrow's types": arrow.to_pandas(types_mapper=pandas.ArrowDtype)["t"].array.__arrow_array__(),
        "pandas, of a column": pandas.Series(table["t"], copy=False).to_numpy(),
    }
    arrays = {name: getattr(array, "chunks", [array])[0] for name, array in arrays.items()}
    for name, array in arrays.items():
        array = array.to_numpy() if isinstance(array, pyarrow.Array) else array
        assert address(array) == address(table["t"]), name
        assert array.tolist() == table["t"].tolist()


def test_mistakes_show_their_line():
    with pytest.raises(gearsim.SceneError) as error:
        struck(t_end="0.1 sec")
    assert "run.t_end=0.1 sec" in str(error.value) and "unit" in str(error.value)
    with pytest.raises(gearsim.SceneError, match="`I2`"):
        gearsim.Scene("chain_2", parameters={"I1": 1.0})
    with pytest.raises(TypeError, match="not object"):
        struck(t_end=object())


def test_the_files_are_those_of_the_command_line(tmp_path):
    scene = gearsim.load(SCENES / "two_stage.toml").replace({"run.t_end": "5 ms", "output.csv": True})
    scene.run().write(tmp_path / "here")
    command = [sys.executable, "-m", "gearsim", "run", str(SCENES / "two_stage.toml")]
    command += ["--set", "run.t_end=5 ms", "--set", "output.csv=true", "--out", str(tmp_path / "there"), "--quiet"]
    subprocess.run(command, check=True)
    there = sorted(path.name for path in (tmp_path / "there").iterdir())
    assert "trajectory.parquet" in there and "trajectory.csv" in there
    for name in there:
        here, other = (tmp_path / "here" / name).read_bytes(), (tmp_path / "there" / name).read_bytes()
        if name == "summary.json":  # the processor time differs
            here, other = ({**json.loads(text), "cpu_seconds": 0} for text in (here, other))
        assert here == other, name


def test_a_scene_travels_by_pickle():
    scene = gearsim.load(SCENES / "two_stage.toml").replace(run={"t_end": "2 ms"})
    other = pickle.loads(pickle.dumps(scene))
    assert other.run().summary["provenance"] == scene.run().summary["provenance"]


def long(t_end):
    values = {"run.t_end": t_end, "output.rate": "10 Hz", "output.events": False}
    return gearsim.load(SCENES / "two_stage.toml").replace(values)


@pytest.mark.parametrize(
    "call",
    [
        lambda scene: scene.run(),
        lambda scene: scene.advise(),
        lambda scene: scene.response("start.speed=1000 rpm:2000 rpm:3"),
    ],
    ids=["run", "advise", "response"],
)
def test_ctrl_c_ends_a_call(call):
    scene = long("10000 s")
    threading.Timer(0.5, signal.raise_signal, [signal.SIGINT]).start()
    begin = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        call(scene)
    assert time.monotonic() - begin < 10


def test_ctrl_c_ends_floquet():
    """The motion of a crank that repeats is searched for by runs: half a minute."""
    scene = gearsim.load(SCENES / "crank_drive.toml")
    begin = time.monotonic()
    threading.Timer(0.5, signal.raise_signal, [signal.SIGINT]).start()
    with pytest.raises(KeyboardInterrupt):
        scene.floquet()
    assert time.monotonic() - begin < 1.5


@pytest.mark.parametrize(
    "call",
    [
        lambda: long("100 s").run(),
        lambda: gearsim.load(SCENES / "sliding_friction.toml").floquet(),
    ],
    ids=["run", "floquet"],
)
def test_other_threads_run_meanwhile(call):
    thread = threading.Thread(target=call)
    thread.start()
    turns = 0
    while thread.is_alive():
        turns += 1
        time.sleep(0.001)
    assert turns > 10


def test_progress_is_told():
    told = []
    scene = long("100 s")
    scene.run(progress=told.append)
    assert told and told == sorted(told) and told[-1] <= 100


def test_a_notebook_shows_results():
    results = gearsim.load(SCENES / "two_stage.toml").replace(run={"t_end": "5 ms"}).run()
    shown = results._repr_html_()
    assert "mesh_force_12" in shown and "<svg" in shown
    assert "<th>theta1 [rad]</th>" in results.table._repr_html_() or "[rad]" in results.table._repr_html_()
    assert "T_motor" in results.scene._repr_html_()
    assert results.plot("energy").png().startswith(b"\x89PNG")


def test_advice_says_which_effects_matter():
    scene = gearsim.load(SCENES / "oh2005" / "energy_300rpm.toml").replace({"run.t_end": "5 ms"})
    advice = scene.advise()
    damping = next(one for one in advice["candidates"] if one["without"] == "damping")
    assert advice["format"] == "gearsim.advise" and damping["truth"]["rms"] > 0


def test_columns_are_not_copied_and_not_written_to():
    table = gearsim.load(SCENES / "oh2005" / "energy_300rpm.toml").replace({"run.t_end": "5 ms"}).run().table
    first, second = table["t"], table["t"]
    assert first.__array_interface__["data"] == second.__array_interface__["data"]
    with pytest.raises(ValueError):
        first[0] = 1.0
    end = first[-1]
    del table, second
    assert first[-1] == end == pytest.approx(5e-3)
