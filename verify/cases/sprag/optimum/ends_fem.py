"""End pressures of the optimal crown by slices, strips and a half-space, under equal forces.

Slices do not model the pressure peak at the end of a sprag. On a half-space, the pressure of a
contact that reaches the end has no finite maximum. The crown for manufacture is therefore searched
among crowns with unloaded ends.
"""

import numpy as np

from analytic.sprag.best_crown import Answer, answers, infilled
from analytic.sprag.closure import wedged
from analytic.sprag.peaks import Peaks
from analytic.surrogate.infill import NoAgreementError
from verify.cases.sprag.clutch.drawn_fem import crowned
from verify.cases.sprag.clutch.model import built
from verify.cases.sprag.engagement.model import in_slices, in_strips
from verify.cases.sprag.optimum.inputs import OptimumInputs
from verify.cases.sprag.peaks import STRIPS, one_fem, peaks_fem, with_crown
from verify.core.figures import Array

STRIPPED = (41, 81, 161)
SLICED = (21, 41, 81, 161)
CELLS = ((40, 384), (48, 512), (64, 768))  # cells across and along the contact, narrow at the ends


def ends_fem(q: OptimumInputs, found: dict[str, Array]) -> dict[str, Array]:
    """Contact pressures of four crowns: optimal by slices, given, optimal by strips, no crown."""
    crowns = {"best": found["best"], "at hand": np.array([q.K_1, q.K_2, q.z_m])}
    own = freed_fem(q, found["X"], found["N_max"][:, 0])
    if "free" in own:
        crowns["free"] = own["free"]
    for name, crown in crowns.items():
        own |= {f"{name}: {key}": value for key, value in pressed_fem(q, crown).items()}
    N, p = one_fem(with_crown(q, None), q.torques)
    flat = sliced(q, None, float(N[0]), float(own["best: R"]))
    return own | {"none: N_max": N, "none: pressures": p, "none: sliced": flat}


def freed_fem(q: OptimumInputs, x: Array, N: Array) -> dict[str, Array]:
    """Optimal crown with unloaded ends by strips, and the values at the designs added by infill.

    Kriging, infill and search are those used for slices. N (n,) are the known forces [N] of the
    crowns x (n, 3). The result is empty if surrogate and strips give different optima.
    Raises an error if an engagement or a contact has no solution.
    """
    one = built(q)
    R = one.radii(wedged(one.clutch, float(np.median(N))))[0]  # nearly independent of the crown
    gaps = np.array([crowned(with_crown(q, crown), STRIPS) for crown in x])
    by = in_strips(q, gaps, R, N)
    known = answers(Peaks(x, np.array([q.T]), N[:, None], by.pressure[:, None], "strips"))

    def true(crown: Array) -> Answer:
        return answers(peaks_fem(q, crown[None], [q.T], by="strips"))[0]

    try:
        last = infilled(q.box, x, known, true)
    except NoAgreementError:
        return {}
    return {"free": last.x, "free infill": np.array([[r.predicted, r.true] for r in last.history])}


def pressed_fem(q: OptimumInputs, crown: Array) -> dict[str, Array]:
    """Largest force of a crown, and pressures under this force by slices, strips and cells.

    The numbers of strips and cells are refined.
    """
    from analytic.contact.half_space_roller import press_roller

    mine = with_crown(q, crown)
    N, p = one_fem(mine, q.torques)
    one, load = built(mine), float(N[0])
    R, E_star = one.radii(wedged(one.clutch, load))[0], float(one.parts.E_star)
    found = {"crown": crown, "N_max": N, "pressures": p, "R": R}
    for n in STRIPPED:
        by = in_strips(q, crowned(mine, n), R, load)
        found |= {f"strips {n}": by.pressure, f"strips mid {n}": by.mid}
    width = None  # width of the patch, common to all cells
    for across, along in CELLS:
        solid = press_roller(crowned(mine, along), length=q.l, R=R, E_star=E_star, load=load,
                             cells=(across, along), width=width)  # fmt: skip
        width = across * solid.contact.cell[0]
        found |= {f"cells {along}": solid.centre_pressure, f"cells mid {along}": solid.mid_pressure}
    found["sliced"] = sliced(q, crown, load, R)
    return {name: np.asarray(value, dtype=np.float64) for name, value in found.items()}


def sliced(q: OptimumInputs, crown: Array | None, N: float, R: float) -> Array:
    """Largest pressures [Pa] under N [N] for each number of slices in SLICED."""
    mine = with_crown(q, crown)
    contacts = [in_slices(q, crowned(mine, n), R, N) for n in SLICED]
    return np.array([contact.peak_pressure.max() for contact in contacts])
