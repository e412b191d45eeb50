"""Cases judged on their stored references while a formula is read in another sense."""

import pytest

from verify.audit.mutation.tracing import forget_memoised


@pytest.fixture
def failures(judged, without_fault, red, monkeypatch):
    """Names of the rows that fail where `reading` makes another function of one of the formulas."""

    def found(case, owner, name, reading):
        without_fault(case)  # caches of functions hold values of the right formulas
        monkeypatch.setattr(owner, name, reading(getattr(owner, name)))
        return {row.quantity for row in red(judged(case, drawn=False))}

    return found


@pytest.fixture
def broken(monkeypatch):
    """Replace an attribute by what `fault` makes of it; functions forget what they have found."""

    def replace(owner, name, fault):
        monkeypatch.setattr(owner, name, fault(vars(owner)[name]))
        forget_memoised()

    yield replace
    monkeypatch.undo()
    forget_memoised()
