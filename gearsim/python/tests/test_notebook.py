"""The notebook of the paper runs, and its results agree with the paper."""

import pathlib
import re

import pytest

NOTEBOOK = pathlib.Path(__file__).parents[1] / "examples" / "paper.ipynb"


def test_the_notebook_of_the_paper_runs():
    nbclient = pytest.importorskip("nbclient")
    nbformat = pytest.importorskip("nbformat")
    notebook = nbformat.read(NOTEBOOK, as_version=4)
    nbclient.NotebookClient(notebook, timeout=120, resources={"metadata": {"path": NOTEBOOK.parent}}).execute()
    printed = "".join(
        output.get("text", "") for cell in notebook.cells if cell.cell_type == "code" for output in cell.outputs
    )
    # The exact equations only lose energy; the others create it.
    end, rise = map(float, re.search(r"exact +energy at the end (\S+) J, largest rise (\S+) J", printed).groups())
    assert end < 0 and rise < 1e-9
    for name in ("rigid kinematic", "classical"):
        assert float(re.search(rf"{name} +energy at the end \S+ J, largest rise (\S+) J", printed)[1]) > 1e-4
    assert re.search(r"zeta = 0.0: .* unstable: True", printed) and re.search(r"zeta = 0.1: .* unstable: False", printed)
