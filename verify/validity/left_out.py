"""What is not measured, with the reason, and the cases whose own maps and rows tell more."""

from collections.abc import Mapping

LEFT_OUT: Mapping[str, str] = {}

# cases that map a formula over its inputs, for the cases about the same formula
MAPS: Mapping[str, tuple[str, ...]] = {
    "ring-loads-outer": ("ring-loads-map",),
    "ring-loads-inner": ("ring-loads-map",),
    "polyhedral-ring": ("polyhedral-map",),
    "polyhedral-pressure": ("polyhedral-map",),
    "polyhedral-locking": ("polyhedral-clutch",),
    "spring-accordion": ("spring-map", "spring-width"),
    "spring-stages": ("spring-curve", "spring-map"),
    "spring-curve": ("spring-map",),
    "rotor-shaft": ("rotor-step",),
    "freewheel-torque": ("freewheel-cup",),
    "sprag-crown": ("sprag-optimum",),
    "contact-roller": ("contact-roller-end", "sprag-optimum"),
}

SUBJECTS: Mapping[str, str] = {
    "ring": "Races and rings", "polyhedral": "Polyhedral rings", "freewheel": "Roller freewheels",
    "sprag": "Sprag clutches", "spring": "Accordion springs", "contact": "Contacts",
    "rotor": "Rotors",
}  # fmt: skip
