"""Sets of the twelve parameters for which the paper's 20 elements give its three speeds."""

from fem.rotor.ensemble import Ensemble, Ranges, elasticities, ensemble
from verify.cases.rotor.sprag.inputs import PRINTED
from verify.cases.rotor.sprag.layout import HIGH, LOW
from verify.cases.rotor.sprag.system_fem import systems_fem
from verify.core.figures import Array

RANGES = Ranges(LOW, HIGH)


def ensemble_fem(members: int) -> Ensemble:
    """At least `members` sets (m, 12) of parameters [SI] that give the printed speeds.

    The result has fewer sets if 32 batches of initial values do not give enough.
    """
    return ensemble(RANGES, PRINTED, systems_fem, members, seed=2022)


def elasticities_fem(p: Array) -> Array:
    """Relative change (m, 3, 12) of each critical speed per relative change of each parameter."""
    return elasticities(RANGES, p, systems_fem, len(PRINTED))
