"""Locked polyhedral rings, and one pitch of roller and sprag clutches, compared with calculix."""

from functools import partial
from typing import Any

import numpy as np

from verify.cases.freewheel.cup.case import CUP
from verify.cases.freewheel.fem import pitch
from verify.cases.freewheel.sweep import rigid_force, starts
from verify.cases.freewheel.torque.case import TORQUE
from verify.cases.polyhedral.locking.case import LOCKING
from verify.cases.polyhedral.locking.fem import locked_fem
from verify.cases.sprag.wedge.case import WEDGE
from verify.cases.sprag.wedge.sweep import starts_by_fem
from verify.core.figures import Array
from verify.studies.crosscheck.clock import timed
from verify.studies.crosscheck.comparisons.touching import CONTACT, PENALTY, Touched, posed
from verify.studies.crosscheck.statement import CALCULIX, Cross, Numbers, Posed, Quantity

STIFF = 50.0  # slope of the penalty [E/a]
LOADED = 2  # of the sweep of a freewheel: at 0.4 of the overlap under N_0
FULL = 3  # of the sweep of a sprag clutch: at N_0
CELLS = 5  # on the half-width of the fine zones
Points = list[tuple[float, float]]


def locked(elastic: bool, refine: int) -> Posed:
    """Half a sector of the polyhedral ring under pressure, in contact with a roller."""
    from fem.plane.material import Elastic
    from verify.studies.crosscheck.calculix.contact import ContactDeck, Settings

    q: Any = LOCKING.inputs()
    ring = locked_fem(q, refine, d=q.d, p=q.p_t, elastic=elastic)
    state, seconds = timed(lambda: ring.at(q.p_t))
    deck = ContactDeck(
        states=[state], materials=Elastic(E=q.E, nu=q.nu), assumption="plane stress",
        how=Settings(slope=STIFF * q.E / state.touches[0].half_width()),
    )  # fmt: skip
    return posed(
        deck, {"force of a roller": 2 * state.touches[0].force[0]}, seconds,
        lambda fields: {"force of a roller": 2 * fields.force()[0]},
    )  # fmt: skip


def freewheel(case: Any) -> Posed:
    """Cam, roller and race with friction, at one state of the case's torque sweep."""
    from fem.plane.material import Elastic
    from verify.studies.crosscheck.calculix.contact import ContactDeck, Settings

    q: Any = case.inputs()
    one = pitch(q)
    start = starts(one, rigid_force(q) / q.L)[LOADED]
    state, seconds = timed(lambda: start.state(one, CELLS))
    deck = ContactDeck(
        states=[state.solution], materials=Elastic(E=q.E, nu=q.nu), assumption="plane strain",
        how=Settings(slope=STIFF * q.E / min(state.widths)),
    )  # fmt: skip
    inner, outer = state.solution.touches
    ours = both([inner.force, outer.force], [inner.moment(), outer.moment()], q.z * q.L)
    return posed(deck, ours, seconds, lambda fields: of_both(fields, q.z * q.L))


def sprag() -> Posed:
    """Races and sprag with friction; the races' radii are changed to model the interference."""
    from fem.plane.material import Elastic
    from verify.studies.crosscheck.calculix.contact import ContactDeck, Settings
    from verify.studies.crosscheck.calculix.numbering import Numbering

    q: Any = WEDGE.inputs()
    start = starts_by_fem(q)[FULL]
    state, seconds = timed(lambda: start.state(CELLS))
    numbering, place = Numbering(state.solution.bodies.basis), state.start
    shift = np.zeros((numbering.count, 2))
    for body, k, outwards in (("inner", 0, 1.0), ("outer", 1, -1.0)):
        own = np.unique(numbering.cells[:, numbering.body(body)]) - 1
        x: Array = numbering.x[:, own]
        shift[own] = (outwards * (place.overlaps[k] - place.bends[k]) * x / np.hypot(*x)).T
    deck = ContactDeck(
        states=[state.solution], materials=Elastic(E=q.E, nu=q.nu), assumption="plane strain",
        how=Settings(slope=STIFF * q.E / min(state.widths)), shift=shift,
    )  # fmt: skip
    inner, outer = state.solution.touches
    ours = both([inner.force, outer.force], [inner.moment(), outer.moment()], q.z * q.l)
    return posed(deck, ours, seconds, lambda fields: of_both(fields, q.z * q.l))


