"""Cases that no second solver can solve, with reasons."""

from collections.abc import Mapping

_IN_TIME = (
    "transient motion of rigid sprags on springs: no mesh and no equilibrium for a second solver"
)
_STRIPS = (
    "coupled strips on a half-space: neither tamaas's half-space nor a mesh; case contact-roller "
    "compares the strips with it"
)
_ALONG = "a movement along the axis at uniform strain: plane cells of calculix do not have it"
_FRAME = "frames of the beams that strips of calculix are compared with in "

ALONE: Mapping[str, str] = {
    "ring-loads-map": "sectors of ring-loads with other numbers and walls, which calculix solves",
    "polyhedral-map": "sectors of polyhedral-ring with other flats, which calculix solves",
    "polyhedral-wedge": "history-dependent sticking where a roller is released: calculix models "
    "sticking by a slope, which blurs the required half-width",
    "polyhedral-clutch": "torques of the ring of polyhedral-locking, which calculix solves",
    "freewheel-friction": _ALONG,
    "freewheel-paths": _ALONG,
    "freewheel-clutch": "the pitch of freewheel-torque with other sizes, which calculix solves",
    "sprag-engagement": _IN_TIME,
    "sprag-friction": _IN_TIME,
    "sprag-clutch": _STRIPS,
    "sprag-crown": _STRIPS,
    "sprag-optimum": _STRIPS,
    "sprag-optimum-40": _STRIPS,
    "spring-stages": f"{_FRAME}spring-accordion; rigid links of its tips are not compared",
    "spring-map": f"{_FRAME}spring-curve and spring-buckling, of other sizes",
    "contact-roller-end": "an end face in contact around the circumference: its corner requires "
    "too many bricks",
}
