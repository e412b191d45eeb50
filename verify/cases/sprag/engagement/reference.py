"""Runge-Kutta steps of an engagement with refined time steps, and LSODA for comparison.

Each level has half the time step of the level before. Compiled code is imported inside functions.
"""

import math
from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from analytic.sprag import oscillation
from analytic.sprag.balance import sampled
from analytic.sprag.closure import wedged
from analytic.sprag.history import Phase
from analytic.sprag.motion import Motion, Speeds, Torque
from analytic.sprag.oscillation import Oscillation
from analytic.sprag.race_spring import RaceSpring
from analytic.sprag.readings import asked, highest, later_peak, missing, put_in
from analytic.sprag.table import INTERVALS
from verify.cases.contact.roller.inputs import DESIGNS
from verify.cases.sprag.engagement.formulas import analytic, with_torque
from verify.cases.sprag.engagement.model import motion, wedge
from verify.cases.sprag.inputs import EngagementInputs
from verify.core.case import FemResult
from verify.core.figures import Array

if TYPE_CHECKING:
    from analytic.sprag.events import Events
    from analytic.sprag.history import Engagement

LEVELS = (1, 2, 4)  # steps in a step of the inputs
ORDER = (4.0, 2.0, 1.0, 0.5)  # step over the step of the inputs, for the fit of the order
FINEST = 16  # steps in a step of the inputs, as reference for the order
FIRST = 1.3  # end time of the partner over the time of the first peak
RTOL = 1e-8
COARSER = 1500  # intervals of the table by which the error of its cubics is estimated
LEAST = 1e-7  # relative: half the effect of a table of 500 intervals; 4000 change 6e-9
SPLINES = 1e-6  # standard, relative: LSODA's force is another spline through the states
CROSSED = 1e-6  # relative to a frequency: crossings by linear interpolation of samples
STUCK = 0.05  # uncertainty of the time of sticking, in steps
SHOWN = 601  # samples that are stored
ACROSS = 240  # moments in figures of pressure


def solve(q: EngagementInputs, level: int) -> FemResult:
    """Results of a level by Runge-Kutta steps; on the finest level, also results by LSODA."""
    dt = q.dt / level
    main, rigid, more = (engaged_fem(*which, dt) for which in engagements(q))
    rest = about_rest(q)
    free, strut = rest.undamped(dt, q.t_end), rest.strut(dt)
    sliced = q.model_copy(update={"slices": max(round(q.slices * level / LEVELS[-1]), 5)})
    values = {
        "N_1 strut": strut.first_peak[1], "W_1 strut": put_in(strut),
        "N_max": main.N_max, "t_max": main.peak[0], "N_max rigid": rigid.N_max,
        "N_max more": more.N_max, "ratio": more.N_max / main.N_max,
        "rigid": rigid.N_max / main.N_max, "first peak": main.first_peak[1],
        "N_undamped": free.first_peak[1], "N": rest.settled(level), "f": rest.frequency(level),
        "missing": missing(main), "missing undamped": missing(free),
        "N_max sliced": engaged_fem(*engagements(sliced)[0], dt).N_max,
        "later peak": later_peak(main), "asked": asked(main), "D_V": main.D_V,
        "slides": float((main.phases == Phase.SLIP).any(axis=1).mean()),
    }  # fmt: skip
    arrays = history(main, "") | history(free, "undamped ") | history(rigid, "rigid ")
    if level == LEVELS[-1]:
        values |= partners_fem(q)
        arrays |= compared_fem(q, main) | {"order": order_fem(q)} | designs_fem(q)
        arrays |= pressed_fem(q)
    return FemResult(h=1 / level, values=values, u_it=tables_fem(q, main), arrays=arrays)


