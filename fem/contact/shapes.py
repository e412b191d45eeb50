"""Exact shapes of contact surfaces, so that the gap does not depend on the facets of the mesh."""

import math
from dataclasses import dataclass, replace
from typing import Protocol

import numpy as np

from fem.plane.discretisation import Array

NEWTON, ROUND_OFF = 20, 1e-15  # steps to a spiral's nearest point, and its angle [rad]


class Shape(Protocol):
    """Smooth curve that bounds a body, with a normal directed out of the body."""

    def project(self, x: Array) -> Array:
        """Nearest points (2, ...) of the curve to the points `x` (2, ...)."""
        ...

    def normal(self, x: Array) -> Array:
        """Unit normals (2, ...) out of the body at points `x` (2, ...) of the curve."""
        ...

    def moved(self, motion: "Motion") -> "Shape":
        """The curve after a small rigid motion."""
        ...

    @property
    def curvature(self) -> float:
        """Curvature of the curve [1/length], without sign."""
        ...


@dataclass(frozen=True)
class Motion:
    """Small rigid motion: `shift` of the point `about`, and rotation by `angle` [rad]."""

    shift: tuple[float, float]
    angle: float
    about: tuple[float, float]

    def of(self, point: tuple[float, float]) -> tuple[float, float]:
        """Position of `point` after the motion."""
        x, y = np.array(point) + self.displacement(np.array(point)[:, None])[:, 0]
        return float(x), float(y)

    def displacement(self, x: Array) -> Array:
        """Displacements (2, m) of the points `x` (2, m).

        The rotation is exact, not linear in the angle. With a linear rotation, points would leave
        the surface by half the square of the angle times the radius.
        """
        arm = x - np.reshape(self.about, (2, 1))
        sine, versine = math.sin(self.angle), 2 * math.sin(self.angle / 2) ** 2
        turned = sine * np.array([-arm[1], arm[0]]) - versine * arm
        return np.asarray(np.reshape(self.shift, (2, 1)) + turned)

    @classmethod
    def fitted(cls, x: Array, u: Array) -> "Motion":
        """Rigid motion nearest to the displacements `u` (2, m) of the points `x` (2, m)."""
        about, shift = x.mean(axis=1), u.mean(axis=1)
        x, u = x - about[:, None], u - shift[:, None]
        sine, cosine = float((x[0] * u[1] - x[1] * u[0]).sum()), float((x * (x + u)).sum())
        angle = math.atan2(sine, cosine) if sine else 0.0
        return cls((float(shift[0]), float(shift[1])), angle, (float(about[0]), float(about[1])))


@dataclass(frozen=True)
class Flat:
    """Straight line through `point`; `outward` is its normal, directed out of the body."""

    point: tuple[float, float] = (0.0, 0.0)
    outward: tuple[float, float] = (0.0, 1.0)

    def __post_init__(self) -> None:
        size = math.hypot(*self.outward)
        if not (math.isfinite(size) and size > 0 and all(map(math.isfinite, self.point))):
            raise ValueError(
                f"a flat needs a finite point and a finite normal that is not zero, got {self}"
            )

    def project(self, x: Array) -> Array:
        n = self.normal(x)
        return x - n * ((x - _column(self.point, x)) * n).sum(axis=0)

    @property
    def curvature(self) -> float:
        return 0.0

    def moved(self, motion: Motion) -> "Flat":
        (x, y), c, s = self.outward, math.cos(motion.angle), math.sin(motion.angle)
        return Flat(motion.of(self.point), (c * x - s * y, s * x + c * y))

    def normal(self, x: Array) -> Array:
        n = np.array(self.outward) / math.hypot(*self.outward)
        return np.broadcast_to(_column((n[0], n[1]), x), x.shape)


@dataclass(frozen=True)
class Circle:
    """Circle of `radius` about `centre` [length]: the rim of a disc, or a bore if `hollow`.

    Raises ValueError unless radius and centre are finite and the radius is positive.
    """

    centre: tuple[float, float]
    radius: float
    hollow: bool = False

    def __post_init__(self) -> None:
        if not (math.isfinite(self.radius) and self.radius > 0):
            raise ValueError(
                f"the radius of a circle must be positive and finite, got {self.radius:g}"
            )
        if not all(map(math.isfinite, self.centre)):
            raise ValueError(f"the centre of a circle must be finite, got {self.centre}")

    def project(self, x: Array) -> Array:
        d = x - _column(self.centre, x)
        return _column(self.centre, x) + self.radius * d / np.hypot(*d)

    @property
    def curvature(self) -> float:
        return 1 / self.radius

    def moved(self, motion: Motion) -> "Circle":
        return replace(self, centre=motion.of(self.centre))

    def normal(self, x: Array) -> Array:
        d = x - _column(self.centre, x)
        return (-1.0 if self.hollow else 1.0) * d / np.hypot(*d)


@dataclass(frozen=True)
class Spiral:
    """Spiral rho = `radius` exp(`growth` (angle - `start`)) about `pole`, near the angle `start`.

    Angles [rad] are measured anticlockwise from +x. The body is on the side of the pole.
    """

    pole: tuple[float, float]
    radius: float
    start: float
    growth: float

    def __post_init__(self) -> None:
        if not (math.isfinite(self.radius) and self.radius > 0):
            raise ValueError(
                f"the radius of a spiral must be positive and finite, got {self.radius:g}"
            )
        if not all(map(math.isfinite, (*self.pole, self.start, self.growth))):
            raise ValueError(f"pole, start and growth of a spiral must be finite, got {self}")

    def project(self, x: Array) -> Array:
        d = x - _column(self.pole, x)
        away, towards, g = np.hypot(*d), np.arctan2(d[1], d[0]), self.growth
        ahead = (towards - self.start + math.pi) % (2 * math.pi) - math.pi
        turn = np.zeros(away.shape)  # angle from the direction of x to the nearest point
        for _ in range(NEWTON):
            rho = self.radius * np.exp(g * (ahead + turn))
            c, s = away * np.cos(turn), away * np.sin(turn)
            step = (g * c - s - g * rho) / (g * s + c + g**2 * rho)
            turn += step
            if not np.any(np.abs(step) > ROUND_OFF):
                break
        rho = self.radius * np.exp(g * (ahead + turn))
        return _column(self.pole, x) + rho * np.array([np.cos(towards + turn),
                                                       np.sin(towards + turn)])  # fmt: skip

    @property
    def curvature(self) -> float:
        return 1 / (self.radius * math.hypot(1, self.growth))

    def moved(self, motion: Motion) -> "Spiral":
        return replace(self, pole=motion.of(self.pole), start=self.start + motion.angle)

    def normal(self, x: Array) -> Array:
        d = x - _column(self.pole, x)
        n = d - self.growth * np.array([-d[1], d[0]])
        return n / np.hypot(*n)


def _column(point: tuple[float, float], x: Array) -> Array:
    return np.reshape(point, (2, *[1] * (x.ndim - 1)))
