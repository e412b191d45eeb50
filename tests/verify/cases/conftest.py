"""Cases judged on their stored references while a formula is read in another sense."""

import pytest

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
