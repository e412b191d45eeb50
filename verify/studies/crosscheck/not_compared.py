"""Cases that no second solver can solve, with reasons."""

from collections.abc import Mapping

_IN_TIME = (
    "the case computes the motion of rigid sprags on springs in time; there is no mesh that a "
    "second solver can use"
)
_STRIPS = (
    "the model is coupled strips on a half-space, which tamaas and calculix do not have; case "
    "contact-roller compares the strips with tamaas"
)
_ALONG = (
    "the model has axial displacements that are uniform along the axis, which plane "
    "elements of calculix do not have"
)
_FRAME = "the frames consist of beams; such beams are compared with plane elements of calculix in "

ALONE: Mapping[str, str] = {
    "ring-loads-map": "the sectors are those of ring-loads, which calculix solves, but with other "
    "numbers of loads n and other wall thicknesses",
    "polyhedral-map": "the sectors are those of polyhedral-ring, which calculix solves, but "
    "with other numbers of flats, walls and fillets",
    "polyhedral-wedge": "the stick zone of a released roller depends on the history of loading; "
    "calculix models sticking by a tangential stiffness, so that the width of this zone is wrong",
    "polyhedral-clutch": "the ring is that of polyhedral-locking, which calculix solves, but "
    "under a torque",
    "freewheel-friction": _ALONG,
    "freewheel-paths": _ALONG,
    "freewheel-clutch": "the model is one pitch as in freewheel-torque, which calculix solves, "
    "but with other dimensions",
    "sprag-engagement": _IN_TIME,
    "sprag-friction": _IN_TIME,
    "sprag-clutch": _STRIPS,
    "sprag-crown": _STRIPS,
    "sprag-optimum": _STRIPS,
    "sprag-optimum-40": _STRIPS,
    "spring-stages": f"{_FRAME}spring-accordion; the rigid links of the tips are not compared",
    "spring-map": f"{_FRAME}spring-curve and spring-buckling, with other dimensions",
    "contact-roller-end": "the edge of the end face requires small cells; around the complete "
    "circumference, these would be too many solid elements of calculix",
}
