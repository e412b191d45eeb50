"""Solutions as VTU files for ParaView, by meshio, which is imported when one is written."""

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
T = TypeVar("T")
CELLS = {2: "line", 3: "triangle", 4: "quad"}


def to_vtu(solution: Any, path: str | Path, *, elements: Any = None) -> Path:
    """Write a solution as VTU, lengths and stresses in the units of the input; the path.

    Plane, axisymmetric and contact solutions have `displacement` at the vertices, and per cell the
    mean `stress` (six components XX, YY, ZZ, XY, YZ, XZ; ZZ is the hoop stress of a body of
    revolution) and `von_mises`. Frames have `displacement` and `rotation` [rad] at their nodes and
    need their `elements` (m, 2 or 3), of which a line joins the ends.

    ImportError without meshio, which `freewheel-verification[fem]` has; TypeError for a solution
    of another kind; ValueError for a frame without elements; OSError where it cannot be written.
    """
    content = kind_of(solution, WRITTEN)
    try:
        import meshio
    except ImportError as error:
        raise ImportError("to_vtu needs meshio: install freewheel-verification[fem]") from error
    points, cells, at_points, in_cells = content(solution, elements)
    meshio.Mesh(
        _solid(points), [(CELLS[cells.shape[1]], cells)], point_data=at_points,
        cell_data={name: [values] for name, values in in_cells.items()},
    ).write(path, file_format="vtu")  # fmt: skip
    return Path(path)


def kind_of(solution: object, known: Mapping[str, T]) -> T:
    """What is known of the class of a solution, by its full name; none of them is imported."""
    for cls in type(solution).__mro__:
        if found := known.get(f"{cls.__module__}.{cls.__qualname__}"):
            return found
    names = ", ".join(name.rpartition(".")[2] for name in known)
    raise TypeError(f"a solution is one of {names}, got {type(solution).__name__}")


Content = tuple[Array, NDArray[np.int64], dict[str, Array], dict[str, Array]]


def _plane(solution: Any, _elements: Any) -> Content:
    f = solution.cells()
    xx, yy, xy, zz = f["stress"].T
    none = np.zeros_like(xx)
    stress = np.column_stack([xx, yy, zz, xy, none, none])
    return (
        f["points"], f["cells"], {"displacement": _solid(f["displacement"])},
        {"stress": stress, "von_mises": f["von_mises"]},
    )  # fmt: skip


def _contact(solution: Any, elements: Any) -> Content:
    return _plane(solution.plane, elements)


def _frame(solution: Any, elements: Any) -> Content:
    if elements is None:
        raise ValueError("the solution of a frame contains no elements: give elements=")
    fields = {"displacement": _solid(solution.u[:, :2]), "rotation": solution.u[:, 2]}
    return np.asarray(solution.points), np.asarray(elements)[:, :2], fields, {}


def _solid(values: Array) -> Array:
    """Plane vectors in space."""
    return np.column_stack([values, np.zeros(len(values))])


WRITTEN: dict[str, Callable[[Any, Any], Content]] = {
    "fem.plane.solution.PlaneSolution": _plane,
    "fem.contact.solution.ContactSolution": _contact,
    "fem.beam.section.FrameSolution": _frame,
}
