"""One pitch of two races with a body between them, as a contact problem in plane strain."""

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from skfem.mesh import Mesh2D

    from fem.contact.along import Along
    from fem.contact.pairs import Pair
    from fem.contact.problem import ContactProblem
    from fem.plane.supports import Support


def pitch_problem(
    mesh: "Mesh2D", contacts: "Sequence[Pair]", *, E: float, nu: float, z: int,
    races: tuple[str, str], turned: Sequence[str], supports: "Mapping[str, Support] | None" = None,
    along: "Along | None" = None,
) -> "ContactProblem":  # fmt: skip
    """Contact problem of one of `z` equal pitches.

    The `races` are cut at the boundaries "left" and "right". The mean rotation of the boundaries
    `turned` is prescribed. Other motions are free, so that races can expand like rings. E [Pa] and
    nu apply to all bodies.
    """
    # imported on use: reading a case loads no solver
    from fem.contact.problem import ContactProblem
    from fem.plane.material import Elastic
    from fem.plane.means import Mean
    from fem.plane.ties import Tie

    return ContactProblem(
        mesh,
        materials=Elastic(E=E, nu=nu),
        assumption="plane strain",
        supports=supports,
        contacts=contacts,
        ties=[
            Tie(leader=f"{body}.right", follower=f"{body}.left", angle=2 * math.pi / z)
            for body in races
        ],
        means={name: Mean({"r": 0.0}) for name in turned},
        along=along,
    )
