"""The round ring that pressure expands until it touches the rollers, compared with calculix."""

from functools import partial
from typing import TYPE_CHECKING, Any

from verify.cases.polyhedral.pressure.case import PRESSURE
from verify.studies.crosscheck.clock import timed
from verify.studies.crosscheck.comparisons.plane import (
    AVERAGED,
    LINEAR,
    MESH,
    hoop,
    outwards,
    posed,
)
from verify.studies.crosscheck.statement import CALCULIX, Cross, Posed, Quantity

if TYPE_CHECKING:
    from fem.plane.solution import PlaneSolution

FINE = 4  # of the case's meshes
UNIT = 1e-3  # E, the pressure that is solved for
NODAL = "the project computes the stresses from calculix's displacements"


def expanded(assumption: Any) -> Posed:
    """A quarter of the ring under pressure in its bore; calculix integrates the pressure."""
    from fem.plane.material import Elastic
    from fem.plane.solve import solve_plane
    from meshes.ring.quarter import quarter_ring
    from verify.studies.crosscheck.calculix.plane import PlaneDeck

    q: Any = PRESSURE.inputs()
    steel, loads = Elastic(E=q.E, nu=q.nu), {"bore": UNIT * q.E}
    mesh = quarter_ring(r_i=q.d_i / 2, r_o=q.d_e / 2, refine=FINE)
    ring, seconds = timed(lambda: solve_plane(
        mesh, materials=steel, assumption=assumption, supports={"x=0": "x", "y=0": "y"},
        pressures=loads,
    ))  # fmt: skip
    deck = PlaneDeck(solution=ring, materials=steel, assumption=assumption, pressures=loads)

    def read(solution: "PlaneSolution") -> dict[str, float]:
        share = q.j_D / (2 * outwards(solution, "rim"))  # of the pressure that closes j_D
        return {
            "p": share * UNIT * q.E, "middle": 2 * share * outwards(solution, "middle"),
            "hoop": share * hoop(solution, "rim"),
        }  # fmt: skip

    return posed(deck, read(ring), seconds, lambda fields: read(fields.solution))


ROUNDS = tuple(
    Cross(
        id=f"polyhedral-pressure, {a}", case="polyhedral-pressure", solver=CALCULIX,
        what=f"quarter of a round ring under pressure, {a}", pose=partial(expanded, a),
        quantities=(
            Quantity(name="p", row=f"pressure that closes the clearance, {a}", symbol="p",
                     unit="MPa", allowed=LINEAR, why=MESH),
            *more,
        ),
    )
    for a, more in (
        ("plane stress", (
            Quantity(name="middle", row="growth of the mean diameter, Eq. 8", symbol="Δd_m",
                     unit="µm", allowed=LINEAR, why=MESH),
            Quantity(name="hoop",
                     row="hoop stress, Eq. 9, against the hoop stress at the outer surface",
                     symbol="σ_t", unit="MPa", allowed=AVERAGED, why=NODAL),
        )),
        ("plane strain", ()),
    )
)  # fmt: skip
