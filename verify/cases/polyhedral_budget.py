"""Error budgets of polyhedral rings: walls, corners, contacts and the plane assumption."""

from collections.abc import Mapping
from typing import Any

from verify.budget.statement import Cause, Rerun, Statement, plane_strain, plane_stress
from verify.cases.polyhedral_inputs import RoundRing

PROBLEM = "fem.contact.problem:ContactProblem"
THINNER, MORE, LIGHTER = 10, 4, 16


def thin_round(q: RoundRing) -> RoundRing:
    """A thinner wall about the same mean diameter."""
    wall = q.delta_1 / THINNER
    return q.model_copy(update={"d_e": q.d_m + wall, "delta_1": wall})


def many(q: Any) -> Any:
    """A bore with more flats, and a hub that still touches them; fillets as they are."""
    return q.model_copy(update={"z": MORE * q.z, "e": q.e / MORE})


def light(q: Any) -> Any:
    """A contact a quarter as wide."""
    return q.model_copy(update={"N": q.N / LIGHTER})


def tight(q: Any) -> Any:
    """A clearance a quarter as large, under a quarter of the pressure."""
    return q.model_copy(update={"j_D": q.j_D / 4, "p_t": q.p_t / 4})


def clutch_tight(q: Any) -> Any:
    """The same of a clutch, whose race says the clearance."""
    return q.model_copy(
        update={"D_i": q.D_i - 0.75 * (q.D_i - 2 * q.d - q.d_e), "p_t": q.p_t / 4, "M_t": q.M_t / 4}
    )


LIMITED = Rerun(
    cause=Cause.PLANE, what="plane strain instead of plane stress", changes=plane_strain(PROBLEM),
    levels=(1,), shared=True,
)  # fmt: skip

STATEMENTS: Mapping[str, Statement] = {
    "polyhedral-pressure": Statement(
        reruns=(
            Rerun(
                cause=Cause.GEOMETRY, what="a wall a tenth as thick, mean diameter as it is",
                rows=("*Eq. 8", "*Eq. 9*", "*Eq. 10"), inputs=thin_round,
            ),
            Rerun(
                cause=Cause.PLANE, what="plane strain instead of plane stress",
                rows=("*Eq. 8", "*Eq. 9*", "*Eq. 10"), changes=plane_strain(), shared=True,
            ),
        ),
        finer=6,
    ),
    "polyhedral-ring": Statement(
        reruns=(
            Rerun(cause=Cause.GEOMETRY, what="four times as many flats", rows=("K of the paper",),
                  inputs=many),
            Rerun(cause=Cause.PLANE, what="plane strain instead of plane stress",
                  rows=("K of the paper",), changes=plane_strain(), shared=True),
        ),
        finer=8,
    ),
    "polyhedral-map": Statement(finer=4),
    "polyhedral-locking": Statement(
        reruns=(
            Rerun(cause=Cause.GEOMETRY, what="clearance and pressure a quarter: a narrower contact",
                  inputs=tight, levels=(1,)),
            LIMITED,
        ),
        finer=5, headline="force of a roller under pressure, series",
    ),
    "polyhedral-wedge": Statement(
        reruns=(
            Rerun(cause=Cause.GEOMETRY, what="a sixteenth of the force: contacts a quarter as wide",
                  inputs=light),
            Rerun(cause=Cause.PLANE, what="plane stress instead of plane strain", shared=True,
                  changes=plane_stress(PROBLEM)),
        ),
        finer=32, headline="stick half-width of a roller let go, T/(μN) = 0.6",
    ),
    "polyhedral-clutch": Statement(
        reruns=(
            Rerun(cause=Cause.GEOMETRY, what="clearance, pressure and torque a quarter",
                  inputs=clutch_tight, levels=(1,)),
            LIMITED,
        ),
        finer=5, headline="torque of the elastic ring, series",
    ),
}  # fmt: skip
