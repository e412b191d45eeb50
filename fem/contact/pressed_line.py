"""Two bodies of a line contact, pressed together until the contact carries a given load.

The section through the centre of a disc moves as a rigid line. A quarter of a disc is therefore an
exact model of a disc pressed from both sides. The problems are plane, without friction, and
symmetric about x = 0, with contact at the origin and displacement along y. All units must be
consistent; docstrings state SI units.
"""

from collections.abc import Callable

import numpy as np

from fem.contact.errors import NotFoundError
from fem.contact.problem import ContactProblem
from fem.contact.solution import ContactSolution, Touch
from fem.plane.discretisation import Array

ZONE = 1.5  # of the even cells over the contact
CELLS = 6  # on it, on the mesh of level 1: four on the half-width
COARSE = 2  # mesh level for the search of the end of the contact
HIT = 1e-12  # relative to P, within which the load is met
MOST = 40
SOLVED = 1e-10  # relative error of values if the load is reached within HIT
PLACES = 8.0  # of the pressure by which places of nodes, rounded in double precision, move a peak
INTEGRAL = 0.02  # share of this error, relative to the peak, in integrals of the pressure
AXIS = np.linspace(0.5, 1.25, 301)  # depths over a at which stresses are taken

Build = Callable[[float, int, int], ContactProblem]


class PressedLine:
    """Line contact at the origin under the load P [N/m]; the bodies are displaced along y."""

    def __init__(
        self, build: Build, level: int, *, P: float, guess: float, arc: float, softness: float,
        cut: str,
    ) -> None:  # fmt: skip
        """`build(zone, cells, refine)` defines the problem; the boundary `cut` is displaced.

        `guess` [m] is the approximate half-width; `arc` [m] is the radius of the surface, along
        which cells have equal lengths. `softness` [1/Pa] is the sum of (1 - nu^2)/E of both bodies.

        A coarse solution finds the edge of the contact. All meshes have a vertex there; therefore,
        mesh levels differ only in the size of the cells.
        """
        self.P, self.guess, self.cut = P, guess, cut
        self.start, self.softness, self.level = P * softness, softness, level
        self.problem = build(ZONE * guess, CELLS, COARSE)
        self.solution, self.approach = self._under_load()
        self.a = self.half_width
        self.problem = build(arc * np.sin(ZONE * np.arcsin(self.a / arc)), CELLS, level)
        self.solution, self.approach = self._under_load()

    @property
    def touch(self) -> Touch:
        """Contact state of the surfaces."""
        return self.solution.touches[0]

    @property
    def peak(self) -> float:
        """Pressure [Pa] at the axis."""
        touch = self.touch
        return float(touch.pressure[np.argmin(np.abs(touch.x[0]))])

    @property
    def half_width(self) -> float:
        """Half-width 2 sqrt(int q x^2 / int q) [m], with the load q along y at the coordinate x.

        x is the mean of the coordinates of both surfaces.
        """
        x, q = self.load
        return float(2 * np.sqrt(q @ x**2 / q.sum()))

    @property
    def load(self) -> tuple[Array, Array]:
        """Positions x [m] of the integration points and forces along y at these points [N/m]."""
        points = self.touch.mortar.points
        return (points.x[0] + points.y[0]) / 2, self.touch.p * np.abs(points.n[1]) * points.weight

    def values(self) -> dict[str, float]:
        """Peak pressure, half-width, and approach of the bodies, in the units of the input."""
        return {"p_0": self.peak, "a": self.half_width, "approach": self.approach}

    def rounding(self, key: str, value: float) -> float:
        """Uncertainty of the result `key` by round-off, in the unit of its `value`.

        Coordinates of nodes on a circle are rounded relative to the largest x. In a cell of size h,
        this causes a strain x eps/h, and a pressure equal to this strain divided by the compliance
        of both bodies.
        """
        largest = float(abs(self.solution.plane.basis.mesh.p).max())
        cell = ZONE * self.a / (CELLS * self.level)
        pressure = PLACES * largest * float(np.finfo(float).eps) / (cell * self.softness)
        share = 1.0 if key == "p_0" else INTEGRAL
        return (SOLVED + share * pressure / self.peak) * abs(value)

    def balance(self, supports: tuple[str, ...]) -> dict[str, float]:
        """Unbalanced forces [N/m] and moment about the origin [N] on the displaced body."""
        plane, touch = self.solution.plane, self.touch
        x, y, moment = np.sum([plane.reaction(name) for name in supports], axis=0)
        force = touch.force  # on the master; the pushed body is the slave
        return {
            "balance_x": x - force[0],
            "balance_y": y - force[1],
            "moment": moment + touch.moment(on="slave"),
        }

    def shear(self) -> tuple[float, float]:
        """Largest shear stress [Pa] on the axis of the upper body, and its depth [m].

        A polynomial fitted to the stresses of many cells smooths the jumps between cells.
        """
        z = AXIS * self.a
        stress = self.solution.plane.at(np.array([np.zeros_like(z), z])).stress
        fit = np.polynomial.Polynomial.fit(AXIS, (stress[0] - stress[1]) / 2, 6)
        fine = np.linspace(AXIS[0], AXIS[-1], 4001)
        first = fine[np.argmax(fit(fine))]
        tops = fit.deriv().roots()
        top = float(np.real(tops[np.argmin(np.abs(tops - first))]))
        return float(fit(top)), top * self.a

    def _under_load(self) -> tuple[ContactSolution, float]:
        """Contact state under P and the displacement of the section, by the secant method."""
        before, now = self.start, 3 * self.start
        missing = self._missing(before)[1]
        for _ in range(MOST):
            solution, more = self._missing(now)
            if abs(more) <= HIT:
                return solution, now
            if more == missing:
                break
            before, now, missing = now, now - more * (now - before) / (more - missing), more
        raise NotFoundError(f"the load P was not reached: relative error {more:.1e}")

    def _missing(self, d: float) -> tuple[ContactSolution, float]:
        """Contact state with the cut moved down by `d`, and the relative error of the load."""
        solution = self.problem.solve(displacements={self.cut: {"y": -d}})
        half = abs(solution.touches[0].force[1])
        return solution, 2 * half / self.P - 1
