"""Straight and curved members by both linear solvers against integrals, statics and textbooks.

Straight elements are the solution of the beam's equations; chords of an arc converge at order 2,
curved elements at 4.
"""

from math import cos, pi, radians, sin

import numpy as np
import pytest

from fem.beam.curved import solve_curved_frame
from fem.beam.section import Section
from fem.beam.straight import solve_frame

L, EA, EI, GA = 3.0, 5000.0, 70.0, 900.0  # any
ROUND_OFF = 1e-10  # relative; 1e-16 times a condition number of about (elements)^4 = 1e4


def with_middles(points, elements, **problem):
    """`solve_curved_frame` on straight members: a middle node on every pair."""
    points, elements = np.asarray(points, float), np.asarray(elements)
    numbers = len(points) + np.arange(len(elements))
    return solve_curved_frame(
        np.vstack([points, points[elements].mean(axis=1)]), np.column_stack([elements, numbers]),
        **problem,
    )  # fmt: skip


both_solvers = pytest.mark.parametrize("solve", [solve_frame, with_middles])


def bar(count, angle):
    """Nodes 0 (clamped) to `count`, evenly along `angle` [deg]."""
    along = np.array([cos(radians(angle)), sin(radians(angle))])
    pairs = np.column_stack([np.arange(count), np.arange(1, count + 1)])
    return np.linspace(0, L, count + 1)[:, None] * along + [0.4, -0.7], pairs


def to_plane(along, across, angle):
    c, s = cos(radians(angle)), sin(radians(angle))
    return along * c - across * s, along * s + across * c


@pytest.mark.parametrize(
    ("angle", "count", "shear"), [(-110, 7, GA), (50, 2, np.inf)], ids=["Timoshenko", "Bernoulli"]
)
def test_a_uniform_load_along_and_across_moves_every_node_as_by_its_integrals(angle, count, shear):
    n, q = 7.0, 3.0
    points, pairs = bar(count, angle)
    s = solve_frame(
        points, pairs, sections={"bar": Section(EA=EA, EI=EI, GA=shear)},
        bodies={"bar": range(count)}, supports={0: "xyr"}, loads={},
        distributed=dict.fromkeys(range(count), to_plane(n, q, angle)),
    )  # fmt: skip
    for node, x in enumerate(np.linspace(0, L, count + 1)):
        stretch = n * (L * x - x**2 / 2) / EA
        bend = q * x**2 * (6 * L**2 - 4 * L * x + x**2) / (24 * EI)
        sink = bend + q * (L * x - x**2 / 2) / shear
        turn = q * x * (3 * L**2 - 3 * L * x + x**2) / (6 * EI)
        expected = (*to_plane(stretch, sink, angle), turn)
        assert s.u[node] == pytest.approx(expected, rel=ROUND_OFF, abs=1e-14)
    expected = (*to_plane(-n * L, -q * L, angle), -q * L**2 / 2)
    assert s.reaction(0) == pytest.approx(expected, rel=ROUND_OFF)
    # int N^2 / 2 EA with N = n (L - x), V likewise, M = q (L - x)^2 / 2
    energy = n**2 * L**3 / (6 * EA) + q**2 * L**3 / (6 * shear) + q**2 * L**5 / (40 * EI)
    assert s.strain_energy == pytest.approx(energy, rel=ROUND_OFF)
    assert s.potential_energy == pytest.approx(-energy, rel=ROUND_OFF)  # Clapeyron


@both_solvers
def test_a_built_in_end_that_settles_and_turns(solve):
    L, EI, s, sink, turn = 2.0, 30.0, 0.05, 0.01, 0.02  # s = EI / (GA L^2)
    f = solve(
        [(0, 0), (L / 2, 0), (L, 0)], [(0, 1), (1, 2)],
        sections=Section(EA=1e3, EI=EI, GA=EI / (s * L**2)),
        supports={0: "xyr", 2: {"x": 0.0, "y": sink, "r": turn}}, loads={},
    )  # fmt: skip
    # slope deflection: 12, 6, 4 + 12 s and 2 - 12 s over 1 + 12 s
    k = EI / (L * (1 + 12 * s))
    force = 12 * k * sink / L**2 - 6 * k * turn / L
    here = -6 * k * sink / L + (4 + 12 * s) * k * turn
    there = -6 * k * sink / L + (2 - 12 * s) * k * turn
    assert f.reaction(2) == pytest.approx((0, force, here), rel=ROUND_OFF, abs=1e-11)
    assert f.reaction(0) == pytest.approx((0, -force, there), rel=ROUND_OFF, abs=1e-11)
    # the supports' work is stored
    assert f.strain_energy == pytest.approx((force * sink + here * turn) / 2, rel=ROUND_OFF)
    assert f.potential_energy == f.strain_energy


