"""The torque that a clutch may carry."""

from collections.abc import Sequence
from typing import Protocol

from verify.answers.answer import Quantity


class Limit(Protocol):
    """A torque [N m] at which a limit is reached, and the limit in words."""

    @property
    def at(self) -> float: ...

    @property
    def words(self) -> str: ...


def permissible(limits: Sequence[Limit], condition: str) -> Quantity | None:
    """The smallest of `limits`, sorted, under a `condition`; None where there is none."""
    if not limits:
        return None
    what = f"permissible torque{condition}; beyond it {limits[0].words}"
    return Quantity(key="permissible_torque", symbol="T_max", value=limits[0].at, unit="N m",
                    what=what)  # fmt: skip
