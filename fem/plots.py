"""Plots of solutions with matplotlib, which is imported when a plot is drawn.

`plot` is a function, not a method: stored results become invalid if the code of a solution class
changes, and a change of a plot must not have this effect.
"""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from fem.vtu import kind_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Array = NDArray[np.float64]
STRESSES = ("xx", "yy", "xy", "zz")
MOVES = ("x", "y")


def plot(
    solution: Any, value: str = "", *, ax: "Axes | None" = None, scale: float = 1.0,
    node: int | None = None, elements: Any = None,
) -> "Axes":  # fmt: skip
    """Draw a solution and return its Axes; values have the units of the input.

    Labels of the axes state these units as "as given".

    - plane, axisymmetric and contact solutions: a field over the cells, `value` "von_mises" (the
      default), a stress "xx", "yy", "xy" or "zz" (hoop), or a displacement "x" or "y";
      "pressure" of a contact solution is the contact pressure along each slave surface
    - frames: undeformed nodes, and nodes with displacements times `scale`, connected if `elements`
      (m, 2 or 3) are given
    - a line of units under compression (`Curve`): force [N] over displacement [m]
    - modes: displacements across the axis over the node; a Campbell diagram: frequencies over
      speed [rad/s]; a response: the largest amplitude [m] of `node` over speed [rad/s]

    Raises ImportError without matplotlib, which `freewheel-verification[report]` contains;
    TypeError for a solution of another kind; ValueError for an unknown `value`, and for a response
    without `node`.

    >>> from fem.plane import Elastic, solve_plane
    >>> from skfem import MeshTri
    >>> ends = {"left": lambda x: x[0] == 0, "right": lambda x: x[0] == 1}
    >>> bar = solve_plane(
    ...     MeshTri().with_boundaries(ends),
    ...     materials=Elastic(E=200.0, nu=0.0), assumption="plane stress",
    ...     supports={"left": "xy"}, tractions={"right": (1.0, 0.0)},
    ... )
    >>> plot(bar, "xx").get_xlabel()
    'x [as given]'
    """
    draw = kind_of(solution, DRAWN)
    try:
        from matplotlib import pyplot as plt
    except ImportError as error:
        raise ImportError(
            "plot needs matplotlib: install freewheel-verification[report]"
        ) from error
    axes = plt.subplots(layout="constrained")[1] if ax is None else ax
    draw(axes, solution, value=value, scale=scale, node=node, elements=elements)
    return axes


def _plane(ax: Any, solution: Any, *, value: str, **_more: Any) -> None:
    from matplotlib.collections import PolyCollection

    fields, value = solution.cells(), value or "von_mises"
    known = {"von_mises": fields["von_mises"]}
    known |= dict(zip(STRESSES, fields["stress"].T, strict=True))
    moved = fields["displacement"][fields["cells"]].mean(axis=1)
    known |= dict(zip(MOVES, moved.T, strict=True))
    if value not in known:
        raise ValueError(f"value must be one of {', '.join(known)}, got {value!r}")
    corners = PolyCollection(
        fields["points"][fields["cells"]], array=known[value], edgecolor="face"
    )
    ax.add_collection(corners)
    ax.autoscale()
    ax.set(xlabel="x [as given]", ylabel="y [as given]", aspect="equal")
    what = "displacement" if value in MOVES else "stress"
    ax.figure.colorbar(corners, ax=ax, label=f"{what} {value} [as given]")


def _contact(ax: Any, solution: Any, *, value: str, **more: Any) -> None:
    if value != "pressure":
        _plane(ax, solution.plane, value=value, **more)
        return
    for number, touch in enumerate(solution.touches):
        ax.plot(touch.arc, touch.pressure, label=f"pair {number}")
    ax.set(xlabel="length along the surface [as given]", ylabel="contact pressure [as given]")
    ax.legend()


def _frame(ax: Any, solution: Any, *, scale: float, elements: Any, **_more: Any) -> None:
    at_rest = np.asarray(solution.points)
    for points, style in (
        (at_rest, {"color": "0.6", "label": "at rest"}),
        (
            at_rest + scale * solution.u[:, :2],
            {"color": "C0", "label": f"displaced, times {scale:g}"},
        ),
    ):
        if elements is None:
            ax.plot(*points.T, ".", **style)
            continue
        for number, (first, second, *middle) in enumerate(np.asarray(elements).tolist()):
            label = {} if number == 0 else {"label": "_"}
            ax.plot(*points[[first, *middle, second]].T, **style | label)
    ax.set(xlabel="x [as given]", ylabel="y [as given]", aspect="equal")
    ax.legend()


def _curve(ax: Any, curve: Any, **_more: Any) -> None:
    ax.plot(curve.U, curve.F)
    ax.set(xlabel="displacement [m]", ylabel="force [N]")


def _modes(ax: Any, modes: Any, **_more: Any) -> None:
    for shape, frequency in zip(modes.shapes, modes.frequencies, strict=True):
        across = shape[:, np.abs(shape[:, :2]).max(axis=0).argmax()].real
        ax.plot(across, label=f"{frequency:.4g} rad/s")
    ax.set(xlabel="node", ylabel="displacement over the largest one")
    ax.legend()


def _campbell(ax: Any, diagram: Any, **_more: Any) -> None:
    for branch, whirl in zip(diagram.frequencies.T, diagram.whirl[-1], strict=True):
        ax.plot(diagram.speeds, branch, "-" if whirl >= 0 else "--", color="C0")
    ax.plot(diagram.speeds, diagram.speeds, color="0.5", label="frequency = speed")
    ax.set(xlabel="speed [rad/s]", ylabel="natural frequency [rad/s], backward whirl dashed")
    ax.legend()


def _response(ax: Any, response: Any, *, node: int | None, **_more: Any) -> None:
    if node is None:
        raise ValueError(
            "the plot of a response requires a node: give its number as the argument node"
        )
    ax.plot(response.speeds, response.major(node))
    ax.set(xlabel="speed [rad/s]", ylabel=f"amplitude of node {node} [m]")


DRAWN: dict[str, Callable[..., None]] = {
    "fem.plane.solution.PlaneSolution": _plane,
    "fem.contact.solution.ContactSolution": _contact,
    "fem.beam.section.FrameSolution": _frame,
    "fem.beam.touching_curve.Curve": _curve,
    "fem.rotor.modes.Modes": _modes,
    "fem.rotor.campbell.Campbell": _campbell,
    "fem.rotor.response.Response": _response,
}
