"""What is read off the contact of two rollers: stick zone, tractions, the loop of a cycle."""

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline

from verify.cases.contact.slip.inputs import SlipInputs
from verify.cases.contact.window import cut
from verify.core.figures import Field

if TYPE_CHECKING:
    from fem.contact.solution import ContactSolution

Array = NDArray[np.float64]

WINDOW = 0.06  # of Q/(mu P) about a row's, over which a sweep is smoothed
ACROSS = np.linspace(-0.95, 0.95, 39)  # x/a of the profiles
AROUND = np.linspace(-1.0, 1.0, 17)  # Q/Q_max where the loop is shown, on both branches
VIEW = 3.0  # half-widths about the contact whose cells are kept


def stick_share(touch: Any) -> float:
    """(c/a)² from the moments of a traction mu p_a - mu p_c of two ellipses.

    Both mu p have the moments mu P and mu P a²/4, those of c have (c/a)² and (c/a)⁴ of that, so
    that 4 M_2/(M_0 a²) = (1 - (c/a)⁴)/(1 - (c/a)²) = 1 + (c/a)². M_2 is about the centre of q.
    """
    s, load = touch.along((0.0, 0.0)), touch.q * touch.weight
    M_0 = load.sum()
    M_2 = load @ (s - load @ s / M_0) ** 2
    return float(4 * M_2 / (M_0 * touch.half_width((0.0, 0.0)) ** 2) - 1)


def smoothed(k: Array, v: Array, at: float, window: float = WINDOW) -> tuple[float, float, float]:
    """Value at k = `at` of a cubic through the samples around it, its uncertainty, and a sample's.

    As the slip strips grow, nodes let go one by one; the value jitters with the place of the
    strip's end between two nodes.
    """
    chosen = np.abs(k - at) <= window
    A = np.vander((k[chosen] - at) / window, 4)
    constants = np.linalg.lstsq(A, v[chosen], rcond=None)[0]
    scatter = np.linalg.norm(A @ constants - v[chosen]) / np.sqrt(max(chosen.sum() - 4, 1))
    share = np.sqrt(np.linalg.inv(A.T @ A)[-1, -1])
    return float(constants[-1]), float(scatter * share), float(scatter)


def traction(q: SlipInputs, state: "ContactSolution", name: str) -> dict[str, Array]:
    """Tangential traction at integration points, with their weights, and at `ACROSS`."""
    touch = state.touches[0]
    order = np.argsort(touch.x[0])
    loaded = touch.p > 0
    return {
        f"points, {name}": np.array([touch.along((0.0, 0.0)), touch.q, touch.weight])[:, loaded],
        f"profile, {name}": np.interp(ACROSS * q.width, touch.x[0][order], touch.traction[order]),
    }


def apart(state: "ContactSolution", other: "ContactSolution") -> float:
    """Largest difference of the tractions of two states [Pa]."""
    return float(np.abs(state.touches[0].traction - other.touches[0].traction).max())


def simpson(x: Array, Q: Array) -> float:
    """Area enclosed by a loop of even steps that reverses once, in the middle."""
    weights = np.full(x.size // 2 + 1, 2.0)
    weights[1::2], weights[[0, -1]] = 4.0, 1.0
    half = x.size // 2
    swings = (Q[: half + 1], Q[half:][::-1])
    return float((swings[1] - swings[0]) @ weights * (x[0] - x[1]) / 3)


def around(x: Array, Q: Array) -> Array:
    """Displacements beyond the line from -Q_max to Q_max [m], down and up again at `AROUND`."""
    half = x.size // 2
    beyond = x - x[0] / Q[0] * Q
    down = CubicSpline(Q[half::-1], beyond[half::-1])(AROUND[::-1] * Q[0])
    up = CubicSpline(Q[half:], beyond[half:])(AROUND * Q[0])
    return np.concatenate([down, up])


def near(q: SlipInputs, whole: dict[str, Any]) -> Field:
    """The cells about the contact, with their largest shear stress."""
    cells, _ = cut(whole, lambda centre: np.asarray(np.abs(centre).max(axis=1) <= VIEW * q.width))
    points, index, stress = cells["points"], cells["cells"], cells["stress"]
    return Field(
        name="pushed", points=points, cells=index,
        point_data={"displacement": cells["displacement"],
                    "shear_at_nodes": largest_shear(at_nodes(points, index, stress))},
        cell_data={"stress": stress, "largest_shear": largest_shear(stress)},
        units={"displacement": "m", "stress": "Pa", "largest_shear": "Pa", "shear_at_nodes": "Pa"},
    )  # fmt: skip


def largest_shear(stress: Array) -> Array:
    """Largest shear stress in the plane (m,) of stresses (m, 4): xx, yy, xy, zz."""
    xx, yy, xy, _ = stress.T
    return np.asarray(np.hypot((xx - yy) / 2, xy))


def at_nodes(points: Array, cells: NDArray[np.int64], values: Array) -> Array:
    """Values (n, k) at nodes: means of the cells' values (m, k) about each, weighed by area."""
    x, y = points[cells].transpose(2, 0, 1)
    after = np.roll(np.arange(cells.shape[1]), -1)
    area = np.abs((x * y[:, after] - y * x[:, after]).sum(axis=1)) / 2
    total, weight = np.zeros((len(points), values.shape[1])), np.zeros(len(points))
    for corner in cells.T:
        np.add.at(total, corner, values * area[:, None])
        np.add.at(weight, corner, area)
    return total / weight[:, None]
