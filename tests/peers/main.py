"""Runs all peers on all scenes and all derivations, and writes the table. `cargo xtask peers` calls this program.

    main.py SCENES TABLE [--quick]                      everything, each run in a process of its own
    main.py --one SCENES NAME SOLVER METHOD TOLERANCE   one run, as JSON

Because each run has its own process, a crash or an endless run only gives a row of the table.
"""

import json
import sys
from pathlib import Path

import derivations
import table
from apart import apart
from scene import Scene
from solvers import SOLVERS, solver as module_of

LIMITS = {"quick": 3, "scenes": 10}
"""The processor time [s] allowed for a solver on a scene, including its repetitions."""


def load(path):
    """The scenes of a file by name."""
    return {data["name"]: data for data in json.loads(Path(path).read_text())}


def one(path, name, solver, method, tolerance):
    """Runs one solver on one scene and prints the result as JSON."""
    scene = Scene(load(path)[name])
    scene.file = path
    scene.flags = ["--quick"] if Path(path).stem == "quick" else []
    tolerance = tolerance if tolerance in ("default", "exact") else float(tolerance)
    print(json.dumps(module_of(solver).run(scene, method, tolerance)))


def tolerances(path, module):
    """The tolerances of a solver; only one in a quick run."""
    return [module.TOLERANCES[-2:][0]] if Path(path).stem == "quick" else module.TOLERANCES


def rows(path, name):
    """The runs of all solvers on a scene. If a tolerance takes too long, tighter ones are not tried."""
    for solver in SOLVERS:
        module = module_of(solver)
        for method in module.METHODS:
            for tolerance in tolerances(path, module):
                arguments = ["--one", path, name, solver, method, str(tolerance)]
                result = apart([sys.executable, __file__, *arguments], LIMITS[Path(path).stem])
                print(name, solver, method, tolerance, result.get("failed", "done"), flush=True)
                yield {"solver": solver, "method": method, "tolerance": tolerance, **result}
                if result.get("over") and tolerance != "default":
                    break


def main(path, out, quick):
    results = {
        "scenes": load(path),
        "runs": {name: list(rows(path, name)) for name in load(path)},
        "derivations": list(derivations.rows(quick)),
        "versions": [
            *(module_of(solver).version() for solver in SOLVERS),
            *(derivations.tool(tool).version() for tool in derivations.TOOLS),
        ],
        "limits": [LIMITS[Path(path).stem], derivations.limit(quick)],
        "quick": quick,
    }
    # All measured values, for other evaluations.
    Path(path).with_suffix(".results.json").write_text(json.dumps(results))
    Path(out).write_text(table.write(**results))


if __name__ == "__main__":
    if sys.argv[1] == "--one":
        one(*sys.argv[2:])
    else:
        main(sys.argv[1], sys.argv[2], "--quick" in sys.argv)