STATICS = 1e-11  # of a load of 1; the worst seen is 1e-13
both_kinds = pytest.mark.parametrize("kind", ["straight", "curved"])


def cantilever(kind, count, ratio):
    """Inclined, of length 1, EI = 1, EA = GA = ratio; exact section forces and energy as well."""
    along, across, load = np.array([0.8, 0.6]), np.array([-0.6, 0.8]), np.array([1.0, 0.3])
    nodes = np.linspace(0, 1, 2 * count + 1)[:, None] * along
    problem = {
        "sections": Section(EA=ratio, GA=ratio, EI=1.0), "supports": {0: "xyr"},
        "loads": {2 * count: (*load, 0.0)},
    }  # fmt: skip
    k = np.arange(2 * count)
    if kind == "straight":
        s = solve_frame(nodes, np.column_stack([k, k + 1]), **problem)
    else:
        s = solve_curved_frame(nodes, np.column_stack([k, k + 2, k + 1])[::2], **problem)
    N, V = load @ along, load @ across
    exact = np.stack(np.broadcast_arrays(N, V, V * (1 - s.stations @ along)), axis=-1)
    return s, exact, V**2 / 6 + (N**2 + V**2) / (2 * ratio)


@both_kinds
@pytest.mark.parametrize("ratio", [1e6, 1e12])
def test_an_inclined_cantilever_carries_its_load_however_stiff(kind, ratio):
    s, exact, energy = cantilever(kind, 8, ratio)
    np.testing.assert_allclose(s.section_forces, exact, atol=STATICS)
    assert s.strain_energy == pytest.approx(energy, rel=STATICS)
    assert s.potential_energy == pytest.approx(-energy, rel=STATICS)
    assert s.reaction(0) == pytest.approx((-1, -0.3, 0.6 - 0.8 * 0.3), abs=STATICS)


@both_kinds
def test_what_is_too_stiff_to_be_resolved_is_refused(kind):
    with pytest.raises((ArithmeticError, ValueError)):
        cantilever(kind, 4, 1e17)


R = 1.5
THICK = Section(EA=300.0, EI=20.0, GA=100.0)  # every part counts
THIN = Section(EA=20e6, EI=20.0, GA=8e6)  # as of a strip 1/1000 of the radius thick
ORDER = {"chords": 2, "curves": 4}
SPREAD = 0.1  # of an order observed between 8 and 16 elements a quarter


def compliances(section):
    """R^3 / EI, R / EA and R / GA."""
    return R**3 / section.EI, R / section.EA, R / section.GA


def quarter_compliance(section):
    """Of a quarter built in at (0, R), for a force (x, y) and a couple on its end at (R, 0).

    At the angle t from the end M = (R sin t, R (1 - cos t), 1), N = (-sin t, cos t, 0) and
    V = (cos t, sin t, 0) for the three unit loads; int sin^2 = pi/4, int (1 - cos)^2 = 3 pi/4 - 2.
    """
    a, b, c = compliances(section)
    both = pi / 4 * (b + c)
    return np.array([
        [a * pi / 4 + both, a / 2 - b / 2 + c / 2, a / R],
        [a / 2 - b / 2 + c / 2, a * (3 * pi / 4 - 2) + both, a / R * (pi / 2 - 1)],
        [a / R, a / R * (pi / 2 - 1), a / R**2 * pi / 2],
    ])  # fmt: skip


def quarter(geometry, count, **problem):
    """From (R, 0) to (0, R); nodes 0 to `count` are its elements' ends."""
    phi = np.linspace(0, pi / 2, 2 * count + 1)
    points = R * np.column_stack([np.cos(phi), np.sin(phi)])
    k = np.arange(count)
    if geometry == "curves":
        points = np.vstack([points[::2], points[1::2]])
        return solve_curved_frame(points, np.column_stack([k, k + 1, count + 1 + k]), **problem)
    return solve_frame(points[::2], np.column_stack([k, k + 1]), **problem)


@pytest.mark.parametrize("section", [THICK, THIN], ids=["thick", "thin"])
@pytest.mark.parametrize("geometry", ORDER)
def test_the_end_of_a_quarter_moves_as_by_its_integrals(geometry, section):
    load = (1.0, -0.7, 0.4)
    errors = []
    for count in (8, 16):
        s = quarter(geometry, count, sections=section, supports={count: "xyr"}, loads={0: load})
        errors.append(np.linalg.norm(s.u[0] - quarter_compliance(section) @ load))
    assert np.log2(errors[0] / errors[1]) == pytest.approx(ORDER[geometry], abs=SPREAD)
