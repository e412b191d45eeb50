"""No formula decides anything by the last bits of its inputs.

Every input of every case is moved by 1e-13 of itself, up or down as drawn. Values follow by as much
as they are ill-conditioned, the difference of two near lengths by some 1e4 times that. What moves
further stands at a tie: a search, a branch or a count that another processor decides otherwise.
"""

import math
import re

import numpy as np
import pytest
from pydantic import ValidationError

from verify.cases.registry import CASES

SHIFT = 1e-13  # of an input: some hundred times its last bit
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


def moved(inputs, rng):
    """The inputs, each 1e-13 larger or smaller; the other way, or as it is, at a limit."""
    for name in type(inputs).model_fields:
        value, sign = getattr(inputs, name), rng.choice([-1.0, 1.0])
        for shift in (sign * SHIFT, -sign * SHIFT):
            if isinstance(value, tuple):
                other = tuple(moved(entry, rng) for entry in value)
            elif isinstance(value, float):
                other = value * (1 + shift)
            else:
                break
            fields = {key: getattr(inputs, key) for key in type(inputs).model_fields}
            try:
                inputs = type(inputs)(**fields | {name: other})
                break
            except ValidationError:
                continue
    return inputs


def found(table, case, key):
    """The entry of the table for a value, if there is one."""
    for entry in table:
        if re.fullmatch(entry[0], case) and re.fullmatch(entry[1], key):
            return entry
    return None


def excess(case, values, other):
    """Values whose movement exceeds their bound, each with the share of its scale."""
    beyond = {}
    for key in values.keys() & other.keys():
        here, there = float(values[key]), float(other[key])
        if here == there or (math.isnan(here) and math.isnan(there)):
            continue
        scaled, further = found(SCALES, case, key), found(FURTHER, case, key)
        scale = abs(here)
        if scaled:
            scale = abs(values[scaled[2]]) if isinstance(scaled[2], str) else scaled[2]
        share = abs(there - here) / scale if scale else math.inf
        if not share <= (further[2] if further else BOUND):
            beyond[key] = f"{share:.1e}: {here!r} and {there!r}"
    return beyond


@pytest.mark.parametrize("seed", [0, *(pytest.param(n, marks=pytest.mark.soak) for n in (1, 2))])
@pytest.mark.parametrize("case", CASES, ids=lambda case: case.id)
def test_formulas_move_no_further_than_their_inputs_let_them(case, seed):
    inputs = case.inputs()
    values = dict(case.analytic(inputs))
    other = dict(case.analytic(moved(inputs, np.random.default_rng(seed))))
    assert other.keys() <= values.keys()
    assert other.keys() == values.keys() or case.id in PAPER_ONLY
    assert excess(case.id, values, other) == {}
