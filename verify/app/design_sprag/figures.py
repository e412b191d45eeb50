"""Figures of a crown: its profile, pressures, the region around the optimum, kriging errors."""

import numpy as np

from reports.design import Picture
from verify.core.figures import Array, Curve, Curves, Density
from verify.studies.design_sprag.console import named
from verify.studies.design_sprag.outcome import Outcome
from verify.studies.design_sprag.verified import Check

MPa, mm, um = 1e6, 1e-3, 1e-6
POINTS, CELLS, DOTS = 181, 41, 64
SHADED = 1.08  # of the least pressure, which the colours span
SEEN = 1.2  # times the best pressure, which kriging is drawn for
NAMES = ("K_1", "K_2", "z_m [µm]")
UNITS = (1.0, 1.0, um)


def figures(outcome: Outcome) -> list[Picture]:
    """All figures that can be drawn.

    The plot of pressures requires a check by the half-space. The plot over torques requires
    several torques.
    """
    found: list[Picture] = [profiles(outcome)]
    if outcome.checks:
        found.append(pressures(outcome))
    found += [plane(outcome, 0, 2), plane(outcome, 0, 1), parity(outcome)]
    if len(outcome.task.torques) > 1:
        found.append(over_torques(outcome))
    return found


def profiles(outcome: Outcome) -> Curves:
    """Plot of the profile drop along the sprag: present crown, optimal crown and its tolerance."""
    model, q = outcome.search.model, outcome.task.clutch
    y = np.linspace(-0.5, 0.5, POINTS) * q.l
    drops = model.drop(outcome.chosen.crowns, y) / um
    curves = [Curve(name="best", x=y / mm, y=drops[0], colour=1)]
    if len(drops) > 1:
        for edge, name in ((drops.min(axis=0), "its tolerance"), (drops.max(axis=0), "")):
            curves.append(Curve(name=name, x=y / mm, y=edge, style="dashes", colour=1))
    now = model.drop(outcome.now.crowns, y)[0] / um
    curves.append(Curve(name="now" if q.z_m else "now, without a crown", x=y / mm, y=now, colour=0))
    return Curves(
        title="Profile of the sprag", x_label="y [mm]", y_label="z [µm]", curves=tuple(curves),
        y_bottom=0.0, note="Deviation of the profile from a straight line. "
                           f"{named(outcome.crown)}. "
        "The coordinates are in profile.csv.",
    )  # fmt: skip


def pressures(outcome: Outcome) -> Curves:
    """Plot of pressures along the sprag at the largest torque, by slices, strips and half-space."""
    c = [check for check in outcome.checks if check.which == "nominal"][-1]
    l = outcome.task.clutch.l  # noqa: E741
    half = _thinned(c.half.y, DOTS)
    return Curves(
        title="Pressure along the sprag at the largest force", x_label="y [mm]", y_label="p [MPa]",
        curves=(
            _along("slices", c.slices, l, 0),
            _along("strips", c.strips, l, 1),
            Curve(name="half-space", x=c.half.y[half] / mm, y=c.half.centre_pressure[half] / MPa,
                  style="dots", colour=2),
        ), y_bottom=0.0, note=_load_text(c),
    )  # fmt: skip


def _load_text(c: Check) -> str:
    ends = "The ends are unloaded." if c.end == 0 else "The ends are loaded."
    return f"{c.T:g} N m, N_max = {c.N:.5g} N at the inner race. {ends}"


def _along(name: str, p: Array, l: float, colour: int) -> Curve:  # noqa: E741
    y = ((np.arange(len(p)) + 0.5) / len(p) - 0.5) * l
    return Curve(name=f"{len(p)} {name}", x=y / mm, y=p / MPa, colour=colour)


def _thinned(values: Array, most: int) -> Array:
    return np.unique(np.round(np.linspace(0, len(values) - 1, most)).astype(int))


