"""The system of Fig. 1 of the paper, with its missing dimensions as parameters.

Nodes are numbered as in the paper, 1 to 12 on the outer and 13 to 22 on the inner rotor.
"""

from dataclasses import dataclass
from math import pi, tan

import numpy as np
from numpy.typing import ArrayLike

from verify.core.figures import Array

E, NU, RHO = 210e9, 0.3, 7850.0  # steel
BORE = 19.44 / 26.23  # bore of the drum over its diameter, as for the outer race of Ref. 9
WIDTH = 0.02  # m, of both discs
SPRAGS, SPRAG_LENGTH, SLICES = 12, 0.012, 20
WEDGE = tan(4 * pi / 180)  # tangent of the wedge angle at the inner race
EXPONENT = 10 / 9  # exponent of Eq. 2
DRIVE = 0.1  # N m/rad: stiffness of the drive, much less than any other torsional stiffness
OUTER, INNER = 12, 10  # nodes
DISCS = (4, 19)
BOTTOM = 6  # element of the drum's bottom, between nodes 7 and 8
GROUNDED = (2, 6, 21)  # bearings 1, 2, 5
BETWEEN = ((9, 14), (11, 16))  # bearings 3, 4
CLUTCH = (10, 15)
OPPOSITE = ", opposite"  # key suffix of arrays with unbalance 2 opposite to unbalance 1


@dataclass(frozen=True, kw_only=True)
class Parameter:
    """A parameter that the paper does not print: symbol, meaning, unit, SI factor and range."""

    symbol: str
    what: str
    unit: str
    factor: float
    low: float
    high: float
    reason: str


PARAMETERS = (
    Parameter(symbol="l_1", what="distance from bearing 1 to bearing 2", unit="mm", factor=1e-3,
              low=100, high=300, reason="three to eight shaft diameters, with a disc between the "
                                        "bearings"),
    Parameter(symbol="l_2", what="distance from bearing 2 to bearing 3", unit="mm", factor=1e-3,
              low=60, high=180, reason="assumed overhang of the drum that carries the clutch"),
    Parameter(symbol="l_3", what="distance from bearing 3 to bearing 4", unit="mm", factor=1e-3,
              low=40, high=100, reason="clutch about 10 mm long, with a bearing on each side"),
    Parameter(symbol="l_4", what="distance from bearing 4 to bearing 5", unit="mm", factor=1e-3,
              low=150, high=450, reason="assumed: this part of the inner rotor carries a disc"),
    Parameter(symbol="d_1", what="shaft diameter of the outer rotor", unit="mm", factor=1e-3,
              low=25, high=45, reason="seat diameters of angular contact bearings for "
                                     "36,000 r/min"),
    Parameter(symbol="D", what="drum diameter of the outer rotor", unit="mm", factor=1e-3,
              low=45, high=80, reason="about 52.5 mm in the clutch of the same authors (Ref. 9)"),
    Parameter(symbol="d_2", what="diameter of the inner rotor", unit="mm", factor=1e-3,
              low=16, high=32, reason="about 22.2 mm for the inner race in the clutch of the "
                                      "same authors (Ref. 9)"),
    Parameter(symbol="m_4", what="mass of the disc at node 4", unit="kg", factor=1.0,
              low=0.3, high=3, reason="steel disc, 20 mm wide, with a diameter of 55 to 160 mm"),
    Parameter(symbol="m_19", what="mass of the disc at node 19", unit="kg", factor=1.0,
              low=0.3, high=3, reason="the same range as for the disc at node 4"),
    Parameter(symbol="k_g", what="stiffness of bearings 1, 2 and 5", unit="MN/m", factor=1e6,
              low=10, high=300, reason="ball bearings for these shafts, with light to heavy "
                                       "preload"),
    Parameter(symbol="k_s", what="stiffness of bearings 3 and 4", unit="MN/m", factor=1e6,
              low=10, high=300, reason="the same range as for the bearings to the ground"),
    Parameter(symbol="k_c", what="radial stiffness of the clutch", unit="MN/m", factor=1e6,
              low=100, high=3000, reason="n T/(2 d_t δ_0) at T = 15 N m, with δ_0 = 3 to 200 µm"),
)  # fmt: skip
L_1, L_2, L_3, L_4, D_1, D, D_2, M_4, M_19, K_G, K_S, K_C = range(len(PARAMETERS))
LOW = np.array([p.low * p.factor for p in PARAMETERS])
HIGH = np.array([p.high * p.factor for p in PARAMETERS])
# Result of least-norm steps from the middle of all ranges, rounded to six digits.
CENTRAL = np.array([p.factor for p in PARAMETERS]) * np.array([
    201.45, 151.447, 76.1678, 260.765, 26.8457, 60.1335, 23.9792, 1.12583, 1.03208, 34.4554,
    108.376, 561.007,
])  # fmt: skip

