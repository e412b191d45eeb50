"""Unbalance response of every member: amplitudes and loads over the speed and at the peaks.

Nodes are numbered from 1 as in the paper; the first axis of arrays is the member (m,).
"""

from typing import Any

import numpy as np

from verify.cases.rotor.sprag.inputs import PRINTED, RPM, SpragRotorInputs
from verify.cases.rotor.sprag.layout import DISCS, INNER, OPPOSITE, OUTER
from verify.cases.rotor.sprag.system_fem import Damped, rotor_fem
from verify.core.figures import Array

SHOWN_NODES = (4, 6, 11, 16, 19, 21)  # nodes of Figs. 9 to 11
NEAR = np.outer(PRINTED, 1 + np.linspace(-0.05, 0.05, 17)).ravel()
GRID = np.sort(np.concatenate([np.geomspace(3000, 42_000, 60) * RPM, NEAR]))
MOVED = 11  # node of unbalance 1 according to a remark in Sec. 2.2
WINDOW = np.linspace(-1, 1, 25)  # speeds about a peak, relative to the half-width of the window
WIDEST = 0.055  # largest half-width over the speed: peaks 3 and 5 differ by 12 %
RATIOS = 3.0  # half-width of the window over the damping ratio
BAND = (5, 50, 95)  # per cent of members
SMALL_OFFSETS = (0.01, 0.02)
THETA_Z = 5


def damping_ratios_fem(q: SpragRotorInputs, members: int) -> Array:
    """Damping ratios (m, 2) at critical speeds 1 and 5."""
    from fem.rotor.peaks import spread_ratios

    return spread_ratios(q.zeta_low, q.zeta_high, PRINTED[-1] / PRINTED[0], members)


def damped(zeta: Array) -> Damped:
    """Critical speeds 1 and 5 [rad/s], and the damping ratios (2,) there."""
    return (PRINTED[0], float(zeta[0])), (PRINTED[-1], float(zeta[1]))


def windows(zeta: Array) -> Array:
    """Speeds (3, 25) [rad/s] in windows around the three critical speeds."""
    wide = np.minimum(RATIOS * zeta[[0, 1, 1]], WIDEST)
    return np.asarray(np.array(PRINTED)[:, None] * (1 + wide[:, None] * WINDOW))


def responses_fem(q: SpragRotorInputs, members: Array) -> dict[str, Array]:
    """All responses of the members (m, 12) that rows and figures use."""
    zeta = damping_ratios_fem(q, len(members))
    each = [_member(q, p, z) for p, z in zip(members, zeta, strict=True)]
    found = {key: np.stack([one[key] for one in each]) for key in each[0]}
    over = ("nodes over speed", "bearings over speed")
    bands = {key: np.percentile(found.pop(key), BAND, axis=0) for key in over}
    return found | bands | {"zeta": zeta, "grid": GRID}


def _member(q: SpragRotorInputs, p: Array, zeta: Array) -> dict[str, Array]:
    even = rotor_fem(p, damping=damped(zeta))
    return (bending_fem(q, even, zeta) | torsion_fem(q, p, zeta, even)
            | orbits_fem(q, p, zeta, even))  # fmt: skip


def bending_fem(q: SpragRotorInputs, rotor: Any, zeta: Array) -> dict[str, Array]:
    """Peak amplitudes (U_2, 3, 22), loads of bearings 3 and 4 (U_2, 3, 2), curves; by name."""
    from fem.rotor.peaks import above_chord
    from fem.rotor.response import unbalance_responses

    speeds = np.concatenate([GRID, windows(zeta).ravel()])
    one, two, moved = unbalance_responses(rotor, speeds, [{n - 1: 1.0} for n in (*DISCS, MOVED)])
    x = [
        np.stack([response.at(node)[:, 0] for node in range(OUTER + INNER)])
        for response in (one, two, moved)
    ]
    loads = [np.stack([r.link_load(k)[:, 0] for k in range(2)]) for r in (one, two)]

    def combined(unit: list[Any], sense: int = 1) -> Array:
        U_2 = sense * q.unbalances_2[:, None, None]
        return np.asarray(np.abs(q.U_1 * unit[0] + U_2 * unit[1]))

    nodes, bearings = combined(x), combined(loads)  # U_2, nodes or bearings, speeds
    return {
        "peaks": peaks_fem(nodes), "peaks, moved": peaks_fem(combined(x[::-1]))[0],
        "loads": peaks_fem(bearings), "convex": above_chord(together_fem(q, rotor), q.unbalances_2),
        "peaks" + OPPOSITE: peaks_fem(combined(x, -1)),
        "loads" + OPPOSITE: peaks_fem(combined(loads, -1)),
        "nodes over speed": nodes[:, [n - 1 for n in SHOWN_NODES], : GRID.size],
        "bearings over speed": bearings[:, :, : GRID.size],
    }  # fmt: skip


