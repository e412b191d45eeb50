"""A patch replaces the function under every name and in every wrapper."""

import importlib
import sys
from textwrap import dedent

import pytest

from analytic.contact.strip_influence import _cubics
from tests.verify.mutation.forked import answer
from verify.audit.mutation.patching import patch
from verify.audit.mutation.sites import mutants, source
from verify.audit.mutation.subject_operators import FORMULAS
from verify.audit.mutation.tracing import called

FORMULA = """
    from dataclasses import dataclass
    from functools import cache, cached_property

    FACTOR = 7.5


    def area(a, b, *, scale=2.0):
        def inner():
            return a * b
        return scale * inner()


    @cache
    def stored(a):
        return a + 10


    @dataclass(frozen=True)
    class Ring:
        r: float

        @cached_property
        def size(self):
            return self.r - 1

        @property
        def twice(self):
            return self.size * 2

        @staticmethod
        def half(a):
            return a / 2
"""
USER = """
    from weighed import FACTOR, Ring, area, stored

    def used():
        return [area(3.0, 4.0), stored(5), FACTOR, Ring(5.0).twice, Ring.half(4.0)]
"""


@pytest.fixture
def used(tmp_path, monkeypatch):
    """A function of another module, which has imported the names of the formulas."""
    for name, text in (("weighed", FORMULA), ("weighing", USER)):
        (tmp_path / f"{name}.py").write_text(dedent(text), "utf-8")
    monkeypatch.syspath_prepend(tmp_path)
    source.cache_clear()
    yield importlib.import_module("weighing").used
    for name in ("weighed", "weighing"):
        monkeypatch.delitem(sys.modules, name)
    source.cache_clear()


@pytest.mark.parametrize(
    ("function", "before", "becomes", "at", "value"),
    [
        ("stored", "a + 10", "a - 10", 1, -5),  # memoised
        ("area", "2.0", "4.0", 0, 48.0),  # a default
        ("area", "a * b", "a / b", 0, 1.5),  # a function inside
        ("FACTOR", "7.5", "15.0", 2, 15.0),
        ("Ring.size", "self.r - 1", "self.r + 1", 3, 12.0),
        ("Ring.twice", "self.size * 2", "self.size / 2", 3, 2.0),
        ("Ring.half", "a / 2", "a * 2", 4, 8.0),
    ],
)
def test_a_change_reaches_a_module_that_imported_the_name(
    used, function, before, becomes, at, value
):
    right = [24.0, 15, 7.5, 8.0, 2.0]
    of = source("weighed")
    (one,) = (
        m for m in mutants(of, FORMULAS)
        if m.mutant.function.startswith(function)
        and (m.mutant.before, m.mutant.after) == (before, becomes)
    )  # fmt: skip

    def changed():
        patch(of, one)
        return used()

    found = answer(changed, 20.0)
    assert not found.failure
    assert found.value == [*right[:at], value, *right[at + 1 :]]
    assert used() == right  # nothing comes back from the child


def test_what_is_memoised_is_traced_as_well():
    _cubics()
    assert "analytic.contact.strip_influence:_slope" in called(_cubics)[1]
