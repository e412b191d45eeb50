"""Causes of error in formulas of polyhedral rings: wall, corners, contacts, plane assumption."""

from collections.abc import Mapping
from typing import Any

from verify.cases.polyhedral.inputs import HubRing
from verify.cases.ring.walls import quarter_fem
from verify.core.case import FemResult
from verify.judging.budget_statement import (
    Cause,
    Corrected,
    Rerun,
    Statement,
    plane_strain,
    plane_stress,
)

PROBLEM = "fem.contact.problem:ContactProblem"
THINNER, SHARPER, LIGHTER = 10, 10, 16


def thin_round(q: Any) -> Any:
    """The inputs `q` with a wall a tenth as thick and an unchanged mean diameter."""
    wall = q.delta_1 / THINNER
    return q.model_copy(update={"d_e": q.d_m + wall, "delta_1": wall})


def sharp(q: HubRing) -> HubRing:
    """The inputs `q` with a tenth of the fillet radius and unchanged wall in the corners."""
    return q.model_copy(update={"rho": q.rho / SHARPER})


def fem_round(q: HubRing, level: int) -> FemResult:
    """K of a round ring (round bore) that has the wall thickness of `q`."""
    from verify.cases.polyhedral.fem import UNIT
    from verify.cases.polyhedral.ring.reference import stiffness

    r_i, r_o = q.d_i / 2, q.d_e / 2
    ring = quarter_fem(q, r_i, r_o, "plane stress", level, pressures={"bore": UNIT})
    rim = ring.on_boundary("rim")
    u = float(rim.mean(rim.polar()[0]))
    K = stiffness(q, {"mid": u, "mean": u, "corner": u})["K_mid"]
    return FemResult(h=1 / level, values={"K_mid": K})


def fem_thin_round(q: HubRing, level: int) -> FemResult:
    """K of a round ring (round bore) that has a tenth of the wall thickness of `q`."""
    return fem_round(thin_round(q), level)


def light(q: Any) -> Any:
    """The inputs `q` with a sixteenth of the normal force; the contacts are a quarter as wide."""
    return q.model_copy(update={"N": q.N / LIGHTER})


def tight(q: Any) -> Any:
    """The inputs `q` with a quarter of the clearance and of the pressure."""
    return q.model_copy(update={"j_D": q.j_D / 4, "p_t": q.p_t / 4})


def clutch_tight(q: Any) -> Any:
    """The inputs `q` with a quarter of clearance (by a smaller race), pressure and torque."""
    return q.model_copy(
        update={"D_i": q.D_i - 0.75 * (q.D_i - 2 * q.d - q.d_e), "p_t": q.p_t / 4, "M_t": q.M_t / 4}
    )


LIMITED = Rerun(
    cause=Cause.PLANE, what="plane strain instead of plane stress", changes=plane_strain(PROBLEM),
    levels=(1,), shared=True,
)  # fmt: skip

SHARP, ROUND = "fillet radius / 10", "round bore of the diameter d_i instead of the polygonal bore"
K = ("K of the paper",)

BY_SERIES = "the series of an elastic ring on its rollers replaces the formula of the paper"

