"""Formulas not measured, with the reason, and the cases with maps or rows of the formula."""

from collections.abc import Mapping

LEFT_OUT: Mapping[str, str] = {
    "freewheel-clutch": "the same formulas as freewheel-torque, which measures them",
    "sprag-friction": "a point takes five minutes of transient analysis: only rows compare them",
    "sprag-optimum": "its first level is the search itself: its maps show pressures over the "
    "crowns",
    "sprag-optimum-40": "its first level is the search itself: its maps show pressures over "
    "the crowns",
    "spring-curve": "a point takes a minute: spring-stages measures the same stiffness",
    "contact-roller-end": "a point takes two minutes, three-dimensional bodies: contact-roller "
    "measures the same formulas outside the ends",
    "rotor-step": "a point takes three minutes, three-dimensional bodies: its map shows the step",
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
