"""The true model: computed engagements of the clutch with any crown; results are stored on disk.

Forces are computed with the slices of the clutch; the ends of the crown have little effect on the
forces. Pressures under these forces are computed by slices and by strips on a half-space.
"""

import json
from collections import deque
from contextlib import suppress
from hashlib import sha256
from importlib.metadata import version
from pathlib import Path

import numpy as np

from analytic.contact import crown, strips
from analytic.sprag.closure import wedged
from analytic.sprag.crowned import Crowned
from verify.cases.sprag.clutch.model import built
from verify.cases.sprag.inputs import EngagementInputs
from verify.cases.sprag.peaks import CHUNK, Crown, NoLockError, Task, some_fem, with_crown
from verify.core import source_code
from verify.core.figures import Array
from verify.core.progress import Show
from verify.core.store import Store, packed, unpacked
from verify.jobs import cache
from verify.jobs.dispatch import Dispatch, queue
from verify.jobs.executor import Lost, local
from verify.studies.design_sprag.known import Known

KIND, CASE = "engagement", "design-sprag"  # of stored chunks
PER_HALF_WIDTH = 3  # strips: where ends carry more of them matter, where they don't these do
FEWEST, MOST = 41, 401
TOLERANCE = 1e-8  # of the strips
SAME = 1e-7  # relative change of a crown's numbers that makes no other crown

One = tuple[Array, Array]  # N_max (m,) and pressures (m, slices) of a crown


class Model:
    """True model of a clutch under its torques; `known` contains all evaluated crowns."""

    def __init__(
        self, q: EngagementInputs, torques: tuple[float, ...], middle: Crown, *, jobs: int,
        show: Show = lambda _state: None, folder: Path | None = None,
    ) -> None:  # fmt: skip
        self.q, self.torques, self.jobs, self.show = q, torques, jobs, show
        self.store = Store(folder or cache.default_folder())
        self.one: Crowned = built(with_crown(q, middle))
        self.Q = float(with_crown(q, None).Q or 0)
        first = self._engaged(np.array([middle]))
        loads = first[0][0]
        self.R = np.array([self.one.radii(wedged(self.one.clutch, N))[0] for N in loads])
        E_star = float(self.one.parts.E_star)
        b = np.sqrt(4 * loads * self.R / (np.pi * E_star * q.l))
        counts = np.clip(np.ceil(PER_HALF_WIDTH * q.l / b), FEWEST, MOST).astype(int)
        self.counts = tuple(int(n) | 1 for n in counts)
        self.known = self._known(np.array([middle]), first)

    def answers(self, crowns: Array) -> Known:
        """Results of the true model for crowns (n, 3); z_m = 0 stands for no crown.

        Raises NoLockError if an engagement does not lock, and another ArithmeticError if an
        engagement could not be solved.
        """
        return self._known(crowns, self._engaged(crowns))

    def ask(self, crowns: Array) -> Known:
        """Results of the true model for crowns (n, 3); new results are added to `known`."""
        found = self.answers(crowns)
        for k in range(len(found)):
            apart = np.abs(found.crowns[k] / self.known.crowns - 1).max(axis=1)
            if apart.min() > SAME:
                self.known = self.known.with_(found[k : k + 1])
        return found

    def gap(self, crowns: Array, n: int) -> Array:
        """Drops (..., n) [m] of crowns (..., 3) at the centres of n slices."""
        return self.drop(crowns, crown.slice_centres(length=self.q.l, slices=n))

    def drop(self, crowns: Array, y: Array) -> Array:
        """Drops (..., k) [m] of crowns (..., 3) at the positions `y` (k,) [m] along the sprag."""
        K_1, K_2, z_m = (crowns[..., k, None] for k in range(3))
        drop = crown.logarithmic(
            y, K_1=K_1, K_2=K_2, z_m=np.where(z_m > 0, z_m, 1.0), load=self.Q, length=self.q.l,
            E_star=float(self.one.parts.E_star),
        )  # fmt: skip
        return np.asarray(np.where(z_m > 0, drop, 0.0))

    def by_strips(self, crowns: Array, loads: Array, torque: int, n: int) -> Array:
        """Pressures (k, n) [Pa] of crowns (k, 3) by n strips, under the loads (k,) [N].

        `torque` is the number of the torque that causes the loads.
        """
        return strips.press_strips(
            self.gap(crowns, n), length=self.q.l, R=self.R[torque],
            E_star=float(self.one.parts.E_star), load=loads, tolerance=TOLERANCE,
        ).pressure  # fmt: skip

    def _known(self, crowns: Array, found: list[One]) -> Known:
        N_max = np.array([N for N, _ in found])
        return Known(
            np.asarray(crowns, dtype=np.float64), N_max, np.array([p for _, p in found]),
            tuple(self.by_strips(crowns, N_max[:, k], k, n) for k, n in enumerate(self.counts)),
        )  # fmt: skip

    def _engaged(self, crowns: Array) -> list[One]:
        tasks = [
            tuple((float(a), float(b), float(c)) for a, b, c in crowns[k : k + CHUNK])
            for k in range(0, len(crowns), CHUNK)
        ]
        whole: list[Task] = [(self.q, self.torques, task, "slices") for task in tasks]
        found = {task[2]: one for task in whole if (one := load(self.store, task))}
        missing = {task[2]: task for task in whole if task[2] not in found}
        waiting = deque(missing.values())
        processes = 0 if self.jobs == 1 or len(missing) < 2 else min(self.jobs, len(missing))
        known = sum(map(len, found))

        def receive(task: Task, answer: list[One] | str | Lost) -> int:
            found[task[2]] = engagements(answer)
            if not keep(self.store, task, found[task[2]]):
                dispatch.unstored += len(task[2])
            return len(task[2])

        show = self.show if len(whole) > 1 else (lambda _state: None)
        dispatch = Dispatch("crowns", len(crowns), known, show, title=lambda _task: "engagements")
        dispatch.run(local(processes), some_fem, queue(waiting), receive)
        return [one for task in tasks for one in found[task]]


