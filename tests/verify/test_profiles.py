"""Profiles of finite elements: band, L2 distance, errors without bound; portions of cases."""

from dataclasses import dataclass

import numpy as np
import pytest

from verify.cases.polyhedral.ring.case import RING
from verify.cases.spring.accordion.case import ACCORDION
from verify.core.case import Context, FemResult
from verify.core.results import Status
from verify.judging.profile_checks import Estimated, Within, l2_error
from verify.judging.profiles import along

X = np.linspace(0, 1, 7)


@dataclass(frozen=True)
class Numbers:
    x: float = 1.0


def values(*found, paper=True):
    levels = [FemResult(h=h, values={"x": v}) for h, v in zip((4, 2, 1), found, strict=True)]
    return Context("some-case", Numbers(), {"x": 1.0}, levels, is_paper=paper)


def test_the_band_of_a_line_covers_its_errors():
    for errors, u_it, low, high in (
        # errors that change place are covered, and not by much more
        ([0.3 / 4**i * np.sin((5 + 3 * i) * X + i) for i in range(4)], (0,) * 4, 0, 0.02),
        # round-off is covered by the most that the solver states of a level
        ([1e-9 * np.cos(40 * X + i) for i in range(4)], (1e-6, 0, 0, 0), 5e-7, 1e-4),
        # growing differences give a wide band of finite numbers
        ([0.1 * 2**i * X for i in range(4)], (0,) * 4, 0.5, np.inf),
    ):
        levels = [
            FemResult(h=1 / 2**i, values={}, u_it={"line": u}, arrays={"line": X + e})
            for i, (e, u) in enumerate(zip(errors, u_it, strict=True))
        ]
        context = Context("c", None, {}, levels, is_paper=True)
        y, u = along(context, "line", formal=2.0, scale=1.0)
        assert np.all(np.abs(y - X) <= 2 * u)
        assert low <= u[0] < high


def test_an_error_in_l2_is_weighed_and_over_its_norm():
    weight = np.array([1.0, 3.0])
    assert l2_error(np.array([0.1, 0.1]), np.array([1.0, 1.0]), weight) == pytest.approx(0.1)
    assert l2_error(np.array([0.2, 0.0]), np.array([1.0, 1.0]), weight) == pytest.approx(0.1)


@pytest.mark.parametrize(("error", "status"), [(0.02, Status.PASS), (0.04, Status.FAIL)])
def test_a_profile_within_its_figure_states_its_error(error, status):
    check = Within(name="profile", symbol="e", unit="1", accepted=0.03,
                   margin=lambda _: (0.03 - error, 0.0))  # fmt: skip
    (row,) = check.rows(values(1, 1, 1))
    assert (row.status, row.reason[-8:]) == (status, f": {100 * error:.2f} %")


@pytest.mark.parametrize(("paper", "status"), [(True, Status.FAIL), (False, Status.SHOWN)])
def test_a_reference_that_stays_open_fails_on_the_paper_s_inputs_alone(paper, status):
    check = Estimated(name="x", symbol="x", unit="1", analytic="x", fem="x", formal=1,
                      interval=lambda *_: None, source="none")  # fmt: skip
    rows = check.rows(values(1.0, 2.0, 1.0, paper=paper))
    assert {row.status for row in rows} <= {status, Status.SHOWN, Status.PASS}
    assert any(row.status is status for row in rows)
    assert paper or any(row.reason.startswith("cannot be judged") for row in rows)


@pytest.mark.parametrize("case", [RING, ACCORDION], ids=lambda case: case.id)
def test_a_portion_has_the_values_of_its_case_on_the_same_mesh(case):
    for portion in case.portions:
        level = portion.levels[0]
        part, whole = (fem(case.inputs(), level) for fem in (portion.fem, case.reference))
        assert set(part.values) == set(portion.keys)
        assert part.h == whole.h
        assert part.values == {key: whole.values[key] for key in portion.keys}
        assert part.u_it == {key: whole.u_it[key] for key in portion.keys}
        # rows of the case need it, on levels enough for its convergence
        assert set(portion.keys) <= {getattr(check, "fem", None) for check in case.checks}
        assert len(portion.levels) >= 3
        assert list(portion.levels) == sorted(portion.levels)
