"""Design ranges: each of an input that exists, dimensionless where it says so, spanned or not."""

from types import SimpleNamespace

import pytest

from verify.cases.registry import find
from verify.core import units
from verify.core.inputs import meta
from verify.verdicts import design
from verify.verdicts.declared import declared

ENTRIES = design.declared()


@pytest.mark.parametrize("entry", ENTRIES, ids=lambda e: f"{e.case}: {e.ends}")
def test_a_range_is_of_an_input_of_its_case_and_holds_the_case_s_own_value(entry):
    axis = design.axis_of(entry)
    low, high = axis.values
    assert axis.nominal is not None
    assert low <= axis.nominal <= high


def dimensions(case, name):
    return dict(units.dimensions(meta(find(case).inputs.model_fields[name])["unit"]))


@pytest.mark.parametrize(
    "entry", [e for e in ENTRIES if e.ratio], ids=lambda e: f"{e.case}: {e.ratio}"
)
def test_a_ratio_has_no_dimension(entry):
    left = dimensions(entry.case, design.axis_of(entry).name)
    for name, power in entry.per.items():
        for base, exponent in dimensions(entry.case, name).items():
            left[base] = left.get(base, 0) - power * exponent
    assert all(abs(exponent) < 1e-12 for exponent in left.values()), left


def plan(case, *axes):
    """A study of a case that varies inputs, each between two values [SI]."""
    return SimpleNamespace(
        case=SimpleNamespace(id=case),
        axes=[SimpleNamespace(name=name, values=values) for name, *values in axes],
    )


@pytest.mark.parametrize(
    ("low", "high", "spanned"),
    [(0.02, 0.02623, False), (0.022, 0.045, True), (0.0221, 0.045, False), (0.022, 0.0449, False)],
)
def test_a_study_spans_a_range_from_end_to_end(low, high, spanned):
    found = design.design(["ring-loads-outer"], [plan("ring-loads-outer", ("r_o", low, high))])
    assert [one.spanned for one in found] == [False, spanned]  # n was not varied
    (other,) = design.design(["sprag-wedge"], [plan("x", ("T", 0, 100))])[:1]
    assert not other.spanned


def test_a_side_has_its_dimensionless_ends():
    (_, r_o) = design.design(["ring-loads-outer"], [])
    assert (r_o.side.ratio, r_o.side.ratio_ends) == ("r_o/r_i", (1.13, 2.31))
    assert (r_o.side.low, r_o.side.high) == (22.0, 45.0)


def test_each_case_that_errors_over_a_range_are_taken_from_has_a_design_range():
    cases = {
        row.partition("/")[0] for d in declared().values() for f in d.formulas for row in f.part
    }
    ranged = {entry.case for entry in ENTRIES}
    assert {case for case in cases - ranged if find(case).scans} == set()
