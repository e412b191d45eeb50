"""Random problems of contact with friction: solving method, run time, and check of each solution.

    python -m benchmarks.friction [--problems 10000] [--seed 0]

One to four bodies are in contact with each other and with the ground along graded surfaces of
half-planes; Dundurs' constant couples pressure and slip. The load path has 20 steps with reversals.
A separate check, which shares no code with the solver, judges every solution.
"""

import argparse
import time
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linprog

from fem.contact.complementarity import Complementarity, Rest
from fem.contact.errors import NoEquilibriumError, NotFoundError

Array = NDArray[np.float64]

STEPS = 20
ACCEPTED = 1e-9
PROVEN = 1e-6  # load without equilibrium, over the largest load: well above numerical errors
HELD, PRESSED, DRIVEN, HUNG, PULLED = KINDS = (
    "no free bodies", "pressed by loads", "driven by the ground", "held by friction", "pulled away",
)  # fmt: skip


@dataclass(frozen=True)
class Problem:
    """A kernel with initial gaps (m,), motions of the ground (steps, n) and loads (steps, k)."""

    kind: str
    kernel: Complementarity
    gaps: Array
    ground: Array
    loads: Array


def second_differences(F: Array) -> Array:
    """Integrals over pairs of cells, computed from F, a function of the distances of their ends."""
    return np.asarray(F[1:, :-1] - F[:-1, :-1] - F[1:, 1:] + F[:-1, 1:])


def half_plane(ends: Array, beta: float) -> Array:
    """Compliance (2 n, 2 n) of n cells with constant tractions on a half-plane."""
    d = ends[:, None] - ends[None, :]
    size = np.abs(d) / (20 * np.ptp(ends))
    log = second_differences(d**2 / 2 * (np.log(np.where(size > 0, size, 1.0)) - 1.5))
    turn = second_differences(d * np.abs(d) / 2) * beta * np.pi / 2
    return np.block([[-log, turn], [turn.T, -log]])


def cells(rng: np.random.Generator, n: int) -> Array:
    """Ends (n + 1,) of cells on (-1, 1); lengths grow up to tenfold towards a random side."""
    lengths = np.geomspace(1.0, rng.uniform(1, 10), n)
    if rng.random() < 0.5:
        lengths = np.concatenate([lengths[::-2], lengths[1::2]])
    ends = np.concatenate([[0.0], np.cumsum(lengths)])
    return np.asarray(2 * ends / ends[-1] - 1)


def problem(seed: int) -> Problem:
    """The problem for a seed."""
    rng = np.random.default_rng(seed)
    kind = KINDS[rng.choice(5, p=[0.3, 0.35, 0.2, 0.1, 0.05])]
    bodies = int(rng.integers(1, 5))
    pairs = [(i, i - 1) for i in range(bodies)]  # body -1 is the ground
    if kind != PULLED and rng.random() < 0.5:
        pairs.append((bodies - 1, -1))  # in contact on two sides
    sizes = rng.integers(4, 33, len(pairs))
    blocks = [surface(rng, int(n)) for n in sizes]
    m, k = int(sizes.sum()), 0 if kind == HELD else 3 * bodies
    B, D, gaps = np.zeros((2 * m, 2 * m)), np.zeros((2 * m, 3 * bodies)), np.zeros(m)
    start, normals = 0, []
    for (upper, lower), n, (C, x, length, gap) in zip(pairs, sizes, blocks, strict=True):
        own = start + np.arange(n)
        rows = np.concatenate([own, m + own])
        B[np.ix_(rows, rows)] = C
        gaps[own] = length * gap
        angle = rng.uniform(-0.3, 0.3) + (np.pi if lower == -1 and upper > 0 else 0.0)
        normal, tangent = (
            np.array([-np.sin(angle), np.cos(angle)]),
            np.array([np.cos(angle), np.sin(angle)]),
        )
        for body, sign in ((upper, 1.0), (lower, -1.0)):
            if body >= 0:
                D[own, 3 * body : 3 * body + 2] = sign * length[:, None] * normal
                D[own, 3 * body + 2] = sign * length * x
                D[m + own, 3 * body : 3 * body + 2] = sign * length[:, None] * tangent
        normals.append((own, length, normal))
        start += n
    coupling = rng.normal(size=(2 * m, 3)) * np.sqrt(np.diag(B))[:, None] * 0.1
    kernel = Complementarity(
        B=B + coupling @ coupling.T, D=D[:, :k], friction=np.full(m, rng.uniform(0, 1.5)),
        partner=m + np.arange(m), part=np.repeat(np.arange(len(pairs)), sizes),
    )  # fmt: skip
    return Problem(kind, kernel, gaps, *paths(rng, kind, kernel, D, gaps))


def surface(rng: np.random.Generator, n: int) -> tuple[Array, Array, Array, Array]:
    """Compliance, midpoints, lengths and gaps of a surface: flat, round or with a sharp end."""
    ends = cells(rng, n)
    x, length = (ends[1:] + ends[:-1]) / 2, np.diff(ends)
    gap = rng.choice([0.0, 0.5, 5.0]) * (x - rng.uniform(-0.3, 0.3)) ** 2
    return half_plane(ends, rng.uniform(-0.45, 0.45)), x, length, gap - gap.min()


