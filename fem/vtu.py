"""VTU files of solutions for ParaView, with meshio, which is imported when a file is written."""

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, TypeVar

import numpy as np

from fem.vtu_space import Array, Content, modes, shell, solid

T = TypeVar("T")
CELLS = {2: "line", 3: "triangle", 4: "quad", 8: "hexahedron", 9: "quad9"}


def to_vtu(solution: Any, path: str | Path, *, elements: Any = None, rotor: Any = None) -> Path:
    """Write a solution as a VTU file, with lengths and stresses in input units; return the path.

    Tensors have the six components XX, YY, ZZ, XY, YZ, XZ. Values per cell are means over the cell,
    weighted by volume or area.

    - plane, axisymmetric and contact solutions: `displacement` at the vertices; `stress` and
      `von_mises` per cell. In a body of revolution x is the radius, y the axis, ZZ the hoop stress
    - solids: the same quantities in space
    - shells: `displacement` and `rotation` [rad] at the nodes; per cell the tensors
      `membrane_stress` and `bending_stress` (on the face to which the normals point) and the
      vector `shear_stress`
    - frames: `displacement` and `rotation` [rad] at the nodes. The argument `elements` (m, 2 or 3)
      is required; the ends of an element are connected by a line
    - modes of a rotor: the numbered nodes, on the z-axis. For mode k = 1, 2, ..., `mode_k_real` and
      `mode_k_imaginary` are the two parts of the displacement. The argument `rotor` is required

    Raises ImportError without meshio, which `freewheel-verification[fem]` installs; TypeError for a
    solution of another kind; ValueError for a frame without elements, and for modes without their
    rotor; OSError if the file cannot be written.
    """
    content = kind_of(solution, WRITTEN)
    try:
        import meshio
    except ImportError as error:
        raise ImportError("to_vtu needs meshio: install freewheel-verification[fem]") from error
    points, cells, at_points, in_cells = content(solution, elements=elements, rotor=rotor)
    meshio.Mesh(
        points, [(CELLS[cells.shape[1]], cells)], point_data=at_points,
        cell_data={name: [values] for name, values in in_cells.items()},
    ).write(path, file_format="vtu")  # fmt: skip
    return Path(path)


def kind_of(solution: object, known: Mapping[str, T]) -> T:
    """Entry of `known` for the class of `solution`.

    Keys are full names of classes, so that classes of other solutions need not be imported.
    """
    for cls in type(solution).__mro__:
        if found := known.get(f"{cls.__module__}.{cls.__qualname__}"):
            return found
    names = ", ".join(name.rpartition(".")[2] for name in known)
    raise TypeError(f"a solution must be one of {names}, got {type(solution).__name__}")


def _plane(solution: Any, **_more: Any) -> Content:
    f = solution.cells()
    xx, yy, xy, zz = f["stress"].T
    none = np.zeros_like(xx)
    stress = np.column_stack([xx, yy, zz, xy, none, none])
    return (
        _in_space(f["points"]), f["cells"], {"displacement": _in_space(f["displacement"])},
        {"stress": stress, "von_mises": f["von_mises"]},
    )  # fmt: skip


def _contact(solution: Any, **more: Any) -> Content:
    return _plane(solution.plane, **more)


def _frame(solution: Any, *, elements: Any, **_more: Any) -> Content:
    if elements is None:
        raise ValueError(
            "the solution of a frame contains no elements: give them as the argument elements"
        )
    fields = {"displacement": _in_space(solution.u[:, :2]), "rotation": solution.u[:, 2]}
    return _in_space(np.asarray(solution.points)), np.asarray(elements)[:, :2], fields, {}


def _in_space(values: Array) -> Array:
    """Plane vectors as vectors in space, with a third component of zero."""
    return np.column_stack([values, np.zeros(len(values))])


WRITTEN: dict[str, Callable[..., Content]] = {
    "fem.plane.solution.PlaneSolution": _plane,
    "fem.contact.solution.ContactSolution": _contact,
    "fem.solid.solution.SolidSolution": solid,
    "fem.shell.solution.ShellSolution": shell,
    "fem.beam.section.FrameSolution": _frame,
    "fem.rotor.modes.Modes": modes,
}
