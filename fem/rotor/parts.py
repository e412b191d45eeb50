"""Parts of a rotor: materials, shafts, discs, supports and links, in SI units."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from fem.rotor.elements import Array

UNKNOWNS = 6  # of a node: x, y, z, theta_x, theta_y, theta_z


@dataclass(frozen=True)
class Material:
    """Isotropic elastic material: Young's modulus `E` [Pa], Poisson's ratio `nu`, density `rho`.

    The unit of `rho` is kg/m^3; a shaft without mass has rho = 0. Raises ValueError unless E > 0,
    -1 < nu <= 0.5 and rho >= 0.
    """

    E: float
    nu: float = 0.3
    rho: float = 0.0

    def __post_init__(self) -> None:
        if not 0 < self.E < math.inf:
            raise ValueError(f"Young's modulus must be positive and finite, got E={self.E:g} Pa")
        if not -1 < self.nu <= 0.5:
            raise ValueError(f"Poisson's ratio must satisfy -1 < nu <= 0.5, got nu={self.nu:g}")
        if not 0 <= self.rho < math.inf:
            raise ValueError(f"density must not be negative, got rho={self.rho:g} kg/m^3")

    @property
    def G(self) -> float:
        """Shear modulus [Pa]."""
        return self.E / (2 * (1 + self.nu))


STEEL = Material(E=210e9, nu=0.3, rho=7850.0)


@dataclass(frozen=True)
class Element:
    """Cylindrical part of a shaft: `length`, outer and inner diameter `d_o`, `d_i` [m].

    `shear` is the coefficient kappa of the shear stiffness kappa G A. The default is Hutchinson's
    value (J. Appl. Mech. 68 (2001) 87-92) for the solid or hollow circular section. Raises
    ValueError unless length > 0, 0 <= d_i < d_o and kappa > 0.
    """

    length: float
    d_o: float
    d_i: float = 0.0
    material: Material = STEEL
    shear: float | None = None

    def __post_init__(self) -> None:
        if not 0 < self.length < math.inf:
            raise ValueError(f"the length of a shaft element must be > 0, got {self.length:g} m")
        if not 0 <= self.d_i < self.d_o < math.inf:
            raise ValueError(
                f"diameters must satisfy 0 <= d_i < d_o, got d_i={self.d_i:g} m, d_o={self.d_o:g} m"
            )
        if self.shear is not None and not 0 < self.shear < math.inf:
            raise ValueError(f"the shear coefficient must be positive, got {self.shear:g}")

    @property
    def area(self) -> float:
        """Area of the cross-section [m^2]."""
        return math.pi / 4 * (self.d_o**2 - self.d_i**2)

    @property
    def inertia(self) -> float:
        """Second moment of area I [m^4]; the polar moment is 2 I."""
        return math.pi / 64 * (self.d_o**4 - self.d_i**4)

    @property
    def kappa(self) -> float:
        """Shear coefficient kappa; if not given, Hutchinson's value for a circular section."""
        if self.shear is not None:
            return self.shear
        nu, a, b = self.material.nu, self.d_o, self.d_i
        ends, middle = a**4 + b**4, a**2 * b**2
        below = (7 + 12 * nu + 4 * nu**2) * ends + (34 + 48 * nu + 16 * nu**2) * middle
        return 6 * (a**2 + b**2) ** 2 * (1 + nu) ** 2 / below


@dataclass(frozen=True)
class Shaft:
    """Shaft of consecutive elements, beginning at the axial position `z` [m].

    The shaft rotates at `ratio` [1] times the speed of the rotor; with a negative ratio, it rotates
    in the opposite sense. Raises ValueError without elements.
    """

    elements: Sequence[Element]
    ratio: float = 1.0
    z: float = 0.0

    def __post_init__(self) -> None:
        if not self.elements:
            raise ValueError("a shaft needs at least one element")
        if not math.isfinite(self.ratio) or not math.isfinite(self.z):
            raise ValueError(
                f"ratio and z of a shaft must be finite, got ratio={self.ratio:g}, z={self.z:g} m"
            )


@dataclass(frozen=True)
class Disc:
    """Rigid disc: `mass` [kg], `polar` and `diametral` moments of inertia [kg m^2].

    Discs with a `width` [m], centred at their nodes, must not overlap. Raises ValueError for
    negative values.
    """

    node: int
    mass: float
    polar: float = 0.0
    diametral: float = 0.0
    width: float = 0.0

    def __post_init__(self) -> None:
        for name, unit in (("mass", "kg"), ("polar", "kg m^2"), ("diametral", "kg m^2"),
                           ("width", "m")):  # fmt: skip
            value = getattr(self, name)
            if not 0 <= value < math.inf:
                raise ValueError(f"a disc's {name} must not be negative, got {value:g} {unit}")

    @classmethod
    def cylinder(cls, node: int, d_o: float, d_i: float, width: float, rho: float) -> "Disc":
        """Homogeneous disc with a bore; lengths [m], density `rho` [kg/m^3]."""
        if not (0 <= d_i < d_o and width > 0 and rho > 0):
            raise ValueError(
                "a disc must have 0 <= d_i < d_o, width > 0 and rho > 0, got "
                f"d_i={d_i:g} m, d_o={d_o:g} m, width={width:g} m, rho={rho:g} kg/m^3"
            )
        mass = math.pi / 4 * (d_o**2 - d_i**2) * width * rho
        ring = mass * (d_o**2 + d_i**2)
        return cls(node, mass, ring / 8, ring / 16 + mass * width**2 / 12, width)


