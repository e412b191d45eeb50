"""Inputs of the accordion spring beyond its free stage: its ends, and its width factor."""

from typing import Any

from pydantic import model_validator

from analytic.spring.loops import Tail
from analytic.spring.stages import Head, Stages, stages
from verify.cases.spring.inputs import AccordionInputs, strip_of
from verify.core.inputs import quantity, word


def refuse_wider(width_factor: float | None, nu: float) -> None:
    """Raise ValueError if the width factor is above the limit of a very wide strip."""
    most = 1 / (1 - nu**2)
    if width_factor is not None and width_factor > most * (1 + 1e-6):
        raise ValueError(
            f"the width factor must not exceed 1/(1 - ν²) = {most:.5g}, got "
            f"width_factor = {width_factor:g}"
        )


class StagesInputs(AccordionInputs):
    """Inputs of the accordion spring with whole end leaves, and of its supports."""

    width_factor: float | None = quantity(
        1.0957, "1", "f",
        "width factor: bending stiffness of the strip over E I, at most 1/(1 - ν²)",
        omitted=None, ge=1, le=1.3, example="1.09",
    )  # fmt: skip
    head: Head = word(
        "guided", "boundary condition of the head; guided: no sideways motion and no rotation"
    )
    tail: Tail = word(
        "mid-leaf", "place at which the clamp of the tail begins: middle of its leaf, or its arc"
    )

    @model_validator(mode="after")
    def _factor(self) -> "StagesInputs":
        refuse_wider(self.width_factor, self.nu)
        return self

    @property
    def factor(self) -> float:
        """Width factor of the judged rows, 1 if none is given."""
        return 1.0 if self.width_factor is None else self.width_factor

    def held(self, **other: Any) -> Stages:
        """Stages of the spring with the inputs' ends; `other` replaces arguments of `stages`."""
        ends: dict[str, Any] = {"head": self.head, "tail": self.tail, "width_factor": self.factor}
        return stages(**self.path, **strip_of(self), **(ends | other))
