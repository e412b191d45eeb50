"""Cases without measured ranges, with reasons, and cases with maps of the same formulas."""

from collections.abc import Mapping

LEFT_OUT: Mapping[str, str] = {
    "freewheel-clutch": "the study of freewheel-torque covers the same formulas",
    "sprag-friction": "the transient analyses of one set of inputs take five minutes; the rows of "
    "the case state the errors at the default inputs",
    "sprag-optimum": "one set of inputs requires a complete search for the optimal crown; the maps "
    "of the case show the pressures of other crowns",
    "sprag-optimum-40": "one set of inputs requires a complete search for the optimal crown; the "
    "maps of the case show the pressures of other crowns",
    "spring-curve": "errors at other inputs are not measured, because one set of inputs takes a "
    "minute; the study of spring-stages covers the stiffness k_1 of the same spring",
    "contact-roller-end": "one set of inputs takes two minutes with solid elements; the study of "
    "contact-roller covers the same formulas except near the ends",
    "rotor-step": "one set of inputs takes three minutes with solid elements; the maps of this "
    "case show the errors over the dimensions",
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
