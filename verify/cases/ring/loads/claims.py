"""What is judged of a race under n sprags: finite elements, Fourier ring, and Eq. 6 beside both."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.integrate import quad

from verify.cases.ring.loads import formulas
from verify.cases.ring.loads.fem import stations
from verify.cases.ring.loads.inputs import LoadsInputs
from verify.core.case import Check, Context, Values
from verify.core.results import Row
from verify.judging.checks import Accepted, Approximation, Identity
from verify.judging.convergence import grid_convergence
from verify.judging.judge import expanded, numerical_uncertainty
from verify.judging.tolerance_checks import Deviation

SHARP = 1e-3
ACCEPTED = "acceptance figure of finite elements against the Fourier ring"
EDGE = 1.5  # order at the load: even cells on the pressure's square-root end
AWAY = 3.0  # and away from it: twice the order of the energy norm, 3/2 by that end
FITTED = "on a force and a length that are identified, not printed"
BY_FOURIER = (
    "derived: the Fourier ring's own value, which knows nothing of these finite elements; the dent "
    "from McEwen's stresses, integrated along the axis of the contact"
)
DEPTH = {"dent, wall": 1.0, "dent, half wall": 0.5}  # over the wall
PART = 0.05  # of the displacement at the load: of less a ratio says nothing


@dataclass(frozen=True, kw_only=True)
class Smeared(Approximation):
    """A formula beside the finite elements' deflection, less what `less` names: the dent."""

    less: str = ""

    def rows(self, context: Context) -> list[Row]:
        taken = context.analytic[self.less] if self.less else 0.0
        fem = [
            replace(result, values={**result.values, self.fem: result.values[self.fem] - taken})
            for result in context.fem
        ]
        return super().rows(replace(context, fem=fem))


def predicted(
    formula: str, key: str, less: str
) -> Callable[[LoadsInputs, Values], tuple[float, float] | None]:
    """formula/(Fourier ring - dent) - 1, give or take the acceptance figure.

    Both from the Fourier ring, whose mean is Lamé's ring, so that a slip in Eq. 6 shows, and the
    dent by integration, so that one in its formula does.
    """

    def interval(q: LoadsInputs, v: Values) -> tuple[float, float] | None:
        reference = v[key] - (integrated_dent(q, DEPTH[less]) if less else 0.0)
        if abs(reference) < PART * v["load"]:
            return None
        added = integrated_dent(q, DEPTH["dent, wall"]) if formula == "Lamé + Hertz" else 0.0
        expected = v["mean"] + added
        ratio = expected / reference
        return ratio - 1 - SHARP * abs(ratio), ratio - 1 + SHARP * abs(ratio)

    return interval


def integrated_dent(q: LoadsInputs, share: float) -> float:
    """Shortening [m] of the axis below a patch down to `share` of the wall, plane stress."""
    a, depth = q.half_width, share * (q.r_o - q.r_i)
    p_0 = 2 * q.P / (np.pi * a)

    def strain(z: float) -> float:
        root = np.hypot(a, z)
        sigma_z = -p_0 * a / root
        sigma_x = -p_0 * ((a**2 + 2 * z**2) / (a * root) - 2 * z / a)
        return float(sigma_z - q.nu * sigma_x) / q.E

    return -float(quad(strain, 0.0, depth, points=(a,))[0])


def wall_errors(context: Context) -> list[float]:
    """Largest difference of u_r and u_theta at the nodes of both walls over u_r at the load."""
    q = context.inputs
    ring, found = formulas.race(q), []
    for result in context.fem:
        worst = 0.0
        for name, r in (("bore", q.r_i), ("rim", q.r_o)):
            theta, u_r, u_theta = result.arrays[f"{name} nodes"]
            exact = ring.at(r, theta)
            worst = max(worst, np.abs(u_r - exact.u_r).max(), np.abs(u_theta - exact.u_theta).max())
        found.append(float(worst) / context.analytic["load"])
    return found


def stress_errors(context: Context) -> list[float]:
    """Largest difference of the three stresses at `stations` over the largest hoop stress."""
    exact = formulas.race(context.inputs).at(*stations(context.inputs))
    wanted = np.array([exact.sigma_r, exact.sigma_theta, exact.tau])
    scale = np.abs(wanted).max()
    return [float(np.abs(r.arrays["stresses"] - wanted).max() / scale) for r in context.fem]


