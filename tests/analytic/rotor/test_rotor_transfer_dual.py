"""Several shafts, response to unbalance and torsion, against lumped models and closed forms."""

import numpy as np
import pytest

from analytic.rotor.transfer_model import Disc, Link, Rotor, Segment, Shaft, Support
from analytic.rotor.transfer_modes import critical_speeds, modes, whirl_frequencies
from analytic.rotor.transfer_response import unbalance_response
from analytic.rotor.transfer_shapes import lines_of, mode_lines
from analytic.rotor.transfer_torsion import free_turns, torsional_frequencies

E, NU = 210e9, 0.3
LIGHT = 1e-4  # kg/m³: shafts without mass, exactly elastic


def light(lengths, d, ratio=1.0):
    segments = tuple(Segment(length=a, d_o=d, E=E, nu=NU, rho=LIGHT) for a in lengths)
    return Shaft(segments=segments, ratio=ratio)


DISCS = (
    Disc(node=1, mass=4.0, polar=0.03, diametral=0.016),
    Disc(node=3, mass=3.0, polar=0.01, diametral=0.02),
    Disc(node=4, mass=2.0, polar=0.004, diametral=0.005),
    Disc(node=5, mass=5.0, polar=0.05, diametral=0.026),
    Disc(node=6, mass=1.0, polar=0.002, diametral=0.002),
    Disc(node=0, mass=0.5, polar=0.001, diametral=0.001),
    Disc(node=2, mass=0.5, polar=0.001, diametral=0.001),
)
LINKS = (Link(a=1, b=4, kxx=3e7), Link(a=2, b=6, kxx=2e7, k_tilt=4e4, cxx=300.0))
SUPPORTS = (Support(node=0, kxx=5e7, cxx=900.0), Support(node=3, kxx=4e7, cxx=200.0, c_tilt=3.0))


def dual(ratio):
    """Seven stations, 0 to 3 on one shaft of unequal lengths and 4 to 6 on the other."""
    shafts = (light([0.2, 0.15, 0.25], 0.05), light([0.15, 0.1], 0.03, ratio))
    return Rotor(shafts=shafts, discs=DISCS, supports=SUPPORTS, links=LINKS, theory="euler")


def lumped(ratio):
    """M, G1 for one rad/s, K, C of the same with 14 unknowns (r, phi), written out here."""
    K, M, G, C = (np.zeros((14, 14)) for _ in range(4))
    spans = [(0, 0.2, 0.05), (1, 0.15, 0.05), (2, 0.25, 0.05), (4, 0.15, 0.03), (5, 0.1, 0.03)]
    for node, span, d in spans:
        k = np.array([[12, 6, -12, 6], [6, 4, -6, 2], [-12, -6, 12, -6], [6, 2, -6, 4.0]])
        k *= E * np.pi * d**4 / 64 / span**3 * np.outer(*2 * [[1, span, 1, span]])
        at = slice(2 * node, 2 * node + 4)
        K[at, at] += k
    for disc in DISCS:
        i = 2 * disc.node
        M[i, i], M[i + 1, i + 1] = disc.mass, disc.diametral
        G[i + 1, i + 1] = disc.polar * (1 if disc.node < 4 else ratio)
    for A, name, tilt in ((K, "kxx", "k_tilt"), (C, "cxx", "c_tilt")):
        for support in SUPPORTS:
            i = 2 * support.node
            A[i, i] += getattr(support, name)
            A[i + 1, i + 1] += getattr(support, tilt)
        for link in LINKS:
            for j, value in enumerate((getattr(link, name), getattr(link, tilt))):
                a, b = 2 * link.a + j, 2 * link.b + j
                A[a, a] += value
                A[b, b] += value
                A[a, b] -= value
                A[b, a] -= value
    return M, G, K, C


def eigenvalues(ratio, Omega):
    """All whirl frequencies, forward ones positive, of K + w Omega G1 - w² M."""
    M, G, K, _ = lumped(ratio)
    inverse = np.diag(1 / np.diag(M))
    none, one = np.zeros_like(M), np.eye(len(M))
    found = np.linalg.eigvals(np.block([[none, one], [inverse @ K, Omega * inverse @ G]]))
    assert np.abs(found.imag).max() < 1e-4 * np.abs(found).max()
    return np.sort(found.real)


