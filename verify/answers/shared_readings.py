"""Assumptions that formula and reference share.

Their agreement does not verify these assumptions.
"""

from collections.abc import Mapping
from typing import Any

from verify.answers.shared.clutches import CLUTCHES
from verify.answers.shared.contacts import CONTACTS
from verify.answers.shared.record import Function, SharedReading, Values
from verify.answers.shared.rings import RINGS
from verify.answers.shared.springs import SPRINGS

__all__ = ["SHARED", "SharedReading", "shared_readings"]

SHARED: Mapping[str, Function] = {**RINGS, **CLUTCHES, **SPRINGS, **CONTACTS}

ROLLING = ("contact-flat", "contact-pair", "contact-ring", "contact-slip", "contact-sphere",
           "contact-roller", "freewheel-", "sprag-")  # fmt: skip
ELASTIC = SharedReading(
    assumption="bodies in contact stay elastic",
    part="hardened steel yields below the surface from about 1.7 times its yield strength on",
    quantity="the contact pressure",
    source="not quantified; at the limit of ISO 76 the permanent deformation is 1e-4 of the "
    "rolling element's diameter",
)


def shared_readings(case_id: str, inputs: Any, values: Values) -> tuple[SharedReading, ...]:
    """Assumptions that formula and reference of a case share, with their effects for these inputs.

    `values` are results of the case's formulas. The result is empty for a case outside the suite.
    """
    if case_id not in SHARED:
        return ()
    found = SHARED[case_id](inputs, values)
    return (*found, ELASTIC) if case_id.startswith(ROLLING) else found
