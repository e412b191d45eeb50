"""Finite elements of a freewheel with friction: torque only, axial load, beyond the limit."""

import math
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from analytic.freewheel.geometry import InnerCam
from fem.wedge.flat_place import Pitch
from fem.wedge.pulled import EDGES, Borne, Pulled, at_torque, lever_left, sector, yielding
from fem.wedge.sliding import driven, let_out, under_load
from fem.wedge.slip_limit import Limit, over_angles
from verify.case import Level
from verify.cases.freewheel.pulled_sector import field, one_pulled

if TYPE_CHECKING:
    from verify.cases.freewheel.friction.case import FreewheelFriction

LEVELS = (4, 6, 8)  # cells on the half-width of the fine zones
STEPS = (1.0, 2.0, 3.0, 4.0)  # steps of the ring along z over the deflection at the limit
FREE = (1.0, 2.0, 5.0, 10.0, 18.0, 27.0, 37.0)  # likewise with the ring fixed
SOLVED = 1e-9  # relative to N: force balance of a body held by contact only


def solve(q: "FreewheelFriction", level: int) -> Level:
    """Results of a level: with ample friction, and on the path to slip.

    The finest mesh also gives the motion beyond slip.
    """
    one = one_pulled(q)
    start = at_torque(one, level)
    rest, held = under_load(one, start, level)
    alone, borne = Borne.by(rest), Borne.by(held)
    missed = abs(rest.torque * q.L / q.T - 1)
    per_torque = q.T / rest.torque  # of forces, at an angle that hardly changes
    values = {
        "F_t": Borne.on_mesh(rest).F_t[1] * per_torque, "N": alone.N.mean() * per_torque,
        "F_a": borne.F_z[0] * per_torque, "balance": borne.F_z.sum() * q.L,
        "mu_T": alone.tangent, "mu_req": borne.required.mean(),
    }  # fmt: skip
    # tan² alpha is linear in the approaches; T increases more than in proportion to them
    u_it = {key: (EDGES + missed / 2) * values[key] for key in ("mu_T", "mu_req", "N")}
    u_it |= dict.fromkeys(("F_t", "F_a"), SOLVED * values["N"])
    there = sector(one.q, start, level, q.mu, driven=True)
    stuck = there.rest(rest.drags)
    unit = yielding(one, there, stuck)
    path = driven(there, stuck, [u * unit for u in STEPS])
    # slip depends on the normals of the mesh: from its angle to the angle of the given torque
    own = lever_left(q.mu, stuck.place) / lever_left(q.mu, stuck.start)
    force = -own * path[:, 5] / path[:, 3] * q.T / q.R
    turned = np.diff(path[:, 1]) / np.diff(path[:, 0]) / own
    values |= {"F_lim": force[-1], "creep": turned[-1]}
    steep = 1 / (1 - (alone.tangent / q.mu) ** 2)  # d ln(F_lim)/d ln(tan alpha)
    u_it["F_lim"] = abs(force[-1] - force[-2]) + steep * (EDGES + missed) * force[-1]
    u_it["creep"] = abs(turned[-1] - turned[-2]) + steep * EDGES * turned[-1]
    arrays = {
        "tan": np.array([math.tan(at.psi / 2) for at in (rest.place, rest.start)]),
        "loaded": np.array([borne.N, borne.F_t, borne.F_z]),
        "creep": path,
    }  # fmt: skip
    if level == LEVELS[-1]:
        bound = Limit(one, start, rest.drags)
        arrays |= {
            "shares": bound.shares(), "onset": bound.of_torque(), "axial_onset": bound.of_load(),
            "angles": over_angles(
                one, start, rest, N=float(alone.N.mean()), unit=unit, built=partial(with_flat, one)
            ),
            "let_out": let_out(there, stuck, [u * unit for u in FREE]),
        }  # fmt: skip
    return Level(
        h=1 / level, values={k: float(v) for k, v in values.items()},
        u_it={k: float(v) for k, v in u_it.items()}, arrays=arrays, fields=(field(held),),
    )  # fmt: skip


def with_flat(one: Pulled, X: float) -> Pitch:
    """The pitch with its flats at the distance `X` [m]; raises ValueError if no wedge exists."""
    q = one.q
    InnerCam(R=q.race, r=q.r, X=X, z=q.z)
    return replace(q, flat=X)
