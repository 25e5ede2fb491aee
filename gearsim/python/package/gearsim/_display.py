"""How results look in notebooks; summaries and advice as dictionaries."""

from __future__ import annotations

import html
import json

_ROWS = 10


def _cells(values, tag="td"):
    return "".join(f"<{tag}>{html.escape(str(value))}</{tag}>" for value in values)


def _table(table) -> str:
    """The first rows of a table, with units."""
    shown = min(len(table), _ROWS)
    columns = [table[name][:shown] for name in table.columns]
    head = _cells((f"{name} [{table.units[name]}]" if table.units[name] else name for name in table.columns), "th")
    number = lambda value: f"{value:.6g}" if isinstance(value, float) else value
    rows = "".join(f"<tr>{_cells(number(column[i]) for column in columns)}</tr>" for i in range(shown))
    more = f"<p>{len(table)} rows, of which {shown} are shown</p>" if len(table) > shown else ""
    return f"<table><thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table>{more}"


def _results(results) -> str:
    """The outputs of a run with their statistics, its energy account, and its first plot."""
    summary = results.summary
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
        plot = results.plot().svg()
    except Exception as error:  # a run without outputs has no such plot
        plot = f"<p>{html.escape(str(error))}</p>"
    return (
        f"<p><b>{html.escape(summary['scene'])}</b>: {html.escape(state)}; energy {html.escape(account)}</p>"
        f"<table><thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table>{plot}"
    )


def _scene(scene) -> str:
    rows = "".join(f"<tr>{_cells([name, f'{value:.6g}'])}</tr>" for name, value in scene.parameters.items())
    about = html.escape(scene.about or scene.name)
    return f"<p><b>{about}</b></p><p>{html.escape(repr(scene))}</p><table>{rows}</table>"


def _advise(scene):
    """Which effects the scene needs: estimated, and checked by runs with and without each. A dictionary."""
    return json.loads(scene._advise())


def install(results, table, scene):
    """Add the display of notebooks to the classes of the extension module."""
    results.summary = property(
        lambda self: json.loads(self._summary()), doc="End state, energies, statistics of the outputs, method."
    )
    scene.advise = _advise
    results._repr_html_ = _results
    table._repr_html_ = _table
    scene._repr_html_ = _scene