@pytest.mark.parametrize("ratio", [1.0, 1.4, -1.2])
def test_two_shafts_are_the_lumped_model_where_their_mass_vanishes(ratio):
    for Omega in (0.0, 600.0, 2000.0):
        exact = eigenvalues(ratio, Omega)
        forward = whirl_frequencies(dual(ratio), Omega, count=5)[0]
        backward = whirl_frequencies(dual(ratio), Omega, count=5, whirl="backward")[0]
        assert forward == pytest.approx(exact[exact > 0][:5], rel=1e-6)
        assert backward == pytest.approx(-exact[exact < 0][::-1][:5], rel=1e-6)


@pytest.mark.parametrize("ratio", [1.4, -1.2])
def test_critical_speeds_of_either_shaft_s_unbalance_are_the_lumped_model_s(ratio):
    M, G, K, _ = lumped(ratio)
    for e in (1.0, abs(ratio)):
        for whirl, sign in (("forward", 1), ("backward", -1)):  # (K - w² (M -+ G1/e)) v = 0
            over = np.linalg.eigvals(np.linalg.solve(K, M - sign * G / e)).real  # 1/w²
            exact = np.sort(over[over > 1e-12] ** -0.5) / e
            found = critical_speeds(dual(ratio), count=4, whirl=whirl, excitation=e)
            assert found.speeds == pytest.approx(exact[:4], rel=1e-6)
            assert set(found.whirl) == {sign}


@pytest.mark.parametrize("ratio", [1.4, -1.2])
def test_damped_response_to_unbalance_is_the_lumped_model_s(ratio):
    M, G, K, C = lumped(ratio)
    speeds = np.array([50.0, 400.0, 777.0, 1500.0])
    unbalances = {1: 2e-5 + 1e-5j, 3: -1e-5j}
    found = unbalance_response(dual(ratio), speeds, unbalances)
    for k, w in enumerate(speeds):
        f = np.zeros(14, dtype=complex)
        f[[2, 6]] = w**2 * np.array([unbalances[1], unbalances[3]])
        q = np.linalg.solve(K + w**2 * G - w**2 * M + 1j * w * C, f)
        for node in range(7):
            assert found.at(node)[0][k] == pytest.approx(q[2 * node], rel=1e-6)
        pull = (4e7 + 200j * w) * q[6]
        assert found.load(SUPPORTS[1])[k] == pytest.approx(abs(pull), rel=1e-6)
        pull = (2e7 + 300j * w) * (q[4] - q[12])
        assert found.load(LINKS[1])[k] == pytest.approx(abs(pull), rel=1e-6)


def test_a_mirrored_rotor_responds_in_mirror():
    one = unbalance_response(dual(-1.2), [500.0], {1: 1e-5 + 2e-5j})
    shafts = (light([0.2, 0.15, 0.25], 0.05, -1.0), light([0.15, 0.1], 0.03, 1.2))
    mirrored = Rotor(shafts=shafts, discs=DISCS, supports=SUPPORTS, links=LINKS, theory="euler")
    other = unbalance_response(mirrored, [500.0], {1: 1e-5 - 2e-5j}, excitation=-1.0)
    assert other.at(3)[1] == pytest.approx(one.at(3)[0], rel=1e-9)
    assert other.amplitude(3) == pytest.approx(one.amplitude(3), rel=1e-9)


