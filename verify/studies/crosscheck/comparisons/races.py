"""A roller in a race with a fixed rim, compared with calculix."""

import numpy as np

from verify.cases.contact.line.reference import race_fem
from verify.cases.contact.line.ring import RollerInRace
from verify.studies.crosscheck.clock import timed
from verify.studies.crosscheck.comparisons.touching import (
    CONTACT,
    PENALTY,
    Touched,
    along_first_moment,
    posed,
)
from verify.studies.crosscheck.statement import CALCULIX, Cross, Numbers, Posed, Quantity

STIFF = 500.0  # slope of the penalty [E/a]
LEVEL = 3
LOAD = "load at the approach of the project's solution"


def race() -> Posed:
    """A quarter of the roller and half the race; the displacement under the load is prescribed."""
    from fem.plane.material import Elastic
    from verify.studies.crosscheck.calculix.contact import ContactDeck, Settings

    q = RollerInRace()
    steel = {"roller": Elastic(E=q.E_1, nu=q.nu_1), "race": Elastic(E=q.E_2, nu=q.nu_2)}
    found = race_fem(q, LEVEL)
    state, seconds = timed(
        lambda: found.problem.solve(displacements={found.cut: {"y": -found.approach}})
    )
    deck = ContactDeck(
        states=[state], materials=steel, assumption="plane strain",
        how=Settings(slope=STIFF * max(q.E_1, q.E_2) / found.a),
    )  # fmt: skip
    ours = {
        LOAD: 2 * abs(state.touches[0].force[1]), "a": along_first_moment(state.touches[0]),
        "p_0": found.peak,
    }  # fmt: skip

    def there(fields: Touched) -> Numbers:
        force = abs(fields.force()[1])
        # the moment about the origin, where the contact begins, is that of the forces along y
        a = 3 * np.pi / 4 * abs(fields.moment()) / force
        return {LOAD: 2 * force, "a": a, "p_0": fields.peak()}

    return posed(deck, ours, seconds, there)


RACES = (
    Cross(
        id="contact-ring", case="contact-ring", solver=CALCULIX,
        what="a quarter of a roller in half a race with fixed rim, plane strain", pose=race,
        quantities=(
            Quantity(name=LOAD, row="approach of roller centre and rim", beside=True,
                     symbol="P(δ)", unit="N/mm", allowed=CONTACT, why=PENALTY),
            Quantity(name="a", row="half-width, Hertz", symbol="a", unit="µm", allowed=CONTACT,
                     why=PENALTY),
            Quantity(name="p_0", row="peak pressure, Hertz", symbol="p_0", unit="MPa",
                     allowed=CONTACT, why=PENALTY),
        ),
    ),
)  # fmt: skip
