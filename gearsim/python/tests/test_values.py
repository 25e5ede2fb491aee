"""One grammar of values: all places accept the same values and refuse the same values."""

import re
import subprocess
import sys

from decimal import Decimal
from fractions import Fraction

import gearsim
import numpy as np
import pytest
from conftest import SCENE

GOOD = {
    "start.speed": ["600rpm", "600 rpm", "6e2 rpm", "+600 rpm", "62.8 rad/s", "3600 deg/s", " 600 rpm "],
    "parameters.zeta": ["0.05", ".05", "5e-2", "5 %", "5%"],
    "parameters.T0": ["10 N*m", "10N*m", "10 Nm", "10 N m", "10 N·m", "10 kg*m^2/s^2"],
}
BAD = {
    "start.speed": ["600", "600 RPM", "10 Hz", "1_000 rpm", "nan rpm", "1e999 rpm", "0x10 rpm", "600 rpmm", "10 N*m"],
    "parameters.zeta": ["5 rpm", "half", ""],
    "parameters.T0": ["10", "10 N", "ten N*m"],
}
#: A second value for charts, larger than any above.
LARGER = {"start.speed": "900 rpm", "parameters.zeta": "0.5", "parameters.T0": "20 N*m"}
CASES = [(key, value, good) for good, of in ((True, GOOD), (False, BAD)) for key, values in of.items() for value in values]


def command(*words):
    return subprocess.run([sys.executable, "-m", "gearsim", *map(str, words)], capture_output=True).returncode == 0


def accepts(call, *arguments):
    try:
        call(*arguments)
    except gearsim.SceneError:
        return False
    return True


@pytest.mark.parametrize("key, value, good", CASES)
def test_a_value_is_accepted_everywhere_or_nowhere(key, value, good, tmp_path):
    name = key.rpartition(".")[2]
    text, count = re.subn(rf"(?m)^{name} *=.*$", lambda _: f'{name} = "{value}"', SCENE.read_text())
    assert count == 1
    scene = gearsim.load(SCENE)
    places = {
        "the scene": accepts(gearsim.Scene.from_toml, text),
        "--set": command("check", SCENE, "--quiet", "--set", f"{key}={value}"),
        "Scene.replace": accepts(scene.replace, {key: value}),
        "sweep --vary": accepts(scene.job, [f"{key}={value},{LARGER[key]}"]),
        "floquet --vary": command("floquet", SCENE, "--quiet", "--vary", f"{key}={value},{LARGER[key]}", "--out", tmp_path / "chart"),
    }
    assert set(places.values()) == {good}, places


class Indexed:
    """An integer of another package."""

    def __index__(self):
        return 3


OF_NUMPY = [np.int64(3), np.uint8(3), np.float32(3), np.float64(3), np.longdouble(3), np.array(3), np.array(3.0)]


@pytest.mark.parametrize("three", [3, 3.0, *OF_NUMPY, Decimal(3), Fraction(3), Indexed()])
def test_numbers_of_any_type_are_in_si_units(three):
    scene = gearsim.load(SCENE)
    assert scene.replace({"parameters.T0": three}).parameters["T0"] == 3
    assert scene.replace(parameters={"T0": three}).parameters["T0"] == 3
    built = gearsim.Scene("chain_2", parameters={"I1": three, "I2": three, "k1": three}, run={"t_end": three})
    assert [built.parameters[name] for name in ("I1", "I2", "k1")] == [3, 3, 3] and built.t_end == 3


def test_bools_and_texts_of_numpy_are_no_numbers():
    scene = gearsim.load(SCENE)
    for flag in (np.True_, np.array(True)):
        scene.replace({"output.csv": flag})
        with pytest.raises(gearsim.SceneError, match="parameters.T0=true"):
            scene.replace({"parameters.T0": flag})
    assert scene.replace({"parameters.T0": np.str_("3 N*m")}).parameters["T0"] == 3
    for bad in (b"3 N*m", 3j, np.complex128(3)):
        with pytest.raises(TypeError, match="numbers, texts, bools, lists and dicts"):
            scene.replace({"parameters.T0": bad})