STATEMENTS: Mapping[str, Statement] = {
    "polyhedral-pressure": Statement(
        reruns=(
            Rerun(
                cause=Cause.GEOMETRY, what="wall thickness / 10, unchanged mean diameter",
                rows=("*Eq. 8*", "*Eq. 9*", "*Eq. 10"), inputs=thin_round,
            ),
            Rerun(
                cause=Cause.PLANE, what="plane strain instead of plane stress",
                rows=("*Eq. 8*", "*Eq. 9*", "*Eq. 10"), changes=plane_strain(), shared=True,
            ),
        ),
        finer=6,
    ),
    "polyhedral-ring": Statement(
        reruns=(
            Rerun(cause=Cause.GEOMETRY, what=SHARP, rows=K, inputs=sharp),
            Rerun(cause=Cause.GEOMETRY, what=ROUND, rows=K, fem=fem_round, after=SHARP),
            Rerun(cause=Cause.GEOMETRY,
                  what="in addition to the round bore, wall thickness / 10, "
                  "unchanged mean diameter",
                  rows=K, fem=fem_thin_round, after=ROUND),
            Rerun(cause=Cause.PLANE, what="plane strain instead of plane stress", rows=K,
                  changes=plane_strain(), shared=True),
        ),
        corrected=(
            Corrected("K = 1 against K for the mean displacement of the outer surface", "K_mean",
                      "the series includes the bending of the flats"),
            Corrected("K = 1 against K in the middle of the flats, plane strain", "K_mid_strain",
                      "the series includes the bending of the flats"),
            Corrected("mean hoop stress in the corners, Eq. 12 as printed", "sigma_tr"),
            *(
                Corrected(f"{row}, against the largest hoop stress in the fillets", "fillet",
                          "the largest stress by the series replaces the mean stress over the wall")
                for row in ("hoop stress, Eq. 9", "mean hoop stress, Eq. 12")
            ),
        ),
        finer=8,
    ),
    "polyhedral-map": Statement(finer=4),
    "polyhedral-locking": Statement(
        reruns=(
            Rerun(cause=Cause.GEOMETRY, what="clearance / 4, pressure / 4: narrower contact",
                  inputs=tight, levels=(1,)),
            LIMITED,
        ),
        corrected=(
            Corrected("resultant of the pressure on a side, Eq. 13 as printed", "side"),
            Corrected("force of a roller, Eqs. 13 and 16 without hub force", "N_alone", BY_SERIES),
            Corrected("force of a roller, Eqs. 13 and 16 with hub force", "N", BY_SERIES),
            Corrected("force of an elastic roller, Eqs. 13 and 16 without hub force", "N_elastic",
                      BY_SERIES),
            Corrected("blocking pressure, Eq. 19 with K = 1", "p_2",
                      "the series includes the bending of the flats"),
            Corrected("blocking pressure, Eq. 19 with K = 1, against a long ring in plane strain",
                      "p_2_long", "the series includes the bending of the flats"),
        ),
        finer=5, headline="force of a roller under pressure, series",
    ),
    "polyhedral-wedge": Statement(
        reruns=(
            Rerun(cause=Cause.GEOMETRY, what="force / 16: contact width / 4",
                  inputs=light),
            Rerun(cause=Cause.PLANE, what="plane stress instead of plane strain", shared=True,
                  changes=plane_stress(PROBLEM)),
        ),
        corrected=(
            Corrected("torque of free rollers, Eq. 3 as printed", "M_free"),
            Corrected("normal force per torque of free rollers, Eq. 4 as printed", "N_per_M"),
        ),
        finer=32,
        headline="stick half-width at T/(μN) = 0.6 (roller pressed without friction, then loaded "
        "tangentially)",
    ),
    "polyhedral-clutch": Statement(
        reruns=(
            Rerun(cause=Cause.GEOMETRY, what="clearance / 4, pressure / 4, torque / 4",
                  inputs=clutch_tight, levels=(1,)),
            LIMITED,
        ),
        corrected=(
            Corrected("torque, Eq. 20", "M_el", BY_SERIES),
            Corrected("torque of the first design, Eq. 21", "M_el", BY_SERIES),
            Corrected("pressure for the target torque, Eqs. 17 to 20", "p_need",
                      BY_SERIES),
            Corrected("torque, Eq. 20 as printed", "M_el", BY_SERIES),
            Corrected("torque of the first design, Eq. 21 as printed", "M_el", BY_SERIES),
            Corrected("pressure for the target torque, Eq. 17 as printed", "p_need",
                      BY_SERIES),
            Corrected("blocking pressure for the target torque, Eq. 17", "p_block", BY_SERIES),
            Corrected("blocking pressure for the target torque, Eq. 17 as printed", "p_block",
                      BY_SERIES),
        ),
        finer=5, headline="torque with elastic ring and rollers, series",
    ),
}  # fmt: skip
