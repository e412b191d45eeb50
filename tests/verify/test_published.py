"""The ledgers: complete, consistent, and pointing at code and tests that exist."""

import ast
import math
import pkgutil
import re
import tomllib
from functools import cache
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pydantic import ValidationError
from ziamath.tex import tex2mml

import verify
from reports.equations import Glyphs
from verify.cases.registry import CASES, find
from verify.core import units
from verify.core.case import Context
from verify.core.inputs import meta
from verify.papers import ledger
from verify.papers.digits import half_last_digit, number
from verify.papers.entries import Value
from verify.papers.ledger import Paper, erratum, papers, published

fixed = settings(deadline=None, derandomize=True)

ROOT = Path(verify.__file__).parent.parent
# How many equations each paper numbers, counted in the papers.
EQUATIONS = {"huang2018": 22, "huang2022": 11, "nagler2021": 10, "wang2023": 13, "belcin": 21}

RAW = {
    key: tomllib.loads((Path(ledger.__file__).parent / f"{key}.toml").read_text("utf-8"))
    for key in EQUATIONS
}
PAPERS = pytest.mark.parametrize("paper", papers(), ids=lambda paper: paper.key)


def entries(kind):
    """One case per entry of the files: paper key and entry as written."""
    return [
        pytest.param(key, entry, id=f"{key}: {entry.get('id', entry.get('number'))}")
        for key, raw in RAW.items()
        for entry in raw[kind]
    ]


VALUES, EQS, ERRATA = entries("values"), entries("equations"), entries("errata")


# The files.


def test_there_is_one_file_for_each_of_the_five_papers():
    files = {path.stem for path in Path(ledger.__file__).parent.glob("*.toml")}
    assert files == set(EQUATIONS)
    assert [paper.key for paper in papers()] == list(EQUATIONS)


@PAPERS
def test_every_numbered_equation_has_an_entry(paper):
    assert [e.number for e in paper.equations] == list(range(1, EQUATIONS[paper.key] + 1))


def test_the_five_papers_number_77_equations():
    assert sum(len(raw["equations"]) for raw in RAW.values()) == 22 + 11 + 10 + 13 + 21 == 77


@pytest.mark.parametrize("kind", ["values", "errata"])
@pytest.mark.parametrize("key", RAW)
def test_no_id_is_used_twice(key, kind):
    ids = [entry["id"] for entry in RAW[key][kind]]
    assert sorted(ids) == sorted(set(ids))


@pytest.mark.parametrize(("key", "entry"), ERRATA)
def test_an_erratum_gives_place_print_right_form_and_evidence(key, entry):
    for part in ("place", "printed", "right", "evidence"):
        assert entry[part].strip()
    assert entry["printed"] != entry["right"]


TEX = [
    pytest.param(entry[side], entry[f"{side}_tex"], f"{entry['printed']} {entry['right']}",
                 id=f"{key}: {entry['id']} {side}")
    for key, raw in RAW.items()
    for entry in raw["errata"]
    for side in ("printed", "right")
    if entry.get(f"{side}_tex")
]  # fmt: skip


@pytest.mark.parametrize(("plain", "tex", "both"), TEX)
def test_a_formula_of_an_erratum_is_drawn_and_says_what_the_plain_text_says(plain, tex, both):
    """Numbers at least: its decimals are those of the text, larger integers those of the entry."""
    assert "<use" in Glyphs().maths(tex)
    assert "\\" not in tex2mml(tex)  # a command unknown to it stays as text
    assert tex.count("{") == tex.count("}")
    assert set(re.findall(r"\d+\.\d+", tex)) <= set(re.findall(r"\d+\.\d+", plain))
    assert set(re.findall(r"\b\d{2,}\b", tex)) <= set(re.findall(r"\d+", both))


@pytest.mark.parametrize(("key", "entry"), EQS)
def test_a_numbered_equation_is_drawn_with_the_paper_s_numbers(key, entry):
    tex = entry["tex"]
    assert "<use" in Glyphs().maths(tex)
    assert "\\" not in tex2mml(tex)
    assert tex.count("{") - tex.count(r"\{") == tex.count("}") - tex.count(r"\}")
    printed = {value["printed"].lstrip("-") for value in RAW[key]["values"]}
    assert set(re.findall(r"\d+\.\d+", tex)) <= printed


@pytest.mark.parametrize(("key", "entry"), ERRATA)
def test_formulas_before_and_after_the_correction_differ(key, entry):
    if entry.get("printed_tex"):
        assert entry["printed_tex"] != entry.get("right_tex")


@pytest.mark.parametrize(("key", "entry"), VALUES)
def test_a_printed_value_has_the_number_a_place_and_a_unit_that_is_known(key, entry):
    # The string as it stands, read without the ledger's own parser.
    printed = entry["printed"].replace("−", "-").replace("×10^", "e").replace(" ", "")
    assert float(printed) == pytest.approx(entry["value"], rel=1e-12)
    assert entry["place"].strip()
    assert units.factor(entry["unit"]) > 0


