"""The table of the measured values in Markdown, with the machine and the versions."""

import platform
from pathlib import Path
from statistics import median

LARGE = 0.5
"""An end with a larger error, in units of the motion, counts as no solution."""


def number(x, digits=2):
    """A number with few digits; very small and very large ones with a power of ten."""
    if x == 0:
        return "0"
    return f"{x:.{digits - 1}e}" if abs(x) < 1e-3 or abs(x) >= 1e4 else f"{x:.{digits}g}"


def duration(seconds):
    """A time with its unit."""
    for unit, scale in (("s", 1), ("ms", 1e-3), ("us", 1e-6)):
        if seconds >= scale:
            return f"{seconds / scale:.3g} {unit}"
    return f"{seconds / 1e-9:.3g} ns"


def markdown(head, rows):
    lines = [head, ["---"] * len(head), *rows]
    return "".join("| " + " | ".join(str(x).replace("|", "/") for x in line) + " |\n" for line in lines)


def end_error(scene, result):
    """The largest difference of the end from the reference, relative to the sizes of the motion."""
    reference = scene["reference"]
    below = lambda cell: cell // 2 * scene["pitch"] + cell % 2 * scene["width"][0]
    differences = [(x - high) - low for x, (high, low) in zip(result["end"], reference["end"])]
    differences[0] += below(result["cell"]) - below(reference["cell"])
    return max(abs(d) / size for d, size in zip(differences, scene["sizes"]))


def agreement(scene, result):
    """How many events agree with the reference, in words, and the error of the last event's time [s] if all agree."""
    wanted = scene["reference"]["events"]
    found = result.get("events")
    if found is None:
        count = result["count"]
        return f"{count} of {len(wanted)}, by number" if count != len(wanted) else f"all {count}, by number", None
    same = [(f[1], f[2]) == (w[2], w[3]) for f, w in zip(found, wanted)]
    right = same.index(False) if False in same else len(same)
    if right == len(wanted) == len(found):
        return f"all {right}", abs((found[-1][0] - wanted[-1][0]) - wanted[-1][1])
    return f"**first {right} of {len(wanted)}**, {len(found)} found", None


def solver_row(scene, row):
    head = [row["solver"], row["method"], row["tolerance"]]
    if "failed" in row:
        reason = row["failed"].split(".cpp:", 1)[-1]
        return [*head, f"**failed: {reason}**", "", "", "", "", "", ""]
    error, (events, last) = end_error(scene, row), agreement(scene, row)
    cpu = row["cpu"]
    each = min(cpu) / len(scene["reference"]["events"])
    wrong = not error < LARGE
    return [
        *head,
        f"**{number(error)}**" if wrong else number(error),
        "" if last is None else number(last),
        events,
        duration(min(cpu)),
        duration(median(cpu)),
        duration(each) if not events.startswith("*") else "",
        duration(row["prepare"]) if row["prepare"] > 1e-3 else "",
    ]


SOLVER_HEAD = ["tool", "method", "tolerance", "error at the end", "error of the last event's time [s]", "events",
               "CPU time, least", "median", "per event", "once, before"]


def scene_part(scene, rows):
    reference = scene["reference"]
    reflections = sum(event[2] == "reflect" for event in reference["events"])
    own = f"{reference['error']:.0e}" if reference["error"] else "below 1e-30"
    return (
        f"## {scene['name']}\n\n{scene['about'].capitalize()}. {len(reference['events'])} events, {reflections} of them "
        f"reflections. The reference's own error (50 against 70 digits) is {own}; a relative disturbance of the start "
        f"grows {reference['growth']:.2g}-fold until the end.\n\n    {scene['command']}\n\n"
        + markdown(SOLVER_HEAD, [solver_row(scene, row) for row in rows])
        + "\n"
    )


def derivation_row(row):
    missing = f"**{row.get('failed', '')}**"
    took = duration(row["took"]) if "took" in row else missing
    return [row["model"], row["tool"], row["method"], took, row.get("before", missing), row.get("after", missing)]


def machine():
    """The processor and the system."""
    info = Path("/proc/cpuinfo")
    lines = info.read_text().splitlines() if info.exists() else []
    names = [line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")]
    processor = f"{names[0]}, {len(names)} cores" if names else platform.processor()
    return f"{processor}, {platform.system()}, Python {platform.python_version()}"


def write(scenes, runs, derivations, versions, limits, quick):
    """The whole table."""
    command = "cargo xtask peers" + (" --quick" if quick else "")
    scenes_text = "".join(scene_part(scenes[name], rows) for name, rows in runs.items())
    derived = markdown(
        ["model", "tool", "gives", "CPU time", "operations as written", "after common subexpressions"],
        [derivation_row(row) for row in derivations],
    )
    return f"""# Peers

The cost and accuracy of other tools on the same scenes and the same derivations, each used as an experienced user would. What was
done to be fair is at the head of the tool's file in `tests/peers`. This file is written by

    {command}

from one run; do not edit it. {machine()}. {"; ".join(dict.fromkeys(versions))}.

An error is the difference from an independent engine with 50 digits, in units of the motion: theta over a pitch, theta' over its
start, phi over T0/k1, phi' over w0 T0/k1; the largest of these counts. Events count as found up to the first that differs in kind
or place. Times are processor times of a whole run: the smallest and the median of up to five samples of at least 0.2 s (one sample
if a run takes longer than 3 s). "once, before" is the time of compilation and setup, which the other times do not include. A tool
that takes over {limits[0]} s on a scene, repetitions included, is stopped, and its tighter tolerances are not tried. An error in bold is no
solution.

{scenes_text}## Derivation

From T, V, D and Q, as gearsim prints them, to the equations of motion. "Forces" leave M on the left; for "accelerations" M is
inverted. gearsim's time is wall clock time and includes its proofs and its file; its derivation has jump terms, which no other tool
has. Operations are counted in the same way for all tools, by `tests/peers/derivations/operations.py`. The limit is {limits[1]} s.

{derived}"""
