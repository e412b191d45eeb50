"""Profiles of finite elements: their band, their distance in L2, and errors that nothing bounds."""

from dataclasses import dataclass

import numpy as np
import pytest

from verify.core.case import Context, FemResult
from verify.core.results import Status
from verify.judging.profile_checks import Estimated, Within, l2_error
from verify.judging.profiles import along

X = np.linspace(0, 1, 7)


@dataclass(frozen=True)
class Numbers:
    x: float = 1.0


def lines(errors, u_it=(0.0,) * 4):
    """Levels whose values are X plus an error that changes place from mesh to mesh."""
    levels = [
        FemResult(h=1 / 2**i, values={}, u_it={"line": u}, arrays={"line": X + e})
        for i, (e, u) in enumerate(zip(errors, u_it, strict=True))
    ]
    return Context("c", None, {}, levels, is_paper=True)


def values(*found, paper=True):
    levels = [FemResult(h=h, values={"x": v}) for h, v in zip((4, 2, 1), found, strict=True)]
    return Context("some-case", Numbers(), {"x": 1.0}, levels, is_paper=paper)


def test_errors_that_change_place_are_covered_and_not_by_much_more():
    wandering = [0.3 / 4**i * np.sin((5 + 3 * i) * X + i) for i in range(4)]
    y, u = along(lines(wandering), "line", formal=2.0, scale=1.0)
    assert np.all(np.abs(y - X) <= 2 * u)
    assert u[0] < 0.02


def test_round_off_is_covered_by_the_most_that_the_solver_states_of_a_level():
    noise = [1e-9 * np.cos(40 * X + i) for i in range(4)]
    y, u = along(lines(noise, u_it=(1e-6, 0, 0, 0)), "line", formal=2.0, scale=1.0)
    assert np.all(np.abs(y - X) <= 2 * u)
    assert u[0] >= 5e-7


def test_growing_differences_give_a_wide_band_of_finite_numbers():
    _, u = along(lines([0.1 * 2**i * X for i in range(4)]), "line", formal=2.0, scale=1.0)
    assert np.all(np.isfinite(u))
    assert u[0] > 0.5


def test_an_error_in_l2_is_weighed_and_over_its_norm():
    weight = np.array([1.0, 3.0])
    assert l2_error(np.array([0.1, 0.1]), np.array([1.0, 1.0]), weight) == pytest.approx(0.1)
    assert l2_error(np.array([0.2, 0.0]), np.array([1.0, 1.0]), weight) == pytest.approx(0.1)


@pytest.mark.parametrize(("error", "status"), [(0.02, Status.PASS), (0.04, Status.FAIL)])
def test_a_profile_within_its_figure_states_its_error(error, status):
    check = Within(name="profile", symbol="e", unit="1", accepted=0.03,
                   margin=lambda _: (0.03 - error, 0.0))  # fmt: skip
    (row,) = check.rows(values(1, 1, 1))
    assert row.status is status
    assert row.reason.endswith(f": {error:.2%}")


@pytest.mark.parametrize(("paper", "status"), [(True, Status.FAIL), (False, Status.SHOWN)])
def test_a_reference_that_stays_open_fails_on_the_paper_s_inputs_alone(paper, status):
    check = Estimated(name="x", symbol="x", unit="1", analytic="x", fem="x", formal=1,
                      interval=lambda *_: None, source="none")  # fmt: skip
    rows = check.rows(values(1.0, 2.0, 1.0, paper=paper))
    assert {row.status for row in rows} <= {status, Status.SHOWN, Status.PASS}
    assert any(row.status is status for row in rows)
    assert paper or any(row.reason.startswith("cannot be judged") for row in rows)
