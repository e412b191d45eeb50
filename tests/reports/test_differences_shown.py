"""Differences and references on the page, in the PDF and in the workbook."""

import math
import re

import numpy as np
import pytest

from reports.formats import difference, fraction, tolerance, values
from reports.plots import profile
from reports.signature import position
from verify.cases.registry import find
from verify.core.figures import Profile
from verify.core.references import reference_name
from verify.core.results import Kind


@pytest.fixture
def ends(of_paper):
    """A row whose formula and reference are negative, the formula being the smaller magnitude."""
    rows = of_paper(find("contact-roller-end")).rows
    return next(row for row in rows if row.quantity.startswith("sharpness of a right-angled edge"))


@pytest.fixture
def others(of_paper):
    """The compared rows of a case with other references than finite elements."""
    return [r for r in of_paper(find("rotor-clutch")).rows if r.kind is Kind.APPROXIMATION]


def plain(markup):
    return re.sub("<[^>]*>", "", str(markup)).replace("−", "-").replace("\u202f", " ")


def test_a_negative_row_lies_in_its_interval_on_the_page(ends):
    assert ends.reference < ends.analytic < 0
    assert plain(difference(ends)) == "-0.063 %"
    low, high = (float(end.removesuffix(" %")) for end in plain(tolerance(ends)).split(" to"))
    assert low < -0.063 < high
    assert -1 < position(ends) < 1


def test_every_other_reference_is_named_beside_its_value(others):
    for row in others:
        name = reference_name(row)
        shown = values(row)
        assert shown.by == ("" if name == "FE" or name.startswith("printed") else name), row.id
    assert any(values(row).by for row in others)


def test_fractions_are_percents_and_balances_are_numbers(of_paper):
    rows = of_paper(find("ring-lame")).rows
    identity = next(row for row in rows if row.kind is Kind.IDENTITY)
    balance = next(row for row in rows if row.kind is Kind.EXACT)
    assert plain(fraction(identity, 0.0123)) == "1.2 %"
    assert plain(fraction(identity, 1.23e-9)) == "1.2×10-7 %"
    assert plain(fraction(balance, 1.23e-9)) == "1.2×10-9"
    assert plain(fraction(identity, math.inf)) == "–"


def test_the_lower_part_of_a_profile_is_formula_less_reference():
    x = np.array([0.0, 1.0])
    curve = Profile(title="p", x_label="x", y_label="p", x=x, y=x, x_fem=x, y_fem=x - 1.0,
                    y_ref=x, u=np.zeros(2), scale=1.0)  # fmt: skip
    dots = [float(y) for y in re.findall(r'cy="([\d.]+)"', str(profile(curve)))][-2:]
    assert max(dots) < 233  # above the line of zero, in the middle of 204 and 262
