"""Clutches with tolerances under load: share of slipping clutches, most influential dimension."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from analytic.contact.checks import Array
from analytic.freewheel import criterion
from analytic.freewheel.cam import Cam
from analytic.freewheel.duty import Duty
from analytic.freewheel.tolerance import (
    Ensemble,
    Kind,
    Outcome,
    clamping_angle_sensitivities,
    draw,
    first_order,
)

DRAWS, SEED = 20_000, 2021
PERCENTILES = (5.0, 50.0, 95.0)
COUNTED: dict[str, Outcome] = {
    "slip": "slips", "no_wedge": "no wedge", "corner": "past the corners",
    "no_state": "no state",
}  # fmt: skip
NAMES = {"R_s": "R", "X_o": "X"}  # fields of an outer cam by the names common to both kinds of cam


@dataclass(frozen=True)
class Scatter:
    """Sample of clutches under load, and its statistics."""

    drawn: Ensemble

    @property
    def safety(self) -> Array:
        """Ratio mu/mu_req of the clutches that have a wedge and an equilibrium."""
        kept = np.isfinite(self.drawn.mu_req)
        return np.asarray(self.drawn.mu[kept] / self.drawn.mu_req[kept])

    def values(self) -> dict[str, float]:
        """Percentiles (SI units), shares of outcomes and shares of traffic-light classes, by name.

        An outcome that does not occur is omitted, except slip.
        """
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
        # including those without wedge or equilibrium, beyond the corners, or self-releasing
        shares["red"] = 1 - sum(shares.values())
        return found | {f"share_{name}": share for name, share in shares.items()}


def scatter(duty: Duty, sigma: Mapping[str, float], kind: Kind) -> Scatter | None:
    """Sample of clutches; `sigma` has the standard deviations of fields of the cam and of mu.

    None if all dimensions are exact or the clutch has no equilibrium.
    """
    if not sigma or duty.under is None:
        return None
    loads = {"mu": duty.mu, "T": duty.T, "F_ax": duty.F_ax}
    return Scatter(draw(duty.clutch, sigma, **loads, n=DRAWS, seed=SEED, kind=kind))


@dataclass(frozen=True)
class Slope:
    """Slope of alpha_0 over X, r or R [rad/m], and share of this input in the variance."""

    name: str
    slope: float
    share: float


def slopes(cam: Cam, sigma: Mapping[str, float]) -> list[Slope]:
    """Sensitivities of alpha_0 to X, r and R, in this order.

    `sigma` [m] contains standard deviations by the names of the fields of `cam`.

    >>> from analytic.freewheel.geometry import InnerCam
    >>> cam = InnerCam(R=16.5, r=2.5, X=11.39565, z=8)
    >>> [(s.name, s.share) for s in slopes(cam, {"X": 5e-3})]
    [('X', 1.0), ('r', 0.0), ('R', 0.0)]
    """
    shares = first_order(cam, sigma)[1] if sigma else {}
    found = [Slope(NAMES.get(n, n), float(v), shares.get(n, 0.0))
             for n, v in clamping_angle_sensitivities(cam).items()]  # fmt: skip
    return sorted(found, key=lambda s: "XrR".index(s.name))


def deviation(cam: Cam, sigma: Mapping[str, float]) -> float:
    """Standard deviation of alpha_0 [rad] to first order; 0 if all dimensions are exact."""
    return first_order(cam, sigma)[0] if sigma else 0.0