def tables_fem(q: EngagementInputs, main: "Engagement") -> dict[str, float]:
    """Uncertainties, by name, of values that depend on the interpolated table of the force."""
    other = engaged_fem(q, wedge(q), main.dt, intervals=COARSER)
    share = max(abs(other.N_max / main.N_max - 1), LEAST)
    v = analytic(q)
    parabola = q.dt * (2 * math.pi * v["f"] * q.dt) ** 2  # through samples: its next order
    slid = (main.phases[main.t < main.peak[0]] == Phase.SLIP).any()
    time = max(abs(other.peak[0] - main.peak[0]), parabola, STUCK * q.dt if slid else 0.0)
    keys = ("N_max", "N_max rigid", "N_max more", "ratio", "rigid", "N_undamped", "N", "f", "asked")
    beside = {"asked": "mu_asked", "N_max rigid": "N_max rigid", "N_max more": "N_max more"}
    found = {key: share * v[beside.get(key, key)] for key in keys} | {"t_max": time}
    return found | {"f": max(found["f"], CROSSED * v["f"])}


def engagements(q: EngagementInputs) -> tuple[tuple[EngagementInputs, RaceSpring], ...]:
    """Inputs and spring of three engagements: as given, with rigid races, and under 1.6 T."""
    more = with_torque(q)
    return (q, wedge(q)), (q, wedge(q, rigid=True)), (more, wedge(more))


def torque(q: EngagementInputs) -> Torque:
    return Torque.step(q.T, t_ramp=q.t_ramp)


def engaged_fem(
    q: EngagementInputs, w: RaceSpring, dt: float, moves: Motion | None = None,
    course: Torque | None = None, **how: Any,
) -> "Engagement":  # fmt: skip
    """Engagement of `q` with the spring `w`, computed by Runge-Kutta steps of dt [s]."""
    from analytic.sprag.transient import engage

    how = {"duration": q.t_end, "D_V": q.D_V, "speeds": Speeds(inner=q.w_i)} | how
    table = w.table(how.pop("intervals", INTERVALS))
    return engage(table, moves or motion(q), course or torque(q), dt=dt, **how)


def held(q: EngagementInputs, **changes: float) -> Motion:
    """Inertias, springs, damping and friction of the clutch with the outer race fixed."""
    return oscillation.held(motion(q), **changes)


def about_rest(q: EngagementInputs) -> Oscillation:
    """Oscillation of the clutch about its state at rest, with the outer race fixed."""
    v = analytic(q)
    return Oscillation(wedge(q), motion(q), T=q.T, f=v["f"], k=v["k"])


def history(found: "Engagement", name: str) -> dict[str, Array]:
    """Arrays of force, sliding and energies at SHOWN times; `name` is the prefix of their keys."""
    return {name + key: column for key, column in sampled(found, SHOWN).items()}


def partner_fem(
    q: EngagementInputs,
    w: RaceSpring,
    duration: float,
    *,
    unlimited: bool = False,
    rtol: float = RTOL,
    every: int = 1,
) -> "Events":
    """Engagement by LSODA with events; the force is interpolated from each `every`-th state."""
    from analytic.sprag.events import engage_by_events

    return engage_by_events(
        wedged(w.clutch, w.states.N[::every]), q.z, motion(q), torque(q), duration=duration,
        speeds=Speeds(inner=q.w_i), unlimited=unlimited, rtol=rtol,
    )  # fmt: skip


def partners_fem(q: EngagementInputs) -> Mapping[str, float]:
    """Largest N [N] of each engagement by LSODA, and the time [s] at which it occurs, by name.

    The integration ends after the first peak. The "residual" is the relative change of these
    values with half of the tabulated states and a hundredfold tolerance.
    """
    values: dict[str, float] = {}
    until = min(FIRST * analytic(q)["t_max"], q.t_end)
    for name, (p, w) in zip(("", " rigid", " more"), engagements(q), strict=True):
        top = highest(partner_fem(p, w, until))
        values |= {f"LSODA N_max{name}": top[1], f"LSODA t_max{name}": top[0]}
    rough = highest(partner_fem(q, wedge(q), until, every=2, rtol=100 * RTOL))
    first = values["LSODA t_max"], values["LSODA N_max"]
    return values | {
        "LSODA ratio": values["LSODA N_max more"] / values["LSODA N_max"],
        "LSODA rigid": values["LSODA N_max rigid"] / values["LSODA N_max"],
        "LSODA residual": max(
            SPLINES, *(abs(a / b - 1) for a, b in zip(rough, first, strict=True))
        ),
    }