@pytest.mark.parametrize(("key", "entry"), VALUES)
def test_a_limit_is_a_bound_whose_last_digit_says_nothing(key, entry):
    if entry["role"] == "limit":
        assert Value(**entry).standard_uncertainty is None


# Numbers that whoever reads the papers finds in them, with places.
SPOT_CHECKS = [
    ("wang2023:k1-theory", 0.601, "N/mm"),  # Table 1
    ("wang2023:k1-fea", 0.613, "N/mm"),
    ("wang2023:k1-test", 0.610, "N/mm"),
    ("wang2023:k2-fea", 0.749, "N/mm"),
    ("wang2023:k2-test", 0.708, "N/mm"),
    ("wang2023:b", 0.1, "mm"),  # Sec. 1.2, last paragraph
    ("wang2023:alpha", 80.0, "deg"),
    ("huang2018:table1-r-e", 19.44, "mm"),  # Table 1
    ("huang2018:table1-r-ed", 26.23, "mm"),
]


@pytest.mark.parametrize(("reference", "value", "unit"), SPOT_CHECKS)
def test_a_value_is_found_by_paper_and_id(reference, value, unit):
    entry = published(reference)
    assert (entry.value, entry.unit) == (value, unit)


@pytest.mark.parametrize("reference", ["wang2023:nothing", "nobody:b", "b", ""])
def test_a_value_or_erratum_that_is_not_there_is_refused(reference):
    with pytest.raises(KeyError):
        published(reference)
    with pytest.raises(KeyError):
        erratum(reference)


# Inputs that claim to be the paper's.

CLAIMS = [
    pytest.param(field.default, meta(field), id=f"{case.id}: {name}")
    for case in CASES
    for name, field in case.inputs.model_fields.items()
    if meta(field)["claims"]
]


@pytest.mark.parametrize(("default", "extra"), CLAIMS)
def test_a_default_that_claims_a_printed_value_is_that_value(default, extra):
    entry = published(extra["claims"])
    assert default == pytest.approx(entry.value * units.factor(entry.unit), rel=1e-15)
    assert units.dimensions(entry.unit) == units.dimensions(extra["unit"])
    # a design that it found may be where we start, and the range of a rig how far we load
    rig = entry.role == "limit" and entry.kind == "test"
    assert rig or entry.role in ("input", "result")


# Code and tests that the ledgers name.


def names_in(path):
    """Functions and classes of a test file, by the names that pytest gives them."""
    for node in ast.parse(path.read_text("utf-8")).body:
        if isinstance(node, ast.FunctionDef | ast.ClassDef):
            yield node.name
        if isinstance(node, ast.ClassDef):
            yield from (f"{node.name}::{n.name}" for n in node.body if hasattr(n, "name"))


@cache
def rows(case_id):
    """Ids of all rows that a run of the case judges, known without finite elements."""
    case = find(case_id)
    context = Context(case.id, case.inputs(), case.analytic(case.inputs()), (), is_paper=True)
    found = [
        check.skipped(case.id, "") if check.needs_fem else check.rows(context)
        for check in case.checks
    ]
    return {row.id for every in found for row in every}


def with_test(kind):
    return [param for param in entries(kind) if param.values[1].get("test")]


def assert_exists(test):
    if test.startswith("tests/"):
        path, _, name = test.partition("::")
        assert (ROOT / path).is_file(), path
        assert name.partition("[")[0] in set(names_in(ROOT / path)), test
    else:
        assert test in rows(test.partition("/")[0]), test


@pytest.mark.parametrize(("key", "entry"), with_test("equations") + with_test("errata"))
def test_a_test_that_is_named_exists_as_test_or_row(key, entry):
    assert_exists(entry["test"])


IMPLEMENTED = [param for param in EQS if param.values[1]["status"] == "implemented"]


@pytest.mark.parametrize(("key", "entry"), IMPLEMENTED)
def test_an_implemented_equation_names_code_that_exists(key, entry):
    assert callable(pkgutil.resolve_name(entry["code"]))
    assert entry["test"]


@pytest.mark.parametrize(("key", "entry"), EQS)
def test_an_equation_is_implemented_argued_or_missing(key, entry):
    assert entry["status"] in ("implemented", "argued", "missing")
    assert entry["what"].strip()
    if entry["status"] == "argued":
        assert entry["note"].strip()
    if entry["status"] == "missing":
        assert not entry.get("code")
        assert not entry.get("test")


# What a printed string means.


