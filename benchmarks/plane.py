"""Plane elasticity by size: assembly, factorisation with the project's ordering, and SciPy's own.

The peer solves the same matrix in the same run, so that only the ordering differs. Prints
seconds and ratios; `make bench`.
"""

import time
from collections.abc import Callable
from typing import Any

import numpy as np
from scipy.sparse.linalg import splu

from fem.plane import solve
from fem.plane.material import Elastic
from meshes.ring.quarter import quarter_ring

RING = {"r_i": 0.04, "r_o": 0.06}


def timed(run: Callable[[], Any], repeat: int = 3) -> tuple[float, Any]:
    """Best of `repeat` runs [s] and the last result."""
    best, result = np.inf, None
    for _ in range(repeat):
        start = time.perf_counter()
        result = run()
        best = min(best, time.perf_counter() - start)
    return best, result


def measure(refine: int) -> None:
    """One line: unknowns, seconds of mesh, assembly, both factorisations, and their ratio."""
    t_mesh, mesh = timed(lambda: quarter_ring(**RING, refine=refine), 1)
    basis = solve.vector_basis(mesh, None)
    lam, mu, _ = solve._moduli(mesh, Elastic(E=210e9, nu=0.3), "plane strain")
    fields = {"lam": solve._per_cell(lam, basis), "mu": solve._per_cell(mu, basis)}
    t_assembly, K = timed(lambda: solve.stiffness.assemble(basis, **fields))
    held = np.concatenate([basis.get_dofs("x=0").all("u^1"), basis.get_dofs("y=0").all("u^2")])
    free = np.setdiff1d(np.arange(basis.N), held)
    A = K[free][:, free].tocsc()
    b = np.ones(free.size)
    symmetric = {"SymmetricMode": True}

    def ours() -> Any:
        return splu(A, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options=symmetric).solve(
            b
        )

    t_ours, x = timed(ours)
    t_default, y = timed(lambda: splu(A).solve(b))
    agree = np.linalg.norm(x - y) / np.linalg.norm(y)
    print(
        f"{basis.N:8d} {t_mesh:8.3f} {t_assembly:10.3f} {t_ours:9.3f} {t_default:14.3f} "
        f"{t_default / t_ours:7.2f} {agree:10.1e}"
    )


def main() -> None:
    print("unknowns   mesh s assembly s   solve s SciPy default s   ratio  difference")
    for refine in (4, 8, 16):
        measure(refine)


if __name__ == "__main__":
    main()
