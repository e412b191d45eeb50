"""Inputs of the accordion spring, common to its cases."""

import math
from typing import Any, Self

from pydantic import model_validator

from verify.core.inputs import Inputs, count, quantity


class SpringInputs(Inputs):
    """Inputs of an accordion spring: geometry and material; r is the inner radius of the arcs."""

    n: int = count(10, "n", "number of segments", claims="wang2023:n", ge=4, le=200)
    b: float = quantity("0.1 mm", "mm", "b", "thickness", gt=0, le=10, claims="wang2023:b")
    h: float = quantity("56 mm", "mm", "h", "width", gt=0, le=1e4, claims="wang2023:h")
    r: float = quantity(
        "0.45 mm", "mm", "r", "inner radius of the arcs", gt=0, le=100, claims="wang2023:r"
    )
    L1: float = quantity(
        "11.6 mm", "mm", "L_1", "straight length of head and tail", gt=0, le=1e3,
        claims="wang2023:L1",
    )  # fmt: skip
    alpha: float = quantity(
        "80 deg", "deg", "α", "angle of the arcs", ge=20, le=90, claims="wang2023:alpha"
    )
    E: float = quantity("206 GPa", "GPa", "E", "Young's modulus", gt=0, le=1e5, claims="wang2023:E")
    nu: float = quantity(0.3, "1", "ν", "Poisson's ratio", ge=0, le=0.45, claims="wang2023:nu")

    @model_validator(mode="after")
    def _strip(self) -> Self:
        if not self.b < self.r:
            raise ValueError(
                f"the thickness must be below the inner radius: b < r, got b = "
                f"{self.b * 1e3:g} mm, r = {self.r * 1e3:g} mm"
            )
        if not 2 * self.r < self.L1:
            raise ValueError(
                f"the leaves must be longer than the loops are wide: L1 > 2 r, got L1 = "
                f"{self.L1 * 1e3:g} mm, r = {self.r * 1e3:g} mm"
            )
        return self

    @property
    def R(self) -> float:
        """Radius [m] of the centre line of the arcs."""
        return self.r + self.b / 2

    @property
    def leaf(self) -> float:
        """Straight length [m] of a middle leaf."""
        return leaf_length(self.L1, self.R, self.alpha)

    @property
    def widest(self) -> float:
        """Ratio 1/(1 - nu^2) of the stiffness of a very wide strip to that of a narrow strip."""
        return 1 / (1 - self.nu**2)

    @property
    def path(self) -> dict[str, Any]:
        """Arguments that define the true centre line."""
        return {"n": self.n, "L1": self.L1, "radius": self.R, "alpha": self.alpha}

    @property
    def paper_path(self) -> dict[str, Any]:
        """Arguments that define the paper's centre line.

        Its arcs have the inner radius; the leaves have the length for the true radius.
        """
        leaf = self.L1 / math.sin(self.alpha) + 2 * self.R / math.tan(self.alpha)
        return self.path | {"radius": self.r, "leaf": leaf}


class AccordionInputs(SpringInputs):
    """Inputs of a spring with an optional working force and an optional strength."""

    F: float | None = quantity(
        None, "N", "F", "working force, for deflection and stress", omitted=None, gt=0,
        example="5 N",
    )  # fmt: skip
    R_p: float | None = quantity(
        None, "MPa", "R_p", "yield strength", omitted=None, gt=0,
        example="1200 MPa",
    )  # fmt: skip


def leaf_length(L1: float, R: float, alpha: float) -> float:
    """Straight length [m] of a middle leaf."""
    return (L1 + 2 * R * math.cos(alpha)) / math.sin(alpha)


def length_of(n: int, L1: float, R: float, alpha: float) -> float:
    """Axial length [m] between the centre lines of the leaves of head and tail."""
    pitch = leaf_length(L1, R, alpha) * math.cos(alpha) + 2 * R * math.sin(alpha)
    return (n - 2) * pitch + 2 * R


def strip_of(q: SpringInputs) -> dict[str, Any]:
    """Section and material of the strip, as keyword arguments."""
    return {"b": q.b, "h": q.h, "E": q.E, "nu": q.nu}
