"""Every case at the printed inputs: rows follow from their data, formulas have no tie.

No formula decides anything by the last bits of its inputs: every input is moved by some 1e-13 of
itself. Values follow by as much as they are ill-conditioned. What moves further stands at a tie:
a search, a branch or a count that another processor decides otherwise.
"""

import math
import re
from functools import cache

import pytest

from tests.verify.rows_again import assert_the_same
from verify.answers.answer import Verdict
from verify.answers.console import headline, limits
from verify.answers.keys import identifier
from verify.answers.registry import RULES, answer
from verify.answers.usual import unusual
from verify.audit.portable.perturbation import perturbed
from verify.cases.registry import CASES, QUICK
from verify.core.references import Method
from verify.core.source_code import parts_of
from verify.judging.explain.steps import steps

BOUND = 1e-8  # of a value's scale: a condition of 1e5

# The scale of values that are zero, or small differences of much larger ones: a number or the key
# of another value.
SCALES = (
    ("polyhedral-ring", r"uncertainty of .*", 1.0),  # shares of the loads that a fit leaves
    ("spring-width", r"uncertainty of .*", 1.0),
    ("rotor-clutch", r"K_xz_.*", "K_xx"),
    ("rotor-step", r"uncertainty of .*", 1.0),  # relative errors
)
# Values that move further, and why that is no tie.
FLAT = "where a smooth maximum lies: its place is found to the root of what its value is found to"
SAMPLED = "of a path at so many times; one more of them moves all by a step, 1/240 of a cycle"
FURTHER = (
    ("contact-flat", r"z_disc", 1e-6, FLAT),
    ("contact-sphere", r"z_.*", 1e-6, FLAT),
    ("freewheel-paths", r"(slip|when|peak|safety)_\d|F_2", 1e-3, SAMPLED),
)
# Keys that only the papers' inputs have, which moved ones are no longer.
PAPER_ONLY = ("rotor-system", "sprag-clutch", "sprag-crown", "spring-curve", "spring-map")
# Levels of the others take two minutes to solve, and `make verify` judges all.
SOLVED = [
    pytest.param(case, id=case.id, marks=[] if case.id in QUICK else pytest.mark.soak)
    for case in CASES
]


EVERY = pytest.mark.parametrize("case", CASES, ids=lambda case: case.id)


@cache
def values_of(case):
    return dict(case.analytic(case.inputs()))


@pytest.mark.parametrize("case", SOLVED)
def test_every_row_of_the_paper_follows_from_what_it_keeps(case, judged):
    result = judged(case)
    assert not result.errors  # of figures, tables and texts too
    for row in result.rows:
        assert_the_same(row)
        label, words = steps(row)[-1]
        assert label == "verdict"
        assert words.startswith(row.status.value)


@EVERY
def test_every_case_answers_with_sources_reasons_and_keys_on_usual_inputs(case):
    q = case.inputs()
    assert unusual(q) == {}
    found = answer(case, q, values_of(case))
    assert all(c.source and c.what for c in found.criteria)
    assert found.verdict is Verdict.HOLDS or found.reasons or found.limiting.margin < 1
    assert headline(case.id, found, ())[0].startswith(f"{case.id}: {found.verdict}")
    assert (found.design is None) == (RULES[case.id].design == "")
    assert len(limits(found)) == len(found.criteria)
    keys = [identifier(o.key) for o in case.outputs]
    assert all(key.isidentifier() and key.isascii() for key in keys)
    assert len(set(keys)) == len(keys)


def found(table, case, key):
    """The entry of the table for a value, if there is one."""
    return next((one for one in table if one[0] == case and re.fullmatch(one[1], key)), None)


def excess(case, values, other):
    """Values whose movement exceeds their bound, each with the share of its scale."""
    beyond = {}
    for key in values.keys() & other.keys():
        here, there = float(values[key]), float(other[key])
        if here == there or (math.isnan(here) and math.isnan(there)):
            continue
        scaled, further = found(SCALES, case, key), found(FURTHER, case, key)
        scale = scaled[2] if scaled else abs(here)
        if isinstance(scale, str):
            scale = abs(values[scale])
        share = abs(there - here) / scale if scale else math.inf
        if not share <= (further[2] if further else BOUND):
            beyond[key] = f"{share:.1e}: {here!r} and {there!r}"
    return beyond


@EVERY
def test_formulas_change_by_no_more_than_their_inputs_cause(case):
    values = values_of(case)
    inputs = perturbed(case.inputs(), seed=1, fixed=("shafts[1].ratio",))  # 1, by a rule
    other = dict(case.analytic(case.inputs.model_validate(inputs)))
    assert other.keys() <= values.keys()
    assert other.keys() == values.keys() or case.id in PAPER_ONLY
    assert excess(case.id, values, other) == {}


def test_every_case_whose_reference_uses_no_finite_elements_is_known():
    """By the modules that its reference runs; struts between rigid hubs are no elements."""
    bare = {
        case.id for case in CASES
        if not any(
            name.startswith("fem.") and not name.startswith("fem.rotor.struts")
            for name in parts_of(case.reference)[1]
        )
    }  # fmt: skip
    assert bare
    assert bare <= {case.id for case in CASES if case.method != Method()}
