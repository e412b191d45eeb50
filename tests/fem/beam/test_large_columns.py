"""Buckling of columns, and limit points of a toggle and of Lee's frame."""

from math import pi, sqrt

import numpy as np
import pytest
from scipy.optimize import brentq
from scipy.special import ellipe, ellipk

from fem.beam.large import LargeFrame
from fem.beam.section import Section

THIN = Section(EA=1e8, EI=1.0, GA=4e7)
THICK = Section(EA=150.0, EI=1.0, GA=60.0)
HALF_WAVES = {"hinged": 1.0, "clamped": 2.0, "free": 0.5}
ENDS = {"hinged": ("xy", "x"), "clamped": ("xyr", "xr"), "free": ("xyr", "")}
every_end = pytest.mark.parametrize("ends", ENDS)


def column(ends, section, count=24):
    """A column of length 1 along y, loaded on its last node; quadratic elements."""
    k, y = 2 * np.arange(count), np.linspace(0, 1, 2 * count + 1)
    foot, head = ENDS[ends]
    return LargeFrame(
        np.column_stack([0 * y, y]),
        np.column_stack([k, k + 2, k + 1]),
        sections=section,
        supports={0: foot, 2 * count: head},
    )


def critical(ends, section):
    """Load P at which the compressed column turns aside.

    The column, shortened to lambda = 1 - P/EA, leans by lambda phi + P phi / GA under the dead
    force: EI phi'' = -P (lambda + P/GA) phi. The smallest root of P (1 - P/EA + P/GA) = P_Euler.
    """
    euler = (HALF_WAVES[ends] * pi) ** 2 * section.EI
    return brentq(lambda P: P * (1 - P / section.EA + P / section.GA) - euler, 0, 2 * euler)


@pytest.mark.parametrize(
    ("ends", "section"), [("hinged", THICK), ("clamped", THIN), ("free", THICK)]
)
def test_the_bifurcation_is_reissners(ends, section):
    frame, P = column(ends, section), critical(ends, section)
    path = frame.under_loads({48: (0, -1, 0)}, [0.5 * P, 0.9 * P, 1.1 * P])
    assert path.negative.tolist() == [0, 0, 1]
    (point,) = frame.buckling(path)
    assert not point.limit
    assert point.factor == pytest.approx(P, rel=2e-5)
    np.testing.assert_allclose(path.u[:, :, [0, 2]], 0, atol=1e-12)


@every_end
def test_linearised_buckling_is_eulers(ends):
    loads, modes = column(ends, THIN).linear_buckling({48: (0, -1, 0)}, count=3)
    odd = np.array([1, 3, 5]) if ends == "free" else np.arange(1, 4)
    euler = (HALF_WAVES[ends] * odd * pi) ** 2
    if ends == "clamped":  # the second mode turns over in the middle: tan x = x, x = 4.4934
        euler = np.array([2 * pi, 2 * 4.493409458, 4 * pi]) ** 2
    np.testing.assert_allclose(loads, euler, rtol=4e-4)
    assert loads[0] == pytest.approx(euler[0], rel=4e-5)
    assert abs(modes[:, :, :2]).max() == pytest.approx(1.0)


def test_a_buckled_column_is_the_elastica():
    """P / P_Euler = (2 K(k) / pi)^2, middle moves k / K, the ends come 2 (1 - E/K) nearer.

    Also k = sin(rotation of the end / 2): Timoshenko & Gere, Theory of Elastic Stability, 2.7.
    """
    share = 1.3
    m = brentq(lambda m: (2 * ellipk(m) / pi) ** 2 - share, 1e-9, 1 - 1e-9, xtol=1e-15)
    frame = column("hinged", THIN, 40)
    _, modes = frame.linear_buckling({80: (0, -1, 0)})
    bent = frame.imperfect(modes[0], 1e-7)
    P = share * pi**2
    path = bent.along_arc({80: (0, -1, 0)}, first=8.0, until=lambda state: state.factor > P)
    near = path.states[-2]
    last = bent.under_loads({80: (0, -1, 0)}, [P - near.factor], since=near).last
    assert last.negative == 0
    error = 2e-5
    assert abs(last.u[40, 0]) == pytest.approx(np.sqrt(m) / ellipk(m), rel=error)
    assert -last.u[80, 1] == pytest.approx(2 * (1 - ellipe(m) / ellipk(m)), rel=error)
    assert np.sin(abs(last.u[0, 2]) / 2) ** 2 == pytest.approx(m, rel=error)


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
