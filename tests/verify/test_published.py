"""The ledgers: complete, consistent, with references to existing code and tests."""

import ast
import json
import math
import pkgutil
import re
import tomllib
from functools import cache
from pathlib import Path

import pytest
from pydantic import ValidationError

import verify
from reports.mathematics import tree
from verify.cases.registry import CASES, find
from verify.core import units
from verify.core.case import Context
from verify.core.inputs import meta
from verify.papers import ledger
from verify.papers.digits import half_last_digit, number
from verify.papers.entries import Value
from verify.papers.ledger import Paper, erratum, papers, published

ROOT = Path(verify.__file__).parent.parent
# How many equations and tables each paper numbers, counted in the papers.
EQUATIONS = {"huang2018": 22, "huang2022": 11, "nagler2021": 10, "wang2023": 13, "belcin": 21}
TABLES = {"huang2018": 2, "huang2022": 1, "nagler2021": 2, "wang2023": 1, "belcin": 0}
RAW = {
    key: tomllib.loads((Path(ledger.__file__).parent / f"{key}.toml").read_text("utf-8"))
    for key in EQUATIONS
}
DECIMALS, INTEGERS = r"\d+\.\d+", r"\b\d{2,}\b"


def test_every_numbered_equation_and_table_of_every_paper_has_an_entry():
    assert {path.stem for path in Path(ledger.__file__).parent.glob("*.toml")} == set(EQUATIONS)
    for paper in papers():
        assert [e.number for e in paper.equations] == [*range(1, EQUATIONS[paper.key] + 1)]
        assert [t.name for t in paper.tables] == [
            f"Table {i + 1}" for i in range(TABLES[paper.key])
        ]


def test_formulas_can_be_set_and_have_the_numbers_of_their_entries():
    """Decimals are those of the text; larger integers of an erratum those of its entry."""

    def numbers(pattern, tex):
        set_as = json.dumps(tree(tex), ensure_ascii=False)
        assert "\\" not in set_as, tex  # a command unknown to the converter stays as text
        return set(re.findall(pattern, tex))

    for raw in RAW.values():
        printed = {value["printed"].lstrip("-") for value in raw["values"]}
        for entry in raw["equations"]:
            assert numbers(DECIMALS, entry["tex"]) <= printed, entry["number"]
        for entry in raw["errata"]:
            assert entry["printed"] != entry["right"], entry["id"]
            both = f"{entry['printed']} {entry['right']}"
            for tex in filter(None, (entry.get("printed_tex"), entry.get("right_tex"))):
                assert numbers(DECIMALS, tex) <= set(re.findall(DECIMALS, both)), tex
                assert numbers(INTEGERS, tex) <= set(re.findall(r"\d+", both)), tex


def test_a_value_or_erratum_that_is_not_there_is_refused():
    for lookup in (published, erratum):
        for reference in ("wang2023:nothing", "nobody:b", "b"):
            with pytest.raises(KeyError):
                lookup(reference)


def test_a_default_that_claims_a_printed_value_is_that_value():
    for case in CASES:
        for name, field in case.inputs.model_fields.items():
            extra = meta(field)
            if not extra["claims"]:
                continue
            entry = published(extra["claims"])
            value = entry.value * units.factor(entry.unit)
            assert field.default == pytest.approx(value, rel=1e-15), (case.id, name)
            assert units.dimensions(entry.unit) == units.dimensions(extra["unit"])
            # a design that it found may be where we start, and a rig's range how far we load
            rig = entry.role == "limit" and entry.kind == "test"
            assert rig or entry.role in ("input", "result")


# Code and tests that the ledgers name


@cache
def names_in(path):
    """Functions of a test file."""
    return {n.name for n in ast.parse(path.read_text("utf-8")).body if hasattr(n, "name")}


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


def test_tests_rows_and_code_that_a_ledger_names_exist():
    for entry in (e for raw in RAW.values() for e in [*raw["equations"], *raw["errata"]]):
        if test := entry.get("test"):
            path, _, name = test.partition("::")
            if name:
                assert name.partition("[")[0] in names_in(ROOT / path), test
            else:
                assert test in rows(test.partition("/")[0]), test
        if entry.get("status") == "implemented":
            assert callable(pkgutil.resolve_name(entry["code"]))


# What a printed string means


def test_a_printed_string_is_a_number_with_a_last_digit():
    for printed, value, half in (
        ("0.610", 0.61, 0.0005),  # the zero was printed: it counts
        ("3500", 3500.0, 0.5),
        ("−1.62", -1.62, 0.005),  # the printer's minus
        ("1.4 × 10^−5", 1.4e-5, 5e-7),
        ("2.06e5", 2.06e5, 500.0),
    ):
        assert number(printed) == value
        assert half_last_digit(printed) == pytest.approx(half, rel=1e-15)


def test_what_is_no_printed_number_is_refused():
    for printed in ("", "about 5", "5,5", "5.", "nan", "1/2"):
        with pytest.raises(ValueError, match="must be a printed number"):
            number(printed)


# What the model refuses

VALUE = {
    "id": "k", "what": "stiffness", "printed": "0.601", "value": 0.601, "unit": "N/mm",
    "kind": "theory", "role": "result", "place": "Table 1",
}  # fmt: skip


def test_a_value_that_differs_from_its_printed_text_is_refused():
    # its uncertainty is half its last digit over the root of three
    assert Value(**VALUE).standard_uncertainty == pytest.approx(0.0005 / math.sqrt(3), rel=1e-15)
    assert Value(**VALUE, approximate=True).standard_uncertainty is None
    for change, message in (
        ({"value": 0.602}, "must equal the printed number"), ({"kind": "guess"}, "kind"),
        ({"place": " "}, "place"), ({"id": "a:b"}, "id"), ({"colour": "red"}, "colour"),
    ):  # fmt: skip
        with pytest.raises(ValidationError, match=message):
            Value(**VALUE | change)


def changed(kind, index, **change):
    """Belcin's file with one entry changed; without a change the entry is removed."""
    raw = RAW["belcin"] | {kind: list(RAW["belcin"][kind])}
    if change:
        raw[kind][index] = raw[kind][index] | change
    else:
        del raw[kind][index]
    return raw


EMPTY = {"code": "", "test": "", "note": ""}


def test_an_incomplete_ledger_is_refused():
    Paper.model_validate(RAW["belcin"])
    for raw, message in (
        (changed("equations", -1), "equations must be 1 to 21"),
        (changed("equations", 0, **EMPTY | {"status": "implemented"}),
         "status 'implemented' requires code and test"),
        (changed("equations", 0, **EMPTY | {"status": "argued"}), "requires a reason in note"),
        (changed("equations", 0, **EMPTY | {"status": "missing", "code": "analytic"}),
         "excludes code and test"),
        (changed("errata", 1, id=RAW["belcin"]["errata"][0]["id"]), "used twice"),
        (changed("errata", 0, evidence=""), "evidence"),
        (RAW["belcin"] | {"values": RAW["belcin"]["values"] * 2}, "used twice"),
    ):  # fmt: skip
        with pytest.raises(ValidationError, match=message):
            Paper.model_validate(raw)
