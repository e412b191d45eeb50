"""Figures of freewheels, sprag clutches and slip: finite numbers, profiles within their bands."""

import numpy as np
import pytest

from tests.verify.cases.rows import context
from verify.cases.registry import CASES
from verify.core.figures import Profile

DRAWN = [case for case in CASES if case.id.startswith(("freewheel-", "sprag-", "contact-slip"))]


@pytest.mark.parametrize("case", DRAWN, ids=lambda case: case.id)
def test_figures_have_finite_numbers_and_profiles_lie_within_their_bands(case):
    of = context(case)
    figures = case.figures(of)
    assert figures
    for figure in figures:
        if isinstance(figure, Profile) and not figure.neglects:
            assert np.all(np.abs(figure.y_fem - figure.y_ref) <= 2 * figure.u), figure.title
        for curve in getattr(figure, "curves", ()):
            assert np.isfinite(curve.x).all(), figure.title
            assert not np.isinf(curve.y).any(), figure.title
    assert case.sketch(of.inputs).shapes
    assert case.equations(of.inputs, of.analytic)
    case.tables(of)
