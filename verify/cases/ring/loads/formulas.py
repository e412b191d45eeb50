"""The formulas of a race under n sprags: Hertz's patch, Fourier ring, smeared ring, dent."""

from typing import Any

import numpy as np

from analytic.contact import hertz_line, hertz_line_approach
from analytic.ring import loaded_race, smeared
from analytic.ring.loaded_race import LoadedRace
from verify.cases.ring.loads.inputs import LoadsInputs
from verify.core.case import Values

POINTS = 24  # of the rule over the patch for its work


def hertz(q: LoadsInputs, P: float | None = None) -> tuple[float, float]:
    """Half-width [m] and peak pressure [Pa] of a sprag on the race under P per length."""
    R = hertz_line.relative_radius(R_1=q.R, R_2=-q.r_i if q.loaded == "bore" else q.r_o)
    E_star = hertz_line.contact_modulus(
        E_1=q.E, nu_1=q.nu, E_2=q.E, nu_2=q.nu, assumption="plane strain"
    )
    P = q.P if P is None else P
    a = hertz_line.half_width(P=P, R=R, E_star=E_star)
    return float(a), float(hertz_line.peak_pressure(P=P, R=R, E_star=E_star))


def race(q: LoadsInputs, *, n: int | None = None, P: float | None = None) -> LoadedRace:
    """The Fourier ring of these inputs, or under another number of loads P per length."""
    P = q.P if P is None else P
    return LoadedRace(
        r_i=q.r_i, r_o=q.r_o, E=q.E, nu=q.nu, assumption="plane stress", loaded=q.loaded,
        n=q.n if n is None else n, P=P, a=hertz(q, P)[0],
    )  # fmt: skip


def outward(q: LoadsInputs) -> float:
    """The sign with which a displacement goes along with the push."""
    return 1.0 if q.loaded == "bore" else -1.0


def dent(q: LoadsInputs, depth: float, P: float | None = None) -> float:
    """Approach [m] of the patch's middle and a point at `depth` of a half plane, plane stress."""
    P = q.P if P is None else P
    return float(
        hertz_line_approach.approach_to_depth(
            depth, P=P, a=hertz(q, P)[0], E=q.E, nu=q.nu, assumption="plane stress"
        )
    )


def by_smearing(q: LoadsInputs, *, n: int | None = None, P: float | None = None) -> float:
    """Eq. 6 [m]."""
    return float(
        smeared.race_deflection(
            P=q.P if P is None else P, n=q.n if n is None else n, r_i=q.r_i, r_o=q.r_o, E=q.E,
            nu=q.nu, loaded=q.loaded,
        )
    )  # fmt: skip


def analytic(q: LoadsInputs) -> Values:
    ring, sign = race(q), outward(q)
    far_wall = q.r_o if q.loaded == "bore" else q.r_i
    pitch = np.pi / q.n
    state = ring.at([ring.r, ring.r, far_wall, far_wall], [0.0, pitch, 0.0, pitch])
    load, between, far_load, far_between = sign * state.u_r
    wall = q.r_o - q.r_i
    lamé = by_smearing(q)
    values: dict[str, Any] = {
        "load": load, "between": between, "far load": far_load, "far between": far_between,
        "ripple": (load - between) / lamé, "one": 1.0,
        "smeared": lamé, "mean": sign * ring.ring.mean_displacement(ring.r),
        "dent, wall": dent(q, wall), "dent, half wall": dent(q, wall / 2),
        "hoop between": state.sigma_theta[1], "far hoop load": state.sigma_theta[2],
        "far hoop between": state.sigma_theta[3],
        "stress scale": float(np.abs(state.sigma_theta[1:]).max()),
        "hoop force": hoop_force(ring), "strain energy": strain_energy(ring),
        "a": ring.a, "p_0": hertz(q)[1], "a/wall": ring.a / wall,
    }  # fmt: skip
    values["Lamé + Hertz"] = lamé + values["dent, wall"]
    values["windup"] = values["Lamé + Hertz"] / load
    return {key: float(value) for key, value in values.items()}


def hoop_force(ring: LoadedRace) -> float:
    """Force per length [N/m] in the cut between the loads by statics; tension is positive.

    Half a load's push along its axis, P <cos theta> over the patch, hangs on the cut.
    """
    along = loaded_race.share(ring.alpha) * ring.P
    sign = 1.0 if ring.loaded == "bore" else -1.0
    return float(sign * along / (2 * np.sin(np.pi / ring.n)))


def strain_energy(ring: LoadedRace) -> float:
    """Of the whole ring per length [N]: half the work of the pressures on the patches."""
    turn = np.arange(1, POINTS + 1) * np.pi / (POINTS + 1)
    weight = 2 / (POINTS + 1) * np.sin(turn) ** 2
    u = ring.at(ring.r, ring.alpha * np.cos(turn)).u_r
    return float(ring.n * ring.P / 2 * abs(u @ weight))