def compared_fem(q: EngagementInputs, main: "Engagement") -> dict[str, Array]:
    """Arrays over time [s]: N [N] by LSODA with rolling contacts, N [N] by Runge-Kutta steps."""
    found = partner_fem(q, wedge(q), q.t_end, unlimited=True, rtol=100 * RTOL)
    every = max(len(found.t) // SHOWN, 1)
    t = found.t[::every]
    return {
        "rolling": np.array([found.N_max]), "LSODA t": t, "LSODA N": found.N[::every],
        "LSODA beside": np.interp(t, main.t, main.N),
    }  # fmt: skip


def order_fem(q: EngagementInputs) -> Array:
    """Largest error of N over time, relative to the peak, for each time step of ORDER."""
    fine = engaged_fem(q, wedge(q), q.dt / FINEST)
    errors = []
    for many in ORDER:
        found = engaged_fem(q, wedge(q), q.dt * many)
        beside = fine.N[:: round(FINEST * many)]
        n = min(len(beside), len(found.N))
        errors.append(np.abs(found.N[:n] - beside[:n]).max() / fine.N_max)
    return np.array(errors)


def designs_fem(q: EngagementInputs) -> dict[str, Array]:
    """Largest N [N] without a crown, with each printed crown, with two other sprag centroids."""
    crowns = [q.model_copy(update={"z_m": 0.0})] + [
        q.model_copy(update={"K_1": K_1, "K_2": K_2, "z_m": z_m}) for K_1, K_2, z_m in DESIGNS
    ]
    found = [engaged_fem(p, wedge(p), q.dt).N_max for p in crowns]
    elsewhere = []
    for c in ((0.0, 0.0), (q.R_i * np.sin(float(q.sprag.beta_0)), 0.0)):
        w = wedge(q)
        moved = replace(w, clutch=replace(w.clutch, c_x=c[0], c_y=c[1]))
        elsewhere.append(engaged_fem(q, moved, q.dt).N_max)
    return {"crowns": np.array(found), "centroids": np.array(elsewhere)} | balanced_fem(q)


def balanced_fem(q: EngagementInputs) -> dict[str, Array]:
    """Largest N [N] with damping, and first peak [N] without damping.

    Both take the ratio N_e/N_i from statics.
    """
    from analytic.sprag.transient import engage

    damped = engage(
        oscillation.strut_table(wedge(q)), motion(q), torque(q), duration=q.t_end, dt=q.dt,
        speeds=Speeds(inner=q.w_i),
    )  # fmt: skip
    free = about_rest(q).strut(q.dt)
    return {"balanced": np.array([damped.N_max, free.first_peak[1]])}


def drawn(q: EngagementInputs) -> dict[str, EngagementInputs]:
    """Inputs whose pressures are drawn, by prefix of the names.

    These are inputs with the crowns of Fig. 13 if `q` are the default inputs, otherwise only `q`.
    """
    if q != type(q)():
        return {"": q}
    return {
        f"{part} ": q.model_copy(update={"K_1": K_1, "K_2": 0.4, "z_m": 10e-6})
        for part, K_1 in (("a", 1.0), ("b", 3.0))
    }


def pressed_fem(q: EngagementInputs) -> dict[str, Array]:
    """N [N] at equidistant times [s] for each crown whose pressures are drawn."""
    found: dict[str, Array] = {}
    for name, p in drawn(q).items():
        run = engaged_fem(p, wedge(p), p.dt)
        every = max(len(run.t) // ACROSS, 1)
        found |= {f"{name}drawn N": run.N[::every], "drawn t": run.t[::every]}
    return found
