"""Rotors of several coaxial shafts: input of the exact transfer-matrix model.

Stations are the ends of the segments. They are numbered from 0 along the first shaft, then along
the next shafts. Deflections are r = x + iy and phi = theta_y - i theta_x, which is dr/dz of a
slender shaft.
"""

import math
from dataclasses import dataclass

from analytic.rotor.shafts import Theory, hutchinson

THEORIES = ("timoshenko", "rayleigh", "euler")


@dataclass(frozen=True, kw_only=True)
class Segment:
    """Tube of constant section: `length`, diameters `d_o`, `d_i` [m], E [Pa], nu, rho [kg/m³].

    `kappa` is the shear coefficient; None selects Hutchinson's value for the tube. Raises
    ValueError if a length or modulus is not positive or d_i is not in [0, d_o).
    """

    length: float
    d_o: float
    d_i: float = 0.0
    E: float = 210e9
    nu: float = 0.3
    rho: float = 7850.0
    kappa: float | None = None

    def __post_init__(self) -> None:
        for value, what, unit in (
            (self.length, "length of a segment", "m"), (self.d_o, "outer diameter", "m"),
            (self.E, "Young's modulus", "Pa"), (self.rho, "density", "kg/m³"),
            (1.0 if self.kappa is None else self.kappa, "shear coefficient", ""),
        ):  # fmt: skip
            if not (math.isfinite(value) and value > 0):
                raise ValueError(f"{what} must be positive, got {value:g} {unit}".rstrip())
        if not 0 <= self.d_i < self.d_o:
            raise ValueError(
                f"diameters of a tube must satisfy 0 <= d_i < d_o, got d_i = {self.d_i:g} m, d_o = "
                f"{self.d_o:g} m"
            )
        if not -1 < self.nu <= 0.5:
            raise ValueError(f"Poisson's ratio must be above -1 and at most 0.5, got {self.nu:g}")

    @property
    def A(self) -> float:
        """Area of the cross-section [m²]."""
        return math.pi / 4 * (self.d_o**2 - self.d_i**2)

    @property
    def I(self) -> float:  # noqa: E743 - the book's symbol
        """Second moment of area about a diameter [m⁴]; the polar one is twice this value."""
        return math.pi / 64 * (self.d_o**4 - self.d_i**4)

    @property
    def G(self) -> float:
        """Shear modulus [Pa]."""
        return self.E / (2 * (1 + self.nu))

    @property
    def shear(self) -> float:
        """Shear coefficient in use: `kappa`, or Hutchinson's value."""
        if self.kappa is not None:
            return self.kappa
        return hutchinson(nu=self.nu, m=self.d_i / self.d_o)


@dataclass(frozen=True, kw_only=True)
class SegmentedShaft:
    """Shaft of consecutive segments that rotates at `ratio` times the rotor speed.

    A negative `ratio` is rotation in the opposite direction.
    """

    segments: tuple[Segment, ...]
    ratio: float = 1.0

    def __post_init__(self) -> None:
        if not self.segments:
            raise ValueError("a shaft must have at least one segment, got none")
        if not math.isfinite(self.ratio):
            raise ValueError(f"the speed ratio of a shaft must be finite, got {self.ratio:g}")


Shaft = SegmentedShaft  # its name in version 0.1


@dataclass(frozen=True, kw_only=True)
class StationDisc:
    """Rigid disc at a station: `mass` [kg], `polar` and `diametral` moment of inertia [kg m²]."""

    node: int
    mass: float
    polar: float
    diametral: float

    def __post_init__(self) -> None:
        for value, what in (
            (self.mass, "mass"), (self.polar, "polar moment"), (self.diametral, "diametral moment")
        ):  # fmt: skip
            if not (math.isfinite(value) and value >= 0):
                raise ValueError(f"{what} of a disc must not be negative, got {value:g}")


Disc = StationDisc  # its name in version 0.1


