"""Largest pressures of engagements for each crown."""

import numpy as np
import pytest

from verify.cases.sprag import peaks
from verify.cases.sprag.clutch.run_fem import run_fem
from verify.cases.sprag.inputs import EngagementInputs
from verify.cases.sprag.peaks import NoLockError, peaks_fem, with_crown

Q = EngagementInputs(Q=3407.0, t_end=0.02)
FREE = (3.0, 0.68, 25e-6)  # its ends carry little
CROWNS = np.array([FREE, (1.0, 0.4, 5e-6), (5.0, 0.7, 25e-6)])


@pytest.fixture(scope="module")
def found():
    return peaks_fem(Q, CROWNS, [10.0, 25.0])


def test_peaks_are_those_of_a_whole_engagement_in_the_order_of_the_torques(found):
    run = run_fem(with_crown(Q, FREE))
    peak = [found.N_max[0, 1], found.largest[0, 1]]
    assert peak == pytest.approx([run.engagement.N_max, run.peaks[0]], rel=1e-7)
    alone = peaks_fem(Q, CROWNS[:1], [10.0])
    assert found.of(0).largest[0] == pytest.approx(alone.largest[0], rel=1e-7)
    assert found.of(0).torques.tolist() == [10.0]
    assert found.pressure.shape == (3, 2, Q.slices)
    # the end and the rest make up the largest
    assert np.maximum(found.end, found.inside).tolist() == found.largest.tolist()
    assert found.end[1, 1] > found.inside[1, 1]
    assert found.end[2, 1] == 0


def test_processes_change_nothing(found):
    seen = []
    crowns = np.concatenate([CROWNS, CROWNS[:2]])[::-1]
    again = peaks_fem(Q, np.tile(crowns, (2, 1)), [25.0], jobs=2, progress=seen.append)
    assert again.largest[[4, 3, 2], 0] == pytest.approx(found.largest[:, 1], rel=1e-7)
    assert again.largest[:5].tolist() == again.largest[5:].tolist()
    assert seen[-1] == 10


def test_what_does_not_lock_has_no_peak():
    slippery = Q.model_copy(update={"mu_s": 0.05, "mu_c": 0.05})
    with pytest.raises(NoLockError, match=r"T = 25 N m .*no crown prevents this"):
        peaks_fem(slippery, CROWNS[:1], [25.0])


def test_an_engagement_that_is_not_solved_is_not_one_that_does_not_lock(monkeypatch):
    def fails(*_):
        raise ValueError("dt is too long")

    peaks._peak_fem.cache_clear()  # other tests have solved this engagement
    monkeypatch.setattr(peaks, "engaged_fem", fails)
    with pytest.raises(
        ArithmeticError, match="could not be computed: ValueError: dt is too long"
    ) as error:
        peaks_fem(Q, CROWNS[:1], [25.0])
    assert not isinstance(error.value, NoLockError)
