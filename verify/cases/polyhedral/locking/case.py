"""The ring locked against its rollers: how much of the pressure reaches them."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from analytic.polyhedral import bore_pressure, expansion, forces
from analytic.polyhedral.hub_force import HubForce, hub_force
from analytic.polyhedral.locking import Locked, Roller, locked
from analytic.polyhedral.roller_load import roller_load
from analytic.polyhedral.sector import Sector
from analytic.polyhedral.wall_stress import bore_stress
from verify.cases.polyhedral.fem import largest_in_fillet, pressed_fem, whole
from verify.cases.polyhedral.locking import figures as shown
from verify.cases.polyhedral.locking.bounds import fillet_blur
from verify.cases.polyhedral.locking.claims import CHECKS
from verify.cases.polyhedral.locking.fem import LockedRing, held_fem
from verify.cases.polyhedral.locking.inputs import LockingInputs
from verify.cases.polyhedral.warnings import of_fillets
from verify.core.case import Case, FemResult, Output, Scan, Values
from verify.core.figures import Array, Field

LEVELS = (1, 2, 3, 4)
DRAWN = 2  # level of the curves
THICK = 0.15  # wall over outer diameter from which on a mesh is twice as fine
PRESSED = 1.02  # of the pressure that touches: from there on forces are compared
STEP = 0.05  # of the hub's force, either way, for its share

ALONG = 200  # points of the fillet


def hub_of(q: LockingInputs) -> tuple[float, float]:
    """The hub's force on a flat [N/m]: along its normal, and along it away from the middle."""
    normal = q.R_b / np.hypot(1, q.tan_phi)
    return float(normal), float(-normal * q.tan_phi)


def state(
    q: LockingInputs, p: float, hub: HubForce | None = None, *, elastic: bool = False
) -> Locked:
    """The locked ring by the series, its rollers rigid or `elastic` as the ring."""
    ring = Sector(z=q.z, d_e=q.d_e, d_i=q.d_i, rho=q.rho)
    own = {"E": q.E, "nu": q.nu} if elastic else {}
    return locked(sector=ring, roller=Roller(d=q.d, j_D=q.j_D, **own), p=p, E=q.E, nu=q.nu,
                  assumption="plane stress", hub=hub)  # fmt: skip


def analytic(q: LockingInputs) -> Values:
    ring = Sector(z=q.z, d_e=q.d_e, d_i=q.d_i, rho=q.rho)
    normal, along = hub_of(q)
    hub = hub_force(sector=ring, e=q.e, normal=normal, along=along)
    alone, pushed, soft = state(q, q.p_t), state(q, q.p_t, hub), state(q, q.p_t, elastic=True)
    wall = {"d_i": q.d_i, "d_e": q.d_e}
    K = bore_pressure.stiffness_factors(sector=ring, nu=q.nu, assumption="plane stress").mid
    p_1r = float(expansion.touching_pressure(j_D=q.j_D, **wall, E=q.E, K=K))
    p_2 = max(q.p_t - p_1r, 0.0)
    F = float(forces.pressure_force(p_2=p_2, b=1.0, d_i=q.d_i, z=q.z))
    phi_1 = float(np.arctan(q.tan_phi))
    values: dict[str, Any] = {
        "p_1r": p_1r, "p_2": p_2, "F": F, "touch": alone.touch,
        "touch with hub": pushed.touch,
        "N Eq. 16": forces.normal_force(F=F, R=q.R_b, phi_1=phi_1, gamma=0.0),
        "N": alone.N, "efficiency": alone.efficiency, "N with hub": pushed.N,
        "hub share": pushed.hub_share, "a": pushed.a,
        "p_0": 2 * pushed.N / (np.pi * pushed.a) if pushed.a else 0.0,
        "N elastic": soft.N, "efficiency elastic": soft.efficiency, "a elastic": soft.a,
        "a race": soft.a_race,
        "side": forces.pressure_force(p_2=q.p_t, b=1.0, d_i=q.d_i, z=q.z),
        "fillet": in_fillet(q, ring, hub, pushed),
    }  # fmt: skip
    unloaded = in_fillet(q, ring, hub, replace(pushed, N=0.0))
    rollers = abs(1 - unloaded / values["fillet"])
    values["fillet blur"] = fillet_blur(q, rollers, pushed.a)
    return {key: float(value) for key, value in values.items()}