@dataclass(frozen=True, kw_only=True)
class Spring:
    """Stiffness [N/m; N m/rad] and damping [N s/m; N m s/rad] of a bearing.

    F_x = kxx x + kxy y, F_y = kxy x + kyy y. None stands for kyy = kxx or cyy = cxx. `k_tilt` acts
    on theta_x and theta_y, `k_turn` on theta_z. Raises ValueError if a value is negative or not
    finite, or if kxy^2 > kxx kyy, because the stiffness matrix then has a negative
    eigenvalue.
    """

    kxx: float
    kyy: float | None = None
    kxy: float = 0.0
    cxx: float = 0.0
    cyy: float | None = None
    cxy: float = 0.0
    k_tilt: float = 0.0
    c_tilt: float = 0.0
    k_turn: float = 0.0

    def __post_init__(self) -> None:
        for name in ("kxx", "kyy", "cxx", "cyy", "k_tilt", "c_tilt", "k_turn"):
            value = getattr(self, name)
            if value is not None and not (math.isfinite(value) and value >= 0):
                what = "stiffness" if name.startswith("k") else "damping"
                raise ValueError(f"a {what} must not be negative, got {name} = {value:g}")
        for one, two, both in (("kxx", "kyy", "kxy"), ("cxx", "cyy", "cxy")):
            x, cross = getattr(self, one), getattr(self, both)
            y = x if getattr(self, two) is None else getattr(self, two)
            if not (math.isfinite(cross) and cross**2 <= x * y):
                raise ValueError(
                    f"{both} must not exceed the square root of ({one} x {two}), got {cross:g}; "
                    f"the two factors are {x:g} and {y:g}"
                )

    @property
    def stiffness(self) -> tuple[float, complex]:
        """Mean and deviator (k, d) of the stiffness [N/m]: the force is k r + d conj(r)."""
        return _parts(self.kxx, self.kyy, self.kxy)

    @property
    def damping(self) -> tuple[float, complex]:
        """Mean and deviator of the damping [N s/m]."""
        return _parts(self.cxx, self.cyy, self.cxy)


def _parts(xx: float, yy: float | None, xy: float) -> tuple[float, complex]:
    y = xx if yy is None else yy
    return (xx + y) / 2, complex((xx - y) / 2, xy)


@dataclass(frozen=True, kw_only=True)
class StationSupport(Spring):
    """Bearing between a station and the ground."""

    node: int


Support = StationSupport  # its name in version 0.1


@dataclass(frozen=True, kw_only=True)
class StationLink(Spring):
    """Bearing or clutch between the stations `a` and `b`."""

    a: int
    b: int

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.a == self.b:
            raise ValueError(f"a link must connect two different stations, got {self.a} twice")


Link = StationLink  # its name in version 0.1


@dataclass(frozen=True, kw_only=True)
class TransferMatrixRotor:
    """Rotor of shafts with discs, bearings to the ground and links between shafts.

    The segments are undamped. `theory` is "timoshenko", "rayleigh" (no shear) or "euler" (no shear,
    no rotary inertia of the shafts). Raises ValueError if there is no shaft, the theory is unknown
    or a station does not exist.
    """

    shafts: tuple[SegmentedShaft, ...]
    discs: tuple[StationDisc, ...] = ()
    supports: tuple[StationSupport, ...] = ()
    links: tuple[StationLink, ...] = ()
    theory: Theory = "timoshenko"

    def __post_init__(self) -> None:
        if not self.shafts:
            raise ValueError("a rotor must have at least one shaft, got none")
        if self.theory not in THEORIES:
            raise ValueError(f"theory must be one of {', '.join(THEORIES)}, got {self.theory!r}")
        used = [(d.node, "disc") for d in self.discs]
        used += [(s.node, "support") for s in self.supports]
        used += [(n, "link") for link in self.links for n in (link.a, link.b)]
        for node, what in used:
            if not 0 <= node < self.stations:
                raise ValueError(
                    f"a {what} must be at an existing station, got {node}, the last station is "
                    f"{self.stations - 1}"
                )

    @property
    def stations(self) -> int:
        """Number of stations."""
        return sum(len(shaft.segments) + 1 for shaft in self.shafts)

    @property
    def shaft_of(self) -> tuple[int, ...]:
        """Index of the shaft of each station."""
        return tuple(
            k for k, shaft in enumerate(self.shafts) for _ in range(len(shaft.segments) + 1)
        )

    @property
    def places(self) -> tuple[float, ...]:
        """Positions of the stations along each shaft [m]."""
        found: list[float] = []
        for shaft in self.shafts:
            z = 0.0
            found.append(z)
            for segment in shaft.segments:
                z += segment.length
                found.append(z)
        return tuple(found)

    @property
    def isotropic(self) -> bool:
        """True if all bearings have equal properties in x and y."""
        springs = (*self.supports, *self.links)
        return all(s.stiffness[1] == 0 and s.damping[1] == 0 for s in springs)


Rotor = TransferMatrixRotor  # its name in version 0.1
