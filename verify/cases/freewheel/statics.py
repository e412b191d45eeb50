"""Rows of a sector of star or cup on the equilibrium of forces and the limit without load."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from verify.case import Comparison, Level, Quantity, balance
from verify.cases.freewheel.bodies import OneClutch
from verify.core.case import Context
from verify.judging.tolerance_checks import SUBJECT, Agreement, Pair, demanded, suites

TORQUE = suites("the same tolerance as for the torque compared with the forces on the race")
BOTH = suites("twice the tolerance of 2e-3 for F_t/F_n at one contact")
OTHER = suites("the same tolerance as for the torque compared with the forces on the race")
NOISE = 5e-6  # least difference of F_t/N between meshes

Points = tuple[list[float], list[float], list[float]]


def accepted(
    q: Quantity, name: str, share: str, words: str, *, within: float, symbol: str = "",
    source: str = SUBJECT, by: str = "", inverse: bool = False,
) -> Comparison:  # fmt: skip
    """Row that evaluates the formula `q` with the forces of the reference, with a tolerance.

    `share` is the key of the computed value formula/reference - 1, or reference/formula - 1 if
    `inverse`. The uncertainty is twice the difference between the last two meshes. `words` precede
    the error in the text of the row.
    """

    def pair(context: Context) -> Pair:
        before, now = (level.values[share] for level in context.fem[-2:])
        stated = f"{words} {now:+.2%}, {within:.1%} accepted"
        return Pair(1 / (1 + now) if inverse else 1 + now, 1.0, 2 * abs(now - before), stated)

    check = Agreement(name=name, symbol=symbol or q.symbol, unit="1", accepted=within, by=by,
                      source=source, pair=pair, **demanded(within))  # fmt: skip
    return Comparison(check=check, quantity=q)


@dataclass(frozen=True, kw_only=True)
class Named:
    """Names of parts, and reasons for deviations from formulas, in rows of one kind of clutch."""

    cam: str
    race: str
    race_radius: str
    flat_distance: str
    form: str  # form of the torque equation
    cam_tilt: str  # why the forces on the cam differ from the formula
    race_tilt: str  # likewise on the race
    unlike_forces: str  # why the tangential forces of both contacts differ
    rolling: str  # what tangential forces deform: why the angle differs from the rolling angle


def balanced(clutch: Any, of_cam: Quantity, words: Named) -> Iterator[Comparison]:
    """Rows that insert the forces of the reference into the formulas of the class `clutch`.

    `of_cam` is the torque of both forces on the flats.
    """
    n = words
    for part, share, tilts in (n.cam, "flat", n.cam_tilt), (n.race, "race", n.race_tilt):
        yield accepted(
            clutch.mu_T, f"F_t/F_n on the {part} compared with tan(ψ/2)", f"share_{share}", tilts,
            symbol="F_t/F_n", within=2e-3, inverse=True,
        )  # fmt: skip
    on_race = f"z {n.race_radius} F_t of the {n.race} ({n.form})"
    on_cam = f"z (F_n x − F_t {n.flat_distance}) of the {n.cam} ({n.form})"
    yield accepted(clutch.torque, f"torque compared with {on_race}", "torque_race", "error",
                   within=1e-3)  # fmt: skip
    yield accepted(of_cam, f"torque compared with {on_cam}", "torque_cam", "error", within=1e-3,
                   source=OTHER)  # fmt: skip
    yield accepted(clutch.N, "equal normal forces of both contacts (Eq. 2)", "unlike_N",
                   "difference", within=1e-3, source=TORQUE,
                   by="force on the flat, taken as 1")  # fmt: skip
    yield accepted(clutch.F_t, "equal tangential forces of both contacts (Eq. 2)", "unlike_F_t",
                   f"{n.unlike_forces}: difference", within=4e-3,
                   source=BOTH, by="force on the flat, taken as 1")  # fmt: skip
    yield accepted(clutch.phi, "wind-up from the strain energy compared with that by exact "
                   "rolling, both by finite elements", "rolling", within=5e-3,
                   words=f"exact rolling neglects that tangential forces deform {n.rolling}: error"
                   )  # fmt: skip
    yield balance("forces", "balance of both contact forces on a roller", "ΣF", "1",
                  of={"one": 1.0}, bound=1e-9,
                  because="equilibrium of a free body, iterated by the solver")  # fmt: skip


def no_load(q: OneClutch, alpha_0: float, levels: Sequence[Level]) -> Points:
    """Points of the limit without load: ratio of (F_t/N)² (reference) to tan² alpha_0, minus 1.

    Each ratio is multiplied by (R + X + d_o - d_i)/(R + X). R is the radius of the race, X the
    distance of the flats. The product is linear in d_i + d_o.
    """
    found, tan = [], np.tan(alpha_0)
    for level in levels[-2:]:
        d_i, d_o = level.arrays["loads"][3:5]
        share = level.arrays["shares"].mean(axis=0) / tan
        found.append(share**2 * (1 + (d_o - d_i) / (q.race + q.flat)))
    overlap, u = d_i + d_o, np.maximum(np.abs(found[1] - found[0]), NOISE)
    return (overlap / overlap[-1]).tolist(), (found[1] - 1).tolist(), u.tolist()
