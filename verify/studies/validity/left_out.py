"""Formulas that are not measured, with reasons, and cases with maps of a formula."""

from collections.abc import Mapping

LEFT_OUT: Mapping[str, str] = {
    "freewheel-clutch": "the study of freewheel-torque measures the same formulas",
    "sprag-friction": "a point takes five minutes of transient analysis: see the rows of the case",
    "sprag-optimum": "the first level is a complete search: the maps show pressures over the "
    "crowns",
    "sprag-optimum-40": "the first level is a complete search: the maps show pressures over "
    "the crowns",
    "spring-curve": "one point takes a minute of computing time; case spring-stages measures "
    "the stiffness k_1 of the same spring",
    "contact-roller-end": "a set of inputs takes two minutes with solid elements; the case "
    "contact-roller measures the same formulas outside the ends",
    "rotor-step": "a point with solid elements takes three minutes: see the map of the case",
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
