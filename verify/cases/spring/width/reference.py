"""Finite elements of case spring-width: shells and solids of the spring, a loop and a leaf."""

import math
from collections.abc import Sequence
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from analytic.spring.frame import Head, Tail
from verify.case import Level
from verify.cases.spring.limits import Share
from verify.cases.spring.width.inputs import WidthInputs
from verify.core.figures import Field

if TYPE_CHECKING:
    from fem.plane.material import Elastic
    from fem.shell.solution import ShellSolution
    from meshes.shell.surface import ShellMesh
    from meshes.spring.path import Piece

LEVELS = (2, 3, 4)  # number of cells of an arc
SWEPT = 2  # level for sweeps and for other end conditions
ENDS: tuple[tuple[Tail, Head], ...] = (
    ("arc", "free"), ("arc", "guided"), ("mid-leaf", "free"), ("mid-leaf", "guided"),
)  # fmt: skip
HEADS = {"free": "", "hinged": "y", "guided": "yabc"}
NARROW = (0.2, 0.5, 1.0, 2.0, 4.0)  # widths over the thickness or over THREAD, whichever is larger
THREAD = 1 / 120  # width over the length of a leaf: narrower strips are ill-conditioned
MEDIUM = (0.1, 0.2, 0.4, 0.7, 1.0)  # widths over the length of a leaf
WIDE = (2.0, 5.0, 10.0, 30.0, 90.0)
RATIOS = (Share(0.2), Share(1.0), Share(5.0))  # width over length of a thin leaf
THIN = 3e-5  # thickness over length of a leaf for which Kirchhoff's plate theory is valid
BOTH = (20.0, 100.0)  # widths over the thickness at which solids are compared with shells
ROUND_OFF = 1e-12  # relative to the energy


def solve(q: WidthInputs, level: int) -> Level:
    """Results of one level of spring, leaves and loops; one level also has the sweeps."""
    values: dict[str, float] = {}
    for tail, head in ENDS:
        values[f"k_wide_{key_of(tail, head)}"] = fem_spring(q, q.h, level, tail, head, held=True)
    values["k_narrow"] = fem_spring(q, q.h, level, q.tail, q.head, held=True, narrow=True)
    values["k"] = fem_spring(q, q.h, level, q.tail, q.head)
    values["f"] = values["k"] / values["k_narrow"]
    values["f_narrowest"] = factor(q, NARROW[0] * thread(q), level)
    arrays: dict[str, NDArray[Any]] = {}
    for ratio in RATIOS:
        values[f"leaf_factor_{ratio}"], arrays[f"lifted_{ratio}"] = fem_leaf(q, ratio, level)
    fields: list[Field] = []
    for name, h in widths_of_both(q).items():
        loops = shell_loop(q, h, level)
        values[f"shell_{name}"], values[f"solid_{name}"] = loops[0], solid_loop(q, h, level)
        fields = [loop_field(*loops[1:])]  # the last loop has the inputs' width
    if level == SWEPT:
        arrays |= sweeps(q)
    u_it = {key: ROUND_OFF * abs(value) for key, value in values.items()}
    return Level(h=1 / level, values=values, u_it=u_it, arrays=arrays, fields=tuple(fields))


def key_of(tail: Tail, head: Head) -> str:
    """Suffix of the names of values with the end conditions `tail` and `head`."""
    return f"{tail}_{head}".replace("-", "_")


def thread(q: WidthInputs) -> float:
    """Reference width [m] of narrow springs: the larger of b and THREAD times the leaf length."""
    return max(q.b, THREAD * q.leaf)


def widths_of_both(q: WidthInputs) -> dict[str, float]:
    """Widths [m], by name, of the loops that are computed twice: as shell and as solid."""
    return {f"{ratio:g}": ratio * q.b for ratio in BOTH} | {"given": q.h}


def sweeps(q: WidthInputs) -> dict[str, NDArray[Any]]:
    """Arrays of width factors, by name: over width, for all end conditions, with uniform force."""
    swept = {
        "narrow": [ratio * thread(q) for ratio in NARROW],
        "medium": [ratio * q.leaf for ratio in MEDIUM if ratio * q.leaf > NARROW[-1] * thread(q)],
        "wide": [ratio * q.leaf for ratio in WIDE],
    }
    found = {
        f"sweep_{name}": np.array([(h, factor(q, h, SWEPT)) for h in widths]).reshape(-1, 2)
        for name, widths in swept.items()
    }
    found["ends"] = np.array([factor(q, q.h, SWEPT, *ends) for ends in ENDS])
    found["uniform"] = np.array([factor(q, q.h, SWEPT, uniform=each) for each in (False, True)])
    return found