def test_no_digit_of_a_number_is_lost():
    third = Fraction(1, 3)
    scene = gearsim.load(SCENE).replace({"parameters.T0": third, "parameters.zeta": np.float32(0.1)})
    assert scene.parameters["T0"] == 1 / 3 and scene.parameters["zeta"] == float(np.float32(0.1))


def train(number, **more):
    """A train whose tables have the number, without a unit."""
    return gearsim.Scene(
        "train",
        effects=["stiffness_step", "torques", "damping"],
        rotors={"a": number, "b": {"inertia": number}, "c": number},
        shafts={"bc": {"between": ["b", "c"], "stiffness": number}},
        meshes={
            "m": {
                "between": ("a", "b"),
                "teeth": np.array([20, 40]),
                "base_radius": np.float64(0.03),
                "stiffness": {"steps": [{"value": number, "width": number}, {"value": number}]},
            }
        },
        drives={"d": {"rotor": "a", "torque": number}},
        parameters={"beta_K": number},
        start={"speed": number},
        run={"t_end": number},
        **more,
    )


@pytest.mark.parametrize("three", [3, 3.0, *OF_NUMPY, Decimal(3), Indexed()])
def test_numbers_in_the_tables_of_a_train_are_in_si_units(three):
    scene = train(three)
    names = ["I_a", "I_b", "I_c", "k_bc", "T_d", "beta_K"]
    assert {name: scene.parameters[name] for name in names} == dict.fromkeys(names, 3.0)
    assert scene.t_end == 3
    assert scene.replace(rotors={"a": 2 * scene.t_end}).parameters["I_a"] == 6
    assert scene.replace({"shafts.bc.stiffness": "3 kN*m/rad"}).parameters["k_bc"] == 3000


@pytest.mark.parametrize(
    "more, error, said",
    [
        ({"loads": {"l": {"rotor": "c", "torque": None}}}, TypeError, "`loads.l.torque` cannot be set: .*not NoneType"),
        ({"loads": {1: {"rotor": "c"}}}, TypeError, 'the keys of `loads` are texts, not 1: write "1"'),
        ({"loads": {"a=b": {"rotor": "c"}}}, ValueError, 'the keys of `loads` are names, or names joined by dots, not "a=b": a name has letters, digits and `_`'),
        ({"loads": {"a..b": {"rotor": "c"}}}, ValueError, 'the keys of `loads` are .* not "a..b"'),
        ({"loads": {"": {"rotor": "c"}}}, ValueError, 'the keys of `loads` are .* not ""'),
        ({"loads": {"a.b": {"rotor": "c"}}}, gearsim.SceneError, "a name has no dots: `a.b` is the key `b` of `a`"),
        ({"loads": {"a.rotr": "c"}}, gearsim.SceneError, "did you mean `rotor`?"),
        ({"loads": {"l": {}}}, gearsim.SceneError, r"\[loads.l\] lacks `rotor`"),
        ({"loads": {"l": {"rotor": "c", "torque": float("nan")}}}, gearsim.SceneError, "`loads.l.torque` is not a finite number"),
    ],
)
def test_wrong_values_are_refused_with_their_key(more, error, said):
    with pytest.raises(error, match=said):
        train(3.0, **more)


@pytest.mark.parametrize("axis, error, said", [
    ({"parameters.ze=ta": [1, 2]}, ValueError, 'the keys of a scene are names, or names joined by dots, not "parameters.ze=ta"'),
    ({"parameters": {1: [1, 2]}}, TypeError, 'the keys of `parameters` are texts, not 1: write "1"'),
])
def test_wrong_keys_of_axes_are_refused(axis, error, said):
    with pytest.raises(error, match=said):
        gearsim.load(SCENE).job(axis)


@pytest.mark.parametrize("effects", [3, [3], "damping"])
def test_effects_are_a_list_of_texts(effects):
    with pytest.raises(TypeError, match="`effects` is a list of texts: effects="):
        gearsim.load(SCENE) and gearsim.Scene("chain_2", effects)


def test_a_number_where_none_is_allowed_is_refused_with_its_key():
    with pytest.raises(gearsim.SceneError, match="meshes.m.between"):
        train(3.0).replace({"meshes.m.between": 3.0})
    with pytest.raises(gearsim.SceneError, match="rotors.a"):
        train(3.0).replace({"rotors.a": "3"})
