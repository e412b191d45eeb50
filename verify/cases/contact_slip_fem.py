"""Finite elements of partial slip: two half discs, the upper one's cut driven along x and y."""

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import cumulative_trapezoid
from scipy.interpolate import CubicSpline

from verify.case import FemResult
from verify.cases.contact_slip_inputs import SlipInputs
from verify.shown import Field

if TYPE_CHECKING:
    from fem.contact.solution import ContactSolution

Array = NDArray[np.float64]

SHARES = (0.2, 0.4, 0.6, 0.8)  # Q/(mu P) of the first loading's rows
STAGES = (0.5, 0.0, -0.5, -1.0)  # Q/Q_max of the unloading's rows
SIDES = ("upper", "lower")
ZONE = 1.1  # half-width of the fine cells over Hertz's
SWEEP, SWEPT = 80, 0.92  # steps of the first loading and Q/(mu P) at its end
WINDOW = 0.06  # of Q/(mu P) about a row's, over which the sweep is smoothed
STEPS = 32  # of a swing from Q_max to -Q_max
ACROSS = np.linspace(-0.95, 0.95, 39)  # x/a of the profiles
GROWTH = np.linspace(0.1, 0.85, 16)  # Q/(mu P) where the stick zone's growth is shown
AROUND = np.linspace(-1.0, 1.0, 17)  # Q/Q_max where the loop is shown, on both branches
HIT = 1e-12  # of P, within which loads are met
VIEW = 3.0  # half-widths about the contact whose cells are kept


class Rollers:
    """Two equal half discs whose cuts move as rigid lines; loads are met by a secant method."""

    def __init__(self, q: SlipInputs, level: int) -> None:
        from fem.contact.pairs import Pair
        from fem.contact.problem import ContactProblem
        from fem.contact.shapes import Circle
        from fem.plane.material import Elastic
        from meshes.contact.disc import half_disc
        from meshes.join import join

        fine: dict[str, Any] = {"R": q.R, "zone": ZONE * q.a, "cells": round(ZONE * level)}
        self.q = q
        self.problem = ContactProblem(
            join({side: half_disc(**fine, refine=1, below=side == "lower") for side in SIDES}),
            materials=Elastic(E=q.E, nu=q.nu),
            assumption="plane strain",
            supports={"lower.middle": "xy", "upper.middle": "xy"},
            contacts=[
                Pair(
                    slave="upper.surface", master="lower.surface", friction=q.mu,
                    slave_shape=Circle((0.0, q.R), q.R), master_shape=Circle((0.0, -q.R), q.R),
                )
            ],
        )  # fmt: skip
        self.pressed, self.flexibility = self._press()

    def at(self, cut: Array, after: "ContactSolution | None") -> "ContactSolution":
        """The state with the upper cut moved by `cut` (x, y) [m]."""
        moved = {"upper.middle": {"x": float(cut[0]), "y": float(cut[1])}}
        return self.problem.solve(displacements=moved, after=after)

    def loaded(
        self, Q: float, cut: Array, after: "ContactSolution"
    ) -> tuple["ContactSolution", Array]:
        """The state under Q and P [N/m], one step on from `after`, and the cut's place.

        `cut` is where to start looking (Broyden's method).
        """
        target, flexibility = np.array([Q, -self.q.P]), self.flexibility
        state = self.at(cut, after)
        for _ in range(50):
            missing = target - state.touches[0].force
            if np.abs(missing).max() <= HIT * self.q.P:
                return state, cut
            step = flexibility @ missing
            cut = cut + step
            state = self.at(cut, after)
            gained = missing - (target - state.touches[0].force)
            miss = step - flexibility @ gained
            flexibility = flexibility + np.outer(miss, step @ flexibility) / (
                step @ flexibility @ gained
            )
        raise ArithmeticError(
            f"loads not met after 50 steps: forces still miss by {np.abs(missing).max():.2e} N/m"
        )

    def _press(self) -> tuple[tuple["ContactSolution", Array], Array]:
        """The state under P alone, with x held, and a first guess of the flexibility."""
        q, y = self.q, self.q.a**2 / self.q.R
        touched = self.at(np.array([0.0, -y]), None)
        y *= q.P / touched.touches[0].normal_force  # secant from the origin
        self.flexibility = np.eye(2) * y / q.P
        # by symmetry pressing alone brings no tangential traction, whatever its steps
        state, cut = self.loaded(0.0, np.array([0.0, -y]), touched)
        slope = self.at(cut * 1.001, state).touches[0].normal_force - q.P
        return (state, cut), np.eye(2) * abs(cut[1]) * 1e-3 / slope


def fem(q: SlipInputs, level: int) -> FemResult:
    rollers = Rollers(q, level)
    values, u_it, arrays = loading(rollers)
    cycled, jitter, tractions, fields = cycle(rollers)
    return FemResult(
        h=1 / level, values=values | cycled, u_it=u_it | jitter, arrays=arrays | tractions,
        fields=fields,
    )  # fmt: skip


