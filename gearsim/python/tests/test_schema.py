"""The JSON schema of scenes agrees with the reader: the reader refuses every scene that the schema refuses."""

import copy
import functools
import json
import pathlib
import subprocess
import sys

import gearsim
import pytest

tomllib = pytest.importorskip("tomllib")
jsonschema = pytest.importorskip("jsonschema")

SCENES = sorted((pathlib.Path(__file__).parents[3] / "models" / "scenes").rglob("*.toml"))
MODEL = {path: tomllib.loads(path.read_text())["model"] for path in SCENES}
# The largest scene of each model has the most keys.
LARGEST = {MODEL[path]: path for path in sorted(SCENES, key=lambda path: path.stat().st_size)}


@functools.cache
def validator(*model):
    command = [sys.executable, "-m", "gearsim", "scene", "--schema", *model]
    schema = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


def toml(value):
    """A value in TOML. Texts and numbers are written as in JSON; all tables are inline."""
    if isinstance(value, dict):
        return "{" + ", ".join(f"{json.dumps(key)} = {toml(of)}" for key, of in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(toml, value)) + "]"
    return json.dumps(value)


def reads(scene):
    """Whether the reader accepts a scene."""
    text = "\n".join(f"{json.dumps(key)} = {toml(value)}" for key, value in scene.items())
    try:
        gearsim.Scene.from_toml(text)
    except gearsim.SceneError:
        return False
    return True


def places(value, path=()):
    """The paths of all keys in a scene."""
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, of in items:
        yield (*path, key)
        yield from places(of, (*path, key))


def changed(scene, path, change):
    """A copy of the scene in which `change` was applied to the container of `path` and its last key."""
    scene = copy.deepcopy(scene)
    change(functools.reduce(lambda of, key: of[key], path[:-1], scene), path[-1])
    return scene


def test_committed_scenes_are_valid():
    assert len(SCENES) > 30
    for path in SCENES:
        errors = [error.message for error in validator().iter_errors(tomllib.loads(path.read_text()))]
        assert not errors, f"{path}: {errors}"


@pytest.mark.parametrize("model", sorted(LARGEST))
def test_what_the_schema_refuses_the_reader_refuses(model):
    scene = tomllib.loads(LARGEST[model].read_text())
    valid = validator(model).is_valid
    assert valid(scene) and reads(scene)
    of = lambda path: functools.reduce(lambda of, key: of[key], path, scene)
    for path in places(scene):
        for value in (True, "word", []):
            other = changed(scene, path, lambda table, key: table.__setitem__(key, value))
            if not valid(other):
                assert not reads(other), f"{path} = {value} is refused by the schema alone"
            elif value is True and not isinstance(of(path), bool):
                raise AssertionError(f"{path} = true is valid")
        if isinstance(of(path), dict):
            other = changed(scene, (*path, "zzz"), lambda table, key: table.__setitem__(key, {}))
            assert not valid(other) or len(path) == 1, f"{path}.zzz is valid"
            assert not reads(other) or path[0] in ("rotors", "bearings")
        if isinstance(path[-1], str):
            other = changed(scene, path, lambda table, key: table.pop(key))
            assert valid(other) or not reads(other), f"{path} is required by the schema alone"
