"""Cases that no second solver takes, and why."""

from collections.abc import Mapping

_IN_TIME = (
    "rigid sprags on springs, followed in time: no mesh and no equilibrium that a solver here takes"
)
_STRIPS = (
    "strips that yield together in a plane: neither tamaas's half-space nor a mesh; case "
    "contact-roller sets strips beside it"
)
_ALONG = (
    "a movement along the axis at one strain of all cells: calculix's plane cells cannot move so"
)
_FRAME = "frames of the beams that strips of calculix stand beside in "

ALONE: Mapping[str, str] = {
    "ring-loads-map": "sectors of ring-loads with other numbers and walls, which calculix takes",
    "polyhedral-map": "sectors of polyhedral-ring with other flats, which calculix takes",
    "polyhedral-wedge": "sticking by its history where a roller is let go: calculix sticks by a "
    "slope of its own, which blurs the half-width that is asked for",
    "polyhedral-clutch": "torques of the ring of polyhedral-locking, which calculix takes",
    "freewheel-friction": _ALONG,
    "freewheel-paths": _ALONG,
    "freewheel-clutch": "the pitch of freewheel-torque with other sizes, which calculix takes",
    "sprag-engagement": _IN_TIME,
    "sprag-friction": _IN_TIME,
    "sprag-clutch": _STRIPS,
    "sprag-crown": _STRIPS,
    "sprag-optimum": _STRIPS,
    "sprag-optimum-40": _STRIPS,
    "spring-stages": f"{_FRAME}spring-accordion; rigid links of its tips are not posed",
    "spring-map": f"{_FRAME}spring-curve and spring-buckling, of other sizes",
    "contact-roller-end": "an end face in contact around a turn: bricks as fine as its corner asks "
    "for are too many",
}
