"""Formulas that are not measured, with reasons, and cases with maps of a formula."""

from collections.abc import Mapping

LEFT_OUT: Mapping[str, str] = {
    "freewheel-clutch": "its formulas are those of freewheel-torque, which has a study",
    "sprag-friction": "a point takes five minutes of transient analysis; the rows of the case "
    "state the errors at the inputs of the case",
    "sprag-optimum": "a point takes a complete search for the optimum, even on the first level; "
    "maps of the case show the pressure over the parameters of the crown",
    "sprag-optimum-40": "a point takes a complete search for the optimum, even on the first level; "
    "maps of the case show the pressure over the parameters of the crown",
    "spring-curve": "a point takes a minute; spring-stages has a study of the same stiffness",
    "contact-roller-end": "a point takes two minutes with solid elements; contact-roller has a "
    "study of the same formulas outside the ends",
    "rotor-step": "a point takes three minutes with solid elements; a map of the case shows the "
    "error of mode 1",
}

# cases with maps or curves of the same formula over its inputs, including those of the case
MAPS: Mapping[str, tuple[str, ...]] = {
    "ring-loads-outer": ("ring-loads-map",),
    "ring-loads-inner": ("ring-loads-map",),
    "ring-loads-map": ("ring-loads-map",),
    "polyhedral-ring": ("polyhedral-map",),
    "polyhedral-map": ("polyhedral-map",),
    "polyhedral-locking": ("polyhedral-map",),
    "freewheel-torque": ("freewheel-cup",),
    "freewheel-cup": ("freewheel-cup",),
    "freewheel-paths": ("freewheel-paths",),
    "sprag-friction": ("sprag-friction",),
    "sprag-crown": ("sprag-optimum",),
    "sprag-optimum": ("sprag-optimum",),
    "sprag-optimum-40": ("sprag-optimum-40",),
    "spring-accordion": ("spring-map",),
    "spring-stages": ("spring-map", "spring-curve"),
    "spring-curve": ("spring-curve", "spring-map"),
    "spring-buckling": ("spring-buckling",),
    "spring-map": ("spring-map",),
    "rotor-shaft": ("rotor-step",),
    "rotor-step": ("rotor-step",),
}

SUBJECTS: Mapping[str, str] = {
    "ring": "Races and rings", "polyhedral": "Polyhedral rings", "freewheel": "Roller freewheels",
    "sprag": "Sprag clutches", "spring": "Accordion springs", "contact": "Contacts",
    "rotor": "Rotors",
}  # fmt: skip
