"""Cases judged on their stored references while a formula is read in another sense."""

import pytest


@pytest.fixture
def failures(judged, without_fault, red, monkeypatch):
    """Names of the rows that fail where `reading` makes another function of one of the formulas."""

    def found(case, owner, name, reading):
        without_fault(case)  # caches of functions hold values of the right formulas
        monkeypatch.setattr(owner, name, reading(getattr(owner, name)))
        return {row.quantity for row in red(judged(case, drawn=False))}

    return found
