"""Distances of profiles in L2, and models whose error nothing bounds for one's own inputs."""

from dataclasses import dataclass
from types import SimpleNamespace

import numpy as np
import pytest

from verify.core.case import Context
from verify.core.results import Status
from verify.judging.profile_checks import Estimated, Within, l2_error


@dataclass(frozen=True)
class Numbers:
    x: float = 1.0


def context(values, *, paper):
    fem = [
        SimpleNamespace(h=h, values={"x": v}, u_it={})
        for h, v in zip((4, 2, 1), values, strict=True)
    ]
    return Context("some-case", Numbers(), {"x": 1.0}, fem, is_paper=paper)


def test_an_error_in_l2_is_weighed_and_over_its_norm():
    weight = np.array([1.0, 3.0])
    assert l2_error(np.array([0.1, 0.1]), np.array([1.0, 1.0]), weight) == pytest.approx(0.1)
    assert l2_error(np.array([0.2, 0.0]), np.array([1.0, 1.0]), weight) == pytest.approx(0.1)


@pytest.mark.parametrize(("error", "status"), [(0.02, Status.PASS), (0.04, Status.FAIL)])
def test_a_profile_within_its_figure_says_how_near_it_is(error, status):
    check = Within(name="profile", symbol="e", unit="1", accepted=0.03,
                   margin=lambda _: (0.03 - error, 0.0))  # fmt: skip
    (row,) = check.rows(context((1, 1, 1), paper=True))
    assert row.status is status
    assert row.reason.endswith(f": {error:.2%}")


@pytest.mark.parametrize(("paper", "status"), [(True, Status.FAIL), (False, Status.SHOWN)])
def test_a_reference_that_stays_open_fails_on_the_paper_s_inputs_alone(paper, status):
    check = Estimated(name="x", symbol="x", unit="1", analytic="x", fem="x", formal=1,
                      interval=lambda *_: None, source="none")  # fmt: skip
    rows = check.rows(context((1.0, 2.0, 1.0), paper=paper))
    assert {row.status for row in rows} <= {status, Status.SHOWN, Status.PASS}
    assert any(row.status is status for row in rows)
    assert paper or any(row.reason.startswith("cannot be judged") for row in rows)
