"""Limit points and snap-backs: a toggle, an arch and Lee's frame."""

from math import sqrt

import numpy as np
import pytest

from fem.beam.large import LargeFrame
from fem.beam.section import Section


def test_a_hinged_bar_snaps_through_at_its_closed_limit():
    """A bar from (0, 0) to a guide at (c, h): P = EA (1 - l / l_0) y / l while it stays straight.

    dP/dy = 0 at l^3 = c^2 l_0; the load comes back to zero in the horizontal.
    """
    c, h, EA = 4.0, 1.0, 50.0
    frame = LargeFrame(
        [(0, 0), (c, h)], [(0, 1)], sections=Section(EA=EA, EI=30, GA=1e3),
        supports={0: "xy", 1: "x"},
    )  # fmt: skip
    path = frame.along_arc({1: (0, -1, 0)}, first=0.02, until=lambda s: s.u[1, 1] < -2.2 * h)
    l_0 = sqrt(c * c + h * h)
    l_limit = (c * c * l_0) ** (1 / 3)
    y = sqrt(l_limit**2 - c * c)
    limit = EA * (1 - l_limit / l_0) * y / l_limit
    first, second = frame.buckling(path)
    assert first.limit
    assert second.limit
    assert first.factor == pytest.approx(limit, rel=1e-9)
    assert second.factor == pytest.approx(-limit, rel=1e-9)
    assert first.state.u[1, 1] == pytest.approx(y - h, rel=1e-5)
    at = h + path.u[:, 1, 1]
    length = np.hypot(c, at)
    np.testing.assert_allclose(path.factors, EA * (l_0 - length) / l_0 * at / length, atol=1e-10)
    np.testing.assert_allclose(path.strain_energy, EA * (length - l_0) ** 2 / l_0 / 2, rtol=1e-9)


def test_load_control_does_not_leap_over_a_limit_point():
    """A shallow sine arch under more than its limit load stands snapped through.

    Newton's method would find that state in a step or two; the path leads nowhere near it.
    """
    x, k = np.linspace(0, 1, 25), 2 * np.arange(12)
    points = np.column_stack([x, 0.1 * np.sin(np.pi * x)])
    elements = np.column_stack([k, k + 2, k + 1])
    frame = LargeFrame(
        points, elements, sections=Section(EA=2e3, EI=1.0, GA=2e3),
        supports={0: "xy", 24: "xy", 12: "x"},
    )  # fmt: skip
    path = frame.along_arc({12: (0, -1, 0)}, first=1.0, until=lambda s: s.u[12, 1] < -0.06)
    (point,) = frame.buckling(path)
    assert point.limit
    with pytest.raises(ArithmeticError, match=r"no equilibrium found beyond factor 10\.7\d* "):
        frame.under_loads({12: (0, -1, 0)}, [30.0])
    assert point.factor == pytest.approx(10.7, rel=0.01)


def test_lees_frame_snaps_back_at_its_published_load():
    """Hinged-hinged right-angled frame, 120 each, E = 720, A = 6, I = 2, load 24 from the corner.

    Lee, Manuel & Rossow, J. Eng. Mech. 94 (1968) 521-547; 1.8558 in Schweizerhof & Wriggers,
    Comput. Meth. Appl. Mech. Eng. 59 (1986) 261-279.
    """
    up, out = np.linspace(0, 120, 41), np.linspace(0, 120, 41)[1:]
    points = np.vstack([np.column_stack([0 * up, up]), np.column_stack([out, 0 * out + 120])])
    k, loaded, last = 2 * np.arange(40), 48, 80
    frame = LargeFrame(
        points, np.column_stack([k, k + 2, k + 1]),
        sections=Section(EA=4320.0, EI=1440.0, GA=1e6), supports={0: "xy", last: "xy"},
    )  # fmt: skip
    path = frame.along_arc(
        {loaded: (0, -1, 0)}, first=0.1, until=lambda state: state.u[loaded, 1] < -80
    )
    first, second = frame.buckling(path)
    assert first.limit
    assert second.limit
    assert first.factor == pytest.approx(1.8558, rel=2e-4)
    assert [path.negative[0], path.negative.max(), path.last.negative] == [0, 1, 0]
