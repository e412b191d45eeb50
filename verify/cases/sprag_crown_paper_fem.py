"""What is measured of the paper's crowns: Figs. 12 to 15 and Table 2's level."""

import numpy as np

from analytic.contact import slices, strips
from verify.cases.contact_roller_inputs import DESIGNS
from verify.cases.sprag_clutch_run_fem import run_fem
from verify.cases.sprag_crown_box_fem import MANY, SHARES, forces, largest
from verify.cases.sprag_crown_formulas import box, factorial, radius
from verify.cases.sprag_engagement_model import gap, parts
from verify.cases.sprag_inputs import EngagementInputs
from verify.cases.sprag_peaks import Crown, Peaks, peaks_fem, with_crown
from verify.shown import Array

FIG_12: tuple[Crown, Crown] = ((1, 0.7, 10e-6), (5, 0.7, 15e-6))  # called the best and the worst
FIG_13: tuple[Crown, Crown] = ((1, 0.4, 10e-6), (3, 0.4, 10e-6))
FIG_14: tuple[Crown, Crown] = ((1, 0.5, 8e-6), (5, 0.5, 15e-6))  # lowest at 10 and at 30 N m
EQ_21: Crown = (2.1507, 0.6763, 12.1e-6)
SWEPT = np.linspace(500.0, 8000.0, 31)  # N
STRIPS = 81  # of the other side of that sweep
COUNTS = (11, 21, 31, 41, 61, 81, 121, 161)  # slices, strips
RANDOM = 400  # crowns within Eq. 19
BAND = np.linspace(5.0, 45.0, 17)  # N m
FINE = (25, 13)  # crowns along K_1 and the other parameter of Fig. 15


def paper_fem(q: EngagementInputs, few: Peaks) -> dict[str, Array]:
    """All that Figs. 12 to 15 and Table 2 need; `few` are 27 crowns under the shares of T."""
    T = q.T * np.array(SHARES)
    named = peaks_fem(q, np.array(DESIGNS), T)
    many = factorial(q, MANY)
    N = forces(q, few, many)
    low, high = box(q)
    random = low + (high - low) * np.random.default_rng(1).random((RANDOM, 3))
    return {
        "torques": T, "named p": named.largest, "named N": named.N_max,
        "many p": largest(q, many, N), "many N": N,
        "random p": largest(q, random, forces(q, few, random)),
        **swept(q), **moments(q), **counted(q, named), **maps(q, few.of(1)),
        **over_torque(q, many, few, T),
    }  # fmt: skip


def swept(q: EngagementInputs) -> dict[str, Array]:
    """Largest pressures [Pa] of the printed crowns over the force, by slices and by strips."""
    given = {"length": q.l, "E_star": float(parts(q).E_star), "load": SWEPT}
    R = np.array([radius(q, float(N)) for N in SWEPT])
    found: dict[str, list[Array]] = {"swept, slices": [], "swept, strips": []}
    for crown in DESIGNS:
        own = with_crown(q, crown)
        fine = gap(own.model_copy(update={"slices": STRIPS}))
        found["swept, slices"].append(
            slices.press(gap(own), R=R, **given).peak_pressure.max(axis=-1)
        )
        found["swept, strips"].append(strips.press(fine, R=R, **given).peak)
    return {"swept": SWEPT} | {name: np.array(p) for name, p in found.items()}


def moments(q: EngagementInputs) -> dict[str, Array]:
    """Pressures [Pa] of Fig. 13's crowns at the first peak and at the trough behind it."""
    found = []
    for crown in FIG_13:
        run = run_fem(with_crown(q, crown))
        N, first = run.engagement.N, run.engagement.first_peak[0]
        behind = N[round(first / run.engagement.dt) :]
        trough = float(behind[: int(np.argmax(np.diff(behind) > 0)) + 1].min())
        found.append([run.one.pressed(x)[0].peak_pressure for x in (run.engagement.N_max, trough)])
    return {"Fig. 13": np.array(found)}


def counted(q: EngagementInputs, named: Peaks) -> dict[str, Array]:
    """Largest pressures [Pa] by ever more slices and strips, (3 crowns, counts), first peak.

    At 25 N m; without a crown by slices at 40 N m too.
    """
    at_25, at_40 = float(named.N_max[0, 1]), float(named.N_max[0, 3])
    found: dict[str, list[list[float]]] = {"slices": [], "strips": [], "40": []}
    for crown in (None, EQ_21, FIG_12[1]):
        z = [gap(with_crown(q, crown).model_copy(update={"slices": n})) for n in COUNTS]
        found["slices"].append([_by_slices(q, x, at_25) for x in z])
        found["strips"].append([_by_strips(q, x, at_25) for x in z])
        if crown is None:
            found["40"].append([_by_slices(q, x, at_40) for x in z])
    return {"counts": np.array(COUNTS, dtype=np.float64), "counted N": np.array([at_25, at_40])} | {
        f"counted, {name}": np.array(p) for name, p in found.items()
    }


def _by_slices(q: EngagementInputs, z: Array, N: float) -> float:
    found = slices.press(z, length=q.l, R=radius(q, N), E_star=float(parts(q).E_star), load=N)
    return float(found.peak_pressure.max())


def _by_strips(q: EngagementInputs, z: Array, N: float) -> float:
    E_star = float(parts(q).E_star)
    return float(strips.press(z, length=q.l, R=radius(q, N), E_star=E_star, load=N).peak)


def over_torque(q: EngagementInputs, many: Array, few: Peaks, T: Array) -> dict[str, Array]:
    """Fig. 14: p_max [Pa] over the torque, least and largest of `many`, and of the printed crowns.

    N_max/T is nearly constant: a parabola through its values at the torques engaged.
    """
    crowns = np.concatenate([many, np.array(DESIGNS)])
    slope = np.polynomial.polynomial.polyfit(T, (forces(q, few, crowns) / T).T, 2)
    N = np.polynomial.polynomial.polyval(BAND, slope) * BAND
    p = largest(q, crowns, N)
    own = p[: len(many)]
    return {
        "band T": BAND, "band low": own.min(axis=0), "band high": own.max(axis=0),
        "band crown": many[own.argmin(axis=0)], "band N": N.mean(axis=0),
        "band p": p[len(many) :],
    }  # fmt: skip


def maps(q: EngagementInputs, at_25: Peaks) -> dict[str, Array]:
    """Fig. 15 at 25 N m: p_max [Pa] over K_1 and K_2 at z_m = 10 µm, and z_m at K_2 = 0.5."""
    low, high = box(q)
    K_1 = np.linspace(low[0], high[0], FINE[0])
    K_2, z_m = (np.linspace(low[k], high[k], FINE[1]) for k in (1, 2))
    a = np.array([(x, y, 10e-6) for y in K_2 for x in K_1])
    b = np.array([(x, 0.5, y) for y in z_m for x in K_1])
    over_a, over_b = (largest(q, x, forces(q, at_25, x)).reshape(FINE[1], FINE[0]) for x in (a, b))
    return {"K_1": K_1, "K_2": K_2, "z_m": z_m, "Fig. 15a": over_a, "Fig. 15b": over_b}
