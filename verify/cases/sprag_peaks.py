"""Largest pressures of a sprag clutch's engagements, crown by crown: what a design of it judges by.

A crown changes the laws of the contacts and little else: they are solved once for all torques.
"""

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass

import numpy as np

from analytic.contact import slices
from analytic.sprag.closure import wedged
from verify.cases.sprag_clutch_model import built
from verify.cases.sprag_clutch_run_fem import AHEAD, engaged_fem
from verify.cases.sprag_engagement_model import crowned_for
from verify.cases.sprag_inputs import EngagementInputs
from verify.shown import Array
from verify.workers import Here, Lost, Pool

CHUNK = 5  # crowns that a process takes at a time
HOW = {
    "slips": "a contact slides on",
    "over the end": "the sprags leave their profile, or what the formulas can tell",
    "disengages": "the contacts are apart at the end",
    "not followed": "the force still rises at the end, take a longer t_end",
}

Crown = tuple[float, float, float]  # K_1, K_2, z_m [m]


class NoLockError(ArithmeticError):
    """An engagement that does not lock: it has no largest pressure to make less."""


@dataclass(frozen=True, eq=False)
class Peaks:
    """Of n crowns (n, 3) under m torques [N m], at the inner contacts.

    `N_max` [N] (n, m), and under it the `pressure` [Pa] of each slice, (n, m, slices).
    """

    crowns: Array
    torques: Array
    N_max: Array
    pressure: Array

    @property
    def largest(self) -> Array:
        """Pre_max [Pa] of Eq. 17, (n, m)."""
        return np.asarray(self.pressure.max(axis=-1))

    @property
    def end(self) -> Array:
        """Pressure [Pa] of the end slices, 0 where they carry nothing, (n, m)."""
        return np.asarray(self.pressure[..., 0])

    @property
    def inside(self) -> Array:
        """Largest pressure [Pa] of all other slices, (n, m)."""
        return np.asarray(self.pressure[..., 1:-1].max(axis=-1))

    def of(self, torque: int) -> "Peaks":
        """The same under one of the torques, by its number."""
        only = slice(torque, torque + 1)
        return Peaks(self.crowns, self.torques[only], self.N_max[:, only], self.pressure[:, only])


def with_crown(q: EngagementInputs, crown: Crown | Array | None) -> EngagementInputs:
    """The clutch with another crown for the same load, or with none."""
    Q = crowned_for(q)
    if crown is None:
        return q.model_copy(update={"z_m": 0.0, "Q": Q})
    K_1, K_2, z_m = (float(x) for x in crown)
    return q.model_copy(update={"K_1": K_1, "K_2": K_2, "z_m": z_m, "Q": Q})


def one_fem(q: EngagementInputs, torques: Iterable[float]) -> tuple[Array, Array]:
    """N_max [N], (m,), and pressures [Pa], (m, slices), with the crown of `q`.

    NoLockError where an engagement does not lock; its own errors where there is none.
    """
    one, forces, pressures = built(q), [], []
    for T in torques:
        N_end = AHEAD * T / (q.z * q.R_i * math.tan(q.nu_0))
        run = engaged_fem(one, q.model_copy(update={"T": T}), N_end)
        verdict = run.engagement.verdict
        if verdict != "locks":
            raise NoLockError(f"under T = {T:g} N m {HOW[verdict]}: no crown mends that")
        N = run.engagement.N_max
        R, _ = one.radii(wedged(one.clutch, N))
        pressed = slices.press(one.gap, length=q.l, R=R, E_star=one.parts.E_star, load=N)
        forces.append(N)
        pressures.append(pressed.peak_pressure)
    return np.array(forces), np.array(pressures)


Task = tuple[EngagementInputs, tuple[float, ...], tuple[Crown, ...]]


def some_fem(task: Task) -> list[tuple[Array, Array]] | str:
    """A chunk of crowns; why, where one has no answer."""
    q, torques, crowns = task
    try:
        return [one_fem(with_crown(q, crown), torques) for crown in crowns]
    except (ArithmeticError, ValueError) as error:
        return str(error)


def peaks_fem(
    q: EngagementInputs,
    crowns: Array,
    torques: Iterable[float],
    *,
    jobs: int = 1,
    progress: Callable[[int], None] = lambda _done: None,
) -> Peaks:
    """Engagements with each of the crowns (n, 3), made for the same load, under each torque [N m].

    `progress` is told how many crowns are done. ArithmeticError where one has no answer.
    """
    torques, n = tuple(float(T) for T in torques), len(crowns)
    tasks = [
        tuple((float(a), float(b), float(c)) for a, b, c in crowns[k : k + CHUNK])
        for k in range(0, n, CHUNK)
    ]
    pool = Here(some_fem) if jobs == 1 or len(tasks) == 1 else Pool(some_fem, min(jobs, len(tasks)))
    found: dict[int, list[tuple[Array, Array]]] = {}
    for said in pool.answers(len(tasks), lambda k: (q, torques, tasks[k])):
        if said is None:
            continue
        number, answer = said
        if isinstance(answer, Lost):
            raise ArithmeticError(f"an engagement had no answer: {answer.reason}")
        if isinstance(answer, str):
            raise NoLockError(answer)
        found[number] = answer
        progress(sum(map(len, found.values())))
    whole = [one for k in range(len(tasks)) for one in found[k]]
    return Peaks(
        np.asarray(crowns, dtype=np.float64), np.array(torques),
        np.array([N for N, _ in whole]), np.array([p for _, p in whole]),
    )  # fmt: skip
