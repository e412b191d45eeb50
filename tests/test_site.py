"""Sources of the pages of `make docs`: docstrings that Sphinx reads, equations of the ledgers."""

import importlib.util
import os
import re
import subprocess
from pathlib import Path

import pytest

from verify.papers.ledger import papers

ROOT = Path(__file__).parents[1]
SPHINX = ROOT / ".venv-docs" / "bin" / "python"


def extension(name):
    place = ROOT / "docs" / "_extensions" / f"{name}.py"
    spec = importlib.util.spec_from_file_location(f"docs_{name}", place)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize(
    ("text", "lines"),
    [
        ("Where |x| < a, several `State`s; `|y|` is code.",
         [r"Where \|x\| < a, several `State`\ s; `|y|` is code."]),
        ("Sums:\n\n    K[a] = |b|\n\nmore |c|",  # code
         ["Sums:", "", "::", "", "    K[a] = |b|", "", r"more \|c\|"]),
        (".. math::\n    a\n\n    |b|", [".. math::", "    a", "", "    |b|"]),
        ('"thin"   and N\n         of it;\n"thick"  all',  # values that are explained
         ["", '- "thin": and N', "  of it;", '- "thick": all']),
        ("F.\n\nRaises\n------\nValueError\n    Why.\n\n>>> f(**x)",
         ["F.", "", "Raises", "------", "ValueError", "    Why.", "",
          "Examples", "--------", ">>> f(**x)"]),
    ],
)  # fmt: skip
def test_docstrings_become_what_sphinx_reads(text, lines):
    found = text.splitlines()
    extension("docstrings").mark(None, "function", "f", None, None, found)
    assert found == lines


def test_types_of_a_signature_are_those_of_the_source():
    from analytic.ring.lame import stresses

    arguments, result = extension("docstrings").signature(
        None, "function", "stresses", stresses, None, "", ""
    )
    assert arguments.startswith("(r: ArrayLike, *, r_i: ArrayLike")
    assert result == "tuple[Array, Array]"


@pytest.mark.parametrize("paper", papers(), ids=lambda paper: paper.key)
def test_a_theory_page_has_every_equation_and_every_correction(paper):
    text = "\n".join(extension("theory")._paper(paper, {}))
    pages = (ROOT / "docs" / "theory").glob("*.md")
    assert any(f"_generated/{paper.key}.txt" in page.read_text("utf-8") for page in pages)
    for equation in paper.equations:
        assert f"### Eq. {equation.number}: " in text
        assert equation.tex in text
    named = [e for e in paper.errata if re.search(r"Eqs?\. \d", e.place)]
    assert len(named) > 5
    for erratum in named:
        assert erratum.right_tex in text, erratum.id


@pytest.mark.soak
@pytest.mark.skipif(not SPHINX.exists(), reason="`make docs` makes the environment with Sphinx")
def test_the_pages_are_built_without_a_warning(tmp_path):
    done = subprocess.run(
        [SPHINX, "-m", "sphinx", "-W", "-q", "-d", tmp_path / "trees", "docs", tmp_path / "html"],
        cwd=ROOT, env={**os.environ, "PYTHONPATH": ""}, capture_output=True, text=True,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
