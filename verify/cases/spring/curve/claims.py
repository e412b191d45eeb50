"""Margins of the rows of the whole curve: fitted lines, contact, energy, limits, Eq. 10."""

from collections.abc import Callable
from functools import cache

import numpy as np

from analytic.spring.stages import stages
from fem.beam import two_lines
from fem.beam.two_lines import ROUNDING, TWICE, FittedLines, fitted, on_common
from verify.cases.spring.claims import stored
from verify.cases.spring.curve.inputs import CurveInputs
from verify.cases.spring.curve.reference import (
    BEYOND,
    COARSE,
    FINE,
    THIN,
    THIN_UNITS,
    TIMES,
    readings,
    thin,
)
from verify.cases.spring.stages.readings import eq10
from verify.core.case import Context
from verify.core.figures import Array
from verify.judging.checks import Margin

mm = 1e-3
FORCE = 0.04  # relative to Eq. 10, along the curve
SETTLED = 1e-4  # over b: tolerance of the gap at which contact acts
STIFFER = 10.0  # over k_2, once all loops touch


def curve(context: Context, level: int = FINE) -> Array:
    """Displacement [m], force [N] and sum of contact forces [N] of the spring, shape (3, k)."""
    U, F, press = (stored(context, f"curve {level} {key}") for key in ("U", "F", "press"))
    return np.array([U, F, press.sum(axis=1)])


def lines(context: Context, level: int = FINE) -> FittedLines:
    """Fitted lines of the curve of the spring of the inputs."""
    return fitted(curve(context, level), context.inputs.stroke)


def read(context: Context) -> list[tuple[str, float, FittedLines, Array]]:
    """For each reading and width factor: name, factor, fitted lines, and U [m], F [N] (2, k)."""
    q: CurveInputs = context.inputs
    found = []
    for name, _ in readings(q):
        U, F, N = stored(context, f"reading {name}")
        for factor in (1.0, q.width_factor, 1 / (1 - q.nu**2)):
            stiff = np.array([U, factor * F, factor * N])
            found.append((name, factor, fitted(stiff, q.stroke), stiff[:2]))
    return found


def beside(context: Context, other: Array) -> tuple[FittedLines, FittedLines]:
    """Fitted lines of two curves: that of the inputs on the coarse mesh, and `other` (3, k).

    Both curves are evaluated at the same displacements.
    """
    stroke = context.inputs.stroke
    own, other = on_common(curve(context, COARSE), other, stroke)
    return fitted(own, stroke), fitted(other, stroke)


def apart(context: Context, other: Array) -> float:
    """Largest relative difference of slopes between the inputs' coarse curve and `other`."""
    own, other_lines = beside(context, other)
    return own.apart(other_lines)


def without(context: Context) -> str:
    """Text that k_2 is missing, if too few states have contact; otherwise empty."""
    return "" if np.isfinite(lines(context).k2) else "; no k_2: too few states with contact"


def drift(number: Callable[[FittedLines], float]) -> Callable[[Context], float]:
    """Function that returns the relative difference of `number` between coarse and fine mesh."""

    def of(context: Context) -> float:
        coarse, fine = map(number, beside(context, curve(context)))
        return abs(coarse / fine - 1)

    return of


def depth(context: Context) -> tuple[float, float, str]:
    b, deepest = context.inputs.b, float(stored(context, f"curve {FINE} depth").max())
    return deepest / b, 0.0, f"the largest overlap of surfaces is {deepest / b:.1e} b"


def same_contact(context: Context) -> tuple[float, float, str]:
    off = max(apart(context, stored(context, f"contact {times:g}")) for times in TIMES)
    words = f"largest change of slopes {off:.1e} with a tenth or ten times the contact stiffness"
    return off, 0.0, words + without(context)


def halved(context: Context) -> tuple[float, float, str]:
    off = apart(context, curve(context))
    words = f"largest change of slopes {off:.1e} from {COARSE} to {FINE} cells"
    return off, 0.0, words + without(context)


def balance(context: Context) -> tuple[float, float, str]:
    work, energy, lost = (
        stored(context, f"curve {FINE} {key}") for key in ("work", "stored", "dissipated")
    )
    off = float(abs(work - energy - lost).max() / work.max())
    words = f"largest difference of work and energies {off:.1e} of the work"
    return off, 0.0, words


def retraced(context: Context) -> tuple[float, float, str]:
    """Largest relative difference between unloading and loading forces, without friction.

    The uncertainty and the text of the row are also returned.
    """
    U, F, _ = stored(context, "there and back")
    off = two_lines.retraced(U, F)
    return off, 0.0, f"unloading forces differ from loading forces by {off:.1e}"


