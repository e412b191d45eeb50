"""Cases that no second solver can solve, with reasons."""

from collections.abc import Mapping

_IN_TIME = (
    "transient motion of rigid sprags on springs: there is no mesh that a second solver can use"
)
_STRIPS = (
    "coupled strips on a half-space, which tamaas and calculix do not have; case contact-roller "
    "compares the strips with tamaas"
)
_ALONG = "displacement along the axis at uniform strain, which plane cells of calculix do not have"
_FRAME = "frames of the same beams as those that are compared with strips of calculix in "

ALONE: Mapping[str, str] = {
    "ring-loads-map": "sectors as in ring-loads, which calculix solves, with other n and walls",
    "polyhedral-map": "sectors as in polyhedral-ring, which calculix solves, with other flats",
    "polyhedral-wedge": "history-dependent sticking of a released roller: calculix models "
    "sticking by a slope, so that the half-width is not accurate",
    "polyhedral-clutch": "the ring of polyhedral-locking, which calculix solves, under torque",
    "freewheel-friction": _ALONG,
    "freewheel-paths": _ALONG,
    "freewheel-clutch": "a pitch as in freewheel-torque, which calculix solves, of other size",
    "sprag-engagement": _IN_TIME,
    "sprag-friction": _IN_TIME,
    "sprag-clutch": _STRIPS,
    "sprag-crown": _STRIPS,
    "sprag-optimum": _STRIPS,
    "sprag-optimum-40": _STRIPS,
    "spring-stages": f"{_FRAME}spring-accordion; the rigid links of the tips are not compared",
    "spring-map": f"{_FRAME}spring-curve and spring-buckling, with other dimensions",
    "contact-roller-end": "contact of an end face around the circumference: the corner requires "
    "too many bricks",
}