def both(forces: Points, moments: list[float], times: float) -> Numbers:
    """Magnitudes of force per length and of torque on the inner and outer part (name: value)."""
    (inner, outer), (on_inner, on_outer) = forces, moments
    return {
        "force on the inner part": float(np.hypot(*inner)),
        "force on the outer part": float(np.hypot(*outer)),
        "torque on the inner part": abs(on_inner) * times,
        "torque on the outer part": abs(on_outer) * times,
    }  # fmt: skip


def of_both(fields: Touched, times: float) -> Numbers:
    return both(
        [fields.force(i) for i in (0, 1)], [fields.moment(i) for i in (0, 1)], times
    )  # fmt: skip


HERE: Any = {"allowed": 5e-3, "why": PENALTY}
DRAWN: Any = {
    "allowed": CONTACT,
    "why": f"{PENALTY}; the radii of the races are changed by 1e-3 of a radius to model the "
    "interference",
}


def quantities(
    normal: tuple[str, str], torque: tuple[str, str], within: Any = HERE
) -> tuple[Quantity, ...]:
    """Definitions of the four quantities of `both`, each with the row to which it belongs."""
    return (
        Quantity(name="force on the inner part", row=normal[0], symbol="F", unit="N/mm",
                 beside=True, **within),
        Quantity(name="force on the outer part", row=normal[1], symbol="F", unit="N/mm",
                 beside=True, **within),
        Quantity(name="torque on the inner part", row=torque[0], symbol="T", unit="N m",
                 beside=True, **within),
        Quantity(name="torque on the outer part", row=torque[1], symbol="T", unit="N m",
                 beside=True, **within),
    )  # fmt: skip


NORMAL = (
    "normal force under torque (Eqs. 2, 3)", "equal normal forces of both contacts (Eq. 2)"
)  # fmt: skip
CLUTCHES = (
    Cross(
        id="polyhedral-locking, rigid roller", case="polyhedral-locking", solver=CALCULIX,
        what="half a sector of the ring under pressure, in contact with a rigid roller, "
        "plane stress",
        pose=partial(locked, False, 2),
        quantities=(
            Quantity(name="force of a roller", row="force of a roller under pressure, series",
                     symbol="N/b", unit="N/mm", **HERE),
        ),
    ),
    Cross(
        id="polyhedral-locking, elastic roller", case="polyhedral-locking", solver=CALCULIX,
        what="half a sector of the ring under pressure, in contact with half an elastic roller in "
        "a rigid race, plane stress",
        pose=partial(locked, True, 1),
        quantities=(
            Quantity(name="force of a roller", symbol="N/b", unit="N/mm", **HERE,
                     row="force of an elastic roller under pressure, series"),
        ),
    ),
    Cross(
        id="freewheel-torque", case="freewheel-torque", solver=CALCULIX,
        what="star, roller and ring of one pitch with friction, plane strain",
        pose=partial(freewheel, TORQUE),
        quantities=quantities(
            NORMAL,
            ("torque compared with z (F_n x − F_t X) of the star (Eq. 3, corrected)",
             "torque compared with z R F_t of the ring (Eq. 3, corrected)"),
        ),
    ),
    Cross(
        id="freewheel-cup", case="freewheel-cup", solver=CALCULIX,
        what="shaft, roller and cup of one pitch with friction, plane strain",
        pose=partial(freewheel, CUP),
        quantities=quantities(
            NORMAL,
            ("torque compared with z R_s F_t of the shaft (Eq. 3 for a cup)",
             "torque compared with z (F_n x − F_t X_o) of the cup (Eq. 3 for a cup)"),
        ),
    ),
    Cross(
        id="sprag-wedge", case="sprag-wedge", solver=CALCULIX,
        what="races and sprag of one pitch with friction, plane strain",
        pose=sprag,
        quantities=quantities(
            ("normal force (Eq. 10), at T",
             "excess of N_e over N_i (zero in the paper), at N_0"),
            ("torque n_s N tan(ν) OA, at N_0",
             "torque on the inner race, compared with that on the outer"),
            DRAWN,
        ),
    ),
)  # fmt: skip
