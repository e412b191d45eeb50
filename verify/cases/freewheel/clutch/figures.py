"""Figures of a user's freewheel: range without slip, values over torque, scatter."""

import math
from collections.abc import Sequence

import numpy as np

from analytic.freewheel import criterion, state
from analytic.freewheel.duty import WORDS
from analytic.freewheel.scatter import DRAWS
from analytic.freewheel.state import RollerClutchState
from verify.cases.freewheel import star_sketch
from verify.cases.freewheel.clutch.inputs import ClutchInputs
from verify.cases.freewheel.clutch.reference import GRID
from verify.cases.freewheel.clutch.sketch import cup
from verify.core.case import Context
from verify.core.figures import Array, Bars, Curves, Figure, Sketch, Zone, Zones
from verify.form.plots import dashes, dots, line, plot

DEGREE = math.degrees(1.0)
POINTS = 241
WIDE, HIGH = 2.0, 2.2  # least range of figures, as multiples of T and F_ax
AT_END = 1e-6  # relative tolerance for the last torque of a figure at the last state
DRAWN = np.linspace(0.1, 99.9, 200)  # per cent of the clutches


def sketch(q: ClutchInputs) -> Sketch:
    return star_sketch.sketch(q) if q.is_star else cup(q)


def figures(context: Context) -> Sequence[Figure]:
    q = context.inputs
    if q.duty.under is None:
        return ()
    found: list[Figure] = [lights(q), angles(q), windup(q, context)]
    if context.fem:
        found.append(flats(q, context))
    if (ensemble := q.scatter) is not None:
        found += [
            cumulated("Distribution of the clamping angle without load, random clutches", "α_0 [°]",
                      ensemble.drawn.alpha0 * DEGREE, float(q.cam.alpha0) * DEGREE),
            cumulated("Distribution of the ratio μ/μ_req, random clutches", "μ/μ_req",
                      ensemble.safety, context.analytic["safety"], limits=True),
        ]  # fmt: skip
    if any(s.share for s in q.slopes):
        found.append(sensitivity(q))
    return found


def reach(q: ClutchInputs) -> float:
    """Upper end [N m] of the torque axis: beyond the next two limits above T, below `duty.end`."""
    ahead = [limit.at for limit in q.duty.of_torque if limit.at > q.T]
    most = 1.15 * ahead[1] if len(ahead) > 1 else 1.3 * ahead[0] if ahead else 3 * q.T
    return min(max(WIDE * q.T, min(most, 6 * q.T)), (1 - 1e-9) * q.duty.end)


def lights(q: ClutchInputs) -> Zones:
    T = np.linspace(0.0, reach(q), POINTS)
    T[0] = 1e-6 * T[-1]
    alpha = state.loaded(q.clutch, T).alpha
    F = {
        share: np.nan_to_num(criterion.largest_axial_load(
            alpha=alpha, T=T, R=q.cam.race, mu=q.mu / share)) / 1e3
        for share in (criterion.GREEN, criterion.RED)
    }  # fmt: skip
    top = max(HIGH * q.F_ax / 1e3, 1.15 * float(F[criterion.RED].max()), 1e-3)
    curves = [
        dashes(f"{limit.words}", limit.at, [0.0, top], k)
        for k, limit in enumerate(q.duty.of_torque[:3])
        if limit.key != "slip" and limit.at <= T[-1]
    ]  # fmt: skip
    through = float(q.duty.of_torque_alone.pop_through)
    if through < (1 + AT_END) * T[-1]:
        curves.append(dashes(f"the diagram ends: {WORDS['pop_through']}", T[-1], [0.0, top], 3))
    lifted = [x for x in q.duty.of_axial_load if x.key != "slip" and x.at / 1e3 < 0.98 * top]
    curves += [
        dashes(f"{limit.words}, at this torque", T[[0, -1]], limit.at / 1e3, 4) for limit in lifted
    ]  # fmt: skip
    free = "the torque alone causes slip" if float(np.tan(q.cam.alpha0)) > q.mu else ""
    return Zones(
        title="Range of loads in which the clutch "
              "holds" + (f": {free}" if free else ""), x_label="T [N m]",
        y_label="F_ax [kN]", x=T, y_top=top, zones=_zones(q, T, F, top),
        curves=tuple(curves), point=(q.T, q.F_ax / 1e3, "this clutch"),
        note="Green: μ ≥ μ_req (Coulomb's law), with pressure and tilt within their limits. "
             "Yellow: 0.8 μ_req ≤ μ < μ_req; by Coulomb's law the clutch slips, but it slipped "
             "only in some of the paper's tests.",
    )  # fmt: skip


