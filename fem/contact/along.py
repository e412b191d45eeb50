"""Supports and loads of bodies along the third axis, z."""

from collections.abc import Mapping
from dataclasses import dataclass, field

from fem.plane.discretisation import Array
from fem.plane.supports import Prescribed


@dataclass(frozen=True)
class Along:
    """Supports of bodies along z.

    `supports` prescribe u_z on boundaries and on obstacles. By default, obstacles are fixed along
    z. Obstacles named in `free` move under forces. Ties of the plane problem also act along z.
    """

    supports: Mapping[str, Prescribed] = field(default_factory=dict)
    free: tuple[str, ...] = ()


@dataclass(frozen=True)
class Pull:
    """Load along z: forces `f` (nodes,) and prescribed displacements `u_0` (nodes,)."""

    f: Array
    u_0: Array

    def after(self, before: "Pull | None", share: float) -> "Pull":
        """Sum of `share` x this load and (1 - `share`) x the load `before` (None: no load)."""
        if before is None:
            return Pull(share * self.f, share * self.u_0)
        rest = 1 - share
        return Pull(share * self.f + rest * before.f, share * self.u_0 + rest * before.u_0)
