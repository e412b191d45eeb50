"""Rows of the whole curve: contact, energy, limits, and readings against Eq. 10."""

from collections.abc import Iterator
from typing import Any

from verify.cases.spring.curve import claims
from verify.cases.spring.stages.readings import eq10
from verify.judging.checks import Accepted, Limit
from verify.judging.tolerance_checks import Deviation, suites

PENETRATION = 1e-4  # over b: tolerance of the contact gap
SAME_CONTACT = 0.002  # relative change of a slope with the contact stiffness
HALVED = 0.003  # relative change of a slope on a mesh of half the size
BALANCE = 1e-5  # relative to the work
RETRACED = 1e-5  # relative to the force: contact within 1e-4 b changes it by a few 1e-6
K1, K2, CROSSING = 0.01, 0.05, 0.05  # relative to Eq. 10
FITTED = "calibrated: the reading is chosen because its k_1 is nearest to k_1 of Eq. 10"
ASKED = "the required sensitivity of slopes, 1 %"
LIMIT = (
    "linear theory is exact for vanishing rotation; an accuracy of 0.2 % is sufficient for the "
    "closed form"
)


def slender(k: int, symbol: str, words: str) -> Limit:
    """Row on U_A, F_A or k_2: for slender leaves, beams tend to the closed form."""
    return Limit(
        name=f"{words}, closed form for slender leaves", symbol=f"{symbol}, FE/formula − 1",
        unit="1", points=claims.parallel(k), exponent=None, demand=2e-3, demand_reason=LIMIT,
        paper_only=True,
    )  # fmt: skip


def deviations() -> Iterator[Deviation]:
    """Rows on overlap, contact stiffness, mesh, energy and unloading of the beams."""
    slopes: dict[str, Any] = {"symbol": "Δk/k", "unit": "1", "whole": "slopes k_1, k_2"}
    yield Deviation(name="no interpenetration of leaves", symbol="δ/b", unit="1",
                    size=claims.depth, accepted=PENETRATION, whole="thickness",
                    source="tolerance of the contact algorithm")  # fmt: skip
    yield Deviation(name="slopes k_1 and k_2 do not depend on the contact stiffness", **slopes,
                    size=claims.same_contact, accepted=SAME_CONTACT,
                    source=suites(f"one fifth of {ASKED}"))  # fmt: skip
    yield Deviation(name="slopes k_1 and k_2 do not change if the cell size is halved",
                    **slopes, size=claims.halved, accepted=HALVED,
                    source=suites(f"one third of {ASKED}"))  # fmt: skip
    yield Deviation(name="work equals stored energy and friction losses", symbol="W − V − D",
                    unit="1", size=claims.balance, accepted=BALANCE, whole="work",
                    source=suites("effect of the contact tolerance of 1e-4 b"))  # fmt: skip
    yield Deviation(name="loading and unloading coincide without friction", symbol="ΔF/F",
                    unit="1", size=claims.retraced, accepted=RETRACED,
                    whole="force at the same displacement",
                    source=suites("the contact tolerance is 1e-4 b"))  # fmt: skip


def accepted() -> Iterator[Accepted]:
    """Rows on the third stage, and on the paper's spring against Eq. 10."""
    yield Accepted(name="stiffness after the loops touch (stage BE) is at least ten times k_2",
                   symbol="dF/dU", unit="1", margin=claims.stiffens)  # fmt: skip
    fitted: dict[str, Any] = {"unit": "1", "fitted": FITTED, "paper_only": True}
    yield Accepted(name="the chosen reading has the k_1 nearest to Eq. 10", symbol="k_1",
                   margin=claims.nearest, **fitted)  # fmt: skip
    yield Accepted(name="k_1 of the chosen reading against Eq. 10", symbol="k_1",
                   margin=claims.near("k1", K1, lambda: eq10().k1), **fitted,
                   printed=("wang2023:k1-fea",))  # fmt: skip
    yield Accepted(name="k_2 of the chosen reading against Eq. 10", symbol="k_2",
                   margin=claims.near("k2", K2, lambda: eq10().k2), **fitted,
                   printed=("wang2023:k2-fea",))  # fmt: skip
    yield Accepted(name="displacement at the intersection of both fitted lines, compared with "
                   "Eq. 10",
                   symbol="U", margin=claims.near("U", CROSSING, lambda: eq10().U),
                   **fitted)  # fmt: skip
    yield Accepted(name="force for U = 1 to 17 mm, compared with Eq. 10", symbol="F",
                   margin=claims.along, **fitted)  # fmt: skip
