"""Answers of all cases: the design value and the criteria of each case."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from importlib import import_module
from typing import Any

from verify.answers.answer import Answer, Quantity
from verify.answers.assessment import Assessment
from verify.answers.keys import identifier
from verify.core.case import Case, Values
from verify.core.inputs import Inputs

NO_PART = (
    "this case determines the error of a formula over a range; it has no part, no load and no limit"
)
NO_LIMITS = "this case defines no limits for the part"


@dataclass(frozen=True)
class Rule:
    """Rule for the answer of a case: key of its design value, and the function for its criteria.

    The function is given as MODULE.NAME in this package; a module is imported only if one of its
    cases is checked. Without a function there are no criteria, and `without` states the reason.
    """

    design: str
    criteria: str = ""
    without: str = NO_PART

    def assess(self, inputs: Any, values: Values, part: Assessment) -> None:
        """Add the criteria for `inputs` and `values` to `part`."""
        if not self.criteria:
            part.unknowns.append(self.without)
            return
        module, _, name = self.criteria.partition(".")
        collect: Callable[[Any, Values, Assessment], None] = getattr(
            import_module(f"verify.answers.{module}"), name
        )
        collect(inputs, values, part)


RULES: Mapping[str, Rule] = {
    "ring-lame": Rule("u_bore", "rings.under_pressure"),
    "ring-loads-outer": Rule("load", "rings.under_sprags"),
    "ring-loads-inner": Rule("load", "rings.under_sprags"),
    "ring-loads-map": Rule(""),
    "ring-rotation": Rule("growth", "rings.rotating"),
    "polyhedral-pressure": Rule("p", "polyhedral.round_ring"),
    "polyhedral-ring": Rule("p_1r", "polyhedral.ring"),
    "polyhedral-map": Rule(""),
    "polyhedral-locking": Rule("N_elastic", "polyhedral.locking"),
    "polyhedral-wedge": Rule("M_free", "polyhedral.wedge"),
    "polyhedral-clutch": Rule("M_el", "polyhedral.clutch"),
    "freewheel-torque": Rule("phi", "freewheels.under_torque"),
    "freewheel-cup": Rule("phi", "freewheels.cup"),
    "freewheel-friction": Rule("F_lim", "freewheels.with_axial_load"),
    "freewheel-paths": Rule("F_lim", "freewheels.load_paths"),
    "freewheel-clutch": Rule("mu_req", "freewheels.clutch"),
    "sprag-wedge": Rule("theta", "sprags.wedge"),
    "sprag-engagement": Rule("N_max", "sprags.engagement"),
    "sprag-friction": Rule("mu_b", "sprags.stick_slip"),
    "sprag-clutch": Rule("stiffness", "sprags.clutch"),
    "sprag-crown": Rule("p_peak", "sprags.crown"),
    "sprag-optimum": Rule("static_peak", "sprags.optimum"),
    "sprag-optimum-40": Rule("static_peak", "sprags.optimum"),
    "spring-accordion": Rule("k_wide", "springs.free_stage"),
    "spring-continuum": Rule("k_wide", "springs.free_stage"),
    "spring-stages": Rule("k1", "springs.stages"),
    "spring-width": Rule("k", "springs.compared"),
    "spring-curve": Rule("k1", "springs.curve"),
    "spring-buckling": Rule("F_cr", "springs.buckling"),
    "spring-map": Rule("k1", "springs.compared"),
    "contact-flat": Rule("p_0", "contacts.line"),
    "contact-pair": Rule("p_0", "contacts.line"),
    "contact-ring": Rule("p_0", "contacts.line"),
    "contact-slip": Rule("c", "contacts.slip"),
    "contact-sphere": Rule("p_0_flat", "contacts.sphere"),
    "contact-press-fit": Rule("p", "rings.pressed_together"),
    "contact-roller": Rule("p_max", "contacts.roller"),
    "contact-roller-tilted": Rule("p_max", "contacts.roller"),
    "contact-roller-flat": Rule("p_max", "contacts.roller"),
    "contact-roller-crowns": Rule("p_mid", "contacts.crowns"),
    "contact-roller-end": Rule("p_mid", "contacts.end_face"),
    "rotor-clutch": Rule("K_zz", "rotors.link"),
    "rotor-shaft": Rule("critical", "rotors.shaft"),
    "rotor-step": Rule("critical_cone", "rotors.stepped"),
    "rotor-system": Rule("critical_first_1", "rotors.system"),
    "rotor-sprag": Rule("critical_forward_1", "rotors.sprag_rotor"),
}


def answer(
    case: Case, inputs: Inputs, values: Values, *, assumed: Iterable[str] = (),
    with_design: bool = True,
) -> Answer:  # fmt: skip
    """Answer for a part with the given `inputs`.

    `values` are results of the formulas; `assumed` contains the names of the inputs that were not
    given. Pass with_design=False if only the criteria are needed.
    """
    rule = RULES.get(case.id) or _outside(case)
    part = Assessment(design=_output(case, rule.design, values), with_design=with_design,
                      assumed=frozenset(assumed))  # fmt: skip
    rule.assess(inputs, values, part)
    return part.answer()


def _outside(case: Case) -> Rule:
    """Rule of a case outside the suite: its first judged value is the design value; no criteria."""
    first = next((one.key for one in case.outputs if one.judged), "")
    return Rule(first, without=NO_LIMITS)


def _output(case: Case, key: str, values: Values) -> Quantity | None:
    for output in case.outputs:
        if output.key == key and key in values:
            return Quantity(key=identifier(key), symbol=output.symbol, value=values[key],
                            unit=output.unit, what=output.what)  # fmt: skip
    return None
