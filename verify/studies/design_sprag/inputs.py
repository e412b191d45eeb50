"""Task of a crown design: the clutch, its torques, the ranges and tolerances of the crown."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Literal

from pydantic import model_validator

from verify.answers.assumed.complete import complete
from verify.answers.assumed.registry import DESIGN_SPRAG_TASK as CASE
from verify.answers.assumed.rules import Assumed
from verify.cases.sprag.clutch.formulas import ClutchFormulas
from verify.cases.sprag.clutch.recommendations import verdict, why
from verify.cases.sprag.inputs import EngagementInputs
from verify.core.inputs import InputError, build, count, quantity, read_parameter_file, word
from verify.core.unit_systems import System, system_of
from verify.studies.design.sweep import Sweep
from verify.studies.design_sprag.ranges import RANGES

CLUTCH = "sprag-clutch"
MOST_TORQUES = 12
STATES = {"slips": "slips", "rolls over": "rolls over", "no state": "has no equilibrium"}
LARGEST_SHARE = 0.5  # largest tolerance of the drop over the smallest drop

TORQUES = Sweep(name="torques", unit="N m", what="torques of engagement",
                default=["25 N m"], low=0, above=True, high=1e9)  # fmt: skip

Aim = Literal["excess", "pressure"]
Contacts = Literal["strips", "slices"]
Method = Literal["evolution", "genetic"]


class Wishes(EngagementInputs):
    """The clutch with its present crown, and the requirements on the optimal crown."""

    aim: Aim = word(
        "excess", "objective: largest excess of pressure over the optimal crown of each torque, or "
        "the largest pressure at any torque; for one torque, both are equivalent",
    )  # fmt: skip
    contacts: Contacts = word(
        "strips", "contact model: strips on a half-space or, as in the paper, slices; slices "
        "neglect edge loading",
    )  # fmt: skip
    method: Method = word("evolution", "search: differential evolution or the genetic algorithm")
    t_z: float = quantity(
        "0.001 mm", "mm", "t_z", "tolerance of the drop at the ends, ±; it scales the "
        "whole profile", omitted=0.0, ge=0, le=10,
    )  # fmt: skip
    t_y: float = quantity(
        "0.1 mm", "mm", "t_y", "tolerance of the start of the crown, ± along the sprag",
        omitted=0.0, ge=0, le=1e3,
    )  # fmt: skip
    seed: int = count(0, "", "seed of the random numbers", ge=0, le=10**9)

    @model_validator(mode="after")
    def _fits_length(self) -> "Wishes":
        if not 2 * self.t_y < self.l:
            raise ValueError(
                f"t_y must be less than l/2, got t_y = {self.t_y * 1e3:g} mm, "
                f"l = {self.l * 1e3:g} mm"
            )
        return self


@dataclass(frozen=True)
class Task:
    """A design task: the clutch with its present crown, and SI bounds of (K_1, K_2, z_m).

    `assumed` contains the inputs that the file omits.
    """

    name: str
    wishes: Wishes
    torques: tuple[float, ...]
    low: tuple[float, float, float]
    high: tuple[float, float, float]
    assumed: tuple[Assumed, ...] = ()
    system: System = "mm"

    @property
    def clutch(self) -> EngagementInputs:
        """Inputs of the clutch, without the requirements."""
        return EngagementInputs(
            **{name: getattr(self.wishes, name) for name in EngagementInputs.model_fields}
        )

    @property
    def t_K2(self) -> float:
        """Tolerance of K_2 that corresponds to t_y."""
        return 2 * self.wishes.t_y / self.wishes.l


def load(path: Path) -> Task:
    """Design task from the parameter file `path`.

    Raises InputError, which states the fault in one line, if the file is wrong.
    """
    case, name, raw = read_parameter_file(path)
    if case not in (CASE, CLUTCH):
        raise InputError(f'{path}: case must be "{CASE}" or "{CLUTCH}", got {case[:60]!r}')
    own = (TORQUES.name, *(r.name for r in RANGES), *_wished()) if case == CLUTCH else ()
    if alien := [key for key in raw if key in own]:
        raise InputError(f'{path}: inputs.{alien[0]}: only valid with case = "{CASE}"')
    whole, assumed = complete(CASE, Wishes, raw, str(path))
    return replace(task(whole, name, str(path)), assumed=assumed, system=system_of(raw))


def task(raw: Mapping[str, Any], name: str, where: str) -> Task:
    """Design task from raw inputs; the defaults are those of the paper's task, without tolerances.

    Raises InputError if an input is unknown, missing or out of its range.
    """
    known = (*Wishes.model_fields, TORQUES.name, *(r.name for r in RANGES))
    for key in raw:
        if key not in known:
            raise InputError(
                f"{where}: inputs.{key[:40]!s}: unknown key; allowed keys: {', '.join(known)}"
            )
    wishes = build(
        Wishes, {"seed": 0} | {k: v for k, v in raw.items() if k in Wishes.model_fields}, where
    )
    assert isinstance(wishes, Wishes)
    torques: tuple[float, ...] = (wishes.T,)
    if TORQUES.name in raw:
        torques = TORQUES.read(raw[TORQUES.name], f"{where}: inputs.{TORQUES.name}")
    if len(torques) > MOST_TORQUES:
        raise InputError(
            f"{where}: inputs.torques: {len(torques)} torques, the maximum is {MOST_TORQUES}"
        )
    bounds = [r.read(raw.get(r.name, r.default), f"{where}: inputs.{r.name}") for r in RANGES]
    (a, b, c), (d, e, f) = zip(*bounds, strict=True)
    found = Task(name, wishes, torques, (a, b, c), (d, e, f))
    _refuse_wide(found, where)
    return found


def unable(task: Task) -> str:
    """Reason why the clutch cannot hold one of the torques with any crown, or an empty text."""
    for T in task.torques:
        q = ClutchFormulas(**(task.clutch.model_dump() | {"T": T}))
        state = verdict(q)
        if state in ("slips", "rolls over", "no state"):
            return f"under T = {T:g} N m the clutch {STATES[state]}: {why(q)}"
    return ""


def default() -> Task:
    """The task that the template describes."""
    bounds = [r.read(r.default, f"inputs.{r.name}") for r in RANGES]
    (a, b, c), (d, e, f) = zip(*bounds, strict=True)
    torques = TORQUES.read(TORQUES.default, "inputs.torques")
    return Task(f"my {CASE}", Wishes(), torques, (a, b, c), (d, e, f))


def _wished() -> tuple[str, ...]:
    return tuple(n for n in Wishes.model_fields if n not in EngagementInputs.model_fields)


def _refuse_wide(task: Task, where: str) -> None:
    """Raise InputError if a tolerance is too wide for the ranges."""
    t_z, least = task.wishes.t_z, task.low[2]
    if t_z > LARGEST_SHARE * least:
        raise InputError(
            f"{where}: inputs.t_z = {t_z * 1e3:g} mm: must not exceed half of the smallest drop in "
            f"z_m_range (half of {least * 1e3:g} mm)"
        )
    if not task.t_K2 < task.low[1]:
        raise InputError(
            f"{where}: inputs.t_y = {task.wishes.t_y * 1e3:g} mm: the corresponding tolerance of "
            f"K_2, {task.t_K2:.3g}, must be less than the lower end of K_2_range, {task.low[1]:g}"
        )
