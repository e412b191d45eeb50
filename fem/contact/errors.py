"""Errors of the contact solvers, by their meaning.

Invalid input is a plain ValueError. `NoEquilibriumError` is a physical result. `NotFoundError` is
not: a caller must never read it as a state of the bodies.
"""


class NoEquilibriumError(ArithmeticError, ValueError):
    """It is proven that no admissible contact forces balance the loads."""


class NotFoundError(ArithmeticError):
    """No equilibrium was found; this does not prove that none exists."""
