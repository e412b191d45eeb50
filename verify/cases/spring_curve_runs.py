"""What case spring-curve has solved: the curve, other contacts and friction, readings, limits."""

from collections.abc import Iterator
from itertools import product
from typing import Any

import numpy as np

from verify.case import FemResult
from verify.cases.spring_curve_fem import Array, Spring, fem_compress
from verify.cases.spring_curve_inputs import CurveInputs

LEVELS = (4, 6, 8)  # cells of an arc and of a leaf
COARSE, READINGS, FINE = LEVELS
GRID = 68  # states over the stroke
FIRST = 1e-6  # of the stroke, for the stiffness at rest
TIMES = (0.1, 10.0)  # the contact's usual stiffness
BACK = (1.0, 0.8, 0.6, 0.4)  # of the stroke, on the way back
BEYOND = np.arange(1, 41) * 0.006  # of the stroke, beyond it
READ = 34  # states of the readings
ROUND_OFF = 1e-9
TOUCH = 0.004  # of the force: tips that press this much touch for sure
THIN = (0.01, 0.005, 0.002, 0.001)  # r over L_1, towards leaves that stay parallel
THIN_UNITS, THIN_SLOPE, THIN_CELLS = 10, 1.5, (4, 6)
THIN_GRID = (10.0, 14.0, 15.6, 16.0)  # of the loops' radius


def spring_of(q: CurveInputs, **changed: Any) -> Spring:
    """The spring of the inputs, or one of its readings."""
    own: dict[str, Any] = {
        "line": q.path, "b": q.b, "h": q.h, "E": q.E, "nu": q.nu, "factor": q.width_factor,
        "head": q.head, "tail": q.tail, "mu": q.mu,
    }  # fmt: skip
    return Spring(**own | changed)


def readings(q: CurveInputs) -> Iterator[tuple[str, Spring]]:
    """What the paper leaves open: tail, head and arcs, without friction and width factor."""
    arcs = {"r": q.r, "r + b/2": q.r + q.b / 2}
    for tail, head, (name, radius) in product(
        ("arc", "mid-leaf"), ("free", "guided"), arcs.items()
    ):
        changed = {"line": q.path | {"radius": radius}, "head": head, "tail": tail}
        yield f"{tail}, {head}, {name}", spring_of(q, factor=1.0, mu=0.0, **changed)


def fem(q: CurveInputs, level: int) -> FemResult:
    own, grid = spring_of(q), np.linspace(0, q.stroke, GRID + 1)[1:]
    rest = fem_compress(own, [FIRST * q.stroke], per_arc=level)
    k0 = float(rest.F[0] / rest.U[0])
    arrays: dict[str, Any] = {}
    if level == FINE:
        arrays["rest"] = rest.shapes[0, rest.nodes]
    if level != READINGS:
        beyond = (q.stroke * (1 + BEYOND)).tolist() if level == FINE else ()
        arrays |= fem_compress(own, grid, per_arc=level, beyond=beyond).arrays(f"curve {level}")
    if level == COARSE:
        for times in TIMES:
            varied = fem_compress(own, grid, per_arc=level, times=times)
            arrays |= {f"contact {times:g}": np.array([varied.U, varied.F, varied.press.sum(1)])}
        slippery = spring_of(q, mu=0.0)
        there = fem_compress(slippery, np.append(grid, np.array(BACK) * q.stroke), per_arc=level)
        arrays["there and back"] = np.array([there.U, there.F, there.press.sum(1)])
    if level == READINGS:
        read = np.linspace(0, q.stroke, READ + 1)[1:]
        for name, spring in readings(q):
            held = read if spring.head != "free" else read[:2]  # it gives way soon after
            found = fem_compress(spring, held, per_arc=COARSE)
            arrays[f"reading {name}"] = np.array([found.U, found.F, found.press.sum(1)])
        arrays["thin"] = np.array([[thin_fem(q, share, c) for share in THIN] for c in THIN_CELLS])
    return FemResult(h=1 / level, values={"k0": k0}, u_it={"k0": ROUND_OFF * k0}, arrays=arrays)


def thin(q: CurveInputs, share: float) -> Spring:
    """A guided spring whose loops are `share` of its leaves, and so are its leaves' slopes.

    Small enough, everything turns by angles of that order only, and linear theory becomes exact.
    """
    radius = share * q.L1
    line = {"n": THIN_UNITS, "L1": q.L1, "radius": radius, "alpha": np.pi / 2 - THIN_SLOPE * share}
    return Spring(line=line, b=0.2 * radius, h=q.h, E=q.E, nu=q.nu, factor=1.0, head="guided",
                  tail="mid-leaf")  # fmt: skip


def thin_fem(q: CurveInputs, share: float, cells: int) -> tuple[float, float, float]:
    """Displacement [m] and force [N] where its tips touch, and the stiffness from there on."""
    spring = thin(q, share)
    curve = fem_compress(spring, spring.line["radius"] * np.array(THIN_GRID), per_arc=cells)
    return _line(curve.U[-2:], curve.F[-2:], curve.press[-2:].sum(axis=1))


def touching(U: Array, F: Array, N: Array) -> tuple[float, float, float]:
    """U_A, F_A and the slope beyond, from the two first states in which tips surely touch.

    N is the sum of normal forces, which begins at zero in A and grows evenly. NaN where nothing
    touches.
    """
    i = int(np.argmax(N > TOUCH * F))
    if i == 0 or i + 1 == len(U):
        return (np.nan,) * 3
    return _line(U[i : i + 2], F[i : i + 2], N[i : i + 2])


def _line(U: Array, F: Array, N: Array) -> tuple[float, float, float]:
    """Where N began, the force there and the slope, from two states."""
    k = (F[1] - F[0]) / (U[1] - U[0])
    U_A = U[0] - N[0] * (U[1] - U[0]) / (N[1] - N[0])
    return float(U_A), float(F[0] - k * (U[0] - U_A)), float(k)
