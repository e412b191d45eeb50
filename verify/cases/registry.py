"""Every case, in the order of the report."""

from collections.abc import Sequence
from difflib import get_close_matches

from verify.cases import files
from verify.cases.contact.line.flat import FLAT
from verify.cases.contact.line.pair import PAIR
from verify.cases.contact.line.ring import RING
from verify.cases.contact.press_fit.case import PRESS_FIT
from verify.cases.contact.roller.case import ROLLER
from verify.cases.contact.roller.crowns import CROWNS
from verify.cases.contact.roller.end import END
from verify.cases.contact.roller.flat import UNCROWNED
from verify.cases.contact.roller.tilted import TILTED
from verify.cases.contact.slip.case import SLIP
from verify.cases.contact.sphere.case import SPHERE
from verify.cases.freewheel.clutch.case import CLUTCH as FREEWHEEL
from verify.cases.freewheel.cup.case import CUP
from verify.cases.freewheel.friction.case import FRICTION
from verify.cases.freewheel.paths.case import PATHS
from verify.cases.freewheel.torque.case import TORQUE
from verify.cases.polyhedral.clutch.case import CLUTCH
from verify.cases.polyhedral.locking.case import LOCKING
from verify.cases.polyhedral.map.case import MAP as POLYHEDRAL_MAP
from verify.cases.polyhedral.pressure.case import PRESSURE
from verify.cases.polyhedral.ring.case import RING as POLYHEDRAL_RING
from verify.cases.polyhedral.wedge.case import WEDGE
from verify.cases.ring.lame.case import LAME
from verify.cases.ring.loads.case import INNER, OUTER
from verify.cases.ring.loads_map.case import MAP
from verify.cases.ring.rotation.case import ROTATION
from verify.cases.rotor.clutch.case import CLUTCH as ROTOR_CLUTCH
from verify.cases.rotor.shaft.case import SHAFT
from verify.cases.rotor.sprag.case import SPRAG_ROTOR
from verify.cases.rotor.step.case import STEP
from verify.cases.rotor.system.case import SYSTEM
from verify.cases.sprag.clutch.case import CLUTCH as SPRAG
from verify.cases.sprag.crown.case import CROWN
from verify.cases.sprag.engagement.case import ENGAGEMENT
from verify.cases.sprag.friction.case import FRICTION as STICK_SLIP
from verify.cases.sprag.optimum.case import OPTIMUM_25, OPTIMUM_40
from verify.cases.sprag.optimum.deep import DEEP_25, DEEP_40
from verify.cases.sprag.wedge.case import WEDGE as SPRAG_WEDGE
from verify.cases.spring.accordion.case import ACCORDION
from verify.cases.spring.buckling.case import BUCKLING
from verify.cases.spring.continuum.case import CONTINUUM
from verify.cases.spring.curve.case import CURVE
from verify.cases.spring.map.case import DEEP_MAP
from verify.cases.spring.map.case import MAP as SPRING_MAP
from verify.cases.spring.stages.case import STAGES
from verify.cases.spring.width.case import WIDTH
from verify.core.case import Case
from verify.core.suggestions import FEW, nearest

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
    """The case named `case_id`, of the suite, a file or a package; ValueError with like names."""
    if files.is_file_name(case_id):
        return _own(files.load(case_id), case_id)
    for case in (*among, *files.loaded()):
        if case.id == case_id:
            return case
    if case_id in files.installed():
        return _own(files.of_package(case_id), case_id)
    known = [*(case.id for case in among), *files.installed()]
    near = get_close_matches(case_id, known, n=1)
    meant = f", did you mean {near[0]}?" if near else ";"
    more = ", see freewheel list" if len(known) > FEW else ""
    raise ValueError(f"unknown case {case_id!r}{meant} there are {nearest(case_id, known)}{more}")


def _own(case: Case, file: str) -> Case:
    if any(case.id == other.id for other in (*CASES, *DEEP)):
        raise ValueError(f"{file}: the suite has a case {case.id} already; give it another id")
    return case


Case.finder = staticmethod(find_any)
