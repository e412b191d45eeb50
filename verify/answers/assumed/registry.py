"""Assumed inputs of each case and design task, in the order in which they are evaluated."""

from collections.abc import Mapping

from verify.answers.assumed.rollers import FREEWHEEL_CLUTCH, POLYHEDRAL_CLUTCH
from verify.answers.assumed.rotors import ROTOR_SYSTEM
from verify.answers.assumed.rules import Assumption
from verify.answers.assumed.sprags import SEED, SPRAG_CLUTCH
from verify.answers.assumed.springs import DESIGN_SPRING, SPRING_ACCORDION, SPRING_CURVE

TASKS = DESIGN_SPRING_TASK, DESIGN_SPRAG_TASK = "design-spring", "design-sprag"

ASSUMPTIONS: Mapping[str, tuple[Assumption, ...]] = {
    "sprag-clutch": SPRAG_CLUTCH,
    DESIGN_SPRAG_TASK: (*SPRAG_CLUTCH, SEED),
    "freewheel-clutch": FREEWHEEL_CLUTCH,
    "polyhedral-clutch": POLYHEDRAL_CLUTCH,
    "rotor-system": ROTOR_SYSTEM,
    "spring-accordion": SPRING_ACCORDION,
    "spring-curve": SPRING_CURVE,
    DESIGN_SPRING_TASK: DESIGN_SPRING,
}


def assumption_of(case_id: str, name: str) -> Assumption:
    """Assumption for one input of a case. Raises LookupError if there is none."""
    for one in ASSUMPTIONS.get(case_id, ()):
        if one.name == name:
            return one
    raise LookupError(f"case {case_id} has no assumption for the input {name}")
