"""Computed pressures of the paper's crowns, for Figs. 12 to 14 and Table 2."""

import numpy as np

from analytic.sprag.peaks import Peaks
from analytic.sprag.readings import first_trough
from verify.cases.contact.roller.inputs import DESIGNS
from verify.cases.sprag.clutch.run_fem import run_fem
from verify.cases.sprag.crown.box_fem import MANY, SHARES, forces, largest
from verify.cases.sprag.crown.formulas import box, factorial, radius
from verify.cases.sprag.engagement.model import gap, in_slices, in_strips
from verify.cases.sprag.inputs import EngagementInputs
from verify.cases.sprag.peaks import Crown, peaks_fem, with_crown
from verify.core.figures import Array

FIG_12: tuple[Crown, Crown] = ((1, 0.7, 10e-6), (5, 0.7, 15e-6))  # called the best and the worst
FIG_13: tuple[Crown, Crown] = ((1, 0.4, 10e-6), (3, 0.4, 10e-6))
FIG_14: tuple[Crown, Crown] = ((1, 0.5, 8e-6), (5, 0.5, 15e-6))  # lowest at 10 and at 30 N m
EQ_21: Crown = (2.1507, 0.6763, 12.1e-6)
SWEPT = np.linspace(500.0, 8000.0, 31)  # N
STRIPS = 81  # strips of the second model of this sweep
COUNTS = (11, 21, 31, 41, 61, 81, 121, 161)  # slices, strips
RANDOM = 400  # crowns within Eq. 19
BAND = np.linspace(5.0, 45.0, 17)  # N m
ALONG = np.linspace(1.0, 5.0, 41)  # K_1


def paper_fem(q: EngagementInputs, few: Peaks) -> dict[str, Array]:
    """Arrays for Figs. 12 to 14 and Table 2, from the engagements `few` with 27 crowns."""
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
        **swept(q), **moments_fem(q), **counted(q, named),
        **over_torque(q, many, few, T),
    }  # fmt: skip


def swept(q: EngagementInputs) -> dict[str, Array]:
    """Largest pressures [Pa] of the printed crowns at several forces, by slices and by strips."""
    R = np.array([radius(q, float(N)) for N in SWEPT])
    by_slices, by_strips = [], []
    for crown in DESIGNS:
        own = with_crown(q, crown)
        fine = gap(own.model_copy(update={"slices": STRIPS}))
        by_slices.append(in_slices(q, gap(own), R, SWEPT).peak_pressure.max(axis=-1))
        by_strips.append(in_strips(q, fine, R, SWEPT).peak)
    return {
        "swept": SWEPT, "swept, slices": np.array(by_slices), "swept, strips": np.array(by_strips)
    }  # fmt: skip


def moments_fem(q: EngagementInputs) -> dict[str, Array]:
    """Pressures [Pa] of the crowns of Fig. 13 at the first force peak and the next minimum."""
    found = []
    for crown in FIG_13:
        run = run_fem(with_crown(q, crown))
        forces = run.engagement.N_max, first_trough(run.engagement)
        found.append([run.one.pressed(N)[0].peak_pressure for N in forces])
    return {"Fig. 13": np.array(found)}


def counted(q: EngagementInputs, named: Peaks) -> dict[str, Array]:
    """Largest pressures [Pa], (3 crowns, counts), for growing numbers of slices and of strips.

    They apply at the first force peak under 25 N m; without a crown, also under 40 N m by slices.
    """
    at_25, at_40 = float(named.N_max[0, 1]), float(named.N_max[0, 3])
    R_25 = radius(q, at_25)
    found: dict[str, list[list[float]]] = {"slices": [], "strips": [], "40": []}
    for crown in (None, EQ_21, FIG_12[1]):
        z = [gap(with_crown(q, crown).model_copy(update={"slices": n})) for n in COUNTS]
        found["slices"].append([float(in_slices(q, x, R_25, at_25).peak_pressure.max()) for x in z])
        found["strips"].append([float(in_strips(q, x, R_25, at_25).peak) for x in z])
        if crown is None:
            R_40 = radius(q, at_40)
            found["40"].append([float(in_slices(q, x, R_40, at_40).peak_pressure.max()) for x in z])
    return {"counts": np.array(COUNTS, dtype=np.float64), "counted N": np.array([at_25, at_40])} | {
        f"counted, {name}": np.array(p) for name, p in found.items()
    }


def over_torque(q: EngagementInputs, many: Array, few: Peaks, T: Array) -> dict[str, Array]:
    """Arrays for Fig. 14: p_max [Pa] over the torque, of `many` crowns and of the printed crowns.

    Lowest and highest p_max of `many` are given, and the K_1 that has the lowest p_max with K_2
    and z_m of the optimal crown of Fig. 12. N_max/T is nearly constant; a parabola interpolates
    between the computed torques.
    """
    deeper = np.array([(K_1, FIG_12[0][1], FIG_12[0][2]) for K_1 in ALONG])
    crowns = np.concatenate([many, np.array(DESIGNS), deeper])
    slope = np.polynomial.polynomial.polyfit(T, (forces(q, few, crowns) / T).T, 2)
    N = np.polynomial.polynomial.polyval(BAND, slope) * BAND
    p = largest(q, crowns, N)
    own, named, along = np.split(p, [len(many), len(many) + len(DESIGNS)])
    return {
        "band T": BAND, "band low": own.min(axis=0), "band high": own.max(axis=0),
        "band K_1": ALONG[along.argmin(axis=0)], "band N": N.mean(axis=0), "band p": named,
    }  # fmt: skip
