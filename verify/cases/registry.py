"""All cases by id, in the order of the report; the module of a case is imported at first use."""

from collections.abc import Iterable, Mapping, Sequence
from difflib import get_close_matches
from importlib import import_module
from typing import overload

from verify.cases import files
from verify.core.case import Case
from verify.core.suggestions import FEW, nearest


class Listed(Sequence[Case]):
    """Cases by id, each with its place `module:variable` below `verify.cases`."""

    def __init__(self, places: Mapping[str, str]) -> None:
        self._places = places

    @property
    def ids(self) -> tuple[str, ...]:
        """Ids of the cases; no case is imported."""
        return tuple(self._places)

    def named(self, case_id: str) -> Case:
        """The case with the id `case_id`; raises KeyError for an unknown id."""
        name = self._places[case_id].partition(":")[2]
        case: Case = getattr(import_module(self.module_of(case_id)), name)
        return case

    def only(self, names: Iterable[str]) -> "Listed":
        """The cases with the ids `names`, each once; raises KeyError for an unknown id."""
        return Listed({name: self._places[name] for name in names})

    def module_of(self, case_id: str) -> str:
        """Dotted name of the module that declares a case; raises KeyError for an unknown id."""
        return f"verify.cases.{self._places[case_id].partition(':')[0]}"

    @overload
    def __getitem__(self, index: int) -> Case: ...
    @overload
    def __getitem__(self, index: slice) -> tuple[Case, ...]: ...
    def __getitem__(self, index: int | slice) -> Case | tuple[Case, ...]:
        if isinstance(index, slice):
            return tuple(map(self.named, self.ids[index]))
        return self.named(self.ids[index])

    def __len__(self) -> int:
        return len(self._places)


CASES = Listed(
    {
        "ring-lame": "ring.lame.case:LAME",
        "ring-loads-outer": "ring.loads.case:OUTER",
        "ring-loads-inner": "ring.loads.case:INNER",
        "ring-loads-map": "ring.loads_map.case:MAP",
        "ring-rotation": "ring.rotation.case:ROTATION",
        "polyhedral-pressure": "polyhedral.pressure.case:PRESSURE",
        "polyhedral-ring": "polyhedral.ring.case:RING",
        "polyhedral-map": "polyhedral.map.case:MAP",
        "polyhedral-locking": "polyhedral.locking.case:LOCKING",
        "polyhedral-wedge": "polyhedral.wedge.case:WEDGE",
        "polyhedral-clutch": "polyhedral.clutch.case:CLUTCH",
        "freewheel-torque": "freewheel.torque.case:TORQUE",
        "freewheel-cup": "freewheel.cup.case:CUP",
        "freewheel-friction": "freewheel.friction.case:FRICTION",
        "freewheel-paths": "freewheel.paths.case:PATHS",
        "freewheel-clutch": "freewheel.clutch.case:CLUTCH",
        "sprag-wedge": "sprag.wedge.case:WEDGE",
        "sprag-engagement": "sprag.engagement.case:ENGAGEMENT",
        "sprag-friction": "sprag.friction.case:FRICTION",
        "sprag-clutch": "sprag.clutch.case:CLUTCH",
        "sprag-crown": "sprag.crown.case:CROWN",
        "sprag-optimum": "sprag.optimum.case:OPTIMUM_25",
        "sprag-optimum-40": "sprag.optimum.case:OPTIMUM_40",
        "spring-accordion": "spring.accordion.case:ACCORDION",
        "spring-continuum": "spring.continuum.case:CONTINUUM",
        "spring-stages": "spring.stages.case:STAGES",
        "spring-width": "spring.width.case:WIDTH",
        "spring-curve": "spring.curve.case:CURVE",
        "spring-buckling": "spring.buckling.case:BUCKLING",
        "spring-map": "spring.map.case:MAP",
        "contact-flat": "contact.line.flat:FLAT",
        "contact-pair": "contact.line.pair:PAIR",
        "contact-ring": "contact.line.ring:RING",
        "contact-slip": "contact.slip.case:SLIP",
        "contact-sphere": "contact.sphere.case:SPHERE",
        "contact-press-fit": "contact.press_fit.case:PRESS_FIT",
        "contact-roller": "contact.roller.case:ROLLER",
        "contact-roller-tilted": "contact.roller.tilted:TILTED",
        "contact-roller-flat": "contact.roller.flat:UNCROWNED",
        "contact-roller-crowns": "contact.roller.crowns:CROWNS",
        "contact-roller-end": "contact.roller.end:END",
        "rotor-clutch": "rotor.clutch.case:CLUTCH",
        "rotor-shaft": "rotor.shaft.case:SHAFT",
        "rotor-step": "rotor.step.case:STEP",
        "rotor-system": "rotor.system.case:SYSTEM",
        "rotor-sprag": "rotor.sprag.case:SPRAG_ROTOR",
    }
)

# cases of `verify --quick`: cheap cases of every subject
QUICK = (
    "ring-lame", "ring-rotation", "polyhedral-pressure", "polyhedral-ring", "freewheel-torque",
    "sprag-clutch", "spring-accordion", "spring-stages", "contact-press-fit",
    "contact-roller-flat", "rotor-clutch", "rotor-shaft",
)  # fmt: skip

# measured by `freewheel deep` only
DEEP = Listed(
    {
        "spring-map-deep": "spring.map.case:DEEP_MAP",
        "sprag-optimum-deep": "sprag.optimum.deep:DEEP_25",
        "sprag-optimum-40-deep": "sprag.optimum.deep:DEEP_40",
    }
)


def find_any(case_id: str) -> Case:
    """The case with the id `case_id`, which may be a deep case (long study)."""
    return DEEP.named(case_id) if case_id in DEEP.ids else find(case_id)


def find(case_id: str, among: Sequence[Case] | None = None) -> Case:
    """The case with the id `case_id`: of the suite, of a file or of a package.

    Raises ValueError, with similar names, if the case is unknown.
    """
    cases = CASES if among is None else among
    if files.is_file_name(case_id):
        return _own(files.load(case_id), case_id)
    known = ids(cases)
    if case_id in known:
        return cases.named(case_id) if isinstance(cases, Listed) else cases[known.index(case_id)]
    if own := [case for case in files.loaded() if case.id == case_id]:
        return own[0]
    if case_id in files.installed():
        return _own(files.of_package(case_id), case_id)
    known = (*known, *files.installed())
    near = get_close_matches(case_id, known, n=1)
    meant = f", did you mean {near[0]}?" if near else ";"
    more = ", see freewheel list" if len(known) > FEW else ""
    raise ValueError(f"unknown case {case_id!r}{meant} there are {nearest(case_id, known)}{more}")


def ids(cases: Iterable[Case]) -> tuple[str, ...]:
    """Ids of `cases`, found without an import of the cases of the suite."""
    return cases.ids if isinstance(cases, Listed) else tuple(case.id for case in cases)


def _own(case: Case, file: str) -> Case:
    if case.id in (*CASES.ids, *DEEP.ids):
        raise ValueError(
            f"{file}: the suite has a case {case.id} already; give the new case another id"
        )
    return case


Case.finder = staticmethod(find_any)
