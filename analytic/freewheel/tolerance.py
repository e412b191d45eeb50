r"""Clutches with tolerances: sensitivities of the clamping angle, and Monte Carlo samples.

The derivatives of cos psi = y/rho give

.. math::
    \frac{\partial\alpha_0}{\partial X} = \frac{-1}{2\rho\sin\psi}, \quad
    \frac{\partial\alpha_0}{\partial r} = \mp\frac{1 + \cos\psi}{2\rho\sin\psi}, \quad
    \frac{\partial\alpha_0}{\partial R} = \frac{\cos\psi}{2\rho\sin\psi},

with the upper sign for an inner cam. All rollers and flats of one clutch are assumed to be equal;
unequal load sharing in one clutch is not considered.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Literal, get_args

import numpy as np
from numpy.typing import NDArray

from analytic.contact.checks import Array, not_negative
from analytic.freewheel import criterion, state
from analytic.freewheel.cam import Cam
from analytic.freewheel.clutch import RollerClutch
from analytic.freewheel.geometry import InnerCam
from analytic.freewheel.rules import require
from analytic.freewheel.state import RollerClutchState

Kind = Literal["normal", "uniform"]
Outcome = Literal["holds", "slips", "no wedge", "past the corners", "no state"]


def clamping_angle_sensitivities(cam: Cam) -> dict[str, Array]:
    """Derivatives of alpha0 [rad/length] by the fields R, r, X (outer cam: R_s, r, X_o) of `cam`.

    >>> cam = InnerCam(R=16.5, r=2.5, X=14 * np.cos(np.radians(7)) - 2.5, z=8)
    >>> by_X = clamping_angle_sensitivities(cam)["X"]
    >>> round(float(np.degrees(5e-3 * by_X)), 3)  # 5 um on X, in degrees
    -0.084
    """
    psi, rho = 2 * cam.alpha0, cam.distance(d_i=0.0, d_o=0.0)
    scale = 1 / (2 * rho * np.sin(psi))
    R, X = _names(cam)
    by_r = -cam.sense * scale * (1 + np.cos(psi))
    return {X: np.asarray(-scale), "r": np.asarray(by_r), R: np.asarray(scale * np.cos(psi))}


sensitivities = clamping_angle_sensitivities  # its name in version 0.1


def first_order(cam: Cam, sigma: Mapping[str, float]) -> tuple[float, dict[str, float]]:
    """Standard deviation of alpha0 [rad], and the share of each field in its variance.

    >>> cam = InnerCam(R=16.5, r=2.5, X=11.39565, z=8)
    >>> first_order(cam, {"X": 5e-3})[1]
    {'X': 1.0}
    """
    slopes = clamping_angle_sensitivities(cam)
    _known(sigma, slopes)
    parts = {name: float((slopes[name] * value) ** 2) for name, value in sigma.items()}
    variance = sum(parts.values())
    require(variance > 0, "tolerances need a deviation above 0", "")
    return float(np.sqrt(variance)), {name: part / variance for name, part in parts.items()}


@dataclass(frozen=True, kw_only=True, eq=False)
class Ensemble:
    """Sample of clutches: outcomes of all clutches, and arrays for the clutches with a wedge.

    Angles in rad; alpha and mu_req under the load, nan without an equilibrium. `outcomes` are of
    the type `Outcome`; "no state" means that the rollers of an outer cam pop through or contacts
    are too wide.
    """

    drawn: dict[str, Array]
    wedging: NDArray[np.bool_]
    outcomes: NDArray[np.str_]
    alpha0: Array
    alpha: Array
    mu_req: Array
    mu: Array

    def share(self, outcome: Outcome) -> float:
        """Fraction of all sampled clutches with this outcome."""
        return float(np.count_nonzero(self.outcomes == outcome) / self.outcomes.size)


def draw(
    clutch: RollerClutch,
    sigma: Mapping[str, float],
    *,
    mu: float,
    T: float,
    F_ax: float,
    n: int,
    seed: int,
    kind: Kind = "normal",
) -> Ensemble:
    """Sample of n clutches about `clutch` with standard deviations `sigma`, under load.

    `sigma` contains standard deviations by name: R, r, X (outer cam: R_s, r, X_o) [length], mu.
    `kind` is the distribution of the dimensions; "uniform" has the same standard deviations. mu is
    always normally distributed, because no inspection limits it.
    """
    names = {*_names(clutch.cam), "r", "mu"}
    _known(sigma, names)
    means = {name: float(np.asarray(getattr(clutch.cam, name))) for name in names - {"mu"}}
    means["mu"] = mu
    drawn = _drawn(means, sigma, n, seed, kind)
    outcomes = _unloaded(clutch.cam, drawn)
    wedging = outcomes == "holds"
    kept = {name: value[wedging] for name, value in drawn.items()}
    cam = replace(clutch.cam, **{name: kept[name] for name in names - {"mu"}})
    now = state.loaded(replace(clutch, cam=cam), T)
    asked = criterion.required_friction(alpha=now.alpha, T=T, F_ax=F_ax, R=cam.race)
    outcomes[wedging] = _loaded(cam, now, asked, kept["mu"])
    return Ensemble(
        drawn=drawn, wedging=wedging, outcomes=outcomes, alpha0=cam.alpha0, alpha=now.alpha,
        mu_req=asked, mu=kept["mu"],
    )  # fmt: skip


def _drawn(
    means: Mapping[str, float], sigma: Mapping[str, float], n: int, seed: int, kind: Kind
) -> dict[str, Array]:
    if kind not in get_args(Kind):
        raise ValueError(f"kind must be one of {', '.join(get_args(Kind))}, got {kind!r}")
    rng = np.random.default_rng(seed)
    found = {}
    for name in sorted(means):  # so that a seed means the same draw always
        deviation = float(not_negative(sigma.get(name, 0.0), f"deviation of {name}", ""))
        normal = kind == "normal" or name == "mu"
        unit = rng.normal(size=n) if normal else rng.uniform(-1, 1, n) * np.sqrt(3)
        found[name] = means[name] + deviation * unit
    return found


def _unloaded(cam: Cam, drawn: Mapping[str, Array]) -> NDArray[np.str_]:
    """Outcomes of the clutches without load; "holds" if there is a wedge."""
    R, X, r = (drawn[name] for name in (*_names(cam), "r"))
    rho, y = R - cam.sense * r, X + cam.sense * r
    x = np.sqrt(np.maximum(rho**2 - y**2, 0.0))
    corner = X * np.tan(np.pi / cam.count)
    return _first([(y >= rho, "no wedge"), (x >= corner, "past the corners"),
                   (drawn["mu"] <= 0, "slips")])  # fmt: skip


def _loaded(cam: Cam, now: RollerClutchState, asked: Array, mu: Array) -> NDArray[np.str_]:
    """Outcomes under load of the clutches with a wedge."""
    x, _ = cam.centre(d_i=now.d_i, d_o=now.d_o)
    slips = (asked > mu) | criterion.self_releasing(alpha=cam.alpha0, mu=mu)
    return _first([(np.isnan(asked), "no state"), (x > cam.corner, "past the corners"),
                   (slips, "slips")])  # fmt: skip


def _first(found: Sequence[tuple[NDArray[np.bool_], Outcome]]) -> NDArray[np.str_]:
    """First of the outcomes that occurs; "holds" if none occurs."""
    text = np.dtype("<U16")  # of the longest outcome
    return np.select([met for met, _ in found], [name for _, name in found], "holds").astype(text)


def _names(cam: Cam) -> tuple[str, str]:
    return ("R", "X") if isinstance(cam, InnerCam) else ("R_s", "X_o")


def _known(given: Mapping[str, float], known: Mapping[str, Array] | set[str]) -> None:
    strange = sorted(set(given) - set(known))
    if strange:
        raise ValueError(
            f"tolerances must be given for {', '.join(sorted(known))} only, got {strange[0]!r}"
        )