def joint(
    xx: float, yy: float | None, xy: float, yx: float | None, zz: float, tilt: float, turn: float
) -> Array:
    """Stiffness or damping matrix (6, 6) of a support, for displacements, then rotations.

    `zz` is axial, `tilt` acts about x and y, `turn` about z. If omitted, `yy` equals `xx` and `yx`
    equals `xy`.
    """
    A = np.diag([xx, xx if yy is None else yy, zz, tilt, tilt, turn]).astype(float)
    A[0, 1], A[1, 0] = xy, xy if yx is None else yx
    return A


@dataclass(frozen=True)
class Support:
    """Bearing between a node and the ground.

    Stiffness coefficients begin with k [N/m], damping coefficients with c [N s/m]. If omitted,
    `kyy` equals `kxx` and `kyx` equals `kxy`: a single number defines an isotropic bearing.
    `k_tilt` and `c_tilt` act on both tilts, `k_turn` and `c_turn` on the rotation about the axis [N
    m/rad, N m s/rad]. Raises ValueError for negative or infinite coefficients.
    """

    node: int
    kxx: float
    kyy: float | None = None
    kxy: float = 0.0
    kyx: float | None = None
    cxx: float = 0.0
    cyy: float | None = None
    cxy: float = 0.0
    cyx: float | None = None
    kzz: float = 0.0
    czz: float = 0.0
    k_tilt: float = 0.0
    c_tilt: float = 0.0
    k_turn: float = 0.0
    c_turn: float = 0.0

    def __post_init__(self) -> None:
        for name in ("kxx", "kyy", "kzz", "k_tilt", "k_turn", "cxx", "cyy", "czz", "c_tilt",
                     "c_turn"):  # fmt: skip
            value = getattr(self, name)
            if value is not None and not 0 <= value < math.inf:
                raise ValueError(f"a support's {name} must not be negative, got {value:g}")
        if not np.all(np.isfinite(self.K)) or not np.all(np.isfinite(self.C)):
            raise ValueError("the coefficients of a support must be finite")

    @cached_property
    def K(self) -> Array:
        """Stiffness matrix (6, 6)."""
        return joint(
            self.kxx, self.kyy, self.kxy, self.kyx, self.kzz, self.k_tilt, self.k_turn
        )  # fmt: skip

    @cached_property
    def C(self) -> Array:
        """Damping matrix (6, 6)."""
        return joint(self.cxx, self.cyy, self.cxy, self.cyx, self.czz, self.c_tilt, self.c_turn)


@dataclass(frozen=True)
class SpeedSupport:
    """Bearing whose coefficients depend on the speed: `at(speed [rad/s])` returns a `Support`."""

    node: int
    at: Callable[[float], Support]


@dataclass(frozen=True)
class Link:
    """Link between node `a` of one shaft and node `b` of another shaft.

    The matrices K and C (6, 6) act on q_a - q_b.
    """

    a: int
    b: int
    K: ArrayLike
    C: ArrayLike | None = None

    def __post_init__(self) -> None:
        for name, A in (("K", self.stiffness), ("C", self.damping)):
            if A.shape != (UNKNOWNS, UNKNOWNS) or not np.all(np.isfinite(A)):
                raise ValueError(f"{name} of a link must be a finite (6, 6) matrix, got {A.shape}")
            if np.any(np.diag(A) < 0):
                raise ValueError(
                    f"the diagonal of a link's {name} must be >= 0, got {np.diag(A).min():g}"
                )
        if self.a == self.b:
            raise ValueError(f"a link must join two different nodes, got node {self.a} twice")

    @classmethod
    def bearing(cls, a: int, b: int, kxx: float, **coefficients: float) -> "Link":
        """Bearing between two shafts, with the coefficients of `Support`."""
        own = Support(a, kxx, **coefficients)
        return cls(a, b, own.K, own.C)

    @property
    def stiffness(self) -> Array:
        """Stiffness matrix K (6, 6)."""
        return np.asarray(self.K, float)

    @property
    def damping(self) -> Array:
        """Damping matrix C (6, 6)."""
        return np.zeros((UNKNOWNS, UNKNOWNS)) if self.C is None else np.asarray(self.C, float)
