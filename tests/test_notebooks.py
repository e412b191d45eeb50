"""The notebooks of examples have no outputs; their cells run in order without Jupyter."""

import ast
import json
from html.parser import HTMLParser
from pathlib import Path

import matplotlib as mpl
import matplotlib.pyplot as plt
import pytest

from verify.app.notebook import Part, Run

NOTEBOOKS = sorted((Path(__file__).parents[1] / "examples" / "notebooks").glob("*.ipynb"))
SUBJECTS = {"contact", "freewheel", "polyhedral", "ring", "rotor", "spring", "sprag"}
FEWEST, MOST = 5, 8  # cells


def cells(path):
    return json.loads(path.read_text("utf-8"))["cells"]


def shown(source, namespace):
    """Run a cell; the value of its last expression, which a notebook displays."""
    body = ast.parse(source).body
    last = body.pop() if isinstance(body[-1], ast.Expr) else None
    exec(compile(ast.Module(body, []), "cell", "exec"), namespace)
    return last and eval(compile(ast.Expression(last.value), "cell", "eval"), namespace)


@pytest.fixture
def _drawn_to_nothing(monkeypatch, tmp_path):
    backend = mpl.get_backend()
    mpl.use("agg")
    monkeypatch.chdir(tmp_path)
    yield
    plt.close("all")
    mpl.use(backend)


def test_there_is_a_notebook_for_each_subject():
    assert {path.stem for path in NOTEBOOKS} == SUBJECTS


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_a_notebook_is_short_and_without_outputs(path):
    found = cells(path)
    assert FEWEST <= len(found) <= MOST
    assert "".join(found[0]["source"]).startswith("# ")
    code = [cell for cell in found if cell["cell_type"] == "code"]
    assert all(cell["outputs"] == [] and cell["execution_count"] is None for cell in code)
    assert len({cell["id"] for cell in found}) == len(found)  # nbformat 4.5


@pytest.mark.slow("every notebook is run as a reader runs it")
@pytest.mark.usefixtures("_drawn_to_nothing")
@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_the_cells_of_a_notebook_run_in_order(path):
    namespace = {}
    code = ["".join(cell["source"]) for cell in cells(path) if cell["cell_type"] == "code"]
    values = [shown(source, namespace) for source in code]
    assert all(value is not None for value in values)  # each cell displays something
    answers = [value for value in values if isinstance(value, Run | Part)]
    assert answers
    assert all(value.passed for value in answers if isinstance(value, Run))
    assert all(value.verdict != "fails" for value in answers if isinstance(value, Part))
    for value in values:
        if display := getattr(value, "_repr_html_", None):
            HTMLParser().feed(display())