def ends_early(context: Context) -> bool:
    """Whether the curve ends because no equilibrium was found.

    It ends regularly at the last displacement or when the force has doubled.
    """
    U, F, _ = curve(context)
    stroke = context.inputs.stroke
    at_stroke = F[stroke * (1 + ROUNDING) >= U][-1]
    return bool(stroke * (1 + BEYOND[-1]) * (1 - ROUNDING) > U[-1] and TWICE * at_stroke >= F[-1])


def stiffens(context: Context) -> tuple[float, float, str]:
    """Positive margin if the final slope exceeds STIFFER times k_2; nan if the curve ends early.

    The uncertainty and the text of the row are also returned.
    """
    U, F, _ = curve(context)
    if ends_early(context):
        return np.nan, 0.0, f"no result: no equilibrium was found beyond {U[-1] / mm:.4g} mm"
    ratio = float((F[-1] - F[-2]) / (U[-1] - U[-2])) / lines(context).k2
    if not np.isfinite(ratio):
        return ratio, 0.0, without(context).removeprefix("; ")
    words = f"dF/dU is {ratio:.3g} times k_2 at {U[-1] / mm:.4g} mm, {F[-1]:.4g} N"
    return ratio - STIFFER, 0.0, words


def near(key: str, figure: float, printed: Callable[[], float]) -> Margin:
    """Function that returns a positive margin if a value differs from Eq. 10 by less than `figure`.

    The value is the attribute `key` of the fitted lines.
    """

    def margin(context: Context) -> tuple[float, float, str]:
        def own(found: FittedLines) -> float:
            return float(getattr(found, key))

        off = own(lines(context)) / printed() - 1
        return figure - abs(off), drift(own)(context), f"{off:+.2%} from the printed value"

    return margin


def nearest(context: Context) -> tuple[float, float, str]:
    """Positive margin if no other reading gives a smaller error of k_1 than the given reading.

    The uncertainty and the text of the row are also returned.
    """
    q: CurveInputs = context.inputs
    given = f"{q.tail}, {q.head}, {q.arcs}", q.width_factor
    off = {
        (name, f): abs(found.k1 / eq10().k1 - 1)
        for name, f, found, _ in read(context) if np.isfinite(found.k1)
    }  # fmt: skip
    next_one = min((key for key in off if key != given), key=off.__getitem__)
    words = (
        f"on the coarse mesh, k_1 of the chosen reading differs by {off[given]:.2%} from Eq. 10, "
        f"and k_1 of the next reading ({next_one[0]}, f = {next_one[1]:.4g}) by {off[next_one]:.2%}"
    )
    return off[next_one] - off[given], 0.0, words


def along(context: Context) -> tuple[float, float, str]:
    """Positive margin if F(U) differs from Eq. 10 by less than FORCE for U = 1 to 17 mm.

    The uncertainty and the text of the row are also returned.
    """
    U, off = deviations(context, FINE)
    worst = int(np.argmax(abs(off)))
    u = float(abs(off - deviations(context, COARSE)[1]).max())
    words = (
        f"largest difference {off[worst]:+.2%} at {U[worst] / mm:g} mm; "
        f"difference {off[-1]:+.2%} at 17 mm"
    )
    return FORCE - abs(off[worst]), u, words


def deviations(context: Context, level: int) -> tuple[Array, Array]:
    """Displacements U = 1 to 17 mm [m], and relative differences of the force from Eq. 10."""
    U = np.arange(1.0, 18.0) * mm
    reached, F = (stored(context, f"curve {level} {key}") for key in ("U", "F"))
    return U, np.interp(U, reached, F) / eq10().force(U) - 1


def parallel(k: int) -> Callable[[Context], tuple[list[float], list[float], list[float]]]:
    """Function that returns relative differences of beams from the closed form for slender leaves.

    They are those of U_A, F_A or k_2 (`k`). The function returns loop radii over L_1, differences
    and uncertainties.
    """
    name = ("U_A", "F_A", "k2")[k]

    def points(context: Context) -> tuple[list[float], list[float], list[float]]:
        coarse, fine = stored(context, "thin")[:, :, k]
        forms = [_thin(context.inputs, share) for share in THIN]
        exact = np.array([form[name] for form in forms])
        early = [SETTLED * thin(context.inputs, share).b / form["gap"]
                 for share, form in zip(THIN, forms, strict=True)]  # fmt: skip
        u = np.maximum(abs(fine / coarse - 1), early)
        return list(THIN), (fine / exact - 1).tolist(), u.tolist()

    return points


@cache
def _thin(q: CurveInputs, share: float) -> dict[str, float]:
    spring = thin(q, share)
    found = stages(n=THIN_UNITS, b=spring.b, h=q.h, radius=spring.line["radius"], L1=q.L1,
                   alpha=spring.line["alpha"], E=q.E, nu=q.nu, theory="shear")  # fmt: skip
    return {key: float(getattr(found, key)) for key in ("U_A", "F_A", "k2", "gap")}
