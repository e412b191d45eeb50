"""The contact solvers' errors for drivers of cases, which import no finite elements by themselves.

Only `NoEquilibriumError` says something of the bodies; `NotFoundError` is never caught.
"""

from types import ModuleType


def fem_errors() -> ModuleType:
    """`fem.contact.errors`."""
    from fem.contact import errors

    return errors