def test_unlike_bearings_turn_the_orbit_into_the_ellipse_of_two_oscillators():
    m, kx, ky, cx, cy, me = 20.0, 4e6, 2e6, 900.0, 300.0, 3e-5
    rotor = Rotor(
        shafts=(light([0.25, 0.25], 0.2),),
        discs=(Disc(node=1, mass=m, polar=0.3, diametral=0.2),),
        supports=tuple(Support(node=n, kxx=kx / 2, kyy=ky / 2, cxx=cx / 2, cyy=cy / 2)
                       for n in (0, 2)),
    )  # fmt: skip
    speeds = np.array([100.0, 250.0, 400.0, 700.0])
    found = unbalance_response(rotor, speeds, {1: me})
    EI = E * np.pi * 0.2**4 / 64
    kappa_GA = 6 * 1.3**2 / (7 + 12 * 0.3 + 0.36) * E / 2.6 * np.pi * 0.01
    bends = 0.5**3 / (48 * EI) + 0.5 / (4 * kappa_GA)
    x, y = (
        me * speeds**2 / (1 / (1 / (k + 1j * speeds * c) + bends) - m * speeds**2) * turn
        for k, c, turn in ((kx, cx, 1), (ky, cy, -1j))  # me W² cos Wt, me W² sin Wt
    )
    t = np.linspace(0, 2 * np.pi, 20001)[:, None]
    reach = np.hypot((x * np.exp(1j * t)).real, (y * np.exp(1j * t)).real).max(axis=0)
    assert found.amplitude(1) == pytest.approx(reach, rel=1e-6)
    plus, minus = found.at(1)
    assert plus == pytest.approx((x + 1j * y) / 2, rel=1e-6)
    assert minus == pytest.approx((x.conj() + 1j * y.conj()).conj() / 2, rel=1e-6)


def test_a_bearing_that_couples_x_and_y_pushes_across():
    kxx, kyy, kxy, cxx, cyy, cxy = 4e6, 2e6, 9e5, 900.0, 400.0, 250.0
    bearing = {"kxx": kxx, "kyy": kyy, "kxy": kxy, "cxx": cxx, "cyy": cyy, "cxy": cxy}
    rotor = Rotor(
        shafts=(Shaft(segments=(Segment(length=0.25, d_o=0.2, E=E * 1e4, rho=LIGHT),) * 2),),
        discs=(Disc(node=1, mass=20.0, polar=0.3, diametral=0.2),),
        supports=(Support(node=0, **bearing), Support(node=2, **bearing)),
    )
    for w in (100.0, 450.0, 700.0):
        found = unbalance_response(rotor, [w], {1: 3e-5})
        D = 2 * np.array([[kxx, kxy], [kxy, kyy]]) - 20 * w**2 * np.eye(2)
        D = D + 2j * w * np.array([[cxx, cxy], [cxy, cyy]])
        x, y = np.linalg.solve(D, 3e-5 * w**2 * np.array([1, -1j]))
        plus, minus = found.at(1)
        assert plus == pytest.approx((x + 1j * y) / 2, rel=1e-5)
        assert minus == pytest.approx((x - 1j * y) / 2, rel=1e-5)
        fx, fy = (
            (kxx + 1j * w * cxx) * x + (kxy + 1j * w * cxy) * y,
            ((kxy + 1j * w * cxy) * x + (kyy + 1j * w * cyy) * y),
        )
        load = (abs(fx + 1j * fy) + abs(fx - 1j * fy)) / 2
        assert found.load(rotor.supports[0]) == pytest.approx(load, rel=1e-5)


@pytest.mark.parametrize("whirl", [1, -1])
def test_the_state_between_stations_is_that_of_further_stations(whirl):
    found = []
    for lengths, points in (((1.0,), 11), ((0.3, 0.3, 0.4), 2)):
        last = len(lengths)
        rotor = Rotor(
            shafts=(Shaft(segments=tuple(Segment(length=a, d_o=0.2) for a in lengths)),),
            supports=(Support(node=0, kxx=1e8), Support(node=last, kxx=3e7)),
        )
        known = modes(rotor, 8000.0, count=4)
        (line,) = mode_lines(known, list(known.whirl).index(whirl), points=points)
        at = [np.flatnonzero(np.isclose(line.z, z))[0] for z in (0.0, 0.3, 0.6, 1.0)]
        r, phi = line.plus + line.minus, line.tilt_plus + line.tilt_minus
        found.append((np.append(r[at], phi[at]) / r[at[0]]).real)
    assert found[0] == pytest.approx(found[1], rel=1e-8)


def test_modes_are_continuous_across_stations_and_between_shafts_through_stiff_links():
    found = modes(dual(1.4), 800.0, count=3)
    for k in range(3):
        outer, inner = mode_lines(found, k, points=5)
        assert outer.z[-1] == pytest.approx(0.6)
        assert inner.z[-1] == pytest.approx(0.25)
        same = np.flatnonzero(np.diff(outer.z) < 1e-12)  # a station, from either side
        assert len(same) >= 2
        for side in (outer.plus, outer.minus, outer.tilt_plus, outer.tilt_minus):
            assert side[same + 1] == pytest.approx(side[same], abs=1e-9 * np.abs(side).max())


