"""The rotor as beams, with every segment divided into `refine` elements."""

from typing import Any

import numpy as np

from verify.case import Level, solved
from verify.cases.rotor.system.companion import companion
from verify.cases.rotor.system.inputs import (
    CRITICALS,
    FREQUENCIES,
    CoaxialRotor,
    critical_name,
)

TURN = 2 * np.pi  # divisor from rad/s to Hz
RIGID = 1e-4  # relative to a torsional frequency: a lower frequency is a rigid-body rotation


def fem_rotor(q: CoaxialRotor, refine: int, theory: str = "timoshenko") -> Any:
    """Rotor of a user's file as beam elements."""
    from fem.rotor.model import Disc, Element, Link, Material, Rotor, Shaft, Support

    shafts = [
        Shaft(
            [Element(s.length, s.d_o, s.d_i, Material(s.E, s.nu, s.rho))
             for s in q.segments if s.shaft == shaft.name],
            ratio=shaft.ratio, z=shaft.start,
        )
        for shaft in q.shafts
    ]  # fmt: skip
    discs = []
    for disc in q.discs:
        if disc.d_o is not None and disc.width is not None:
            own = Disc.cylinder(disc.node - 1, disc.d_o, disc.d_i, disc.width, disc.rho)
            share = 1.0 if disc.mass is None else disc.mass / own.mass
            given = {"mass": own.mass * share, "polar": own.polar * share,
                     "diametral": own.diametral * share}  # fmt: skip
        else:
            given = {}
        for name in ("mass", "polar", "diametral"):
            value = getattr(disc, name)
            if value is not None:
                given[name] = value
        discs.append(Disc(disc.node - 1, width=disc.width or 0.0, **given))
    supports = [Support(s.node - 1, **_bearing(s)) for s in q.supports]
    links = [Link.bearing(a.node - 1, a.to - 1, **_bearing(a)) for a in q.links]
    return Rotor(shafts, discs, supports, links, refine=refine, theory=theory)


def _bearing(spring: Any) -> dict[str, Any]:
    return {
        "kxx": spring.k, "kyy": spring.kyy, "kxy": spring.kxy, "cxx": spring.c, "cyy": spring.cyy,
        "k_tilt": spring.k_tilt, "c_tilt": spring.c_tilt, "k_turn": spring.k_turn,
    }  # fmt: skip


def solve(q: CoaxialRotor, level: int) -> Level:
    """Beam results of the rotor and, for the default rotor, of the second test rotor."""
    values = fem_values(q, level)
    if q.is_default:
        other = fem_values(companion(CoaxialRotor), level)
        values |= {f"{key}_companion": value for key, value in other.items()}
    return solved(1 / level, **values)


def fem_values(q: CoaxialRotor, level: int) -> dict[str, float]:
    from fem.rotor.critical import critical_speeds
    from fem.rotor.modes import modes

    undamped = fem_rotor(still(q), level)
    found = modes(undamped, q.speed, FREQUENCIES)
    values = {f"frequency_{k}": w / TURN for k, w in enumerate(found.frequencies, start=1)}
    values |= {f"sense_{k}": float(s) for k, s in enumerate(found.whirl, start=1)}
    alike = all(s.kyy in (None, s.k) and s.kxy == 0 for s in (*q.supports, *q.links))
    ratios = list(dict.fromkeys(shaft.ratio for shaft in q.shafts if shaft.ratio))
    for group, ratio in enumerate(ratios, start=1):
        whirl = "both" if not alike else "forward" if ratio > 0 else "backward"
        speeds = critical_speeds(undamped, CRITICALS, whirl, abs(ratio)).speeds
        values |= {f"{critical_name(group)}_{k}": w for k, w in enumerate(speeds, start=1)}
    turning = modes(undamped, 0.0, len(q.shafts) + 1, "torsion").frequencies
    values["torsion"] = turning[turning > RIGID * turning.max()][0] / TURN
    slender = modes(fem_rotor(still(q), level, "euler"), q.speed, FREQUENCIES).frequencies
    values |= {f"euler_{k}": w / TURN for k, w in enumerate(slender, start=1)}
    values |= _fem_response(q, fem_rotor(q, level))
    return {key: float(value) for key, value in values.items()}


def still(q: CoaxialRotor) -> CoaxialRotor:
    """The rotor without damping, for natural frequencies."""
    none = {"c": 0.0, "cyy": None, "c_tilt": 0.0}
    bearings = {
        "supports": tuple(s.model_copy(update=none) for s in q.supports),
        "links": tuple(s.model_copy(update=none) for s in q.links),
    }
    return q.model_copy(update=bearings)


def _fem_response(q: CoaxialRotor, rotor: Any) -> dict[str, float]:
    """Amplitude and loads at the speed, summed over unbalances that rotate at different speeds."""
    from fem.rotor.response import unbalance_response

    groups: dict[float, dict[int, complex]] = {}
    for u in q.unbalances:
        ratio = rotor.shafts[rotor.shaft_of[u.node - 1]].ratio
        own = groups.setdefault(ratio, {})
        own[u.node - 1] = own.get(u.node - 1, 0.0) + u.value * np.exp(1j * u.angle)
    found: dict[str, float] = {}
    for ratio, group in groups.items():
        if ratio:
            response = unbalance_response(rotor, q.speed, group)
            parts = {"amplitude": response.major(q.probe - 1)[0],
                     "support_load": _largest(response.support_load(0)[0])}  # fmt: skip
            if q.links:
                parts["link_load"] = _largest(response.link_load(0)[0])
            found = {key: found.get(key, 0.0) + value for key, value in parts.items()}
    return found


def _largest(load: Any) -> float:
    """Semi-major axis of the ellipse of a rotating force [N]."""
    x, y = load[:2]
    return float((abs(x + 1j * y) + abs(x - 1j * y)) / 2)
