"""Finite-element results of the locked ring: forces, widths, pressures, residuals of balances."""

from typing import TYPE_CHECKING, Any

import numpy as np

from verify.case import Level
from verify.cases.polyhedral.fem import UNIT, factors_fem, in_fillet_fem, pressed_fem, whole_fem
from verify.cases.polyhedral.locking.fem import held_fem, locked_fem
from verify.cases.polyhedral.locking.inputs import LockingInputs
from verify.core.figures import Array, Field

if TYPE_CHECKING:
    from fem.contact.locked import LockedSector

LEVELS = (1, 2, 3, 4)
DRAWN = 2  # level of the curves
THICK = 0.15  # wall over outer diameter above which a mesh is twice as fine
STEP = 0.05  # relative change of the hub's force in both directions, for its share
SIZES = (0.25, 0.5, 1.0, 2.0, 4.0)  # diameters of the swept rollers over the given one
STRETCHES = (0.005, 0.01, 0.02, 0.05, 0.1)  # distances above the flat over the wall
PRESSURES = np.linspace(0, 1.2, 9)  # pressures of the dots over p_t


def solve(q: LockingInputs, level: int) -> Level:
    """Results for `level`: pressure only, with hub force, with elastic rollers."""
    hub, thick = q.push, q.d_e / 2 - q.apothem > THICK * q.d_e
    fine = 2 * level if thick else level
    alone = locked_fem(q, fine, d=q.d, p=q.p_t)
    pushed = locked_fem(q, fine, d=q.d, e=q.e, p=q.p_t, hub=hub)
    soft = locked_fem(q, fine, d=q.d, p=q.p_t, elastic=True)
    N = [pushed.force(q.p_t, (k * hub[0], k * hub[1])) for k in (1 - STEP, 1, 1 + STEP)]
    both = pushed.at(q.p_t, hub)
    touch = both.touches[0]
    free, long = (pressed_fem(q, level, a) for a in ("plane stress", "plane strain"))
    rest = pushed.balance(q.p_t, hub)
    shares = {
        "efficiency_alone": alone.efficiency(q.p_t), "efficiency_elastic": soft.efficiency(q.p_t),
    }  # fmt: skip
    values = {
        "N_alone": alone.force(q.p_t), **{key: share for key, (share, _) in shares.items()},
        "N": N[1], "hub_share": (N[2] - N[0]) / (2 * STEP * q.R_b),
        "a": touch.half_width((q.d_e / 2, 0.0)), "p_0": peak(touch),
        "balance_x": rest[0], "balance_y": rest[1],
        "side": -2 * (free.reaction("mid")[0] + free.reaction("corner")[0]) * q.p_t / 1e6,
        "fillet": in_fillet_fem(q, both.plane, q.p_t, name="ring.fillet"),
        "p_2": q.p_t - UNIT * q.j_D / 2 / factors_fem(q, free)["mid"],
        "p_2_long": q.p_t - UNIT * q.j_D / 2 / factors_fem(q, long)["mid"],
    }  # fmt: skip
    values |= elastic_rollers(q, soft)
    arrays: dict[str, Array] = {}
    fields: tuple[Field, ...] = ()
    if level == DRAWN:
        arrays["over pressure"] = np.array([
            (alone.force(p), pushed.force(p, hub), soft.force(p)) for p in PRESSURES * q.p_t
        ]).T  # fmt: skip
        arrays |= supports(q)
    if level == LEVELS[-1]:
        coarse = locked_fem(q, 1, d=q.d, e=q.e, p=q.p_t, hub=hub).at(q.p_t, hub).plane.cells()
        fields = (whole_fem("locked", q.z, coarse, von_mises=(coarse["von_mises"], "Pa")),)
    u_it = {key: 1e-10 * abs(value) for key, value in values.items()}
    u_it |= {key: u for key, (_, u) in shares.items()}
    return Level(h=1 / level, values=values, u_it=u_it, arrays=arrays, fields=fields)


def elastic_rollers(q: LockingInputs, ring: "LockedSector") -> dict[str, float]:
    """Force [N/m] and half-widths [m] of elastic rollers, and residual of the balance of forces."""
    near, far = ring.half_widths(q.p_t)
    on_roller, on_race = (touch.force[0] for touch in ring.at(q.p_t).touches)
    return {
        "N_elastic": ring.force(q.p_t), "a_elastic": near, "a_race_elastic": far,
        "balance_roller": on_roller - on_race,
    }  # fmt: skip


def peak(touch: Any) -> float:
    """Contact pressure [Pa] above the middle of the flat."""
    return float(touch.pressure[np.argmin(np.abs(touch.x[1]))])


def supports(q: LockingInputs) -> dict[str, Array]:
    """Half-widths [m] and load-transfer ratios, by name.

    "rollers" has the values for rollers of varied diameter, "bonded" those for a rim that is fixed
    over varied widths.
    """
    side, rollers = q.d_i * np.sin(q.half_angle), []
    for d in diameters(q):
        ring = locked_fem(q, DRAWN, d=d, p=q.p_t)
        rollers.append((ring.half_widths(q.p_t)[0], ring.efficiency(q.p_t)[0]))
    bonded = [(w, held_fem(q, w) / side) for w in widths(q)]
    return {"rollers": np.array(rollers).T, "bonded": np.array(bonded).T}


def diameters(q: LockingInputs) -> list[float]:
    """Diameters [m] of the rollers of the sweep that fit side by side."""
    sine = np.sin(q.half_angle)
    room = 0.98 * (q.d_e + q.j_D) * sine / (1 - sine)
    return [float(d) for d in q.d * np.array(SIZES) if d < room]


def widths(q: LockingInputs) -> list[float]:
    """Half-widths [m] of the fixed parts of the rim, which replace the rollers."""
    wall = min(q.d_e / 2 - q.apothem, q.half_angle * q.d_e / 2)
    return [float(w) for w in wall * np.array(STRETCHES)]