def test_a_response_can_be_carried_into_the_segments():
    found = unbalance_response(dual(1.4), [700.0], {1: 1e-5})
    outer, _ = lines_of(found.bending, 700.0, 700.0, found.unknowns[0], points=3)
    at = [np.flatnonzero(np.isclose(outer.z, z))[0] for z in (0.0, 0.2, 0.35, 0.6)]
    stations = np.array([found.at(node)[0][0] for node in range(4)])
    assert outer.plus[at] == pytest.approx(stations, rel=1e-9)


def bar(L, d, rho=7850.0):
    return Shaft(segments=(Segment(length=L, d_o=d, E=E, nu=NU, rho=rho),))


def test_a_free_bar_turns_in_half_waves():
    c = np.sqrt(E / 2.6 / 7850.0)
    found = torsional_frequencies(Rotor(shafts=(bar(1.3, 0.05),)), count=8)
    assert found == pytest.approx(np.arange(1, 9) * np.pi * c / 1.3, rel=1e-12)


def test_two_discs_on_a_light_shaft_turn_against_each_other():
    L, d, J = 0.4, 0.03, (0.02, 0.07)
    discs = tuple(Disc(node=n, mass=1.0, polar=j, diametral=0.01) for n, j in enumerate(J))
    found = torsional_frequencies(Rotor(shafts=(bar(L, d, LIGHT),), discs=discs), count=1)
    k = E / 2.6 * np.pi * d**4 / 32 / L
    assert found == pytest.approx([np.sqrt(k * sum(J) / (J[0] * J[1]))], rel=1e-6)


def test_two_stiff_shafts_turn_against_each_other_in_the_clutch():
    k, J = 1e3, (0.02, 0.07)
    discs = (Disc(node=0, mass=1.0, polar=J[0], diametral=0.01),
             Disc(node=2, mass=1.0, polar=J[1], diametral=0.01))  # fmt: skip
    rotor = Rotor(shafts=(bar(0.2, 0.1, LIGHT), bar(0.2, 0.1, LIGHT)), discs=discs,
                  links=(Link(a=0, b=2, kxx=1e8, k_turn=k),))  # fmt: skip
    assert free_turns(rotor) == 1
    found = torsional_frequencies(rotor, count=1)
    assert found == pytest.approx([np.sqrt(k * sum(J) / (J[0] * J[1]))], rel=1e-6)


def test_shafts_apart_turn_apart():
    rotor = Rotor(shafts=(bar(1.0, 0.05), bar(0.7, 0.03)))
    c = np.sqrt(E / 2.6 / 7850.0)
    assert free_turns(rotor) == 2
    exact = np.pi * c * np.array([1.0, 1 / 0.7, 2.0])
    assert torsional_frequencies(rotor, count=3) == pytest.approx(exact, rel=1e-12)


@pytest.mark.parametrize("k", [3e3, 1.7e5, 0.9e7])
def test_shafts_in_a_row_turn_together_in_one_way(k):
    """Whatever round-off makes of the zero among the eigenvalues of their springs."""
    shafts = (bar(1.0, 0.05), bar(0.7, 0.03), bar(0.6, 0.04), bar(0.9, 0.02))
    links = tuple(
        Link(a=a, b=b, kxx=1e6, k_turn=k * c) for a, b, c in ((1, 2, 0.3), (3, 4, 1.1), (5, 6, 0.7))
    )
    assert free_turns(Rotor(shafts=shafts, links=links)) == 1
    assert free_turns(Rotor(shafts=shafts, links=links[:2])) == 2


def test_a_held_end_turns_in_quarter_waves():
    rotor = Rotor(shafts=(bar(1.0, 0.05),), supports=(Support(node=0, kxx=1e8, k_turn=1e13),))
    c = np.sqrt(E / 2.6 / 7850.0)
    assert free_turns(rotor) == 0
    exact = np.pi * c * np.array([0.5, 1.5, 2.5])
    assert torsional_frequencies(rotor, count=3) == pytest.approx(exact, rel=1e-6)
