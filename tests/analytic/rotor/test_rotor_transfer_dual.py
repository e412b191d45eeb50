"""Several shafts, response to unbalance and torsion, against lumped models and closed forms."""

import numpy as np
import pytest

from analytic.rotor.transfer_model import (
    Segment,
    SegmentedShaft,
    StationDisc,
    StationLink,
    StationSupport,
    TransferMatrixRotor,
)
from analytic.rotor.transfer_modes import whirl_frequencies
from analytic.rotor.transfer_response import transfer_unbalance_response
from analytic.rotor.transfer_torsion import free_turns, torsional_frequencies

E, NU = 210e9, 0.3
LIGHT = 1e-4  # kg/m³: shafts without mass, exactly elastic


def light(lengths, d, ratio=1.0):
    segments = tuple(Segment(length=a, d_o=d, E=E, nu=NU, rho=LIGHT) for a in lengths)
    return SegmentedShaft(segments=segments, ratio=ratio)


DISCS = (
    StationDisc(node=1, mass=4.0, polar=0.03, diametral=0.016),
    StationDisc(node=3, mass=3.0, polar=0.01, diametral=0.02),
    StationDisc(node=4, mass=2.0, polar=0.004, diametral=0.005),
    StationDisc(node=5, mass=5.0, polar=0.05, diametral=0.026),
    StationDisc(node=6, mass=1.0, polar=0.002, diametral=0.002),
    StationDisc(node=0, mass=0.5, polar=0.001, diametral=0.001),
    StationDisc(node=2, mass=0.5, polar=0.001, diametral=0.001),
)
LINKS = (StationLink(a=1, b=4, kxx=3e7), StationLink(a=2, b=6, kxx=2e7, k_tilt=4e4, cxx=300.0))
SUPPORTS = (
    StationSupport(node=0, kxx=5e7, cxx=900.0),
    StationSupport(node=3, kxx=4e7, cxx=200.0, c_tilt=3.0),
)


def dual(ratio):
    """Seven stations, 0 to 3 on one shaft of unequal lengths and 4 to 6 on the other."""
    shafts = (light([0.2, 0.15, 0.25], 0.05), light([0.15, 0.1], 0.03, ratio))
    return TransferMatrixRotor(
        shafts=shafts, discs=DISCS, supports=SUPPORTS, links=LINKS, theory="euler"
    )


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
def test_damped_response_to_unbalance_is_the_lumped_model_s(ratio):
    M, G, K, C = lumped(ratio)
    speeds = np.array([50.0, 400.0, 777.0, 1500.0])
    unbalances = {1: 2e-5 + 1e-5j, 3: -1e-5j}
    found = transfer_unbalance_response(dual(ratio), speeds, unbalances)
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


def test_a_bearing_that_couples_x_and_y_pushes_across():
    kxx, kyy, kxy, cxx, cyy, cxy = 4e6, 2e6, 9e5, 900.0, 400.0, 250.0
    bearing = {"kxx": kxx, "kyy": kyy, "kxy": kxy, "cxx": cxx, "cyy": cyy, "cxy": cxy}
    rotor = TransferMatrixRotor(
        shafts=(
            SegmentedShaft(segments=(Segment(length=0.25, d_o=0.2, E=E * 1e4, rho=LIGHT),) * 2),
        ),
        discs=(StationDisc(node=1, mass=20.0, polar=0.3, diametral=0.2),),
        supports=(StationSupport(node=0, **bearing), StationSupport(node=2, **bearing)),
    )
    for w in (100.0, 450.0, 700.0):
        found = transfer_unbalance_response(rotor, [w], {1: 3e-5})
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


def bar(L, d, rho=7850.0):
    return SegmentedShaft(segments=(Segment(length=L, d_o=d, E=E, nu=NU, rho=rho),))


def test_a_free_bar_turns_in_half_waves():
    c = np.sqrt(E / 2.6 / 7850.0)
    shaft = TransferMatrixRotor(shafts=(bar(1.3, 0.05),))
    found = torsional_frequencies(shaft, count=8)
    assert found == pytest.approx(np.arange(1, 9) * np.pi * c / 1.3, rel=1e-12)
    assert torsional_frequencies(shaft) == pytest.approx(found[:3], rel=1e-12)


@pytest.mark.parametrize("k", [3e3, 1.7e5, 0.9e7])
def test_shafts_in_a_row_have_one_free_turn(k):
    """Independent of the round-off of the zero among the eigenvalues of their springs."""
    shafts = (bar(1.0, 0.05), bar(0.7, 0.03), bar(0.6, 0.04), bar(0.9, 0.02))
    links = tuple(
        StationLink(a=a, b=b, kxx=1e6, k_turn=k * c)
        for a, b, c in ((1, 2, 0.3), (3, 4, 1.1), (5, 6, 0.7))
    )
    assert free_turns(TransferMatrixRotor(shafts=shafts, links=links)) == 1
    assert free_turns(TransferMatrixRotor(shafts=shafts, links=links[:2])) == 2
