"""Statements of the paper other than its three critical speeds, evaluated for every member.

A member is one set of parameters of the ensemble. `responses_fem` returns the arrays. A statement
is evaluated only for members in which all compared responses have a peak.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from verify.cases.rotor.sprag.layout import GROUNDED, OPPOSITE, OUTER
from verify.core.figures import Array

Members = NDArray[np.bool_]
Arrays = Mapping[str, Array]
ALIKE = 0.1  # relative to the mean: amplitudes that are "nearly equal"
SMALL = 0.5  # relative to the median of the others: amplitudes that are "significantly lower"
ORDERS = (1, 3, 5)


@dataclass(frozen=True, kw_only=True)
class Statement:
    """A statement of the paper, the members in which it holds, and its printed values.

    `compares` returns the compared values (m, ...); a value is NaN if a response has no peak.
    """

    name: str
    symbol: str
    holds: Callable[[Arrays], Members]
    compares: Callable[[Arrays], Array]
    printed: tuple[str, ...] = ()
    place: str = "Sec. 2.2"

    def asked(self, a: Arrays) -> Members:
        """Mask (m,) of the members in which all compared responses have a peak."""
        of = self.compares(a)
        return np.asarray(np.isfinite(of.reshape(len(of), -1)).all(axis=1))


def opposite(a: Arrays) -> Arrays:
    """Arrays of responses with unbalance 2 opposite to unbalance 1 (phase difference 180°)."""
    turned = {key.removesuffix(OPPOSITE): v for key, v in a.items() if key.endswith(OPPOSITE)}
    return {**a, **turned}


def base(a: Arrays) -> Array:
    """Peaks (members, critical speeds, nodes) for the smallest value of unbalance 2."""
    return a["peaks"][:, 0]


def outer_peaks(a: Arrays, *orders: int, last: int = OUTER) -> Array:
    """Peaks (m, orders, nodes) of outer-rotor nodes 1 to `last`, at critical speeds `orders`."""
    return base(a)[:, [ORDERS.index(k) for k in orders], :last]


def outer(a: Arrays, node: int, *orders: int, last: int = OUTER) -> Members:
    """Whether `node` has the highest peak of nodes 1 to `last`, at all critical speeds `orders`."""
    of = outer_peaks(a, *orders, last=last)
    return np.asarray((of.argmax(axis=2) == node - 1).all(axis=1))


def inner(a: Arrays, node: int) -> Members:
    return np.asarray((base(a)[:, :, OUTER:].argmax(axis=2) == node - 1 - OUTER).all(axis=1))


def first_highest(a: Arrays) -> Members:
    """Whether nodes 13 to 19 have their highest peak at critical speed 1."""
    of = base(a)[:, :, OUTER:19]
    return np.asarray((of[:, :1] > of[:, 1:]).all(axis=(1, 2)))


def more_on_4(a: Arrays) -> Members:
    """Whether bearing 4 has a larger load than bearing 3 at every peak, for each unbalance 2."""
    return np.asarray((a["loads"][..., 1] > a["loads"][..., 0]).all(axis=(1, 2)))


def small(a: Arrays, node: int) -> Members:
    """Whether peaks of `node` are below half the median peak of nodes not at bearings 1 and 2."""
    others = [i for i in range(OUTER) if i + 1 not in (2, 6)]
    of = base(a)
    return np.asarray((of[:, :, node - 1] < SMALL * np.median(of[:, :, others], axis=2)).all(1))


def alike(a: Arrays, shaft: slice, peaks: slice) -> Members:
    of = a["torsion"][:, peaks, shaft]
    spread = (of.max(axis=2) - of.min(axis=2)) / of.mean(axis=2)
    return np.asarray((spread < ALIKE).all(axis=1))


def first_torsion(a: Arrays) -> Members:
    of = np.stack([a["torsion"][:, :, s].mean(axis=2) for s in (OUTER_NODES, INNER_NODES)])
    return np.asarray((of[:, :, 0] > of[:, :, 1:].max(axis=2)).all(axis=0))


def grows(values: Array) -> Members:
    """Whether all values (m, U_2, ...) of a member grow with unbalance 2."""
    return np.asarray((np.diff(values, axis=1) > 0).reshape(len(values), -1).all(axis=1))


def rises(loads: Array) -> Members:
    """Whether loads (m, U_2, 3, 2) increase from each critical speed to the next."""
    return np.asarray((np.diff(loads, axis=2) > 0).reshape(len(loads), -1).all(axis=1))


def anomaly(a: Arrays) -> Members:
    """Whether node 19's peak at critical speed 3 is lower at the largest than at the middle U_2."""
    peaks = a["peaks"][:, :, 1, 18]
    return np.asarray(peaks[:, 1] > peaks[:, 2])


