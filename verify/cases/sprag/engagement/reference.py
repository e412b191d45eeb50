"""The compiled Runge-Kutta steps of an engagement, refined like a mesh, and their LSODA partner.

A level halves the time step that the inputs name. What is compiled is imported inside functions.
"""

import math
from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from analytic.sprag.balance import balance
from analytic.sprag.closure import wedged
from analytic.sprag.history import Phase
from analytic.sprag.motion import Motion, Speeds, Torque
from analytic.sprag.race_spring import RaceSpring
from analytic.sprag.readings import asked, highest, later_peak, missing, put_in
from analytic.sprag.table import INTERVALS, Table, tabulated
from verify.cases.contact.roller.inputs import DESIGNS
from verify.cases.sprag.engagement.formulas import analytic, with_torque
from verify.cases.sprag.engagement.model import motion, wedge
from verify.cases.sprag.inputs import EngagementInputs
from verify.core.case import FemResult
from verify.core.figures import Array

if TYPE_CHECKING:
    from analytic.sprag.events import Events
    from analytic.sprag.history import Engagement

LEVELS = (1, 2, 4)  # steps in the one of the inputs
ORDER = (4.0, 2.0, 1.0, 0.5)  # steps of the inputs in one, of which the order is told
FINEST = 16  # steps in the one of the inputs that those are measured by
HELD = 1e6  # times its inertia, which holds the outer race
PACE = 200  # steps in a period, where the period rules
DAMPED = 0.3  # of critical damping
RAMP, REST = 4, 12  # periods in which the torque rises, and in which motion dies
SWUNG = 1.5  # periods about rest, past the first peak without damping
SLOW, COUNTED = 8, 12  # periods of the ramp and of the free oscillation
STEP = 0.01  # of the torque, which starts that
FIRST = 1.3  # of the time of the first peak, which the partner is followed to
RTOL = 1e-8
COARSER = 1500  # intervals of the table that says how far its own cubics are off
LEAST = 1e-7  # of a value: half of what a table of 500 intervals changes, 4000 change 6e-9
SPLINES = 1e-6  # of a value, standard: LSODA's force is a spline of its own through the states
CROSSED = 1e-6  # of a frequency: crossings are told on straight lines between samples
STUCK = 0.05  # of a step, within which the time of sticking is known
SHOWN = 601  # samples that are kept
ACROSS = 240  # moments in figures of pressure
ENERGIES = ("torque", "blades", "kinetic", "elastic", "support", "damping", "friction", "missing")