def factor(
    q: WidthInputs, h: float, level: int, tail: Tail | None = None, head: Head | None = None, *,
    uniform: bool = False,
) -> float:  # fmt: skip
    """Ratio of the stiffness to that in plane stress on the same mesh."""
    ends = tail or q.tail, head or q.head
    plane = fem_spring(q, h, level, *ends, held=True, narrow=True)
    return fem_spring(q, h, level, *ends, uniform=uniform) / plane


@lru_cache(maxsize=64)
def fem_spring(
    q: WidthInputs, h: float, level: int, tail: Tail, head: Head, *, held: bool = False,
    narrow: bool = False, uniform: bool = False,
) -> float:  # fmt: skip
    """Stiffness [N/m] of the spring as a shell of width h [m], symmetric about its middle.

    With `held` edges (no rotation, no displacement normal to the plane) it is in plane strain; with
    the material of a `narrow` strip, it has the plane-stress stiffness. If `uniform`, a uniform
    force acts on the head; otherwise, the head remains straight.
    """
    from meshes.spring.path import accordion

    material = fem_plane_stress(q) if narrow else fem_steel(q)
    mesh = fem_mesh(
        list(accordion(**q.path, tail=tail)), q.b, h, level, across=cells(q, h, level, held)
    )
    solved = fem_pulled(mesh, q.b, h, material, HEADS[head], held=held, uniform=uniform)
    return -1 / solved.potential_energy


def cells(q: WidthInputs, h: float, level: int, held: bool) -> int:
    """Number of cells across half the width: one if `held` (plane strain), few if narrow."""
    if held:
        return 1
    return level if h <= NARROW[-1] * q.b else 3 * level


def fem_steel(q: WidthInputs) -> "Elastic":
    from fem.plane.material import Elastic

    return Elastic(E=q.E, nu=q.nu)


def fem_plane_stress(q: WidthInputs) -> "Elastic":
    """Elastic material whose stiffness in plane strain equals that of the steel in plane stress."""
    from fem.plane.material import Elastic

    return Elastic(E=q.E * (1 + 2 * q.nu) / (1 + q.nu) ** 2, nu=q.nu / (1 + q.nu))


def fem_mesh(
    path: "Sequence[Piece]", b: float, h: float, level: int, *, across: int
) -> "ShellMesh":
    """Shell mesh of half the width of the strip, with small cells in the edge layer of width b."""
    from meshes.shell.strip import swept_path

    return swept_path(path, width=h / 2, per_arc=level, per_leaf=3 * level, across=across,
                      finest=3.2 * b / level, leaf_ends=0.1)  # fmt: skip


def fem_pulled(
    mesh: "ShellMesh", b: float, h: float, material: "Elastic", head: str, *,
    held: bool = False, uniform: bool = False,
) -> "ShellSolution":  # fmt: skip
    """Solution for half of the width under 1 N along x on the head (2 N on the whole width)."""
    from fem.shell.solve import solve_shell

    supports: dict[str | int, Any] = {"tail": "xyzabc", "middle": "zab", "head": head}
    if held:
        supports["edge"] = "zab"
    return solve_shell(
        mesh.points, mesh.cells, thickness=b, materials=material, boundaries=mesh.boundaries,
        ties={} if uniform else {"head": "x"}, edge_loads={"head": (2 / h, 0.0, 0.0)},
        supports=supports,
    )  # fmt: skip


def fem_leaf(q: WidthInputs, ratio: float, level: int) -> tuple[float, NDArray[np.float64]]:
    """Width factor of a leaf so thin that Kirchhoff's plate theory applies, and its deflection.

    The second result (k, 2) contains positions relative to the length of the leaf, and deflections
    of the edge against the middle, relative to the displacement of the head.
    """
    from meshes.shell.strip import swept_path
    from meshes.spring.path import Piece

    length, b, h = q.leaf, THIN * q.leaf, ratio * q.leaf
    path = [Piece("leaf", 0.0, 0.0, math.pi / 2, length, 0.0, 1)]

    def solve(material: "Elastic", held: bool) -> tuple["ShellMesh", "ShellSolution"]:
        mesh = swept_path(
            path, width=h / 2, per_arc=1, per_leaf=6 * level, across=1 if held else 3 * level,
            finest=None if held else 0.02 * min(h / 2, length) / level, leaf_ends=0.02,
        )  # fmt: skip
        return mesh, fem_pulled(mesh, b, h, material, HEADS["guided"], held=held)

    (mesh, wide), (_, narrow) = solve(fem_steel(q), False), solve(fem_plane_stress(q), True)
    y, x = mesh.points[:, 1] / length, wide.u[:, 0]
    edge, middle = (np.unique(mesh.boundaries[name]) for name in ("edge", "middle"))
    edge, middle = edge[np.argsort(y[edge])], middle[np.argsort(y[middle])]
    lifted = (x[edge] - x[middle]) / x.max()
    factor = narrow.potential_energy / wide.potential_energy
    return float(factor), np.column_stack([y[edge], lifted])


