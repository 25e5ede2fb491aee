"""Arguments of wrong types: each function says which argument is wrong, what is allowed, and gives an example."""

import inspect
import re
import types

import gearsim
import numpy as np
import pytest
from conftest import SCENE

AXIS = "parameters.zeta=0.1"
RANDOM = "parameters.zeta=uniform:0.1:0.2"


class Nothing:
    """No argument can be one."""


@pytest.fixture(scope="module")
def objects(tmp_path_factory):
    """An object of each class, and values that fit, by the names of arguments: all arguments of a call but one fit."""
    scene = gearsim.load(SCENE).replace({"run.t_end": "2 ms"})
    results, job = scene.run(), scene.job(AXIS)
    objects = [scene, results, results.table, results.plot("motion"), gearsim.compare(scene, scene), job]
    return {type(it).__name__: it for it in objects} | {
        "scene": scene, "scenes": scene, "table": results.table, "axes": AXIS, "axis": "start.speed=1 rpm:2 rpm:2", "model": "chain_2",
        "first": 0, "end": 1, "most": 1, "q": [0.0], "q_dot": [0.0], "name": "scene", "text": "", "limits": "t_end <= 1 s", "samples": 2, "laws": [1.0],
        "folder": tmp_path_factory.mktemp("out"), "gathering": job.gather(tmp_path_factory.mktemp("parts")), "rows": b"", "overrides": [],
    }  # fmt: skip


def functions():
    """The public functions and methods, and those by which `in`, `[]` and pickle reach the package."""
    for name in gearsim.__all__:
        what = getattr(gearsim, name)
        if not inspect.isclass(what):
            if callable(what):
                yield name, what
        elif not issubclass(what, Exception):
            if what in (gearsim.Scene, gearsim.Comparison):
                yield name, what
            for method in vars(what):
                if not method.startswith("_") or method in ("__contains__", "__getitem__", "_restore"):
                    if callable(getattr(what, method)):
                        yield f"{name}.{method}", getattr(what, method)
    yield "command_line", gearsim.command_line


FUNCTIONS = dict(functions())
MISTAKES = [
    (name, argument)
    for name, what in FUNCTIONS.items()
    for argument, parameter in inspect.signature(what).parameters.items()
    # Any object is a request of Arrow; tables are checked with the scene.
    if argument not in ("self", "requested_schema") and parameter.kind is not parameter.VAR_KEYWORD
]


def test_all_functions_are_tried():
    some = {("Scene", "model"), ("Scene.replace", "values"), ("Table.__contains__", "key"), ("Job.run", "threads"), ("sweep", "out")}
    assert some < set(MISTAKES) and len(MISTAKES) > 70, MISTAKES


@pytest.mark.parametrize("name, wrong", MISTAKES)
def test_a_wrong_argument_is_refused_with_what_is_allowed(name, wrong, objects):
    fitting = objects | ({"axes": RANDOM} if name == "sensitivity" else {})
    parameters = inspect.signature(FUNCTIONS[name]).parameters
    several = any(parameter.kind is parameter.VAR_POSITIONAL for parameter in parameters.values())
    positional, keywords = [], {}
    for argument, parameter in parameters.items():
        place = parameter.kind in (parameter.POSITIONAL_ONLY, parameter.VAR_POSITIONAL) or several and argument == "scene"
        if argument == "self":
            positional.append(objects[name.partition(".")[0]])
        elif argument == wrong or parameter.default is parameter.empty and parameter.kind is not parameter.VAR_KEYWORD:
            value = Nothing() if argument == wrong else fitting[argument]
            positional.append(value) if place else keywords.update({argument: value})
    with pytest.raises(TypeError) as raised:
        FUNCTIONS[name](*positional, **keywords)
    assert re.match(r"`\w+` (is|must be) |an axis is |columns are read ", str(raised.value)), raised.value


@pytest.mark.parametrize(
    "call, error, said",
    [
        (lambda scene: gearsim.Scene(3), TypeError, '`model` is the name of a model, not 3 (int): model="gear_pair"'),
        (lambda scene: scene.replace("text"), TypeError, "`values` is a dict of keys and values, not 'text' (str): values={\"parameters.T0\": 20.0}"),
        (lambda scene: scene.modes(levels=1.0), TypeError, "`levels` is a list of numbers in SI units, not 1.0 (float): levels=[1e8, 2e8]"),
        (lambda scene: scene.modes("12"), TypeError, "`levels` is a list of numbers in SI units, not '12' (str): levels=[1e8, 2e8]"),
        (lambda scene: scene.job(AXIS, start="1 s"), TypeError, "`start` is a time in s, not '1 s' (str): start=0.5"),
        (lambda scene: scene.job(AXIS, samples=-1), ValueError, "`samples` is a whole number from 0 on, not -1 (int): samples=1000"),
        (lambda scene: scene.job(AXIS).run(0, 1, threads=0), ValueError, "`threads` is a whole number from 1 on, not 0 (int): threads=4"),
        (lambda scene: gearsim.sweep(scene, AXIS, points_per_task=0), ValueError, "`points_per_task` is a whole number from 1 on, not 0 (int)"),
        (lambda scene: gearsim.sweep(3, AXIS), TypeError, '`scene` is a gearsim.Scene, not 3 (int): scene=gearsim.load("scene.toml")'),
        (lambda scene: scene.run(progress=1), TypeError, "`progress` is a function of one number, not 1 (int): progress=print"),
        (lambda scene: gearsim.compare(scene, scene, names="ab"), TypeError, "`names` is a list of texts"),
        (lambda _: gearsim.executors.DaskExecutor("tcp://host:8786"), TypeError, "`client` is a distributed.Client, not 'tcp://host:8786' (str)"),
        (lambda _: gearsim.executors.SubmititExecutor(3), TypeError, "`executor` is a submitit.AutoExecutor, not 3 (int)"),
        (lambda _: gearsim.executors._remote.RemoteExecutor("1 s"), TypeError, "`interval` is a time in s, not '1 s' (str): interval=1.0"),
        (lambda scene: gearsim.limits(scene, AXIS, limits=3), TypeError, "`limits` is a list of texts"),
    ],
)  # fmt: skip
def test_the_message_says_what_is_wrong_and_what_is_allowed(call, error, said):
    with pytest.raises(error, match=re.escape(said)):
        call(gearsim.load(SCENE))


def test_lists_are_of_any_kind_and_dicts_are_any_mapping():
    scene = gearsim.load(SCENE)
    two = [2.0]
    assert [mode["shape"] for mode in scene.modes(two)] == [mode["shape"] for mode in scene.modes(np.array(two))]
    values = types.MappingProxyType({"parameters": types.MappingProxyType({"T0": 3.0})})
    assert scene.replace(values).parameters["T0"] == 3.0


class Interrupting:
    """A number whose conversion is interrupted."""

    def __float__(self):
        raise KeyboardInterrupt


def test_errors_of_the_caller_stay_as_they_are():
    with pytest.raises(KeyboardInterrupt):
        gearsim.load(SCENE).modes([Interrupting()])
