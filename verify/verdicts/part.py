"""Comparison of a user's inputs with the ranges of studies."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Self

from verify.core.inputs import Inputs
from verify.core.verdicts import Side, VerdictRange

SAME = 1e-9  # relative: inputs that differ by less are equal


@dataclass(frozen=True)
class Part:
    """Values of a user's inputs, and default values, both in display units (name: value)."""

    values: Mapping[str, object]
    default: Mapping[str, object]

    @classmethod
    def of(cls, inputs: Inputs, free: frozenset[str]) -> Self:
        """Values of the inputs, except those in `free`, on which no error depends."""
        mine, default = (
            {one.name: one.value for one in given.display() if one.name not in free}
            for given in (inputs, type(inputs)())
        )
        return cls(mine, default)

    def changed(self, found: VerdictRange | None = None) -> list[str]:
        """Names of the inputs that differ from the centre of a study.

        The centre consists of the constant inputs of the study, and of the default values of all
        other inputs. Without a study, it consists of the default values.
        """
        held = {side.name: side.low for side in (found.held if found else ())}
        centre = {**self.default, **held}
        return [name for name, value in self.values.items() if not _equal(value, centre.get(name))]

    def is_varied(self, found: VerdictRange) -> bool:
        """Whether a study varies together all inputs that differ from the centre of the study."""
        changed = self.changed(found)
        varied = {side.name for side in found.studied}
        return set(changed) <= varied and not (found.is_star and len(changed) > 1)

    def placed(self, found: VerdictRange) -> list[str]:
        """Names of the inputs whose values are compared with the ranges of a study.

        For a star, this is the changed input, if any. Otherwise, these are all varied inputs. The
        default of a varied input may lie outside the range of the study.
        """
        changed = self.changed(found)
        return changed if found.is_star and changed else [side.name for side in found.studied]

    def is_within(self, found: VerdictRange, sides: Sequence[Side]) -> bool:
        """Whether all compared inputs lie in the ranges `sides` (of a study, or of a limit)."""
        ends = {side.name: side for side in sides}
        return all(name in ends and self.is_inside(ends[name]) for name in self.placed(found))

    def is_inside(self, side: Side) -> bool:
        """Whether the input lies in the range `side`."""
        value = self.values[side.name]
        if not isinstance(value, int | float):
            return False
        room = SAME * max(abs(side.low), abs(side.high))
        return side.low - room <= value <= side.high + room


def _equal(one: object, other: object) -> bool:
    if isinstance(one, int | float) and isinstance(other, int | float):
        return math.isclose(one, other, rel_tol=SAME)
    return one == other