# Elements of both rotors: index of a length, share of this length, and index of the diameter.
ELEMENT_LENGTHS = (
    [(L_1, 1 / 8)]
    + [(L_1, 1 / 4)] * 4
    + [(L_2, 0.45), (L_2, 0.1), (L_2, 0.45)]
    + [(L_3, 1 / 2)] * 2
    + [(L_3, 1 / 4)],
    [(L_3, 1 / 4)] + [(L_3, 1 / 2)] * 2 + [(L_4, 1 / 5)] * 5 + [(L_4, 1 / 10)],
)
PARTS = tuple(part for rotor in ELEMENT_LENGTHS for part in rotor)
WHICH = np.array([which for which, _ in PARTS])
SHARE = np.array([share for _, share in PARTS])
ACROSS = np.array([D_1] * 6 + [D] * 5 + [D_2] * 9)
HOLLOW = np.where((ACROSS == D) & (np.arange(len(PARTS)) != BOTTOM), BORE, 0.0)


@dataclass(frozen=True)
class Layout:
    """Dimensions of m systems: elements (m, 20), discs (m, 2), spring stiffnesses (m,)."""

    length: Array
    d_o: Array
    d_i: Array
    mass: Array
    polar: Array
    diametral: Array
    k_g: Array
    k_s: Array
    k_c: Array
    d_t: Array

    @property
    def k_tilt(self) -> Array:
        """Tilting stiffness of an evenly loaded clutch [N m/rad]."""
        return self.k_c * SPRAG_LENGTH**2 / 12 * (1 - 1 / SLICES**2)

    @property
    def k_turn(self) -> Array:
        """Torsional stiffness of the clutch [N m/rad], Z k d_t^2; the radial stiffness is Z k/2."""
        return 2 * self.k_c * self.d_t**2

    @property
    def z(self) -> Array:
        """Axial positions (m, 22) of the nodes [m]."""
        outer = _places(self.length[:, : OUTER - 1])
        inner = _places(self.length[:, OUTER - 1 :])
        first = outer[:, CLUTCH[0] - 1] - inner[:, CLUTCH[1] - OUTER - 1]
        return np.concatenate([outer, first[:, None] + inner], axis=1)


def layout(parameters: ArrayLike) -> Layout:
    """Layouts with `parameters` (m, 12) [SI], in the order of `PARAMETERS`."""
    p = np.atleast_2d(np.asarray(parameters, dtype=np.float64))
    d_o = p[:, ACROSS]
    mass, bore = p[:, [M_4, M_19]], p[:, [D_1, D_2]]
    rim = 4 * mass / (pi * RHO * WIDTH) + bore**2  # diameter squared
    around = mass * (rim + bore**2)
    return Layout(
        length=p[:, WHICH] * SHARE, d_o=d_o, d_i=d_o * HOLLOW,
        mass=mass, polar=around / 8, diametral=around / 16 + mass * WIDTH**2 / 12,
        k_g=p[:, K_G], k_s=p[:, K_S], k_c=p[:, K_C], d_t=p[:, D_2] / 2 * WEDGE,
    )  # fmt: skip


def _places(lengths: Array) -> Array:
    return np.concatenate([np.zeros((len(lengths), 1)), np.cumsum(lengths, axis=1)], axis=1)
