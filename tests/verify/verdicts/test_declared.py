"""Declarations: complete, existing rows, safe sides of the cases; and design ranges."""

from types import SimpleNamespace

import numpy as np
import pytest

from verify.app.explain import row_ids
from verify.cases.registry import find
from verify.core import units
from verify.core.inputs import meta
from verify.core.verdicts import Form, Safe
from verify.papers.ledger import papers
from verify.papers.numbers import numbers
from verify.verdicts import design
from verify.verdicts.declared import declared

SIDES = {Safe.ABOVE: "too high", Safe.BELOW: "too low"}
FORMULAS = [(key, f) for key, each in declared().items() for f in each.formulas]
CASES = sorted({row.partition("/")[0] for _, f in FORMULAS for row in f.rows})


def test_each_erratum_about_an_equation_is_declared_there():
    """As one that changes its number, or as notation: none is dropped."""
    for paper in papers():
        for erratum in paper.errata:
            for number in numbers(erratum.place):
                forms = declared()[paper.key].of(number)
                listed = [e for f in forms for e in f.errata + f.notation]
                assert erratum.id in listed, (paper.key, number)


@pytest.mark.slow("formulas of many cases are evaluated to name their rows")
@pytest.mark.parametrize("case_id", CASES)
def test_rows_exist_and_agree_with_their_case_on_form_and_safe_side(case_id):
    case = find(case_id)
    known = set(row_ids(case, case.inputs(), paper=True))
    keys = {f"{case_id}/{check.name}": getattr(check, "analytic", "")
            for check in case.checks if hasattr(check, "name")}  # fmt: skip
    quantities = {q.name: q for q in case.inputs.quantities()}
    for _, f in FORMULAS:
        for row in (r for r in f.rows if r.startswith(f"{case_id}/")):
            assert row in known
            quantity = quantities.get(keys.get(row, ""))
            if quantity is None:
                continue
            if quantity.safe and f.safe is not Safe.NEITHER:
                assert quantity.safe == SIDES[f.safe], (f.name, f.form, row)
            if quantity.form == "as printed":
                assert f.form is Form.PRINTED, (f.name, row)


# Design ranges


def dimensions(case, name):
    return dict(units.dimensions(meta(find(case).inputs.model_fields[name])["unit"]))


def test_a_design_range_contains_the_value_of_its_input_and_a_ratio_has_no_dimension():
    for entry in design.declared():
        axis = design.axis_of(entry)
        low, high = axis.values
        assert low <= axis.nominal <= high, entry
        if entry.ratio:
            left = dimensions(entry.case, axis.name)
            for name, power in entry.per.items():
                for base, exponent in dimensions(entry.case, name).items():
                    left[base] = left.get(base, 0) - power * exponent
            assert all(abs(exponent) < 1e-12 for exponent in left.values()), entry


def test_the_solved_points_of_a_study_span_a_range_from_end_to_end():
    for case_id, values, solved, spanned in (
        ("ring-loads-outer", (0.022, 0.045), True, True),
        ("ring-loads-outer", (0.022, 0.045), False, False),
        ("ring-loads-outer", (0.0221, 0.045), True, False),
        ("ring-loads-outer", (0.022, 0.0449), True, False),
        ("ring-loads", (0.022, 0.045), True, False),
    ):
        error = np.where([solved or k == 0 for k in range(len(values))], 0.01, np.nan)
        plan = SimpleNamespace(
            case=SimpleNamespace(id=case_id), axes=[SimpleNamespace(name="r_o")],
            points=np.array(values)[:, None],
        )  # fmt: skip
        study = plan, SimpleNamespace(error=error, U_error=np.zeros(len(values)))
        n, r_o = design.design(["ring-loads-outer"], [study])
        assert (n.spanned, r_o.spanned) == (False, spanned)  # n was not varied
        assert (r_o.side.ratio, r_o.side.ratio_ends) == ("r_o/r_i", (1.13, 2.31))
        assert (r_o.side.low, r_o.side.high) == (22.0, 45.0)


def test_each_case_that_errors_over_a_range_are_taken_from_has_a_design_range():
    cases = {
        row.partition("/")[0] for d in declared().values() for f in d.formulas for row in f.part
    }
    ranged = {entry.case for entry in design.declared()}
    assert {case for case in cases - ranged if find(case).scans} == set()
