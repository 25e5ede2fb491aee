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


def row(rotors, fan=False):
    """Rotors on shafts, whose dampers couple all modes, and a fan on one of them."""
    names = [f"r{i}" for i in range(rotors)]
    shafts = {
        f"s{i}": {"between": list(pair), "stiffness": "10 kN*m/rad", "damping": f"{1 + i % 5} N*m*s/rad"}
        for i, pair in enumerate(zip(names, names[1:]))
    }
    inertias = {name: f"{0.01 + 0.001 * (i % 7)} kg*m^2" for i, name in enumerate(names)}
    if not fan:
        return gearsim.Scene("train", ["viscous_friction"], rotors=inertias, shafts=shafts)
    loads = {"f": {"rotor": "r3", "fan": {"coefficient": 0.1}}}
    effects = ["viscous_friction", "fan"]
    return gearsim.Scene("train", effects, rotors=inertias, shafts=shafts, loads=loads, start={"speed": 10.0})


@pytest.mark.parametrize("fan", [False, True], ids=["dampers", "fan"])
def test_ctrl_c_ends_modes(fan):
    """The fan makes the matrices unsymmetric: their eigenvalues take seconds, in one step."""
    scene = row(150, fan)
    begin = time.monotonic()
    threading.Timer(0.5, signal.raise_signal, [signal.SIGINT]).start()
    with pytest.raises(KeyboardInterrupt):
        scene.modes()
    assert time.monotonic() - begin < 1.5


PROGRAM = "import gearsim, sys; sys.argv = ['gearsim', 'modes', sys.argv[1]]; print('ready', flush=True); gearsim._command_line()"


def test_ctrl_c_ends_the_program(tmp_path):
    """Also where the program was started with SIGINT ignored, as in the background of a shell."""
    path = tmp_path / "row.toml"
    path.write_text(row(150, True).to_toml())
    for handler in (signal.SIG_DFL, signal.SIG_IGN):
        command = [sys.executable, "-c", PROGRAM, str(path)]
        process = subprocess.Popen(command, stdout=subprocess.PIPE, preexec_fn=lambda: signal.signal(signal.SIGINT, handler))
        assert process.stdout.readline() == b"ready\n"
        time.sleep(0.7)
        begin = time.monotonic()
        process.send_signal(signal.SIGINT)
        assert process.wait(10) == -signal.SIGINT and time.monotonic() - begin < 1


def test_shapes_have_the_coordinates_of_the_scene():
    scene = struck()
    assert scene.coordinates == ["theta1", "theta2"]
    shape = dict(zip(scene.coordinates, scene.modes()[1]["shape"]))
    # The momenta are opposite: I1 a1 + I2 a2 = 0.
    assert 0.5 * shape["theta1"] == pytest.approx(-0.25 * shape["theta2"])


@pytest.mark.parametrize(
    "scene",
    [
        lambda: struck().replace({"parameters.I1": 1 / 3}, start={"theta2": "1 mrad"}),
        lambda: gearsim.load(SCENES / "two_stage.toml").replace({"run.t_end": "2 ms", "effects": ["stiffness_step", "torques"]}),
        lambda: gearsim.load(SCENES / "train_turbine.toml").replace({"run.t_end": "1 ms", "shafts.low.stiffness": "3 MN*m/rad"}),
    ],
    ids=["built", "loaded", "train"],
)
def test_the_text_of_a_scene_is_the_scene(scene, tmp_path):
    scene = scene()
    path = tmp_path / f"{scene.name}.toml"
    path.write_text(scene.to_toml())
    again = gearsim.load(path)
    first, second = scene.run(), again.run()
    assert first.keys() == second.keys()
    for name in first:
        same = first[name] == second[name] if isinstance(first[name], list) else first[name].tobytes() == second[name].tobytes()
        assert same, name
    assert again.to_toml() == scene.to_toml()


def test_scenes_and_equations_are_compared():
    scene = gearsim.load(SCENES / "oh2005" / "energy_300rpm.toml").replace({"run.t_end": "20 ms"})
    told = []
    compared = gearsim.compare(scene, progress=told.append)
    assert list(compared.runs) == ["exact", "rigid kinematic", "classical"] and "classical" in repr(compared)
    assert "frozen_phase" in compared.runs["classical"].scene.effects
    # The exact equations have the energy account of the scene; the others leave energy out.
    exact, rigid, _ = (run.summary["energy"] for run in compared.runs.values())
    assert exact == scene.run().summary["energy"] and rigid != exact
    assert "rigid kinematic" in compared.plot("energy").svg()
    two = gearsim.compare(scene, scene.replace({"parameters.zeta": 0.2}))
    assert list(two.runs) == ["energy_300rpm 1", "energy_300rpm 2"]
    named = gearsim.compare(scene, scene.replace({"parameters.zeta": 0.2}), names=["a", "b"])
    assert list(named.runs) == ["a", "b"] and named.runs["a"]["t"][-1] == 0.02
    with pytest.raises(ValueError, match="as many different names"):
        gearsim.compare(scene, scene, names=["a", "a"])
    with pytest.raises(ValueError, match="give one scene, or several"):
        gearsim.compare()
    with pytest.raises(gearsim.GearsimError, match="are no classical|has no effect that"):
        gearsim.compare(struck())


def test_rows_are_not_read_by_numbers():
    results = struck().run()
    for columns in (results, results.table):
        with pytest.raises(TypeError, match=r'names, which are texts, not int: table\["t"\] is a column'):
            columns[0]


def test_messages_have_the_words_of_python(tmp_path):
    scene = struck()
    random = "parameters.k1=uniform:1 N*m/rad:2 N*m/rad"
    calls = [
        lambda: scene.job(random),
        lambda: scene.job("parameters.k1=1 N*m/rad", samples=3),
        lambda: scene.job("parameters.k1=1 N*m/rad", design="sobol"),
        lambda: scene.job("parameters.k1=1 N*m/rad", start=1.0),
        lambda: scene.job("parameters.k1=1 N*m/rad:2 m:3"),
        lambda: scene.job("parameters.k1=1:2"),
        lambda: scene.job(["parameters.k1=1 N*m/rad", "parameters.k1=1 N*m/rad"]),
        lambda: scene.job([]),
        lambda: scene.replace({"": 1}),
        lambda: scene.replace({"parameters.k1": ""}),
        lambda: scene.replace({"parameters.k1": "1 m"}),
        lambda: scene.response({"parameters.k1": [1, 2]}, hold="k9"),
        lambda: scene.run().write(__file__),
        lambda: gearsim.limits(scene, random, samples=2, limits="t_end = 3"),
    ]
    for number, call in enumerate(calls):
        with pytest.raises((gearsim.GearsimError, ValueError)) as raised:
            call()
        assert "--" not in str(raised.value) and "command line" not in str(raised.value), f"{number}: {raised.value}"


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
    whole = gearsim.load(SCENES / "two_stage.toml").run()
    assert len(whole._repr_html_()) < 100_000 < len(whole.plot().svg())
    assert len(whole.plot()._repr_svg_()) < 100_000
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