def in_fillet(q: LockingInputs, ring: Sector, hub: HubForce, found: Locked) -> float:
    """Largest hoop stress [Pa] in the fillet under pressure, hub and rollers together."""
    at = ring.straight + np.linspace(0, 1, ALONG + 1) * ring.rho * ring.half_angle
    stress = q.p_t * bore_stress(at, sector=ring, field=bore_pressure.pressed(ring), p=1.0)
    stress = stress + bore_stress(at, sector=ring, field=hub)
    if found.N:
        load = roller_load(sector=ring, a=found.a)
        stress = stress + found.N * bore_stress(at, sector=ring, field=load)
    return float(stress.max())


def fem(q: LockingInputs, level: int) -> FemResult:
    hub, thick = hub_of(q), q.d_e / 2 - q.apothem > THICK * q.d_e
    fine = 2 * level if thick else level
    alone = LockedRing(q, fine, d=q.d, p=q.p_t)
    pushed = LockedRing(q, fine, d=q.d, e=q.e, p=q.p_t, hub=hub)
    soft = LockedRing(q, fine, d=q.d, p=q.p_t, elastic=True)
    R = [pushed.force(q.p_t, (k * hub[0], k * hub[1])) for k in (1 - STEP, 1, 1 + STEP)]
    both = pushed.at(q.p_t, hub)
    touch = both.touches[0]
    free = pressed_fem(q, level, "plane stress")
    rest = pushed.balance(q.p_t, hub)
    shares = {"efficiency": alone.efficiency(q.p_t), "efficiency elastic": soft.efficiency(q.p_t)}
    values = {
        "N": alone.force(q.p_t), **{key: share for key, (share, _) in shares.items()},
        "N with hub": R[1], "hub share": (R[2] - R[0]) / (2 * STEP * q.R_b),
        "a": touch.half_width((q.d_e / 2, 0.0)), "p_0": peak(touch),
        "balance x": rest[0], "balance y": rest[1],
        "side": -2 * (free.reaction("mid")[0] + free.reaction("corner")[0]) * q.p_t / 1e6,
        "fillet": largest_in_fillet(q, both.plane, q.p_t, name="ring.fillet"),
    }  # fmt: skip
    values |= elastic_rollers(q, soft)
    arrays: dict[str, Array] = {}
    fields: tuple[Field, ...] = ()
    if level == DRAWN:
        arrays["over pressure"] = np.array([
            (alone.force(p), pushed.force(p, hub), soft.force(p)) for p in shown.PRESSURES * q.p_t
        ]).T  # fmt: skip
        arrays |= supports(q)
    if level == LEVELS[-1]:
        coarse = LockedRing(q, 1, d=q.d, e=q.e, p=q.p_t, hub=hub).at(q.p_t, hub).plane.cells()
        fields = (whole("locked", q.z, coarse, von_mises=(coarse["von_mises"], "Pa")),)
    u_it = {key: 1e-10 * abs(value) for key, value in values.items()}
    u_it |= {key: u for key, (_, u) in shares.items()}
    return FemResult(h=1 / level, values=values, u_it=u_it, arrays=arrays, fields=fields)


def elastic_rollers(q: LockingInputs, ring: LockedRing) -> dict[str, float]:
    """Force and half-widths of elastic rollers, and what is left of forces on one [N/m]."""
    near, far = ring.half_widths(q.p_t)
    on_roller, on_race = (touch.force[0] for touch in ring.at(q.p_t).touches)
    return {
        "N elastic": ring.force(q.p_t), "a elastic": near, "a race": far,
        "balance roller": on_roller - on_race,
    }  # fmt: skip


def peak(touch: Any) -> float:
    """Pressure [Pa] above the middle of the flat."""
    return float(touch.pressure[np.argmin(np.abs(touch.x[1]))])


def supports(q: LockingInputs) -> dict[str, Array]:
    """Half-width and efficiency of rollers of other diameters, and of bonded stretches."""
    side, rollers = q.d_i * np.sin(q.half_angle), []
    for d in shown.diameters(q):
        ring = LockedRing(q, DRAWN, d=d, p=q.p_t)
        rollers.append((ring.half_widths(q.p_t)[0], ring.efficiency(q.p_t)[0]))
    bonded = [(w, held_fem(q, w) / side) for w in shown.widths(q)]
    return {"rollers": np.array(rollers).T, "bonded": np.array(bonded).T}


