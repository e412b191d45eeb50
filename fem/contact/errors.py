"""Errors of the contact solvers.

Invalid input raises a plain ValueError. `NoEquilibriumError` is a physical result. `NotFoundError`
is not a physical result: a caller must not interpret it as a state of the bodies.
"""


class NoEquilibriumError(ArithmeticError, ValueError):
    """No equilibrium exists: it is proven that no admissible contact forces balance the loads."""


class NotFoundError(ArithmeticError):
    """No equilibrium was found; an equilibrium may nevertheless exist."""
