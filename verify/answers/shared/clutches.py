"""Assumptions that formula and reference share: roller freewheels and sprag clutches."""

import math
from collections.abc import Mapping
from typing import Any

from verify.answers.shared.record import (
    Function,
    SharedReading,
    Values,
    equal_shares,
    only_at_paper,
    ratio,
)

OFF = 5e-6  # m, deviation of the flats from their nominal position in the examples below

ENDS = SharedReading(
    assumption="the rollers are long (plane strain), uniform along the axis",
    part="their ends carry more or less than their middle", quantity="the largest pressure",
    source="not quantified here; see the cases contact-roller-flat and contact-roller-end",
)  # fmt: skip
HOLD = SharedReading(
    assumption="the star is clamped on its shaft and the rim of the ring is free",
    part="fits and housing hold star and ring elastically", quantity="the wind-up φ",
)  # fmt: skip
MU = SharedReading(
    assumption="the friction coefficient μ is constant, independent of the sliding speed",
    part="μ varies with lubrication, wear and speed", quantity="the axial load at slip F_ax,lim",
    source="not quantified; it is proportional to sqrt(μ² − tan²α)",
)  # fmt: skip


def wedge_angle(R: float, r: float, X: float) -> float:
    """Half the wedge angle [rad] of an unloaded clutch: inner cam, flats at X from the axis.

    `X`, the bore radius `R` of the ring and the roller radius `r` are in m.
    """
    return math.acos(min((X + r) / (R - r), 1.0)) / 2


def _flat(q: Any, quantity: str, *, inverse: bool) -> tuple[SharedReading, ...]:
    """Effect of flats whose distance from the axis exceeds its nominal value by `OFF`.

    `inverse` is True for a quantity that is inversely proportional to tan(half the wedge angle),
    and False for a proportional quantity.
    """
    nominal, real = (math.tan(wedge_angle(q.R, q.r, X)) for X in (q.X, q.X + OFF))
    if not real > 0:
        return ()
    return (
        SharedReading(
            assumption="the flats lie at their nominal distance X",
            part="the distance has a tolerance", quantity=quantity,
            effect=real / nominal - 1 if inverse else nominal / real - 1,
            source=f"for X + {OFF * 1e6:g} µm, without load",
        ),
    )  # fmt: skip


def _torque(q: Any, _: Values) -> tuple[SharedReading, ...]:
    return (*_flat(q, "the normal force F_n", inverse=True), ENDS, HOLD,
            equal_shares("rollers", "the normal force F_n"))  # fmt: skip


def _cup(_q: Any, _v: Values) -> tuple[SharedReading, ...]:
    fit = SharedReading(
        assumption="cup and housing are one body up to R_a",
        part="the cup is pressed into its housing",
        quantity="the normal force F_n",
    )
    return (fit, ENDS, equal_shares("rollers", "the normal force F_n"))


def _friction(q: Any, v: Values) -> tuple[SharedReading, ...]:
    tilt = SharedReading(
        assumption="the load is uniform along the rollers",
        part="the axial forces on a roller form a couple that tilts the roller",
        quantity="the largest pressure", effect=1 / v["pressure"] - 1, source="a linear line load",
    )  # fmt: skip
    return (*_flat(q, "the required friction coefficient", inverse=False), tilt, MU,
            equal_shares("rollers", "the axial load at slip F_ax,lim"))  # fmt: skip


def _paths(q: Any, v: Values) -> tuple[SharedReading, ...]:
    inertia = SharedReading(
        assumption="the forces are in static equilibrium at every time (no inertia)",
        part="the ring has mass, and its natural frequency f_0 is "
             "finite", quantity="the alternating loads",
        effect=1 / (1 + v["sway"]) - 1, source="(f/f_0)²",
    )  # fmt: skip
    return (inertia, *_flat(q, "the required friction coefficient", inverse=False), MU,
            equal_shares("rollers", "the axial load at slip F_ax,lim"))  # fmt: skip


def _freewheel(_q: Any, _v: Values) -> tuple[SharedReading, ...]:
    return (equal_shares("rollers", "the required friction coefficient"), MU, ENDS, HOLD)


SPRAGS = equal_shares("sprags", "the normal force N")
TENTH = math.radians(0.1)


def _angle(q: Any) -> SharedReading:
    """Shared assumption about the wedge angle ν_0, which determines all forces."""
    return SharedReading(
        assumption="the wedge angle ν_0 is that of the inputs",
        part="the wedge angle has a tolerance",
        quantity="the normal force N", source="for a wedge angle larger by 0.1°",
        effect=math.tan(q.nu_0 + TENTH) / math.tan(q.nu_0) - 1,
    )  # fmt: skip


SAME_YIELDS = "the deflections are those of Palmgren's law and Eq. 6"


def _composite(effect: float | None) -> SharedReading:
    """Shared assumption that deflections follow the laws of the paper."""
    known = "the elastic bodies of case sprag-wedge"
    return SharedReading(
        assumption=SAME_YIELDS, part="elastic bodies deflect less",
        quantity="the sprag rotation under T", effect=effect,
        source=known if effect is not None else "not quantified for these inputs",
    )  # fmt: skip


AT_25 = 0.265  # sprag rotation by these laws over that of elastic bodies, case sprag-clutch


def _wedge(q: Any, _: Values) -> tuple[SharedReading, ...]:
    column = SharedReading(
        assumption="the sprag is a column of width b with rounded ends",
        part="the outline of the sprag between its contacts is not printed",
        quantity="the sprag rotation",
    )  # fmt: skip
    return (_angle(q), column, SPRAGS)


def _engagement(q: Any, _: Values) -> tuple[SharedReading, ...]:
    rigid = SharedReading(
        assumption="races rotate without bending or vibration, and N is the static function of α",
        part="races have bending modes", quantity="the largest normal force N_max",
    )  # fmt: skip
    return (_composite(only_at_paper(q, AT_25)), _angle(q), rigid, SPRAGS)


def _sliding(q: Any, _: Values) -> tuple[SharedReading, ...]:
    law = SharedReading(
        assumption="friction follows the law of Eq. 12 with assumed coefficients",
        part="the paper prints none of the "
             "coefficients", quantity="the torque at which sprags slip",
    )  # fmt: skip
    return (law, _composite(only_at_paper(q, AT_25)), SPRAGS)


def _clutch(q: Any, v: Values) -> tuple[SharedReading, ...]:
    return (_composite(ratio(v, "alpha", "alpha_elastic")), _angle(q), SPRAGS)


def _crown(q: Any, _: Values) -> tuple[SharedReading, ...]:
    half_space = SharedReading(
        assumption="the contacting bodies are half-spaces that extend beyond the ends of the sprag",
        part="the sprag ends there", quantity="the load near the ends",
        source="not quantified here; +29 % to +35 % for a roller (case contact-roller-end)",
    )  # fmt: skip
    peak = SharedReading(
        assumption="the pressure at the largest force of an engagement is the static pressure",
        part="the inertia of the sprag also acts", quantity="the largest pressure",
    )  # fmt: skip
    return (half_space, peak, _angle(q), SPRAGS)


CLUTCHES: Mapping[str, Function] = {
    "freewheel-torque": _torque,
    "freewheel-cup": _cup,
    "freewheel-friction": _friction,
    "freewheel-paths": _paths,
    "freewheel-clutch": _freewheel,
    "sprag-wedge": _wedge,
    "sprag-engagement": _engagement,
    "sprag-friction": _sliding,
    "sprag-clutch": _clutch,
    "sprag-crown": _crown,
    "sprag-optimum": _crown,
    "sprag-optimum-40": _crown,
}