def plane(outcome: Outcome, i: int, j: int) -> Density:
    """Plot of the objective over two parameters of the crown; the third parameter is optimal."""
    search, task = outcome.search, outcome.task
    x, y = (np.linspace(task.low[k], task.high[k], CELLS) for k in (i, j))
    crowns = np.tile(outcome.crown, (CELLS * CELLS, 1))
    crowns[:, i], crowns[:, j] = (a.ravel() for a in np.meshgrid(x, y))
    worst = search.worst(crowns)
    if outcome.relative:
        z, unit = 100 * ((worst / outcome.best).max(axis=1) - 1), "excess [%]"
        least = 100 * float(outcome.excess.max())
        span = (least, least + 100 * (SHADED - 1))
    else:
        z, unit = worst.max(axis=1) / MPa, "p [MPa]"
        least = float(outcome.worst.max()) / MPa
        span = (least, SHADED * least)
    third = 3 - i - j
    return Density(
        title=f"{_bare(i)} and {_bare(j)} about the optimal crown", x_label=NAMES[i],
        y_label=NAMES[j], z_label=unit, x=x / UNITS[i], y=y / UNITS[j], z=z.reshape(CELLS, CELLS),
        range=span, point=(float(outcome.crown[i] / UNITS[i]),
                             float(outcome.crown[j] / UNITS[j]), "best"),
        note=f"Computed by kriging, with {_bare(third)} of the optimal crown"
        + ("" if search.single else ", at the worst point within the tolerance")
        + "; values above the colour scale have its last colour.",
    )  # fmt: skip


def _bare(k: int) -> str:
    return NAMES[k].partition(" ")[0]


def parity(outcome: Outcome) -> Curves:
    """Plot of the pressure by kriging over that by the true model, for random crowns.

    The crowns are not in the sample from which kriging interpolates. Both pressures are divided by
    the optimal pressure.
    """
    search, ends = outcome.search, np.array([1.0, SEEN])
    curves = [Curve(name="equal", x=ends, y=ends, style="dashes", colour=4)]
    drawn = [(true / outcome.best, by / outcome.best) for true, by in search.parity]
    groups = (("learnt from", drawn[:-1], 3), ("accepted by", drawn[-1:], 0))
    for name, draws, colour in groups:
        pairs = [np.column_stack([t.ravel(), p.ravel()]) for t, p in draws]
        if pairs and (near := (all_ := np.vstack(pairs))[:, 0] <= SEEN).any():
            x, y = all_[near].T
            curves.append(Curve(name=name, x=x, y=y, style="dots", colour=colour))
    return Curves(
        title="Kriging against the true model", x_label="p/p_best, true",
        y_label="p/p_best, kriging", curves=tuple(curves), y_bottom=0.98,
        note="Each point is a random crown that is not in the sample of kriging, at one torque; "
             "pressures are relative to the optimal one at "
        "this torque. Where kriging was inaccurate, the crowns were added to its sample, and "
        "new crowns were drawn. "
        "Edge-loaded crowns are far above, because the end pressure counts three times.",
    )  # fmt: skip


def over_torques(outcome: Outcome) -> Curves:
    """Plot of the largest pressures over the torque: present, selected and optimal crowns."""
    T = np.array(outcome.task.torques)
    now = outcome.largest(outcome.now)[0] / MPa
    limit = outcome.task.wishes.p_lim
    curves = [
        Curve(name="now", x=T, y=now, colour=0),
        Curve(name="chosen", x=T, y=outcome.worst / MPa, colour=1),
        Curve(name="best of each torque", x=T, y=outcome.best / MPa, style="dots", colour=2),
    ]
    if limit is not None:
        curves.append(Curve(name="p_lim", x=T[[0, -1]], y=np.full(2, limit / MPa), style="dashes",
                            colour=4))  # fmt: skip
    worst = (
        ""
        if outcome.search.single
        else (" For the selected and the optimal crowns: largest value within the tolerance.")
    )
    return Curves(
        title="Largest pressure over the torque", x_label="T [N m]", y_label="p [MPa]",
        curves=tuple(curves), y_bottom=0.0,
        note=f"Pressures during engagement, computed by {outcome.task.wishes.contacts}.{worst}",
    )  # fmt: skip
