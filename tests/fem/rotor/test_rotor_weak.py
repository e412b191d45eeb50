"""Shafts as weak forms; peaks of responses; sets of springs with equal critical speeds."""

import numpy as np
import pytest
from skfem import MeshLine

from analytic.rotor.shafts import UniformShaft, hutchinson
from fem.rotor.ensemble import Ranges, elasticities, ensemble
from fem.rotor.parts import Element, Material
from fem.rotor.peaks import above_chord, peaks, spread_ratios
from fem.rotor.weak import weak_shaft
from fem.rotor.whirl_systems import Discs, Springs, WhirlSystems

E, NU, RHO, L = 210e9, 0.3, 7850.0, 0.6
SPEED = 2000.0


def uniform(d):
    return UniformShaft(L=L, d_o=d, E=E, nu=NU, rho=RHO, kappa=hutchinson(nu=NU))


def weak(s, cells, theory="timoshenko"):
    mesh = MeshLine(np.linspace(0, s.L, cells + 1))
    return weak_shaft(
        mesh, bending=E * s.I, shear=s.S, mass=RHO * s.A, rotary=RHO * s.I, theory=theory
    )  # fmt: skip


@pytest.mark.parametrize(
    ("theory", "d"), [("euler", 0.018), ("rayleigh", 0.2), ("timoshenko", 0.2)]
)
def test_whirl_converges_to_the_closed_form_at_order_four(theory, d):
    s = uniform(d)
    exact = np.array([s.whirl(j, Omega=SPEED, theory=theory) for j in (1, 2, 3)]).T
    errors = np.array([
        np.array(weak(s, cells, theory).whirl(SPEED, held=[0, L])) / exact - 1
        for cells in (8, 16, 32)
    ])  # fmt: skip
    assert np.all(errors > 0)
    assert np.log2(errors[1] / errors[2]) == pytest.approx(np.full((2, 3), 4), abs=0.1)
    assert errors[2, :, 0] == pytest.approx(0, abs=3e-7)


def test_splitting_has_as_many_digits_at_a_low_speed_where_a_difference_has_four():
    own = weak(uniform(0.06), 16)
    slow, fast = 1e-4, 1.0
    expected = own.splitting(fast, held=[0, L]) * slow / fast
    assert own.splitting(slow, held=[0, L]) == pytest.approx(expected, rel=1e-9)
    forward, backward = own.whirl(slow, held=[0, L])
    assert abs((forward - backward) / expected - 1).max() > 1e-7


def test_a_stout_shaft_on_springs_bounces_and_rocks_as_if_rigid():
    """Two springs k at the ends: w^2 = 2 k/m, and k L^2/2 over m L^2/12 + rho I L."""
    s, k = uniform(0.2), 1e3
    found = weak(s, 8).on_springs({0.0: k, L: k}).whirl(0.0, count=2)[0]
    m = RHO * s.A * L
    rocking = np.sqrt(k * L**2 / 2 / (m * L**2 / 12 + RHO * s.I * L))
    assert found == pytest.approx([np.sqrt(2 * k / m), rocking], rel=1e-5)


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"theory": "bernoulli"}, "theory must be one of timoshenko, rayleigh"),
        ({"shear": 0.0}, "shear must be positive"),
        ({"mass": np.nan}, "mass must be positive"),
    ],
)
def test_what_makes_no_sense_is_refused(wrong, message):
    right = {"bending": 1.0, "shear": 1.0, "mass": 1.0, "rotary": 1.0}
    with pytest.raises(ValueError, match=message):
        weak_shaft(MeshLine(np.linspace(0, 1, 3)), **(right | wrong))
    with pytest.raises(ValueError, match=r"no node at z=0\.31"):
        weak(uniform(0.05), 4).whirl(0.0, held=[0.31])


def test_what_is_above_a_chord_counts_the_spacing_of_unbalances():
    u = np.array([1.0, 2.0, 5.0])
    line = (3 + 2 * u)[:, None, None]  # f = 3 + 2u: 5, 7, 13
    assert above_chord(line, u) == pytest.approx(0, abs=1e-15)
    assert above_chord(line * [[[1]], [[1.1]], [[1]]], u) == pytest.approx(0.1, rel=1e-12)
    assert above_chord(u[:, None, None] ** 2, u) < -0.4  # 4 against a chord of 7


def test_a_flank_at_an_end_is_no_peak():
    assert np.isnan(peaks(np.array([3.0, 2.0, 1.0, 2.0])))
    assert peaks(np.array([9.0, 2.0, 5.0, 2.0, 7.0])) == 5.0


def test_damping_ratios_differ_as_by_rayleigh_damping():
    zeta = spread_ratios(0.005, 0.03, 2.0, 200)
    apart = zeta[:, 1] / zeta[:, 0]
    assert np.all((apart < 2) & (apart > 0.5))
    # even over the square of logarithms: each of 16 parts has about a sixteenth of the ratios
    place = np.log(spread_ratios(0.005, 0.03, 1e9, 1024) / 0.005) / np.log(6)
    counts, *_ = np.histogram2d(*place.T, bins=4, range=[[0, 1]] * 2)
    assert np.all(abs(counts - 64) <= 6)
    assert np.median(zeta[:, 0]) == pytest.approx(np.sqrt(0.005 * 0.03), rel=0.02)


STEEL = Material(210e9, 0.3, 7850.0)
RANGES = Ranges(np.array([1e6, 1e6]), np.array([1e8, 1e8]))


def systems(k):
    """A shaft with a disc on two bearings of the stiffness k (m, 2) [N/m]."""
    one = np.ones((len(k), 2))
    return WhirlSystems(
        nodes=3, first=(0, 1), length=0.1 * one, d_o=0.03 * one, d_i=0.0 * one, material=STEEL,
        kappa=np.full(2, Element(1.0, 1.0, 0.0, STEEL).kappa),
        springs=(Springs(0, None, k[:, 0]), Springs(4, None, k[:, 1])),
        discs=(Discs(1, one[:, 0], 1e-3 * one[:, 0], 5e-4 * one[:, 0]),),
    )  # fmt: skip


def test_every_member_has_the_speed_and_lies_in_the_ranges():
    wanted = float(systems(np.array([[8e6, 2e7]])).critical_speeds(1)[0][0, 0])
    found = ensemble(RANGES, (wanted,), systems, 5, seed=1)
    assert len(found.members) == found.kept.sum() >= 5
    assert systems(found.members).critical_speeds(1)[0] == pytest.approx(wanted, rel=2e-8)
    assert ((found.members >= RANGES.low) & (found.members <= RANGES.high)).all()
    assert not (found.kept & ~found.met).any()
    x = np.array([[0.0, 0.25], [0.5, 1.0]])
    assert RANGES.parameters(x)[1] == pytest.approx([1e7, 1e8])
    assert RANGES.places(RANGES.parameters(x)) == pytest.approx(x)
    k = np.array([[8e6, 2e7]])
    before, after = (systems(one).critical_speeds(1)[0][0, 0] for one in (k, k * [1.001, 1.0]))
    slope = np.log(after / before) / np.log(1.001)
    assert elasticities(RANGES, k, systems, 1)[0, 0, 0] == pytest.approx(slope, rel=1e-3)
