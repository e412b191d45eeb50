"""Design ranges: each of an input that exists, dimensionless where it says so, spanned or not."""

from types import SimpleNamespace

import numpy as np
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


def study(case, name, values, solved=True):
    """A study of a case over one input [SI], with an answer at all values or at the first."""
    error = np.where([solved or k == 0 for k in range(len(values))], 0.01, np.nan)
    plan = SimpleNamespace(
        case=SimpleNamespace(id=case), axes=[SimpleNamespace(name=name)],
        points=np.array(values)[:, None],
    )  # fmt: skip
    return plan, SimpleNamespace(error=error, U_error=np.zeros(len(values)))


@pytest.mark.parametrize(
    ("values", "solved", "spanned"),
    [
        ((0.02, 0.02623), True, False), ((0.022, 0.045), True, True),
        ((0.022, 0.045), False, False), ((0.0221, 0.045), True, False),
        ((0.022, 0.0449), True, False),
    ],
)  # fmt: skip
def test_the_solved_points_of_a_study_span_a_range_from_end_to_end(values, solved, spanned):
    found = design.design(["ring-loads-outer"], [study("ring-loads-outer", "r_o", values, solved)])
    assert [one.spanned for one in found] == [False, spanned]  # n was not varied
    (other,) = design.design(["sprag-wedge"], [study("x", "T", (0, 100))])[:1]
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
