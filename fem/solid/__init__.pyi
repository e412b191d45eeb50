from fem.solid.solution import SolidSolution
from fem.solid.solve import solve_solid

__all__ = ["SolidSolution", "solve_solid"]