def size(errors: Callable[[Context], list[float]]) -> Callable[[Context], tuple[float, float, str]]:
    """The finest error, with its last change as its uncertainty."""

    def of(context: Context) -> tuple[float, float, str]:
        found = errors(context)
        return found[-1], abs(found[-1] - found[-2]), f"{found[-1]:.1e}"

    return of


def too_soft(context: Context) -> tuple[float, float, str]:
    """How far Eq. 6 exceeds what finite elements give at the load less the dent."""
    q, v = context.inputs, context.analytic
    h, series = context.series("load")
    u = numerical_uncertainty(grid_convergence(h, series, formal=EDGE, scale=series[-1]))
    reference = series[-1] - v["dent, wall"]
    if reference < PART * v["load"]:
        return 0.0, 0.0, "the dent leaves nothing to compare with"
    m = v["smeared"] / reference - 1
    U = (1 + m) * expanded(u) / reference
    return m, U, f"Eq. 6 is {m:+.1%} off at n = {q.n}"


def identity(
    name: str, key: str, symbol: str, unit: str, *, formal: float = AWAY, scale: str = "",
    analytic: str = "",
) -> Identity:  # fmt: skip
    return Identity(
        name=name, fem=key, analytic=analytic or key, symbol=symbol, unit=unit, formal=formal,
        scale=scale, demand=SHARP, demand_reason=ACCEPTED,
    )  # fmt: skip


def checks(wall: str, far: str, delta: str) -> Sequence[Check]:
    """The claims of a race loaded on `wall`, whose deflection the paper calls `delta`."""
    names = (
        ("load", f"{wall} displacement at a load", "δ(0)"),
        ("between", f"{wall} displacement between loads", "δ(π/n)"),
        ("far load", f"{far} displacement opposite a load", "u_r(0)"),
        ("far between", f"{far} displacement between loads", "u_r(π/n)"),
    )
    stresses = (
        ("hoop between", f"hoop stress between loads, {wall}"),
        ("far hoop load", f"hoop stress opposite a load, {far}"),
        ("far hoop between", f"hoop stress between loads, {far}"),
    )
    beside: tuple[tuple[str, str, str, str], ...] = (
        ("Eq. 6 at a load", "smeared", "load", ""),
        ("Eq. 6 at a load, dent to the wall's depth taken out", "smeared", "load", "dent, wall"),
        ("Eq. 6 at a load, dent to half the wall taken out", "smeared", "load", "dent, half wall"),
        ("Eq. 6 between loads", "smeared", "between", ""),
        ("Eq. 6 and Hertz's dent to the wall's depth, at a load", "Lamé + Hertz", "load", ""),
    )
    return (
        *(
            identity(name, key, symbol, "µm", scale="load", formal=EDGE if key == "load" else AWAY)
            for key, name, symbol in names
        ),
        identity(f"{wall} displacement, mean", "mean", delta, "µm", analytic="smeared"),
        identity("ripple over the mean", "ripple", "Δδ/δ", "1", formal=EDGE),
        *(
            identity(name, key, "σ_θ", "MPa", scale="stress scale", formal=2)
            for key, name in stresses
        ),
        identity("hoop force in the cut between loads", "hoop force", "N_θ", "N/mm"),
        identity("strain energy of the race", "strain energy", "U", "J/m", formal=EDGE),
        Deviation(name=f"displacements at every node of both walls within {SHARP:g}", symbol="e_u",
                  unit="1", size=size(wall_errors), accepted=SHARP, source=ACCEPTED,
                  whole="radial displacement at a load"),
        Deviation(name=f"stresses beyond one patch width within {SHARP:g}", symbol="e_σ",
                  unit="1", size=size(stress_errors), accepted=SHARP, source=ACCEPTED,
                  whole="largest stress there"),
        *(
            Smeared(name=name, symbol=delta, unit="µm", analytic=formula, fem=key, less=less,
                    formal=EDGE if key == "load" else AWAY, source=BY_FOURIER,
                    interval=predicted(formula, key, less))
            for name, formula, key, less in beside
        ),
        Accepted(name="the smeared race is too soft, the dent taken out", symbol="m", unit="1",
                 margin=too_soft, fitted=FITTED),
    )  # fmt: skip
