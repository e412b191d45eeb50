"""ROSS as a second solver: matrices, frequencies, responses of the same rotor of 22 nodes."""

import numpy as np
import pytest

from fem.rotor.campbell import campbell
from fem.rotor.modes import modes
from fem.rotor.response import unbalance_response
from tests.fem.rotor.rotor_ross import across, bending, kappas, ours, theirs

ross = pytest.importorskip("ross", reason="ROSS is not installed")


@pytest.fixture(scope="module", params=[False, True], ids=["isotropic", "unlike"])
def pair(request):
    other = theirs(ross, unlike=request.param)
    return ours(kappas(other), unlike=request.param), other


def test_matrices(pair):
    own, other = pair
    for mine, peer in ((own.M, other.M()), (own.K, other.K(0.0)), (own.G, other.G()),
                       (own.C, other.C(0.0))):  # fmt: skip
        assert abs(across(mine) - across(peer)).max() <= 1e-12 * abs(peer).max()


@pytest.mark.parametrize("speed", [0.0, 523.6, 3500.0])
def test_frequencies_and_damping(pair, speed):
    own, other = pair
    # their dense eigenvalues of a state matrix of bending alone
    M, K, C, G = (across(A) for A in (other.M(), other.K(0.0), other.C(0.0), other.G()))
    n = len(M)
    S = np.block([[np.zeros((n, n)), np.eye(n)],
                  [-np.linalg.solve(M, K), -np.linalg.solve(M, C + speed * G)]])  # fmt: skip
    values = np.linalg.eigvals(S)
    values = values[values.imag > 0]
    found = modes(own, speed, 12).eigenvalues
    for value in found:
        assert abs(values - value).min() < 1e-9 * abs(value)
    peers = np.sort(other.run_modal(speed, num_modes=60, sparse=False).wd)
    for value in found.imag:
        assert abs(peers - value).min() < 1e-9 * value


def test_campbell_diagram(pair):
    own, other = pair
    speeds = np.linspace(0, 3500, 8)
    peers = other.run_campbell(speeds, frequencies=10).wd
    found = campbell(own, speeds, 6).frequencies
    for i in range(speeds.size):
        for value in peers[i][peers[i] > 1][:4]:
            assert abs(found[i] - value).min() < 1e-6 * value or value > found[i].max()


def test_unbalance_response(pair):
    own, other = pair
    speeds = np.linspace(50, 4000, 15)
    peer = other.run_unbalance_response([3, 18], [1.4e-5, 1e-5], [0.0, 0.6], frequency=speeds)
    found = unbalance_response(own, speeds, {3: 1.4e-5, 18: 1e-5 * np.exp(0.6j)})
    own_at, at = bending(found.q.shape[1]), bending(len(peer.forced_resp))
    scale = abs(found.q[:, own_at]).max(axis=1, keepdims=True)
    assert (abs(peer.forced_resp.T[:, at] - found.q[:, own_at]) / scale).max() < 1e-9