def _zones(q: ClutchInputs, T: Array, F: dict[float, Array], top: float) -> tuple[Zone, ...]:
    """Zones of the classes over `T`; `F`: axial load [kN] at each class limit of mu/mu_req."""
    within = float(q.duty.of_torque_alone.corner) >= T
    holds, slips = (np.where(within, F[share], 0.0) for share in (criterion.GREEN, criterion.RED))
    borne = np.fmin(holds, q.duty.largest_axial_load(T) / 1e3)
    return (
        Zone(name="green: holds", top=borne, tone="good"),
        Zone(name="friction holds, overloaded", top=holds, tone="fair"),
        Zone(name="yellow: slips by Coulomb's law", top=slips, tone="fair"),
        Zone(name="red: slips", top=np.where(within, top, 0.0), tone="bad"),
        Zone(
            name="red: rollers beyond the ends of the flats", top=np.full(T.size, top), tone="bad"
        ),
    )


def _states(q: ClutchInputs) -> tuple[Array, RollerClutchState]:
    T = np.linspace(0.0, min(WIDE * q.T, (1 - 1e-9) * q.duty.end), POINTS)
    T[0] = 1e-6 * T[-1]
    return T, state.loaded(q.clutch, T)


def angles(q: ClutchInputs) -> Curves:
    T, now = _states(q)
    tan = math.atan(q.mu) * DEGREE
    asked = np.arctan(q.duty.required(T, now.alpha))
    return plot(
        "Clamping angle and required friction angle", "T [N m]", "angle [°]",
        line("α", T, now.alpha * DEGREE),
        line("arctan μ_req, with F_ax", T, asked * DEGREE, 2),
        dashes("arctan μ", T[[0, -1]], tan, 1),
        dots("this clutch", [q.T], np.interp([q.T], T, now.alpha * DEGREE), 5),
        y_bottom=0.0, y_top=1.7 * max(tan, float(now.alpha.max()) * DEGREE),
        note="The clutch holds where arctan μ_req is below arctan μ.",
    )  # fmt: skip


def flats(q: ClutchInputs, context: Context) -> Curves:
    """Figure of alpha_0, and of alpha under torque, over the shift of the flats."""
    far = 2 * q.off
    X = np.linspace(-far, far, 41)
    moved = [q.moved(dX) for dX in X]
    low, own, high = context.fem[-1].arrays["moved"] * DEGREE
    return plot(
        "Sensitivity of the clamping angle to X", "deviation of X [µm]", "α [°]",
        line("α under T", X * 1e6,
             np.array([float(state.loaded(c, q.T).alpha) for c in moved]) * DEGREE),
        dashes("α_0", X * 1e6, np.array([float(c.cam.alpha0) for c in moved]) * DEGREE, 4),
        dots("FE under T", np.array([-q.off, 0.0, q.off]) * 1e6, [low, own, high], 1),
        y_bottom=0.97 * float(moved[-1].cam.alpha0) * DEGREE,
        note="The angle under torque changes less than α_0, because the elastic approaches partly "
             "compensate the deviation of X.",
    )  # fmt: skip


def windup(q: ClutchInputs, context: Context) -> Curves:
    T, now = _states(q)
    measured = () if not context.fem else (
        dots("FE, from strain energy", GRID * q.T,
             context.fem[-1].arrays["phi_over_T"] * DEGREE, 1),
    )  # fmt: skip
    assert q.duty.under is not None
    return plot(
        "Wind-up over torque", "T [N m]", "φ [°]",
        line("exact rolling (Eq. 7, corrected)", T, now.phi * DEGREE),
        dashes("Eq. 7 as printed, s/R + s/X", T, now.phi_printed * DEGREE, 2),
        dashes("2s/R", T, now.phi_small * DEGREE, 4),
        measured,
        note="Under the given torque, the travel of the rollers is s = "
             f"{float(q.duty.under.s) * 1e6:.4g} µm.",
    )  # fmt: skip


def cumulated(title: str, label: str, x: Array, drawn: float, *, limits: bool = False) -> Curves:
    """Figure of the cumulative distribution of `x` over random clutches; `drawn`: nominal value."""
    ends = np.percentile(x, DRAWN)
    full = np.array([0.0, 100.0])
    lines = [(drawn, "nominal", 5)]
    if limits:
        lines += [(criterion.GREEN, "green above", 1), (criterion.RED, "red below", 2)]
    return plot(
        title, label, "clutches below [%]",
        line("clutches", ends, DRAWN),
        (dashes(name, at, full, k) for at, name, k in lines),
        note=f"{DRAWS:,} random clutches with the given tolerances, from a fixed seed. All rollers "
             "of a clutch are identical.",
    )  # fmt: skip


def sensitivity(q: ClutchInputs) -> Bars:
    by = q.slopes
    return Bars(
        title="Contributions to the scatter of the clamping angle",
        label="share of the variance of α_0 [%]",
        items=tuple(
            (f"{s.name}, ±{getattr(q, f'{s.name}_tol') * 1e6:.3g} µm", 100 * s.share,
             f"{100 * s.share:.0f} %, {s.slope * 1e-6 * DEGREE:+.3f}°/µm".replace("-", "−"))
            for s in by
        ),
        note="The contributions are a first-order approximation.",
    )  # fmt: skip
