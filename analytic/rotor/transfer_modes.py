"""Whirl frequencies at a speed, and critical speeds of rotors, by exact transfer matrices."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from analytic.rotor.transfer_bending import Bending
from analytic.rotor.transfer_model import TransferMatrixRotor
from analytic.rotor.transfer_roots import count_below, roots_below
from analytic.rotor.transfer_supported import check_supported

Array = NDArray[np.float64]
Whirl = Literal["forward", "backward"]
SENSES: tuple[Whirl, ...] = ("forward", "backward")
MOST_NODES = 400  # cut so fine, a rotor is far beyond the range of beam theory
PLANAR = 1e-6
SAME_SIZE = 1e-9  # relative to the largest: equal unknowns of a symmetric shape differ by round-off


@dataclass(frozen=True)
class TransferModes:
    """Natural frequencies `w` (k,) [rad/s] in ascending order, with whirl senses and mode shapes.

    `whirl` is 1 for forward, -1 for backward and 0 for planar modes. `unknowns` (k, 4 * nodes) are
    (r+, phi+ L) and then (r-, phi- L) of the nodes of `bending`, with r = r+ e^{iwt} + conj(r-)
    e^{-iwt}. `speeds` (k,) [rad/s] are the rotor speeds of the modes.
    """

    w: Array
    whirl: NDArray[np.int64]
    unknowns: NDArray[np.complex128]
    speeds: Array
    bending: Bending


Modes = TransferModes  # its name in version 0.1


def whirl_frequencies(
    rotor: TransferMatrixRotor, speeds: ArrayLike, *, count: int = 3, whirl: Whirl = "forward"
) -> Array:
    """Lowest `count` natural frequencies [rad/s] at `speeds` [rad/s], shape (speeds, count).

    Only for isotropic bearings, whose modes are circles: forward is the sense of a positive speed.
    Raises ValueError if bearings differ in x and y, the rotor is unsupported or count < 1.
    """
    Omega = np.atleast_1d(np.asarray(speeds, dtype=np.float64))
    return _Search(rotor, lambda _, item: Omega[item], Omega.size, whirl).lowest(count)[0]


def natural_frequencies(rotor: TransferMatrixRotor, speeds: ArrayLike, *, count: int = 6) -> Array:
    """Lowest `count` natural frequencies of both whirl senses, (speeds, count) [rad/s].

    Valid for all bearings.
    """
    if not rotor.isotropic:
        Omega = np.atleast_1d(np.asarray(speeds, dtype=np.float64))
        return _Search(rotor, lambda _, item: Omega[item], Omega.size, None).lowest(count)[0]
    both = [whirl_frequencies(rotor, speeds, count=count, whirl=sense) for sense in SENSES]
    return np.sort(np.concatenate(both, axis=1), axis=1)[:, :count]


def modes(rotor: TransferMatrixRotor, speed: float, *, count: int = 6) -> TransferModes:
    """Lowest `count` modes of both whirl senses at one speed [rad/s]."""
    return _modes(rotor, lambda w, _: np.full_like(w, speed), count, None)


def transfer_critical_speeds(
    rotor: TransferMatrixRotor,
    *,
    count: int = 3,
    whirl: Whirl | None = None,
    excitation: float = 1.0,
) -> TransferModes:
    """Lowest `count` rotor speeds at which a whirl frequency is `excitation` times the rotor speed.

    Unbalance of a shaft with speed ratio q has the excitation |q|, forward if q > 0. With `whirl` =
    None, both senses are included; a single sense requires isotropic bearings. Fewer than `count`
    speeds may exist, because gyroscopic stiffening limits the number of forward critical speeds.
    Raises ValueError if the excitation is zero or not finite, count < 1 or the rotor is
    unsupported.
    """
    if not (np.isfinite(excitation) and excitation != 0):
        raise ValueError(f"the excitation must be finite and not 0, got {excitation:g}")
    return _modes(rotor, lambda w, _: w / abs(excitation), count, whirl)


critical_speeds = transfer_critical_speeds  # its name in version 0.1


@dataclass(frozen=True)
class _Search:
    """Search of the frequencies w > 0 of `items` problems; `speed(w, item)` is the rotor speed."""

    rotor: TransferMatrixRotor
    speed: Callable[[Array, NDArray[np.int64]], Array]
    items: int
    whirl: Whirl | None  # None: both, coupled by bearings that differ in x and y

    def lowest(self, count: int) -> tuple[Array, Bending]:
        """Lowest roots (items, count), NaN if there are no more, and their bending model."""
        if count < 1:
            raise ValueError(f"count must be at least 1, got {count}")
        if self.whirl and not self.rotor.isotropic:
            raise ValueError(
                "forward or backward whirl can be selected only for bearings that are equal in x "
                "and y: use whirl=None or natural_frequencies"
            )
        check_supported(self.rotor)
        item, top = np.arange(self.items), np.full(self.items, _guess(self.rotor))
        while True:
            both = np.concatenate([self.sign * top, -top])
            speed = np.tile(self.speed(top, item), 2)
            taken = slice(None) if self.whirl is None else slice(self.items)
            bending = Bending.up_to(self.rotor, both[taken], speed[taken])
            enough = count_below(self.stiffness(bending, top, item)).min() >= count
            if enough or bending.nodes > MOST_NODES:
                break
            top = 2 * top
        roots = roots_below(lambda w, k: self.stiffness(bending, w, k), top, np.arange(count))
        return roots, bending

    @property
    def sign(self) -> float:
        return -1.0 if self.whirl == "backward" else 1.0

    def stiffness(
        self, bending: Bending, w: Array, item: NDArray[np.int64]
    ) -> NDArray[np.float64] | NDArray[np.complex128]:
        if self.whirl is None:
            return bending.coupled(w, self.speed(w, item))
        return bending.stiffness(self.sign * w, self.speed(w, item))


def _guess(rotor: TransferMatrixRotor) -> float:
    """Estimated lowest frequency [rad/s]: rigid rotor on its supports, or bending if lower."""
    k = sum(s.stiffness[0] for s in rotor.supports)
    m = sum(d.mass for d in rotor.discs)
    m += sum(s.rho * s.A * s.length for shaft in rotor.shafts for s in shaft.segments)
    length = max(sum(s.length for s in shaft.segments) for shaft in rotor.shafts)
    E_rho = min(s.E * s.I / (s.rho * s.A) for shaft in rotor.shafts for s in shaft.segments)
    return float(min(np.sqrt(k / m), 10 * np.sqrt(E_rho) / length**2))


def _modes(
    rotor: TransferMatrixRotor,
    speed: Callable[[Array, NDArray[np.int64]], Array],
    count: int,
    whirl: Whirl | None,
) -> TransferModes:
    """Modes of one problem; on isotropic bearings, each whirl sense is solved separately."""
    senses: tuple[Whirl | None, ...] = (whirl,)
    if whirl is None and rotor.isotropic:
        senses = SENSES
    searches = [_Search(rotor, speed, 1, sense) for sense in senses]
    found = [(search, *search.lowest(count)) for search in searches]
    bending = max((b for _, _, b in found), key=lambda b: b.nodes)
    ws, signs, vectors = [], [], []
    for search, roots, _ in found:
        for k, w in enumerate(roots[0]):
            if np.isfinite(w):
                v = _shape(search, bending, w, k)
                ws.append(w)
                vectors.append(v)
                signs.append(_sense(v))
    order = np.argsort(ws)[:count]
    w = np.array(ws)[order]
    return TransferModes(
        w, np.array(signs, dtype=np.int64)[order],
        np.array(vectors, dtype=np.complex128).reshape(-1, 4 * bending.nodes)[order],
        speed(w, np.zeros(w.size, dtype=np.int64)), bending,
    )  # fmt: skip


def _shape(search: _Search, bending: Bending, w: float, k: int) -> NDArray[np.complex128]:
    """Shape (r+, r-) of the root with index k, scaled to 1 at the largest unknown."""
    item = np.zeros(1, dtype=np.int64)
    _, vectors = np.linalg.eigh(search.stiffness(bending, np.array([w]), item)[0])
    v = vectors[:, k].astype(np.complex128)
    size = np.abs(v)
    v = np.asarray(v / v[(size >= (1 - SAME_SIZE) * size.max()).argmax()])
    if search.whirl is None:
        return v
    none = np.zeros_like(v)
    return np.concatenate([v, none] if search.whirl == "forward" else [none, v])


def _sense(v: NDArray[np.complex128]) -> int:
    """Whirl sense (forward, backward or planar) from the magnitudes of r+ and r- at all nodes."""
    plus, minus = (np.linalg.norm(half[::2]) for half in np.split(v, 2))
    if abs(plus - minus) <= PLANAR * (plus + minus):
        return 0
    return 1 if plus > minus else -1
