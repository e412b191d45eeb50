"""What keys of a case that is one class are made of: its class and a reference in another file."""

import importlib
import sys

import pytest

import verify.cases
from verify.core import source_code
from verify.form.adapter import adapted

SOURCES = {
    "made_bar": '''
from verify.case import Case, Quantity, approximation, given
from verify.case import Expected

EXPECTED = Expected(-0.01, 0.03, "book")


class Bar(Case):
    """A bar in tension."""

    title = "Bar"
    source = "belcin"

    d: float = given("10 mm", "mm", "d", "diameter", gt=0)
    F: float = given("1 kN", "kN", "F", "force")

    @Quantity("r", "mm", "radius", role="geometry")
    def radius(self) -> float:
        return self.d / 2.0

    @Quantity("A", "mm^2", "area", role="geometry")
    def area(self) -> float:
        return 3.14 * self.radius**2

    @Quantity("V", "mm^3", "volume of a cube", role="geometry")
    def unread(self) -> float:
        return self.d**3.0

    @Quantity("σ", "MPa", "stress", equation="1", when=lambda q: q.F > 0)
    def sigma(self) -> float:
        return self.F / self.area * 1.0

    def reference(self, level):
        from verify.cases.made_bar_reference import solve

        return solve(self, level)

    def comparisons(self):
        yield approximation(Bar.sigma, order=2, expected=EXPECTED)
''',
    "made_bar_reference": """
from verify.case import solved


def solve(q, level):
    return solved(1 / level, sigma=q.F / q.area)


def error(q, stress):
    # of the formula; no part of a solution, in which reading it is an error
    return q.sigma / stress - 1
""",
}


@pytest.fixture
def keys(tmp_path_factory, monkeypatch):
    """Hashes of the made-up case's formulas and reference, after a replacement in its modules."""
    path = verify.cases.__path__

    def hashed(module="made_bar", old="", new=""):
        folder = tmp_path_factory.mktemp("variant")
        for name, text in SOURCES.items():
            assert name != module or old in text
            changed = text.replace(old, new) if name == module and old else text
            (folder / f"{name}.py").write_text(changed, "utf-8")
            sys.modules.pop(f"verify.cases.{name}", None)
        monkeypatch.setattr(verify.cases, "__path__", [*path, str(folder)])
        importlib.invalidate_caches()
        source_code.forget()
        case = adapted(importlib.import_module("verify.cases.made_bar").Bar)
        return {
            "formulas": source_code.whole_source_of(case.analytic),
            "reference": source_code.source_of(case.reference),
        }

    yield hashed
    for name in SOURCES:
        sys.modules.pop(f"verify.cases.{name}", None)
        vars(verify.cases).pop(name, None)
    source_code.forget()


@pytest.mark.parametrize(
    ("old", "new", "changed"),
    [
        pytest.param("3.14 *", "3.15 *", {"formulas", "reference"}, id="geometry that it reads"),
        pytest.param("d / 2.0", "d / 2.5", {"formulas", "reference"}, id="geometry under that"),
        pytest.param("lambda q: q.F", "lambda q: -q.F", {"formulas"}, id="which inputs have it"),
        pytest.param("d**3.0", "d**3.5", {"formulas"}, id="geometry that it does not read"),
        pytest.param("area * 1.0", "area * 1.5", {"formulas"}, id="formula"),
        pytest.param("0.03", "0.04", {"formulas"}, id="bound of a comparison"),
        pytest.param("order=2", "order=3", {"formulas"}, id="argument of a comparison"),
        pytest.param('"10 mm"', '"11 mm"', {"formulas", "reference"}, id="default of an input"),
        pytest.param("in tension", "under a pull", set(), id="docstring"),
    ],
)
def test_a_change_of_the_class_changes_the_keys_of_the_sides_that_read_it(keys, old, new, changed):
    before, after = keys(), keys("made_bar", old, new)
    assert {side for side in before if before[side] != after[side]} == changed


def test_a_change_of_the_file_of_the_reference_changes_its_key_alone(keys):
    before, after = keys(), keys("made_bar_reference", "q.F / q.area", "2 * q.F / q.area")
    assert before["reference"] != after["reference"]
    assert before["formulas"] == after["formulas"]
