"""Comparisons of a race under n sprags: finite elements, Fourier series, and Eq. 6."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from analytic.bounds.ring import ACCEPTED, PART, integrated_dent, smeared_error
from verify.case import Comparison, Quantity, identity
from verify.cases.ring.loads.formulas import SpragLoads
from verify.cases.ring.loads.reference import stations
from verify.core.case import Check, Context
from verify.core.results import Row
from verify.judging.checks import Accepted, Approximation
from verify.judging.convergence import grid_convergence
from verify.judging.judge import expanded, numerical_uncertainty
from verify.judging.tolerance_checks import Deviation

BY_SUBJECT = "accepted difference between finite elements and the Fourier series"
EDGE = 1.5  # order at the load: even cells on the pressure's square-root end
AWAY = 3.0  # away from it: twice the order of the energy norm, which is 3/2 due to that end
FITTED = "force and length of the sprags are identified, not printed"
PATCHES = "Hertz's pressure on the contact patches, radial forces, plane stress"
RADII = "radial forces, plane stress"
DEPTH = {SpragLoads.dent.name: 1.0, SpragLoads.dent_half.name: 0.5}  # over the wall
BY_FOURIER = (
    "derived: deflection by the Fourier series of the ring, which is independent of these finite "
    "elements; local indentation by integration of McEwen's stresses along the normal at the "
    "centre of the contact"
)


@dataclass(frozen=True, kw_only=True)
class Smeared(Approximation):
    """Comparison of a formula with a deflection by FE, minus the value named `less`, if any."""

    less: str = ""

    def rows(self, context: Context) -> list[Row]:
        taken = context.analytic[self.less] if self.less else 0.0
        fem = [
            replace(result, values={**result.values, self.fem: result.values[self.fem] - taken})
            for result in context.fem
        ]
        return super().rows(replace(context, fem=fem))


def comparisons(self: SpragLoads) -> Iterator[Comparison | Check]:
    """Rows: Fourier series against finite elements; Eq. 6 against finite elements."""
    race = type(self)
    wall, far = ("bore", "rim") if self.loaded == "bore" else ("rim", "bore")
    shared: dict[str, Any] = {"sensitivity": (ACCEPTED, BY_SUBJECT), "shares": PATCHES}
    for q, name, order in (
        (race.load, f"{wall} displacement under a sprag", EDGE),
        (race.between, f"{wall} displacement between sprags", AWAY),
        (race.far_load, f"{far} displacement at the angle of a sprag", AWAY),
        (race.far_between, f"{far} displacement between sprags", AWAY),
    ):
        yield identity(q, name=name, scale=race.load, order=order, **shared)
    yield identity(race.smeared, "mean", name=f"{wall} displacement, mean", order=AWAY,
                   **shared | {"shares": RADII})  # fmt: skip
    yield identity(race.ripple, name="peak-to-peak variation of the deflection, divided by the "
                   "mean deflection", order=EDGE, **shared)  # fmt: skip
    for q, name in (
        (race.hoop_between, f"hoop stress between sprags, {wall}"),
        (race.far_hoop_load, f"hoop stress at the angle of a sprag, {far}"),
        (race.far_hoop_between, f"hoop stress between sprags, {far}"),
    ):
        scale = {"largest hoop stress": self.stress_scale}
        yield identity(q, name=name, symbol="σ_θ", scale=scale, order=2, **shared)
    yield identity(race.hoop_force, name="hoop force in the cut between sprags", order=AWAY,
                   **shared)  # fmt: skip
    yield identity(race.strain_energy, name="strain energy of the race", order=EDGE, **shared)
    yield from _fields()
    for q, at, less, name in (
        (race.smeared, race.load, None,
         "deflection by Eq. 6, compared with the displacement under a sprag"),
        (race.smeared, race.load, race.dent,
         "deflection by Eq. 6, compared with the displacement under a sprag after subtraction of "
         "the local indentation δ_H (relative to a point one wall thickness deep)"),
        (race.smeared, race.load, race.dent_half,
         "deflection by Eq. 6, compared with the displacement under a sprag after subtraction of "
         "the local indentation δ_Hh (relative to a point half a wall thickness deep)"),
        (race.smeared, race.between, None,
         "deflection by Eq. 6, compared with the displacement between sprags"),
        (race.with_dent, race.load, None,
         "deflection by Eq. 6 plus local indentation δ_H (relative to a point one wall thickness "
         "deep), compared with the displacement under a sprag"),
    ):  # fmt: skip
        yield _smeared(self, q, at, less, name)
    check = Accepted(name="Eq. 6 overestimates the displacement under a sprag after subtraction of "
                     "the local indentation δ_H",
                     symbol="m", unit="1", margin=too_soft, fitted=FITTED)  # fmt: skip
    yield Comparison(check=check, quantity=race.smeared, shares=RADII)


def _fields() -> Iterator[Deviation]:
    """Rows: Fourier series against FE, at all nodes of bore and rim and inside the wall."""
    for name, symbol, size, whole in (
        (f"largest displacement error at the nodes of bore and rim is below {ACCEPTED:g} of the "
         "displacement under a sprag", "e_u",
         wall_errors, "radial displacement under a sprag"),
        (f"largest stress error, at more than one patch width from a sprag, is below {ACCEPTED:g} "
         "of the largest stress", "e_σ",
         stress_errors, "largest stress at more than one patch width from a sprag"),
    ):  # fmt: skip
        yield Deviation(name=name, symbol=symbol, unit="1", size=finest(size), accepted=ACCEPTED,
                        source=BY_SUBJECT, whole=whole, shares=PATCHES)  # fmt: skip


def _smeared(
    self: SpragLoads, q: Quantity, at: Quantity, less: Quantity | None, name: str
) -> Comparison:
    def dent(of: Quantity) -> float:
        depth = DEPTH[of.name] * (self.r_o - self.r_i)
        return integrated_dent(depth, P=self.P, a=self.half_width, E=self.E, nu=self.nu)

    limits = smeared_error(
        mean=self.mean, at=getattr(self, at.name), load=self.load,
        indentation=dent(less) if less else 0.0,
        added=dent(SpragLoads.dent) if q.name == SpragLoads.with_dent.name else 0.0,
    )  # fmt: skip
    check = Smeared(
        name=name, symbol=type(self).smeared.symbol, unit="µm", analytic=q.name, fem=at.name,
        less=less.name if less else "", formal=EDGE if at.name == "load" else AWAY,
        source=BY_FOURIER, interval=lambda *_: limits,
    )  # fmt: skip
    return Comparison(check=check, quantity=q, shares=RADII)


def wall_errors(context: Context) -> list[float]:
    """Largest errors of u_r and u_theta on both walls, relative to u_r at the load.

    Finite elements are compared with the Fourier series. The list has one value per level.
    """
    q = context.inputs
    ring, found = q.race(), []
    for result in context.fem:
        worst = 0.0
        for name, r in (("bore", q.r_i), ("rim", q.r_o)):
            theta, u_r, u_theta = result.arrays[f"{name} nodes"]
            exact = ring.at(r, theta)
            worst = max(worst, np.abs(u_r - exact.u_r).max(), np.abs(u_theta - exact.u_theta).max())
        found.append(float(worst) / q.load)
    return found


def stress_errors(context: Context) -> list[float]:
    """Largest errors of three stresses at `stations`, relative to the largest stress.

    Finite elements are compared with the Fourier series. The list has one value per level.
    """
    exact = context.inputs.race().at(*stations(context.inputs))
    wanted = np.array([exact.sigma_r, exact.sigma_theta, exact.tau])
    scale = np.abs(wanted).max()
    return [float(np.abs(r.arrays["stresses"] - wanted).max() / scale) for r in context.fem]


def finest(
    errors: Callable[[Context], list[float]],
) -> Callable[[Context], tuple[float, float, str]]:
    """Function that returns the error on the finest mesh.

    The change of the error from the second finest mesh and a text are also returned.
    """

    def of(context: Context) -> tuple[float, float, str]:
        found = errors(context)
        return found[-1], abs(found[-1] - found[-2]), f"{found[-1]:.1e}"

    return of


def too_soft(context: Context) -> tuple[float, float, str]:
    """Relative error of Eq. 6 against the deflection by FE that is reduced by δ_H.

    The uncertainty and the text of the row are also returned.
    """
    q, (h, series) = context.inputs, context.series("load")
    u = numerical_uncertainty(grid_convergence(h, series, formal=EDGE, scale=series[-1]))
    reference = series[-1] - q.dent
    if reference < PART * q.load:
        return 0.0, 0.0, "the deflection without local indentation is too small to be compared"
    m = q.smeared / reference - 1
    U = (1 + m) * expanded(u) / reference
    return m, U, f"the error of Eq. 6 is {m:+.1%} at n = {q.n}"