def solve(q: EngagementInputs, level: int) -> FemResult:
    """One level: the engagements in steps, statics and oscillation; on the finest LSODA."""
    dt = q.dt / level
    main, rigid, more = (engaged_fem(*which, dt) for which in engagements(q))
    free = undamped_fem(q, dt)
    tremor = tremor_fem(q, level)
    sliced = q.model_copy(update={"slices": max(round(q.slices * level / LEVELS[-1]), 5)})
    strut = strut_fem(q, dt)
    values = {
        "N_1 strut": strut.first_peak[1], "W_1 strut": put_in(strut),
        "N_max": main.N_max, "t_max": main.peak[0], "N_max rigid": rigid.N_max,
        "N_max more": more.N_max, "ratio": more.N_max / main.N_max,
        "rigid": rigid.N_max / main.N_max, "first peak": main.first_peak[1],
        "N_undamped": free.first_peak[1], "N": settled_fem(q, level), "f": tremor,
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
    """What another table of the force leaves uncertain, over all that hangs on the force."""
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
    """The engagement, that with rigid races and that under more torque."""
    more = with_torque(q)
    return (q, wedge(q)), (q, wedge(q, rigid=True)), (more, wedge(more))


def torque(q: EngagementInputs) -> Torque:
    return Torque.step(q.T, t_ramp=q.t_ramp)


def engaged_fem(
    q: EngagementInputs, w: RaceSpring, dt: float, moves: Motion | None = None,
    course: Torque | None = None, **how: Any,
) -> "Engagement":  # fmt: skip
    """The engagement of `q` on the clutch `w` in steps of dt [s]."""
    from analytic.sprag.transient import engage

    how = {"duration": q.t_end, "D_V": q.D_V, "speeds": Speeds(inner=q.w_i)} | how
    table = w.table(how.pop("intervals", INTERVALS))
    return engage(table, moves or motion(q), course or torque(q), dt=dt, **how)


def held(q: EngagementInputs, **changes: float) -> Motion:
    """The same motion with the outer race held."""
    return replace(motion(q), I_be=HELD * q.I_be, **changes)


def undamped_fem(q: EngagementInputs, dt: float) -> "Engagement":
    """Step of the torque without damping, from rest."""
    until = max(q.t_end, SWUNG / analytic(q)["f"])
    return engaged_fem(
        q, wedge(q), dt, held(q, C_rl=0.0), Torque.step(q.T), duration=until, speeds=None, D_V=None
    )  # fmt: skip


def strut_fem(q: EngagementInputs, dt: float) -> "Engagement":
    """The same, to behind its first peak, with N_e/N_i of a strut in place of 1."""
    from analytic.sprag.transient import engage

    until = SWUNG / analytic(q)["f"]
    return engage(strut_table(q), held(q, C_rl=0.0), Torque.step(q.T), duration=until, dt=dt)


def strut_table(q: EngagementInputs) -> Table:
    w = wedge(q)
    return tabulated(w.clutch, N_end=w.end, balanced=True)


def settled_fem(q: EngagementInputs, level: int) -> float:
    """N [N] at rest: after a slow rise, with damping."""
    v = analytic(q)
    omega = 2 * math.pi * v["f"]
    damped = held(q, C_rl=2 * DAMPED * v["k"] / omega)
    course = Torque.step(q.T, t_ramp=RAMP / v["f"])
    how = {"duration": (RAMP + REST) / v["f"], "speeds": None, "D_V": None}
    return float(engaged_fem(q, wedge(q), 1 / (PACE * level * v["f"]), damped, course, **how).N[-1])


def tremor_fem(q: EngagementInputs, level: int) -> float:
    """Frequency [Hz] of a small free oscillation about the state at rest."""
    period = 1 / analytic(q)["f"]
    dt = period / (PACE * level)
    ramp = SLOW * period
    course = Torque(times=np.array([0.0, ramp, ramp + dt]), values=q.T * np.array([0, 1 - STEP, 1]))
    found = engaged_fem(
        q, wedge(q), dt, held(q, C_rl=0.0), course, duration=ramp + COUNTED * period, speeds=None,
        D_V=None,
    )  # fmt: skip
    late = found.t > ramp + dt
    N, t = found.N[late] - found.N[late].mean(), found.t[late]
    up = np.flatnonzero((N[:-1] < 0) & (N[1:] >= 0))
    crossings = t[up] - N[up] * dt / (N[up + 1] - N[up])
    return float(1 / np.diff(crossings).mean())


def history(found: "Engagement", name: str) -> dict[str, Array]:
    """Force, sliding and energies, thinned."""
    every = max(len(found.t) // SHOWN, 1)
    kept = balance(found)
    columns = {"t": found.t, "N": found.N, "T_i": found.T_i, "v_i": found.v_i, "alpha": found.alpha,
               "theta_i": found.theta_i, "theta_e": found.theta_e}  # fmt: skip
    columns |= {key: getattr(kept, key) for key in ENERGIES}
    return {name + key: np.asarray(column[::every]) for key, column in columns.items()}


def partner_fem(
    q: EngagementInputs,
    w: RaceSpring,
    duration: float,
    *,
    unlimited: bool = False,
    rtol: float = RTOL,
    every: int = 1,
) -> "Events":
    """The same engagement by events and LSODA, the force from every so many of the states."""
    from analytic.sprag.events import engage_by_events

    return engage_by_events(
        wedged(w.clutch, w.states.N[::every]), q.z, motion(q), torque(q), duration=duration,
        speeds=Speeds(inner=q.w_i), unlimited=unlimited, rtol=rtol,
    )  # fmt: skip


def partners_fem(q: EngagementInputs) -> Mapping[str, float]:
    """Largest N of each engagement by LSODA and its time, to a little past the first peak.

    The residual is what half the states and a hundredfold tolerance change.
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
    """N of the whole engagement by LSODA, contacts that always roll, and of the steps then."""
    found = partner_fem(q, wedge(q), q.t_end, unlimited=True, rtol=100 * RTOL)
    every = max(len(found.t) // SHOWN, 1)
    t = found.t[::every]
    return {
        "rolling": np.array([found.N_max]), "LSODA t": t, "LSODA N": found.N[::every],
        "LSODA beside": np.interp(t, main.t, main.N),
    }  # fmt: skip


def order_fem(q: EngagementInputs) -> Array:
    """Largest error of N over the engagement over its peak for each step of ORDER."""
    fine = engaged_fem(q, wedge(q), q.dt / FINEST)
    errors = []
    for many in ORDER:
        found = engaged_fem(q, wedge(q), q.dt * many)
        beside = fine.N[:: round(FINEST * many)]
        n = min(len(beside), len(found.N))
        errors.append(np.abs(found.N[:n] - beside[:n]).max() / fine.N_max)
    return np.array(errors)


def designs_fem(q: EngagementInputs) -> dict[str, Array]:
    """Largest N [N] without a crown and with each of the paper's; and with other centroids."""
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
    """Largest N [N], and first peak without damping, with N_e/N_i of a strut in place of 1."""
    from analytic.sprag.transient import engage

    speeds = Speeds(inner=q.w_i)
    damped = engage(
        strut_table(q), motion(q), torque(q), duration=q.t_end, dt=q.dt, speeds=speeds
    )  # fmt: skip
    free = strut_fem(q, q.dt)
    return {"balanced": np.array([damped.N_max, free.first_peak[1]])}


def drawn(q: EngagementInputs) -> dict[str, EngagementInputs]:
    """Whose pressures are drawn: the crowns of Fig. 13 for the paper's clutch, else one's own."""
    if q != type(q)():
        return {"": q}
    return {
        f"{part} ": q.model_copy(update={"K_1": K_1, "K_2": 0.4, "z_m": 10e-6})
        for part, K_1 in (("a", 1.0), ("b", 3.0))
    }


def pressed_fem(q: EngagementInputs) -> dict[str, Array]:
    """N [N] at even times [s] for each design whose pressures are drawn."""
    found: dict[str, Array] = {}
    for name, p in drawn(q).items():
        run = engaged_fem(p, wedge(p), p.dt)
        every = max(len(run.t) // ACROSS, 1)
        found |= {f"{name}drawn N": run.N[::every], "drawn t": run.t[::every]}
    return found