def inverse_inertia(a: Arrays, order: int) -> Array:
    """Relative deviation (m,) of the ratio of torsion at nodes 4 and 19 from -J_in/J_out."""
    turned: Any = a["turned"][:, :, ORDERS.index(order)]
    wanted = -a["inertia"][:, 1] / a["inertia"][:, 0]
    return np.asarray(np.abs(turned[:, 0] / turned[:, 1] / wanted - 1))


def torsion(a: Arrays) -> Array:
    """Torsion amplitudes at the critical speeds; they exist even where a curve has no peak."""
    return a["torsion"]


def growing(name: str, node: int, at: slice = slice(None)) -> Statement:
    """Statement that the peaks of a node at some critical speeds grow with unbalance 2."""

    def peaks(a: Arrays) -> Array:
        return a["peaks"][:, :, at, node - 1]

    return Statement(name=name, symbol=f"x_{node}", holds=lambda a: grows(peaks(a)), compares=peaks)


def value(*ids: str) -> tuple[str, ...]:
    return tuple(f"huang2022:{id_}" for id_ in ids)


OUTER_NODES, INNER_NODES = slice(OUTER), slice(OUTER, None)
STATEMENTS = (
    Statement(name="node 11 has the highest peak of nodes 1 to 11 at critical speed 1",
              symbol="x_11",
              holds=lambda a: outer(a, 11, 1, last=11),
              compares=lambda a: outer_peaks(a, 1, last=11),
              printed=value("outer-highest-node-at-critical-1")),
    Statement(name="node 11 has the highest peak of nodes 1 to 12 (with the free end) at critical "
                   "speed 1", symbol="x_11", holds=lambda a: outer(a, 11, 1),
              compares=lambda a: outer_peaks(a, 1)),
    Statement(name="node 11 has the highest peak of nodes 1 to 11 at critical speeds 3 and 5",
              symbol="x_11", holds=lambda a: outer(a, 11, 3, 5, last=11),
              compares=lambda a: outer_peaks(a, 3, 5, last=11),
              printed=value("outer-highest-node-at-critical-3-and-5")),
    *(Statement(name=f"amplitude of node {node} at every peak is below half the median amplitude "
                     "of outer-rotor nodes without bearings to the ground",
                symbol=f"x_{node}", holds=partial(small, node=node),
                compares=lambda a: outer_peaks(a, *ORDERS),
                printed=value(f"outer-small-node-at-bearing-{k}"))
      for k, node in enumerate(GROUNDED[:2], start=1)),
    Statement(name="nodes 13 to 19 have their highest peaks at critical speed 1", symbol="x",
              holds=first_highest, compares=lambda a: base(a)[:, :, OUTER:19],
              printed=value("inner-high-range-first-node", "inner-high-range-last-node")),
    Statement(name="node 19 has the highest amplitude of the inner rotor at every peak",
              symbol="x_19",
              holds=lambda a: inner(a, 19), compares=lambda a: base(a)[:, :, OUTER:],
              printed=value("inner-highest-node")),
    Statement(name="torsional rotation is uniform along the outer rotor at critical speed 1",
              symbol="θ_z",
              holds=lambda a: alike(a, OUTER_NODES, slice(1)), compares=torsion),
    Statement(name="torsional rotation is uniform along the inner rotor at critical speed 1",
              symbol="θ_z",
              holds=lambda a: alike(a, INNER_NODES, slice(1)), compares=torsion),
    Statement(name="torsional rotation is uniform along both rotors at critical speeds 3 and 5",
              symbol="θ_z",
              holds=lambda a: alike(a, OUTER_NODES, slice(1, 3))
              & alike(a, INNER_NODES, slice(1, 3)), compares=torsion),
    Statement(name="torsional rotation is highest at critical speed 1", symbol="θ_z",
              holds=first_torsion, compares=torsion),
    growing("peaks of node 4 grow with unbalance 2", 4),
    growing("peaks of node 19 at critical speeds 1 and 5 grow with unbalance 2", 19,
            slice(None, None, 2)),
    Statement(name="peak of node 19 at critical speed 3 is lower with unbalance 2 = 5e-5 than with "
                   "3e-5 kg m", symbol="x_19", holds=anomaly,
              compares=lambda a: a["peaks"][:, 1:, 1, 18]),
    *(Statement(name=name, symbol=symbol, holds=holds, compares=lambda a: a["loads"])
      for name, symbol, holds in (
          ("loads of bearings 3 and 4 grow with unbalance 2", "F", lambda a: grows(a["loads"])),
          ("loads of bearings 3 and 4 are higher at higher critical speeds", "F",
           lambda a: rises(a["loads"])),
          ("load of bearing 4 exceeds that of bearing 3 at every peak", "F_4", more_on_4))),
    Statement(name="ratio of the torsional rotations of nodes 4 and 19 is −J_in/J_out within 3 % "
                   "at critical speed 1", symbol="θ_z",
              holds=lambda a: inverse_inertia(a, 1) < 0.03,
              compares=lambda a: np.abs(a["turned"])),
)  # fmt: skip
