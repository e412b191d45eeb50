from fem.contact.along import Along, Pull
from fem.contact.errors import NoEquilibriumError, NotFoundError
from fem.contact.nitsche import solve_nitsche
from fem.contact.pairs import Obstacle, Pair, Rigid
from fem.contact.pressed_line import PressedLine
from fem.contact.problem import ContactProblem
from fem.contact.shapes import Circle, Flat, Spiral
from fem.contact.solution import ContactSolution, Touch

__all__ = [
    "Along", "Circle", "ContactProblem", "ContactSolution", "Flat", "NoEquilibriumError",
    "NotFoundError", "Obstacle", "Pair", "PressedLine", "Pull", "Rigid", "Spiral", "Touch",
    "solve_nitsche",
]  # fmt: skip
