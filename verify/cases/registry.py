"""Every case, in the order of the report."""

from collections.abc import Sequence
from difflib import get_close_matches

from verify.case import Case
from verify.cases.contact_line_flat import FLAT
from verify.cases.contact_line_pair import PAIR
from verify.cases.contact_line_ring import RING
from verify.cases.contact_press_fit import PRESS_FIT
from verify.cases.contact_roller import ROLLER
from verify.cases.contact_roller_crowns import CROWNS
from verify.cases.contact_roller_end import END
from verify.cases.contact_roller_flat import UNCROWNED
from verify.cases.contact_roller_tilted import TILTED
from verify.cases.contact_slip import SLIP
from verify.cases.contact_sphere import SPHERE
from verify.cases.freewheel_clutch import CLUTCH as FREEWHEEL
from verify.cases.freewheel_cup import CUP
from verify.cases.freewheel_friction import FRICTION
from verify.cases.freewheel_paths import PATHS
from verify.cases.freewheel_torque import TORQUE
from verify.cases.polyhedral_clutch import CLUTCH
from verify.cases.polyhedral_locking import LOCKING
from verify.cases.polyhedral_map import MAP as POLYHEDRAL_MAP
from verify.cases.polyhedral_pressure import PRESSURE
from verify.cases.polyhedral_ring import RING as POLYHEDRAL_RING
from verify.cases.polyhedral_wedge import WEDGE
from verify.cases.ring import LAME
from verify.cases.ring_loads import INNER, OUTER
from verify.cases.ring_loads_map import MAP
from verify.cases.ring_rotation import ROTATION
from verify.cases.rotor_clutch import CLUTCH as ROTOR_CLUTCH
from verify.cases.rotor_shaft import SHAFT
from verify.cases.rotor_sprag import SPRAG_ROTOR
from verify.cases.rotor_step import STEP
from verify.cases.rotor_system import SYSTEM
from verify.cases.sprag_clutch import CLUTCH as SPRAG
from verify.cases.sprag_crown import CROWN
from verify.cases.sprag_engagement import ENGAGEMENT
from verify.cases.sprag_friction import FRICTION as STICK_SLIP
from verify.cases.sprag_optimum import OPTIMUM_25, OPTIMUM_40
from verify.cases.sprag_optimum_deep import DEEP_25, DEEP_40
from verify.cases.sprag_wedge import WEDGE as SPRAG_WEDGE
from verify.cases.spring_accordion import ACCORDION
from verify.cases.spring_buckling import BUCKLING
from verify.cases.spring_continuum import CONTINUUM
from verify.cases.spring_curve import CURVE
from verify.cases.spring_map import DEEP_MAP
from verify.cases.spring_map import MAP as SPRING_MAP
from verify.cases.spring_stages import STAGES
from verify.cases.spring_width import WIDTH
from verify.nearest import FEW, nearest

CASES: tuple[Case, ...] = (
    LAME, OUTER, INNER, MAP, ROTATION,
    PRESSURE, POLYHEDRAL_RING, POLYHEDRAL_MAP, LOCKING, WEDGE, CLUTCH,
    TORQUE, CUP, FRICTION, PATHS, FREEWHEEL,
    SPRAG_WEDGE, ENGAGEMENT, STICK_SLIP, SPRAG, CROWN,
    OPTIMUM_25, OPTIMUM_40,
    ACCORDION, CONTINUUM, STAGES, WIDTH, CURVE, BUCKLING, SPRING_MAP,
    FLAT, PAIR, RING, SLIP, SPHERE, PRESS_FIT,
    ROLLER, TILTED, UNCROWNED, CROWNS, END,
    ROTOR_CLUTCH, SHAFT, STEP, SYSTEM, SPRAG_ROTOR,
)  # fmt: skip


DEEP: tuple[Case, ...] = (DEEP_MAP, DEEP_25, DEEP_40)  # measured by `freewheel deep` alone


def find_any(case_id: str) -> Case:
    """The case named `case_id`, deep ones included."""
    return find(case_id, (*CASES, *DEEP))


def find(case_id: str, among: Sequence[Case] = CASES) -> Case:
    """The case named `case_id`; ValueError with names like it."""
    for case in among:
        if case.id == case_id:
            return case
    known = [case.id for case in among]
    near = get_close_matches(case_id, known, n=1)
    meant = f", did you mean {near[0]}?" if near else ";"
    more = ", see freewheel list" if len(known) > FEW else ""
    raise ValueError(f"unknown case {case_id!r}{meant} there are {nearest(case_id, known)}{more}")


Case.finder = staticmethod(find_any)
