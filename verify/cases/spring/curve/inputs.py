"""Inputs of the accordion spring's whole curve: ends, arcs, friction and stroke."""

from typing import Literal, Self

from pydantic import model_validator

from analytic.spring import frame
from analytic.spring.loops import Tail
from analytic.spring.stages import Head
from verify.cases.spring.inputs import SpringInputs
from verify.cases.spring.stages.inputs import refuse_wider
from verify.core.inputs import quantity, word

Arcs = Literal["r", "r + b/2"]
SHORTEST = 0.05  # shortest useful curve over the free length
LONGEST = 0.72


class CurveInputs(SpringInputs):
    """Inputs of the accordion spring with whole end leaves, compressed beyond tip contact."""

    width_factor: float = quantity(
        1.0957, "1", "f",
        "width factor: bending stiffness of the strip over E I, at most 1/(1 - ν²)",
        ge=1, le=1.3,
    )  # fmt: skip
    mu: float = quantity(
        0.15, "1", "μ", "friction coefficient between the leaves", ge=0, le=0.5,
        claims="wang2023:fea-friction-coefficient",
    )  # fmt: skip
    stroke: float = quantity(
        "17 mm", "mm", "U_max", "largest displacement of the computed curve", gt=0, le=1e4
    )
    head: Head = word(
        "guided", "boundary condition of the head; guided: no sideways motion and no rotation"
    )
    tail: Tail = word(
        "mid-leaf", "place at which the clamp of the tail begins: middle of its leaf, or its arc"
    )
    arcs: Arcs = word("r", "radius of the centre line of the arcs: r as printed, or r + b/2")

    @model_validator(mode="after")
    def _factor(self) -> Self:
        refuse_wider(self.width_factor, self.nu)
        return self

    @model_validator(mode="after")
    def _reach(self) -> Self:
        L0 = frame.free_length(n=self.n, b=self.b, r=self.R - self.b / 2, L1=self.L1,
                               alpha=self.alpha)  # fmt: skip
        if not SHORTEST * L0 <= self.stroke <= LONGEST * L0:
            raise ValueError(
                f"the stroke must be between {SHORTEST:.0%} and {LONGEST:.0%} of the free length "
                f"L_0 = {L0 * 1e3:.4g} mm, got stroke = {self.stroke * 1e3:g} mm"
            )
        return self

    @property
    def R(self) -> float:
        """Radius [m] of the centre line of the arcs, according to the input `arcs`."""
        return self.r if self.arcs == "r" else self.r + self.b / 2

    @property
    def is_paper(self) -> bool:
        """Whether this is the spring of the paper, to which Eq. 10 and the readings apply."""
        return self == type(self)()

    @property
    def factor(self) -> float:
        """Width factor of the strip."""
        return self.width_factor
