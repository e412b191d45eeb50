"""Fixtures that judge cases with stored references while a formula is changed."""

import pytest

from tests.conftest import solved
from tests.verify.cases.rows import failed
from verify.form.memoised import forget_memoised


@pytest.fixture
def broken(monkeypatch):
    """Function: replace an attribute by the result of `fault`, and empty the caches."""

    def replace(owner, name, fault):
        monkeypatch.setattr(owner, name, fault(getattr(owner, name)))
        forget_memoised()

    yield replace
    monkeypatch.undo()
    forget_memoised()


@pytest.fixture
def fails(broken):
    """Function: rows of a case that fail after an attribute is replaced."""

    def found(case, owner, name, fault, row):
        solved(case, case.inputs())  # with the right one: levels are stored
        broken(owner, name, fault)
        return failed(case, row)

    return found
