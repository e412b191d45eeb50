"""Transfer-matrix results of one rotor: modes, critical speeds, response, torsion."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from analytic.rotor.transfer_model import TransferMatrixRotor
from analytic.rotor.transfer_modes import (
    TransferModes,
    Whirl,
    modes,
    natural_frequencies,
    transfer_critical_speeds,
    whirl_frequencies,
)
from analytic.rotor.transfer_response import TransferResponse, transfer_unbalance_response
from analytic.rotor.transfer_torsion import torsional_frequencies

SEARCHED = 8  # critical speeds of each shaft's unbalance
CAMPBELL = 20  # speeds

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Excited:
    """Modes at the critical speeds due to unbalance of the shafts with the speed ratio `ratio`."""

    ratio: float
    shafts: tuple[str, ...]
    modes: TransferModes

    @property
    def speeds(self) -> Array:
        """Critical speeds [rad/s] of the rotor in ascending order."""
        return self.modes.speeds


@dataclass(frozen=True)
class Study:
    """Transfer-matrix results of a rotor, returned by `study`."""

    modes: TransferModes
    excited: tuple[Excited, ...]
    responses: tuple[TransferResponse, ...]
    torsion: Array
    slender: Array  # frequencies by Euler's theory


def study(
    rotor: TransferMatrixRotor, names: Sequence[str], speed: float,
    unbalances: Mapping[float, Mapping[int, complex]], count: int,
) -> Study:  # fmt: skip
    """Compute modes and response at `speed` [rad/s], critical speeds, and the torsional frequency.

    `count` is the number of modes, `names` are the names of the shafts. `unbalances` [kg m] are
    given at stations numbered from 0, grouped by the speed ratio of their shaft. A shaft that does
    not rotate causes no excitation.
    """
    return Study(
        modes=modes(rotor, speed, count=count),
        excited=tuple(_excited(rotor, names, ratio) for ratio in ratios(rotor)),
        responses=tuple(
            transfer_unbalance_response(rotor, speed, group, excitation=ratio)
            for ratio, group in unbalances.items() if ratio
        ),
        torsion=torsional_frequencies(rotor, count=1),
        slender=modes(replace(rotor, theory="euler"), speed, count=count).w,
    )  # fmt: skip


def ratios(rotor: TransferMatrixRotor) -> list[float]:
    """Distinct speed ratios of the rotating shafts, in the order of the shafts."""
    return list(dict.fromkeys(shaft.ratio for shaft in rotor.shafts if shaft.ratio))


def _excited(rotor: TransferMatrixRotor, names: Sequence[str], ratio: float) -> Excited:
    """Critical speeds due to unbalance of the shafts with the speed ratio `ratio`.

    On isotropic bearings, unbalance excites only whirl in the direction of its rotation.
    """
    own = tuple(n for n, s in zip(names, rotor.shafts, strict=True) if s.ratio == ratio)
    sense: Whirl | None = None
    if rotor.isotropic:
        sense = "forward" if ratio > 0 else "backward"
    found = transfer_critical_speeds(rotor, count=SEARCHED, whirl=sense, excitation=abs(ratio))
    return Excited(ratio, own, found)


def opposite_criticals(rotor: TransferMatrixRotor) -> list[float]:
    """Critical speeds [rad/s] of whirl opposite to the unbalance, for isotropic bearings.

    On isotropic bearings, unbalance does not excite them. For anisotropic bearings, the list is
    empty, because `study` already contains all critical speeds.
    """
    if not rotor.isotropic:
        return []
    found: list[float] = []
    for ratio in ratios(rotor):
        sense: Whirl = "backward" if ratio > 0 else "forward"
        opposite = transfer_critical_speeds(
            rotor, count=SEARCHED, whirl=sense, excitation=abs(ratio)
        )
        found += [float(w) for w in opposite.speeds]
    return sorted(found)


def branches(
    rotor: TransferMatrixRotor, top: float, at_speed: TransferModes, count: int
) -> tuple[Array, Array, tuple[int, ...]]:
    """Speeds (n,) up to `top`, natural frequencies (n, branches) [rad/s], whirl senses.

    `count` is the even number of branches. On anisotropic bearings, whirl is elliptical, and the
    senses are those of the modes `at_speed`.
    """
    speeds = np.linspace(0, top, CAMPBELL)
    if not rotor.isotropic:
        senses = tuple(int(sense) for sense in at_speed.whirl)
        return speeds, natural_frequencies(rotor, speeds, count=len(senses)), senses
    half = count // 2
    forward = whirl_frequencies(rotor, speeds, count=half, whirl="forward")
    backward = whirl_frequencies(rotor, speeds, count=half, whirl="backward")
    both = np.concatenate([forward, backward], axis=1)
    return speeds, both, (1,) * half + (-1,) * half
