"""Cases of clutches, slip and wide springs: no row fails, and figures have finite numbers."""

import numpy as np
import pytest

from tests.verify.cases.rows import context, failed
from verify.cases.registry import CASES
from verify.core.figures import Profile

BEGIN = ("freewheel-", "sprag-", "contact-slip", "spring-width")
DRAWN = [case for case in CASES if case.id.startswith(BEGIN)]


@pytest.mark.parametrize("case", DRAWN, ids=lambda case: case.id)
def test_no_row_fails_figures_are_finite_and_profiles_lie_within_their_bands(case):
    of = context(case)
    assert not failed(case, of=of)
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