@pytest.mark.parametrize(
    ("printed", "value", "half"),
    [
        ("0.601", 0.601, 0.0005),
        ("0.610", 0.61, 0.0005),  # the zero was printed: it counts
        ("11.6", 11.6, 0.05),
        ("80", 80.0, 0.5),
        ("3500", 3500.0, 0.5),
        ("-1.62", -1.62, 0.005),
        ("−1.62", -1.62, 0.005),  # the printer's minus
        ("+2", 2.0, 0.5),
        ("1.4×10^-5", 1.4e-5, 5e-7),
        ("1.4 × 10^−5", 1.4e-5, 5e-7),
        ("1.41x10^-3", 1.41e-3, 5e-6),
        ("2.06e5", 2.06e5, 500.0),
        ("1×10^3", 1000.0, 500.0),
        ("0", 0.0, 0.5),
        (" 5 ", 5.0, 0.5),
    ],
)
def test_a_printed_string_is_a_number_with_a_last_digit(printed, value, half):
    assert number(printed) == value
    assert half_last_digit(printed) == pytest.approx(half, rel=1e-15)


@pytest.mark.parametrize(
    "printed",
    ["", "about 5", "5 mm", "5,5", "1 000", "1e", ".5", "5.", "0x10", "nan", "inf", "1/2"],
)
def test_what_is_no_printed_number_is_refused(printed):
    with pytest.raises(ValueError, match="is not a printed number"):
        number(printed)


@fixed
@given(st.integers(-99999, 99999), st.integers(0, 6))
def test_the_last_digit_is_where_the_print_ends(digits, decimals):
    printed = f"{digits / 10**decimals:.{decimals}f}"
    assert number(printed) == pytest.approx(digits / 10**decimals, rel=1e-12)
    assert half_last_digit(printed) == pytest.approx(0.5 / 10**decimals)


# What the model refuses.

VALUE = {
    "id": "k", "what": "stiffness", "printed": "0.601", "value": 0.601, "unit": "N/mm",
    "kind": "theory", "role": "result", "place": "Table 1",
}  # fmt: skip


def test_uncertainty_of_a_printed_value_is_half_its_last_digit_over_root_three():
    assert Value(**VALUE).standard_uncertainty == pytest.approx(0.0005 / math.sqrt(3), rel=1e-15)
    assert Value(**VALUE, approximate=True).standard_uncertainty is None


@pytest.mark.parametrize(
    ("change", "message"),
    [
        pytest.param({"value": 0.602}, "is not the printed", id="another value"),
        pytest.param({"value": 601.0}, "is not the printed", id="in another unit"),
        pytest.param({"printed": "about 0.6"}, "is not a printed number", id="no number"),
        pytest.param({"kind": "guess"}, "kind", id="another kind"),
        pytest.param({"role": "guess"}, "role", id="another role"),
        pytest.param({"place": " "}, "place", id="no place"),
        pytest.param({"unit": ""}, "unit", id="no unit"),
        pytest.param({"id": "a:b"}, "id", id="a colon in the id"),
        pytest.param({"colour": "red"}, "colour", id="unknown key"),
    ],
)
def test_a_value_that_is_not_what_it_says_is_refused(change, message):
    with pytest.raises(ValidationError, match=message):
        Value(**VALUE | change)


def changed(kind, index, **change):
    """Belcin's file with one entry changed; None removes it."""
    raw = RAW["belcin"] | {kind: list(RAW["belcin"][kind])}
    if change:
        raw[kind][index] = raw[kind][index] | change
    else:
        del raw[kind][index]
    return raw


@pytest.mark.parametrize(
    ("raw", "message"),
    [
        pytest.param(changed("equations", 4), "needs Eqs. 1 to 21", id="an equation left out"),
        pytest.param(changed("equations", -1), "needs Eqs. 1 to 21", id="the last one left out"),
        pytest.param(changed("equations", 1, number=1), "needs Eqs. 1 to 21", id="one twice"),
        pytest.param(changed("equations", 0, status="implemented", code="", test=""),
                     "name its code and its test", id="implemented without code"),
        pytest.param(changed("equations", 0, status="implemented", code="analytic", test=""),
                     "name its code and its test", id="implemented without test"),
        pytest.param(changed("equations", 0, status="argued", code="", test="", note=""),
                     "give the argument", id="argued without argument"),
        pytest.param(changed("equations", 0, status="missing", code="analytic", test=""),
                     "yet names code or a test", id="missing with code"),
        pytest.param(changed("equations", 0, status="done"), "status", id="another status"),
        pytest.param(changed("errata", 1, id=RAW["belcin"]["errata"][0]["id"]), "used twice",
                     id="an erratum twice"),
        pytest.param(changed("errata", 0, evidence=""), "evidence", id="no evidence"),
        pytest.param(changed("errata", 0, right=""), "right", id="no right form"),
        pytest.param(changed("errata", 0, proof="x"), "proof", id="unknown key"),
        pytest.param(RAW["belcin"] | {"values": RAW["belcin"]["values"] * 2}, "used twice",
                     id="a value twice"),
    ],
)  # fmt: skip
def test_a_ledger_with_a_hole_is_refused(raw, message):
    Paper.model_validate(RAW["belcin"])
    with pytest.raises(ValidationError, match=message):
        Paper.model_validate(raw)
