"""The search for a crown of an invented clutch with an optimal crown known beforehand."""

import math
from copy import deepcopy
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from analytic.surrogate.gate import PoorSurrogateError
from verify.studies.design_sprag.corners import corners
from verify.studies.design_sprag.inputs import default
from verify.studies.design_sprag.known import SHARP, Known
from verify.studies.design_sprag.outcome import _worth, bound, flatness
from verify.studies.design_sprag.search import Search
from verify.studies.design_sprag.surrogates import crowns_of

STRIPS, P = 9, 2e9
BEST = {10.0: 1.5, 40.0: 3.375}  # K_1 of the least pressure at each torque
FREE = 10e-6  # z_m from which on the ends of a crown with K_1 = 1 carry nothing


class Invented:
    """A clutch whose pressures are a formula; the end carries where K_1 z_m is too small.

    p = P (1 + 0.2 ln²(K_1/K*) + 0.3 (0.7 - K_2) + 0.02 ln(z_m/5 µm)) inside.
    """

    def __init__(self, torques, *, noise=0.0):
        self.torques, self.noise, self.asked = torques, noise, 0
        self.counts = (STRIPS,) * len(torques)
        self.known = self.answers(np.array([[2.0, 0.55, 11e-6]]))

    def answers(self, crowns):
        K_1, K_2, z_m = crowns.T
        self.asked += len(crowns)
        strips = []
        for T in self.torques:
            inside = P * (
                1 + 0.2 * np.log(K_1 / BEST[T]) ** 2 + 0.3 * (0.7 - K_2)
                + 0.02 * np.log(z_m / 5e-6)
            )  # fmt: skip
            inside = inside * (1 + self.noise * np.sin(1e9 * z_m))
            end = P * np.sqrt(np.maximum(0.0, np.log(FREE / (z_m * K_1))))
            p = np.repeat(0.9 * inside[:, None], STRIPS, axis=1)
            p[:, STRIPS // 2], p[:, 0], p[:, -1] = inside, end, end
            strips.append(p)
        n, m = len(crowns), len(self.torques)
        return Known(
            np.array(crowns), np.full((n, m), 1e3), np.stack(strips, axis=1), tuple(strips)
        )

    def ask(self, crowns):
        found = self.answers(crowns)
        for k in range(len(found)):
            apart = np.abs(found.crowns[k] / self.known.crowns - 1).max(axis=1)
            if apart.min() > 1e-7:
                self.known = self.known.with_(found[k : k + 1])
        return found


def task(*, torques=(10.0,), t_z=0.0, t_y=0.0, **wishes):
    base = default()
    return replace(
        base, torques=torques,
        wishes=base.wishes.model_copy(update={"t_z": t_z, "t_y": t_y, **wishes}),
    )  # fmt: skip


LEVELS, FINE = 4, 5  # of the factorial; where numbers are compared with the formula
# where three times the end's pressure is the inside's, 1.003 P: ln(FREE/(K_1 z_m)) = (1.003/3)²
EDGE = FREE * math.exp(-((1.003 / SHARP) ** 2))
# along it 0.2 ln²(K_1/1.5) - 0.02 ln K_1 is least
K_BEST = 1.5 * math.exp(0.05)
LEAST = P * (1 + 0.2 * 0.05**2 + 0.02 * math.log(EDGE / K_BEST / 5e-6))


@cache
def _prepared(key):
    return fresh(task(**dict(key)), LEVELS if key else FINE)


def fresh(one, levels=LEVELS):
    """A search that has learnt enough."""
    search = Search(one, Invented(one.torques), levels)
    search.prepare()
    return search


def prepared(**wishes):
    """A copy of the stored search, for one test to continue."""
    return deepcopy(_prepared(tuple(sorted(wishes.items()))))


def single(p):
    return p[:, 0]


def test_the_best_crown_of_a_torque_is_found_where_it_is_known_to_be():
    """On the edge where the end would count more; K_2 is best at its bound."""
    found = prepared().least(single)
    assert found.true == pytest.approx(LEAST, rel=5e-4)
    K_1, K_2, z_m = crowns_of(found.x[None])[0]
    assert pytest.approx(K_BEST, rel=0.05) == K_1  # 0.05 % of the pressure
    assert pytest.approx(0.7, abs=1e-4) == K_2
    assert K_1 * z_m == pytest.approx(EDGE, rel=0.01)
    assert prepared().least(single).x.tolist() == found.x.tolist()  # one seed, one crown
    genetic = prepared(seed=4, method="genetic").least(single)
    assert genetic.true == pytest.approx(LEAST, rel=5e-3)


def test_the_least_excess_over_two_torques_lies_between_their_crowns():
    """ln² is as far from both at the geometric mean: K_1 = 2.25, 0.2 ln²(1.5) over each."""
    search = prepared(torques=(10.0, 40.0))
    one = search.task
    best = np.array([search.least(lambda p, k=k: p[:, k]).true for k in (0, 1)])
    found = search.least(_worth(one, best))
    assert crowns_of(found.x[None])[0, 0] == pytest.approx(2.25, rel=0.03)
    assert found.true - 1 == pytest.approx(0.2 * math.log(1.5) ** 2, rel=0.2)


def test_a_tolerance_keeps_the_crown_off_the_edge_where_its_end_carries():
    """The shallowest profile, K_1 z_m (1 - t_z/z_m)², is on the edge, the requested one beyond."""
    loose = prepared(t_z=1e-6)
    x = crowns_of(loose.least(single).x[None])
    shallow = min(corners(loose.task, x)[0].tolist())
    assert shallow[0] * shallow[2] == pytest.approx(EDGE, rel=0.02)
    assert x[0, 0] * x[0, 2] > 1.15 * EDGE


def test_a_model_that_kriging_cannot_follow_is_refused(monkeypatch):
    monkeypatch.setattr("verify.studies.design_sprag.search.DRAWS", 2)
    search = Search(task(), Invented((10.0,), noise=0.15), 3)
    with pytest.raises(PoorSurrogateError, match="the surrogate of the largest pressure at"):
        search.prepare()
    assert len(search.judged) == 2  # it learnt from the first crowns and met others


# How flat, and which bound binds


def test_a_flat_optimum_is_stated_parameter_by_parameter():
    """Half a per cent is ln(K_1/1.5) = ±sqrt(0.025) inside, and 0.005/0.3 of K_2."""
    search = prepared()
    crown = np.array([1.5, 0.7, 12e-6])
    worst = search.true(crown)
    alone, together = flatness(search, single, crown, worst)
    share = 0.005 * worst[0] / P
    half = math.sqrt(share / 0.2)
    assert alone[0] == pytest.approx([1.5 * math.exp(-half), 1.5 * math.exp(half)], abs=0.05)
    assert alone[1] == pytest.approx([0.7 - share / 0.3, 0.7], abs=0.003)
    assert np.all(together[:, 0] <= crown)
    assert np.all(together[:, 1] >= crown)


def test_a_bound_has_what_more_would_gain():
    """K_2 = 0.73 lowers p by 0.3 x 0.03 of P; K_1 is no bound, z_m at its top gains nothing."""
    search = prepared()
    crown = np.array([1.5, 0.7, 25e-6])
    worst = search.true(crown)
    found, deep = bound(search, single, crown, worst)
    assert (deep.parameter, deep.costs) == (2, False)
    assert found.costs
    assert found.parameter == 1
    assert found.beyond == pytest.approx(0.73)
    assert found.gain == pytest.approx(0.009 * P / worst[0], rel=1e-6)
