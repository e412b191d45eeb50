"""Limit points and snap-backs: toggles, arches and Lee's frame beside exact references."""

from math import sqrt

import numpy as np
import pytest

from fem.beam.large import LargeFrame
from fem.beam.section import Section
from tests.fem.beam.large_reference import integrate, shoot


def chain(*members):
    """Nodes and quadratic elements of members given as functions of 0..1 and element counts."""
    points, elements = [np.asarray(members[0][0](0.0), float)], []
    for shape, count in members:
        first = len(points) - 1
        points += [np.asarray(shape(x), float) for x in np.linspace(0, 1, 2 * count + 1)[1:]]
        elements += [(first + 2 * k, first + 2 * k + 2, first + 2 * k + 1) for k in range(count)]
    return np.array(points), elements


def straight(a, b):
    a, b = np.asarray(a, float), np.asarray(b, float)
    return lambda x: a + x * (b - a)


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


def test_lees_frame_limits_are_those_of_reissners_equations():
    """Hinged-hinged right-angled frame, 120 each, E = 720, A = 6, I = 2, load 24 from the corner.

    Lee, Manuel & Rossow, J. Eng. Mech. 94 (1968) 521-547; as a benchmark of snap-back in
    Schweizerhof & Wriggers, Comput. Meth. Appl. Mech. Eng. 59 (1986) 261-279: about 1.8558.
    """
    section = Section(EA=4320.0, EI=1440.0, GA=1e6)
    points, elements = chain(
        (straight((0, 0), (0, 120)), 20), (straight((0, 120), (24, 120)), 4),
        (straight((24, 120), (120, 120)), 16),
    )  # fmt: skip
    loaded, last = 48, len(points) - 1
    frame = LargeFrame(points, elements, sections=section, supports={0: "xy", last: "xy"})
    path = frame.along_arc(
        {loaded: (0, -1, 0)}, first=0.1, until=lambda state: state.u[loaded, 1] < -80
    )
    first, second = frame.buckling(path)
    pieces = [(120, lambda s: np.pi / 2), (24, lambda s: 0.0), (96, lambda s: 0.0)]

    def load(moved, near):
        """Exact load at a displacement of the loaded point."""

        def missing(unknown):
            turned, H, V, P = unknown
            end, _, joints = integrate(
                pieces, [0, 0, turned, 0], (H, V), [(0, 0), (0, -P)], section
            )
            return [end[0] - 120, end[1] - 120, end[3] / 10, joints[1][1] - 120 - moved]

        turned = near.u[0, 2]
        x, y, _ = near.reactions[0]
        return shoot(missing, [turned, -x, -y, near.factor])[3]

    for point, published in ((first, 1.8558), (second, None)):
        assert point.limit
        at, h = point.state.u[loaded, 1], 0.2
        loads = [load(at + d, point.state) for d in (-h, 0.0, h)]
        extreme = loads[1] - (loads[2] - loads[0]) ** 2 / 8 / (loads[0] + loads[2] - 2 * loads[1])
        assert point.factor == pytest.approx(extreme, rel=2e-5)
        if published:
            assert extreme == pytest.approx(published, rel=2e-4)
    assert path.negative[0] == 0
    assert path.negative.max() == 1
    assert path.last.negative == 0


def test_load_control_does_not_leap_over_a_limit_point():
    """A shallow sine arch under more than its limit load stands snapped through.

    Newton's method would find that state in a step or two; the path leads nowhere near it.
    """
    points, elements = chain((lambda x: (x, 0.1 * np.sin(np.pi * x)), 12))
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
