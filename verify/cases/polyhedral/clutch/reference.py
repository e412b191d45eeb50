"""Finite-element results of the clutch: torque with elastic and with rigid rollers."""

from math import isfinite

from verify.case import Level
from verify.cases.polyhedral.clutch.fem import driven_fem
from verify.cases.polyhedral.clutch.inputs import ClutchInputs
from verify.cases.polyhedral.fem import UNIT, factors_fem, in_fillet_fem, pressed_fem, whole_fem
from verify.core.figures import Field

LEVELS = (1, 2, 3, 4)


def solve(q: ClutchInputs, level: int) -> Level:
    """Results under p_t, and pressure for the target torque, on the mesh of `level`."""
    hub = driven_fem(q, level, elastic=True)
    N, N_t = hub.N, q.M_t / (q.grip * q.b * q.z * q.D_i / 2)
    if not isfinite(N):
        raise ArithmeticError(
            "the clutch locks itself by the hub force: pressure does not limit the roller force"
        )
    p = hub.pressure(N_t)
    state = hub.at(q.p_t, N)
    rest = hub.fine.balance(q.p_t, hub.push(N))
    values = {
        "N_el": N * q.b, "M_el": q.grip * N * q.b * q.z * q.D_i / 2, "p_need": p,
        "p_block": p - touching(q, level),
        "fillet": in_fillet_fem(q.ring, state.plane, q.p_t, name="ring.fillet"),
        "balance_x": rest[0], "balance_y": rest[1],
        "moment": q.b * q.z * moment(q, hub.push(N)) - q.grip * N * q.b * q.z * q.D_i / 2,
    }  # fmt: skip
    if isfinite(N_rigid := driven_fem(q, level, elastic=False).N):
        values["M_rigid"] = q.grip * N_rigid * q.b * q.z * q.D_i / 2
    u_it = {key: 1e-9 * abs(value) for key, value in values.items()}
    fields = (drawn_fem(q, N),) if level == LEVELS[-1] else ()
    return Level(h=1 / level, values=values, u_it=u_it, fields=fields)


def drawn_fem(q: ClutchInputs, N: float) -> Field:
    """Field of ring and rollers under p_t and the roller force N [N/m], on a coarse mesh."""
    coarse = driven_fem(q, 1, elastic=True).at(q.p_t, N).plane.cells()
    return whole_fem("driven", q.z, coarse, von_mises=(coarse["von_mises"], "Pa"))


def touching(q: ClutchInputs, level: int) -> float:
    """Pressure [Pa] at which the free ring reaches its rollers, in the middle of the flats."""
    free = pressed_fem(q.ring, level, "plane stress")
    return UNIT * q.j_D / 2 / factors_fem(q.ring, free)["mid"]


def moment(q: ClutchInputs, push: tuple[float, float]) -> float:
    """Moment per width [N] about the axis, caused by a force [N/m] on a flat at e.

    `push` contains the normal component of the force and the component along the flat.
    """
    return q.e * push[0] - q.ring.apothem * push[1]
