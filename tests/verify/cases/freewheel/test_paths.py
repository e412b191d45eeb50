"""The rig's load paths and the clutch that slips along its axis: courses, words, and facts."""

import numpy as np
import pytest

from verify.cases.freewheel.paths.case import PATHS, LoadPaths


def test_all_three_paths_slip_at_the_load_of_eq_9_an_alternating_one_no_sooner():
    q = LoadPaths()
    v = PATHS.analytic(q)
    steady = q.rise + v["F_lim"] / q.F_ax * (q.duration - q.rise)
    assert v["slip_1"] == pytest.approx(steady, abs=3e-4)
    assert v["slip_2"] >= v["slip_1"]
    for case in (2, 3):
        along = q.courses[case]
        at = np.searchsorted(along.t, along.slips_at)
        assert abs(along.mu_req[at]) > q.mu > abs(along.mu_req[at - 1])


def test_a_path_that_ends_below_the_limit_holds_and_is_green():
    q = LoadPaths(F_ax=900.0)
    v = PATHS.analytic(q)
    assert not any(key.startswith("slip") for key in v)
    assert all("holds to the end" in x and "green" in x for x in PATHS.findings(q, v)[1:4])


def test_round_off_of_the_frequency_moves_no_time_of_a_course():
    """Cycles of the defaults are whole: one time more would move every time of slip."""
    q = LoadPaths()
    for off in (-1e-13, 1e-13):
        for case, along in q.model_copy(update={"f": q.f * (1 + off)}).courses.items():
            assert np.array_equal(along.t, q.courses[case].t)