def fem_loop(q: WidthInputs) -> "tuple[Piece, ...]":
    """Pieces of a loop: half a leaf, two quarter arcs, half a leaf."""
    from meshes.spring.path import Piece

    a, R, turn = q.L1 / 2, q.R, -math.pi / 2
    return (
        Piece("leaf", 0.0, 0.0, math.pi / 2, a, 0.0, 1),
        Piece("arc", 0.0, a, math.pi / 2, R * math.pi / 2, turn, 1),
        Piece("arc", R, a + R, 0.0, R * math.pi / 2, turn, 1),
        Piece("leaf", 2 * R, a, turn, a, 0.0, 1),
    )


def shell_loop(q: WidthInputs, h: float, level: int) -> "tuple[float, ShellMesh, ShellSolution]":
    """Ratio of a loop's stiffness to that in plane strain, with the loop's mesh and solution."""
    path = fem_loop(q)
    mesh = fem_mesh(path, q.b, h, level, across=cells(q, h, level, held=False))
    solved = fem_pulled(mesh, q.b, h, fem_steel(q), HEADS["guided"])
    flat = fem_mesh(path, q.b, h, level, across=1)
    endless = fem_pulled(flat, q.b, h, fem_steel(q), HEADS["guided"], held=True)
    return endless.potential_energy / solved.potential_energy, mesh, solved


def solid_loop(q: WidthInputs, h: float, level: int) -> float:
    """Ratio of the stiffness of a loop to that in plane strain, by 27-node solid elements."""
    return fem_solid(q, h, level, held=False) / fem_solid(q, h, level, held=True)


def fem_solid(q: WidthInputs, h: float, level: int, *, held: bool) -> float:
    """Stiffness [N/m] of the loop as a solid, with parabolic shear stress on its ends."""
    from fem.solid.solve import solve_solid
    from meshes.solid.strip import solid_strip

    path = fem_loop(q)
    x, y = path[-1].end
    mesh = solid_strip(path, b=q.b, width=h / 2, through=1, per_arc=level, per_leaf=3 * level,
                       across=1 if held else 2 * level, grading=100.0)  # fmt: skip

    def shear(centre: float, force: float) -> Any:
        def traction(p: Any) -> Any:
            t = force / (q.b * h / 2) * 1.5 * (1 - (2 * (p[0] - centre) / q.b) ** 2)
            return np.array([t, 0 * t, 0 * t])

        return traction

    solved = solve_solid(
        mesh, materials=fem_steel(q), points=(2, 3, 3), uniform={(0.0, 0.0, None): "x"},
        supports={
            "middle": "z", "head": "y", "tail": "y", (x, y, None): "x" if held else "xz",
            **({"edge": "z"} if held else {}),
        },
        tractions={"head": shear(0.0, 1.0), "tail": shear(x, -1.0)},
    )  # fmt: skip
    return -1 / solved.potential_energy


QUARTERS = ((0, 4, 8, 7), (4, 1, 5, 8), (8, 5, 2, 6), (7, 8, 6, 3))  # of a nine-node cell
NEAREST = (0, 6, 8, 2)  # Gauss point in each quarter, the second coordinate running fastest


def loop_field(mesh: "ShellMesh", solved: "ShellSolution") -> Field:
    """Displacement and bending stress of half the loop's width, under 2 N on the whole width."""
    cells = mesh.cells[:, QUARTERS].reshape(-1, 4)
    stress = solved.bending_stress[:, NEAREST].reshape(-1, 3, 3)
    return Field(
        name="loop", points=mesh.points, cells=cells, point_data={"displacement": solved.u},
        cell_data={"across": stress[:, 2, 2]}, units={"displacement": "m", "across": "Pa"},
    )  # fmt: skip