def engagements(answer: list[One] | str | Lost) -> list[One]:
    """Forces and pressures of the crowns in `answer`, if the computation succeeded.

    Raises NoLockError if an engagement does not lock, and ArithmeticError if it was not computed.
    """
    if isinstance(answer, Lost):
        raise ArithmeticError(f"the computation of an engagement failed: {answer.reason}")
    if isinstance(answer, str):
        raise NoLockError(answer)
    return answer


def key(task: Task) -> str:
    """Hexadecimal key of the results of a task, from all data on which the results depend."""
    q, torques, crowns, by = task
    clutch = with_crown(q, None).model_dump(exclude={"K_1", "K_2", "z_m", "T", "p_lim", "R_p"})
    task_text = json.dumps([clutch, torques, crowns, by], sort_keys=True)
    parts = [task_text, source_code.source_of(some_fem)]
    parts += [f"{name} {version(name)}" for name in cache.libraries_of(some_fem)]
    return sha256("\0".join(parts).encode()).hexdigest()[:32]


def load(store: Store, task: Task) -> list[One] | None:
    """Stored results of a task; None if there is no readable record."""
    content = store.one(KIND, key(task))
    if content is None:
        return None
    try:
        arrays = unpacked(content)
        return list(zip(arrays["N"], arrays["p"], strict=True))
    except cache.UNREADABLE:
        return None


def keep(store: Store, task: Task, answer: list[One]) -> bool:
    """Store the results of a task; False if they could not be written."""
    N, p = (np.array(part) for part in zip(*answer, strict=True))
    with suppress(OSError):
        store.store(KIND, CASE, {key(task): packed({"N": N, "p": p})})
        return True
    return False