def paths(
    rng: np.random.Generator, kind: str, kernel: Complementarity, D: Array, gaps: Array
) -> tuple[Array, Array]:
    """Motions of the ground and loads with reversals, for small to nearly complete contacts."""
    m, k = gaps.size, kernel.D.shape[1]
    size = 10.0 ** rng.uniform(-6, 0)
    turns = np.cumsum(rng.choice([-1.0, 1.0], STEPS, p=[0.4, 0.6])) / 5
    press = np.minimum(np.arange(1, STEPS + 1), 5) / 5 * (1 + 0.3 * np.sin(np.arange(STEPS)))
    area = np.abs(D).max(axis=1)
    down = np.concatenate([-area[:m], np.zeros(m)])
    along = np.concatenate([0.2 * rng.uniform(-1, 1, m) * area[:m], area[m:]])
    ground = size * (np.outer(press, down) + rng.uniform(0, 1.5) * np.outer(turns, along))
    if kind in (HELD, DRIVEN, HUNG):
        loads = np.zeros((STEPS, k))
        if kind == HUNG:
            loads = np.outer(turns, rng.normal(size=k)) * size * 0.1
        return ground, loads
    force = rng.uniform(0, 1, m) * size  # contact forces that balance the loads without friction
    pressed = -kernel.D[:m].T @ force
    if kind == PULLED:
        return 0 * ground, np.outer(-press, pressed)
    return 0.1 * ground, np.outer(press, pressed)


def violation(one: Problem, w_0: Array, e: Array, rest: Rest) -> float:
    """Largest violation of the laws of contact, each over its scale, without code of the solver."""
    B, D, mu, m = one.kernel.B, one.kernel.D, one.kernel.friction, one.gaps.size
    w, own = w_0 + B @ rest.multipliers + D @ rest.motion, np.diag(B)
    p, q = rest.multipliers[:m], rest.multipliers[m:]
    force, nothing = p.max(), 1e-12 * np.abs(w_0 / own).max() * np.abs(D).max(initial=0.0)
    if np.abs(e).max(initial=0.0) <= nothing:
        force = max(force, 1e-3 * np.maximum(-w_0[:m] / own[:m], 0.0).max())
    force = force or 1.0
    reach = np.maximum(own * force, 1e-5 * (np.abs(w_0) + np.abs(D) @ np.abs(rest.motion)))
    g, s = w[:m] / reach[:m], w[m:] / reach[m:]
    found = [
        (-p).max() / force,
        (-g).max(),
        np.minimum(np.abs(p) / force, np.abs(g)).max(),
        (np.abs(q) - mu * np.abs(p)).max() / force,
        np.minimum(np.abs(s), (mu * p - np.abs(q)) / force).max(),  # slip below the limit
        np.minimum(s, q / force).max(),
        np.minimum(-s, -q / force).max(),  # slip along the traction
    ]
    if e.size:
        missed = np.abs(e + D.T @ rest.multipliers).max()
        size = max((np.abs(e) + np.abs(D).T @ np.abs(rest.multipliers)).max(), 1e-300)
        if np.abs(e).max() <= nothing:
            size = max(size, force * np.abs(D).max())
        found.append(missed / size)
    return float(max(found))


def is_impossible(one: Problem, e: Array) -> bool:
    """Whether no admissible contact forces balance the loads `e` (k,), by a linear programme.

    The programme minimises the sum of the unbalanced loads over the largest load.
    """
    D, mu, m, k = one.kernel.D, one.kernel.friction, one.gaps.size, e.size
    normal, sideways = D[:m].T, (mu[:, None] * D[m:]).T
    edges = np.hstack([normal + sideways, normal - sideways])
    found = linprog(
        np.append(np.zeros(2 * m), np.ones(2 * k)),
        A_eq=np.hstack([edges / np.abs(edges).max(axis=0), np.eye(k), -np.eye(k)]),
        b_eq=-e / np.abs(e).max(),
    )
    return bool(found.fun > PROVEN)


def steps(one: Problem) -> Iterator[tuple[str, float, float]]:
    """Outcome, seconds and violation of each step of the load path."""
    m, slips, states = one.gaps.size, np.zeros(one.gaps.size), None
    for ground, e in zip(one.ground, one.loads, strict=True):
        w_0 = ground + np.concatenate([one.gaps, -slips])
        begin = time.perf_counter()
        try:
            rest = one.kernel.solve(w_0, e, states)
        except NoEquilibriumError:
            outcome = "proven" if is_impossible(one, e) else "wrong proof"
            yield outcome, time.perf_counter() - begin, 0.0
            return
        except NotFoundError:
            yield "not found", time.perf_counter() - begin, 0.0
            return
        yield rest.method, time.perf_counter() - begin, violation(one, w_0, e, rest)
        states = rest.states
        w = w_0 + one.kernel.B @ rest.multipliers + one.kernel.D @ rest.motion
        slips = slips + w[m:]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--problems", type=int, default=10_000)
    parser.add_argument("--seed", type=int, default=0)
    given = parser.parse_args()
    counts: Counter[tuple[str, str]] = Counter()
    seconds, worst, bad = [], (0.0, -1), []
    for seed in range(given.seed, given.seed + given.problems):
        one = problem(seed)
        for outcome, spent, missed in steps(one):
            counts[one.kind, outcome] += 1
            seconds.append((spent, seed))
            worst = max(worst, (missed, seed))
            if missed > ACCEPTED or outcome in ("not found", "wrong proof"):
                bad.append((seed, one.kind, outcome, missed))
    for (kind, outcome), n in sorted(counts.items()):
        print(f"{kind:24} {outcome:16} {n:8}")
    slow = max(seconds)
    print(f"median {np.median([s for s, _ in seconds]) * 1e3:.2f} ms, slowest {slow[0]:.2f} s "
          f"(seed {slow[1]}); largest violation {worst[0]:.1e} (seed {worst[1]})")  # fmt: skip
    for line in bad:
        print("unsolved:", *line)


if __name__ == "__main__":
    main()