def warnings(q: LockingInputs, v: Values) -> Sequence[str]:
    found = []
    if not v["N"] > 0:
        found.append(
            f"p_t = {q.p_t / 1e6:.4g} MPa is below {v['p_1r'] / 1e6:.4g} MPa, at which the ring "
            "reaches its rollers: pressure alone does not lock them"
        )
    found += of_fillets(v["fillet"], E=q.E, R_p=q.R_p, when="")
    if v["p_0"] > 4e9:
        found.append(
            f"p_0 = {v['p_0'] / 1e6:.4g} MPa is beyond 4000 MPa, the static rating of hardened "
            "rollers (ISO 76)"
        )
    return found


def too_large(q: LockingInputs) -> str:
    """Rows compare forces of rollers, which there must be."""
    touch = state(q, q.p_t).touch
    if q.p_t < PRESSED * touch:
        return (
            f"p_t = {q.p_t / 1e6:.4g} MPa hardly presses the rollers, if at all: the ring reaches "
            f"them at {touch / 1e6:.4g} MPa and is compared from {PRESSED * touch / 1e6:.4g} MPa "
            "on, check it without --fem"
        )
    return ""


LOCKING = Case(
    id="polyhedral-locking",
    title="Polyhedral ring locked against its rollers",
    paper="belcin",
    place="Eqs. 7, 13, 16, 19",
    lead="The paper hands all of the blocking pressure to the rollers. The ring's own hoop force "
    "keeps a good part of it: finite elements with the roller as a contact, and complex potentials "
    "with Hertz's patch, say how much. Sizes and loads are the project's.",
    inputs=LockingInputs,
    analytic=analytic,
    reference=fem,
    levels=LEVELS,
    scans=(
        Scan(vary=("p_t=15MPa,30MPa,60MPa,100MPa", "delta_1=3mm,4mm,6mm", "z=4,6,8"), star=True),
    ),
    checks=CHECKS,
    outputs=(
        Output(key="p_1r", symbol="p_1r", unit="MPa",
               what="pressure at which the ring reaches its rollers", judged=False),
        Output(key="p_2", symbol="p_2", unit="MPa", what="blocking pressure (Eq. 19)",
               judged=False),
        Output(key="F", symbol="F/b", unit="N/mm",
               what="force of a roller, all of the pressure's (Eqs. 13 and 16)"),
        Output(key="N", symbol="N/b", unit="N/mm", what="force of a roller, series"),
        Output(key="efficiency", symbol="η", unit="1",
               what="share of a further pressure that reaches the rollers"),
        Output(key="N Eq. 16", symbol="N/b", unit="N/mm",
               what="force of a roller with the hub's (Eq. 16)"),
        Output(key="N with hub", symbol="N/b", unit="N/mm",
               what="force of a roller with the hub's, series"),
        Output(key="hub share", symbol="η_h", unit="1",
               what="share of a further hub force that reaches the rollers"),
        Output(key="a", symbol="a", unit="µm", what="half-width of the contact"),
        Output(key="p_0", symbol="p_0", unit="MPa", what="pressure on the ring, rigid rollers"),
        Output(key="N elastic", symbol="N/b", unit="N/mm",
               what="force of an elastic roller, without the hub's"),
        Output(key="efficiency elastic", symbol="η", unit="1",
               what="share of a further pressure that reaches elastic rollers"),
        Output(key="a elastic", symbol="a", unit="µm",
               what="half-width of an elastic roller's contact on the ring"),
        Output(key="a race", symbol="a", unit="µm", what="and on the race"),
        Output(key="fillet", symbol="σ_max", unit="MPa", what="hoop stress in the fillets"),
    ),
    readings=(
        "rollers and race are rigid, the ring is in plane stress: all of the ring's own compliance",
        "rollers that are said to be elastic are of the ring's material, in plane stress; the race "
        "stays rigid",
        "p_2 is what p_t exceeds K_mid p_1 by (Eq. 19 with K in the middle of the flats)",
        "the hub's friction acts towards the flat's middle: R makes ψ + φ_1 with the radius "
        "through its contact (Eq. 14)",
        "the side of the polygon in Eq. 13, not its arc; γ = 0 in Eq. 16: along the flat's normal",
    ),
    assumptions=(
        "linear elasticity, small strain; no friction at the rollers",
        "half a sector, symmetry on both cuts; the roller above the middle of the flat",
        "the hub's force at e counts as half of it on each side of the flat's middle",
    ),
    warnings=warnings,
    too_large=too_large,
    equations=shown.equations,
    sketch=shown.sketch,
    figures=shown.figures,
    pictures=shown.pictures,
)  # fmt: skip
