"""All comparisons with second solvers, in the order of the cases."""

from collections.abc import Sequence

from verify.cases.registry import CASES, find
from verify.core.inputs import InputError
from verify.core.suggestions import nearest
from verify.studies.crosscheck.comparisons.clutches import CLUTCHES
from verify.studies.crosscheck.comparisons.contacts import CONTACTS
from verify.studies.crosscheck.comparisons.half_spaces import HALF_SPACES
from verify.studies.crosscheck.comparisons.races import RACES
from verify.studies.crosscheck.comparisons.rings import RINGS
from verify.studies.crosscheck.comparisons.rotors import ROTORS
from verify.studies.crosscheck.comparisons.rounds import ROUNDS
from verify.studies.crosscheck.comparisons.solids import SOLIDS
from verify.studies.crosscheck.comparisons.springs import SPRINGS
from verify.studies.crosscheck.comparisons.struts import STRUTS
from verify.studies.crosscheck.not_compared import ALONE
from verify.studies.crosscheck.statement import Cross

_ORDER = {name: i for i, name in enumerate(CASES.ids)}
COMPARISONS: tuple[Cross, ...] = tuple(
    sorted(
        (
            *RINGS,
            *ROUNDS,
            *CLUTCHES,
            *SPRINGS,
            *SOLIDS,
            *CONTACTS,
            *RACES,
            *HALF_SPACES,
            *ROTORS,
            *STRUTS,
        ),
        key=lambda cross: _ORDER[cross.case],
    )
)


def chosen(names: Sequence[str]) -> tuple[Cross, ...]:
    """Comparisons of the named cases; all comparisons if `names` is empty.

    Raises InputError if a case is unknown or has no comparison.
    """
    for name in names:
        if not any(cross.case == name for cross in COMPARISONS):
            try:
                find(name)
            except ValueError as error:
                raise InputError(str(error)) from error
            known = dict.fromkeys(cross.case for cross in COMPARISONS)
            raise InputError(
                f"{name}: no second solver solves this case ({ALONE[name]}); compared cases: "
                f"{nearest(name, known)}, see freewheel crosscheck --list"
            )
    return tuple(c for c in COMPARISONS if not names or c.case in names)
