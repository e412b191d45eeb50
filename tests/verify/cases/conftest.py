"""Cases judged with their stored references while a formula has another reading."""

import pytest

from tests.conftest import solved
from tests.verify.cases.rows import failed
from verify.form.memoised import forget_memoised


@pytest.fixture
def broken(monkeypatch):
    """Replace an attribute by what `fault` makes of it; functions forget what they have found."""

    def replace(owner, name, fault):
        monkeypatch.setattr(owner, name, fault(getattr(owner, name)))
        forget_memoised()

    yield replace
    monkeypatch.undo()
    forget_memoised()


@pytest.fixture
def fails(broken):
    """Rows of a case that fail where an attribute is read in another sense."""

    def found(case, owner, name, fault, row):
        solved(case, case.inputs())  # with the right one: levels are stored
        broken(owner, name, fault)
        return failed(case, row)

    return found
