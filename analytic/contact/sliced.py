"""A line contact of equal slices along the roller: input and results of the models."""

from dataclasses import dataclass, replace
from typing import Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from analytic.contact import palmgren
from analytic.contact.checks import Array, finite, positive


@dataclass(frozen=True, kw_only=True)
class SlicedContact:
    """Contact of a roller and its race in slices; `force` is (..., n), other arrays (...)."""

    force: Array  # q of each slice [N]
    approach: Array  # [m]
    length: Array  # of all slices together [m]
    R: Array  # relative radius [m]
    E_star: Array  # contact modulus [Pa]

    @property
    def load(self) -> Array:
        """Total load [N], the sum of the forces, shape (...)."""
        return np.asarray(self.force.sum(axis=-1))

    @property
    def carries(self) -> NDArray[np.bool_]:
        """True for slices in contact, shape (..., n)."""
        return np.asarray(self.force > 0)

    @property
    def line_load(self) -> Array:
        """Line load [N/m] of each slice, shape (..., n)."""
        return np.asarray(self.force * (self.force.shape[-1] / self.length[..., None]))

    @property
    def half_width(self) -> Array:
        """Half-width [m] by Hertz for the line load of each slice, shape (..., n)."""
        return np.asarray(np.sqrt(4 / np.pi * self.line_load * (self.R / self.E_star)[..., None]))

    @property
    def peak_pressure(self) -> Array:
        """Peak pressure [Pa] by Hertz for the line load of each slice, shape (..., n)."""
        return np.asarray(np.sqrt(self.line_load * (self.E_star / (np.pi * self.R))[..., None]))


@dataclass(frozen=True, kw_only=True)
class Cases:
    """Many contacts, flattened to one axis: `gap` is (cases, n), the other arrays (cases,)."""

    gap: Array
    length: Array
    R: Array
    E_star: Array
    compliance: Array  # s of each slice
    load: Array | None
    approach: Array | None  # one of the two is given
    shape: tuple[int, ...]  # of the input arrays

    @classmethod
    def of(
        cls,
        gap: ArrayLike,
        *,
        length: ArrayLike,
        R: ArrayLike,
        E_star: ArrayLike,
        load: ArrayLike | None,
        approach: ArrayLike | None,
        compliance: ArrayLike | None,
    ) -> Self:
        """Checked arguments, broadcast over all cases; raises ValueError if shapes do not fit."""
        gap = finite(gap, "gap", "m")
        if gap.ndim == 0 or gap.shape[-1] == 0:
            raise ValueError(
                f"gap must have one height [m] per slice along its last axis, got shape {gap.shape}"
            )
        if compliance is None:
            compliance = palmgren.compliance(length=length, slices=gap.shape[-1])
        parameters = (
            positive(length, "length", "m"),
            positive(R, "relative radius", "m"),
            positive(E_star, "contact modulus", "Pa"),
            positive(compliance, "compliance of a slice", "m^(10/9)/N"),
            _pressed(load, approach),
        )
        shape = _common_shape(gap.shape[:-1], [value.shape for value in parameters])
        length, R, E_star, compliance, pressed = (
            np.broadcast_to(value, shape).reshape(-1) for value in parameters
        )
        return cls(
            gap=np.broadcast_to(gap, (*shape, gap.shape[-1])).reshape(-1, gap.shape[-1]),
            length=length, R=R, E_star=E_star, compliance=compliance,
            load=None if load is None else pressed, approach=pressed if load is None else None,
            shape=shape,
        )  # fmt: skip

    def some(self, part: NDArray[np.intp]) -> Self:
        """Subset of the cases: those with the indices `part`."""
        return replace(
            self, gap=self.gap[part], length=self.length[part], R=self.R[part],
            E_star=self.E_star[part], compliance=self.compliance[part],
            load=None if self.load is None else self.load[part],
            approach=None if self.approach is None else self.approach[part],
            shape=part.shape,
        )  # fmt: skip

    def contact(self, force: Array, approach: Array) -> SlicedContact:
        """Contact with these forces and approaches, in the shape of the input arrays."""
        return SlicedContact(
            force=force.reshape(*self.shape, -1),
            approach=approach.reshape(self.shape),
            length=self.length.reshape(self.shape),
            R=self.R.reshape(self.shape),
            E_star=self.E_star.reshape(self.shape),
        )


def _pressed(load: ArrayLike | None, approach: ArrayLike | None) -> Array:
    if load is not None and approach is None:
        return positive(load, "load", "N")
    if approach is not None and load is None:
        return finite(approach, "approach", "m")
    raise ValueError("exactly one of load [N] and approach [m] must be given")


def _common_shape(gap: tuple[int, ...], others: list[tuple[int, ...]]) -> tuple[int, ...]:
    try:
        return np.broadcast_shapes(gap, *others)
    except ValueError:
        raise ValueError(
            f"the shape of gap without its last axis, {gap}, must be compatible with the shapes of "
            f"the other arguments, {', '.join(map(str, others))}"
        ) from None