def loading(rollers: Rollers) -> tuple[dict[str, float], dict[str, float], dict[str, Array]]:
    """First loading: stick half-widths, displacements, tractions; sliding at its end."""
    q, (state, cut) = rollers.q, rollers.pressed
    values: dict[str, float] = {"half-width": state.touches[0].half_width((0.0, 0.0))}
    u_it: dict[str, float] = {}
    arrays: dict[str, Array] = {}
    for k in SHARES:
        state, cut = rollers.loaded(k * q.mu * q.P, cut, state)
        arrays |= traction(q, state, f"k = {k:g}")
    end, limit = rollers.loaded(SWEPT * q.mu * q.P, cut, state)
    slid = rollers.at(limit * (4.0, 1.0), end).touches[0]
    values["sliding force"] = slid.friction_force - q.mu * slid.normal_force

    state, cut = rollers.pressed
    swept = []
    for x in np.linspace(0.0, limit[0], SWEEP + 1)[1:]:
        state = rollers.at(np.array([x, cut[1]]), state)
        touch = state.touches[0]
        swept.append((touch.friction_force / (q.mu * q.P), stick_share(touch), x))
    k, c2, x = np.array(swept).T
    arrays["profile, growth"] = np.sqrt([smoothed(k, c2, share)[0] for share in GROWTH])
    # Masing: each branch of a cycle is the first loading, twice as large
    area = 8 * cumulative_trapezoid(k, x, initial=0.0) - 4 * k * x
    jitter = smoothed(k, area, q.share)[2] * q.mu * q.P
    u_it |= {"friction's work": jitter, "loop's area": jitter}
    for name, share in (*((f"stick, k = {s:g}", s) for s in SHARES), ("stick at Q_max", q.share)):
        c2_k, u, _ = smoothed(k, c2, share)
        values[name] = values["half-width"] * np.sqrt(c2_k)
        u_it[name] = u * values[name] / (2 * c2_k)
    far, u_far, _ = smoothed(k, x, SHARES[-1])
    for share in SHARES:
        x_k, u, _ = smoothed(k, x, share)
        part = share / SHARES[-1]
        values[f"beyond chord, k = {share:g}"] = x_k - part * far
        u_it[f"beyond chord, k = {share:g}"] = float(np.hypot(u, part * u_far))
    return values, u_it, arrays


def cycle(
    rollers: Rollers,
) -> tuple[dict[str, float], dict[str, float], dict[str, Array], tuple[Field, ...]]:
    """Q_max, -Q_max, Q_max: tractions on the way, work of friction, area of the loop."""
    q, (state, cut) = rollers.q, rollers.pressed
    Q_max = q.share * q.mu * q.P
    first, top = rollers.loaded(Q_max, cut, state)
    values: dict[str, float] = {}
    arrays = traction(q, first, "Q/Q_max = 1")
    for stage in STAGES:
        state, _ = rollers.loaded(stage * Q_max, top * (stage, 1.0), first)
        arrays |= traction(q, state, f"Q/Q_max = {stage:g}")
    back = state  # -Q_max, in one step

    steps = np.linspace(1.0, -1.0, STEPS + 1)[1:]
    state, work, swung = first, 0.0, [(top[0], Q_max)]
    for x in top[0] * np.concatenate([steps, -steps]):
        state = rollers.at(np.array([x, top[1]]), state)
        touch = state.touches[0]
        work += float(np.abs(touch.traction * touch.slip) @ touch.mortar.size)
        swung.append((x, touch.friction_force))
        if len(swung) == STEPS + 1:
            values["steps"] = apart(state, back)
    values |= {"closure": apart(state, first), "friction's work": work}
    arrays["loop, x"], arrays["loop, Q"] = np.array(swung).T
    arrays["profile, loop"] = around(arrays["loop, x"], arrays["loop, Q"])
    area, coarser = (simpson(arrays["loop, x"][::n], arrays["loop, Q"][::n]) for n in (1, 2))
    values |= {"loop's area": area}
    down, moved = arrays["loop, Q"][: STEPS + 1] / Q_max, arrays["loop, x"][: STEPS + 1]
    values["left at Q = 0"], left, _ = smoothed(down, moved, 0.0, window=5.0 * 2 / STEPS)
    u_it = {"left at Q = 0": left, "area by steps": abs(area - coarser)}

    plane, touch = first.plane, first.touches[0]
    upper, lower = (np.array(plane.reaction(f"{side}.middle")) for side in SIDES)
    # about the origin; what a cut holds is what its half disc's surface receives, reversed
    values["balance of cuts"] = float(np.hypot(*(upper + lower)[:2]))
    values["passed on"] = float(np.hypot(*(upper[:2] - np.array(touch.force))))
    values["moment"] = float(upper[2] + touch.moment(on="slave"))
    return values, u_it, arrays, (near(q, plane.cells()),)


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
        f"profile, {name}": np.interp(ACROSS * q.a, touch.x[0][order], touch.traction[order]),
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


def near(q: SlipInputs, cells: dict[str, Any]) -> Field:
    """The cells about the contact, with their largest shear stress."""
    index = cells["cells"].astype(np.int64)
    centre = cells["points"][index].mean(axis=1)
    kept = np.flatnonzero(np.abs(centre).max(axis=1) <= VIEW * q.a)
    used, index = np.unique(index[kept], return_inverse=True)
    xx, yy, xy, _ = cells["stress"][kept].T
    return Field(
        name="pushed", points=cells["points"][used], cells=index.reshape(kept.size, -1),
        point_data={"displacement": cells["displacement"][used]},
        cell_data={"stress": cells["stress"][kept],
                   "largest_shear": np.hypot((xx - yy) / 2, xy)},
        units={"displacement": "m", "stress": "Pa", "largest_shear": "Pa"},
    )  # fmt: skip
