"""Texts on critical speeds of a rotor and its operating range, with the verdict first."""

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from verify.cases.rotor.system.formulas import TransferRotor
from verify.cases.rotor.system.inputs import RPM

SENSE = {1: "forward", -1: "backward", 0: "planar"}


class Critical(NamedTuple):
    """A critical speed of the rotor [rad/s], the shafts that excite it, and its sense of whirl."""

    speed: float
    shafts: str
    whirl: int


def criticals(q: TransferRotor) -> list[Critical]:
    """Critical speeds that the unbalance of any shaft excites, in ascending order."""
    return sorted(
        Critical(float(speed), " and ".join(excited.shafts), int(whirl))
        for excited in q.study.excited
        for speed, whirl in zip(excited.speeds, excited.modes.whirl, strict=True)
    )


def limits(q: TransferRotor) -> tuple[float, float]:
    """Bounds of the operating speed [rad/s], extended by the required margin."""
    return q.speed_from * (1 - q.margin), q.speed_to * (1 + q.margin)


def too_near(q: TransferRotor) -> list[Critical]:
    low, high = limits(q)
    return [c for c in criticals(q) if low <= c.speed <= high]


def distance(q: TransferRotor, speed: float) -> float:
    """Signed relative distance of `speed` from the operating range: 0 inside, negative below."""
    if speed < q.speed_from:
        return speed / q.speed_from - 1
    return speed / q.speed_to - 1 if speed > q.speed_to else 0.0


def findings(q: TransferRotor) -> Sequence[str]:
    return (*_verdict(q), *_neighbours(q), _frequencies(q), *_amplitudes(q))


def _verdict(q: TransferRotor) -> list[str]:
    asked = f"{q.speed_from / RPM:.5g} to {q.speed_to / RPM:.5g} r/min"
    if not (met := too_near(q)):
        return [
            "clear: no critical speed that an unbalance excites is within "
            f"{q.margin:.0%} of the operating range {asked}"
        ]
    number = f"{len(met)} critical speed{'s' if len(met) > 1 else ''}"
    return [
        f"not clear: {number} within {q.margin:.0%} of the operating range {asked}",
        *(_critical_text(q, c) for c in met),
    ]


def _critical_text(q: TransferRotor, critical: Critical) -> str:
    far = distance(q, critical.speed)
    place = "in the operating range" if far == 0 else f"{abs(far):.1%} "
    place += (
        "" if far == 0 else "below the operating range" if far < 0 else "above the operating range"
    )
    return (
        f"critical speed {critical.speed / RPM:.5g} r/min (unbalance of shaft {critical.shafts}, "
        f"{SENSE[critical.whirl]} whirl): {place}"
    )


def _neighbours(q: TransferRotor) -> list[str]:
    """Texts on the nearest critical speeds below and above the operating range with its margin."""
    low, high = limits(q)
    found = criticals(q)
    below = [c for c in found if c.speed < low][-1:]
    above = [c for c in found if c.speed > high][:1]
    return [_critical_text(q, c) for c in below + above]


def _frequencies(q: TransferRotor) -> str:
    modes = q.study.modes
    frequencies = ", ".join(
        f"{w / 2 / np.pi:.4g} Hz {SENSE[int(s)]}" for w, s in zip(modes.w, modes.whirl, strict=True)
    )
    return f"natural frequencies at {q.speed / RPM:.5g} r/min: {frequencies}"


def _amplitudes(q: TransferRotor) -> list[str]:
    if not q.study.responses:
        return []
    loads = {
        f"{table}[{k}]": sum(float(r.load(spring)[0]) for r in q.study.responses)
        for table, springs in (("supports", q.rotor.supports), ("links", q.rotor.links))
        for k, spring in enumerate(springs, start=1)
    }
    worst = max(loads, key=loads.__getitem__)
    together = (
        "; both are sums over the unbalances of all shafts" if len(q.study.responses) > 1 else ""
    )
    return [
        f"at {q.speed / RPM:.5g} r/min, the amplitude of node {q.probe} is "
        f"{q.amplitude * 1e6:.3g} µm (zero to peak), and the largest bearing load is "
        f"{loads[worst]:.4g} N, at {worst}{together}"
    ]


def summary(q: TransferRotor) -> Mapping[str, Any]:
    """Verdict, critical speeds with distances from the operating range, and whirl, as JSON."""
    return {
        "verdict": "not clear" if too_near(q) else "clear",
        "critical_speeds": [
            {"speed": c.speed / RPM, "unit": "r/min", "unbalance_of": c.shafts,
             "whirl": SENSE[c.whirl], "distance": distance(q, c.speed)}
            for c in criticals(q)
        ],
        "whirl": [SENSE[int(s)] for s in q.study.modes.whirl],
    }  # fmt: skip


def refusal(q: TransferRotor) -> str:
    """Reason why the reference does not cover the rotor (too many segments); empty if it does."""
    most = 60
    if len(q.segments) > most:
        return f"the rotor has {len(q.segments)} segments; the reference accepts at most {most}"
    return ""
