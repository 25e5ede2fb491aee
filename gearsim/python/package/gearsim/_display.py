"""Results in notebooks; summaries and advice as dictionaries."""

from __future__ import annotations

import html
import json
from collections.abc import Callable, Iterable
from typing import Any

from gearsim._gearsim import Results, Scene, Table

_ROWS = 10


def _cells(values: Iterable[object], tag: str = "td") -> str:
    return "".join(f"<{tag}>{html.escape(str(value))}</{tag}>" for value in values)


def _number(value: object) -> object:
    return f"{value:.6g}" if isinstance(value, float) else value


def _table(self: Table) -> str:
    """The first rows of a table, with units."""
    shown = min(len(self), _ROWS)
    columns = [self[name][:shown] for name in self.columns]
    head = _cells((f"{name} [{self.units[name]}]" if self.units[name] else name for name in self.columns), "th")
    rows = "".join(f"<tr>{_cells(_number(column[i]) for column in columns)}</tr>" for i in range(shown))
    more = f"<p>{len(self)} rows, of which {shown} are shown</p>" if len(self) > shown else ""
    return f"<table><thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table>{more}"


def _results(self: Results) -> str:
    """The outputs of a run with their statistics, its energy account, and its first plot."""
    summary = self.summary
    names = ["min", "max", "mean", "rms"]
    rows = "".join(
        f"<tr>{_cells([name, *(f'{output[key]:.6g}' for key in names), output['unit']])}</tr>"
        for name, output in summary["outputs"].items()
    )
    head = _cells(["output", *names, "unit"], "th")
    energy = summary["energy"]
    account = f"unaccounted for {energy['residual']:.1e} J of {energy['largest']:.3g} J, by {summary['method']['name']}"
    state = summary["stopped_by"] or summary["refuted"] or "complete"
    try:
        plot = self.plot()._repr_svg_()
    except Exception as error:  # a run without outputs has no such plot
        plot = f"<p>{html.escape(str(error))}</p>"
    return (
        f"<p><b>{html.escape(summary['scene'])}</b>: {html.escape(state)}; energy {html.escape(account)}</p>"
        f"<table><thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table>{plot}"
    )


def _scene(self: Scene) -> str:
    rows = "".join(f"<tr>{_cells([name, f'{value:.6g}'])}</tr>" for name, value in self.parameters.items())
    about = html.escape(self.about or self.name)
    return f"<p><b>{about}</b></p><p>{html.escape(repr(self))}</p><table>{rows}</table>"


def _summary(self: Results) -> dict[str, Any]:
    """End state, energies, statistics of the outputs, method.

    Of each output `min` and `max`; over the time the `mean` and `rms`, which is the root mean square about the mean; and the percentiles
    `p01` and `p99` of its samples.
    """
    summary: dict[str, Any] = json.loads(self._summary())
    return summary


def _advise(self: Scene, progress: Callable[[float], object] | None = None) -> dict[str, Any]:
    """Which effects the scene needs: estimated, and checked by runs with and without each. A dictionary.

    progress: called from time to time with the time [s] that the present run has reached.
    """
    advice: dict[str, Any] = json.loads(self._advise(progress))
    return advice


def install() -> None:
    """Add the methods that are simpler in Python to the classes of the extension module."""
    added: dict[type, dict[str, object]] = {
        Results: {"summary": property(_summary), "_repr_html_": _results},
        Scene: {"advise": _advise, "_repr_html_": _scene},
        Table: {"_repr_html_": _table},
    }
    for where, names in added.items():
        for name, what in names.items():
            setattr(where, name, what)
