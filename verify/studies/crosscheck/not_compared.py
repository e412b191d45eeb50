"""Cases that no second solver can solve, with reasons."""

from collections.abc import Mapping

_IN_TIME = (
    "the case computes the motion of rigid sprags on springs in time; there is no mesh that a "
    "second solver can use"
)
_STRIPS = (
    "the contact model consists of coupled strips on a half-space; tamaas and calculix have no "
    "such model; case contact-roller compares the strips with tamaas"
)
_ALONG = (
    "the model has axial displacements that are uniform along the axis; plane elements of "
    "calculix have no axial displacements"
)
_FRAME = "the frames consist of beams; such beams are compared with plane elements of calculix in "

ALONE: Mapping[str, str] = {
    "ring-loads-map": "the sectors differ from those of ring-loads in the number of loads n "
    "and in the wall thickness; calculix solves those of ring-loads",
    "polyhedral-map": "the sectors differ from those of polyhedral-ring in the number of "
    "flats, the wall thickness and the radius of the fillets; calculix solves those of "
    "polyhedral-ring",
    "polyhedral-wedge": "the stick zone of a roller that is pressed without friction and then "
    "loaded tangentially depends on the history of loading; calculix models sticking by a "
    "tangential stiffness, so that its width of the stick zone is not accurate",
    "polyhedral-clutch": "the ring is the same as in polyhedral-locking, but transmits a torque; "
    "calculix solves the ring of polyhedral-locking without a torque",
    "freewheel-friction": _ALONG,
    "freewheel-paths": _ALONG,
    "freewheel-clutch": "the model differs from that of freewheel-torque in the dimensions; "
    "calculix solves the model of freewheel-torque",
    "sprag-engagement": _IN_TIME,
    "sprag-friction": _IN_TIME,
    "sprag-clutch": _STRIPS,
    "sprag-crown": _STRIPS,
    "sprag-optimum": _STRIPS,
    "sprag-optimum-40": _STRIPS,
    "spring-stages": f"{_FRAME}spring-accordion; the rigid links of the tips are not compared",
    "spring-map": f"{_FRAME}spring-curve and spring-buckling, with other dimensions",
    "contact-roller-end": "the edge of the end face requires small cells; a mesh of such cells "
    "around the complete circumference has too many solid elements for calculix",
}
