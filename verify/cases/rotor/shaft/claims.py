"""Claims about a uniform turning shaft: what beam theories neglect, their limits, acceptance."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from verify.cases.rotor.shaft.expected import frequency
from verify.cases.rotor.shaft.fem import MODES, RATIOS
from verify.cases.rotor.shaft.inputs import ShaftInputs
from verify.core.case import Context, Values
from verify.judging.checks import Limit

CEILING = 0.002  # of a uniform tube's frequencies, Timoshenko's beam against the elastic body
NEAR = 5e-5  # how well the error of a formula is known beforehand
SMALL = 0.3  # of rotary inertia and shear, up to which their series is used
TOWARDS = (0.0125, 0.025, 0.05, 0.125)  # diameters over lengths of Timoshenko's limit
DIGITS = 2e-12  # of both sides there


def inertia_and_shear(q: ShaftInputs) -> tuple[float, float]:
    """I k^2/A of mode 1, and E/(kappa G): rotary inertia and, times that, shear [1]."""
    s = q.shaft()
    return s.I / s.A * (np.pi / q.L) ** 2, q.E * s.A / s.S


def neglected(theory: str) -> Any:
    """Interval of the error of mode 1 by Timoshenko's equation, W the square over Euler's.

    1 - W (1 + a) + s e^2 W^2 = 0 with a = e (1 + s): Euler's error is 1/sqrt(W) - 1 = a/2 less
    a^2/8 + s e^2/2 to second order, Rayleigh's is e s/2 less no more than that. Twice the second
    order is allowed, downwards.
    """

    def interval(q: ShaftInputs, _: Values) -> tuple[float, float] | None:
        e, s = inertia_and_shear(q)
        a = e * (1 + s)
        leading = a / 2 if theory == "euler" else e * s / 2
        return (leading - a**2 / 4 - s * e**2, leading) if a < SMALL else None

    return interval


def known(j: int) -> Any:
    """Interval about the error of Timoshenko's equation against the cylinder of elasticity.

    The equation is solved anew: a slip of the formula's value does not move what it is held to.
    """

    def interval(q: ShaftInputs, v: Values) -> tuple[float, float]:
        m = frequency(q, j) / v[f"exact {j} at rest"] - 1
        return m - NEAR, m + NEAR

    return interval


def errors(key: str, of: str) -> Any:
    """Errors of a frequency against the formula `of`, per level."""

    def found(context: Context) -> tuple[list[float], list[float]]:
        h, v = context.series(key)
        return h, [value / context.analytic[of] - 1 for value in v]

    return found


def euler_limit(context: Context) -> tuple[list[float], list[float], list[float]]:
    """Euler's error at rest against the elastic body, as the shaft gets slender.

    Beside the meshes' uncertainty stands that of a first term alone: (k r)^2 of it.
    """
    q = context.inputs
    runs = np.array([r.arrays["limit"] for r in context.fem])
    formula = [q.shaft(L=q.d_o / ratio).whirl(1, theory="euler")[0] for ratio in RATIOS]
    d = formula / runs[-1] - 1
    u = np.abs(runs[-1] / runs[-2] - 1) + np.abs(d) * (np.pi / 2 * np.array(RATIOS)) ** 2
    return list(RATIOS), d.tolist(), u.tolist()


@dataclass(frozen=True, kw_only=True)
class FormulasLimit(Limit):
    """Both sides are formulas: no finite elements."""

    @property
    def needs_fem(self) -> bool:
        return False


def timoshenko_limit(context: Context) -> tuple[list[float], list[float], list[float]]:
    """Timoshenko's error at rest against the cylinder of elasticity, its first term likewise."""
    q, d = context.inputs, []
    for ratio in TOWARDS:
        exact = q.cylinder().whirl(np.pi * ratio / q.d_o)[0][0]
        d.append(q.shaft(L=q.d_o / ratio).whirl(1, theory="timoshenko")[0] / exact - 1)
    u = DIGITS + np.abs(d) * (np.pi / 2 * np.array(TOWARDS)) ** 2
    return list(TOWARDS), d, u.tolist()


def within_ceiling(context: Context) -> tuple[float, float, str]:
    """What is left of 0.2 % between Timoshenko's beam and the elastic body, modes 1 to 3."""
    runs = [context.series(f"solid {j} at rest")[1] for j in MODES]
    m = [context.analytic[f"timoshenko {j} at rest"] / v[-1] - 1 for j, v in zip(MODES, runs,
         strict=True)]  # fmt: skip
    U = max(abs(v[-1] / v[-2] - 1) for v in runs)
    return CEILING - max(map(abs, m)), U, ", ".join(f"{x:+.4%}" for x in m)


def slender(context: Context) -> tuple[float, float, str]:
    """What is left of 1e-5 at the finest level, 32 elements on a shaft of d/L = 0.03."""
    m = context.series("beam slender")[1][-1] / context.analytic["slender"] - 1
    return 1e-5 - abs(m), 1e-9, f"{m:.1e}"


def sense(context: Context) -> tuple[float, float, str]:
    """The least share by which forward whirl is faster, where elements name it so."""
    v = context.fem[-1].values
    share = [v[f"{name} split"] / v[f"{name} 1 forward"]
             for name in ("beam timoshenko", "weak timoshenko", "solid")]  # fmt: skip
    named = v["beam sense"] == 2  # the faster of the pair is +1, the slower -1
    return min(share) if named else -1.0, 1e-9, f"by {min(share):.2%} of the frequency"