def together_fem(q: SpragRotorInputs, rotor: Any) -> Array:
    """Amplitudes (U_2, 2, speeds) of nodes 4 and 19; both unbalances act in one solution."""
    from fem.rotor.response import unbalance_responses

    acting = [{DISCS[0] - 1: q.U_1, DISCS[1] - 1: U_2} for U_2 in q.unbalances_2.tolist()]
    solved = unbalance_responses(rotor, NEAR, acting)
    return np.array([[np.abs(r.at(node - 1)[:, 0]) for node in DISCS] for r in solved])


def peaks_fem(f: Array) -> Array:
    """Peaks (U_2, 3, k) of the curves f (U_2, k, speeds) in the windows at critical speeds."""
    from fem.rotor.peaks import peaks

    near = f[:, :, GRID.size :].reshape(*f.shape[:2], len(PRINTED), WINDOW.size)
    return peaks(near).swapaxes(1, 2)


def torsion_fem(q: SpragRotorInputs, p: Array, zeta: Array, even: Any) -> dict[str, Array]:
    """Torsion (3, 22) at the critical speeds, with and without offset; angular momenta."""
    from fem.rotor.response import unbalance_response

    def offset_by(offset: float) -> Any:
        return rotor_fem(p, damping=damped(zeta), offset=offset)

    def turned(rotor: Any, sense: int = 1) -> Any:
        U = {DISCS[0] - 1: q.U_1, DISCS[1] - 1: sense * q.U_2}
        q_all = unbalance_response(rotor, PRINTED, U).q
        return q_all.reshape(3, -1, 6)[:, :, THETA_Z]

    rotor = offset_by(q.offset)
    with_offset, other = turned(rotor), turned(rotor, -1)
    small = np.stack([np.abs(turned(offset_by(offset))) for offset in SMALL_OFFSETS])
    M = rotor.M[THETA_Z::6, THETA_Z::6]
    split = np.arange(OUTER + INNER) < OUTER
    momenta = [with_offset @ M @ part for part in (split, ~split)]
    return {
        "torsion": np.abs(with_offset), "torsion" + OPPOSITE: np.abs(other),
        "torsion, small offsets": small,
        "torsion, no offset": np.abs(turned(even)),
        "momenta": np.abs(np.array([momenta[0] + momenta[1], momenta[1]])),
        "turned": np.stack([with_offset[:, n - 1] for n in DISCS]),
        "turned" + OPPOSITE: np.stack([other[:, n - 1] for n in DISCS]),
        "inertia": np.array([part @ M @ part for part in (1.0 * split, 1.0 * ~split)]),
    }  # fmt: skip


def orbits_fem(q: SpragRotorInputs, p: Array, zeta: Array, even: Any) -> dict[str, Array]:
    """Orbit axes of nodes 4 and 19 at the rig's speed, on isotropic and anisotropic supports."""
    from fem.rotor.response import unbalance_response

    U = {DISCS[0] - 1: q.u_rig_1, DISCS[1] - 1: q.u_rig_2}
    found = {}
    uneven = rotor_fem(p, damping=damped(zeta), anisotropy=q.anisotropy)
    for name, rotor in (("isotropic", even), ("anisotropic", uneven)):
        response = unbalance_response(rotor, q.rig_speed, U)
        orbits = [response.orbit(node - 1) for node in DISCS]
        found[f"axes, {name}"] = np.array([[o.major, abs(o.minor)] for o in orbits])
        found[f"orbit, {name}"] = np.array([[o.x, o.y] for o in orbits])
    return found
