"""A rotor by transfer matrices: frequencies, critical speeds, response, torsion."""

from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from analytic.rotor.transfer_modes import (
    Modes,
    critical_speeds,
    modes,
    natural_frequencies,
    whirl_frequencies,
)
from analytic.rotor.transfer_response import Response, unbalance_response
from analytic.rotor.transfer_torsion import torsional_frequencies
from verify.cases.rotor.system.companion import JUDGED, NAMED, companion, has_companion
from verify.cases.rotor.system.inputs import SystemInputs
from verify.core.case import Values

FREQUENCIES = 6
CRITICALS = 3  # of each shaft's unbalance, judged
SEARCHED = 8  # and looked for
CAMPBELL = 20  # speeds
TURN = 2 * np.pi  # frequencies are handed over in Hz, speeds in rad/s

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Excited:
    """Critical speeds [rad/s] of the unbalance of shafts with one `ratio`, and their modes."""

    ratio: float
    shafts: tuple[str, ...]
    modes: Modes

    @property
    def speeds(self) -> Array:
        """Of the rotor, rising."""
        return self.modes.speeds


@dataclass(frozen=True)
class Study:
    """What the formulas find of a rotor."""

    modes: Modes
    excited: tuple[Excited, ...]
    responses: tuple[Response, ...]
    torsion: Array
    slender: Array  # frequencies by Euler's theory


@lru_cache(maxsize=4)
def study(q: SystemInputs) -> Study:
    """Modes at the speed told, critical speeds of every shaft's unbalance, response, torsion."""
    return Study(
        modes=modes(q.rotor, q.speed, count=FREQUENCIES),
        excited=tuple(_excited(q, ratio) for ratio in ratios(q)),
        responses=tuple(
            unbalance_response(q.rotor, q.speed, group, excitation=ratio)
            for ratio, group in q.unbalanced().items()
            if ratio
        ),
        torsion=torsional_frequencies(q.rotor, count=1),
        slender=modes(replace(q.rotor, theory="euler"), q.speed, count=FREQUENCIES).w,
    )


def ratios(q: SystemInputs) -> list[float]:
    """Ratios of speed that unbalance may turn with, in the order of the shafts."""
    return list(dict.fromkeys(shaft.ratio for shaft in q.shafts if shaft.ratio))


def _excited(q: SystemInputs, ratio: float) -> Excited:
    """On bearings alike in x and y unbalance excites whirl in its own sense alone."""
    names = tuple(shaft.name for shaft in q.shafts if shaft.ratio == ratio)
    sense = None if not q.rotor.isotropic else "forward" if ratio > 0 else "backward"
    found = critical_speeds(q.rotor, count=SEARCHED, whirl=sense, excitation=abs(ratio))  # type: ignore[arg-type]
    return Excited(ratio, names, found)


def opposite_criticals(q: SystemInputs) -> list[float]:
    """Critical speeds [rad/s] of whirl against the unbalance's turn, which bearings excite.

    Unbalance excites them only where bearings differ in x and y; where they are given so, all
    critical speeds are among those of `study`.
    """
    if not q.rotor.isotropic:
        return []
    found: list[float] = []
    for ratio in ratios(q):
        sense = "backward" if ratio > 0 else "forward"
        modes_ = critical_speeds(q.rotor, count=SEARCHED, whirl=sense, excitation=abs(ratio))  # type: ignore[arg-type]
        found += [float(w) for w in modes_.speeds]
    return sorted(found)


def analytic(q: SystemInputs) -> Values:
    """By key, in SI units; those of the companion beside the default rotor's."""
    values = _values(q)
    if has_companion(q):
        other = _values(companion())
        values |= {f"{NAMED} {key}": other[key] for key in JUDGED}
    return values


def _values(q: SystemInputs) -> dict[str, float]:
    found = study(q)
    values = {f"frequency {k}": w / TURN for k, w in enumerate(found.modes.w, start=1)}
    values |= {f"whirl {k}": float(s) for k, s in enumerate(found.modes.whirl, start=1)}
    for group, excited in enumerate(found.excited, start=1):
        for k, speed in enumerate(excited.speeds[:CRITICALS], start=1):
            values[f"critical {group}.{k}"] = speed
    values["torsion"] = found.torsion[0] / TURN
    values |= {f"euler {k}": w / TURN for k, w in enumerate(found.slender, start=1)}
    if found.responses:
        values["amplitude"] = sum(r.amplitude(q.probe - 1)[0] for r in found.responses)
        values["support load"] = sum(r.load(q.rotor.supports[0])[0] for r in found.responses)
        if q.rotor.links:
            values["link load"] = sum(r.load(q.rotor.links[0])[0] for r in found.responses)
    return {key: float(value) for key, value in values.items()}


def shown_to(q: SystemInputs) -> float:
    """Where axes of the speed end [rad/s]: with the nearest critical speed above on them."""
    top = max(q.speed_to, q.speed)
    above = [w for excited in study(q).excited for w in excited.speeds if w > top]
    return float(max(1.2 * top, 1.1 * min(above, default=0.0)))


@lru_cache(maxsize=2)
def campbell(q: SystemInputs) -> tuple[Array, Array, tuple[int, ...]]:
    """Speeds (n,), natural frequencies (n, branches) [rad/s] and the sense of each branch.

    On unlike bearings, where whirl is elliptical, a branch has the sense that it has at the speed
    that frequencies are told at.
    """
    speeds = np.linspace(0, shown_to(q), CAMPBELL)
    if not q.rotor.isotropic:
        told = tuple(int(sense) for sense in study(q).modes.whirl[:FREQUENCIES])
        return speeds, natural_frequencies(q.rotor, speeds, count=len(told)), told
    half = FREQUENCIES // 2
    forward = whirl_frequencies(q.rotor, speeds, count=half, whirl="forward")
    backward = whirl_frequencies(q.rotor, speeds, count=half, whirl="backward")
    return speeds, np.concatenate([forward, backward], axis=1), (1,) * half + (-1,) * half
