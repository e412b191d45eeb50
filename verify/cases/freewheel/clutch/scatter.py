"""Clutches out of tolerance: what share of them slips, and which dimension does most."""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from analytic.freewheel import criterion
from analytic.freewheel.tolerance import Ensemble, Outcome, draw, first_order, sensitivities
from verify.cases.freewheel.clutch.inputs import ClutchInputs
from verify.cases.freewheel.clutch.limits import under

Array = NDArray[np.float64]

DRAWS, SEED = 20_000, 2021
PERCENTILES = (5.0, 50.0, 95.0)
COUNTED: dict[str, Outcome] = {
    "slip": "slips", "no_wedge": "no wedge", "corner": "past the corners",
    "no_state": "no state",
}  # fmt: skip
NAMES = {"R_s": "R", "X_o": "X"}  # of an outer cam's fields, as inputs are called


@dataclass(frozen=True)
class Scatter:
    """An ensemble under load, and what was counted in it."""

    drawn: Ensemble

    @property
    def safety(self) -> Array:
        """mu/mu_req of the clutches that wedge and have a state."""
        kept = np.isfinite(self.drawn.mu_req)
        return np.asarray(self.drawn.mu[kept] / self.drawn.mu_req[kept])

    def values(self) -> dict[str, float]:
        """Percentiles and shares, SI; shares of none are left out, but for those that slip."""
        d, known = self.drawn, np.isfinite(self.drawn.mu_req)
        found = {f"P_{key}": d.share(outcome) for key, outcome in COUNTED.items()}
        found = {key: share for key, share in found.items() if share > 0 or key == "P_slip"}
        for name, x in (
            ("alpha_0", d.alpha0), ("alpha", d.alpha[known]), ("safety", self.safety),
        ):  # fmt: skip
            if x.size:
                found |= {f"{name}_{p:g}": float(np.percentile(x, p)) for p in PERCENTILES}
        wedged = ~criterion.self_releasing(alpha=d.alpha0, mu=d.mu)
        wedged &= d.outcomes[d.wedging] != "past the corners"
        lights = criterion.traffic_light(self.safety)[wedged[known]]
        shares = {name: float((lights == name).sum() / d.outcomes.size)
                  for name in ("green", "yellow")}  # fmt: skip
        # those without a wedge or a state, past the corners or releasing themselves among them
        shares["red"] = 1 - sum(shares.values())
        return found | {f"share_{name}": share for name, share in shares.items()}


@lru_cache(maxsize=4)
def scatter(q: ClutchInputs) -> Scatter | None:
    """The ensemble of `q`; None where nothing scatters or the clutch bears nothing."""
    if not q.deviations or under(q) is None:
        return None
    return Scatter(
        draw(q.clutch, q.deviations, mu=q.mu, T=q.T, F_ax=q.F_ax, n=DRAWS, seed=SEED, kind=q.spread)
    )


@dataclass(frozen=True)
class Slope:
    """What a dimension does to alpha_0: by input's name, rad/m, and its share of the variance."""

    name: str
    slope: float
    share: float


def slopes(q: ClutchInputs) -> list[Slope]:
    """Of X, r and R, in this order."""
    by = sensitivities(q.cam)
    sigma = {name: s for name, s in q.deviations.items() if name != "mu"}
    shares = first_order(q.cam, sigma)[1] if sigma else {}
    found = [Slope(NAMES.get(n, n), float(v), shares.get(n, 0.0)) for n, v in by.items()]
    return sorted(found, key=lambda s: "XrR".index(s.name))


def deviation(q: ClutchInputs) -> float:
    """Standard deviation of alpha_0 [rad] to first order; 0 where nothing scatters."""
    sigma = {name: s for name, s in q.deviations.items() if name != "mu"}
    return first_order(q.cam, sigma)[0] if sigma else 0.0
