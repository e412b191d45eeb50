"""Inputs of a user: the template of a case with changed values, in the form of a file."""

from functools import cache

import numpy as np

from tests.verify.template_text import inputs_of
from verify.answers.template import template
from verify.core.inputs import build


@cache
def printed(case):
    """The raw inputs of the case's template, but those that may be unknown, such as a strength."""
    fields = case.inputs.model_fields
    raw = inputs_of(template(case))
    return {key: value for key, value in raw.items() if fields[key].default is not None}


def own(case, **changes):
    return build(case.inputs, printed(case) | changes, "my.toml")


def state(case, **changes):
    """Inputs, values and warnings of a part; its values are finite and its texts can be made."""
    q = own(case, **changes)
    with np.errstate(over="raise", divide="raise", invalid="raise"):  # as the command does
        values = case.analytic(q)
    assert all(np.isfinite(value) for value in values.values())
    case.equations(q, values)
    case.sketch(q)
    warned = case.warnings(q, values)
    assert all("\n" not in line for line in warned)
    return q, values, warned
